/** What the panel shows while nothing is selected: does it connect, what is wrong, what is not known. It also explains what is empty. */

import { element } from "./elements.js";
import { changesBlocks } from "./changes.js";
import { endsOf, isIn } from "./model.js";
import { badge, block, findingList, list } from "./panel_blocks.js";
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
  return [
    element("p", { class: "kind" }, "Launch file"),
    element("h2", { tabindex: -1 }, page.model.data.files[entry.file] ?? ""),
    entry.verdict === "refused" && element("p", { class: "refused" }, badge("refused", "error"), ` roslaunch does not load it: ${entry.why}`),
    entry.verdict === "cannot be told" &&
      element("p", {}, badge("cannot be told", "warning"), ` whether roslaunch loads it: ${entry.why}`),
    entry.withArgs !== "" &&
      element("p", { class: "refused" }, badge("refused with other args", "error"), ` ${entry.withArgs.replace(/^refused /, "")}`),
    !entry.complete && element("p", { class: "note" }, "An include could not be followed, so there may be more nodes than are shown."),
    ...page.model.data.notices.map((each) => element("p", { class: "note" }, each)),
    ...changesBlocks(page, model),
    entry.findings.length > 0
      ? block("What is wrong", findingList(page, entry.findings))
      : block("What is wrong", element("p", {}, "Nothing was found. Mistakes that only show while the robot runs are not looked for.")),
    ...(entry.nodes.length > 0 ? connectedBlocks(page, model, configuration) : [nothingBlock()]),
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
  return [
    block(
      "Does it connect?",
      element(
        "p",
        {},
        topics.length > 0 ? `${connected} of ${number(topics.length, "topic")} ${connected === 1 ? "has" : "have"} both ends.` : "No topic is known.",
      ),
      loosePart(
        page,
        "Nobody publishes, yet a node waits for it:",
        waiting.map((each) => each.index),
      ),
      loosePart(
        page,
        "Nobody in this launch file subscribes:",
        unheard.map((each) => each.index),
      ),
    ),
    unknown.length > 0 && unknownBlock(page, model, unknown),
  ];
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

/** @param {Page} page @param {EntryModel} model @param {number[]} unknown */
function unknownBlock(page, model, unknown) {
  const all = unknown.length === model.entry.nodes.length;
  const what = all
    ? "No library knows any of these nodes, so no connections can be drawn. Names, params and what is wrong in the files are complete all the same."
    : "Nothing is drawn from or to these, because no library knows what they do.";
  const commands = [...new Set(unknown.map((each) => model.entry.nodes[each]?.learn ?? ""))].filter(Boolean);
  return block(
    `${number(unknown.length, "node")} not known`,
    element("p", {}, what),
    list(unknown.map((each) => nodeReference(page, each))),
    commands.length > 0 && [
      element("p", {}, "To know them, run these, then make the page again with ", element("code", {}, "--library library.json"), ":"),
      list(
        commands.map((each) => element("code", {}, each)),
        "commands",
      ),
    ],
  );
}

function nothingBlock() {
  return block(
    "Nothing to draw",
    element("p", {}, "This launch file starts no nodes: it may only set params, or declare what other launch files include."),
    element("p", {}, "Choose another entry file above; params and findings are in the tables below."),
  );
}
