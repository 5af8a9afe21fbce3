// From a state of the view to a sheet: which containers are open, what is in them, and where it stands.

import { layOut } from "./arrange.js";
import { MOST, boxesIn, opening } from "./expansion.js";
import { levelsOf } from "./levels.js";
import { sheetOf } from "./sheet.js";
import { viewOf } from "./view.js";
import { Drawn } from "./walk.js";

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("./types").Group} Group */
/** @typedef {import("./types").ViewState} ViewState */
/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./engine").Engine} Engine */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Sheet} Sheet */
/** @typedef {import("./model").View} View */
/** @typedef {{ view: View, open: Set<string>, root: Level, sheet: Sheet, drawn: Drawn }} Scene */

/** A name of 13 pixels can still be read with ease at this scale. */
const LEGIBLE = 0.66;
/** Layouts that are tried. */
const TRIALS = 4;
const WIDEST = 2.4;

export class Director {
  /** @param {ReportData} data @param {Engine} engine @param {Measure} measure */
  constructor(data, engine, measure) {
    this.data = data;
    this.engine = engine;
    this.measure = measure;
    /** @type {Map<string, Promise<Placed>>} */
    this.cache = new Map();
    /** Width by height of the viewport when the view was first drawn: later changes of its size move nothing. */
    this.aspect = 1;
    this.seen = { key: "", view: /** @type {View | null} */ (null) };
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
    if (!known) this.aspect = Math.min(WIDEST, Math.max(1 / WIDEST, extent.width / extent.height));
    this.seen = { key, view };
    return view;
  }

  /**
   * @param {ViewState} state
   * @param {{ width: number, height: number }} extent of the viewport, in pixels
   * @returns {Promise<Scene>}
   */
  async scene(state, extent) {
    const view = this.view(state, extent);
    if (state.expanded !== "auto") return this.stage(view, withFocus(view, state.expanded));
    const changed = this.data.base === null ? null : changedGroups(view);
    /** @param {Group} group */
    const mayOpen = (group) => Boolean(view.counts.get(group.id)) && !view.stubs.has(group.id) && (!changed?.size || changed.has(group.id));
    // What changed is to be seen, on narrow screens, too.
    const most = changed?.size ? MOST : boxesIn(extent.width, extent.height);
    const order = opening(view.root, most, mayOpen);
    if (view.state.focus !== null && !order.includes(view.state.focus)) order.unshift(view.state.focus);
    let scene = await this.stage(view, withFocus(view, order));
    if (changed?.size || isLegible(scene.sheet, extent)) return scene;
    // What was guessed is measured: the longest start of the order that can be read is looked for.
    let [fits, tooMany] = [0, order.length];
    scene = await this.stage(view, withFocus(view, []));
    for (let trial = 0; trial < TRIALS && tooMany - fits > 1; trial++) {
      const middle = Math.floor((fits + tooMany) / 2);
      const tried = await this.stage(view, withFocus(view, order.slice(0, middle)));
      if (isLegible(tried.sheet, extent)) [fits, scene] = [middle, tried];
      else tooMany = middle;
    }
    // One large container may keep small ones after it from being opened: some of them get a try of their own.
    const open = new Set(scene.open);
    const rest = order.slice(tooMany).filter((id) => open.has(view.groups.get(id)?.parent ?? "") || view.root.groups.some((each) => each.id === id));
    for (const id of rest.slice(0, TRIALS)) {
      const tried = await this.stage(view, withFocus(view, [...open, id]));
      if (!isLegible(tried.sheet, extent)) continue;
      open.add(id);
      scene = tried;
    }
    return scene;
  }

  /** @param {View} view @param {Set<string>} open @returns {Promise<Scene>} */
  async stage(view, open) {
    const root = levelsOf(view, open, this.measure);
    const sheet = sheetOf(root, await layOut(this.engine, root, this.measure, this.cache, this.aspect));
    return { view, open, root, sheet, drawn: new Drawn(root) };
  }
}

/** What of a state decides what is there, whatever is open of it. @param {ViewState} state */
export function viewKey({ entry, configuration, grouping, focus, layers, topicsAsNodes, hubs, danglingOnly, findingsOnly, hidden }) {
  const { topics, services, actions, params } = layers;
  return JSON.stringify([entry, configuration, grouping, focus, topics, services, actions, params, topicsAsNodes, hubs, danglingOnly, findingsOnly, [...hidden].sort()]);
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

/** @param {Sheet} sheet @param {{ width: number, height: number }} extent */
function isLegible(sheet, extent) {
  return Math.min(extent.width / sheet.width, extent.height / sheet.height) >= LEGIBLE;
}
