/** Findings of the same words are one line with a count: forty copies of one mistake must not hide the forty-first, which is another one. */

/** @typedef {import("../data").ReportData} ReportData */

const ORDER = ["error", "warning", "info"];

/**
 * Lists of findings of the same rule, severity and message, the worst first; else in the order in which they come.
 *
 * @param {ReportData} data
 * @param {readonly number[]} findings by number
 * @returns {number[][]}
 */
export function grouped(data, findings) {
  /** @type {Map<string, number[]>} */
  const groups = new Map();
  for (const index of findings) {
    const each = data.findings[index];
    if (!each) continue;
    const key = `${ORDER.indexOf(each.severity)} ${each.since ?? ""} ${each.rule} ${each.message}`;
    const known = groups.get(key);
    if (known) known.push(index);
    else groups.set(key, [index]);
  }
  return [...groups].sort(([one], [other]) => one.charCodeAt(0) - other.charCodeAt(0)).map(([, those]) => those);
}
