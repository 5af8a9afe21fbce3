// Finds the launchlint to start.
import { execFile } from "node:child_process";
import * as vscode from "vscode";
import { candidates } from "./candidates";

const PATIENCE = 10_000;

export interface Program {
  readonly command: string;
  readonly version: string;
}

/** The first launchlint that answers; undefined where none does. */
export async function find(folder: vscode.WorkspaceFolder | undefined): Promise<Program | undefined> {
  const settings = vscode.workspace.getConfiguration("launchlint", folder);
  const tried = candidates({
    configured: settings.get("path", ""),
    interpreter: await interpreter(folder),
    folder: folder?.uri.fsPath,
    trusted: vscode.workspace.isTrusted,
    windows: process.platform === "win32",
  });
  for (const command of tried) {
    const version = await answer(command);
    if (version !== undefined) return { command, version };
  }
  return undefined;
}

/** The interpreter that is selected in the Python extension, where that is installed. */
export async function interpreter(folder: vscode.WorkspaceFolder | undefined): Promise<string | undefined> {
  const python = vscode.extensions.getExtension("ms-python.python");
  if (python === undefined) return undefined;
  try {
    const api: unknown = python.isActive ? python.exports : await python.activate();
    const environments = (api as { environments?: { getActiveEnvironmentPath(uri?: vscode.Uri): { path: string } } }).environments;
    return environments?.getActiveEnvironmentPath(folder?.uri).path;
  } catch {
    return undefined;
  }
}

function answer(command: string): Promise<string | undefined> {
  return new Promise((resolve) => {
    execFile(command, ["--version"], { timeout: PATIENCE }, (error, output) => {
      resolve(error === null ? output.trim() : undefined);
    });
  });
}
