/** Saves what is shown as SVG, PNG, Mermaid, DOT or JSON. */

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
    ["PNG picture", () => void page.drawing.png().then((picture) => picture && save("image/png", "png", picture))],
    ["Mermaid", () => save("text/plain", "mmd", mermaid(pictureOf(page)))],
    ["Graphviz DOT", () => save("text/vnd.graphviz", "dot", dot(pictureOf(page)))],
    ["JSON", () => save("application/json", "json", `${JSON.stringify(pictureOf(page), null, 2)}\n`)],
  ]);
}

/** @param {string} type @param {string} ending @param {string | Blob} content */
function save(type, ending, content) {
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = element("a", { href: address, download: `launchlint-graph.${ending}` });
  document.body.append(link);
  link.click();
  link.remove();
  // The browser reads it after this returns.
  window.setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
