// What is written on a box, and how large that makes it.

import { briefNames, counted, cut, inLines, isLocal, lastPart, machineName, shortName } from "./names.js";
import { walk } from "./tree.js";

/** @typedef {import("./types").Group} Group */
/** @typedef {import("./model").Badge} Badge */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Line} Line */
/** @typedef {import("./model").Loose} Loose */
/** @typedef {import("./model").LoosePort} LoosePort */
/** @typedef {import("./model").View} View */
/** @typedef {import("./model").Wire} Wire */
/** @typedef {(text: string, kind: Line["kind"] | "label") => number} Measure Width of a text in pixels. */

export const LINE_HEIGHTS = { title: 17, detail: 15, condition: 15, host: 15, count: 15 };
export const PADDING = { x: 12, y: 8 };
/** Room for the sign that opens or folds a container. */
export const FOLD = 18;
/** Longest texts, in characters. */
const LONGEST = { title: 40, detail: 24, condition: 24, label: 20, open: 48 };
/** From so many characters on, a name stands in two lines. */
const BROAD = 20;
/** Longest name of a node in the tray. */
const BRIEF = 26;
/** From so many names on, a port or a line says their number instead. */
export const BUNDLE = 3;

const SEVERITIES = /** @type {const} */ (["error", "warning", "info"]);

/**
 * How many findings there are, and the worst of them.
 * @param {View} view
 * @param {Iterable<number>} findings indexes
 * @param {boolean} [elsewhere] whether they stand elsewhere
 * @returns {Badge | null}
 */
export function badgeOf(view, findings, elsewhere = false) {
  const distinct = new Set(findings);
  for (const severity of SEVERITIES) {
    for (const each of distinct) if (view.findings[each]?.severity === severity) return { severity, count: distinct.size, elsewhere };
  }
  return null;
}

/**
 * @param {View} view
 * @param {number} index of the node
 * @param {Group} group around it
 * @param {Measure} measure
 * @returns {Box}
 */
export function nodeBox(view, index, group, measure) {
  const node = view.entry.nodes[index];
  if (!node) throw new RangeError(`there is no node ${index}`);
  // In the tray only names stand: the rest comes with the panel.
  const isBrief = group.kind === "tray";
  const inNamespace = group.namespace === node.namespace || (view.state.grouping === "namespace" && !isBrief);
  /** @type {Line[]} */
  const lines = isBrief ? [{ kind: "title", text: namesIn(view, group).get(node.name) ?? node.name }] : titles(inNamespace ? cut(lastPart(node.name), LONGEST.title) : shortName(node.name, "", LONGEST.title));
  if (node.program && !isBrief && !view.terse) lines.push({ kind: "detail", text: cut(node.program, LONGEST.detail) });
  const classes = ["node"];
  const when = view.presence.of(node.only, node.mark);
  const conditional = node.conditions.length > 0 || view.presence.conditional(when, view.now);
  if (conditional) classes.push("conditional");
  if (node.conditions.length && !isBrief) lines.push({ kind: "condition", text: cut(node.conditions.join(" and "), LONGEST.condition) });
  const guest = node.host !== "" && node.host !== node.name;
  if (guest && !isBrief) lines.push({ kind: "host", text: `in ${shortName(node.host, node.namespace, LONGEST.detail)}` });
  const [machine = "", address = ""] = node.machine;
  // What is true of every box is not said in each.
  if (machine && !isLocal(machine, address) && view.machines > 1 && view.state.grouping !== "machine" && !isBrief) {
    classes.push("machine");
    lines.push({ kind: "host", text: `on ${cut(machine, LONGEST.detail)}` });
  }
  const params = view.params.get(index);
  if (params) lines.push({ kind: "count", text: counted(params, "param") });
  if (node.knowledge === "unknown") classes.push("unknown");
  if (node.lifecycle) classes.push("lifecycle");
  if (node.kind === "container" || node.kind === "manager") classes.push("host");
  if (node.isTest) classes.push("test");
  if (node.mark) classes.push(node.mark);
  if (view.stubs.has(`n:${index}`)) classes.push("stub");
  const said = [node.name, node.program];
  if (node.knowledge === "unknown") said.push(`unknown: ${node.reason || "nothing is known of what it connects to"}`);
  if (node.conditions.length) said.push(`only where ${node.conditions.join(" and ")}`);
  if (node.lifecycle) said.push("lifecycle node: somebody has to configure and activate it");
  if (guest) said.push(`in the process of ${node.host}`);
  if (machine) said.push(`on the machine ${machineName(machine, address)}`);
  const loose = loosePorts(view, `n:${index}`, view.loose.get(index) ?? [], group);
  const badge = badgeOf(view, node.findings) ?? badgeOf(view, node.related, true);
  return sized({ id: `n:${index}`, kind: "node", classes, lines, title: said.join("\n"), badge, loose, level: null, wires: [] }, measure);
}

