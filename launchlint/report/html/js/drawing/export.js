// The drawing as a document of its own.

const MARGIN = 16;

/**
 * @param {SVGSVGElement} svg
 * @param {{ width: number, height: number }} size of the drawing
 * @param {string} styles its rules; they are written with the colours that the page has now, for programs that know no variables
 * @returns {string}
 */
export function exported(svg, size, styles) {
  const copy = /** @type {SVGSVGElement} */ (svg.cloneNode(true));
  const [width, height] = [Math.ceil(size.width + 2 * MARGIN), Math.ceil(size.height + 2 * MARGIN)];
  for (const name of ["tabindex", "data-distance"]) copy.removeAttribute(name);
  copy.setAttribute("class", "ll-drawing");
  copy.setAttribute("viewBox", `${-MARGIN} ${-MARGIN} ${width} ${height}`);
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  copy.querySelector("g")?.removeAttribute("transform");
  for (const each of copy.querySelectorAll("[tabindex], [role]")) {
    each.removeAttribute("tabindex");
    each.removeAttribute("role");
  }
  for (const each of copy.querySelectorAll(".hit, .fold")) each.remove();
  const colours = getComputedStyle(svg);
  const rules = styles
    .slice(styles.indexOf("svg.ll-drawing"))
    .replace(/--ll-own: var\((--ll-\w+)\)/g, (_, name) => `--ll-own: ${colours.getPropertyValue(name).trim()}`)
    .replace(/var\((--ll-(?!own)[\w-]+)\)/g, (_, name) => colours.getPropertyValue(name).trim());
  const style = document.createElementNS("http://www.w3.org/2000/svg", "style");
  style.textContent = rules;
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  for (const [name, value] of Object.entries({ x: -MARGIN, y: -MARGIN, width, height, fill: colours.getPropertyValue("--ll-ground").trim() })) ground.setAttribute(name, String(value));
  copy.prepend(style, ground);
  return new XMLSerializer().serializeToString(copy);
}
