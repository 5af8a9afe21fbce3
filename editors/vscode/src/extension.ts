// Starts the language server and says where it is missing; everything else is the server's.
import * as vscode from "vscode";
import { LanguageClient, type LanguageClientOptions, type ServerOptions } from "vscode-languageclient/node";
import { find, interpreter } from "./finding";
import { Topology } from "./topology";

const PATTERN = "**/{*.launch,*.test,*.launch.xml,*.launch.yaml,*.launch.yml,*.launch.py,*_launch.py,*_launch.xml,*_launch.yaml}";
const SELECTOR = [{ scheme: "file", pattern: PATTERN }];
const INSTALL = "Install";
const SETTINGS = "Settings";

let client: LanguageClient | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const output = vscode.window.createOutputChannel("launchlint", { log: true });
  const topology = new Topology(() => (client?.isRunning() === true ? client : undefined));
  const restart = async (): Promise<void> => {
    await stop();
    await start(output, topology);
  };
  context.subscriptions.push(
    output,
    topology,
    vscode.commands.registerCommand("launchlint.restart", restart),
    vscode.commands.registerCommand("launchlint.showOutput", () => { output.show(true); }),
    vscode.commands.registerCommand("launchlint.showTopology", (given?: vscode.Uri) => {
      const file = given ?? vscode.window.activeTextEditor?.document.uri;
      if (file !== undefined) topology.show(file);
    }),
    // What the server's lenses call.
    vscode.commands.registerCommand("launchlint.topology", (address: string) => { topology.show(vscode.Uri.parse(address)); }),
    vscode.commands.registerCommand("launchlint.references", async (address: string) => {
      const file = vscode.Uri.parse(address);
      await vscode.window.showTextDocument(file);
      await vscode.commands.executeCommand("references-view.showCallHierarchy", file, new vscode.Position(0, 0));
    }),
    vscode.window.onDidChangeTextEditorSelection(({ textEditor }) => { topology.moved(textEditor); }),
    vscode.window.onDidChangeActiveTextEditor(note),
    vscode.workspace.onDidGrantWorkspaceTrust(() => void restart()),
    vscode.workspace.onDidChangeConfiguration(async (change) => {
      if (change.affectsConfiguration("launchlint.path") || change.affectsConfiguration("launchlint.enable")) await restart();
    }),
  );
  note(vscode.window.activeTextEditor);
  await start(output, topology);
}

export async function deactivate(): Promise<void> {
  await stop();
}

function note(editor: vscode.TextEditor | undefined): void {
  const isLaunchFile = editor !== undefined && vscode.languages.match(SELECTOR, editor.document) > 0;
  void vscode.commands.executeCommand("setContext", "launchlint.isLaunchFile", isLaunchFile);
}

async function start(output: vscode.LogOutputChannel, topology: Topology): Promise<void> {
  const folder = vscode.workspace.workspaceFolders?.[0];
  if (!vscode.workspace.getConfiguration("launchlint", folder).get("enable", true)) return;
  const program = await find(folder);
  if (program === undefined) {
    void missing(folder); // whoever waits until the extension is active must not wait until somebody has answered
    return;
  }
  output.info(`${program.command}: ${program.version}`);
  const server: ServerOptions = { command: program.command, args: ["server"] };
  const options: LanguageClientOptions = { documentSelector: SELECTOR, outputChannel: output, diagnosticCollectionName: "launchlint" };
  client = new LanguageClient("launchlint", "launchlint", server, options);
  client.onNotification("launchlint/topologyChanged", ({ uri }: { uri: string }) => { topology.changed(uri); });
  try {
    await client.start();
  } catch (error) {
    output.error(String(error));
    void vscode.window.showErrorMessage(`launchlint: ${program.command} server does not start. Is it installed with its extra, 'launchlint[server]'?`);
  }
}

async function stop(): Promise<void> {
  const running = client;
  client = undefined;
  if (running?.isRunning() === true) await running.stop();
}

async function missing(folder: vscode.WorkspaceFolder | undefined): Promise<void> {
  const python = vscode.workspace.isTrusted ? await interpreter(folder) : undefined;
  const offers = python === undefined ? [SETTINGS] : [INSTALL, SETTINGS];
  const chosen = await vscode.window.showWarningMessage("launchlint is not installed: pip install 'launchlint[server]'", ...offers);
  if (chosen === SETTINGS) {
    await vscode.commands.executeCommand("workbench.action.openSettings", "launchlint.path");
  } else if (chosen === INSTALL && python !== undefined) {
    const terminal = vscode.window.createTerminal({ name: "launchlint", shellPath: python, shellArgs: ["-m", "pip", "install", "launchlint[server]"] });
    terminal.show();
  }
}
