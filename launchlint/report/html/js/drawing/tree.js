// The containers around the nodes of an entry: by namespace, by the elements of its launch files, by package, or by machine.

import { compareNames, counted, cut, lastPart, machineName } from "./names.js";

/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").Grouping} Grouping */

/** Levels of nesting that are told apart, counted from outside. */
const DEEPEST = 32;
/** More siblings than this are put into ranges, so that they can be read and laid out. */
const MOST = 40;
/** More includes than this do not fit beside each other with the lines between them. */
const FEW = 20;
/** Members of a range; of one of includes, so that one of them can be opened. */
const [RANGE, SMALL] = [12, 6];
const RANGES = 24;
/** Longest name at an end of a range, in characters. */
const SHORT = 20;

/** @type {WeakMap<Entry, Map<Grouping, Group>>} */
const made = new WeakMap();

/**
 * The tree of containers around the nodes of an entry. Those without nodes are left out; one that holds nothing but another one is joined with it.
 * @param {Entry} entry
 * @param {Grouping} grouping
 * @returns {Group} the outermost
 */
export function containersOf(entry, grouping) {
  let trees = made.get(entry);
  if (!trees) made.set(entry, (trees = new Map()));
  let root = trees.get(grouping);
  if (!root) {
    root = MAKERS[grouping](entry);
    finish(root, entry);
    trees.set(grouping, root);
  }
  return root;
}

/**
 * All containers of a tree, outer ones first.
 * @param {Group} root
 * @returns {Generator<Group>}
 */
export function* walk(root) {
  yield root;
  for (const each of root.groups) yield* walk(each);
}

/**
 * @param {Group["kind"]} kind
 * @param {string} id
 * @param {string} label
 * @param {string} [namespace]
 * @param {number} [container]
 * @returns {Group}
 */
function group(kind, id, label, namespace = "", container = -1) {
  return { id, kind, label, title: label, namespace, container, own: [], groups: [], nodes: [], count: 0, parent: "" };
}

/** @param {Entry} entry */
function byNamespace(entry) {
  const root = group("root", "g:namespace:/", "/", "/");
  /** @type {Map<string, Group>} */
  const known = new Map();
  entry.nodes.forEach((node, index) => {
    let around = root;
    let from = 1;
    for (let depth = 1; node.namespace.length > from && from > 0; depth++) {
      const end = depth < DEEPEST ? node.namespace.indexOf("/", from) : -1;
      const namespace = end < 0 ? node.namespace : node.namespace.slice(0, end);
      let inner = known.get(namespace);
      if (!inner) {
        const label = around === root ? namespace : namespace.slice(around.namespace.length + 1);
        inner = group("namespace", `g:namespace:${namespace}`, label, namespace);
        known.set(namespace, inner);
        around.groups.push(inner);
      }
      around = inner;
      from = end + 1;
    }
    around.nodes.push(index);
  });
  return root;
}

/** @param {Entry} entry */
function byElement(entry) {
  const root = group("root", "g:file:", "/", "/");
  /** @type {{ group: Group, depth: number }[]} */
  const all = [];
  const outermost = { group: root, depth: 0 };
  /** @param {number} index */
  const find = (index) => all[index] ?? outermost;
  entry.containers.forEach((container, index) => {
    const around = container.parent < index ? find(container.parent) : outermost;
    // A group without a namespace has nothing to be called by: what is in it belongs to what is around it.
    if (container.kind === "group" && !container.label) {
      around.group.own = [...around.group.own, ...container.findings];
      all.push(around);
      return;
    }
    const label = container.kind === "include" ? lastPart(container.label) : container.label;
    const own = group(container.kind, `g:file:${index}`, label, container.namespace, index);
    own.title = container.label;
    own.own = container.findings;
    all.push(around.depth < DEEPEST ? { group: own, depth: around.depth + 1 } : around);
    if (around.depth < DEEPEST) around.group.groups.push(own);
  });
  entry.nodes.forEach((node, index) => find(node.container).group.nodes.push(index));
  return root;
}

/**
 * @param {Entry} entry
 * @param {"package" | "machine"} kind
 * @param {(node: Entry["nodes"][number]) => [key: string, label: string]} keyOf
 */
