/** The bar above the drawing: what it shows, what is left out of it, and its zoom. */

import { button, element, fill, part } from "./elements.js";
import { containerOf, fullName } from "./containers.js";
import { createShareButton } from "./share.js";
import { createSidePanels } from "./side_panels.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {{ label: string, title: string, get: (state: PageState) => boolean, change: (state: PageState, on: boolean) => Partial<PageState> }} Toggle */

/** Milliseconds without a key before the drawing follows the filter. */
const PAUSE = 200;

/** @type {(layer: keyof PageState["layers"], label: string, title: string) => Toggle} */
const layer = (name, label, title) => ({
  label,
  title,
  get: (state) => state.layers[name],
  change: (state, on) => ({ layers: { ...state.layers, [name]: on } }),
});

/** @type {(name: "topicsAsNodes" | "hubs" | "danglingOnly" | "findingsOnly" | "tray", label: string, title: string) => Toggle} */
const flag = (name, label, title) => ({ label, title, get: (state) => state[name], change: (_, on) => ({ [name]: on }) });

/** @type {readonly [string, Toggle[]][]} */
const TOGGLES = [
  [
    "Show",
    [
      layer("topics", "Topics", "Topics that nodes publish and subscribe to"),
      layer("services", "Services", "Services that nodes serve and call"),
      layer("actions", "Actions", "Actions that nodes serve and call"),
      layer("params", "Params", "Params that nodes read"),
      flag("hubs", "Hub topics", "Topics that everybody uses: /tf, /clock, /diagnostics …"),
      flag("topicsAsNodes", "Topics as boxes", "Draw each topic as a box of its own instead of as arrows"),
      flag("tray", "Unconnected", "Nodes that share nothing with another one: they stand in a tray of their own"),
    ],
  ],
  [
    "Only",
    [
      flag("danglingOnly", "Not connected", "Only what has nobody at its other end"),
      flag("findingsOnly", "With findings", "Only what a finding is about"),
    ],
  ],
];

/** @param {Page} page */
export function createViewBar(page) {
  const { store, drawing } = page;
  /** @type {Map<Toggle, HTMLElement>} */
  const buttons = new Map(TOGGLES.flatMap(([, toggles]) => toggles.map((each) => /** @type {const} */ ([each, toggleButton(page, each)]))));
  const groups = TOGGLES.map(([title, toggles]) =>
    element(
      "div",
      { class: "toggles", role: "group", "aria-label": title },
      element("span", { class: "title", "aria-hidden": "true" }, title),
      ...toggles.map((each) => buttons.get(each)),
    ),
  );
  const scope = element("div", { class: "scope" });
  const filter = createFilter(page);
  const [tree, details] = createSidePanels();
  if (tree) groups[0]?.prepend(tree);
  const zoom = element(
    "div",
    { class: "zoom", role: "group", "aria-label": "Zoom" },
    button("+", () => drawing.zoom(1.25), { "aria-label": "Zoom in", title: "Zoom in (+)" }),
    button("−", () => drawing.zoom(0.8), { "aria-label": "Zoom out", title: "Zoom out (−)" }),
    button("Fit", () => drawing.fit(), { title: "Fit the drawing into its frame (0)" }),
  );
  part("stage").prepend(element("div", { id: "view-bar" }, ...groups, filter.host, scope, element("div", { class: "view-end" }, createShareButton(page), details)));
  part("stage").append(zoom);
  store.listen((state) => {
    filter.show(state.filter);
    for (const [toggle, host] of buttons) host.setAttribute("aria-pressed", String(toggle.get(state)));
    fill(scope, ...scopeOf(page, state));
  });
}

/** A field that keeps in the drawing what is called so. @param {Page} page */
function createFilter({ store }) {
  const field = element("input", {
    id: "filter",
    type: "search",
    placeholder: "Filter: name, type:, package:",
    title: "Draws what fits all words: a part of a name, /left/*, type:Image, package:nav, and -rviz for what shall not be there",
    "aria-label": "Filter the drawing by name, type: or package:",
    autocomplete: "off",
    spellcheck: "false",
  });
  let timer = 0;
  field.addEventListener("input", () => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => store.set({ filter: field.value.trim() }, "replace"), PAUSE);
  });
  return {
    host: field,
    /** @param {string} text */
    show(text) {
      if (document.activeElement !== field && field.value.trim() !== text) field.value = text;
    },
  };
}

/** @param {Page} page @param {Toggle} toggle */
function toggleButton({ store }, { label, title, get, change }) {
  return button(label, () => store.set(change(store.get(), !get(store.get()))), { class: "toggle", title });
}

/** What of the whole is drawn, with a way back. @param {Page} page @param {PageState} state */
function scopeOf({ model, store }, state) {
  const focused = state.focus && containerOf(model.entry(state.entry).entry, state.grouping, state.focus);
  return [
    state.focus &&
      element(
        "span",
        {},
        "Focus: ",
        element("b", {}, focused ? fullName(focused) : state.focus),
        " ",
        button("Leave", () => store.set({ focus: null })),
      ),
    state.hidden.size > 0 &&
      element(
        "span",
        {},
        `${number(state.hidden.size, "thing")} hidden `,
        button("Show all", () => store.set({ hidden: new Set() })),
      ),
    state.expanded !== "auto" && button("Overview", () => store.set({ expanded: "auto" }), { title: "Expand as much as can be read at once" }),
  ];
}
