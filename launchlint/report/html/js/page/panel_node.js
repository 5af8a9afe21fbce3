/** The panel of a node: what it says and hears, what its params are, where it is written, and what nobody knows of it. */

import { element } from "./elements.js";
import { isIn, peers } from "./model.js";
import {
  badge,
  block,
  commandPart,
  connectionFacts,
  findingList,
  findingsBlock,
  focusButton,
  heading,
  hideButton,
  list,
  peerList,
  presenceBlock,
  sourceBlock,
} from "./panel_blocks.js";
import { pairField } from "./panel_pair.js";
import { channelReference, nodeReference, reference } from "./reference.js";
import { written } from "./source.js";
import { does, number, ROLE_ORDER } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../data").Node} GraphNode */
/** @typedef {import("../data").Connection} Connection */

/** How many names of one kind are shown that it may have, and nobody is known to use. */
const MOST_IDLE = 5;
/** @type {{ [kind: string]: string }} */
const KINDS = { manager: "Nodelet manager", nodelet: "Nodelet", container: "Component container", component: "Component" };

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {number} index
 * @returns {Child[]}
 */
export function nodePanel(page, model, index) {
  const node = model.entry.nodes[index];
  if (!node) return [];
  const { configuration } = page.store.get();
  const kind = node.isTest ? "Test node" : (KINDS[node.kind] ?? "Node");
  const badges = [
    node.knowledge === "unknown" && badge("interface not known", "unknown"),
    node.lifecycle && badge("lifecycle: somebody has to configure and activate it"),
    node.mark && badge(node.mark, node.mark),
    (node.conditions.length > 0 || node.only.length > 0) && badge("conditional", "conditional"),
  ];
  const namespace = node.namespace !== "/" && `g:namespace:${node.namespace}`;
  const actions = [
    namespace && page.store.get().grouping === "namespace" && focusButton(page, namespace, `Focus on ${node.namespace}`),
    hideButton(page, `n:${index}`),
  ];
  const connections = (model.ofNode[index] ?? []).filter((each) => isIn(each, configuration));
  return [
    ...heading(kind, node.name, badges, actions),
    element("p", {}, "runs ", element("code", {}, node.program), host(page, model, node), machine(node)),
    pairField(page, model, `n:${index}`),
    guestsBlock(page, model, node),
    findingsBlock(page, node.findings),
    node.related.length > 0 && block("Findings elsewhere that speak of it", findingList(page, node.related)),
    node.knowledge === "unknown" && unknownBlock(node, model.entry.mend),
    ...ROLE_ORDER.map((role) => roleBlock(page, model, role, connections)),
    openBlock(node),
    partlyBlock(node),
    paramsBlock(page, model, index, configuration),
    presenceBlock(page, node.only, node.conditions),
    sourceBlock(page, node.place),
    includesBlock(page, model, node),
  ];
}

/** @param {Page} page @param {EntryModel} model @param {GraphNode} node @returns {Child[]} */
function host(page, model, node) {
  if ((node.kind !== "nodelet" && node.kind !== "component") || !node.host) return [];
  const [manager] = model.nodesNamed.get(node.host) ?? [];
  return [" inside ", manager === undefined ? element("code", {}, node.host) : nodeReference(page, manager)];
}

/** What runs in the process of a container or manager. @param {Page} page @param {EntryModel} model @param {GraphNode} node */
function guestsBlock(page, model, node) {
  if (node.kind !== "manager" && node.kind !== "container") return null;
  const guests = model.entry.nodes.flatMap((each, index) => (each !== node && each.host === node.name ? [index] : []));
  return guests.length > 0 && block(`In its process: ${guests.length}`, list(guests.map((each) => nodeReference(page, each))));
}

/** @param {GraphNode} node @returns {Child[]} */
function machine({ machine: [name, address] }) {
  if (name === undefined) return [];
  const where = address ? ` (${address})` : ", which no launch file here declares";
  return [" on the machine ", element("code", {}, name), where];
}

