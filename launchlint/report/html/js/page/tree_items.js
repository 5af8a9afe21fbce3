/** The items of the tree: containers and nodes with their counts, finding badges and hide buttons. */

import { element } from "./elements.js";
import { findingsWithin, fullName } from "./containers.js";
import { lastPart } from "./wording.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../drawing/types").Group} Group */

/**
 * One line of the tree: `row` is what is seen of it, `host` what also holds the lines below it. `group` is what it opens; null for a node.
 *
 * @typedef {object} Item
 * @property {string} id
 * @property {HTMLLIElement} host
 * @property {HTMLDivElement} row
 * @property {HTMLButtonElement} hide
 * @property {Group | null} group
 */

const SEVERITIES = /** @type {const} */ (["error", "warning", "info"]);

/**
 * @param {Model} model
 * @param {Entry} entry
 * @param {Group} group
 * @param {number} level from 1
 * @returns {Item}
 */
export function groupItem(model, entry, group, level) {
  const findings = findingsWithin(entry, group);
  const count = element("span", { class: "count" }, ` ${group.count}`, told(group.count === 1 ? " node" : " nodes"));
  return item(model, {
    id: group.id,
    label: group.label,
    title: fullName(group),
    classes: `group ${group.kind}`,
    level,
    findings,
    more: count,
    group,
  });
}

/**
 * @param {Model} model
 * @param {Entry} entry
 * @param {number} node
 * @param {number} level
 * @param {string} namespace that its name is shortened by
 * @returns {Item | null}
 */
export function nodeItem(model, entry, node, level, namespace) {
  const data = entry.nodes[node];
  if (!data) return null;
  const label =
    namespace && data.name.startsWith(`${namespace}/`)
      ? data.name.slice(namespace.length + 1)
      : namespace === "/"
        ? data.name.slice(1)
        : lastPart(data.name);
  const unknown = data.knowledge === "unknown";
  const classes = ["node", unknown && "unknown", (data.only.length > 0 || data.conditions.length > 0) && "conditional", data.mark]
    .filter(Boolean)
    .join(" ");
  const state = [unknown && "not known", data.mark].filter(Boolean).join(", ");
  const more = state ? told(` ${state}`) : null;
  return item(model, { id: `n:${node}`, label, title: data.name, classes, level, findings: data.findings, more, group: null });
}

/**
 * @typedef {object} Parts
 * @property {string} id
 * @property {string} label
 * @property {string} title
 * @property {string} classes
 * @property {number} level
 * @property {number[]} findings
 * @property {HTMLElement | null} more
 * @property {Group | null} group
 */

/** @param {Model} model @param {Parts} parts @returns {Item} */
function item(model, { id, label, title, classes, level, findings, more, group }) {
  const all = [...new Set(findings)];
  const worst = SEVERITIES.find((severity) => all.some((each) => model.data.findings[each]?.severity === severity));
  const badge = worst && element("span", { class: `badge ${worst}` }, ` ${all.length}`, told(all.length === 1 ? " finding" : " findings"));
  // Without a mouse it is the key h, or the panel's button: within an item of a tree nothing else can have the focus.
  const hide = element("button", {
    type: "button",
    class: "hide",
    tabindex: -1,
    "aria-hidden": "true",
    "aria-pressed": "false",
    title: "Hide in the drawing (h)",
  });
  const row = element(
    "div",
    {
      class: `row ${classes}`,
      role: "treeitem",
      tabindex: -1,
      "aria-level": level,
      "aria-selected": "false",
      "aria-expanded": group ? "false" : null,
      "data-id": id,
    },
    element("span", { class: group ? "twisty" : "dot", "aria-hidden": "true" }),
    element("span", { class: "label", title }, label),
    badge,
    more,
    hide,
  );
  return { id, host: element("li", { role: "none" }, row), row, hide, group };
}

/** Words that complete what is seen, for those who hear it. @param {string} words */
function told(words) {
  return element("span", { class: "visually-hidden" }, words);
}
