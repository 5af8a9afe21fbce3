// From a state of the view to a sheet: which containers are open, what is in them, and where it stands.

import { layOut } from "./arrange.js";
import { MOST, boxesIn, opening } from "./expansion.js";
import { grown } from "./growing.js";
import { hasLate, turnOf, withoutLate } from "./late.js";
import { levelsOf } from "./levels.js";
import { masked } from "./mask.js";
import { sheetOf } from "./sheet.js";
import { viewOf } from "./view.js";
import { LEGIBLE, fitting, room } from "./viewport.js";
import { Drawn } from "./walk.js";

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").ViewState} ViewState */
/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./engine").Engine} Engine */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Sheet} Sheet */
/** @typedef {import("./model").View} View */
/** @typedef {{ view: View, open: Set<string>, root: Level, sheet: Sheet, drawn: Drawn }} Scene */

/** Layouts that are tried. */
const TRIALS = 4;
const WIDEST = 2.4;
/** What is tried one after the other where not all can be read. */
const DENSER = /** @type {const} */ (["dense", "terse"]);
/** Square pixels that a line takes with its name and the way around others: half of the least in layouts of public robots. */
const LINE = 14_000;

export class Director {
  /** @param {ReportData} data @param {Engine} engine @param {Measure} measure */
  constructor(data, engine, measure) {
    this.data = data;
    this.engine = engine;
    this.measure = measure;
    /** @type {Map<string, Promise<Placed>>} */
    this.cache = new Map();
    /** The viewport when the view was first drawn: later changes of its size move nothing. */
    /** @type {import("./model").Screen} */
    this.screen = { aspect: 1, width: Infinity, density: "plain" };
    this.seen = { key: "", place: "", view: /** @type {View | null} */ (null) };
    this.laid = { key: "", view: /** @type {View | null} */ (null) };
    this.former = { key: "", view: /** @type {View | null} */ (null) };
  }

  /**
   * The view without what came late, whose layout is that of the page before; null where nothing did.
   * @param {View} view
   * @returns {View | null}
   */
  before(view) {
    const key = viewKey(view.state);
    if (this.former.key !== key) {
      const entries = this.data.entries.map((entry) => (entry === view.entry ? withoutLate(entry) : entry));
      this.former = { key, view: hasLate(view.entry) ? viewOf({ ...this.data, entries }, view.state) : null };
    }
    return this.former.view;
  }

  /**
   * The view whose layout a view is a part of: that of everything which could be switched off, filtered or hidden.
   * @param {View} view
   * @returns {View}
   */
  whole(view) {
    const state = wholeState(view.state);
    const key = viewKey(state);
    if (key === viewKey(view.state)) return view;
    const known = this.laid.key === key ? this.laid.view : null;
    const made = known ?? viewOf(this.data, state);
    this.laid = { key, view: made };
    return made;
  }

  /**
   * The view of a state, made anew only where more than the expansion changed.
   * @param {ViewState} state
   * @param {{ width: number, height: number }} extent
   * @returns {View}
   */
  view(state, extent) {
    const key = viewKey(state);
    const known = this.seen.key === key ? this.seen.view : null;
    const view = known ? { ...known, state } : viewOf(this.data, state);
    const place = placeKey(state);
    if (this.seen.place !== place) this.screen = screenOf(extent);
    this.seen = { key, place, view };
    return view;
  }

  /**
   * @param {ViewState} state
   * @param {{ width: number, height: number }} extent of the viewport, in pixels
   * @returns {Promise<Scene>}
   */
  async scene(state, extent) {
    const shown = this.view(state, extent);
    const view = this.whole(shown);
    if (state.expanded !== "auto") return this.stage(view, withFocus(view, state.expanded), shown);
    return this.stage(view, await this.opened(this.before(view) ?? view, extent), shown);
  }

  /**
   * The containers that are open at first: as many as leave all names legible.
   * @param {View} view
   * @param {{ width: number, height: number }} extent
   * @returns {Promise<Set<string>>}
   */
  async opened(view, extent) {
    const changed = this.data.base === null ? null : changedGroups(view);
    /** @param {Group} group */
    const mayOpen = (group) => Boolean(view.counts.get(group.id)) && !view.stubs.has(group.id) && (!changed?.size || changed.has(group.id));
    // What changed is to be seen, on narrow screens, too.
    const order = opening(view.root, changed?.size ? MOST : boxesIn(extent.width, extent.height), mayOpen);
    if (view.state.focus !== null && !order.includes(view.state.focus)) order.unshift(view.state.focus);
    if (changed?.size) return withFocus(view, order);
    return (await this.legible(view, order, extent)).open;
  }

