// What of a level is drawn as one: lines between the same two things, ports of wires from the same places, pills between the same.

import { BUNDLE, badgeOf, pillBox } from "./boxes.js";
import { counted, inLines, shortName } from "./names.js";
import { clashIn, clashWords, qosLine } from "./qos.js";

/** @typedef {import("./boxes").Measure} Measure */
/** @typedef {import("./model").Edge} Edge */
/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Port} Port */
/** @typedef {import("./model").Tip} Tip */
/** @typedef {import("./model").View} View */
/** @typedef {import("./model").Wire} Wire */

/** Longest name on a line, in characters. */
const LABEL = 32;
/** Where there are two; a longer single name stands in two lines. */
const BROAD = 20;

/** The lines of a level: those of one kind and look between the same two tips are one. */
export class Lines {
  /** @param {View} view @param {Level} level */
  constructor(view, level) {
    this.view = view;
    this.level = level;
    /** @type {Map<string, { from: Tip, to: Tip, when: number, certain: boolean, changed: boolean, wires: Wire[] }>} */
    this.found = new Map();
  }

  /** @param {Wire} wire @param {Tip} from @param {Tip} to */
  add(wire, from, to) {
    const when = this.view.presence.both(from.when, to.when);
    const [certain, changed] = [from.certain && to.certain, from.changed || to.changed];
    const key = `e:${from.id}>${to.id}:${wire.kind}:${when}${certain ? "" : "?"}${changed ? "!" : ""}`;
    const known = this.found.get(key);
    if (known) known.wires.push(wire);
    else this.found.set(key, { from, to, when, certain, changed, wires: [wire] });
  }

  /**
   * Whether an open container at an end of a line says what it carries: one that it leaves with nothing else, or one that it enters from the border.
   * @param {Tip} from
   * @param {Tip} to
   * @param {Wire[]} wires
   */
  isNamedInside(from, to, wires) {
    const [left, entered] = [from, to].map((tip) => this.level.boxes.find((box) => box.id === tip.box)?.level);
    const port = left?.ports.find((each) => each.id === from.id);
    return port ? port.wires.length === wires.length : from.box === "" && Boolean(entered);
  }

  /** @returns {Edge[]} */
  edges() {
    const { presence, now } = this.view;
    return Array.from(this.found, ([id, { from, to, when, certain, changed, wires }]) => {
      const kind = wires[0]?.kind ?? "topic";
      const mark = presence.mark(when) || (changed ? "changed" : "");
      const classes = [/** @type {string} */ (kind)];
      if (mark) classes.push(mark);
      if (!certain) classes.push("uncertain");
      if (presence.conditional(when, now)) classes.push("conditional");
      const badge = badgeOf(this.view, wires.flatMap((wire) => wire.findings));
      if (badge) classes.push(badge.severity);
      if (wires.some(clashIn)) classes.push("clash");
      const fromPill = from.id.startsWith("w:");
      const isNamed = !fromPill && !(to.id.startsWith("w:") && wires.length === 1) && !this.isNamedInside(from, to, wires);
      return {
        id,
        from: from.id,
        to: to.id,
        fromBox: from.box,
        toBox: to.box,
        kind,
        wires,
        label: isNamed ? labelOf(wires, this.level.group.namespace) : [],
        classes,
        fromPort: "",
        toPort: "",
      };
    });
  }
}

/** What is written on a line. @param {Wire[]} wires @param {string} namespace @returns {string[]} */
export function labelOf(wires, namespace) {
  const kind = wires[0]?.kind ?? "topic";
  const [only, more] = wires;
  if (only && !more) return [...inLines(shortName(only.name, namespace, LABEL), BROAD), ...[qosLine(only)].filter(Boolean)];
  if (wires.length < BUNDLE) return wires.flatMap((wire) => [shortName(wire.name, namespace, BROAD), ...[clashWords(wire)].filter(Boolean)]);
  return [counted(wires.length, kind), ...clashesOf(wires, namespace)];
}

/** What keeps ends apart in a bundle, with the name that has it, or how many do. @param {Wire[]} wires @param {string} namespace @returns {string[]} */
function clashesOf(wires, namespace) {
  /** @type {Map<string, Wire[]>} */
  const found = new Map();
  for (const wire of wires) {
    const words = clashWords(wire);
    if (words) found.set(words, [...(found.get(words) ?? []), wire]);
  }
  return Array.from(found, ([words, [first, ...others]]) => `${others.length || !first ? others.length + 1 : shortName(first.name, namespace, BROAD)}: ${words}`);
}

