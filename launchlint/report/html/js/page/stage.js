/** Keeps the drawing in step with the state: draws, lights what is selected, brings it into view, says when there is nothing to see. */

import { around, outside } from "./containers.js";
import { element, part } from "./elements.js";
import { pairWay } from "./panel_pair.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {import("./state.js").Target} Target */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../drawing/types").Selection} Selection */


/** What of the state the drawing depends on. */
const DRAWN = /** @type {const} */ ([
  "entry",
  "configuration",
  "grouping",
  "expanded",
  "focus",
  "layers",
  "topicsAsNodes",
  "hubs",
  "danglingOnly",
  "findingsOnly",
  "tray",
  "filter",
  "hidden",
  "matches",
]);

/**
 * @param {Page} page
 * @param {object} hooks
 * @param {() => boolean} hooks.cameFromDrawing whether the last selection was made in the drawing itself
 * @param {() => () => void} hooks.holdFocus remembers what in the drawing has the focus, and gives it back
 */
export function createStage(page, { cameFromDrawing, holdFocus }) {
  const { store, drawing, model } = page;
  const told = element("p", { class: "visually-hidden", role: "status" });
  const empty = element("p", { class: "stage-empty", hidden: true });
  const note = element("p", { class: "stage-note", hidden: true });
  part("stage").append(told, empty, note);
  const host = part("drawing");
  let running = false;
  let stale = false;
  /** @type {PageState["place"]} where somebody moved the drawing, or a link put it */
  let placed = null;

  /** Draws until what is drawn is the latest state. */
  async function draw() {
    stale = true;
    if (running) return;
    running = true;
    host.setAttribute("aria-busy", "true");
    while (stale) {
      stale = false;
      const state = store.get();
      const giveBack = holdFocus();
      await drawing.show(state);
      giveBack();
      if (state.place && state.place !== placed) drawing.goTo(state.place);
      placed = state.place;
      drawing.select(drawnSelection(page, state));
      report(state);
    }
    running = false;
    host.setAttribute("aria-busy", "false");
  }

  /** @param {PageState} state */
  function report(state) {
    const shown = drawing.focusables().length;
    empty.hidden = shown > 0;
    empty.textContent = shown > 0 ? "" : whyEmpty(model.entry(state.entry), state);
    note.textContent = shown > 0 ? leftOut(drawing.extent(), state.place === null) : "";
    note.hidden = note.textContent === "";
    told.textContent = shown > 0 ? `The drawing shows ${number(shown, "thing")}.` : empty.textContent;
  }

  /** @param {PageState} state */
  async function reveal(state) {
    const target = drawnSelection(page, state);
    if (!target) return;
    const { entry } = model.entry(state.entry);
    if ((target.kind === "node" || target.kind === "container") && !drawing.isDrawn(target)) {
      const outer = target.kind === "node" ? around(entry, state.grouping, Number(target.id.slice(2))).map((group) => group.id) : outside(entry, state.grouping, target.id);
      const expanded = new Set([...drawing.expanded(), ...outer]);
      store.set({ expanded }, "replace");
      await finished();
    }
    if (!drawing.isDrawn(target)) return;
    drawing.panTo(target);
    // An address that says where the drawing stands stays true.
    if (store.get().place) store.set({ place: drawing.spot() }, "replace");
  }

  /** Resolves once nothing is being drawn. */
  let finished = () => Promise.resolve();

  store.listen((state, before) => {
    const first = state === before;
    const changed = first || DRAWN.some((key) => state[key] !== before[key]);
    const selected = (first ? state.place === null : state.selection !== before.selection) && !cameFromDrawing();
    if (changed) {
      const done = draw();
      finished = () => done;
      if (selected) void done.then(() => reveal(store.get()));
      return;
    }
    if (state.place !== before.place) {
      note.textContent = leftOut(drawing.extent(), state.place === null);
      note.hidden = note.textContent === "";
      if (state.place) drawing.goTo(state.place);
      placed = state.place;
    }
    if (state.selection === before.selection) return;
    drawing.select(drawnSelection(page, state));
    if (selected) void finished().then(() => reveal(store.get()));
  });
}

/**
 * What is to be lit: the selection, or what the selected finding is about.
 *
 * @param {Page} page
 * @param {PageState} state
 * @returns {Selection | null}
 */
function drawnSelection(page, { selection, entry, configuration }) {
  const model = page.model.entry(entry);
  if (selection?.kind === "pair") return { kind: "way", id: pairWay(model, selection.id, configuration).join("|") };
  if (selection?.kind !== "finding") return selection;
  const finding = page.model.finding(selection.id);
  const [node] = model.nodesWithFinding.get(finding) ?? [];
  if (node !== undefined) return { kind: "node", id: `n:${node}` };
  const [channel] = model.channelsWithFinding.get(finding) ?? [];
  return channel === undefined ? null : { kind: "channel", id: `c:${channel}` };
}

/** What is there and not seen at once. @param {import("../drawing/types").Extent} extent @param {boolean} untouched whether nobody moved the drawing */
function leftOut({ folded, boxes, outside }, untouched) {
  const words = [];
  if (folded > 0) words.push(`${number(folded, "node")} in ${number(boxes, "folded box", "folded boxes")}`);
  if (untouched && outside > 0) words.push(`${number(outside, "box", "boxes")} at or beyond the edge: drag, or Fit`);
  return words.join(" · ");
}

/** @param {EntryModel} model @param {PageState} state */
function whyEmpty({ entry }, state) {
  if (entry.nodes.length === 0 && !entry.complete)
    return "Which nodes this launch file starts is not known. Its params and findings are in the tables below.";
  if (entry.nodes.length === 0)
    return "This launch file starts no nodes, so there is nothing to draw. Its params and findings are in the tables below.";
  if (state.danglingOnly) return "Nothing is left unconnected here, as far as it is known.";
  if (state.findingsOnly) return "No finding is about anything that could be drawn here.";
  if (state.filter) return `Nothing here fits the filter “${state.filter}”.`;
  if (state.hidden.size > 0) return "All of it is hidden.";
  return "Nothing to draw in this view.";
}
