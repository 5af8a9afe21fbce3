/** One table of the page: its heads sort, its rows are those of the launch file and configuration that is shown, and know what they are about. */

import { element, fill } from "./elements.js";
import { isIn } from "./model.js";
import { reference } from "./reference.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {import("./state.js").Target} Target */
/** @typedef {ReturnType<typeof enhance>} Table */

const KINDS = new Map([
  ["table-nodes", "node"],
  ["table-topics", "channel"],
  ["table-services", "channel"],
  ["table-actions", "channel"],
  ["table-params", "param"],
  ["table-findings", "finding"],
]);
const SEVERITIES = ["error", "warning", "info"];
const collator = new Intl.Collator("en", { numeric: true });

/** @param {Page} page @param {HTMLTableElement} table */
export function enhance(page, table) {
  const kind = KINDS.get(table.id) ?? "";
  const named = kind === "finding" ? 2 : 0;
  let linked = false;
  let sorted = -1;
  let down = false;

  const heads = [...(table.tHead?.rows[0]?.cells ?? [])];
  heads.forEach((head, column) => {
    fill(head, element("button", { type: "button", click: () => sort(column) }, head.textContent ?? ""));
  });

  /** @param {number} column */
  function sort(column) {
    down = column === sorted && !down;
    sorted = column;
    heads.forEach((head, at) => {
      if (at === column) head.setAttribute("aria-sort", down ? "descending" : "ascending");
      else head.removeAttribute("aria-sort");
    });
    for (const body of table.tBodies) {
      const rows = [...body.rows].filter((row) => row.dataset["index"] !== undefined);
      const texts = new Map(rows.map((row) => [row, row.cells[column]?.textContent?.trim() ?? ""]));
      rows.sort((one, other) => compare(texts.get(one) ?? "", texts.get(other) ?? "") * (down ? -1 : 1));
      body.append(...rows);
    }
  }

  /** @param {HTMLTableRowElement} row @returns {{ target: Target, entry: number } | null} */
  function targetOf(row) {
    const index = Number(row.dataset["index"] ?? NaN);
    const entry = Number(row.closest("tbody")?.dataset["entry"] ?? page.store.get().entry);
    if (Number.isNaN(index)) return null;
    if (kind === "finding") {
      const finding = page.model.data.findings[index];
      const reached = page.model.data.entries[entry]?.findings.includes(index);
      const first = page.model.data.entries.findIndex((each) => each.findings.includes(index));
      return finding ? { target: { kind: "finding", id: finding.id }, entry: reached || first < 0 ? entry : first } : null;
    }
    const selected = /** @type {"node" | "channel" | "param"} */ (kind);
    return { target: { kind: selected, id: `${kind.charAt(0)}:${index}` }, entry };
  }

  /** Makes the name in each row a link: when the table is first looked at, since there may be thousands. */
  function link() {
    linked = true;
    for (const row of table.tBodies) {
      for (const each of row.rows) {
        const found = targetOf(each);
        const cell = each.cells[named];
        if (found && cell) fill(cell, reference(page, found.target, cell.textContent ?? "", found.entry));
      }
    }
  }

  /**
   * What belongs to the view: bodies of launch files, and rows.
   *
   * @param {PageState} state
   * @param {boolean} everything of all launch files
   */
  function belonging(state, everything) {
    const { entry } = page.model.entry(state.entry);
    const findings = new Set(entry.findings);
    const isIt = (/** @type {number} */ index) =>
      kind === "finding" ? findings.has(index) : inConfiguration(entry, kind, index, state.configuration);
    return {
      body: (/** @type {HTMLElement} */ { dataset }) => everything || dataset["entry"] === undefined || Number(dataset["entry"]) === state.entry,
      row: (/** @type {HTMLElement} */ { dataset }) => everything || (dataset["index"] !== undefined && isIt(Number(dataset["index"]))),
    };
  }

  return {
    targetOf,
    /** How many rows belong to the view. @param {PageState} state @param {boolean} everything */
    count(state, everything) {
      const belongs = belonging(state, everything);
      const rows = [...table.tBodies].filter(belongs.body).flatMap((body) => [...body.rows]);
      return rows.filter((row) => row.dataset["index"] !== undefined && belongs.row(row)).length;
    },
    /**
     * Shows the rows that belong to the view.
     *
     * @param {PageState} state
     * @param {string} filter
     * @param {boolean} everything rows of all launch files
     */
    show(state, filter, everything) {
      if (!linked) link();
      const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
      const belongs = belonging(state, everything);
      for (const body of table.tBodies) {
        body.hidden = !belongs.body(body);
        if (body.hidden) continue;
        for (const row of body.rows) {
          const isTitle = row.dataset["index"] === undefined;
          const text = words.length === 0 || isTitle ? "" : (row.textContent ?? "").toLowerCase();
          row.hidden = !belongs.row(row) || !(isTitle || words.every((word) => text.includes(word)));
          mark(row, state);
        }
      }
    },
  };

  /** @param {HTMLTableRowElement} row @param {PageState} state */
  function mark(row, { selection }) {
    const found = selection && targetOf(row);
    const selected = found && found.entry === page.store.get().entry && found.target.kind === selection.kind && found.target.id === selection.id;
    if (selected && !row.hasAttribute("aria-current")) row.scrollIntoView({ block: "nearest" });
    if (selected) row.setAttribute("aria-current", "true");
    else row.removeAttribute("aria-current");
  }
}

/** @param {import("../data").Entry} entry @param {string} kind @param {number} index @param {number} configuration */
function inConfiguration(entry, kind, index, configuration) {
  if (configuration < 0) return true;
  if (kind === "node") return isIn(entry.nodes[index] ?? { only: [] }, configuration);
  if (kind === "param") return isIn(entry.params[index] ?? { only: [] }, configuration);
  return true;
}

/** @param {string} one @param {string} other */
function compare(one, other) {
  const [left, right] = [SEVERITIES.indexOf(one), SEVERITIES.indexOf(other)];
  return left >= 0 && right >= 0 ? left - right : collator.compare(one, other);
}
