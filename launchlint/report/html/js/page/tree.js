/** The tree at the side: nodes by namespace, by launch file or by package. What is shown opens on demand, however large the system is. */

import { containersOf } from "../drawing/index.js";
import { around } from "./containers.js";
import { button, element, fill, part } from "./elements.js";
import { isIn } from "./model.js";
import { toggled } from "./panel_blocks.js";
import { select } from "./reference.js";
import { groupItem, nodeItem } from "./tree_items.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {import("./tree_items.js").Item} Item */
/** @typedef {import("../drawing/types").Group} Group */
/** @typedef {import("../drawing/types").Grouping} Grouping */

/** @type {readonly [Grouping, string][]} */
const GROUPINGS = [
  ["namespace", "Namespace"],
  ["file", "Launch file"],
  ["package", "Package"],
  ["machine", "Machine"],
];
/** Systems up to this many nodes start with the whole tree open. */
const OPEN_AT_ONCE = 60;

/** @param {Page} page */
export function createTree(page) {
  const tree = element("ul", { role: "tree", "aria-label": "Nodes" });
  const grouping = groupingChooser(page);
  fill(part("tree"), grouping.host, tree);
  /** @type {Map<string, Item>} */
  const items = new Map();

  const entryNow = () => page.model.entry(page.store.get().entry).entry;

  /** Whether the configuration that is shown has a node. @param {number} node */
  const isThere = (node) => isIn(entryNow().nodes[node] ?? { only: [] }, page.store.get().configuration);

  /** @param {Group} group @returns {number} */
  const nodesIn = (group) => group.nodes.filter(isThere).length + group.groups.reduce((sum, each) => sum + nodesIn(each), 0);

  /** @param {Group} group @param {Element} host @param {number} level */
  function grow(group, host, level) {
    const entry = entryNow();
    for (const each of group.groups) {
      const count = nodesIn(each);
      if (count > 0) add(groupItem(page.model, entry, { ...each, count }, level), host);
    }
    for (const node of group.nodes) {
      if (!isThere(node)) continue;
      const made = nodeItem(page.model, entry, node, level, group.namespace);
      if (made) add(made, host);
    }
  }

  /** @param {Item} item @param {Element} host */
  function add(item, host) {
    items.set(item.id, item);
    markHidden(item, page.store.get());
    host.append(item.host);
  }

  /** The item of a row, or of anything in it. @param {EventTarget | null} target */
  function itemAt(target) {
    const row = target instanceof Element ? target.closest(".row") : null;
    return row instanceof HTMLElement ? items.get(row.dataset["id"] ?? "") : undefined;
  }

  /** @param {Item} item */
  const isOpen = ({ row }) => row.getAttribute("aria-expanded") === "true";

  /** @param {Item} item @param {boolean} open */
  function turn(item, open) {
    if (!item.group || isOpen(item) === open) return;
    item.row.setAttribute("aria-expanded", String(open));
    let inner = item.host.querySelector(":scope > ul");
    if (!inner) {
      inner = element("ul", { role: "none" });
      item.host.append(inner);
      grow(item.group, inner, Number(item.row.getAttribute("aria-level")) + 1);
    }
    inner.toggleAttribute("hidden", !open);
  }

  /** @param {PageState} state */
  function rebuild(state) {
    items.clear();
    fill(tree);
    const root = containersOf(entryNow(), state.grouping);
    grow(root, tree, 1);
    // Items are added while this runs: a Map goes on with them.
    if (root.count <= OPEN_AT_ONCE) for (const item of items.values()) turn(item, true);
    if (root.count === 0) {
      const said = entryNow().complete ? "This launch file starts no nodes." : "Which nodes this launch file starts is not known.";
      tree.append(element("li", { role: "treeitem", class: "empty" }, said));
    }
    tree.querySelector('[role="treeitem"]')?.setAttribute("tabindex", "0");
  }

  /** @param {PageState} state */
  function markSelected(state) {
    for (const row of tree.querySelectorAll('[aria-selected="true"]')) row.setAttribute("aria-selected", "false");
    if (state.selection?.kind === "node") for (const group of around(entryNow(), state.grouping, Number(state.selection.id.slice(2)))) open(group.id);
    const item = items.get(state.selection?.id ?? "");
    if (!item) return;
    item.row.setAttribute("aria-selected", "true");
    rove(item.row);
    item.row.scrollIntoView({ block: "nearest" });
  }

  /** @param {string} id */
  function open(id) {
    const item = items.get(id);
    if (item) turn(item, true);
  }

  /** Makes a row the one that the tab key finds. @param {Element | null | undefined} row */
  function rove(row) {
    if (!(row instanceof HTMLElement)) return;
    for (const each of tree.querySelectorAll('[tabindex="0"]')) each.setAttribute("tabindex", "-1");
    row.tabIndex = 0;
  }

  /** @param {Element | null | undefined} row */
  function focus(row) {
    rove(row);
    if (row instanceof HTMLElement) row.focus();
  }

  const visible = () => [...tree.querySelectorAll(".row")].filter((row) => !row.closest("ul[hidden]"));

  /** @param {Item} item */
  function choose({ id }) {
    select(page, id.startsWith("n:") ? { kind: "node", id } : { kind: "container", id });
  }

  /** @param {Item} item */
  function hide({ id }) {
    page.store.set({ hidden: toggled(page.store.get().hidden, id) });
  }

  tree.addEventListener("click", (event) => {
    const item = itemAt(event.target);
    const target = /** @type {Element} */ (event.target);
    if (!item) return;
    rove(item.row);
    if (target.closest(".hide")) hide(item);
    else if (target.closest(".twisty")) turn(item, !isOpen(item));
    else choose(item);
  });

  tree.addEventListener("keydown", (event) => {
    const item = itemAt(event.target);
    if (!item || event.ctrlKey || event.metaKey || event.altKey) return;
    const rows = visible();
    const at = rows.indexOf(item.row);
    /** @type {Map<string, () => void>} */
    const keys = new Map([
      ["ArrowDown", () => focus(rows[at + 1])],
      ["ArrowUp", () => focus(rows[at - 1])],
      ["Home", () => focus(rows[0])],
      ["End", () => focus(rows.at(-1))],
      ["ArrowRight", () => (isOpen(item) ? focus(rows[at + 1]) : turn(item, true))],
      ["ArrowLeft", () => (isOpen(item) ? turn(item, false) : focus(item.host.parentElement?.closest("li")?.querySelector(".row")))],
      ["Enter", () => choose(item)],
      [" ", () => choose(item)],
      ["h", () => hide(item)],
    ]);
    const action = keys.get(event.key);
    if (!action) return;
    event.preventDefault();
    event.stopPropagation();
    action();
  });

  page.store.listen((state, before) => {
    const anew = /** @type {const} */ (["entry", "grouping", "configuration"]).some((key) => state === before || state[key] !== before[key]);
    if (anew) {
      grouping.show(state.grouping, entryNow().nodes.some((each) => each.machine.length > 0));
      rebuild(state);
    }
    if (state.hidden !== before.hidden) for (const item of items.values()) markHidden(item, state);
    if (anew || state.selection !== before.selection) markSelected(state);
  });

  return {
    focus: () => focus(tree.querySelector('[tabindex="0"]')),
  };
}

/** @param {Item} item @param {PageState} state */
function markHidden({ id, row, hide }, { hidden }) {
  row.classList.toggle("hidden-in-drawing", hidden.has(id));
  hide.setAttribute("aria-pressed", String(hidden.has(id)));
}

/** @param {Page} page */
function groupingChooser(page) {
  const buttons = GROUPINGS.map(([grouping, label]) => /** @type {const} */ ([grouping, button(label, () => page.store.set({ grouping }))]));
  const host = element("div", { class: "segments", role: "group", "aria-label": "Group nodes by" }, ...buttons.map(([, each]) => each));
  return {
    host,
    /** @param {Grouping} now @param {boolean} machines whether any node is on one */
    show(now, machines) {
      host.classList.toggle("two-rows", machines || now === "machine");
      for (const [grouping, each] of buttons) {
        each.setAttribute("aria-pressed", String(grouping === now));
        each.hidden = grouping === "machine" && now !== "machine" && !machines;
      }
    },
  };
}
