/** On paper all of the drawing is seen, whatever part of it is on the screen, and in the light theme: set just before it is printed. */

import { part } from "./elements.js";

const MARGIN = 8;

export function preparePrint() {
  /** @type {(() => void)[]} */
  let undo = [];
  window.addEventListener("beforeprint", () => {
    const { dataset } = document.documentElement;
    const theme = dataset["theme"];
    dataset["theme"] = "light";
    undo = [() => (theme === undefined ? delete dataset["theme"] : (dataset["theme"] = theme))];
    const svg = part("drawing").querySelector(":scope > svg");
    const content = svg?.querySelector(":scope > g");
    if (!svg || !(content instanceof SVGGElement)) return;
    const { x, y, width, height } = content.getBBox();
    svg.setAttribute("viewBox", [x - MARGIN, y - MARGIN, width + 2 * MARGIN, height + 2 * MARGIN].join(" "));
    // The style sheet takes the place on the screen from what is printed: it may change once more while the page is laid out for paper.
    svg.classList.add("printing");
    undo.push(
      () => svg.removeAttribute("viewBox"),
      () => svg.classList.remove("printing"),
    );
  });
  window.addEventListener("afterprint", () => {
    for (const each of undo.splice(0)) each();
  });
}
