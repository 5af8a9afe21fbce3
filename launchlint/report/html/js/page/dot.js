/** A picture in Graphviz's language. */

/** @typedef {import("./picture.js").Picture} Picture */
/** @typedef {import("./picture.js").Box} Box */
/** @typedef {import("./picture.js").Arrow} Arrow */

const COLOURS = new Map([
  ["added", "#1a7f37"],
  ["removed", "#cf222e"],
  ["changed", "#9a6700"],
]);
const BUNDLE = 3;

/** @param {Picture} picture */
export function dot({ title, verdict, boxes, arrows }) {
  const names = new Map(boxes.map((box, index) => [box.id, `n${index + 1}`]));
  const lines = ["digraph connections {", "  rankdir=LR;", `  label=${quoted(title, verdict)};`, "  node [shape=box];"];
  /** @param {string} parent @param {number} depth */
  const write = (parent, depth) => {
    const indent = "  ".repeat(Math.min(depth, 12));
    for (const box of boxes) {
      if (box.parent !== parent) continue;
      if (box.kind === "container") {
        lines.push(`${indent}subgraph cluster_${names.get(box.id)} { label=${quoted(box.label)};`);
        write(box.id, depth + 1);
        lines.push(`${indent}}`);
      } else lines.push(`${indent}${names.get(box.id)} [${attributes(box)}];`);
    }
  };
  write("", 1);
  for (const arrow of arrows) lines.push(`  ${names.get(arrow.from)} -> ${names.get(arrow.to)} [${arrowAttributes(arrow)}];`);
  return `${[...lines, "}"].join("\n")}\n`;
}

/** @param {Box} box */
function attributes({ kind, label, detail, unknown, conditional, mark }) {
  const found = [`label=${quoted(label, detail)}`];
  if (kind !== "node" && kind !== "folded") found.push("shape=ellipse");
  if (unknown || conditional || mark === "removed") found.push(`style="${unknown ? "dotted" : "dashed"}"`);
  if (mark) found.push(`color="${COLOURS.get(mark)}", penwidth=3`);
  return found.join(", ");
}

/** @param {Arrow} arrow */
function arrowAttributes({ kind, names, conditional, mark }) {
  const found = [`label=${names.length < BUNDLE ? quoted(...names) : quoted(`${names.length} ${kind}s`)}`];
  if (kind === "service" || conditional || mark === "removed") found.push('style="dashed"');
  else if (kind === "action") found.push('style="bold"');
  if (mark) found.push(`color="${COLOURS.get(mark)}", penwidth=3`);
  return found.join(", ");
}

/** A string that is text only: none of Graphviz's escapes, no character references. @param {...string} rows */
function quoted(...rows) {
  const text = rows.filter(Boolean).map((row) =>
    row
      .replaceAll(/[\\"]/g, "\\$&")
      .replaceAll("&", "&amp;")
      .replaceAll(/\p{Cc}/gu, "�"),
  );
  return `"${text.join("\\n")}"`;
}
