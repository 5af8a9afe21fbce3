// Which lines may run together. ELK draws lines that share a port as one net, so a shared port must not say that two things are
// connected that are not: lines run together where they leave one place with the same wires, and where all of some places are
// connected with all of some others.

/** @typedef {import("./model").Edge} Edge */

/**
 * Gives the lines of a level their ports.
 * @param {Edge[]} edges
 */
export function joinLines(edges) {
  /** @type {Map<string, Edge[]>} */
  const nets = new Map();
  /** @type {Map<string, Set<string>>} nets at each port of the border */
  const borders = new Map();
  for (const edge of edges) {
    const net = netOf(edge);
    const known = nets.get(net);
    if (known) known.push(edge);
    else nets.set(net, [edge]);
    for (const border of bordersOf(edge)) borders.set(border, (borders.get(border) ?? new Set()).add(net));
  }
  for (const [net, own] of nets) {
    const everybody = new Set(own.map((edge) => edge.from)).size * new Set(own.map((edge) => edge.to)).size === own.length;
    const alone = own.every((edge) => bordersOf(edge).every((border) => borders.get(border)?.size === 1));
    for (const edge of own) {
      const leavesAlone = edge.toBox === "" && !(everybody && alone);
      edge.fromPort = edge.fromBox === "" ? edge.from : `${edge.from}|o|${leavesAlone ? edge.id : net}`;
      edge.toPort = edge.toBox === "" ? edge.to : `${edge.to}|i|${everybody && alone ? net : edge.id}`;
    }
  }
}

/** Lines that look alike and carry the same. @param {Edge} edge */
function netOf({ classes, wires }) {
  return `${classes.join(".")} ${wires.map((wire) => wire.id).join()}`;
}

/** @param {Edge} edge */
function bordersOf({ from, fromBox, to, toBox }) {
  return [...(fromBox === "" ? [from] : []), ...(toBox === "" ? [to] : [])];
}
