// One flat list of all that is drawn, in places of the whole drawing.

/** @typedef {import("./model").Level} Level */
/** @typedef {import("./model").Placed} Placed */
/** @typedef {import("./model").Sheet} Sheet */

/** Between the upper border of an open container and its loose ports. */
const HEAD = 13;

/**
 * @param {Level} root
 * @param {Map<string, Placed>} placed levels by the id of their container
 * @returns {Sheet}
 */
export function sheetOf(root, placed) {
  const outermost = placed.get(root.group.id);
  /** @type {Sheet} */
  const sheet = { width: outermost?.width ?? 0, height: outermost?.height ?? 0, boxes: [], edges: [], labels: [], ports: [], loose: [] };
  add(root, 0, 0, 0);
  return sheet;

  /** @param {Level} level @param {number} dx @param {number} dy @param {number} depth */
  function add(level, dx, dy, depth) {
    const own = placed.get(level.group.id);
    if (!own) return;
    /** @template {{ x: number, y: number }} P @param {P} point @returns {P} */
    const move = (point) => ({ ...point, x: point.x + dx, y: point.y + dy });
    const named = new Set();
    for (const port of level.ports) {
      const at = own.ports.get(port.id);
      if (at) sheet.ports.push({ ...move(at), port });
    }
    for (const edge of level.edges) {
      const line = own.edges.get(edge.id);
      if (!line) continue;
      const arrives = edge.to === edge.toBox;
      sheet.edges.push({ edge, points: line.points.map(move), junctions: line.junctions.map(move), arrives });
      const label = own.labels.get(edge.fromPort);
      if (label && edge.label.length && !named.has(edge.fromPort)) sheet.labels.push({ ...move(label), lines: edge.label, classes: edge.classes, edge });
      named.add(edge.fromPort);
    }
    for (const box of level.boxes) {
      const area = own.boxes.get(box.id);
      if (!area) continue;
      sheet.boxes.push({ ...move(area), box, depth });
      for (const port of box.loose) {
        // An open container has them beside its name, where no line enters.
        const at = box.level ? { x: area.x + (port.out ? area.width : 0), y: area.y + HEAD } : own.ports.get(port.id);
        const label = own.labels.get(port.id);
        if (at) sheet.loose.push({ ...move(at), port, box, label: label ? move(label) : null });
      }
      if (box.level) add(box.level, dx + area.x, dy + area.y, depth + 1);
    }
  }
}
