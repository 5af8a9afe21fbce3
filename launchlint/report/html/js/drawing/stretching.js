// Makes room where an open container is larger than it was: of several ways that one in which the fewest others move.

import { hull, overlap, pieces, wider } from "./areas.js";
import { MARGIN } from "./engine.js";

/** @typedef {import("./model").Area} Area */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Point} Point */
/** @typedef {{ placed: Placed, cost: number }} Stretched Lines that need another way are left out; the cost is in boxes that moved. */

/** Between a box that had to give way and what it gave way to. */
const GAP = 22;
/** Nearer than this nothing stands that did not before. */
const NEAR = 8;
/** Between places that are tried for a box that gives way. */
const STEP = 12;
/** A line that has to be led anew, and a pixel by which the drawing gets longer or wider, in boxes that move. */
const [LINE, PIXEL] = [0.4, 0.01];
/** Boxes that give way one by one; where it were more, all of them are pushed. */
const MOST = 60;

/**
 * @param {Level} level
 * @param {Placed} placed with the container as it was; it stays as it is
 * @param {Box} box the container
 * @param {{ width: number, height: number }} size that it has now
 * @returns {Stretched}
 */
export function stretched(level, placed, box, size) {
  const was = /** @type {Area} */ (placed.boxes.get(box.id));
  if (size.width <= was.width && size.height <= was.height) return { placed, cost: 0 };
  const ways = [pushed, aside("x"), aside("y"), aside("either"), elsewhere].flatMap((way) => way(new Room(level, placed, box, size)) ?? []);
  return /** @type {Stretched} */ (ways.sort((a, b) => a.cost - b.cost)[0]);
}

/** All that is to the right goes to the right, all that is below goes down. @param {Room} room @returns {Stretched} */
function pushed(room) {
  const { all, was, box, grown } = room;
  const [right, bottom] = [was.x + was.width, was.y + was.height];
  let count = 0;
  /** @param {Point} point */
  const push = (point) => {
    const [dx, dy] = [point.x >= right - 0.5 ? grown.x : 0, point.y >= bottom - 0.5 ? grown.y : 0];
    point.x += dx;
    point.y += dy;
    return dx + dy > 0;
  };
  all.boxes.forEach((each, id) => {
    if (id !== box.id && push(each)) count += 1;
  });
  all.ports.forEach(push);
  all.labels.forEach(push);
  for (const { points, junctions } of all.edges.values()) [...points, ...junctions].forEach(push);
  all.width += grown.x;
  all.height += grown.y;
  return { placed: all, cost: count + PIXEL * (grown.x + grown.y) };
}

/**
 * What is in the way goes aside, and what is in its way in turn.
 * @param {"x" | "y" | "either"} axis with `either`, what stands beside goes to the right, and what stands below goes down
 * @returns {(room: Room) => Stretched | null}
 */
function aside(axis) {
  return (room) => {
    const { was } = room;
    let waiting = [{ id: room.box.id, before: room.before }];
    for (let next = waiting.shift(); next; next = waiting.shift()) {
      const now = room.taken(next.id);
      for (const id of room.inTheWay(next.id, next.before)) {
        const before = room.taken(id);
        const level = axis === "x" || (axis === "either" && before.x >= was.x + was.width);
        const by = GAP + (level ? now.x + now.width - before.x : now.y + now.height - before.y);
        if (room.moved.size >= MOST || id === room.box.id) return null;
        room.move(id, level ? by : 0, level ? 0 : by);
        waiting = [...waiting, { id, before }];
      }
    }
    return room.done();
  };
}

/** What is in the way goes where there is room, as near as can be. @param {Room} room @returns {Stretched | null} */
function elsewhere(room) {
  const found = room.inTheWay(room.box.id, room.before);
  if (found.length > MOST) return null;
  for (const id of found) {
    const from = room.taken(id);
    const taken = [...room.others(id).map((area) => wider(area, GAP - 1)), ...room.linesBeside(id).map((area) => wider(area, NEAR))];
    const last = { x: Math.max(MARGIN, room.all.width - MARGIN - from.width), y: room.all.height + GAP };
    let [best, least] = [/** @type {Point | null} */ (null), Infinity];
    for (let y = room.top; y <= last.y; y += STEP) {
      for (let x = MARGIN; x <= last.x; x += STEP) {
        const cost = Math.abs(x - from.x) + Math.abs(y - from.y);
        const area = { ...from, x, y };
        if (cost < least && !taken.some((each) => overlap(each, area))) [best, least] = [{ x, y }, cost];
      }
    }
    if (!best) return null;
    room.move(id, best.x - from.x, best.y - from.y);
  }
  return room.done();
}

/** One way of giving way: what has moved so far. */
class Room {
  /** @param {Level} level @param {Placed} placed @param {Box} box @param {{ width: number, height: number }} size */
  constructor(level, placed, box, size) {
    this.level = level;
    this.box = box;
    this.all = copied(placed);
    this.size = { width: placed.width, height: placed.height };
    this.was = { .../** @type {Area} */ (this.all.boxes.get(box.id)) };
    this.grown = { x: Math.max(0, size.width - this.was.width), y: Math.max(0, size.height - this.was.height) };
    this.top = Math.min(...Array.from(this.all.boxes.values(), (area) => area.y));
    /** @type {Map<string, Point>} how far each box went */
    this.moved = new Map();
    /** @type {Map<string, Set<string>>} the ports of each box */
    this.ports = new Map(level.boxes.map((each) => [each.id, new Set(each.loose.map((port) => port.id))]));
    for (const edge of level.edges) {
      this.ports.get(edge.fromBox)?.add(edge.fromPort);
      this.ports.get(edge.toBox)?.add(edge.toPort);
    }
    const own = [...this.ports.values()].flatMap((each) => [...each]);
    /** Names at the border, which do not move. */
    this.fixed = Array.from(this.all.labels).flatMap(([id, area]) => (own.includes(id) ? [] : [area]));
    this.before = this.taken(box.id);
    const area = /** @type {Area} */ (this.all.boxes.get(box.id));
    const right = area.x + area.width;
    area.width += this.grown.x;
    area.height += this.grown.y;
    for (const id of this.ports.get(box.id) ?? []) {
      for (const each of [this.all.ports.get(id), this.all.labels.get(id)]) if (each && each.x >= right - 0.5) each.x += this.grown.x;
    }
  }

