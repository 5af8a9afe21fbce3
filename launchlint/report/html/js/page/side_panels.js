/** Tree and details at the sides of the drawing: each can be folded and made wider, and stays so in this browser. */

import { button, element, part } from "./elements.js";

/** @typedef {{ width: number, folded: boolean }} Form */

const SIDES = /** @type {const} */ ([
  { id: "tree", name: "Tree", sign: "◧", usual: 260, grows: 1 },
  { id: "panel", name: "Details", sign: "◨", usual: 360, grows: -1 },
]);
const LEAST = 160;
const MOST = 720;
const STEP = 20;

/** @returns {HTMLButtonElement[]} the buttons that fold each of them */
export function createSidePanels() {
  // Their widths are a style sheet of their own: the page allows no style attributes.
  const sheet = new CSSStyleSheet();
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
  /** @type {Map<string, number>} */
  const widths = new Map();
  return SIDES.map(({ id, name, sign, usual, grows }) => {
    const key = `launchlint-${id}`;
    let form = remembered(key, usual);
    const fold = button(sign, () => become({ ...form, folded: !form.folded }), { class: "fold-side", "aria-controls": id });
    const bar = element("div", {
      class: `divider ${id}`,
      role: "separator",
      tabindex: 0,
      "aria-orientation": "vertical",
      "aria-label": `Width of the ${name.toLowerCase()}`,
      "aria-valuemin": LEAST,
      "aria-valuemax": MOST,
    });
    part("stage").append(bar); // a landmark has to hold it

    /** @param {Form} next */
    function become(next) {
      form = { ...next, width: Math.max(LEAST, Math.min(MOST, Math.round(next.width))) };
      widths.set(id, form.width);
      sheet.replaceSync(`body { ${Array.from(widths, ([side, width]) => `--${side}-width: ${width}px;`).join(" ")} }`);
      document.body.toggleAttribute(`data-${id}-folded`, form.folded);
      bar.setAttribute("aria-valuenow", String(form.width));
      fold.setAttribute("aria-expanded", String(!form.folded));
      fold.setAttribute("aria-label", `${form.folded ? "Show" : "Fold"} the ${name.toLowerCase()}`);
      fold.title = `${form.folded ? "Show" : "Fold"} the ${name.toLowerCase()}`;
      remember(key, form);
    }

    bar.addEventListener("pointerdown", (event) => {
      const [from, width] = [event.clientX, form.width];
      bar.setPointerCapture(event.pointerId);
      const follow = (/** @type {PointerEvent} */ moved) => become({ ...form, width: width + (moved.clientX - from) * grows });
      bar.addEventListener("pointermove", follow);
      bar.addEventListener("lostpointercapture", () => bar.removeEventListener("pointermove", follow), { once: true });
    });
    bar.addEventListener("keydown", (event) => {
      const steps = { ArrowRight: STEP, ArrowLeft: -STEP }[event.key];
      if (steps === undefined) return;
      event.preventDefault();
      become({ ...form, width: form.width + steps * grows });
    });
    become(form);
    return fold;
  });
}

/** @param {string} key @param {number} usual @returns {Form} */
function remembered(key, usual) {
  try {
    const [width, folded] = (localStorage.getItem(key) ?? "").split(" ");
    return { width: Number(width) || usual, folded: folded === "folded" };
  } catch {
    return { width: usual, folded: false }; // a page from a file may have no storage
  }
}

/** @param {string} key @param {Form} form */
function remember(key, { width, folded }) {
  try {
    localStorage.setItem(key, `${width} ${folded ? "folded" : "open"}`);
  } catch {
    // then it holds for this page only
  }
}
