/** The panel of a finding: what, where, why, and what to do. */

import { containersWith, fullName } from "./containers.js";
import { element } from "./elements.js";
import { badge, block, heading, list } from "./panel_blocks.js";
import { nodeReference, channelReference, reference } from "./reference.js";
import { source, written } from "./source.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("../data").Finding} Finding */

/**
 * @param {Page} page
 * @param {string} id
 * @returns {Child[]}
 */
export function findingPanel(page, id) {
  const index = page.model.finding(id);
  const finding = page.model.data.findings[index];
  if (!finding) return [];
  return [
    ...heading(`${finding.rule} ${finding.name}`, finding.message, [badge(finding.severity, finding.severity)]),
    source(page.model, finding.place, finding),
    (finding.help || finding.fix) && block("What to do", finding.help && element("p", {}, finding.help), fix(finding)),
    finding.notes.length > 0 && list(finding.notes, "notes"),
    ...finding.related.map(([place, label]) => block(label || "See also", source(page.model, place))),
    aboutBlock(page, index),
    finding.chain.length > 0 &&
      block(
        "How the launch file gets there",
        element("ol", { class: "steps" }, ...finding.chain.map((step) => element("li", {}, written(page.model, step)))),
      ),
    finding.show && block("Shown by", element("pre", { class: "command" }, finding.show)),
    entriesBlock(page, finding, index),
    block("Why it matters", element("pre", { class: "command" }, `launchlint explain ${finding.rule}`)),
  ];
}

/** @param {Finding} finding */
function fix(finding) {
  if (!finding.fix) return null;
  const how = finding.fixSafe ? "launchlint check --fix" : "launchlint check --fix --unsafe-fixes";
  return element("p", {}, `${finding.fix} (`, element("code", {}, how), ")");
}

/** What of the shown entry file the finding is about. @param {Page} page @param {number} index */
function aboutBlock(page, index) {
  const model = page.model.entry(page.store.get().entry);
  const items = [
    ...(model.nodesWithFinding.get(index) ?? []).map((each) => nodeReference(page, each)),
    ...(model.channelsWithFinding.get(index) ?? []).map((each) => channelReference(page, each)),
    ...(model.paramsWithFinding.get(index) ?? []).map((each) =>
      reference(page, { kind: "param", id: `p:${each}` }, model.entry.params[each]?.name ?? ""),
    ),
    ...containersWith(model.entry, page.store.get().grouping, index).map((each) => reference(page, { kind: "container", id: each.id }, fullName(each))),
  ];
  return items.length > 0 && block("In the drawing", list(items));
}

/** @param {Page} page @param {Finding} finding @param {number} index */
function entriesBlock(page, finding, index) {
  const { entries, files } = page.model.data;
  const others = entries.flatMap((each, at) => (each.findings.includes(index) && at !== page.store.get().entry ? [at] : []));
  const items = others.map((at) => reference(page, { kind: "finding", id: finding.id }, files[entries[at]?.file ?? -1] ?? "", at));
  return items.length > 0 && block("Also reached from", list(items));
}
