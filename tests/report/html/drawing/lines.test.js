// What is drawn between what: from a few facts to all boxes and lines.

import assert from "node:assert/strict";
import { test } from "node:test";
import { data, lines, scene } from "./written.js";

/** Lines of what is drawn, with the names of nodes for their ids. */
async function drawn(of, changes) {
  const { root } = await scene(of, changes);
  return JSON.parse(JSON.stringify(lines(root)).replace(/n:(\d+)/g, (_, at) => of.entries[0].nodes[at].name));
}
const open = (...namespaces) => ({ expanded: new Set(namespaces.map((each) => `g:namespace:${each}`)) });

test("from publisher to subscriber, from client to server", async () => {
  const of = data(["/cam > /image", "/flip < /image", "/ui calls /map", "/mapper serves /map", "/ui asks /go", "/base does /go"]);
  assert.deepEqual(await drawn(of), ["/cam → /flip: /image", "/ui → /mapper: /map (service)", "/ui → /base: /go (action)"]);
  assert.deepEqual(await drawn(of, { layers: { topics: false, services: true, actions: false, params: false } }), ["/ui → /mapper: /map (service)"]);
});

test("lines pass the border of an open container, and end at a folded one", async () => {
  const of = data(["/a/x > /t", "/a/y < /t", "/b/z < /t"]);
  assert.deepEqual(await drawn(of), ["g:namespace:/a → g:namespace:/b: /t"]);
  assert.deepEqual(await drawn(of, open("/a")), ["g:namespace:/a → g:namespace:/b: /t", { "g:namespace:/a": ["/a/x → /a/y: /t", "/a/x → border: /t"] }]);
  assert.deepEqual(await drawn(of, open("/a", "/b")), [
    "g:namespace:/a → g:namespace:/b: /t",
    { "g:namespace:/a": ["/a/x → /a/y: /t", "/a/x → border: /t"], "g:namespace:/b": ["border → /b/z: /t"] },
  ]);
});

test("several topics between the same two are one line, with their number from three on", async () => {
  const of = data(["/a > /x", "/b < /x", "/a > /y", "/b < /y", "/c > /x2", "/b < /x2", "/c > /y2", "/b < /y2", "/c > /z2", "/b < /z2"]);
  assert.deepEqual(await drawn(of), ["/a → /b: /x /y", "/c → /b: /x2 /y2 /z2"]);
  const { sheet } = await scene(of);
  assert.deepEqual(sheet.labels.map((each) => each.lines), [["/x", "/y"], ["3 topics"]]);
});

test("a topic of many to many is a pill where they meet, whatever is open", async () => {
  const of = data(["/a/p > /t", "/a/q > /t", "/b/r < /t", "/b/s < /t", "/c < /t"]);
  assert.deepEqual(await drawn(of), ["g:namespace:/a → g:namespace:/b: /t", "g:namespace:/a → /c: /t"]);
  const inside = ["/a/p → border: /t", "/a/q → border: /t"];
  assert.deepEqual(await drawn(of, open("/a")), ["g:namespace:/a → g:namespace:/b: /t", "g:namespace:/a → /c: /t", { "g:namespace:/a": inside }]);
  const flat = data(["/p > /t", "/q > /t", "/r < /t", "/s < /t"]);
  assert.deepEqual(await drawn(flat), ["/p → w:c:0: /t", "/q → w:c:0: /t", "w:c:0 → /r: /t", "w:c:0 → /s: /t"]);
});

test("what never exists together is not connected", async () => {
  const of = data(["/a > /t @0", "/b < /t @1", "/c < /t"], { configurations: ["", "sim:=true"] });
  assert.deepEqual(await drawn(of), ["/a → /c: /t (conditional)"]);
  assert.deepEqual(await drawn(of, { configuration: 0 }), ["/a → /c: /t"]);
  assert.deepEqual(await drawn(of, { configuration: 1 }), []);
});

