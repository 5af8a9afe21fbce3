// The containers around nodes, and which of them are open at first.

import assert from "node:assert/strict";
import { test } from "node:test";
import { autoExpansion, opening } from "../../../../launchlint/report/html/js/drawing/expansion.js";
import { containersOf } from "../../../../launchlint/report/html/js/drawing/tree.js";
import { data } from "./written.js";

/** A container in words: its label, what is directly in it, and how many nodes in all. */
function outline(entry, group) {
  const nodes = group.nodes.map((each) => entry.nodes[each].name);
  return { [`${group.kind} ${group.label} (${group.count})`]: [...group.groups.map((each) => outline(entry, each)), ...nodes] };
}

const of = (facts, others, grouping) => {
  const [entry] = data(facts, others).entries;
  return outline(entry, containersOf(entry, grouping));
};
const named = (...names) => ({ nodes: Object.fromEntries(names.map((name) => [name, {}])) });

test("namespaces, one that holds only another one joined with it, names in the order of people", () => {
  assert.deepEqual(of([], named("/top", "/a/b/cam10", "/a/b/cam2", "/c/x", "/c/d/y"), "namespace"), {
    "root / (5)": [
      { "namespace /a/b (2)": ["/a/b/cam2", "/a/b/cam10"] },
      { "namespace /c (2)": [{ "namespace d (1)": ["/c/d/y"] }, "/c/x"] },
      "/top",
    ],
  });
});

test("elements of launch files, the empty ones and groups without a name left out", () => {
  const containers = [
    { kind: "include", label: "bringup/launch/camera.launch", namespace: "/", place: null, parent: -1 },
    { kind: "group", label: "cam", namespace: "/cam", place: null, parent: 0 },
    { kind: "group", label: "", namespace: "/", place: null, parent: -1 },
    { kind: "group", label: "", namespace: "/", place: null, parent: -1 },
  ];
  const nodes = { "/cam/driver": { container: 1 }, "/cam/flip": { container: 1 }, "/alone": { container: 2 }, "/top": {} };
  assert.deepEqual(of([], { nodes, containers }, "file"), {
    "root / (4)": [{ "include camera.launch › cam (2)": ["/cam/driver", "/cam/flip"] }, "/alone", "/top"],
  });
});

test("includes of one file are told apart", () => {
  const containers = [0, 1, 2].map(() => ({ kind: "include", label: "demo/drone.launch", namespace: "/", place: null, parent: -1 }));
  const nodes = { "/drone_0_pose": { container: 0 }, "/drone_0_map": { container: 0 }, "/drone_1_pose": { container: 1 } };
  assert.deepEqual(of([], { nodes, containers }, "file"), {
    "root / (3)": [{ "include drone.launch · drone_0 (2)": ["/drone_0_map", "/drone_0_pose"] }, { "include drone.launch · drone_1_pose (1)": ["/drone_1_pose"] }],
  });
  assert.deepEqual(of([], { nodes: { "/a": { container: 0 }, "/b": { container: 0 }, "/c": { container: 1 } }, containers }, "file"), {
    "root / (3)": [{ "include drone.launch · 1 (2)": ["/a", "/b"] }, { "include drone.launch · 2 (1)": ["/c"] }],
  });
});

test("packages", () => {
  const nodes = { "/b": { package: "tf" }, "/a": { package: "tf" }, "/c": { package: "" } };
  assert.deepEqual(of([], { nodes }, "package"), { "root / (3)": [{ "package no package (1)": ["/c"] }, { "package tf (2)": ["/a", "/b"] }] });
});

test("too many siblings stand in ranges", () => {
  const names = Array.from({ length: 42 }, (_, at) => `/cam_${at}`);
  const range = (from, to) => ({ [`range cam_${from} – ${to} (${to - from + 1})`]: names.slice(from, to + 1) });
  assert.deepEqual(of([], named(...names), "namespace"), { "root / (42)": [range(0, 9), range(10, 20), range(21, 30), range(31, 41)] });
});

