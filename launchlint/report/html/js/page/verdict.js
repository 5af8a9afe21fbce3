/** The verdict and the counts in the header, of the launch file that is shown. */

import { element, fill, part } from "./elements.js";
import { findingsIn, isIn, isUsedIn } from "./model.js";
import { configurationName, notice } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("../data").Entry} Entry */

const SEVERITIES = /** @type {const} */ (["error", "warning", "info"]);

/** @param {Page} page */
export function createVerdict(page) {
  const verdict = part("verdict");
  const counts = part("counts");
  page.store.listen((state, before) => {
    if (state !== before && state.entry === before.entry && state.configuration === before.configuration) return;
    const model = page.model.entry(state.entry);
    const { entry } = model;
    const args = entry.configurations[state.configuration];
    // On paper there is no chooser that says what is shown.
    part("bar").querySelector("h1")?.setAttribute("data-shown", [page.model.data.files[entry.file], args !== undefined && configurationName(args)].filter(Boolean).join(", "));
    const severities = findingsIn(model, state.configuration).map((each) => page.model.data.findings[each]?.severity);
    const has = (/** @type {string} */ severity) => severities.filter((each) => each === severity).length;
    const words = notice(entry) || loads(has("error"), has("warning"));
    const { base } = page.model.data;
    verdict.className = isRefused(entry) || has("error") > 0 ? "error" : entry.verdict !== "loads" || has("warning") > 0 ? "warning" : "ok";
    verdict.textContent = base === null ? words : `${words}; compared with ${base}`;
    const nodes = entry.nodes.filter((each) => isIn(each, state.configuration) && each.mark !== "removed");
    const topics = entry.channels.filter((each, at) => each.kind === "topic" && !each.plumbing && each.mark !== "removed" && isUsedIn(model, at, state.configuration));
    // Cards, and check, count what is started without other args.
    const [, usual] = entry.sight;
    const started = state.configuration < 0 && usual ? Math.min(usual, nodes.length) : nodes.length;
    const unknown = nodes.filter((each) => each.knowledge === "unknown");
    const partly = nodes.filter((each) => each.knowledge !== "unknown" && (each.open.length > 0 || each.partly.length > 0));
    fill(
      counts,
      ...SEVERITIES.map((severity) => count(has(severity), severity, severity)),
      count(started, "node"),
      count(nodes.length - started, "more with other args", "", "more with other args"),
      count(unknown.length, "not known", "unknown", "not known"),
      count(partly.length, "known in part", "partly", "known in part"),
      count(topics.length, "topic"),
      !entry.complete && element("li", { class: "unknown" }, "not all could be followed"),
    );
  });
}

/** Whether the launch file is refused in some configuration. @param {Entry} entry */
const isRefused = (entry) => entry.verdict === "refused" || entry.withArgs !== "";

/** @param {number} errors @param {number} warnings */
function loads(errors, warnings) {
  return errors > 0 ? "loads, with errors" : warnings > 0 ? "loads, with warnings" : "loads";
}

/** @param {number} number @param {string} one @param {string} [name] @param {string} [many] */
function count(number, one, name = "", many = `${one}s`) {
  return number > 0 && element("li", { class: name || null }, element("b", {}, number.toLocaleString("en")), ` ${number === 1 ? one : many}`);
}
