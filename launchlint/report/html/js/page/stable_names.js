/**
 * Ids of the drawing hold indexes of nodes, channels, params and containers: in an address names stand for them, so that a link outlives a node
 * that comes or goes. "n:3" becomes "n(/a/b)", the second of that name "n(/a/b~~2)".
 */

/** @typedef {import("./model.js").EntryModel} EntryModel */

const INDEXED = /(^|[:>|+])([ncp]):(\d+)(?=$|[|>+:])/g;
const NAMED = /(^|[:>|+])([ncp])\(([^()]*)\)/g;
const CONTAINED = /^(g:file:|g:[a-z]+:[^#]*#f)(\d+)(?=$|\|)/;
const CONTAINER = /^(g:file:|g:[a-z]+:[^#]*#f)\(([^()]*)\)/;
const RANGE = /#n(\d+)$/;
const RANGE_NAMED = /#n\(([^()]*)\)$/;

/** @type {WeakMap<EntryModel, string[]>} */
const known = new WeakMap();

/** A name for each container: what it includes, or its namespace, and where it stands. @param {EntryModel} model */
function containerNames(model) {
  let names = known.get(model);
  if (!names) {
    names = model.entry.containers.map(({ kind, label, namespace }) => `${kind} ${label || namespace}`);
    known.set(model, names);
  }
  return names;
}

/** A name, with its number where several things before it have it. @param {readonly string[]} names @param {number} index */
function numbered(names, index) {
  const name = names[index] ?? "";
  let before = 0;
  for (let at = 0; at < index; at++) if (names[at] === name) before += 1;
  return (before ? `${name}~~${before + 1}` : name).replaceAll(/[%()|>+:#,]/g, (sign) => `%${sign.charCodeAt(0).toString(16)}`);
}

/** @param {readonly string[]} names @param {string} text */
function indexOf(names, text) {
  const name = decoded(text);
  const own = names.indexOf(name);
  const match = /^(.*)~~(\d{1,6})$/s.exec(name);
  if (own >= 0 || !match) return own;
  const all = names.flatMap((each, at) => (each === match[1] ? [at] : []));
  return all[Number(match[2]) - 1] ?? all[0] ?? -1;
}

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

/** @param {EntryModel} model @param {string} kind @returns {readonly string[]} */
function namesOf({ entry }, kind) {
  if (kind === "n") return entry.nodes.map((each) => each.name);
  return kind === "c" ? entry.channels.map((each) => `${each.kind} ${each.name}`) : entry.params.map((each) => each.name);
}

/**
 * An id of a node, container or line, with names instead of indexes.
 *
 * @param {EntryModel} model
 * @param {string} id
 */
export function byName(model, id) {
  return id
    .replace(CONTAINED, (_, before, index) => `${before}(${numbered(containerNames(model), Number(index))})`)
    .replace(RANGE, (_, index) => `#n(${numbered(namesOf(model, "n"), Number(index))})`)
    .replaceAll(INDEXED, (_, before, kind, index) => `${before}${kind}(${numbered(namesOf(model, kind), Number(index))})`);
}

/**
 * The id that such a text stands for; a name that is not there becomes index -1, which nothing has.
 *
 * @param {EntryModel} model
 * @param {string} text
 */
export function byIndex(model, text) {
  return text
    .replace(CONTAINER, (_, before, name) => `${before}${indexOf(containerNames(model), name)}`)
    .replace(RANGE_NAMED, (_, name) => `#n${indexOf(namesOf(model, "n"), name)}`)
    .replaceAll(NAMED, (_, before, kind, name) => `${before}${kind}:${indexOf(namesOf(model, kind), name)}`);
}
