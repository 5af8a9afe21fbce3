// What the drawing exchanges with the page, and what its own modules exchange with each other.

import type { Mark } from "../data";

export type Grouping = "namespace" | "file" | "package" | "machine";

/** What can be selected. Ids: node "n:<index>", channel "c:<index>", container "g:<grouping>:<path>", edge "e:…", param "p:<index>", way: ids of nodes and channels with | between. */
export interface Selection {
  kind: "node" | "channel" | "container" | "edge" | "param" | "way";
  id: string;
}

export interface Layers {
  topics: boolean;
  services: boolean;
  actions: boolean;
  params: boolean;
}

/** What is to be drawn: all of it is the page's, none of it the drawing's. */
export interface ViewState {
  /** Index into ReportData.entries. */
  entry: number;
  /** Index into Entry.configurations; -1: all joined. */
  configuration: number;
  grouping: Grouping;
  /** Ids of open containers; "auto": as many as can be read (Drawing.expanded says which). */
  expanded: Set<string> | "auto";
  /** Id of the container that is drawn alone, with stubs for what it is connected to; null: everything. */
  focus: string | null;
  layers: Layers;
  topicsAsNodes: boolean;
  hubs: boolean;
  danglingOnly: boolean;
  findingsOnly: boolean;
  /** Whether nodes that are connected with no other one are drawn. */
  tray: boolean;
  /** Ids of containers and nodes that are not drawn. */
  hidden: Set<string>;
  /** What nodes have to be called, or made of, to be drawn: see filter.js; empty: there is no filter. */
  filter: string;
  /** Ids of nodes and channels that a search found: the others are dimmed; null: there is no search. */
  matches: Set<string> | null;
}

/** A place of the drawing: so far right of and below the corner of a box, in pixels of the drawing, and how large it is seen. */
export interface Spot {
  id: string;
  x: number;
  y: number;
  scale: number;
}

/** How much of what is to be drawn is seen. */
export interface Extent {
  /** Nodes in folded boxes, and how many boxes those are. */
  folded: number;
  boxes: number;
  /** Boxes that are not on the screen. */
  outside: number;
}

export interface DrawingEvents {
  /** Somebody moved the drawing on the screen; null: all of it is shown again. */
  moved(spot: Spot | null): void;
  select(selection: Selection | null): void;
  expand(container: string, open: boolean): void;
  busy(on: boolean): void;
}

/** A container of nodes: of namespaces, of the elements of launch files, of packages, or of machines; or a range of too many siblings. */
export interface Group {
  id: string;
  kind: "root" | "namespace" | "group" | "include" | "package" | "machine" | "range" | "tray";
  /** What is written on it. */
  label: string;
  /** All of its name. */
  title: string;
  /** Namespace that names within it are shortened by; empty: none. */
  namespace: string;
  /** Index into Entry.containers; -1: it is none of them. */
  container: number;
  /** Indexes into ReportData.findings that stand in it, and in none of its nodes and no container within. */
  own: number[];
  /** Containers directly in it, in order. */
  groups: Group[];
  /** Indexes of the nodes directly in it, in order of their names. */
  nodes: number[];
  /** Nodes in it and below it. */
  count: number;
  /** Id of the container around it; empty: this is the outermost. */
  parent: string;
}

export interface Drawing {
  /** Draws; the viewport keeps its place where only the expansion changes. */
  show(state: ViewState): Promise<void>;
  /** Lights what is selected, its neighbours and the paths to them; dims the rest. */
  select(selection: Selection | null): void;
  fit(): void;
  zoom(factor: number): void;
  panTo(selection: Selection): void;
  /** A self-contained SVG document of what is drawn. */
  svg(): string;
  /** The same as pixels. */
  png(): Promise<Blob | null>;
  /** Brings a place to the middle of the screen; whether what it is told by is drawn. */
  goTo(spot: Spot): boolean;
  /** What is in the middle of the screen; null: nothing is drawn. */
  spot(): Spot | null;
  extent(): Extent;
  /** What can be selected, in reading order, for the keyboard. */
  focusables(): { selection: Selection; label: string; element: SVGGElement }[];
  /** Whether it is drawn by itself: not folded, filtered or hidden. */
  isDrawn(selection: Selection): boolean;
  /** Ids of the containers that are open now. */
  expanded(): Set<string>;
  /** Ids of the channels and params ("c:3", "p:4") that a line or a pill stands for. */
  wiresOf(selection: Selection): string[];
  /** Id of the innermost drawn box that holds a node (itself, or a folded container); null: none. */
  standsFor(node: number): string | null;
}
