/**
 * The view as the fragment of the page's address and back. Everything goes by name, so that a link outlives changes elsewhere in the launch
 * files; what an address says that is not on the page is left out silently.
 */

import { configurationNamed } from "./combination.js";
import { channelKey } from "./model.js";
import { byIndex, byName } from "./stable_names.js";
import { initialState, LAYERS } from "./state.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("./model.js").EntryModel} EntryModel */
/** @typedef {import("./state.js").PageState} PageState */
/** @typedef {import("./state.js").Target} Target */

const FLAGS = /** @type {const} */ (["topicsAsNodes", "hubs", "danglingOnly", "findingsOnly", "tray"]);
const CHANNELS = ["topic", "service", "action"];
const GROUPINGS = ["namespace", "file", "package", "machine"];

/**
 * "node=/a/b&group=file": what differs from the view that opens first; empty where nothing does.
 *
 * @param {Model} model
 * @param {PageState} state
 */
export function addressOf(model, state) {
  if (state.landing) return "";
  const first = initialState();
  const entry = model.entry(state.entry);
  /** @type {[string, string][]} */
  const pairs = [];
  if (state.selection) pairs.push(target(entry, state.selection));
  if (state.entry !== first.entry) pairs.push(["entry", model.data.files[entry.entry.file] ?? ""]);
  if (state.configuration >= 0) pairs.push(["configuration", entry.entry.configurations[state.configuration] ?? ""]);
  if (state.grouping !== first.grouping) pairs.push(["group", state.grouping]);
  if (state.focus !== null) pairs.push(["focus", pathOf(entry, state.focus)]);
  if (state.expanded !== "auto") pairs.push(["open", many([...state.expanded].map((id) => pathOf(entry, id)))]);
  if (state.hidden.size > 0) pairs.push(["hide", many([...state.hidden].map((id) => hiddenName(entry, id)))]);
  if (LAYERS.some((layer) => state.layers[layer] !== first.layers[layer])) {
    pairs.push(["layers", LAYERS.filter((layer) => state.layers[layer]).join()]);
  }
  for (const flag of FLAGS) if (state[flag] !== first[flag]) pairs.push([flag, state[flag] ? "yes" : "no"]);
  if (state.filter) pairs.push(["filter", state.filter]);
  if (state.place) pairs.push(["at", placeText(entry, state.place)]);
  // Where there are several launch files, an address that says nothing is that of the landing page.
  if (pairs.length === 0 && model.data.entries.length > 1) pairs.push(["entry", model.data.files[entry.entry.file] ?? ""]);
  return pairs.map(([key, value]) => `${key}=${key === "open" || key === "hide" ? value : escape(value)}`).join("&");
}

/**
 * The view that an address describes.
 *
 * @param {Model} model
 * @param {string} hash with or without "#"
 * @returns {PageState}
 */
export function stateOf(model, hash) {
  const said = pairsOf(hash);
  const state = initialState();
  const wanted = wantedOf(said);
  state.landing = said.size === 0 && model.data.entries.length > 1;
  if (state.landing) return state;
  state.entry = entryOf(model, said, wanted) ?? state.entry;
  const entry = model.entry(state.entry);
  const configuration = said.get("configuration");
  if (configuration !== undefined) state.configuration = configurationNamed(entry.entry, configuration);
  const grouping = said.get("group") ?? "";
  if (GROUPINGS.includes(grouping)) state.grouping = /** @type {PageState["grouping"]} */ (grouping);
  const outside = (/** @type {string} */ path) => byIndex(entry, `g:${state.grouping}:${path}`);
  const focus = said.get("focus");
  if (focus) state.focus = outside(focus);
  const open = said.get("open");
  if (open !== undefined) state.expanded = new Set(parts(open).map(outside));
  state.hidden = new Set(parts(said.get("hide") ?? "").flatMap((each) => unstable(entry, each)));
  const layers = said.get("layers")?.split(",");
  if (layers) for (const layer of LAYERS) state.layers[layer] = layers.includes(layer);
  for (const flag of FLAGS) if (said.has(flag)) state[flag] = said.get(flag) === "yes";
  state.filter = said.get("filter") ?? "";
  state.place = placeOf(entry, said.get("at") ?? "");
  state.selection = wanted && found(model, entry, state.grouping, wanted);
  return state;
}

/**
 * The fragment that selects one thing and changes nothing else; empty where it cannot be named.
 *
 * @param {EntryModel} entry
 * @param {Target} selection
 * @returns {[kind: string, name: string]}
 */
function target(entry, selection) {
  const { kind, id } = selection;
  const index = Number(id.slice(2));
  if (kind === "node") return ["node", numbered(entry.nodesNamed, entry.entry.nodes[index]?.name ?? "", index)];
  if (kind === "channel") return [entry.entry.channels[index]?.kind ?? "topic", entry.entry.channels[index]?.name ?? ""];
  if (kind === "param") return ["param", numbered(entry.paramsNamed, entry.entry.params[index]?.name ?? "", index)];
  if (kind === "container") return ["container", pathOf(entry, id)];
  return [kind, kind === "edge" || kind === "pair" ? byName(entry, id) : id];
}

/**
 * The thing of an entry that an address names.
 *
 * @param {Model} model
 * @param {EntryModel} entry
 * @param {string} grouping
 * @param {[kind: string, name: string]} wanted
 * @returns {Target | null}
 */
