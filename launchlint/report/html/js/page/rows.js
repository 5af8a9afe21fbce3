/** The rows of the tables: the same that launchlint/report/html/tables.py writes for those who have no scripts. */

import { findingsIn, isIn, isUsedIn, mayBeAt } from "./model.js";
import { grouped } from "./same_findings.js";
import { doubted } from "./wording.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("./state.js").Target} Target */
/** @typedef {import("../data").Place} Place */

/**
 * One row. A cell is text; `place` is where the one of that column leads to, `name` says which one is a link to the target, `others` are further
 * findings of the same words.
 *
 * @typedef {object} Row
 * @property {Target} target
 * @property {number} entry
 * @property {string} index
 * @property {string[]} cells
 * @property {string} classes
 * @property {Place | null} place
 * @property {Target[]} others
 */
/**
 * @typedef {object} Kind
 * @property {string} id
 * @property {string} caption
 * @property {readonly string[]} columns
 * @property {number} named column of the name
 * @property {number} placed column of the place; -1: none
 * @property {string} empty
 * @property {(model: EntryModel, configuration: number, data: Model) => Row[]} rows
 * @property {(model: EntryModel, configuration: number) => number} count how many rows there are
 */

const MOST_NAMES = 8;

/** @type {readonly Kind[]} */
export const KINDS = [
  {
    id: "findings",
    caption: "Findings",
    columns: ["Severity", "Rule", "Finding", "Place", "What to do"],
    named: 2,
    placed: 3,
    empty: "No rule found anything wrong here. Mistakes at nodes that are not known cannot be seen.",
    rows: findingRows,
    count: (model, configuration) => findingsIn(model, configuration).length,
  },
  {
    id: "nodes",
    caption: "Nodes",
    columns: ["Node", "Program", "Known", "Place", "Findings"],
    named: 0,
    placed: 3,
    empty: "No node is started.",
    rows: nodeRows,
    count: ({ entry }, configuration) => entry.nodes.filter((each) => isIn(each, configuration)).length,
  },
  channelTable("topic", "Topics", "No topic is known.", ["Publishers", "Subscribers"]),
  channelTable("service", "Services", "No service is known.", ["Servers", "Clients"]),
  channelTable("action", "Actions", "No action is known.", ["Servers", "Clients"]),
  {
    id: "params",
    caption: "Params",
    columns: ["Param", "Value", "Place", "Overrides", "Read by"],
    named: 0,
    placed: 2,
    empty: "No param is set.",
    rows: paramRows,
    count: ({ entry }, configuration) => entry.params.filter((each) => isIn(each, configuration)).length,
  },
];

/** @param {"topic" | "service" | "action"} kind @param {string} caption @param {string} empty @param {[string, string]} ends @returns {Kind} */
function channelTable(kind, caption, empty, ends) {
  return {
    id: `${kind}s`,
    caption,
    columns: [caption.slice(0, -1), "Type", ...ends],
    named: 0,
    placed: -1,
    empty,
    rows: (model, configuration) => those(model, kind, configuration).map((at) => channelRow(model, at, configuration)),
    count: (model, configuration) => those(model, kind, configuration).length,
  };
}

/** @param {EntryModel} model @param {number} configuration @param {Model} page @returns {Row[]} */
function findingRows(model, configuration, { data }) {
  return grouped(data, findingsIn(model, configuration)).flatMap(([first, ...more]) => {
    const finding = data.findings[first ?? -1];
    if (!finding) return [];
    const others = more.flatMap((each) => data.findings[each] ?? []);
    const place = `${data.files[finding.place[0]]}:${finding.place[1]}`;
    const [since, times] = [finding.since ? `${finding.since} ` : "", others.length > 0 ? ` (${others.length + 1} times)` : ""];
    return [
      {
        target: { kind: "finding", id: finding.id },
        entry: model.index,
        index: String(first),
        cells: [`${since}${finding.severity}`, `${finding.rule} ${finding.name}`, `${finding.message}${times}`, place, finding.help],
        classes: [finding.severity, finding.since && `${finding.since}-finding`].filter(Boolean).join(" "),
        place: finding.place,
        others: others.map((each) => /** @type {Target} */ ({ kind: "finding", id: each.id })),
      },
    ];
  });
}

/** @param {EntryModel} model @param {number} configuration @param {Model} page @returns {Row[]} */
function nodeRows(model, configuration, page) {
  return model.entry.nodes.flatMap((node, at) => {
    if (!isIn(node, configuration)) return [];
    const known = node.knowledge === "unknown" ? "unknown" : "known";
    const cells = [node.name, node.program, known, node.place ? page.place(node.place) : "", node.findings.length ? String(node.findings.length) : ""];
    return [row(model, "node", at, cells, node.mark, node.place)];
  });
}

/** @param {EntryModel} model @param {string} kind @param {number} configuration */
function those(model, kind, configuration) {
  return model.entry.channels.flatMap((each, at) => (each.kind === kind && !each.plumbing && isUsedIn(model, at, configuration) ? [at] : []));
}

/** @param {EntryModel} model @param {number} at @param {number} configuration @returns {Row} */
function channelRow(model, at, configuration) {
  const channel = model.entry.channels[at];
  if (!channel) throw new RangeError(`there is no channel ${at}`);
  const sides = [true, false].map((offers) => {
    const ends = (model.onChannel[at] ?? []).filter((each) => each.offers === offers && each.mark !== "removed" && isIn(each, configuration));
    return some(ends.map((each) => model.entry.nodes[each.node]?.name ?? "")) || nobody(model, at, offers, configuration);
  });
  return row(model, "channel", at, [channel.name, channel.types.join(", "), ...sides], channel.mark, null);
}

/** What is said of an empty end, with the doubt that there is. @param {EntryModel} model @param {number} at @param {boolean} offers @param {number} configuration */
function nobody(model, at, offers, configuration) {
  const channel = model.entry.channels[at];
  if (!channel || channel.mark === "removed") return "";
  const who = doubted(mayBeAt(model, at, offers, configuration));
  return who ? `nobody here, but ${who} may` : channel.hub ? "" : "nobody";
}

/** @param {EntryModel} model @param {number} configuration @param {Model} page @returns {Row[]} */
function paramRows(model, configuration, page) {
  return model.entry.params.flatMap((param, at) => {
    if (!isIn(param, configuration)) return [];
    const earlier = param.overrides.map(([value, place]) => `${value} at ${place ? page.place(place) : ""}`).join("; ");
    const readers = some(param.readers.map((each) => model.entry.nodes[each]?.name ?? ""));
    return [row(model, "param", at, [param.name, param.value, param.place ? page.place(param.place) : "", earlier, readers], param.mark, param.place)];
  });
}

/** @param {EntryModel} model @param {"node" | "channel" | "param"} kind @param {number} at @param {string[]} cells @param {string | undefined} mark @param {Place | null} place @returns {Row} */
function row(model, kind, at, cells, mark, place) {
  return { target: { kind, id: `${kind.charAt(0)}:${at}` }, entry: model.index, index: String(at), cells, classes: mark ?? "", place, others: [] };
}

/** The first names, and how many more there are. @param {string[]} names */
function some(names) {
  const all = [...new Set(names)].sort();
  const more = all.length - MOST_NAMES;
  return `${all.slice(0, MOST_NAMES).join(", ")}${more > 0 ? ` and ${more} more` : ""}`;
}
