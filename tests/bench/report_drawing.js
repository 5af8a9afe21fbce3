// Measures the drawing in a browser: bundled and driven by report_drawing.py beside this file.

import { createDrawing } from "../../launchlint/report/html/js/drawing/index.js";
import { OPTIONS } from "../../launchlint/report/html/js/drawing/engine.js";
import { measurer } from "../../launchlint/report/html/js/drawing/measure.js";
import { Director } from "../../launchlint/report/html/js/drawing/scene.js";
import { walk } from "../../launchlint/report/html/js/drawing/tree.js";
import { read } from "../../launchlint/report/html/js/unpack.js";

const extent = { width: innerWidth, height: innerHeight };
const START = {
  ...{ entry: 0, configuration: -1, grouping: "namespace", expanded: "auto", focus: null, layers: { topics: true, services: true, actions: true, params: false } },
  ...{ topicsAsNodes: false, hubs: false, danglingOnly: false, findingsOnly: false, tray: true, filter: "", hidden: new Set(), matches: null },
};
let data;
let drawing;
let state = START;

const nextFrame = () => new Promise((resolve) => requestAnimationFrame(resolve));

/** Runs something, and waits until what it changed is on the screen. */
async function timed(act) {
  const from = performance.now();
  await act();
  await nextFrame();
  return performance.now() - from;
}

export function load(text) {
  data = read(text);
}

export function nodes() {
  return data.entries[0].nodes.length;
}

/** The first drawing, as a page shows it. */
export function first() {
  return timed(() => {
    const host = document.getElementById("drawing");
    drawing = createDrawing(data, host, { select() {}, expand() {}, moved() {}, busy() {} });
    return drawing.show(state);
  });
}

/** Opens one folded container after the other, at most so many: milliseconds of each. */
export async function expand(most) {
  const found = [];
  for (let at = 0; at < most; at++) {
    const id = document.querySelector(".box.folded")?.getAttribute("data-id");
    if (!id) break;
    state = { ...state, expanded: drawing.expanded().add(id) };
    found.push(await timed(() => drawing.show(state)));
  }
  return found;
}

/** Selects everything that can be, at most so many: milliseconds of each. */
export async function select(most) {
  const found = [];
  for (const { selection } of drawing.focusables().slice(0, most)) found.push(await timed(() => drawing.select(selection)));
  drawing.select(null);
  return found;
}

/** Shows the topics that everybody uses, and hides them again: milliseconds of both. */
export async function hubs() {
  const found = [];
  for (const on of [true, false]) found.push(await timed(() => drawing.show({ ...state, hubs: on })));
  return found;
}

export async function openEverything() {
  const root = (await new Director(data, new ELK(), measurer()).scene({ ...START, expanded: new Set() }, extent)).view.root;
  state = { ...state, expanded: new Set(Array.from(walk(root), (each) => each.id)) };
  const took = await timed(() => drawing.show(state));
  drawing.fit();
  return took;
}

/** How many frames there were while the drawing was dragged about. */
export async function pan(milliseconds) {
  const svg = document.querySelector("svg.ll-drawing");
  const send = (type, x, y) => svg.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX: x, clientY: y, button: 0, bubbles: true }));
  svg.setPointerCapture = () => {};
  send("pointerdown", 600, 400);
  const from = performance.now();
  let frames = 0;
  for (let now = from; now - from < milliseconds; frames++) {
    send("pointermove", 600 + 200 * Math.sin(frames / 20), 400 + 150 * Math.cos(frames / 15));
    await nextFrame();
    now = performance.now();
  }
  send("pointerup", 600, 400);
  return frames;
}

export function drawn() {
  return { boxes: document.querySelectorAll(".box").length, lines: document.querySelectorAll(".line").length };
}

