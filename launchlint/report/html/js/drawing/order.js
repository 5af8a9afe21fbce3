// The order in which launch files name their nodes: what is added at the end of a file comes last, and moves nothing before it.

/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../data").Place} Place */

/** Levels of nesting that are looked at. */
const DEEPEST = 32;

/** @type {WeakMap<Entry, Int32Array>} */
const known = new WeakMap();

/**
 * The rank of each node, by its index: as a reader meets them who follows every include where it stands.
 * @param {Entry} entry
 * @returns {Int32Array}
 */
export function ranksOf(entry) {
  let ranks = known.get(entry);
  if (!ranks) {
    const chains = entry.nodes.map((node) => chainOf(entry, node.container, node.place));
    const order = entry.nodes.map((_, index) => index).sort((a, b) => compare(chains[a] ?? [], chains[b] ?? []) || a - b);
    ranks = new Int32Array(order.length);
    for (const [rank, node] of order.entries()) ranks[node] = rank;
    known.set(entry, ranks);
  }
  return ranks;
}

/** Where the includes and groups around a node stand, and the node itself. @param {Entry} entry @param {number} container @param {Place | null} place */
function chainOf(entry, container, place) {
  const chain = [place];
  for (let at = container; at >= 0 && chain.length < DEEPEST; at = entry.containers[at]?.parent ?? -1) chain.unshift(entry.containers[at]?.place ?? null);
  return chain.map((each) => each ?? [0, 0, 0]);
}

/** @param {number[][]} one @param {number[][]} other */
function compare(one, other) {
  for (let at = 0; at < one.length && at < other.length; at++) {
    const [a, b] = [one[at] ?? [], other[at] ?? []];
    for (let part = 0; part < 3; part++) if (a[part] !== b[part]) return (a[part] ?? 0) - (b[part] ?? 0);
  }
  return one.length - other.length;
}
