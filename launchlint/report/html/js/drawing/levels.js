// The inside of each open container as a small graph of its own: boxes, ports at its border, and lines between them.
// What is inside depends on the wires and on what is open inside, never on what is open elsewhere: so places stay where they are.

import { foldedBox, nodeBox, openBox } from "./boxes.js";
import { Lines, Pills, Ports, nameOnce } from "./bundles.js";
import { joinLines } from "./joints.js";

/** @typedef {import("./types").Group} Group */
/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").End} End */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Tip} Tip */
/** @typedef {import("./model").View} View */
/** @typedef {import("./model").Wire} Wire */

/** @typedef {{ wire: Wire, givers: Map<string, End[]>, takers: Map<string, End[]> }} Part Ends of a wire in one level, by box. */

/**
 * @param {View} view
 * @param {Set<string>} open ids of the open containers
 * @param {Measure} measure
 * @returns {Level} the outermost
 */
export function levelsOf(view, open, measure) {
  const chain = chains(view);
  /** @param {number} node */
  const paths = (node) => chain(view.home.get(node));
  /** @type {Map<string, Map<Wire, Part>>} */
  const parts = new Map();
  for (const wire of view.wires) {
    for (const side of /** @type {const} */ (["givers", "takers"])) {
      for (const end of wire[side]) place(wire, side, end, paths(end.node), open, parts);
    }
  }
  return new Builder(view, open, measure, parts, chain).level(view.root);
}

/** @param {View} view @returns {(group: Group | undefined) => Group[]} a container and those around it, outermost first */
function chains(view) {
  /** @type {Map<string, Group[]>} */
  const known = new Map([[view.root.id, [view.root]]]);
  /** @param {Group} group @param {Group[]} around */
  const fill = (group, around) => {
    const own = [...around, group];
    known.set(group.id, own);
    group.groups.forEach((each) => fill(each, own));
  };
  view.root.groups.forEach((each) => fill(each, [view.root]));
  return (group) => known.get(group?.id ?? "") ?? [];
}

/**
 * @param {Wire} wire
 * @param {"givers" | "takers"} side
 * @param {End} end
 * @param {Group[]} path
 * @param {Set<string>} open
 * @param {Map<string, Map<Wire, Part>>} parts
 */
function place(wire, side, end, path, open, parts) {
  for (let depth = 0; depth < path.length; depth++) {
    const own = /** @type {Group} */ (path[depth]);
    if (depth && !open.has(own.id)) return;
    const box = path[depth + 1]?.id ?? `n:${end.node}`;
    let wires = parts.get(own.id);
    if (!wires) parts.set(own.id, (wires = new Map()));
    let part = wires.get(wire);
    if (!part) wires.set(wire, (part = { wire, givers: new Map(), takers: new Map() }));
    const ends = part[side].get(box);
    if (ends) ends.push(end);
    else part[side].set(box, [end]);
  }
}

class Builder {
  /**
   * @param {View} view
   * @param {Set<string>} open
   * @param {Measure} measure
   * @param {Map<string, Map<Wire, Part>>} parts
   * @param {(group: Group | undefined) => Group[]} chain
   */
  constructor(view, open, measure, parts, chain) {
    this.view = view;
    this.open = open;
    this.measure = measure;
    this.parts = parts;
    this.chain = chain;
    /** @type {Map<Wire, Group | undefined>} */
    this.homes = new Map();
  }

  /** The innermost container around all ends of a wire. @param {Wire} wire */
  home(wire) {
    if (!this.homes.has(wire)) {
      /** @type {Group[] | undefined} */
      let common;
      for (const end of [...wire.givers, ...wire.takers]) {
        const path = this.chain(this.view.home.get(end.node));
        if (!common) common = path;
        let same = 0;
        while (same < common.length && common[same] === path[same]) same++;
        common = common.slice(0, same);
      }
      this.homes.set(wire, common?.[common.length - 1]);
    }
    return this.homes.get(wire);
  }

