/** The panel of a namespace, group, include, package or machine: what is in it, and what goes in and out. */

import { button, element } from "./elements.js";
import { containerOf, findingsWithin, fullName, nodesWithin } from "./containers.js";
import { isIn } from "./model.js";
import { block, findingsBlock, focusButton, heading, hideButton, list, sourceBlock } from "./panel_blocks.js";
import { channelReference, nodeReference, reference } from "./reference.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../drawing/types").Group} Group */

/** @type {Record<Group["kind"], string>} */
const KINDS = { root: "Everything", namespace: "Namespace", group: "Group", include: "Include", package: "Package", machine: "Machine", range: "Neighbours", tray: "Without a connection" };

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @param {string} id
 * @returns {Child[]}
 */
export function containerPanel(page, model, id) {
  const { grouping, configuration } = page.store.get();
  const group = containerOf(model.entry, grouping, id);
  if (!group) return [];
  const nodes = nodesWithin(group);
  const findings = findingsWithin(model.entry, group);
  const place = model.entry.containers[group.container]?.place ?? null;
  const { incoming, outgoing } = boundary(model, new Set(nodes), configuration);
  const inner = group.groups.map((each) => [reference(page, { kind: "container", id: each.id }, fullName(each)), ` ${number(each.count, "node")}`]);
  return [
    ...heading(KINDS[group.kind], fullName(group), [], [openButton(page, id), focusButton(page, id, "Focus on it"), hideButton(page, id)]),
    findingsBlock(page, findings),
    channels(page, "Goes out", outgoing),
    channels(page, "Comes in", incoming),
    inner.length > 0 && block("Contains", list(inner.map((each) => element("div", {}, ...each)))),
    group.nodes.length > 0 && block(number(group.nodes.length, "node"), list(group.nodes.map((each) => nodeReference(page, each)))),
    sourceBlock(page, place),
  ];
}

/** @param {Page} page @param {string} id */
function openButton({ store, drawing }, id) {
  const open = drawing.expanded().has(id);
  return button(open ? "Collapse" : "Expand", () => {
    const expanded = drawing.expanded();
    if (open) expanded.delete(id);
    else expanded.add(id);
    store.set({ expanded });
  });
}

/** @param {Page} page @param {string} title @param {number[]} those */
function channels(page, title, those) {
  return those.length > 0 && block(title, list(those.map((each) => channelReference(page, each))));
}

/**
 * The channels that pass the border of a container, hubs and the machinery of nodes left out.
 *
 * @param {EntryModel} model
 * @param {ReadonlySet<number>} inside nodes
 * @param {number} configuration
 */
function boundary(model, inside, configuration) {
  /** @type {number[]} */
  const incoming = [];
  /** @type {number[]} */
  const outgoing = [];
  const touched = new Set([...inside].flatMap((node) => (model.ofNode[node] ?? []).map((each) => each.channel)));
  for (const channel of touched) {
    const { kind, hub, plumbing } = model.entry.channels[channel] ?? { kind: "topic", hub: true, plumbing: true };
    if (hub || plumbing) continue;
    const ends = (model.onChannel[channel] ?? []).filter((each) => isIn(each, configuration));
    // Data goes from publishers to subscribers, and from clients to servers.
    const gives = (/** @type {import("../data").Connection} */ each) => (kind === "topic") === each.offers;
    const has = (/** @type {boolean} */ giving, /** @type {boolean} */ within) =>
      ends.some((each) => gives(each) === giving && inside.has(each.node) === within);
    if (has(true, true) && has(false, false)) outgoing.push(channel);
    if (has(false, true) && has(true, false)) incoming.push(channel);
  }
  return { incoming, outgoing };
}
