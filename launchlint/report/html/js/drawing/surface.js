// The element on the page: paints scenes, keeps the viewport still, lights what is selected, and tells what people do.

import styles from "./drawing.css";
import { exported } from "./export.js";
import { showLegend } from "./legend.js";
import { measurer } from "./measure.js";
import { paint } from "./paint.js";
import { rastered } from "./raster.js";
import { Director, viewKey } from "./scene.js";
import { element } from "./shapes.js";
import { Viewport } from "./viewport.js";
import { toldNames } from "./told.js";
import { litBy } from "./walk.js";

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("./types").DrawingEvents} DrawingEvents */
/** @typedef {import("./types").Selection} Selection */
/** @typedef {import("./types").ViewState} ViewState */
/** @typedef {import("./engine").Engine} Engine */
/** @typedef {import("./model").Area} Area */
/** @typedef {import("./paint").Painted} Painted */
/** @typedef {import("./scene").Scene} Scene */

/** Milliseconds in which boxes glide to their new place. */
const GLIDE = 220;
/** Milliseconds without a move, after which it is told where the drawing stands. */
const PAUSE = 250;
/** Milliseconds that a drawing may take without a sign that it is being made. */
const PATIENCE = 150;

/** What has been changed on the page is on the screen; a page that nobody sees is not waited for. */
function shown() {
  return new Promise((done) => {
    requestAnimationFrame(() => setTimeout(done));
    setTimeout(done, PATIENCE);
  });
}

export class Surface {
  /** @param {ReportData} data @param {HTMLElement} host @param {DrawingEvents} events */
  constructor(data, host, events) {
    this.host = host;
    this.events = events;
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(styles);
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
    host.classList.add("ll-drawing-host");
    const ELK = /** @type {{ ELK?: new () => Engine }} */ (globalThis).ELK;
    if (!ELK) throw new Error("elk.js is not loaded");
    this.director = new Director(data, new ELK(), measurer());
    this.svgElement = element("svg", { class: "ll-drawing", tabindex: 0, role: "group", "aria-label": "Connection graph" }, [hatching()]);
    this.content = this.svgElement.appendChild(element("g"));
    this.legend = document.createElement("details");
    this.legend.className = "ll-legend";
    this.legend.append(document.createElement("summary"));
    this.legend.firstElementChild?.append("Legend");
    host.replaceChildren(this.svgElement, this.legend);
    this.pause = 0;
    this.viewport = new Viewport(this.svgElement, this.content, (all) => {
      clearTimeout(this.pause);
      if (all) this.events.moved(null);
      else this.pause = window.setTimeout(() => this.events.moved(this.spot()), PAUSE);
    });
    /** @type {Scene | null} */
    this.scene = null;
    /** @type {Painted | null} */
    this.painted = null;
    /** @type {Set<string>} */
    this.open = new Set();
    /** @type {Selection | null} */
    this.selection = null;
    this.turn = 0;
    /** Whether the last drawing took longer than people wait: then a sign is shown before the next one is begun. */
    this.slow = false;
    this.shownKey = "";
    this.svgElement.addEventListener("click", (event) => this.click(event));
    this.svgElement.addEventListener("dblclick", (event) => this.doubleClick(event));
    new ResizeObserver(() => this.viewport.touched || this.viewport.begin()).observe(host);
  }

  /** @param {ViewState} state */
  async show(state) {
    const turn = ++this.turn;
    const key = keyOf(state);
    const same = key.all === this.shownKey;
    this.events.busy(true);
    this.host.classList.toggle("waiting", !same && this.slow);
    const sign = window.setTimeout(() => turn === this.turn && this.host.classList.add("waiting"), PATIENCE);
    if (!same && this.slow) await shown();
    try {
      const scene = same && this.scene ? this.scene : await this.made(state);
      if (turn !== this.turn) return; // a later state is being drawn
      scene.view.state = state;
      const before = this.scene;
      if (!same || !before) {
        this.scene = scene;
        this.put(scene, before && isAlike(before.view.state, state) ? before : null);
      }
      this.shownKey = key.all;
      this.match(state.matches);
      this.select(this.selection);
    } finally {
      clearTimeout(sign);
      if (turn === this.turn) {
        this.host.classList.remove("waiting");
        this.events.busy(false);
      }
    }
  }