function found(model, entry, grouping, [kind, name]) {
  if (kind === "node") return indexed("node", "n:", one(entry.nodesNamed, name));
  if (kind === "param") return indexed("param", "p:", one(entry.paramsNamed, name));
  if (CHANNELS.includes(kind)) return indexed("channel", "c:", entry.channelNamed.get(channelKey(kind, name)));
  if (kind === "container") return { kind, id: byIndex(entry, `g:${grouping}:${name}`) };
  if (kind === "finding") return model.finding(name) < 0 ? null : { kind, id: name };
  if (kind === "edge" || kind === "pair") return { kind, id: byIndex(entry, name) };
  return null;
}

/** @param {"node" | "param" | "channel"} kind @param {string} prefix @param {number | undefined} index @returns {Target | null} */
function indexed(kind, prefix, index) {
  return index === undefined ? null : { kind, id: `${prefix}${index}` };
}

/**
 * The entry file that an address means: the one it names, else the first that has what it selects.
 *
 * @param {Model} model
 * @param {Map<string, string>} said
 * @param {[kind: string, name: string] | null} wanted
 */
function entryOf(model, said, wanted) {
  const file = said.get("entry");
  const { entries } = model.data;
  if (file !== undefined) return positive(entries.findIndex((each) => model.data.files[each.file] === file));
  if (!wanted) return undefined;
  const [kind, name] = wanted;
  if (kind === "finding") {
    const finding = model.finding(name);
    return finding < 0 ? undefined : positive(entries.findIndex((each) => each.findings.includes(finding)));
  }
  const plain = withoutNumber(name)[0];
  const has = (/** @type {import("../data").Entry} */ each) =>
    (kind === "node" && each.nodes.some((node) => node.name === plain)) ||
    (kind === "param" && each.params.some((param) => param.name === plain)) ||
    (CHANNELS.includes(kind) && each.channels.some((channel) => channel.kind === kind && channel.name === name));
  return positive(entries.findIndex(has));
}

/** @param {number} index */
const positive = (index) => (index < 0 ? undefined : index);

/** @param {Map<string, string>} said @returns {[kind: string, name: string] | null} */
function wantedOf(said) {
  for (const kind of ["finding", "node", ...CHANNELS, "param", "container", "edge", "pair"]) {
    const name = said.get(kind);
    if (name) return [kind, name];
  }
  return null;
}

/** @param {string} hash @returns {Map<string, string>} */
function pairsOf(hash) {
  const said = new Map();
  for (const pair of hash.replace(/^#/, "").split("&")) {
    const [key = "", ...rest] = pair.split("=");
    const value = rest.join("=");
    if (rest.length > 0 && !said.has(key)) said.set(key, key === "open" || key === "hide" ? value : unescape(value));
  }
  return said;
}

/** A name, with its number where several things have it. @param {Map<string, number[]>} named @param {string} name @param {number} index */
function numbered(named, name, index) {
  const at = named.get(name)?.indexOf(index) ?? 0;
  return at > 0 ? `${name}~~${at + 1}` : name;
}

/** @param {Map<string, number[]>} named @param {string} text */
function one(named, text) {
  const [name, at] = withoutNumber(text);
  const those = named.get(text) ?? named.get(name) ?? [];
  return those[named.has(text) ? 0 : at - 1] ?? those[0];
}

/** @param {string} text @returns {[name: string, number: number]} */
function withoutNumber(text) {
  const match = /^(.*)~~(\d{1,6})$/s.exec(text);
  return match ? [match[1] ?? "", Number(match[2])] : [text, 1];
}

/** An id of something hidden, by name instead of index; all nodes of a name are hidden together. @param {EntryModel} entry @param {string} id */
function hiddenName(entry, id) {
  return id.startsWith("n:") ? `n:${entry.entry.nodes[Number(id.slice(2))]?.name ?? ""}` : byName(entry, id);
}

/** @param {EntryModel} entry @param {string} text @returns {string[]} */
function unstable(entry, text) {
  return text.startsWith("n:") ? (entry.nodesNamed.get(text.slice(2)) ?? []).map((index) => `n:${index}`) : [byIndex(entry, text)];
}

/** The path in a container's id, by name. @param {EntryModel} entry @param {string} id */
const pathOf = (entry, id) => byName(entry, id).split(":").slice(2).join(":");

/** "x,y,scale,name": what of the drawing is in the middle of the screen. @param {EntryModel} entry @param {NonNullable<PageState["place"]>} place */
function placeText(entry, { id, x, y, scale }) {
  return `${Math.round(x)},${Math.round(y)},${Math.round(scale * 100)},${byName(entry, id)}`;
}

/** @param {EntryModel} entry @param {string} text @returns {PageState["place"]} */
function placeOf(entry, text) {
  const match = /^(-?\d{1,6}),(-?\d{1,6}),(\d{1,4}),(.*)$/s.exec(text);
  return match && { x: Number(match[1]), y: Number(match[2]), scale: Number(match[3]) / 100, id: byIndex(entry, match[4] ?? "") };
}

/** @param {string[]} values */
const many = (values) => values.map((each) => encodeURIComponent(each).replaceAll("%2F", "/")).join();
/** @param {string} text @returns {string[]} */
const parts = (text) => text.split(",").filter(Boolean).map(unescape);

/** Percent-encoded, but for what is harmless in a fragment and stands in every name. @param {string} text */
function escape(text) {
  return encodeURIComponent(text).replaceAll(/%(?:2F|3A|3D|2C)/g, decodeURIComponent);
}

/** @param {string} text */
function unescape(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
