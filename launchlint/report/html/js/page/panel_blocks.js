/** Pieces that several panels share. */

import { button, element } from "./elements.js";
import { mayBeAt } from "./model.js";
import { nodeReference, reference } from "./reference.js";
import { source, written } from "./source.js";
import { grouped } from "./same_findings.js";
import { missed, number, when } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./elements.js").Child} Child */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("../data").Finding} Finding */
/** @typedef {import("../data").Place} Place */

const MANY = 12;

/**
 * A part of a panel under a heading, which may be empty.
 *
 * @param {string} title
 * @param {...(Child | Child[])} children
 */
export function block(title, ...children) {
  return element("section", { class: "block" }, title && element("h3", {}, title), ...children);
}

/**
 * What is selected, and what can be done with it.
 *
 * @param {string} kind
 * @param {string} name
 * @param {Child[]} badges
 * @param {Child[]} actions
 */
export function heading(kind, name, badges, actions = []) {
  return [
    element("p", { class: "kind" }, kind),
    element("h2", { tabindex: -1 }, name),
    badges.some(Boolean) && element("p", { class: "badges" }, ...badges),
    actions.some(Boolean) && element("p", { class: "actions" }, ...actions),
  ];
}

/** @param {string} text @param {string} [name] class of its colour */
export function badge(text, name = "") {
  return element("span", { class: `badge ${name}`.trim() }, text);
}

/**
 * A list; a long one is cut, and the rest is behind a button.
 *
 * @param {readonly Child[]} items
 * @param {string} [name] class
 */
export function list(items, name = "") {
  const host = element("ul", { class: name || null }, ...items.slice(0, MANY).map((item) => element("li", {}, item)));
  if (items.length <= MANY) return host;
  const rest = items.slice(MANY);
  const more = element(
    "li",
    {},
    button(`${rest.length} more`, () => more.replaceWith(...rest.map((item) => element("li", {}, item))), { class: "more" }),
  );
  host.append(more);
  return host;
}

/**
 * Findings as links, the worst first; nothing where there are none.
 *
 * @param {Page} page
 * @param {readonly number[]} findings
 */
export function findingsBlock(page, findings) {
  if (findings.length === 0) return null;
  return block(findings.length === 1 ? "Finding" : `${findings.length} findings`, findingList(page, findings));
}

/** Those of the same words are one item with their number. @param {Page} page @param {readonly number[]} findings */
export function findingList(page, findings) {
  const { data } = page.model;
  const items = grouped(data, findings).flatMap((those) => {
    const [each, ...others] = those.flatMap((index) => data.findings[index] ?? []);
    return each ? [findingItem(page, each, others)] : [];
  });
  return list(items, "findings");
}

/** @param {Page} page @param {Finding} finding @param {readonly Finding[]} others of the same words */
function findingItem(page, finding, others) {
  const link = (/** @type {Finding} */ each, /** @type {string} */ text) => reference(page, { kind: "finding", id: each.id }, text);
  const more = others.length > 0 && [
    element("summary", {}, `and at ${number(others.length, "more place")}`),
    list(others.map((each) => link(each, page.model.place(each.place)))),
  ];
  return element(
    "div",
    {},
    finding.since === "new" && [badge("new", "since"), " "],
    badge(finding.severity, finding.severity),
    " ",
    element("code", {}, finding.rule),
    " ",
    link(finding, finding.message),
    element("span", { class: "note" }, written(page.model, finding.place)),
    more && element("details", { class: "others" }, ...more),
  );
}

/** @param {Page} page @param {Place | null} place @param {string} [title] */
export function sourceBlock(page, place, title = "Written at") {
  return place && block(title, source(page.model, place));
}

/**
 * In which configurations something is, and under which conditions.
 *
 * @param {Page} page
 * @param {readonly number[]} only
 * @param {readonly string[]} conditions
 */
export function presenceBlock(page, only, conditions = []) {
  const entry = page.model.entry(page.store.get().entry).entry;
  const words = when(entry, only);
  if (!words && conditions.length === 0) return null;
  const lines = conditions.map((condition) => element("code", {}, condition));
  const there = words || (entry.configurations.length > 1 ? "in every configuration of this page" : "in the one configuration of this page");
  return block("When it is there", element("p", {}, there), lines.length > 0 && list(lines));
}