  /** @param {ViewState} state */
  async made(state) {
    const begun = performance.now();
    const scene = await this.director.scene(state, this.viewport.extent);
    this.slow = performance.now() - begun > PATIENCE;
    return scene;
  }

  /** @param {Scene} scene @param {Scene | null} before the one whose place on the screen is kept */
  put(scene, before) {
    const painted = paint(scene.sheet);
    this.content.replaceChildren(painted.content);
    this.painted = painted;
    const previous = this.open;
    this.open = scene.open;
    this.viewport.size = { width: scene.sheet.width, height: scene.sheet.height };
    if (before) this.hold(before, scene, previous);
    else this.viewport.begin();
    showLegend(scene.sheet, this.legend);
  }

  /** Keeps what was opened or folded where it is on the screen, and lets the boxes glide. @param {Scene} before @param {Scene} after @param {Set<string>} previous */
  hold(before, after, previous) {
    const [old, now] = [areas(before), areas(after)];
    const toggled = [...after.open, ...previous].find((id) => after.open.has(id) !== previous.has(id) && old.has(id) && now.has(id));
    const anchor = toggled ?? [...old.keys()].find((id) => now.has(id));
    const [from, to] = [old.get(anchor ?? ""), now.get(anchor ?? "")];
    if (!from || !to) {
      this.viewport.begin();
      return;
    }
    const { place } = this.viewport;
    const shift = { x: from.x - to.x, y: from.y - to.y };
    this.viewport.set({ ...place, x: place.x + shift.x * place.scale, y: place.y + shift.y * place.scale });
    this.viewport.apply();
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
    for (const [id, drawn] of this.painted?.boxes ?? []) {
      const [start, end] = [old.get(id), now.get(id)];
      if (!end) continue;
      const target = `translate(${end.x}px, ${end.y}px)`;
      if (!start) drawn.animate([{ opacity: 0 }, { opacity: 1 }], { duration: GLIDE });
      else if (Math.abs(start.x - end.x - shift.x) + Math.abs(start.y - end.y - shift.y) > 1) {
        drawn.animate([{ transform: `translate(${start.x - shift.x}px, ${start.y - shift.y}px)` }, { transform: target }], { duration: GLIDE, easing: "ease-out" });
      }
    }
    for (const name of ["lines", "names"]) this.painted?.content.querySelector(`.${name}`)?.animate([{ opacity: 0 }, { opacity: 1 }], { duration: GLIDE });
  }

  /** @param {Set<string> | null} matches */
  match(matches) {
    this.svgElement.classList.toggle("searching", matches !== null);
    const found = new Set(matches);
    for (const id of matches ?? []) if (id.startsWith("n:")) found.add(this.standsFor(Number(id.slice(2))) ?? "");
    for (const [id, drawn] of this.painted?.boxes ?? []) {
      const wires = this.scene?.drawn.boxes.get(id)?.wires ?? [];
      drawn.classList.toggle("match", found.has(id) || wires.some((wire) => found.has(wire.id)));
    }
    for (const each of this.painted?.loose ?? []) each.element.classList.toggle("match", each.wires.some((wire) => found.has(wire)));
  }

  /** @param {Selection | null} selection */
  select(selection) {
    this.selection = selection;
    const { scene, painted } = this;
    if (!scene || !painted) return;
    const lit = selection && litBy(scene.drawn, scene.view, selection, (node) => this.standsFor(node));
    const any = Boolean(lit && lit.boxes.size + lit.edges.size);
    this.svgElement.classList.toggle("selecting", any);
    const ports = new Set();
    for (const [id, drawn] of painted.boxes) {
      drawn.classList.toggle("lit", any && lit?.boxes.has(id));
      drawn.classList.toggle("chosen", any && lit?.chosen.has(id));
    }
    for (const [id, drawn] of painted.lines) {
      const isLit = any && Boolean(lit?.edges.has(id));
      for (const each of drawn) {
        each.classList.toggle("lit", isLit);
        each.classList.toggle("chosen", any && Boolean(lit?.chosen.has(id)));
      }
      const edge = isLit ? scene.drawn.edges.get(id) : undefined;
      if (edge) ports.add(edge.from).add(edge.to);
    }
    for (const each of painted.ports) {
      each.element.classList.toggle("lit", ports.has(each.id));
      each.element.classList.toggle("own", selection?.kind === "container" && each.id.startsWith(`${selection.id}|`));
    }
    painted.content.querySelector(".told-names")?.replaceChildren(...(selection && lit && any ? toldNames(scene, selection, lit.chosen) : []));
    const wire = selection?.kind === "channel" ? selection.id : "";
    for (const each of painted.loose) each.element.classList.toggle("lit", wire ? each.wires.includes(wire) : Boolean(lit?.chosen.has(each.box)));
  }

