// What the signs of the drawing mean: those that it shows.

import { element, text } from "./shapes.js";

/** @typedef {import("./model").Sheet} Sheet */

/** @type {[test: (sheet: Sheet) => boolean, words: string, sample: () => SVGElement[]][]} */
const SIGNS = [
  [hasLine("topic"), "topic", () => line("topic", "M36 6L44 10L36 14Z")],
  [hasLine("service"), "service, from client to server", () => line("service", "M32 10L37 6L42 10L37 14Z")],
  [hasLine("action"), "action, from client to server", () => line("action", "M36 6L44 10L36 14ZM30 6L38 10L30 14Z")],
  [hasLine("param"), "param, to its readers", () => line("param", "M36 7H42V13H36Z")],
  [(sheet) => sheet.edges.some(({ edge }) => edge.wires.length > 2), "several between the same two", () => line("topic bundle", "M36 6L44 10L36 14Z")],
  [hasLine("conditional"), "in some configurations only", () => line("topic conditional", "M36 6L44 10L36 14Z")],
  [hasLine("uncertain"), "not certain", () => line("topic uncertain", "M36 6L44 10L36 14Z")],
  [hasBox("folded"), "container, folded", () => box("folded")],
  [hasBox("conditional"), "conditional node", () => box("node conditional")],
  [hasBox("lifecycle"), "lifecycle node", () => [...box("node"), group("box node", element("rect", { class: "inner", x: 5, y: 5, width: 34, height: 10, rx: 3 }))]],
  [hasBox("host"), "process that others run in", () => box("node host")],
  [hasBox("unknown"), "unknown: what it connects to is not known", () => [...box("node unknown"), element("rect", { x: 3, y: 3, width: 38, height: 14, fill: "url(#ll-hatching)" })]],
  [hasBox("pill"), "many to many, or shared", () => [group("box pill topic", element("rect", { class: "shape", x: 2, y: 3, width: 40, height: 14, rx: 7 }))]],
  [hasBox("stub"), "around what is in focus", () => box("node stub")],
  [(sheet) => sheet.loose.length > 0, "nobody else is known to use or offer it", () => [group("loose topic", element("circle", { cx: 22, cy: 10, r: 4 }))]],
  [hasAny("added"), "added", () => box("node added")],
  [hasAny("removed"), "removed", () => box("node removed")],
  [hasAny("changed"), "changed", () => box("node changed")],
  [(sheet) => sheet.boxes.some((each) => each.box.badge?.elsewhere), "a finding elsewhere is about it, too", () => [group("badge error elsewhere", element("circle", { cx: 22, cy: 10, r: 8 }), text("!", { x: 22, y: 14 }))]],
  [(sheet) => sheet.boxes.some((each) => each.box.badge && !each.box.badge.elsewhere) || sheet.loose.some((each) => each.port.badge), "findings", () => [group("badge error", element("circle", { cx: 22, cy: 10, r: 8 }), text("!", { x: 22, y: 14 }))]],
];

/**
 * @param {Sheet} sheet
 * @param {HTMLDetailsElement} host
 */
export function showLegend(sheet, host) {
  const list = document.createElement("ul");
  for (const [isShown, words, sample] of SIGNS) {
    if (!isShown(sheet)) continue;
    const item = list.appendChild(document.createElement("li"));
    item.append(element("svg", { class: "ll-drawing", viewBox: "0 0 44 20", "aria-hidden": "true" }, sample()), words);
  }
  host.querySelector("ul")?.remove();
  host.hidden = !list.childElementCount;
  host.append(list);
}

/** @param {string} name @returns {(sheet: Sheet) => boolean} */
function hasLine(name) {
  return (sheet) => sheet.edges.some(({ edge }) => edge.classes.includes(name));
}

/** @param {string} name @returns {(sheet: Sheet) => boolean} */
function hasBox(name) {
  return (sheet) => sheet.boxes.some(({ box: { classes } }) => classes.includes(name));
}

/** @param {string} name @returns {(sheet: Sheet) => boolean} */
function hasAny(name) {
  return (sheet) => hasLine(name)(sheet) || hasBox(name)(sheet);
}

/** @param {string} classes @param {SVGElement[]} children */
function group(classes, ...children) {
  return element("g", { class: classes }, children);
}

/** @param {string} classes @param {string} head */
function line(classes, head) {
  return [group(`line ${classes}`, element("path", { class: "course", d: "M2 10H36" }), element("path", { class: "head", d: head }))];
}

/** @param {string} classes */
function box(classes) {
  return [group(`box ${classes}`, element("rect", { class: "shape", x: 2, y: 2, width: 40, height: 16, rx: 4 }))];
}
