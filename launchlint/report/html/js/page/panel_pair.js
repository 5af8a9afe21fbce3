/** The panel of two things: does the one hear the other, and if not, what stands in the way. */

import { element } from "./elements.js";
import { block, heading, list } from "./panel_blocks.js";
import { channelReference, nodeReference } from "./reference.js";
import { does } from "./wording.js";
import { nearMisses, pathBetween } from "./why.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("./why.js").Near} Near */
/** @typedef {import("./why.js").Step} Step */

/** Names that the field offers. */
const OFFERED = 600;

/**
 * A field that takes a second node, or a topic where the first is a node, and asks how both are connected.
 *
 * @param {Page} page
 * @param {EntryModel} model
 * @param {string} id of the first, a node or a channel
 */
export function pairField({ store }, model, id) {
  /** @type {Map<string, string>} */
  const names = new Map();
  for (const [index, node] of model.entry.nodes.entries()) if (`n:${index}` !== id && !names.has(node.name)) names.set(node.name, `n:${index}`);
  const isNode = id.startsWith("n:");
  if (isNode) for (const [index, { name, hub, plumbing }] of model.entry.channels.entries()) if (!hub && !plumbing && !names.has(name)) names.set(name, `c:${index}`);
  const offers = element("datalist", { id: "pair-names" }, ...[...names.keys()].slice(0, OFFERED).map((name) => element("option", { value: name })));
  const field = element("input", { type: "search", list: "pair-names", placeholder: isNode ? "Why does it not hear …" : "Why is it not connected with …", "aria-label": isNode ? "Another node or topic: why are they not connected?" : "A node: why are they not connected?", class: "pair", autocomplete: "off" });
  const ask = () => {
    const other = names.get(field.value.trim());
    if (other) store.set({ selection: { kind: "pair", id: isNode ? `${id}|${other}` : `${other}|${id}` } });
  };
  field.addEventListener("input", ask);
  return element("p", { class: "pair-host" }, field, offers);
}

/**
 * The ids that are lit for a pair: the nodes and channels of the way between them, or both alone.
 *
 * @param {EntryModel} model
 * @param {string} id
 * @param {number} configuration
 */
export function pairWay(model, id, configuration) {
  const [one = "", other = ""] = id.split("|");
  const [from, to] = [Number(one.slice(2)), Number(other.slice(2))];
  const way = other.startsWith("n:") ? (pathBetween(model, from, to, configuration) ?? pathBetween(model, to, from, configuration)) : null;
  return way ? [...new Set(way.flatMap((step) => [`n:${step.from}`, `c:${step.channel}`, `n:${step.to}`]))] : [one, other];
}

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {string} id
 * @returns {Child[]}
 */
export function pairPanel(page, model, id) {
  const [one = "", other = ""] = id.split("|");
  const node = model.entry.nodes[Number(one.slice(2))];
  if (!node) return [];
  if (other.startsWith("c:")) return topicPanel(page, model, Number(one.slice(2)), Number(other.slice(2)));
  const [from, to] = [Number(one.slice(2)), Number(other.slice(2))];
  const second = model.entry.nodes[to];
  if (!second) return [];
  return [
    ...heading("Two nodes", `${node.name} and ${second.name}`, []),
    ...directionBlocks(page, model, from, to),
    ...directionBlocks(page, model, to, from),
    unknownNote(model, [from, to]),
  ];
}

/** @param {Page} page @param {EntryModel} model @param {number} from @param {number} to */
function directionBlocks(page, model, from, to) {
  const [one, other] = [model.entry.nodes[from]?.name ?? "", model.entry.nodes[to]?.name ?? ""];
  const path = pathBetween(model, from, to, page.store.get().configuration);
  if (path) return [block(path.length > 1 ? `${other} hears ${one} by way of others` : `${other} hears ${one}`, list(path.map((step) => stepItem(page, step)), "steps"))];
  const near = nearMisses(model, from, to, (place) => page.model.place(place));
  if (near.length === 0) return [block(`${other} does not hear ${one}`, element("p", {}, `Nothing that ${one} gives is like anything that ${other} takes.`))];
  return [block(`${other} does not hear ${one}`, ...near.map((each) => nearItem(page, model, each)))];
}

