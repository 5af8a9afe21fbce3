/** Light, dark, or as the system has it: kept in this browser, where it lets us. */

import { button } from "./elements.js";

/** @typedef {"system" | "light" | "dark"} Theme */

const KEY = "launchlint-theme";
/** @type {readonly Theme[]} */
const ORDER = ["system", "light", "dark"];
/** @type {Record<Theme, string>} */
const SIGNS = { system: "◐", light: "☀", dark: "☾" };

/** A button that goes through the themes. */
export function themeButton() {
  const host = button("", () => show(ORDER[(ORDER.indexOf(now) + 1) % ORDER.length] ?? "system"), { class: "theme" });
  let now = remembered();

  /** @param {Theme} theme */
  function show(theme) {
    now = theme;
    if (theme === "system") delete document.documentElement.dataset["theme"];
    else document.documentElement.dataset["theme"] = theme;
    host.textContent = SIGNS[theme];
    host.title = `Theme: ${theme}`;
    host.setAttribute("aria-label", `Theme: ${theme}`);
    remember(theme);
  }

  show(now);
  return host;
}

/** @returns {Theme} */
function remembered() {
  try {
    return ORDER.find((each) => each === localStorage.getItem(KEY)) ?? "system";
  } catch {
    return "system"; // a page from a file may have no storage
  }
}

/** @param {Theme} theme */
function remember(theme) {
  try {
    localStorage.setItem(KEY, theme);
  } catch {
    // then the next page starts with the system's theme
  }
}
