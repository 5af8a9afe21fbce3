// What of an entry is drawn: its nodes and wires after the chooser of the configuration, layers, filters, hiding and focus.

import { Presence } from "./presence.js";
import { fitsType, fittingNodes, termsOf } from "./filter.js";
import { ranksOf } from "./order.js";
import { inTray, trayId, withTray } from "./tray.js";
import { containersOf, walk } from "./tree.js";

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../data").Mark} Mark */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").ViewState} ViewState */
/** @typedef {import("./model").End} End */
/** @typedef {import("./model").Loose} Loose */
/** @typedef {import("./model").View} View */
/** @typedef {import("./model").Wire} Wire */

/** A param with more readers is drawn with the hub topics only. */
const MANY_READERS = 12;

/**
 * @param {ReportData} data
 * @param {ViewState} state
 * @returns {View}
 */
export function viewOf(data, state) {
  const entry = data.entries[state.entry];
  if (!entry) throw new RangeError(`there is no entry ${state.entry}`);
  const presence = new Presence(entry.configurations.length, data.base !== null);
  const now = presence.at(state.configuration);
  const whole = containersOf(entry, state.grouping);
  const tray = state.focus === null && !state.danglingOnly ? inTray(entry) : [];
  const tree = tray.length ? withTray(whole, state.grouping, tray) : whole;
  const groups = new Map(Array.from(walk(tree), (each) => [each.id, each]));
  /** @type {Map<number, Group>} */
  const home = new Map();
  for (const group of groups.values()) for (const node of group.nodes) home.set(node, group);

  const exists = Uint8Array.from(entry.nodes, (node) => Number(!node.absent && presence.meet(presence.of(node.only, node.mark), now)));
  const all = wiresOf(entry, state, presence, now, exists);
  const shown = Uint8Array.from(exists);
  for (const node of hiddenNodes(state, whole)) shown[node] = 0;
  if (!state.tray || state.hidden.has(trayId(state.grouping))) for (const node of tray) shown[node] = 0;
  const loose = looseEnds(all, presence);
  if (state.danglingOnly) shown.forEach((_, node) => loose.has(node) || (shown[node] = 0));
  if (state.findingsOnly) keepFindings(entry, all, shown);
  const terms = termsOf(state.filter);
  if (terms.length) fittingNodes(entry, terms).forEach((fits, node) => fits || (shown[node] = 0));

  let root = tree;
  /** @type {Set<string>} */
  const stubs = new Set();
  const focus = state.focus === null ? undefined : groups.get(state.focus);
  if (focus && focus !== tree) {
    keepAround(focus, all, shown);
    root = surroundings(focus, groups, stubs);
    for (const node of root.nodes) home.set(node, root);
    groups.set(root.id, root);
  }

  const params = state.layers.params ? ownParams(entry, presence, now, shown) : new Map();
  const counts = new Map();
  count(root, shown, counts);
  const wires = state.danglingOnly ? [] : all.filter((wire) => fitsType(terms, wire.types)).map((wire) => within(wire, shown)).filter((wire) => wire.givers.length + wire.takers.length > 1);
  if (state.topicsAsNodes) {
    wires.length = 0;
    for (const wire of all) {
      const kept = within(wire, shown);
      if (kept.givers.length + kept.takers.length > 0) wires.push({ ...kept, pilled: true, always: true });
    }
    loose.clear();
  }
  const touched = new Set(entry.connections.filter((each) => each.mark).map((each) => each.node));
  return { entry, state, findings: data.findings, presence, now, root, groups, shown, counts, home, wires, loose, params, stubs, touched, ranks: ranksOf(entry), machines: new Set(entry.nodes.map((node) => node.machine.join(" "))).size };
}

/** @param {ViewState} state @param {Group} tree */
function* hiddenNodes({ hidden }, tree) {
  for (const id of hidden) if (id.startsWith("n:")) yield Number(id.slice(2));
  if (hidden.size) for (const group of walk(tree)) if (hidden.has(group.id)) for (const each of walk(group)) yield* each.nodes;
}

/**
 * @param {Entry} entry
 * @param {ViewState} state
 * @param {Presence} presence
 * @param {number} now
 * @param {Uint8Array} exists
 * @returns {Wire[]}
 */
function wiresOf(entry, state, presence, now, exists) {
  const layers = { topic: state.layers.topics, service: state.layers.services, action: state.layers.actions };
  /** @type {(Wire | null)[]} */
  const wires = entry.channels.map((channel, index) => {
    if (!layers[channel.kind] || channel.plumbing || (channel.hub && !state.hubs)) return null;
    const { kind, name, types, findings } = channel;
    /** @type {Mark | ""} */
    const mark = channel.mark ?? "";
    return { id: `c:${index}`, kind, name, types, findings, mark, may: channel.may, givers: [], takers: [], pilled: false, always: false };
  });
  for (const each of entry.connections) {
    const wire = wires[each.channel];
    const node = entry.nodes[each.node];
    if (!wire || !node || !exists[each.node]) continue;
    const when = presence.both(presence.both(presence.of(each.only, each.mark), presence.of(node.only, node.mark)), now);
    if (!presence.meet(when, now)) continue;
    const ends = each.offers === (wire.kind === "topic") ? wire.givers : wire.takers;
    const known = ends.find((end) => end.node === each.node);
    if (known) {
      known.when = presence.either(known.when, when);
      known.certain ||= each.certain;
    } else ends.push({ node: each.node, when, certain: each.certain, changed: each.mark === "changed", qos: each.qos });
  }
  /** @type {Wire[]} */
  const found = [];
  for (const wire of wires) {
    if (!wire || !(wire.givers.length + wire.takers.length)) continue;
    // Whoever is at a pill is connected with all at its other side: so they have to exist together.
    const together = moments(wire.givers).every((one) => moments(wire.takers).every((other) => presence.meet(one, other)));
    wire.pilled = wire.givers.length > 1 && wire.takers.length > 1 && together;
    found.push(wire);
  }
  if (state.layers.params) found.push(...sharedParams(entry, state, presence, now, exists));
  return found;
}

