/** The one place where the page keeps what it shows. */

/** @typedef {import("../drawing/types").Grouping} Grouping */
/** @typedef {import("../drawing/types").Selection | { kind: "finding", id: string } | { kind: "pair", id: string }} Target */
/** @typedef {import("../drawing/types").Spot} Spot */
/**
 * `landing`: all launch files are shown, and none in particular; `place`: what somebody moved to the middle of the screen, null where all is shown.
 *
 * @typedef {import("../drawing/types").ViewState & { selection: Target | null, landing: boolean, place: Spot | null }} PageState
 */

/** @type {readonly (keyof PageState["layers"])[]} */
export const LAYERS = ["topics", "services", "actions", "params"];

/** The view that opens first. @returns {PageState} */
export function initialState() {
  return {
    entry: 0,
    configuration: -1,
    grouping: "namespace",
    expanded: "auto",
    focus: null,
    layers: { topics: true, services: true, actions: true, params: false },
    topicsAsNodes: false,
    hubs: false,
    danglingOnly: false,
    findingsOnly: false,
    tray: true,
    filter: "",
    hidden: new Set(),
    matches: null,
    selection: null,
    landing: false,
    place: null,
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */

/**
 * Holds the state, tells listeners of changes, and keeps the address of the page in step: back and forward undo and redo.
 *
 * @param {PageState} first
 * @param {{ write: (state: PageState) => string, read: (hash: string) => PageState }} address
 */
export function createStore(first, address) {
  let state = first;
  /** @type {{ hear: (state: PageState, before: PageState) => void, always: boolean }[]} */
  const listeners = [];

  /** @param {PageState} next */
  function become(next) {
    const before = state;
    state = next;
    for (const { hear, always } of listeners) {
      if (always) hear(state, before);
      // What shows a launch file rests while none is shown, and then begins anew: what nobody opens is not even read.
      else if (!state.landing) hear(state, before.landing ? state : before);
    }
  }

  window.addEventListener("popstate", () => {
    // "#library" and the like are places on the page, not views of it.
    if (location.hash === "" || location.hash.includes("=")) become(address.read(location.hash));
  });

  return {
    get: () => state,
    /**
     * Changes some of the state. What belongs to one entry file or grouping only does not outlive it; any other change than what a search
     * lights leaves the landing page.
     *
     * @param {Partial<PageState>} change
     * @param {"push" | "replace"} [step] whether "back" undoes it by itself
     */
    set(change, step = "push") {
      const landing = state.landing && Object.keys(change).every((key) => key === "matches");
      const next = { ...state, landing, ...outlived(state, change), ...change };
      const before = address.write(state);
      const now = address.write(next);
      if (now !== before) history[step === "push" ? "pushState" : "replaceState"](null, "", `#${now}`);
      become(next);
    },
    /**
     * Calls back after every change while a launch file is shown, and once when one is, with the same state twice.
     *
     * @param {(state: PageState, before: PageState) => void} hear
     * @param {{ always: boolean }} [when] `always`: on the landing page, too
     */
    listen(hear, { always } = { always: false }) {
      listeners.push({ hear, always });
      if (always || !state.landing) hear(state, state);
    },
  };
}

/**
 * @param {PageState} state
 * @param {Partial<PageState>} change
 * @returns {Partial<PageState>}
 */
function outlived(state, change) {
  if (change.entry !== undefined && change.entry !== state.entry) {
    const selection = state.selection?.kind === "finding" ? state.selection : null;
    return { configuration: -1, expanded: "auto", focus: null, hidden: new Set(), filter: "", matches: null, place: null, selection };
  }
  if (change.grouping !== undefined && change.grouping !== state.grouping) {
    const hidden = new Set([...state.hidden].filter((id) => id.startsWith("n:")));
    const selection = state.selection?.kind === "container" || state.selection?.kind === "edge" ? null : state.selection;
    return { expanded: "auto", focus: null, hidden, place: null, selection };
  }
  if (change.focus !== undefined && change.focus !== state.focus) return { place: null };
  return {};
}
