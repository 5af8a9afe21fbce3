/** The panels of a topic, service or action, and of a param. */

import { element } from "./elements.js";
import { isIn, mayBeAt } from "./model.js";
import { badge, block, connectionFacts, findingsBlock, heading, list, presenceBlock, sourceBlock } from "./panel_blocks.js";
import { pairField } from "./panel_pair.js";
import { nodeReference } from "./reference.js";
import { missed, nounOf, ROLE_ORDER } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("../data").Channel} Channel */

/** @type {Record<Channel["kind"], [name: string, roles: [string, string]]>} */
const KINDS = {
  topic: ["Topic", ["publisher", "subscriber"]],
  service: ["Service", ["server", "client"]],
  action: ["Action", ["action server", "action client"]],
};

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {number} index
 * @returns {Child[]}
 */
export function channelPanel(page, model, index) {
  const channel = model.entry.channels[index];
  if (!channel) return [];
  const [noun, [offering, using]] = KINDS[channel.kind];
  const ends = (model.onChannel[index] ?? []).filter((each) => isIn(each, page.store.get().configuration));
  const badges = [
    channel.hub && badge("hub: everybody uses it"),
    channel.plumbing && badge("machinery"),
    channel.mark && badge(channel.mark, channel.mark),
    channel.types.length > 1 && badge(`${channel.types.length} types`, "error"),
  ];
  const types = channel.types.map((type) => element("div", {}, element("code", {}, type), ...md5(page, type)));
  const sides = ROLE_ORDER.flatMap((role) => {
    const those = ends.filter((each) => each.role.replace("_", " ") === role);
    return those.length > 0 ? endBlock(page, nounOf(role), those, channel.types.length > 1) : [];
  });
  const offered = ends.some((each) => each.offers);
  const used = ends.some((each) => !each.offers);
  return [
    ...heading(noun, channel.name, badges),
    types.length > 0 ? list(types, "types") : element("p", { class: "note" }, "Its type is not known."),
    findingsBlock(page, channel.findings),
    !channel.hub && !channel.plumbing && pairField(page, model, `c:${index}`),
    ...sides,
    offered !== used && aloneBlock(page, model, index, offered ? offering : using, offered),
  ];
}

/** What libraries say the MD5 of a type is. @param {Page} page @param {string} type */
function md5({ model }, type) {
  return (model.md5s.get(type) ?? []).map((each) => element("div", { class: "note" }, "MD5 ", element("code", {}, each)));
}

/** @param {Page} page @param {string} title @param {Connection[]} those @param {boolean} withType */
function endBlock(page, title, those, withType) {
  const items = those.map((each) =>
    element(
      "div",
      { class: `connection ${each.mark ?? ""}`.trim() },
      element("div", { class: "name" }, nodeReference(page, each.node)),
      ...connectionFacts(page, each, withType),
    ),
  );
  return block(`${title}: ${items.length}`, list(items, "connections"));
}

/**
 * What is said of a channel that has one end only.
 *
 * @param {Page} page
 * @param {EntryModel} model
 * @param {number} index
 * @param {string} role of those that are there
 * @param {boolean} offered whether these offer
 */
function aloneBlock(page, model, index, role, offered) {
  const { hub, plumbing } = model.entry.channels[index] ?? {};
  const doubts = mayBeAt(model, index, !offered, page.store.get().configuration);
  const words = missed(role, doubts);
  const others = "A node that another launch file starts, or a person at a terminal, may be at the other end.";
  const reasons = doubts.map(([, node, , why]) => {
    const [at] = model.nodesNamed.get(node) ?? [];
    const reason = why || (at !== undefined && model.entry.nodes[at]?.reason) || "";
    return element("div", {}, at !== undefined && nodeReference(page, at), element("div", { class: "note" }, reason));
  });
  return block(
    `${words.charAt(0).toUpperCase()}${words.slice(1)}`,
    reasons.length > 0 ? list(reasons) : element("p", {}, hub || plumbing ? "That is usual here: ROS's own tools use it." : others),
  );
}

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {number} index
 * @returns {Child[]}
 */
export function paramPanel(page, model, index) {
  const param = model.entry.params[index];
  if (!param) return [];
  const same = (model.paramsNamed.get(param.name) ?? []).filter((each) => each !== index);
  const others = same.flatMap((each) => model.entry.params[each] ?? []);
  return [
    ...heading("Param", param.name, [param.mark && badge(param.mark, param.mark)]),
    element("pre", { class: "value", tabindex: 0, role: "group", "aria-label": "Value" }, param.value || "(empty)"),
    findingsBlock(page, param.findings),
    block(
      "Read by",
      param.readers.length > 0
        ? list(param.readers.map((node) => nodeReference(page, node)))
        : element("p", { class: "note" }, "No node is known to read it."),
    ),
    sourceBlock(page, param.place, "Set at"),
    ...[...param.overrides].reverse().map(([value, place]) => sourceBlock(page, place, `Overrides ${value || "an empty value"}, set at`)),
    ...others.map((each) => sourceBlock(page, each.place, `In other configurations: ${each.value}`)),
    presenceBlock(page, param.only),
  ];
}
