// The layout of one level with ELK: boxes in layers from left to right, lines at right angles, ports on the sides of boxes.

import { PADDING } from "./boxes.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./model").Box} Box */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Point} Point */
/** @typedef {import("./model").Screen} Screen */
/** @typedef {{ layout(graph: ElkNode): Promise<ElkNode> }} Engine */
/**
 * @typedef {object} ElkNode
 * @property {string} id
 * @property {number} [x]
 * @property {number} [y]
 * @property {number} [width]
 * @property {number} [height]
 * @property {Record<string, string>} [layoutOptions]
 * @property {ElkNode[]} [children]
 * @property {ElkPort[]} [ports]
 * @property {ElkEdge[]} [edges]
 */
/**
 * @typedef {object} ElkPort
 * @property {string} id
 * @property {number} [x]
 * @property {number} [y]
 * @property {number} width
 * @property {number} height
 * @property {{ text: string, x?: number, y?: number, width: number, height: number }[]} [labels]
 * @property {Record<string, string>} layoutOptions
 */
/**
 * @typedef {object} ElkEdge
 * @property {string} id
 * @property {string[]} sources
 * @property {string[]} targets
 * @property {{ startPoint: Point, endPoint: Point, bendPoints?: Point[] }[]} [sections]
 * @property {Point[]} [junctionPoints]
 */

export const LABEL_HEIGHT = 14;
/** Width of a badge beside a hollow port. */
export const BADGE = 17;
/** Between the border of a container and what is in it. */
export const MARGIN = 16;
/** A drawing at least so many pixels long, or wider than a narrow screen, and this much wider than the screen for its height, is folded into rows. */
const LONG = 700;
const WIDER = 1.25;
/** What a pixel costs that is beyond the side of a narrow screen, in pixels of height. */
const DOWNWARDS = 4;
/** Rows have to make it so much smaller. */
const GAIN = 0.9;
/** Forms of rows that are tried: width by height, against the screen's. */
const ROWS = [1, 0.4];
/** The same where names are still too small to be read: there rows end anywhere, and not only where few lines are cut. */
const ROWS_ANYWHERE = 0.75;
/** The same with less room between things, for what the screen does not hold otherwise. */
const DENSE = {
  "elk.spacing.nodeNode": "12",
  "elk.spacing.edgeEdge": "9",
  "elk.spacing.edgeNode": "10",
  "elk.spacing.portPort": "14",
  "elk.spacing.componentComponent": "18",
  "elk.layered.spacing.nodeNodeBetweenLayers": "18",
  "elk.layered.spacing.edgeNodeBetweenLayers": "9",
  "elk.layered.spacing.edgeEdgeBetweenLayers": "8",
};
/** Parts whose layout is kept, by all that it depends on. */
const KEPT = 600;

export const OPTIONS = {
  "elk.algorithm": "layered",
  "elk.direction": "RIGHT",
  "elk.edgeRouting": "ORTHOGONAL",
  "elk.randomSeed": "1",
  "elk.spacing.nodeNode": "22",
  "elk.spacing.edgeEdge": "12",
  "elk.spacing.edgeNode": "14",
  "elk.spacing.portPort": "16",
  "elk.spacing.componentComponent": "26",
  "elk.layered.spacing.nodeNodeBetweenLayers": "26",
  "elk.layered.spacing.edgeNodeBetweenLayers": "12",
  "elk.layered.spacing.edgeEdgeBetweenLayers": "10",
  "elk.layered.nodePlacement.strategy": "BRANDES_KOEPF",
  "elk.layered.nodePlacement.bk.fixedAlignment": "LEFTUP",
  "elk.layered.crossingMinimization.strategy": "LAYER_SWEEP",
  "elk.layered.thoroughness": "7",
  "elk.layered.considerModelOrder.strategy": "NODES_AND_EDGES",
  "elk.layered.considerModelOrder.crossingCounterNodeInfluence": "0.001",
};

