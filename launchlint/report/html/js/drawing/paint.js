// The drawing as SVG: containers, then lines, then boxes, then names, so that nothing hides a name.

import { FOLD, LINE_HEIGHTS, PADDING } from "./boxes.js";
import { LABEL_HEIGHT } from "./engine.js";
import { course, element, text, title } from "./shapes.js";

/** @typedef {import("./model").Badge} Badge */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Sheet} Sheet */

/** In a box that its ports make high, names stand so far from its top. */
const HIGH = 24;

/**
 * What was painted, by the ids of what it stands for.
 * @typedef {object} Painted
 * @property {SVGGElement} content
 * @property {Map<string, SVGGElement>} boxes
 * @property {Map<string, SVGElement[]>} lines of an edge: itself and its name
 * @property {{ element: SVGElement, id: string }[]} ports by the id of the port
 * @property {{ element: SVGElement, box: string, wires: string[] }[]} loose
 */

/**
 * @param {Sheet} sheet
 * @returns {Painted}
 */
export function paint(sheet) {
  const content = element("g", { class: "content" });
  const [open, lines, boxes, names] = ["containers", "lines", "boxes", "names"].map((each) => content.appendChild(element("g", { class: each })));
  /** @type {Painted} */
  const painted = { content, boxes: new Map(), lines: new Map(), ports: [], loose: [] };
  for (const each of sheet.boxes) {
    const drawn = each.box.kind === "open" ? openElement(each) : boxElement(each);
    painted.boxes.set(each.box.id, drawn);
    (each.box.kind === "open" ? open : boxes)?.append(drawn);
  }
  for (const each of sheet.edges) {
    const drawn = lineElement(each);
    painted.lines.set(each.edge.id, [drawn]);
    lines?.append(drawn);
  }
  for (const { x, y, port } of sheet.ports) {
    const drawn = element("rect", { class: `port ${port.kind}`, x: x - 3, y: y - 3, width: 6, height: 6, rx: 1.5 });
    painted.ports.push({ element: drawn, id: port.id });
    boxes?.append(drawn);
  }
  for (const { x, y, height, lines: written, classes, edge } of sheet.labels) {
    const drawn = element("g", { class: `name ${classes.join(" ")}`, "data-id": edge.id });
    written.forEach((line, at) => drawn.append(text(line, { x: x + 5, y: y + height - 4 - (written.length - 1 - at) * LABEL_HEIGHT })));
    painted.lines.get(edge.id)?.push(drawn);
    names?.append(drawn);
  }
  for (const each of sheet.loose) {
    const drawn = looseElement(each);
    painted.loose.push({ element: drawn, box: each.box.id, wires: each.port.wires.map((wire) => wire.id) });
    names?.append(drawn);
  }
  content.append(element("g", { class: "told-names" }));
  return painted;
}

/** @param {Sheet["boxes"][number]} placed @returns {SVGGElement} */
function boxElement({ x, y, width, height, box }) {
  const drawn = frame(box, x, y);
  const corner = box.kind === "pill" ? height / 2 : box.kind === "folded" ? 8 : 5;
  if (box.kind === "folded") drawn.append(element("rect", { class: "behind", x: 4, y: 4, width, height, rx: corner }));
  drawn.append(element("rect", { class: "shape", width, height, rx: corner }));
  // A node of two states has two borders; what others run in has a thick one.
  if (box.classes.includes("lifecycle")) drawn.append(element("rect", { class: "inner", x: 3, y: 3, width: width - 6, height: height - 6, rx: 3 }));
  if (box.classes.includes("unknown")) drawn.append(element("rect", { class: "hatched", x: 1, y: 1, width: width - 2, height: height - 2, rx: corner - 1, fill: "url(#ll-hatching)" }));
  if (box.kind === "pill") drawn.append(text(box.lines[0]?.text ?? "", { class: "title", x: width / 2, y: height / 2 + 4, "text-anchor": "middle" }));
  else {
    const block = box.lines.reduce((sum, line) => sum + LINE_HEIGHTS[line.kind], 0);
    const above = Math.min((height - block) / 2, HIGH);
    let baseline = above - 4;
    const indent = box.kind === "folded" ? FOLD : 0;
    for (const line of box.lines) {
      baseline += LINE_HEIGHTS[line.kind];
      drawn.append(text(line.text, { class: line.kind, x: PADDING.x + indent, y: baseline }));
    }
    if (box.kind === "folded") drawn.append(fold(box.id, 8, above + 1, true));
  }
  if (box.badge) drawn.append(badge(box.badge, width - 9, 0));
  return drawn;
}

/** @param {Sheet["boxes"][number]} placed @returns {SVGGElement} */
function openElement({ x, y, width, height, box }) {
  const drawn = frame(box, x, y);
  drawn.append(element("rect", { class: "shape", width, height, rx: box.classes.includes("include") || box.classes.includes("group") ? 3 : 10 }));
  const head = drawn.appendChild(element("g", { class: "head" }, [element("rect", { width, height: 26, fill: "transparent" })]));
  head.append(fold(box.id, 8, 6, false), text(box.lines[0]?.text ?? "", { class: "title", x: FOLD + 9, y: 19 }));
  const tag = [box.lines[1]?.text, tagOf(box)].filter(Boolean).join(" · ");
  if (tag && width > 220) head.append(text(tag, { class: "tag", x: width - 10, y: 18, "text-anchor": "end" }));
  if (box.badge) drawn.append(badge(box.badge, width - 9, 0));
  return drawn;
}

