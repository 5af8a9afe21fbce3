/** The drawer of tables: one at a time, of the launch file that is shown, sorted, filtered, and linked with the drawing both ways. */

import { button, element, part } from "./elements.js";
import { createLibrary } from "./library.js";
import { KINDS } from "./rows.js";
import { createTable } from "./table.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./table.js").Table} Table */
/** @typedef {{ id: string, host: HTMLElement, opener: HTMLButtonElement, count: HTMLElement, table: Table | null, fill: () => void }} Drawer */

/** @param {Page} page */
export function createTables(page) {
  const section = part("tables");
  const filter = element("input", { type: "search", placeholder: "Filter rows", "aria-label": "Filter rows", spellcheck: "false" });
  const everything = element("input", { type: "checkbox" });
  const several = page.model.data.entries.length > 1;
  const tools = element("div", { class: "drawer-tools", hidden: true }, filter, several && element("label", {}, everything, " all launch files"));
  const openers = element("div", { class: "openers" });
  section.prepend(element("div", { class: "drawer-bar" }, openers, tools));
  const drawers = KINDS.map((kind) => {
    const table = createTable(page, kind);
    section.append(table.host);
    return drawerOf(`table-${kind.id}`, table.host, kind.caption, table);
  });
  const unknown = part("unknown");
  section.append(unknown);
  drawers.push(drawerOf("table-unknown", unknown, unknown.querySelector("h2")?.textContent?.trim() ?? "", null));
  const library = part("library");
  drawers.push(drawerOf("library", library, "Library", null, createLibrary(page, library)));
  library.append(part("foot"));
  section.append(library);
  /** @type {Drawer | null} */
  let open = null;

  /** @param {string} id @param {HTMLElement} host @param {string} title @param {Table | null} table @param {() => void} [fill] @returns {Drawer} */
  function drawerOf(id, host, title, table, fill = () => {}) {
    host.hidden = true;
    if (host instanceof HTMLDetailsElement) host.open = true;
    const opener = button("", () => turn(id), { "aria-expanded": "false", "aria-controls": host.id });
    const [, words = title, count = ""] = /^(.*?)\s*([\d,]*)$/s.exec(title) ?? [];
    const counted = element("span", { class: "number" }, count);
    opener.append(words, counted);
    openers.append(opener);
    return { id, host, opener, count: counted, table, fill };
  }

  /** @param {string} id */
  function turn(id) {
    const next = drawers.find((each) => each.id === id) ?? null;
    open = next === open ? null : next;
    open?.fill();
    for (const each of drawers) {
      each.host.hidden = each !== open;
      each.opener.setAttribute("aria-expanded", String(each === open));
    }
    tools.hidden = !open?.table;
    document.body.classList.toggle("drawer-open", open !== null);
    update();
  }

  /** Of the landing page no launch file is shown, so that nothing of any is counted. */
  const isAway = () => page.store.get().landing;

  function update() {
    if (isAway()) return;
    for (const { table, count } of drawers) if (table) count.textContent = table.count(page.store.get(), everything.checked).toLocaleString("en");
    open?.table?.show(page.store.get(), filter.value, everything.checked);
  }

  filter.addEventListener("input", update);
  everything.addEventListener("change", update);
  page.store.listen((state, before) => {
    const keys = /** @type {const} */ (["entry", "configuration", "landing"]);
    if (state === before || keys.some((key) => state[key] !== before[key])) update();
    else if (state.selection !== before.selection) open?.table?.mark(state);
  });
  window.addEventListener("beforeprint", () => {
    if (!isAway()) for (const { table, fill } of drawers) table ? table.show(page.store.get(), "", false) : fill();
  });
  window.addEventListener("hashchange", () => {
    const id = decoded(location.hash.slice(1));
    for (const each of drawers) if (id.startsWith("program-") && each.id === "library") each.fill();
    const meant = drawers.find((each) => each.host.id === id || each.id === id || each.host.contains(document.getElementById(id)));
    if (id && meant && meant !== open) turn(meant.id);
    if (meant) document.getElementById(id)?.scrollIntoView({ block: "nearest" });
  });
  return {
    /** Closes the table that is open, or opens the first. */
    toggle: () => turn(open?.id ?? drawers[0]?.id ?? ""),
    /** Opens the first table where none is open. */
    open: () => open ?? turn(drawers[0]?.id ?? ""),
  };
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
