// Puts what is new into a drawing that stands: nothing that was there moves, but what a larger container pushes away. New boxes come where
// there is room beside those that they share a line with, new lines find a way around all boxes.

import { overlap, pieces, wider } from "./areas.js";
import { PADDING } from "./boxes.js";
import { BADGE, LABEL_HEIGHT, MARGIN } from "./engine.js";
import { stretched } from "./stretching.js";
import { wayBetween } from "./wayfinder.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./model").Area} Area */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Point} Point */

/** Around a new box. */
const ROOM = 22;
/** Between a new box and one that it shares a line with. */
const AWAY = 64;
/** Between places that are tried. */
const STEP = 12;
/** Between two ports of a side. */
const PITCH = 16;
/** What a pixel costs by which a container gets wider and higher, in pixels away from where a box belongs: as it should, rather high, rather wide. */
const FORMS = [{ wide: 2, high: 2 }, { wide: 12, high: 2 }, { wide: 2, high: 12 }];

/** @typedef {(typeof FORMS)[number]} Form */
/** @typedef {{ all: Map<string, Placed>, cost: number }} Grown Containers by their ids, and what it costs that boxes moved. */
/**
 * @typedef {object} Ways
 * @property {Map<string, Placed>} standing where everything was, by the id of the container
 * @property {(level: Level) => Promise<Map<string, Placed>>} fresh lays out a container that is new
 * @property {(box: Box) => number} turn later ones are put after earlier ones
 * @property {Measure} measure
 */

/**
 * @param {Level} level with what is new
 * @param {Level} before without it
 * @param {Ways} ways
 * @returns {Promise<Map<string, Placed>>}
 */
export async function grown(level, before, ways) {
  const [first] = await forms(level, before, ways);
  return first?.all ?? new Map();
}

/**
 * A container, and what is in it, in several forms where it had to grow: what is around it takes the one for which the fewest others move.
 * @param {Level} level
 * @param {Level} before
 * @param {Ways} ways
 * @returns {Promise<Grown[]>}
 */
async function forms(level, before, ways) {
  const own = ways.standing.get(before.group.id);
  if (!own) return [];
  /** @type {Map<string, Grown[]>} */
  const inner = new Map();
  for (const box of level.boxes) {
    if (!box.level) continue;
    const was = before.boxes.find((each) => each.id === box.id)?.level;
    inner.set(box.id, was ? await forms(box.level, was, ways) : [{ all: await ways.fresh(box.level), cost: 0 }]);
  }
  /** @type {Map<string, Grown>} */
  const found = new Map();
  for (const form of FORMS) {
    const growth = new Growth(level, before, own, inner, form, ways.measure);
    const placed = growth.placed(ways.turn);
    growth.inner.set(level.group.id, placed);
    const size = `${placed.width} ${placed.height}`;
    if (placed.width === own.width && placed.height === own.height) return [{ all: growth.inner, cost: growth.cost }];
    if ((found.get(size)?.cost ?? Infinity) > growth.cost) found.set(size, { all: growth.inner, cost: growth.cost });
  }
  return [...found.values()];
}

class Growth {
  /** @param {Level} level @param {Level} before @param {Placed} own @param {Map<string, Grown[]>} inner of each open box @param {Form} form @param {Measure} measure */
  constructor(level, before, own, inner, form, measure) {
    this.level = level;
    this.form = form;
    this.measure = measure;
    this.cost = 0;
    /** @type {Map<string, Placed>} the containers in it */
    this.inner = new Map();
    this.head = Math.min(own.height, ...Array.from(own.boxes.values(), (area) => area.y));
    /** @type {Placed} */
    this.all = { width: own.width, height: own.height, boxes: new Map(), ports: new Map(), labels: new Map(), edges: new Map() };
    this.keep(before, own);
    for (const [id, grown] of inner) this.stretch(id, grown);
  }

