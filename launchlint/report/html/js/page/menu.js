/** A button that opens a list of choices. */

import { button, element } from "./elements.js";

/**
 * @param {string} label
 * @param {readonly [label: string, action: () => void][]} choices
 */
export function menu(label, choices) {
  const host = element("details", { class: "menu" }, element("summary", {}, label));
  const close = () => host.removeAttribute("open");
  const items = choices.map(([name, action]) => button(name, () => (close(), action())));
  host.append(element("div", { class: "menu-items" }, ...items));
  host.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !host.open) return;
    event.stopPropagation();
    close();
    host.querySelector("summary")?.focus();
  });
  host.addEventListener("focusout", (event) => {
    if (!host.contains(/** @type {Node | null} */ (event.relatedTarget))) close();
  });
  return host;
}
