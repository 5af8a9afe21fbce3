import assert from "node:assert/strict";
import os from "node:os";
import test from "node:test";
import parts from "../dist/parts/candidates.js";

const given = { configured: "", interpreter: undefined, folder: "/robot", trusted: true, windows: false };

test("the selected environment comes first, then those of the folder, then the PATH", () => {
  assert.deepEqual(parts.candidates({ ...given, interpreter: "/envs/ros/bin/python" }), [
    "/envs/ros/bin/launchlint", "/robot/.venv/bin/launchlint", "/robot/venv/bin/launchlint", "launchlint",
  ]);
});

test("what was configured is the only one", () => {
  assert.deepEqual(parts.candidates({ ...given, configured: " ~/bin/launchlint " }), [`${os.homedir()}/bin/launchlint`]);
  assert.deepEqual(parts.candidates({ ...given, configured: "${workspaceFolder}/env/bin/launchlint" }), ["/robot/env/bin/launchlint"]);
});

test("nothing that an untrusted workspace says is started", () => {
  assert.deepEqual(parts.candidates({ ...given, trusted: false, configured: "./evil", interpreter: "/robot/evil/python" }), ["launchlint"]);
});

test("without a folder, and with an interpreter that is just a name", () => {
  assert.deepEqual(parts.candidates({ ...given, folder: undefined, interpreter: "python3" }), ["launchlint"]);
});