  /** What was there stays. @param {Level} before @param {Placed} own */
  keep(before, own) {
    const { all, level } = this;
    const known = new Map(before.edges.map((edge) => [edge.id, edge]));
    for (const box of level.boxes) {
      const area = own.boxes.get(box.id);
      if (area) all.boxes.set(box.id, { ...area });
      for (const { id } of box.loose) this.take(own, id, id);
    }
    for (const port of level.ports) this.take(own, port.id, port.id);
    for (const edge of level.edges) {
      const was = known.get(edge.id);
      const line = was && own.edges.get(was.id);
      if (!was || !line) continue;
      all.edges.set(edge.id, { points: line.points.map((point) => ({ ...point })), junctions: line.junctions.map((point) => ({ ...point })) });
      this.take(own, was.fromPort, edge.fromPort);
      this.take(own, was.toPort, edge.toPort);
    }
  }

  /** @param {Placed} own @param {string} id @param {string} now */
  take(own, id, now) {
    const [port, label] = [own.ports.get(id), own.labels.get(id)];
    if (port) this.all.ports.set(now, { ...port });
    if (label) this.all.labels.set(now, { ...label });
  }

  /** Makes room for an open container in the form for which the fewest others move. @param {string} id @param {Grown[]} grown */
  stretch(id, grown) {
    const box = this.level.boxes.find((each) => each.id === id);
    const tried = grown.map((each) => {
      const size = each.all.get(id);
      const room = box && size && this.all.boxes.has(id) ? stretched(this.level, this.all, box, size) : { placed: this.all, cost: 0 };
      return { inside: each.all, placed: room.placed, cost: each.cost + room.cost };
    });
    const best = tried.sort((a, b) => a.cost - b.cost)[0];
    if (!best) return;
    this.all = best.placed;
    this.cost += best.cost;
    best.inside.forEach((placed, each) => this.inner.set(each, placed));
  }

  /** @param {(box: Box) => number} turn @returns {Placed} */
  placed(turn) {
    const { all, level } = this;
    const missing = level.boxes.filter((box) => !all.boxes.has(box.id)).sort((a, b) => turn(a) - turn(b));
    for (const box of missing) this.put(box);
    for (const box of level.boxes) if (!missing.includes(box)) this.hollow(box);
    for (const edge of level.edges) if (!this.holds(edge)) all.edges.delete(edge.id);
    const routed = level.edges.filter((edge) => !all.edges.has(edge.id));
    for (const edge of routed) this.route(edge);
    this.close();
    return all;
  }

  /** Where a line ends: at a port that is there, at an open container where its line passes, at the border, or at a place that is free. @param {Edge} edge @param {boolean} out @param {Point} [towards] @returns {Point} */
  end(edge, out, towards) {
    const { all } = this;
    const [id, box, tip] = out ? [edge.fromPort, edge.fromBox, edge.from] : [edge.toPort, edge.toBox, edge.to];
    const area = all.boxes.get(box);
    const inside = area && this.inner.get(box)?.ports.get(tip);
    if (area && inside) return { x: out ? area.x + area.width : area.x, y: area.y + inside.y };
    const known = all.ports.get(id);
    if (known) return known;
    const side = area ? { x: out ? area.x + area.width : area.x, from: area.y, to: area.y + area.height } : { x: out ? 0 : all.width, from: this.head, to: Math.max(this.head + PITCH, all.height - MARGIN) };
    const isPill = this.level.boxes.find((each) => each.id === box)?.kind === "pill";
    const y = isPill ? (side.from + side.to) / 2 : this.free(side, towards?.y ?? (side.from + side.to) / 2);
    const port = { x: side.x, y };
    all.ports.set(id, port);
    return port;
  }

  /** A place at a side that no port has. @param {{ x: number, from: number, to: number }} side @param {number} wanted */
  free({ x, from, to }, wanted) {
    const taken = [...this.all.ports.values(), ...Array.from(this.all.edges.values(), ({ points }) => [points[0], points[points.length - 1]]).flat()];
    const near = taken.flatMap((port) => (port && Math.abs(port.x - x) < 1 && port.y >= from && port.y <= to ? [port.y] : []));
    let [best, most] = [(from + to) / 2, -Infinity];
    for (let y = from + 6; y <= to - 6; y += 2) {
      const room = Math.min(PITCH, ...near.map((each) => Math.abs(each - y)));
      const worth = room * 100 - Math.abs(y - wanted);
      if (worth > most) [best, most] = [y, worth];
    }
    return best;
  }

