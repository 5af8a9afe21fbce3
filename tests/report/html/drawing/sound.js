// What is true of every drawing: boxes do not overlap and stand in their container, no line and no name goes through a box, no two names lie over each other.

import assert from "node:assert/strict";

const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
const inside = (a, b) => a.x >= b.x && a.y >= b.y && a.x + a.width <= b.x + b.width && a.y + a.height <= b.y + b.height;

/** What a name takes of the room that is kept for it. */
const narrow = ({ x, y, width, height }) => ({ x: x + 3, y: y + 2, width: width - 8, height: height - 4 });

/** Whether a piece of a line, which is level or upright, goes through a box: touching its border is no matter. */
function crosses(from, to, box) {
  const [left, right] = [Math.min(from.x, to.x), Math.max(from.x, to.x)];
  const [top, bottom] = [Math.min(from.y, to.y), Math.max(from.y, to.y)];
  return right > box.x + 1 && left < box.x + box.width - 1 && bottom > box.y + 1 && top < box.y + box.height - 1;
}

export function* levels(level) {
  yield level;
  for (const box of level.boxes) if (box.level) yield* levels(box.level);
}

/** @param scene what is drawn, and where */
export function assertSound(scene) {
  const { sheet, root, drawn } = scene;
  const areas = new Map(sheet.boxes.map((each) => [each.box.id, each]));
  const lineOf = new Map(sheet.edges.map((each) => [each.edge.id, each]));
  assert.deepEqual([...areas.keys()].sort(), [...drawn.boxes.keys()].sort());
  assert.deepEqual([...lineOf.keys()].sort(), [...drawn.edges.keys()].sort());

  for (const level of levels(root)) {
    const around = areas.get(level.group.id) ?? { x: 0, y: 0, width: sheet.width, height: sheet.height };
    const own = level.boxes.map((box) => areas.get(box.id));
    for (const box of own) assert.ok(inside(box, around), `${box.box.id} sticks out of ${level.group.id}`);
    own.forEach((one, at) => own.slice(at + 1).forEach((other) => assert.ok(!overlap(one, other), `${one.box.id} overlaps ${other.box.id}`)));
    for (const edge of level.edges) {
      const { points } = lineOf.get(edge.id);
      for (let at = 1; at < points.length; at++) {
        const through = own.filter((box) => crosses(points[at - 1], points[at], box)).map((box) => box.box.id);
        assert.deepEqual(through, [], `${edge.id} goes through boxes`);
      }
    }
    const labels = sheet.labels.filter((each) => level.edges.includes(each.edge));
    for (const label of labels) assert.deepEqual(own.filter((box) => overlap(label, box)).map((box) => box.box.id), [], `the name of ${label.edge.id}`);
    labels.forEach((one, at) => labels.slice(at + 1).forEach((other) => assert.ok(!overlap(narrow(one), narrow(other)), `the names of ${one.edge.id} and ${other.edge.id}`)));
  }
}
