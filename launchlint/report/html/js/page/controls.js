/** The header: which launch file and configuration, search, export, theme, help. */

import { button, element, fill, part } from "./elements.js";
import { createConfigurations } from "./configurations.js";
import { createExportMenu } from "./export.js";
import { createSearch } from "./search.js";
import { themeButton } from "./theme.js";
import { initialState } from "./state.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */

/**
 * @param {Page} page
 * @param {{ help: () => void }} actions
 */
export function createControls(page, { help }) {
  const search = createSearch(page);
  const entry = entryChooser(page);
  fill(
    part("controls"),
    entry,
    createConfigurations(page),
    search.host,
    createExportMenu(page),
    themeButton(),
    button("?", help, { class: "help", "aria-label": "Keyboard help", title: "Keyboard (?)" }),
  );
  page.store.listen((state) => entry && (entry.value = state.landing ? "-1" : String(state.entry)), { always: true });
  return search;
}

/** Nothing where there is one entry file only. @param {Page} page */
function entryChooser({ model, store }) {
  const { entries, files } = model.data;
  if (entries.length < 2) return null;
  const names = toldApart(entries.map((each) => files[each.file] ?? ""));
  const options = entries.map((each, index) => {
    const count = each.findings.length;
    const told = [
      each.configurations[0],
      each.verdict !== "loads" ? each.verdict : each.withArgs !== "" && "refused with other args",
      each.mark ?? each.changes.map(([, words]) => words).join(", "),
      count > 0 && `${count} ${count === 1 ? "finding" : "findings"}`,
    ];
    const more = told.filter(Boolean).join(", ");
    return element("option", { value: index, title: files[each.file] ?? "" }, `${names[index]}${more ? ` (${more})` : ""}`);
  });
  const all = element("option", { value: -1 }, `All ${number(entries.length, "launch file")}`);
  const host = element("select", { "aria-label": "Launch file" }, all, ...options);
  host.addEventListener("change", () => store.set(host.value === "-1" ? { ...initialState(), landing: true } : { entry: Number(host.value) }));
  return host;
}

/**
 * The ends of paths that tell them apart: a narrow field shows only the beginning of what it holds.
 *
 * @param {string[]} paths
 */
function toldApart(paths) {
  /** @param {string} path */
  const endings = (path) => path.split("/").map((_, at, parts) => parts.slice(parts.length - 1 - at).join("/"));
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (const path of new Set(paths)) for (const each of endings(path)) counts.set(each, (counts.get(each) ?? 0) + 1);
  return paths.map((path) => endings(path).find((each) => counts.get(each) === 1) ?? path);
}
