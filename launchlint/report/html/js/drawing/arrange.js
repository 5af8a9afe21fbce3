// Where everything in a container stands: connected parts as ELK lays them out, the rest in rows below, in the order of names,
// so that opening one box moves others but never changes their order.

import { BADGE, MARGIN, costOf, layOutPart } from "./engine.js";
import { PADDING } from "./boxes.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./engine").Engine} Engine */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Point} Point */
/** @typedef {import("./model").Screen} Screen */
/** @typedef {{ head: number, least: number, screen: Screen, gap: number }} Shape Room at the top, least width, what it is for, room between boxes. */

/** Between the upper border of an open container, which has its name, and what is in it. */
const HEAD = 32;
const GAP = 24;
/** Between boxes in the tray, and where the screen does not hold more. */
const NARROW_GAP = 10;
/** Between two hollow ports of a box without lines. */
const PITCH = 17;
const TRIALS = 16;
/** How much narrower than the screen a container is, for its height. */
const NARROWER = 0.75;
/** The tray stands below the others. */
const BROADER = 2.2;
/** Widths of boxes without lines are multiples of this, so that one more of them seldom widens the others. */
const STEP = 40;

/**
 * Lays out a level and all that are open in it, from inside to outside.
 * @param {Engine} engine
 * @param {Level} level
 * @param {Measure} measure
 * @param {Map<string, Promise<Placed>>} cache
 * @param {Screen} screen
 * @returns {Promise<Map<string, Placed>>} by the id of the container
 */
export async function layOut(engine, level, measure, cache, screen) {
  const { aspect } = screen;
  // What stands beside others had better be narrow.
  const alone = level.boxes.filter((box) => !isTray(box)).length === 1;
  /** @param {Box} box @returns {Screen} */
  const within = (box) => ({ ...screen, aspect: form(box), width: screen.width - 2 * MARGIN });
  /** @param {Box} box */
  const form = (box) => (isTray(box) ? aspect * BROADER : level.group.kind === "root" && !alone ? Math.min(aspect, 1) * NARROWER : aspect);
  const inside = await Promise.all(level.boxes.map((box) => (box.level ? layOut(engine, box.level, measure, cache, within(box)) : null)));
  /** @type {Map<string, Placed>} */
  const all = new Map();
  for (const each of inside) each?.forEach((placed, id) => all.set(id, placed));
  const parts = connectedParts(level);
  const singles = parts.filter((part) => part.boxes.length === 1 && !part.edges.length && !part.ports.length).map((part) => /** @type {Box} */ (part.boxes[0]));
  const widths = evenWidths(singles.filter((box) => !isTray(box)));
  const blocks = await Promise.all(
    parts.map((part) => {
      const [box] = part.boxes;
      return box && singles.includes(box) ? single(box, all.get(box.id), isTray(box) ? box.width : (widths.get(box.kind) ?? 0), measure) : layOutPart(engine, part, all, measure, cache, screen);
    }),
  );
  const least = level.group.kind === "root" ? 0 : measure(level.group.label, "title") + 92;
  const head = level.group.kind === "root" ? MARGIN : HEAD;
  const shape = { head, least, screen, gap: level.group.kind === "tray" || screen.density !== "plain" ? NARROW_GAP : GAP };
  all.set(level.group.id, pack(parts, blocks, shape));
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
  // Not by their size: one more box in a part would move all others.
  return Array.from(parts.values()).sort((a, b) => rank(a) - rank(b));
}

/** What touches the border first, then what is connected, then the rest, and the tray at the end. @param {Level} part */
function rank({ ports, edges, boxes }) {
  return ports.length ? 0 : edges.length ? 1 : boxes[0] && isTray(boxes[0]) ? 3 : 2;
}

/** @param {Box} box */
function isTray(box) {
  return box.classes.includes("tray");
}

