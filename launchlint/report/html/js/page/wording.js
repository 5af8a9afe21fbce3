/** How roles, counts and conditions are put into words: the same as in launchlint's text output. */

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../data").MayBe} MayBe */

/** @type {ReadonlyMap<string, [does: string, others: string, noun: string]>} */
const ROLES = new Map([
  ["publisher", ["publishes", "subscribes to it", "Publishers"]],
  ["subscriber", ["subscribes to", "publishes it", "Subscribers"]],
  ["server", ["serves", "calls it", "Servers"]],
  ["client", ["calls", "serves it", "Clients"]],
  ["action server", ["serves action", "calls it", "Action servers"]],
  ["action client", ["calls action", "serves it", "Action clients"]],
]);

const MOST_DOUBTED = 3;
/** How many configurations are named. */
const MOST_NAMED = 4;

/** The order in which the roles of a node are shown. */
export const ROLE_ORDER = [...ROLES.keys()];

/** @param {string} role */
const words = (role) => ROLES.get(role.replace("_", " ")) ?? [role, "uses it", role];

/** "publishes". @param {string} role */
export const does = (role) => words(role)[0];
/**
 * What is said of a name that has nobody at its other end, with the doubt that is there.
 *
 * @param {string} role
 * @param {readonly MayBe[]} doubts
 */
export function missed(role, doubts) {
  const who = doubted(doubts);
  return who ? `nobody here ${words(role)[1]}, but ${who} may` : `nobody ${words(role)[1]}`;
}

/** Who may be there, the first of them by name; as the tables say it. @param {readonly MayBe[]} doubts */
export function doubted(doubts) {
  const names = [...new Set(doubts.map((each) => `${each[1] || "another one"} (${why(each)})`))];
  if (names.length > MOST_DOUBTED) names.splice(MOST_DOUBTED, names.length, "others");
  return [names.slice(0, -1).join(", "), ...names.slice(-1)].filter(Boolean).join(" and ");
}

/** @param {MayBe} doubt */
function why([, node, unknown, reason]) {
  return node ? (unknown ? "not known" : "not all of it is known") : reason.replace(/:.*/s, "");
}

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
export function notice({ verdict, why, withArgs, launcher }) {
  if (verdict === "loads") return withArgs && `loads; ${withArgs}`;
  return `${verdict === "refused" ? `refused by ${launcher}` : verdict}: ${why}${withArgs && `; ${withArgs}`}`;
}

/** The launch file, with the args it is started with. @param {ReportData} data @param {number} index */
export function entryTitle(data, index) {
  const entry = data.entries[index];
  return entry ? `${data.files[entry.file]} ${entry.configurations[0] ?? ""}`.trimEnd() : "";
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
 * In which configurations something is, the shorter way, the first of them by name; empty where it is in all.
 *
 * @param {Entry} entry
 * @param {readonly number[]} only
 */
export function when(entry, only) {
  if (only.length === 0) return "";
  const names = (/** @type {number[]} */ those) => {
    const named = those.map((each) => configurationName(entry.configurations[each] ?? ""));
    if (named.length > MOST_NAMED + 1) named.splice(MOST_NAMED, named.length, `${named.length - MOST_NAMED} others`);
    return named.join(" or ");
  };
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
