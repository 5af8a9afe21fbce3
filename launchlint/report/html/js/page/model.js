/** The data of the page made ready for questions: who is on which channel, what lies in which namespace. */

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("../data").Entry} Entry */
/** @typedef {import("../data").Connection} Connection */
/** @typedef {import("../data").Place} Place */

/**
 * One entry file with its relations. Lists are by index of node or channel.
 *
 * @typedef {object} EntryModel
 * @property {Entry} entry
 * @property {number} index
 * @property {Connection[][]} ofNode
 * @property {Connection[][]} onChannel
 * @property {number[][]} paramsOf params that a node reads, or that are private to it
 * @property {Map<string, number[]>} nodesNamed
 * @property {Map<string, number>} channelNamed by "kind name"
 * @property {Map<string, number[]>} paramsNamed
 * @property {Map<number, number[]>} nodesWithFinding by finding
 * @property {Map<number, number[]>} channelsWithFinding
 * @property {Map<number, number[]>} paramsWithFinding
 */

/** @typedef {ReturnType<typeof createModel>} Model */

/** @param {ReportData} data */
export function createModel(data) {
  /** @type {Map<number, EntryModel>} */
  const known = new Map();
  /** @type {Map<number, Map<number, string>> | null} */
  let lines = null;
  /** @type {Map<string, string[]>} */
  const md5s = new Map();
  for (const [type, md5] of data.md5s) md5s.set(type, [...(md5s.get(type) ?? []), md5]);
  const findings = new Map(data.findings.map((each, index) => [each.id, index]));
  return {
    data,
    md5s,
    /**
     * The relations of one entry file, worked out when first asked for.
     *
     * @param {number} index
     */
    entry(index) {
      let found = known.get(index);
      if (!found) {
        const entry = data.entries[index];
        if (!entry) throw new Error(`the page has no entry ${index}`);
        found = related(entry, index);
        known.set(index, found);
      }
      return found;
    },
    /**
     * Index of the finding with this id; -1: there is none.
     *
     * @param {string} id
     */
    finding: (id) => findings.get(id) ?? -1,
    /**
     * The line of a file; undefined where the page does not hold it.
     *
     * @param {number} file
     * @param {number} line
     */
    line: (file, line) => (lines ??= new Map(data.lines.map((each) => [each.file, new Map(each.lines)]))).get(file)?.get(line),
    /**
     * "path:line".
     *
     * @param {Place} place
     */
    place: (place) => `${data.files[place[0]] ?? "?"}:${place[1]}`,
  };
}

/**
 * Whether something is there in a configuration (-1: in any).
 *
 * @param {{ only: readonly number[] }} thing
 * @param {number} configuration
 */
export function isIn(thing, configuration) {
  return configuration < 0 || thing.only.length === 0 || thing.only.includes(configuration);
}

/**
 * Whether anybody has a channel in a configuration (-1: in any).
 *
 * @param {EntryModel} model
 * @param {number} channel
 * @param {number} configuration
 */
export function isUsedIn(model, channel, configuration) {
  return configuration < 0 || (model.onChannel[channel] ?? []).some((each) => isIn(each, configuration) && isIn(model.entry.nodes[each.node] ?? each, configuration));
}

/**
 * The findings of an entry file that a configuration has (-1: any), by number.
 *
 * @param {EntryModel} model
 * @param {number} configuration
 */
export function findingsIn({ entry }, configuration) {
  return entry.findings.filter((_, at) => isIn({ only: entry.findingsOnly[at] ?? [] }, configuration));
}

/**
 * The connections at the other end of one, those of the node itself included.
 *
 * @param {EntryModel} model
 * @param {Connection} connection
 * @param {number} configuration
 */
export function peers(model, connection, configuration) {
  const all = model.onChannel[connection.channel] ?? [];
  return all.filter((each) => each.offers !== connection.offers && isIn(each, configuration));
}

/**
 * Which of its ends a channel has in a configuration, as it is now; `certain` says whether any of them is there for certain.
 *
 * @param {EntryModel} model
 * @param {number} channel
 * @param {number} configuration
 */
export function endsOf(model, channel, configuration) {
  const ends = (model.onChannel[channel] ?? []).filter((each) => isIn(each, configuration) && each.mark !== "removed");
  return { offered: ends.some((each) => each.offers), used: ends.some((each) => !each.offers), certain: ends.some((each) => each.certain) };
}

/**
 * Who may be at an end of a channel where nobody is known, in a configuration.
 *
 * @param {EntryModel} model
 * @param {number} channel
 * @param {boolean} offers the end that publishes or serves, or the other
 * @param {number} configuration
 */
export function mayBeAt(model, channel, offers, configuration) {
  const isThere = (/** @type {string} */ node) =>
    (model.nodesNamed.get(node) ?? []).some((index) => isIn(model.entry.nodes[index] ?? { only: [] }, configuration));
  return (model.entry.channels[channel]?.may ?? []).filter((each) => each[0] === offers && (!each[1] || isThere(each[1])));
}

/** @param {string} kind @param {string} name */
export const channelKey = (kind, name) => `${kind} ${name}`;

/** @param {Entry} entry @param {number} index @returns {EntryModel} */
function related(entry, index) {
  /** @type {EntryModel} */
  const model = {
    entry,
    index,
    ofNode: entry.nodes.map(() => []),
    onChannel: entry.channels.map(() => []),
    paramsOf: entry.nodes.map(() => []),
    nodesNamed: listed(entry.nodes.map((each) => each.name)),
    channelNamed: new Map(entry.channels.map((each, at) => [channelKey(each.kind, each.name), at])),
    paramsNamed: listed(entry.params.map((each) => each.name)),
    nodesWithFinding: byFinding(entry.nodes),
    channelsWithFinding: byFinding(entry.channels),
    paramsWithFinding: byFinding(entry.params),
  };
  for (const connection of entry.connections) {
    model.ofNode[connection.node]?.push(connection);
    model.onChannel[connection.channel]?.push(connection);
  }
  for (const [at, param] of entry.params.entries()) {
    const owners = new Set(param.readers);
    for (let end = param.name.lastIndexOf("/"); end > 0; end = param.name.lastIndexOf("/", end - 1)) {
      for (const node of model.nodesNamed.get(param.name.slice(0, end)) ?? []) owners.add(node);
    }
    for (const node of owners) model.paramsOf[node]?.push(at);
  }
  return model;
}

/** @param {string[]} names @returns {Map<string, number[]>} */
function listed(names) {
  const found = new Map();
  for (const [index, name] of names.entries()) {
    const those = found.get(name);
    if (those) those.push(index);
    else found.set(name, [index]);
  }
  return found;
}

/** @param {readonly { findings: number[] }[]} things @returns {Map<number, number[]>} */
function byFinding(things) {
  const found = new Map();
  for (const [index, { findings }] of things.entries()) {
    for (const finding of findings) {
      const those = found.get(finding);
      if (those) those.push(index);
      else found.set(finding, [index]);
    }
  }
  return found;
}
