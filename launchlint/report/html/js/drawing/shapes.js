// SVG elements and the course of lines.

/** @typedef {import("./model").Point} Point */

const SVG = "http://www.w3.org/2000/svg";
const CORNER = 7;

/**
 * @template {keyof SVGElementTagNameMap} T
 * @param {T} tag
 * @param {Record<string, string | number>} [attributes]
 * @param {(Node | null)[]} [children]
 * @returns {SVGElementTagNameMap[T]}
 */
export function element(tag, attributes = {}, children = []) {
  const made = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  for (const each of children) if (each) made.append(each);
  return made;
}

/**
 * @param {string} content
 * @param {Record<string, string | number>} attributes
 */
export function text(content, attributes) {
  const made = element("text", attributes);
  made.textContent = content;
  return made;
}

/** @param {string} content */
export function title(content) {
  const made = element("title");
  made.textContent = content;
  return made;
}

/**
 * A line through points, with rounded corners.
 * @param {Point[]} points
 * @returns {string} for the attribute d
 */
export function course(points) {
  const [first] = points;
  if (!first) return "";
  let path = `M${round(first.x)} ${round(first.y)}`;
  for (let at = 1; at < points.length; at++) {
    const [before, corner, after] = [points[at - 1], points[at], points[at + 1]];
    if (!before || !corner) continue;
    if (!after) {
      path += `L${round(corner.x)} ${round(corner.y)}`;
      continue;
    }
    const [enter, leave] = [towards(corner, before), towards(corner, after)];
    path += `L${round(enter.x)} ${round(enter.y)}Q${round(corner.x)} ${round(corner.y)} ${round(leave.x)} ${round(leave.y)}`;
  }
  return path;
}

/** @param {Point} from @param {Point} to */
function towards(from, to) {
  const length = Math.hypot(to.x - from.x, to.y - from.y);
  const part = length ? Math.min(CORNER, length / 2) / length : 0;
  return { x: from.x + (to.x - from.x) * part, y: from.y + (to.y - from.y) * part };
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 10) / 10;
}