function byKey(entry, kind, keyOf) {
  const root = group("root", `g:${kind}:`, "/", "/");
  /** @type {Map<string, Group>} */
  const known = new Map();
  entry.nodes.forEach((node, index) => {
    const [key, label] = keyOf(node);
    let around = known.get(key);
    if (!around) {
      around = group(kind, `g:${kind}:${key}`, label);
      known.set(key, around);
      root.groups.push(around);
    }
    around.nodes.push(index);
  });
  return root;
}

/** @type {Record<Grouping, (entry: Entry) => Group>} */
const MAKERS = {
  namespace: byNamespace,
  file: byElement,
  package: (entry) => byKey(entry, "package", (node) => [node.package, node.package || "no package"]),
  machine: (entry) => byKey(entry, "machine", ({ machine: [name = "", address = ""] }) => [name, name ? machineName(name, address) : "no machine named"]),
};

/**
 * Counts, drops what is empty, joins what holds only one other, orders, and puts too many siblings into ranges.
 * @param {Group} own
 * @param {Entry} entry
 */
function finish(own, entry) {
  own.groups.forEach((each) => finish(each, entry));
  // What stands in one without nodes is told at the one around it; at the outermost the list of all findings does.
  for (const each of own.groups) if (each.count === 0 && own.kind !== "root") own.own = [...own.own, ...each.own];
  own.groups = own.groups.filter((each) => each.count > 0);
  const inner = own.groups[0];
  if (own.kind !== "root" && inner && own.groups.length === 1 && !own.nodes.length) {
    const joint = own.kind === "namespace" ? "/" : " › ";
    const label = `${own.label}${joint}${inner.label}`;
    // An include stays what it is, around a group of its file.
    const { id, kind, container, title } = own.kind === "include" && inner.kind === "group" ? own : inner;
    Object.assign(own, inner, { id, kind, container, title, label, own: [...own.own, ...inner.own] });
  }
  own.nodes.sort((a, b) => compareNames(entry.nodes[a]?.name ?? "", entry.nodes[b]?.name ?? "") || a - b);
  if (own.kind === "namespace" || own.kind === "root" || own.kind === "package" || own.kind === "machine") own.groups.sort((a, b) => compareNames(a.label, b.label));
  // What came late splits nothing that was whole.
  const late = own.nodes.filter((node) => entry.nodes[node]?.late);
  own.nodes = own.nodes.filter((node) => !entry.nodes[node]?.late);
  if (own.nodes.length > MOST) byFile(own, entry);
  if (own.nodes.length > MOST) {
    const ranges = split(own.nodes).map((nodes) => {
      const label = between(nodes.map((each) => lastPart(entry.nodes[each]?.name ?? "")));
      const range = group("range", `${own.id}#n${nodes[0]}`, label, own.namespace);
      range.title = `${counted(nodes.length, "node")}: ${label}`;
      range.nodes = nodes;
      return range;
    });
    own.nodes = [];
    ranges[ranges.length - 1]?.nodes.push(...late.splice(0));
    own.groups.push(...ranges);
    ranges.forEach((each) => finish(each, entry));
  }
  own.nodes.push(...late);
  tellApart(own.groups, entry);
  const whole = own.groups.filter((each) => each.kind !== "range");
  if (whole.length > MOST) {
    const ranges = inRanges(own, whole);
    own.groups = [...ranges, ...own.groups.filter((each) => each.kind === "range")];
    ranges.forEach((each) => finish(each, entry));
  }
  own.count = own.nodes.length;
  for (const each of own.groups) {
    each.parent = own.id;
    own.count += each.count;
  }
}

/** Containers put into ranges of some. @param {Group} own what they are in @param {Group[]} groups @param {number} [size] */
function inRanges(own, groups, size) {
  return split(groups, size).map((members) => {
    const label = between(members.map((each) => each.label));
    const range = group("range", `${own.id}#${members[0]?.id}`, label, own.namespace);
    range.title = `${counted(members.length, "container")}: ${label}`;
    range.groups = members;
    return range;
  });
}

