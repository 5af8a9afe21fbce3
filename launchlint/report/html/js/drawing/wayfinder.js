// A way for one more line through a drawing that stands: at right angles, around boxes, over other lines but never along them.

/** @typedef {import("./model").Area} Area */
/** @typedef {import("./model").Point} Point */
/** @typedef {{ net: string, points: Point[] }} Drawn */

/** Between two lines of the grid that ways are made of. */
const STEP = 8;
/** Room that is kept beside a box. */
const BESIDE = 5;
/** A line leaves a box, and arrives, level for at least so long. */
const STRAIGHT = 9;
/** What it costs to turn, to cross a line, to run along one for a step, and to run through a name: in pixels of detour. */
const [TURN, CROSS, ALONG, NAME] = [24, 16, 400, 24];
/** A way beyond what is drawn makes the drawing larger. */
const BEYOND = 3;

/**
 * @param {Point} from where it leaves to the right
 * @param {Point} to where it arrives from the left
 * @param {{ width: number, height: number, top: number }} room of the drawing; below it there is more
 * @param {Area[]} boxes
 * @param {Area[]} names
 * @param {Drawn[]} lines
 * @param {string} net lines of the same net may run together
 * @returns {Point[]}
 */
export function wayBetween(from, to, room, boxes, names, lines, net) {
  const start = { x: from.x + STRAIGHT, y: from.y };
  const end = { x: to.x - STRAIGHT, y: to.y };
  const [left, right] = [Math.min(BESIDE, start.x, end.x), Math.max(room.width - BESIDE, start.x, end.x)];
  const [top, bottom] = [Math.min(room.top, start.y, end.y), Math.max(room.height, start.y, end.y) + 4 * STEP];
  const grid = new Grid(ticks(left, right, [start.x, end.x, right]), ticks(top, bottom, [start.y, end.y, bottom]));
  for (const box of boxes) grid.mark(grid.blocked, box.x - BESIDE, box.y - BESIDE, box.x + box.width + BESIDE, box.y + box.height + BESIDE);
  for (const name of names) grid.mark(grid.named, name.x, name.y, name.x + name.width, name.y + name.height);
  for (const line of lines) {
    if (line.net === net) continue;
    line.points.slice(1).forEach((point, at) => {
      const last = /** @type {Point} */ (line.points[at]);
      const level = Math.abs(point.y - last.y) < 0.5;
      const near = STEP / 2 + 1;
      const [x1, x2, y1, y2] = [Math.min(point.x, last.x), Math.max(point.x, last.x), Math.min(point.y, last.y), Math.max(point.y, last.y)];
      grid.mark(level ? grid.level : grid.upright, level ? x1 : x1 - near, level ? y1 - near : y1, level ? x2 : x2 + near, level ? y2 + near : y2);
    });
  }
  const way = grid.search(start, end, room.height);
  return straightened([from, ...(way ?? [start, { x: start.x, y: bottom }, { x: end.x, y: bottom }, end]), to]);
}

/** Ascending, with some that have to be there. @param {number} from @param {number} to @param {number[]} more */
function ticks(from, to, more) {
  const found = new Set(more);
  for (let at = from; at <= to; at += STEP) found.add(at);
  return [...found].sort((a, b) => a - b);
}

/** Without points in the middle of a straight piece. @param {Point[]} points */
function straightened(points) {
  return points.filter((point, at) => {
    const [last, next] = [points[at - 1], points[at + 1]];
    return !last || !next || !((last.x === point.x && point.x === next.x) || (last.y === point.y && point.y === next.y));
  });
}

class Grid {
  /** @param {number[]} xs @param {number[]} ys */
  constructor(xs, ys) {
    this.xs = xs;
    this.ys = ys;
    const size = xs.length * ys.length;
    this.blocked = new Uint8Array(size);
    this.named = new Uint8Array(size);
    this.level = new Uint8Array(size);
    this.upright = new Uint8Array(size);
  }

