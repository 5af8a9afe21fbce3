import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import parts from "../dist/parts/following.js";

test("what is selected is said as the page hears it, and heard as the page says it", () => {
  const node = { kind: "node", name: "/turtle" };
  assert.deepEqual(parts.selected(node), { launchlint: ["node", "/turtle"] });
  assert.deepEqual(parts.chosen(parts.selected(node)), node);
});

test("what is no choice is not heard", () => {
  for (const said of [undefined, null, 3, "node", {}, { launchlint: "node" }, { launchlint: ["node"] }, { launchlint: [1, 2] }]) {
    assert.equal(parts.chosen(said), undefined);
  }
});

test("the requests are those that the server answers", async () => {
  const here = new URL("..", import.meta.url);
  const asked = await readFile(new URL("src/topology.ts", here), "utf8") + await readFile(new URL("src/extension.ts", here), "utf8");
  const server = new URL("../../launchlint/server/", here);
  const answered = await readFile(new URL("features/drawing.py", server), "utf8") + await readFile(new URL("service.py", server), "utf8");
  const names = [...asked.matchAll(/"(launchlint\/\w+)"/g)].map(([, name]) => name);
  assert.deepEqual([...new Set(names)].sort(), ["launchlint/topology", "launchlint/topologyAt", "launchlint/topologyChanged", "launchlint/topologyPlace"]);
  for (const name of names) assert.ok(answered.includes(`"${name}"`), name);
});
