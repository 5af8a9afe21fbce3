/** The header: which launch file and configuration, search, export, theme, help. */

import { button, element, fill, part } from "./elements.js";
import { createExportMenu } from "./export.js";
import { createSearch } from "./search.js";
import { themeButton } from "./theme.js";
import { initialState } from "./state.js";
import { configurationName, number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */

/**
 * @param {Page} page
 * @param {{ help: () => void }} actions
 */
export function createControls(page, { help }) {
  const search = createSearch(page);
  const configuration = element("select", { class: "one-only", "aria-label": "Configuration" });
  const entry = entryChooser(page);
  configuration.addEventListener("change", () => page.store.set({ configuration: Number(configuration.value) }));
  fill(
    part("controls"),
    entry,
    configuration,
    search.host,
    createExportMenu(page),
    themeButton(),
    button("?", help, { class: "help", "aria-label": "Keyboard help", title: "Keyboard (?)" }),
  );
  page.store.listen((state) => entry && (entry.value = state.landing ? "-1" : String(state.entry)), { always: true });
  page.store.listen((state, before) => {
    if (state === before || state.entry !== before.entry) fillConfigurations(page, configuration);
    configuration.value = String(state.configuration);
  });
  return search;
}

/** Nothing where there is one entry file only. @param {Page} page */
function entryChooser({ model, store }) {
  const { entries, files } = model.data;
  if (entries.length < 2) return null;
  const options = entries.map((each, index) => {
    const count = each.findings.length;
    const told = [
      each.configurations[0],
      each.verdict !== "loads" ? each.verdict : each.withArgs !== "" && "refused with other args",
      each.mark ?? each.changes.map(([, words]) => words).join(", "),
      count > 0 && `${count} ${count === 1 ? "finding" : "findings"}`,
    ];
    const more = told.filter(Boolean).join(", ");
    return element("option", { value: index }, `${files[each.file]}${more ? ` (${more})` : ""}`);
  });
  const all = element("option", { value: -1 }, `All ${number(entries.length, "launch file")}`);
  const host = element("select", { "aria-label": "Launch file" }, all, ...options);
  host.addEventListener("change", () => store.set(host.value === "-1" ? { ...initialState(), landing: true } : { entry: Number(host.value) }));
  return host;
}

/** @param {Page} page @param {HTMLSelectElement} host */
function fillConfigurations({ model, store }, host) {
  const { configurations } = model.entry(store.get().entry).entry;
  host.hidden = configurations.length < 2;
  fill(
    host,
    element("option", { value: -1 }, `All ${configurations.length} configurations`),
    ...configurations.map((args, index) => element("option", { value: index }, configurationName(args))),
  );
}