test("what is not certain, and what changed", async () => {
  const of = data(["/a > /t?", "/b < /t", "+/c < /t", "-/d < /t", "~/e < /t"], { base: "main" });
  assert.deepEqual(await drawn(of), [
    "/a → /b: /t (uncertain)",
    "/a → /c: /t (added uncertain)",
    "/a → /d: /t (removed uncertain)",
    "/a → /e: /t (changed uncertain)",
  ]);
  const never = data(["+/a > /t", "-/b < /t"], { base: "main" });
  assert.deepEqual(await drawn(never), []);
});

test("topics as nodes, the unconnected ones, too", async () => {
  const of = data(["/a > /t", "/b < /t", "/a > /alone"]);
  assert.deepEqual(await drawn(of, { topicsAsNodes: true }), ["/a → w:c:0: /t", "w:c:0 → /b: /t", "/a → w:c:1: /alone"]);
});

test("hub topics only when they are asked for", async () => {
  const of = data(["/a > /tf", "/b < /tf"], { channels: { "/tf": { hub: true } } });
  assert.deepEqual(await drawn(of), []);
  assert.deepEqual(await drawn(of, { hubs: true }), ["/a → /b: /tf"]);
});

test("params that several nodes read", async () => {
  const params = [
    { name: "/robot", value: "x", place: null, readers: [0, 1], only: [], findings: [] },
    { name: "/a/own", value: "y", place: null, readers: [0], only: [], findings: [] },
  ];
  const of = data([], { nodes: { "/a": {}, "/b": {} }, params });
  const layers = { topics: true, services: true, actions: true, params: true };
  assert.deepEqual(await drawn(of), []);
  assert.deepEqual(await drawn(of, { layers }), ["w:p:0 → /a: /robot (param)", "w:p:0 → /b: /robot (param)"]);
  const { root } = await scene(of, { layers });
  assert.deepEqual(root.boxes.map((box) => box.lines.map((line) => line.text)), [["a", "demo/node", "1 param"], ["b", "demo/node"], ["/robot"]]);
});

test("in focus, what is around stands beside", async () => {
  const of = data(["/a/x > /t", "/b/y < /t", "/b/y > /u", "/c/z < /u", "/b/y > /v", "/top < /v"]);
  assert.deepEqual(await drawn(of, { focus: "g:namespace:/b" }), [
    "g:namespace:/a → g:namespace:/b: /t",
    "g:namespace:/b → g:namespace:/c: /u",
    "g:namespace:/b → /top: /v",
    { "g:namespace:/b": ["border → /b/y: /t", "/b/y → border: /u /v"] },
  ]);
});

test("hidden nodes and containers are not there, and what they leave is not called unconnected", async () => {
  const of = data(["/a/x > /t", "/b < /t", "/c < /t"]);
  assert.deepEqual(await drawn(of, { hidden: new Set(["n:1"]) }), ["g:namespace:/a → /c: /t"]);
  assert.deepEqual(await drawn(of, { hidden: new Set(["g:namespace:/a"]) }), []);
  const { root } = await scene(of, { hidden: new Set(["g:namespace:/a"]) });
  assert.deepEqual(root.boxes.map((box) => [box.id, box.loose]), [["n:1", []], ["n:2", []]]);
});

test("what nobody else shares is a hollow port with its number; by name only what something is to be said of", async () => {
  const of = data(["/a > /x", "/a > /y", "/a < /1", "/a < /2", "/a < /3", "/b < /bad"], {
    channels: { "/3": { findings: [0] } },
    findings: [{ severity: "error" }],
  });
  const ports = (box) => box.loose.map((port) => [port.out ? "out" : "in", port.label, port.badge]);
  const { root } = await scene(of);
  assert.deepEqual(root.boxes.map(ports), [
    [["in", "/3", { severity: "error", count: 1, elsewhere: false }], ["in", "2", null], ["out", "2", null]],
    [["in", "", null]],
  ]);
  const many = await scene(data(["/a < /1", "/a < /2", "/a < /3"]));
  assert.deepEqual(many.root.boxes.map(ports), [[["in", "3", null]]]);
});

