/** The help: what keys do. What the signs of the drawing mean is told beside it. */

import { button, element } from "./elements.js";

/** @typedef {{ isOn: () => boolean, turn: (on: boolean) => void }} Shortcuts */

/** @type {readonly [keys: string, what: string][]} */
const KEYS = [
  ["/", "search"],
  ["n  N", "next, previous finding"],
  ["]  [", "next, previous change, where two revisions are compared"],
  ["a", "all launch files"],
  ["t", "tree"],
  ["d", "drawing"],
  ["p", "panel"],
  ["b", "tables"],
  ["← ↑ ↓ →", "in the drawing: the next thing in that direction; in the tree: move, open, close"],
  ["Enter", "select"],
  ["Space", "in the drawing: expand or collapse"],
  ["h", "in the tree: hide or show in the drawing"],
  ["f", "draw the selected container, or the one around the selected node, alone"],
  ["+  −  0", "zoom in, zoom out, fit"],
  ["Esc", "one step back: close, deselect, leave focus"],
  ["?", "this help"],
];

/** @param {Shortcuts} shortcuts */
export function createHelp(shortcuts) {
  const letters = element("input", { type: "checkbox", change: () => shortcuts.turn(letters.checked) });
  const rows = KEYS.map(([keys, what]) =>
    element("tr", {}, element("th", { scope: "row" }, ...keys.split("  ").map((key) => element("kbd", {}, key))), element("td", {}, what)),
  );
  const dialog = element(
    "dialog",
    { id: "help", "aria-labelledby": "help-title" },
    element("h2", { id: "help-title" }, "Keyboard"),
    element("table", {}, element("tbody", {}, ...rows)),
    element("p", {}, element("label", {}, letters, " Keys that are single letters or signs")),
    button("Close", () => dialog.close()),
  );
  document.body.append(dialog);
  return () => {
    letters.checked = shortcuts.isOn();
    dialog.showModal();
  };
}