/** @param {Page} page @param {Step} step */
function stepItem(page, { from, channel, to }) {
  return element("div", {}, nodeReference(page, from), " → ", channelReference(page, channel), " → ", nodeReference(page, to));
}

/** @param {Page} page @param {EntryModel} model @param {Near} near */
function nearItem(page, model, { giver, taker, apart, edit }) {
  const rows = [
    ["", ...[giver, taker].map((each) => `${model.entry.nodes[each.node]?.name ?? ""} ${does(each.role)}`)],
    ["in the code", giver.declared, taker.declared],
    ["in its namespace", giver.unremapped, taker.unremapped],
    ...remapRows(giver, taker),
    ["on the graph", nameOf(model, giver), nameOf(model, taker)],
    ["type", giver.type || "not known", taker.type || "not known"],
    ...(giver.qos || taker.qos ? [["QoS", giver.qos ?? "not known", taker.qos ?? "not known"]] : []),
  ];
  const [head = [], ...body] = rows;
  const line = (/** @type {string[]} */ [title = "", left = "", right = ""]) =>
    element("tr", { class: left !== right && title !== "in the code" ? "parts" : null }, element("th", { scope: "row" }, title), element("td", {}, element("code", {}, left)), element("td", {}, element("code", {}, right)));
  return element(
    "div",
    { class: "near" },
    element("table", { class: "beside" }, element("thead", {}, element("tr", {}, ...head.map((each) => element("th", { scope: "col" }, each)))), element("tbody", {}, ...body.map(line))),
    element("p", { class: "apart" }, apart),
    element("p", {}, element("b", {}, "To join them: "), edit),
    element("p", { class: "note" }, "See ", channelReference(page, giver.channel), " and ", channelReference(page, taker.channel)),
  );
}

/** The names after each remap, side by side. @param {Connection} giver @param {Connection} taker */
function remapRows(giver, taker) {
  const steps = (/** @type {Connection} */ each) => each.remaps.filter(([from, to]) => from !== to).map(([, to]) => to);
  const [left, right] = [steps(giver), steps(taker)];
  return Array.from({ length: Math.max(left.length, right.length) }, (_, at) => [`after remap ${at + 1}`, left[at] ?? "", right[at] ?? ""]);
}

/** @param {EntryModel} model @param {Connection} each */
const nameOf = (model, each) => model.entry.channels[each.channel]?.name ?? "";

/** @param {EntryModel} model @param {number[]} nodes */
function unknownNote(model, nodes) {
  const names = nodes.flatMap((each) => (model.entry.nodes[each]?.knowledge === "unknown" ? [model.entry.nodes[each]?.name] : []));
  return names.length > 0 && element("p", { class: "note" }, `What ${names.join(" and ")} ${names.length > 1 ? "do" : "does"} is not known, so more may connect them.`);
}

/** A node and a topic that it may not be on. @param {Page} page @param {EntryModel} model @param {number} node @param {number} channel @returns {Child[]} */
function topicPanel(page, model, node, channel) {
  const name = model.entry.channels[channel]?.name ?? "";
  const own = (model.ofNode[node] ?? []).filter((each) => each.channel === channel);
  const title = heading("A node and a name", `${model.entry.nodes[node]?.name ?? ""} and ${name}`, []);
  if (own.length > 0) return [...title, block("Connected", list(own.map((each) => element("div", {}, nodeReference(page, node), ` ${does(each.role)} `, channelReference(page, channel)))))];
  const others = [...new Set((model.onChannel[channel] ?? []).map((each) => each.node))].filter((each) => each !== node);
  const near = others.flatMap((other) => [...nearMisses(model, other, node, (place) => page.model.place(place)), ...nearMisses(model, node, other, (place) => page.model.place(place))]);
  const about = near.filter((each) => each.giver.channel === channel || each.taker.channel === channel).slice(0, 3);
  return [
    ...title,
    about.length > 0
      ? block("Not connected", ...about.map((each) => nearItem(page, model, each)))
      : block("Not connected", element("p", {}, "Nothing that the node gives or takes is like this name.")),
    unknownNote(model, [node]),
  ];
}