/** @param {Page} page @param {EntryModel} model @param {string} role @param {Connection[]} connections */
function roleBlock(page, model, role, connections) {
  const those = connections.filter((each) => each.role.replace("_", " ") === role && !model.entry.channels[each.channel]?.plumbing);
  if (those.length === 0) return null;
  const { configuration } = page.store.get();
  const title = does(role);
  const item = (/** @type {Connection} */ each) =>
    element(
      "div",
      { class: `connection ${each.mark ?? ""}`.trim() },
      element("div", { class: "name" }, channelReference(page, each.channel)),
      ...connectionFacts(page, each),
      peerList(page, peers(model, each, configuration), each),
    );
  // What may be there and nobody is known to use does not bury the rest: image_transport has dozens.
  const isIdle = (/** @type {Connection} */ each) => !each.certain && peers(model, each, configuration).length === 0;
  const idle = those.filter(isIdle);
  const folded = idle.length > MOST_IDLE ? idle : [];
  const shown = those.filter((each) => !folded.includes(each));
  const more = () =>
    element(
      "details",
      {},
      element("summary", {}, `${folded.length} ${shown.length > 0 ? "more " : ""}that it may have, and nobody is known to use`),
      list(folded.map(item), "connections"),
    );
  return block(
    `${title.charAt(0).toUpperCase()}${title.slice(1)}`,
    shown.length > 0 && list(shown.map(item), "connections"),
    folded.length > 0 && more(),
  );
}

/** Each reason with the kinds that it is one for. @param {GraphNode} node */
function openReasons({ open }) {
  /** @type {Map<string, string[]>} */
  const kinds = new Map();
  for (const [kind, why] of open) kinds.set(why, [...(kinds.get(why) ?? []), kind]);
  return [...kinds].map(([why, those]) => `${[those.slice(0, -1).join(", "), ...those.slice(-1)].filter(Boolean).join(" and ")}: ${why}`);
}

/** @param {GraphNode} node */
function openBlock(node) {
  if (node.open.length === 0 || node.knowledge === "unknown") return null;
  return block("There may be more", list(openReasons(node)));
}

/** The names of which only a part is known. @param {GraphNode} node */
function partlyBlock({ partly }) {
  if (partly.length === 0) return null;
  const items = partly.map(([kind, pattern]) => element("div", {}, `${kind}: `, pattern === "*" ? "any name" : element("code", {}, pattern)));
  return block("Names known only in part", list(items));
}

/** What can be done about a node of which nothing is known. @param {GraphNode} node @param {import("../data").Mend} mend */
function unknownBlock({ reason, learn }, mend) {
  const why = reason.charAt(0).toUpperCase() + reason.slice(1);
  return block(
    "What it does is not known",
    element("p", {}, `${why ? `${why}. ` : ""}So launchlint cannot say what it is connected to, and keeps quiet about it.`),
    learn === "probe" && commandPart(mend.command, "To know it, run this, then make the page again:"),
    learn === "sources" &&
      element("p", {}, "Its package is not in the workspace: put the sources there, or name their directory with --workspace, and launchlint reads them by itself."),
  );
}

/** @param {Page} page @param {EntryModel} model @param {number} index @param {number} configuration */
function paramsBlock(page, model, index, configuration) {
  const those = (model.paramsOf[index] ?? []).filter((each) => isIn(model.entry.params[each] ?? { only: [] }, configuration));
  if (those.length === 0) return null;
  const items = those.flatMap((at) => {
    const param = model.entry.params[at];
    if (!param) return [];
    const read = param.readers.includes(index) ? "" : "not known to be read";
    return element(
      "div",
      { class: "param" },
      element("div", { class: "name" }, reference(page, { kind: "param", id: `p:${at}` }, param.name)),
      element("code", { class: "value" }, param.value),
      element("div", { class: "note" }, param.place && written(page.model, param.place), read && ` · ${read}`),
      param.overrides.length > 0 &&
        element("div", { class: "note" }, "overrides ", element("code", {}, param.overrides.map(([value]) => value).join(", "))),
    );
  });
  return block(number(items.length, "param"), list(items, "params"));
}

/** The includes and groups that lead to a node, outermost first. @param {Page} page @param {EntryModel} model @param {GraphNode} node */
function includesBlock(page, model, node) {
  const steps = [];
  for (let at = node.container; at >= 0 && steps.length < 64; at = model.entry.containers[at]?.parent ?? -1) {
    const container = model.entry.containers[at];
    if (!container) break;
    steps.unshift(
      element(
        "li",
        {},
        `${container.kind} `,
        element("code", {}, container.label || container.namespace),
        " ",
        container.place && written(page.model, container.place),
      ),
    );
  }
  return steps.length > 0 && block("How the launch file gets there", element("ol", { class: "steps" }, ...steps));
}