/** The first view, laid out by us and by plain elkjs in one run with all of its levels: milliseconds and crossings of both. */
export async function against() {
  const elk = new ELK();
  const director = new Director(data, elk, measurer());
  const { open } = await director.scene(START, extent);
  const view = { ...START, expanded: open };
  let scene;
  const ours = await timed(async () => (scene = await new Director(data, elk, measurer()).scene(view, extent)));
  const pairs = new Map();
  for (const wire of scene.view.wires) {
    for (const from of scene.drawn.boxes.values()) {
      if (from.kind !== "node" && from.kind !== "folded") continue;
      const leaving = (scene.drawn.leaving.get(from.id) ?? []).filter((edge) => edge.wires.some((each) => each.id === wire.id));
      const look = leaving.map((edge) => edge.classes.join(".")).join();
      for (const to of scene.drawn.follow(from.id, wire.id, true, new Set())) {
        if (scene.drawn.isEnd(to)) pairs.set(`${from.id} ${look} ${to}`, { from: from.id, port: `${from.id} ${wire.id}`, to });
      }
    }
  }
  const edges = Array.from(pairs.values(), ({ from, port, to }, at) => ({ id: `e${at}`, from, port, to }));
  const [free, sided] = [[], []];
  const theirs = await timed(async () => free.push(...(await plainly(elk, scene.root, edges, false))));
  const theirsWithPorts = await timed(async () => sided.push(...(await plainly(elk, scene.root, edges, true))));
  const own = scene.sheet.edges.map(({ edge, points }) => ({ net: edge.fromPort, points }));
  return {
    ours: { milliseconds: ours, ...told(own, scene.sheet) },
    elkjs: { milliseconds: theirs, ...told(...free) },
    "elkjs with ports": { milliseconds: theirsWithPorts, ...told(...sided) },
  };
}

/**
 * What elkjs makes of all levels in one run: its lines, and its size. With `ports`, what leaves a box leaves to the right, the same wire by one
 * port, and what enters it enters from the left, as we draw it; else lines leave and enter as it likes.
 */
async function plainly(elk, root, edges, ports) {
  const portsOf = (id) => {
    const leaving = new Set(edges.filter((each) => each.from === id).map((each) => each.port));
    const port = (side) => (each) => ({ id: each, layoutOptions: { "elk.port.side": side } });
    return [...Array.from(leaving, port("EAST")), ...edges.filter((each) => each.to === id).map((each) => each.id).map((each) => `in ${each}`).map(port("WEST"))];
  };
  const nested = (level) => level.boxes.filter((box) => box.kind !== "pill").map((box) => {
    if (box.level) return { id: box.id, children: nested(box.level), layoutOptions: { "elk.padding": "[left=16,top=32,right=16,bottom=16]" } };
    const leaf = { id: box.id, width: box.width, height: box.height };
    return ports ? { ...leaf, ports: portsOf(box.id), layoutOptions: { "elk.portConstraints": "FIXED_SIDE" } } : leaf;
  });
  const layoutOptions = { ...OPTIONS, "elk.hierarchyHandling": "INCLUDE_CHILDREN", "elk.json.edgeCoords": "ROOT" };
  const lines = edges.map(({ id, from, port, to }) => ({ id, sources: [ports ? port : from], targets: [ports ? `in ${id}` : to] }));
  const placed = await elk.layout({ id: "root", layoutOptions, children: nested(root), edges: lines });
  const net = new Map(edges.map(({ id, port }) => [id, ports ? port : id]));
  const polylines = placed.edges.map((edge) => ({ net: net.get(edge.id), points: edge.sections.flatMap((each) => [each.startPoint, ...(each.bendPoints ?? []), each.endPoint]) }));
  return [polylines, placed];
}

function told(lines, { width, height }) {
  return { lines: lines.length, crossings: crossings(lines), width, height };
}

/** Where pieces of lines that do not leave together cross. */
function crossings(lines) {
  const level = [];
  const upright = [];
  for (const { net, points } of lines) {
    for (let at = 1; at < points.length; at++) {
      const [a, b] = [points[at - 1], points[at]];
      if (Math.abs(a.y - b.y) < 0.5) level.push({ net, y: a.y, from: Math.min(a.x, b.x), to: Math.max(a.x, b.x) });
      else upright.push({ net, x: a.x, from: Math.min(a.y, b.y), to: Math.max(a.y, b.y) });
    }
  }
  let count = 0;
  for (const one of level) {
    for (const other of upright) {
      if (one.net !== other.net && other.x > one.from + 1 && other.x < one.to - 1 && one.y > other.from + 1 && one.y < other.to - 1) count += 1;
    }
  }
  return count;
}