  /** @param {Group} group @returns {Level} */
  level(group) {
    const { view, measure } = this;
    /** @type {Level} */
    const own = { group, boxes: [], ports: [], edges: [] };
    for (const each of group.groups) {
      if (!view.counts.get(each.id)) continue;
      const isOpen = this.open.has(each.id) && !view.stubs.has(each.id);
      own.boxes.push(isOpen ? openBox(view, this.level(each)) : foldedBox(view, each, measure));
    }
    const nodes = group.nodes.filter((node) => view.shown[node]).sort((a, b) => (view.ranks[a] ?? 0) - (view.ranks[b] ?? 0));
    for (const node of nodes) own.boxes.push(nodeBox(view, node, group, measure));
    const lines = new Lines(view, own);
    const ports = new Ports(own);
    const pills = new Pills(view, own, measure, lines);
    const boxes = new Map(own.boxes.map((box) => [box.id, box]));
    for (const part of this.parts.get(group.id)?.values() ?? []) {
      const { wire } = part;
      const home = this.home(wire);
      if (home !== group && this.chain(home).includes(group)) continue;
      const givers = tips(part.givers, boxes, wire, true);
      const takers = tips(part.takers, boxes, wire, false);
      if (group !== view.root) {
        for (const out of [true, false]) {
          const outside = this.outside(wire, out ? "takers" : "givers", out ? part.takers : part.givers);
          const passing = wire.pilled && home !== group ? () => true : (/** @type {Tip} */ tip) => outside.some((when) => view.presence.meet(when, tip.when));
          ports.add(wire, out, (out ? givers : takers).filter(passing));
        }
      }
      if (!wire.pilled) pairs(view, wire, givers, takers, boxes, lines);
      else if (home === group) {
        const boxOf = (/** @type {Tip[]} */ each) => new Set(each.map((tip) => tip.box));
        const [from, to] = [boxOf(givers), boxOf(takers)];
        const plain = !wire.always && (from.size < 2 || to.size < 2) && ![...from].some((box) => to.has(box));
        if (plain) pairs(view, wire, givers, takers, boxes, lines);
        else pills.add(wire, givers, takers);
      }
    }
    ports.connect(lines);
    pills.connect();
    own.edges = lines.edges();
    joinLines(own.edges);
    nameOnce(own);
    return own;
  }

  /**
   * When the ends of a wire exist that are not among these.
   * @param {Wire} wire
   * @param {"givers" | "takers"} side
   * @param {Map<string, End[]>} inside
   */
  outside(wire, side, inside) {
    /** @type {Map<number, number>} */
    const counts = new Map();
    for (const end of wire[side]) counts.set(end.when, (counts.get(end.when) ?? 0) + 1);
    for (const ends of inside.values()) for (const end of ends) counts.set(end.when, (counts.get(end.when) ?? 0) - 1);
    return Array.from(counts).flatMap(([when, count]) => (count > 0 ? [when] : []));
  }
}

/**
 * The ends of a wire as tips: of a node or folded box one for each time it exists, of an open one those of its ports that the wire passes.
 * @param {Map<string, End[]>} ends
 * @param {Map<string, Box>} boxes
 * @param {Wire} wire
 * @param {boolean} out
 * @returns {Tip[]}
 */
function tips(ends, boxes, wire, out) {
  /** @type {Tip[]} */
  const found = [];
  for (const [id, own] of ends) {
    const box = boxes.get(id);
    if (box?.level) {
      for (const port of box.level.ports) if (port.out === out && port.wires.includes(wire)) found.push({ ...port, box: id });
      continue;
    }
    /** @type {Map<number, Tip>} */
    const byTime = new Map();
    for (const end of own) {
      const known = byTime.get(end.when);
      if (known) {
        known.certain ||= end.certain;
        known.changed ||= end.changed;
      } else byTime.set(end.when, { id, box: id, when: end.when, certain: end.certain, changed: end.changed });
    }
    found.push(...byTime.values());
  }
  return found;
}

/**
 * @param {View} view
 * @param {Wire} wire
 * @param {Tip[]} givers
 * @param {Tip[]} takers
 * @param {Map<string, Box>} boxes
 * @param {Lines} lines
 */
function pairs(view, wire, givers, takers, boxes, lines) {
  for (const from of givers) {
    for (const to of takers) {
      if (from.box === to.box && boxes.get(from.box)?.kind !== "node") continue;
      if (view.presence.meet(from.when, to.when)) lines.add(wire, from, to);
    }
  }
}
