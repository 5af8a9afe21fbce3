// Where launchlint may be installed, best place first. Knows nothing of VS Code.
import * as os from "node:os";
import * as path from "node:path";

export interface Surroundings {
  /** The setting `launchlint.path`. */
  readonly configured: string;
  /** The interpreter that the Python extension has selected. */
  readonly interpreter: string | undefined;
  readonly folder: string | undefined;
  /** Whether what the workspace says may be started. */
  readonly trusted: boolean;
  readonly windows: boolean;
}

/** Commands to try; the last is left to the PATH. A configured one is the only one: what somebody named is not guessed at. */
export function candidates(given: Surroundings): string[] {
  if (!given.trusted) return ["launchlint"];
  if (given.configured.trim() !== "") return [expanded(given.configured.trim(), given.folder)];
  const program = given.windows ? "launchlint.exe" : "launchlint";
  const found: string[] = [];
  if (given.interpreter !== undefined && path.isAbsolute(given.interpreter)) {
    found.push(path.join(path.dirname(given.interpreter), program));
  }
  if (given.folder !== undefined) {
    for (const environment of [".venv", "venv"]) {
      found.push(path.join(given.folder, environment, given.windows ? "Scripts" : "bin", program));
    }
  }
  return [...new Set(found), "launchlint"];
}

function expanded(written: string, folder: string | undefined): string {
  const home = written === "~" || written.startsWith("~/") ? os.homedir() + written.slice(1) : written;
  return folder === undefined ? home : home.replaceAll("${workspaceFolder}", folder);
}
