/** One table of the drawer: its rows are made when it is looked at, its heads sort, and each row knows what it is about. */

import { element, fill } from "./elements.js";
import { reference } from "./reference.js";
import { written } from "./source.js";
import { entryTitle } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./rows.js").Kind} Kind */
/** @typedef {import("./rows.js").Row} Row */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {ReturnType<typeof createTable>} Table */

/** Rows that one table shows at once. */
const MOST_ROWS = 12_000;
const SEVERITIES = ["error", "warning", "info"];
const collator = new Intl.Collator("en", { numeric: true });

/** @param {Page} page @param {Kind} kind */
export function createTable(page, kind) {
  let sorted = -1;
  let down = false;
  let again = () => {};
  const heads = kind.columns.map((column, at) => element("th", { scope: "col" }, element("button", { type: "button", click: () => sort(at) }, column)));
  const table = element("table", { id: `table-${kind.id}` }, element("thead", {}, element("tr", {}, ...heads)));
  const note = element("p", { class: "note", hidden: true });
  const empty = element("p", { class: "empty", hidden: true }, kind.empty);
  const wide = element("div", { class: "wide", tabindex: 0, role: "region", "aria-label": kind.caption }, table);
  const host = element("section", { class: "table", id: `drawer-table-${kind.id}` }, element("h2", {}, kind.caption), wide, note, empty);
  /** @type {Map<Element, Row>} */
  const rows = new Map();

  table.addEventListener("click", (event) => {
    const target = /** @type {Element} */ (event.target);
    const row = rows.get(target.closest("tr") ?? table);
    if (!row || target.closest("a, button, summary")) return;
    page.store.set({ ...(row.entry === page.store.get().entry ? {} : { entry: row.entry }), landing: false, selection: row.target });
  });

  /** @param {number} column */
  function sort(column) {
    down = column === sorted && !down;
    sorted = column;
    heads.forEach((head, at) => {
      if (at === column) head.setAttribute("aria-sort", down ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    again();
  }

  /** @param {Row[]} found */
  function inOrder(found) {
    if (sorted < 0) return found;
    return [...found].sort((one, other) => compare(one.cells[sorted] ?? "", other.cells[sorted] ?? "") * (down ? -1 : 1));
  }

  /** @param {Row} row */
  function made(row) {
    const cells = row.cells.map((text, column) => {
      if (column === kind.named) return element("td", {}, reference(page, row.target, text, row.entry), more(row));
      if (column === kind.placed && row.place) return element("td", {}, written(page.model, row.place));
      return element("td", {}, text);
    });
    const host = element("tr", { "data-index": row.index, class: row.classes || null }, ...cells);
    rows.set(host, row);
    return host;
  }

  /** The further places of findings of the same words. @param {Row} row */
  function more(row) {
    if (row.others.length === 0) return null;
    const items = row.others.map((each) => {
      const finding = page.model.data.findings[page.model.finding(each.id)];
      return element("li", {}, reference(page, each, finding ? page.model.place(finding.place) : "", row.entry));
    });
    return element("details", { class: "others" }, element("summary", {}, `${row.others.length} more places`), element("ul", {}, ...items));
  }

  return {
    host,
    /** How many rows belong to the view; of all launch files with `everything`. @param {PageState} state @param {boolean} everything */
    count(state, everything) {
      if (everything && kind.id === "findings") return page.model.data.findings.length;
      return entriesOf(page, state, everything).reduce((sum, at) => sum + kind.count(page.model.entry(at), everything ? -1 : state.configuration), 0);
    },
    /**
     * Makes the rows that belong to the view.
     *
     * @param {PageState} state
     * @param {string} filter
     * @param {boolean} everything rows of all launch files
     */
    show(state, filter, everything) {
      again = () => this.show(page.store.get(), filter, everything);
      rows.clear();
      const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
      const fits = (/** @type {Row} */ { cells }) => words.every((word) => cells.some((text) => text.toLowerCase().includes(word)));
      /** @type {HTMLElement[]} */
      const bodies = [];
      let [shown, left] = [0, 0];
      const seen = new Set();
      for (const at of entriesOf(page, state, everything)) {
        const all = kind.rows(page.model.entry(at), everything ? -1 : state.configuration, page.model).filter(fits);
        // A finding of several launch files stands below the first of them.
        const found = inOrder(kind.id === "findings" ? all.filter(({ target }) => !seen.has(target.id) && seen.add(target.id)) : all);
        if (found.length === 0) continue;
        if (shown > 0 && shown + found.length > MOST_ROWS) {
          left += found.length;
          continue;
        }
        shown += found.length;
        const title = everything && element("tr", { class: "entry" }, element("th", { colspan: kind.columns.length, scope: "rowgroup" }, entryTitle(page.model.data, at)));
        bodies.push(element("tbody", { "data-entry": at }, title, ...found.map(made)));
      }
      fill(table, table.tHead, ...bodies);
      wide.hidden = shown === 0;
      empty.hidden = shown > 0;
      note.hidden = left === 0;
      note.textContent = `${left.toLocaleString("en")} more rows are left out: filter the rows, or open a launch file.`;
      this.mark(state);
    },
    /** Marks the row of what is selected. @param {PageState} state */
    mark({ selection, entry }) {
      for (const [host, row] of rows) {
        const ids = [row.target, ...row.others];
        const is = selection !== null && row.entry === entry && ids.some((each) => each.kind === selection.kind && each.id === selection.id);
        if (is && !host.hasAttribute("aria-current")) host.scrollIntoView({ block: "nearest" });
        if (is) host.setAttribute("aria-current", "true");
        else host.removeAttribute("aria-current");
      }
    },
  };
}

/** The launch files whose rows are shown. @param {Page} page @param {PageState} state @param {boolean} everything */
function entriesOf({ model }, { entry }, everything) {
  return everything ? model.data.entries.map((_, at) => at) : [entry];
}

/** @param {string} one @param {string} other */
function compare(one, other) {
  const [left, right] = [one, other].map((each) => SEVERITIES.findIndex((word) => each.endsWith(word) && each.length < word.length + 8));
  return left !== undefined && right !== undefined && left >= 0 && right >= 0 ? left - right : collator.compare(one, other);
}
