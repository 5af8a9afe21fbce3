// Quality of service, as far as it is known: what of it stands on a line, and what keeps two ends apart.

/** @typedef {import("./model").Wire} Wire */

/** What is offered is too little for what is asked. */
const CLASHES = [["best_effort", "reliable"], ["volatile", "transient_local"]];
/** What is not as it is where nobody says anything. */
const UNUSUAL = ["best_effort", "transient_local"];

/** @param {string} qos "reliable, transient_local, keep_last 1" @param {string} word */
const says = (qos, word) => qos.split(/[,\s]+/).includes(word);

/** What of two profiles does not fit: what is offered, and what is asked for; null where nothing is known to. @param {string} offered @param {string} asked @returns {string[] | null} */
export function clashOf(offered, asked) {
  return CLASHES.find(([little = "", much = ""]) => says(offered, little) && says(asked, much)) ?? null;
}

/** What keeps ends of a wire apart. @param {Wire} wire @returns {string[] | null} */
export function clashIn({ kind, givers, takers }) {
  if (kind !== "topic") return null;
  for (const giver of givers) for (const taker of takers) {
    const found = clashOf(giver.qos ?? "", taker.qos ?? "");
    if (found) return found;
  }
  return null;
}

/** What keeps ends of a wire apart, in words; empty where nothing does. @param {Wire} wire */
export function clashWords(wire) {
  return clashIn(wire)?.join(" ≠ ") ?? "";
}

/** The line below the name of a wire; empty where there is nothing unusual to be said. @param {Wire} wire */
export function qosLine(wire) {
  const clash = clashWords(wire);
  if (clash) return clash;
  return wire.kind === "topic" ? UNUSUAL.filter((word) => wire.givers.some(({ qos = "" }) => says(qos, word))).join(", ") : "";
}
