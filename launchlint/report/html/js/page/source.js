/** Where something is written: file and line, a link where the repository is known, and the lines themselves. */

import { sourceLink } from "../links.js";
import { element } from "./elements.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("../data").Place} Place */

const AROUND = 2;
const LONGEST_MARKED = 12;

/**
 * "path:line".
 *
 * @param {Model} model
 * @param {Place} place
 */
export function written(model, place) {
  const address = sourceLink(model.data, place[0], place[1]);
  const text = model.place(place);
  return address === null ? element("code", { class: "place" }, text) : element("a", { class: "place", href: address }, text);
}

/**
 * The lines around a place, that part of them marked which a finding is about; only the place where the page holds no lines.
 *
 * @param {Model} model
 * @param {Place} place
 * @param {{ endLine: number, endColumn: number, label: string }} [marked]
 */
export function source(model, place, marked) {
  const [file, line, column] = place;
  const last = marked ? Math.min(marked.endLine, line + LONGEST_MARKED) : line;
  const shown = [];
  for (let at = Math.max(1, line - AROUND); at <= last + AROUND; at += 1) {
    const text = model.line(file, at);
    if (text === undefined) continue;
    const inside = at >= line && at <= last;
    const from = at === line ? column - 1 : 0;
    const to = marked && at === marked.endLine ? marked.endColumn - 1 : Infinity;
    shown.push(
      element(
        "span",
        { class: inside ? "line hit" : "line" },
        element("span", { class: "number", "aria-hidden": "true" }, String(at)),
        element("span", { class: "text" }, ...(inside && marked ? split(text, from, to) : [text || " "])),
      ),
    );
    if (marked?.label && at === last) {
      const start = at === line ? Math.max(column - 1, indentOf(Array.from(text))) : indentOf(Array.from(text));
      const below = Array.from(text).slice(0, start).join("").replaceAll(/[^\t]/g, " ");
      const label = element("span", { class: "text" }, `${below}└ ${marked.label}`);
      shown.push(element("span", { class: "line label" }, element("span", { class: "number" }), label));
    }
  }
  const where = element("figcaption", {}, written(model, place));
  // Long lines scroll sideways, also by keyboard.
  const code = shown.length > 0 && element("pre", { class: "source", tabindex: 0, role: "group", "aria-label": model.place(place) }, shown);
  return element("figure", { class: "source" }, where, code);
}

/**
 * A line with what lies between two columns marked; columns count code points, from 0.
 *
 * @param {string} line
 * @param {number} from
 * @param {number} to
 */
function split(line, from, to) {
  const points = Array.from(line);
  const start = Math.max(from, indentOf(points));
  const end = Math.max(start, Math.min(to, points.length));
  const middle = points.slice(start, end).join("");
  return [points.slice(0, start).join(""), middle && element("mark", {}, middle), points.slice(end).join("")];
}

/** @param {string[]} points */
function indentOf(points) {
  return Math.max(
    0,
    points.findIndex((each) => each.trim() !== ""),
  );
}
