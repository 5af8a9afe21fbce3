// What the panel and the page in it say to each other. Knows nothing of VS Code.

/** Something in the drawing: a node, topic, service, action or param, and its name. */
export interface Chosen { kind: string; name: string }

/** Tells the page to select something. */
export function selected({ kind, name }: Chosen): { launchlint: [string, string] } {
  return { launchlint: [kind, name] };
}

/** What the page says was chosen in it; nothing where it says something else. */
export function chosen(said: unknown): Chosen | undefined {
  const pair: unknown = typeof said === "object" && said !== null && "launchlint" in said ? said.launchlint : undefined;
  if (!Array.isArray(pair)) return undefined;
  const [kind, name] = pair as unknown[];
  return typeof kind === "string" && typeof name === "string" ? { kind, name } : undefined;
}
