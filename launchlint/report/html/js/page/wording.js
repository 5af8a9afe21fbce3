/** How roles, counts and conditions are put into words: the same as in launchlint's text output. */

/** @typedef {import("../data").Entry} Entry */

/** @type {ReadonlyMap<string, [does: string, missed: string, noun: string]>} */
const ROLES = new Map([
  ["publisher", ["publishes", "nobody subscribes", "Publishers"]],
  ["subscriber", ["subscribes to", "nobody publishes", "Subscribers"]],
  ["server", ["serves", "nobody calls it", "Servers"]],
  ["client", ["calls", "nobody serves it", "Clients"]],
  ["action server", ["serves action", "nobody calls it", "Action servers"]],
  ["action client", ["calls action", "nobody serves it", "Action clients"]],
]);

/** The order in which the roles of a node are shown. */
export const ROLE_ORDER = [...ROLES.keys()];

/** @param {string} role */
const words = (role) => ROLES.get(role.replace("_", " ")) ?? [role, "nobody else uses it", role];

/** "publishes". @param {string} role */
export const does = (role) => words(role)[0];
/** What is said of a name that has nobody at its other end. @param {string} role */
export const missed = (role) => words(role)[1];
/** "Publishers". @param {string} role */
export const nounOf = (role) => words(role)[2];

/**
 * "1 node", "2 nodes".
 *
 * @param {number} count
 * @param {string} one
 * @param {string} [many]
 */
export function number(count, one, many = `${one}s`) {
  return `${count.toLocaleString("en")} ${count === 1 ? one : many}`;
}

/** The verdict in a sentence; empty where no configuration is known that does not load. @param {Entry} entry */
export function notice({ verdict, why, withArgs }) {
  if (verdict === "loads") return withArgs && `loads; ${withArgs}`;
  return `${verdict === "refused" ? "refused by roslaunch" : verdict}: ${why}${withArgs && `; ${withArgs}`}`;
}

/**
 * A configuration as people call it.
 *
 * @param {string} args as on the command line
 */
export function configurationName(args) {
  return args || "default args";
}

/**
 * In which configurations something is, the shorter way; empty where it is in all.
 *
 * @param {Entry} entry
 * @param {readonly number[]} only
 */
export function when(entry, only) {
  if (only.length === 0) return "";
  const names = (/** @type {number[]} */ those) => those.map((each) => configurationName(entry.configurations[each] ?? "")).join(" or ");
  const others = entry.configurations.map((_, index) => index).filter((index) => !only.includes(index));
  if (others.length > 0 && others.length < only.length) return `not with ${names(others)}`;
  return `only with ${names([...only])}`;
}

/**
 * The last part of a resolved name.
 *
 * @param {string} name
 */
export function lastPart(name) {
  return name.slice(name.lastIndexOf("/") + 1) || name;
}