  /** @param {Selection} selection */
  panTo(selection) {
    const { scene } = this;
    const lit = scene && litBy(scene.drawn, scene.view, selection, (node) => this.standsFor(node));
    if (!scene || !lit) return;
    const wanted = lit.chosen.size ? lit.chosen : lit.boxes;
    const found = scene.sheet.boxes.filter((each) => wanted.has(each.box.id));
    const edges = scene.sheet.edges.filter((each) => lit.chosen.has(each.edge.id)).flatMap((each) => each.points.map((point) => ({ ...point, width: 0, height: 0 })));
    const area = around([...found, ...edges]);
    if (area) this.viewport.show(area);
  }

  /** The middle of the screen, told by the box that is nearest to it. @returns {import("./types").Spot | null} */
  spot() {
    const { place, extent } = this.viewport;
    const [x, y] = [(extent.width / 2 - place.x) / place.scale, (extent.height / 2 - place.y) / place.scale];
    let [nearest, least] = [/** @type {Scene["sheet"]["boxes"][number] | null} */ (null), Infinity];
    for (const each of this.scene?.sheet.boxes ?? []) {
      const distance = Math.hypot(each.x + each.width / 2 - x, each.y + each.height / 2 - y);
      if (each.box.kind !== "pill" && distance < least) [nearest, least] = [each, distance];
    }
    return nearest && { id: nearest.box.id, x: x - nearest.x, y: y - nearest.y, scale: place.scale };
  }

  /** @param {import("./types").Spot} spot */
  goTo({ id, x, y, scale }) {
    const found = this.scene?.sheet.boxes.find((each) => each.box.id === id);
    if (!found) return false;
    const { width, height } = this.viewport.extent;
    this.viewport.touched = true;
    this.viewport.set({ scale, x: width / 2 - (found.x + x) * scale, y: height / 2 - (found.y + y) * scale });
    this.viewport.apply();
    return true;
  }

  /** @returns {import("./types").Extent} */
  extent() {
    const { scene, viewport } = this;
    const { place, extent } = viewport;
    const found = { folded: 0, boxes: 0, outside: 0 };
    for (const { box, x, y, width, height } of scene?.sheet.boxes ?? []) {
      if (box.kind === "folded") {
        found.boxes += 1;
        found.folded += scene?.view.counts.get(box.id) ?? 0;
      }
      const [left, top] = [place.x + x * place.scale, place.y + y * place.scale];
      const isSeen = left > -1 && top > -1 && left + width * place.scale < extent.width + 1 && top + height * place.scale < extent.height + 1;
      if (!isSeen && box.kind !== "open") found.outside += 1;
    }
    return found;
  }

  /** @param {number} node @returns {string | null} */
  standsFor(node) {
    const { scene } = this;
    if (!scene || !scene.view.shown[node]) return null;
    const own = `n:${node}`;
    if (scene.drawn.boxes.has(own)) return own;
    /** @type {string | null} */
    let found = null;
    for (let group = scene.view.home.get(node); group; group = scene.view.groups.get(group.parent)) {
      if (scene.drawn.boxes.get(group.id)?.kind === "folded") found = group.id;
    }
    return found;
  }

  /** @param {Selection} selection */
  isDrawn({ kind, id }) {
    const { scene } = this;
    if (!scene) return false;
    if (kind === "edge") return scene.drawn.edges.has(id);
    if (kind === "node" || kind === "container") return scene.drawn.boxes.has(id);
    const boxes = Array.from(scene.drawn.boxes.values());
    return scene.drawn.carrying.has(id) || boxes.some((box) => [box, ...box.loose].some((each) => each.wires.some((wire) => wire.id === id)));
  }

