// What the modules of the drawing hand to each other, in this order: view → levels → laid out → items on the page.

import type { Entry, Finding, Mark, MayBe } from "../data";
import type { Group, ViewState } from "./types";
import type { Presence } from "./presence";

export type WireKind = "topic" | "service" | "action" | "param";

/** One node at one side of a wire. */
export interface End {
  node: number;
  when: number;
  certain: boolean;
  changed: boolean;
  /** Of a topic in ROS 2. */
  qos?: string | undefined;
}

/** A channel or a shared param, with who gives (data flows from there) and who takes; services and actions flow from clients to servers. */
export interface Wire {
  /** Id of its selection: "c:3", "p:4". */
  id: string;
  kind: WireKind;
  name: string;
  types: string[];
  givers: End[];
  takers: End[];
  /** Drawn as a pill at its home: many-to-many, a param, or topics are nodes. */
  pilled: boolean;
  /** Even a wire with one box at one side is a pill. */
  always: boolean;
  findings: number[];
  mark: Mark | "";
  /** Who may be at an empty end. */
  may?: MayBe[];
}

/** A connection that nobody shares. */
export interface Loose {
  wire: Wire;
  gives: boolean;
  certain: boolean;
  mark: Mark | "";
}

/** What of an entry is drawn. */
export interface View {
  entry: Entry;
  state: ViewState;
  findings: Finding[];
  presence: Presence;
  now: number;
  /** The tree that is drawn; with a focus, it and its surroundings. */
  root: Group;
  groups: Map<string, Group>;
  /** Whether a node is drawn, and how many of a group are. */
  shown: Uint8Array;
  counts: Map<string, number>;
  /** Innermost container of each node, by its index in the entry. */
  home: Map<number, Group>;
  wires: Wire[];
  loose: Map<number, Loose[]>;
  /** Params that only one node reads, counted. */
  params: Map<number, number>;
  /** Nodes with connections that came, went or changed since the revision compared with. */
  touched: Set<number>;
  /** Ids of groups that stand for what is around the focus. */
  stubs: Set<string>;
  /** The place of each node in the order of the launch files, by its index. */
  ranks: Int32Array;
  /** Boxes have names only. */
  terse?: boolean;
  /** Machines that nodes of the launch file run on, roslaunch's own among them. */
  machines: number;
}

export interface Line {
  text: string;
  /** CSS class of the text. */
  kind: "title" | "detail" | "condition" | "host" | "count";
}

export interface Badge {
  severity: Finding["severity"];
  count: number;
  /** Whether all of them stand elsewhere, and only speak of this, too. */
  elsewhere: boolean;
}

/** A node, a folded container, an open one, a pill or a stub. */
export interface Box {
  id: string;
  kind: "node" | "folded" | "open" | "pill";
  /** CSS classes that tell its variant. */
  classes: string[];
  lines: Line[];
  /** What a screen reader and a tooltip say. */
  title: string;
  badge: Badge | null;
  width: number;
  height: number;
  /** Wires that a pill stands for. */
  wires: Wire[];
  loose: LoosePort[];
  level: Level | null;
}

/** A hollow port of a node: one loose connection, or several. */
export interface LoosePort {
  id: string;
  out: boolean;
  wires: Wire[];
  label: string;
  classes: string[];
  badge: Badge | null;
}

/** Where wires pass the border of an open container. */
export interface Port {
  id: string;
  out: boolean;
  kind: WireKind;
  wires: Wire[];
  when: number;
  certain: boolean;
  changed: boolean;
}

/** A line between two things of one level: ids of a box, of a port of an open box in it, or of a port of the level itself. */
export interface Edge {
  id: string;
  from: string;
  to: string;
  /** Boxes of this level that the ends belong to; empty: the level's own border. */
  fromBox: string;
  toBox: string;
  kind: WireKind;
  wires: Wire[];
  label: string[];
  classes: string[];
  /** Ids of the ports that ELK shall use; lines with the same one fork there. */
  fromPort: string;
  toPort: string;
}

/** An end of a wire as a level sees it: at a box, and there at a port where the box is open; without a box, at the level's border. */
export interface Tip {
  id: string;
  box: string;
  when: number;
  certain: boolean;
  changed: boolean;
}

/** The inside of one open container. */
export interface Level {
  group: Group;
  boxes: Box[];
  ports: Port[];
  edges: Edge[];
}

export interface Area {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Point {
  x: number;
  y: number;
}

/** A level with sizes and places, relative to its upper left corner. */
/** What a drawing is made for: its width by its height, and the width, in pixels of the drawing, at which names can be read. */
export interface Screen {
  aspect: number;
  width: number;
  /** How much room things have; where it is little, they stand closer together, and terse boxes have names only. */
  density: "plain" | "dense" | "terse";
}

export interface Placed {
  width: number;
  height: number;
  boxes: Map<string, Area>;
  /** Ports of the level's border, and of its boxes. */
  ports: Map<string, Point>;
  /** Names beside ports, by the id of the port. */
  labels: Map<string, Area>;
  edges: Map<string, { points: Point[]; junctions: Point[] }>;
}

/** All that is drawn, in places of the drawing: what the painter and the tests read. */
export interface Sheet {
  width: number;
  height: number;
  boxes: (Area & { box: Box; depth: number })[];
  edges: { edge: Edge; points: Point[]; junctions: Point[]; /** Whether it ends at a box, not at a border. */ arrives: boolean }[];
  labels: (Area & { lines: string[]; classes: string[]; edge: Edge })[];
  /** Where lines pass borders. */
  ports: (Point & { port: Port })[];
  loose: (Point & { port: LoosePort; box: Box; label: Area | null })[];
}
