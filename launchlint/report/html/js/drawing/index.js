// The drawing of a report: from data to a nested SVG. See types.d.ts for what it takes and gives.

import { Surface } from "./surface.js";

/** @typedef {import("../data").ReportData} ReportData */
/** @typedef {import("./types").Drawing} Drawing */
/** @typedef {import("./types").DrawingEvents} DrawingEvents */

export { inTray, trayId, trayOf } from "./tray.js";
export { containersOf } from "./tree.js";
export { autoExpansion } from "./expansion.js";

/**
 * @param {ReportData} data
 * @param {HTMLElement} host element that the drawing fills
 * @param {DrawingEvents} events
 * @returns {Drawing}
 */
export function createDrawing(data, host, events) {
  const surface = new Surface(data, host, events);
  return {
    show: (state) => surface.show(state),
    select: (selection) => surface.select(selection),
    fit: () => surface.viewport.showAll(),
    zoom: (factor) => surface.viewport.zoom(factor),
    goTo: (spot) => surface.goTo(spot),
    spot: () => surface.spot(),
    extent: () => surface.extent(),
    panTo: (selection) => surface.panTo(selection),
    svg: () => surface.svg(),
    png: () => surface.png(),
    focusables: () => surface.focusables(),
    isDrawn: (selection) => surface.isDrawn(selection),
    expanded: () => new Set(surface.open),
    standsFor: (node) => surface.standsFor(node),
    wiresOf: (selection) => surface.wiresOf(selection),
  };
}
