// Where the drawing stands on the screen: moved by drag, wheel, pinch and keys.

const LARGEST = 3;
const SMALLEST = 0.04;
/** At a first look nothing is enlarged beyond this. */
const FIT_LARGEST = 1.6;
const MARGIN = 16;
/** Room for the legend. */
const FOOT = 36;
/** The smallest names of the drawing have 12 pixels: at this scale they have 9. */
export const LEGIBLE = 9.02 / 12;
/** Pixels a pointer may move in a click. */
const STILL = 4;
const STEP = 60;
/** Names can be read at this scale. */
const READABLE = 0.5;

/** @typedef {{ x: number, y: number, scale: number }} Place */

/**
 * The scale at which all of a drawing is seen.
 * @param {{ width: number, height: number }} size of the drawing
 * @param {{ width: number, height: number }} extent of the screen
 */
export function fitting(size, extent) {
  const { width, height } = room(extent);
  return Math.min(width / Math.max(1, size.width), height / Math.max(1, size.height));
}

/**
 * What a drawing has of the screen.
 * @param {{ width: number, height: number }} extent of the screen
 */
export function room({ width, height }) {
  return { width: Math.max(1, width - 2 * MARGIN), height: Math.max(1, height - 2 * MARGIN - FOOT) };
}

export class Viewport {
  /**
   * @param {SVGSVGElement} svg
   * @param {SVGGElement} content
   * @param {(all: boolean) => void} moved somebody moved it, or shows all of it
   */
  constructor(svg, content, moved) {
    this.svg = svg;
    this.tell = moved;
    this.content = content;
    /** @type {Place} */
    this.place = { x: 0, y: 0, scale: 1 };
    this.size = { width: 1, height: 1 };
    this.touched = false;
    this.frame = 0;
    /** @type {Map<number, { x: number, y: number }>} */
    this.pointers = new Map();
    this.moved = 0;
    svg.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    svg.addEventListener("pointerdown", (event) => this.down(event));
    svg.addEventListener("pointermove", (event) => this.move(event));
    for (const end of /** @type {const} */ (["pointerup", "pointercancel"])) svg.addEventListener(end, (event) => this.up(event));
    svg.addEventListener("keydown", (event) => this.key(event));
  }

  /** Whether the pointer was dragged, so that its release is no click. */
  get dragged() {
    return this.moved > STILL;
  }

  get extent() {
    const { clientWidth, clientHeight } = this.svg;
    return { width: clientWidth || 800, height: clientHeight || 600 };
  }

  /** @param {Place} place */
  set(place) {
    this.place = { ...place, scale: Math.min(LARGEST, Math.max(SMALLEST, place.scale)) };
    this.frame ||= requestAnimationFrame(() => this.apply());
  }