/**
 * Lays out boxes that lines connect with each other and with the border.
 * @param {Engine} engine
 * @param {Level} part of a level; its ports are those of the border that it touches
 * @param {Map<string, Placed>} inner the levels of its open boxes, by the id of their container
 * @param {Measure} measure
 * @param {Map<string, Promise<Placed>>} cache
 * @param {Screen} screen
 * @returns {Promise<Placed>} without room around it, but between it and a border that it touches
 */
export async function layOutPart(engine, part, inner, measure, cache, screen) {
  const names = new Names();
  const graph = asGraph(part, inner, measure, names);
  // Parts that differ in their names only look the same: robots of a swarm.
  const key = JSON.stringify([graph, screen]);
  let placed = cache.get(key);
  if (!placed) {
    placed = run(engine, part, graph, screen);
    cache.set(key, placed);
    for (const oldest of cache.keys()) {
      if (cache.size <= KEPT) break;
      cache.delete(oldest);
    }
  }
  return names.given(await placed);
}

/**
 * @param {Engine} engine
 * @param {Level} part
 * @param {ElkNode} graph
 * @param {Screen} screen
 * @returns {Promise<Placed>} by the short ids of the graph
 */
async function run(engine, part, graph, screen) {
  const root = (options = {}) => ({
    id: "root",
    layoutOptions: { "elk.algorithm": "layered", "elk.padding": "[left=0,top=0,right=0,bottom=0]" },
    children: [{ ...graph, layoutOptions: { ...graph.layoutOptions, ...(screen.density === "plain" ? {} : DENSE), ...options } }],
  });
  let best = asPlaced(await engine.layout(root()));
  if (!part.ports.length) {
    /** @param {string} cutting @param {number} ratio @param {boolean} anywhere */
    const inRows = async (cutting, ratio, anywhere) => {
      const rows = { "elk.layered.wrapping.strategy": "MULTI_EDGE", "elk.layered.wrapping.cutting.strategy": cutting, "elk.aspectRatio": String(ratio * screen.aspect) };
      const tried = straightened(asPlaced(await engine.layout(root({ ...rows, "elk.layered.wrapping.multiEdge.improveCuts": String(!anywhere) }))));
      if (isStraight(tried) && costOf(tried, screen) < GAIN * costOf(best, screen)) best = tried;
    };
    for (const ratio of ROWS) {
      if (best.width <= Math.min(LONG, screen.width) || (best.width < WIDER * screen.aspect * best.height && !isNarrow(screen))) break;
      await inRows("ARD", ratio, false);
    }
    const [width, height] = [screen.width, screen.width / screen.aspect];
    // What is far too large for any form is not tried.
    if ((best.width > width || best.height > height) && best.width * best.height < 1.2 * width * height) await inRows("MSD", ROWS_ANYWHERE, true);
  }
  return isStraight(best) ? best : asPlaced(await engine.layout(root({ "elk.layered.nodePlacement.strategy": "NETWORK_SIMPLEX" })));
}

/**
 * The height of a screen that shows all of it; on a narrow one it is better drawn downwards than to be cut at its side.
 * @param {{ width: number, height: number }} size
 * @param {Screen} screen
 */
export function costOf({ width, height }, screen) {
  const cut = isNarrow(screen) ? Math.max(0, width - screen.width) : 0;
  return Math.max(width / screen.aspect, height) + DOWNWARDS * cut;
}

/** @param {Screen} screen */
function isNarrow({ width }) {
  return width < LONG;
}

/** Whether all lines are level or upright: where it folds long drawings, ELK sometimes fails to make them so. @param {Placed} placed */
function isStraight({ edges }) {
  return Array.from(edges.values()).every(({ points }) => isRight(points));
}

/** Whether all of a line is level or upright. @param {Point[]} points */
function isRight(points) {
  return points.every((point, at) => {
    const next = points[at + 1];
    return !next || Math.abs(next.x - point.x) < 0.5 || Math.abs(next.y - point.y) < 0.5;
  });
}

/**
 * Lines that ELK leads back to the row in which they begin and end, as if they had left it, are level; and no line parts where it does not run.
 * @param {Placed} placed
 * @returns {Placed}
 */
