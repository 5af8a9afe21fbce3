/** A picture as a Mermaid flowchart, with labels that cannot be markup. */

/** @typedef {import("./picture.js").Picture} Picture */
/** @typedef {import("./picture.js").Box} Box */
/** @typedef {import("./picture.js").Arrow} Arrow */

const LONGEST = 80;
const LONGEST_VERDICT = 200;
const BUNDLE = 3;
const STYLES = new Map([
  ["unknown", "stroke-dasharray: 2 2"],
  ["conditional", "stroke-dasharray: 6 3"],
  ["added", "stroke:#1a7f37,stroke-width:3px"],
  ["removed", "stroke:#cf222e,stroke-width:3px,stroke-dasharray: 6 3"],
  ["changed", "stroke:#9a6700,stroke-width:3px"],
]);

/** @param {Picture} picture */
export function mermaid({ verdict, boxes, arrows }) {
  const names = new Map(boxes.map((box, index) => [box.id, `n${index + 1}`]));
  const lines = ["flowchart LR"];
  if (verdict) lines.push(`  verdict["${label(verdict, LONGEST_VERDICT)}"]`, "  style verdict stroke:#cf222e,stroke-width:2px");
  /** @param {string} parent @param {number} depth */
  const write = (parent, depth) => {
    const indent = "  ".repeat(Math.min(depth, 12));
    for (const box of boxes) {
      if (box.parent !== parent) continue;
      if (box.kind === "container") {
        lines.push(`${indent}subgraph ${names.get(box.id)} ["${label(box.label)}"]`);
        write(box.id, depth + 1);
        lines.push(`${indent}end`);
      } else lines.push(`${indent}${names.get(box.id)}${shape(box)}`);
    }
  };
  write("", 1);
  for (const arrow of arrows) lines.push(`  ${names.get(arrow.from)} ${line(arrow)} ${names.get(arrow.to)}`);
  // What has gone must not look as if it were there.
  for (const [at, { mark }] of arrows.entries()) if (mark) lines.push(`  linkStyle ${at} ${STYLES.get(mark)}`);
  for (const [style, css] of STYLES) {
    const those = boxes.filter((box) => box.mark === style || (style === "unknown" && box.unknown) || (style === "conditional" && box.conditional));
    if (those.length > 0) lines.push(`  classDef ${style} ${css}`, `  class ${those.map((box) => names.get(box.id)).join()} ${style}`);
  }
  return `${lines.join("\n")}\n`;
}

/** @param {Box} box */
function shape({ kind, label: text, detail }) {
  const inside = `"${label(text)}${detail ? `<br/>${label(detail)}` : ""}"`;
  if (kind === "folded") return `[[${inside}]]`;
  return kind === "node" ? `[${inside}]` : `([${inside}])`;
}

/** @param {Arrow} arrow */
function line({ kind, names, conditional }) {
  const shown = names.length < BUNDLE ? names.map((each) => label(each)).join("<br/>") : `${names.length} ${kind}s`;
  const text = shown && `|"${shown}"|`;
  if (kind === "action") return `==>${text}`;
  return conditional || kind === "service" ? `-.->${text}` : `-->${text}`;
}

/** Whatever could end a label or begin markup is written as its code. @param {string} text @param {number} longest */
function label(text, longest = LONGEST) {
  const characters = Array.from(text);
  const shown = characters.length <= longest ? characters : [...characters.slice(0, 26), "…", ...characters.slice(-(longest - 27))];
  return shown.map((each) => (/^[\w\-/.,~ …→]$/.test(each) ? each : `#${each.codePointAt(0)};`)).join("");
}
