/** The drawer of tables: one at a time, of the launch file that is shown, sorted, filtered, and linked with the drawing both ways. */

import { button, element, part } from "./elements.js";
import { select } from "./reference.js";
import { enhance } from "./table.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./table.js").Table} Table */
/** @typedef {{ id: string, host: HTMLElement, opener: HTMLButtonElement, count: HTMLElement, table: Table | null }} Drawer */

/** @param {Page} page */
export function createTables(page) {
  const section = part("tables");
  const filter = element("input", { type: "search", placeholder: "Filter rows", "aria-label": "Filter rows", spellcheck: "false" });
  const everything = element("input", { type: "checkbox" });
  const several = page.model.data.entries.length > 1;
  const tools = element("div", { class: "drawer-tools", hidden: true }, filter, several && element("label", {}, everything, " all launch files"));
  const openers = element("div", { class: "openers" });
  section.prepend(element("div", { class: "drawer-bar" }, openers, tools));
  /** @type {Drawer[]} */
  const drawers = [...section.querySelectorAll("details.table")].map((host) => drawer(/** @type {HTMLDetailsElement} */ (host)));
  const library = part("library");
  drawers.push(drawerOf("library", library, "Library"));
  library.append(part("foot"));
  section.append(library);
  /** @type {Drawer | null} */
  let open = null;

  /** @param {HTMLDetailsElement} host @returns {Drawer} */
  function drawer(host) {
    const title = host.querySelector("summary h2")?.textContent?.trim() ?? "";
    const own = host.querySelector("table");
    host.open = true;
    const made = drawerOf(own?.id || host.id, host, title);
    if (own && own.id !== "table-unknown") {
      made.table = enhance(page, own);
      own.addEventListener("click", (event) => follow(/** @type {Table} */ (made.table), event));
    }
    return made;
  }

  /** @param {string} id @param {HTMLElement} host @param {string} title @returns {Drawer} */
  function drawerOf(id, host, title) {
    host.hidden = true;
    host.id ||= `drawer-${id}`;
    const opener = button("", () => turn(id), { "aria-expanded": "false", "aria-controls": host.id });
    const [, words = title, count = ""] = /^(.*?)\s*([\d,]*)$/s.exec(title) ?? [];
    const counted = element("span", { class: "number" }, count);
    opener.append(words, counted);
    openers.append(opener);
    return { id, host, opener, count: counted, table: null };
  }

  /** @param {string} id */
  function turn(id) {
    const next = drawers.find((each) => each.id === id) ?? null;
    open = next === open ? null : next;
    for (const each of drawers) {
      each.host.hidden = each !== open;
      each.opener.setAttribute("aria-expanded", String(each === open));
    }
    tools.hidden = !open?.table;
    document.body.classList.toggle("drawer-open", open !== null);
    update();
  }

  function update() {
    for (const { table, count } of drawers) if (table) count.textContent = String(table.count(page.store.get(), everything.checked));
    open?.table?.show(page.store.get(), filter.value, everything.checked);
  }

  /** A click on a row, but not on a link in it. @param {Table} table @param {MouseEvent} event */
  function follow(table, event) {
    const target = /** @type {Element} */ (event.target);
    const row = target.closest("tr");
    const found = row && table.targetOf(row);
    if (!found || target.closest("a[href^=http], button")) return;
    event.preventDefault();
    select(page, found.target, found.entry);
  }

  filter.addEventListener("input", update);
  everything.addEventListener("change", update);
  page.store.listen((state, before) => {
    const keys = /** @type {const} */ (["entry", "configuration", "selection"]);
    if (state === before || keys.some((key) => state[key] !== before[key])) update();
  });
  window.addEventListener("hashchange", () => {
    const id = decoded(location.hash.slice(1));
    const meant = drawers.find((each) => each.host.id === id || each.host.contains(document.getElementById(id)));
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
