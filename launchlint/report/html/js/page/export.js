/** Saves what is shown as SVG, Mermaid, DOT or JSON. */

import { dot } from "./dot.js";
import { element } from "./elements.js";
import { menu } from "./menu.js";
import { mermaid } from "./mermaid.js";
import { pictureOf } from "./picture.js";

/** @typedef {import("./reference.js").Page} Page */

/** @param {Page} page */
export function createExportMenu(page) {
  return menu("Export", [
    ["SVG picture", () => save("image/svg+xml", "svg", page.drawing.svg())],
    ["Mermaid", () => save("text/plain", "mmd", mermaid(pictureOf(page)))],
    ["Graphviz DOT", () => save("text/vnd.graphviz", "dot", dot(pictureOf(page)))],
    ["JSON", () => save("application/json", "json", `${JSON.stringify(pictureOf(page), null, 2)}\n`)],
  ]);
}

/** @param {string} type @param {string} ending @param {string} text */
function save(type, ending, text) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = element("a", { href: address, download: `launchlint-graph.${ending}` });
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads it after this returns.
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