test("only what has findings", async () => {
  const of = data(["/a > /t", "/b < /t", "/b > /u", "/c < /u"], { channels: { "/t": { findings: [0] } }, findings: [{ severity: "warning" }] });
  assert.deepEqual(await drawn(of, { findingsOnly: true }), ["/a → /b: /t (warning)"]);
});

test("a finding that stands elsewhere is a badge only where a node has none of its own", async () => {
  const of = data(["/a > /t", "/b < /t"], {
    nodes: { "/a": { related: [0] }, "/b": { findings: [1], related: [0] } },
    findings: [{ severity: "error" }, { severity: "info" }],
  });
  const { root } = await scene(of);
  assert.deepEqual(root.boxes.map((box) => box.badge), [{ severity: "error", count: 1, elsewhere: true }, { severity: "info", count: 1, elsewhere: false }]);
});

test("the machine that a node runs on is written on it, and is a container", async () => {
  const of = data(["/a > /t", "/b < /t", "/c < /t"], { nodes: { "/a": { machine: ["c1", "10.0.0.1"] }, "/b": { machine: ["c1", "10.0.0.1"] } } });
  const { root } = await scene(of);
  assert.deepEqual(root.boxes.map((box) => box.lines.map((line) => line.text)), [["a", "demo/node", "on c1"], ["b", "demo/node", "on c1"], ["c", "demo/node"]]);
  const grouped = await scene(of, { grouping: "machine" });
  assert.deepEqual(grouped.root.boxes.map((box) => [box.id, box.lines[0].text]), [["g:machine:c1", "c1 (10.0.0.1)"], ["g:machine:", "no machine named"]]);
  assert.deepEqual(lines(grouped.root), ["g:machine:c1 → g:machine:: /t"]);
});

test("a node that talks to itself", async () => {
  assert.deepEqual(await drawn(data(["/a > /t", "/a < /t"])), ["/a → /a: /t"]);
});

test("of two revisions, only what changed is open at first, and its hollow ports say what became of them", async () => {
  const of = data(["/a/x > /t", "/a/y < /t", "/b/p > /u", "+/b/p > /v"], { base: "main", nodes: { "/c/gone": { mark: "removed" } } });
  const { open: opened, root } = await scene(of, { expanded: "auto" });
  assert.deepEqual([...opened].sort(), ["g:namespace:/b", "g:namespace:/c"]);
  assert.deepEqual(root.boxes.map((box) => [box.id, box.classes]), [
    ["g:namespace:/a", ["folded", "namespace"]],
    ["g:namespace:/b", ["open", "namespace", "changed"]],
    ["g:namespace:/c", ["open", "namespace", "removed"]],
  ]);
  const [, b] = root.boxes;
  assert.deepEqual(b.level.boxes.map((box) => box.loose.map((port) => [port.label, port.classes])), [[["/v", ["topic", "added"]], ["", ["topic"]]]]);
});

test("a line of several topics says which of them ends keep apart, and by what quality of service", async () => {
  const of = data(["/a > /x", "/b < /x", "/a > /y", "/b < /y", "/c > /x2", "/b < /x2", "/c > /y2", "/b < /y2", "/c > /z2", "/b < /z2"]);
  const clashing = (...names) => {
    const { channels, connections } = of.entries[0];
    for (const each of connections) {
      if (names.includes(channels[each.channel].name)) each.qos = each.role === "publisher" ? "best_effort, volatile" : "reliable, volatile";
    }
  };
  clashing("/y", "/y2");
  assert.deepEqual((await scene(of)).sheet.labels.map((each) => each.lines), [["/x", "/y", "best_effort ≠ reliable"], ["3 topics", "/y2: best_effort ≠ reliable"]]);
  clashing("/z2");
  assert.deepEqual((await scene(of)).sheet.labels[1].lines, ["3 topics", "2: best_effort ≠ reliable"]);
});
