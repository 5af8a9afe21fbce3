// Reads Mermaid files as GitHub does (strict, with its limits) and prints what is in each: one line of JSON for each file.
import { readFileSync } from "node:fs";
import { JSDOM } from "jsdom";

const { window } = new JSDOM("<!DOCTYPE html><body></body>");
globalThis.window = window;
globalThis.document = window.document;
const { default: mermaid } = await import("mermaid");
mermaid.initialize({ startOnLoad: false, securityLevel: "strict", maxEdges: 500, maxTextSize: 50000 });

for (const file of process.argv.slice(2)) {
  const text = readFileSync(file, "utf8");
  await mermaid.parse(text);
  const { db } = await mermaid.mermaidAPI.getDiagramFromText(text);
  const boxes = [...db.getVertices().values()];
  const groups = db.getSubGraphs();
  const names = new Set(groups.map((group) => group.id));
  console.log(
    JSON.stringify({
      boxes: boxes.filter((box) => !names.has(box.id)).length,
      arrows: db.getEdges().length,
      groups: groups.length,
      acting: boxes.filter((box) => box.link || box.haveCallback).length,
      foreign: boxes.filter((box) => !/^n\d+$/.test(box.id) || /<(?!br)/.test(box.text ?? "")).length,
    }),
  );
}
