// Walks the drawing as the eye does: along lines, through ports of borders and through pills, wire by wire.

import { walk } from "./tree.js";

/** @typedef {import("./types").Selection} Selection */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").View} View */

/** What a level and those in it hold, by id. */
export class Drawn {
  /** @param {Level} root */
  constructor(root) {
    /** @type {Map<string, Box>} */
    this.boxes = new Map();
    /** @type {Map<string, Edge>} */
    this.edges = new Map();
    /** @type {Map<string, Edge[]>} lines by the id of what they come from */
    this.leaving = new Map();
    /** @type {Map<string, Edge[]>} */
    this.entering = new Map();
    /** @type {Map<string, Edge[]>} lines by the id of a wire */
    this.carrying = new Map();
    this.add(root);
  }

  /** @param {Level} level */
  add(level) {
    for (const box of level.boxes) {
      this.boxes.set(box.id, box);
      if (box.level) this.add(box.level);
    }
    for (const edge of level.edges) {
      this.edges.set(edge.id, edge);
      push(this.leaving, edge.from, edge);
      push(this.entering, edge.to, edge);
      for (const wire of edge.wires) push(this.carrying, wire.id, edge);
    }
  }

  /** Whether lines end at it. @param {string} id */
  isEnd(id) {
    const kind = this.boxes.get(id)?.kind;
    return kind === "node" || kind === "folded";
  }

  /**
   * Follows a wire from something that is drawn to where it ends.
   * @param {string} start id of a box or a port
   * @param {string} wire
   * @param {boolean} forward with the data, or against it
   * @param {Set<string>} edges gets the ids of the lines on the way
   * @returns {Set<string>} ids of the boxes reached
   */
  follow(start, wire, forward, edges) {
    /** @type {Set<string>} */
    const reached = new Set();
    const known = new Set([start]);
    const waiting = [start];
    for (let at = waiting.pop(); at !== undefined; at = waiting.pop()) {
      for (const edge of (forward ? this.leaving : this.entering).get(at) ?? []) {
        if (!edge.wires.some((each) => each.id === wire)) continue;
        edges.add(edge.id);
        const next = forward ? edge.to : edge.from;
        if (this.boxes.get(next)?.kind === "pill") reached.add(next);
        if (this.isEnd(next)) reached.add(next);
        else if (!known.has(next)) {
          known.add(next);
          waiting.push(next);
        }
      }
    }
    return reached;
  }
}

/**
 * The boxes and lines that belong to what is selected.
 * @param {Drawn} drawn
 * @param {View} view
 * @param {Selection} selection
 * @param {(node: number) => string | null} standsFor
 * @returns {{ chosen: Set<string>, boxes: Set<string>, edges: Set<string> }}
 */
export function litBy(drawn, view, selection, standsFor) {
  const { kind, id } = selection;
  /** @type {Set<string>} */
  const chosen = new Set();
  /** @type {Set<string>} */
  const boxes = new Set();
  /** @type {Set<string>} */
  const edges = new Set();
  /** @param {string} start @param {string} wire */
  const both = (start, wire) => {
    for (const forward of [true, false]) drawn.follow(start, wire, forward, edges).forEach((box) => boxes.add(box));
  };
  /** @param {string} box @param {(wire: string) => boolean} passes */
  const around = (box, passes = () => true) => {
    boxes.add(box);
    for (const edge of [...(drawn.leaving.get(box) ?? []), ...(drawn.entering.get(box) ?? [])]) {
      for (const wire of edge.wires) if (passes(wire.id)) both(box, wire.id);
    }
  };
  if (kind === "edge") {
    const edge = drawn.edges.get(id);
    if (edge) {
      chosen.add(id);
      edges.add(id);
      for (const wire of edge.wires) {
        for (const [at, forward] of /** @type {const} */ ([[edge.to, true], [edge.from, false]])) {
          if (drawn.boxes.has(at)) boxes.add(at);
          if (!drawn.isEnd(at)) drawn.follow(at, wire.id, forward, edges).forEach((box) => boxes.add(box));
        }
      }
    }
  } else if (kind === "channel" || kind === "param") {
    for (const edge of drawn.carrying.get(id) ?? []) {
      edges.add(edge.id);
      for (const end of [edge.from, edge.to]) if (drawn.boxes.has(end)) boxes.add(end);
    }
    for (const [box, { kind: shape, wires, loose }] of drawn.boxes) {
      if (shape === "pill" && wires.some((wire) => wire.id === id)) chosen.add(box);
      if (loose.some((port) => port.wires.some((wire) => wire.id === id))) boxes.add(box);
    }
  } else if (kind === "way") {
    const parts = id.split("|");
    for (const each of parts) {
      const box = each.startsWith("n:") ? standsFor(Number(each.slice(2))) : null;
      if (box) chosen.add(box);
    }
    const passes = [...chosen];
    for (const wire of parts.filter((each) => each.startsWith("c:"))) {
      for (const box of passes) {
        /** @type {Set<string>} */
        const lines = new Set();
        const ends = drawn.follow(box, wire, true, lines);
        if (passes.some((other) => other !== box && ends.has(other))) lines.forEach((line) => edges.add(line));
      }
      if (parts.length === 2) for (const edge of drawn.carrying.get(wire) ?? []) edges.add(edge.id);
    }
  } else if (kind === "node") {
    const node = Number(id.slice(2));
    const box = standsFor(node);
    if (box) {
      chosen.add(box);
      const own = new Set(view.wires.filter((wire) => wire.givers.concat(wire.takers).some((end) => end.node === node)).map((wire) => wire.id));
      around(box, box === id ? undefined : (wire) => own.has(wire));
    }
  } else {
    const group = view.groups.get(id);
    chosen.add(id);
    if (drawn.boxes.get(id)?.kind === "folded") around(id);
    else if (group) {
      for (const each of walk(group)) for (const inner of [each.id, ...each.nodes.map((node) => `n:${node}`)]) if (drawn.boxes.has(inner)) around(inner);
    }
  }
  for (const box of chosen) if (drawn.boxes.has(box)) boxes.add(box);
  return { chosen, boxes, edges };
}

/**
 * @template V
 * @param {Map<string, V[]>} map
 * @param {string} key
 * @param {V} value
 */
function push(map, key, value) {
  const known = map.get(key);
  if (known) known.push(value);
  else map.set(key, [value]);
}
