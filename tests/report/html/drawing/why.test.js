// Why one node hears another, or does not.

import assert from "node:assert/strict";
import { test } from "node:test";
import { nearMisses, pathBetween } from "../../../../launchlint/report/html/js/page/why.js";
import { data } from "./written.js";

/** What the page knows of an entry, as createModel() has it. */
function model(of) {
  const [entry] = of.entries;
  const by = (count, key) => Array.from({ length: count }, (_, at) => entry.connections.filter((each) => each[key] === at));
  return { entry, ofNode: by(entry.nodes.length, "node"), onChannel: by(entry.channels.length, "channel") };
}

const written = () => "robot.launch:7";
const at = (of, name) => of.entries[0].nodes.findIndex((node) => node.name === name);

test("the way from node to node", () => {
  const of = data(["/a > /x", "/b < /x", "/b > /y", "/c < /y", "/d < /z"]);
  const names = (way) => way?.map((step) => of.entries[0].channels[step.channel].name);
  assert.deepEqual(names(pathBetween(model(of), at(of, "/a"), at(of, "/c"), -1)), ["/x", "/y"]);
  assert.equal(pathBetween(model(of), at(of, "/c"), at(of, "/a"), -1), null);
  assert.equal(pathBetween(model(of), at(of, "/a"), at(of, "/d"), -1), null);
});

test("names that part, and the remap that joins them", () => {
  const of = data(["/robot/driver > /robot/scan", "/mapper < /scan"]);
  for (const each of of.entries[0].connections) Object.assign(each, { declared: "scan", spelling: "relative", type: "sensor_msgs/LaserScan" });
  const [near] = nearMisses(model(of), at(of, "/robot/driver"), at(of, "/mapper"), written);
  assert.equal(near.apart, "The names part at /: “robot/scan” there, “scan” here: the nodes are in different namespaces, /robot and /.");
  assert.equal(near.edit, 'At its element, in /mapper: <remap from="scan" to="/robot/scan"/>');
});

test("one name that types, QoS or conditions keep apart", () => {
  const of = (one, other, nodes = {}) => {
    const made = data(["/a > /x", "/b < /x"], { nodes, configurations: ["", "sim:=true"] });
    Object.assign(made.entries[0].connections[0], one);
    Object.assign(made.entries[0].connections[1], other);
    return nearMisses(model(made), at(made, "/a"), at(made, "/b"), written)[0]?.apart;
  };
  assert.equal(of({ type: "a/A" }, { type: "a/B" }), "One name, two types: /a has a/A, /b wants a/B.");
  assert.equal(of({ qos: "best_effort, volatile" }, { qos: "reliable" }), "One name, and their QoS does not fit: best_effort is offered, reliable is asked for.");
  const never = of({}, {}, { "/a": { only: [0], conditions: ["unless=sim"] }, "/b": { only: [1], conditions: ["if=sim"] } });
  assert.equal(never, "They are never there together: /a only where unless=sim, /b only where if=sim.");
});
