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
/** What is only like a name comes after all in which it is. */
const FAR = 10;
const SHORT_WORD = 3;
const LONG_WORD = 5;
const LONGEST_WORD = 40;

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
  const scored = hits.flatMap((hit) => {
    const exact = words.every((word) => hit.key.includes(word));
    const near = exact ? 0 : roughly(hit, words);
    return exact || near < Infinity ? [{ hit, score: exact ? score(hit, words) : near }] : [];
  });
  scored.sort((one, other) => one.score - other.score);
  return scored.map((each) => each.hit);
}

/**
 * How far a name is from what was typed, where it is not in it: letters left out ("frcam" for front_camera), or one typed wrong in a word of
 * five or more ("cemera"). Infinity: too far.
 *
 * @param {Hit} hit
 * @param {string[]} words
 */
function roughly({ label }, words) {
  const name = label.toLowerCase();
  let sum = FAR;
  for (const word of words) {
    if (name.includes(word)) continue;
    const gaps = gapsIn(name, word);
    if (gaps <= word.length) sum += 1 + gaps / 10;
    else if (word.length >= LONG_WORD && word.length <= LONGEST_WORD && hasTypo(name, word)) sum += 2;
    else return Infinity;
  }
  return sum;
}

/** Letters between the first and the last of a word that are in a name in its order, the tightest from the end; Infinity: they are not. @param {string} name @param {string} word */
function gapsIn(name, word) {
  if (word.length < SHORT_WORD) return Infinity;
  let at = name.length;
  let last = -1;
  for (const letter of [...word].reverse()) {
    at = at <= 0 ? -1 : name.lastIndexOf(letter, at - 1);
    if (at < 0) return Infinity;
    if (last < 0) last = at;
  }
  return last - at + 1 - word.length;
}

/** Whether a word with one letter wrong, more, missing, or two changed in place is in a name. @param {string} name @param {string} word */
function hasTypo(name, word) {
  for (let at = 0; at < word.length; at++) {
    const [before, after] = [word.slice(0, at), word.slice(at + 1)];
    if (name.includes(before + after)) return true;
    if (at + 1 < word.length && name.includes(before + (word[at + 1] ?? "") + (word[at] ?? "") + word.slice(at + 2))) return true;
    // An empty text is found everywhere, also behind the end.
    for (let start = name.indexOf(before); start >= 0 && start < name.length; start = name.indexOf(before, start + 1)) {
      if (name.startsWith(after, start + at + 1) || name.startsWith(word.slice(at), start + at + 1)) return true;
    }
  }
  return false;
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
