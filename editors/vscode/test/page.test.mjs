import assert from "node:assert/strict";
import test from "node:test";
import parts from "../dist/parts/page.js";

test("what a message says cannot become a part of the page", () => {
  const html = parts.message("No topology", '<script>alert("&")</script>');
  assert.ok(html.includes("&lt;script&gt;alert(&quot;&amp;&quot;)&lt;/script&gt;"));
  assert.ok(!html.includes("<script"));
  assert.match(html, /default-src 'none'/);
});
