// The names at the ports of what is selected: connected and hollow ones, beside the border, as long as it is selected.

import { shortName } from "./names.js";
import { element, text } from "./shapes.js";

/** @typedef {import("./types").Selection} Selection */
/** @typedef {import("./model").Point} Point */
/** @typedef {import("./model").Wire} Wire */
/** @typedef {import("./scene").Scene} Scene */

/** Names at one port, and the longest of them in characters. */
const MOST = 6;
const LONGEST = 34;
const HEIGHT = 14;

/**
 * @param {Scene} scene
 * @param {Selection} selection
 * @param {ReadonlySet<string>} chosen boxes
 * @returns {SVGGElement[]}
 */
export function toldNames(scene, selection, chosen) {
  const { sheet, view } = scene;
  const found = [];
  const namespace = view.groups.get(selection.id)?.namespace ?? "";
  for (const each of sheet.loose) {
    // A port that says its name already need not say it twice.
    if (chosen.has(each.box.id) && !/[^0-9]/.test(each.port.label)) found.push(names(each, each.port.out, each.port.wires, namespace, "hollow"));
  }
  if (selection.kind === "container") {
    for (const each of sheet.ports) if (each.port.id.startsWith(`${selection.id}|`)) found.push(names(each, each.port.out, each.port.wires, namespace, "joined"));
  }
  return found;
}

/** @param {Point} at @param {boolean} out @param {Wire[]} wires @param {string} namespace @param {string} kind */
function names(at, out, wires, namespace, kind) {
  const said = wires.slice(0, MOST).map((wire) => shortName(wire.name, namespace, LONGEST));
  if (wires.length > MOST) said.push(`and ${wires.length - MOST} more`);
  const top = at.y + 4 - ((said.length - 1) * HEIGHT) / 2;
  const drawn = element("g", { class: `told ${kind}` });
  said.forEach((line, index) => drawn.append(text(line, { x: out ? at.x + 9 : at.x - 9, y: top + index * HEIGHT, "text-anchor": out ? "start" : "end" })));
  return drawn;
}
