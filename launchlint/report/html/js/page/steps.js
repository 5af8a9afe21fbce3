/** From one change to the next, over all launch files that changed: what a reviewer does. */

import { createSequence } from "./changes.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").Target} Target */

/**
 * A function that selects the next change (1), or the one before (-1).
 *
 * @param {Page} page
 */
export function createSteps(page) {
  const { store, model } = page;
  const changed = model.data.entries.flatMap(({ changes, mark }, index) => (changes.length > 0 || mark ? [index] : []));
  const sequence = createSequence(model);

  return (/** @type {1 | -1} */ step) => {
    const { entry, selection, landing } = store.get();
    if (changed.length === 0) return;
    const here = landing ? -1 : changed.indexOf(entry);
    const targets = here < 0 ? [] : sequence(entry);
    const at = targets.findIndex((each) => each.kind === selection?.kind && each.id === selection.id);
    const inside = targets[at < 0 ? (step > 0 ? 0 : -1) : at + step];
    if (inside && (at >= 0 || step > 0)) {
      store.set({ selection: inside });
      return;
    }
    for (let turn = 1; turn <= changed.length; turn += 1) {
      const from = here < 0 && step < 0 ? 0 : here;
      const next = changed[(from + step * turn + changed.length * 2) % changed.length];
      const others = next === undefined ? [] : sequence(next);
      const target = others.at(step > 0 ? 0 : -1);
      if (next === undefined) return;
      store.set({ ...(next === entry && !landing ? {} : { entry: next }), selection: target ?? null });
      return;
    }
  };
}
