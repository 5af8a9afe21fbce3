// Report data as tests write it down, in a few words, and random data.

import { createRequire } from "node:module";
import { measurer } from "../../../../launchlint/report/html/js/drawing/measure.js";
import { Director } from "../../../../launchlint/report/html/js/drawing/scene.js";

const ELK = createRequire(import.meta.url)("../../../../launchlint/report/html/assets/elk.js");

const SIGNS = {
  ">": ["topic", "publisher", true],
  "<": ["topic", "subscriber", false],
  serves: ["service", "server", true],
  calls: ["service", "client", false],
  does: ["action", "action_server", true],
  asks: ["action", "action_client", false],
};

/**
 * "/a > /x": /a publishes /x; also <, serves, calls, does, asks. A ? behind it: not certain. "@0,2": only in these configurations. "+", "-"
 * or "~" before it: added, removed, changed.
 */
export function data(facts, { nodes = {}, channels = {}, params = [], containers = [], configurations = [""], base = null, findings = [] } = {}) {
  const entry = { file: 0, verdict: "loads", why: "", withArgs: "", configurations, complete: true, containers: containers.map((each) => ({ findings: [], ...each })), nodes: [], channels: [], connections: [], params, findings: [] };
  const at = new Map();
  const node = (name) => {
    const key = `n ${name}`;
    if (!at.has(key)) {
      at.set(key, entry.nodes.length);
      const namespace = name.slice(0, name.lastIndexOf("/")) || "/";
      entry.nodes.push({
        ...{ name, program: "demo/node", package: "demo", executable: "node", kind: "node", knowledge: "known", reason: "", host: name, namespace },
        ...{ isTest: false, place: null, container: -1, open: [], conditions: [], only: [], findings: [], related: [], machine: [], ...nodes[name] },
      });
    }
    return at.get(key);
  };
  const channel = (kind, name) => {
    const key = `c ${kind} ${name}`;
    if (!at.has(key)) {
      at.set(key, entry.channels.length);
      entry.channels.push({ kind, name, types: [], hub: false, plumbing: false, findings: [], ...channels[name] });
    }
    return at.get(key);
  };
  Object.keys(nodes).forEach(node);
  for (const fact of facts) {
    const [, sign, text] = /^([+~-]?)(.*)$/.exec(fact);
    const mark = { "+": "added", "-": "removed", "~": "changed" }[sign];
    const [words, only] = text.split(" @");
    const [name, verb, target] = words.split(" ");
    const [kind, role, offers] = SIGNS[verb];
    const certain = !target.endsWith("?");
    const topic = certain ? target : target.slice(0, -1);
    const others = { declared: topic, spelling: "global", unremapped: topic, remaps: [], type: "", when: "", evidence: [] };
    const own = { node: node(name), channel: channel(kind, topic), role, offers, certain, only: only ? only.split(",").map(Number) : [], ...others };
    entry.connections.push(mark ? { ...own, mark } : own);
  }
  return { format: 1, title: "demo", version: "0", sourceUrl: null, base, files: ["demo.launch"], baseFiles: [], lines: [], md5s: [], findings, entries: [entry], library: [] };
}

export function state(changes = {}) {
  return {
    ...{ entry: 0, configuration: -1, grouping: "namespace", expanded: new Set(), focus: null },
    ...{ layers: { topics: true, services: true, actions: true, params: false }, topicsAsNodes: false, hubs: false },
    ...{ danglingOnly: false, findingsOnly: false, tray: true, filter: "", hidden: new Set(), matches: null, ...changes },
  };
}

/** What is drawn of data in a state. */
export function scene(of, changes) {
  return new Director(of, new ELK(), measurer()).scene(state(changes), { width: 1440, height: 900 });
}

/** The lines of a level and of those in it, in words: "from → to: names", with ports of borders as the id of their container. */
export function lines(level) {
  const short = (id) => (id.startsWith("w:") ? id : id.split("|")[0]);
  const own = level.edges.map((edge) => {
    const look = edge.classes.filter((each) => each !== "topic");
    const end = (id, box) => (box === "" ? "border" : short(id));
    return `${end(edge.from, edge.fromBox)} → ${end(edge.to, edge.toBox)}: ${edge.wires.map((wire) => wire.name).join(" ")}${look.length ? ` (${look.join(" ")})` : ""}`;
  });
  const inner = level.boxes.filter((box) => box.level).map((box) => [box.id, lines(box.level)]);
  return inner.length ? [...own, Object.fromEntries(inner)] : own;
}

/** Numbers that look random, the same for the same seed. */
export function numbers(seed) {
  let at = seed * 2654435761;
  return (below) => {
    at = (at + 0x6d2b79f5) | 0;
    let mixed = Math.imul(at ^ (at >>> 15), 1 | at);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) % below;
  };
}

/** A system of up to 24 nodes in up to three levels of namespaces, with everything that connections can have. */
export function random(seed) {
  const next = numbers(seed);
  const namespaces = ["", "/a", "/a/b", "/a/b/c", "/a/d", "/e", "/e/f"].slice(0, 1 + next(7));
  const nodes = Array.from({ length: 2 + next(22) }, (_, at) => `${namespaces[next(namespaces.length)]}/n${at}`);
  const configurations = ["", "sim:=true", "fast:=true"].slice(0, 1 + next(3));
  const compared = next(3) === 0;
  const facts = [];
  const verbs = [[">", "<"], [">", "<"], [">", "<"], ["serves", "calls"], ["does", "asks"]];
  for (let channel = 0; channel < 2 + next(24); channel++) {
    const [offers, uses] = verbs[next(verbs.length)];
    for (const [verb, count] of [[offers, next(4)], [uses, next(5)]]) {
      for (let end = 0; end < count; end++) {
        const only = configurations.length > 1 && next(4) === 0 ? ` @${next(configurations.length)}` : "";
        const mark = compared ? ["", "", "+", "-", "~"][next(5)] : "";
        facts.push(`${mark}${nodes[next(nodes.length)]} ${verb} /t${channel}${next(6) === 0 ? "?" : ""}${only}`);
      }
    }
  }
  return data(facts, { nodes: Object.fromEntries(nodes.map((name) => [name, {}])), configurations, base: compared ? "main" : null });
}
