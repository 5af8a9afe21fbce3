/** Beside a text in an editor: the page follows its cursor, and tells it what was chosen here. Elsewhere there is no editor to speak to. */

import { addressOf, stateOf } from "./address.js";

/** @typedef {import("./model.js").Model} Model */
/** @typedef {import("./state.js").Store} Store */
/** @typedef {{ postMessage: (message: unknown) => void, getState: () => unknown, setState: (state: unknown) => void }} Host */

/** What shows the page, where that is an editor: VS Code's webviews have this function, which may be called once. */
export function editor() {
  const { acquireVsCodeApi } = /** @type {{ acquireVsCodeApi?: () => Host }} */ (globalThis);
  return acquireVsCodeApi?.();
}

/**
 * The address at which the page stood when its data was older; empty where it is shown for the first time.
 * @param {Host | undefined} host
 */
export function addressBefore(host) {
  const state = host?.getState();
  return typeof state === "string" ? state : "";
}

/**
 * "Select this" is `{ launchlint: ["node", "/turtle"] }`, in either direction.
 * @param {{ model: Model, store: Store }} page
 * @param {Host | undefined} host
 */
export function followEditor({ model, store }, host) {
  if (host === undefined) return;
  let following = false;
  window.addEventListener("message", ({ data }) => {
    const [kind, name] = Array.isArray(data?.launchlint) ? data.launchlint : [];
    if (typeof kind !== "string" || typeof name !== "string") return;
    const now = store.get();
    const file = model.data.files[model.entry(now.entry).entry.file] ?? "";
    const address = `entry=${encodeURIComponent(file)}&group=${now.grouping}&${encodeURIComponent(kind)}=${encodeURIComponent(name)}`;
    const { selection } = stateOf(model, address);
    if (selection === null) return;
    following = true;
    store.set({ selection }, "replace");
    following = false;
  });
  store.listen((state, before) => {
    const address = addressOf(model, state);
    host.setState(address);
    if (following || state.selection === null || state.selection === before.selection) return;
    const [kind, name] = (address.split("&")[0] ?? "").split("=");
    if (kind && name) host.postMessage({ launchlint: [kind, decodeURIComponent(name)] });
  });
}
