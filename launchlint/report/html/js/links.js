// Links to lines of files on the forge, the same as launchlint/report/html/links.py makes for the tables.

/** @typedef {import("./data.js").ReportData} ReportData */

/**
 * The address of a line; null where it is not known, or where the file is not one of the repository as it is now.
 * @param {ReportData} data
 * @param {number} file
 * @param {number} line
 * @returns {string | null}
 */
export function sourceLink(data, file, line) {
  const path = data.files[file];
  if (data.sourceUrl === null || data.baseFiles.includes(file) || /^\/|^\.\.\//.test(path)) return null;
  if (!/^https?:\/\//.test(data.sourceUrl)) return null;
  return `${data.sourceUrl}${path.split("/").map(encodeURIComponent).join("/")}#L${line}`;
}