/**
 * Lines that leave an open container at one place say once what they carry, and not at all where all of it is named inside.
 * @param {Level} level
 */
export function nameOnce({ group, boxes, edges }) {
  for (const { id, level } of boxes) {
    for (const port of level?.ports ?? []) {
      const own = edges.filter((edge) => edge.fromBox === id && edge.from === port.id && edge.label.length);
      if (new Set(own.map((edge) => edge.fromPort)).size < 2) continue;
      const wires = [...new Set(own.flatMap((edge) => edge.wires))];
      for (const [at, edge] of own.entries()) edge.label = at || wires.length === port.wires.length ? [] : labelOf(wires, group.namespace);
    }
  }
}

/** The ports of a level's border: wires that come from the same tips leave together. */
export class Ports {
  /** @param {Level} level */
  constructor(level) {
    this.level = level;
    /** @type {Map<string, { port: Port, tips: Tip[] }>} */
    this.found = new Map();
  }

  /** @param {Wire} wire @param {boolean} out @param {Tip[]} all */
  add(wire, out, all) {
    /** @type {Map<string, Tip[]>} */
    const alike = new Map();
    for (const tip of all) {
      const look = `${tip.when}${tip.certain ? "" : "?"}${tip.changed ? "!" : ""}`;
      const known = alike.get(look);
      if (known) known.push(tip);
      else alike.set(look, [tip]);
    }
    for (const [look, own] of alike) {
      const [first] = own;
      if (!first) continue;
      const key = `${out ? "out" : "in"} ${wire.kind} ${look} ${Array.from(new Set(own.map((tip) => tip.id)), String).sort().join(" ")}`;
      const known = this.found.get(key);
      if (known) known.port.wires.push(wire);
      else {
        const id = `${this.level.group.id}|${out ? "out" : "in"}|${look}|${wire.id}`;
        const { when, certain, changed } = first;
        this.found.set(key, { port: { id, out, kind: wire.kind, wires: [wire], when, certain, changed }, tips: own });
      }
    }
  }

  /** @param {Lines} lines */
  connect(lines) {
    for (const { port, tips: own } of this.found.values()) {
      this.level.ports.push(port);
      const border = { ...port, box: "" };
      for (const tip of own) for (const wire of port.wires) port.out ? lines.add(wire, tip, border) : lines.add(wire, border, tip);
    }
  }
}

/** The pills of a level: three or more wires between the same tips share one. */
export class Pills {
  /** @param {View} view @param {Level} level @param {Measure} measure @param {Lines} lines */
  constructor(view, level, measure, lines) {
    this.view = view;
    this.level = level;
    this.measure = measure;
    this.lines = lines;
    /** @type {Map<string, { wires: Wire[], givers: Tip[], takers: Tip[] }>} */
    this.found = new Map();
  }

  /** @param {Wire} wire @param {Tip[]} givers @param {Tip[]} takers */
  add(wire, givers, takers) {
    /** @param {Tip} tip */
    const look = (tip) => `${tip.id} ${tip.when}${tip.certain ? "" : "?"}${tip.changed ? "!" : ""}`;
    const key = `${wire.kind}|${givers.map(look).join()}|${takers.map(look).join()}`;
    const known = this.found.get(key);
    if (known) known.wires.push(wire);
    else this.found.set(key, { wires: [wire], givers, takers });
  }

  connect() {
    for (const { wires, givers, takers } of this.found.values()) {
      const bundles = wires.length < BUNDLE ? wires.map((wire) => [wire]) : [wires];
      for (const each of bundles) {
        const box = pillBox(this.view, each, this.level.group, this.measure);
        this.level.boxes.push(box);
        /** @param {Tip} tip */
        const beside = (tip) => ({ ...tip, id: box.id, box: box.id });
        for (const wire of each) {
          for (const tip of givers) this.lines.add(wire, tip, beside(tip));
          for (const tip of takers) this.lines.add(wire, beside(tip), tip);
        }
      }
    }
  }
}
