// The topology of a launch file, in a panel beside its text; drawn anew when a file is saved.
import { execFile } from "node:child_process";
import * as path from "node:path";
import * as vscode from "vscode";
import { message } from "./page";

const PATIENCE = 120_000;
const LARGEST = 64 << 20;
const QUIET = 400;

export class Topology implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private shown: vscode.Uri | undefined;
  private waiting: NodeJS.Timeout | undefined;
  private drawing = 0;

  constructor(private readonly command: () => string | undefined) {}

  show(file: vscode.Uri): void {
    this.panel ??= this.opened();
    this.panel.reveal(vscode.ViewColumn.Beside, true);
    if (this.shown?.toString() !== file.toString()) {
      this.shown = file;
      void this.draw();
    }
  }

  /** A file of the workspace was written. */
  saved(): void {
    if (this.panel === undefined) return;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => void this.draw(), QUIET);
  }

  dispose(): void {
    clearTimeout(this.waiting);
    this.panel?.dispose();
  }

  private opened(): vscode.WebviewPanel {
    const panel = vscode.window.createWebviewPanel(
      "launchlint.topology",
      "Topology",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    panel.onDidDispose(() => {
      this.panel = undefined;
      this.shown = undefined;
    });
    return panel;
  }

  private async draw(): Promise<void> {
    const { panel, shown } = this;
    const command = this.command();
    if (panel === undefined || shown === undefined || command === undefined) return;
    const turn = ++this.drawing;
    const name = path.basename(shown.fsPath);
    panel.title = name;
    const html = await made(command, shown.fsPath);
    if (turn === this.drawing && panel === this.panel) panel.webview.html = html;
  }
}

function made(command: string, file: string): Promise<string> {
  return new Promise((resolve) => {
    const words = ["report", "--quiet", "--output", "-", "--", file];
    execFile(command, words, { cwd: path.dirname(file), timeout: PATIENCE, maxBuffer: LARGEST }, (error, output, errors) => {
      const failed = error !== null && (error.code !== 1 || output === "");
      resolve(failed ? message("No topology", errors || String(error)) : output);
    });
  });
}