  apply() {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    const { x, y, scale } = this.place;
    this.content.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)}) scale(${scale.toFixed(4)})`);
    const distance = scale < 0.3 ? "far" : scale < 0.55 ? "middle" : "near";
    if (this.svg.dataset.distance !== distance) this.svg.dataset.distance = distance;
  }

  /** Shows all of the drawing. @param {number} [least] scale below which only a part of it is shown, from its beginning */
  fit(least = 0) {
    const { width, height } = this.extent;
    const scale = Math.max(least, Math.min(FIT_LARGEST, fitting(this.size, this.extent)));
    this.touched = false;
    this.set({ scale, x: Math.max(least && MARGIN, (width - this.size.width * scale) / 2), y: Math.max(least && MARGIN, (height - FOOT - this.size.height * scale) / 2) });
    this.apply();
  }

  /** Somebody wants to see all of it. */
  showAll() {
    this.fit();
    this.tell(true);
  }

  /** Shows all of the drawing, or as much of it as can be read. */
  begin() {
    this.fit(fitting(this.size, this.extent) < LEGIBLE ? LEGIBLE : 0);
  }

  /**
   * @param {number} factor
   * @param {number} [x] where on the screen what is there stays
   * @param {number} [y]
   */
  zoom(factor, x = this.extent.width / 2, y = this.extent.height / 2) {
    const { place } = this;
    const scale = Math.min(LARGEST, Math.max(SMALLEST, place.scale * factor));
    const ratio = scale / place.scale;
    this.touched = true;
    this.set({ scale, x: x - (x - place.x) * ratio, y: y - (y - place.y) * ratio });
    this.tell(false);
  }

  /** @param {number} dx @param {number} dy */
  pan(dx, dy) {
    this.touched = true;
    this.set({ ...this.place, x: this.place.x + dx, y: this.place.y + dy });
    this.tell(false);
  }

  /**
   * Brings an area of the drawing into view, at a scale at which it can be read; what can be read already stays where it is.
   * @param {{ x: number, y: number, width: number, height: number }} area
   */
  show(area) {
    const { width, height } = this.extent;
    const { x, y, scale: now } = this.place;
    const [left, top] = [x + area.x * now, y + area.y * now];
    const isSeen = left >= 0 && top >= 0 && left + area.width * now <= width && top + area.height * now <= height;
    if (isSeen && now >= READABLE) return;
    const most = Math.min((width - 2 * MARGIN) / area.width, (height - 2 * MARGIN) / area.height);
    const scale = Math.min(Math.max(this.place.scale, 0.7), Math.max(most, SMALLEST));
    this.touched = true;
    this.set({ scale, x: width / 2 - (area.x + area.width / 2) * scale, y: height / 2 - (area.y + area.height / 2) * scale });
    this.apply();
  }

  /** @param {WheelEvent} event */
  wheel(event) {
    event.preventDefault();
    const unit = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
    const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
    if (!event.ctrlKey && (event.shiftKey || dx !== 0)) {
      this.pan(event.shiftKey && !dx ? -dy : -dx, event.shiftKey ? 0 : -dy);
      return;
    }
    const at = this.svg.getBoundingClientRect();
    this.zoom(Math.exp(-dy * (event.ctrlKey ? 0.008 : 0.0016)), event.clientX - at.left, event.clientY - at.top);
  }

  /** @param {PointerEvent} event */
  down(event) {
    if (event.button !== 0 && event.button !== 1) return;
    if (!this.pointers.size) this.moved = 0;
    this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  /** @param {PointerEvent} event */
  move(event) {
    const last = this.pointers.get(event.pointerId);
    if (!last) return;
    const now = { x: event.clientX, y: event.clientY };
    const other = Array.from(this.pointers).find(([id]) => id !== event.pointerId)?.[1];
    this.moved += Math.abs(now.x - last.x) + Math.abs(now.y - last.y);
    if (!this.dragged) {
      this.pointers.set(event.pointerId, now);
      return;
    }
    if (!this.svg.hasPointerCapture(event.pointerId)) {
      this.svg.setPointerCapture(event.pointerId);
      this.svg.classList.add("dragging");
    }
    if (other) {
      const at = this.svg.getBoundingClientRect();
      const [before, after] = [Math.hypot(last.x - other.x, last.y - other.y), Math.hypot(now.x - other.x, now.y - other.y)];
      this.zoom(after / Math.max(1, before), (now.x + other.x) / 2 - at.left, (now.y + other.y) / 2 - at.top);
      this.pan((now.x - last.x) / 2, (now.y - last.y) / 2);
    } else this.pan(now.x - last.x, now.y - last.y);
    this.pointers.set(event.pointerId, now);
  }

  /** @param {PointerEvent} event */
  up(event) {
    this.pointers.delete(event.pointerId);
    if (!this.pointers.size) this.svg.classList.remove("dragging");
  }

  /** @param {KeyboardEvent} event */
  key(event) {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target !== this.svg) return;
    /** @type {Record<string, () => void>} */
    const keys = {
      ArrowLeft: () => this.pan(STEP, 0),
      ArrowRight: () => this.pan(-STEP, 0),
      ArrowUp: () => this.pan(0, STEP),
      ArrowDown: () => this.pan(0, -STEP),
      "+": () => this.zoom(1.25),
      "=": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      0: () => this.showAll(),
    };
    const act = Object.hasOwn(keys, event.key) ? keys[event.key] : undefined;
    if (!act) return;
    event.preventDefault();
    act();
  }
}
