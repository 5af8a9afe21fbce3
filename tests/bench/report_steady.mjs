// How steady is the drawing of a report: what moves when a launch file gets one node more?
//
//   node tests/bench/report_steady.mjs REPORT.html…
//
// Pages that `launchlint report` wrote. Each of their launch files with 8 to 300 nodes that are drawn, three at most of a page, is laid out as
// it is at first sight, and once more for each of some newcomers: one that listens to what is there, one that tells others something, and
// one that does what a node that is there does, each at the end of the launch file and behind some node of it. A box has stayed where it
// stands within 10 pixels of where it was, from the corner of what is around it. Names are measured by a guess, as there is no browser.

import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { basename } from "node:path";
import { measurer } from "../../launchlint/report/html/js/drawing/measure.js";
import { Director } from "../../launchlint/report/html/js/drawing/scene.js";
import { inTray } from "../../launchlint/report/html/js/drawing/tray.js";
import { LEGIBLE, fitting } from "../../launchlint/report/html/js/drawing/viewport.js";
import { read } from "../../launchlint/report/html/js/unpack.js";

/** The stage of a window of 1440 × 900 pixels. */
const ELK = createRequire(import.meta.url)("../../launchlint/report/html/assets/elk.js");
const elk = new ELK();
const EXTENT = { width: 876, height: 640 };
const NEAR = 10;
const [FEWEST, MOST] = [8, 300];
const ENTRIES = 3;
const KINDS = ["listener", "talker", "twin"];
const START = {
  ...{ configuration: -1, grouping: "namespace", expanded: "auto", focus: null, layers: { topics: true, services: true, actions: true, params: false } },
  ...{ topicsAsNodes: false, hubs: false, danglingOnly: false, findingsOnly: false, tray: true, filter: "", hidden: new Set(), matches: null },
};

/** Numbers that look random, the same for the same seed. */
function numbers(seed) {
  let at = seed * 2654435761;
  return (below) => {
    at = (at + 0x6d2b79f5) | 0;
    let mixed = Math.imul(at ^ (at >>> 15), 1 | at);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) % below;
  };
}

/** An entry with one node more; null where there is nothing that it could share. */
function grown(entry, kind, atEnd, next) {
  const own = entry.connections.filter((each) => !entry.channels[each.channel].hub && !entry.channels[each.channel].plumbing);
  const topics = own.filter((each) => entry.channels[each.channel].kind === "topic");
  const fitting = { listener: topics.filter((each) => each.offers), talker: topics.filter((each) => !each.offers), twin: own }[kind];
  if (!fitting.length) return null;
  const model = fitting[next(fitting.length)];
  const like = entry.nodes[model.node];
  const files = entry.nodes.filter((each) => each.container === -1 && each.place);
  const last = files.reduce((found, each) => (!found || each.place[1] > found.place[1] ? each : found), null);
  const after = atEnd ? entry.nodes.indexOf(last ?? entry.nodes[entry.nodes.length - 1]) : model.node;
  const { place, container, namespace } = entry.nodes[after];
  const home = atEnd ? "/" : namespace;
  const name = `${home === "/" ? "" : home}/${"acgkmpsvy"[next(9)]}${next(100)}_newcomer`;
  const at = atEnd ? entry.nodes.length : after + 1;
  const moved = (index) => (index >= at ? index + 1 : index);
  const put = place && [place[0], place[1], place[2] + 1];
  const node = { ...like, name, host: name, namespace: home, place: put, container: atEnd ? -1 : container, findings: [], related: [], conditions: [], only: [], late: 1 };
  const nodes = [...entry.nodes.slice(0, at), node, ...entry.nodes.slice(at)];
  const connections = entry.connections.map((each) => ({ ...each, node: moved(each.node) }));
  const channels = [...entry.channels];
  if (kind === "twin") connections.push(...entry.connections.filter((each) => each.node === model.node).map((each) => ({ ...each, node: at })));
  else {
    connections.push({ ...model, node: at, offers: kind === "talker", role: kind === "talker" ? "publisher" : "subscriber", only: [] });
    channels.push({ ...channels[model.channel], name: `${name}/more`, findings: [], may: [] });
    connections.push({ ...model, node: at, channel: channels.length - 1, offers: true, role: "publisher", only: [] });
  }
  const params = entry.params.map((param) => ({ ...param, readers: param.readers.map(moved) }));
  return { name, entry: { ...entry, nodes, connections, channels, params } };
}

async function sceneOf(data) {
  return new Director(data, elk, measurer()).scene({ ...START, entry: 0 }, EXTENT);
}

/** Boxes by what they stand for: from the corner of what is around them. */
function places({ sheet, root }, entry) {
  const areas = new Map(sheet.boxes.map((each) => [each.box.id, each]));
  const found = new Map();
  const called = (id) => (id.startsWith("n:") ? `n:${entry.nodes[Number(id.slice(2))].name} ${entry.nodes[Number(id.slice(2))].place}` : id.startsWith("w:c:") ? `w:${entry.channels[parseInt(id.slice(4))].name}` : id);
  const visit = (level) => {
    const around = areas.get(level.group.id) ?? { x: 0, y: 0 };
    for (const box of level.boxes) {
      const area = areas.get(box.id);
      if (area) found.set(called(box.id), { x: area.x - around.x, y: area.y - around.y, kind: box.kind, level: level.group.id });
      if (box.level) visit(box.level);
    }
  };
  visit(root);
  return found;
}