/**
 * Params that several nodes read: each is a pill with a line to each of them.
 * @param {Entry} entry
 * @param {ViewState} state
 * @param {Presence} presence
 * @param {number} now
 * @param {Uint8Array} exists
 * @returns {Wire[]}
 */
function sharedParams(entry, state, presence, now, exists) {
  /** @type {Wire[]} */
  const found = [];
  entry.params.forEach((param, index) => {
    const when = presence.both(presence.of(param.only, param.mark), now);
    const readers = Array.from(new Set(param.readers)).filter((each) => exists[each]);
    if (readers.length < 2 || !presence.meet(when, now) || (readers.length > MANY_READERS && !state.hubs)) return;
    const takers = readers.map((node) => ({ node, when, certain: true, changed: param.mark === "changed" }));
    const { name, findings, mark = "" } = param;
    found.push({ id: `p:${index}`, kind: "param", name, types: [], givers: [], takers, pilled: true, always: true, findings, mark });
  });
  return found;
}

/** @param {Entry} entry @param {Presence} presence @param {number} now @param {Uint8Array} shown */
function ownParams(entry, presence, now, shown) {
  /** @type {Map<number, number>} */
  const counts = new Map();
  for (const param of entry.params) {
    const reader = param.readers[0];
    if (reader === undefined || !shown[reader] || param.readers.some((each) => each !== reader)) continue;
    if (presence.meet(presence.of(param.only, param.mark), now)) counts.set(reader, (counts.get(reader) ?? 0) + 1);
  }
  return counts;
}

/**
 * What a node has that nobody else in the system shares, whether the others are drawn or not.
 * @param {Wire[]} wires
 * @param {Presence} presence
 */
function looseEnds(wires, presence) {
  /** @type {Map<number, Loose[]>} */
  const found = new Map();
  for (const wire of wires) {
    if (wire.kind === "param") continue;
    for (const gives of [true, false]) {
      const others = moments(gives ? wire.takers : wire.givers);
      for (const end of gives ? wire.givers : wire.takers) {
        if (others.some((when) => presence.meet(when, end.when))) continue;
        const own = found.get(end.node);
        /** @type {Loose} */
        const loose = { wire, gives, certain: end.certain, mark: presence.mark(end.when) || (end.changed ? "changed" : "") };
        if (own) own.push(loose);
        else found.set(end.node, [loose]);
      }
    }
  }
  return found;
}

/** @param {End[]} ends */
function moments(ends) {
  return Array.from(new Set(ends.map((end) => end.when)));
}

/** @param {Entry} entry @param {Wire[]} wires @param {Uint8Array} shown */
function keepFindings(entry, wires, shown) {
  /** @type {Set<number>} */
  const kept = new Set();
  entry.nodes.forEach((node, index) => node.findings.length && kept.add(index));
  for (const wire of wires) if (wire.findings.length) for (const end of [...wire.givers, ...wire.takers]) kept.add(end.node);
  shown.forEach((_, node) => kept.has(node) || (shown[node] = 0));
}

/** @param {Group} focus @param {Wire[]} wires @param {Uint8Array} shown */
function keepAround(focus, wires, shown) {
  const inside = new Set(Array.from(walk(focus), (each) => each.nodes).flat());
  const kept = new Set(inside);
  for (const { givers, takers } of wires) {
    if (givers.some((end) => inside.has(end.node))) for (const end of takers) kept.add(end.node);
    if (takers.some((end) => inside.has(end.node))) for (const end of givers) kept.add(end.node);
  }
  shown.forEach((_, node) => kept.has(node) || (shown[node] = 0));
}

/**
 * A tree in which the focus stands beside what is around it, instead of within.
 * @param {Group} focus
 * @param {Map<string, Group>} groups
 * @param {Set<string>} stubs filled with the ids of what is around
 * @returns {Group}
 */
function surroundings(focus, groups, stubs) {
  /** @type {Group} */
  const root = { ...focus, id: `${focus.id}~`, kind: "root", namespace: "", groups: [focus], nodes: [], parent: "" };
  let inner = focus;
  for (let around = groups.get(inner.parent); around; around = groups.get(inner.parent)) {
    for (const each of around.groups) {
      if (each === inner) continue;
      root.groups.push(each);
      stubs.add(each.id);
    }
    for (const node of around.nodes) {
      root.nodes.push(node);
      stubs.add(`n:${node}`);
    }
    inner = around;
  }
  return root;
}

/** @param {Group} group @param {Uint8Array} shown @param {Map<string, number>} counts @returns {number} */
function count(group, shown, counts) {
  let total = 0;
  for (const node of group.nodes) total += shown[node] ? 1 : 0;
  for (const each of group.groups) total += count(each, shown, counts);
  counts.set(group.id, total);
  return total;
}

/** @param {Wire} wire @param {Uint8Array} shown @returns {Wire} */
function within(wire, shown) {
  /** @param {End} end */
  const isShown = (end) => shown[end.node] === 1;
  if (wire.givers.every(isShown) && wire.takers.every(isShown)) return wire;
  return { ...wire, givers: wire.givers.filter(isShown), takers: wire.takers.filter(isShown) };
}
