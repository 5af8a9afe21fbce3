/** What the drawing shows as plain boxes and arrows, for other formats. */

import { containersOf } from "../drawing/index.js";
import { endsAt } from "./changes.js";
import { fullName } from "./containers.js";
import { isIn } from "./model.js";
import { notice, number } from "./wording.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../data").Channel} Channel */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("../drawing/types").Group} Group */

/**
 * `kind` is container (open), folded, node, topic, service or action; `parent` the id of the container around it, empty for none. `verdict` says
 * why roslaunch does not load all that is drawn; empty where it does.
 *
 * @typedef {{ id: string, parent: string, kind: string, label: string, detail: string, unknown: boolean, conditional: boolean, mark: string }} Box
 * @typedef {{ from: string, to: string, kind: Channel["kind"], names: string[], conditional: boolean, mark: string }} Arrow
 * @typedef {{ title: string, verdict: string, boxes: Box[], arrows: Arrow[] }} Picture
 */

/** @type {ReadonlyMap<Channel["kind"], "topics" | "services" | "actions">} */
const LAYER_OF = new Map([
  ["topic", "topics"],
  ["service", "services"],
  ["action", "actions"],
]);

/** @param {Page} page @returns {Picture} */
export function pictureOf(page) {
  const state = page.store.get();
  const model = page.model.entry(state.entry);
  const boxes = boxesOf(page, model.entry, state);
  const drawn = new Set(boxes.map((each) => each.id));
  /** @type {Map<string, Arrow>} */
  const arrows = new Map();
  for (const [at, channel] of model.entry.channels.entries()) {
    if (!isShown(page, state, channel, at)) continue;
    const ends = endsAt(model, at).flatMap(({ end, mark }) => (isIn(end, state.configuration) ? [{ ...end, mark: mark ?? "" }] : []));
    const givers = sides(
      page,
      ends.filter((each) => givesData(channel, each)),
      drawn,
    );
    const takers = sides(
      page,
      ends.filter((each) => !givesData(channel, each)),
      drawn,
    );
    if (givers.size === 0 && takers.size === 0) continue;
    const alone = givers.size === 0 || takers.size === 0;
    if (alone ? state.danglingOnly : state.topicsAsNodes || (givers.size > 1 && takers.size > 1)) {
      const id = `c:${at}`;
      boxes.push({
        id,
        parent: "",
        kind: channel.kind,
        label: channel.name,
        detail: channel.types.join(", "),
        unknown: false,
        conditional: false,
        mark: channel.mark ?? "",
      });
      for (const [from, end] of givers) draw(arrows, from, id, channel.kind, "", end);
      for (const [to, end] of takers) draw(arrows, id, to, channel.kind, "", end);
    } else {
      for (const [from, giver] of givers)
        for (const [to, taker] of takers) if (from !== to && meet(giver, taker)) draw(arrows, from, to, channel.kind, channel.name, both(giver, taker));
    }
  }
  return { title: page.model.data.files[model.entry.file] ?? "", verdict: notice(model.entry), boxes, arrows: [...arrows.values()] };
}

/** Data flows from publishers, and from clients to servers. @param {Channel} channel @param {{ offers: boolean }} end */
const givesData = ({ kind }, end) => (kind === "topic") === end.offers;

/** @param {Page} page @param {PageState} state @param {Channel} channel @param {number} at */
function isShown({ drawing }, state, channel, at) {
  if (channel.plumbing || (channel.hub && !state.hubs)) return false;
  if (state.danglingOnly || state.findingsOnly) return drawing.isDrawn({ kind: "channel", id: `c:${at}` });
  return state.layers[LAYER_OF.get(channel.kind) ?? "topics"];
}

/** @param {Page} page @param {Entry} entry @param {PageState} state */
function boxesOf({ drawing }, entry, state) {
  /** @type {Box[]} */
  const boxes = [];
  const open = drawing.expanded();
  /** @param {Group} group @param {string} parent */
  const walk = (group, parent) => {
    const isOpen = group.kind === "root" || open.has(group.id);
    const box = { id: group.id, parent, label: fullName(group), unknown: false, conditional: false, mark: "" };
    if (!drawing.isDrawn({ kind: "container", id: group.id }) && group.kind !== "root") {
      for (const each of group.groups) walk(each, parent);
      return;
    }
    if (!isOpen) boxes.push({ ...box, kind: "folded", detail: number(group.count, "node") });
    if (!isOpen) return;
    const inner = group.kind === "root" ? "" : group.id;
    if (inner) boxes.push({ ...box, kind: "container", detail: "" });
    for (const each of group.groups) walk(each, inner);
    for (const index of group.nodes) {
      const node = entry.nodes[index];
      if (!node || !drawing.isDrawn({ kind: "node", id: `n:${index}` })) continue;
      const conditional = node.only.length > 0 || node.conditions.length > 0;
      boxes.push({
        id: `n:${index}`,
        parent: inner,
        kind: "node",
        label: node.name,
        detail: node.program,
        unknown: node.knowledge === "unknown",
        conditional,
        mark: node.mark ?? "",
      });
    }
  };
  walk(containersOf(entry, state.grouping), "");
  return boxes;
}

/** @typedef {{ conditional: boolean, mark: string }} End */

/** The boxes at one side of a channel. @param {Page} page @param {(Omit<Connection, "mark"> & { mark: string })[]} ends @param {ReadonlySet<string>} drawn @returns {Map<string, End>} */
function sides({ drawing }, ends, drawn) {
  const found = new Map();
  for (const end of ends) {
    const box = drawing.standsFor(end.node);
    if (box !== null && drawn.has(box) && !found.has(box)) found.set(box, { conditional: !end.certain || end.only.length > 0, mark: end.mark });
  }
  return found;
}

/** @param {End} one @param {End} other @returns {End} */
const both = (one, other) => ({ conditional: one.conditional || other.conditional, mark: one.mark || other.mark });

/** Whether both are there in one of the two states that are compared. @param {End} one @param {End} other */
const meet = (one, other) => one.mark === other.mark || ![one.mark, other.mark].every((mark) => mark === "added" || mark === "removed");

/** @param {Map<string, Arrow>} arrows @param {string} from @param {string} to @param {Channel["kind"]} kind @param {string} name @param {End} end */
function draw(arrows, from, to, kind, name, end) {
  const key = `${from}\n${to}\n${kind}\n${end.mark}`;
  const known = arrows.get(key);
  if (!known) arrows.set(key, { from, to, kind, names: name ? [name] : [], ...end });
  else {
    if (name) known.names.push(name);
    known.conditional &&= end.conditional;
  }
}
