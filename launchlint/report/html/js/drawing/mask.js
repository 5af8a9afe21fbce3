// What is switched off, filtered or hidden leaves the drawing, and what stays keeps its place: the layout is that of everything.

import { foldedBox, openBox } from "./boxes.js";
import { labelOf } from "./bundles.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").View} View */

/**
 * What of a level is left in a view that shows less.
 * @param {Level} whole as it is laid out
 * @param {View} view
 * @param {Measure} measure
 * @returns {Level}
 */
export function masked(whole, view, measure) {
  return new Mask(view, measure).level(whole);
}

class Mask {
  /** @param {View} view @param {Measure} measure */
  constructor(view, measure) {
    this.view = view;
    this.measure = measure;
    /** @type {Set<string>} */
    this.wires = new Set(view.wires.map((wire) => wire.id));
    /** @type {Map<string, Set<string>>} wires with an end in a box, by the id of the box */
    this.ends = new Map();
    for (const wire of view.wires) {
      for (const { node } of [...wire.givers, ...wire.takers]) {
        put(this.ends, `n:${node}`, wire.id);
        for (let group = view.home.get(node); group && !this.ends.get(group.id)?.has(wire.id); group = view.groups.get(group.parent)) put(this.ends, group.id, wire.id);
      }
    }
  }

  /** @param {Level} whole @returns {Level} */
  level(whole) {
    const [kept] = this.inside(whole);
    return this.used(kept, null);
  }

  /**
   * A level without what is not shown, and which wires its ports lead to something that is.
   * @param {Level} level
   * @returns {[level: Level, alive: Map<string, Set<string>>]}
   */
  inside(level) {
    /** @type {Map<string, Set<string>>} */
    const alive = new Map();
    const boxes = level.boxes.flatMap((box) => this.box(box, alive));
    const there = new Set(boxes.map((box) => box.id));
    /** @param {string} end @param {string} box @param {string} wire */
    const leads = (end, box, wire) => {
      if (box === "") return true;
      if (!there.has(box)) return false;
      if (box.startsWith("w:")) return true;
      return end === box ? Boolean(this.ends.get(box)?.has(wire)) : Boolean(alive.get(end)?.has(wire));
    };
    const edges = level.edges.flatMap((edge) => only(edge, ({ id }) => this.wires.has(id) && leads(edge.from, edge.fromBox, id) && leads(edge.to, edge.toBox, id), level));
    /** @type {Map<string, Set<string>>} */
    const own = new Map();
    for (const edge of edges) {
      const port = edge.fromBox === "" ? edge.from : edge.toBox === "" ? edge.to : "";
      if (port) for (const wire of edge.wires) put(own, port, wire.id);
    }
    return [{ ...level, boxes, edges }, own];
  }

  /** @param {Box} box @param {Map<string, Set<string>>} alive gets the ports of an open box @returns {Box[]} */
  box(box, alive) {
    const { view } = this;
    if (box.kind === "node") {
      if (!view.shown[Number(box.id.slice(2))]) return [];
      const known = new Set((view.loose.get(Number(box.id.slice(2))) ?? []).map((each) => each.wire.id));
      const loose = box.loose.flatMap((port) => {
        const wires = port.wires.filter((wire) => known.has(wire.id));
        return wires.length ? [wires.length === port.wires.length ? port : { ...port, wires, label: wires.length > 1 ? String(wires.length) : "" }] : [];
      });
      return [{ ...box, loose }];
    }
    if (box.kind === "pill") {
      const wires = box.wires.filter((wire) => this.wires.has(wire.id));
      return wires.length ? [{ ...box, wires }] : [];
    }
    const group = view.groups.get(box.id);
    if (!group || !view.counts.get(box.id)) return [];
    if (!box.level) return [foldedBox(view, group, this.measure)];
    const [level, own] = this.inside(box.level);
    own.forEach((wires, port) => alive.set(port, wires));
    return [openBox(view, level)];
  }

  /**
   * A level without lines to ports of its border that lead to nothing outside.
   * @param {Level} level
   * @param {Map<string, Set<string>> | null} outside wires by the port; null: it has no border
   * @returns {Level}
   */
  used(level, outside) {
    const edges = level.edges.flatMap((edge) => {
      const port = edge.fromBox === "" ? edge.from : edge.toBox === "" ? edge.to : "";
      return port && outside ? only(edge, ({ id }) => Boolean(outside.get(port)?.has(id)), level) : [edge];
    });
    /** @type {Map<string, Set<string>>} */
    const used = new Map();
    for (const { from, to, wires } of edges) for (const wire of wires) for (const end of [from, to]) put(used, end, wire.id);
    const ports = level.ports.filter((port) => outside?.has(port.id));
    const boxes = level.boxes.map((box) => (box.level ? { ...box, level: this.used(box.level, used) } : box));
    return { ...level, boxes, edges, ports };
  }
}

/** A line with some of its wires; none where it has none. @param {Edge} edge @param {(wire: Edge["wires"][number]) => boolean} isKept @param {Level} level @returns {Edge[]} */
function only(edge, isKept, level) {
  const wires = edge.wires.filter(isKept);
  if (!wires.length || wires.length === edge.wires.length) return wires.length ? [edge] : [];
  return [{ ...edge, wires, label: edge.label.length ? labelOf(wires, level.group.namespace) : [] }];
}

/** @param {Map<string, Set<string>>} map @param {string} key @param {string} value */
function put(map, key, value) {
  const known = map.get(key);
  if (known) known.add(value);
  else map.set(key, new Set([value]));
}
