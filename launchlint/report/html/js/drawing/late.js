// What came after a page was first made: see launchlint/report/html/late.py. What was there before does not move for it.

/** @typedef {import("../data").Entry} Entry */

/** Whether something came late. @param {Entry} entry */
export function hasLate(entry) {
  return entry.nodes.some((node) => node.late && !node.absent) || entry.connections.some((each) => each.late);
}

/** In which turn a box came. @param {Entry} entry @param {string} box */
export function turnOf(entry, box) {
  return (box.startsWith("n:") && entry.nodes[Number(box.slice(2))]?.late) || 0;
}

/** @type {WeakMap<Entry, Entry>} */
const former = new WeakMap();

/** An entry without what came late: nodes keep their numbers. @param {Entry} entry @returns {Entry} */
export function withoutLate(entry) {
  let before = former.get(entry);
  if (!before) {
    const nodes = entry.nodes.map((node) => (node.late ? { ...node, absent: /** @type {const} */ (true) } : node));
    before = { ...entry, nodes, connections: entry.connections.filter((each) => !each.late && !entry.nodes[each.node]?.late) };
    former.set(entry, before);
  }
  return before;
}
