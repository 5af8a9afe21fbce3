// The topology of a launch file, in a panel beside its text. The server draws it; the panel follows the cursor and what is typed, and a
// click in it moves the cursor.
import * as vscode from "vscode";
import type { LanguageClient } from "vscode-languageclient/node";
import { type Chosen, chosen, selected } from "./following";
import { message } from "./page";

/** Milliseconds without a key, or a move, before the panel follows. */
const QUIET = 400;
const REST = 60;

interface Drawn { title: string; html: string }
interface Place { uri: string; range: { start: { line: number; character: number } } }

export class Topology implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private shown: vscode.Uri | undefined;
  private waiting: NodeJS.Timeout | undefined;
  private moving: NodeJS.Timeout | undefined;
  private drawing = 0;

  constructor(private readonly client: () => LanguageClient | undefined) {}

  show(file: vscode.Uri): void {
    this.panel ??= this.opened();
    this.panel.reveal(vscode.ViewColumn.Beside, true);
    if (this.shown?.toString() !== file.toString()) {
      this.shown = file;
      void this.draw();
    }
  }

  /** What the server knows of a file has changed. */
  changed(uri: string): void {
    if (this.panel === undefined || this.shown === undefined || vscode.Uri.parse(uri).toString() !== this.shown.toString()) return;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => void this.draw(), QUIET);
  }

  /** The cursor stands somewhere else. */
  moved(editor: vscode.TextEditor): void {
    if (this.panel === undefined || editor.document.uri.toString() !== this.shown?.toString()) return;
    clearTimeout(this.moving);
    this.moving = setTimeout(() => void this.follow(editor), REST);
  }

  dispose(): void {
    clearTimeout(this.waiting);
    clearTimeout(this.moving);
    this.panel?.dispose();
  }

  private opened(): vscode.WebviewPanel {
    const panel = vscode.window.createWebviewPanel(
      "launchlint.topology",
      "Topology",
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    panel.webview.onDidReceiveMessage((said: unknown) => {
      const found = chosen(said);
      if (found !== undefined) void this.reveal(found);
    });
    panel.onDidDispose(() => {
      this.panel = undefined;
      this.shown = undefined;
    });
    return panel;
  }

  private async draw(): Promise<void> {
    const { panel, shown } = this;
    const client = this.client();
    if (panel === undefined || shown === undefined || client === undefined) return;
    const turn = ++this.drawing;
    const drawn = await client.sendRequest<Drawn | null>("launchlint/topology", { textDocument: { uri: this.address(client, shown) } }).catch(() => null);
    if (turn !== this.drawing || panel !== this.panel) return;
    panel.title = drawn?.title ?? "Topology";
    panel.webview.html = drawn?.html ?? message("No topology", "The server has none of this file. Is it a launch file, and open?");
  }

  private async follow(editor: vscode.TextEditor): Promise<void> {
    const client = this.client();
    if (client === undefined) return;
    const { line, character } = editor.selection.active;
    const given = { textDocument: { uri: this.address(client, editor.document.uri) }, position: { line, character } };
    const found = await client.sendRequest<Chosen | null>("launchlint/topologyAt", given).catch(() => null);
    if (found !== null) await this.panel?.webview.postMessage(selected(found));
  }

  private async reveal(found: Chosen): Promise<void> {
    const { shown } = this;
    const client = this.client();
    if (shown === undefined || client === undefined) return;
    const given = { textDocument: { uri: this.address(client, shown) }, ...found };
    const place = await client.sendRequest<Place | null>("launchlint/topologyPlace", given).catch(() => null);
    if (place === null) return;
    const { line, character } = place.range.start;
    const at = new vscode.Range(line, character, line, character);
    await vscode.window.showTextDocument(vscode.Uri.parse(place.uri), { viewColumn: vscode.ViewColumn.One, selection: at });
  }

  private address(client: LanguageClient, file: vscode.Uri): string {
    return client.code2ProtocolConverter.asUri(file);
  }
}
