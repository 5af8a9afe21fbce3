/** What can be searched for on the page, and how well it fits. */

import { lastPart } from "./wording.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("./state.js").Target} Target */

/**
 * @typedef {object} Hit
 * @property {string} kind as shown
 * @property {string} label
 * @property {string} detail
 * @property {Target | null} target null: the entry file itself
 * @property {number} entry
 * @property {boolean} byFile whether the target is one of the grouping by launch file
 * @property {string} key what is compared, in lower case
 * @property {string} tail last part of the label, in lower case
 */

/** @typedef {{ hits: Hit[], total: number, ids: Set<string> }} Result */

const MOST = 50;

/** @param {Model} model */
export function createIndex(model) {
  /** @type {Map<number, Hit[]>} */
  const known = new Map();

  /** @param {number} entry */
  function all(entry) {
    let found = known.get(entry);
    if (!found) {
      found = hitsOf(model, entry);
      known.set(entry, found);
    }
    return found;
  }

  /**
   * What fits all words of a query, the best first: of the entry file that is shown, then of the others.
   *
   * @param {string} query
   * @param {number} entry
   * @returns {Result}
   */
  return function search(query, entry) {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length === 0) return { hits: [], total: 0, ids: new Set() };
    const here = fitting(all(entry), words);
    const ids = new Set(here.flatMap((each) => each.target?.id ?? []));
    const others = here.length >= MOST ? [] : model.data.entries.flatMap((_, at) => (at === entry ? [] : fitting(all(at), words)));
    const elsewhere = others.filter((each) => !here.some((known) => known.kind === each.kind && known.label === each.label));
    const hits = [...here, ...elsewhere];
    return { hits: hits.slice(0, MOST), total: hits.length, ids };
  };
}

/** @param {Hit[]} hits @param {string[]} words */
function fitting(hits, words) {
  const scored = hits.flatMap((hit) => (words.every((word) => hit.key.includes(word)) ? [{ hit, score: score(hit, words) }] : []));
  scored.sort((one, other) => one.score - other.score);
  return scored.map((each) => each.hit);
}

/** Small is good. @param {Hit} hit @param {string[]} words */
function score({ label, tail }, words) {
  const [word = ""] = words;
  const name = label.toLowerCase();
  if (name === word || tail === word) return 0;
  if (tail.startsWith(word) || name.startsWith(word)) return 1;
  if (tail.includes(word)) return 2;
  return name.includes(word) ? 3 : 4;
}

/** @param {Model} model @param {number} index @returns {Hit[]} */
function hitsOf(model, index) {
  const { data } = model;
  const { entry } = model.entry(index);
  const file = data.files[entry.file] ?? "";
  /** @type {Hit[]} */
  const hits = [];
  /** @type {(kind: string, label: string, detail: string, target: Target | null, byFile?: boolean) => void} */
  const add = (kind, label, detail, target, byFile = false) => {
    hits.push({
      kind,
      label,
      detail,
      target,
      entry: index,
      byFile,
      key: `${label} ${detail} ${kind}`.toLowerCase(),
      tail: lastPart(label).toLowerCase(),
    });
  };
  for (const [at, each] of entry.nodes.entries()) add("node", each.name, each.program, { kind: "node", id: `n:${at}` });
  for (const [at, each] of entry.channels.entries()) {
    if (!each.plumbing) add(each.kind, each.name, each.types.join(", "), { kind: "channel", id: `c:${at}` });
  }
  for (const [at, each] of entry.params.entries()) add("param", each.name, each.value, { kind: "param", id: `p:${at}` });
  for (const at of entry.findings) {
    const finding = data.findings[at];
    if (finding)
      add("finding", finding.message, `${finding.rule} ${finding.name} ${model.place(finding.place)}`, { kind: "finding", id: finding.id });
  }
  add("file", file, "entry file", null);
  const seen = new Set();
  for (const [at, each] of entry.containers.entries()) {
    if (each.kind !== "include" || seen.has(each.label)) continue;
    seen.add(each.label);
    add("file", each.label, `included by ${file}`, { kind: "container", id: `g:file:${at}` }, true);
  }
  return hits;
}