/**
 * The name a node's code uses, and how it came to be the one on the graph.
 *
 * @param {Page} page
 * @param {Connection} connection
 */
function renaming({ model }, connection) {
  const steps = connection.remaps.filter(([from, to]) => from !== to);
  if (steps.length === 0) return null;
  const items = steps.map(([from, to, place]) => {
    const where = place ? written(model, place) : "its args";
    return element("li", {}, element("code", {}, from), " → ", element("code", {}, to), " ", element("span", { class: "note" }, "in ", where));
  });
  return element("ol", { class: "remaps", "aria-label": "Remapped" }, ...items);
}

/**
 * The nodes at one end of a channel, or that there are none.
 *
 * @param {Page} page
 * @param {readonly Connection[]} others at the other end
 * @param {Connection} self
 */
export function peerList(page, others, self) {
  const { entry: shown, configuration } = page.store.get();
  const model = page.model.entry(shown);
  const channel = model.entry.channels[self.channel];
  // Data goes from publishers to subscribers, and from clients to servers.
  const direction = (channel?.kind === "topic") === self.offers ? "to" : "from";
  if (others.length > 0)
    return list(
      [...new Set(others.map((each) => each.node))].map((node) => nodeReference(page, node)),
      `peers ${direction}`,
    );
  const doubts = mayBeAt(model, self.channel, !self.offers, configuration);
  const isNote = channel?.hub || channel?.plumbing || !self.certain || doubts.length > 0;
  return element("p", { class: isNote ? "note" : "missing" }, missed(self.role, doubts));
}

/**
 * Everything else that is known of a connection: type, what its name was, when it is there, and how that is known.
 *
 * @param {Page} page
 * @param {Connection} connection
 * @param {boolean} [withType] not where it is told already
 */
export function connectionFacts(page, connection, withType = true) {
  const entry = page.model.entry(page.store.get().entry).entry;
  const notes = [moment(connection), when(entry, connection.only), connection.mark && `${connection.mark} since ${page.model.data.base}`];
  const renamed = renaming(page, connection);
  const evidence = element(
    "details",
    {},
    element("summary", {}, "How this is known"),
    list(connection.evidence.map((each) => element("code", {}, each))),
  );
  const name = entry.channels[connection.channel]?.name;
  return [
    connection.qos && element("div", { class: "type" }, "QoS: ", connection.qos),
    withType && connection.type && element("div", { class: "type" }, element("code", {}, connection.type)),
    (renamed || connection.unremapped !== name || connection.spelling === "private") &&
      element("div", { class: "note" }, "in the code: ", element("code", {}, connection.declared), ` (${connection.spelling})`),
    renamed,
    notes.filter(Boolean).map((note) => element("div", { class: "note" }, note)),
    connection.evidence.length > 0 && evidence,
  ];
}

/** @param {Connection} connection */
function moment({ certain, when: since }) {
  const known = new Map([
    ["on_subscriber", "once somebody subscribes"],
    ["on_message", "once a message has come"],
    ["condition", "under a condition"],
  ]);
  return known.get(since) ?? (certain ? "" : "perhaps: it is not certain that it does");
}

/**
 * A button that draws one container alone.
 *
 * @param {Page} page
 * @param {string} id
 * @param {string} label
 */
export function focusButton({ store }, id, label) {
  const focused = store.get().focus === id;
  return button(focused ? "Leave focus" : label, () => store.set({ focus: focused ? null : id }), { "aria-pressed": String(focused) });
}

/** @param {Page} page @param {string} id */
export function hideButton({ store }, id) {
  const hidden = store.get().hidden.has(id);
  return button(hidden ? "Show in the drawing" : "Hide in the drawing", () => store.set({ hidden: toggled(store.get().hidden, id) }));
}

/** A set with something put in, or taken out where it was in. @param {ReadonlySet<string>} those @param {string} id @returns {Set<string>} */
export function toggled(those, id) {
  const next = new Set(those);
  if (!next.delete(id)) next.add(id);
  return next;
}

/** A command to type, with what is said before it. @param {string} command @param {string} words @returns {Child[]} */
export function commandPart(command, words) {
  if (!command) return [];
  return [element("p", {}, words), element("pre", { class: "command", tabindex: 0, role: "group", "aria-label": "Command" }, command)];
}