/** Where pieces of lines that do not leave together cross. */
function crossings(lines) {
  const [level, upright] = [[], []];
  for (const { edge, points } of lines) {
    for (let at = 1; at < points.length; at++) {
      const [a, b] = [points[at - 1], points[at]];
      if (Math.abs(a.y - b.y) < 0.5) level.push({ net: edge.fromPort, y: a.y, from: Math.min(a.x, b.x), to: Math.max(a.x, b.x) });
      else upright.push({ net: edge.fromPort, x: a.x, from: Math.min(a.y, b.y), to: Math.max(a.y, b.y) });
    }
  }
  let count = 0;
  for (const one of level) for (const other of upright) if (one.net !== other.net && other.x > one.from + 1 && other.x < one.to - 1 && one.y > other.from + 1 && one.y < other.to - 1) count += 1;
  return count;
}

/** Of one drawing: pixels of its smallest names, share of the stage's longer side, crossings, and what is folded. */
function looks({ sheet }) {
  const scale = Math.min(1.6, fitting(sheet, EXTENT));
  const share = (sheet.width * scale * sheet.height * scale) / (EXTENT.width * EXTENT.height);
  return { smallest: 12 * Math.max(scale, LEGIBLE), share, crossings: crossings(sheet.edges), lines: sheet.edges.length, boxes: sheet.boxes.length, folded: sheet.boxes.filter((each) => each.box.kind === "folded").length };
}

const mean = (all) => all.reduce((sum, each) => sum + each, 0) / Math.max(1, all.length);
const percent = (part, whole) => `${((100 * part) / Math.max(1, whole)).toFixed(1)} %`;
const total = new Map();
const seen = [];
const details = process.env.DETAILS === "yes";
let spent = 0;

for (const path of process.argv.slice(2)) {
  const text = /<script type="application\/json" id="launchlint-data">(.*?)<\/script>/s.exec(readFileSync(path, "utf-8"))?.[1];
  const data = read(text ?? "{}");
  const sized = data.entries.filter((each) => {
    const drawn = each.nodes.length - inTray(each).length;
    return drawn >= FEWEST && drawn <= MOST;
  });
  const own = { stayed: 0, boxes: 0 };
  const steps = Math.max(1, Math.floor(sized.length / ENTRIES));
  for (const entry of sized.filter((_, at) => at % steps === 0).slice(0, ENTRIES)) {
    const next = numbers(entry.nodes.length * 7 + entry.connections.length);
    const started = performance.now();
    const scene = await sceneOf({ ...data, entries: [entry] });
    spent += performance.now() - started;
    const before = places(scene, entry);
    seen.push(looks(scene));
    if (process.env.LOOKS !== "yes") for (const kind of KINDS) {
      for (const atEnd of [true, false]) {
        const more = grown(entry, kind, atEnd, next);
        if (!more) continue;
        const sceneAfter = await sceneOf({ ...data, entries: [more.entry] });
        const after = places(sceneAfter, more.entry);
        const key = `${kind}, ${atEnd ? "at the end" : "in between"}`;
        const sum = total.get(key) ?? { stayed: 0, boxes: 0, gone: 0, near: 0, level: 0, upright: 0 };
        total.set(key, sum);
        const count = { stayed: 0, boxes: 0 };
        for (const [id, { x, y, kind: what }] of before) {
          if (what === "pill") continue;
          const now = after.get(id);
          sum.gone += Number(!now);
          if (!now) continue;
          const [dx, dy] = [Math.abs(now.x - x) <= NEAR, Math.abs(now.y - y) <= NEAR];
          count.boxes += 1;
          count.stayed += Number(dx && dy);
          sum.level += Number(dx);
          sum.upright += Number(dy);
        }
        for (const one of [sum, own]) {
          one.boxes += count.boxes;
          one.stayed += count.stayed;
        }
        if (details) console.log(`    ${key}: ${count.stayed} of ${count.boxes}`);
      }
    }
    if (details) console.log(`  ${data.files[entry.file]}: ${entry.nodes.length} nodes; ${JSON.stringify(seen[seen.length - 1])}`);
  }
  if (own.boxes) console.log(`${basename(path)}: ${percent(own.stayed, own.boxes)} of ${own.boxes} boxes`);
}

const all = { stayed: 0, boxes: 0 };
for (const [key, { stayed, boxes, gone, level, upright }] of total) {
  console.log(`${key}: ${percent(stayed, boxes)} of ${boxes} boxes stayed (${percent(level, boxes)} level, ${percent(upright, boxes)} upright); ${gone} are not drawn any more`);
  all.stayed += stayed;
  all.boxes += boxes;
}
console.log(`all: ${percent(all.stayed, all.boxes)} of ${all.boxes} boxes`);
const sum = (key) => seen.reduce((found, each) => found + each[key], 0);
console.log(
  `${seen.length} launch files: smallest name ${Math.min(...seen.map((each) => each.smallest)).toFixed(1)} px; ${mean(seen.map((each) => each.share)).toFixed(2)} of the stage used; ` +
    `${sum("crossings")} crossings of ${sum("lines")} lines, ${sum("boxes")} boxes, ${sum("folded")} of them folded; ${(spent / seen.length).toFixed(0)} ms each`,
);
