/** Starts the page: the server-rendered tables stay, everything else grows around them. */

import { createDrawing } from "./drawing/index.js";
import { addressOf, stateOf } from "./page/address.js";
import { createControls } from "./page/controls.js";
import { createDrawingKeys } from "./page/drawing_keys.js";
import { addressBefore, editor, followEditor } from "./page/editor.js";
import { part } from "./page/elements.js";
import { createHelp } from "./page/help.js";
import { createKeyboard } from "./page/keyboard.js";
import { createLanding } from "./page/landing.js";
import { createModel } from "./page/model.js";
import { createPanel } from "./page/panel.js";
import { preparePrint } from "./page/print.js";
import { createSheets } from "./page/sheets.js";
import { createStage } from "./page/stage.js";
import { createSteps } from "./page/steps.js";
import { createStore } from "./page/state.js";
import { createTables } from "./page/tables.js";
import { createTree } from "./page/tree.js";
import { createVerdict } from "./page/verdict.js";
import { createViewBar } from "./page/view_bar.js";
import { read } from "./unpack.js";

/** @typedef {import("./drawing/types").Selection} Selection */

function start() {
  const data = read(part("launchlint-data").textContent ?? "");
  if (data.entries.length === 0) return; // what the server wrote says why
  const model = createModel(data);
  const host = editor();
  const store = createStore(stateOf(model, location.hash || addressBefore(host)), { write: (state) => addressOf(model, state), read: (hash) => stateOf(model, hash) });
  document.documentElement.classList.add("interactive");

  let fromDrawing = false;
  /** @param {Selection | null} selection */
  const selectFromDrawing = (selection) => {
    fromDrawing = true;
    store.set({ selection });
    fromDrawing = false;
  };
  const canvas = part("drawing");
  canvas.replaceChildren();
  const drawing = createDrawing(data, canvas, {
    select: selectFromDrawing,
    expand(container, open) {
      const expanded = drawing.expanded();
      if (open) expanded.add(container);
      else expanded.delete(container);
      store.set({ expanded });
    },
    moved: (place) => store.set({ place }, "replace"),
    busy: (on) => canvas.classList.toggle("busy", on),
  });
  const page = { model, store, drawing };

  const landing = createLanding(page);
  createVerdict(page);
  const search = createControls(page, { help: () => help() });
  const tree = createTree(page);
  createViewBar(page);
  createPanel(page);
  const tables = createTables(page);
  createSheets(page, tables.open);
  const drawingKeys = createDrawingKeys(page);
  const shortcuts = createKeyboard(page, {
    search: search.focus,
    tree: () => tree.focus(),
    drawing: drawingKeys.focus,
    tables: tables.toggle,
    help: () => help(),
    landing: landing.show,
    change: createSteps(page),
  });
  const help = createHelp(shortcuts);
  preparePrint();
  followEditor(page, host);
  createStage(page, { cameFromDrawing: () => fromDrawing, holdFocus: drawingKeys.hold });
}

start();
