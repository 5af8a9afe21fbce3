/** The page that opens first where there are several launch files: a card of each, as the server wrote them. Here it only comes and goes. */

import { part } from "./elements.js";
import { initialState } from "./state.js";

/** @typedef {import("./reference.js").Page} Page */

/** @param {Page} page */
export function createLanding({ store, model }) {
  const host = document.getElementById("landing");
  const [verdict, counts] = [part("verdict"), part("counts")];
  const [words, looks, numbers] = [verdict.textContent, verdict.className, [...counts.children]];
  store.listen(
    ({ landing }, before) => {
      document.body.dataset["view"] = landing ? "landing" : "entry";
      if (!landing) return;
      verdict.textContent = words;
      verdict.className = looks;
      counts.replaceChildren(...numbers);
      part("drawing").setAttribute("aria-busy", "false");
      if (!before.landing) host?.querySelector("h2")?.focus();
    },
    { always: true },
  );
  return {
    /** Shows all launch files, where there are several. */
    show() {
      if (model.data.entries.length > 1) store.set({ ...initialState(), landing: true });
    },
  };
}
