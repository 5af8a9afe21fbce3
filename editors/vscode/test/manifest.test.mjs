import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";

const here = new URL("..", import.meta.url);
const manifest = JSON.parse(await readFile(new URL("package.json", here), "utf8"));
const source = await readFile(new URL("src/extension.ts", here), "utf8");

test("every command of the manifest is registered", () => {
  for (const { command } of manifest.contributes.commands) assert.ok(source.includes(`registerCommand("${command}"`), command);
});

test("every setting is read, by the extension or by the client", () => {
  const read = ["launchlint.enable", "launchlint.path", "launchlint.trace.server"];
  assert.deepEqual(Object.keys(manifest.contributes.configuration.properties).sort(), read);
});

test("the problem matcher reads what launchlint prints", () => {
  const { pattern } = manifest.contributes.problemMatchers[0];
  const found = "src/a b/x.launch:3:7: warning LL504 the param rate is set twice".match(new RegExp(pattern.regexp));
  assert.deepEqual([found[pattern.file], found[pattern.line], found[pattern.column], found[pattern.severity], found[pattern.code]], [
    "src/a b/x.launch", "3", "7", "warning", "LL504",
  ]);
});
