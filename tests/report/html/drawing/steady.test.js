// Opening one container leaves all others as they are inside, and in their order.

import assert from "node:assert/strict";
import { test } from "node:test";
import { createRequire } from "node:module";
import { measurer } from "../../../../launchlint/report/html/js/drawing/measure.js";
import { Director } from "../../../../launchlint/report/html/js/drawing/scene.js";
import { walk } from "../../../../launchlint/report/html/js/drawing/tree.js";
import { random, state } from "./written.js";

const ELK = createRequire(import.meta.url)("../../../../launchlint/report/html/assets/elk.js");
const extent = { width: 1440, height: 900 };

/** Where everything inside an open container stands, from its corner. */
function inside(sheet, id) {
  const own = sheet.boxes.find((each) => each.box.id === id);
  return sheet.boxes
    .filter((each) => each.depth > own.depth && each.x >= own.x && each.y >= own.y && each.x < own.x + own.width && each.y < own.y + own.height)
    .map((each) => [each.box.id, Math.round(each.x - own.x), Math.round(each.y - own.y)]);
}

for (const seed of [3, 8, 21]) {
  test(`seed ${seed}`, async () => {
    const of = random(seed);
    const layouts = [];
    const elk = new ELK();
    const engine = { layout: (graph) => (layouts.push(graph), elk.layout(graph)) };
    const director = new Director(of, engine, measurer());
    const all = await director.scene(state(), extent);
    const groups = Array.from(walk(all.view.root), (each) => each.id).slice(1);
    for (const last of groups) {
      const before = await director.scene(state({ expanded: new Set(groups.filter((each) => each !== last)) }), extent);
      const after = await director.scene(state({ expanded: new Set(groups) }), extent);
      const beside = [...before.open].filter((id) => !id.startsWith(last) && !last.startsWith(id) && before.drawn.boxes.has(id));
      for (const id of beside) assert.deepEqual(inside(after.sheet, id), inside(before.sheet, id));
    }
    const done = layouts.length;
    await director.scene(state({ expanded: new Set(groups) }), extent);
    assert.equal(layouts.length, done, "nothing is laid out twice");
  });
}
