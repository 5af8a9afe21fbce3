// The drawing as pixels. The page allows itself no images, so the picture is painted from what the browser drew, shape by shape.

const MARGIN = 16;
/** Pixels of the picture for each of the drawing: sharp on dense screens. */
const DENSITY = 2;
/** Browsers make no larger pictures. */
const LARGEST = 12_000;

/**
 * @param {SVGSVGElement} svg
 * @param {{ width: number, height: number }} size of the drawing
 * @returns {HTMLCanvasElement}
 */
export function rastered(svg, size) {
  const [width, height] = [size.width + 2 * MARGIN, size.height + 2 * MARGIN];
  const density = Math.min(DENSITY, LARGEST / Math.max(width, height));
  const canvas = document.createElement("canvas");
  Object.assign(canvas, { width: Math.ceil(width * density), height: Math.ceil(height * density) });
  const pen = canvas.getContext("2d");
  const content = svg.querySelector(":scope > g");
  if (!pen || !(content instanceof SVGGElement)) return canvas;
  const colours = getComputedStyle(svg);
  pen.fillStyle = colours.getPropertyValue("--ll-ground").trim();
  pen.fillRect(0, 0, canvas.width, canvas.height);
  const hatch = hatching(colours.getPropertyValue("--ll-hatch").trim());
  const screen = content.getScreenCTM()?.inverse();
  const { distance } = svg.dataset;
  delete svg.dataset["distance"];
  for (const each of content.querySelectorAll("rect, circle, path, text")) {
    const style = getComputedStyle(each);
    if (!(each instanceof SVGGraphicsElement) || style.display === "none" || each.matches(".hit, .fold *")) continue;
    const at = each.getScreenCTM();
    if (!at || !screen) continue;
    const { a, b, c, d, e, f } = screen.multiply(at);
    pen.setTransform(new DOMMatrix([density, 0, 0, density, MARGIN * density, MARGIN * density]).multiply(new DOMMatrix([a, b, c, d, e, f])));
    paint(pen, each, style, hatch);
  }
  if (distance) svg.dataset["distance"] = distance;
  return canvas;
}

/**
 * @param {CanvasRenderingContext2D} pen
 * @param {SVGGraphicsElement} shape
 * @param {CSSStyleDeclaration} style
 * @param {CanvasPattern | null} hatch
 */
function paint(pen, shape, style, hatch) {
  const stroke = style.stroke !== "none" && parseFloat(style.strokeWidth) > 0;
  pen.globalAlpha = opacityOf(shape);
  pen.strokeStyle = stroke ? style.stroke : "transparent";
  pen.lineWidth = parseFloat(style.strokeWidth) || 0;
  pen.lineJoin = "round";
  pen.lineCap = style.strokeLinecap === "round" ? "round" : "butt";
  pen.setLineDash(style.strokeDasharray === "none" ? [] : style.strokeDasharray.split(/[ ,]+/).map(parseFloat));
  const fill = style.fill.startsWith("url") ? hatch : style.fill;
  pen.fillStyle = fill && fill !== "none" ? fill : "transparent";
  if (shape instanceof SVGTextElement) {
    pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    pen.textAlign = style.textAnchor === "middle" ? "center" : style.textAnchor === "end" ? "right" : "left";
    const [x, y] = [numberOf(shape, "x"), numberOf(shape, "y")];
    if (stroke) pen.strokeText(shape.textContent ?? "", x, y);
    pen.fillText(shape.textContent ?? "", x, y);
    return;
  }
  const outline = outlineOf(shape);
  const solid = pen.globalAlpha;
  pen.globalAlpha = solid * parseFloat(style.fillOpacity || "1");
  pen.fill(outline);
  pen.globalAlpha = solid;
  if (stroke) pen.stroke(outline);
}

/** @param {SVGGraphicsElement} shape */
function outlineOf(shape) {
  if (shape instanceof SVGPathElement) return new Path2D(shape.getAttribute("d") ?? "");
  const outline = new Path2D();
  if (shape instanceof SVGCircleElement) outline.arc(numberOf(shape, "cx"), numberOf(shape, "cy"), numberOf(shape, "r"), 0, 2 * Math.PI);
  else rounded(outline, numberOf(shape, "x"), numberOf(shape, "y"), numberOf(shape, "width"), numberOf(shape, "height"), numberOf(shape, "rx"));
  return outline;
}

/** @param {Path2D} outline @param {number} x @param {number} y @param {number} width @param {number} height @param {number} radius */
function rounded(outline, x, y, width, height, radius) {
  const corner = Math.max(0, Math.min(radius, width / 2, height / 2));
  outline.moveTo(x + corner, y);
  outline.arcTo(x + width, y, x + width, y + height, corner);
  outline.arcTo(x + width, y + height, x, y + height, corner);
  outline.arcTo(x, y + height, x, y, corner);
  outline.arcTo(x, y, x + width, y, corner);
  outline.closePath();
}

/** @param {Element} shape */
function opacityOf(shape) {
  let opacity = 1;
  for (let at = /** @type {Element | null} */ (shape); at && !(at instanceof SVGSVGElement); at = at.parentElement) opacity *= parseFloat(getComputedStyle(at).opacity);
  return opacity;
}

/** @param {Element} shape @param {string} name */
function numberOf(shape, name) {
  return Number(shape.getAttribute(name) ?? 0);
}

/** @param {string} colour */
function hatching(colour) {
  const tile = document.createElement("canvas");
  Object.assign(tile, { width: 7, height: 7 });
  const pen = tile.getContext("2d");
  if (!pen) return null;
  pen.strokeStyle = colour;
  pen.lineWidth = 1.4;
  pen.stroke(new Path2D("M-1 8L8 -1M-1 1L1 -1M6 8L8 6"));
  return pen.createPattern(tile, "repeat");
}
