/** A link to exactly what is shown: what is open, what is selected, and where the drawing stands on the screen. */

import { addressOf } from "./address.js";
import { button, element } from "./elements.js";

/** @typedef {import("./reference.js").Page} Page */

/** Milliseconds for which it is said that the link is copied. */
const SAID = 2000;

/** @param {Page} page */
export function createShareButton(page) {
  const told = element("span", { class: "visually-hidden", role: "status" });
  const host = button("Copy link", copy, { class: "share", title: "Copy a link to exactly this view" });

  async function copy() {
    const done = await copied(linkTo(page));
    host.textContent = done ? "Copied" : "Not copied";
    told.textContent = done ? "The link is copied." : "The browser does not let the page copy: the address of the page is the link.";
    window.setTimeout(() => {
      host.textContent = "Copy link";
      told.textContent = "";
    }, SAID);
  }

  return element("span", { class: "share-host" }, host, told);
}

/** @param {Page} page */
export function linkTo({ model, store, drawing }) {
  const state = store.get();
  const exact = addressOf(model, { ...state, expanded: drawing.expanded(), place: drawing.spot() });
  return `${location.href.replace(/#.*$/s, "")}#${exact}`;
}

/** @param {string} text */
async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    // Not every page may: an old way is left.
    const field = element("textarea", { class: "visually-hidden", "aria-hidden": "true" });
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    return done;
  }
}