/** @type {WeakMap<Group, Map<string, string>>} */
const brief = new WeakMap();

/** How nodes are called in the tray. @param {View} view @param {Group} tray */
function namesIn(view, tray) {
  let found = brief.get(tray);
  if (!found) brief.set(tray, (found = briefNames(tray.nodes.map((each) => view.entry.nodes[each]?.name ?? ""), BRIEF)));
  return found;
}

/** @param {string} text @returns {Line[]} */
function titles(text) {
  return inLines(text, BROAD).map((each) => ({ kind: "title", text: each }));
}

/**
 * A container that is drawn as one box.
 * @param {View} view
 * @param {Group} group
 * @param {Measure} measure
 * @returns {Box}
 */
export function foldedBox(view, group, measure) {
  const about = contents(view, group);
  const lines = titles(cut(group.label, LONGEST.title));
  const unknown = about.unknown && about.unknown < about.nodes ? ` · ${about.unknown} unknown` : "";
  const only = about.nodes === 1 ? `: ${cut(lastPart(view.entry.nodes[about.first]?.name ?? ""), LONGEST.label)}` : unknown;
  // The tray's name says how many there are.
  const detail = group.kind === "tray" ? unknown.replace(" · ", "") : `${counted(about.nodes, "node")}${only}`;
  if (detail && !view.terse) lines.push({ kind: "detail", text: detail });
  const classes = ["folded", group.kind];
  if (about.nodes && about.unknown === about.nodes) classes.push("unknown");
  if (about.mark) classes.push(about.mark);
  if (view.stubs.has(group.id)) classes.push("stub");
  const title = `${group.title}\n${counted(about.nodes, "node")}${about.unknown ? `, ${about.unknown} unknown` : ""}`;
  const badge = badgeOf(view, about.findings);
  return sized({ id: group.id, kind: "folded", classes, lines, title, badge, loose: looseOf(view, group), level: null, wires: [] }, measure);
}

/**
 * A container that shows what is in it.
 * @param {View} view
 * @param {Level} level
 * @returns {Box}
 */
export function openBox(view, level) {
  const { group } = level;
  const about = contents(view, group);
  const classes = ["open", group.kind];
  if (about.mark) classes.push(about.mark);
  /** @type {Line[]} */
  const lines = [{ kind: "title", text: cut(group.label, LONGEST.open) }];
  const title = `${group.title}\n${counted(about.nodes, "node")}`;
  return { id: group.id, kind: "open", classes, lines, title, badge: badgeOf(view, group.own), width: 0, height: 0, loose: looseOf(view, group), level, wires: [] };
}

/**
 * What an include has in common with nobody: a component's loose ports, one at each side.
 * @param {View} view
 * @param {Group} group
 * @returns {LoosePort[]}
 */
function looseOf(view, group) {
  if (group.kind !== "include") return [];
  /** @type {[Set<Wire>, Set<Wire>]} */
  const sides = [new Set(), new Set()];
  for (const each of walk(group)) {
    for (const node of each.nodes) if (view.shown[node]) for (const { wire, gives } of view.loose.get(node) ?? []) sides[gives ? 1 : 0].add(wire);
  }
  return sides.flatMap((side, out) => {
    const wires = [...side];
    return wires.length ? [{ id: `${group.id}|loose|${out ? "out" : "in"}`, out: out === 1, wires, label: wires.length > 1 ? String(wires.length) : "", classes: ["several"], badge: null }] : [];
  });
}

/**
 * One or several wires as a box of their own.
 * @param {View} view
 * @param {Wire[]} wires
 * @param {Group} group around it
 * @param {Measure} measure
 * @returns {Box}
 */
