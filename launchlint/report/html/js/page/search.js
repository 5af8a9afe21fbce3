/** The search field: names, types, programs, params, files and findings, with a list that the keyboard walks through. */

import { element, fill, part } from "./elements.js";
import { createIndex } from "./search_index.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./search_index.js").Hit} Hit */

/** Milliseconds without a key before the drawing follows. */
const PAUSE = 150;

/**
 * @param {Page} page
 * @returns {{ host: HTMLElement, focus: () => void }}
 */
export function createSearch(page) {
  const index = createIndex(page.model);
  const options = element("ul", { id: "search-results", role: "listbox", "aria-label": "Search results", hidden: true });
  const told = element("span", { class: "visually-hidden", role: "status" });
  const field = element("input", {
    id: "search",
    type: "search",
    role: "combobox",
    placeholder: "Search  /",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": "Search names, types, params, files and findings",
    "aria-controls": "search-results",
    "aria-expanded": "false",
    "aria-autocomplete": "list",
  });
  const host = element("div", { class: "search", role: "search" }, field, options, told);
  /** @type {Hit[]} */
  let hits = [];
  let active = -1;
  let timer = 0;

  /** @param {boolean} open */
  function show(open) {
    options.hidden = !open;
    field.setAttribute("aria-expanded", String(open));
    if (!open) activate(-1);
  }

  /** @param {number} next */
  function activate(next) {
    options.children[active]?.setAttribute("aria-selected", "false");
    active = hits.length === 0 || next < 0 ? -1 : next % hits.length;
    const option = options.children[active];
    if (option) {
      option.setAttribute("aria-selected", "true");
      option.scrollIntoView({ block: "nearest" });
      field.setAttribute("aria-activedescendant", option.id);
    } else field.removeAttribute("aria-activedescendant");
  }

  function update() {
    const query = field.value.trim();
    const result = index(query, page.store.get().entry);
    hits = result.hits;
    active = -1;
    const more = result.total - hits.length;
    fill(
      options,
      ...hits.map((hit, at) => optionOf(page, hit, at)),
      query &&
        hits.length === 0 &&
        element("li", { class: "empty", role: "option", "aria-disabled": "true", "aria-selected": "false" }, "Nothing on this page is called that."),
      more > 0 && element("li", { class: "empty", role: "option", "aria-disabled": "true", "aria-selected": "false" }, `${more} more: type on`),
    );
    told.textContent = query ? number(result.total, "result") : "";
    show(query !== "");
    window.clearTimeout(timer);
    timer = window.setTimeout(() => page.store.set({ matches: query ? result.ids : null }), PAUSE);
  }

  /** @param {Hit | undefined} hit */
  function choose(hit) {
    if (!hit) return;
    show(false);
    window.clearTimeout(timer);
    if (hit.byFile) page.store.set({ entry: hit.entry, grouping: "file" });
    page.store.set({ entry: hit.entry, selection: hit.target, matches: null });
    part("panel").querySelector("h2")?.focus();
  }

  function clear() {
    field.value = "";
    update();
  }

  field.addEventListener("input", update);
  field.addEventListener("focus", () => field.value && show(true));
  host.addEventListener("focusout", (event) => !host.contains(/** @type {Node | null} */ (event.relatedTarget)) && show(false));
  options.addEventListener("mousedown", (event) => event.preventDefault());
  options.addEventListener("click", (event) => {
    const option = /** @type {Element} */ (event.target).closest("li");
    if (option) choose(hits[[...options.children].indexOf(option)]);
  });
  field.addEventListener("keydown", (event) => {
    /** @type {Map<string, () => void>} */
    const keys = new Map([
      ["ArrowDown", () => (options.hidden ? update() : activate(active + 1))],
      ["ArrowUp", () => activate(active <= 0 ? hits.length - 1 : active - 1)],
      ["Enter", () => choose(hits[Math.max(active, 0)])],
      ["Escape", () => (field.value ? clear() : field.blur())],
    ]);
    const action = keys.get(event.key);
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  });
  return { host, focus: () => (field.focus(), field.select()) };
}

/** @param {Page} page @param {Hit} hit @param {number} at */
function optionOf({ model, store }, hit, at) {
  const elsewhere = hit.entry !== store.get().entry && hit.target !== null;
  return element(
    "li",
    { id: `search-result-${at}`, role: "option", "aria-selected": "false" },
    element("span", { class: "result-kind" }, hit.kind),
    element("span", { class: "result-label" }, hit.label),
    element("span", { class: "result-detail" }, elsewhere ? `in ${model.data.files[model.entry(hit.entry).entry.file]}` : hit.detail),
  );
}