  /** @param {Selection} selection */
  wiresOf({ id }) {
    const edge = this.scene?.drawn.edges.get(id);
    return (edge?.wires ?? this.scene?.drawn.boxes.get(id)?.wires ?? []).map((wire) => wire.id);
  }

  focusables() {
    const { scene, painted } = this;
    if (!scene || !painted) return [];
    return scene.sheet.boxes
      .flatMap(({ box }) => {
        const drawn = painted.boxes.get(box.id);
        const selection = selectionOf(box.id, box.wires.map((wire) => wire.id));
        return drawn && selection ? [{ selection, label: box.title, element: drawn }] : [];
      });
  }

  svg() {
    return this.scene ? exported(this.svgElement, this.viewport.size, styles) : "";
  }

  /** @returns {Promise<Blob | null>} */
  png() {
    return new Promise((resolve) => rastered(this.svgElement, this.viewport.size).toBlob(resolve, "image/png"));
  }

  /** @param {MouseEvent} event */
  click(event) {
    if (this.viewport.dragged || !(event.target instanceof Element)) return;
    const container = event.target.closest("[data-fold]")?.getAttribute("data-fold");
    if (container) this.events.expand(container, !this.open.has(container));
    else this.events.select(this.at(event.target));
  }

  /** @param {MouseEvent} event */
  doubleClick(event) {
    if (!(event.target instanceof Element) || event.target.closest("[data-fold]")) return;
    const id = event.target.closest(".box.folded, .box.open .head")?.closest("[data-id]")?.getAttribute("data-id");
    if (id) this.events.expand(id, !this.open.has(id));
  }

  /** @param {Element} target @returns {Selection | null} */
  at(target) {
    const loose = target.closest("[data-loose]")?.getAttribute("data-loose")?.split(" ");
    const id = target.closest("[data-id]")?.getAttribute("data-id") ?? "";
    if (loose?.length === 1 && loose[0]) return { kind: "channel", id: loose[0] };
    if (loose) return selectionOf(this.painted?.loose.find((each) => each.element === target.closest("[data-loose]"))?.box ?? "", []);
    if (id.startsWith("g:") && this.open.has(id) && !target.closest(".head")) return null;
    return selectionOf(id, this.wiresOf({ kind: "edge", id }));
  }
}

/**
 * @param {string} id of a box or a line
 * @param {string[]} wires that it stands for
 * @returns {Selection | null}
 */
function selectionOf(id, wires) {
  if (id.startsWith("n:")) return { kind: "node", id };
  if (id.startsWith("g:")) return { kind: "container", id };
  const [only, more] = wires;
  if (only && more === undefined) return { kind: only.startsWith("p:") ? "param" : "channel", id: only };
  return id ? { kind: "edge", id } : null;
}

/** Whether two states show the same launch file in the same way, so that most of what is drawn stands in both. @param {ViewState} one @param {ViewState} other */
function isAlike(one, other) {
  return one.entry === other.entry && one.grouping === other.grouping && one.focus === other.focus;
}

/** What of a state asks for another layout, and what for another view. @param {ViewState} state */
function keyOf(state) {
  const view = viewKey(state);
  return { view, all: `${view} ${state.expanded === "auto" ? "auto" : JSON.stringify([...state.expanded].sort())}` };
}

/** @param {Scene} scene @returns {Map<string, Area>} */
function areas(scene) {
  return new Map(scene.sheet.boxes.map((each) => [each.box.id, each]));
}

/** @param {Area[]} all @returns {Area | null} */
function around(all) {
  if (!all.length) return null;
  const [x, y] = [Math.min(...all.map((each) => each.x)), Math.min(...all.map((each) => each.y))];
  return { x, y, width: Math.max(...all.map((each) => each.x + each.width)) - x, height: Math.max(...all.map((each) => each.y + each.height)) - y };
}

function hatching() {
  const lines = element("pattern", { id: "ll-hatching", class: "hatching", width: 7, height: 7, patternUnits: "userSpaceOnUse" }, [element("path", { d: "M-1 8L8 -1M-1 1L1 -1M6 8L8 6" })]);
  return element("defs", {}, [lines]);
}
