// How the page puts things into words.

import assert from "node:assert/strict";
import { test } from "node:test";
import { when } from "../../../../launchlint/report/html/js/page/wording.js";

const entry = { configurations: ["", ...Array.from({ length: 19 }, (_, at) => `arg${at}:=true`)] };

test("of many configurations the first are named", () => {
  assert.equal(when(entry, []), "");
  assert.equal(when(entry, [0, 1]), "only with default args or arg0:=true");
  assert.equal(when(entry, [0, 1, 2, 3, 4]), "only with default args or arg0:=true or arg1:=true or arg2:=true or arg3:=true");
  assert.equal(when(entry, [0, 1, 2, 3, 4, 5, 6, 7]), "only with default args or arg0:=true or arg1:=true or arg2:=true or 4 others");
  assert.equal(when(entry, entry.configurations.map((_, at) => at).slice(1)), "not with default args");
});