/** What kind of container it is, where that is not plain from its name. @param {Box} box */
function tagOf(box) {
  return ["include", "group", "package", "machine"].find((each) => box.classes.includes(each)) ?? "";
}

/** @param {Box} box @param {number} x @param {number} y */
function frame(box, x, y) {
  // Its title is its name to screen readers, too.
  const attributes = { class: `box ${box.classes.join(" ")}`, transform: `translate(${x} ${y})`, "data-id": box.id, role: "button", tabindex: -1 };
  return element("g", attributes, [title(box.title)]);
}

/**
 * The sign that opens or folds a container.
 * @param {string} container
 * @param {number} x
 * @param {number} y
 * @param {boolean} folded
 */
function fold(container, x, y, folded) {
  const sign = folded ? "M6 3.5L10 7.5L6 11.5" : "M3.5 6L7.5 10L11.5 6";
  return element("g", { class: "fold", "data-fold": container, transform: `translate(${x} ${y})` }, [
    element("rect", { x: -6, y: -4, width: 24, height: 24 }),
    element("path", { d: sign }),
  ]);
}

/** @param {Badge} about @param {number} x @param {number} y */
function badge(about, x, y) {
  const sign = about.count > 99 ? "99" : about.count > 1 ? String(about.count) : about.severity === "info" ? "i" : "!";
  const found = about.count > 1 ? `${about.count} findings` : `1 ${about.severity}`;
  const words = about.elsewhere ? `${found} elsewhere, about this, too` : found;
  return element("g", { class: `badge ${about.severity} ${about.elsewhere ? "elsewhere" : ""}`.trim(), transform: `translate(${x} ${y})` }, [title(words), element("circle", { r: 8.5 }), text(sign, { y: 4.2 })]);
}

/** @param {Sheet["edges"][number]} placed @returns {SVGGElement} */
function lineElement({ edge, points, junctions, arrives }) {
  const bundle = edge.wires.length > 2 ? " bundle" : "";
  const drawn = element("g", { class: `line ${edge.classes.join(" ")}${bundle}`, "data-id": edge.id }, [
    title(edge.wires.slice(0, 40).map((wire) => [wire.name, ...wire.types].join("  ")).join("\n")),
  ]);
  const d = course(points);
  drawn.append(element("path", { class: "hit", d }), element("path", { class: "course", d }));
  const last = points[points.length - 1];
  for (const { x, y } of junctions) {
    const hidden = arrives && last && Math.abs(last.y - y) < 1 && last.x - x < 16; // by the arrow's head
    if (!hidden) drawn.append(element("circle", { class: "joint", cx: x, cy: y, r: 2.4 }));
  }
  if (arrives && last) drawn.append(head(edge.kind, last.x, last.y));
  return drawn;
}

/** @param {string} kind @param {number} x @param {number} y */
function head(kind, x, y) {
  const shapes = { topic: "M-8 -4L0 0L-8 4Z", service: "M-10 0L-5 -4L0 0L-5 4Z", action: "M-8 -4L0 0L-8 4ZM-14 -4L-6 0L-14 4Z", param: "M-6 -3H0V3H-6Z" };
  return element("path", { class: "head", d: shapes[/** @type {keyof typeof shapes} */ (kind)] ?? shapes.topic, transform: `translate(${x} ${y})` });
}

/** What is said of an empty end, with the doubt that there is. @param {Sheet["loose"][number]["port"]["wires"][number]} wire @param {boolean} out */
function missing(wire, out) {
  const does = out ? "uses" : "offers";
  const doubtful = wire.may?.some(([offers]) => offers !== ((wire.kind === "topic") === out));
  return doubtful ? `nobody known ${does} it; a node that is not known as a whole may` : `nobody else ${does} it`;
}

/** @param {Sheet["loose"][number]} placed @returns {SVGGElement} */
function looseElement({ x, y, port, label }) {
  const drawn = element("g", { class: `loose ${port.classes.join(" ")}`, "data-loose": port.wires.map((wire) => wire.id).join(" ") }, [
    title(port.wires.map((wire) => `${wire.name}: ${missing(wire, port.out)}`).join("\n")),
    element("circle", { cx: x, cy: y, r: 4 }),
  ]);
  if (label) {
    const away = port.badge ? 26 : 9;
    const at = { x: port.out ? x + away : x - away, y: y + 4, "text-anchor": port.out ? "start" : "end" };
    drawn.append(element("g", { class: `name ${port.badge?.severity ?? ""}` }, [text(port.label, at)]));
  }
  if (port.badge) drawn.append(badge(port.badge, port.out ? x + 15 : x - 15, y));
  return drawn;
}