test("too many siblings that different files start stand by file", () => {
  const containers = ["left", "right"].map((each) => ({ kind: "include", label: `demo/${each}.launch`, namespace: "/", place: null, parent: -1 }));
  const names = (side, count) => Array.from({ length: count }, (_, at) => `/${side}_${at}`);
  const nodes = Object.fromEntries([...names("l", 25).map((name) => [name, { container: 0 }]), ...names("r", 20).map((name) => [name, { container: 1 }]), ["/top", {}]]);
  assert.deepEqual(of([], { nodes, containers }, "namespace"), {
    "root / (46)": [{ "include left.launch (25)": names("l", 25) }, { "include right.launch (20)": names("r", 20) }, "/top"],
  });
});

test("too many siblings stand by the outermost include that parts them, those of one node beside the others", () => {
  const drones = Array.from({ length: 10 }, (_, at) => at);
  const include = (label, parent) => ({ kind: "include", label: `demo/${label}.launch`, namespace: "/", place: null, parent });
  const containers = [include("all", -1), ...drones.flatMap((at) => [include("drone", 0), include("planner", 1 + 3 * at), include("simulator", 1 + 3 * at)])];
  const own = (at) => [[`/d${at}_server`, 1 + 3 * at], [`/d${at}_planner`, 2 + 3 * at], [`/d${at}_map`, 3 + 3 * at], [`/d${at}_odom`, 3 + 3 * at], [`/d${at}_pose`, 3 + 3 * at]];
  const nodes = Object.fromEntries([...drones.flatMap(own).map(([name, container]) => [name, { container }]), ["/rviz", { container: 0 }]]);
  const drone = (at) => ({
    [`include drone.launch · d${at} (5)`]: [{ "include simulator.launch (3)": ["map", "odom", "pose"].map((each) => `/d${at}_${each}`) }, `/d${at}_planner`, `/d${at}_server`],
  });
  assert.deepEqual(of([], { nodes, containers }, "namespace"), { "root / (51)": [...drones.map(drone), "/rviz"] });
});

test("more includes than fit beside each other stand in ranges", () => {
  const containers = Array.from({ length: 24 }, () => ({ kind: "include", label: "demo/drone.launch", namespace: "/", place: null, parent: -1 }));
  const nodes = Object.fromEntries(containers.flatMap((_, at) => ["a", "b"].map((each) => [`/d${at}_${each}`, { container: at }])));
  const [root] = Object.values(of([], { nodes, containers }, "namespace"));
  assert.deepEqual(root.map((each) => Object.keys(each)[0].match(/^range .* \((\d+)\)$/)?.[1]), ["12", "12", "12", "12"]);
});

test("hostile nesting ends somewhere, and no node is lost", () => {
  const deep = `${"/d".repeat(2000)}/n`;
  const [entry] = data([], named(deep, "/d/x")).entries;
  const root = containersOf(entry, "namespace");
  assert.deepEqual(outline(entry, root), { "root / (2)": [{ "namespace /d (2)": [{ [`namespace ${"d/".repeat(1999).slice(0, -1)} (1)`]: [deep] }, "/d/x"] }] });
});

test("small containers are opened before large ones, outer before inner, as long as there is room", () => {
  const names = (namespace, count) => Array.from({ length: count }, (_, at) => `${namespace}/n${at}`);
  const [entry] = data([], named(...names("/large", 30), ...names("/small", 2), ...names("/outer/in", 2), "/outer/n")).entries;
  assert.deepEqual(opening(containersOf(entry, "namespace"), 12), ["g:namespace:/outer", "g:namespace:/small", "g:namespace:/outer/in"]);
  assert.deepEqual(opening(containersOf(entry, "namespace"), 4), ["g:namespace:/outer"]);
  assert.deepEqual([...autoExpansion(entry, "namespace", 1440, 900)].sort(), ["g:namespace:/large", "g:namespace:/outer", "g:namespace:/outer/in", "g:namespace:/small"]);
});
