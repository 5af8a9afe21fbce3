// A filter as people write it: "camera", "/left/*", "type:Image", "package:nav", and "-rviz" for what shall not be there.

/** @typedef {import("../data").Entry} Entry */
/** @typedef {{ without: boolean, key: "name" | "type" | "package", fits: (text: string) => boolean }} Term */

/** Words before a colon, and what they are about. */
const KEYS = new Map(/** @type {const} */ ([["name", "name"], ["type", "type"], ["package", "package"], ["pkg", "package"]]));
const MOST_TERMS = 16;
const LONGEST = 200;

/**
 * The terms of a filter.
 * @param {string} text
 * @returns {Term[]}
 */
export function termsOf(text) {
  return text.slice(0, LONGEST).split(/\s+/).filter(Boolean).slice(0, MOST_TERMS).flatMap((word) => {
    const without = word.length > 1 && word.startsWith("-");
    const plain = without ? word.slice(1) : word;
    const colon = plain.indexOf(":");
    const key = KEYS.get(/** @type {"name"} */ (plain.slice(0, Math.max(0, colon)).toLowerCase()));
    const pattern = key ? plain.slice(colon + 1) : plain;
    return pattern ? [{ without, key: key ?? "name", fits: globbed(pattern.toLowerCase()) }] : [];
  });
}

/**
 * What has a filter's text in it; with a star, what fits as a whole. Every star takes the first place that it can: no pattern takes long.
 * @param {string} pattern in lower case
 * @returns {(text: string) => boolean}
 */
function globbed(pattern) {
  if (!pattern.includes("*")) return (text) => text.toLowerCase().includes(pattern);
  const pieces = pattern.split("*");
  const [first = "", last = ""] = [pieces[0], pieces[pieces.length - 1]];
  return (text) => {
    const whole = text.toLowerCase();
    if (!whole.startsWith(first) || !whole.endsWith(last) || whole.length < first.length + last.length) return false;
    let at = first.length;
    for (const piece of pieces.slice(1, -1)) {
      const found = whole.indexOf(piece, at);
      if (found < 0) return false;
      at = found + piece.length;
    }
    return at <= whole.length - last.length;
  };
}

/**
 * Whether each node fits a filter: by its own name or that of something it is connected with, by the types of what it is connected with, or by
 * its package. What a term with a minus names is left out by the node's own name.
 * @param {Entry} entry
 * @param {Term[]} terms
 * @returns {Uint8Array}
 */
export function fittingNodes(entry, terms) {
  /** @type {Set<number>[]} */
  const channels = entry.nodes.map(() => new Set());
  for (const { node, channel } of entry.connections) if (!entry.channels[channel]?.plumbing) channels[node]?.add(channel);
  return Uint8Array.from(entry.nodes, (node, index) => {
    const own = [...(channels[index] ?? [])].flatMap((at) => entry.channels[at] ?? []);
    /** @param {Term} term */
    const fits = ({ key, without, fits: is }) => {
      if (key === "package") return is(node.package);
      if (key === "type") return own.some((each) => each.types.some(is));
      return is(node.name) || (!without && own.some((each) => !each.hub && is(each.name)));
    };
    return Number(terms.every((term) => fits(term) !== term.without));
  });
}

/**
 * Whether something of these types may be drawn: with terms about types, what fits one of them.
 * @param {Term[]} terms
 * @param {string[]} types
 */
export function fitsType(terms, types) {
  return terms.every(({ key, without, fits }) => key !== "type" || types.some(fits) !== without);
}
