// What the page is made from: the JSON in <script type="application/json" id="launchlint-data">, written by launchlint/report/html/data.py.
// Names in it come from untrusted files: show them with textContent only, key them in Maps only.

/** Index into ReportData.files, line and column from 1. */
export type Place = [file: number, line: number, column: number];

export interface ReportData {
  format: 1;
  title: string;
  /** Version of launchlint that wrote the page. */
  version: string;
  /** Prefix of a link to a line: sourceUrl + encoded path + "#L" + line; null where unknown. Always http(s). */
  sourceUrl: string | null;
  /** Revision it is compared with; null where the page shows one state only. */
  base: string | null;
  /** Paths as shown to people, relative. */
  files: string[];
  /** Lines of files that anything on the page refers to, with two lines around findings: sorted by line. */
  lines: { file: number; lines: [line: number, text: string][] }[];
  findings: Finding[];
  entries: Entry[];
  /** Programs that appear on the page, and all of libraries given by hand. */
  library: Program[];
}

export type Mark = "added" | "removed" | "changed";

/** One entry file, all its configurations joined. */
export interface Entry {
  file: number;
  /** "ok" or "error": whether roslaunch loads it. */
  verdict: "ok" | "error";
  /** Why it is refused; empty where it is not. */
  refused: string;
  /** Args of each configuration as on the command line; the first is the default one (often ""). */
  configurations: string[];
  /** Whether every include could be followed. */
  complete: boolean;
  containers: Container[];
  nodes: Node[];
  channels: Channel[];
  connections: Connection[];
  params: Param[];
  /** Indexes into ReportData.findings of those that this entry reaches. */
  findings: number[];
}

/** A <group> or <include> around nodes. */
export interface Container {
  kind: "group" | "include";
  /** Namespace of a group (empty where it has none of its own), file of an include. */
  label: string;
  namespace: string;
  place: Place | null;
  /** Index of the container around it; -1: none. */
  parent: number;
}

export interface Node {
  /** Resolved name: /a/b. Several may share it. */
  name: string;
  program: string;
  package: string;
  executable: string;
  /** node, nodelet, nodelet manager …: launchlint/graph/connections.py Instance.kind. */
  kind: string;
  /** known, template, unknown …: Instance.knowledge; reason says why it is not known. */
  knowledge: string;
  reason: string;
  host: string;
  namespace: string;
  isTest: boolean;
  place: Place | null;
  /** Index of the innermost container; -1: none. */
  container: number;
  /** Kinds of which there may be more than is known, and why. */
  open: [kind: string, why: string][];
  conditions: string[];
  /** Indexes of the configurations it exists in; empty: all. */
  only: number[];
  /** Indexes into ReportData.findings that stand inside this node's element. */
  findings: number[];
  mark?: Mark;
}

export interface Channel {
  kind: "topic" | "service" | "action";
  name: string;
  types: string[];
  /** Everybody uses it (/tf, /clock …). */
  hub: boolean;
  /** Belongs to an action: shown with it, not by itself. */
  plumbing: boolean;
  findings: number[];
  mark?: Mark;
}

export interface Connection {
  node: number;
  channel: number;
  /** publisher, subscriber, server, client, action_server, action_client …: see Endpoint.role. */
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
  /** start, on_subscriber, on_message, condition …; empty: start. */
  when: string;
  /** "by: where", untrusted text. */
  evidence: string[];
  only: number[];
  mark?: Mark;
}

export interface Param {
  name: string;
  value: string;
  place: Place | null;
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
  /** Grouped as in the library: publishers, subscribers, services, clients, actions, params. */
  interface: { category: string; name: string; type: string; detail: string; evidence: string[] }[];
  open: [kind: string, why: string][];
}
