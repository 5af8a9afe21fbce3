// What the page is made from, written by launchlint/report/html/data.py. In the page it is packed, and entry files are unpacked when something
// of them is first asked for: read it with
//   read(document.getElementById("launchlint-data").textContent)   from ./unpack.js
// which gives ReportData exactly as it is declared here.
// Names in it come from untrusted files: show them with textContent only, key them in Maps only.

/** Index into ReportData.files, line and column from 1. */
export type Place = [file: number, line: number, column: number];

export interface ReportData {
  format: 1;
  title: string;
  /** Version of launchlint that wrote the page. */
  version: string;
  /** Prefix of a link to a line, always http(s) and with a slash at its end; null where unknown. sourceLink() of ./links.js makes the link. */
  sourceUrl: string | null;
  /** Revision it is compared with; null where the page shows one state only. */
  base: string | null;
  /** Paths as shown to people, relative. One path stands here twice where both revisions of a comparison are referred to. */
  files: string[];
  /** Indexes of the files that are meant as they were in `base`: places of what was removed. */
  baseFiles: number[];
  /** Lines of files that anything on the page refers to, with two lines around findings: sorted by line. */
  lines: { file: number; lines: [line: number, text: string][] }[];
  /** MD5 of types as libraries say it, sorted by type; a type of which they say several stands here as often. */
  md5s: [type: string, md5: string][];
  findings: Finding[];
  /** Findings at `base` that are there no more: no number of the page counts them. */
  fixed: Finding[];
  /** The first one is what the page shows first: what changed since `base`, then files that no other one includes, the larger ones first. */
  entries: Entry[];
  /** Programs that appear on the page, and all of libraries given by hand. */
  library: Program[];
  /** How many programs of libraries given by hand are not among them. */
  libraryLeftOut: number;
  /** Of all entries, as `launchlint check` says it. */
  sight: Sight;
  mend: Mend;
  /** What is told of the run as a whole. */
  notices: string[];
}

/** How many of the nodes that are started without args are known; both 0 where nobody looked. */
export type Sight = [known: number, nodes: number];

/** What makes programs known: one command for those whose packages are here, a sentence on the others; empty where that helps none. */
export interface Mend {
  command: string;
  advice: string;
}

/** Somebody who may be at an empty end: the end that offers, or the other; the name is empty for what is no node, the reason where the node says it. */
export type MayBe = [offers: boolean, node: string, unknown: boolean, reason: string];

export type Mark = "added" | "removed" | "changed";

/** One entry file, all its configurations joined. */
export interface Entry {
  file: number;
  /** What roslaunch makes of it, started as it stands. */
  verdict: "loads" | "refused" | "cannot be told";
  /** The command that starts it. */
  launcher: string;
  /** Why it is refused, or what is missing so that it cannot be told; empty where it loads. */
  why: string;
  /** Which other configuration roslaunch refuses, and why: "refused with sim:=true: …"; empty where none is known. */
  withArgs: string;
  /** Args of each configuration as on the command line; the first is the default one (often ""). */
  configurations: string[];
  /** The same as names and values, without what it is started with anyway. */
  given: [name: string, value: string][][];
  /** Whether of any other combination of their args it can be told what it starts: args that act on the same things were all combined. */
  whole: boolean;
  /** What starts it, on the command line; empty where it cannot be typed. */
  command: string;
  /** Whether every include could be followed. */
  complete: boolean;
  /** Launch files in Python that are not known as a whole, with the reasons, each behind its line; absent where there are none. */
  python?: { file: string; state: "partly" | "not"; reasons: [number, string][] }[];
  sight: Sight;
  mend: Mend;
  containers: Container[];
  nodes: Node[];
  channels: Channel[];
  connections: Connection[];
  params: Param[];
  /** Indexes into ReportData.findings of those that this entry reaches. */
  findings: number[];
  /** Of each of these the indexes of the configurations that have it; empty: all. */
  findingsOnly: number[][];
  /** In a comparison: what is otherwise, in words ("−3 connections"), the weightiest first; empty where nothing is, or nothing is compared. */
  changes: [looks: Mark, words: string][];
  /** Indexes into ReportData.fixed of findings that it had at `base`. */
  fixed: number[];
  /** Of the whole file, in a comparison. */
  mark?: Mark;
}

/** A <group> or <include> around nodes. */
export interface Container {
  kind: "group" | "include";
  /** Namespace of a group (empty where it has none of its own), file of an include. */
  label: string;
  namespace: string;
  place: Place | null;
  /** Index of the container around it; -1: none. It may come after this one. */
  parent: number;
  /** Indexes into ReportData.findings that stand in it, and in none of its nodes and no container within. */
  findings: number[];
  /** Args of an include: what it passes, and what the file has by default; null: nothing. */
  args?: [name: string, value: string | null, fallback: string | null][];
  mark?: Mark;
}

