// Filters, and what leaves the drawing without moving the rest.

import assert from "node:assert/strict";
import { test } from "node:test";
import { fittingNodes, termsOf } from "../../../../launchlint/report/html/js/drawing/filter.js";
import { data, scene } from "./written.js";

const NODES = { "/left/camera": { package: "usb_cam" }, "/right/camera": { package: "usb_cam" }, "/nav/planner": { package: "nav" }, "/rviz": { package: "rviz" } };
const OF = data(["/left/camera > /left/image", "/right/camera > /right/image", "/nav/planner < /left/image", "/rviz < /left/image", "/rviz < /right/image"], {
  nodes: NODES,
  channels: { "/left/image": { types: ["sensor_msgs/Image"] }, "/right/image": { types: ["sensor_msgs/Image"] } },
});

/** Names of the nodes that fit. */
function fitting(filter) {
  const fits = fittingNodes(OF.entries[0], termsOf(filter));
  return OF.entries[0].nodes.filter((_, at) => fits[at]).map((node) => node.name);
}

test("by a part of a name, their own or of what they are connected with", () => {
  assert.deepEqual(fitting("camera"), ["/left/camera", "/right/camera"]);
  assert.deepEqual(fitting("right/image"), ["/right/camera", "/rviz"]);
});

test("with a star, as a whole; by package and type; without", () => {
  assert.deepEqual(fitting("/left/*"), ["/left/camera", "/nav/planner", "/rviz"]);
  assert.deepEqual(fitting("package:usb -right"), ["/left/camera"]);
  assert.deepEqual(fitting("type:Image -camera -rviz"), ["/nav/planner"]);
});

test("what nobody would type ends soon", () => {
  const from = performance.now();
  fitting(`${"*a".repeat(90)} ${"- ".repeat(50)}`);
  assert.ok(performance.now() - from < 500);
});

test("what is hidden, filtered or switched off moves nothing", async () => {
  const places = ({ sheet }) => new Map(sheet.boxes.map(({ box, x, y, width, height }) => [box.id, [x, y, width, height].join()]));
  const open = new Set(["g:namespace:/left", "g:namespace:/right", "g:namespace:/nav"]);
  const before = places(await scene(OF, { expanded: open }));
  for (const change of [{ filter: "left" }, { hidden: new Set(["n:3"]) }, { layers: { topics: false, services: true, actions: true, params: false } }, { tray: false }]) {
    const after = await scene(OF, { expanded: open, ...change });
    for (const [id, place] of places(after)) assert.equal(place, before.get(id), `${id} with ${JSON.stringify(Object.keys(change))}`);
    for (const { edge } of after.sheet.edges) for (const end of [edge.fromBox, edge.toBox]) assert.ok(end === "" || after.drawn.boxes.has(end), `${edge.id} leads nowhere`);
  }
});
