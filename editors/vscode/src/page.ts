// What is shown beside the text where there is no topology to show. Knows nothing of VS Code.

/** A page that says something, whatever is in it. */
export function message(title: string, text: string): string {
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'">
<title>${escaped(title)}</title>
<style>body { font: var(--vscode-font-size) var(--vscode-font-family); padding: 1em } pre { white-space: pre-wrap }</style>
</head>
<body><h2>${escaped(title)}</h2><pre>${escaped(text)}</pre></body>
</html>`;
}

function escaped(text: string): string {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
