/** What the panel shows while nothing is selected: does it connect, what is wrong, what is not known. It also explains what is empty. */

import { element } from "./elements.js";
import { changesBlocks } from "./changes.js";
import { endsOf, findingsIn, isIn, mayBeAt } from "./model.js";
import { badge, block, commandPart, findingList, list } from "./panel_blocks.js";
import { channelReference, nodeReference } from "./reference.js";
import { number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("./model.js").EntryModel} EntryModel */

/**
 * @param {Page} page
 * @param {EntryModel} model
 * @returns {Child[]}
 */
export function overviewPanel(page, model) {
  const { entry } = model;
  const { configuration } = page.store.get();
  const findings = findingsIn(model, configuration);
  const fixed = entry.fixed.flatMap((each) => page.model.data.fixed[each] ?? []);
  return [
    element("p", { class: "kind" }, "Launch file"),
    element("h2", { tabindex: -1 }, page.model.data.files[entry.file] ?? ""),
    entry.verdict === "refused" && element("p", { class: "refused" }, badge("refused", "error"), ` ${entry.launcher} does not load it: ${entry.why}`),
    entry.verdict === "cannot be told" &&
      element("p", {}, badge("cannot be told", "warning"), ` whether ${entry.launcher} loads it: ${entry.why}`),
    entry.withArgs !== "" &&
      element("p", { class: "refused" }, badge("refused with other args", "error"), ` ${entry.withArgs.replace(/^refused /, "")}`),
    !entry.complete && element("p", { class: "note" }, `${entry.python ? "Not everything could be followed" : "An include could not be followed"}, so there may be more nodes than are shown.`),
    ...page.model.data.notices.map((each) => element("p", { class: "note" }, each)),
    ...changesBlocks(page, model),
    findings.length > 0
      ? block(`What is wrong (${findings.length})`, findingList(page, findings))
      : block("What is wrong", element("p", {}, "Nothing was found. Mistakes that only show while the robot runs are not looked for.")),
    fixed.length > 0 && block(`Fixed since ${page.model.data.base} (${fixed.length})`, list(fixed.map(({ rule, message }) => element("div", {}, badge("fixed", "since fixed"), " ", element("code", {}, rule), ` ${message}`)), "findings")),
    ...(entry.python ?? []).map((each) =>
      block(
        `Python, known ${each.state === "not" ? "not at all" : "in part"}: ${each.file}`,
        element("p", {}, "It is read and not run. Not known without running it:"),
        list(each.reasons.map(([line, why]) => `line ${line}: ${why}`)),
      ),
    ),
    ...(entry.nodes.length > 0 ? connectedBlocks(page, model, configuration) : [nothingBlock(entry.complete)]),
  ];
}

/** @param {Page} page @param {EntryModel} model @param {number} configuration */
function connectedBlocks(page, model, configuration) {
  const unknown = model.entry.nodes.flatMap((each, index) =>
    each.knowledge === "unknown" && each.mark !== "removed" && isIn(each, configuration) ? [index] : [],
  );
  const topics = model.entry.channels.flatMap(({ kind, hub, plumbing }, index) => {
    const ends = endsOf(model, index, configuration);
    return kind === "topic" && !hub && !plumbing && (ends.offered || ends.used) ? [{ index, ...ends }] : [];
  });
  const connected = topics.filter((each) => each.offered && each.used).length;
  const waiting = topics.filter((each) => !each.offered && each.certain);
  const unheard = topics.filter((each) => !each.used && each.certain);
  const share = shareKnown(model, configuration);
  const inDoubt = (/** @type {number} */ index, /** @type {boolean} */ offers) => mayBeAt(model, index, offers, configuration).length > 0;
  const numbers = (/** @type {{ index: number }[]} */ those) => those.map((each) => each.index);
  const doubtful = (/** @type {{ index: number }[]} */ those, /** @type {boolean} */ offers) => numbers(those).filter((each) => inDoubt(each, offers));
  const doubtless = (/** @type {{ index: number }[]} */ those, /** @type {boolean} */ offers) => numbers(those).filter((each) => !inDoubt(each, offers));
  return [
    block(
      "Does it connect?",
      element(
        "p",
        {},
        topics.length > 0 ? `${connected} of ${number(topics.length, "topic")} ${connected === 1 ? "has" : "have"} both ends.` : "No topic is known.",
        share && ` ${share}.`,
      ),
      loosePart(page, "Nobody publishes, yet a node waits for it:", doubtless(waiting, true)),
      loosePart(page, "Nobody here is known to publish, yet somebody may:", doubtful(waiting, true)),
      loosePart(page, "Nobody in this launch file subscribes:", doubtless(unheard, false)),
      loosePart(page, "Nobody here is known to subscribe, yet somebody may:", doubtful(unheard, false)),
    ),
    unknown.length > 0 && unknownBlock(page, model, unknown),
  ];
}

/**
 * "12 of 15 nodes known", as `launchlint check` says it: of what is started without args. Empty where another configuration is shown.
 *
 * @param {EntryModel} model
 * @param {number} configuration
 */
function shareKnown({ entry }, configuration) {
  const [known, nodes] = entry.sight;
  if (nodes === 0 || configuration > 0) return "";
  return `${known} of ${number(nodes, "node")} known${entry.configurations.length > 1 ? " when it is started without args" : ""}`;
}

/** @param {Page} page @param {string} title @param {number[]} channels */
function loosePart(page, title, channels) {
  return (
    channels.length > 0 && [
      element("p", { class: "note" }, title),
      list(
        channels.map((each) => channelReference(page, each)),
        "loose",
      ),
    ]
  );
}

/** How many nodes are known, what stands in the way of the others, and what mends it. @param {Page} page @param {EntryModel} model @param {number[]} unknown */
function unknownBlock(page, model, unknown) {
  const { entry } = model;
  const all = unknown.length === entry.nodes.length;
  const what = all
    ? "Nothing is known of any of these nodes, so no connections can be drawn. Names, params and what is wrong in the files are complete all the same."
    : "Nothing is drawn from or to these, because nothing says what they do:";
  /** @type {Map<string, number[]>} */
  const programs = new Map();
  for (const index of unknown) {
    const program = entry.nodes[index]?.program ?? "";
    programs.set(program, [...(programs.get(program) ?? []), index]);
  }
  const items = [...programs].map(([program, nodes]) => {
    const reason = entry.nodes[nodes[0] ?? -1]?.reason ?? "";
    const why = reason.replaceAll(`the nodelet class ${program}`, "it").replaceAll(program, "it");
    return element("div", {}, ...nodes.flatMap((each, at) => [at > 0 && ", ", nodeReference(page, each)]), element("div", { class: "note" }, element("code", {}, program), why && `: ${why}`));
  });
  return block(
    `${number(unknown.length, "node")} not known`,
    element("p", {}, what),
    list(items),
    commandPart(entry.mend.command, "To know those whose packages are here, run this, then make the page again:"),
    entry.mend.advice && element("p", {}, `${entry.mend.advice}.`),
  );
}

/** @param {boolean} complete whether all that the launch file starts could be followed */
function nothingBlock(complete) {
  const said = complete
    ? "This launch file starts no nodes: it may only set params, or declare what other launch files include."
    : "Which nodes this launch file starts is not known.";
  return block(
    "Nothing to draw",
    element("p", {}, said),
    element("p", {}, "Choose another entry file above; params and findings are in the tables below."),
  );
}