export function pillBox(view, wires, group, measure) {
  const [first] = wires;
  if (!first) throw new RangeError("a pill stands for something");
  const single = wires.length === 1;
  const text = single ? shortName(first.name, group.namespace, LONGEST.title) : counted(wires.length, first.kind);
  const classes = ["pill", first.kind];
  if (single && first.kind !== "param" && !(first.givers.length && first.takers.length)) classes.push("dangling");
  const mark = commonMark(wires);
  if (mark) classes.push(mark);
  const title = single ? [first.name, ...first.types].join("\n") : wires.map((wire) => wire.name).join("\n");
  const badge = badgeOf(view, wires.flatMap((wire) => wire.findings));
  const id = single ? `w:${first.id}` : `w:${first.id}+${wires.length}`;
  const width = Math.ceil(measure(text, "label")) + 22;
  return { id, kind: "pill", classes, lines: [{ kind: "title", text }], title, badge, width, height: 22, loose: [], level: null, wires };
}

/** @param {Wire[]} wires */
function commonMark(wires) {
  const marks = new Set(wires.map((wire) => wire.mark));
  return marks.size === 1 ? (wires[0]?.mark ?? "") : "";
}

/** @param {View} view @param {Group} group */
function contents(view, group) {
  let [nodes, unknown, first] = [0, 0, -1];
  /** @type {number[]} */
  const findings = [];
  /** @type {Set<string>} */
  const marks = new Set();
  for (const each of walk(group)) {
    findings.push(...each.own);
    for (const index of each.nodes) {
      const node = view.entry.nodes[index];
      if (!node || !view.shown[index]) continue;
      nodes += 1;
      if (first < 0) first = index;
      unknown += Number(node.knowledge === "unknown");
      findings.push(...node.findings);
      marks.add(node.mark ?? (view.touched.has(index) ? "changed" : ""));
    }
  }
  const mark = marks.size === 1 ? String([...marks][0]) : marks.size ? "changed" : "";
  return { nodes, unknown, first, findings, mark };
}

/**
 * @param {View} view
 * @param {string} box
 * @param {Loose[]} all
 * @param {Group} group
 * @returns {LoosePort[]}
 */
function loosePorts(view, box, all, group) {
  /** @type {LoosePort[]} */
  const found = [];
  for (const out of [false, true]) {
    const side = all.filter((each) => each.gives === out);
    const alone = view.state.danglingOnly ? side : side.filter((each) => each.wire.findings.length || (each.mark && !isNew(view, box)));
    const rest = side.filter((each) => !alone.includes(each));
    // Those of which nothing more is to be said share a port: their names come once the node is selected.
    for (const each of [...alone.map((each) => [each]), rest]) {
      const [first] = each;
      if (!first) continue;
      const wires = each.map((loose) => loose.wire);
      const label = each !== rest ? shortName(first.wire.name, group.namespace, LONGEST.label) : each.length > 1 && group.kind !== "tray" ? String(each.length) : "";
      const classes = [each.length === 1 ? first.wire.kind : "several"];
      if (!each.some((loose) => loose.certain)) classes.push("uncertain");
      if (first.mark && each.every((loose) => loose.mark === first.mark)) classes.push(first.mark);
      const badge = badgeOf(view, wires.flatMap((wire) => wire.findings));
      found.push({ id: `${box}|loose|${out ? "out" : "in"}|${first.wire.id}`, out, wires, label, classes, badge });
    }
  }
  return found;
}

/** Whether all of a node came or went: then its ports did, too, and need not be told one by one. @param {View} view @param {string} box */
function isNew(view, box) {
  const mark = view.entry.nodes[Number(box.slice(2))]?.mark;
  return mark === "added" || mark === "removed";
}

/**
 * @param {Omit<Box, "width" | "height">} box
 * @param {Measure} measure
 * @returns {Box}
 */
function sized(box, measure) {
  const indent = box.kind === "folded" ? FOLD : 0;
  const width = Math.max(...box.lines.map((line) => measure(line.text, line.kind)), 56) + 2 * PADDING.x + indent;
  const height = box.lines.reduce((sum, line) => sum + LINE_HEIGHTS[line.kind], 0) + 2 * PADDING.y;
  return { ...box, width: Math.ceil(width), height };
}
