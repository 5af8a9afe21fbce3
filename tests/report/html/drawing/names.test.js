import assert from "node:assert/strict";
import { test } from "node:test";

import { briefNames } from "../../../../launchlint/report/html/js/drawing/names.js";

test("names whose ends are the same are told apart by where they differ", () => {
  const [front, rear, other] = ["/robot/relay_rgbd_front_top_rgb_camera_info", "/robot/relay_rgbd_rear_top_rgb_camera_info", "/rviz"];
  const found = briefNames([front, rear, other, rear], 26);
  assert.deepEqual([...found.keys()], [front, rear, other]);
  assert.equal(found.get(front), "…front_top_rgb_camera_info");
  assert.equal(found.get(rear), "…rear_top_rgb_camera_info");
  assert.equal(found.get(other), "/rviz");
});

test("none is longer than it may be, however long they are", () => {
  const long = (which) => `/a/${which}_${"x".repeat(90)}`;
  const found = [...briefNames([long("one"), long("two")], 26).values()];
  assert.equal(new Set(found).size, 2);
  assert.ok(found.every((each) => each.length <= 26));
});
