/**
 * Any combination of the args of a launch file. Some were evaluated; of any other one, what it starts follows from these: args that act on the
 * same things were combined, and what each of the others does it does whatever the rest is.
 */

/** @typedef {import("../data").Entry} Entry */
/** @typedef {readonly (readonly [name: string, value: string])[]} Pairs */
/** @typedef {{ name: string, values: string[] }} Choice */

/** The args that make a difference, each with the values it can be given. @param {Entry} entry @returns {Choice[]} */
export function choices({ given }) {
  /** @type {Map<string, Set<string>>} */
  const found = new Map();
  for (const [name, value] of given.flat()) found.set(name, (found.get(name) ?? new Set()).add(value));
  return [...found].map(([name, values]) => ({ name, values: [...values].sort() }));
}

/**
 * The number of the configuration with these args; one that was not evaluated is added to the entry.
 *
 * @param {Entry} entry
 * @param {Pairs} pairs
 */
export function configurationOf(entry, pairs) {
  const known = entry.given.findIndex((each, at) => (at === 0 || each.length > 0) && each.length === pairs.length && contains(pairs, each));
  return known >= 0 ? known : add(entry, pairs);
}

/**
 * The number of the configuration that is spelled so; -1: there is none.
 *
 * @param {Entry} entry
 * @param {string} text
 */
export function configurationNamed(entry, text) {
  const known = entry.configurations.indexOf(text);
  if (known >= 0) return known;
  const start = entry.configurations[0] ?? "";
  const rest = text.startsWith(start) ? text.slice(start.length).trimStart() : null;
  const pairs = rest === null ? null : read(rest, choices(entry));
  return pairs ? configurationOf(entry, pairs) : -1;
}

/** What starts the launch file so; empty where it cannot be typed. @param {Entry} entry @param {number} configuration */
export function commandOf(entry, configuration) {
  const pairs = entry.given[configuration] ?? [];
  return entry.command && [entry.command, ...pairs.map(([name, value]) => quoted(`${name}:=${value}`))].join(" ");
}

/** As for a shell. @param {string} word */
function quoted(word) {
  return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'"'"'`)}'`;
}

/** @param {Pairs} all @param {Pairs} some */
function contains(all, some) {
  return some.every(([name, value]) => all.some((each) => each[0] === name && each[1] === value));
}

/** "a:=1 b:=2" as pairs, in the order of the choices; null where it says anything else. @param {string} text @param {readonly Choice[]} known @returns {Pairs | null} */
function read(text, known) {
  if (text === "") return [];
  for (const { name, values } of known) {
    for (const value of values) {
      const word = `${name}:=${value}`;
      if (text !== word && !text.startsWith(`${word} `)) continue;
      const rest = read(text.slice(word.length).trimStart(), known.filter((each) => each.name !== name));
      if (rest) return [/** @type {const} */ ([name, value]), ...rest];
    }
  }
  return null;
}

/** @param {Entry} entry @param {Pairs} pairs */
function add(entry, pairs) {
  const number = entry.configurations.length;
  const within = entry.given.flatMap((each, at) => (at > 0 && each.length > 0 && contains(pairs, each) ? [at] : []));
  const largest = within.filter((at) => !within.some((other) => bigger(entry.given[other] ?? [], entry.given[at] ?? [])));
  /** @type {Map<readonly number[], number[]>} */
  const known = new Map();
  /** Where something is, with the new configuration. @param {number[]} only */
  const extended = (only) => {
    let found = known.get(only);
    if (!found) {
      const first = only.includes(0);
      const there = largest.some((at) => only.includes(at) !== first) ? !first : first;
      found = only.length > 0 && there ? [...only, number] : only;
      known.set(only, found);
    }
    return found;
  };
  for (const each of [...entry.nodes, ...entry.connections, ...entry.params]) each.only = extended(each.only);
  entry.findingsOnly = entry.findingsOnly.map(extended);
  entry.given.push(pairs.map(([name, value]) => [name, value]));
  entry.configurations.push([entry.configurations[0], ...pairs.map(([name, value]) => `${name}:=${value}`)].filter(Boolean).join(" "));
  return number;
}

/** @param {Pairs} one @param {Pairs} other */
const bigger = (one, other) => one.length > other.length && contains(one, other);