/** Includes of one file, and groups of one name, are told apart by what the names of their nodes begin with, else by their number. @param {Group[]} groups @param {Entry} entry */
function tellApart(groups, entry) {
  /** @type {Map<string, Group[]>} */
  const alike = new Map();
  for (const each of groups) alike.set(each.label, [...(alike.get(each.label) ?? []), each]);
  for (const own of alike.values()) {
    if (own.length < 2) continue;
    const told = own.map((each) => beginning(Array.from(walk(each), ({ nodes }) => nodes).flat().filter((node) => !entry.nodes[node]?.late).map((node) => entry.nodes[node]?.name ?? "")));
    const differ = new Set(told).size === own.length && !told.includes("");
    own.forEach((each, at) => (each.label = `${each.label} · ${differ ? cut(told[at] ?? "", SHORT) : at + 1}`));
  }
}

/** What names begin with, up to the end of a word. @param {string[]} names */
function beginning([first = "", ...others]) {
  let same = first.length;
  for (const other of others) while (!other.startsWith(first.slice(0, same))) same--;
  const shared = first.slice(0, same);
  return (others.every((other) => other === first) ? shared : shared.replace(/[^/_.-]*$/, "")).replace(/^[/]|[/_.-]+$/g, "");
}

/**
 * Too many nodes beside each other are put together with those that the same include starts, by itself or through others, where that makes
 * groups worth having.
 * @param {Group} own
 * @param {Entry} entry
 */
function byFile(own, entry) {
  if (own.kind === "range" || own.container >= 0) return;
  const top = group("root", own.id, "");
  /** @type {Map<number, Group>} */
  const known = new Map();
  for (const node of own.nodes) {
    let around = top;
    for (const file of includesAround(entry, node)) {
      let inner = known.get(file);
      if (!inner) {
        const path = entry.containers[file]?.label ?? "";
        inner = group("include", `${own.id}#f${file}`, lastPart(path), own.namespace, file);
        Object.assign(inner, { title: path, own: entry.containers[file]?.findings ?? [] });
        known.set(file, inner);
        around.groups.push(inner);
      }
      around = inner;
    }
    around.nodes.push(node);
  }
  thin(top);
  // What all or nearly all stands in parts nothing.
  for (let [only, other] = top.groups; only && !other; [only, other] = top.groups) {
    top.groups = only.groups;
    top.nodes.push(...only.nodes);
  }
  if (!top.groups.length || top.nodes.length + top.groups.length > MOST) return;
  top.groups.forEach((each) => finish(each, entry));
  own.nodes = own.nodes.filter((node) => top.nodes.includes(node));
  tellApart(top.groups, entry);
  const ranges = top.groups.length > FEW ? inRanges(own, top.groups, SMALL) : [];
  ranges.forEach((each) => finish(each, entry));
  own.groups.push(...(ranges.length ? ranges : top.groups));
}

/** Indexes of the includes around a node, outermost first. @param {Entry} entry @param {number} node */
function includesAround(entry, node) {
  const chain = [];
  let at = entry.nodes[node]?.container ?? -1;
  for (let seen = 0; at >= 0 && seen < DEEPEST; seen++) {
    if (entry.containers[at]?.kind === "include") chain.unshift(at);
    at = entry.containers[at]?.parent ?? -1;
  }
  return chain;
}

/** Includes of one node are no groups. @param {Group} own @returns {number} nodes in it */
function thin(own) {
  let count = own.nodes.length;
  own.groups = own.groups.filter((each) => {
    const inside = thin(each);
    count += inside;
    if (inside < 2) own.nodes.push(...each.nodes);
    return inside > 1;
  });
  return count;
}

/**
 * @template T
 * @param {T[]} members
 * @param {number} [size] of a range, at most
 * @returns {T[][]}
 */
function split(members, size = RANGE) {
  const ranges = Math.min(RANGES, Math.ceil(members.length / size));
  return Array.from({ length: ranges }, (_, at) =>
    members.slice(Math.floor((at * members.length) / ranges), Math.floor(((at + 1) * members.length) / ranges)),
  );
}

/**
 * "cam_3 – 12", "left_arm – torso".
 * @param {string[]} labels
 */
function between(labels) {
  const [first, last] = [labels[0] ?? "", labels[labels.length - 1] ?? ""];
  if (first === last) return cut(first, 2 * SHORT);
  let same = 0;
  while (same < first.length && first[same] === last[same]) same++;
  const shared = first.slice(0, same).search(/[^_\-./ ]*$/);
  return `${cut(first, SHORT)} – ${cut(last.slice(shared), SHORT)}`;
}