  /** @param {Uint8Array} cells @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
  mark(cells, x1, y1, x2, y2) {
    for (let y = atLeast(this.ys, y1); y < this.ys.length && /** @type {number} */ (this.ys[y]) <= y2; y++) {
      for (let x = atLeast(this.xs, x1); x < this.xs.length && /** @type {number} */ (this.xs[x]) <= x2; x++) cells[y * this.xs.length + x] = 1;
    }
  }

  /**
   * The cheapest way, level at its start; null where there is none.
   * @param {Point} start @param {Point} end @param {number} beyond height from which on it costs more
   * @returns {Point[] | null}
   */
  search(start, end, beyond) {
    const { xs, ys } = this;
    const columns = xs.length;
    const cell = (/** @type {Point} */ point) => ys.indexOf(point.y) * columns + xs.indexOf(point.x);
    const [first, last] = [cell(start), cell(end)];
    const costs = new Float64Array(2 * columns * ys.length).fill(Infinity);
    const from = new Int32Array(2 * columns * ys.length).fill(-1);
    const done = new Uint8Array(2 * columns * ys.length);
    const open = new Heap();
    // A state is a cell, and whether the way came to it upright.
    costs[2 * first] = 0;
    open.add(2 * first, 0);
    for (let state = open.take(); state !== undefined; state = open.take()) {
      if (done[state]) continue;
      done[state] = 1;
      const at = state >> 1;
      if (at === last) return this.back(from, state);
      const [x, y, isUpright] = [at % columns, Math.floor(at / columns), state & 1];
      for (const [dx, dy] of /** @type {const} */ ([[1, 0], [-1, 0], [0, 1], [0, -1]])) {
        const [nx, ny] = [x + dx, y + dy];
        if (nx < 0 || ny < 0 || nx >= columns || ny >= ys.length) continue;
        const next = ny * columns + nx;
        if (this.blocked[next] && next !== last) continue;
        const turned = dy !== 0;
        const length = Math.abs(/** @type {number} */ (xs[nx]) - /** @type {number} */ (xs[x])) + Math.abs(/** @type {number} */ (ys[ny]) - /** @type {number} */ (ys[y]));
        let cost = /** @type {number} */ (costs[state]) + length * (/** @type {number} */ (ys[ny]) > beyond ? BEYOND : 1);
        if (turned !== Boolean(isUpright)) cost += TURN;
        if ((turned ? this.upright : this.level)[next]) cost += ALONG;
        if ((turned ? this.level : this.upright)[next]) cost += CROSS;
        if (this.named[next]) cost += NAME;
        const key = 2 * next + Number(turned);
        if (cost >= /** @type {number} */ (costs[key])) continue;
        costs[key] = cost;
        from[key] = state;
        open.add(key, cost + Math.abs(/** @type {number} */ (xs[nx]) - end.x) + Math.abs(/** @type {number} */ (ys[ny]) - end.y));
      }
    }
    return null;
  }

  /** @param {Int32Array} from @param {number} state */
  back(from, state) {
    /** @type {Point[]} */
    const points = [];
    for (let at = state; at >= 0; at = from[at] ?? -1) {
      const cell = at >> 1;
      points.push({ x: this.xs[cell % this.xs.length] ?? 0, y: this.ys[Math.floor(cell / this.xs.length)] ?? 0 });
    }
    return points.reverse();
  }
}

/** The first of ascending numbers that is at least as large. @param {number[]} all @param {number} least */
function atLeast(all, least) {
  let [low, high] = [0, all.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (/** @type {number} */ (all[middle]) < least) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Gives what costs least first; of equals what came first. */
class Heap {
  constructor() {
    /** @type {number[]} */
    this.costs = [];
    /** @type {number[]} */
    this.turns = [];
    /** @type {number[]} */
    this.whats = [];
    this.turn = 0;
  }

  /** @param {number} what @param {number} cost */
  add(what, cost) {
    const turn = this.turn++;
    let at = this.costs.length;
    for (; at > 0; ) {
      const above = (at - 1) >> 1;
      // What came later stands behind its equals.
      if (cost >= /** @type {number} */ (this.costs[above])) break;
      this.move(above, at);
      at = above;
    }
    this.put(at, cost, turn, what);
  }

  /** @returns {number | undefined} */
  take() {
    const first = this.whats[0];
    const [cost, turn, what] = [this.costs.pop(), this.turns.pop(), this.whats.pop()];
    const size = this.costs.length;
    if (!size || cost === undefined || turn === undefined || what === undefined) return first;
    let at = 0;
    for (let below = 1; below < size; below = 2 * at + 1) {
      if (below + 1 < size && this.before(below + 1, /** @type {number} */ (this.costs[below]), /** @type {number} */ (this.turns[below]))) below += 1;
      if (!this.before(below, cost, turn)) break;
      this.move(below, at);
      at = below;
    }
    this.put(at, cost, turn, what);
    return first;
  }

  /** @param {number} at @param {number} cost @param {number} turn */
  before(at, cost, turn) {
    const own = /** @type {number} */ (this.costs[at]);
    return own < cost || (own === cost && /** @type {number} */ (this.turns[at]) < turn);
  }

  /** @param {number} from @param {number} to */
  move(from, to) {
    this.put(to, /** @type {number} */ (this.costs[from]), /** @type {number} */ (this.turns[from]), /** @type {number} */ (this.whats[from]));
  }

  /** @param {number} at @param {number} cost @param {number} turn @param {number} what */
  put(at, cost, turn, what) {
    this.costs[at] = cost;
    this.turns[at] = turn;
    this.whats[at] = what;
  }
}
