/** The panel at the side: what is selected, or an overview. */

import { button, element, fill, part } from "./elements.js";
import { channelPanel, paramPanel } from "./panel_channel.js";
import { containerPanel } from "./panel_container.js";
import { edgePanel } from "./panel_edge.js";
import { findingPanel } from "./panel_finding.js";
import { nodePanel } from "./panel_node.js";
import { pairPanel } from "./panel_pair.js";
import { overviewPanel } from "./panel_overview.js";
import { select } from "./reference.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./state.js").PageState} PageState */

/** Pixels between what is brought into view and the edge. */
const MARGIN = 24;

/** @param {Page} page */
export function createPanel(page) {
  const host = part("panel");
  page.store.listen((state, before) => {
    if (state !== before && !concerns(state, before)) return;
    const hadFocus = host.contains(document.activeElement);
    show(page, host, state);
    if (hadFocus) host.querySelector("h2")?.focus();
    if (state.selection !== before.selection) host.scrollTop = 0;
  });
}

/** @param {Page} page @param {HTMLElement} host @param {PageState} state */
function show(page, host, state) {
  const model = page.model.entry(state.entry);
  const content = state.selection ? panelOf(page, state.selection) : [];
  if (content.length === 0) {
    fill(host, ...overviewPanel(page, model));
    return;
  }
  const close = button("Close", () => select(page, null), { class: "close", "aria-label": "Close: back to the overview" });
  fill(host, element("div", { class: "panel-bar" }, close), ...content);
  for (const mark of host.querySelectorAll("mark")) bringIntoView(mark);
}

/** Scrolls long source lines so that what a finding is about is seen. @param {HTMLElement} mark */
function bringIntoView(mark) {
  const lines = mark.closest("pre");
  if (lines) lines.scrollLeft += Math.max(0, mark.getBoundingClientRect().right - lines.getBoundingClientRect().right + MARGIN);
}

/** @param {Page} page @param {import("./state.js").Target} target @returns {Child[]} */
function panelOf(page, { kind, id }) {
  const model = page.model.entry(page.store.get().entry);
  const index = Number(id.slice(2));
  if (kind === "node") return nodePanel(page, model, index);
  if (kind === "channel") return channelPanel(page, model, index);
  if (kind === "param") return paramPanel(page, model, index);
  if (kind === "container") return containerPanel(page, model, id);
  if (kind === "pair") return pairPanel(page, model, id);
  return kind === "finding" ? findingPanel(page, id) : edgePanel(page, model, id);
}

/** Whether a change of the state changes what the panel says. @param {PageState} state @param {PageState} before */
function concerns(state, before) {
  const keys = /** @type {const} */ (["selection", "entry", "configuration", "grouping", "focus", "hidden"]);
  return keys.some((key) => state[key] !== before[key]) || (state.selection?.kind === "container" && state.expanded !== before.expanded);
}
