// The page's data as it was before launchlint/report/html/pack.py made it small: lists of objects are kept there as columns.

/** @typedef {import("./data.js").ReportData} ReportData */

const DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

/** What of an entry file stands in a line of its own. */
const PARTS = /** @type {const} */ (["containers", "nodes", "channels", "connections", "params"]);

/**
 * The data of the page: what stands in <script type="application/json" id="launchlint-data">. The parts of an entry file are read when one
 * of them is first asked for, and so is the library.
 * @param {string} text
 * @returns {ReportData}
 */
export function read(text) {
  const [head = "", ...lines] = text.split("\n");
  const data = unpack(JSON.parse(head));
  data.entries.forEach((/** @type {object} */ entry, /** @type {number} */ index) => {
    /** @type {any} */
    let parts = null;
    for (const part of PARTS) {
      Object.defineProperty(entry, part, { enumerable: true, get: () => (parts ??= unpack(JSON.parse(lines[index] ?? "{}")))[part] });
    }
  });
  /** @type {any} */
  let library = null;
  Object.defineProperty(data, "library", { enumerable: true, get: () => (library ??= unpack(JSON.parse(lines[data.entries.length] ?? "[]"))) });
  return data;
}

/**
 * @param {any} value
 * @returns {any}
 */
export function unpack(value) {
  if (Array.isArray(value)) return value.map(unpack);
  if (value === null || typeof value !== "object") return value;
  if (typeof value.$rows === "number") return rows(value.$rows, value.columns);
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
}

/**
 * @param {number} count
 * @param {Record<string, any>} columns
 * @returns {Record<string, any>[]}
 */
function rows(count, columns) {
  /** @type {Record<string, any>[]} */
  const found = Array.from({ length: count }, () => ({}));
  for (const [key, column] of Object.entries(columns)) {
    cells(count, column).forEach((cell, index) => {
      if (cell !== undefined) found[index][key] = cell;
    });
  }
  return found;
}

/**
 * The cells of a column: a list, one value for all ($all), or the distinct values and which of them each row has ($of, $at; -1 or ".":
 * the row lacks the key). Equal values are one object: never change what is read from here.
 * @param {number} count
 * @param {any} column
 * @returns {any[]}
 */
function cells(count, column) {
  if ("$all" in column) return new Array(count).fill(unpack(column.$all));
  if (!("$of" in column)) return list(column);
  const distinct = list(column.$of);
  const at = typeof column.$at === "string" ? Array.from(column.$at, (digit) => DIGITS.indexOf(digit)) : column.$at;
  return at.map((/** @type {number} */ index) => distinct[index]);
}

/**
 * A plain list, or texts of which each says with its first character how much of the one before it begins in the same way ($front).
 * @param {any} value
 * @returns {any[]}
 */
function list(value) {
  if (Array.isArray(value)) return value.map(unpack);
  let before = "";
  return value.$front.map((/** @type {string} */ text) => (before = before.slice(0, DIGITS.indexOf(text.charAt(0))) + text.slice(1)));
}