function straightened(placed) {
  for (const line of placed.edges.values()) {
    const [first, last] = [line.points[0], line.points[line.points.length - 1]];
    if (!first || !last) continue;
    const isLevel = !isRight(line.points) && isRight([first, last]);
    if (isLevel && !Array.from(placed.boxes.values()).some((box) => isThrough(box, first, last))) line.points = [first, last];
    line.junctions = line.junctions.filter((junction) => isOn(line.points, junction));
  }
  return placed;
}

/** Whether a point is on a line. @param {Point[]} points @param {Point} point */
function isOn(points, { x, y }) {
  return points.some((from, at) => {
    const to = points[at + 1] ?? from;
    return x > Math.min(from.x, to.x) - 1 && x < Math.max(from.x, to.x) + 1 && y > Math.min(from.y, to.y) - 1 && y < Math.max(from.y, to.y) + 1;
  });
}

/** Whether a level line runs through a box, and not only up to it. @param {import("./model").Area} box @param {Point} from @param {Point} to */
function isThrough(box, from, to) {
  const [left, right] = [Math.min(from.x, to.x), Math.max(from.x, to.x)];
  return from.y > box.y && from.y < box.y + box.height && left < box.x + box.width - 0.5 && right > box.x + 0.5;
}

/** Short ids for ELK, which are plain in any case. */
class Names {
  constructor() {
    /** @type {string[]} */
    this.all = [];
    /** @type {Map<string, string>} */
    this.short = new Map();
  }

  /** @param {string} id @returns {string} */
  of(id) {
    let found = this.short.get(id);
    if (found === undefined) {
      found = `i${this.all.length}`;
      this.all.push(id);
      this.short.set(id, found);
    }
    return found;
  }

  /** The same by the ids that the short ones stand for. @param {Placed} placed @returns {Placed} */
  given({ width, height, boxes, ports, labels, edges }) {
    /** @template T @param {Map<string, T>} map @returns {Map<string, T>} */
    const named = (map) => new Map(Array.from(map, ([short, each]) => [this.all[Number(short.slice(1))] ?? short, each]));
    return { width, height, boxes: named(boxes), ports: named(ports), labels: named(labels), edges: named(edges) };
  }
}

/**
 * @param {Level} level
 * @param {Map<string, Placed>} inner
 * @param {Measure} measure
 * @param {Names} names
 * @returns {ElkNode}
 */
function asGraph(level, inner, measure, names) {
  /** @type {Map<string, Edge[]>} */
  const leaving = new Map();
  const entering = new Map();
  for (const edge of level.edges) {
    add(leaving, edge.fromBox, edge);
    add(entering, edge.toBox, edge);
  }
  const children = level.boxes.map((box) => asNode(box, leaving.get(box.id) ?? [], entering.get(box.id) ?? [], inner.get(box.id), measure, names));
  /** @type {ElkPort[]} */
  const ports = level.ports.map((port) => asPort(names.of(port.id), port.out, port.out ? [] : labelAt(leaving.get("") ?? [], port.id), measure));
  const edges = level.edges.map((edge) => ({ id: names.of(edge.id), sources: [names.of(edge.fromPort)], targets: [names.of(edge.toPort)] }));
  const side = ports.length ? MARGIN : 0;
  return {
    id: "level",
    children,
    ports,
    edges,
    layoutOptions: {
      ...OPTIONS,
      "elk.padding": `[left=${side},top=0,right=${side},bottom=0]`,
      "elk.portConstraints": "FIXED_SIDE",
      "elk.portLabels.placement": "INSIDE",
      "elk.nodeSize.constraints": "PORTS PORT_LABELS MINIMUM_SIZE",
    },
  };
}

/**
 * @param {Box} box
 * @param {Edge[]} leaving
 * @param {Edge[]} entering
 * @param {Placed | undefined} inner
 * @param {Measure} measure
 * @param {Names} names
 * @returns {ElkNode}
 */
