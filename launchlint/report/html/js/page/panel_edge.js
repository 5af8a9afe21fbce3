/** The panel of a line in the drawing: what runs along it. */

import { element } from "./elements.js";
import { block, heading, list } from "./panel_blocks.js";
import { channelReference, nodeReference, reference } from "./reference.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {string} id
 * @returns {Child[]}
 */
export function edgePanel(page, model, id) {
  const wires = page.drawing.wiresOf({ kind: "edge", id });
  const channels = wires.filter((each) => each.startsWith("c:")).map((each) => Number(each.slice(2)));
  const params = wires.filter((each) => each.startsWith("p:"));
  if (wires.length === 0) return [];
  const kinds = new Set(channels.map((each) => model.entry.channels[each]?.kind ?? "topic"));
  const [kind] = kinds;
  const noun = params.length > 0 ? "param" : kinds.size === 1 && kind ? kind : "name";
  return [
    ...heading("Line", number(wires.length, noun), []),
    element("p", { class: "note" }, "What runs along this line:"),
    ...channels.map((each) => channelBlock(page, model, each)),
    params.length > 0 &&
      list(params.map((each) => reference(page, { kind: "param", id: each }, model.entry.params[Number(each.slice(2))]?.name ?? ""))),
  ];
}

/** @param {Page} page @param {EntryModel} model @param {number} channel */
function channelBlock(page, model, channel) {
  const ends = model.onChannel[channel] ?? [];
  const nodes = (/** @type {boolean} */ offers) => [...new Set(ends.filter((each) => each.offers === offers).map((each) => each.node))];
  const side = (/** @type {string} */ title, /** @type {number[]} */ those) =>
    those.length > 0 && element("div", {}, element("span", { class: "note" }, title), list(those.map((each) => nodeReference(page, each))));
  const topic = model.entry.channels[channel]?.kind === "topic";
  return block(
    "",
    element("div", { class: "name" }, channelReference(page, channel)),
    element("div", { class: "type" }, element("code", {}, model.entry.channels[channel]?.types.join(", ") ?? "")),
    side(topic ? "from" : "served by", nodes(true)),
    side(topic ? "to" : "called by", nodes(false)),
  );
}
