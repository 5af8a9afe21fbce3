// Which containers are open at first: as many as can still be read.

import { containersOf } from "./tree.js";

/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").Grouping} Grouping */

/** Pixels that a box needs with its surroundings, at the smallest scale at which its name can be read. */
const SPACE = 230 * 120 * 0.65 ** 2;
const FEWEST = 12;
/** Boxes that are drawn at first, on whatever screen. */
export const MOST = 90;

/**
 * The largest expansion that is expected to be legible: outer containers first, small ones first.
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @param {number} width of the viewport, in pixels
 * @param {number} height
 * @returns {Set<string>} ids of the open containers
 */
export function autoExpansion(entry, grouping, width, height) {
  return new Set(opening(containersOf(entry, grouping), boxesIn(width, height)));
}

/** @param {number} width @param {number} height */
export function boxesIn(width, height) {
  return Math.max(FEWEST, Math.min(MOST, Math.floor((width * height) / SPACE)));
}

/**
 * The containers that can be opened with at most `most` boxes, in the order of opening.
 * @param {Group} root
 * @param {number} most
 * @param {(group: Group) => boolean} [isShown]
 * @returns {string[]}
 */
export function opening(root, most, isShown = () => true) {
  /** @param {Group} group */
  const cost = (group) => group.nodes.length + group.groups.length;
  /** @type {string[]} */
  const opened = [];
  let left = most - cost(root);
  let level = root.groups;
  while (level.length) {
    /** @type {Group[]} */
    const next = [];
    for (const each of level.filter(isShown).sort((a, b) => cost(a) - cost(b))) {
      if (cost(each) - 1 > left) continue;
      left -= cost(each) - 1;
      opened.push(each.id);
      next.push(...each.groups);
    }
    level = next;
  }
  return opened;
}