export interface Node {
  /** Resolved name: /a/b. Several may share it. */
  name: string;
  program: string;
  package: string;
  executable: string;
  /** node, nodelet, nodelet manager, component …: launchlint/graph/connections.py Instance.kind. */
  kind: string;
  /** known, template, unknown …: Instance.knowledge; reason says why it is not known. */
  knowledge: string;
  reason: string;
  /** What makes it known: a probe, as its package is here; its sources, which are not; empty where it is known, or nothing helps. */
  learn: "probe" | "sources" | "";
  host: string;
  /** Name of the <machine> it runs on, and its address, which may be empty; empty: where roslaunch itself runs. */
  machine: [] | [name: string, address: string];
  namespace: string;
  isTest: boolean;
  /** ROS 2: somebody has to configure and activate it. */
  lifecycle?: true;
  place: Place | null;
  /** Index of the innermost container; -1: none. */
  container: number;
  /** Kinds of which there may be more than is known, and why. */
  open: [kind: string, why: string][];
  /** Names that are known only in part: what is known, with * for the rest. */
  partly: [kind: string, pattern: string][];
  conditions: string[];
  /** Indexes of the configurations it exists in; empty: all. */
  only: number[];
  /** Indexes into ReportData.findings that stand inside this node's element. */
  findings: number[];
  /** The same of those that stand elsewhere and speak of this element, too. */
  related: number[];
  mark?: Mark;
  /** In which turn it came, where it was not there when the page was first made: what was there before does not move for it. */
  late?: number;
  /** Of the page itself: not there in the view that tells where the others stand. */
  absent?: true;
}

export interface Channel {
  kind: "topic" | "service" | "action";
  name: string;
  types: string[];
  /** Everybody uses it (/tf, /clock …). */
  hub: boolean;
  /** Machinery of nodes (bonds, dynamic_reconfigure, nodelet services), or nothing but a part of an action: not shown by itself. */
  plumbing: boolean;
  findings: number[];
  /** Who may be where nobody is known. */
  may: MayBe[];
  mark?: Mark;
}

export interface Connection {
  node: number;
  channel: number;
  /** publisher, subscriber, server, client, action server, action client: Endpoint.role. */
  role: string;
  /** Whether it publishes or serves. */
  offers: boolean;
  /** As the library spells it: x, ~x, /x or a template. */
  declared: string;
  spelling: "relative" | "private" | "global";
  /** Resolved, before remaps. */
  unremapped: string;
  remaps: [source: string, target: string, place: Place | null][];
  type: string;
  certain: boolean;
  /** Empty: from the start; on_subscriber: while somebody listens; on_message: after a first message or call. */
  when: string;
  /** Name of the action of which this topic is a part; else empty. */
  action: string;
  /** ROS 2: its quality of service in words, as far as it is known: "reliable, transient_local, keep_last 1". */
  qos?: string;
  /** "by: where", untrusted text. */
  evidence: string[];
  only: number[];
  mark?: Mark;
  /** As of a node. */
  late?: number;
}

export interface Param {
  name: string;
  value: string;
  place: Place | null;
  /** Settings that this one overrides, in order. */
  overrides: [value: string, place: Place | null][];
  /** Indexes of nodes known to read it. */
  readers: number[];
  only: number[];
  findings: number[];
  mark?: Mark;
}

export interface Finding {
  /** Stable: the fingerprint; used in #finding=… */
  id: string;
  rule: string;
  name: string;
  severity: "error" | "warning" | "info";
  /** In a comparison: that it was not there at `base`, or is not there any more. */
  since?: "new" | "fixed";
  message: string;
  label: string;
  place: Place;
  endLine: number;
  endColumn: number;
  help: string;
  notes: string[];
  related: [place: Place, label: string][];
  /** Include elements that lead to it, outermost first. */
  chain: Place[];
  /** The command that shows it; empty where it needs none. */
  show: string;
  /** What a fix would do; empty: there is none. */
  fix: string;
  fixSafe: boolean;
}

/** An executable or nodelet class of the library. */
export interface Program {
  package: string;
  name: string;
  kind: "executable" | "nodelet";
  /** What is to be said of it as a whole; empty: nothing. */
  status: string;
  /** Grouped as in the library: publishers, subscribers, services, clients, actions, params. */
  interface: { category: string; name: string; type: string; detail: string; evidence: string[] }[];
  open: [kind: string, why: string][];
}
