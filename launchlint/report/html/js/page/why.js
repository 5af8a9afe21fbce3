/** Why one node hears another, or does not: the path between them, or the names that nearly meet and what keeps them apart. */

import { clashOf } from "../drawing/qos.js";
import { isIn } from "./model.js";

/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("../data").Connection} Connection */

/** One step of a path: a node gives something that the next takes. @typedef {{ from: number, channel: number, to: number }} Step */

/**
 * Two connections that could be one: `apart` says in a sentence why they are not, `edit` what would join them.
 *
 * @typedef {{ giver: Connection, taker: Connection, apart: string, edit: string }} Near
 */

const MOST = 3;
/** The least likeness at which two names are shown beside each other. */
const LIKE = 0.45;

/** Data goes from publishers to subscribers, and from clients to servers. @param {EntryModel} model @param {Connection} each */
const gives = (model, each) => (model.entry.channels[each.channel]?.kind === "topic") === each.offers;

/**
 * The shortest way that data takes from a node to another; null where there is none.
 *
 * @param {EntryModel} model
 * @param {number} from
 * @param {number} to
 * @param {number} configuration
 * @returns {Step[] | null}
 */
export function pathBetween(model, from, to, configuration) {
  /** @type {Map<number, Step | null>} */
  const reached = new Map([[from, null]]);
  const waiting = [from];
  for (const node of waiting) {
    if (node === to && node !== from) break;
    for (const out of ends(model, node, configuration).filter((each) => gives(model, each))) {
      // Messages go on from node to node; a call ends where it is served.
      const isTopic = model.entry.channels[out.channel]?.kind === "topic";
      for (const into of model.onChannel[out.channel] ?? []) {
        if (gives(model, into) || !isThere(model, into, configuration) || !meet(out, into) || reached.has(into.node)) continue;
        if (!isTopic && (node !== from || into.node !== to)) continue;
        reached.set(into.node, { from: node, channel: out.channel, to: into.node });
        waiting.push(into.node);
      }
    }
  }
  if (!reached.has(to) || from === to) return null;
  /** @type {Step[]} */
  const steps = [];
  for (let step = reached.get(to); step; step = reached.get(step.from)) steps.unshift(step);
  return steps;
}

/**
 * What a node could give and another take, and does not: the likeliest pairs of names, what parts them, and what joins them.
 *
 * @param {EntryModel} model
 * @param {number} from
 * @param {number} to
 * @param {(place: import("../data").Place) => string} written
 * @returns {Near[]}
 */
export function nearMisses(model, from, to, written) {
  const out = ends(model, from, -1).filter((each) => gives(model, each));
  const into = ends(model, to, -1).filter((each) => !gives(model, each));
  const found = out.flatMap((giver) =>
    into.flatMap((taker) => {
      const [one, other] = [model.entry.channels[giver.channel], model.entry.channels[taker.channel]];
      if (!one || !other || one.kind !== other.kind) return [];
      const score = likeness(giver, taker, one.name, other.name);
      return score >= LIKE ? [{ giver, taker, score }] : [];
    }),
  );
  found.sort((one, other) => other.score - one.score);
  return found.slice(0, MOST).map(({ giver, taker }) => ({ giver, taker, ...verdict(model, giver, taker, written) }));
}

/** @param {EntryModel} model @param {number} node @param {number} configuration */
function ends(model, node, configuration) {
  return (model.ofNode[node] ?? []).filter((each) => {
    const { hub = true, plumbing = true } = model.entry.channels[each.channel] ?? {};
    return !hub && !plumbing && isThere(model, each, configuration);
  });
}

/** @param {EntryModel} model @param {Connection} each @param {number} configuration */
function isThere(model, each, configuration) {
  return each.mark !== "removed" && isIn(each, configuration) && isIn(model.entry.nodes[each.node] ?? { only: [] }, configuration);
}

/** Whether two are ever there together. @param {{ only: number[] }} one @param {{ only: number[] }} other */
function meet(one, other) {
  return one.only.length === 0 || other.only.length === 0 || one.only.some((each) => other.only.includes(each));
}

/** From 0 to 1. @param {Connection} giver @param {Connection} taker @param {string} one @param {string} other */
function likeness(giver, taker, one, other) {
  if (one === other) return 1;
  const sameType = giver.type !== "" && giver.type === taker.type;
  if (giver.type && taker.type && !sameType) return tail(one) === tail(other) ? 0.5 : 0;
  if (tail(one) === tail(other)) return sameType ? 0.95 : 0.8;
  if (bare(giver.declared) === bare(taker.declared)) return sameType ? 0.9 : 0.7;
  return (sameType ? 0.45 : 0) + 0.45 * shared(tail(one), tail(other));
}

