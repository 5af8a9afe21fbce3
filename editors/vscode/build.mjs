// Makes dist/: the extension in one file, and the schema of .launchlint.yaml beside it.
import { build } from "esbuild";
import { copyFile, mkdir, rm } from "node:fs/promises";

const common = { bundle: true, platform: "node", target: "node18", format: "cjs", minify: true, legalComments: "none", logLevel: "warning" };

await rm("dist", { recursive: true, force: true });
await mkdir("dist");
await build({ ...common, entryPoints: ["src/extension.ts"], external: ["vscode"], outfile: "dist/extension.js" });
await build({ ...common, entryPoints: ["src/candidates.ts", "src/following.ts", "src/page.ts"], minify: false, outdir: "dist/parts" });
await copyFile("../../launchlint/workspace/configuration_schema.json", "dist/configuration_schema.json");