  /**
   * What was guessed is measured: the longest start of the order is looked for that can be read.
   * @param {View} view
   * @param {string[]} order
   * @param {{ width: number, height: number }} extent
   * @returns {Promise<Scene>}
   */
  async legible(view, order, extent) {
    /** @param {Scene} tried */
    const isLegible = (tried) => fitting(tried.sheet, extent) >= LEGIBLE;
    /** @param {string[]} ids @returns {Promise<Scene | null>} null where it cannot be read */
    const trial = async (ids) => {
      const open = withFocus(view, ids);
      const whole = this.levels(view, open);
      if (roomOf(whole) > roomIn(extent)) return null;
      const tried = await this.stage(view, open, view, whole);
      return isLegible(tried) ? tried : null;
    };
    let scene = await this.stage(view, withFocus(view, []));
    // Where the fewest boxes are too many already, more of them are no better.
    if (this.screen.density !== "plain") return scene;
    for (const density of isLegible(scene) ? [] : DENSER) {
      this.screen = { ...this.screen, density };
      scene = await this.stage(view, withFocus(view, []));
      if (density === "terse" || isLegible(scene)) return scene;
    }
    if (!order.length) return scene;
    const everything = await trial(order);
    if (everything) return everything;
    let [fits, tooMany] = [0, order.length];
    for (let count = 0; count < TRIALS && tooMany - fits > 1; count++) {
      const middle = Math.floor((fits + tooMany) / 2);
      const tried = await trial(order.slice(0, middle));
      if (tried) [fits, scene] = [middle, tried];
      else tooMany = middle;
    }
    // One large container may keep small ones after it from being opened: some of them get a try of their own.
    const open = new Set(scene.open);
    const rest = order.slice(tooMany).filter((id) => open.has(view.groups.get(id)?.parent ?? "") || view.root.groups.some((each) => each.id === id));
    for (const id of rest.slice(0, TRIALS)) {
      const tried = await trial([...open, id]);
      if (!tried) continue;
      open.add(id);
      scene = tried;
    }
    return scene;
  }

  /** @param {View} view @param {Set<string>} open @returns {Level} */
  levels(view, open) {
    return levelsOf(this.screen.density === "terse" ? { ...view, terse: true } : view, open, this.measure);
  }

  /** @param {View} view @param {Level} whole @param {Set<string>} open @returns {Promise<Map<string, Placed>>} */
  async laidOut(view, whole, open) {
    const fresh = (/** @type {Level} */ level) => layOut(this.engine, level, this.measure, this.cache, this.screen);
    const former = this.before(view);
    if (!former) return fresh(whole);
    const before = this.levels(former, open);
    const turn = (/** @type {Box} */ box) => turnOf(view.entry, box.id);
    return grown(whole, before, { standing: await fresh(before), fresh, turn, measure: this.measure });
  }

  /**
   * @param {View} view that is laid out
   * @param {Set<string>} open
   * @param {View} [shown] what of it is seen
   * @param {Level} [whole] what is in it
   * @returns {Promise<Scene>}
   */
  async stage(view, open, shown = view, whole = this.levels(view, open)) {
    const placed = await this.laidOut(view, whole, open);
    const root = shown === view ? whole : masked(whole, shown, this.measure);
    return { view: shown, open, root, sheet: sheetOf(root, placed), drawn: new Drawn(root) };
  }
}

/** Square pixels that a level takes at the least, however it is laid out. @param {Level} level @returns {number} */
function roomOf({ boxes, edges }) {
  return edges.length * LINE + boxes.reduce((sum, { level, width, height }) => sum + (level ? roomOf(level) : width * height), 0);
}

/** Square pixels of a drawing whose names can be read. @param {{ width: number, height: number }} extent of the viewport, in pixels */
function roomIn(extent) {
  const { width, height } = room(extent);
  return (width * height) / LEGIBLE ** 2;
}

/** @param {{ width: number, height: number }} extent of the viewport, in pixels @returns {import("./model").Screen} */
function screenOf(extent) {
  const { width, height } = room(extent);
  return { aspect: Math.min(WIDEST, Math.max(1 / WIDEST, width / height)), width: width / LEGIBLE, density: "plain" };
}

/** The same state with nothing switched off, filtered or hidden that leaves a place of its own. @param {ViewState} state @returns {ViewState} */
function wholeState(state) {
  return { ...state, layers: { topics: true, services: true, actions: true, params: state.layers.params }, findingsOnly: false, tray: true, hidden: new Set(), filter: "" };
}

/** What of a state decides where things stand, whatever is open of it. @param {ViewState} state */
export function placeKey(state) {
  return viewKey(wholeState(state));
}

/** What of a state decides what is there, whatever is open of it. @param {ViewState} state */
export function viewKey({ entry, configuration, grouping, focus, layers, topicsAsNodes, hubs, danglingOnly, findingsOnly, tray, hidden, filter }) {
  const { topics, services, actions, params } = layers;
  return JSON.stringify([entry, configuration, grouping, focus, topics, services, actions, params, topicsAsNodes, hubs, danglingOnly, findingsOnly, tray, [...hidden].sort(), filter]);
}

/** Containers in which something came, went or changed, and those around them. @param {View} view @returns {Set<string>} */
function changedGroups({ entry, groups, home, touched }) {
  const nodes = new Set(touched);
  entry.nodes.forEach((node, index) => node.mark && nodes.add(index));
  /** @type {Set<string>} */
  const found = new Set();
  for (const node of nodes) {
    for (let group = home.get(node); group && !found.has(group.id); group = groups.get(group.parent)) found.add(group.id);
  }
  return found;
}

/** @param {View} view @param {Iterable<string>} ids @returns {Set<string>} those that are there, and the focus */
function withFocus(view, ids) {
  const open = new Set(Array.from(ids).filter((id) => view.groups.has(id)));
  if (view.state.focus !== null && view.groups.has(view.state.focus)) open.add(view.state.focus);
  return open;
}
