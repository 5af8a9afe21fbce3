/** What goes in and out of a container: the names that pass its border, and those of its ends that nobody shares, by role. */

import { isIn } from "./model.js";

/** @typedef {import("./model.js").EntryModel} EntryModel */

/** @typedef {{ incoming: number[], outgoing: number[], looseIn: number[], looseOut: number[] }} Interface channels, in order */

/**
 * The interface of some nodes; what everybody uses and the machinery of nodes left out. Data goes from publishers to subscribers, and from
 * clients to servers.
 *
 * @param {EntryModel} model
 * @param {ReadonlySet<number>} inside nodes
 * @param {number} configuration
 * @returns {Interface}
 */
export function interfaceOf(model, inside, configuration) {
  /** @type {Interface} */
  const found = { incoming: [], outgoing: [], looseIn: [], looseOut: [] };
  const touched = new Set([...inside].flatMap((node) => (model.ofNode[node] ?? []).map((each) => each.channel)));
  for (const channel of [...touched].sort((one, other) => one - other)) {
    const { kind, hub, plumbing } = model.entry.channels[channel] ?? { kind: "topic", hub: true, plumbing: true };
    if (hub || plumbing) continue;
    const ends = (model.onChannel[channel] ?? []).filter((each) => isIn(each, configuration) && each.mark !== "removed");
    const has = (/** @type {boolean} */ gives, /** @type {boolean} */ within) =>
      ends.some((each) => ((kind === "topic") === each.offers) === gives && inside.has(each.node) === within);
    if (has(true, true) && has(false, false)) found.outgoing.push(channel);
    if (has(false, true) && has(true, false)) found.incoming.push(channel);
    const loose = (/** @type {boolean} */ gives) => has(gives, true) && !has(!gives, true) && !has(!gives, false);
    if (loose(true)) found.looseOut.push(channel);
    if (loose(false)) found.looseIn.push(channel);
  }
  return found;
}
