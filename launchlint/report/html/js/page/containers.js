/** The containers of an entry file by id, and what lies in them. */

import { containersOf, inTray, trayId, trayOf } from "../drawing/index.js";

/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../drawing/types").Group} Group */
/** @typedef {import("../drawing/types").Grouping} Grouping */

/** @type {WeakMap<Group, Map<string, Group>>} */
const known = new WeakMap();

/**
 * A container; undefined where the entry has none of this id.
 *
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @param {string} id
 */
export function containerOf(entry, grouping, id) {
  if (id === trayId(grouping)) return inTray(entry).length ? trayOf(grouping, inTray(entry)) : undefined;
  const root = containersOf(entry, grouping);
  let all = known.get(root);
  if (!all) {
    all = new Map();
    const waiting = [root];
    for (let each = waiting.pop(); each; each = waiting.pop()) {
      all.set(each.id, each);
      waiting.push(...each.groups);
    }
    known.set(root, all);
  }
  return all.get(id);
}

/** All of a container's name: of a namespace, where it begins at the root. @param {Group} group */
export function fullName({ kind, title, namespace }) {
  return kind === "namespace" ? namespace : title;
}

/**
 * The nodes in a container and below it.
 *
 * @param {Group} group
 * @returns {number[]}
 */
export function nodesWithin(group) {
  const found = [];
  const waiting = [group];
  for (let each = waiting.pop(); each; each = waiting.pop()) {
    found.push(...each.nodes);
    waiting.push(...[...each.groups].reverse());
  }
  return found;
}

/**
 * The findings in a container and below it, each once: those of its nodes, and those that stand between them.
 *
 * @param {Entry} entry
 * @param {Group} group
 */
export function findingsWithin(entry, group) {
  const found = new Set(nodesWithin(group).flatMap((node) => entry.nodes[node]?.findings ?? []));
  const waiting = [group];
  for (let each = waiting.pop(); each; each = waiting.pop()) {
    for (const finding of each.own) found.add(finding);
    waiting.push(...each.groups);
  }
  return [...found].sort((one, other) => one - other);
}

/**
 * The containers in which a finding stands that is in none of their nodes.
 *
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @param {number} finding
 */
export function containersWith(entry, grouping, finding) {
  const found = [];
  const waiting = [containersOf(entry, grouping)];
  for (let each = waiting.pop(); each; each = waiting.pop()) {
    if (each.own.includes(finding)) found.push(each);
    waiting.push(...each.groups);
  }
  return found;
}

/**
 * The containers around a node, outermost first, without the outermost one of all.
 *
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @param {number} node
 * @returns {Group[]}
 */
export function around(entry, grouping, node) {
  /** @type {Group[]} */
  const path = [];
  /** @param {Group} group @returns {boolean} */
  const search = (group) => {
    if (group.nodes.includes(node)) return true;
    const inner = group.groups.find(search);
    if (inner) path.unshift(inner);
    return inner !== undefined;
  };
  search(containersOf(entry, grouping));
  return path;
}

/**
 * The ids of the containers around one.
 *
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @param {string} id
 */
export function outside(entry, grouping, id) {
  const found = [];
  const outermost = containersOf(entry, grouping).id;
  for (let group = containerOf(entry, grouping, id); group?.parent && group.parent !== outermost; group = containerOf(entry, grouping, group.parent)) found.push(group.parent);
  return found;
}
