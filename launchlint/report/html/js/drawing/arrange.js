// Where everything in a container stands: connected parts as ELK lays them out, the rest in rows below, in the order of names,
// so that opening one box moves others but never changes their order.

import { BADGE, MARGIN, layOutPart } from "./engine.js";
import { PADDING } from "./boxes.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./engine").Engine} Engine */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Point} Point */

/** Between the upper border of an open container, which has its name, and what is in it. */
const HEAD = 32;
const GAP = 24;
/** Between two hollow ports of a box without lines. */
const PITCH = 17;
const TRIALS = 16;

/**
 * Lays out a level and all that are open in it, from inside to outside.
 * @param {Engine} engine
 * @param {Level} level
 * @param {Measure} measure
 * @param {Map<string, Promise<Placed>>} cache
 * @param {number} aspect of the screen: width by height
 * @returns {Promise<Map<string, Placed>>} by the id of the container
 */
export async function layOut(engine, level, measure, cache, aspect) {
  const inside = await Promise.all(level.boxes.map((box) => (box.level ? layOut(engine, box.level, measure, cache, aspect) : null)));
  /** @type {Map<string, Placed>} */
  const all = new Map();
  for (const each of inside) each?.forEach((placed, id) => all.set(id, placed));
  const parts = connectedParts(level);
  const singles = parts.filter((part) => part.boxes.length === 1 && !part.edges.length && !part.ports.length).map((part) => /** @type {Box} */ (part.boxes[0]));
  const widths = evenWidths(singles);
  const blocks = await Promise.all(
    parts.map((part) => {
      const [box] = part.boxes;
      return box && singles.includes(box) ? single(box, all.get(box.id), widths.get(box.kind) ?? 0, measure) : layOutPart(engine, part, all, measure, cache, aspect);
    }),
  );
  const least = level.group.kind === "root" ? 0 : measure(level.group.label, "title") + 92;
  const head = level.group.kind === "root" ? MARGIN : HEAD;
  all.set(level.group.id, pack(parts, blocks, head, least, aspect));
  return all;
}

/**
 * The parts of a level that no line connects, that which touches the border first, then the larger ones.
 * @param {Level} level
 * @returns {Level[]}
 */
function connectedParts(level) {
  /** @type {Map<string, string>} */
  const leaders = new Map();
  /** @param {string} id @returns {string} */
  const leader = (id) => {
    let at = id;
    for (let next = leaders.get(at); next !== undefined; next = leaders.get(at)) at = next;
    return at;
  };
  for (const edge of level.edges) {
    const [one, other] = [leader(edge.fromBox), leader(edge.toBox)];
    if (one !== other) leaders.set(one === "" ? other : one, one === "" ? one : other);
  }
  /** @type {Map<string, Level>} */
  const parts = new Map();
  if (level.ports.length) parts.set("", { group: level.group, boxes: [], ports: level.ports, edges: [] });
  for (const box of level.boxes) {
    const key = leader(box.id);
    const part = parts.get(key);
    if (part) part.boxes.push(box);
    else parts.set(key, { group: level.group, boxes: [box], ports: [], edges: [] });
  }
  for (const edge of level.edges) parts.get(leader(edge.fromBox))?.edges.push(edge);
  return Array.from(parts.values()).sort((a, b) => Number(!a.ports.length) - Number(!b.ports.length) || b.boxes.length - a.boxes.length);
}

/** Boxes without lines stand in columns where they are equally wide. @param {Box[]} boxes @returns {Map<Box["kind"], number>} */
function evenWidths(boxes) {
  const widths = new Map();
  for (const { kind, level, width } of boxes) if (!level) widths.set(kind, Math.max(widths.get(kind) ?? 0, width));
  return widths;
}

/**
 * A box without lines, and its hollow ports.
 * @param {Box} box
 * @param {Placed | undefined} inner
 * @param {number} width
 * @param {Measure} measure
 * @returns {Placed}
 */
function single(box, inner, width, measure) {
  const sides = [false, true].map((out) => box.loose.filter((port) => port.out === out));
  const [left, right] = sides.map((ports) => Math.max(0, ...ports.map((port) => Math.ceil(measure(port.label, "label")) + PADDING.x + (port.badge ? BADGE : 0))));
  const size = { width: inner?.width ?? (box.kind === "pill" ? box.width : width), height: Math.max(inner?.height ?? box.height, ...sides.map((ports) => ports.length * PITCH + 6)) };
  /** @type {Placed} */
  const placed = { width: size.width + (left ?? 0) + (right ?? 0), height: size.height, boxes: new Map(), ports: new Map(), labels: new Map(), edges: new Map() };
  placed.boxes.set(box.id, { x: left ?? 0, y: 0, ...size });
  sides.forEach((ports, out) =>
    ports.forEach((port, at) => {
      const point = { x: (left ?? 0) + (out ? size.width : 0), y: size.height / 2 + (at - (ports.length - 1) / 2) * PITCH };
      placed.ports.set(port.id, point);
      const extent = (out ? right : left) ?? 0;
      placed.labels.set(port.id, { x: out ? point.x : 0, y: point.y - 7, width: extent, height: 14 });
    }),
  );
  return placed;
}