  /** Whether a line that was there still ends where it has to. @param {Edge} edge */
  holds(edge) {
    const points = this.all.edges.get(edge.id)?.points;
    const [first, last] = [points?.[0], points?.[points.length - 1]];
    if (!points || !first || !last) return false;
    const near = (/** @type {Point} */ a, /** @type {Point} */ b) => Math.abs(a.x - b.x) < 0.5 && Math.abs(a.y - b.y) < 0.5;
    return near(first, this.end(edge, true)) && near(last, this.end(edge, false));
  }

  /** Puts a new box where there is room, and its ports. @param {Box} box */
  put(box) {
    const { all, level } = this;
    const leaving = level.edges.filter((edge) => edge.fromBox === box.id);
    const entering = level.edges.filter((edge) => edge.toBox === box.id);
    const inner = this.inner.get(box.id);
    const sides = [false, true].map((out) => ({
      ids: inner || box.kind === "pill" ? [] : [...new Set([...(out ? leaving : entering).map((edge) => (out ? edge.fromPort : edge.toPort)), ...box.loose.filter((port) => port.out === out).map((port) => port.id)])],
      names: new Map([...(out ? leaving : []).map((edge) => /** @type {const} */ ([edge.fromPort, this.nameOf(edge.label)])), ...box.loose.filter((port) => port.out === out).map((port) => /** @type {const} */ ([port.id, this.nameOf(port.label ? [port.label] : [], port.badge ? BADGE : 0)]))]),
    }));
    const [left = 0, right = 0] = sides.map(({ names }) => Math.max(0, ...Array.from(names.values(), (name) => name?.width ?? 0)));
    const pitch = (/** @type {{ names: Map<string, Area | null> }} */ { names }) => Math.max(PITCH, ...Array.from(names.values(), (name) => (name?.height ?? 0) + 2));
    const width = inner?.width ?? box.width;
    const height = Math.max(inner?.height ?? box.height, ...sides.map((side) => (side.ids.length + 0.5) * pitch(side)));
    const at = this.placeFor({ width: left + width + right, height }, leaving, entering);
    const area = { x: at.x + left, y: at.y, width, height };
    all.boxes.set(box.id, area);
    sides.forEach((side, out) => side.ids.forEach((id, index) => {
      const port = { x: area.x + (out ? width : 0), y: area.y + height / 2 + (index - (side.ids.length - 1) / 2) * pitch(side) };
      all.ports.set(id, port);
      const name = side.names.get(id);
      const isLoose = box.loose.some((each) => each.id === id);
      if (name) all.labels.set(id, { x: out ? port.x : port.x - name.width, y: port.y - (isLoose ? name.height / 2 : name.height), width: name.width, height: name.height });
    }));
    all.width = Math.max(all.width, at.x + left + width + right + MARGIN);
    all.height = Math.max(all.height, at.y + height + MARGIN);
  }

  /** Room for a name. @param {string[]} lines @param {number} [more] @returns {Area | null} */
  nameOf(lines, more = 0) {
    const width = Math.ceil(Math.max(0, ...lines.map((line) => this.measure(line, "label")))) + more;
    return width ? { x: 0, y: 0, width: width + PADDING.x, height: Math.max(1, lines.length) * LABEL_HEIGHT + 2 } : null;
  }