function asNode(box, leaving, entering, inner, measure, names) {
  /** @type {Map<string, ElkPort>} */
  const ports = new Map();
  const ends = new Map([...leaving.map((edge) => /** @type {const} */ ([edge.fromPort, edge.from])), ...entering.map((edge) => /** @type {const} */ ([edge.toPort, edge.to]))]);
  for (const edge of leaving) if (!ports.has(edge.fromPort)) ports.set(edge.fromPort, asPort(names.of(edge.fromPort), true, edge.label, measure));
  for (const edge of entering) if (!ports.has(edge.toPort)) ports.set(edge.toPort, asPort(names.of(edge.toPort), false, [], measure));
  if (!inner) for (const loose of box.loose) ports.set(loose.id, asPort(names.of(loose.id), loose.out, [loose.label], measure, loose.badge ? BADGE : 0));
  const size = inner ?? box;
  const node = { id: names.of(box.id), width: size.width, height: size.height };
  if (inner || box.kind === "pill") {
    for (const [id, port] of ports) {
      const at = inner?.ports.get(ends.get(id) ?? id) ?? { x: port.layoutOptions["elk.port.side"] === "WEST" ? 0 : box.width, y: box.height / 2 };
      Object.assign(port, { x: at.x, y: at.y });
    }
  }
  return {
    ...node,
    ports: Array.from(ports.values()),
    layoutOptions: {
      "elk.portConstraints": inner || box.kind === "pill" ? "FIXED_POS" : "FIXED_SIDE",
      "elk.portLabels.placement": "OUTSIDE NEXT_TO_PORT_IF_POSSIBLE",
      "elk.nodeSize.constraints": inner || box.kind === "pill" ? "" : "PORTS PORT_LABELS MINIMUM_SIZE",
      "elk.nodeSize.minimum": `(${node.width}, ${node.height})`,
      "elk.portAlignment.default": "CENTER",
    },
  };
}

/**
 * @param {string} id
 * @param {boolean} out
 * @param {string[]} label
 * @param {Measure} measure
 * @param {number} [more] room beside the label
 * @returns {ElkPort}
 */
function asPort(id, out, label, measure, more = 0) {
  const width = Math.ceil(Math.max(0, ...label.map((line) => measure(line, "label")))) + more;
  const labels = width ? [{ text: "x", width: width + PADDING.x, height: label.length * LABEL_HEIGHT + 2 }] : [];
  return { id, width: 0, height: 0, labels, layoutOptions: { "elk.port.side": out ? "EAST" : "WEST" } };
}

/** @param {Edge[]} edges @param {string} port */
function labelAt(edges, port) {
  return edges.find((edge) => edge.from === port)?.label ?? [];
}

/** @param {Map<string, Edge[]>} map @param {string} key @param {Edge} edge */
function add(map, key, edge) {
  const known = map.get(key);
  if (known) known.push(edge);
  else map.set(key, [edge]);
}

/**
 * @param {ElkNode} root
 * @returns {Placed} by the ids that ELK was given
 */
function asPlaced(root) {
  const graph = /** @type {ElkNode} */ (root.children?.[0]);
  /** @type {Placed} */
  const placed = { width: graph.width ?? 0, height: graph.height ?? 0, boxes: new Map(), ports: new Map(), labels: new Map(), edges: new Map() };
  /** @param {ElkPort} port @param {number} x @param {number} y */
  const keep = (port, x, y) => {
    const at = { x: x + (port.x ?? 0), y: y + (port.y ?? 0) };
    const label = port.labels?.[0];
    placed.ports.set(port.id, at);
    if (label) placed.labels.set(port.id, { x: at.x + (label.x ?? 0), y: at.y + (label.y ?? 0), width: label.width, height: label.height });
  };
  for (const port of graph.ports ?? []) keep(port, 0, 0);
  for (const { id, x = 0, y = 0, width = 0, height = 0, ports = [] } of graph.children ?? []) {
    placed.boxes.set(id, { x, y, width, height });
    for (const port of ports) keep(port, x, y);
  }
  for (const edge of graph.edges ?? []) {
    const points = (edge.sections ?? []).flatMap((section) => [section.startPoint, ...(section.bendPoints ?? []), section.endPoint]);
    placed.edges.set(edge.id, { points, junctions: edge.junctionPoints ?? [] });
  }
  return placed;
}