  /** A box with the names at its ports. @param {string} id @returns {Area} */
  taken(id) {
    const names = [...(this.ports.get(id) ?? [])].flatMap((port) => this.all.labels.get(port) ?? []);
    return hull([/** @type {Area} */ (this.all.boxes.get(id)), ...names]);
  }

  /** What stands beside a box. @param {string} box @returns {Area[]} */
  others(box) {
    return [...Array.from(this.all.boxes.keys()).flatMap((id) => (id === box ? [] : this.taken(id))), ...this.fixed];
  }

  /** Boxes that a box reaches where it is now, and did not where it was. @param {string} box @param {Area} before @returns {string[]} */
  inTheWay(box, before) {
    const [now, then] = [this.taken(box), before].map((area) => wider(area, NEAR));
    return [...this.all.boxes.keys()].filter((id) => id !== box && now && then && overlap(now, this.taken(id)) && !overlap(then, this.taken(id)));
  }

  /** Pieces of lines that end at other boxes. @param {string} box */
  linesBeside(box) {
    return this.level.edges.filter((edge) => edge.fromBox !== box && edge.toBox !== box).flatMap((edge) => pieces(this.all.edges.get(edge.id)?.points ?? []));
  }

  /** @param {string} id @param {number} dx @param {number} dy */
  move(id, dx, dy) {
    const ports = [...(this.ports.get(id) ?? [])];
    for (const each of [this.all.boxes.get(id), ...ports.flatMap((port) => [this.all.ports.get(port), this.all.labels.get(port)])]) {
      if (!each) continue;
      each.x += dx;
      each.y += dy;
    }
    const known = this.moved.get(id) ?? { x: 0, y: 0 };
    this.moved.set(id, { x: known.x + dx, y: known.y + dy });
  }

  /** Lines go along with their boxes, or are left out. @returns {Stretched | null} null where something stands in the way still */
  done() {
    const { all } = this;
    const changed = [this.box.id, ...this.moved.keys()];
    if (changed.some((id) => this.others(id).some((area) => overlap(area, this.taken(id))))) return null;
    let lost = 0;
    for (const edge of this.level.edges) {
      const line = all.edges.get(edge.id);
      if (!line) continue;
      const near = this.moved.has(edge.fromBox) ? [...all.boxes.keys()] : changed;
      if (this.follows(edge, line.points, line.junctions) && !near.some((id) => this.runsInto(edge, line.points, id))) continue;
      all.edges.delete(edge.id);
      lost += 1;
    }
    all.width = Math.max(all.width, ...Array.from(all.boxes.keys(), (id) => this.taken(id)).map((area) => area.x + area.width + MARGIN));
    all.height = Math.max(all.height, ...Array.from(all.boxes.values(), (area) => area.y + area.height + MARGIN));
    return { placed: all, cost: this.moved.size + LINE * lost + PIXEL * (all.width - this.size.width + all.height - this.size.height) };
  }

  /** Whether a line runs through a box, or through a name at one where it does not end. @param {Edge} edge @param {Point[]} points @param {string} id */
  runsInto(edge, points, id) {
    const isOwn = edge.fromBox === id || edge.toBox === id;
    const area = isOwn ? wider(/** @type {Area} */ (this.all.boxes.get(id)), -1) : wider(this.taken(id), 1);
    return pieces(points).some((piece) => overlap(piece, area));
  }

  /** Whether a line still leads from one of its ends to the other one. @param {Edge} edge @param {Point[]} points @param {Point[]} junctions */
  follows(edge, points, junctions) {
    const still = { x: 0, y: 0 };
    const [from, to] = [this.moved.get(edge.fromBox) ?? still, this.moved.get(edge.toBox) ?? still];
    if (from.x !== to.x || from.y !== to.y) return false;
    for (const point of [...points, ...junctions]) {
      point.x += from.x;
      point.y += from.y;
    }
    const [first, next] = points;
    if (edge.fromBox !== this.box.id || !this.grown.x || !first || !next) return true;
    first.x += this.grown.x;
    return next.x > first.x + NEAR;
  }
}

/** @param {Placed} placed @returns {Placed} */
function copied({ width, height, boxes, ports, labels, edges }) {
  /** @template {object} T @param {Map<string, T>} map @returns {Map<string, T>} */
  const each = (map) => new Map(Array.from(map, ([id, value]) => [id, { ...value }]));
  const lines = Array.from(edges, ([id, { points, junctions }]) => /** @type {const} */ ([id, { points: points.map((point) => ({ ...point })), junctions: junctions.map((point) => ({ ...point })) }]));
  return { width, height, boxes: each(boxes), ports: each(ports), labels: each(labels), edges: new Map(lines) };
}