  /**
   * The free place that is nearest to where a box belongs: behind what it hears, before what hears it.
   * @param {{ width: number, height: number }} size
   * @param {Edge[]} leaving
   * @param {Edge[]} entering
   * @returns {Point}
   */
  placeFor({ width, height }, leaving, entering) {
    const { all, form } = this;
    const givers = entering.flatMap((edge) => all.boxes.get(edge.fromBox) ?? []);
    const takers = leaving.flatMap((edge) => all.boxes.get(edge.toBox) ?? []);
    const [giver, taker] = [givers[0], takers[0]];
    const wanted = giver ? { x: giver.x + giver.width + AWAY, y: giver.y } : taker ? { x: taker.x - AWAY - width, y: taker.y } : { x: MARGIN, y: all.height };
    const lines = Array.from(all.edges.values(), ({ points }) => pieces(points)).flat();
    const taken = [...Array.from(all.boxes.values(), (area) => wider(area, ROOM)), ...Array.from(all.labels.values(), (area) => wider(area, 8)), ...lines.map((area) => wider(area, 10))];
    let [best, least] = [{ x: MARGIN, y: all.height }, Infinity];
    const last = { x: Math.max(MARGIN, all.width - MARGIN - width), y: all.height + ROOM };
    const rows = [];
    for (let y = this.head; y <= last.y; y += STEP) rows.push({ y, cost: Math.abs(y - wanted.y) + form.high * Math.max(0, y + height + MARGIN - all.height) });
    // The nearest rows first: what is farther away than a place that is free is not looked at.
    for (const row of rows.sort((a, b) => a.cost - b.cost || a.y - b.y)) {
      if (row.cost > least) break;
      const beside = taken.filter((area) => area.y < row.y + height && row.y < area.y + area.height);
      for (let x = MARGIN; x <= last.x + STEP; x += STEP) {
        const at = { x: Math.min(x, last.x), y: row.y };
        const cost = row.cost + Math.abs(at.x - wanted.x) + form.wide * Math.max(0, at.x + width + MARGIN - all.width);
        const isNearer = cost < least || (cost === least && at.y < best.y);
        if (isNearer && !beside.some((area) => area.x < at.x + width && at.x < area.x + area.width)) [best, least] = [at, cost];
      }
    }
    return best;
  }

  /** Hollow ports that a box did not have. @param {Box} box */
  hollow(box) {
    const { all } = this;
    const area = all.boxes.get(box.id);
    if (!area || box.level) return;
    for (const port of box.loose) {
      if (all.ports.has(port.id)) continue;
      const x = area.x + (port.out ? area.width : 0);
      const y = this.free({ x, from: area.y, to: area.y + area.height }, area.y + area.height / 2);
      all.ports.set(port.id, { x, y });
    }
  }

  /** @param {Edge} edge */
  route(edge) {
    const { all } = this;
    const roughly = all.boxes.get(edge.toBox);
    const from = this.end(edge, true, roughly && { x: roughly.x, y: roughly.y + roughly.height / 2 });
    const to = this.end(edge, false, from);
    const net = edge.fromPort;
    const nets = new Map(this.level.edges.map((each) => [each.id, each.fromPort === edge.fromPort || each.toPort === edge.toPort ? net : each.id]));
    const lines = Array.from(all.edges, ([id, { points }]) => ({ net: nets.get(id) ?? id, points }));
    const points = wayBetween(from, to, { width: all.width, height: all.height - 8, top: this.head }, [...all.boxes.values()], [...all.labels.values()], lines, net);
    all.height = Math.max(all.height, ...points.map((point) => point.y + MARGIN));
    all.edges.set(edge.id, { points, junctions: [] });
    const name = edge.fromBox ? this.nameOf(edge.label) : null;
    if (!name || all.labels.has(edge.fromPort)) return;
    const taken = [...all.boxes.values(), ...all.labels.values()];
    const free = [from.y - name.height, from.y].map((y) => ({ ...name, x: from.x, y })).find((area) => !taken.some((each) => overlap(each, area)));
    if (free) all.labels.set(edge.fromPort, free);
  }

  /** Leads what leaves through the border on to where it is now. */
  close() {
    const { all, level } = this;
    for (const { id, out } of level.ports) {
      const port = all.ports.get(id);
      if (!port || !out || port.x >= all.width) continue;
      const was = port.x;
      port.x = all.width;
      for (const edge of level.edges) for (const point of edge.to === id ? (all.edges.get(edge.id)?.points ?? []) : []) if (Math.abs(point.x - was) < 0.5) point.x = all.width;
    }
  }
}
