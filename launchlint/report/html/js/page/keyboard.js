/** The keys of the page. Tree, search and drawing have keys of their own, which they do not let through to here. */

import { part } from "./elements.js";
import { around } from "./containers.js";
import { select } from "./reference.js";

/** @typedef {import("./reference.js").Page} Page */

const STORED = "launchlint-single-keys";

/**
 * @param {Page} page
 * @param {{ search: () => void, tree: () => void, drawing: () => void, tables: () => void, help: () => void, landing: () => void, change: (step: 1 | -1) => void }} go
 */
export function createKeyboard(page, go) {
  const { store, drawing } = page;
  let single = stored();

  /** @type {ReadonlyMap<string, () => void>} */
  const keys = new Map([
    ["/", go.search],
    ["?", go.help],
    ["t", go.tree],
    ["d", go.drawing],
    ["b", go.tables],
    ["p", () => part("panel").querySelector("h2")?.focus()],
    ["n", () => nextFinding(page, 1)],
    ["N", () => nextFinding(page, -1)],
    ["]", () => go.change(1)],
    ["[", () => go.change(-1)],
    ["a", go.landing],
    ["f", () => focusOnSelected(page)],
    ["+", () => drawing.zoom(1.25)],
    ["=", () => drawing.zoom(1.25)],
    ["-", () => drawing.zoom(0.8)],
    ["0", () => drawing.fit()],
  ]);

  document.addEventListener("keydown", (event) => {
    const target = /** @type {Element} */ (event.target);
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || document.querySelector("dialog[open]")) return;
    if (target.closest("input, select, textarea")) return;
    const action = event.key === "Escape" ? back : single ? keys.get(event.key) : undefined;
    if (!action) return;
    event.preventDefault();
    action();
  });

  function back() {
    const { selection, focus, landing } = store.get();
    if (selection) store.set({ selection: null });
    else if (focus) store.set({ focus: null });
    else if (!landing) go.landing();
  }

  return {
    isOn: () => single,
    /** @param {boolean} on */
    turn(on) {
      single = on;
      try {
        localStorage.setItem(STORED, String(on));
      } catch {
        // then it holds for this page only
      }
    },
  };
}

/** @param {Page} page @param {1 | -1} step */
function nextFinding(page, step) {
  const { entry, selection, landing } = page.store.get();
  if (landing) return;
  const findings = page.model.entry(entry).entry.findings.flatMap((each) => page.model.data.findings[each] ?? []);
  const order = ["error", "warning", "info"];
  findings.sort((one, other) => order.indexOf(one.severity) - order.indexOf(other.severity));
  const at = findings.findIndex((each) => each.id === selection?.id);
  const next = findings.at(at < 0 ? (step > 0 ? 0 : -1) : (at + step) % findings.length);
  if (next) select(page, { kind: "finding", id: next.id });
}

/** @param {Page} page */
function focusOnSelected({ store, model }) {
  const { selection, grouping, entry, focus } = store.get();
  let id = selection?.kind === "container" ? selection.id : null;
  if (selection?.kind === "node") id = around(model.entry(entry).entry, grouping, Number(selection.id.slice(2))).at(-1)?.id ?? null;
  if (id) store.set({ focus: id === focus ? null : id });
}

function stored() {
  try {
    return localStorage.getItem(STORED) !== "false";
  } catch {
    return true;
  }
}
