/** The panel of a namespace, group, include, package or machine: what is in it, and what goes in and out. */

import { button, element } from "./elements.js";
import { containerOf, findingsWithin, fullName, nodesWithin } from "./containers.js";
import { interfaceOf } from "./interface.js";
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
  const { incoming, outgoing, looseIn, looseOut } = interfaceOf(model, new Set(nodes), configuration);
  const args = model.entry.containers[group.container]?.args ?? [];
  const inner = group.groups.map((each) => [reference(page, { kind: "container", id: each.id }, fullName(each)), ` ${number(each.count, "node")}`]);
  return [
    ...heading(KINDS[group.kind], fullName(group), [], [openButton(page, id), focusButton(page, id, "Focus on it"), hideButton(page, id)]),
    findingsBlock(page, findings),
    args.length > 0 && argsBlock(args),
    channels(page, "Comes in", incoming),
    channels(page, "Goes out", outgoing),
    channels(page, "Waits for what nobody here is known to offer", looseIn),
    channels(page, "Offers what nobody here is known to use", looseOut),
    inner.length > 0 && block("Contains", list(inner.map((each) => element("div", {}, ...each)))),
    group.nodes.length > 0 && block(number(group.nodes.length, "node"), list(group.nodes.map((each) => nodeReference(page, each)))),
    sourceBlock(page, place),
  ];
}

/** What an include passes, and what the file has beside. @param {[name: string, value: string | null, fallback: string | null][]} args */
function argsBlock(args) {
  const rows = args.map(([name, value, fallback]) =>
    element(
      "tr",
      {},
      element("th", { scope: "row" }, element("code", {}, name)),
      element("td", {}, value === null ? element("span", { class: "note" }, "default") : element("code", {}, value || "(empty)")),
      element("td", {}, fallback === null ? element("span", { class: "note" }, "none") : element("code", {}, fallback || "(empty)")),
    ),
  );
  const head = element("tr", {}, ...["Arg", "Passed", "Default"].map((each) => element("th", { scope: "col" }, each)));
  return block(number(args.length, "arg"), element("table", { class: "args" }, element("thead", {}, head), element("tbody", {}, ...rows)));
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