/** Boxes without lines stand in columns where they are equally wide. @param {Box[]} boxes @returns {Map<Box["kind"], number>} */
function evenWidths(boxes) {
  const widths = new Map();
  for (const { kind, level, width } of boxes) if (!level) widths.set(kind, Math.max(widths.get(kind) ?? 0, Math.ceil(width / STEP) * STEP));
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
  const sides = [false, true].map((out) => (inner ? [] : box.loose.filter((port) => port.out === out)));
  const [left, right] = sides.map((ports) => Math.max(0, ...ports.map((port) => (port.label || port.badge ? Math.ceil(measure(port.label, "label")) + PADDING.x + (port.badge ? BADGE : 0) : 0))));
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
 * @param {Shape} shape
 * @returns {Placed}
 */
function pack(parts, blocks, shape) {
  const { head, least, gap } = shape;
  const spanning = parts[0]?.ports.length ? blocks[0] : undefined;
  const rest = spanning ? blocks.slice(1) : blocks;
  const from = spanning ? head + spanning.height + (rest.length ? gap : 0) : head;
  const rows = inRows(rest, spanning ? spanning.width - 2 * MARGIN : 0, from, shape);
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
 * @param {Shape} shape
 * @returns {{ width: number, height: number, places: Point[] }}
 */
function inRows(blocks, width, above, { screen, gap }) {
  const widest = Math.max(width, ...blocks.map((block) => block.width));
  const longest = blocks.reduce((sum, block) => sum + block.width + gap, 0);
  let best = shelves(blocks, widest, gap);
  /** @param {{ width: number, height: number }} rows */
  const cost = (rows) => costOf({ width: rows.width, height: rows.height + above }, screen);
  for (let trial = 1; trial <= TRIALS && widest < longest; trial++) {
    const rows = shelves(blocks, widest + ((longest - widest) * trial * trial) / TRIALS ** 2, gap);
    if (cost(rows) < cost(best)) best = rows;
  }
  // What the screen does not hold in rows it may hold where each stands as high as it can, large ones first if need be.
  const orders = [blocks, [...blocks].sort((a, b) => b.width - a.width), [...blocks].sort((a, b) => b.height - a.height)];
  for (const order of cost(best) > screen.width / screen.aspect ? orders : []) {
    for (let trial = 0; trial <= TRIALS; trial++) {
      const stacked = raised(order, widest + ((longest - widest) * trial * trial) / TRIALS ** 2, gap);
      if (cost(stacked) < cost(best)) best = { ...stacked, places: blocks.map((block) => /** @type {Point} */ (stacked.places[order.indexOf(block)])) };
    }
    if (cost(best) <= screen.width / screen.aspect) break;
  }
  return best;
}

/**
 * Each block as high as it can stand within a width below those before it, and there as far to the left.
 * @param {Placed[]} blocks
 * @param {number} most
 * @param {number} gap
 */
function raised(blocks, most, gap) {
  /** @type {Point[]} */
  const places = [];
  /** @type {{ x: number, width: number, y: number }[]} how far down the space is taken, from left to right */
  let floor = [{ x: 0, width: most, y: 0 }];
  let [width, height] = [0, 0];
  for (const block of blocks) {
    let best = { x: 0, y: Infinity };
    for (const { x } of floor) {
      if (x > 0 && x + block.width > most) break;
      const y = Math.max(...floor.filter((each) => each.x < x + block.width && each.x + each.width > x).map((each) => each.y));
      if (y < best.y) best = { x, y };
    }
    places.push(best);
    const right = Math.min(most, best.x + block.width + gap);
    floor = floor.flatMap((each) => {
      const end = each.x + each.width;
      return [
        { ...each, width: Math.min(end, best.x) - each.x },
        { ...each, x: Math.max(each.x, right), width: end - Math.max(each.x, right) },
      ].filter((piece) => piece.width > 0);
    });
    floor.push({ x: best.x, width: right - best.x, y: best.y + block.height + gap });
    floor.sort((a, b) => a.x - b.x);
    width = Math.max(width, best.x + block.width);
    height = Math.max(height, best.y + block.height);
  }
  return { width, height, places };
}

/**
 * Rows of at most a width; in a row, low blocks stand below each other beside a high one.
 * @param {Placed[]} blocks
 * @param {number} most
 * @param {number} gap
 */
function shelves(blocks, most, gap) {
  /** @type {Point[]} */
  const places = [];
  const row = { y: 0, height: 0 };
  const column = { x: 0, width: 0, bottom: 0 };
  let width = 0;
  for (const block of blocks) {
    const first = column.width === 0;
    if (!first && column.bottom + gap + block.height <= row.height && block.width <= Math.max(column.width, 60) * 1.25 && column.x + block.width <= most) {
      places.push({ x: column.x, y: row.y + column.bottom + gap });
      column.bottom += gap + block.height;
      column.width = Math.max(column.width, block.width);
    } else {
      if (!first) column.x += column.width + gap;
      if (!first && column.x + block.width > most) {
        row.y += row.height + gap;
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
