/** What changed since the revision that the page compares with. */

import { element } from "./elements.js";
import { badge, block, list } from "./panel_blocks.js";
import { channelReference, nodeReference } from "./reference.js";
import { does } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("./state.js").Target} Target */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("../data").Mark} Mark */

/** @type {readonly [Mark, string][]} */
const MARKS = [
  ["removed", "Lost"],
  ["added", "Gained"],
  ["changed", "Changed"],
];

/**
 * Lists of what is lost, gained and changed; nothing where the page compares with nothing.
 *
 * @param {Page} page
 * @param {EntryModel} model
 */
export function changesBlocks(page, model) {
  const { base } = page.model.data;
  if (base === null) return [];
  if (model.entry.mark === "added") return [block(`Since ${base}`, element("p", {}, "This launch file is new."))];
  if (model.entry.mark === "removed") return [block(`Since ${base}`, element("p", {}, "This launch file is gone. What it started is shown."))];
  const blocks = MARKS.flatMap(([mark, title]) => {
    const items = [...nodesWith(page, model, mark), ...linksWith(page, model, mark), ...connectionsWith(page, model, mark)];
    return items.length > 0 ? [block(`${title} since ${base}`, list(items, "changes"))] : [];
  });
  return blocks.length > 0 ? blocks : [block(`Since ${base}`, element("p", {}, "Nothing changed in what this launch file starts and connects."))];
}

/**
 * A function that lists, for an entry file, what to look at so that every change was seen: each thing once, what is lost first.
 *
 * @param {Model} model
 */
export function createSequence(model) {
  /** @type {Map<number, Target[]>} */
  const known = new Map();
  return (/** @type {number} */ index) => {
    let found = known.get(index);
    if (!found) known.set(index, (found = targetsOf(model, index)));
    return found;
  };
}

/** @param {Model} model @param {number} index @returns {Target[]} */
function targetsOf(model, index) {
  const one = model.entry(index);
  const { nodes, channels, params, findings } = one.entry;
  const marked = MARKS.flatMap(([mark]) => [
    ...channels.flatMap(({ hub, plumbing }, at) => (!hub && !plumbing && endsAt(one, at).some((each) => each.mark === mark) ? [`c:${at}`] : [])),
    ...nodes.flatMap((each, at) => (each.mark === mark ? [`n:${at}`] : [])),
    ...params.flatMap((each, at) => (each.mark === mark ? [`p:${at}`] : [])),
  ]);
  const fresh = findings.flatMap((each) => (model.data.findings[each]?.since ? [model.data.findings[each]?.id ?? ""] : []));
  return [
    ...fresh.map((id) => /** @type {Target} */ ({ kind: "finding", id })),
    ...[...new Set(marked)].map((id) => /** @type {Target} */ ({ kind: KIND_OF[id.charAt(0)], id })),
  ];
}

/** @type {Record<string, string>} */
const KIND_OF = { c: "channel", n: "node", p: "param" };

/** @param {Page} page @param {EntryModel} model @param {Mark} mark */
function nodesWith(page, model, mark) {
  return model.entry.nodes.flatMap((each, index) => (each.mark === mark ? [line(mark, "node ", nodeReference(page, index))] : []));
}

/** Who talks to whom no more, or anew. @param {Page} page @param {EntryModel} model @param {Mark} mark */
function linksWith(page, model, mark) {
  return model.entry.channels.flatMap(({ kind, hub, plumbing }, channel) => {
    if (hub || plumbing) return [];
    const there = endsAt(model, channel).filter((each) => each.mark !== opposite(mark));
    // Data goes from publishers to subscribers, and from clients to servers.
    const [givers, takers] = [true, false].map((gives) => there.filter(({ end }) => ((kind === "topic") === end.offers) === gives));
    const pairs = (givers ?? []).flatMap((from) => (takers ?? []).map((to) => /** @type {const} */ ([from, to])));
    return pairs
      .filter(([from, to]) => from.mark === mark || to.mark === mark)
      .map(([from, to]) =>
        line(mark, nodeReference(page, from.end.node), " → ", nodeReference(page, to.end.node), " on ", channelReference(page, channel)),
      );
  });
}

/** Connections that changed and have nobody at the other end. @param {Page} page @param {EntryModel} model @param {Mark} mark */
function connectionsWith(page, model, mark) {
  return model.entry.channels.flatMap(({ plumbing }, channel) => {
    const ends = plumbing ? [] : endsAt(model, channel).filter((each) => each.mark !== opposite(mark));
    const alone = ends.filter((each) => each.mark === mark && !ends.some((other) => other.end.offers !== each.end.offers));
    return alone.map(({ end }) => line(mark, nodeReference(page, end.node), ` ${does(end.role)} `, channelReference(page, channel)));
  });
}

/**
 * The connections of a channel with what became of each there: one that moved here from another name is new here.
 *
 * @param {EntryModel} model
 * @param {number} channel
 * @returns {{ end: Connection, mark: Mark | undefined }[]}
 */
export function endsAt(model, channel) {
  return (model.onChannel[channel] ?? []).map((end) => {
    const moved = (/** @type {Connection} */ each) =>
      each.mark === "removed" && each.role === end.role && each.declared === end.declared && each.channel !== channel;
    return { end, mark: end.mark === "changed" && model.ofNode[end.node]?.some(moved) ? "added" : end.mark };
  });
}

/** @param {Mark} mark @param {...(string | Element)} words */
function line(mark, ...words) {
  return element("div", {}, badge(mark, mark), " ", ...words);
}

/** The state before has none of what was added; that after it, and what changed, none of what was removed. @param {Mark} mark @returns {Mark} */
const opposite = (mark) => (mark === "removed" ? "added" : "removed");
