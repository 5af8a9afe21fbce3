/** What is known of each program: the same that the page holds for those who have no scripts, made when it is looked at. */

import { element } from "./elements.js";

/** @typedef {import("./reference.js").Page} Page */
/** @typedef {import("../data").Program} Program */

const COLUMNS = ["Kind", "Name", "Type", "Detail", "Evidence"];

/**
 * A function that fills the drawer, the first time it is called.
 *
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createLibrary({ model }, host) {
  let filled = false;
  return () => {
    if (filled) return;
    filled = true;
    const { library, libraryLeftOut } = model.data;
    const foot = host.querySelector("#foot");
    const programs = library.map((each, at) => program(each, at));
    const nothing = library.length === 0 && element("p", { class: "empty" }, "Nothing is known of any program on this page.");
    const more = libraryLeftOut > 0 && element("p", { class: "note" }, `${libraryLeftOut} more programs are in the libraries that were given.`);
    host.append(...[nothing, ...programs, more, foot].filter((each) => each instanceof Element));
  };
}

/** @param {Program} each @param {number} at */
function program({ kind, name, package: package_, status, interface: rows, open }, at) {
  const title = kind === "nodelet" ? name : `${package_}/${name}`;
  const host = element(
    "details",
    { class: "program", id: `program-${at}`, "data-index": at },
    element("summary", {}, element("h3", {}, title), " ", element("span", { class: "number" }, rows.length), kind === "nodelet" && ` nodelet of ${package_}`),
  );
  host.addEventListener(
    "toggle",
    () => {
      host.append(...[status && element("p", {}, status), rows.length > 0 && table(rows)].filter((each) => each instanceof Element));
      for (const [category, why] of open) host.append(element("p", { class: "note" }, `It may have more ${category} than are listed: ${why}`));
    },
    { once: true },
  );
  return host;
}

/** @param {Program["interface"]} rows */
function table(rows) {
  const cells = rows.map(({ category, name, type, detail, evidence }) => [category, name, type, detail, evidence.join("; ")]);
  return element(
    "table",
    {},
    element("thead", {}, element("tr", {}, ...COLUMNS.map((each) => element("th", { scope: "col" }, each)))),
    element("tbody", {}, ...cells.map((each) => element("tr", {}, ...each.map((text) => element("td", {}, text))))),
  );
}
