/** Links from one place on the page to another. Each has a real address, so that it can be copied and opened elsewhere. */

import { addressOf } from "./address.js";
import { element } from "./elements.js";
import { initialState } from "./state.js";

/** @typedef {import("./state.js").Target} Target */

/**
 * What the parts of the page work with.
 *
 * @typedef {object} Page
 * @property {import("./model.js").Model} model
 * @property {import("./state.js").Store} store
 * @property {import("../drawing/types").Drawing} drawing
 */

/**
 * A link that selects something and brings it into view.
 *
 * @param {Page} page
 * @param {Target} target
 * @param {string} label
 * @param {number} [entry] where it is not the entry file that is shown
 */
export function reference(page, target, label, entry = page.store.get().entry) {
  const address = addressOf(page.model, { ...initialState(), entry, grouping: page.store.get().grouping, selection: target });
  return element("a", { href: `#${address}`, click: (event) => follow(page, target, entry, event) }, label);
}

/** @param {Page} page @param {number} node */
export function nodeReference(page, node) {
  const { store, model } = page;
  return reference(page, { kind: "node", id: `n:${node}` }, model.entry(store.get().entry).entry.nodes[node]?.name ?? "");
}

/** @param {Page} page @param {number} channel */
export function channelReference(page, channel) {
  const { store, model } = page;
  return reference(page, { kind: "channel", id: `c:${channel}` }, model.entry(store.get().entry).entry.channels[channel]?.name ?? "");
}

/**
 * Selects something; in another entry file where need be.
 *
 * @param {Page} page
 * @param {Target | null} target
 * @param {number} [entry]
 */
export function select({ store }, target, entry = store.get().entry) {
  if (entry === store.get().entry) store.set({ selection: target });
  else store.set({ entry, selection: target });
}

/** @param {Page} page @param {Target} target @param {number} entry @param {MouseEvent} event */
function follow(page, target, entry, event) {
  if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
  event.preventDefault();
  select(page, target, entry);
}