/**
 * Puts parts into rows; what touches the border spans all of the first one.
 * @param {Level[]} parts
 * @param {Placed[]} blocks
 * @param {number} head
 * @param {number} least width
 * @param {number} aspect
 * @returns {Placed}
 */
function pack(parts, blocks, head, least, aspect) {
  const spanning = parts[0]?.ports.length ? blocks[0] : undefined;
  const rest = spanning ? blocks.slice(1) : blocks;
  const from = spanning ? head + spanning.height + (rest.length ? GAP : 0) : head;
  const rows = inRows(rest, spanning ? spanning.width - 2 * MARGIN : 0, from, aspect);
  /** @type {Placed} */
  const all = { width: Math.max(least, spanning?.width ?? 0, rows.width + 2 * MARGIN), height: from + rows.height + MARGIN, boxes: new Map(), ports: new Map(), labels: new Map(), edges: new Map() };
  if (spanning) {
    add(all, spanning, 0, head);
    widen(all, parts[0]?.ports.filter((port) => port.out).map((port) => port.id) ?? [], spanning.width);
  }
  rest.forEach((block, at) => add(all, block, MARGIN + (rows.places[at]?.x ?? 0), from + (rows.places[at]?.y ?? 0)));
  return all;
}

/**
 * @param {Placed[]} blocks
 * @param {number} width that is there in any case
 * @param {number} above height of what stands above
 * @param {number} aspect
 * @returns {{ width: number, height: number, places: Point[] }}
 */
function inRows(blocks, width, above, aspect) {
  const widest = Math.max(width, ...blocks.map((block) => block.width));
  const longest = blocks.reduce((sum, block) => sum + block.width + GAP, 0);
  let best = shelves(blocks, widest);
  /** @param {{ width: number, height: number }} rows */
  const cost = (rows) => Math.max(rows.width / aspect, rows.height + above);
  for (let trial = 1; trial <= TRIALS && widest < longest; trial++) {
    const rows = shelves(blocks, widest + ((longest - widest) * trial * trial) / TRIALS ** 2);
    if (cost(rows) < cost(best)) best = rows;
  }
  return best;
}

/**
 * Rows of at most a width; in a row, low blocks stand below each other beside a high one.
 * @param {Placed[]} blocks
 * @param {number} most
 */
function shelves(blocks, most) {
  /** @type {Point[]} */
  const places = [];
  const row = { y: 0, height: 0 };
  const column = { x: 0, width: 0, bottom: 0 };
  let width = 0;
  for (const block of blocks) {
    const first = column.width === 0;
    if (!first && column.bottom + GAP + block.height <= row.height && block.width <= Math.max(column.width, 60) * 1.25 && column.x + block.width <= most) {
      places.push({ x: column.x, y: row.y + column.bottom + GAP });
      column.bottom += GAP + block.height;
      column.width = Math.max(column.width, block.width);
    } else {
      if (!first) column.x += column.width + GAP;
      if (!first && column.x + block.width > most) {
        row.y += row.height + GAP;
        row.height = 0;
        column.x = 0;
      }
      places.push({ x: column.x, y: row.y });
      column.width = block.width;
      column.bottom = block.height;
      row.height = Math.max(row.height, block.height);
    }
    width = Math.max(width, column.x + column.width);
  }
  return { width, height: row.y + row.height, places };
}

/** @param {Placed} all @param {Placed} block @param {number} dx @param {number} dy */
function add(all, block, dx, dy) {
  /** @template {Point} P @param {P} point @returns {P} */
  const move = (point) => ({ ...point, x: point.x + dx, y: point.y + dy });
  for (const name of /** @type {const} */ (["boxes", "labels"])) block[name].forEach((area, id) => all[name].set(id, move(area)));
  block.ports.forEach((point, id) => all.ports.set(id, move(point)));
  block.edges.forEach(({ points, junctions }, id) => all.edges.set(id, { points: points.map(move), junctions: junctions.map(move) }));
}

/**
 * Leads lines that left through a border on to where the border is now.
 * @param {Placed} all
 * @param {string[]} leaving ids of ports
 * @param {number} border where it was
 */
function widen(all, leaving, border) {
  if (all.width <= border) return;
  for (const id of leaving) {
    const port = all.ports.get(id);
    if (port) port.x = all.width;
  }
  for (const { points } of all.edges.values()) for (const point of points) if (point.x >= border - 0.5) point.x = all.width;
}
