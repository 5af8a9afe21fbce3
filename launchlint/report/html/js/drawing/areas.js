// What is asked of rectangles.

/** @typedef {import("./model").Area} Area */
/** @typedef {import("./model").Point} Point */

/** @param {Area} a @param {Area} b */
export function overlap(a, b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

/** @param {Area} area @param {number} by @returns {Area} */
export function wider({ x, y, width, height }, by) {
  return { x: x - by, y: y - by, width: width + 2 * by, height: height + 2 * by };
}

/** @param {Point} a @param {Point} b @returns {Area} */
export function between(a, b) {
  return { x: Math.min(a.x, b.x), y: Math.min(a.y, b.y), width: Math.abs(a.x - b.x), height: Math.abs(a.y - b.y) };
}

/** The pieces of a line. @param {Point[]} points @returns {Area[]} */
export function pieces(points) {
  return points.slice(1).map((point, at) => between(/** @type {Point} */ (points[at]), point));
}

/** The least around some. @param {readonly [Area, ...Area[]]} all @returns {Area} */
export function hull(all) {
  const [x, y] = [Math.min(...all.map((each) => each.x)), Math.min(...all.map((each) => each.y))];
  return { x, y, width: Math.max(...all.map((each) => each.x + each.width)) - x, height: Math.max(...all.map((each) => each.y + each.height)) - y };
}