/** The last part of a name. @param {string} name */
const tail = (name) => name.slice(name.lastIndexOf("/") + 1);
/** @param {string} declared */
const bare = (declared) => tail(declared.replace(/^~/, ""));

/** How much of two words is the same: pairs of letters. @param {string} one @param {string} other */
function shared(one, other) {
  const pairs = (/** @type {string} */ word) => new Set(Array.from({ length: Math.max(0, word.length - 1) }, (_, at) => word.slice(at, at + 2).toLowerCase()));
  const [left, right] = [pairs(one), pairs(other)];
  const both = [...left].filter((each) => right.has(each)).length;
  return left.size + right.size ? (2 * both) / (left.size + right.size) : 0;
}

/**
 * @param {EntryModel} model
 * @param {Connection} giver
 * @param {Connection} taker
 * @param {(place: import("../data").Place) => string} written
 */
function verdict(model, giver, taker, written) {
  const name = (/** @type {Connection} */ each) => model.entry.channels[each.channel]?.name ?? "";
  const node = (/** @type {Connection} */ each) => model.entry.nodes[each.node]?.name ?? "";
  if (name(giver) !== name(taker)) return { apart: `The names part at ${parting(name(giver), name(taker))}${cause(model, giver, taker, written)}.`, edit: remap(model, taker, name(giver), written) };
  if (giver.type && taker.type && giver.type !== taker.type) {
    return { apart: `One name, two types: ${node(giver)} has ${giver.type}, ${node(taker)} wants ${taker.type}.`, edit: "Let both use one type: ROS does not connect them." };
  }
  const clash = clashOf(giver.qos ?? "", taker.qos ?? "");
  if (clash) return { apart: `One name, and their QoS does not fit: ${clash[0]} is offered, ${clash[1]} is asked for.`, edit: "Let what is offered be at least what is asked for." };
  const [one, other] = [model.entry.nodes[giver.node], model.entry.nodes[taker.node]];
  const never = !meet(giver, taker) || (one && other && !meet(one, other));
  if (never) {
    const when = (/** @type {typeof one} */ each) => each?.conditions.join(" and ") || "some configurations";
    return { apart: `They are never there together: ${node(giver)} only where ${when(one)}, ${node(taker)} only where ${when(other)}.`, edit: "Start both under one condition." };
  }
  return { apart: "They are connected, yet not in the configuration that is shown.", edit: "Choose a configuration in which both are there." };
}

/** "/robot | /", the first part of two names that differs. @param {string} one @param {string} other */
function parting(one, other) {
  const [left, right] = [one.split("/"), other.split("/")];
  const at = left.findIndex((part, index) => part !== right[index]);
  const from = at < 0 ? left.length : at;
  const rest = (/** @type {string[]} */ parts) => parts.slice(from).join("/") || "its end";
  const before = left.slice(0, from).join("/");
  return `${before ? `${before}/` : "/"}: “${rest(left)}” there, “${rest(right)}” here`;
}

/** Which step of making the names parts them. @param {EntryModel} model @param {Connection} giver @param {Connection} taker @param {(place: import("../data").Place) => string} written */
function cause(model, giver, taker, written) {
  if (giver.unremapped === taker.unremapped) {
    const step = [...giver.remaps, ...taker.remaps].find(([from, to]) => from !== to);
    return step ? `: before remaps both are ${giver.unremapped}, then ${step[0]} becomes ${step[1]}${step[2] ? ` in ${written(step[2])}` : ""}` : "";
  }
  if (bare(giver.declared) === bare(taker.declared)) {
    const [one, other] = [model.entry.nodes[giver.node]?.namespace ?? "", model.entry.nodes[taker.node]?.namespace ?? ""];
    if (giver.spelling === "private" || taker.spelling === "private") return ": a private name begins with the name of its node";
    if (one !== other) return `: the nodes are in different namespaces, ${one} and ${other}`;
  }
  return "";
}

/** What to write so that a connection takes a name. @param {EntryModel} model @param {Connection} taker @param {string} name @param {(place: import("../data").Place) => string} written */
function remap(model, taker, name, written) {
  const own = [...taker.remaps].reverse().find(([from, to, place]) => from !== to && place);
  if (own?.[2]) return `In ${written(own[2])} let the remap lead to ${name} instead of ${own[1]}.`;
  const node = model.entry.nodes[taker.node];
  const place = node?.place;
  const where = place ? written(place) : "its element";
  const file = where.replace(/:\d+$/, "");
  const line = file.endsWith(".py") ? `remappings=[("${taker.declared}", "${name}")]` : /\.ya?ml$/.test(file) ? `remap: [{from: "${taker.declared}", to: "${name}"}]` : `<remap from="${taker.declared}" to="${name}"/>`;
  return `At ${where}, in ${node?.name ?? "the node"}: ${line}`;
}
