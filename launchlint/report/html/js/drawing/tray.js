// Nodes that are connected with no other one stand in a tray of their own: between the others they would hide what is connected.

import { hasLate, withoutLate } from "./late.js";

/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").Grouping} Grouping */

/** Fewer of them stand where they belong. */
const FEWEST = 3;

/** @type {WeakMap<Entry, number[]>} */
const known = new WeakMap();

/** The id of the tray of a grouping. @param {Grouping} grouping */
export const trayId = (grouping) => `g:${grouping}:~tray`;

/**
 * The nodes that stand in the tray. Who is there does not depend on what of the drawing is switched on, so that no switch moves a node there:
 * it is who shares no topic, service or action with another node, what everybody uses and machinery aside, in any configuration.
 * @param {Entry} entry
 * @returns {number[]} indexes; empty where they are few, or where there is nobody else
 */
export function inTray(entry) {
  let found = known.get(entry);
  if (!found && hasLate(entry)) {
    // Whether there is a tray is not decided anew for one node more.
    const before = inTray(withoutLate(entry));
    const now = before.length ? unconnected(entry) : [];
    found = now.filter((node) => entry.nodes[node]?.late || before.includes(node));
    known.set(entry, found);
  }
  if (!found) {
    found = unconnected(entry);
    if (found.length < FEWEST || found.length === entry.nodes.filter((node) => !node.absent).length) found = [];
    known.set(entry, found);
  }
  return found;
}

/** Who shares nothing with another node. @param {Entry} entry */
function unconnected(entry) {
  const sides = entry.channels.map(() => ({ offers: new Set(), uses: new Set() }));
  for (const { channel, offers, node } of entry.connections) sides[channel]?.[offers ? "offers" : "uses"].add(node);
  const connected = new Set();
  sides.forEach(({ offers, uses }, at) => {
    const { hub = true, plumbing = true } = entry.channels[at] ?? {};
    if (hub || plumbing || !offers.size || !uses.size || (offers.size === 1 && uses.size === 1 && offers.has([...uses][0]))) return;
    for (const each of [...offers, ...uses]) connected.add(each);
  });
  return entry.nodes.flatMap((node, index) => (connected.has(index) || node.mark || node.absent ? [] : [index]));
}

/**
 * The containers of an entry without those nodes, and with the tray that they stand in.
 * @param {Group} root
 * @param {Grouping} grouping
 * @param {readonly number[]} nodes
 * @returns {Group}
 */
export function withTray(root, grouping, nodes) {
  const gone = new Set(nodes);
  /** @param {Group} group @returns {Group} */
  const without = (group) => ({ ...group, groups: group.groups.map(without), nodes: group.nodes.filter((each) => !gone.has(each)) });
  const own = without(root);
  own.groups.push(trayOf(grouping, nodes, root.id));
  return own;
}

/**
 * @param {Grouping} grouping
 * @param {readonly number[]} nodes
 * @param {string} parent
 * @returns {Group}
 */
export function trayOf(grouping, nodes, parent = "") {
  const label = `${nodes.length} nodes without a connection`;
  const title = `${label}: they share no topic, service or action with another node of this launch file, as far as is known`;
  return { id: trayId(grouping), kind: "tray", label, title, namespace: "", container: -1, own: [], groups: [], nodes: [...nodes], count: nodes.length, parent };
}
