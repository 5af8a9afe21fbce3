// A page that is written again with one node more: what was there stays where it was, and the drawing is as sound as any.

import assert from "node:assert/strict";
import { test } from "node:test";
import { walk } from "../../../../launchlint/report/html/js/drawing/tree.js";
import { assertSound } from "./sound.js";
import { data, numbers, random, scene } from "./written.js";

const SEEDS = Array.from({ length: 40 }, (_, at) => at + 1);

/** A system, and the same with one node more that shares names with it. */
function both(seed) {
  const before = random(seed);
  before.base = null;
  const [entry] = before.entries;
  const next = numbers(seed + 500);
  const like = entry.nodes[next(entry.nodes.length)];
  const namespace = next(2) ? like.namespace : "/";
  const late = { ...like, name: `${namespace === "/" ? "" : namespace}/newcomer`, namespace, late: 1 };
  late.host = late.name;
  const own = entry.connections.filter(() => next(4) === 0).slice(0, 2).map((each) => ({ ...each, node: entry.nodes.length, only: [] }));
  const after = { ...before, entries: [{ ...entry, nodes: [...entry.nodes, late], connections: [...entry.connections, ...own] }] };
  return [before, after];
}

async function opened(of) {
  const { view } = await scene(of, {});
  return scene(of, { expanded: new Set(Array.from(walk(view.root), (each) => each.id).slice(1)) });
}

/** Where boxes stand in what is around them. */
function places({ sheet, root }) {
  const areas = new Map(sheet.boxes.map((each) => [each.box.id, each]));
  const found = new Map();
  const visit = (level) => {
    const around = areas.get(level.group.id) ?? { x: 0, y: 0 };
    for (const { id, kind, level: inner } of level.boxes) {
      const { x, y } = areas.get(id);
      if (kind !== "pill") found.set(`${level.group.id} ${id}`, { x: x - around.x, y: y - around.y });
      if (inner) visit(inner);
    }
  };
  visit(root);
  return found;
}

test("what was there stays", async () => {
  let [stayed, all] = [0, 0];
  for (const seed of SEEDS) {
    const [before, after] = both(seed);
    const [was, now] = [places(await opened(before)), places(await opened(after))];
    for (const [id, { x, y }] of was) {
      const place = now.get(id);
      if (!place) continue;
      all += 1;
      stayed += Number(Math.abs(place.x - x) <= 10 && Math.abs(place.y - y) <= 10);
    }
  }
  assert.ok(all > 300);
  assert.ok(stayed >= 0.95 * all, `${stayed} of ${all}`);
});

for (const seed of SEEDS) {
  test(`seed ${seed}`, async () => {
    const found = await opened(both(seed)[1]);
    assert.ok(found.drawn.boxes.has(`n:${found.view.entry.nodes.length - 1}`));
    assertSound(found);
  });
}

test("a line that came late", async () => {
  const of = data(["/a > /x", "/b < /x", "/c > /y", "/d < /y", "/d > /z", "/b < /z"]);
  const before = places(await scene({ ...of, entries: [{ ...of.entries[0], connections: of.entries[0].connections.slice(0, 4) }] }));
  of.entries[0].connections.slice(4).forEach((each) => (each.late = 1));
  const now = await scene(of);
  assert.deepEqual(places(now), before);
  assert.deepEqual(now.sheet.edges.filter(({ edge }) => edge.from === "n:3").map(({ edge }) => edge.to), ["n:1"]);
  assertSound(now);
});
