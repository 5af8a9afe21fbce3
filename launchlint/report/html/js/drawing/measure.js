// How wide a text is in the drawing's font: asked of the browser, guessed where there is none.

/** @typedef {import("./boxes").Measure} Measure */

const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
const SIZES = { title: 13, detail: 12, condition: 12, host: 12, count: 12, label: 12 };
const GUESS = 0.58;

/** @returns {Measure} */
export function measurer() {
  const canvas = typeof document === "undefined" ? null : document.createElement("canvas").getContext("2d");
  /** @type {Map<string, number>} */
  const known = new Map();
  return (text, kind) => {
    const size = SIZES[kind];
    if (!canvas) return text.length * size * GUESS;
    const font = `${kind === "title" ? 600 : 400} ${size}px ${FONT}`;
    const key = `${kind === "title" ? "b" : ""}${size} ${text}`;
    let width = known.get(key);
    if (width === undefined) {
      canvas.font = font;
      width = canvas.measureText(text).width;
      known.set(key, width);
    }
    return width;
  };
}
