/** On a narrow screen only one of tree, drawing and panel fits: buttons at the bottom choose which. */

import { button, element } from "./elements.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {"stage" | "tree" | "panel" | "tables"} Sheet */

/** @type {readonly [Sheet, string][]} */
const SHEETS = [
  ["stage", "Drawing"],
  ["tree", "Tree"],
  ["panel", "Details"],
  ["tables", "Tables"],
];

/**
 * @param {Page} page
 * @param {() => void} openTable shows a table where none is shown
 */
export function createSheets(page, openTable) {
  const buttons = SHEETS.map(([sheet, label]) => /** @type {const} */ ([sheet, button(label, () => show(sheet))]));
  document.body.append(element("nav", { id: "sheets", "aria-label": "Parts of the page" }, ...buttons.map(([, each]) => each)));

  /** @param {Sheet} now */
  function show(now) {
    document.body.dataset["sheet"] = now;
    if (now === "tables") openTable();
    for (const [sheet, each] of buttons) each.setAttribute("aria-pressed", String(sheet === now));
  }

  show("stage");
  page.store.listen((state, before) => {
    if (state.selection && state.selection !== before.selection && document.body.dataset["sheet"] !== "stage") show("panel");
  });
}
