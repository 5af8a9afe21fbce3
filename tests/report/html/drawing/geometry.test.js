// Of random systems, in random views: boxes do not overlap, no line goes through a box, and what is drawn as connected is connected.

import assert from "node:assert/strict";
import { test } from "node:test";
import { walk } from "../../../../launchlint/report/html/js/drawing/tree.js";
import { assertSound, levels } from "./sound.js";
import { numbers, random, scene } from "./written.js";

const SEEDS = Array.from({ length: 60 }, (_, at) => at + 1);

/** Some view of a system: everything that a reader may choose, by the seed. */
async function view(seed) {
  const of = random(seed);
  const next = numbers(seed + 1000);
  const grouping = ["namespace", "file", "package"][next(8) < 6 ? 0 : 1 + next(2)];
  const chosen = { grouping, topicsAsNodes: next(4) === 0, configuration: next(3) === 0 ? next(of.entries[0].configurations.length) : -1 };
  const folded = await scene(of, chosen);
  const groups = Array.from(walk(folded.view.root), (each) => each.id).slice(1);
  const focus = groups.length && next(5) === 0 ? groups[next(groups.length)] : null;
  return scene(of, { ...chosen, focus, expanded: new Set(groups.filter(() => next(4) > 0)) });
}

for (const seed of SEEDS) {
  test(`seed ${seed}`, async () => {
    const found = await view(seed);
    assertSound(found);
    const { root, drawn, view: shown } = found;
    assert.deepEqual(followed(drawn, shown), connected(drawn, shown));
    for (const level of levels(root)) assert.deepEqual(misleading(level.edges), []);
  });
}

/** The drawn box that holds a node. */
function boxOf(drawn, shown, node) {
  if (drawn.boxes.has(`n:${node}`)) return `n:${node}`;
  const found = [...drawn.boxes.values()].find((box) => box.kind === "folded" && [...walk(shown.groups.get(box.id))].some((group) => group.nodes.includes(node)));
  return found.id;
}

/** From where to where the data of each wire gets, as the entry says; within one folded box nothing is drawn. */
function connected(drawn, { wires, presence, root, groups, home, state }) {
  const found = new Set();
  for (const wire of wires) {
    for (const giver of wire.givers) {
      for (const taker of wire.takers) {
        const [from, to] = [giver, taker].map((end) => boxOf(drawn, { groups, root, home }, end.node));
        if (from === to && drawn.boxes.get(from).kind === "folded" && !returns(drawn, wire, from)) continue;
        if (presence.meet(giver.when, taker.when) || state.topicsAsNodes) found.add(`${from} ${wire.id} ${to}`);
      }
    }
  }
  return [...found].sort();
}

/** A pill of which one box is at both sides leads from that box to itself. */
function returns(drawn, wire, box) {
  return drawn.follow(box, wire.id, true, new Set()).has(box);
}

/** From where to where the lines lead. */
function followed(drawn, { wires }) {
  const found = new Set();
  for (const wire of wires) {
    for (const box of drawn.boxes.values()) {
      if (box.kind !== "node" && box.kind !== "folded") continue;
      for (const end of drawn.follow(box.id, wire.id, true, new Set())) if (drawn.isEnd(end)) found.add(`${box.id} ${wire.id} ${end}`);
    }
  }
  return [...found].sort();
}

/** Pairs of ends that lines which run together seem to connect, though no line does. */
function misleading(edges) {
  const nets = new Map(edges.map((edge) => [edge, new Set([edge])]));
  for (const side of ["fromPort", "toPort"]) {
    const first = new Map();
    for (const edge of edges) {
      const other = first.get(edge[side]);
      if (!other) first.set(edge[side], edge);
      else if (nets.get(edge) !== nets.get(other)) {
        const joint = new Set([...nets.get(edge), ...nets.get(other)]);
        for (const each of joint) nets.set(each, joint);
      }
    }
  }
  const found = [];
  for (const net of new Set(nets.values())) {
    const [from, to, real] = [new Set(), new Set(), new Set()];
    for (const edge of net) {
      from.add(edge.from);
      to.add(edge.to);
      real.add(`${edge.from} → ${edge.to}`);
    }
    for (const one of from) for (const other of to) if (!real.has(`${one} → ${other}`)) found.push(`${one} → ${other}`);
  }
  return found;
}
