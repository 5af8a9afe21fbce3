/** The chooser of args: each that makes a difference, with its values, and the command line that starts what is shown. */

import { choices, commandOf, configurationOf } from "./combination.js";
import { button, element, fill } from "./elements.js";
import { isIn } from "./model.js";
import { configurationName, number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */

const EVERY = -1;

/** @param {Page} page @returns {HTMLElement} */
export function createConfigurations({ model, store }) {
  const quick = element("select", { "aria-label": "Configuration" });
  const title = element("summary", {}, "Args");
  const content = element("div", { class: "menu-items args" });
  const menu = element("details", { class: "popup one-only" }, title, content);
  const host = element("span", { class: "one-only configurations" }, quick, menu);
  quick.addEventListener("change", () => store.set({ configuration: Number(quick.value) }));
  document.addEventListener("click", (event) => menu.contains(/** @type {Node} */ (event.target)) || (menu.open = false));
  menu.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !menu.open) return;
    menu.open = false;
    title.focus();
    event.stopPropagation();
  });

  const entryNow = () => model.entry(store.get().entry).entry;

  /** The args as they are chosen. */
  function chosen() {
    const selects = [...content.querySelectorAll("select")];
    return selects.flatMap((each) => (each.selectedIndex > 0 ? [/** @type {const} */ ([each.dataset["name"] ?? "", each.value])] : []));
  }

  function apply() {
    store.set({ configuration: configurationOf(entryNow(), chosen()) });
  }

  /** Anew, for another launch file. */
  function build() {
    const entry = entryNow();
    const rows = choices(entry).map(({ name, values }) => {
      const options = [element("option", {}, "default"), ...values.map((value) => element("option", { value }, value || "(empty)"))];
      const chooser = element("select", { "data-name": name, change: apply }, ...options);
      return element("label", {}, element("code", {}, name), chooser);
    });
    host.hidden = rows.length === 0 && entry.configurations.length < 2;
    menu.hidden = rows.length === 0 && !entry.command;
    const command = element("pre", { class: "command", tabindex: 0, role: "group", "aria-label": "Command" });
    const copy = button("Copy", () => void copied(command.textContent ?? "", copy), { class: "copy" });
    const note = element("p", { class: "note" });
    fill(content, element("p", { class: "note" }, "What starts it so:"), command, copy, note, ...rows);
  }

  function show() {
    const { configuration } = store.get();
    const entry = entryNow();
    const all = element("option", { value: EVERY }, `All ${entry.configurations.length} configurations`);
    fill(quick, all, ...entry.configurations.map((args, index) => element("option", { value: index }, configurationName(args))));
    quick.value = String(configuration);
    const pairs = entry.given[configuration] ?? [];
    for (const each of content.querySelectorAll("select")) {
      const value = pairs.find(([name]) => name === each.dataset["name"])?.[1];
      each.selectedIndex = value === undefined ? 0 : [...each.options].findIndex((option, at) => at > 0 && option.value === value);
    }
    const [command, note] = [content.querySelector("pre"), content.querySelector(":scope > p:last-of-type")];
    if (command) command.textContent = commandOf(entry, Math.max(configuration, 0));
    if (note) note.textContent = said(entry, configuration);
  }

  store.listen((state, before) => {
    const anew = state === before || state.entry !== before.entry;
    if (anew) build();
    if (anew || state.configuration !== before.configuration) show();
  });
  return host;
}

/** What has to be said of a configuration. @param {import("../data").Entry} entry @param {number} configuration */
function said(entry, configuration) {
  if (configuration < 0) return "All configurations are shown together: what is in some of them only is dashed.";
  const nodes = entry.nodes.filter((each) => isIn(each, configuration) && each.mark !== "removed").length;
  const guess = !entry.whole && (entry.given[configuration]?.length ?? 0) > 1;
  const doubt = guess ? " It has more args that act on each other than were combined: of several at once, it is shown what each of them does." : "";
  return `${number(nodes, "node")} with these args.${doubt}`;
}

/** @param {string} text @param {HTMLButtonElement} told */
async function copied(text, told) {
  try {
    await navigator.clipboard.writeText(text);
    told.textContent = "Copied";
  } catch {
    told.textContent = "Select it, and copy with Ctrl+C";
  }
  window.setTimeout(() => (told.textContent = "Copy"), 2000);
}
