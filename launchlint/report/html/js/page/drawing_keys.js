/** The keyboard in the drawing: one thing in it has the focus; arrows go to the next in their direction. */

import { part } from "./elements.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {ReturnType<import("../drawing/types").Drawing["focusables"]>[number]} Focusable */

/** How far off the way counts, against how far along it. */
const ASIDE = 2;

/** @type {ReadonlyMap<string, [x: number, y: number]>} */
const DIRECTIONS = new Map([
  ["ArrowLeft", [-1, 0]],
  ["ArrowRight", [1, 0]],
  ["ArrowUp", [0, -1]],
  ["ArrowDown", [0, 1]],
]);

/** @param {Page} page */
export function createDrawingKeys({ drawing, store }) {
  const host = part("drawing");
  let last = "";

  /** @param {Focusable | undefined} next */
  function go(next) {
    if (!next) return;
    last = next.selection.id;
    next.element.setAttribute("tabindex", "0");
    next.element.focus();
  }

  host.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const all = drawing.focusables();
    const at = all.find((each) => each.element === event.target);
    if (!at) return;
    const direction = DIRECTIONS.get(event.key);
    if (direction) go(nearest(all, at, direction));
    else if (event.key === "Enter") store.set({ selection: at.selection });
    else if (event.key === " " && at.selection.kind === "container") turn(at.selection.id);
    else if (event.key === "Home") go(all[0]);
    else if (event.key === "End") go(all.at(-1));
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  /** @param {string} id */
  function turn(id) {
    const expanded = drawing.expanded();
    if (!expanded.delete(id)) expanded.add(id);
    store.set({ expanded });
  }

  return {
    focus() {
      const all = drawing.focusables();
      const selected = store.get().selection?.id;
      go(all.find((each) => each.selection.id === selected) ?? all.find((each) => each.selection.id === last) ?? all[0]);
    },
    /** Remembers what in the drawing has the focus; what it returns gives it back after the drawing was made anew. */
    hold() {
      const held = drawing.focusables().find((each) => each.element === document.activeElement)?.selection.id;
      return () => {
        if (held && !host.contains(document.activeElement)) go(drawing.focusables().find((each) => each.selection.id === held));
      };
    },
  };
}

/**
 * The nearest thing in a direction.
 *
 * @param {Focusable[]} all
 * @param {Focusable} from
 * @param {[x: number, y: number]} direction
 */
function nearest(all, from, [dx, dy]) {
  const start = middle(from);
  let best;
  let least = Infinity;
  for (const each of all) {
    const { x, y } = middle(each);
    const along = (x - start.x) * dx + (y - start.y) * dy;
    const aside = Math.abs((x - start.x) * dy) + Math.abs((y - start.y) * dx);
    const cost = along + ASIDE * aside;
    if (each !== from && along > 1 && cost < least) {
      least = cost;
      best = each;
    }
  }
  return best;
}

/** @param {Focusable} each */
function middle({ element }) {
  const { left, top, width, height } = element.getBoundingClientRect();
  return { x: left + width / 2, y: top + height / 2 };
}
