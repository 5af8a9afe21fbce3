// Names as people order and shorten them.

/**
 * Orders names so that cam_2 comes before cam_10.
 * @param {string} one
 * @param {string} other
 * @returns {number}
 */
export function compareNames(one, other) {
  const left = parts(one);
  const right = parts(other);
  for (let at = 0; at < left.length && at < right.length; at++) {
    const [a, b] = [left[at], right[at]];
    if (a === b) continue;
    if (typeof a === "number" && typeof b === "number") return a - b;
    return String(a) < String(b) ? -1 : 1;
  }
  return left.length - right.length || (one < other ? -1 : one > other ? 1 : 0);
}

/** @type {Map<string, (string | number)[]>} */
const known = new Map();

/** @param {string} name @returns {(string | number)[]} */
function parts(name) {
  let found = known.get(name);
  if (found === undefined) {
    found = name.split(/(\d{1,15})/).map((part, at) => (at % 2 ? Number(part) : part));
    known.set(name, found);
  }
  return found;
}

/**
 * The last part of a name: /a/b → b.
 * @param {string} name
 */
export function lastPart(name) {
  return name.slice(name.lastIndexOf("/") + 1) || name;
}

const SPARE = 9;

/**
 * A name within a namespace, at most `most` characters long: what tells it from its neighbours stands at its end, so that stays.
 * @param {string} name
 * @param {string} namespace
 * @param {number} most
 */
export function shortName(name, namespace, most) {
  const inner = namespace.length > 1 && name.startsWith(`${namespace}/`) ? name.slice(namespace.length + 1) : name;
  if (inner.length <= most) return inner;
  const pieces = inner.split("/");
  let tail = pieces.pop() ?? "";
  while (pieces.length > 1 && tail.length + 1 + (pieces[pieces.length - 1] ?? "").length < most - 2) tail = `${pieces.pop()}/${tail}`;
  // Where the end alone leaves much room unused, the beginning tells more: left/… from right/….
  return pieces.length && tail.length + 2 > most - SPARE ? cut(`…/${tail}`, most) : cut(inner, most);
}

/**
 * A text of at most so many characters: its end is kept, for there names differ.
 * @param {string} text
 * @param {number} most
 */
export function cut(text, most) {
  const characters = Array.from(text);
  if (characters.length <= most) return text;
  const head = Math.max(2, Math.floor(most / 4));
  return `${characters.slice(0, head).join("")}…${characters.slice(head + 1 - most).join("")}`;
}

/**
 * Names at most `most` characters long that stand beside each other: those whose ends are the same are told apart by where they differ.
 * @param {readonly string[]} names
 * @param {number} most
 * @returns {Map<string, string>}
 */
export function briefNames(names, most) {
  /** @type {Map<string, string[]>} */
  const alike = new Map();
  for (const name of new Set(names)) {
    const brief = shortName(name, "", most);
    const others = alike.get(brief);
    if (others) others.push(name);
    else alike.set(brief, [name]);
  }
  /** @type {Map<string, string>} */
  const found = new Map();
  for (const [brief, same] of alike) {
    if (same.length === 1) found.set(/** @type {string} */ (same[0]), brief);
    else for (const name of same) found.set(name, fromWhereTheyPart(name, same, most));
  }
  return found;
}

/** @param {string} name @param {readonly string[]} names @param {number} most */
function fromWhereTheyPart(name, names, most) {
  let same = 0;
  while (same < name.length && names.every((each) => each[same] === name[same])) same++;
  const from = Math.max(...["/", "_", "-", "."].map((sign) => name.lastIndexOf(sign, same - 1))) + 1;
  const rest = from > 1 ? `…${name.slice(from)}` : name;
  return rest.length <= most ? rest : `${rest.slice(0, most - 1)}…`;
}

/**
 * "1 node", "3 nodes".
 * @param {number} count
 * @param {string} noun
 */
export function counted(count, noun) {
  return `${count} ${noun}${count === 1 ? "" : "s"}`;
}

/** "c2 (10.0.0.2)". @param {string} name @param {string} address */
export function machineName(name, address) {
  return address && address !== name ? `${name} (${address})` : name;
}

/**
 * A text in at most two lines of about so many characters, parted where names are: behind a / or _, or before a capital.
 * @param {string} text
 * @param {number} most
 * @returns {string[]}
 */
export function inLines(text, most) {
  if (text.length <= most) return [text];
  const middle = text.length / 2;
  let [best, cost] = [0, Infinity];
  for (let at = 1; at < text.length; at++) {
    const [before = "", after = ""] = [text[at - 1], text[at]];
    const kind = before === "/" || before === "_" || before === "-" || before === "." ? 0 : /[a-z]/.test(before) && /[A-Z]/.test(after) ? 2 : Infinity;
    const own = Math.abs(at - middle) + kind;
    if (own < cost) [best, cost] = [at, own];
  }
  return cost > most / 2 ? [text] : [text.slice(0, best), text.slice(best)];
}

/** Whether a machine is the one that roslaunch itself runs on. @param {string} name @param {string} address */
export function isLocal(name, address) {
  const host = address || name;
  return host === "localhost" || host === "127.0.0.1" || host === "::1";
}
