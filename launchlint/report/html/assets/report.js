(() => {
  // launchlint/report/html/js/drawing/drawing.css
  var drawing_default = '/* The drawing brings its own rules, so that an exported picture looks as it does in the page. */\n:is(.ll-drawing, .ll-drawing-host) {\n  --ll-ground: #fbfcfe;\n  --ll-node: #ffffff;\n  --ll-edge: #8b99a8;\n  --ll-text: #17212b;\n  --ll-muted: #566474;\n  --ll-box: #5f7ea1;\n  --ll-box-line: #bfcad6;\n  --ll-folded: #eef3f8;\n  --ll-topic: #4b78a8;\n  --ll-service: #1e857a;\n  --ll-action: #7b55b5;\n  --ll-param: #97702a;\n  --ll-error: #c5283d;\n  --ll-warning: #a65f00;\n  --ll-info: #2f6fae;\n  --ll-added: #1a7f37;\n  --ll-removed: #cf222e;\n  --ll-changed: #9a6700;\n  --ll-chosen: #0b63ce;\n  --ll-on-badge: #ffffff;\n  --ll-hatch: #dbe2e9;\n}\n@media (prefers-color-scheme: dark) {\n  :root:not([data-theme="light"]) :is(.ll-drawing, .ll-drawing-host) {\n    --ll-ground: #13181e;\n    --ll-node: #1d252e;\n    --ll-edge: #5f6f7f;\n    --ll-text: #e4ebf2;\n    --ll-muted: #9fadbb;\n    --ll-box: #8fb2d8;\n    --ll-box-line: #3a4755;\n    --ll-folded: #232e39;\n    --ll-topic: #79a8da;\n    --ll-service: #56c2b4;\n    --ll-action: #b795ea;\n    --ll-param: #d4aa5c;\n    --ll-error: #ff6b7a;\n    --ll-warning: #e9a23b;\n    --ll-info: #6cb0f0;\n    --ll-added: #4ac26b;\n    --ll-removed: #ff7b72;\n    --ll-changed: #d4a72c;\n    --ll-chosen: #6cb2ff;\n    --ll-on-badge: #13181e;\n    --ll-hatch: #303b47;\n  }\n}\n:root[data-theme="dark"] :is(.ll-drawing, .ll-drawing-host) {\n  --ll-ground: #13181e;\n  --ll-node: #1d252e;\n  --ll-edge: #5f6f7f;\n  --ll-text: #e4ebf2;\n  --ll-muted: #9fadbb;\n  --ll-box: #8fb2d8;\n  --ll-box-line: #3a4755;\n  --ll-folded: #232e39;\n  --ll-topic: #79a8da;\n  --ll-service: #56c2b4;\n  --ll-action: #b795ea;\n  --ll-param: #d4aa5c;\n  --ll-error: #ff6b7a;\n  --ll-warning: #e9a23b;\n  --ll-info: #6cb0f0;\n  --ll-added: #4ac26b;\n  --ll-removed: #ff7b72;\n  --ll-changed: #d4a72c;\n  --ll-chosen: #6cb2ff;\n  --ll-on-badge: #13181e;\n  --ll-hatch: #303b47;\n}\n@media print {\n  .ll-drawing-host .ll-legend { display: none; }\n}\n\n.ll-drawing-host { position: relative; overflow: hidden; }\nsvg.ll-drawing { display: block; width: 100%; height: 100%; background: var(--ll-ground); touch-action: none; cursor: grab; user-select: none; outline: none; }\nsvg.ll-drawing:focus-visible { box-shadow: inset 0 0 0 2px var(--ll-chosen); }\nsvg.ll-drawing.dragging { cursor: grabbing; }\n/* While it is dragged, the drawing is a layer of its own: moved, not painted again. */\nsvg.ll-drawing.dragging > g { will-change: transform; }\n.ll-drawing text { font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; font-size: 12px; fill: var(--ll-text); }\n.ll-drawing .hatching path { stroke: var(--ll-hatch); stroke-width: 1.4; fill: none; }\n\n.ll-drawing .box { cursor: pointer; outline: none; }\n.ll-drawing .box .shape { fill: var(--ll-node); stroke: var(--ll-edge); stroke-width: 1; }\n.ll-drawing .box .behind { fill: var(--ll-folded); stroke: var(--ll-box-line); stroke-width: 1; }\n.ll-drawing .box .title { font-size: 13px; font-weight: 600; }\n.ll-drawing .box .detail, .ll-drawing .box .host, .ll-drawing .box .count, .ll-drawing .box .tag { fill: var(--ll-muted); }\n.ll-drawing .box .condition { fill: var(--ll-muted); font-style: italic; }\n.ll-drawing .box.folded .shape { fill: var(--ll-folded); stroke: var(--ll-edge); }\n.ll-drawing .box.open .shape { fill: var(--ll-box); fill-opacity: 0.055; stroke: var(--ll-box-line); stroke-width: 1.2; }\n.ll-drawing .box.open.machine > .shape { stroke-width: 2.4; }\n.ll-drawing .box.open .title { fill: var(--ll-muted); }\n.ll-drawing .box.open { cursor: grab; }\n.ll-drawing .box.open .head { cursor: pointer; }\n.ll-drawing .box .inner { fill: none; stroke: var(--ll-edge); stroke-width: 0.8; }\n.ll-drawing .box.host > .shape { stroke-width: 2.2; }\n.ll-drawing .box.tray > .shape { stroke-dasharray: 2 4; fill-opacity: 0; }\n.ll-drawing .line .qos { fill: var(--ll-warning); stroke: var(--ll-ground); stroke-width: 1.5; }\n.ll-drawing .box.conditional .shape { stroke-dasharray: 6 4; }\n.ll-drawing .box.unknown .title { fill: var(--ll-muted); }\n.ll-drawing .box.stub .shape { stroke-dasharray: 1 3; stroke-linecap: round; fill: var(--ll-ground); }\n.ll-drawing .box.stub .title { font-weight: 400; fill: var(--ll-muted); }\n.ll-drawing .box.pill .shape { stroke: var(--ll-topic); fill: var(--ll-ground); }\n.ll-drawing .box.pill .title { font-size: 12px; font-weight: 400; }\n.ll-drawing .box.pill.service .shape { stroke: var(--ll-service); }\n.ll-drawing .box.pill.action .shape { stroke: var(--ll-action); }\n.ll-drawing .box.pill.param .shape { stroke: var(--ll-param); }\n.ll-drawing .box.pill.dangling .shape { stroke-dasharray: 3 3; }\n.ll-drawing .box.added > .shape { stroke: var(--ll-added); stroke-width: 2.5; }\n.ll-drawing .box.removed > .shape { stroke: var(--ll-removed); stroke-width: 2.5; stroke-dasharray: 3 4; }\n.ll-drawing .box.changed > .shape { stroke: var(--ll-changed); stroke-width: 2; stroke-dasharray: 12 3; }\n.ll-drawing .box.removed .title { text-decoration: line-through; }\n.ll-drawing .box:hover > .shape { stroke: var(--ll-chosen); }\n.ll-drawing .box:focus-visible > .shape { stroke: var(--ll-chosen); stroke-width: 2.5; }\n.ll-drawing .box.chosen > .shape { stroke: var(--ll-chosen); stroke-width: 2.5; }\n\n.ll-drawing .fold { cursor: pointer; }\n.ll-drawing .fold rect { fill: transparent; }\n.ll-drawing .fold path { stroke: var(--ll-muted); stroke-width: 1.5; fill: none; }\n.ll-drawing .fold:hover path { stroke: var(--ll-chosen); }\n.ll-drawing .badge circle { fill: var(--ll-node); stroke: var(--ll-info); stroke-width: 1.3; }\n.ll-drawing .badge.warning circle { fill: var(--ll-warning); stroke: var(--ll-ground); stroke-width: 1.5; }\n.ll-drawing .badge.error circle { fill: var(--ll-error); stroke: var(--ll-ground); stroke-width: 1.5; }\n.ll-drawing .badge.warning text, .ll-drawing .badge.error text { fill: var(--ll-on-badge); }\n.ll-drawing .badge.elsewhere circle { fill: var(--ll-node); stroke: var(--ll-muted); stroke-width: 1.2; stroke-dasharray: 2.5 2; }\n.ll-drawing .badge.elsewhere.warning circle { stroke: var(--ll-warning); }\n.ll-drawing .badge.elsewhere.error circle { stroke: var(--ll-error); }\n.ll-drawing .badge.elsewhere.warning text { fill: var(--ll-warning); }\n.ll-drawing .badge.elsewhere.error text { fill: var(--ll-error); }\n.ll-drawing .badge text { fill: var(--ll-info); font-size: 12px; font-weight: 700; text-anchor: middle; }\n\n.ll-drawing .line { --ll-own: var(--ll-topic); cursor: pointer; }\n.ll-drawing .line.service { --ll-own: var(--ll-service); }\n.ll-drawing .line.action { --ll-own: var(--ll-action); }\n.ll-drawing .line.param { --ll-own: var(--ll-param); }\n.ll-drawing .line.added { --ll-own: var(--ll-added); }\n.ll-drawing .line.removed { --ll-own: var(--ll-removed); }\n.ll-drawing .line.changed { --ll-own: var(--ll-changed); }\n.ll-drawing .line path { fill: none; stroke: var(--ll-own); stroke-width: 1.3; stroke-linejoin: round; }\n.ll-drawing .line .hit { stroke: transparent; stroke-width: 11; pointer-events: stroke; }\n.ll-drawing .line .head { fill: var(--ll-own); stroke: none; }\n.ll-drawing .line .joint { fill: var(--ll-own); }\n.ll-drawing .line.bundle .course { stroke-width: 2.6; }\n.ll-drawing .line.service .head { fill: var(--ll-ground); stroke: var(--ll-own); stroke-width: 1.3; }\n.ll-drawing .line.action .course { stroke-width: 2; }\n.ll-drawing .line.param .course { stroke-width: 1; }\n.ll-drawing .line.conditional .course { stroke-dasharray: 7 4; }\n.ll-drawing .line.clash .course { stroke: var(--ll-error); }\n.ll-drawing .name.clash text { fill: var(--ll-error); }\n.ll-drawing .line.uncertain .course { stroke-dasharray: 1.5 4; stroke-linecap: round; }\n.ll-drawing .line.added .course, .ll-drawing .line.removed .course, .ll-drawing .line.changed .course { stroke-width: 2.4; }\n.ll-drawing .line.removed .course { stroke-dasharray: 3 4; }\n.ll-drawing .line.changed .course { stroke-dasharray: 12 3; }\n.ll-drawing .line:hover .course, .ll-drawing .line.chosen .course { stroke: var(--ll-chosen); stroke-width: 3; }\n.ll-drawing .name { cursor: pointer; }\n.ll-drawing .name text { paint-order: stroke; stroke: var(--ll-ground); stroke-width: 3px; stroke-linejoin: round; fill: var(--ll-muted); }\n.ll-drawing .name.info text { fill: var(--ll-info); }\n.ll-drawing .name.warning text { fill: var(--ll-warning); font-weight: 600; }\n.ll-drawing .name.error text { fill: var(--ll-error); font-weight: 600; }\n.ll-drawing .box.unknown text { paint-order: stroke; stroke: var(--ll-node); stroke-width: 3.5px; stroke-linejoin: round; }\n.ll-drawing .box.unknown .badge text { stroke: none; }\n.ll-drawing .port { fill: var(--ll-topic); stroke: var(--ll-ground); stroke-width: 1; }\n.ll-drawing .port.own { stroke: var(--ll-chosen); stroke-width: 2.5; }\n.ll-drawing .told { pointer-events: none; }\n.ll-drawing .told text { paint-order: stroke; stroke: var(--ll-ground); stroke-width: 4px; stroke-linejoin: round; fill: var(--ll-chosen); }\n.ll-drawing .told.hollow text { font-style: italic; fill: var(--ll-text); }\n.ll-drawing .port.service { fill: var(--ll-service); }\n.ll-drawing .port.action { fill: var(--ll-action); }\n.ll-drawing .port.param { fill: var(--ll-param); }\n.ll-drawing .loose { cursor: pointer; }\n.ll-drawing .loose > circle { fill: var(--ll-node); stroke: var(--ll-topic); stroke-width: 1.4; }\n.ll-drawing .loose.service > circle { stroke: var(--ll-service); }\n.ll-drawing .loose.action > circle { stroke: var(--ll-action); }\n.ll-drawing .loose.added > circle { stroke: var(--ll-added); stroke-width: 2.4; }\n.ll-drawing .loose.removed > circle { stroke: var(--ll-removed); stroke-width: 2.4; stroke-dasharray: 2 2; }\n.ll-drawing .loose.changed > circle { stroke: var(--ll-changed); stroke-width: 2.4; }\n.ll-drawing .loose.added .name text { fill: var(--ll-added); }\n.ll-drawing .loose.removed .name text { fill: var(--ll-removed); text-decoration: line-through; }\n.ll-drawing .loose.uncertain > circle { stroke-dasharray: 1.5 2; }\n.ll-drawing .loose .name text { font-style: italic; }\n\n.ll-drawing.selecting .box:not(.lit):not(.open), .ll-drawing.searching .box:not(.match):not(.open) { opacity: 0.34; }\n.ll-drawing.selecting .line:not(.lit) { opacity: 0.18; }\n.ll-drawing.selecting .names > :not(.lit) { opacity: 0.22; }\n.ll-drawing.selecting .port:not(.lit) { opacity: 0.25; }\n.ll-drawing.searching .box.match > .shape { stroke: var(--ll-chosen); stroke-width: 2; }\n.ll-drawing.searching .line, .ll-drawing.searching .names > :not(.match) { opacity: 0.35; }\n.ll-drawing .line.lit .course { stroke-width: 2.4; }\n.ll-drawing .name.lit text { fill: var(--ll-text); }\n\n/* From far away, what could not be read anyway is not drawn. */\n.ll-drawing[data-distance="far"] .name, .ll-drawing[data-distance="far"] .loose,\n.ll-drawing[data-distance="far"] .box:not(.open) .detail, .ll-drawing[data-distance="far"] .box .condition,\n.ll-drawing[data-distance="far"] .box .host, .ll-drawing[data-distance="far"] .box .count, .ll-drawing[data-distance="far"] .port { display: none; }\n.ll-drawing[data-distance="far"] .line path.course { stroke-width: 2; }\n\n.ll-legend { position: absolute; left: 10px; bottom: 10px; max-width: min(92%, 640px); font: 12px/1.35 system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif; color: var(--ll-text); background: var(--ll-node); border: 1px solid var(--ll-box-line); border-radius: 8px; }\n.ll-legend summary { padding: 4px 10px; cursor: pointer; color: var(--ll-muted); }\n.ll-legend ul { margin: 0; padding: 2px 12px 8px; list-style: none; display: grid; grid-template-columns: repeat(auto-fill, minmax(180px, 1fr)); gap: 2px 14px; max-height: 40vh; overflow: auto; }\n.ll-legend li { display: flex; align-items: center; gap: 8px; }\n.ll-legend svg.ll-drawing { flex: none; width: 44px; height: 20px; background: none; cursor: default; }\n/* What takes long says so. */\n.ll-drawing-host.waiting::after {\n  content: "Drawing …";\n  position: absolute;\n  top: 12px;\n  left: 50%;\n  transform: translateX(-50%);\n  padding: 4px 12px;\n  border-radius: 12px;\n  background: var(--ll-text);\n  color: var(--ll-ground);\n  font: 13px system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif;\n  pointer-events: none;\n}\n';

  // launchlint/report/html/js/drawing/export.js
  var MARGIN = 16;
  function exported(svg, size, styles) {
    var _a;
    const copy = (
      /** @type {SVGSVGElement} */
      svg.cloneNode(true)
    );
    const [width, height] = [Math.ceil(size.width + 2 * MARGIN), Math.ceil(size.height + 2 * MARGIN)];
    for (const name of ["tabindex", "data-distance"]) copy.removeAttribute(name);
    copy.setAttribute("class", "ll-drawing");
    copy.setAttribute("viewBox", `${-MARGIN} ${-MARGIN} ${width} ${height}`);
    copy.setAttribute("width", String(width));
    copy.setAttribute("height", String(height));
    (_a = copy.querySelector("g")) == null ? void 0 : _a.removeAttribute("transform");
    for (const each of copy.querySelectorAll("[tabindex], [role]")) {
      each.removeAttribute("tabindex");
      each.removeAttribute("role");
    }
    for (const each of copy.querySelectorAll(".hit, .fold")) each.remove();
    const colours = getComputedStyle(svg);
    const rules = styles.slice(styles.indexOf("svg.ll-drawing")).replace(/--ll-own: var\((--ll-\w+)\)/g, (_, name) => `--ll-own: ${colours.getPropertyValue(name).trim()}`).replace(/var\((--ll-(?!own)[\w-]+)\)/g, (_, name) => colours.getPropertyValue(name).trim());
    const style = document.createElementNS("http://www.w3.org/2000/svg", "style");
    style.textContent = rules;
    const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
    for (const [name, value] of Object.entries({ x: -MARGIN, y: -MARGIN, width, height, fill: colours.getPropertyValue("--ll-ground").trim() })) ground.setAttribute(name, String(value));
    copy.prepend(style, ground);
    return new XMLSerializer().serializeToString(copy);
  }

  // launchlint/report/html/js/drawing/shapes.js
  var SVG = "http://www.w3.org/2000/svg";
  var CORNER = 7;
  function element(tag, attributes2 = {}, children = []) {
    const made2 = document.createElementNS(SVG, tag);
    for (const [name, value] of Object.entries(attributes2)) made2.setAttribute(name, String(value));
    for (const each of children) if (each) made2.append(each);
    return made2;
  }
  function text(content, attributes2) {
    const made2 = element("text", attributes2);
    made2.textContent = content;
    return made2;
  }
  function title(content) {
    const made2 = element("title");
    made2.textContent = content;
    return made2;
  }
  function course(points) {
    const [first] = points;
    if (!first) return "";
    let path = `M${round(first.x)} ${round(first.y)}`;
    for (let at = 1; at < points.length; at++) {
      const [before, corner, after] = [points[at - 1], points[at], points[at + 1]];
      if (!before || !corner) continue;
      if (!after) {
        path += `L${round(corner.x)} ${round(corner.y)}`;
        continue;
      }
      const [enter, leave] = [towards(corner, before), towards(corner, after)];
      path += `L${round(enter.x)} ${round(enter.y)}Q${round(corner.x)} ${round(corner.y)} ${round(leave.x)} ${round(leave.y)}`;
    }
    return path;
  }
  function towards(from, to) {
    const length = Math.hypot(to.x - from.x, to.y - from.y);
    const part2 = length ? Math.min(CORNER, length / 2) / length : 0;
    return { x: from.x + (to.x - from.x) * part2, y: from.y + (to.y - from.y) * part2 };
  }
  function round(value) {
    return Math.round(value * 10) / 10;
  }

  // launchlint/report/html/js/drawing/legend.js
  var SIGNS = [
    [hasLine("topic"), "topic", () => line("topic", "M36 6L44 10L36 14Z")],
    [hasLine("service"), "service, from client to server", () => line("service", "M32 10L37 6L42 10L37 14Z")],
    [hasLine("action"), "action, from client to server", () => line("action", "M36 6L44 10L36 14ZM30 6L38 10L30 14Z")],
    [hasLine("param"), "param, to its readers", () => line("param", "M36 7H42V13H36Z")],
    [(sheet) => sheet.edges.some(({ edge }) => edge.wires.length > 2), "several between the same two", () => line("topic bundle", "M36 6L44 10L36 14Z")],
    [hasLine("conditional"), "in some configurations only", () => line("topic conditional", "M36 6L44 10L36 14Z")],
    [hasLine("uncertain"), "not certain", () => line("topic uncertain", "M36 6L44 10L36 14Z")],
    [hasBox("folded"), "container, folded", () => box("folded")],
    [hasBox("conditional"), "conditional node", () => box("node conditional")],
    [hasBox("lifecycle"), "lifecycle node", () => [...box("node"), group("box node", element("rect", { class: "inner", x: 5, y: 5, width: 34, height: 10, rx: 3 }))]],
    [hasBox("host"), "process that others run in", () => box("node host")],
    [hasBox("unknown"), "unknown: what it connects to is not known", () => [...box("node unknown"), element("rect", { x: 3, y: 3, width: 38, height: 14, fill: "url(#ll-hatching)" })]],
    [hasBox("pill"), "many to many, or shared", () => [group("box pill topic", element("rect", { class: "shape", x: 2, y: 3, width: 40, height: 14, rx: 7 }))]],
    [hasBox("stub"), "around what is in focus", () => box("node stub")],
    [(sheet) => sheet.loose.length > 0, "nobody else is known to use or offer it", () => [group("loose topic", element("circle", { cx: 22, cy: 10, r: 4 }))]],
    [hasAny("added"), "added", () => box("node added")],
    [hasAny("removed"), "removed", () => box("node removed")],
    [hasAny("changed"), "changed", () => box("node changed")],
    [(sheet) => sheet.boxes.some((each) => {
      var _a;
      return (_a = each.box.badge) == null ? void 0 : _a.elsewhere;
    }), "a finding elsewhere is about it, too", () => [group("badge error elsewhere", element("circle", { cx: 22, cy: 10, r: 8 }), text("!", { x: 22, y: 14 }))]],
    [(sheet) => sheet.boxes.some((each) => each.box.badge && !each.box.badge.elsewhere) || sheet.loose.some((each) => each.port.badge), "findings", () => [group("badge error", element("circle", { cx: 22, cy: 10, r: 8 }), text("!", { x: 22, y: 14 }))]]
  ];
  function showLegend(sheet, host2) {
    var _a;
    const list3 = document.createElement("ul");
    for (const [isShown2, words2, sample] of SIGNS) {
      if (!isShown2(sheet)) continue;
      const item2 = list3.appendChild(document.createElement("li"));
      item2.append(element("svg", { class: "ll-drawing", viewBox: "0 0 44 20", "aria-hidden": "true" }, sample()), words2);
    }
    (_a = host2.querySelector("ul")) == null ? void 0 : _a.remove();
    host2.hidden = !list3.childElementCount;
    host2.append(list3);
  }
  function hasLine(name) {
    return (sheet) => sheet.edges.some(({ edge }) => edge.classes.includes(name));
  }
  function hasBox(name) {
    return (sheet) => sheet.boxes.some(({ box: { classes } }) => classes.includes(name));
  }
  function hasAny(name) {
    return (sheet) => hasLine(name)(sheet) || hasBox(name)(sheet);
  }
  function group(classes, ...children) {
    return element("g", { class: classes }, children);
  }
  function line(classes, head2) {
    return [group(`line ${classes}`, element("path", { class: "course", d: "M2 10H36" }), element("path", { class: "head", d: head2 }))];
  }
  function box(classes) {
    return [group(`box ${classes}`, element("rect", { class: "shape", x: 2, y: 2, width: 40, height: 16, rx: 4 }))];
  }

  // launchlint/report/html/js/drawing/measure.js
  var FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Noto Sans", "DejaVu Sans", sans-serif';
  var SIZES = { title: 13, detail: 12, condition: 12, host: 12, count: 12, label: 12 };
  var GUESS = 0.58;
  function measurer() {
    const canvas = typeof document === "undefined" ? null : document.createElement("canvas").getContext("2d");
    const known6 = /* @__PURE__ */ new Map();
    return (text2, kind) => {
      const size = SIZES[kind];
      if (!canvas) return text2.length * size * GUESS;
      const font = `${kind === "title" ? 600 : 400} ${size}px ${FONT}`;
      const key = `${kind === "title" ? "b" : ""}${size} ${text2}`;
      let width = known6.get(key);
      if (width === void 0) {
        canvas.font = font;
        width = canvas.measureText(text2).width;
        known6.set(key, width);
      }
      return width;
    };
  }

  // launchlint/report/html/js/drawing/names.js
  function compareNames(one2, other) {
    const left = parts(one2);
    const right = parts(other);
    for (let at = 0; at < left.length && at < right.length; at++) {
      const [a, b] = [left[at], right[at]];
      if (a === b) continue;
      if (typeof a === "number" && typeof b === "number") return a - b;
      return String(a) < String(b) ? -1 : 1;
    }
    return left.length - right.length || (one2 < other ? -1 : one2 > other ? 1 : 0);
  }
  var known = /* @__PURE__ */ new Map();
  function parts(name) {
    let found2 = known.get(name);
    if (found2 === void 0) {
      found2 = name.split(/(\d{1,15})/).map((part2, at) => at % 2 ? Number(part2) : part2);
      known.set(name, found2);
    }
    return found2;
  }
  function lastPart(name) {
    return name.slice(name.lastIndexOf("/") + 1) || name;
  }
  var SPARE = 9;
  function shortName(name, namespace, most) {
    const inner = namespace.length > 1 && name.startsWith(`${namespace}/`) ? name.slice(namespace.length + 1) : name;
    if (inner.length <= most) return inner;
    const pieces2 = inner.split("/");
    let tail2 = pieces2.pop() ?? "";
    while (pieces2.length > 1 && tail2.length + 1 + (pieces2[pieces2.length - 1] ?? "").length < most - 2) tail2 = `${pieces2.pop()}/${tail2}`;
    return pieces2.length && tail2.length + 2 > most - SPARE ? cut(`…/${tail2}`, most) : cut(inner, most);
  }
  function cut(text2, most) {
    const characters = Array.from(text2);
    if (characters.length <= most) return text2;
    const head2 = Math.max(2, Math.floor(most / 4));
    return `${characters.slice(0, head2).join("")}…${characters.slice(head2 + 1 - most).join("")}`;
  }
  function briefNames(names2, most) {
    const alike = /* @__PURE__ */ new Map();
    for (const name of new Set(names2)) {
      const brief2 = shortName(name, "", most);
      const others = alike.get(brief2);
      if (others) others.push(name);
      else alike.set(brief2, [name]);
    }
    const found2 = /* @__PURE__ */ new Map();
    for (const [brief2, same] of alike) {
      if (same.length === 1) found2.set(
        /** @type {string} */
        same[0],
        brief2
      );
      else for (const name of same) found2.set(name, fromWhereTheyPart(name, same, most));
    }
    return found2;
  }
  function fromWhereTheyPart(name, names2, most) {
    let same = 0;
    while (same < name.length && names2.every((each) => each[same] === name[same])) same++;
    const from = Math.max(...["/", "_", "-", "."].map((sign) => name.lastIndexOf(sign, same - 1))) + 1;
    const rest = from > 1 ? `…${name.slice(from)}` : name;
    return rest.length <= most ? rest : `${rest.slice(0, most - 1)}…`;
  }
  function counted(count3, noun) {
    return `${count3} ${noun}${count3 === 1 ? "" : "s"}`;
  }
  function machineName(name, address) {
    return address && address !== name ? `${name} (${address})` : name;
  }
  function inLines(text2, most) {
    if (text2.length <= most) return [text2];
    const middle2 = text2.length / 2;
    let [best, cost] = [0, Infinity];
    for (let at = 1; at < text2.length; at++) {
      const [before = "", after = ""] = [text2[at - 1], text2[at]];
      const kind = before === "/" || before === "_" || before === "-" || before === "." ? 0 : /[a-z]/.test(before) && /[A-Z]/.test(after) ? 2 : Infinity;
      const own = Math.abs(at - middle2) + kind;
      if (own < cost) [best, cost] = [at, own];
    }
    return cost > most / 2 ? [text2] : [text2.slice(0, best), text2.slice(best)];
  }
  function isLocal(name, address) {
    const host2 = address || name;
    return host2 === "localhost" || host2 === "127.0.0.1" || host2 === "::1";
  }

  // launchlint/report/html/js/drawing/tree.js
  var DEEPEST = 32;
  var MOST = 40;
  var FEW = 20;
  var [RANGE, SMALL] = [12, 6];
  var RANGES = 24;
  var SHORT = 20;
  var made = /* @__PURE__ */ new WeakMap();
  function containersOf(entry, grouping) {
    let trees = made.get(entry);
    if (!trees) made.set(entry, trees = /* @__PURE__ */ new Map());
    let root = trees.get(grouping);
    if (!root) {
      root = MAKERS[grouping](entry);
      finish(root, entry);
      trees.set(grouping, root);
    }
    return root;
  }
  function* walk(root) {
    yield root;
    for (const each of root.groups) yield* walk(each);
  }
  function group2(kind, id, label2, namespace = "", container = -1) {
    return { id, kind, label: label2, title: label2, namespace, container, own: [], groups: [], nodes: [], count: 0, parent: "" };
  }
  function byNamespace(entry) {
    const root = group2("root", "g:namespace:/", "/", "/");
    const known6 = /* @__PURE__ */ new Map();
    entry.nodes.forEach((node, index) => {
      let around3 = root;
      let from = 1;
      for (let depth = 1; node.namespace.length > from && from > 0; depth++) {
        const end = depth < DEEPEST ? node.namespace.indexOf("/", from) : -1;
        const namespace = end < 0 ? node.namespace : node.namespace.slice(0, end);
        let inner = known6.get(namespace);
        if (!inner) {
          const label2 = around3 === root ? namespace : namespace.slice(around3.namespace.length + 1);
          inner = group2("namespace", `g:namespace:${namespace}`, label2, namespace);
          known6.set(namespace, inner);
          around3.groups.push(inner);
        }
        around3 = inner;
        from = end + 1;
      }
      around3.nodes.push(index);
    });
    return root;
  }
  function byElement(entry) {
    const root = group2("root", "g:file:", "/", "/");
    const all = [];
    const outermost = { group: root, depth: 0 };
    const find = (index) => all[index] ?? outermost;
    entry.containers.forEach((container, index) => {
      const around3 = container.parent < index ? find(container.parent) : outermost;
      if (container.kind === "group" && !container.label) {
        around3.group.own = [...around3.group.own, ...container.findings];
        all.push(around3);
        return;
      }
      const label2 = container.kind === "include" ? lastPart(container.label) : container.label;
      const own = group2(container.kind, `g:file:${index}`, label2, container.namespace, index);
      own.title = container.label;
      own.own = container.findings;
      all.push(around3.depth < DEEPEST ? { group: own, depth: around3.depth + 1 } : around3);
      if (around3.depth < DEEPEST) around3.group.groups.push(own);
    });
    entry.nodes.forEach((node, index) => find(node.container).group.nodes.push(index));
    return root;
  }
  function byKey(entry, kind, keyOf2) {
    const root = group2("root", `g:${kind}:`, "/", "/");
    const known6 = /* @__PURE__ */ new Map();
    entry.nodes.forEach((node, index) => {
      const [key, label2] = keyOf2(node);
      let around3 = known6.get(key);
      if (!around3) {
        around3 = group2(kind, `g:${kind}:${key}`, label2);
        known6.set(key, around3);
        root.groups.push(around3);
      }
      around3.nodes.push(index);
    });
    return root;
  }
  var MAKERS = {
    namespace: byNamespace,
    file: byElement,
    package: (entry) => byKey(entry, "package", (node) => [node.package, node.package || "no package"]),
    machine: (entry) => byKey(entry, "machine", ({ machine: [name = "", address = ""] }) => [name, name ? machineName(name, address) : "no machine named"])
  };
  function finish(own, entry) {
    var _a;
    own.groups.forEach((each) => finish(each, entry));
    for (const each of own.groups) if (each.count === 0 && own.kind !== "root") own.own = [...own.own, ...each.own];
    own.groups = own.groups.filter((each) => each.count > 0);
    const inner = own.groups[0];
    if (own.kind !== "root" && inner && own.groups.length === 1 && !own.nodes.length) {
      const joint = own.kind === "namespace" ? "/" : " › ";
      const label2 = `${own.label}${joint}${inner.label}`;
      const { id, kind, container, title: title2 } = own.kind === "include" && inner.kind === "group" ? own : inner;
      Object.assign(own, inner, { id, kind, container, title: title2, label: label2, own: [...own.own, ...inner.own] });
    }
    own.nodes.sort((a, b) => {
      var _a2, _b;
      return compareNames(((_a2 = entry.nodes[a]) == null ? void 0 : _a2.name) ?? "", ((_b = entry.nodes[b]) == null ? void 0 : _b.name) ?? "") || a - b;
    });
    if (own.kind === "namespace" || own.kind === "root" || own.kind === "package" || own.kind === "machine") own.groups.sort((a, b) => compareNames(a.label, b.label));
    const late = own.nodes.filter((node) => {
      var _a2;
      return (_a2 = entry.nodes[node]) == null ? void 0 : _a2.late;
    });
    own.nodes = own.nodes.filter((node) => {
      var _a2;
      return !((_a2 = entry.nodes[node]) == null ? void 0 : _a2.late);
    });
    if (own.nodes.length > MOST) byFile(own, entry);
    if (own.nodes.length > MOST) {
      const ranges = split(own.nodes).map((nodes) => {
        const label2 = between(nodes.map((each) => {
          var _a2;
          return lastPart(((_a2 = entry.nodes[each]) == null ? void 0 : _a2.name) ?? "");
        }));
        const range = group2("range", `${own.id}#n${nodes[0]}`, label2, own.namespace);
        range.title = `${counted(nodes.length, "node")}: ${label2}`;
        range.nodes = nodes;
        return range;
      });
      own.nodes = [];
      (_a = ranges[ranges.length - 1]) == null ? void 0 : _a.nodes.push(...late.splice(0));
      own.groups.push(...ranges);
      ranges.forEach((each) => finish(each, entry));
    }
    own.nodes.push(...late);
    tellApart(own.groups, entry);
    const whole = own.groups.filter((each) => each.kind !== "range");
    if (whole.length > MOST) {
      const ranges = inRanges(own, whole);
      own.groups = [...ranges, ...own.groups.filter((each) => each.kind === "range")];
      ranges.forEach((each) => finish(each, entry));
    }
    own.count = own.nodes.length;
    for (const each of own.groups) {
      each.parent = own.id;
      own.count += each.count;
    }
  }
  function inRanges(own, groups, size) {
    return split(groups, size).map((members) => {
      var _a;
      const label2 = between(members.map((each) => each.label));
      const range = group2("range", `${own.id}#${(_a = members[0]) == null ? void 0 : _a.id}`, label2, own.namespace);
      range.title = `${counted(members.length, "container")}: ${label2}`;
      range.groups = members;
      return range;
    });
  }
  function tellApart(groups, entry) {
    const alike = /* @__PURE__ */ new Map();
    for (const each of groups) alike.set(each.label, [...alike.get(each.label) ?? [], each]);
    for (const own of alike.values()) {
      if (own.length < 2) continue;
      const told2 = own.map((each) => beginning(Array.from(walk(each), ({ nodes }) => nodes).flat().filter((node) => {
        var _a;
        return !((_a = entry.nodes[node]) == null ? void 0 : _a.late);
      }).map((node) => {
        var _a;
        return ((_a = entry.nodes[node]) == null ? void 0 : _a.name) ?? "";
      })));
      const differ = new Set(told2).size === own.length && !told2.includes("");
      own.forEach((each, at) => each.label = `${each.label} · ${differ ? cut(told2[at] ?? "", SHORT) : at + 1}`);
    }
  }
  function beginning([first = "", ...others]) {
    let same = first.length;
    for (const other of others) while (!other.startsWith(first.slice(0, same))) same--;
    const shared2 = first.slice(0, same);
    return (others.every((other) => other === first) ? shared2 : shared2.replace(/[^/_.-]*$/, "")).replace(/^[/]|[/_.-]+$/g, "");
  }
  function byFile(own, entry) {
    var _a, _b;
    if (own.kind === "range" || own.container >= 0) return;
    const top = group2("root", own.id, "");
    const known6 = /* @__PURE__ */ new Map();
    for (const node of own.nodes) {
      let around3 = top;
      for (const file of includesAround(entry, node)) {
        let inner = known6.get(file);
        if (!inner) {
          const path = ((_a = entry.containers[file]) == null ? void 0 : _a.label) ?? "";
          inner = group2("include", `${own.id}#f${file}`, lastPart(path), own.namespace, file);
          Object.assign(inner, { title: path, own: ((_b = entry.containers[file]) == null ? void 0 : _b.findings) ?? [] });
          known6.set(file, inner);
          around3.groups.push(inner);
        }
        around3 = inner;
      }
      around3.nodes.push(node);
    }
    thin(top);
    for (let [only2, other] = top.groups; only2 && !other; [only2, other] = top.groups) {
      top.groups = only2.groups;
      top.nodes.push(...only2.nodes);
    }
    if (!top.groups.length || top.nodes.length + top.groups.length > MOST) return;
    top.groups.forEach((each) => finish(each, entry));
    own.nodes = own.nodes.filter((node) => top.nodes.includes(node));
    tellApart(top.groups, entry);
    const ranges = top.groups.length > FEW ? inRanges(own, top.groups, SMALL) : [];
    ranges.forEach((each) => finish(each, entry));
    own.groups.push(...ranges.length ? ranges : top.groups);
  }
  function includesAround(entry, node) {
    var _a, _b, _c;
    const chain = [];
    let at = ((_a = entry.nodes[node]) == null ? void 0 : _a.container) ?? -1;
    for (let seen = 0; at >= 0 && seen < DEEPEST; seen++) {
      if (((_b = entry.containers[at]) == null ? void 0 : _b.kind) === "include") chain.unshift(at);
      at = ((_c = entry.containers[at]) == null ? void 0 : _c.parent) ?? -1;
    }
    return chain;
  }
  function thin(own) {
    let count3 = own.nodes.length;
    own.groups = own.groups.filter((each) => {
      const inside = thin(each);
      count3 += inside;
      if (inside < 2) own.nodes.push(...each.nodes);
      return inside > 1;
    });
    return count3;
  }
  function split(members, size = RANGE) {
    const ranges = Math.min(RANGES, Math.ceil(members.length / size));
    return Array.from(
      { length: ranges },
      (_, at) => members.slice(Math.floor(at * members.length / ranges), Math.floor((at + 1) * members.length / ranges))
    );
  }
  function between(labels) {
    const [first, last] = [labels[0] ?? "", labels[labels.length - 1] ?? ""];
    if (first === last) return cut(first, 2 * SHORT);
    let same = 0;
    while (same < first.length && first[same] === last[same]) same++;
    const shared2 = first.slice(0, same).search(/[^_\-./ ]*$/);
    return `${cut(first, SHORT)} – ${cut(last.slice(shared2), SHORT)}`;
  }

  // launchlint/report/html/js/drawing/boxes.js
  var LINE_HEIGHTS = { title: 17, detail: 15, condition: 15, host: 15, count: 15 };
  var PADDING = { x: 12, y: 8 };
  var FOLD = 18;
  var LONGEST = { title: 40, detail: 24, condition: 24, label: 20, open: 48 };
  var BROAD = 20;
  var BRIEF = 26;
  var BUNDLE = 3;
  var SEVERITIES = (
    /** @type {const} */
    ["error", "warning", "info"]
  );
  function badgeOf(view, findings, elsewhere2 = false) {
    var _a;
    const distinct = new Set(findings);
    for (const severity of SEVERITIES) {
      for (const each of distinct) if (((_a = view.findings[each]) == null ? void 0 : _a.severity) === severity) return { severity, count: distinct.size, elsewhere: elsewhere2 };
    }
    return null;
  }
  function nodeBox(view, index, group3, measure) {
    const node = view.entry.nodes[index];
    if (!node) throw new RangeError(`there is no node ${index}`);
    const isBrief = group3.kind === "tray";
    const inNamespace = group3.namespace === node.namespace || view.state.grouping === "namespace" && !isBrief;
    const lines = isBrief ? [{ kind: "title", text: namesIn(view, group3).get(node.name) ?? node.name }] : titles(inNamespace ? cut(lastPart(node.name), LONGEST.title) : shortName(node.name, "", LONGEST.title));
    if (node.program && !isBrief && !view.terse) lines.push({ kind: "detail", text: cut(node.program, LONGEST.detail) });
    const classes = ["node"];
    const when2 = view.presence.of(node.only, node.mark);
    const conditional = node.conditions.length > 0 || view.presence.conditional(when2, view.now);
    if (conditional) classes.push("conditional");
    if (node.conditions.length && !isBrief) lines.push({ kind: "condition", text: cut(node.conditions.join(" and "), LONGEST.condition) });
    const guest = node.host !== "" && node.host !== node.name;
    if (guest && !isBrief) lines.push({ kind: "host", text: `in ${shortName(node.host, node.namespace, LONGEST.detail)}` });
    const [machine2 = "", address = ""] = node.machine;
    if (machine2 && !isLocal(machine2, address) && view.machines > 1 && view.state.grouping !== "machine" && !isBrief) {
      classes.push("machine");
      lines.push({ kind: "host", text: `on ${cut(machine2, LONGEST.detail)}` });
    }
    const params = view.params.get(index);
    if (params) lines.push({ kind: "count", text: counted(params, "param") });
    if (node.knowledge === "unknown") classes.push("unknown");
    if (node.lifecycle) classes.push("lifecycle");
    if (node.kind === "container" || node.kind === "manager") classes.push("host");
    if (node.isTest) classes.push("test");
    if (node.mark) classes.push(node.mark);
    if (view.stubs.has(`n:${index}`)) classes.push("stub");
    const said2 = [node.name, node.program];
    if (node.knowledge === "unknown") said2.push(`unknown: ${node.reason || "nothing is known of what it connects to"}`);
    if (node.conditions.length) said2.push(`only where ${node.conditions.join(" and ")}`);
    if (node.lifecycle) said2.push("lifecycle node: somebody has to configure and activate it");
    if (guest) said2.push(`in the process of ${node.host}`);
    if (machine2) said2.push(`on the machine ${machineName(machine2, address)}`);
    const loose = loosePorts(view, `n:${index}`, view.loose.get(index) ?? [], group3);
    const badge3 = badgeOf(view, node.findings) ?? badgeOf(view, node.related, true);
    return sized({ id: `n:${index}`, kind: "node", classes, lines, title: said2.join("\n"), badge: badge3, loose, level: null, wires: [] }, measure);
  }
  var brief = /* @__PURE__ */ new WeakMap();
  function namesIn(view, tray) {
    let found2 = brief.get(tray);
    if (!found2) brief.set(tray, found2 = briefNames(tray.nodes.map((each) => {
      var _a;
      return ((_a = view.entry.nodes[each]) == null ? void 0 : _a.name) ?? "";
    }), BRIEF));
    return found2;
  }
  function titles(text2) {
    return inLines(text2, BROAD).map((each) => ({ kind: "title", text: each }));
  }
  function foldedBox(view, group3, measure) {
    var _a;
    const about = contents(view, group3);
    const lines = titles(cut(group3.label, LONGEST.title));
    const unknown = about.unknown && about.unknown < about.nodes ? ` · ${about.unknown} unknown` : "";
    const only2 = about.nodes === 1 ? `: ${cut(lastPart(((_a = view.entry.nodes[about.first]) == null ? void 0 : _a.name) ?? ""), LONGEST.label)}` : unknown;
    const detail = group3.kind === "tray" ? unknown.replace(" · ", "") : `${counted(about.nodes, "node")}${only2}`;
    if (detail && !view.terse) lines.push({ kind: "detail", text: detail });
    const classes = ["folded", group3.kind];
    if (about.nodes && about.unknown === about.nodes) classes.push("unknown");
    if (about.mark) classes.push(about.mark);
    if (view.stubs.has(group3.id)) classes.push("stub");
    const title2 = `${group3.title}
${counted(about.nodes, "node")}${about.unknown ? `, ${about.unknown} unknown` : ""}`;
    const badge3 = badgeOf(view, about.findings);
    return sized({ id: group3.id, kind: "folded", classes, lines, title: title2, badge: badge3, loose: looseOf(view, group3), level: null, wires: [] }, measure);
  }
  function openBox(view, level) {
    const { group: group3 } = level;
    const about = contents(view, group3);
    const classes = ["open", group3.kind];
    if (about.mark) classes.push(about.mark);
    const lines = [{ kind: "title", text: cut(group3.label, LONGEST.open) }];
    const title2 = `${group3.title}
${counted(about.nodes, "node")}`;
    return { id: group3.id, kind: "open", classes, lines, title: title2, badge: badgeOf(view, group3.own), width: 0, height: 0, loose: looseOf(view, group3), level, wires: [] };
  }
  function looseOf(view, group3) {
    if (group3.kind !== "include") return [];
    const sides2 = [/* @__PURE__ */ new Set(), /* @__PURE__ */ new Set()];
    for (const each of walk(group3)) {
      for (const node of each.nodes) if (view.shown[node]) for (const { wire, gives: gives2 } of view.loose.get(node) ?? []) sides2[gives2 ? 1 : 0].add(wire);
    }
    return sides2.flatMap((side, out) => {
      const wires = [...side];
      return wires.length ? [{ id: `${group3.id}|loose|${out ? "out" : "in"}`, out: out === 1, wires, label: wires.length > 1 ? String(wires.length) : "", classes: ["several"], badge: null }] : [];
    });
  }
  function pillBox(view, wires, group3, measure) {
    const [first] = wires;
    if (!first) throw new RangeError("a pill stands for something");
    const single2 = wires.length === 1;
    const text2 = single2 ? shortName(first.name, group3.namespace, LONGEST.title) : counted(wires.length, first.kind);
    const classes = ["pill", first.kind];
    if (single2 && first.kind !== "param" && !(first.givers.length && first.takers.length)) classes.push("dangling");
    const mark = commonMark(wires);
    if (mark) classes.push(mark);
    const title2 = single2 ? [first.name, ...first.types].join("\n") : wires.map((wire) => wire.name).join("\n");
    const badge3 = badgeOf(view, wires.flatMap((wire) => wire.findings));
    const id = single2 ? `w:${first.id}` : `w:${first.id}+${wires.length}`;
    const width = Math.ceil(measure(text2, "label")) + 22;
    return { id, kind: "pill", classes, lines: [{ kind: "title", text: text2 }], title: title2, badge: badge3, width, height: 22, loose: [], level: null, wires };
  }
  function commonMark(wires) {
    var _a;
    const marks = new Set(wires.map((wire) => wire.mark));
    return marks.size === 1 ? ((_a = wires[0]) == null ? void 0 : _a.mark) ?? "" : "";
  }
  function contents(view, group3) {
    let [nodes, unknown, first] = [0, 0, -1];
    const findings = [];
    const marks = /* @__PURE__ */ new Set();
    for (const each of walk(group3)) {
      findings.push(...each.own);
      for (const index of each.nodes) {
        const node = view.entry.nodes[index];
        if (!node || !view.shown[index]) continue;
        nodes += 1;
        if (first < 0) first = index;
        unknown += Number(node.knowledge === "unknown");
        findings.push(...node.findings);
        marks.add(node.mark ?? (view.touched.has(index) ? "changed" : ""));
      }
    }
    const mark = marks.size === 1 ? String([...marks][0]) : marks.size ? "changed" : "";
    return { nodes, unknown, first, findings, mark };
  }
  function loosePorts(view, box2, all, group3) {
    const found2 = [];
    for (const out of [false, true]) {
      const side = all.filter((each) => each.gives === out);
      const alone = view.state.danglingOnly ? side : side.filter((each) => each.wire.findings.length || each.mark && !isNew(view, box2));
      const rest = side.filter((each) => !alone.includes(each));
      for (const each of [...alone.map((each2) => [each2]), rest]) {
        const [first] = each;
        if (!first) continue;
        const wires = each.map((loose) => loose.wire);
        const label2 = each !== rest ? shortName(first.wire.name, group3.namespace, LONGEST.label) : each.length > 1 && group3.kind !== "tray" ? String(each.length) : "";
        const classes = [each.length === 1 ? first.wire.kind : "several"];
        if (!each.some((loose) => loose.certain)) classes.push("uncertain");
        if (first.mark && each.every((loose) => loose.mark === first.mark)) classes.push(first.mark);
        const badge3 = badgeOf(view, wires.flatMap((wire) => wire.findings));
        found2.push({ id: `${box2}|loose|${out ? "out" : "in"}|${first.wire.id}`, out, wires, label: label2, classes, badge: badge3 });
      }
    }
    return found2;
  }
  function isNew(view, box2) {
    var _a;
    const mark = (_a = view.entry.nodes[Number(box2.slice(2))]) == null ? void 0 : _a.mark;
    return mark === "added" || mark === "removed";
  }
  function sized(box2, measure) {
    const indent = box2.kind === "folded" ? FOLD : 0;
    const width = Math.max(...box2.lines.map((line4) => measure(line4.text, line4.kind)), 56) + 2 * PADDING.x + indent;
    const height = box2.lines.reduce((sum, line4) => sum + LINE_HEIGHTS[line4.kind], 0) + 2 * PADDING.y;
    return { ...box2, width: Math.ceil(width), height };
  }

  // launchlint/report/html/js/drawing/engine.js
  var LABEL_HEIGHT = 14;
  var BADGE = 17;
  var MARGIN2 = 16;
  var LONG = 700;
  var WIDER = 1.25;
  var DOWNWARDS = 4;
  var GAIN = 0.9;
  var ROWS = [1, 0.4];
  var ROWS_ANYWHERE = 0.75;
  var DENSE = {
    "elk.spacing.nodeNode": "12",
    "elk.spacing.edgeEdge": "9",
    "elk.spacing.edgeNode": "10",
    "elk.spacing.portPort": "14",
    "elk.spacing.componentComponent": "18",
    "elk.layered.spacing.nodeNodeBetweenLayers": "18",
    "elk.layered.spacing.edgeNodeBetweenLayers": "9",
    "elk.layered.spacing.edgeEdgeBetweenLayers": "8"
  };
  var KEPT = 600;
  var OPTIONS = {
    "elk.algorithm": "layered",
    "elk.direction": "RIGHT",
    "elk.edgeRouting": "ORTHOGONAL",
    "elk.randomSeed": "1",
    "elk.spacing.nodeNode": "22",
    "elk.spacing.edgeEdge": "12",
    "elk.spacing.edgeNode": "14",
    "elk.spacing.portPort": "16",
    "elk.spacing.componentComponent": "26",
    "elk.layered.spacing.nodeNodeBetweenLayers": "26",
    "elk.layered.spacing.edgeNodeBetweenLayers": "12",
    "elk.layered.spacing.edgeEdgeBetweenLayers": "10",
    "elk.layered.nodePlacement.strategy": "BRANDES_KOEPF",
    "elk.layered.nodePlacement.bk.fixedAlignment": "LEFTUP",
    "elk.layered.crossingMinimization.strategy": "LAYER_SWEEP",
    "elk.layered.thoroughness": "7",
    "elk.layered.considerModelOrder.strategy": "NODES_AND_EDGES",
    "elk.layered.considerModelOrder.crossingCounterNodeInfluence": "0.001"
  };
  async function layOutPart(engine, part2, inner, measure, cache, screen) {
    const names2 = new Names();
    const graph = asGraph(part2, inner, measure, names2);
    const key = JSON.stringify([graph, screen]);
    let placed = cache.get(key);
    if (!placed) {
      placed = run(engine, part2, graph, screen);
      cache.set(key, placed);
      for (const oldest of cache.keys()) {
        if (cache.size <= KEPT) break;
        cache.delete(oldest);
      }
    }
    return names2.given(await placed);
  }
  async function run(engine, part2, graph, screen) {
    const root = (options = {}) => ({
      id: "root",
      layoutOptions: { "elk.algorithm": "layered", "elk.padding": "[left=0,top=0,right=0,bottom=0]" },
      children: [{ ...graph, layoutOptions: { ...graph.layoutOptions, ...screen.density === "plain" ? {} : DENSE, ...options } }]
    });
    let best = asPlaced(await engine.layout(root()));
    if (!part2.ports.length) {
      const inRows2 = async (cutting, ratio, anywhere) => {
        const rows2 = { "elk.layered.wrapping.strategy": "MULTI_EDGE", "elk.layered.wrapping.cutting.strategy": cutting, "elk.aspectRatio": String(ratio * screen.aspect) };
        const tried = straightened(asPlaced(await engine.layout(root({ ...rows2, "elk.layered.wrapping.multiEdge.improveCuts": String(!anywhere) }))));
        if (isStraight(tried) && costOf(tried, screen) < GAIN * costOf(best, screen)) best = tried;
      };
      for (const ratio of ROWS) {
        if (best.width <= Math.min(LONG, screen.width) || best.width < WIDER * screen.aspect * best.height && !isNarrow(screen)) break;
        await inRows2("ARD", ratio, false);
      }
      const [width, height] = [screen.width, screen.width / screen.aspect];
      if ((best.width > width || best.height > height) && best.width * best.height < 1.2 * width * height) await inRows2("MSD", ROWS_ANYWHERE, true);
    }
    return isStraight(best) ? best : asPlaced(await engine.layout(root({ "elk.layered.nodePlacement.strategy": "NETWORK_SIMPLEX" })));
  }
  function costOf({ width, height }, screen) {
    const cut2 = isNarrow(screen) ? Math.max(0, width - screen.width) : 0;
    return Math.max(width / screen.aspect, height) + DOWNWARDS * cut2;
  }
  function isNarrow({ width }) {
    return width < LONG;
  }
  function isStraight({ edges }) {
    return Array.from(edges.values()).every(({ points }) => isRight(points));
  }
  function isRight(points) {
    return points.every((point, at) => {
      const next = points[at + 1];
      return !next || Math.abs(next.x - point.x) < 0.5 || Math.abs(next.y - point.y) < 0.5;
    });
  }
  function straightened(placed) {
    for (const line4 of placed.edges.values()) {
      const [first, last] = [line4.points[0], line4.points[line4.points.length - 1]];
      if (!first || !last) continue;
      const isLevel = !isRight(line4.points) && isRight([first, last]);
      if (isLevel && !Array.from(placed.boxes.values()).some((box2) => isThrough(box2, first, last))) line4.points = [first, last];
      line4.junctions = line4.junctions.filter((junction) => isOn(line4.points, junction));
    }
    return placed;
  }
  function isOn(points, { x, y }) {
    return points.some((from, at) => {
      const to = points[at + 1] ?? from;
      return x > Math.min(from.x, to.x) - 1 && x < Math.max(from.x, to.x) + 1 && y > Math.min(from.y, to.y) - 1 && y < Math.max(from.y, to.y) + 1;
    });
  }
  function isThrough(box2, from, to) {
    const [left, right] = [Math.min(from.x, to.x), Math.max(from.x, to.x)];
    return from.y > box2.y && from.y < box2.y + box2.height && left < box2.x + box2.width - 0.5 && right > box2.x + 0.5;
  }
  var Names = class {
    constructor() {
      this.all = [];
      this.short = /* @__PURE__ */ new Map();
    }
    /** @param {string} id @returns {string} */
    of(id) {
      let found2 = this.short.get(id);
      if (found2 === void 0) {
        found2 = `i${this.all.length}`;
        this.all.push(id);
        this.short.set(id, found2);
      }
      return found2;
    }
    /** The same by the ids that the short ones stand for. @param {Placed} placed @returns {Placed} */
    given({ width, height, boxes, ports, labels, edges }) {
      const named = (map) => new Map(Array.from(map, ([short, each]) => [this.all[Number(short.slice(1))] ?? short, each]));
      return { width, height, boxes: named(boxes), ports: named(ports), labels: named(labels), edges: named(edges) };
    }
  };
  function asGraph(level, inner, measure, names2) {
    const leaving = /* @__PURE__ */ new Map();
    const entering = /* @__PURE__ */ new Map();
    for (const edge of level.edges) {
      add(leaving, edge.fromBox, edge);
      add(entering, edge.toBox, edge);
    }
    const children = level.boxes.map((box2) => asNode(box2, leaving.get(box2.id) ?? [], entering.get(box2.id) ?? [], inner.get(box2.id), measure, names2));
    const ports = level.ports.map((port) => asPort(names2.of(port.id), port.out, port.out ? [] : labelAt(leaving.get("") ?? [], port.id), measure));
    const edges = level.edges.map((edge) => ({ id: names2.of(edge.id), sources: [names2.of(edge.fromPort)], targets: [names2.of(edge.toPort)] }));
    const side = ports.length ? MARGIN2 : 0;
    return {
      id: "level",
      children,
      ports,
      edges,
      layoutOptions: {
        ...OPTIONS,
        "elk.padding": `[left=${side},top=0,right=${side},bottom=0]`,
        "elk.portConstraints": "FIXED_SIDE",
        "elk.portLabels.placement": "INSIDE",
        "elk.nodeSize.constraints": "PORTS PORT_LABELS MINIMUM_SIZE"
      }
    };
  }
  function asNode(box2, leaving, entering, inner, measure, names2) {
    const ports = /* @__PURE__ */ new Map();
    const ends2 = new Map([...leaving.map((edge) => (
      /** @type {const} */
      [edge.fromPort, edge.from]
    )), ...entering.map((edge) => (
      /** @type {const} */
      [edge.toPort, edge.to]
    ))]);
    for (const edge of leaving) if (!ports.has(edge.fromPort)) ports.set(edge.fromPort, asPort(names2.of(edge.fromPort), true, edge.label, measure));
    for (const edge of entering) if (!ports.has(edge.toPort)) ports.set(edge.toPort, asPort(names2.of(edge.toPort), false, [], measure));
    if (!inner) for (const loose of box2.loose) ports.set(loose.id, asPort(names2.of(loose.id), loose.out, [loose.label], measure, loose.badge ? BADGE : 0));
    const size = inner ?? box2;
    const node = { id: names2.of(box2.id), width: size.width, height: size.height };
    if (inner || box2.kind === "pill") {
      for (const [id, port] of ports) {
        const at = (inner == null ? void 0 : inner.ports.get(ends2.get(id) ?? id)) ?? { x: port.layoutOptions["elk.port.side"] === "WEST" ? 0 : box2.width, y: box2.height / 2 };
        Object.assign(port, { x: at.x, y: at.y });
      }
    }
    return {
      ...node,
      ports: Array.from(ports.values()),
      layoutOptions: {
        "elk.portConstraints": inner || box2.kind === "pill" ? "FIXED_POS" : "FIXED_SIDE",
        "elk.portLabels.placement": "OUTSIDE NEXT_TO_PORT_IF_POSSIBLE",
        "elk.nodeSize.constraints": inner || box2.kind === "pill" ? "" : "PORTS PORT_LABELS MINIMUM_SIZE",
        "elk.nodeSize.minimum": `(${node.width}, ${node.height})`,
        "elk.portAlignment.default": "CENTER"
      }
    };
  }
  function asPort(id, out, label2, measure, more = 0) {
    const width = Math.ceil(Math.max(0, ...label2.map((line4) => measure(line4, "label")))) + more;
    const labels = width ? [{ text: "x", width: width + PADDING.x, height: label2.length * LABEL_HEIGHT + 2 }] : [];
    return { id, width: 0, height: 0, labels, layoutOptions: { "elk.port.side": out ? "EAST" : "WEST" } };
  }
  function labelAt(edges, port) {
    var _a;
    return ((_a = edges.find((edge) => edge.from === port)) == null ? void 0 : _a.label) ?? [];
  }
  function add(map, key, edge) {
    const known6 = map.get(key);
    if (known6) known6.push(edge);
    else map.set(key, [edge]);
  }
  function asPlaced(root) {
    var _a;
    const graph = (
      /** @type {ElkNode} */
      (_a = root.children) == null ? void 0 : _a[0]
    );
    const placed = { width: graph.width ?? 0, height: graph.height ?? 0, boxes: /* @__PURE__ */ new Map(), ports: /* @__PURE__ */ new Map(), labels: /* @__PURE__ */ new Map(), edges: /* @__PURE__ */ new Map() };
    const keep = (port, x, y) => {
      var _a2;
      const at = { x: x + (port.x ?? 0), y: y + (port.y ?? 0) };
      const label2 = (_a2 = port.labels) == null ? void 0 : _a2[0];
      placed.ports.set(port.id, at);
      if (label2) placed.labels.set(port.id, { x: at.x + (label2.x ?? 0), y: at.y + (label2.y ?? 0), width: label2.width, height: label2.height });
    };
    for (const port of graph.ports ?? []) keep(port, 0, 0);
    for (const { id, x = 0, y = 0, width = 0, height = 0, ports = [] } of graph.children ?? []) {
      placed.boxes.set(id, { x, y, width, height });
      for (const port of ports) keep(port, x, y);
    }
    for (const edge of graph.edges ?? []) {
      const points = (edge.sections ?? []).flatMap((section) => [section.startPoint, ...section.bendPoints ?? [], section.endPoint]);
      placed.edges.set(edge.id, { points, junctions: edge.junctionPoints ?? [] });
    }
    return placed;
  }

  // launchlint/report/html/js/drawing/paint.js
  var HIGH = 24;
  function paint(sheet) {
    var _a, _b;
    const content = element("g", { class: "content" });
    const [open, lines, boxes, names2] = ["containers", "lines", "boxes", "names"].map((each) => content.appendChild(element("g", { class: each })));
    const painted = { content, boxes: /* @__PURE__ */ new Map(), lines: /* @__PURE__ */ new Map(), ports: [], loose: [] };
    for (const each of sheet.boxes) {
      const drawn = each.box.kind === "open" ? openElement(each) : boxElement(each);
      painted.boxes.set(each.box.id, drawn);
      (_a = each.box.kind === "open" ? open : boxes) == null ? void 0 : _a.append(drawn);
    }
    for (const each of sheet.edges) {
      const drawn = lineElement(each);
      painted.lines.set(each.edge.id, [drawn]);
      lines == null ? void 0 : lines.append(drawn);
    }
    for (const { x, y, port } of sheet.ports) {
      const drawn = element("rect", { class: `port ${port.kind}`, x: x - 3, y: y - 3, width: 6, height: 6, rx: 1.5 });
      painted.ports.push({ element: drawn, id: port.id });
      boxes == null ? void 0 : boxes.append(drawn);
    }
    for (const { x, y, height, lines: written2, classes, edge } of sheet.labels) {
      const drawn = element("g", { class: `name ${classes.join(" ")}`, "data-id": edge.id });
      written2.forEach((line4, at) => drawn.append(text(line4, { x: x + 5, y: y + height - 4 - (written2.length - 1 - at) * LABEL_HEIGHT })));
      (_b = painted.lines.get(edge.id)) == null ? void 0 : _b.push(drawn);
      names2 == null ? void 0 : names2.append(drawn);
    }
    for (const each of sheet.loose) {
      const drawn = looseElement(each);
      painted.loose.push({ element: drawn, box: each.box.id, wires: each.port.wires.map((wire) => wire.id) });
      names2 == null ? void 0 : names2.append(drawn);
    }
    content.append(element("g", { class: "told-names" }));
    return painted;
  }
  function boxElement({ x, y, width, height, box: box2 }) {
    var _a;
    const drawn = frame(box2, x, y);
    const corner = box2.kind === "pill" ? height / 2 : box2.kind === "folded" ? 8 : 5;
    if (box2.kind === "folded") drawn.append(element("rect", { class: "behind", x: 4, y: 4, width, height, rx: corner }));
    drawn.append(element("rect", { class: "shape", width, height, rx: corner }));
    if (box2.classes.includes("lifecycle")) drawn.append(element("rect", { class: "inner", x: 3, y: 3, width: width - 6, height: height - 6, rx: 3 }));
    if (box2.classes.includes("unknown")) drawn.append(element("rect", { class: "hatched", x: 1, y: 1, width: width - 2, height: height - 2, rx: corner - 1, fill: "url(#ll-hatching)" }));
    if (box2.kind === "pill") drawn.append(text(((_a = box2.lines[0]) == null ? void 0 : _a.text) ?? "", { class: "title", x: width / 2, y: height / 2 + 4, "text-anchor": "middle" }));
    else {
      const block2 = box2.lines.reduce((sum, line4) => sum + LINE_HEIGHTS[line4.kind], 0);
      const above = Math.min((height - block2) / 2, HIGH);
      let baseline = above - 4;
      const indent = box2.kind === "folded" ? FOLD : 0;
      for (const line4 of box2.lines) {
        baseline += LINE_HEIGHTS[line4.kind];
        drawn.append(text(line4.text, { class: line4.kind, x: PADDING.x + indent, y: baseline }));
      }
      if (box2.kind === "folded") drawn.append(fold(box2.id, 8, above + 1, true));
    }
    if (box2.badge) drawn.append(badge(box2.badge, width - 9, 0));
    return drawn;
  }
  function openElement({ x, y, width, height, box: box2 }) {
    var _a, _b;
    const drawn = frame(box2, x, y);
    drawn.append(element("rect", { class: "shape", width, height, rx: box2.classes.includes("include") || box2.classes.includes("group") ? 3 : 10 }));
    const head2 = drawn.appendChild(element("g", { class: "head" }, [element("rect", { width, height: 26, fill: "transparent" })]));
    head2.append(fold(box2.id, 8, 6, false), text(((_a = box2.lines[0]) == null ? void 0 : _a.text) ?? "", { class: "title", x: FOLD + 9, y: 19 }));
    const tag = [(_b = box2.lines[1]) == null ? void 0 : _b.text, tagOf(box2)].filter(Boolean).join(" · ");
    if (tag && width > 220) head2.append(text(tag, { class: "tag", x: width - 10, y: 18, "text-anchor": "end" }));
    if (box2.badge) drawn.append(badge(box2.badge, width - 9, 0));
    return drawn;
  }
  function tagOf(box2) {
    return ["include", "group", "package", "machine"].find((each) => box2.classes.includes(each)) ?? "";
  }
  function frame(box2, x, y) {
    const attributes2 = { class: `box ${box2.classes.join(" ")}`, transform: `translate(${x} ${y})`, "data-id": box2.id, role: "button", tabindex: -1 };
    return element("g", attributes2, [title(box2.title)]);
  }
  function fold(container, x, y, folded) {
    const sign = folded ? "M6 3.5L10 7.5L6 11.5" : "M3.5 6L7.5 10L11.5 6";
    return element("g", { class: "fold", "data-fold": container, transform: `translate(${x} ${y})` }, [
      element("rect", { x: -6, y: -4, width: 24, height: 24 }),
      element("path", { d: sign })
    ]);
  }
  function badge(about, x, y) {
    const sign = about.count > 99 ? "99" : about.count > 1 ? String(about.count) : about.severity === "info" ? "i" : "!";
    const found2 = about.count > 1 ? `${about.count} findings` : `1 ${about.severity}`;
    const words2 = about.elsewhere ? `${found2} elsewhere, about this, too` : found2;
    return element("g", { class: `badge ${about.severity} ${about.elsewhere ? "elsewhere" : ""}`.trim(), transform: `translate(${x} ${y})` }, [title(words2), element("circle", { r: 8.5 }), text(sign, { y: 4.2 })]);
  }
  function lineElement({ edge, points, junctions, arrives }) {
    const bundle = edge.wires.length > 2 ? " bundle" : "";
    const drawn = element("g", { class: `line ${edge.classes.join(" ")}${bundle}`, "data-id": edge.id }, [
      title(edge.wires.slice(0, 40).map((wire) => [wire.name, ...wire.types].join("  ")).join("\n"))
    ]);
    const d = course(points);
    drawn.append(element("path", { class: "hit", d }), element("path", { class: "course", d }));
    const last = points[points.length - 1];
    for (const { x, y } of junctions) {
      const hidden = arrives && last && Math.abs(last.y - y) < 1 && last.x - x < 16;
      if (!hidden) drawn.append(element("circle", { class: "joint", cx: x, cy: y, r: 2.4 }));
    }
    if (arrives && last) drawn.append(head(edge.kind, last.x, last.y));
    return drawn;
  }
  function head(kind, x, y) {
    const shapes = { topic: "M-8 -4L0 0L-8 4Z", service: "M-10 0L-5 -4L0 0L-5 4Z", action: "M-8 -4L0 0L-8 4ZM-14 -4L-6 0L-14 4Z", param: "M-6 -3H0V3H-6Z" };
    return element("path", { class: "head", d: shapes[
      /** @type {keyof typeof shapes} */
      kind
    ] ?? shapes.topic, transform: `translate(${x} ${y})` });
  }
  function missing(wire, out) {
    var _a;
    const does2 = out ? "uses" : "offers";
    const doubtful = (_a = wire.may) == null ? void 0 : _a.some(([offers]) => offers !== (wire.kind === "topic" === out));
    return doubtful ? `nobody known ${does2} it; a node that is not known as a whole may` : `nobody else ${does2} it`;
  }
  function looseElement({ x, y, port, label: label2 }) {
    var _a;
    const drawn = element("g", { class: `loose ${port.classes.join(" ")}`, "data-loose": port.wires.map((wire) => wire.id).join(" ") }, [
      title(port.wires.map((wire) => `${wire.name}: ${missing(wire, port.out)}`).join("\n")),
      element("circle", { cx: x, cy: y, r: 4 })
    ]);
    if (label2) {
      const away = port.badge ? 26 : 9;
      const at = { x: port.out ? x + away : x - away, y: y + 4, "text-anchor": port.out ? "start" : "end" };
      drawn.append(element("g", { class: `name ${((_a = port.badge) == null ? void 0 : _a.severity) ?? ""}` }, [text(port.label, at)]));
    }
    if (port.badge) drawn.append(badge(port.badge, port.out ? x + 15 : x - 15, y));
    return drawn;
  }

  // launchlint/report/html/js/drawing/raster.js
  var MARGIN3 = 16;
  var DENSITY = 2;
  var LARGEST = 12e3;
  function rastered(svg, size) {
    var _a;
    const [width, height] = [size.width + 2 * MARGIN3, size.height + 2 * MARGIN3];
    const density = Math.min(DENSITY, LARGEST / Math.max(width, height));
    const canvas = document.createElement("canvas");
    Object.assign(canvas, { width: Math.ceil(width * density), height: Math.ceil(height * density) });
    const pen = canvas.getContext("2d");
    const content = svg.querySelector(":scope > g");
    if (!pen || !(content instanceof SVGGElement)) return canvas;
    const colours = getComputedStyle(svg);
    pen.fillStyle = colours.getPropertyValue("--ll-ground").trim();
    pen.fillRect(0, 0, canvas.width, canvas.height);
    const hatch = hatching(colours.getPropertyValue("--ll-hatch").trim());
    const screen = (_a = content.getScreenCTM()) == null ? void 0 : _a.inverse();
    const { distance } = svg.dataset;
    delete svg.dataset["distance"];
    for (const each of content.querySelectorAll("rect, circle, path, text")) {
      const style = getComputedStyle(each);
      if (!(each instanceof SVGGraphicsElement) || style.display === "none" || each.matches(".hit, .fold *")) continue;
      const at = each.getScreenCTM();
      if (!at || !screen) continue;
      const { a, b, c, d, e, f } = screen.multiply(at);
      pen.setTransform(new DOMMatrix([density, 0, 0, density, MARGIN3 * density, MARGIN3 * density]).multiply(new DOMMatrix([a, b, c, d, e, f])));
      paint2(pen, each, style, hatch);
    }
    if (distance) svg.dataset["distance"] = distance;
    return canvas;
  }
  function paint2(pen, shape2, style, hatch) {
    const stroke = style.stroke !== "none" && parseFloat(style.strokeWidth) > 0;
    pen.globalAlpha = opacityOf(shape2);
    pen.strokeStyle = stroke ? style.stroke : "transparent";
    pen.lineWidth = parseFloat(style.strokeWidth) || 0;
    pen.lineJoin = "round";
    pen.lineCap = style.strokeLinecap === "round" ? "round" : "butt";
    pen.setLineDash(style.strokeDasharray === "none" ? [] : style.strokeDasharray.split(/[ ,]+/).map(parseFloat));
    const fill2 = style.fill.startsWith("url") ? hatch : style.fill;
    pen.fillStyle = fill2 && fill2 !== "none" ? fill2 : "transparent";
    if (shape2 instanceof SVGTextElement) {
      pen.font = `${style.fontStyle} ${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
      pen.textAlign = style.textAnchor === "middle" ? "center" : style.textAnchor === "end" ? "right" : "left";
      const [x, y] = [numberOf(shape2, "x"), numberOf(shape2, "y")];
      if (stroke) pen.strokeText(shape2.textContent ?? "", x, y);
      pen.fillText(shape2.textContent ?? "", x, y);
      return;
    }
    const outline = outlineOf(shape2);
    const solid = pen.globalAlpha;
    pen.globalAlpha = solid * parseFloat(style.fillOpacity || "1");
    pen.fill(outline);
    pen.globalAlpha = solid;
    if (stroke) pen.stroke(outline);
  }
  function outlineOf(shape2) {
    if (shape2 instanceof SVGPathElement) return new Path2D(shape2.getAttribute("d") ?? "");
    const outline = new Path2D();
    if (shape2 instanceof SVGCircleElement) outline.arc(numberOf(shape2, "cx"), numberOf(shape2, "cy"), numberOf(shape2, "r"), 0, 2 * Math.PI);
    else rounded(outline, numberOf(shape2, "x"), numberOf(shape2, "y"), numberOf(shape2, "width"), numberOf(shape2, "height"), numberOf(shape2, "rx"));
    return outline;
  }
  function rounded(outline, x, y, width, height, radius) {
    const corner = Math.max(0, Math.min(radius, width / 2, height / 2));
    outline.moveTo(x + corner, y);
    outline.arcTo(x + width, y, x + width, y + height, corner);
    outline.arcTo(x + width, y + height, x, y + height, corner);
    outline.arcTo(x, y + height, x, y, corner);
    outline.arcTo(x, y, x + width, y, corner);
    outline.closePath();
  }
  function opacityOf(shape2) {
    let opacity = 1;
    for (let at = (
      /** @type {Element | null} */
      shape2
    ); at && !(at instanceof SVGSVGElement); at = at.parentElement) opacity *= parseFloat(getComputedStyle(at).opacity);
    return opacity;
  }
  function numberOf(shape2, name) {
    return Number(shape2.getAttribute(name) ?? 0);
  }
  function hatching(colour) {
    const tile = document.createElement("canvas");
    Object.assign(tile, { width: 7, height: 7 });
    const pen = tile.getContext("2d");
    if (!pen) return null;
    pen.strokeStyle = colour;
    pen.lineWidth = 1.4;
    pen.stroke(new Path2D("M-1 8L8 -1M-1 1L1 -1M6 8L8 6"));
    return pen.createPattern(tile, "repeat");
  }

  // launchlint/report/html/js/drawing/arrange.js
  var HEAD = 32;
  var GAP = 24;
  var NARROW_GAP = 10;
  var PITCH = 17;
  var TRIALS = 16;
  var NARROWER = 0.75;
  var BROADER = 2.2;
  var STEP = 40;
  async function layOut(engine, level, measure, cache, screen) {
    const { aspect } = screen;
    const alone = level.boxes.filter((box2) => !isTray(box2)).length === 1;
    const within2 = (box2) => ({ ...screen, aspect: form(box2), width: screen.width - 2 * MARGIN2 });
    const form = (box2) => isTray(box2) ? aspect * BROADER : level.group.kind === "root" && !alone ? Math.min(aspect, 1) * NARROWER : aspect;
    const inside = await Promise.all(level.boxes.map((box2) => box2.level ? layOut(engine, box2.level, measure, cache, within2(box2)) : null));
    const all = /* @__PURE__ */ new Map();
    for (const each of inside) each == null ? void 0 : each.forEach((placed, id) => all.set(id, placed));
    const parts3 = connectedParts(level);
    const singles = parts3.filter((part2) => part2.boxes.length === 1 && !part2.edges.length && !part2.ports.length).map((part2) => (
      /** @type {Box} */
      part2.boxes[0]
    ));
    const widths = evenWidths(singles.filter((box2) => !isTray(box2)));
    const blocks = await Promise.all(
      parts3.map((part2) => {
        const [box2] = part2.boxes;
        return box2 && singles.includes(box2) ? single(box2, all.get(box2.id), isTray(box2) ? box2.width : widths.get(box2.kind) ?? 0, measure) : layOutPart(engine, part2, all, measure, cache, screen);
      })
    );
    const least = level.group.kind === "root" ? 0 : measure(level.group.label, "title") + 92;
    const head2 = level.group.kind === "root" ? MARGIN2 : HEAD;
    const shape2 = { head: head2, least, screen, gap: level.group.kind === "tray" || screen.density !== "plain" ? NARROW_GAP : GAP };
    all.set(level.group.id, pack(parts3, blocks, shape2));
    return all;
  }
  function connectedParts(level) {
    var _a;
    const leaders = /* @__PURE__ */ new Map();
    const leader = (id) => {
      let at = id;
      for (let next = leaders.get(at); next !== void 0; next = leaders.get(at)) at = next;
      return at;
    };
    for (const edge of level.edges) {
      const [one2, other] = [leader(edge.fromBox), leader(edge.toBox)];
      if (one2 !== other) leaders.set(one2 === "" ? other : one2, one2 === "" ? one2 : other);
    }
    const parts3 = /* @__PURE__ */ new Map();
    if (level.ports.length) parts3.set("", { group: level.group, boxes: [], ports: level.ports, edges: [] });
    for (const box2 of level.boxes) {
      const key = leader(box2.id);
      const part2 = parts3.get(key);
      if (part2) part2.boxes.push(box2);
      else parts3.set(key, { group: level.group, boxes: [box2], ports: [], edges: [] });
    }
    for (const edge of level.edges) (_a = parts3.get(leader(edge.fromBox))) == null ? void 0 : _a.edges.push(edge);
    return Array.from(parts3.values()).sort((a, b) => rank(a) - rank(b));
  }
  function rank({ ports, edges, boxes }) {
    return ports.length ? 0 : edges.length ? 1 : boxes[0] && isTray(boxes[0]) ? 3 : 2;
  }
  function isTray(box2) {
    return box2.classes.includes("tray");
  }
  function evenWidths(boxes) {
    const widths = /* @__PURE__ */ new Map();
    for (const { kind, level, width } of boxes) if (!level) widths.set(kind, Math.max(widths.get(kind) ?? 0, Math.ceil(width / STEP) * STEP));
    return widths;
  }
  function single(box2, inner, width, measure) {
    const sides2 = [false, true].map((out) => inner ? [] : box2.loose.filter((port) => port.out === out));
    const [left, right] = sides2.map((ports) => Math.max(0, ...ports.map((port) => port.label || port.badge ? Math.ceil(measure(port.label, "label")) + PADDING.x + (port.badge ? BADGE : 0) : 0)));
    const size = { width: (inner == null ? void 0 : inner.width) ?? (box2.kind === "pill" ? box2.width : width), height: Math.max((inner == null ? void 0 : inner.height) ?? box2.height, ...sides2.map((ports) => ports.length * PITCH + 6)) };
    const placed = { width: size.width + (left ?? 0) + (right ?? 0), height: size.height, boxes: /* @__PURE__ */ new Map(), ports: /* @__PURE__ */ new Map(), labels: /* @__PURE__ */ new Map(), edges: /* @__PURE__ */ new Map() };
    placed.boxes.set(box2.id, { x: left ?? 0, y: 0, ...size });
    sides2.forEach(
      (ports, out) => ports.forEach((port, at) => {
        const point = { x: (left ?? 0) + (out ? size.width : 0), y: size.height / 2 + (at - (ports.length - 1) / 2) * PITCH };
        placed.ports.set(port.id, point);
        const extent = (out ? right : left) ?? 0;
        placed.labels.set(port.id, { x: out ? point.x : 0, y: point.y - 7, width: extent, height: 14 });
      })
    );
    return placed;
  }
  function pack(parts3, blocks, shape2) {
    var _a, _b;
    const { head: head2, least, gap } = shape2;
    const spanning = ((_a = parts3[0]) == null ? void 0 : _a.ports.length) ? blocks[0] : void 0;
    const rest = spanning ? blocks.slice(1) : blocks;
    const from = spanning ? head2 + spanning.height + (rest.length ? gap : 0) : head2;
    const rows2 = inRows(rest, spanning ? spanning.width - 2 * MARGIN2 : 0, from, shape2);
    const all = { width: Math.max(least, (spanning == null ? void 0 : spanning.width) ?? 0, rows2.width + 2 * MARGIN2), height: from + rows2.height + MARGIN2, boxes: /* @__PURE__ */ new Map(), ports: /* @__PURE__ */ new Map(), labels: /* @__PURE__ */ new Map(), edges: /* @__PURE__ */ new Map() };
    if (spanning) {
      add2(all, spanning, 0, head2);
      widen(all, ((_b = parts3[0]) == null ? void 0 : _b.ports.filter((port) => port.out).map((port) => port.id)) ?? [], spanning.width);
    }
    rest.forEach((block2, at) => {
      var _a2, _b2;
      return add2(all, block2, MARGIN2 + (((_a2 = rows2.places[at]) == null ? void 0 : _a2.x) ?? 0), from + (((_b2 = rows2.places[at]) == null ? void 0 : _b2.y) ?? 0));
    });
    return all;
  }
  function inRows(blocks, width, above, { screen, gap }) {
    const widest = Math.max(width, ...blocks.map((block2) => block2.width));
    const longest = blocks.reduce((sum, block2) => sum + block2.width + gap, 0);
    let best = shelves(blocks, widest, gap);
    const cost = (rows2) => costOf({ width: rows2.width, height: rows2.height + above }, screen);
    for (let trial = 1; trial <= TRIALS && widest < longest; trial++) {
      const rows2 = shelves(blocks, widest + (longest - widest) * trial * trial / TRIALS ** 2, gap);
      if (cost(rows2) < cost(best)) best = rows2;
    }
    const orders = [blocks, [...blocks].sort((a, b) => b.width - a.width), [...blocks].sort((a, b) => b.height - a.height)];
    for (const order of cost(best) > screen.width / screen.aspect ? orders : []) {
      for (let trial = 0; trial <= TRIALS; trial++) {
        const stacked = raised(order, widest + (longest - widest) * trial * trial / TRIALS ** 2, gap);
        if (cost(stacked) < cost(best)) best = { ...stacked, places: blocks.map((block2) => (
          /** @type {Point} */
          stacked.places[order.indexOf(block2)]
        )) };
      }
      if (cost(best) <= screen.width / screen.aspect) break;
    }
    return best;
  }
  function raised(blocks, most, gap) {
    const places = [];
    let floor = [{ x: 0, width: most, y: 0 }];
    let [width, height] = [0, 0];
    for (const block2 of blocks) {
      let best = { x: 0, y: Infinity };
      for (const { x } of floor) {
        if (x > 0 && x + block2.width > most) break;
        const y = Math.max(...floor.filter((each) => each.x < x + block2.width && each.x + each.width > x).map((each) => each.y));
        if (y < best.y) best = { x, y };
      }
      places.push(best);
      const right = Math.min(most, best.x + block2.width + gap);
      floor = floor.flatMap((each) => {
        const end = each.x + each.width;
        return [
          { ...each, width: Math.min(end, best.x) - each.x },
          { ...each, x: Math.max(each.x, right), width: end - Math.max(each.x, right) }
        ].filter((piece) => piece.width > 0);
      });
      floor.push({ x: best.x, width: right - best.x, y: best.y + block2.height + gap });
      floor.sort((a, b) => a.x - b.x);
      width = Math.max(width, best.x + block2.width);
      height = Math.max(height, best.y + block2.height);
    }
    return { width, height, places };
  }
  function shelves(blocks, most, gap) {
    const places = [];
    const row2 = { y: 0, height: 0 };
    const column = { x: 0, width: 0, bottom: 0 };
    let width = 0;
    for (const block2 of blocks) {
      const first = column.width === 0;
      if (!first && column.bottom + gap + block2.height <= row2.height && block2.width <= Math.max(column.width, 60) * 1.25 && column.x + block2.width <= most) {
        places.push({ x: column.x, y: row2.y + column.bottom + gap });
        column.bottom += gap + block2.height;
        column.width = Math.max(column.width, block2.width);
      } else {
        if (!first) column.x += column.width + gap;
        if (!first && column.x + block2.width > most) {
          row2.y += row2.height + gap;
          row2.height = 0;
          column.x = 0;
        }
        places.push({ x: column.x, y: row2.y });
        column.width = block2.width;
        column.bottom = block2.height;
        row2.height = Math.max(row2.height, block2.height);
      }
      width = Math.max(width, column.x + column.width);
    }
    return { width, height: row2.y + row2.height, places };
  }
  function add2(all, block2, dx, dy) {
    const move = (point) => ({ ...point, x: point.x + dx, y: point.y + dy });
    for (
      const name of
      /** @type {const} */
      ["boxes", "labels"]
    ) block2[name].forEach((area, id) => all[name].set(id, move(area)));
    block2.ports.forEach((point, id) => all.ports.set(id, move(point)));
    block2.edges.forEach(({ points, junctions }, id) => all.edges.set(id, { points: points.map(move), junctions: junctions.map(move) }));
  }
  function widen(all, leaving, border) {
    if (all.width <= border) return;
    for (const id of leaving) {
      const port = all.ports.get(id);
      if (port) port.x = all.width;
    }
    for (const { points } of all.edges.values()) for (const point of points) if (point.x >= border - 0.5) point.x = all.width;
  }

  // launchlint/report/html/js/drawing/expansion.js
  var SPACE = 230 * 120 * 0.65 ** 2;
  var FEWEST = 12;
  var MOST2 = 90;
  function boxesIn(width, height) {
    return Math.max(FEWEST, Math.min(MOST2, Math.floor(width * height / SPACE)));
  }
  function opening(root, most, isShown2 = () => true) {
    const cost = (group3) => group3.nodes.length + group3.groups.length;
    const opened = [];
    let left = most - cost(root);
    let level = root.groups;
    while (level.length) {
      const next = [];
      for (const each of level.filter(isShown2).sort((a, b) => cost(a) - cost(b))) {
        if (cost(each) - 1 > left) continue;
        left -= cost(each) - 1;
        opened.push(each.id);
        next.push(...each.groups);
      }
      level = next;
    }
    return opened;
  }

  // launchlint/report/html/js/drawing/areas.js
  function overlap(a, b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
  }
  function wider({ x, y, width, height }, by) {
    return { x: x - by, y: y - by, width: width + 2 * by, height: height + 2 * by };
  }
  function between2(a, b) {
    return { x: Math.min(a.x, b.x), y: Math.min(a.y, b.y), width: Math.abs(a.x - b.x), height: Math.abs(a.y - b.y) };
  }
  function pieces(points) {
    return points.slice(1).map((point, at) => between2(
      /** @type {Point} */
      points[at],
      point
    ));
  }
  function hull(all) {
    const [x, y] = [Math.min(...all.map((each) => each.x)), Math.min(...all.map((each) => each.y))];
    return { x, y, width: Math.max(...all.map((each) => each.x + each.width)) - x, height: Math.max(...all.map((each) => each.y + each.height)) - y };
  }

  // launchlint/report/html/js/drawing/stretching.js
  var GAP2 = 22;
  var NEAR = 8;
  var STEP2 = 12;
  var [LINE, PIXEL] = [0.4, 0.01];
  var MOST3 = 60;
  function stretched(level, placed, box2, size) {
    const was = (
      /** @type {Area} */
      placed.boxes.get(box2.id)
    );
    if (size.width <= was.width && size.height <= was.height) return { placed, cost: 0 };
    const ways = [pushed, aside("x"), aside("y"), aside("either"), elsewhere].flatMap((way) => way(new Room(level, placed, box2, size)) ?? []);
    return (
      /** @type {Stretched} */
      ways.sort((a, b) => a.cost - b.cost)[0]
    );
  }
  function pushed(room2) {
    const { all, was, box: box2, grown: grown2 } = room2;
    const [right, bottom] = [was.x + was.width, was.y + was.height];
    let count3 = 0;
    const push2 = (point) => {
      const [dx, dy] = [point.x >= right - 0.5 ? grown2.x : 0, point.y >= bottom - 0.5 ? grown2.y : 0];
      point.x += dx;
      point.y += dy;
      return dx + dy > 0;
    };
    all.boxes.forEach((each, id) => {
      if (id !== box2.id && push2(each)) count3 += 1;
    });
    all.ports.forEach(push2);
    all.labels.forEach(push2);
    for (const { points, junctions } of all.edges.values()) [...points, ...junctions].forEach(push2);
    all.width += grown2.x;
    all.height += grown2.y;
    return { placed: all, cost: count3 + PIXEL * (grown2.x + grown2.y) };
  }
  function aside(axis) {
    return (room2) => {
      const { was } = room2;
      let waiting = [{ id: room2.box.id, before: room2.before }];
      for (let next = waiting.shift(); next; next = waiting.shift()) {
        const now = room2.taken(next.id);
        for (const id of room2.inTheWay(next.id, next.before)) {
          const before = room2.taken(id);
          const level = axis === "x" || axis === "either" && before.x >= was.x + was.width;
          const by = GAP2 + (level ? now.x + now.width - before.x : now.y + now.height - before.y);
          if (room2.moved.size >= MOST3 || id === room2.box.id) return null;
          room2.move(id, level ? by : 0, level ? 0 : by);
          waiting = [...waiting, { id, before }];
        }
      }
      return room2.done();
    };
  }
  function elsewhere(room2) {
    const found2 = room2.inTheWay(room2.box.id, room2.before);
    if (found2.length > MOST3) return null;
    for (const id of found2) {
      const from = room2.taken(id);
      const taken = [...room2.others(id).map((area) => wider(area, GAP2 - 1)), ...room2.linesBeside(id).map((area) => wider(area, NEAR))];
      const last = { x: Math.max(MARGIN2, room2.all.width - MARGIN2 - from.width), y: room2.all.height + GAP2 };
      let [best, least] = [
        /** @type {Point | null} */
        null,
        Infinity
      ];
      for (let y = room2.top; y <= last.y; y += STEP2) {
        for (let x = MARGIN2; x <= last.x; x += STEP2) {
          const cost = Math.abs(x - from.x) + Math.abs(y - from.y);
          const area = { ...from, x, y };
          if (cost < least && !taken.some((each) => overlap(each, area))) [best, least] = [{ x, y }, cost];
        }
      }
      if (!best) return null;
      room2.move(id, best.x - from.x, best.y - from.y);
    }
    return room2.done();
  }
  var Room = class {
    /** @param {Level} level @param {Placed} placed @param {Box} box @param {{ width: number, height: number }} size */
    constructor(level, placed, box2, size) {
      var _a, _b;
      this.level = level;
      this.box = box2;
      this.all = copied(placed);
      this.size = { width: placed.width, height: placed.height };
      this.was = { .../** @type {Area} */
      this.all.boxes.get(box2.id) };
      this.grown = { x: Math.max(0, size.width - this.was.width), y: Math.max(0, size.height - this.was.height) };
      this.top = Math.min(...Array.from(this.all.boxes.values(), (area2) => area2.y));
      this.moved = /* @__PURE__ */ new Map();
      this.ports = new Map(level.boxes.map((each) => [each.id, new Set(each.loose.map((port) => port.id))]));
      for (const edge of level.edges) {
        (_a = this.ports.get(edge.fromBox)) == null ? void 0 : _a.add(edge.fromPort);
        (_b = this.ports.get(edge.toBox)) == null ? void 0 : _b.add(edge.toPort);
      }
      const own = [...this.ports.values()].flatMap((each) => [...each]);
      this.fixed = Array.from(this.all.labels).flatMap(([id, area2]) => own.includes(id) ? [] : [area2]);
      this.before = this.taken(box2.id);
      const area = (
        /** @type {Area} */
        this.all.boxes.get(box2.id)
      );
      const right = area.x + area.width;
      area.width += this.grown.x;
      area.height += this.grown.y;
      for (const id of this.ports.get(box2.id) ?? []) {
        for (const each of [this.all.ports.get(id), this.all.labels.get(id)]) if (each && each.x >= right - 0.5) each.x += this.grown.x;
      }
    }
    /** A box with the names at its ports. @param {string} id @returns {Area} */
    taken(id) {
      const names2 = [...this.ports.get(id) ?? []].flatMap((port) => this.all.labels.get(port) ?? []);
      return hull([
        /** @type {Area} */
        this.all.boxes.get(id),
        ...names2
      ]);
    }
    /** What stands beside a box. @param {string} box @returns {Area[]} */
    others(box2) {
      return [...Array.from(this.all.boxes.keys()).flatMap((id) => id === box2 ? [] : this.taken(id)), ...this.fixed];
    }
    /** Boxes that a box reaches where it is now, and did not where it was. @param {string} box @param {Area} before @returns {string[]} */
    inTheWay(box2, before) {
      const [now, then] = [this.taken(box2), before].map((area) => wider(area, NEAR));
      return [...this.all.boxes.keys()].filter((id) => id !== box2 && now && then && overlap(now, this.taken(id)) && !overlap(then, this.taken(id)));
    }
    /** Pieces of lines that end at other boxes. @param {string} box */
    linesBeside(box2) {
      return this.level.edges.filter((edge) => edge.fromBox !== box2 && edge.toBox !== box2).flatMap((edge) => {
        var _a;
        return pieces(((_a = this.all.edges.get(edge.id)) == null ? void 0 : _a.points) ?? []);
      });
    }
    /** @param {string} id @param {number} dx @param {number} dy */
    move(id, dx, dy) {
      const ports = [...this.ports.get(id) ?? []];
      for (const each of [this.all.boxes.get(id), ...ports.flatMap((port) => [this.all.ports.get(port), this.all.labels.get(port)])]) {
        if (!each) continue;
        each.x += dx;
        each.y += dy;
      }
      const known6 = this.moved.get(id) ?? { x: 0, y: 0 };
      this.moved.set(id, { x: known6.x + dx, y: known6.y + dy });
    }
    /** Lines go along with their boxes, or are left out. @returns {Stretched | null} null where something stands in the way still */
    done() {
      const { all } = this;
      const changed = [this.box.id, ...this.moved.keys()];
      if (changed.some((id) => this.others(id).some((area) => overlap(area, this.taken(id))))) return null;
      let lost = 0;
      for (const edge of this.level.edges) {
        const line4 = all.edges.get(edge.id);
        if (!line4) continue;
        const near = this.moved.has(edge.fromBox) ? [...all.boxes.keys()] : changed;
        if (this.follows(edge, line4.points, line4.junctions) && !near.some((id) => this.runsInto(edge, line4.points, id))) continue;
        all.edges.delete(edge.id);
        lost += 1;
      }
      all.width = Math.max(all.width, ...Array.from(all.boxes.keys(), (id) => this.taken(id)).map((area) => area.x + area.width + MARGIN2));
      all.height = Math.max(all.height, ...Array.from(all.boxes.values(), (area) => area.y + area.height + MARGIN2));
      return { placed: all, cost: this.moved.size + LINE * lost + PIXEL * (all.width - this.size.width + all.height - this.size.height) };
    }
    /** Whether a line runs through a box, or through a name at one where it does not end. @param {Edge} edge @param {Point[]} points @param {string} id */
    runsInto(edge, points, id) {
      const isOwn = edge.fromBox === id || edge.toBox === id;
      const area = isOwn ? wider(
        /** @type {Area} */
        this.all.boxes.get(id),
        -1
      ) : wider(this.taken(id), 1);
      return pieces(points).some((piece) => overlap(piece, area));
    }
    /** Whether a line still leads from one of its ends to the other one. @param {Edge} edge @param {Point[]} points @param {Point[]} junctions */
    follows(edge, points, junctions) {
      const still = { x: 0, y: 0 };
      const [from, to] = [this.moved.get(edge.fromBox) ?? still, this.moved.get(edge.toBox) ?? still];
      if (from.x !== to.x || from.y !== to.y) return false;
      for (const point of [...points, ...junctions]) {
        point.x += from.x;
        point.y += from.y;
      }
      const [first, next] = points;
      if (edge.fromBox !== this.box.id || !this.grown.x || !first || !next) return true;
      first.x += this.grown.x;
      return next.x > first.x + NEAR;
    }
  };
  function copied({ width, height, boxes, ports, labels, edges }) {
    const each = (map) => new Map(Array.from(map, ([id, value]) => [id, { ...value }]));
    const lines = Array.from(edges, ([id, { points, junctions }]) => (
      /** @type {const} */
      [id, { points: points.map((point) => ({ ...point })), junctions: junctions.map((point) => ({ ...point })) }]
    ));
    return { width, height, boxes: each(boxes), ports: each(ports), labels: each(labels), edges: new Map(lines) };
  }

  // launchlint/report/html/js/drawing/wayfinder.js
  var STEP3 = 8;
  var BESIDE = 5;
  var STRAIGHT = 9;
  var [TURN, CROSS, ALONG, NAME] = [24, 16, 400, 24];
  var BEYOND = 3;
  function wayBetween(from, to, room2, boxes, names2, lines, net) {
    const start2 = { x: from.x + STRAIGHT, y: from.y };
    const end = { x: to.x - STRAIGHT, y: to.y };
    const [left, right] = [Math.min(BESIDE, start2.x, end.x), Math.max(room2.width - BESIDE, start2.x, end.x)];
    const [top, bottom] = [Math.min(room2.top, start2.y, end.y), Math.max(room2.height, start2.y, end.y) + 4 * STEP3];
    const grid = new Grid(ticks(left, right, [start2.x, end.x, right]), ticks(top, bottom, [start2.y, end.y, bottom]));
    for (const box2 of boxes) grid.mark(grid.blocked, box2.x - BESIDE, box2.y - BESIDE, box2.x + box2.width + BESIDE, box2.y + box2.height + BESIDE);
    for (const name of names2) grid.mark(grid.named, name.x, name.y, name.x + name.width, name.y + name.height);
    for (const line4 of lines) {
      if (line4.net === net) continue;
      line4.points.slice(1).forEach((point, at) => {
        const last = (
          /** @type {Point} */
          line4.points[at]
        );
        const level = Math.abs(point.y - last.y) < 0.5;
        const near = STEP3 / 2 + 1;
        const [x1, x2, y1, y2] = [Math.min(point.x, last.x), Math.max(point.x, last.x), Math.min(point.y, last.y), Math.max(point.y, last.y)];
        grid.mark(level ? grid.level : grid.upright, level ? x1 : x1 - near, level ? y1 - near : y1, level ? x2 : x2 + near, level ? y2 + near : y2);
      });
    }
    const way = grid.search(start2, end, room2.height);
    return straightened2([from, ...way ?? [start2, { x: start2.x, y: bottom }, { x: end.x, y: bottom }, end], to]);
  }
  function ticks(from, to, more) {
    const found2 = new Set(more);
    for (let at = from; at <= to; at += STEP3) found2.add(at);
    return [...found2].sort((a, b) => a - b);
  }
  function straightened2(points) {
    return points.filter((point, at) => {
      const [last, next] = [points[at - 1], points[at + 1]];
      return !last || !next || !(last.x === point.x && point.x === next.x || last.y === point.y && point.y === next.y);
    });
  }
  var Grid = class {
    /** @param {number[]} xs @param {number[]} ys */
    constructor(xs, ys) {
      this.xs = xs;
      this.ys = ys;
      const size = xs.length * ys.length;
      this.blocked = new Uint8Array(size);
      this.named = new Uint8Array(size);
      this.level = new Uint8Array(size);
      this.upright = new Uint8Array(size);
    }
    /** @param {Uint8Array} cells @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
    mark(cells2, x1, y1, x2, y2) {
      for (let y = atLeast(this.ys, y1); y < this.ys.length && /** @type {number} */
      this.ys[y] <= y2; y++) {
        for (let x = atLeast(this.xs, x1); x < this.xs.length && /** @type {number} */
        this.xs[x] <= x2; x++) cells2[y * this.xs.length + x] = 1;
      }
    }
    /**
     * The cheapest way, level at its start; null where there is none.
     * @param {Point} start @param {Point} end @param {number} beyond height from which on it costs more
     * @returns {Point[] | null}
     */
    search(start2, end, beyond) {
      const { xs, ys } = this;
      const columns = xs.length;
      const cell = (point) => ys.indexOf(point.y) * columns + xs.indexOf(point.x);
      const [first, last] = [cell(start2), cell(end)];
      const costs = new Float64Array(2 * columns * ys.length).fill(Infinity);
      const from = new Int32Array(2 * columns * ys.length).fill(-1);
      const done = new Uint8Array(2 * columns * ys.length);
      const open = new Heap();
      costs[2 * first] = 0;
      open.add(2 * first, 0);
      for (let state = open.take(); state !== void 0; state = open.take()) {
        if (done[state]) continue;
        done[state] = 1;
        const at = state >> 1;
        if (at === last) return this.back(from, state);
        const [x, y, isUpright] = [at % columns, Math.floor(at / columns), state & 1];
        for (
          const [dx, dy] of
          /** @type {const} */
          [[1, 0], [-1, 0], [0, 1], [0, -1]]
        ) {
          const [nx, ny] = [x + dx, y + dy];
          if (nx < 0 || ny < 0 || nx >= columns || ny >= ys.length) continue;
          const next = ny * columns + nx;
          if (this.blocked[next] && next !== last) continue;
          const turned = dy !== 0;
          const length = Math.abs(
            /** @type {number} */
            xs[nx] - /** @type {number} */
            xs[x]
          ) + Math.abs(
            /** @type {number} */
            ys[ny] - /** @type {number} */
            ys[y]
          );
          let cost = (
            /** @type {number} */
            costs[state] + length * /** @type {number} */
            (ys[ny] > beyond ? BEYOND : 1)
          );
          if (turned !== Boolean(isUpright)) cost += TURN;
          if ((turned ? this.upright : this.level)[next]) cost += ALONG;
          if ((turned ? this.level : this.upright)[next]) cost += CROSS;
          if (this.named[next]) cost += NAME;
          const key = 2 * next + Number(turned);
          if (cost >= /** @type {number} */
          costs[key]) continue;
          costs[key] = cost;
          from[key] = state;
          open.add(key, cost + Math.abs(
            /** @type {number} */
            xs[nx] - end.x
          ) + Math.abs(
            /** @type {number} */
            ys[ny] - end.y
          ));
        }
      }
      return null;
    }
    /** @param {Int32Array} from @param {number} state */
    back(from, state) {
      const points = [];
      for (let at = state; at >= 0; at = from[at] ?? -1) {
        const cell = at >> 1;
        points.push({ x: this.xs[cell % this.xs.length] ?? 0, y: this.ys[Math.floor(cell / this.xs.length)] ?? 0 });
      }
      return points.reverse();
    }
  };
  function atLeast(all, least) {
    let [low, high] = [0, all.length];
    while (low < high) {
      const middle2 = low + high >> 1;
      if (
        /** @type {number} */
        all[middle2] < least
      ) low = middle2 + 1;
      else high = middle2;
    }
    return low;
  }
  var Heap = class {
    constructor() {
      this.costs = [];
      this.turns = [];
      this.whats = [];
      this.turn = 0;
    }
    /** @param {number} what @param {number} cost */
    add(what, cost) {
      const turn = this.turn++;
      let at = this.costs.length;
      for (; at > 0; ) {
        const above = at - 1 >> 1;
        if (cost >= /** @type {number} */
        this.costs[above]) break;
        this.move(above, at);
        at = above;
      }
      this.put(at, cost, turn, what);
    }
    /** @returns {number | undefined} */
    take() {
      const first = this.whats[0];
      const [cost, turn, what] = [this.costs.pop(), this.turns.pop(), this.whats.pop()];
      const size = this.costs.length;
      if (!size || cost === void 0 || turn === void 0 || what === void 0) return first;
      let at = 0;
      for (let below = 1; below < size; below = 2 * at + 1) {
        if (below + 1 < size && this.before(
          below + 1,
          /** @type {number} */
          this.costs[below],
          /** @type {number} */
          this.turns[below]
        )) below += 1;
        if (!this.before(below, cost, turn)) break;
        this.move(below, at);
        at = below;
      }
      this.put(at, cost, turn, what);
      return first;
    }
    /** @param {number} at @param {number} cost @param {number} turn */
    before(at, cost, turn) {
      const own = (
        /** @type {number} */
        this.costs[at]
      );
      return own < cost || own === cost && /** @type {number} */
      this.turns[at] < turn;
    }
    /** @param {number} from @param {number} to */
    move(from, to) {
      this.put(
        to,
        /** @type {number} */
        this.costs[from],
        /** @type {number} */
        this.turns[from],
        /** @type {number} */
        this.whats[from]
      );
    }
    /** @param {number} at @param {number} cost @param {number} turn @param {number} what */
    put(at, cost, turn, what) {
      this.costs[at] = cost;
      this.turns[at] = turn;
      this.whats[at] = what;
    }
  };

  // launchlint/report/html/js/drawing/growing.js
  var ROOM = 22;
  var AWAY = 64;
  var STEP4 = 12;
  var PITCH2 = 16;
  var FORMS = [{ wide: 2, high: 2 }, { wide: 12, high: 2 }, { wide: 2, high: 12 }];
  async function grown(level, before, ways) {
    const [first] = await forms(level, before, ways);
    return (first == null ? void 0 : first.all) ?? /* @__PURE__ */ new Map();
  }
  async function forms(level, before, ways) {
    var _a, _b;
    const own = ways.standing.get(before.group.id);
    if (!own) return [];
    const inner = /* @__PURE__ */ new Map();
    for (const box2 of level.boxes) {
      if (!box2.level) continue;
      const was = (_a = before.boxes.find((each) => each.id === box2.id)) == null ? void 0 : _a.level;
      inner.set(box2.id, was ? await forms(box2.level, was, ways) : [{ all: await ways.fresh(box2.level), cost: 0 }]);
    }
    const found2 = /* @__PURE__ */ new Map();
    for (const form of FORMS) {
      const growth = new Growth(level, before, own, inner, form, ways.measure);
      const placed = growth.placed(ways.turn);
      growth.inner.set(level.group.id, placed);
      const size = `${placed.width} ${placed.height}`;
      if (placed.width === own.width && placed.height === own.height) return [{ all: growth.inner, cost: growth.cost }];
      if ((((_b = found2.get(size)) == null ? void 0 : _b.cost) ?? Infinity) > growth.cost) found2.set(size, { all: growth.inner, cost: growth.cost });
    }
    return [...found2.values()];
  }
  var Growth = class {
    /** @param {Level} level @param {Level} before @param {Placed} own @param {Map<string, Grown[]>} inner of each open box @param {Form} form @param {Measure} measure */
    constructor(level, before, own, inner, form, measure) {
      this.level = level;
      this.form = form;
      this.measure = measure;
      this.cost = 0;
      this.inner = /* @__PURE__ */ new Map();
      this.head = Math.min(own.height, ...Array.from(own.boxes.values(), (area) => area.y));
      this.all = { width: own.width, height: own.height, boxes: /* @__PURE__ */ new Map(), ports: /* @__PURE__ */ new Map(), labels: /* @__PURE__ */ new Map(), edges: /* @__PURE__ */ new Map() };
      this.keep(before, own);
      for (const [id, grown2] of inner) this.stretch(id, grown2);
    }
    /** What was there stays. @param {Level} before @param {Placed} own */
    keep(before, own) {
      const { all, level } = this;
      const known6 = new Map(before.edges.map((edge) => [edge.id, edge]));
      for (const box2 of level.boxes) {
        const area = own.boxes.get(box2.id);
        if (area) all.boxes.set(box2.id, { ...area });
        for (const { id } of box2.loose) this.take(own, id, id);
      }
      for (const port of level.ports) this.take(own, port.id, port.id);
      for (const edge of level.edges) {
        const was = known6.get(edge.id);
        const line4 = was && own.edges.get(was.id);
        if (!was || !line4) continue;
        all.edges.set(edge.id, { points: line4.points.map((point) => ({ ...point })), junctions: line4.junctions.map((point) => ({ ...point })) });
        this.take(own, was.fromPort, edge.fromPort);
        this.take(own, was.toPort, edge.toPort);
      }
    }
    /** @param {Placed} own @param {string} id @param {string} now */
    take(own, id, now) {
      const [port, label2] = [own.ports.get(id), own.labels.get(id)];
      if (port) this.all.ports.set(now, { ...port });
      if (label2) this.all.labels.set(now, { ...label2 });
    }
    /** Makes room for an open container in the form for which the fewest others move. @param {string} id @param {Grown[]} grown */
    stretch(id, grown2) {
      const box2 = this.level.boxes.find((each) => each.id === id);
      const tried = grown2.map((each) => {
        const size = each.all.get(id);
        const room2 = box2 && size && this.all.boxes.has(id) ? stretched(this.level, this.all, box2, size) : { placed: this.all, cost: 0 };
        return { inside: each.all, placed: room2.placed, cost: each.cost + room2.cost };
      });
      const best = tried.sort((a, b) => a.cost - b.cost)[0];
      if (!best) return;
      this.all = best.placed;
      this.cost += best.cost;
      best.inside.forEach((placed, each) => this.inner.set(each, placed));
    }
    /** @param {(box: Box) => number} turn @returns {Placed} */
    placed(turn) {
      const { all, level } = this;
      const missing2 = level.boxes.filter((box2) => !all.boxes.has(box2.id)).sort((a, b) => turn(a) - turn(b));
      for (const box2 of missing2) this.put(box2);
      for (const box2 of level.boxes) if (!missing2.includes(box2)) this.hollow(box2);
      for (const edge of level.edges) if (!this.holds(edge)) all.edges.delete(edge.id);
      const routed = level.edges.filter((edge) => !all.edges.has(edge.id));
      for (const edge of routed) this.route(edge);
      this.close();
      return all;
    }
    /** Where a line ends: at a port that is there, at an open container where its line passes, at the border, or at a place that is free. @param {Edge} edge @param {boolean} out @param {Point} [towards] @returns {Point} */
    end(edge, out, towards2) {
      var _a, _b;
      const { all } = this;
      const [id, box2, tip] = out ? [edge.fromPort, edge.fromBox, edge.from] : [edge.toPort, edge.toBox, edge.to];
      const area = all.boxes.get(box2);
      const inside = area && ((_a = this.inner.get(box2)) == null ? void 0 : _a.ports.get(tip));
      if (area && inside) return { x: out ? area.x + area.width : area.x, y: area.y + inside.y };
      const known6 = all.ports.get(id);
      if (known6) return known6;
      const side = area ? { x: out ? area.x + area.width : area.x, from: area.y, to: area.y + area.height } : { x: out ? 0 : all.width, from: this.head, to: Math.max(this.head + PITCH2, all.height - MARGIN2) };
      const isPill = ((_b = this.level.boxes.find((each) => each.id === box2)) == null ? void 0 : _b.kind) === "pill";
      const y = isPill ? (side.from + side.to) / 2 : this.free(side, (towards2 == null ? void 0 : towards2.y) ?? (side.from + side.to) / 2);
      const port = { x: side.x, y };
      all.ports.set(id, port);
      return port;
    }
    /** A place at a side that no port has. @param {{ x: number, from: number, to: number }} side @param {number} wanted */
    free({ x, from, to }, wanted) {
      const taken = [...this.all.ports.values(), ...Array.from(this.all.edges.values(), ({ points }) => [points[0], points[points.length - 1]]).flat()];
      const near = taken.flatMap((port) => port && Math.abs(port.x - x) < 1 && port.y >= from && port.y <= to ? [port.y] : []);
      let [best, most] = [(from + to) / 2, -Infinity];
      for (let y = from + 6; y <= to - 6; y += 2) {
        const room2 = Math.min(PITCH2, ...near.map((each) => Math.abs(each - y)));
        const worth = room2 * 100 - Math.abs(y - wanted);
        if (worth > most) [best, most] = [y, worth];
      }
      return best;
    }
    /** Whether a line that was there still ends where it has to. @param {Edge} edge */
    holds(edge) {
      var _a;
      const points = (_a = this.all.edges.get(edge.id)) == null ? void 0 : _a.points;
      const [first, last] = [points == null ? void 0 : points[0], points == null ? void 0 : points[points.length - 1]];
      if (!points || !first || !last) return false;
      const near = (a, b) => Math.abs(a.x - b.x) < 0.5 && Math.abs(a.y - b.y) < 0.5;
      return near(first, this.end(edge, true)) && near(last, this.end(edge, false));
    }
    /** Puts a new box where there is room, and its ports. @param {Box} box */
    put(box2) {
      const { all, level } = this;
      const leaving = level.edges.filter((edge) => edge.fromBox === box2.id);
      const entering = level.edges.filter((edge) => edge.toBox === box2.id);
      const inner = this.inner.get(box2.id);
      const sides2 = [false, true].map((out) => ({
        ids: inner || box2.kind === "pill" ? [] : [.../* @__PURE__ */ new Set([...(out ? leaving : entering).map((edge) => out ? edge.fromPort : edge.toPort), ...box2.loose.filter((port) => port.out === out).map((port) => port.id)])],
        names: new Map([...(out ? leaving : []).map((edge) => (
          /** @type {const} */
          [edge.fromPort, this.nameOf(edge.label)]
        )), ...box2.loose.filter((port) => port.out === out).map((port) => (
          /** @type {const} */
          [port.id, this.nameOf(port.label ? [port.label] : [], port.badge ? BADGE : 0)]
        ))])
      }));
      const [left = 0, right = 0] = sides2.map(({ names: names2 }) => Math.max(0, ...Array.from(names2.values(), (name) => (name == null ? void 0 : name.width) ?? 0)));
      const pitch = ({ names: names2 }) => Math.max(PITCH2, ...Array.from(names2.values(), (name) => ((name == null ? void 0 : name.height) ?? 0) + 2));
      const width = (inner == null ? void 0 : inner.width) ?? box2.width;
      const height = Math.max((inner == null ? void 0 : inner.height) ?? box2.height, ...sides2.map((side) => (side.ids.length + 0.5) * pitch(side)));
      const at = this.placeFor({ width: left + width + right, height }, leaving, entering);
      const area = { x: at.x + left, y: at.y, width, height };
      all.boxes.set(box2.id, area);
      sides2.forEach((side, out) => side.ids.forEach((id, index) => {
        const port = { x: area.x + (out ? width : 0), y: area.y + height / 2 + (index - (side.ids.length - 1) / 2) * pitch(side) };
        all.ports.set(id, port);
        const name = side.names.get(id);
        const isLoose = box2.loose.some((each) => each.id === id);
        if (name) all.labels.set(id, { x: out ? port.x : port.x - name.width, y: port.y - (isLoose ? name.height / 2 : name.height), width: name.width, height: name.height });
      }));
      all.width = Math.max(all.width, at.x + left + width + right + MARGIN2);
      all.height = Math.max(all.height, at.y + height + MARGIN2);
    }
    /** Room for a name. @param {string[]} lines @param {number} [more] @returns {Area | null} */
    nameOf(lines, more = 0) {
      const width = Math.ceil(Math.max(0, ...lines.map((line4) => this.measure(line4, "label")))) + more;
      return width ? { x: 0, y: 0, width: width + PADDING.x, height: Math.max(1, lines.length) * LABEL_HEIGHT + 2 } : null;
    }
    /**
     * The free place that is nearest to where a box belongs: behind what it hears, before what hears it.
     * @param {{ width: number, height: number }} size
     * @param {Edge[]} leaving
     * @param {Edge[]} entering
     * @returns {Point}
     */
    placeFor({ width, height }, leaving, entering) {
      const { all, form } = this;
      const givers = entering.flatMap((edge) => all.boxes.get(edge.fromBox) ?? []);
      const takers = leaving.flatMap((edge) => all.boxes.get(edge.toBox) ?? []);
      const [giver, taker] = [givers[0], takers[0]];
      const wanted = giver ? { x: giver.x + giver.width + AWAY, y: giver.y } : taker ? { x: taker.x - AWAY - width, y: taker.y } : { x: MARGIN2, y: all.height };
      const lines = Array.from(all.edges.values(), ({ points }) => pieces(points)).flat();
      const taken = [...Array.from(all.boxes.values(), (area) => wider(area, ROOM)), ...Array.from(all.labels.values(), (area) => wider(area, 8)), ...lines.map((area) => wider(area, 10))];
      let [best, least] = [{ x: MARGIN2, y: all.height }, Infinity];
      const last = { x: Math.max(MARGIN2, all.width - MARGIN2 - width), y: all.height + ROOM };
      const rows2 = [];
      for (let y = this.head; y <= last.y; y += STEP4) rows2.push({ y, cost: Math.abs(y - wanted.y) + form.high * Math.max(0, y + height + MARGIN2 - all.height) });
      for (const row2 of rows2.sort((a, b) => a.cost - b.cost || a.y - b.y)) {
        if (row2.cost > least) break;
        const beside = taken.filter((area) => area.y < row2.y + height && row2.y < area.y + area.height);
        for (let x = MARGIN2; x <= last.x + STEP4; x += STEP4) {
          const at = { x: Math.min(x, last.x), y: row2.y };
          const cost = row2.cost + Math.abs(at.x - wanted.x) + form.wide * Math.max(0, at.x + width + MARGIN2 - all.width);
          const isNearer = cost < least || cost === least && at.y < best.y;
          if (isNearer && !beside.some((area) => area.x < at.x + width && at.x < area.x + area.width)) [best, least] = [at, cost];
        }
      }
      return best;
    }
    /** Hollow ports that a box did not have. @param {Box} box */
    hollow(box2) {
      const { all } = this;
      const area = all.boxes.get(box2.id);
      if (!area || box2.level) return;
      for (const port of box2.loose) {
        if (all.ports.has(port.id)) continue;
        const x = area.x + (port.out ? area.width : 0);
        const y = this.free({ x, from: area.y, to: area.y + area.height }, area.y + area.height / 2);
        all.ports.set(port.id, { x, y });
      }
    }
    /** @param {Edge} edge */
    route(edge) {
      const { all } = this;
      const roughly2 = all.boxes.get(edge.toBox);
      const from = this.end(edge, true, roughly2 && { x: roughly2.x, y: roughly2.y + roughly2.height / 2 });
      const to = this.end(edge, false, from);
      const net = edge.fromPort;
      const nets = new Map(this.level.edges.map((each) => [each.id, each.fromPort === edge.fromPort || each.toPort === edge.toPort ? net : each.id]));
      const lines = Array.from(all.edges, ([id, { points: points2 }]) => ({ net: nets.get(id) ?? id, points: points2 }));
      const points = wayBetween(from, to, { width: all.width, height: all.height - 8, top: this.head }, [...all.boxes.values()], [...all.labels.values()], lines, net);
      all.height = Math.max(all.height, ...points.map((point) => point.y + MARGIN2));
      all.edges.set(edge.id, { points, junctions: [] });
      const name = edge.fromBox ? this.nameOf(edge.label) : null;
      if (!name || all.labels.has(edge.fromPort)) return;
      const taken = [...all.boxes.values(), ...all.labels.values()];
      const free = [from.y - name.height, from.y].map((y) => ({ ...name, x: from.x, y })).find((area) => !taken.some((each) => overlap(each, area)));
      if (free) all.labels.set(edge.fromPort, free);
    }
    /** Leads what leaves through the border on to where it is now. */
    close() {
      var _a;
      const { all, level } = this;
      for (const { id, out } of level.ports) {
        const port = all.ports.get(id);
        if (!port || !out || port.x >= all.width) continue;
        const was = port.x;
        port.x = all.width;
        for (const edge of level.edges) for (const point of edge.to === id ? ((_a = all.edges.get(edge.id)) == null ? void 0 : _a.points) ?? [] : []) if (Math.abs(point.x - was) < 0.5) point.x = all.width;
      }
    }
  };

  // launchlint/report/html/js/drawing/late.js
  function hasLate(entry) {
    return entry.nodes.some((node) => node.late && !node.absent) || entry.connections.some((each) => each.late);
  }
  function turnOf(entry, box2) {
    var _a;
    return box2.startsWith("n:") && ((_a = entry.nodes[Number(box2.slice(2))]) == null ? void 0 : _a.late) || 0;
  }
  var former = /* @__PURE__ */ new WeakMap();
  function withoutLate(entry) {
    let before = former.get(entry);
    if (!before) {
      const nodes = entry.nodes.map((node) => node.late ? { ...node, absent: (
        /** @type {const} */
        true
      ) } : node);
      before = { ...entry, nodes, connections: entry.connections.filter((each) => {
        var _a;
        return !each.late && !((_a = entry.nodes[each.node]) == null ? void 0 : _a.late);
      }) };
      former.set(entry, before);
    }
    return before;
  }

  // launchlint/report/html/js/drawing/qos.js
  var CLASHES = [["best_effort", "reliable"], ["volatile", "transient_local"]];
  var UNUSUAL = ["best_effort", "transient_local"];
  var says = (qos, word) => qos.split(/[,\s]+/).includes(word);
  function clashOf(offered, asked) {
    return CLASHES.find(([little = "", much = ""]) => says(offered, little) && says(asked, much)) ?? null;
  }
  function clashIn({ kind, givers, takers }) {
    if (kind !== "topic") return null;
    for (const giver of givers) for (const taker of takers) {
      const found2 = clashOf(giver.qos ?? "", taker.qos ?? "");
      if (found2) return found2;
    }
    return null;
  }
  function clashWords(wire) {
    var _a;
    return ((_a = clashIn(wire)) == null ? void 0 : _a.join(" ≠ ")) ?? "";
  }
  function qosLine(wire) {
    const clash = clashWords(wire);
    if (clash) return clash;
    return wire.kind === "topic" ? UNUSUAL.filter((word) => wire.givers.some(({ qos = "" }) => says(qos, word))).join(", ") : "";
  }

  // launchlint/report/html/js/drawing/bundles.js
  var LABEL = 32;
  var BROAD2 = 20;
  var Lines = class {
    /** @param {View} view @param {Level} level */
    constructor(view, level) {
      this.view = view;
      this.level = level;
      this.found = /* @__PURE__ */ new Map();
    }
    /** @param {Wire} wire @param {Tip} from @param {Tip} to */
    add(wire, from, to) {
      const when2 = this.view.presence.both(from.when, to.when);
      const [certain, changed] = [from.certain && to.certain, from.changed || to.changed];
      const key = `e:${from.id}>${to.id}:${wire.kind}:${when2}${certain ? "" : "?"}${changed ? "!" : ""}`;
      const known6 = this.found.get(key);
      if (known6) known6.wires.push(wire);
      else this.found.set(key, { from, to, when: when2, certain, changed, wires: [wire] });
    }
    /**
     * Whether an open container at an end of a line says what it carries: one that it leaves with nothing else, or one that it enters from the border.
     * @param {Tip} from
     * @param {Tip} to
     * @param {Wire[]} wires
     */
    isNamedInside(from, to, wires) {
      const [left, entered] = [from, to].map((tip) => {
        var _a;
        return (_a = this.level.boxes.find((box2) => box2.id === tip.box)) == null ? void 0 : _a.level;
      });
      const port = left == null ? void 0 : left.ports.find((each) => each.id === from.id);
      return port ? port.wires.length === wires.length : from.box === "" && Boolean(entered);
    }
    /** @returns {Edge[]} */
    edges() {
      const { presence, now } = this.view;
      return Array.from(this.found, ([id, { from, to, when: when2, certain, changed, wires }]) => {
        var _a;
        const kind = ((_a = wires[0]) == null ? void 0 : _a.kind) ?? "topic";
        const mark = presence.mark(when2) || (changed ? "changed" : "");
        const classes = [
          /** @type {string} */
          kind
        ];
        if (mark) classes.push(mark);
        if (!certain) classes.push("uncertain");
        if (presence.conditional(when2, now)) classes.push("conditional");
        const badge3 = badgeOf(this.view, wires.flatMap((wire) => wire.findings));
        if (badge3) classes.push(badge3.severity);
        if (wires.some(clashIn)) classes.push("clash");
        const fromPill = from.id.startsWith("w:");
        const isNamed = !fromPill && !(to.id.startsWith("w:") && wires.length === 1) && !this.isNamedInside(from, to, wires);
        return {
          id,
          from: from.id,
          to: to.id,
          fromBox: from.box,
          toBox: to.box,
          kind,
          wires,
          label: isNamed ? labelOf(wires, this.level.group.namespace) : [],
          classes,
          fromPort: "",
          toPort: ""
        };
      });
    }
  };
  function labelOf(wires, namespace) {
    var _a;
    const kind = ((_a = wires[0]) == null ? void 0 : _a.kind) ?? "topic";
    const [only2, more] = wires;
    if (only2 && !more) return [...inLines(shortName(only2.name, namespace, LABEL), BROAD2), ...[qosLine(only2)].filter(Boolean)];
    if (wires.length < BUNDLE) return wires.flatMap((wire) => [shortName(wire.name, namespace, BROAD2), ...[clashWords(wire)].filter(Boolean)]);
    return [counted(wires.length, kind), ...clashesOf(wires, namespace)];
  }
  function clashesOf(wires, namespace) {
    const found2 = /* @__PURE__ */ new Map();
    for (const wire of wires) {
      const words2 = clashWords(wire);
      if (words2) found2.set(words2, [...found2.get(words2) ?? [], wire]);
    }
    return Array.from(found2, ([words2, [first, ...others]]) => `${others.length || !first ? others.length + 1 : shortName(first.name, namespace, BROAD2)}: ${words2}`);
  }
  function nameOnce({ group: group3, boxes, edges }) {
    for (const { id, level } of boxes) {
      for (const port of (level == null ? void 0 : level.ports) ?? []) {
        const own = edges.filter((edge) => edge.fromBox === id && edge.from === port.id && edge.label.length);
        if (new Set(own.map((edge) => edge.fromPort)).size < 2) continue;
        const wires = [...new Set(own.flatMap((edge) => edge.wires))];
        for (const [at, edge] of own.entries()) edge.label = at || wires.length === port.wires.length ? [] : labelOf(wires, group3.namespace);
      }
    }
  }
  var Ports = class {
    /** @param {Level} level */
    constructor(level) {
      this.level = level;
      this.found = /* @__PURE__ */ new Map();
    }
    /** @param {Wire} wire @param {boolean} out @param {Tip[]} all */
    add(wire, out, all) {
      const alike = /* @__PURE__ */ new Map();
      for (const tip of all) {
        const look = `${tip.when}${tip.certain ? "" : "?"}${tip.changed ? "!" : ""}`;
        const known6 = alike.get(look);
        if (known6) known6.push(tip);
        else alike.set(look, [tip]);
      }
      for (const [look, own] of alike) {
        const [first] = own;
        if (!first) continue;
        const key = `${out ? "out" : "in"} ${wire.kind} ${look} ${Array.from(new Set(own.map((tip) => tip.id)), String).sort().join(" ")}`;
        const known6 = this.found.get(key);
        if (known6) known6.port.wires.push(wire);
        else {
          const id = `${this.level.group.id}|${out ? "out" : "in"}|${look}|${wire.id}`;
          const { when: when2, certain, changed } = first;
          this.found.set(key, { port: { id, out, kind: wire.kind, wires: [wire], when: when2, certain, changed }, tips: own });
        }
      }
    }
    /** @param {Lines} lines */
    connect(lines) {
      for (const { port, tips: own } of this.found.values()) {
        this.level.ports.push(port);
        const border = { ...port, box: "" };
        for (const tip of own) for (const wire of port.wires) port.out ? lines.add(wire, tip, border) : lines.add(wire, border, tip);
      }
    }
  };
  var Pills = class {
    /** @param {View} view @param {Level} level @param {Measure} measure @param {Lines} lines */
    constructor(view, level, measure, lines) {
      this.view = view;
      this.level = level;
      this.measure = measure;
      this.lines = lines;
      this.found = /* @__PURE__ */ new Map();
    }
    /** @param {Wire} wire @param {Tip[]} givers @param {Tip[]} takers */
    add(wire, givers, takers) {
      const look = (tip) => `${tip.id} ${tip.when}${tip.certain ? "" : "?"}${tip.changed ? "!" : ""}`;
      const key = `${wire.kind}|${givers.map(look).join()}|${takers.map(look).join()}`;
      const known6 = this.found.get(key);
      if (known6) known6.wires.push(wire);
      else this.found.set(key, { wires: [wire], givers, takers });
    }
    connect() {
      for (const { wires, givers, takers } of this.found.values()) {
        const bundles = wires.length < BUNDLE ? wires.map((wire) => [wire]) : [wires];
        for (const each of bundles) {
          const box2 = pillBox(this.view, each, this.level.group, this.measure);
          this.level.boxes.push(box2);
          const beside = (tip) => ({ ...tip, id: box2.id, box: box2.id });
          for (const wire of each) {
            for (const tip of givers) this.lines.add(wire, tip, beside(tip));
            for (const tip of takers) this.lines.add(wire, beside(tip), tip);
          }
        }
      }
    }
  };

  // launchlint/report/html/js/drawing/joints.js
  function joinLines(edges) {
    const nets = /* @__PURE__ */ new Map();
    const borders = /* @__PURE__ */ new Map();
    for (const edge of edges) {
      const net = netOf(edge);
      const known6 = nets.get(net);
      if (known6) known6.push(edge);
      else nets.set(net, [edge]);
      for (const border of bordersOf(edge)) borders.set(border, (borders.get(border) ?? /* @__PURE__ */ new Set()).add(net));
    }
    for (const [net, own] of nets) {
      const everybody = new Set(own.map((edge) => edge.from)).size * new Set(own.map((edge) => edge.to)).size === own.length;
      const alone = own.every((edge) => bordersOf(edge).every((border) => {
        var _a;
        return ((_a = borders.get(border)) == null ? void 0 : _a.size) === 1;
      }));
      for (const edge of own) {
        const leavesAlone = edge.toBox === "" && !(everybody && alone);
        edge.fromPort = edge.fromBox === "" ? edge.from : `${edge.from}|o|${leavesAlone ? edge.id : net}`;
        edge.toPort = edge.toBox === "" ? edge.to : `${edge.to}|i|${everybody && alone ? net : edge.id}`;
      }
    }
  }
  function netOf({ classes, wires }) {
    return `${classes.join(".")} ${wires.map((wire) => wire.id).join()}`;
  }
  function bordersOf({ from, fromBox, to, toBox }) {
    return [...fromBox === "" ? [from] : [], ...toBox === "" ? [to] : []];
  }

  // launchlint/report/html/js/drawing/levels.js
  function levelsOf(view, open, measure) {
    const chain = chains(view);
    const paths = (node) => chain(view.home.get(node));
    const parts3 = /* @__PURE__ */ new Map();
    for (const wire of view.wires) {
      for (
        const side of
        /** @type {const} */
        ["givers", "takers"]
      ) {
        for (const end of wire[side]) place(wire, side, end, paths(end.node), open, parts3);
      }
    }
    return new Builder(view, open, measure, parts3, chain).level(view.root);
  }
  function chains(view) {
    const known6 = /* @__PURE__ */ new Map([[view.root.id, [view.root]]]);
    const fill2 = (group3, around3) => {
      const own = [...around3, group3];
      known6.set(group3.id, own);
      group3.groups.forEach((each) => fill2(each, own));
    };
    view.root.groups.forEach((each) => fill2(each, [view.root]));
    return (group3) => known6.get((group3 == null ? void 0 : group3.id) ?? "") ?? [];
  }
  function place(wire, side, end, path, open, parts3) {
    var _a;
    for (let depth = 0; depth < path.length; depth++) {
      const own = (
        /** @type {Group} */
        path[depth]
      );
      if (depth && !open.has(own.id)) return;
      const box2 = ((_a = path[depth + 1]) == null ? void 0 : _a.id) ?? `n:${end.node}`;
      let wires = parts3.get(own.id);
      if (!wires) parts3.set(own.id, wires = /* @__PURE__ */ new Map());
      let part2 = wires.get(wire);
      if (!part2) wires.set(wire, part2 = { wire, givers: /* @__PURE__ */ new Map(), takers: /* @__PURE__ */ new Map() });
      const ends2 = part2[side].get(box2);
      if (ends2) ends2.push(end);
      else part2[side].set(box2, [end]);
    }
  }
  var Builder = class {
    /**
     * @param {View} view
     * @param {Set<string>} open
     * @param {Measure} measure
     * @param {Map<string, Map<Wire, Part>>} parts
     * @param {(group: Group | undefined) => Group[]} chain
     */
    constructor(view, open, measure, parts3, chain) {
      this.view = view;
      this.open = open;
      this.measure = measure;
      this.parts = parts3;
      this.chain = chain;
      this.homes = /* @__PURE__ */ new Map();
    }
    /** The innermost container around all ends of a wire. @param {Wire} wire */
    home(wire) {
      if (!this.homes.has(wire)) {
        let common;
        for (const end of [...wire.givers, ...wire.takers]) {
          const path = this.chain(this.view.home.get(end.node));
          if (!common) common = path;
          let same = 0;
          while (same < common.length && common[same] === path[same]) same++;
          common = common.slice(0, same);
        }
        this.homes.set(wire, common == null ? void 0 : common[common.length - 1]);
      }
      return this.homes.get(wire);
    }
    /** @param {Group} group @returns {Level} */
    level(group3) {
      var _a;
      const { view, measure } = this;
      const own = { group: group3, boxes: [], ports: [], edges: [] };
      for (const each of group3.groups) {
        if (!view.counts.get(each.id)) continue;
        const isOpen = this.open.has(each.id) && !view.stubs.has(each.id);
        own.boxes.push(isOpen ? openBox(view, this.level(each)) : foldedBox(view, each, measure));
      }
      const nodes = group3.nodes.filter((node) => view.shown[node]).sort((a, b) => (view.ranks[a] ?? 0) - (view.ranks[b] ?? 0));
      for (const node of nodes) own.boxes.push(nodeBox(view, node, group3, measure));
      const lines = new Lines(view, own);
      const ports = new Ports(own);
      const pills = new Pills(view, own, measure, lines);
      const boxes = new Map(own.boxes.map((box2) => [box2.id, box2]));
      for (const part2 of ((_a = this.parts.get(group3.id)) == null ? void 0 : _a.values()) ?? []) {
        const { wire } = part2;
        const home = this.home(wire);
        if (home !== group3 && this.chain(home).includes(group3)) continue;
        const givers = tips(part2.givers, boxes, wire, true);
        const takers = tips(part2.takers, boxes, wire, false);
        if (group3 !== view.root) {
          for (const out of [true, false]) {
            const outside2 = this.outside(wire, out ? "takers" : "givers", out ? part2.takers : part2.givers);
            const passing = wire.pilled && home !== group3 ? () => true : (tip) => outside2.some((when2) => view.presence.meet(when2, tip.when));
            ports.add(wire, out, (out ? givers : takers).filter(passing));
          }
        }
        if (!wire.pilled) pairs(view, wire, givers, takers, boxes, lines);
        else if (home === group3) {
          const boxOf = (each) => new Set(each.map((tip) => tip.box));
          const [from, to] = [boxOf(givers), boxOf(takers)];
          const plain = !wire.always && (from.size < 2 || to.size < 2) && ![...from].some((box2) => to.has(box2));
          if (plain) pairs(view, wire, givers, takers, boxes, lines);
          else pills.add(wire, givers, takers);
        }
      }
      ports.connect(lines);
      pills.connect();
      own.edges = lines.edges();
      joinLines(own.edges);
      nameOnce(own);
      return own;
    }
    /**
     * When the ends of a wire exist that are not among these.
     * @param {Wire} wire
     * @param {"givers" | "takers"} side
     * @param {Map<string, End[]>} inside
     */
    outside(wire, side, inside) {
      const counts = /* @__PURE__ */ new Map();
      for (const end of wire[side]) counts.set(end.when, (counts.get(end.when) ?? 0) + 1);
      for (const ends2 of inside.values()) for (const end of ends2) counts.set(end.when, (counts.get(end.when) ?? 0) - 1);
      return Array.from(counts).flatMap(([when2, count3]) => count3 > 0 ? [when2] : []);
    }
  };
  function tips(ends2, boxes, wire, out) {
    const found2 = [];
    for (const [id, own] of ends2) {
      const box2 = boxes.get(id);
      if (box2 == null ? void 0 : box2.level) {
        for (const port of box2.level.ports) if (port.out === out && port.wires.includes(wire)) found2.push({ ...port, box: id });
        continue;
      }
      const byTime = /* @__PURE__ */ new Map();
      for (const end of own) {
        const known6 = byTime.get(end.when);
        if (known6) {
          known6.certain ||= end.certain;
          known6.changed ||= end.changed;
        } else byTime.set(end.when, { id, box: id, when: end.when, certain: end.certain, changed: end.changed });
      }
      found2.push(...byTime.values());
    }
    return found2;
  }
  function pairs(view, wire, givers, takers, boxes, lines) {
    var _a;
    for (const from of givers) {
      for (const to of takers) {
        if (from.box === to.box && ((_a = boxes.get(from.box)) == null ? void 0 : _a.kind) !== "node") continue;
        if (view.presence.meet(from.when, to.when)) lines.add(wire, from, to);
      }
    }
  }

  // launchlint/report/html/js/drawing/mask.js
  function masked(whole, view, measure) {
    return new Mask(view, measure).level(whole);
  }
  var Mask = class {
    /** @param {View} view @param {Measure} measure */
    constructor(view, measure) {
      var _a;
      this.view = view;
      this.measure = measure;
      this.wires = new Set(view.wires.map((wire) => wire.id));
      this.ends = /* @__PURE__ */ new Map();
      for (const wire of view.wires) {
        for (const { node } of [...wire.givers, ...wire.takers]) {
          put(this.ends, `n:${node}`, wire.id);
          for (let group3 = view.home.get(node); group3 && !((_a = this.ends.get(group3.id)) == null ? void 0 : _a.has(wire.id)); group3 = view.groups.get(group3.parent)) put(this.ends, group3.id, wire.id);
        }
      }
    }
    /** @param {Level} whole @returns {Level} */
    level(whole) {
      const [kept2] = this.inside(whole);
      return this.used(kept2, null);
    }
    /**
     * A level without what is not shown, and which wires its ports lead to something that is.
     * @param {Level} level
     * @returns {[level: Level, alive: Map<string, Set<string>>]}
     */
    inside(level) {
      const alive = /* @__PURE__ */ new Map();
      const boxes = level.boxes.flatMap((box2) => this.box(box2, alive));
      const there = new Set(boxes.map((box2) => box2.id));
      const leads = (end, box2, wire) => {
        var _a, _b;
        if (box2 === "") return true;
        if (!there.has(box2)) return false;
        if (box2.startsWith("w:")) return true;
        return end === box2 ? Boolean((_a = this.ends.get(box2)) == null ? void 0 : _a.has(wire)) : Boolean((_b = alive.get(end)) == null ? void 0 : _b.has(wire));
      };
      const edges = level.edges.flatMap((edge) => only(edge, ({ id }) => this.wires.has(id) && leads(edge.from, edge.fromBox, id) && leads(edge.to, edge.toBox, id), level));
      const own = /* @__PURE__ */ new Map();
      for (const edge of edges) {
        const port = edge.fromBox === "" ? edge.from : edge.toBox === "" ? edge.to : "";
        if (port) for (const wire of edge.wires) put(own, port, wire.id);
      }
      return [{ ...level, boxes, edges }, own];
    }
    /** @param {Box} box @param {Map<string, Set<string>>} alive gets the ports of an open box @returns {Box[]} */
    box(box2, alive) {
      const { view } = this;
      if (box2.kind === "node") {
        if (!view.shown[Number(box2.id.slice(2))]) return [];
        const known6 = new Set((view.loose.get(Number(box2.id.slice(2))) ?? []).map((each) => each.wire.id));
        const loose = box2.loose.flatMap((port) => {
          const wires = port.wires.filter((wire) => known6.has(wire.id));
          return wires.length ? [wires.length === port.wires.length ? port : { ...port, wires, label: wires.length > 1 ? String(wires.length) : "" }] : [];
        });
        return [{ ...box2, loose }];
      }
      if (box2.kind === "pill") {
        const wires = box2.wires.filter((wire) => this.wires.has(wire.id));
        return wires.length ? [{ ...box2, wires }] : [];
      }
      const group3 = view.groups.get(box2.id);
      if (!group3 || !view.counts.get(box2.id)) return [];
      if (!box2.level) return [foldedBox(view, group3, this.measure)];
      const [level, own] = this.inside(box2.level);
      own.forEach((wires, port) => alive.set(port, wires));
      return [openBox(view, level)];
    }
    /**
     * A level without lines to ports of its border that lead to nothing outside.
     * @param {Level} level
     * @param {Map<string, Set<string>> | null} outside wires by the port; null: it has no border
     * @returns {Level}
     */
    used(level, outside2) {
      const edges = level.edges.flatMap((edge) => {
        const port = edge.fromBox === "" ? edge.from : edge.toBox === "" ? edge.to : "";
        return port && outside2 ? only(edge, ({ id }) => {
          var _a;
          return Boolean((_a = outside2.get(port)) == null ? void 0 : _a.has(id));
        }, level) : [edge];
      });
      const used = /* @__PURE__ */ new Map();
      for (const { from, to, wires } of edges) for (const wire of wires) for (const end of [from, to]) put(used, end, wire.id);
      const ports = level.ports.filter((port) => outside2 == null ? void 0 : outside2.has(port.id));
      const boxes = level.boxes.map((box2) => box2.level ? { ...box2, level: this.used(box2.level, used) } : box2);
      return { ...level, boxes, edges, ports };
    }
  };
  function only(edge, isKept, level) {
    const wires = edge.wires.filter(isKept);
    if (!wires.length || wires.length === edge.wires.length) return wires.length ? [edge] : [];
    return [{ ...edge, wires, label: edge.label.length ? labelOf(wires, level.group.namespace) : [] }];
  }
  function put(map, key, value) {
    const known6 = map.get(key);
    if (known6) known6.add(value);
    else map.set(key, /* @__PURE__ */ new Set([value]));
  }

  // launchlint/report/html/js/drawing/sheet.js
  var HEAD2 = 13;
  function sheetOf(root, placed) {
    const outermost = placed.get(root.group.id);
    const sheet = { width: (outermost == null ? void 0 : outermost.width) ?? 0, height: (outermost == null ? void 0 : outermost.height) ?? 0, boxes: [], edges: [], labels: [], ports: [], loose: [] };
    add4(root, 0, 0, 0);
    return sheet;
    function add4(level, dx, dy, depth) {
      const own = placed.get(level.group.id);
      if (!own) return;
      const move = (point) => ({ ...point, x: point.x + dx, y: point.y + dy });
      const named = /* @__PURE__ */ new Set();
      for (const port of level.ports) {
        const at = own.ports.get(port.id);
        if (at) sheet.ports.push({ ...move(at), port });
      }
      for (const edge of level.edges) {
        const line4 = own.edges.get(edge.id);
        if (!line4) continue;
        const arrives = edge.to === edge.toBox;
        sheet.edges.push({ edge, points: line4.points.map(move), junctions: line4.junctions.map(move), arrives });
        const label2 = own.labels.get(edge.fromPort);
        if (label2 && edge.label.length && !named.has(edge.fromPort)) sheet.labels.push({ ...move(label2), lines: edge.label, classes: edge.classes, edge });
        named.add(edge.fromPort);
      }
      for (const box2 of level.boxes) {
        const area = own.boxes.get(box2.id);
        if (!area) continue;
        sheet.boxes.push({ ...move(area), box: box2, depth });
        for (const port of box2.loose) {
          const at = box2.level ? { x: area.x + (port.out ? area.width : 0), y: area.y + HEAD2 } : own.ports.get(port.id);
          const label2 = own.labels.get(port.id);
          if (at) sheet.loose.push({ ...move(at), port, box: box2, label: label2 ? move(label2) : null });
        }
        if (box2.level) add4(box2.level, dx + area.x, dy + area.y, depth + 1);
      }
    }
  }

  // launchlint/report/html/js/drawing/presence.js
  var Presence = class {
    /** @param {number} configurations how many there are @param {boolean} compared whether two states are */
    constructor(configurations, compared) {
      this.count = BigInt(Math.max(1, configurations));
      this.compared = compared;
      this.sets = [];
      this.numbers = /* @__PURE__ */ new Map();
      this.read = /* @__PURE__ */ new Map();
      this.half = (1n << this.count) - 1n;
      this.whole = this.number(compared ? this.half << this.count | this.half : this.half);
    }
    /**
     * @param {bigint} set
     * @returns {number}
     */
    number(set) {
      let found2 = this.numbers.get(set);
      if (found2 === void 0) {
        found2 = this.sets.length;
        this.sets.push(set);
        this.numbers.set(set, found2);
      }
      return found2;
    }
    /**
     * Of what exists in these configurations (none named: in all) and has this mark.
     * @param {number[]} only
     * @param {Mark | undefined} mark
     * @returns {number}
     */
    of(only2, mark) {
      if (!only2.length && !mark) return this.whole;
      const key = `${only2.join()} ${mark ?? ""}`;
      let found2 = this.read.get(key);
      if (found2 === void 0) {
        let half = only2.length ? 0n : this.half;
        for (const each of only2) if (each >= 0 && BigInt(each) < this.count) half |= 1n << BigInt(each);
        const before = mark === "added" ? 0n : half;
        const after = mark === "removed" ? 0n : half;
        found2 = this.number(this.compared ? before << this.count | after : half);
        this.read.set(key, found2);
      }
      return found2;
    }
    /**
     * The moments of one configuration; of all, where it is negative.
     * @param {number} configuration
     */
    at(configuration) {
      if (configuration < 0 || BigInt(configuration) >= this.count) return this.whole;
      return this.of([configuration], void 0);
    }
    /** @param {number} one @param {number} other @returns {number} */
    both(one2, other) {
      if (one2 === other || other === this.whole) return one2;
      return this.number(this.set(one2) & this.set(other));
    }
    /** @param {number} one @param {number} other @returns {boolean} */
    meet(one2, other) {
      return (one2 === other ? this.set(one2) : this.set(one2) & this.set(other)) !== 0n;
    }
    /** @param {number} one @param {number} other @returns {number} */
    either(one2, other) {
      return one2 === other ? one2 : this.number(this.set(one2) | this.set(other));
    }
    /** @param {number} number */
    set(number2) {
      return this.sets[number2] ?? 0n;
    }
    /**
     * Whether it is there in some configurations only, of those in `within`.
     * @param {number} number
     * @param {number} within
     */
    conditional(number2, within2) {
      const set = this.set(number2);
      const all = this.set(within2);
      const missing2 = all & ~set;
      if (!this.compared) return missing2 !== 0n;
      const [before, after] = [set >> this.count, set & this.half];
      return before !== 0n && missing2 >> this.count !== 0n || after !== 0n && (missing2 & this.half) !== 0n;
    }
    /**
     * What became of it between the two states.
     * @param {number} number
     * @returns {Mark | ""}
     */
    mark(number2) {
      if (!this.compared) return "";
      const set = this.set(number2);
      if (set >> this.count === 0n) return "added";
      return (set & this.half) === 0n ? "removed" : "";
    }
  };

  // launchlint/report/html/js/drawing/filter.js
  var KEYS = /* @__PURE__ */ new Map(
    /** @type {const} */
    [["name", "name"], ["type", "type"], ["package", "package"], ["pkg", "package"]]
  );
  var MOST_TERMS = 16;
  var LONGEST2 = 200;
  function termsOf(text2) {
    return text2.slice(0, LONGEST2).split(/\s+/).filter(Boolean).slice(0, MOST_TERMS).flatMap((word) => {
      const without = word.length > 1 && word.startsWith("-");
      const plain = without ? word.slice(1) : word;
      const colon = plain.indexOf(":");
      const key = KEYS.get(
        /** @type {"name"} */
        plain.slice(0, Math.max(0, colon)).toLowerCase()
      );
      const pattern = key ? plain.slice(colon + 1) : plain;
      return pattern ? [{ without, key: key ?? "name", fits: globbed(pattern.toLowerCase()) }] : [];
    });
  }
  function globbed(pattern) {
    if (!pattern.includes("*")) return (text2) => text2.toLowerCase().includes(pattern);
    const pieces2 = pattern.split("*");
    const [first = "", last = ""] = [pieces2[0], pieces2[pieces2.length - 1]];
    return (text2) => {
      const whole = text2.toLowerCase();
      if (!whole.startsWith(first) || !whole.endsWith(last) || whole.length < first.length + last.length) return false;
      let at = first.length;
      for (const piece of pieces2.slice(1, -1)) {
        const found2 = whole.indexOf(piece, at);
        if (found2 < 0) return false;
        at = found2 + piece.length;
      }
      return at <= whole.length - last.length;
    };
  }
  function fittingNodes(entry, terms) {
    var _a, _b;
    const channels2 = entry.nodes.map(() => /* @__PURE__ */ new Set());
    for (const { node, channel } of entry.connections) if (!((_a = entry.channels[channel]) == null ? void 0 : _a.plumbing)) (_b = channels2[node]) == null ? void 0 : _b.add(channel);
    return Uint8Array.from(entry.nodes, (node, index) => {
      const own = [...channels2[index] ?? []].flatMap((at) => entry.channels[at] ?? []);
      const fits = ({ key, without, fits: is }) => {
        if (key === "package") return is(node.package);
        if (key === "type") return own.some((each) => each.types.some(is));
        return is(node.name) || !without && own.some((each) => !each.hub && is(each.name));
      };
      return Number(terms.every((term) => fits(term) !== term.without));
    });
  }
  function fitsType(terms, types) {
    return terms.every(({ key, without, fits }) => key !== "type" || types.some(fits) !== without);
  }

  // launchlint/report/html/js/drawing/order.js
  var DEEPEST2 = 32;
  var known2 = /* @__PURE__ */ new WeakMap();
  function ranksOf(entry) {
    let ranks = known2.get(entry);
    if (!ranks) {
      const chains2 = entry.nodes.map((node) => chainOf(entry, node.container, node.place));
      const order = entry.nodes.map((_, index) => index).sort((a, b) => compare(chains2[a] ?? [], chains2[b] ?? []) || a - b);
      ranks = new Int32Array(order.length);
      for (const [rank2, node] of order.entries()) ranks[node] = rank2;
      known2.set(entry, ranks);
    }
    return ranks;
  }
  function chainOf(entry, container, place2) {
    var _a, _b;
    const chain = [place2];
    for (let at = container; at >= 0 && chain.length < DEEPEST2; at = ((_a = entry.containers[at]) == null ? void 0 : _a.parent) ?? -1) chain.unshift(((_b = entry.containers[at]) == null ? void 0 : _b.place) ?? null);
    return chain.map((each) => each ?? [0, 0, 0]);
  }
  function compare(one2, other) {
    for (let at = 0; at < one2.length && at < other.length; at++) {
      const [a, b] = [one2[at] ?? [], other[at] ?? []];
      for (let part2 = 0; part2 < 3; part2++) if (a[part2] !== b[part2]) return (a[part2] ?? 0) - (b[part2] ?? 0);
    }
    return one2.length - other.length;
  }

  // launchlint/report/html/js/drawing/tray.js
  var FEWEST2 = 3;
  var known3 = /* @__PURE__ */ new WeakMap();
  var trayId = (grouping) => `g:${grouping}:~tray`;
  function inTray(entry) {
    let found2 = known3.get(entry);
    if (!found2 && hasLate(entry)) {
      const before = inTray(withoutLate(entry));
      const now = before.length ? unconnected(entry) : [];
      found2 = now.filter((node) => {
        var _a;
        return ((_a = entry.nodes[node]) == null ? void 0 : _a.late) || before.includes(node);
      });
      known3.set(entry, found2);
    }
    if (!found2) {
      found2 = unconnected(entry);
      if (found2.length < FEWEST2 || found2.length === entry.nodes.filter((node) => !node.absent).length) found2 = [];
      known3.set(entry, found2);
    }
    return found2;
  }
  function unconnected(entry) {
    var _a;
    const sides2 = entry.channels.map(() => ({ offers: /* @__PURE__ */ new Set(), uses: /* @__PURE__ */ new Set() }));
    for (const { channel, offers, node } of entry.connections) (_a = sides2[channel]) == null ? void 0 : _a[offers ? "offers" : "uses"].add(node);
    const connected = /* @__PURE__ */ new Set();
    sides2.forEach(({ offers, uses }, at) => {
      const { hub = true, plumbing = true } = entry.channels[at] ?? {};
      if (hub || plumbing || !offers.size || !uses.size || offers.size === 1 && uses.size === 1 && offers.has([...uses][0])) return;
      for (const each of [...offers, ...uses]) connected.add(each);
    });
    return entry.nodes.flatMap((node, index) => connected.has(index) || node.mark || node.absent ? [] : [index]);
  }
  function withTray(root, grouping, nodes) {
    const gone = new Set(nodes);
    const without = (group3) => ({ ...group3, groups: group3.groups.map(without), nodes: group3.nodes.filter((each) => !gone.has(each)) });
    const own = without(root);
    own.groups.push(trayOf(grouping, nodes, root.id));
    return own;
  }
  function trayOf(grouping, nodes, parent = "") {
    const label2 = `${nodes.length} nodes without a connection`;
    const title2 = `${label2}: they share no topic, service or action with another node of this launch file, as far as is known`;
    return { id: trayId(grouping), kind: "tray", label: label2, title: title2, namespace: "", container: -1, own: [], groups: [], nodes: [...nodes], count: nodes.length, parent };
  }

  // launchlint/report/html/js/drawing/view.js
  var MANY_READERS = 12;
  function viewOf(data, state) {
    const entry = data.entries[state.entry];
    if (!entry) throw new RangeError(`there is no entry ${state.entry}`);
    const presence = new Presence(entry.configurations.length, data.base !== null);
    const now = presence.at(state.configuration);
    const whole = containersOf(entry, state.grouping);
    const tray = state.focus === null && !state.danglingOnly ? inTray(entry) : [];
    const tree = tray.length ? withTray(whole, state.grouping, tray) : whole;
    const groups = new Map(Array.from(walk(tree), (each) => [each.id, each]));
    const home = /* @__PURE__ */ new Map();
    for (const group3 of groups.values()) for (const node of group3.nodes) home.set(node, group3);
    const exists = Uint8Array.from(entry.nodes, (node) => Number(!node.absent && presence.meet(presence.of(node.only, node.mark), now)));
    const all = wiresOf(entry, state, presence, now, exists);
    const shown2 = Uint8Array.from(exists);
    for (const node of hiddenNodes(state, whole)) shown2[node] = 0;
    if (!state.tray || state.hidden.has(trayId(state.grouping))) for (const node of tray) shown2[node] = 0;
    const loose = looseEnds(all, presence);
    if (state.danglingOnly) shown2.forEach((_, node) => loose.has(node) || (shown2[node] = 0));
    if (state.findingsOnly) keepFindings(entry, all, shown2);
    const terms = termsOf(state.filter);
    if (terms.length) fittingNodes(entry, terms).forEach((fits, node) => fits || (shown2[node] = 0));
    let root = tree;
    const stubs = /* @__PURE__ */ new Set();
    const focus = state.focus === null ? void 0 : groups.get(state.focus);
    if (focus && focus !== tree) {
      keepAround(focus, all, shown2);
      root = surroundings(focus, groups, stubs);
      for (const node of root.nodes) home.set(node, root);
      groups.set(root.id, root);
    }
    const params = state.layers.params ? ownParams(entry, presence, now, shown2) : /* @__PURE__ */ new Map();
    const counts = /* @__PURE__ */ new Map();
    count(root, shown2, counts);
    const wires = state.danglingOnly ? [] : all.filter((wire) => fitsType(terms, wire.types)).map((wire) => within(wire, shown2)).filter((wire) => wire.givers.length + wire.takers.length > 1);
    if (state.topicsAsNodes) {
      wires.length = 0;
      for (const wire of all) {
        const kept2 = within(wire, shown2);
        if (kept2.givers.length + kept2.takers.length > 0) wires.push({ ...kept2, pilled: true, always: true });
      }
      loose.clear();
    }
    const touched = new Set(entry.connections.filter((each) => each.mark).map((each) => each.node));
    return { entry, state, findings: data.findings, presence, now, root, groups, shown: shown2, counts, home, wires, loose, params, stubs, touched, ranks: ranksOf(entry), machines: new Set(entry.nodes.map((node) => node.machine.join(" "))).size };
  }
  function* hiddenNodes({ hidden }, tree) {
    for (const id of hidden) if (id.startsWith("n:")) yield Number(id.slice(2));
    if (hidden.size) {
      for (const group3 of walk(tree)) if (hidden.has(group3.id)) for (const each of walk(group3)) yield* each.nodes;
    }
  }
  function wiresOf(entry, state, presence, now, exists) {
    const layers = { topic: state.layers.topics, service: state.layers.services, action: state.layers.actions };
    const wires = entry.channels.map((channel, index) => {
      if (!layers[channel.kind] || channel.plumbing || channel.hub && !state.hubs) return null;
      const { kind, name, types, findings } = channel;
      const mark = channel.mark ?? "";
      return { id: `c:${index}`, kind, name, types, findings, mark, may: channel.may, givers: [], takers: [], pilled: false, always: false };
    });
    for (const each of entry.connections) {
      const wire = wires[each.channel];
      const node = entry.nodes[each.node];
      if (!wire || !node || !exists[each.node]) continue;
      const when2 = presence.both(presence.both(presence.of(each.only, each.mark), presence.of(node.only, node.mark)), now);
      if (!presence.meet(when2, now)) continue;
      const ends2 = each.offers === (wire.kind === "topic") ? wire.givers : wire.takers;
      const known6 = ends2.find((end) => end.node === each.node);
      if (known6) {
        known6.when = presence.either(known6.when, when2);
        known6.certain ||= each.certain;
      } else ends2.push({ node: each.node, when: when2, certain: each.certain, changed: each.mark === "changed", qos: each.qos });
    }
    const found2 = [];
    for (const wire of wires) {
      if (!wire || !(wire.givers.length + wire.takers.length)) continue;
      const together = moments(wire.givers).every((one2) => moments(wire.takers).every((other) => presence.meet(one2, other)));
      wire.pilled = wire.givers.length > 1 && wire.takers.length > 1 && together;
      found2.push(wire);
    }
    if (state.layers.params) found2.push(...sharedParams(entry, state, presence, now, exists));
    return found2;
  }
  function sharedParams(entry, state, presence, now, exists) {
    const found2 = [];
    entry.params.forEach((param, index) => {
      const when2 = presence.both(presence.of(param.only, param.mark), now);
      const readers = Array.from(new Set(param.readers)).filter((each) => exists[each]);
      if (readers.length < 2 || !presence.meet(when2, now) || readers.length > MANY_READERS && !state.hubs) return;
      const takers = readers.map((node) => ({ node, when: when2, certain: true, changed: param.mark === "changed" }));
      const { name, findings, mark = "" } = param;
      found2.push({ id: `p:${index}`, kind: "param", name, types: [], givers: [], takers, pilled: true, always: true, findings, mark });
    });
    return found2;
  }
  function ownParams(entry, presence, now, shown2) {
    const counts = /* @__PURE__ */ new Map();
    for (const param of entry.params) {
      const reader = param.readers[0];
      if (reader === void 0 || !shown2[reader] || param.readers.some((each) => each !== reader)) continue;
      if (presence.meet(presence.of(param.only, param.mark), now)) counts.set(reader, (counts.get(reader) ?? 0) + 1);
    }
    return counts;
  }
  function looseEnds(wires, presence) {
    const found2 = /* @__PURE__ */ new Map();
    for (const wire of wires) {
      if (wire.kind === "param") continue;
      for (const gives2 of [true, false]) {
        const others = moments(gives2 ? wire.takers : wire.givers);
        for (const end of gives2 ? wire.givers : wire.takers) {
          if (others.some((when2) => presence.meet(when2, end.when))) continue;
          const own = found2.get(end.node);
          const loose = { wire, gives: gives2, certain: end.certain, mark: presence.mark(end.when) || (end.changed ? "changed" : "") };
          if (own) own.push(loose);
          else found2.set(end.node, [loose]);
        }
      }
    }
    return found2;
  }
  function moments(ends2) {
    return Array.from(new Set(ends2.map((end) => end.when)));
  }
  function keepFindings(entry, wires, shown2) {
    const kept2 = /* @__PURE__ */ new Set();
    entry.nodes.forEach((node, index) => node.findings.length && kept2.add(index));
    for (const wire of wires) if (wire.findings.length) for (const end of [...wire.givers, ...wire.takers]) kept2.add(end.node);
    shown2.forEach((_, node) => kept2.has(node) || (shown2[node] = 0));
  }
  function keepAround(focus, wires, shown2) {
    const inside = new Set(Array.from(walk(focus), (each) => each.nodes).flat());
    const kept2 = new Set(inside);
    for (const { givers, takers } of wires) {
      if (givers.some((end) => inside.has(end.node))) for (const end of takers) kept2.add(end.node);
      if (takers.some((end) => inside.has(end.node))) for (const end of givers) kept2.add(end.node);
    }
    shown2.forEach((_, node) => kept2.has(node) || (shown2[node] = 0));
  }
  function surroundings(focus, groups, stubs) {
    const root = { ...focus, id: `${focus.id}~`, kind: "root", namespace: "", groups: [focus], nodes: [], parent: "" };
    let inner = focus;
    for (let around3 = groups.get(inner.parent); around3; around3 = groups.get(inner.parent)) {
      for (const each of around3.groups) {
        if (each === inner) continue;
        root.groups.push(each);
        stubs.add(each.id);
      }
      for (const node of around3.nodes) {
        root.nodes.push(node);
        stubs.add(`n:${node}`);
      }
      inner = around3;
    }
    return root;
  }
  function count(group3, shown2, counts) {
    let total = 0;
    for (const node of group3.nodes) total += shown2[node] ? 1 : 0;
    for (const each of group3.groups) total += count(each, shown2, counts);
    counts.set(group3.id, total);
    return total;
  }
  function within(wire, shown2) {
    const isShown2 = (end) => shown2[end.node] === 1;
    if (wire.givers.every(isShown2) && wire.takers.every(isShown2)) return wire;
    return { ...wire, givers: wire.givers.filter(isShown2), takers: wire.takers.filter(isShown2) };
  }

  // launchlint/report/html/js/drawing/viewport.js
  var LARGEST2 = 3;
  var SMALLEST = 0.04;
  var FIT_LARGEST = 1.6;
  var MARGIN4 = 16;
  var FOOT = 36;
  var LEGIBLE = 9.02 / 12;
  var STILL = 4;
  var STEP5 = 60;
  var READABLE = 0.5;
  function fitting(size, extent) {
    const { width, height } = room(extent);
    return Math.min(width / Math.max(1, size.width), height / Math.max(1, size.height));
  }
  function room({ width, height }) {
    return { width: Math.max(1, width - 2 * MARGIN4), height: Math.max(1, height - 2 * MARGIN4 - FOOT) };
  }
  var Viewport = class {
    /**
     * @param {SVGSVGElement} svg
     * @param {SVGGElement} content
     * @param {(all: boolean) => void} moved somebody moved it, or shows all of it
     */
    constructor(svg, content, moved) {
      this.svg = svg;
      this.tell = moved;
      this.content = content;
      this.place = { x: 0, y: 0, scale: 1 };
      this.size = { width: 1, height: 1 };
      this.touched = false;
      this.frame = 0;
      this.pointers = /* @__PURE__ */ new Map();
      this.moved = 0;
      svg.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
      svg.addEventListener("pointerdown", (event) => this.down(event));
      svg.addEventListener("pointermove", (event) => this.move(event));
      for (
        const end of
        /** @type {const} */
        ["pointerup", "pointercancel"]
      ) svg.addEventListener(end, (event) => this.up(event));
      svg.addEventListener("keydown", (event) => this.key(event));
    }
    /** Whether the pointer was dragged, so that its release is no click. */
    get dragged() {
      return this.moved > STILL;
    }
    get extent() {
      const { clientWidth, clientHeight } = this.svg;
      return { width: clientWidth || 800, height: clientHeight || 600 };
    }
    /** @param {Place} place */
    set(place2) {
      this.place = { ...place2, scale: Math.min(LARGEST2, Math.max(SMALLEST, place2.scale)) };
      this.frame ||= requestAnimationFrame(() => this.apply());
    }
    apply() {
      cancelAnimationFrame(this.frame);
      this.frame = 0;
      const { x, y, scale } = this.place;
      this.content.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)}) scale(${scale.toFixed(4)})`);
      const distance = scale < 0.3 ? "far" : scale < 0.55 ? "middle" : "near";
      if (this.svg.dataset.distance !== distance) this.svg.dataset.distance = distance;
    }
    /** Shows all of the drawing. @param {number} [least] scale below which only a part of it is shown, from its beginning */
    fit(least = 0) {
      const { width, height } = this.extent;
      const scale = Math.max(least, Math.min(FIT_LARGEST, fitting(this.size, this.extent)));
      this.touched = false;
      this.set({ scale, x: Math.max(least && MARGIN4, (width - this.size.width * scale) / 2), y: Math.max(least && MARGIN4, (height - FOOT - this.size.height * scale) / 2) });
      this.apply();
    }
    /** Somebody wants to see all of it. */
    showAll() {
      this.fit();
      this.tell(true);
    }
    /** Shows all of the drawing, or as much of it as can be read. */
    begin() {
      this.fit(fitting(this.size, this.extent) < LEGIBLE ? LEGIBLE : 0);
    }
    /**
     * @param {number} factor
     * @param {number} [x] where on the screen what is there stays
     * @param {number} [y]
     */
    zoom(factor, x = this.extent.width / 2, y = this.extent.height / 2) {
      const { place: place2 } = this;
      const scale = Math.min(LARGEST2, Math.max(SMALLEST, place2.scale * factor));
      const ratio = scale / place2.scale;
      this.touched = true;
      this.set({ scale, x: x - (x - place2.x) * ratio, y: y - (y - place2.y) * ratio });
      this.tell(false);
    }
    /** @param {number} dx @param {number} dy */
    pan(dx, dy) {
      this.touched = true;
      this.set({ ...this.place, x: this.place.x + dx, y: this.place.y + dy });
      this.tell(false);
    }
    /**
     * Brings an area of the drawing into view, at a scale at which it can be read; what can be read already stays where it is.
     * @param {{ x: number, y: number, width: number, height: number }} area
     */
    show(area) {
      const { width, height } = this.extent;
      const { x, y, scale: now } = this.place;
      const [left, top] = [x + area.x * now, y + area.y * now];
      const isSeen = left >= 0 && top >= 0 && left + area.width * now <= width && top + area.height * now <= height;
      if (isSeen && now >= READABLE) return;
      const most = Math.min((width - 2 * MARGIN4) / area.width, (height - 2 * MARGIN4) / area.height);
      const scale = Math.min(Math.max(this.place.scale, 0.7), Math.max(most, SMALLEST));
      this.touched = true;
      this.set({ scale, x: width / 2 - (area.x + area.width / 2) * scale, y: height / 2 - (area.y + area.height / 2) * scale });
      this.apply();
    }
    /** @param {WheelEvent} event */
    wheel(event) {
      event.preventDefault();
      const unit = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
      const [dx, dy] = [event.deltaX * unit, event.deltaY * unit];
      if (!event.ctrlKey && (event.shiftKey || dx !== 0)) {
        this.pan(event.shiftKey && !dx ? -dy : -dx, event.shiftKey ? 0 : -dy);
        return;
      }
      const at = this.svg.getBoundingClientRect();
      this.zoom(Math.exp(-dy * (event.ctrlKey ? 8e-3 : 16e-4)), event.clientX - at.left, event.clientY - at.top);
    }
    /** @param {PointerEvent} event */
    down(event) {
      if (event.button !== 0 && event.button !== 1) return;
      if (!this.pointers.size) this.moved = 0;
      this.pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    }
    /** @param {PointerEvent} event */
    move(event) {
      var _a;
      const last = this.pointers.get(event.pointerId);
      if (!last) return;
      const now = { x: event.clientX, y: event.clientY };
      const other = (_a = Array.from(this.pointers).find(([id]) => id !== event.pointerId)) == null ? void 0 : _a[1];
      this.moved += Math.abs(now.x - last.x) + Math.abs(now.y - last.y);
      if (!this.dragged) {
        this.pointers.set(event.pointerId, now);
        return;
      }
      if (!this.svg.hasPointerCapture(event.pointerId)) {
        this.svg.setPointerCapture(event.pointerId);
        this.svg.classList.add("dragging");
      }
      if (other) {
        const at = this.svg.getBoundingClientRect();
        const [before, after] = [Math.hypot(last.x - other.x, last.y - other.y), Math.hypot(now.x - other.x, now.y - other.y)];
        this.zoom(after / Math.max(1, before), (now.x + other.x) / 2 - at.left, (now.y + other.y) / 2 - at.top);
        this.pan((now.x - last.x) / 2, (now.y - last.y) / 2);
      } else this.pan(now.x - last.x, now.y - last.y);
      this.pointers.set(event.pointerId, now);
    }
    /** @param {PointerEvent} event */
    up(event) {
      this.pointers.delete(event.pointerId);
      if (!this.pointers.size) this.svg.classList.remove("dragging");
    }
    /** @param {KeyboardEvent} event */
    key(event) {
      if (event.altKey || event.ctrlKey || event.metaKey || event.target !== this.svg) return;
      const keys = {
        ArrowLeft: () => this.pan(STEP5, 0),
        ArrowRight: () => this.pan(-STEP5, 0),
        ArrowUp: () => this.pan(0, STEP5),
        ArrowDown: () => this.pan(0, -STEP5),
        "+": () => this.zoom(1.25),
        "=": () => this.zoom(1.25),
        "-": () => this.zoom(0.8),
        0: () => this.showAll()
      };
      const act = Object.hasOwn(keys, event.key) ? keys[event.key] : void 0;
      if (!act) return;
      event.preventDefault();
      act();
    }
  };

  // launchlint/report/html/js/drawing/walk.js
  var Drawn = class {
    /** @param {Level} root */
    constructor(root) {
      this.boxes = /* @__PURE__ */ new Map();
      this.edges = /* @__PURE__ */ new Map();
      this.leaving = /* @__PURE__ */ new Map();
      this.entering = /* @__PURE__ */ new Map();
      this.carrying = /* @__PURE__ */ new Map();
      this.add(root);
    }
    /** @param {Level} level */
    add(level) {
      for (const box2 of level.boxes) {
        this.boxes.set(box2.id, box2);
        if (box2.level) this.add(box2.level);
      }
      for (const edge of level.edges) {
        this.edges.set(edge.id, edge);
        push(this.leaving, edge.from, edge);
        push(this.entering, edge.to, edge);
        for (const wire of edge.wires) push(this.carrying, wire.id, edge);
      }
    }
    /** Whether lines end at it. @param {string} id */
    isEnd(id) {
      var _a;
      const kind = (_a = this.boxes.get(id)) == null ? void 0 : _a.kind;
      return kind === "node" || kind === "folded";
    }
    /**
     * Follows a wire from something that is drawn to where it ends.
     * @param {string} start id of a box or a port
     * @param {string} wire
     * @param {boolean} forward with the data, or against it
     * @param {Set<string>} edges gets the ids of the lines on the way
     * @returns {Set<string>} ids of the boxes reached
     */
    follow(start2, wire, forward, edges) {
      var _a;
      const reached = /* @__PURE__ */ new Set();
      const known6 = /* @__PURE__ */ new Set([start2]);
      const waiting = [start2];
      for (let at = waiting.pop(); at !== void 0; at = waiting.pop()) {
        for (const edge of (forward ? this.leaving : this.entering).get(at) ?? []) {
          if (!edge.wires.some((each) => each.id === wire)) continue;
          edges.add(edge.id);
          const next = forward ? edge.to : edge.from;
          if (((_a = this.boxes.get(next)) == null ? void 0 : _a.kind) === "pill") reached.add(next);
          if (this.isEnd(next)) reached.add(next);
          else if (!known6.has(next)) {
            known6.add(next);
            waiting.push(next);
          }
        }
      }
      return reached;
    }
  };
  function litBy(drawn, view, selection, standsFor) {
    var _a;
    const { kind, id } = selection;
    const chosen = /* @__PURE__ */ new Set();
    const boxes = /* @__PURE__ */ new Set();
    const edges = /* @__PURE__ */ new Set();
    const both2 = (start2, wire) => {
      for (const forward of [true, false]) drawn.follow(start2, wire, forward, edges).forEach((box2) => boxes.add(box2));
    };
    const around3 = (box2, passes = () => true) => {
      boxes.add(box2);
      for (const edge of [...drawn.leaving.get(box2) ?? [], ...drawn.entering.get(box2) ?? []]) {
        for (const wire of edge.wires) if (passes(wire.id)) both2(box2, wire.id);
      }
    };
    if (kind === "edge") {
      const edge = drawn.edges.get(id);
      if (edge) {
        chosen.add(id);
        edges.add(id);
        for (const wire of edge.wires) {
          for (
            const [at, forward] of
            /** @type {const} */
            [[edge.to, true], [edge.from, false]]
          ) {
            if (drawn.boxes.has(at)) boxes.add(at);
            if (!drawn.isEnd(at)) drawn.follow(at, wire.id, forward, edges).forEach((box2) => boxes.add(box2));
          }
        }
      }
    } else if (kind === "channel" || kind === "param") {
      for (const edge of drawn.carrying.get(id) ?? []) {
        edges.add(edge.id);
        for (const end of [edge.from, edge.to]) if (drawn.boxes.has(end)) boxes.add(end);
      }
      for (const [box2, { kind: shape2, wires, loose }] of drawn.boxes) {
        if (shape2 === "pill" && wires.some((wire) => wire.id === id)) chosen.add(box2);
        if (loose.some((port) => port.wires.some((wire) => wire.id === id))) boxes.add(box2);
      }
    } else if (kind === "way") {
      const parts3 = id.split("|");
      for (const each of parts3) {
        const box2 = each.startsWith("n:") ? standsFor(Number(each.slice(2))) : null;
        if (box2) chosen.add(box2);
      }
      const passes = [...chosen];
      for (const wire of parts3.filter((each) => each.startsWith("c:"))) {
        for (const box2 of passes) {
          const lines = /* @__PURE__ */ new Set();
          const ends2 = drawn.follow(box2, wire, true, lines);
          if (passes.some((other) => other !== box2 && ends2.has(other))) lines.forEach((line4) => edges.add(line4));
        }
        if (parts3.length === 2) for (const edge of drawn.carrying.get(wire) ?? []) edges.add(edge.id);
      }
    } else if (kind === "node") {
      const node = Number(id.slice(2));
      const box2 = standsFor(node);
      if (box2) {
        chosen.add(box2);
        const own = new Set(view.wires.filter((wire) => wire.givers.concat(wire.takers).some((end) => end.node === node)).map((wire) => wire.id));
        around3(box2, box2 === id ? void 0 : (wire) => own.has(wire));
      }
    } else {
      const group3 = view.groups.get(id);
      chosen.add(id);
      if (((_a = drawn.boxes.get(id)) == null ? void 0 : _a.kind) === "folded") around3(id);
      else if (group3) {
        for (const each of walk(group3)) for (const inner of [each.id, ...each.nodes.map((node) => `n:${node}`)]) if (drawn.boxes.has(inner)) around3(inner);
      }
    }
    for (const box2 of chosen) if (drawn.boxes.has(box2)) boxes.add(box2);
    return { chosen, boxes, edges };
  }
  function push(map, key, value) {
    const known6 = map.get(key);
    if (known6) known6.push(value);
    else map.set(key, [value]);
  }

  // launchlint/report/html/js/drawing/scene.js
  var TRIALS2 = 4;
  var WIDEST = 2.4;
  var DENSER = (
    /** @type {const} */
    ["dense", "terse"]
  );
  var LINE2 = 14e3;
  var Director = class {
    /** @param {ReportData} data @param {Engine} engine @param {Measure} measure */
    constructor(data, engine, measure) {
      this.data = data;
      this.engine = engine;
      this.measure = measure;
      this.cache = /* @__PURE__ */ new Map();
      this.screen = { aspect: 1, width: Infinity, density: "plain" };
      this.seen = { key: "", place: "", view: (
        /** @type {View | null} */
        null
      ) };
      this.laid = { key: "", view: (
        /** @type {View | null} */
        null
      ) };
      this.former = { key: "", view: (
        /** @type {View | null} */
        null
      ) };
    }
    /**
     * The view without what came late, whose layout is that of the page before; null where nothing did.
     * @param {View} view
     * @returns {View | null}
     */
    before(view) {
      const key = viewKey(view.state);
      if (this.former.key !== key) {
        const entries = this.data.entries.map((entry) => entry === view.entry ? withoutLate(entry) : entry);
        this.former = { key, view: hasLate(view.entry) ? viewOf({ ...this.data, entries }, view.state) : null };
      }
      return this.former.view;
    }
    /**
     * The view whose layout a view is a part of: that of everything which could be switched off, filtered or hidden.
     * @param {View} view
     * @returns {View}
     */
    whole(view) {
      const state = wholeState(view.state);
      const key = viewKey(state);
      if (key === viewKey(view.state)) return view;
      const known6 = this.laid.key === key ? this.laid.view : null;
      const made2 = known6 ?? viewOf(this.data, state);
      this.laid = { key, view: made2 };
      return made2;
    }
    /**
     * The view of a state, made anew only where more than the expansion changed.
     * @param {ViewState} state
     * @param {{ width: number, height: number }} extent
     * @returns {View}
     */
    view(state, extent) {
      const key = viewKey(state);
      const known6 = this.seen.key === key ? this.seen.view : null;
      const view = known6 ? { ...known6, state } : viewOf(this.data, state);
      const place2 = placeKey(state);
      if (this.seen.place !== place2) this.screen = screenOf(extent);
      this.seen = { key, place: place2, view };
      return view;
    }
    /**
     * @param {ViewState} state
     * @param {{ width: number, height: number }} extent of the viewport, in pixels
     * @returns {Promise<Scene>}
     */
    async scene(state, extent) {
      const shown2 = this.view(state, extent);
      const view = this.whole(shown2);
      if (state.expanded !== "auto") return this.stage(view, withFocus(view, state.expanded), shown2);
      return this.stage(view, await this.opened(this.before(view) ?? view, extent), shown2);
    }
    /**
     * The containers that are open at first: as many as leave all names legible.
     * @param {View} view
     * @param {{ width: number, height: number }} extent
     * @returns {Promise<Set<string>>}
     */
    async opened(view, extent) {
      const changed = this.data.base === null ? null : changedGroups(view);
      const mayOpen = (group3) => Boolean(view.counts.get(group3.id)) && !view.stubs.has(group3.id) && (!(changed == null ? void 0 : changed.size) || changed.has(group3.id));
      const order = opening(view.root, (changed == null ? void 0 : changed.size) ? MOST2 : boxesIn(extent.width, extent.height), mayOpen);
      if (view.state.focus !== null && !order.includes(view.state.focus)) order.unshift(view.state.focus);
      if (changed == null ? void 0 : changed.size) return withFocus(view, order);
      return (await this.legible(view, order, extent)).open;
    }
    /**
     * What was guessed is measured: the longest start of the order is looked for that can be read.
     * @param {View} view
     * @param {string[]} order
     * @param {{ width: number, height: number }} extent
     * @returns {Promise<Scene>}
     */
    async legible(view, order, extent) {
      const isLegible = (tried) => fitting(tried.sheet, extent) >= LEGIBLE;
      const trial = async (ids) => {
        const open2 = withFocus(view, ids);
        const whole = this.levels(view, open2);
        if (roomOf(whole) > roomIn(extent)) return null;
        const tried = await this.stage(view, open2, view, whole);
        return isLegible(tried) ? tried : null;
      };
      let scene = await this.stage(view, withFocus(view, []));
      if (this.screen.density !== "plain") return scene;
      for (const density of isLegible(scene) ? [] : DENSER) {
        this.screen = { ...this.screen, density };
        scene = await this.stage(view, withFocus(view, []));
        if (density === "terse" || isLegible(scene)) return scene;
      }
      if (!order.length) return scene;
      const everything = await trial(order);
      if (everything) return everything;
      let [fits, tooMany] = [0, order.length];
      for (let count3 = 0; count3 < TRIALS2 && tooMany - fits > 1; count3++) {
        const middle2 = Math.floor((fits + tooMany) / 2);
        const tried = await trial(order.slice(0, middle2));
        if (tried) [fits, scene] = [middle2, tried];
        else tooMany = middle2;
      }
      const open = new Set(scene.open);
      const rest = order.slice(tooMany).filter((id) => {
        var _a;
        return open.has(((_a = view.groups.get(id)) == null ? void 0 : _a.parent) ?? "") || view.root.groups.some((each) => each.id === id);
      });
      for (const id of rest.slice(0, TRIALS2)) {
        const tried = await trial([...open, id]);
        if (!tried) continue;
        open.add(id);
        scene = tried;
      }
      return scene;
    }
    /** @param {View} view @param {Set<string>} open @returns {Level} */
    levels(view, open) {
      return levelsOf(this.screen.density === "terse" ? { ...view, terse: true } : view, open, this.measure);
    }
    /** @param {View} view @param {Level} whole @param {Set<string>} open @returns {Promise<Map<string, Placed>>} */
    async laidOut(view, whole, open) {
      const fresh = (level) => layOut(this.engine, level, this.measure, this.cache, this.screen);
      const former2 = this.before(view);
      if (!former2) return fresh(whole);
      const before = this.levels(former2, open);
      const turn = (box2) => turnOf(view.entry, box2.id);
      return grown(whole, before, { standing: await fresh(before), fresh, turn, measure: this.measure });
    }
    /**
     * @param {View} view that is laid out
     * @param {Set<string>} open
     * @param {View} [shown] what of it is seen
     * @param {Level} [whole] what is in it
     * @returns {Promise<Scene>}
     */
    async stage(view, open, shown2 = view, whole = this.levels(view, open)) {
      const placed = await this.laidOut(view, whole, open);
      const root = shown2 === view ? whole : masked(whole, shown2, this.measure);
      return { view: shown2, open, root, sheet: sheetOf(root, placed), drawn: new Drawn(root) };
    }
  };
  function roomOf({ boxes, edges }) {
    return edges.length * LINE2 + boxes.reduce((sum, { level, width, height }) => sum + (level ? roomOf(level) : width * height), 0);
  }
  function roomIn(extent) {
    const { width, height } = room(extent);
    return width * height / LEGIBLE ** 2;
  }
  function screenOf(extent) {
    const { width, height } = room(extent);
    return { aspect: Math.min(WIDEST, Math.max(1 / WIDEST, width / height)), width: width / LEGIBLE, density: "plain" };
  }
  function wholeState(state) {
    return { ...state, layers: { topics: true, services: true, actions: true, params: state.layers.params }, findingsOnly: false, tray: true, hidden: /* @__PURE__ */ new Set(), filter: "" };
  }
  function placeKey(state) {
    return viewKey(wholeState(state));
  }
  function viewKey({ entry, configuration, grouping, focus, layers, topicsAsNodes, hubs, danglingOnly, findingsOnly, tray, hidden, filter }) {
    const { topics, services, actions, params } = layers;
    return JSON.stringify([entry, configuration, grouping, focus, topics, services, actions, params, topicsAsNodes, hubs, danglingOnly, findingsOnly, tray, [...hidden].sort(), filter]);
  }
  function changedGroups({ entry, groups, home, touched }) {
    const nodes = new Set(touched);
    entry.nodes.forEach((node, index) => node.mark && nodes.add(index));
    const found2 = /* @__PURE__ */ new Set();
    for (const node of nodes) {
      for (let group3 = home.get(node); group3 && !found2.has(group3.id); group3 = groups.get(group3.parent)) found2.add(group3.id);
    }
    return found2;
  }
  function withFocus(view, ids) {
    const open = new Set(Array.from(ids).filter((id) => view.groups.has(id)));
    if (view.state.focus !== null && view.groups.has(view.state.focus)) open.add(view.state.focus);
    return open;
  }

  // launchlint/report/html/js/drawing/told.js
  var MOST4 = 6;
  var LONGEST3 = 34;
  var HEIGHT = 14;
  function toldNames(scene, selection, chosen) {
    var _a;
    const { sheet, view } = scene;
    const found2 = [];
    const namespace = ((_a = view.groups.get(selection.id)) == null ? void 0 : _a.namespace) ?? "";
    for (const each of sheet.loose) {
      if (chosen.has(each.box.id) && !/[^0-9]/.test(each.port.label)) found2.push(names(each, each.port.out, each.port.wires, namespace, "hollow"));
    }
    if (selection.kind === "container") {
      for (const each of sheet.ports) if (each.port.id.startsWith(`${selection.id}|`)) found2.push(names(each, each.port.out, each.port.wires, namespace, "joined"));
    }
    return found2;
  }
  function names(at, out, wires, namespace, kind) {
    const said2 = wires.slice(0, MOST4).map((wire) => shortName(wire.name, namespace, LONGEST3));
    if (wires.length > MOST4) said2.push(`and ${wires.length - MOST4} more`);
    const top = at.y + 4 - (said2.length - 1) * HEIGHT / 2;
    const drawn = element("g", { class: `told ${kind}` });
    said2.forEach((line4, index) => drawn.append(text(line4, { x: out ? at.x + 9 : at.x - 9, y: top + index * HEIGHT, "text-anchor": out ? "start" : "end" })));
    return drawn;
  }

  // launchlint/report/html/js/drawing/surface.js
  var GLIDE = 220;
  var PAUSE = 250;
  var PATIENCE = 150;
  function shown() {
    return new Promise((done) => {
      requestAnimationFrame(() => setTimeout(done));
      setTimeout(done, PATIENCE);
    });
  }
  var Surface = class {
    /** @param {ReportData} data @param {HTMLElement} host @param {DrawingEvents} events */
    constructor(data, host2, events) {
      var _a;
      this.host = host2;
      this.events = events;
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(drawing_default);
      document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
      host2.classList.add("ll-drawing-host");
      const ELK = (
        /** @type {{ ELK?: new () => Engine }} */
        globalThis.ELK
      );
      if (!ELK) throw new Error("elk.js is not loaded");
      this.director = new Director(data, new ELK(), measurer());
      this.svgElement = element("svg", { class: "ll-drawing", tabindex: 0, role: "group", "aria-label": "Connection graph" }, [hatching2()]);
      this.content = this.svgElement.appendChild(element("g"));
      this.legend = document.createElement("details");
      this.legend.className = "ll-legend";
      this.legend.append(document.createElement("summary"));
      (_a = this.legend.firstElementChild) == null ? void 0 : _a.append("Legend");
      host2.replaceChildren(this.svgElement, this.legend);
      this.pause = 0;
      this.viewport = new Viewport(this.svgElement, this.content, (all) => {
        clearTimeout(this.pause);
        if (all) this.events.moved(null);
        else this.pause = window.setTimeout(() => this.events.moved(this.spot()), PAUSE);
      });
      this.scene = null;
      this.painted = null;
      this.open = /* @__PURE__ */ new Set();
      this.selection = null;
      this.turn = 0;
      this.slow = false;
      this.shownKey = "";
      this.svgElement.addEventListener("click", (event) => this.click(event));
      this.svgElement.addEventListener("dblclick", (event) => this.doubleClick(event));
      new ResizeObserver(() => this.viewport.touched || this.viewport.begin()).observe(host2);
    }
    /** @param {ViewState} state */
    async show(state) {
      const turn = ++this.turn;
      const key = keyOf(state);
      const same = key.all === this.shownKey;
      this.events.busy(true);
      this.host.classList.toggle("waiting", !same && this.slow);
      const sign = window.setTimeout(() => turn === this.turn && this.host.classList.add("waiting"), PATIENCE);
      if (!same && this.slow) await shown();
      try {
        const scene = same && this.scene ? this.scene : await this.made(state);
        if (turn !== this.turn) return;
        scene.view.state = state;
        const before = this.scene;
        if (!same || !before) {
          this.scene = scene;
          this.put(scene, before && isAlike(before.view.state, state) ? before : null);
        }
        this.shownKey = key.all;
        this.match(state.matches);
        this.select(this.selection);
      } finally {
        clearTimeout(sign);
        if (turn === this.turn) {
          this.host.classList.remove("waiting");
          this.events.busy(false);
        }
      }
    }
    /** @param {ViewState} state */
    async made(state) {
      const begun = performance.now();
      const scene = await this.director.scene(state, this.viewport.extent);
      this.slow = performance.now() - begun > PATIENCE;
      return scene;
    }
    /** @param {Scene} scene @param {Scene | null} before the one whose place on the screen is kept */
    put(scene, before) {
      const painted = paint(scene.sheet);
      this.content.replaceChildren(painted.content);
      this.painted = painted;
      const previous = this.open;
      this.open = scene.open;
      this.viewport.size = { width: scene.sheet.width, height: scene.sheet.height };
      if (before) this.hold(before, scene, previous);
      else this.viewport.begin();
      showLegend(scene.sheet, this.legend);
    }
    /** Keeps what was opened or folded where it is on the screen, and lets the boxes glide. @param {Scene} before @param {Scene} after @param {Set<string>} previous */
    hold(before, after, previous) {
      var _a, _b, _c;
      const [old, now] = [areas(before), areas(after)];
      const toggled2 = [...after.open, ...previous].find((id) => after.open.has(id) !== previous.has(id) && old.has(id) && now.has(id));
      const anchor = toggled2 ?? [...old.keys()].find((id) => now.has(id));
      const [from, to] = [old.get(anchor ?? ""), now.get(anchor ?? "")];
      if (!from || !to) {
        this.viewport.begin();
        return;
      }
      const { place: place2 } = this.viewport;
      const shift = { x: from.x - to.x, y: from.y - to.y };
      this.viewport.set({ ...place2, x: place2.x + shift.x * place2.scale, y: place2.y + shift.y * place2.scale });
      this.viewport.apply();
      if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
      for (const [id, drawn] of ((_a = this.painted) == null ? void 0 : _a.boxes) ?? []) {
        const [start2, end] = [old.get(id), now.get(id)];
        if (!end) continue;
        const target2 = `translate(${end.x}px, ${end.y}px)`;
        if (!start2) drawn.animate([{ opacity: 0 }, { opacity: 1 }], { duration: GLIDE });
        else if (Math.abs(start2.x - end.x - shift.x) + Math.abs(start2.y - end.y - shift.y) > 1) {
          drawn.animate([{ transform: `translate(${start2.x - shift.x}px, ${start2.y - shift.y}px)` }, { transform: target2 }], { duration: GLIDE, easing: "ease-out" });
        }
      }
      for (const name of ["lines", "names"]) (_c = (_b = this.painted) == null ? void 0 : _b.content.querySelector(`.${name}`)) == null ? void 0 : _c.animate([{ opacity: 0 }, { opacity: 1 }], { duration: GLIDE });
    }
    /** @param {Set<string> | null} matches */
    match(matches) {
      var _a, _b, _c, _d;
      this.svgElement.classList.toggle("searching", matches !== null);
      const found2 = new Set(matches);
      for (const id of matches ?? []) if (id.startsWith("n:")) found2.add(this.standsFor(Number(id.slice(2))) ?? "");
      for (const [id, drawn] of ((_a = this.painted) == null ? void 0 : _a.boxes) ?? []) {
        const wires = ((_c = (_b = this.scene) == null ? void 0 : _b.drawn.boxes.get(id)) == null ? void 0 : _c.wires) ?? [];
        drawn.classList.toggle("match", found2.has(id) || wires.some((wire) => found2.has(wire.id)));
      }
      for (const each of ((_d = this.painted) == null ? void 0 : _d.loose) ?? []) each.element.classList.toggle("match", each.wires.some((wire) => found2.has(wire)));
    }
    /** @param {Selection | null} selection */
    select(selection) {
      var _a;
      this.selection = selection;
      const { scene, painted } = this;
      if (!scene || !painted) return;
      const lit = selection && litBy(scene.drawn, scene.view, selection, (node) => this.standsFor(node));
      const any = Boolean(lit && lit.boxes.size + lit.edges.size);
      this.svgElement.classList.toggle("selecting", any);
      const ports = /* @__PURE__ */ new Set();
      for (const [id, drawn] of painted.boxes) {
        drawn.classList.toggle("lit", any && (lit == null ? void 0 : lit.boxes.has(id)));
        drawn.classList.toggle("chosen", any && (lit == null ? void 0 : lit.chosen.has(id)));
      }
      for (const [id, drawn] of painted.lines) {
        const isLit = any && Boolean(lit == null ? void 0 : lit.edges.has(id));
        for (const each of drawn) {
          each.classList.toggle("lit", isLit);
          each.classList.toggle("chosen", any && Boolean(lit == null ? void 0 : lit.chosen.has(id)));
        }
        const edge = isLit ? scene.drawn.edges.get(id) : void 0;
        if (edge) ports.add(edge.from).add(edge.to);
      }
      for (const each of painted.ports) {
        each.element.classList.toggle("lit", ports.has(each.id));
        each.element.classList.toggle("own", (selection == null ? void 0 : selection.kind) === "container" && each.id.startsWith(`${selection.id}|`));
      }
      (_a = painted.content.querySelector(".told-names")) == null ? void 0 : _a.replaceChildren(...selection && lit && any ? toldNames(scene, selection, lit.chosen) : []);
      const wire = (selection == null ? void 0 : selection.kind) === "channel" ? selection.id : "";
      for (const each of painted.loose) each.element.classList.toggle("lit", wire ? each.wires.includes(wire) : Boolean(lit == null ? void 0 : lit.chosen.has(each.box)));
    }
    /** @param {Selection} selection */
    panTo(selection) {
      const { scene } = this;
      const lit = scene && litBy(scene.drawn, scene.view, selection, (node) => this.standsFor(node));
      if (!scene || !lit) return;
      const wanted = lit.chosen.size ? lit.chosen : lit.boxes;
      const found2 = scene.sheet.boxes.filter((each) => wanted.has(each.box.id));
      const edges = scene.sheet.edges.filter((each) => lit.chosen.has(each.edge.id)).flatMap((each) => each.points.map((point) => ({ ...point, width: 0, height: 0 })));
      const area = around([...found2, ...edges]);
      if (area) this.viewport.show(area);
    }
    /** The middle of the screen, told by the box that is nearest to it. @returns {import("./types").Spot | null} */
    spot() {
      var _a;
      const { place: place2, extent } = this.viewport;
      const [x, y] = [(extent.width / 2 - place2.x) / place2.scale, (extent.height / 2 - place2.y) / place2.scale];
      let [nearest2, least] = [
        /** @type {Scene["sheet"]["boxes"][number] | null} */
        null,
        Infinity
      ];
      for (const each of ((_a = this.scene) == null ? void 0 : _a.sheet.boxes) ?? []) {
        const distance = Math.hypot(each.x + each.width / 2 - x, each.y + each.height / 2 - y);
        if (each.box.kind !== "pill" && distance < least) [nearest2, least] = [each, distance];
      }
      return nearest2 && { id: nearest2.box.id, x: x - nearest2.x, y: y - nearest2.y, scale: place2.scale };
    }
    /** @param {import("./types").Spot} spot */
    goTo({ id, x, y, scale }) {
      var _a;
      const found2 = (_a = this.scene) == null ? void 0 : _a.sheet.boxes.find((each) => each.box.id === id);
      if (!found2) return false;
      const { width, height } = this.viewport.extent;
      this.viewport.touched = true;
      this.viewport.set({ scale, x: width / 2 - (found2.x + x) * scale, y: height / 2 - (found2.y + y) * scale });
      this.viewport.apply();
      return true;
    }
    /** @returns {import("./types").Extent} */
    extent() {
      const { scene, viewport } = this;
      const { place: place2, extent } = viewport;
      const found2 = { folded: 0, boxes: 0, outside: 0 };
      for (const { box: box2, x, y, width, height } of (scene == null ? void 0 : scene.sheet.boxes) ?? []) {
        if (box2.kind === "folded") {
          found2.boxes += 1;
          found2.folded += (scene == null ? void 0 : scene.view.counts.get(box2.id)) ?? 0;
        }
        const [left, top] = [place2.x + x * place2.scale, place2.y + y * place2.scale];
        const isSeen = left > -1 && top > -1 && left + width * place2.scale < extent.width + 1 && top + height * place2.scale < extent.height + 1;
        if (!isSeen && box2.kind !== "open") found2.outside += 1;
      }
      return found2;
    }
    /** @param {number} node @returns {string | null} */
    standsFor(node) {
      var _a;
      const { scene } = this;
      if (!scene || !scene.view.shown[node]) return null;
      const own = `n:${node}`;
      if (scene.drawn.boxes.has(own)) return own;
      let found2 = null;
      for (let group3 = scene.view.home.get(node); group3; group3 = scene.view.groups.get(group3.parent)) {
        if (((_a = scene.drawn.boxes.get(group3.id)) == null ? void 0 : _a.kind) === "folded") found2 = group3.id;
      }
      return found2;
    }
    /** @param {Selection} selection */
    isDrawn({ kind, id }) {
      const { scene } = this;
      if (!scene) return false;
      if (kind === "edge") return scene.drawn.edges.has(id);
      if (kind === "node" || kind === "container") return scene.drawn.boxes.has(id);
      const boxes = Array.from(scene.drawn.boxes.values());
      return scene.drawn.carrying.has(id) || boxes.some((box2) => [box2, ...box2.loose].some((each) => each.wires.some((wire) => wire.id === id)));
    }
    /** @param {Selection} selection */
    wiresOf({ id }) {
      var _a, _b, _c;
      const edge = (_a = this.scene) == null ? void 0 : _a.drawn.edges.get(id);
      return ((edge == null ? void 0 : edge.wires) ?? ((_c = (_b = this.scene) == null ? void 0 : _b.drawn.boxes.get(id)) == null ? void 0 : _c.wires) ?? []).map((wire) => wire.id);
    }
    focusables() {
      const { scene, painted } = this;
      if (!scene || !painted) return [];
      return scene.sheet.boxes.flatMap(({ box: box2 }) => {
        const drawn = painted.boxes.get(box2.id);
        const selection = selectionOf(box2.id, box2.wires.map((wire) => wire.id));
        return drawn && selection ? [{ selection, label: box2.title, element: drawn }] : [];
      });
    }
    svg() {
      return this.scene ? exported(this.svgElement, this.viewport.size, drawing_default) : "";
    }
    /** @returns {Promise<Blob | null>} */
    png() {
      return new Promise((resolve) => rastered(this.svgElement, this.viewport.size).toBlob(resolve, "image/png"));
    }
    /** @param {MouseEvent} event */
    click(event) {
      var _a;
      if (this.viewport.dragged || !(event.target instanceof Element)) return;
      const container = (_a = event.target.closest("[data-fold]")) == null ? void 0 : _a.getAttribute("data-fold");
      if (container) this.events.expand(container, !this.open.has(container));
      else this.events.select(this.at(event.target));
    }
    /** @param {MouseEvent} event */
    doubleClick(event) {
      var _a, _b;
      if (!(event.target instanceof Element) || event.target.closest("[data-fold]")) return;
      const id = (_b = (_a = event.target.closest(".box.folded, .box.open .head")) == null ? void 0 : _a.closest("[data-id]")) == null ? void 0 : _b.getAttribute("data-id");
      if (id) this.events.expand(id, !this.open.has(id));
    }
    /** @param {Element} target @returns {Selection | null} */
    at(target2) {
      var _a, _b, _c, _d, _e;
      const loose = (_b = (_a = target2.closest("[data-loose]")) == null ? void 0 : _a.getAttribute("data-loose")) == null ? void 0 : _b.split(" ");
      const id = ((_c = target2.closest("[data-id]")) == null ? void 0 : _c.getAttribute("data-id")) ?? "";
      if ((loose == null ? void 0 : loose.length) === 1 && loose[0]) return { kind: "channel", id: loose[0] };
      if (loose) return selectionOf(((_e = (_d = this.painted) == null ? void 0 : _d.loose.find((each) => each.element === target2.closest("[data-loose]"))) == null ? void 0 : _e.box) ?? "", []);
      if (id.startsWith("g:") && this.open.has(id) && !target2.closest(".head")) return null;
      return selectionOf(id, this.wiresOf({ kind: "edge", id }));
    }
  };
  function selectionOf(id, wires) {
    if (id.startsWith("n:")) return { kind: "node", id };
    if (id.startsWith("g:")) return { kind: "container", id };
    const [only2, more] = wires;
    if (only2 && more === void 0) return { kind: only2.startsWith("p:") ? "param" : "channel", id: only2 };
    return id ? { kind: "edge", id } : null;
  }
  function isAlike(one2, other) {
    return one2.entry === other.entry && one2.grouping === other.grouping && one2.focus === other.focus;
  }
  function keyOf(state) {
    const view = viewKey(state);
    return { view, all: `${view} ${state.expanded === "auto" ? "auto" : JSON.stringify([...state.expanded].sort())}` };
  }
  function areas(scene) {
    return new Map(scene.sheet.boxes.map((each) => [each.box.id, each]));
  }
  function around(all) {
    if (!all.length) return null;
    const [x, y] = [Math.min(...all.map((each) => each.x)), Math.min(...all.map((each) => each.y))];
    return { x, y, width: Math.max(...all.map((each) => each.x + each.width)) - x, height: Math.max(...all.map((each) => each.y + each.height)) - y };
  }
  function hatching2() {
    const lines = element("pattern", { id: "ll-hatching", class: "hatching", width: 7, height: 7, patternUnits: "userSpaceOnUse" }, [element("path", { d: "M-1 8L8 -1M-1 1L1 -1M6 8L8 6" })]);
    return element("defs", {}, [lines]);
  }

  // launchlint/report/html/js/drawing/index.js
  function createDrawing(data, host2, events) {
    const surface = new Surface(data, host2, events);
    return {
      show: (state) => surface.show(state),
      select: (selection) => surface.select(selection),
      fit: () => surface.viewport.showAll(),
      zoom: (factor) => surface.viewport.zoom(factor),
      goTo: (spot) => surface.goTo(spot),
      spot: () => surface.spot(),
      extent: () => surface.extent(),
      panTo: (selection) => surface.panTo(selection),
      svg: () => surface.svg(),
      png: () => surface.png(),
      focusables: () => surface.focusables(),
      isDrawn: (selection) => surface.isDrawn(selection),
      expanded: () => new Set(surface.open),
      standsFor: (node) => surface.standsFor(node),
      wiresOf: (selection) => surface.wiresOf(selection)
    };
  }

  // launchlint/report/html/js/page/combination.js
  function choices({ given }) {
    const found2 = /* @__PURE__ */ new Map();
    for (const [name, value] of given.flat()) found2.set(name, (found2.get(name) ?? /* @__PURE__ */ new Set()).add(value));
    return [...found2].map(([name, values]) => ({ name, values: [...values].sort() }));
  }
  function configurationOf(entry, pairs2) {
    const known6 = entry.given.findIndex((each, at) => (at === 0 || each.length > 0) && each.length === pairs2.length && contains(pairs2, each));
    return known6 >= 0 ? known6 : add3(entry, pairs2);
  }
  function configurationNamed(entry, text2) {
    const known6 = entry.configurations.indexOf(text2);
    if (known6 >= 0) return known6;
    const start2 = entry.configurations[0] ?? "";
    const rest = text2.startsWith(start2) ? text2.slice(start2.length).trimStart() : null;
    const pairs2 = rest === null ? null : read(rest, choices(entry));
    return pairs2 ? configurationOf(entry, pairs2) : -1;
  }
  function commandOf(entry, configuration) {
    const pairs2 = entry.given[configuration] ?? [];
    return entry.command && [entry.command, ...pairs2.map(([name, value]) => quoted(`${name}:=${value}`))].join(" ");
  }
  function quoted(word) {
    return /^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", `'"'"'`)}'`;
  }
  function contains(all, some2) {
    return some2.every(([name, value]) => all.some((each) => each[0] === name && each[1] === value));
  }
  function read(text2, known6) {
    if (text2 === "") return [];
    for (const { name, values } of known6) {
      for (const value of values) {
        const word = `${name}:=${value}`;
        if (text2 !== word && !text2.startsWith(`${word} `)) continue;
        const rest = read(text2.slice(word.length).trimStart(), known6.filter((each) => each.name !== name));
        if (rest) return [
          /** @type {const} */
          [name, value],
          ...rest
        ];
      }
    }
    return null;
  }
  function add3(entry, pairs2) {
    const number2 = entry.configurations.length;
    const within2 = entry.given.flatMap((each, at) => at > 0 && each.length > 0 && contains(pairs2, each) ? [at] : []);
    const largest = within2.filter((at) => !within2.some((other) => bigger(entry.given[other] ?? [], entry.given[at] ?? [])));
    const known6 = /* @__PURE__ */ new Map();
    const extended = (only2) => {
      let found2 = known6.get(only2);
      if (!found2) {
        const first = only2.includes(0);
        const there = largest.some((at) => only2.includes(at) !== first) ? !first : first;
        found2 = only2.length > 0 && there ? [...only2, number2] : only2;
        known6.set(only2, found2);
      }
      return found2;
    };
    for (const each of [...entry.nodes, ...entry.connections, ...entry.params]) each.only = extended(each.only);
    entry.findingsOnly = entry.findingsOnly.map(extended);
    entry.given.push(pairs2.map(([name, value]) => [name, value]));
    entry.configurations.push([entry.configurations[0], ...pairs2.map(([name, value]) => `${name}:=${value}`)].filter(Boolean).join(" "));
    return number2;
  }
  var bigger = (one2, other) => one2.length > other.length && contains(one2, other);

  // launchlint/report/html/js/page/model.js
  function createModel(data) {
    const known6 = /* @__PURE__ */ new Map();
    let lines = null;
    const md5s = /* @__PURE__ */ new Map();
    for (const [type, md52] of data.md5s) md5s.set(type, [...md5s.get(type) ?? [], md52]);
    const findings = new Map(data.findings.map((each, index) => [each.id, index]));
    return {
      data,
      md5s,
      /**
       * The relations of one entry file, worked out when first asked for.
       *
       * @param {number} index
       */
      entry(index) {
        let found2 = known6.get(index);
        if (!found2) {
          const entry = data.entries[index];
          if (!entry) throw new Error(`the page has no entry ${index}`);
          found2 = related(entry, index);
          known6.set(index, found2);
        }
        return found2;
      },
      /**
       * Index of the finding with this id; -1: there is none.
       *
       * @param {string} id
       */
      finding: (id) => findings.get(id) ?? -1,
      /**
       * The line of a file; undefined where the page does not hold it.
       *
       * @param {number} file
       * @param {number} line
       */
      line: (file, line4) => {
        var _a;
        return (_a = (lines ??= new Map(data.lines.map((each) => [each.file, new Map(each.lines)]))).get(file)) == null ? void 0 : _a.get(line4);
      },
      /**
       * "path:line".
       *
       * @param {Place} place
       */
      place: (place2) => `${data.files[place2[0]] ?? "?"}:${place2[1]}`
    };
  }
  function isIn(thing, configuration) {
    return configuration < 0 || thing.only.length === 0 || thing.only.includes(configuration);
  }
  function isUsedIn(model, channel, configuration) {
    return configuration < 0 || (model.onChannel[channel] ?? []).some((each) => isIn(each, configuration) && isIn(model.entry.nodes[each.node] ?? each, configuration));
  }
  function findingsIn({ entry }, configuration) {
    return entry.findings.filter((_, at) => isIn({ only: entry.findingsOnly[at] ?? [] }, configuration));
  }
  function peers(model, connection, configuration) {
    const all = model.onChannel[connection.channel] ?? [];
    return all.filter((each) => each.offers !== connection.offers && isIn(each, configuration));
  }
  function endsOf(model, channel, configuration) {
    const ends2 = (model.onChannel[channel] ?? []).filter((each) => isIn(each, configuration) && each.mark !== "removed");
    return { offered: ends2.some((each) => each.offers), used: ends2.some((each) => !each.offers), certain: ends2.some((each) => each.certain) };
  }
  function mayBeAt(model, channel, offers, configuration) {
    var _a;
    const isThere2 = (node) => (model.nodesNamed.get(node) ?? []).some((index) => isIn(model.entry.nodes[index] ?? { only: [] }, configuration));
    return (((_a = model.entry.channels[channel]) == null ? void 0 : _a.may) ?? []).filter((each) => each[0] === offers && (!each[1] || isThere2(each[1])));
  }
  var channelKey = (kind, name) => `${kind} ${name}`;
  function related(entry, index) {
    var _a, _b, _c;
    const model = {
      entry,
      index,
      ofNode: entry.nodes.map(() => []),
      onChannel: entry.channels.map(() => []),
      paramsOf: entry.nodes.map(() => []),
      nodesNamed: listed(entry.nodes.map((each) => each.name)),
      channelNamed: new Map(entry.channels.map((each, at) => [channelKey(each.kind, each.name), at])),
      paramsNamed: listed(entry.params.map((each) => each.name)),
      nodesWithFinding: byFinding(entry.nodes),
      channelsWithFinding: byFinding(entry.channels),
      paramsWithFinding: byFinding(entry.params)
    };
    for (const connection of entry.connections) {
      (_a = model.ofNode[connection.node]) == null ? void 0 : _a.push(connection);
      (_b = model.onChannel[connection.channel]) == null ? void 0 : _b.push(connection);
    }
    for (const [at, param] of entry.params.entries()) {
      const owners = new Set(param.readers);
      for (let end = param.name.lastIndexOf("/"); end > 0; end = param.name.lastIndexOf("/", end - 1)) {
        for (const node of model.nodesNamed.get(param.name.slice(0, end)) ?? []) owners.add(node);
      }
      for (const node of owners) (_c = model.paramsOf[node]) == null ? void 0 : _c.push(at);
    }
    return model;
  }
  function listed(names2) {
    const found2 = /* @__PURE__ */ new Map();
    for (const [index, name] of names2.entries()) {
      const those2 = found2.get(name);
      if (those2) those2.push(index);
      else found2.set(name, [index]);
    }
    return found2;
  }
  function byFinding(things) {
    const found2 = /* @__PURE__ */ new Map();
    for (const [index, { findings }] of things.entries()) {
      for (const finding of findings) {
        const those2 = found2.get(finding);
        if (those2) those2.push(index);
        else found2.set(finding, [index]);
      }
    }
    return found2;
  }

  // launchlint/report/html/js/page/stable_names.js
  var INDEXED = /(^|[:>|+])([ncp]):(\d+)(?=$|[|>+:])/g;
  var NAMED = /(^|[:>|+])([ncp])\(([^()]*)\)/g;
  var CONTAINED = /^(g:file:|g:[a-z]+:[^#]*#f)(\d+)(?=$|\|)/;
  var CONTAINER = /^(g:file:|g:[a-z]+:[^#]*#f)\(([^()]*)\)/;
  var RANGE2 = /#n(\d+)$/;
  var RANGE_NAMED = /#n\(([^()]*)\)$/;
  var known4 = /* @__PURE__ */ new WeakMap();
  function containerNames(model) {
    let names2 = known4.get(model);
    if (!names2) {
      names2 = model.entry.containers.map(({ kind, label: label2, namespace }) => `${kind} ${label2 || namespace}`);
      known4.set(model, names2);
    }
    return names2;
  }
  function numbered(names2, index) {
    const name = names2[index] ?? "";
    let before = 0;
    for (let at = 0; at < index; at++) if (names2[at] === name) before += 1;
    return (before ? `${name}~~${before + 1}` : name).replaceAll(/[%()|>+:#,]/g, (sign) => `%${sign.charCodeAt(0).toString(16)}`);
  }
  function indexOf(names2, text2) {
    const name = decoded(text2);
    const own = names2.indexOf(name);
    const match = /^(.*)~~(\d{1,6})$/s.exec(name);
    if (own >= 0 || !match) return own;
    const all = names2.flatMap((each, at) => each === match[1] ? [at] : []);
    return all[Number(match[2]) - 1] ?? all[0] ?? -1;
  }
  function decoded(text2) {
    try {
      return decodeURIComponent(text2);
    } catch {
      return text2;
    }
  }
  function namesOf({ entry }, kind) {
    if (kind === "n") return entry.nodes.map((each) => each.name);
    return kind === "c" ? entry.channels.map((each) => `${each.kind} ${each.name}`) : entry.params.map((each) => each.name);
  }
  function byName(model, id) {
    return id.replace(CONTAINED, (_, before, index) => `${before}(${numbered(containerNames(model), Number(index))})`).replace(RANGE2, (_, index) => `#n(${numbered(namesOf(model, "n"), Number(index))})`).replaceAll(INDEXED, (_, before, kind, index) => `${before}${kind}(${numbered(namesOf(model, kind), Number(index))})`);
  }
  function byIndex(model, text2) {
    return text2.replace(CONTAINER, (_, before, name) => `${before}${indexOf(containerNames(model), name)}`).replace(RANGE_NAMED, (_, name) => `#n${indexOf(namesOf(model, "n"), name)}`).replaceAll(NAMED, (_, before, kind, name) => `${before}${kind}:${indexOf(namesOf(model, kind), name)}`);
  }

  // launchlint/report/html/js/page/state.js
  var LAYERS = ["topics", "services", "actions", "params"];
  function initialState() {
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
      hidden: /* @__PURE__ */ new Set(),
      matches: null,
      selection: null,
      landing: false,
      place: null
    };
  }
  function createStore(first, address) {
    let state = first;
    const listeners = [];
    function become(next) {
      const before = state;
      state = next;
      for (const { hear, always } of listeners) {
        if (always) hear(state, before);
        else if (!state.landing) hear(state, before.landing ? state : before);
      }
    }
    window.addEventListener("popstate", () => {
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
      }
    };
  }
  function outlived(state, change) {
    var _a, _b, _c;
    if (change.entry !== void 0 && change.entry !== state.entry) {
      const selection = ((_a = state.selection) == null ? void 0 : _a.kind) === "finding" ? state.selection : null;
      return { configuration: -1, expanded: "auto", focus: null, hidden: /* @__PURE__ */ new Set(), filter: "", matches: null, place: null, selection };
    }
    if (change.grouping !== void 0 && change.grouping !== state.grouping) {
      const hidden = new Set([...state.hidden].filter((id) => id.startsWith("n:")));
      const selection = ((_b = state.selection) == null ? void 0 : _b.kind) === "container" || ((_c = state.selection) == null ? void 0 : _c.kind) === "edge" ? null : state.selection;
      return { expanded: "auto", focus: null, hidden, place: null, selection };
    }
    if (change.focus !== void 0 && change.focus !== state.focus) return { place: null };
    return {};
  }

  // launchlint/report/html/js/page/address.js
  var FLAGS = (
    /** @type {const} */
    ["topicsAsNodes", "hubs", "danglingOnly", "findingsOnly", "tray"]
  );
  var CHANNELS = ["topic", "service", "action"];
  var GROUPINGS = ["namespace", "file", "package", "machine"];
  function addressOf(model, state) {
    if (state.landing) return "";
    const first = initialState();
    const entry = model.entry(state.entry);
    const pairs2 = [];
    if (state.selection) pairs2.push(target(entry, state.selection));
    if (state.entry !== first.entry) pairs2.push(["entry", model.data.files[entry.entry.file] ?? ""]);
    if (state.configuration >= 0) pairs2.push(["configuration", entry.entry.configurations[state.configuration] ?? ""]);
    if (state.grouping !== first.grouping) pairs2.push(["group", state.grouping]);
    if (state.focus !== null) pairs2.push(["focus", pathOf(entry, state.focus)]);
    if (state.expanded !== "auto") pairs2.push(["open", many([...state.expanded].map((id) => pathOf(entry, id)))]);
    if (state.hidden.size > 0) pairs2.push(["hide", many([...state.hidden].map((id) => hiddenName(entry, id)))]);
    if (LAYERS.some((layer2) => state.layers[layer2] !== first.layers[layer2])) {
      pairs2.push(["layers", LAYERS.filter((layer2) => state.layers[layer2]).join()]);
    }
    for (const flag2 of FLAGS) if (state[flag2] !== first[flag2]) pairs2.push([flag2, state[flag2] ? "yes" : "no"]);
    if (state.filter) pairs2.push(["filter", state.filter]);
    if (state.place) pairs2.push(["at", placeText(entry, state.place)]);
    if (pairs2.length === 0 && model.data.entries.length > 1) pairs2.push(["entry", model.data.files[entry.entry.file] ?? ""]);
    return pairs2.map(([key, value]) => `${key}=${key === "open" || key === "hide" ? value : escape(value)}`).join("&");
  }
  function stateOf(model, hash) {
    var _a;
    const said2 = pairsOf(hash);
    const state = initialState();
    const wanted = wantedOf(said2);
    state.landing = said2.size === 0 && model.data.entries.length > 1;
    if (state.landing) return state;
    state.entry = entryOf(model, said2, wanted) ?? state.entry;
    const entry = model.entry(state.entry);
    const configuration = said2.get("configuration");
    if (configuration !== void 0) state.configuration = configurationNamed(entry.entry, configuration);
    const grouping = said2.get("group") ?? "";
    if (GROUPINGS.includes(grouping)) state.grouping = /** @type {PageState["grouping"]} */
    grouping;
    const outside2 = (path) => byIndex(entry, `g:${state.grouping}:${path}`);
    const focus = said2.get("focus");
    if (focus) state.focus = outside2(focus);
    const open = said2.get("open");
    if (open !== void 0) state.expanded = new Set(parts2(open).map(outside2));
    state.hidden = new Set(parts2(said2.get("hide") ?? "").flatMap((each) => unstable(entry, each)));
    const layers = (_a = said2.get("layers")) == null ? void 0 : _a.split(",");
    if (layers) for (const layer2 of LAYERS) state.layers[layer2] = layers.includes(layer2);
    for (const flag2 of FLAGS) if (said2.has(flag2)) state[flag2] = said2.get(flag2) === "yes";
    state.filter = said2.get("filter") ?? "";
    state.place = placeOf(entry, said2.get("at") ?? "");
    state.selection = wanted && found(model, entry, state.grouping, wanted);
    return state;
  }
  function target(entry, selection) {
    var _a, _b, _c, _d;
    const { kind, id } = selection;
    const index = Number(id.slice(2));
    if (kind === "node") return ["node", numbered2(entry.nodesNamed, ((_a = entry.entry.nodes[index]) == null ? void 0 : _a.name) ?? "", index)];
    if (kind === "channel") return [((_b = entry.entry.channels[index]) == null ? void 0 : _b.kind) ?? "topic", ((_c = entry.entry.channels[index]) == null ? void 0 : _c.name) ?? ""];
    if (kind === "param") return ["param", numbered2(entry.paramsNamed, ((_d = entry.entry.params[index]) == null ? void 0 : _d.name) ?? "", index)];
    if (kind === "container") return ["container", pathOf(entry, id)];
    return [kind, kind === "edge" || kind === "pair" ? byName(entry, id) : id];
  }
  function found(model, entry, grouping, [kind, name]) {
    if (kind === "node") return indexed("node", "n:", one(entry.nodesNamed, name));
    if (kind === "param") return indexed("param", "p:", one(entry.paramsNamed, name));
    if (CHANNELS.includes(kind)) return indexed("channel", "c:", entry.channelNamed.get(channelKey(kind, name)));
    if (kind === "container") return { kind, id: byIndex(entry, `g:${grouping}:${name}`) };
    if (kind === "finding") return model.finding(name) < 0 ? null : { kind, id: name };
    if (kind === "edge" || kind === "pair") return { kind, id: byIndex(entry, name) };
    return null;
  }
  function indexed(kind, prefix, index) {
    return index === void 0 ? null : { kind, id: `${prefix}${index}` };
  }
  function entryOf(model, said2, wanted) {
    const file = said2.get("entry");
    const { entries } = model.data;
    if (file !== void 0) return positive(entries.findIndex((each) => model.data.files[each.file] === file));
    if (!wanted) return void 0;
    const [kind, name] = wanted;
    if (kind === "finding") {
      const finding = model.finding(name);
      return finding < 0 ? void 0 : positive(entries.findIndex((each) => each.findings.includes(finding)));
    }
    const plain = withoutNumber(name)[0];
    const has = (each) => kind === "node" && each.nodes.some((node) => node.name === plain) || kind === "param" && each.params.some((param) => param.name === plain) || CHANNELS.includes(kind) && each.channels.some((channel) => channel.kind === kind && channel.name === name);
    return positive(entries.findIndex(has));
  }
  var positive = (index) => index < 0 ? void 0 : index;
  function wantedOf(said2) {
    for (const kind of ["finding", "node", ...CHANNELS, "param", "container", "edge", "pair"]) {
      const name = said2.get(kind);
      if (name) return [kind, name];
    }
    return null;
  }
  function pairsOf(hash) {
    const said2 = /* @__PURE__ */ new Map();
    for (const pair of hash.replace(/^#/, "").split("&")) {
      const [key = "", ...rest] = pair.split("=");
      const value = rest.join("=");
      if (rest.length > 0 && !said2.has(key)) said2.set(key, key === "open" || key === "hide" ? value : unescape(value));
    }
    return said2;
  }
  function numbered2(named, name, index) {
    var _a;
    const at = ((_a = named.get(name)) == null ? void 0 : _a.indexOf(index)) ?? 0;
    return at > 0 ? `${name}~~${at + 1}` : name;
  }
  function one(named, text2) {
    const [name, at] = withoutNumber(text2);
    const those2 = named.get(text2) ?? named.get(name) ?? [];
    return those2[named.has(text2) ? 0 : at - 1] ?? those2[0];
  }
  function withoutNumber(text2) {
    const match = /^(.*)~~(\d{1,6})$/s.exec(text2);
    return match ? [match[1] ?? "", Number(match[2])] : [text2, 1];
  }
  function hiddenName(entry, id) {
    var _a;
    return id.startsWith("n:") ? `n:${((_a = entry.entry.nodes[Number(id.slice(2))]) == null ? void 0 : _a.name) ?? ""}` : byName(entry, id);
  }
  function unstable(entry, text2) {
    return text2.startsWith("n:") ? (entry.nodesNamed.get(text2.slice(2)) ?? []).map((index) => `n:${index}`) : [byIndex(entry, text2)];
  }
  var pathOf = (entry, id) => byName(entry, id).split(":").slice(2).join(":");
  function placeText(entry, { id, x, y, scale }) {
    return `${Math.round(x)},${Math.round(y)},${Math.round(scale * 100)},${byName(entry, id)}`;
  }
  function placeOf(entry, text2) {
    const match = /^(-?\d{1,6}),(-?\d{1,6}),(\d{1,4}),(.*)$/s.exec(text2);
    return match && { x: Number(match[1]), y: Number(match[2]), scale: Number(match[3]) / 100, id: byIndex(entry, match[4] ?? "") };
  }
  var many = (values) => values.map((each) => encodeURIComponent(each).replaceAll("%2F", "/")).join();
  var parts2 = (text2) => text2.split(",").filter(Boolean).map(unescape);
  function escape(text2) {
    return encodeURIComponent(text2).replaceAll(/%(?:2F|3A|3D|2C)/g, decodeURIComponent);
  }
  function unescape(text2) {
    try {
      return decodeURIComponent(text2);
    } catch {
      return text2;
    }
  }

  // launchlint/report/html/js/page/elements.js
  function element2(tag, attributes2 = {}, ...children) {
    const made2 = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes2)) {
      if (typeof value === "function") made2.addEventListener(name, value);
      else if (value === true) made2.setAttribute(name, "");
      else if (value !== false && value !== null && value !== void 0) made2.setAttribute(name, String(value));
    }
    made2.append(...kept(children.flat()));
    return made2;
  }
  function fill(host2, ...children) {
    host2.replaceChildren(...kept(children.flat()));
  }
  function button(label2, action, attributes2 = {}) {
    return element2("button", { type: "button", click: action, ...attributes2 }, label2);
  }
  function part(id) {
    const found2 = document.getElementById(id);
    if (!found2) throw new Error(`the page has no element "${id}"`);
    return found2;
  }
  function kept(children) {
    return children.filter((child) => child !== null && child !== void 0 && child !== false && child !== "").map((child) => child instanceof Node ? child : String(child));
  }

  // launchlint/report/html/js/page/wording.js
  var ROLES = /* @__PURE__ */ new Map([
    ["publisher", ["publishes", "subscribes to it", "Publishers"]],
    ["subscriber", ["subscribes to", "publishes it", "Subscribers"]],
    ["server", ["serves", "calls it", "Servers"]],
    ["client", ["calls", "serves it", "Clients"]],
    ["action server", ["serves action", "calls it", "Action servers"]],
    ["action client", ["calls action", "serves it", "Action clients"]]
  ]);
  var MOST_DOUBTED = 3;
  var MOST_NAMED = 4;
  var ROLE_ORDER = [...ROLES.keys()];
  var words = (role) => ROLES.get(role.replace("_", " ")) ?? [role, "uses it", role];
  var does = (role) => words(role)[0];
  function missed(role, doubts) {
    const who = doubted(doubts);
    return who ? `nobody here ${words(role)[1]}, but ${who} may` : `nobody ${words(role)[1]}`;
  }
  function doubted(doubts) {
    const names2 = [...new Set(doubts.map((each) => `${each[1] || "another one"} (${why(each)})`))];
    if (names2.length > MOST_DOUBTED) names2.splice(MOST_DOUBTED, names2.length, "others");
    return [names2.slice(0, -1).join(", "), ...names2.slice(-1)].filter(Boolean).join(" and ");
  }
  function why([, node, unknown, reason]) {
    return node ? unknown ? "not known" : "not all of it is known" : reason.replace(/:.*/s, "");
  }
  var nounOf = (role) => words(role)[2];
  function number(count3, one2, many2 = `${one2}s`) {
    return `${count3.toLocaleString("en")} ${count3 === 1 ? one2 : many2}`;
  }
  function notice({ verdict: verdict2, why: why2, withArgs, launcher }) {
    if (verdict2 === "loads") return withArgs && `loads; ${withArgs}`;
    return `${verdict2 === "refused" ? `refused by ${launcher}` : verdict2}: ${why2}${withArgs && `; ${withArgs}`}`;
  }
  function entryTitle(data, index) {
    const entry = data.entries[index];
    return entry ? `${data.files[entry.file]} ${entry.configurations[0] ?? ""}`.trimEnd() : "";
  }
  function configurationName(args) {
    return args || "default args";
  }
  function when(entry, only2) {
    if (only2.length === 0) return "";
    const names2 = (those2) => {
      const named = those2.map((each) => configurationName(entry.configurations[each] ?? ""));
      if (named.length > MOST_NAMED + 1) named.splice(MOST_NAMED, named.length, `${named.length - MOST_NAMED} others`);
      return named.join(" or ");
    };
    const others = entry.configurations.map((_, index) => index).filter((index) => !only2.includes(index));
    if (others.length > 0 && others.length < only2.length) return `not with ${names2(others)}`;
    return `only with ${names2([...only2])}`;
  }
  function lastPart2(name) {
    return name.slice(name.lastIndexOf("/") + 1) || name;
  }

  // launchlint/report/html/js/page/configurations.js
  var EVERY = -1;
  function createConfigurations({ model, store }) {
    const quick = element2("select", { "aria-label": "Configuration" });
    const title2 = element2("summary", {}, "Args");
    const content = element2("div", { class: "menu-items args" });
    const menu2 = element2("details", { class: "popup one-only" }, title2, content);
    const host2 = element2("span", { class: "one-only configurations" }, quick, menu2);
    quick.addEventListener("change", () => store.set({ configuration: Number(quick.value) }));
    document.addEventListener("click", (event) => menu2.contains(
      /** @type {Node} */
      event.target
    ) || (menu2.open = false));
    menu2.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !menu2.open) return;
      menu2.open = false;
      title2.focus();
      event.stopPropagation();
    });
    const entryNow = () => model.entry(store.get().entry).entry;
    function chosen() {
      const selects = [...content.querySelectorAll("select")];
      return selects.flatMap((each) => each.selectedIndex > 0 ? [
        /** @type {const} */
        [each.dataset["name"] ?? "", each.value]
      ] : []);
    }
    function apply() {
      store.set({ configuration: configurationOf(entryNow(), chosen()) });
    }
    function build() {
      const entry = entryNow();
      const rows2 = choices(entry).map(({ name, values }) => {
        const options = [element2("option", {}, "default"), ...values.map((value) => element2("option", { value }, value || "(empty)"))];
        const chooser = element2("select", { "data-name": name, change: apply }, ...options);
        return element2("label", {}, element2("code", {}, name), chooser);
      });
      host2.hidden = rows2.length === 0 && entry.configurations.length < 2;
      menu2.hidden = rows2.length === 0 && !entry.command;
      const command = element2("pre", { class: "command", tabindex: 0, role: "group", "aria-label": "Command" });
      const copy = button("Copy", () => void copied2(command.textContent ?? "", copy), { class: "copy" });
      const note = element2("p", { class: "note" });
      fill(content, element2("p", { class: "note" }, "What starts it so:"), command, copy, note, ...rows2);
    }
    function show2() {
      var _a;
      const { configuration } = store.get();
      const entry = entryNow();
      const all = element2("option", { value: EVERY }, `All ${entry.configurations.length} configurations`);
      fill(quick, all, ...entry.configurations.map((args, index) => element2("option", { value: index }, configurationName(args))));
      quick.value = String(configuration);
      const pairs2 = entry.given[configuration] ?? [];
      for (const each of content.querySelectorAll("select")) {
        const value = (_a = pairs2.find(([name]) => name === each.dataset["name"])) == null ? void 0 : _a[1];
        each.selectedIndex = value === void 0 ? 0 : [...each.options].findIndex((option, at) => at > 0 && option.value === value);
      }
      const [command, note] = [content.querySelector("pre"), content.querySelector(":scope > p:last-of-type")];
      if (command) command.textContent = commandOf(entry, Math.max(configuration, 0));
      if (note) note.textContent = said(entry, configuration);
    }
    store.listen((state, before) => {
      const anew = state === before || state.entry !== before.entry;
      if (anew) build();
      if (anew || state.configuration !== before.configuration) show2();
    });
    return host2;
  }
  function said(entry, configuration) {
    var _a;
    if (configuration < 0) return "All configurations are shown together: what is in some of them only is dashed.";
    const nodes = entry.nodes.filter((each) => isIn(each, configuration) && each.mark !== "removed").length;
    const guess = !entry.whole && (((_a = entry.given[configuration]) == null ? void 0 : _a.length) ?? 0) > 1;
    const doubt = guess ? " It has more args that act on each other than were combined: of several at once, it is shown what each of them does." : "";
    return `${number(nodes, "node")} with these args.${doubt}`;
  }
  async function copied2(text2, told2) {
    try {
      await navigator.clipboard.writeText(text2);
      told2.textContent = "Copied";
    } catch {
      told2.textContent = "Select it, and copy with Ctrl+C";
    }
    window.setTimeout(() => told2.textContent = "Copy", 2e3);
  }

  // launchlint/report/html/js/page/dot.js
  var COLOURS = /* @__PURE__ */ new Map([
    ["added", "#1a7f37"],
    ["removed", "#cf222e"],
    ["changed", "#9a6700"]
  ]);
  var BUNDLE2 = 3;
  function dot({ title: title2, verdict: verdict2, boxes, arrows }) {
    const names2 = new Map(boxes.map((box2, index) => [box2.id, `n${index + 1}`]));
    const lines = ["digraph connections {", "  rankdir=LR;", `  label=${quoted2(title2, verdict2)};`, "  node [shape=box];"];
    const write = (parent, depth) => {
      const indent = "  ".repeat(Math.min(depth, 12));
      for (const box2 of boxes) {
        if (box2.parent !== parent) continue;
        if (box2.kind === "container") {
          lines.push(`${indent}subgraph cluster_${names2.get(box2.id)} { label=${quoted2(box2.label)};`);
          write(box2.id, depth + 1);
          lines.push(`${indent}}`);
        } else lines.push(`${indent}${names2.get(box2.id)} [${attributes(box2)}];`);
      }
    };
    write("", 1);
    for (const arrow of arrows) lines.push(`  ${names2.get(arrow.from)} -> ${names2.get(arrow.to)} [${arrowAttributes(arrow)}];`);
    return `${[...lines, "}"].join("\n")}
`;
  }
  function attributes({ kind, label: label2, detail, unknown, conditional, mark }) {
    const found2 = [`label=${quoted2(label2, detail)}`];
    if (kind !== "node" && kind !== "folded") found2.push("shape=ellipse");
    if (unknown || conditional || mark === "removed") found2.push(`style="${unknown ? "dotted" : "dashed"}"`);
    if (mark) found2.push(`color="${COLOURS.get(mark)}", penwidth=3`);
    return found2.join(", ");
  }
  function arrowAttributes({ kind, names: names2, conditional, mark }) {
    const found2 = [`label=${names2.length < BUNDLE2 ? quoted2(...names2) : quoted2(`${names2.length} ${kind}s`)}`];
    if (kind === "service" || conditional || mark === "removed") found2.push('style="dashed"');
    else if (kind === "action") found2.push('style="bold"');
    if (mark) found2.push(`color="${COLOURS.get(mark)}", penwidth=3`);
    return found2.join(", ");
  }
  function quoted2(...rows2) {
    const text2 = rows2.filter(Boolean).map(
      (row2) => row2.replaceAll(/[\\"]/g, "\\$&").replaceAll("&", "&amp;").replaceAll(new RegExp("\\p{Cc}", "gu"), "�")
    );
    return `"${text2.join("\\n")}"`;
  }

  // launchlint/report/html/js/page/menu.js
  function menu(label2, choices2) {
    const host2 = element2("details", { class: "menu" }, element2("summary", {}, label2));
    const close = () => host2.removeAttribute("open");
    const items = choices2.map(([name, action]) => button(name, () => (close(), action())));
    host2.append(element2("div", { class: "menu-items" }, ...items));
    host2.addEventListener("keydown", (event) => {
      var _a;
      if (event.key !== "Escape" || !host2.open) return;
      event.stopPropagation();
      close();
      (_a = host2.querySelector("summary")) == null ? void 0 : _a.focus();
    });
    host2.addEventListener("focusout", (event) => {
      if (!host2.contains(
        /** @type {Node | null} */
        event.relatedTarget
      )) close();
    });
    return host2;
  }

  // launchlint/report/html/js/page/mermaid.js
  var LONGEST4 = 80;
  var LONGEST_VERDICT = 200;
  var BUNDLE3 = 3;
  var STYLES = /* @__PURE__ */ new Map([
    ["unknown", "stroke-dasharray: 2 2"],
    ["conditional", "stroke-dasharray: 6 3"],
    ["added", "stroke:#1a7f37,stroke-width:3px"],
    ["removed", "stroke:#cf222e,stroke-width:3px,stroke-dasharray: 6 3"],
    ["changed", "stroke:#9a6700,stroke-width:3px"]
  ]);
  function mermaid({ verdict: verdict2, boxes, arrows }) {
    const names2 = new Map(boxes.map((box2, index) => [box2.id, `n${index + 1}`]));
    const lines = ["flowchart LR"];
    if (verdict2) lines.push(`  verdict["${label(verdict2, LONGEST_VERDICT)}"]`, "  style verdict stroke:#cf222e,stroke-width:2px");
    const write = (parent, depth) => {
      const indent = "  ".repeat(Math.min(depth, 12));
      for (const box2 of boxes) {
        if (box2.parent !== parent) continue;
        if (box2.kind === "container") {
          lines.push(`${indent}subgraph ${names2.get(box2.id)} ["${label(box2.label)}"]`);
          write(box2.id, depth + 1);
          lines.push(`${indent}end`);
        } else lines.push(`${indent}${names2.get(box2.id)}${shape(box2)}`);
      }
    };
    write("", 1);
    for (const arrow of arrows) lines.push(`  ${names2.get(arrow.from)} ${line2(arrow)} ${names2.get(arrow.to)}`);
    for (const [at, { mark }] of arrows.entries()) if (mark) lines.push(`  linkStyle ${at} ${STYLES.get(mark)}`);
    for (const [style, css] of STYLES) {
      const those2 = boxes.filter((box2) => box2.mark === style || style === "unknown" && box2.unknown || style === "conditional" && box2.conditional);
      if (those2.length > 0) lines.push(`  classDef ${style} ${css}`, `  class ${those2.map((box2) => names2.get(box2.id)).join()} ${style}`);
    }
    return `${lines.join("\n")}
`;
  }
  function shape({ kind, label: text2, detail }) {
    const inside = `"${label(text2)}${detail ? `<br/>${label(detail)}` : ""}"`;
    if (kind === "folded") return `[[${inside}]]`;
    return kind === "node" ? `[${inside}]` : `([${inside}])`;
  }
  function line2({ kind, names: names2, conditional }) {
    const shown2 = names2.length < BUNDLE3 ? names2.map((each) => label(each)).join("<br/>") : `${names2.length} ${kind}s`;
    const text2 = shown2 && `|"${shown2}"|`;
    if (kind === "action") return `==>${text2}`;
    return conditional || kind === "service" ? `-.->${text2}` : `-->${text2}`;
  }
  function label(text2, longest = LONGEST4) {
    const characters = Array.from(text2);
    const shown2 = characters.length <= longest ? characters : [...characters.slice(0, 26), "…", ...characters.slice(-(longest - 27))];
    return shown2.map((each) => /^[\w\-/.,~ …→]$/.test(each) ? each : `#${each.codePointAt(0)};`).join("");
  }

  // launchlint/report/html/js/page/reference.js
  function reference(page, target2, label2, entry = page.store.get().entry) {
    const address = addressOf(page.model, { ...initialState(), entry, grouping: page.store.get().grouping, selection: target2 });
    return element2("a", { href: `#${address}`, click: (event) => follow(page, target2, entry, event) }, label2);
  }
  function nodeReference(page, node) {
    var _a;
    const { store, model } = page;
    return reference(page, { kind: "node", id: `n:${node}` }, ((_a = model.entry(store.get().entry).entry.nodes[node]) == null ? void 0 : _a.name) ?? "");
  }
  function channelReference(page, channel) {
    var _a;
    const { store, model } = page;
    return reference(page, { kind: "channel", id: `c:${channel}` }, ((_a = model.entry(store.get().entry).entry.channels[channel]) == null ? void 0 : _a.name) ?? "");
  }
  function select({ store }, target2, entry = store.get().entry) {
    if (entry === store.get().entry) store.set({ selection: target2 });
    else store.set({ entry, selection: target2 });
  }
  function follow(page, target2, entry, event) {
    if (event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    select(page, target2, entry);
  }

  // launchlint/report/html/js/links.js
  function sourceLink(data, file, line4) {
    const path = data.files[file];
    if (data.sourceUrl === null || data.baseFiles.includes(file) || /^\/|^\.\.\//.test(path)) return null;
    if (!/^https?:\/\//.test(data.sourceUrl)) return null;
    return `${data.sourceUrl}${path.split("/").map(encodeURIComponent).join("/")}#L${line4}`;
  }

  // launchlint/report/html/js/page/source.js
  var AROUND = 2;
  var LONGEST_MARKED = 12;
  function written(model, place2) {
    const address = sourceLink(model.data, place2[0], place2[1]);
    const text2 = model.place(place2);
    return address === null ? element2("code", { class: "place" }, text2) : element2("a", { class: "place", href: address }, text2);
  }
  function source(model, place2, marked) {
    const [file, line4, column] = place2;
    const last = marked ? Math.min(marked.endLine, line4 + LONGEST_MARKED) : line4;
    const shown2 = [];
    for (let at = Math.max(1, line4 - AROUND); at <= last + AROUND; at += 1) {
      const text2 = model.line(file, at);
      if (text2 === void 0) continue;
      const inside = at >= line4 && at <= last;
      const from = at === line4 ? column - 1 : 0;
      const to = marked && at === marked.endLine ? marked.endColumn - 1 : Infinity;
      shown2.push(
        element2(
          "span",
          { class: inside ? "line hit" : "line" },
          element2("span", { class: "number", "aria-hidden": "true" }, String(at)),
          element2("span", { class: "text" }, ...inside && marked ? split2(text2, from, to) : [text2 || " "])
        )
      );
      if ((marked == null ? void 0 : marked.label) && at === last) {
        const start2 = at === line4 ? Math.max(column - 1, indentOf(Array.from(text2))) : indentOf(Array.from(text2));
        const below = Array.from(text2).slice(0, start2).join("").replaceAll(/[^\t]/g, " ");
        const label2 = element2("span", { class: "text" }, `${below}└ ${marked.label}`);
        shown2.push(element2("span", { class: "line label" }, element2("span", { class: "number" }), label2));
      }
    }
    const where = element2("figcaption", {}, written(model, place2));
    const code = shown2.length > 0 && element2("pre", { class: "source", tabindex: 0, role: "group", "aria-label": model.place(place2) }, shown2);
    return element2("figure", { class: "source" }, where, code);
  }
  function split2(line4, from, to) {
    const points = Array.from(line4);
    const start2 = Math.max(from, indentOf(points));
    const end = Math.max(start2, Math.min(to, points.length));
    const middle2 = points.slice(start2, end).join("");
    return [points.slice(0, start2).join(""), middle2 && element2("mark", {}, middle2), points.slice(end).join("")];
  }
  function indentOf(points) {
    return Math.max(
      0,
      points.findIndex((each) => each.trim() !== "")
    );
  }

  // launchlint/report/html/js/page/same_findings.js
  var ORDER = ["error", "warning", "info"];
  function grouped(data, findings) {
    const groups = /* @__PURE__ */ new Map();
    for (const index of findings) {
      const each = data.findings[index];
      if (!each) continue;
      const key = `${ORDER.indexOf(each.severity)} ${each.since ?? ""} ${each.rule} ${each.message}`;
      const known6 = groups.get(key);
      if (known6) known6.push(index);
      else groups.set(key, [index]);
    }
    return [...groups].sort(([one2], [other]) => one2.charCodeAt(0) - other.charCodeAt(0)).map(([, those2]) => those2);
  }

  // launchlint/report/html/js/page/panel_blocks.js
  var MANY = 12;
  function block(title2, ...children) {
    return element2("section", { class: "block" }, title2 && element2("h3", {}, title2), ...children);
  }
  function heading(kind, name, badges, actions = []) {
    return [
      element2("p", { class: "kind" }, kind),
      element2("h2", { tabindex: -1 }, name),
      badges.some(Boolean) && element2("p", { class: "badges" }, ...badges),
      actions.some(Boolean) && element2("p", { class: "actions" }, ...actions)
    ];
  }
  function badge2(text2, name = "") {
    return element2("span", { class: `badge ${name}`.trim() }, text2);
  }
  function list(items, name = "") {
    const host2 = element2("ul", { class: name || null }, ...items.slice(0, MANY).map((item2) => element2("li", {}, item2)));
    if (items.length <= MANY) return host2;
    const rest = items.slice(MANY);
    const more = element2(
      "li",
      {},
      button(`${rest.length} more`, () => more.replaceWith(...rest.map((item2) => element2("li", {}, item2))), { class: "more" })
    );
    host2.append(more);
    return host2;
  }
  function findingsBlock(page, findings) {
    if (findings.length === 0) return null;
    return block(findings.length === 1 ? "Finding" : `${findings.length} findings`, findingList(page, findings));
  }
  function findingList(page, findings) {
    const { data } = page.model;
    const items = grouped(data, findings).flatMap((those2) => {
      const [each, ...others] = those2.flatMap((index) => data.findings[index] ?? []);
      return each ? [findingItem(page, each, others)] : [];
    });
    return list(items, "findings");
  }
  function findingItem(page, finding, others) {
    const link = (each, text2) => reference(page, { kind: "finding", id: each.id }, text2);
    const more = others.length > 0 && [
      element2("summary", {}, `and at ${number(others.length, "more place")}`),
      list(others.map((each) => link(each, page.model.place(each.place))))
    ];
    return element2(
      "div",
      {},
      finding.since === "new" && [badge2("new", "since"), " "],
      badge2(finding.severity, finding.severity),
      " ",
      element2("code", {}, finding.rule),
      " ",
      link(finding, finding.message),
      element2("span", { class: "note" }, written(page.model, finding.place)),
      more && element2("details", { class: "others" }, ...more)
    );
  }
  function sourceBlock(page, place2, title2 = "Written at") {
    return place2 && block(title2, source(page.model, place2));
  }
  function presenceBlock(page, only2, conditions = []) {
    const entry = page.model.entry(page.store.get().entry).entry;
    const words2 = when(entry, only2);
    if (!words2 && conditions.length === 0) return null;
    const lines = conditions.map((condition) => element2("code", {}, condition));
    const there = words2 || (entry.configurations.length > 1 ? "in every configuration of this page" : "in the one configuration of this page");
    return block("When it is there", element2("p", {}, there), lines.length > 0 && list(lines));
  }
  function renaming({ model }, connection) {
    const steps = connection.remaps.filter(([from, to]) => from !== to);
    if (steps.length === 0) return null;
    const items = steps.map(([from, to, place2]) => {
      const where = place2 ? written(model, place2) : "its args";
      return element2("li", {}, element2("code", {}, from), " → ", element2("code", {}, to), " ", element2("span", { class: "note" }, "in ", where));
    });
    return element2("ol", { class: "remaps", "aria-label": "Remapped" }, ...items);
  }
  function peerList(page, others, self) {
    const { entry: shown2, configuration } = page.store.get();
    const model = page.model.entry(shown2);
    const channel = model.entry.channels[self.channel];
    const direction = (channel == null ? void 0 : channel.kind) === "topic" === self.offers ? "to" : "from";
    if (others.length > 0)
      return list(
        [...new Set(others.map((each) => each.node))].map((node) => nodeReference(page, node)),
        `peers ${direction}`
      );
    const doubts = mayBeAt(model, self.channel, !self.offers, configuration);
    const isNote = (channel == null ? void 0 : channel.hub) || (channel == null ? void 0 : channel.plumbing) || !self.certain || doubts.length > 0;
    return element2("p", { class: isNote ? "note" : "missing" }, missed(self.role, doubts));
  }
  function connectionFacts(page, connection, withType = true) {
    var _a;
    const entry = page.model.entry(page.store.get().entry).entry;
    const notes = [moment(connection), when(entry, connection.only), connection.mark && `${connection.mark} since ${page.model.data.base}`];
    const renamed = renaming(page, connection);
    const evidence = element2(
      "details",
      {},
      element2("summary", {}, "How this is known"),
      list(connection.evidence.map((each) => element2("code", {}, each)))
    );
    const name = (_a = entry.channels[connection.channel]) == null ? void 0 : _a.name;
    return [
      connection.qos && element2("div", { class: "type" }, "QoS: ", connection.qos),
      withType && connection.type && element2("div", { class: "type" }, element2("code", {}, connection.type)),
      (renamed || connection.unremapped !== name || connection.spelling === "private") && element2("div", { class: "note" }, "in the code: ", element2("code", {}, connection.declared), ` (${connection.spelling})`),
      renamed,
      notes.filter(Boolean).map((note) => element2("div", { class: "note" }, note)),
      connection.evidence.length > 0 && evidence
    ];
  }
  function moment({ certain, when: since }) {
    const known6 = /* @__PURE__ */ new Map([
      ["on_subscriber", "once somebody subscribes"],
      ["on_message", "once a message has come"],
      ["condition", "under a condition"]
    ]);
    return known6.get(since) ?? (certain ? "" : "perhaps: it is not certain that it does");
  }
  function focusButton({ store }, id, label2) {
    const focused = store.get().focus === id;
    return button(focused ? "Leave focus" : label2, () => store.set({ focus: focused ? null : id }), { "aria-pressed": String(focused) });
  }
  function hideButton({ store }, id) {
    const hidden = store.get().hidden.has(id);
    return button(hidden ? "Show in the drawing" : "Hide in the drawing", () => store.set({ hidden: toggled(store.get().hidden, id) }));
  }
  function toggled(those2, id) {
    const next = new Set(those2);
    if (!next.delete(id)) next.add(id);
    return next;
  }
  function commandPart(command, words2) {
    if (!command) return [];
    return [element2("p", {}, words2), element2("pre", { class: "command", tabindex: 0, role: "group", "aria-label": "Command" }, command)];
  }

  // launchlint/report/html/js/page/changes.js
  var MARKS = [
    ["removed", "Lost"],
    ["added", "Gained"],
    ["changed", "Changed"]
  ];
  function changesBlocks(page, model) {
    const { base } = page.model.data;
    if (base === null) return [];
    if (model.entry.mark === "added") return [block(`Since ${base}`, element2("p", {}, "This launch file is new."))];
    if (model.entry.mark === "removed") return [block(`Since ${base}`, element2("p", {}, "This launch file is gone. What it started is shown."))];
    const blocks = MARKS.flatMap(([mark, title2]) => {
      const items = [...nodesWith(page, model, mark), ...linksWith(page, model, mark), ...connectionsWith(page, model, mark)];
      return items.length > 0 ? [block(`${title2} since ${base}`, list(items, "changes"))] : [];
    });
    return blocks.length > 0 ? blocks : [block(`Since ${base}`, element2("p", {}, "Nothing changed in what this launch file starts and connects."))];
  }
  function createSequence(model) {
    const known6 = /* @__PURE__ */ new Map();
    return (index) => {
      let found2 = known6.get(index);
      if (!found2) known6.set(index, found2 = targetsOf(model, index));
      return found2;
    };
  }
  function targetsOf(model, index) {
    const one2 = model.entry(index);
    const { nodes, channels: channels2, params, findings } = one2.entry;
    const marked = MARKS.flatMap(([mark]) => [
      ...channels2.flatMap(({ hub, plumbing }, at) => !hub && !plumbing && endsAt(one2, at).some((each) => each.mark === mark) ? [`c:${at}`] : []),
      ...nodes.flatMap((each, at) => each.mark === mark ? [`n:${at}`] : []),
      ...params.flatMap((each, at) => each.mark === mark ? [`p:${at}`] : [])
    ]);
    const fresh = findings.flatMap((each) => {
      var _a, _b;
      return ((_a = model.data.findings[each]) == null ? void 0 : _a.since) ? [((_b = model.data.findings[each]) == null ? void 0 : _b.id) ?? ""] : [];
    });
    return [
      ...fresh.map((id) => (
        /** @type {Target} */
        { kind: "finding", id }
      )),
      ...[...new Set(marked)].map((id) => (
        /** @type {Target} */
        { kind: KIND_OF[id.charAt(0)], id }
      ))
    ];
  }
  var KIND_OF = { c: "channel", n: "node", p: "param" };
  function nodesWith(page, model, mark) {
    return model.entry.nodes.flatMap((each, index) => each.mark === mark ? [line3(mark, "node ", nodeReference(page, index))] : []);
  }
  function linksWith(page, model, mark) {
    return model.entry.channels.flatMap(({ kind, hub, plumbing }, channel) => {
      if (hub || plumbing) return [];
      const there = endsAt(model, channel).filter((each) => each.mark !== opposite(mark));
      const [givers, takers] = [true, false].map((gives2) => there.filter(({ end }) => kind === "topic" === end.offers === gives2));
      const pairs2 = (givers ?? []).flatMap((from) => (takers ?? []).map((to) => (
        /** @type {const} */
        [from, to]
      )));
      return pairs2.filter(([from, to]) => from.mark === mark || to.mark === mark).map(
        ([from, to]) => line3(mark, nodeReference(page, from.end.node), " → ", nodeReference(page, to.end.node), " on ", channelReference(page, channel))
      );
    });
  }
  function connectionsWith(page, model, mark) {
    return model.entry.channels.flatMap(({ plumbing }, channel) => {
      const ends2 = plumbing ? [] : endsAt(model, channel).filter((each) => each.mark !== opposite(mark));
      const alone = ends2.filter((each) => each.mark === mark && !ends2.some((other) => other.end.offers !== each.end.offers));
      return alone.map(({ end }) => line3(mark, nodeReference(page, end.node), ` ${does(end.role)} `, channelReference(page, channel)));
    });
  }
  function endsAt(model, channel) {
    return (model.onChannel[channel] ?? []).map((end) => {
      var _a;
      const moved = (each) => each.mark === "removed" && each.role === end.role && each.declared === end.declared && each.channel !== channel;
      return { end, mark: end.mark === "changed" && ((_a = model.ofNode[end.node]) == null ? void 0 : _a.some(moved)) ? "added" : end.mark };
    });
  }
  function line3(mark, ...words2) {
    return element2("div", {}, badge2(mark, mark), " ", ...words2);
  }
  var opposite = (mark) => mark === "removed" ? "added" : "removed";

  // launchlint/report/html/js/page/containers.js
  var known5 = /* @__PURE__ */ new WeakMap();
  function containerOf(entry, grouping, id) {
    if (id === trayId(grouping)) return inTray(entry).length ? trayOf(grouping, inTray(entry)) : void 0;
    const root = containersOf(entry, grouping);
    let all = known5.get(root);
    if (!all) {
      all = /* @__PURE__ */ new Map();
      const waiting = [root];
      for (let each = waiting.pop(); each; each = waiting.pop()) {
        all.set(each.id, each);
        waiting.push(...each.groups);
      }
      known5.set(root, all);
    }
    return all.get(id);
  }
  function fullName({ kind, title: title2, namespace }) {
    return kind === "namespace" ? namespace : title2;
  }
  function nodesWithin(group3) {
    const found2 = [];
    const waiting = [group3];
    for (let each = waiting.pop(); each; each = waiting.pop()) {
      found2.push(...each.nodes);
      waiting.push(...[...each.groups].reverse());
    }
    return found2;
  }
  function findingsWithin(entry, group3) {
    const found2 = new Set(nodesWithin(group3).flatMap((node) => {
      var _a;
      return ((_a = entry.nodes[node]) == null ? void 0 : _a.findings) ?? [];
    }));
    const waiting = [group3];
    for (let each = waiting.pop(); each; each = waiting.pop()) {
      for (const finding of each.own) found2.add(finding);
      waiting.push(...each.groups);
    }
    return [...found2].sort((one2, other) => one2 - other);
  }
  function containersWith(entry, grouping, finding) {
    const found2 = [];
    const waiting = [containersOf(entry, grouping)];
    for (let each = waiting.pop(); each; each = waiting.pop()) {
      if (each.own.includes(finding)) found2.push(each);
      waiting.push(...each.groups);
    }
    return found2;
  }
  function around2(entry, grouping, node) {
    const path = [];
    const search = (group3) => {
      if (group3.nodes.includes(node)) return true;
      const inner = group3.groups.find(search);
      if (inner) path.unshift(inner);
      return inner !== void 0;
    };
    search(containersOf(entry, grouping));
    return path;
  }
  function outside(entry, grouping, id) {
    const found2 = [];
    const outermost = containersOf(entry, grouping).id;
    for (let group3 = containerOf(entry, grouping, id); (group3 == null ? void 0 : group3.parent) && group3.parent !== outermost; group3 = containerOf(entry, grouping, group3.parent)) found2.push(group3.parent);
    return found2;
  }

  // launchlint/report/html/js/page/picture.js
  var LAYER_OF = /* @__PURE__ */ new Map([
    ["topic", "topics"],
    ["service", "services"],
    ["action", "actions"]
  ]);
  function pictureOf(page) {
    const state = page.store.get();
    const model = page.model.entry(state.entry);
    const boxes = boxesOf(page, model.entry, state);
    const drawn = new Set(boxes.map((each) => each.id));
    const arrows = /* @__PURE__ */ new Map();
    for (const [at, channel] of model.entry.channels.entries()) {
      if (!isShown(page, state, channel, at)) continue;
      const ends2 = endsAt(model, at).flatMap(({ end, mark }) => isIn(end, state.configuration) ? [{ ...end, mark: mark ?? "" }] : []);
      const givers = sides(
        page,
        ends2.filter((each) => givesData(channel, each)),
        drawn
      );
      const takers = sides(
        page,
        ends2.filter((each) => !givesData(channel, each)),
        drawn
      );
      if (givers.size === 0 && takers.size === 0) continue;
      const alone = givers.size === 0 || takers.size === 0;
      if (alone ? state.danglingOnly : state.topicsAsNodes || givers.size > 1 && takers.size > 1) {
        const id = `c:${at}`;
        boxes.push({
          id,
          parent: "",
          kind: channel.kind,
          label: channel.name,
          detail: channel.types.join(", "),
          unknown: false,
          conditional: false,
          mark: channel.mark ?? ""
        });
        for (const [from, end] of givers) draw(arrows, from, id, channel.kind, "", end);
        for (const [to, end] of takers) draw(arrows, id, to, channel.kind, "", end);
      } else {
        for (const [from, giver] of givers)
          for (const [to, taker] of takers) if (from !== to && meet(giver, taker)) draw(arrows, from, to, channel.kind, channel.name, both(giver, taker));
      }
    }
    return { title: page.model.data.files[model.entry.file] ?? "", verdict: notice(model.entry), boxes, arrows: [...arrows.values()] };
  }
  var givesData = ({ kind }, end) => kind === "topic" === end.offers;
  function isShown({ drawing }, state, channel, at) {
    if (channel.plumbing || channel.hub && !state.hubs) return false;
    if (state.danglingOnly || state.findingsOnly) return drawing.isDrawn({ kind: "channel", id: `c:${at}` });
    return state.layers[LAYER_OF.get(channel.kind) ?? "topics"];
  }
  function boxesOf({ drawing }, entry, state) {
    const boxes = [];
    const open = drawing.expanded();
    const walk2 = (group3, parent) => {
      const isOpen = group3.kind === "root" || open.has(group3.id);
      const box2 = { id: group3.id, parent, label: fullName(group3), unknown: false, conditional: false, mark: "" };
      if (!drawing.isDrawn({ kind: "container", id: group3.id }) && group3.kind !== "root") {
        for (const each of group3.groups) walk2(each, parent);
        return;
      }
      if (!isOpen) boxes.push({ ...box2, kind: "folded", detail: number(group3.count, "node") });
      if (!isOpen) return;
      const inner = group3.kind === "root" ? "" : group3.id;
      if (inner) boxes.push({ ...box2, kind: "container", detail: "" });
      for (const each of group3.groups) walk2(each, inner);
      for (const index of group3.nodes) {
        const node = entry.nodes[index];
        if (!node || !drawing.isDrawn({ kind: "node", id: `n:${index}` })) continue;
        const conditional = node.only.length > 0 || node.conditions.length > 0;
        boxes.push({
          id: `n:${index}`,
          parent: inner,
          kind: "node",
          label: node.name,
          detail: node.program,
          unknown: node.knowledge === "unknown",
          conditional,
          mark: node.mark ?? ""
        });
      }
    };
    walk2(containersOf(entry, state.grouping), "");
    return boxes;
  }
  function sides({ drawing }, ends2, drawn) {
    const found2 = /* @__PURE__ */ new Map();
    for (const end of ends2) {
      const box2 = drawing.standsFor(end.node);
      if (box2 !== null && drawn.has(box2) && !found2.has(box2)) found2.set(box2, { conditional: !end.certain || end.only.length > 0, mark: end.mark });
    }
    return found2;
  }
  var both = (one2, other) => ({ conditional: one2.conditional || other.conditional, mark: one2.mark || other.mark });
  var meet = (one2, other) => one2.mark === other.mark || ![one2.mark, other.mark].every((mark) => mark === "added" || mark === "removed");
  function draw(arrows, from, to, kind, name, end) {
    const key = `${from}
${to}
${kind}
${end.mark}`;
    const known6 = arrows.get(key);
    if (!known6) arrows.set(key, { from, to, kind, names: name ? [name] : [], ...end });
    else {
      if (name) known6.names.push(name);
      known6.conditional &&= end.conditional;
    }
  }

  // launchlint/report/html/js/page/export.js
  function createExportMenu(page) {
    return menu("Export", [
      ["SVG picture", () => save("image/svg+xml", "svg", page.drawing.svg())],
      ["PNG picture", () => void page.drawing.png().then((picture) => picture && save("image/png", "png", picture))],
      ["Mermaid", () => save("text/plain", "mmd", mermaid(pictureOf(page)))],
      ["Graphviz DOT", () => save("text/vnd.graphviz", "dot", dot(pictureOf(page)))],
      ["JSON", () => save("application/json", "json", `${JSON.stringify(pictureOf(page), null, 2)}
`)]
    ]);
  }
  function save(type, ending, content) {
    const address = URL.createObjectURL(new Blob([content], { type }));
    const link = element2("a", { href: address, download: `launchlint-graph.${ending}` });
    document.body.append(link);
    link.click();
    link.remove();
    window.setTimeout(() => URL.revokeObjectURL(address), 1e4);
  }

  // launchlint/report/html/js/page/search_index.js
  var MOST5 = 50;
  var FAR = 10;
  var SHORT_WORD = 3;
  var LONG_WORD = 5;
  var LONGEST_WORD = 40;
  function createIndex(model) {
    const known6 = /* @__PURE__ */ new Map();
    function all(entry) {
      let found2 = known6.get(entry);
      if (!found2) {
        found2 = hitsOf(model, entry);
        known6.set(entry, found2);
      }
      return found2;
    }
    return function search(query, entry) {
      const words2 = query.toLowerCase().split(/\s+/).filter(Boolean);
      if (words2.length === 0) return { hits: [], total: 0, ids: /* @__PURE__ */ new Set() };
      const here = fitting2(all(entry), words2);
      const ids = new Set(here.flatMap((each) => {
        var _a;
        return ((_a = each.target) == null ? void 0 : _a.id) ?? [];
      }));
      const others = here.length >= MOST5 ? [] : model.data.entries.flatMap((_, at) => at === entry ? [] : fitting2(all(at), words2));
      const elsewhere2 = others.filter((each) => !here.some((known7) => known7.kind === each.kind && known7.label === each.label));
      const hits = [...here, ...elsewhere2];
      return { hits: hits.slice(0, MOST5), total: hits.length, ids };
    };
  }
  function fitting2(hits, words2) {
    const scored = hits.flatMap((hit) => {
      const exact = words2.every((word) => hit.key.includes(word));
      const near = exact ? 0 : roughly(hit, words2);
      return exact || near < Infinity ? [{ hit, score: exact ? score(hit, words2) : near }] : [];
    });
    scored.sort((one2, other) => one2.score - other.score);
    return scored.map((each) => each.hit);
  }
  function roughly({ label: label2 }, words2) {
    const name = label2.toLowerCase();
    let sum = FAR;
    for (const word of words2) {
      if (name.includes(word)) continue;
      const gaps = gapsIn(name, word);
      if (gaps <= word.length) sum += 1 + gaps / 10;
      else if (word.length >= LONG_WORD && word.length <= LONGEST_WORD && hasTypo(name, word)) sum += 2;
      else return Infinity;
    }
    return sum;
  }
  function gapsIn(name, word) {
    if (word.length < SHORT_WORD) return Infinity;
    let at = name.length;
    let last = -1;
    for (const letter of [...word].reverse()) {
      at = at <= 0 ? -1 : name.lastIndexOf(letter, at - 1);
      if (at < 0) return Infinity;
      if (last < 0) last = at;
    }
    return last - at + 1 - word.length;
  }
  function hasTypo(name, word) {
    for (let at = 0; at < word.length; at++) {
      const [before, after] = [word.slice(0, at), word.slice(at + 1)];
      if (name.includes(before + after)) return true;
      if (at + 1 < word.length && name.includes(before + (word[at + 1] ?? "") + (word[at] ?? "") + word.slice(at + 2))) return true;
      for (let start2 = name.indexOf(before); start2 >= 0 && start2 < name.length; start2 = name.indexOf(before, start2 + 1)) {
        if (name.startsWith(after, start2 + at + 1) || name.startsWith(word.slice(at), start2 + at + 1)) return true;
      }
    }
    return false;
  }
  function score({ label: label2, tail: tail2 }, words2) {
    const [word = ""] = words2;
    const name = label2.toLowerCase();
    if (name === word || tail2 === word) return 0;
    if (tail2.startsWith(word) || name.startsWith(word)) return 1;
    if (tail2.includes(word)) return 2;
    return name.includes(word) ? 3 : 4;
  }
  function hitsOf(model, index) {
    const { data } = model;
    const { entry } = model.entry(index);
    const file = data.files[entry.file] ?? "";
    const hits = [];
    const add4 = (kind, label2, detail, target2, byFile2 = false) => {
      hits.push({
        kind,
        label: label2,
        detail,
        target: target2,
        entry: index,
        byFile: byFile2,
        key: `${label2} ${detail} ${kind}`.toLowerCase(),
        tail: lastPart2(label2).toLowerCase()
      });
    };
    for (const [at, each] of entry.nodes.entries()) add4("node", each.name, each.program, { kind: "node", id: `n:${at}` });
    for (const [at, each] of entry.channels.entries()) {
      if (!each.plumbing) add4(each.kind, each.name, each.types.join(", "), { kind: "channel", id: `c:${at}` });
    }
    for (const [at, each] of entry.params.entries()) add4("param", each.name, each.value, { kind: "param", id: `p:${at}` });
    for (const at of entry.findings) {
      const finding = data.findings[at];
      if (finding)
        add4("finding", finding.message, `${finding.rule} ${finding.name} ${model.place(finding.place)}`, { kind: "finding", id: finding.id });
    }
    add4("file", file, "entry file", null);
    const seen = /* @__PURE__ */ new Set();
    for (const [at, each] of entry.containers.entries()) {
      if (each.kind !== "include" || seen.has(each.label)) continue;
      seen.add(each.label);
      add4("file", each.label, `included by ${file}`, { kind: "container", id: `g:file:${at}` }, true);
    }
    return hits;
  }

  // launchlint/report/html/js/page/search.js
  var PAUSE2 = 150;
  function createSearch(page) {
    const index = createIndex(page.model);
    const options = element2("ul", { id: "search-results", role: "listbox", "aria-label": "Search results", hidden: true });
    const told2 = element2("span", { class: "visually-hidden", role: "status" });
    const field = element2("input", {
      id: "search",
      type: "search",
      role: "combobox",
      placeholder: "Search  /",
      autocomplete: "off",
      spellcheck: "false",
      "aria-label": "Search names, types, params, files and findings",
      "aria-controls": "search-results",
      "aria-expanded": "false",
      "aria-autocomplete": "list"
    });
    const host2 = element2("div", { class: "search", role: "search" }, field, options, told2);
    let hits = [];
    let active = -1;
    let timer = 0;
    function show2(open) {
      options.hidden = !open;
      field.setAttribute("aria-expanded", String(open));
      if (!open) activate(-1);
    }
    function activate(next) {
      var _a;
      (_a = options.children[active]) == null ? void 0 : _a.setAttribute("aria-selected", "false");
      active = hits.length === 0 || next < 0 ? -1 : next % hits.length;
      const option = options.children[active];
      if (option) {
        option.setAttribute("aria-selected", "true");
        option.scrollIntoView({ block: "nearest" });
        field.setAttribute("aria-activedescendant", option.id);
      } else field.removeAttribute("aria-activedescendant");
    }
    function update() {
      const query = field.value.trim();
      const result = index(query, page.store.get().entry);
      hits = result.hits;
      active = -1;
      const more = result.total - hits.length;
      fill(
        options,
        ...hits.map((hit, at) => optionOf(page, hit, at)),
        query && hits.length === 0 && element2("li", { class: "empty", role: "option", "aria-disabled": "true", "aria-selected": "false" }, "Nothing on this page is called that."),
        more > 0 && element2("li", { class: "empty", role: "option", "aria-disabled": "true", "aria-selected": "false" }, `${more} more: type on`)
      );
      told2.textContent = query ? number(result.total, "result") : "";
      show2(query !== "");
      window.clearTimeout(timer);
      timer = window.setTimeout(() => page.store.set({ matches: query ? result.ids : null }), PAUSE2);
    }
    function choose(hit) {
      var _a;
      if (!hit) return;
      show2(false);
      window.clearTimeout(timer);
      if (hit.byFile) page.store.set({ entry: hit.entry, grouping: "file" });
      page.store.set({ entry: hit.entry, selection: hit.target, matches: null });
      (_a = part("panel").querySelector("h2")) == null ? void 0 : _a.focus();
    }
    function clear() {
      field.value = "";
      update();
    }
    field.addEventListener("input", update);
    field.addEventListener("focus", () => field.value && show2(true));
    host2.addEventListener("focusout", (event) => !host2.contains(
      /** @type {Node | null} */
      event.relatedTarget
    ) && show2(false));
    options.addEventListener("mousedown", (event) => event.preventDefault());
    options.addEventListener("click", (event) => {
      const option = (
        /** @type {Element} */
        event.target.closest("li")
      );
      if (option) choose(hits[[...options.children].indexOf(option)]);
    });
    field.addEventListener("keydown", (event) => {
      const keys = /* @__PURE__ */ new Map([
        ["ArrowDown", () => options.hidden ? update() : activate(active + 1)],
        ["ArrowUp", () => activate(active <= 0 ? hits.length - 1 : active - 1)],
        ["Enter", () => choose(hits[Math.max(active, 0)])],
        ["Escape", () => field.value ? clear() : field.blur()]
      ]);
      const action = keys.get(event.key);
      if (!action) return;
      event.preventDefault();
      event.stopPropagation();
      action();
    });
    return { host: host2, focus: () => (field.focus(), field.select()) };
  }
  function optionOf({ model, store }, hit, at) {
    const elsewhere2 = hit.entry !== store.get().entry && hit.target !== null;
    return element2(
      "li",
      { id: `search-result-${at}`, role: "option", "aria-selected": "false" },
      element2("span", { class: "result-kind" }, hit.kind),
      element2("span", { class: "result-label" }, hit.label),
      element2("span", { class: "result-detail" }, elsewhere2 ? `in ${model.data.files[model.entry(hit.entry).entry.file]}` : hit.detail)
    );
  }

  // launchlint/report/html/js/page/theme.js
  var KEY = "launchlint-theme";
  var ORDER2 = ["system", "light", "dark"];
  var SIGNS2 = { system: "◐", light: "☀", dark: "☾" };
  function themeButton() {
    const host2 = button("", () => show2(ORDER2[(ORDER2.indexOf(now) + 1) % ORDER2.length] ?? "system"), { class: "theme" });
    let now = remembered();
    function show2(theme) {
      now = theme;
      if (theme === "system") delete document.documentElement.dataset["theme"];
      else document.documentElement.dataset["theme"] = theme;
      host2.textContent = SIGNS2[theme];
      host2.title = `Theme: ${theme}`;
      host2.setAttribute("aria-label", `Theme: ${theme}`);
      remember(theme);
    }
    show2(now);
    return host2;
  }
  function remembered() {
    try {
      return ORDER2.find((each) => each === localStorage.getItem(KEY)) ?? "system";
    } catch {
      return "system";
    }
  }
  function remember(theme) {
    try {
      localStorage.setItem(KEY, theme);
    } catch {
    }
  }

  // launchlint/report/html/js/page/controls.js
  function createControls(page, { help }) {
    const search = createSearch(page);
    const entry = entryChooser(page);
    fill(
      part("controls"),
      entry,
      createConfigurations(page),
      search.host,
      createExportMenu(page),
      themeButton(),
      button("?", help, { class: "help", "aria-label": "Keyboard help", title: "Keyboard (?)" })
    );
    page.store.listen((state) => entry && (entry.value = state.landing ? "-1" : String(state.entry)), { always: true });
    return search;
  }
  function entryChooser({ model, store }) {
    const { entries, files } = model.data;
    if (entries.length < 2) return null;
    const names2 = toldApart(entries.map((each) => files[each.file] ?? ""));
    const options = entries.map((each, index) => {
      const count3 = each.findings.length;
      const told2 = [
        each.configurations[0],
        each.verdict !== "loads" ? each.verdict : each.withArgs !== "" && "refused with other args",
        each.mark ?? each.changes.map(([, words2]) => words2).join(", "),
        count3 > 0 && `${count3} ${count3 === 1 ? "finding" : "findings"}`
      ];
      const more = told2.filter(Boolean).join(", ");
      return element2("option", { value: index, title: files[each.file] ?? "" }, `${names2[index]}${more ? ` (${more})` : ""}`);
    });
    const all = element2("option", { value: -1 }, `All ${number(entries.length, "launch file")}`);
    const host2 = element2("select", { "aria-label": "Launch file" }, all, ...options);
    host2.addEventListener("change", () => store.set(host2.value === "-1" ? { ...initialState(), landing: true } : { entry: Number(host2.value) }));
    return host2;
  }
  function toldApart(paths) {
    const endings = (path) => path.split("/").map((_, at, parts3) => parts3.slice(parts3.length - 1 - at).join("/"));
    const counts = /* @__PURE__ */ new Map();
    for (const path of new Set(paths)) for (const each of endings(path)) counts.set(each, (counts.get(each) ?? 0) + 1);
    return paths.map((path) => endings(path).find((each) => counts.get(each) === 1) ?? path);
  }

  // launchlint/report/html/js/page/drawing_keys.js
  var ASIDE = 2;
  var DIRECTIONS = /* @__PURE__ */ new Map([
    ["ArrowLeft", [-1, 0]],
    ["ArrowRight", [1, 0]],
    ["ArrowUp", [0, -1]],
    ["ArrowDown", [0, 1]]
  ]);
  function createDrawingKeys({ drawing, store }) {
    const host2 = part("drawing");
    let last = "";
    function go(next) {
      if (!next) return;
      last = next.selection.id;
      next.element.setAttribute("tabindex", "0");
      next.element.focus();
    }
    host2.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const all = drawing.focusables();
      const at = all.find((each) => each.element === event.target);
      if (!at) return;
      const direction = DIRECTIONS.get(event.key);
      if (direction) go(nearest(all, at, direction));
      else if (event.key === "Enter") store.set({ selection: at.selection });
      else if (event.key === " " && at.selection.kind === "container") turn(at.selection.id);
      else if (event.key === "Home") go(all[0]);
      else if (event.key === "End") go(all.at(-1));
      else return;
      event.preventDefault();
      event.stopPropagation();
    });
    function turn(id) {
      const expanded = drawing.expanded();
      if (!expanded.delete(id)) expanded.add(id);
      store.set({ expanded });
    }
    return {
      focus() {
        var _a;
        const all = drawing.focusables();
        const selected = (_a = store.get().selection) == null ? void 0 : _a.id;
        go(all.find((each) => each.selection.id === selected) ?? all.find((each) => each.selection.id === last) ?? all[0]);
      },
      /** Remembers what in the drawing has the focus; what it returns gives it back after the drawing was made anew. */
      hold() {
        var _a;
        const held = (_a = drawing.focusables().find((each) => each.element === document.activeElement)) == null ? void 0 : _a.selection.id;
        return () => {
          if (held && !host2.contains(document.activeElement)) go(drawing.focusables().find((each) => each.selection.id === held));
        };
      }
    };
  }
  function nearest(all, from, [dx, dy]) {
    const start2 = middle(from);
    let best;
    let least = Infinity;
    for (const each of all) {
      const { x, y } = middle(each);
      const along = (x - start2.x) * dx + (y - start2.y) * dy;
      const aside2 = Math.abs((x - start2.x) * dy) + Math.abs((y - start2.y) * dx);
      const cost = along + ASIDE * aside2;
      if (each !== from && along > 1 && cost < least) {
        least = cost;
        best = each;
      }
    }
    return best;
  }
  function middle({ element: element3 }) {
    const { left, top, width, height } = element3.getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2 };
  }

  // launchlint/report/html/js/page/editor.js
  function editor() {
    const { acquireVsCodeApi } = (
      /** @type {{ acquireVsCodeApi?: () => Host }} */
      globalThis
    );
    return acquireVsCodeApi == null ? void 0 : acquireVsCodeApi();
  }
  function addressBefore(host2) {
    const state = host2 == null ? void 0 : host2.getState();
    return typeof state === "string" ? state : "";
  }
  function followEditor({ model, store }, host2) {
    if (host2 === void 0) return;
    let following = false;
    window.addEventListener("message", ({ data }) => {
      const [kind, name] = Array.isArray(data == null ? void 0 : data.launchlint) ? data.launchlint : [];
      if (typeof kind !== "string" || typeof name !== "string") return;
      const now = store.get();
      const file = model.data.files[model.entry(now.entry).entry.file] ?? "";
      const address = `entry=${encodeURIComponent(file)}&group=${now.grouping}&${encodeURIComponent(kind)}=${encodeURIComponent(name)}`;
      const { selection } = stateOf(model, address);
      if (selection === null) return;
      following = true;
      store.set({ selection }, "replace");
      following = false;
    });
    store.listen((state, before) => {
      const address = addressOf(model, state);
      host2.setState(address);
      if (following || state.selection === null || state.selection === before.selection) return;
      const [kind, name] = (address.split("&")[0] ?? "").split("=");
      if (kind && name) host2.postMessage({ launchlint: [kind, decodeURIComponent(name)] });
    });
  }

  // launchlint/report/html/js/page/help.js
  var KEYS2 = [
    ["/", "search"],
    ["n  N", "next, previous finding"],
    ["]  [", "next, previous change, where two revisions are compared"],
    ["a", "all launch files"],
    ["t", "tree"],
    ["d", "drawing"],
    ["p", "panel"],
    ["b", "tables"],
    ["← ↑ ↓ →", "in the drawing: the next thing in that direction; in the tree: move, open, close"],
    ["Enter", "select"],
    ["Space", "in the drawing: expand or collapse"],
    ["h", "in the tree: hide or show in the drawing"],
    ["f", "draw the selected container, or the one around the selected node, alone"],
    ["+  −  0", "zoom in, zoom out, fit"],
    ["Esc", "one step back: close, deselect, leave focus"],
    ["?", "this help"]
  ];
  function createHelp(shortcuts) {
    const letters = element2("input", { type: "checkbox", change: () => shortcuts.turn(letters.checked) });
    const rows2 = KEYS2.map(
      ([keys, what]) => element2("tr", {}, element2("th", { scope: "row" }, ...keys.split("  ").map((key) => element2("kbd", {}, key))), element2("td", {}, what))
    );
    const dialog = element2(
      "dialog",
      { id: "help", "aria-labelledby": "help-title" },
      element2("h2", { id: "help-title" }, "Keyboard"),
      element2("table", {}, element2("tbody", {}, ...rows2)),
      element2("p", {}, element2("label", {}, letters, " Keys that are single letters or signs")),
      button("Close", () => dialog.close())
    );
    document.body.append(dialog);
    return () => {
      letters.checked = shortcuts.isOn();
      dialog.showModal();
    };
  }

  // launchlint/report/html/js/page/keyboard.js
  var STORED = "launchlint-single-keys";
  function createKeyboard(page, go) {
    const { store, drawing } = page;
    let single2 = stored();
    const keys = /* @__PURE__ */ new Map([
      ["/", go.search],
      ["?", go.help],
      ["t", go.tree],
      ["d", go.drawing],
      ["b", go.tables],
      ["p", () => {
        var _a;
        return (_a = part("panel").querySelector("h2")) == null ? void 0 : _a.focus();
      }],
      ["n", () => nextFinding(page, 1)],
      ["N", () => nextFinding(page, -1)],
      ["]", () => go.change(1)],
      ["[", () => go.change(-1)],
      ["a", go.landing],
      ["f", () => focusOnSelected(page)],
      ["+", () => drawing.zoom(1.25)],
      ["=", () => drawing.zoom(1.25)],
      ["-", () => drawing.zoom(0.8)],
      ["0", () => drawing.fit()]
    ]);
    document.addEventListener("keydown", (event) => {
      const target2 = (
        /** @type {Element} */
        event.target
      );
      if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented || document.querySelector("dialog[open]")) return;
      if (target2.closest("input, select, textarea")) return;
      const action = event.key === "Escape" ? back : single2 ? keys.get(event.key) : void 0;
      if (!action) return;
      event.preventDefault();
      action();
    });
    function back() {
      const { selection, focus, landing } = store.get();
      if (selection) store.set({ selection: null });
      else if (focus) store.set({ focus: null });
      else if (!landing) go.landing();
    }
    return {
      isOn: () => single2,
      /** @param {boolean} on */
      turn(on) {
        single2 = on;
        try {
          localStorage.setItem(STORED, String(on));
        } catch {
        }
      }
    };
  }
  function nextFinding(page, step) {
    const { entry, selection, landing } = page.store.get();
    if (landing) return;
    const findings = page.model.entry(entry).entry.findings.flatMap((each) => page.model.data.findings[each] ?? []);
    const order = ["error", "warning", "info"];
    findings.sort((one2, other) => order.indexOf(one2.severity) - order.indexOf(other.severity));
    const at = findings.findIndex((each) => each.id === (selection == null ? void 0 : selection.id));
    const next = findings.at(at < 0 ? step > 0 ? 0 : -1 : (at + step) % findings.length);
    if (next) select(page, { kind: "finding", id: next.id });
  }
  function focusOnSelected({ store, model }) {
    var _a;
    const { selection, grouping, entry, focus } = store.get();
    let id = (selection == null ? void 0 : selection.kind) === "container" ? selection.id : null;
    if ((selection == null ? void 0 : selection.kind) === "node") id = ((_a = around2(model.entry(entry).entry, grouping, Number(selection.id.slice(2))).at(-1)) == null ? void 0 : _a.id) ?? null;
    if (id) store.set({ focus: id === focus ? null : id });
  }
  function stored() {
    try {
      return localStorage.getItem(STORED) !== "false";
    } catch {
      return true;
    }
  }

  // launchlint/report/html/js/page/landing.js
  function createLanding({ store, model }) {
    const host2 = document.getElementById("landing");
    const [verdict2, counts] = [part("verdict"), part("counts")];
    const [words2, looks, numbers] = [verdict2.textContent, verdict2.className, [...counts.children]];
    store.listen(
      ({ landing }, before) => {
        var _a;
        document.body.dataset["view"] = landing ? "landing" : "entry";
        if (!landing) return;
        verdict2.textContent = words2;
        verdict2.className = looks;
        counts.replaceChildren(...numbers);
        part("drawing").setAttribute("aria-busy", "false");
        if (!before.landing) (_a = host2 == null ? void 0 : host2.querySelector("h2")) == null ? void 0 : _a.focus();
      },
      { always: true }
    );
    return {
      /** Shows all launch files, where there are several. */
      show() {
        if (model.data.entries.length > 1) store.set({ ...initialState(), landing: true });
      }
    };
  }

  // launchlint/report/html/js/page/why.js
  var MOST6 = 3;
  var LIKE = 0.45;
  var gives = (model, each) => {
    var _a;
    return ((_a = model.entry.channels[each.channel]) == null ? void 0 : _a.kind) === "topic" === each.offers;
  };
  function pathBetween(model, from, to, configuration) {
    var _a;
    const reached = /* @__PURE__ */ new Map([[from, null]]);
    const waiting = [from];
    for (const node of waiting) {
      if (node === to && node !== from) break;
      for (const out of ends(model, node, configuration).filter((each) => gives(model, each))) {
        const isTopic = ((_a = model.entry.channels[out.channel]) == null ? void 0 : _a.kind) === "topic";
        for (const into of model.onChannel[out.channel] ?? []) {
          if (gives(model, into) || !isThere(model, into, configuration) || !meet2(out, into) || reached.has(into.node)) continue;
          if (!isTopic && (node !== from || into.node !== to)) continue;
          reached.set(into.node, { from: node, channel: out.channel, to: into.node });
          waiting.push(into.node);
        }
      }
    }
    if (!reached.has(to) || from === to) return null;
    const steps = [];
    for (let step = reached.get(to); step; step = reached.get(step.from)) steps.unshift(step);
    return steps;
  }
  function nearMisses(model, from, to, written2) {
    const out = ends(model, from, -1).filter((each) => gives(model, each));
    const into = ends(model, to, -1).filter((each) => !gives(model, each));
    const found2 = out.flatMap(
      (giver) => into.flatMap((taker) => {
        const [one2, other] = [model.entry.channels[giver.channel], model.entry.channels[taker.channel]];
        if (!one2 || !other || one2.kind !== other.kind) return [];
        const score2 = likeness(giver, taker, one2.name, other.name);
        return score2 >= LIKE ? [{ giver, taker, score: score2 }] : [];
      })
    );
    found2.sort((one2, other) => other.score - one2.score);
    return found2.slice(0, MOST6).map(({ giver, taker }) => ({ giver, taker, ...verdict(model, giver, taker, written2) }));
  }
  function ends(model, node, configuration) {
    return (model.ofNode[node] ?? []).filter((each) => {
      const { hub = true, plumbing = true } = model.entry.channels[each.channel] ?? {};
      return !hub && !plumbing && isThere(model, each, configuration);
    });
  }
  function isThere(model, each, configuration) {
    return each.mark !== "removed" && isIn(each, configuration) && isIn(model.entry.nodes[each.node] ?? { only: [] }, configuration);
  }
  function meet2(one2, other) {
    return one2.only.length === 0 || other.only.length === 0 || one2.only.some((each) => other.only.includes(each));
  }
  function likeness(giver, taker, one2, other) {
    if (one2 === other) return 1;
    const sameType = giver.type !== "" && giver.type === taker.type;
    if (giver.type && taker.type && !sameType) return tail(one2) === tail(other) ? 0.5 : 0;
    if (tail(one2) === tail(other)) return sameType ? 0.95 : 0.8;
    if (bare(giver.declared) === bare(taker.declared)) return sameType ? 0.9 : 0.7;
    return (sameType ? 0.45 : 0) + 0.45 * shared(tail(one2), tail(other));
  }
  var tail = (name) => name.slice(name.lastIndexOf("/") + 1);
  var bare = (declared) => tail(declared.replace(/^~/, ""));
  function shared(one2, other) {
    const pairs2 = (word) => new Set(Array.from({ length: Math.max(0, word.length - 1) }, (_, at) => word.slice(at, at + 2).toLowerCase()));
    const [left, right] = [pairs2(one2), pairs2(other)];
    const both2 = [...left].filter((each) => right.has(each)).length;
    return left.size + right.size ? 2 * both2 / (left.size + right.size) : 0;
  }
  function verdict(model, giver, taker, written2) {
    const name = (each) => {
      var _a;
      return ((_a = model.entry.channels[each.channel]) == null ? void 0 : _a.name) ?? "";
    };
    const node = (each) => {
      var _a;
      return ((_a = model.entry.nodes[each.node]) == null ? void 0 : _a.name) ?? "";
    };
    if (name(giver) !== name(taker)) return { apart: `The names part at ${parting(name(giver), name(taker))}${cause(model, giver, taker, written2)}.`, edit: remap(model, taker, name(giver), written2) };
    if (giver.type && taker.type && giver.type !== taker.type) {
      return { apart: `One name, two types: ${node(giver)} has ${giver.type}, ${node(taker)} wants ${taker.type}.`, edit: "Let both use one type: ROS does not connect them." };
    }
    const clash = clashOf(giver.qos ?? "", taker.qos ?? "");
    if (clash) return { apart: `One name, and their QoS does not fit: ${clash[0]} is offered, ${clash[1]} is asked for.`, edit: "Let what is offered be at least what is asked for." };
    const [one2, other] = [model.entry.nodes[giver.node], model.entry.nodes[taker.node]];
    const never = !meet2(giver, taker) || one2 && other && !meet2(one2, other);
    if (never) {
      const when2 = (each) => (each == null ? void 0 : each.conditions.join(" and ")) || "some configurations";
      return { apart: `They are never there together: ${node(giver)} only where ${when2(one2)}, ${node(taker)} only where ${when2(other)}.`, edit: "Start both under one condition." };
    }
    return { apart: "They are connected, yet not in the configuration that is shown.", edit: "Choose a configuration in which both are there." };
  }
  function parting(one2, other) {
    const [left, right] = [one2.split("/"), other.split("/")];
    const at = left.findIndex((part2, index) => part2 !== right[index]);
    const from = at < 0 ? left.length : at;
    const rest = (parts3) => parts3.slice(from).join("/") || "its end";
    const before = left.slice(0, from).join("/");
    return `${before ? `${before}/` : "/"}: “${rest(left)}” there, “${rest(right)}” here`;
  }
  function cause(model, giver, taker, written2) {
    var _a, _b;
    if (giver.unremapped === taker.unremapped) {
      const step = [...giver.remaps, ...taker.remaps].find(([from, to]) => from !== to);
      return step ? `: before remaps both are ${giver.unremapped}, then ${step[0]} becomes ${step[1]}${step[2] ? ` in ${written2(step[2])}` : ""}` : "";
    }
    if (bare(giver.declared) === bare(taker.declared)) {
      const [one2, other] = [((_a = model.entry.nodes[giver.node]) == null ? void 0 : _a.namespace) ?? "", ((_b = model.entry.nodes[taker.node]) == null ? void 0 : _b.namespace) ?? ""];
      if (giver.spelling === "private" || taker.spelling === "private") return ": a private name begins with the name of its node";
      if (one2 !== other) return `: the nodes are in different namespaces, ${one2} and ${other}`;
    }
    return "";
  }
  function remap(model, taker, name, written2) {
    const own = [...taker.remaps].reverse().find(([from, to, place3]) => from !== to && place3);
    if (own == null ? void 0 : own[2]) return `In ${written2(own[2])} let the remap lead to ${name} instead of ${own[1]}.`;
    const node = model.entry.nodes[taker.node];
    const place2 = node == null ? void 0 : node.place;
    const where = place2 ? written2(place2) : "its element";
    const file = where.replace(/:\d+$/, "");
    const line4 = file.endsWith(".py") ? `remappings=[("${taker.declared}", "${name}")]` : /\.ya?ml$/.test(file) ? `remap: [{from: "${taker.declared}", to: "${name}"}]` : `<remap from="${taker.declared}" to="${name}"/>`;
    return `At ${where}, in ${(node == null ? void 0 : node.name) ?? "the node"}: ${line4}`;
  }

  // launchlint/report/html/js/page/panel_pair.js
  var OFFERED = 600;
  function pairField({ store }, model, id) {
    const names2 = /* @__PURE__ */ new Map();
    for (const [index, node] of model.entry.nodes.entries()) if (`n:${index}` !== id && !names2.has(node.name)) names2.set(node.name, `n:${index}`);
    const isNode = id.startsWith("n:");
    if (isNode) {
      for (const [index, { name, hub, plumbing }] of model.entry.channels.entries()) if (!hub && !plumbing && !names2.has(name)) names2.set(name, `c:${index}`);
    }
    const offers = element2("datalist", { id: "pair-names" }, ...[...names2.keys()].slice(0, OFFERED).map((name) => element2("option", { value: name })));
    const field = element2("input", { type: "search", list: "pair-names", placeholder: isNode ? "Why does it not hear …" : "Why is it not connected with …", "aria-label": isNode ? "Another node or topic: why are they not connected?" : "A node: why are they not connected?", class: "pair", autocomplete: "off" });
    const ask = () => {
      const other = names2.get(field.value.trim());
      if (other) store.set({ selection: { kind: "pair", id: isNode ? `${id}|${other}` : `${other}|${id}` } });
    };
    field.addEventListener("input", ask);
    return element2("p", { class: "pair-host" }, field, offers);
  }
  function pairWay(model, id, configuration) {
    const [one2 = "", other = ""] = id.split("|");
    const [from, to] = [Number(one2.slice(2)), Number(other.slice(2))];
    const way = other.startsWith("n:") ? pathBetween(model, from, to, configuration) ?? pathBetween(model, to, from, configuration) : null;
    return way ? [...new Set(way.flatMap((step) => [`n:${step.from}`, `c:${step.channel}`, `n:${step.to}`]))] : [one2, other];
  }
  function pairPanel(page, model, id) {
    const [one2 = "", other = ""] = id.split("|");
    const node = model.entry.nodes[Number(one2.slice(2))];
    if (!node) return [];
    if (other.startsWith("c:")) return topicPanel(page, model, Number(one2.slice(2)), Number(other.slice(2)));
    const [from, to] = [Number(one2.slice(2)), Number(other.slice(2))];
    const second = model.entry.nodes[to];
    if (!second) return [];
    return [
      ...heading("Two nodes", `${node.name} and ${second.name}`, []),
      ...directionBlocks(page, model, from, to),
      ...directionBlocks(page, model, to, from),
      unknownNote(model, [from, to])
    ];
  }
  function directionBlocks(page, model, from, to) {
    var _a, _b;
    const [one2, other] = [((_a = model.entry.nodes[from]) == null ? void 0 : _a.name) ?? "", ((_b = model.entry.nodes[to]) == null ? void 0 : _b.name) ?? ""];
    const path = pathBetween(model, from, to, page.store.get().configuration);
    if (path) return [block(path.length > 1 ? `${other} hears ${one2} by way of others` : `${other} hears ${one2}`, list(path.map((step) => stepItem(page, step)), "steps"))];
    const near = nearMisses(model, from, to, (place2) => page.model.place(place2));
    if (near.length === 0) return [block(`${other} does not hear ${one2}`, element2("p", {}, `Nothing that ${one2} gives is like anything that ${other} takes.`))];
    return [block(`${other} does not hear ${one2}`, ...near.map((each) => nearItem(page, model, each)))];
  }
  function stepItem(page, { from, channel, to }) {
    return element2("div", {}, nodeReference(page, from), " → ", channelReference(page, channel), " → ", nodeReference(page, to));
  }
  function nearItem(page, model, { giver, taker, apart, edit }) {
    const rows2 = [
      ["", ...[giver, taker].map((each) => {
        var _a;
        return `${((_a = model.entry.nodes[each.node]) == null ? void 0 : _a.name) ?? ""} ${does(each.role)}`;
      })],
      ["in the code", giver.declared, taker.declared],
      ["in its namespace", giver.unremapped, taker.unremapped],
      ...remapRows(giver, taker),
      ["on the graph", nameOf(model, giver), nameOf(model, taker)],
      ["type", giver.type || "not known", taker.type || "not known"],
      ...giver.qos || taker.qos ? [["QoS", giver.qos ?? "not known", taker.qos ?? "not known"]] : []
    ];
    const [head2 = [], ...body] = rows2;
    const line4 = ([title2 = "", left = "", right = ""]) => element2("tr", { class: left !== right && title2 !== "in the code" ? "parts" : null }, element2("th", { scope: "row" }, title2), element2("td", {}, element2("code", {}, left)), element2("td", {}, element2("code", {}, right)));
    return element2(
      "div",
      { class: "near" },
      element2("table", { class: "beside" }, element2("thead", {}, element2("tr", {}, ...head2.map((each) => element2("th", { scope: "col" }, each)))), element2("tbody", {}, ...body.map(line4))),
      element2("p", { class: "apart" }, apart),
      element2("p", {}, element2("b", {}, "To join them: "), edit),
      element2("p", { class: "note" }, "See ", channelReference(page, giver.channel), " and ", channelReference(page, taker.channel))
    );
  }
  function remapRows(giver, taker) {
    const steps = (each) => each.remaps.filter(([from, to]) => from !== to).map(([, to]) => to);
    const [left, right] = [steps(giver), steps(taker)];
    return Array.from({ length: Math.max(left.length, right.length) }, (_, at) => [`after remap ${at + 1}`, left[at] ?? "", right[at] ?? ""]);
  }
  var nameOf = (model, each) => {
    var _a;
    return ((_a = model.entry.channels[each.channel]) == null ? void 0 : _a.name) ?? "";
  };
  function unknownNote(model, nodes) {
    const names2 = nodes.flatMap((each) => {
      var _a, _b;
      return ((_a = model.entry.nodes[each]) == null ? void 0 : _a.knowledge) === "unknown" ? [(_b = model.entry.nodes[each]) == null ? void 0 : _b.name] : [];
    });
    return names2.length > 0 && element2("p", { class: "note" }, `What ${names2.join(" and ")} ${names2.length > 1 ? "do" : "does"} is not known, so more may connect them.`);
  }
  function topicPanel(page, model, node, channel) {
    var _a, _b;
    const name = ((_a = model.entry.channels[channel]) == null ? void 0 : _a.name) ?? "";
    const own = (model.ofNode[node] ?? []).filter((each) => each.channel === channel);
    const title2 = heading("A node and a name", `${((_b = model.entry.nodes[node]) == null ? void 0 : _b.name) ?? ""} and ${name}`, []);
    if (own.length > 0) return [...title2, block("Connected", list(own.map((each) => element2("div", {}, nodeReference(page, node), ` ${does(each.role)} `, channelReference(page, channel)))))];
    const others = [...new Set((model.onChannel[channel] ?? []).map((each) => each.node))].filter((each) => each !== node);
    const near = others.flatMap((other) => [...nearMisses(model, other, node, (place2) => page.model.place(place2)), ...nearMisses(model, node, other, (place2) => page.model.place(place2))]);
    const about = near.filter((each) => each.giver.channel === channel || each.taker.channel === channel).slice(0, 3);
    return [
      ...title2,
      about.length > 0 ? block("Not connected", ...about.map((each) => nearItem(page, model, each))) : block("Not connected", element2("p", {}, "Nothing that the node gives or takes is like this name.")),
      unknownNote(model, [node])
    ];
  }

  // launchlint/report/html/js/page/panel_channel.js
  var KINDS = {
    topic: ["Topic", ["publisher", "subscriber"]],
    service: ["Service", ["server", "client"]],
    action: ["Action", ["action server", "action client"]]
  };
  function channelPanel(page, model, index) {
    const channel = model.entry.channels[index];
    if (!channel) return [];
    const [noun, [offering, using]] = KINDS[channel.kind];
    const ends2 = (model.onChannel[index] ?? []).filter((each) => isIn(each, page.store.get().configuration));
    const badges = [
      channel.hub && badge2("hub: everybody uses it"),
      channel.plumbing && badge2("machinery"),
      channel.mark && badge2(channel.mark, channel.mark),
      channel.types.length > 1 && badge2(`${channel.types.length} types`, "error")
    ];
    const types = channel.types.map((type) => element2("div", {}, element2("code", {}, type), ...md5(page, type)));
    const sides2 = ROLE_ORDER.flatMap((role) => {
      const those2 = ends2.filter((each) => each.role.replace("_", " ") === role);
      return those2.length > 0 ? endBlock(page, nounOf(role), those2, channel.types.length > 1) : [];
    });
    const offered = ends2.some((each) => each.offers);
    const used = ends2.some((each) => !each.offers);
    return [
      ...heading(noun, channel.name, badges),
      types.length > 0 ? list(types, "types") : element2("p", { class: "note" }, "Its type is not known."),
      findingsBlock(page, channel.findings),
      !channel.hub && !channel.plumbing && pairField(page, model, `c:${index}`),
      ...sides2,
      offered !== used && aloneBlock(page, model, index, offered ? offering : using, offered)
    ];
  }
  function md5({ model }, type) {
    return (model.md5s.get(type) ?? []).map((each) => element2("div", { class: "note" }, "MD5 ", element2("code", {}, each)));
  }
  function endBlock(page, title2, those2, withType) {
    const items = those2.map(
      (each) => element2(
        "div",
        { class: `connection ${each.mark ?? ""}`.trim() },
        element2("div", { class: "name" }, nodeReference(page, each.node)),
        ...connectionFacts(page, each, withType)
      )
    );
    return block(`${title2}: ${items.length}`, list(items, "connections"));
  }
  function aloneBlock(page, model, index, role, offered) {
    const { hub, plumbing } = model.entry.channels[index] ?? {};
    const doubts = mayBeAt(model, index, !offered, page.store.get().configuration);
    const words2 = missed(role, doubts);
    const others = "A node that another launch file starts, or a person at a terminal, may be at the other end.";
    const reasons = doubts.map(([, node, , why2]) => {
      var _a;
      const [at] = model.nodesNamed.get(node) ?? [];
      const reason = why2 || at !== void 0 && ((_a = model.entry.nodes[at]) == null ? void 0 : _a.reason) || "";
      return element2("div", {}, at !== void 0 && nodeReference(page, at), element2("div", { class: "note" }, reason));
    });
    return block(
      `${words2.charAt(0).toUpperCase()}${words2.slice(1)}`,
      reasons.length > 0 ? list(reasons) : element2("p", {}, hub || plumbing ? "That is usual here: ROS's own tools use it." : others)
    );
  }
  function paramPanel(page, model, index) {
    const param = model.entry.params[index];
    if (!param) return [];
    const same = (model.paramsNamed.get(param.name) ?? []).filter((each) => each !== index);
    const others = same.flatMap((each) => model.entry.params[each] ?? []);
    return [
      ...heading("Param", param.name, [param.mark && badge2(param.mark, param.mark)]),
      element2("pre", { class: "value", tabindex: 0, role: "group", "aria-label": "Value" }, param.value || "(empty)"),
      findingsBlock(page, param.findings),
      block(
        "Read by",
        param.readers.length > 0 ? list(param.readers.map((node) => nodeReference(page, node))) : element2("p", { class: "note" }, "No node is known to read it.")
      ),
      sourceBlock(page, param.place, "Set at"),
      ...[...param.overrides].reverse().map(([value, place2]) => sourceBlock(page, place2, `Overrides ${value || "an empty value"}, set at`)),
      ...others.map((each) => sourceBlock(page, each.place, `In other configurations: ${each.value}`)),
      presenceBlock(page, param.only)
    ];
  }

  // launchlint/report/html/js/page/interface.js
  function interfaceOf(model, inside, configuration) {
    const found2 = { incoming: [], outgoing: [], looseIn: [], looseOut: [] };
    const touched = new Set([...inside].flatMap((node) => (model.ofNode[node] ?? []).map((each) => each.channel)));
    for (const channel of [...touched].sort((one2, other) => one2 - other)) {
      const { kind, hub, plumbing } = model.entry.channels[channel] ?? { kind: "topic", hub: true, plumbing: true };
      if (hub || plumbing) continue;
      const ends2 = (model.onChannel[channel] ?? []).filter((each) => isIn(each, configuration) && each.mark !== "removed");
      const has = (gives2, within2) => ends2.some((each) => kind === "topic" === each.offers === gives2 && inside.has(each.node) === within2);
      if (has(true, true) && has(false, false)) found2.outgoing.push(channel);
      if (has(false, true) && has(true, false)) found2.incoming.push(channel);
      const loose = (gives2) => has(gives2, true) && !has(!gives2, true) && !has(!gives2, false);
      if (loose(true)) found2.looseOut.push(channel);
      if (loose(false)) found2.looseIn.push(channel);
    }
    return found2;
  }

  // launchlint/report/html/js/page/panel_container.js
  var KINDS2 = { root: "Everything", namespace: "Namespace", group: "Group", include: "Include", package: "Package", machine: "Machine", range: "Neighbours", tray: "Without a connection" };
  function containerPanel(page, model, id) {
    var _a, _b;
    const { grouping, configuration } = page.store.get();
    const group3 = containerOf(model.entry, grouping, id);
    if (!group3) return [];
    const nodes = nodesWithin(group3);
    const findings = findingsWithin(model.entry, group3);
    const place2 = ((_a = model.entry.containers[group3.container]) == null ? void 0 : _a.place) ?? null;
    const { incoming, outgoing, looseIn, looseOut } = interfaceOf(model, new Set(nodes), configuration);
    const args = ((_b = model.entry.containers[group3.container]) == null ? void 0 : _b.args) ?? [];
    const inner = group3.groups.map((each) => [reference(page, { kind: "container", id: each.id }, fullName(each)), ` ${number(each.count, "node")}`]);
    return [
      ...heading(KINDS2[group3.kind], fullName(group3), [], [openButton(page, id), focusButton(page, id, "Focus on it"), hideButton(page, id)]),
      findingsBlock(page, findings),
      args.length > 0 && argsBlock(args),
      channels(page, "Comes in", incoming),
      channels(page, "Goes out", outgoing),
      channels(page, "Waits for what nobody here is known to offer", looseIn),
      channels(page, "Offers what nobody here is known to use", looseOut),
      inner.length > 0 && block("Contains", list(inner.map((each) => element2("div", {}, ...each)))),
      group3.nodes.length > 0 && block(number(group3.nodes.length, "node"), list(group3.nodes.map((each) => nodeReference(page, each)))),
      sourceBlock(page, place2)
    ];
  }
  function argsBlock(args) {
    const rows2 = args.map(
      ([name, value, fallback]) => element2(
        "tr",
        {},
        element2("th", { scope: "row" }, element2("code", {}, name)),
        element2("td", {}, value === null ? element2("span", { class: "note" }, "default") : element2("code", {}, value || "(empty)")),
        element2("td", {}, fallback === null ? element2("span", { class: "note" }, "none") : element2("code", {}, fallback || "(empty)"))
      )
    );
    const head2 = element2("tr", {}, ...["Arg", "Passed", "Default"].map((each) => element2("th", { scope: "col" }, each)));
    return block(number(args.length, "arg"), element2("table", { class: "args" }, element2("thead", {}, head2), element2("tbody", {}, ...rows2)));
  }
  function openButton({ store, drawing }, id) {
    const open = drawing.expanded().has(id);
    return button(open ? "Collapse" : "Expand", () => {
      const expanded = drawing.expanded();
      if (open) expanded.delete(id);
      else expanded.add(id);
      store.set({ expanded });
    });
  }
  function channels(page, title2, those2) {
    return those2.length > 0 && block(title2, list(those2.map((each) => channelReference(page, each))));
  }

  // launchlint/report/html/js/page/panel_edge.js
  function edgePanel(page, model, id) {
    const wires = page.drawing.wiresOf({ kind: "edge", id });
    const channels2 = wires.filter((each) => each.startsWith("c:")).map((each) => Number(each.slice(2)));
    const params = wires.filter((each) => each.startsWith("p:"));
    if (wires.length === 0) return [];
    const kinds = new Set(channels2.map((each) => {
      var _a;
      return ((_a = model.entry.channels[each]) == null ? void 0 : _a.kind) ?? "topic";
    }));
    const [kind] = kinds;
    const noun = params.length > 0 ? "param" : kinds.size === 1 && kind ? kind : "name";
    return [
      ...heading("Line", number(wires.length, noun), []),
      element2("p", { class: "note" }, "What runs along this line:"),
      ...channels2.map((each) => channelBlock(page, model, each)),
      params.length > 0 && list(params.map((each) => {
        var _a;
        return reference(page, { kind: "param", id: each }, ((_a = model.entry.params[Number(each.slice(2))]) == null ? void 0 : _a.name) ?? "");
      }))
    ];
  }
  function channelBlock(page, model, channel) {
    var _a, _b;
    const ends2 = model.onChannel[channel] ?? [];
    const nodes = (offers) => [...new Set(ends2.filter((each) => each.offers === offers).map((each) => each.node))];
    const side = (title2, those2) => those2.length > 0 && element2("div", {}, element2("span", { class: "note" }, title2), list(those2.map((each) => nodeReference(page, each))));
    const topic = ((_a = model.entry.channels[channel]) == null ? void 0 : _a.kind) === "topic";
    return block(
      "",
      element2("div", { class: "name" }, channelReference(page, channel)),
      element2("div", { class: "type" }, element2("code", {}, ((_b = model.entry.channels[channel]) == null ? void 0 : _b.types.join(", ")) ?? "")),
      side(topic ? "from" : "served by", nodes(true)),
      side(topic ? "to" : "called by", nodes(false))
    );
  }

  // launchlint/report/html/js/page/panel_finding.js
  function findingPanel(page, id) {
    const index = page.model.finding(id);
    const finding = page.model.data.findings[index];
    if (!finding) return [];
    return [
      ...heading(`${finding.rule} ${finding.name}`, finding.message, [badge2(finding.severity, finding.severity)]),
      source(page.model, finding.place, finding),
      (finding.help || finding.fix) && block("What to do", finding.help && element2("p", {}, finding.help), fix(finding)),
      finding.notes.length > 0 && list(finding.notes, "notes"),
      ...finding.related.map(([place2, label2]) => block(label2 || "See also", source(page.model, place2))),
      aboutBlock(page, index),
      finding.chain.length > 0 && block(
        "How the launch file gets there",
        element2("ol", { class: "steps" }, ...finding.chain.map((step) => element2("li", {}, written(page.model, step))))
      ),
      finding.show && block("Shown by", element2("pre", { class: "command" }, finding.show)),
      entriesBlock(page, finding, index),
      block("Why it matters", element2("pre", { class: "command" }, `launchlint explain ${finding.rule}`))
    ];
  }
  function fix(finding) {
    if (!finding.fix) return null;
    const how = finding.fixSafe ? "launchlint check --fix" : "launchlint check --fix --unsafe-fixes";
    return element2("p", {}, `${finding.fix} (`, element2("code", {}, how), ")");
  }
  function aboutBlock(page, index) {
    const model = page.model.entry(page.store.get().entry);
    const items = [
      ...(model.nodesWithFinding.get(index) ?? []).map((each) => nodeReference(page, each)),
      ...(model.channelsWithFinding.get(index) ?? []).map((each) => channelReference(page, each)),
      ...(model.paramsWithFinding.get(index) ?? []).map(
        (each) => {
          var _a;
          return reference(page, { kind: "param", id: `p:${each}` }, ((_a = model.entry.params[each]) == null ? void 0 : _a.name) ?? "");
        }
      ),
      ...containersWith(model.entry, page.store.get().grouping, index).map((each) => reference(page, { kind: "container", id: each.id }, fullName(each)))
    ];
    return items.length > 0 && block("In the drawing", list(items));
  }
  function entriesBlock(page, finding, index) {
    const { entries, files } = page.model.data;
    const others = entries.flatMap((each, at) => each.findings.includes(index) && at !== page.store.get().entry ? [at] : []);
    const items = others.map((at) => {
      var _a;
      return reference(page, { kind: "finding", id: finding.id }, files[((_a = entries[at]) == null ? void 0 : _a.file) ?? -1] ?? "", at);
    });
    return items.length > 0 && block("Also reached from", list(items));
  }

  // launchlint/report/html/js/page/panel_node.js
  var MOST_IDLE = 5;
  var KINDS3 = { manager: "Nodelet manager", nodelet: "Nodelet", container: "Component container", component: "Component" };
  function nodePanel(page, model, index) {
    const node = model.entry.nodes[index];
    if (!node) return [];
    const { configuration } = page.store.get();
    const kind = node.isTest ? "Test node" : KINDS3[node.kind] ?? "Node";
    const badges = [
      node.knowledge === "unknown" && badge2("interface not known", "unknown"),
      node.lifecycle && badge2("lifecycle: somebody has to configure and activate it"),
      node.mark && badge2(node.mark, node.mark),
      (node.conditions.length > 0 || node.only.length > 0) && badge2("conditional", "conditional")
    ];
    const namespace = node.namespace !== "/" && `g:namespace:${node.namespace}`;
    const actions = [
      namespace && page.store.get().grouping === "namespace" && focusButton(page, namespace, `Focus on ${node.namespace}`),
      hideButton(page, `n:${index}`)
    ];
    const connections = (model.ofNode[index] ?? []).filter((each) => isIn(each, configuration));
    return [
      ...heading(kind, node.name, badges, actions),
      element2("p", {}, "runs ", element2("code", {}, node.program), host(page, model, node), machine(node)),
      pairField(page, model, `n:${index}`),
      guestsBlock(page, model, node),
      findingsBlock(page, node.findings),
      node.related.length > 0 && block("Findings elsewhere that speak of it", findingList(page, node.related)),
      node.knowledge === "unknown" && unknownBlock(node, model.entry.mend),
      ...ROLE_ORDER.map((role) => roleBlock(page, model, role, connections)),
      openBlock(node),
      partlyBlock(node),
      paramsBlock(page, model, index, configuration),
      presenceBlock(page, node.only, node.conditions),
      sourceBlock(page, node.place),
      includesBlock(page, model, node)
    ];
  }
  function host(page, model, node) {
    if (node.kind !== "nodelet" && node.kind !== "component" || !node.host) return [];
    const [manager] = model.nodesNamed.get(node.host) ?? [];
    return [" inside ", manager === void 0 ? element2("code", {}, node.host) : nodeReference(page, manager)];
  }
  function guestsBlock(page, model, node) {
    if (node.kind !== "manager" && node.kind !== "container") return null;
    const guests = model.entry.nodes.flatMap((each, index) => each !== node && each.host === node.name ? [index] : []);
    return guests.length > 0 && block(`In its process: ${guests.length}`, list(guests.map((each) => nodeReference(page, each))));
  }
  function machine({ machine: [name, address] }) {
    if (name === void 0) return [];
    const where = address ? ` (${address})` : ", which no launch file here declares";
    return [" on the machine ", element2("code", {}, name), where];
  }
  function roleBlock(page, model, role, connections) {
    const those2 = connections.filter((each) => {
      var _a;
      return each.role.replace("_", " ") === role && !((_a = model.entry.channels[each.channel]) == null ? void 0 : _a.plumbing);
    });
    if (those2.length === 0) return null;
    const { configuration } = page.store.get();
    const title2 = does(role);
    const item2 = (each) => element2(
      "div",
      { class: `connection ${each.mark ?? ""}`.trim() },
      element2("div", { class: "name" }, channelReference(page, each.channel)),
      ...connectionFacts(page, each),
      peerList(page, peers(model, each, configuration), each)
    );
    const isIdle = (each) => !each.certain && peers(model, each, configuration).length === 0;
    const idle = those2.filter(isIdle);
    const folded = idle.length > MOST_IDLE ? idle : [];
    const shown2 = those2.filter((each) => !folded.includes(each));
    const more = () => element2(
      "details",
      {},
      element2("summary", {}, `${folded.length} ${shown2.length > 0 ? "more " : ""}that it may have, and nobody is known to use`),
      list(folded.map(item2), "connections")
    );
    return block(
      `${title2.charAt(0).toUpperCase()}${title2.slice(1)}`,
      shown2.length > 0 && list(shown2.map(item2), "connections"),
      folded.length > 0 && more()
    );
  }
  function openReasons({ open }) {
    const kinds = /* @__PURE__ */ new Map();
    for (const [kind, why2] of open) kinds.set(why2, [...kinds.get(why2) ?? [], kind]);
    return [...kinds].map(([why2, those2]) => `${[those2.slice(0, -1).join(", "), ...those2.slice(-1)].filter(Boolean).join(" and ")}: ${why2}`);
  }
  function openBlock(node) {
    if (node.open.length === 0 || node.knowledge === "unknown") return null;
    return block("There may be more", list(openReasons(node)));
  }
  function partlyBlock({ partly }) {
    if (partly.length === 0) return null;
    const items = partly.map(([kind, pattern]) => element2("div", {}, `${kind}: `, pattern === "*" ? "any name" : element2("code", {}, pattern)));
    return block("Names known only in part", list(items));
  }
  function unknownBlock({ reason, learn }, mend) {
    const why2 = reason.charAt(0).toUpperCase() + reason.slice(1);
    return block(
      "What it does is not known",
      element2("p", {}, `${why2 ? `${why2}. ` : ""}So launchlint cannot say what it is connected to, and keeps quiet about it.`),
      learn === "probe" && commandPart(mend.command, "To know it, run this, then make the page again:"),
      learn === "sources" && element2("p", {}, "Its package is not in the workspace: put the sources there, or name their directory with --workspace, and launchlint reads them by itself.")
    );
  }
  function paramsBlock(page, model, index, configuration) {
    const those2 = (model.paramsOf[index] ?? []).filter((each) => isIn(model.entry.params[each] ?? { only: [] }, configuration));
    if (those2.length === 0) return null;
    const items = those2.flatMap((at) => {
      const param = model.entry.params[at];
      if (!param) return [];
      const read3 = param.readers.includes(index) ? "" : "not known to be read";
      return element2(
        "div",
        { class: "param" },
        element2("div", { class: "name" }, reference(page, { kind: "param", id: `p:${at}` }, param.name)),
        element2("code", { class: "value" }, param.value),
        element2("div", { class: "note" }, param.place && written(page.model, param.place), read3 && ` · ${read3}`),
        param.overrides.length > 0 && element2("div", { class: "note" }, "overrides ", element2("code", {}, param.overrides.map(([value]) => value).join(", ")))
      );
    });
    return block(number(items.length, "param"), list(items, "params"));
  }
  function includesBlock(page, model, node) {
    var _a;
    const steps = [];
    for (let at = node.container; at >= 0 && steps.length < 64; at = ((_a = model.entry.containers[at]) == null ? void 0 : _a.parent) ?? -1) {
      const container = model.entry.containers[at];
      if (!container) break;
      steps.unshift(
        element2(
          "li",
          {},
          `${container.kind} `,
          element2("code", {}, container.label || container.namespace),
          " ",
          container.place && written(page.model, container.place)
        )
      );
    }
    return steps.length > 0 && block("How the launch file gets there", element2("ol", { class: "steps" }, ...steps));
  }

  // launchlint/report/html/js/page/panel_overview.js
  function overviewPanel(page, model) {
    const { entry } = model;
    const { configuration } = page.store.get();
    const findings = findingsIn(model, configuration);
    const fixed = entry.fixed.flatMap((each) => page.model.data.fixed[each] ?? []);
    return [
      element2("p", { class: "kind" }, "Launch file"),
      element2("h2", { tabindex: -1 }, page.model.data.files[entry.file] ?? ""),
      entry.verdict === "refused" && element2("p", { class: "refused" }, badge2("refused", "error"), ` ${entry.launcher} does not load it: ${entry.why}`),
      entry.verdict === "cannot be told" && element2("p", {}, badge2("cannot be told", "warning"), ` whether ${entry.launcher} loads it: ${entry.why}`),
      entry.withArgs !== "" && element2("p", { class: "refused" }, badge2("refused with other args", "error"), ` ${entry.withArgs.replace(/^refused /, "")}`),
      !entry.complete && element2("p", { class: "note" }, `${entry.python ? "Not everything could be followed" : "An include could not be followed"}, so there may be more nodes than are shown.`),
      ...page.model.data.notices.map((each) => element2("p", { class: "note" }, each)),
      ...changesBlocks(page, model),
      findings.length > 0 ? block(`What is wrong (${findings.length})`, findingList(page, findings)) : block("What is wrong", element2("p", {}, "Nothing was found. Mistakes that only show while the robot runs are not looked for.")),
      fixed.length > 0 && block(`Fixed since ${page.model.data.base} (${fixed.length})`, list(fixed.map(({ rule, message }) => element2("div", {}, badge2("fixed", "since fixed"), " ", element2("code", {}, rule), ` ${message}`)), "findings")),
      ...(entry.python ?? []).map(
        (each) => block(
          `Python, known ${each.state === "not" ? "not at all" : "in part"}: ${each.file}`,
          element2("p", {}, "It is read and not run. Not known without running it:"),
          list(each.reasons.map(([line4, why2]) => `line ${line4}: ${why2}`))
        )
      ),
      ...entry.nodes.length > 0 ? connectedBlocks(page, model, configuration) : [nothingBlock(entry.complete)]
    ];
  }
  function connectedBlocks(page, model, configuration) {
    const unknown = model.entry.nodes.flatMap(
      (each, index) => each.knowledge === "unknown" && each.mark !== "removed" && isIn(each, configuration) ? [index] : []
    );
    const topics = model.entry.channels.flatMap(({ kind, hub, plumbing }, index) => {
      const ends2 = endsOf(model, index, configuration);
      return kind === "topic" && !hub && !plumbing && (ends2.offered || ends2.used) ? [{ index, ...ends2 }] : [];
    });
    const connected = topics.filter((each) => each.offered && each.used).length;
    const waiting = topics.filter((each) => !each.offered && each.certain);
    const unheard = topics.filter((each) => !each.used && each.certain);
    const share = shareKnown(model, configuration);
    const inDoubt = (index, offers) => mayBeAt(model, index, offers, configuration).length > 0;
    const numbers = (those2) => those2.map((each) => each.index);
    const doubtful = (those2, offers) => numbers(those2).filter((each) => inDoubt(each, offers));
    const doubtless = (those2, offers) => numbers(those2).filter((each) => !inDoubt(each, offers));
    return [
      block(
        "Does it connect?",
        element2(
          "p",
          {},
          topics.length > 0 ? `${connected} of ${number(topics.length, "topic")} ${connected === 1 ? "has" : "have"} both ends.` : "No topic is known.",
          share && ` ${share}.`
        ),
        loosePart(page, "Nobody publishes, yet a node waits for it:", doubtless(waiting, true)),
        loosePart(page, "Nobody here is known to publish, yet somebody may:", doubtful(waiting, true)),
        loosePart(page, "Nobody in this launch file subscribes:", doubtless(unheard, false)),
        loosePart(page, "Nobody here is known to subscribe, yet somebody may:", doubtful(unheard, false))
      ),
      unknown.length > 0 && unknownBlock2(page, model, unknown)
    ];
  }
  function shareKnown({ entry }, configuration) {
    const [known6, nodes] = entry.sight;
    if (nodes === 0 || configuration > 0) return "";
    return `${known6} of ${number(nodes, "node")} known${entry.configurations.length > 1 ? " when it is started without args" : ""}`;
  }
  function loosePart(page, title2, channels2) {
    return channels2.length > 0 && [
      element2("p", { class: "note" }, title2),
      list(
        channels2.map((each) => channelReference(page, each)),
        "loose"
      )
    ];
  }
  function unknownBlock2(page, model, unknown) {
    var _a;
    const { entry } = model;
    const all = unknown.length === entry.nodes.length;
    const what = all ? "Nothing is known of any of these nodes, so no connections can be drawn. Names, params and what is wrong in the files are complete all the same." : "Nothing is drawn from or to these, because nothing says what they do:";
    const programs = /* @__PURE__ */ new Map();
    for (const index of unknown) {
      const program2 = ((_a = entry.nodes[index]) == null ? void 0 : _a.program) ?? "";
      programs.set(program2, [...programs.get(program2) ?? [], index]);
    }
    const items = [...programs].map(([program2, nodes]) => {
      var _a2;
      const reason = ((_a2 = entry.nodes[nodes[0] ?? -1]) == null ? void 0 : _a2.reason) ?? "";
      const why2 = reason.replaceAll(`the nodelet class ${program2}`, "it").replaceAll(program2, "it");
      return element2("div", {}, ...nodes.flatMap((each, at) => [at > 0 && ", ", nodeReference(page, each)]), element2("div", { class: "note" }, element2("code", {}, program2), why2 && `: ${why2}`));
    });
    return block(
      `${number(unknown.length, "node")} not known`,
      element2("p", {}, what),
      list(items),
      commandPart(entry.mend.command, "To know those whose packages are here, run this, then make the page again:"),
      entry.mend.advice && element2("p", {}, `${entry.mend.advice}.`)
    );
  }
  function nothingBlock(complete) {
    const said2 = complete ? "This launch file starts no nodes: it may only set params, or declare what other launch files include." : "Which nodes this launch file starts is not known.";
    return block(
      "Nothing to draw",
      element2("p", {}, said2),
      element2("p", {}, "Choose another entry file above; params and findings are in the tables below.")
    );
  }

  // launchlint/report/html/js/page/panel.js
  var MARGIN5 = 24;
  function createPanel(page) {
    const host2 = part("panel");
    page.store.listen((state, before) => {
      var _a;
      if (state !== before && !concerns(state, before)) return;
      const hadFocus = host2.contains(document.activeElement);
      show(page, host2, state);
      if (hadFocus) (_a = host2.querySelector("h2")) == null ? void 0 : _a.focus();
      if (state.selection !== before.selection) host2.scrollTop = 0;
    });
  }
  function show(page, host2, state) {
    const model = page.model.entry(state.entry);
    const content = state.selection ? panelOf(page, state.selection) : [];
    if (content.length === 0) {
      fill(host2, ...overviewPanel(page, model));
      return;
    }
    const close = button("Close", () => select(page, null), { class: "close", "aria-label": "Close: back to the overview" });
    fill(host2, element2("div", { class: "panel-bar" }, close), ...content);
    for (const mark of host2.querySelectorAll("mark")) bringIntoView(mark);
  }
  function bringIntoView(mark) {
    const lines = mark.closest("pre");
    if (lines) lines.scrollLeft += Math.max(0, mark.getBoundingClientRect().right - lines.getBoundingClientRect().right + MARGIN5);
  }
  function panelOf(page, { kind, id }) {
    const model = page.model.entry(page.store.get().entry);
    const index = Number(id.slice(2));
    if (kind === "node") return nodePanel(page, model, index);
    if (kind === "channel") return channelPanel(page, model, index);
    if (kind === "param") return paramPanel(page, model, index);
    if (kind === "container") return containerPanel(page, model, id);
    if (kind === "pair") return pairPanel(page, model, id);
    return kind === "finding" ? findingPanel(page, id) : edgePanel(page, model, id);
  }
  function concerns(state, before) {
    var _a;
    const keys = (
      /** @type {const} */
      ["selection", "entry", "configuration", "grouping", "focus", "hidden"]
    );
    return keys.some((key) => state[key] !== before[key]) || ((_a = state.selection) == null ? void 0 : _a.kind) === "container" && state.expanded !== before.expanded;
  }

  // launchlint/report/html/js/page/print.js
  var MARGIN6 = 8;
  function preparePrint() {
    let undo = [];
    window.addEventListener("beforeprint", () => {
      const { dataset } = document.documentElement;
      const theme = dataset["theme"];
      dataset["theme"] = "light";
      undo = [() => theme === void 0 ? delete dataset["theme"] : dataset["theme"] = theme];
      const svg = part("drawing").querySelector(":scope > svg");
      const content = svg == null ? void 0 : svg.querySelector(":scope > g");
      if (!svg || !(content instanceof SVGGElement)) return;
      const { x, y, width, height } = content.getBBox();
      svg.setAttribute("viewBox", [x - MARGIN6, y - MARGIN6, width + 2 * MARGIN6, height + 2 * MARGIN6].join(" "));
      svg.classList.add("printing");
      undo.push(
        () => svg.removeAttribute("viewBox"),
        () => svg.classList.remove("printing")
      );
    });
    window.addEventListener("afterprint", () => {
      for (const each of undo.splice(0)) each();
    });
  }

  // launchlint/report/html/js/page/sheets.js
  var SHEETS = [
    ["stage", "Drawing"],
    ["tree", "Tree"],
    ["panel", "Details"],
    ["tables", "Tables"]
  ];
  function createSheets(page, openTable) {
    const buttons = SHEETS.map(([sheet, label2]) => (
      /** @type {const} */
      [sheet, button(label2, () => show2(sheet))]
    ));
    document.body.append(element2("nav", { id: "sheets", "aria-label": "Parts of the page" }, ...buttons.map(([, each]) => each)));
    function show2(now) {
      document.body.dataset["sheet"] = now;
      if (now === "tables") openTable();
      for (const [sheet, each] of buttons) each.setAttribute("aria-pressed", String(sheet === now));
    }
    show2("stage");
    page.store.listen((state, before) => {
      if (state.selection && state.selection !== before.selection && document.body.dataset["sheet"] !== "stage") show2("panel");
    });
  }

  // launchlint/report/html/js/page/stage.js
  var DRAWN = (
    /** @type {const} */
    [
      "entry",
      "configuration",
      "grouping",
      "expanded",
      "focus",
      "layers",
      "topicsAsNodes",
      "hubs",
      "danglingOnly",
      "findingsOnly",
      "tray",
      "filter",
      "hidden",
      "matches"
    ]
  );
  function createStage(page, { cameFromDrawing, holdFocus }) {
    const { store, drawing, model } = page;
    const told2 = element2("p", { class: "visually-hidden", role: "status" });
    const empty = element2("p", { class: "stage-empty", hidden: true });
    const note = element2("p", { class: "stage-note", hidden: true });
    part("stage").append(told2, empty, note);
    const host2 = part("drawing");
    let running = false;
    let stale = false;
    let placed = null;
    async function draw2() {
      stale = true;
      if (running) return;
      running = true;
      host2.setAttribute("aria-busy", "true");
      while (stale) {
        stale = false;
        const state = store.get();
        const giveBack = holdFocus();
        await drawing.show(state);
        giveBack();
        if (state.place && state.place !== placed) drawing.goTo(state.place);
        placed = state.place;
        drawing.select(drawnSelection(page, state));
        report(state);
      }
      running = false;
      host2.setAttribute("aria-busy", "false");
    }
    function report(state) {
      const shown2 = drawing.focusables().length;
      empty.hidden = shown2 > 0;
      empty.textContent = shown2 > 0 ? "" : whyEmpty(model.entry(state.entry), state);
      note.textContent = shown2 > 0 ? leftOut(drawing.extent(), state.place === null) : "";
      note.hidden = note.textContent === "";
      told2.textContent = shown2 > 0 ? `The drawing shows ${number(shown2, "thing")}.` : empty.textContent;
    }
    async function reveal(state) {
      const target2 = drawnSelection(page, state);
      if (!target2) return;
      const { entry } = model.entry(state.entry);
      if ((target2.kind === "node" || target2.kind === "container") && !drawing.isDrawn(target2)) {
        const outer = target2.kind === "node" ? around2(entry, state.grouping, Number(target2.id.slice(2))).map((group3) => group3.id) : outside(entry, state.grouping, target2.id);
        const expanded = /* @__PURE__ */ new Set([...drawing.expanded(), ...outer]);
        store.set({ expanded }, "replace");
        await finished();
      }
      if (!drawing.isDrawn(target2)) return;
      drawing.panTo(target2);
      if (store.get().place) store.set({ place: drawing.spot() }, "replace");
    }
    let finished = () => Promise.resolve();
    store.listen((state, before) => {
      const first = state === before;
      const changed = first || DRAWN.some((key) => state[key] !== before[key]);
      const selected = (first ? state.place === null : state.selection !== before.selection) && !cameFromDrawing();
      if (changed) {
        const done = draw2();
        finished = () => done;
        if (selected) void done.then(() => reveal(store.get()));
        return;
      }
      if (state.place !== before.place) {
        note.textContent = leftOut(drawing.extent(), state.place === null);
        note.hidden = note.textContent === "";
        if (state.place) drawing.goTo(state.place);
        placed = state.place;
      }
      if (state.selection === before.selection) return;
      drawing.select(drawnSelection(page, state));
      if (selected) void finished().then(() => reveal(store.get()));
    });
  }
  function drawnSelection(page, { selection, entry, configuration }) {
    const model = page.model.entry(entry);
    if ((selection == null ? void 0 : selection.kind) === "pair") return { kind: "way", id: pairWay(model, selection.id, configuration).join("|") };
    if ((selection == null ? void 0 : selection.kind) !== "finding") return selection;
    const finding = page.model.finding(selection.id);
    const [node] = model.nodesWithFinding.get(finding) ?? [];
    if (node !== void 0) return { kind: "node", id: `n:${node}` };
    const [channel] = model.channelsWithFinding.get(finding) ?? [];
    return channel === void 0 ? null : { kind: "channel", id: `c:${channel}` };
  }
  function leftOut({ folded, boxes, outside: outside2 }, untouched) {
    const words2 = [];
    if (folded > 0) words2.push(`${number(folded, "node")} in ${number(boxes, "folded box", "folded boxes")}`);
    if (untouched && outside2 > 0) words2.push(`${number(outside2, "box", "boxes")} at or beyond the edge: drag, or Fit`);
    return words2.join(" · ");
  }
  function whyEmpty({ entry }, state) {
    if (entry.nodes.length === 0 && !entry.complete)
      return "Which nodes this launch file starts is not known. Its params and findings are in the tables below.";
    if (entry.nodes.length === 0)
      return "This launch file starts no nodes, so there is nothing to draw. Its params and findings are in the tables below.";
    if (state.danglingOnly) return "Nothing is left unconnected here, as far as it is known.";
    if (state.findingsOnly) return "No finding is about anything that could be drawn here.";
    if (state.filter) return `Nothing here fits the filter “${state.filter}”.`;
    if (state.hidden.size > 0) return "All of it is hidden.";
    return "Nothing to draw in this view.";
  }

  // launchlint/report/html/js/page/steps.js
  function createSteps(page) {
    const { store, model } = page;
    const changed = model.data.entries.flatMap(({ changes, mark }, index) => changes.length > 0 || mark ? [index] : []);
    const sequence = createSequence(model);
    return (step) => {
      const { entry, selection, landing } = store.get();
      if (changed.length === 0) return;
      const here = landing ? -1 : changed.indexOf(entry);
      const targets = here < 0 ? [] : sequence(entry);
      const at = targets.findIndex((each) => each.kind === (selection == null ? void 0 : selection.kind) && each.id === selection.id);
      const inside = targets[at < 0 ? step > 0 ? 0 : -1 : at + step];
      if (inside && (at >= 0 || step > 0)) {
        store.set({ selection: inside });
        return;
      }
      for (let turn = 1; turn <= changed.length; turn += 1) {
        const from = here < 0 && step < 0 ? 0 : here;
        const next = changed[(from + step * turn + changed.length * 2) % changed.length];
        const others = next === void 0 ? [] : sequence(next);
        const target2 = others.at(step > 0 ? 0 : -1);
        if (next === void 0) return;
        store.set({ ...next === entry && !landing ? {} : { entry: next }, selection: target2 ?? null });
        return;
      }
    };
  }

  // launchlint/report/html/js/page/library.js
  var COLUMNS = ["Kind", "Name", "Type", "Detail", "Evidence"];
  function createLibrary({ model }, host2) {
    let filled = false;
    return () => {
      if (filled) return;
      filled = true;
      const { library, libraryLeftOut } = model.data;
      const foot = host2.querySelector("#foot");
      const programs = library.map((each, at) => program(each, at));
      const nothing = library.length === 0 && element2("p", { class: "empty" }, "Nothing is known of any program on this page.");
      const more = libraryLeftOut > 0 && element2("p", { class: "note" }, `${libraryLeftOut} more programs are in the libraries that were given.`);
      host2.append(...[nothing, ...programs, more, foot].filter((each) => each instanceof Element));
    };
  }
  function program({ kind, name, package: package_, status, interface: rows2, open }, at) {
    const title2 = kind === "nodelet" ? name : `${package_}/${name}`;
    const host2 = element2(
      "details",
      { class: "program", id: `program-${at}`, "data-index": at },
      element2("summary", {}, element2("h3", {}, title2), " ", element2("span", { class: "number" }, rows2.length), kind === "nodelet" && ` nodelet of ${package_}`)
    );
    host2.addEventListener(
      "toggle",
      () => {
        host2.append(...[status && element2("p", {}, status), rows2.length > 0 && table(rows2)].filter((each) => each instanceof Element));
        for (const [category, why2] of open) host2.append(element2("p", { class: "note" }, `It may have more ${category} than are listed: ${why2}`));
      },
      { once: true }
    );
    return host2;
  }
  function table(rows2) {
    const cells2 = rows2.map(({ category, name, type, detail, evidence }) => [category, name, type, detail, evidence.join("; ")]);
    return element2(
      "table",
      {},
      element2("thead", {}, element2("tr", {}, ...COLUMNS.map((each) => element2("th", { scope: "col" }, each)))),
      element2("tbody", {}, ...cells2.map((each) => element2("tr", {}, ...each.map((text2) => element2("td", {}, text2)))))
    );
  }

  // launchlint/report/html/js/page/rows.js
  var MOST_NAMES = 8;
  var KINDS4 = [
    {
      id: "findings",
      caption: "Findings",
      columns: ["Severity", "Rule", "Finding", "Place", "What to do"],
      named: 2,
      placed: 3,
      empty: "No rule found anything wrong here. Mistakes at nodes that are not known cannot be seen.",
      rows: findingRows,
      count: (model, configuration) => findingsIn(model, configuration).length
    },
    {
      id: "nodes",
      caption: "Nodes",
      columns: ["Node", "Program", "Known", "Place", "Findings"],
      named: 0,
      placed: 3,
      empty: "No node is started.",
      rows: nodeRows,
      count: ({ entry }, configuration) => entry.nodes.filter((each) => isIn(each, configuration)).length
    },
    channelTable("topic", "Topics", "No topic is known.", ["Publishers", "Subscribers"]),
    channelTable("service", "Services", "No service is known.", ["Servers", "Clients"]),
    channelTable("action", "Actions", "No action is known.", ["Servers", "Clients"]),
    {
      id: "params",
      caption: "Params",
      columns: ["Param", "Value", "Place", "Overrides", "Read by"],
      named: 0,
      placed: 2,
      empty: "No param is set.",
      rows: paramRows,
      count: ({ entry }, configuration) => entry.params.filter((each) => isIn(each, configuration)).length
    }
  ];
  function channelTable(kind, caption, empty, ends2) {
    return {
      id: `${kind}s`,
      caption,
      columns: [caption.slice(0, -1), "Type", ...ends2],
      named: 0,
      placed: -1,
      empty,
      rows: (model, configuration) => those(model, kind, configuration).map((at) => channelRow(model, at, configuration)),
      count: (model, configuration) => those(model, kind, configuration).length
    };
  }
  function findingRows(model, configuration, { data }) {
    return grouped(data, findingsIn(model, configuration)).flatMap(([first, ...more]) => {
      const finding = data.findings[first ?? -1];
      if (!finding) return [];
      const others = more.flatMap((each) => data.findings[each] ?? []);
      const place2 = `${data.files[finding.place[0]]}:${finding.place[1]}`;
      const [since, times] = [finding.since ? `${finding.since} ` : "", others.length > 0 ? ` (${others.length + 1} times)` : ""];
      return [
        {
          target: { kind: "finding", id: finding.id },
          entry: model.index,
          index: String(first),
          cells: [`${since}${finding.severity}`, `${finding.rule} ${finding.name}`, `${finding.message}${times}`, place2, finding.help],
          classes: [finding.severity, finding.since && `${finding.since}-finding`].filter(Boolean).join(" "),
          place: finding.place,
          others: others.map((each) => (
            /** @type {Target} */
            { kind: "finding", id: each.id }
          ))
        }
      ];
    });
  }
  function nodeRows(model, configuration, page) {
    return model.entry.nodes.flatMap((node, at) => {
      if (!isIn(node, configuration)) return [];
      const known6 = node.knowledge === "unknown" ? "unknown" : "known";
      const cells2 = [node.name, node.program, known6, node.place ? page.place(node.place) : "", node.findings.length ? String(node.findings.length) : ""];
      return [row(model, "node", at, cells2, node.mark, node.place)];
    });
  }
  function those(model, kind, configuration) {
    return model.entry.channels.flatMap((each, at) => each.kind === kind && !each.plumbing && isUsedIn(model, at, configuration) ? [at] : []);
  }
  function channelRow(model, at, configuration) {
    const channel = model.entry.channels[at];
    if (!channel) throw new RangeError(`there is no channel ${at}`);
    const sides2 = [true, false].map((offers) => {
      const ends2 = (model.onChannel[at] ?? []).filter((each) => each.offers === offers && each.mark !== "removed" && isIn(each, configuration));
      return some(ends2.map((each) => {
        var _a;
        return ((_a = model.entry.nodes[each.node]) == null ? void 0 : _a.name) ?? "";
      })) || nobody(model, at, offers, configuration);
    });
    return row(model, "channel", at, [channel.name, channel.types.join(", "), ...sides2], channel.mark, null);
  }
  function nobody(model, at, offers, configuration) {
    const channel = model.entry.channels[at];
    if (!channel || channel.mark === "removed") return "";
    const who = doubted(mayBeAt(model, at, offers, configuration));
    return who ? `nobody here, but ${who} may` : channel.hub ? "" : "nobody";
  }
  function paramRows(model, configuration, page) {
    return model.entry.params.flatMap((param, at) => {
      if (!isIn(param, configuration)) return [];
      const earlier = param.overrides.map(([value, place2]) => `${value} at ${place2 ? page.place(place2) : ""}`).join("; ");
      const readers = some(param.readers.map((each) => {
        var _a;
        return ((_a = model.entry.nodes[each]) == null ? void 0 : _a.name) ?? "";
      }));
      return [row(model, "param", at, [param.name, param.value, param.place ? page.place(param.place) : "", earlier, readers], param.mark, param.place)];
    });
  }
  function row(model, kind, at, cells2, mark, place2) {
    return { target: { kind, id: `${kind.charAt(0)}:${at}` }, entry: model.index, index: String(at), cells: cells2, classes: mark ?? "", place: place2, others: [] };
  }
  function some(names2) {
    const all = [...new Set(names2)].sort();
    const more = all.length - MOST_NAMES;
    return `${all.slice(0, MOST_NAMES).join(", ")}${more > 0 ? ` and ${more} more` : ""}`;
  }

  // launchlint/report/html/js/page/table.js
  var MOST_ROWS = 12e3;
  var SEVERITIES2 = ["error", "warning", "info"];
  var collator = new Intl.Collator("en", { numeric: true });
  function createTable(page, kind) {
    let sorted = -1;
    let down = false;
    let again = () => {
    };
    const heads = kind.columns.map((column, at) => element2("th", { scope: "col" }, element2("button", { type: "button", click: () => sort(at) }, column)));
    const table2 = element2("table", { id: `table-${kind.id}` }, element2("thead", {}, element2("tr", {}, ...heads)));
    const note = element2("p", { class: "note", hidden: true });
    const empty = element2("p", { class: "empty", hidden: true }, kind.empty);
    const wide = element2("div", { class: "wide", tabindex: 0, role: "region", "aria-label": kind.caption }, table2);
    const host2 = element2("section", { class: "table", id: `drawer-table-${kind.id}` }, element2("h2", {}, kind.caption), wide, note, empty);
    const rows2 = /* @__PURE__ */ new Map();
    table2.addEventListener("click", (event) => {
      const target2 = (
        /** @type {Element} */
        event.target
      );
      const row2 = rows2.get(target2.closest("tr") ?? table2);
      if (!row2 || target2.closest("a, button, summary")) return;
      page.store.set({ ...row2.entry === page.store.get().entry ? {} : { entry: row2.entry }, landing: false, selection: row2.target });
    });
    function sort(column) {
      down = column === sorted && !down;
      sorted = column;
      heads.forEach((head2, at) => {
        if (at === column) head2.setAttribute("aria-sort", down ? "descending" : "ascending");
        else head2.removeAttribute("aria-sort");
      });
      again();
    }
    function inOrder(found2) {
      if (sorted < 0) return found2;
      return [...found2].sort((one2, other) => compare2(one2.cells[sorted] ?? "", other.cells[sorted] ?? "") * (down ? -1 : 1));
    }
    function made2(row2) {
      const cells2 = row2.cells.map((text2, column) => {
        if (column === kind.named) return element2("td", {}, reference(page, row2.target, text2, row2.entry), more(row2));
        if (column === kind.placed && row2.place) return element2("td", {}, written(page.model, row2.place));
        return element2("td", {}, text2);
      });
      const host3 = element2("tr", { "data-index": row2.index, class: row2.classes || null }, ...cells2);
      rows2.set(host3, row2);
      return host3;
    }
    function more(row2) {
      if (row2.others.length === 0) return null;
      const items = row2.others.map((each) => {
        const finding = page.model.data.findings[page.model.finding(each.id)];
        return element2("li", {}, reference(page, each, finding ? page.model.place(finding.place) : "", row2.entry));
      });
      return element2("details", { class: "others" }, element2("summary", {}, `${row2.others.length} more places`), element2("ul", {}, ...items));
    }
    return {
      host: host2,
      /** How many rows belong to the view; of all launch files with `everything`. @param {PageState} state @param {boolean} everything */
      count(state, everything) {
        if (everything && kind.id === "findings") return page.model.data.findings.length;
        return entriesOf(page, state, everything).reduce((sum, at) => sum + kind.count(page.model.entry(at), everything ? -1 : state.configuration), 0);
      },
      /**
       * Makes the rows that belong to the view.
       *
       * @param {PageState} state
       * @param {string} filter
       * @param {boolean} everything rows of all launch files
       */
      show(state, filter, everything) {
        again = () => this.show(page.store.get(), filter, everything);
        rows2.clear();
        const words2 = filter.toLowerCase().split(/\s+/).filter(Boolean);
        const fits = ({ cells: cells2 }) => words2.every((word) => cells2.some((text2) => text2.toLowerCase().includes(word)));
        const bodies = [];
        let [shown2, left] = [0, 0];
        const seen = /* @__PURE__ */ new Set();
        for (const at of entriesOf(page, state, everything)) {
          const all = kind.rows(page.model.entry(at), everything ? -1 : state.configuration, page.model).filter(fits);
          const found2 = inOrder(kind.id === "findings" ? all.filter(({ target: target2 }) => !seen.has(target2.id) && seen.add(target2.id)) : all);
          if (found2.length === 0) continue;
          if (shown2 > 0 && shown2 + found2.length > MOST_ROWS) {
            left += found2.length;
            continue;
          }
          shown2 += found2.length;
          const title2 = everything && element2("tr", { class: "entry" }, element2("th", { colspan: kind.columns.length, scope: "rowgroup" }, entryTitle(page.model.data, at)));
          bodies.push(element2("tbody", { "data-entry": at }, title2, ...found2.map(made2)));
        }
        fill(table2, table2.tHead, ...bodies);
        wide.hidden = shown2 === 0;
        empty.hidden = shown2 > 0;
        note.hidden = left === 0;
        note.textContent = `${left.toLocaleString("en")} more rows are left out: filter the rows, or open a launch file.`;
        this.mark(state);
      },
      /** Marks the row of what is selected. @param {PageState} state */
      mark({ selection, entry }) {
        for (const [host3, row2] of rows2) {
          const ids = [row2.target, ...row2.others];
          const is = selection !== null && row2.entry === entry && ids.some((each) => each.kind === selection.kind && each.id === selection.id);
          if (is && !host3.hasAttribute("aria-current")) host3.scrollIntoView({ block: "nearest" });
          if (is) host3.setAttribute("aria-current", "true");
          else host3.removeAttribute("aria-current");
        }
      }
    };
  }
  function entriesOf({ model }, { entry }, everything) {
    return everything ? model.data.entries.map((_, at) => at) : [entry];
  }
  function compare2(one2, other) {
    const [left, right] = [one2, other].map((each) => SEVERITIES2.findIndex((word) => each.endsWith(word) && each.length < word.length + 8));
    return left !== void 0 && right !== void 0 && left >= 0 && right >= 0 ? left - right : collator.compare(one2, other);
  }

  // launchlint/report/html/js/page/tables.js
  function createTables(page) {
    var _a, _b;
    const section = part("tables");
    const filter = element2("input", { type: "search", placeholder: "Filter rows", "aria-label": "Filter rows", spellcheck: "false" });
    const everything = element2("input", { type: "checkbox" });
    const several = page.model.data.entries.length > 1;
    const tools = element2("div", { class: "drawer-tools", hidden: true }, filter, several && element2("label", {}, everything, " all launch files"));
    const openers = element2("div", { class: "openers" });
    section.prepend(element2("div", { class: "drawer-bar" }, openers, tools));
    const drawers = KINDS4.map((kind) => {
      const table2 = createTable(page, kind);
      section.append(table2.host);
      return drawerOf(`table-${kind.id}`, table2.host, kind.caption, table2);
    });
    const unknown = part("unknown");
    section.append(unknown);
    drawers.push(drawerOf("table-unknown", unknown, ((_b = (_a = unknown.querySelector("h2")) == null ? void 0 : _a.textContent) == null ? void 0 : _b.trim()) ?? "", null));
    const library = part("library");
    drawers.push(drawerOf("library", library, "Library", null, createLibrary(page, library)));
    library.append(part("foot"));
    section.append(library);
    let open = null;
    function drawerOf(id, host2, title2, table2, fill2 = () => {
    }) {
      host2.hidden = true;
      if (host2 instanceof HTMLDetailsElement) host2.open = true;
      const opener = button("", () => turn(id), { "aria-expanded": "false", "aria-controls": host2.id });
      const [, words2 = title2, count3 = ""] = /^(.*?)\s*([\d,]*)$/s.exec(title2) ?? [];
      const counted2 = element2("span", { class: "number" }, count3);
      opener.append(words2, counted2);
      openers.append(opener);
      return { id, host: host2, opener, count: counted2, table: table2, fill: fill2 };
    }
    function turn(id) {
      const next = drawers.find((each) => each.id === id) ?? null;
      open = next === open ? null : next;
      open == null ? void 0 : open.fill();
      for (const each of drawers) {
        each.host.hidden = each !== open;
        each.opener.setAttribute("aria-expanded", String(each === open));
      }
      tools.hidden = !(open == null ? void 0 : open.table);
      document.body.classList.toggle("drawer-open", open !== null);
      update();
    }
    const isAway = () => page.store.get().landing;
    function update() {
      var _a2;
      if (isAway()) return;
      for (const { table: table2, count: count3 } of drawers) if (table2) count3.textContent = table2.count(page.store.get(), everything.checked).toLocaleString("en");
      (_a2 = open == null ? void 0 : open.table) == null ? void 0 : _a2.show(page.store.get(), filter.value, everything.checked);
    }
    filter.addEventListener("input", update);
    everything.addEventListener("change", update);
    page.store.listen((state, before) => {
      var _a2;
      const keys = (
        /** @type {const} */
        ["entry", "configuration", "landing"]
      );
      if (state === before || keys.some((key) => state[key] !== before[key])) update();
      else if (state.selection !== before.selection) (_a2 = open == null ? void 0 : open.table) == null ? void 0 : _a2.mark(state);
    });
    window.addEventListener("beforeprint", () => {
      if (!isAway()) for (const { table: table2, fill: fill2 } of drawers) table2 ? table2.show(page.store.get(), "", false) : fill2();
    });
    window.addEventListener("hashchange", () => {
      var _a2;
      const id = decoded2(location.hash.slice(1));
      for (const each of drawers) if (id.startsWith("program-") && each.id === "library") each.fill();
      const meant = drawers.find((each) => each.host.id === id || each.id === id || each.host.contains(document.getElementById(id)));
      if (id && meant && meant !== open) turn(meant.id);
      if (meant) (_a2 = document.getElementById(id)) == null ? void 0 : _a2.scrollIntoView({ block: "nearest" });
    });
    return {
      /** Closes the table that is open, or opens the first. */
      toggle: () => {
        var _a2;
        return turn((open == null ? void 0 : open.id) ?? ((_a2 = drawers[0]) == null ? void 0 : _a2.id) ?? "");
      },
      /** Opens the first table where none is open. */
      open: () => {
        var _a2;
        return open ?? turn(((_a2 = drawers[0]) == null ? void 0 : _a2.id) ?? "");
      }
    };
  }
  function decoded2(text2) {
    try {
      return decodeURIComponent(text2);
    } catch {
      return text2;
    }
  }

  // launchlint/report/html/js/page/tree_items.js
  var SEVERITIES3 = (
    /** @type {const} */
    ["error", "warning", "info"]
  );
  function groupItem(model, entry, group3, level) {
    const findings = findingsWithin(entry, group3);
    const count3 = element2("span", { class: "count" }, ` ${group3.count}`, told(group3.count === 1 ? " node" : " nodes"));
    return item(model, {
      id: group3.id,
      label: group3.label,
      title: fullName(group3),
      classes: `group ${group3.kind}`,
      level,
      findings,
      more: count3,
      group: group3
    });
  }
  function nodeItem(model, entry, node, level, namespace) {
    const data = entry.nodes[node];
    if (!data) return null;
    const label2 = namespace && data.name.startsWith(`${namespace}/`) ? data.name.slice(namespace.length + 1) : namespace === "/" ? data.name.slice(1) : lastPart2(data.name);
    const unknown = data.knowledge === "unknown";
    const classes = ["node", unknown && "unknown", (data.only.length > 0 || data.conditions.length > 0) && "conditional", data.mark].filter(Boolean).join(" ");
    const state = [unknown && "not known", data.mark].filter(Boolean).join(", ");
    const more = state ? told(` ${state}`) : null;
    return item(model, { id: `n:${node}`, label: label2, title: data.name, classes, level, findings: data.findings, more, group: null });
  }
  function item(model, { id, label: label2, title: title2, classes, level, findings, more, group: group3 }) {
    const all = [...new Set(findings)];
    const worst = SEVERITIES3.find((severity) => all.some((each) => {
      var _a;
      return ((_a = model.data.findings[each]) == null ? void 0 : _a.severity) === severity;
    }));
    const badge3 = worst && element2("span", { class: `badge ${worst}` }, ` ${all.length}`, told(all.length === 1 ? " finding" : " findings"));
    const hide = element2("button", {
      type: "button",
      class: "hide",
      tabindex: -1,
      "aria-hidden": "true",
      "aria-pressed": "false",
      title: "Hide in the drawing (h)"
    });
    const row2 = element2(
      "div",
      {
        class: `row ${classes}`,
        role: "treeitem",
        tabindex: -1,
        "aria-level": level,
        "aria-selected": "false",
        "aria-expanded": group3 ? "false" : null,
        "data-id": id
      },
      element2("span", { class: group3 ? "twisty" : "dot", "aria-hidden": "true" }),
      element2("span", { class: "label", title: title2 }, label2),
      badge3,
      more,
      hide
    );
    return { id, host: element2("li", { role: "none" }, row2), row: row2, hide, group: group3 };
  }
  function told(words2) {
    return element2("span", { class: "visually-hidden" }, words2);
  }

  // launchlint/report/html/js/page/tree.js
  var GROUPINGS2 = [
    ["namespace", "Namespace"],
    ["file", "Launch file"],
    ["package", "Package"],
    ["machine", "Machine"]
  ];
  var OPEN_AT_ONCE = 60;
  function createTree(page) {
    const tree = element2("ul", { role: "tree", "aria-label": "Nodes" });
    const grouping = groupingChooser(page);
    fill(part("tree"), grouping.host, tree);
    const items = /* @__PURE__ */ new Map();
    const entryNow = () => page.model.entry(page.store.get().entry).entry;
    const isThere2 = (node) => isIn(entryNow().nodes[node] ?? { only: [] }, page.store.get().configuration);
    const nodesIn = (group3) => group3.nodes.filter(isThere2).length + group3.groups.reduce((sum, each) => sum + nodesIn(each), 0);
    function grow(group3, host2, level) {
      const entry = entryNow();
      for (const each of group3.groups) {
        const count3 = nodesIn(each);
        if (count3 > 0) add4(groupItem(page.model, entry, { ...each, count: count3 }, level), host2);
      }
      for (const node of group3.nodes) {
        if (!isThere2(node)) continue;
        const made2 = nodeItem(page.model, entry, node, level, group3.namespace);
        if (made2) add4(made2, host2);
      }
    }
    function add4(item2, host2) {
      items.set(item2.id, item2);
      markHidden(item2, page.store.get());
      host2.append(item2.host);
    }
    function itemAt(target2) {
      const row2 = target2 instanceof Element ? target2.closest(".row") : null;
      return row2 instanceof HTMLElement ? items.get(row2.dataset["id"] ?? "") : void 0;
    }
    const isOpen = ({ row: row2 }) => row2.getAttribute("aria-expanded") === "true";
    function turn(item2, open2) {
      if (!item2.group || isOpen(item2) === open2) return;
      item2.row.setAttribute("aria-expanded", String(open2));
      let inner = item2.host.querySelector(":scope > ul");
      if (!inner) {
        inner = element2("ul", { role: "none" });
        item2.host.append(inner);
        grow(item2.group, inner, Number(item2.row.getAttribute("aria-level")) + 1);
      }
      inner.toggleAttribute("hidden", !open2);
    }
    function rebuild(state) {
      var _a;
      items.clear();
      fill(tree);
      const root = containersOf(entryNow(), state.grouping);
      grow(root, tree, 1);
      if (root.count <= OPEN_AT_ONCE) for (const item2 of items.values()) turn(item2, true);
      if (root.count === 0) {
        const said2 = entryNow().complete ? "This launch file starts no nodes." : "Which nodes this launch file starts is not known.";
        tree.append(element2("li", { role: "treeitem", class: "empty" }, said2));
      }
      (_a = tree.querySelector('[role="treeitem"]')) == null ? void 0 : _a.setAttribute("tabindex", "0");
    }
    function markSelected(state) {
      var _a, _b;
      for (const row2 of tree.querySelectorAll('[aria-selected="true"]')) row2.setAttribute("aria-selected", "false");
      if (((_a = state.selection) == null ? void 0 : _a.kind) === "node") for (const group3 of around2(entryNow(), state.grouping, Number(state.selection.id.slice(2)))) open(group3.id);
      const item2 = items.get(((_b = state.selection) == null ? void 0 : _b.id) ?? "");
      if (!item2) return;
      item2.row.setAttribute("aria-selected", "true");
      rove(item2.row);
      item2.row.scrollIntoView({ block: "nearest" });
    }
    function open(id) {
      const item2 = items.get(id);
      if (item2) turn(item2, true);
    }
    function rove(row2) {
      if (!(row2 instanceof HTMLElement)) return;
      for (const each of tree.querySelectorAll('[tabindex="0"]')) each.setAttribute("tabindex", "-1");
      row2.tabIndex = 0;
    }
    function focus(row2) {
      rove(row2);
      if (row2 instanceof HTMLElement) row2.focus();
    }
    const visible = () => [...tree.querySelectorAll(".row")].filter((row2) => !row2.closest("ul[hidden]"));
    function choose({ id }) {
      select(page, id.startsWith("n:") ? { kind: "node", id } : { kind: "container", id });
    }
    function hide({ id }) {
      page.store.set({ hidden: toggled(page.store.get().hidden, id) });
    }
    tree.addEventListener("click", (event) => {
      const item2 = itemAt(event.target);
      const target2 = (
        /** @type {Element} */
        event.target
      );
      if (!item2) return;
      rove(item2.row);
      if (target2.closest(".hide")) hide(item2);
      else if (target2.closest(".twisty")) turn(item2, !isOpen(item2));
      else choose(item2);
    });
    tree.addEventListener("keydown", (event) => {
      const item2 = itemAt(event.target);
      if (!item2 || event.ctrlKey || event.metaKey || event.altKey) return;
      const rows2 = visible();
      const at = rows2.indexOf(item2.row);
      const keys = /* @__PURE__ */ new Map([
        ["ArrowDown", () => focus(rows2[at + 1])],
        ["ArrowUp", () => focus(rows2[at - 1])],
        ["Home", () => focus(rows2[0])],
        ["End", () => focus(rows2.at(-1))],
        ["ArrowRight", () => isOpen(item2) ? focus(rows2[at + 1]) : turn(item2, true)],
        ["ArrowLeft", () => {
          var _a, _b;
          return isOpen(item2) ? turn(item2, false) : focus((_b = (_a = item2.host.parentElement) == null ? void 0 : _a.closest("li")) == null ? void 0 : _b.querySelector(".row"));
        }],
        ["Enter", () => choose(item2)],
        [" ", () => choose(item2)],
        ["h", () => hide(item2)]
      ]);
      const action = keys.get(event.key);
      if (!action) return;
      event.preventDefault();
      event.stopPropagation();
      action();
    });
    page.store.listen((state, before) => {
      const anew = (
        /** @type {const} */
        ["entry", "grouping", "configuration"].some((key) => state === before || state[key] !== before[key])
      );
      if (anew) {
        grouping.show(state.grouping, entryNow().nodes.some((each) => each.machine.length > 0));
        rebuild(state);
      }
      if (state.hidden !== before.hidden) for (const item2 of items.values()) markHidden(item2, state);
      if (anew || state.selection !== before.selection) markSelected(state);
    });
    return {
      focus: () => focus(tree.querySelector('[tabindex="0"]'))
    };
  }
  function markHidden({ id, row: row2, hide }, { hidden }) {
    row2.classList.toggle("hidden-in-drawing", hidden.has(id));
    hide.setAttribute("aria-pressed", String(hidden.has(id)));
  }
  function groupingChooser(page) {
    const buttons = GROUPINGS2.map(([grouping, label2]) => (
      /** @type {const} */
      [grouping, button(label2, () => page.store.set({ grouping }))]
    ));
    const host2 = element2("div", { class: "segments", role: "group", "aria-label": "Group nodes by" }, ...buttons.map(([, each]) => each));
    return {
      host: host2,
      /** @param {Grouping} now @param {boolean} machines whether any node is on one */
      show(now, machines) {
        host2.classList.toggle("two-rows", machines || now === "machine");
        for (const [grouping, each] of buttons) {
          each.setAttribute("aria-pressed", String(grouping === now));
          each.hidden = grouping === "machine" && now !== "machine" && !machines;
        }
      }
    };
  }

  // launchlint/report/html/js/page/verdict.js
  var SEVERITIES4 = (
    /** @type {const} */
    ["error", "warning", "info"]
  );
  function createVerdict(page) {
    const verdict2 = part("verdict");
    const counts = part("counts");
    page.store.listen((state, before) => {
      var _a;
      if (state !== before && state.entry === before.entry && state.configuration === before.configuration) return;
      const model = page.model.entry(state.entry);
      const { entry } = model;
      const args = entry.configurations[state.configuration];
      (_a = part("bar").querySelector("h1")) == null ? void 0 : _a.setAttribute("data-shown", [page.model.data.files[entry.file], args !== void 0 && configurationName(args)].filter(Boolean).join(", "));
      const severities = findingsIn(model, state.configuration).map((each) => {
        var _a2;
        return (_a2 = page.model.data.findings[each]) == null ? void 0 : _a2.severity;
      });
      const has = (severity) => severities.filter((each) => each === severity).length;
      const words2 = notice(entry) || loads(has("error"), has("warning"));
      const { base } = page.model.data;
      verdict2.className = isRefused(entry) || has("error") > 0 ? "error" : entry.verdict !== "loads" || has("warning") > 0 ? "warning" : "ok";
      verdict2.textContent = base === null ? words2 : `${words2}; compared with ${base}`;
      const nodes = entry.nodes.filter((each) => isIn(each, state.configuration) && each.mark !== "removed");
      const topics = entry.channels.filter((each, at) => each.kind === "topic" && !each.plumbing && each.mark !== "removed" && isUsedIn(model, at, state.configuration));
      const [, usual] = entry.sight;
      const started = state.configuration < 0 && usual ? Math.min(usual, nodes.length) : nodes.length;
      const unknown = nodes.filter((each) => each.knowledge === "unknown");
      const partly = nodes.filter((each) => each.knowledge !== "unknown" && (each.open.length > 0 || each.partly.length > 0));
      fill(
        counts,
        ...SEVERITIES4.map((severity) => count2(has(severity), severity, severity)),
        count2(started, "node"),
        count2(nodes.length - started, "more with other args", "", "more with other args"),
        count2(unknown.length, "not known", "unknown", "not known"),
        count2(partly.length, "known in part", "partly", "known in part"),
        count2(topics.length, "topic"),
        !entry.complete && element2("li", { class: "unknown" }, "not all could be followed")
      );
    });
  }
  var isRefused = (entry) => entry.verdict === "refused" || entry.withArgs !== "";
  function loads(errors, warnings) {
    return errors > 0 ? "loads, with errors" : warnings > 0 ? "loads, with warnings" : "loads";
  }
  function count2(number2, one2, name = "", many2 = `${one2}s`) {
    return number2 > 0 && element2("li", { class: name || null }, element2("b", {}, number2.toLocaleString("en")), ` ${number2 === 1 ? one2 : many2}`);
  }

  // launchlint/report/html/js/page/share.js
  var SAID = 2e3;
  function createShareButton(page) {
    const told2 = element2("span", { class: "visually-hidden", role: "status" });
    const host2 = button("Copy link", copy, { class: "share", title: "Copy a link to exactly this view" });
    async function copy() {
      const done = await copied3(linkTo(page));
      host2.textContent = done ? "Copied" : "Not copied";
      told2.textContent = done ? "The link is copied." : "The browser does not let the page copy: the address of the page is the link.";
      window.setTimeout(() => {
        host2.textContent = "Copy link";
        told2.textContent = "";
      }, SAID);
    }
    return element2("span", { class: "share-host" }, host2, told2);
  }
  function linkTo({ model, store, drawing }) {
    const state = store.get();
    const exact = addressOf(model, { ...state, expanded: drawing.expanded(), place: drawing.spot() });
    return `${location.href.replace(/#.*$/s, "")}#${exact}`;
  }
  async function copied3(text2) {
    try {
      await navigator.clipboard.writeText(text2);
      return true;
    } catch {
      const field = element2("textarea", { class: "visually-hidden", "aria-hidden": "true" });
      field.value = text2;
      document.body.append(field);
      field.select();
      const done = document.execCommand("copy");
      field.remove();
      return done;
    }
  }

  // launchlint/report/html/js/page/side_panels.js
  var SIDES = (
    /** @type {const} */
    [
      { id: "tree", name: "Tree", sign: "◧", usual: 260, grows: 1 },
      { id: "panel", name: "Details", sign: "◨", usual: 360, grows: -1 }
    ]
  );
  var LEAST = 160;
  var MOST7 = 720;
  var STEP6 = 20;
  function createSidePanels() {
    const sheet = new CSSStyleSheet();
    document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
    const widths = /* @__PURE__ */ new Map();
    return SIDES.map(({ id, name, sign, usual, grows }) => {
      const key = `launchlint-${id}`;
      let form = remembered2(key, usual);
      const fold2 = button(sign, () => become({ ...form, folded: !form.folded }), { class: "fold-side", "aria-controls": id });
      const bar = element2("div", {
        class: `divider ${id}`,
        role: "separator",
        tabindex: 0,
        "aria-orientation": "vertical",
        "aria-label": `Width of the ${name.toLowerCase()}`,
        "aria-valuemin": LEAST,
        "aria-valuemax": MOST7
      });
      part("stage").append(bar);
      function become(next) {
        form = { ...next, width: Math.max(LEAST, Math.min(MOST7, Math.round(next.width))) };
        widths.set(id, form.width);
        sheet.replaceSync(`body { ${Array.from(widths, ([side, width]) => `--${side}-width: ${width}px;`).join(" ")} }`);
        document.body.toggleAttribute(`data-${id}-folded`, form.folded);
        bar.setAttribute("aria-valuenow", String(form.width));
        fold2.setAttribute("aria-expanded", String(!form.folded));
        fold2.setAttribute("aria-label", `${form.folded ? "Show" : "Fold"} the ${name.toLowerCase()}`);
        fold2.title = `${form.folded ? "Show" : "Fold"} the ${name.toLowerCase()}`;
        remember2(key, form);
      }
      bar.addEventListener("pointerdown", (event) => {
        const [from, width] = [event.clientX, form.width];
        bar.setPointerCapture(event.pointerId);
        const follow2 = (moved) => become({ ...form, width: width + (moved.clientX - from) * grows });
        bar.addEventListener("pointermove", follow2);
        bar.addEventListener("lostpointercapture", () => bar.removeEventListener("pointermove", follow2), { once: true });
      });
      bar.addEventListener("keydown", (event) => {
        const steps = { ArrowRight: STEP6, ArrowLeft: -STEP6 }[event.key];
        if (steps === void 0) return;
        event.preventDefault();
        become({ ...form, width: form.width + steps * grows });
      });
      become(form);
      return fold2;
    });
  }
  function remembered2(key, usual) {
    try {
      const [width, folded] = (localStorage.getItem(key) ?? "").split(" ");
      return { width: Number(width) || usual, folded: folded === "folded" };
    } catch {
      return { width: usual, folded: false };
    }
  }
  function remember2(key, { width, folded }) {
    try {
      localStorage.setItem(key, `${width} ${folded ? "folded" : "open"}`);
    } catch {
    }
  }

  // launchlint/report/html/js/page/view_bar.js
  var PAUSE3 = 200;
  var layer = (name, label2, title2) => ({
    label: label2,
    title: title2,
    get: (state) => state.layers[name],
    change: (state, on) => ({ layers: { ...state.layers, [name]: on } })
  });
  var flag = (name, label2, title2) => ({ label: label2, title: title2, get: (state) => state[name], change: (_, on) => ({ [name]: on }) });
  var TOGGLES = [
    [
      "Show",
      [
        layer("topics", "Topics", "Topics that nodes publish and subscribe to"),
        layer("services", "Services", "Services that nodes serve and call"),
        layer("actions", "Actions", "Actions that nodes serve and call"),
        layer("params", "Params", "Params that nodes read"),
        flag("hubs", "Hub topics", "Topics that everybody uses: /tf, /clock, /diagnostics …"),
        flag("topicsAsNodes", "Topics as boxes", "Draw each topic as a box of its own instead of as arrows"),
        flag("tray", "Unconnected", "Nodes that share nothing with another one: they stand in a tray of their own")
      ]
    ],
    [
      "Only",
      [
        flag("danglingOnly", "Not connected", "Only what has nobody at its other end"),
        flag("findingsOnly", "With findings", "Only what a finding is about")
      ]
    ]
  ];
  function createViewBar(page) {
    var _a;
    const { store, drawing } = page;
    const buttons = new Map(TOGGLES.flatMap(([, toggles]) => toggles.map((each) => (
      /** @type {const} */
      [each, toggleButton(page, each)]
    ))));
    const groups = TOGGLES.map(
      ([title2, toggles]) => element2(
        "div",
        { class: "toggles", role: "group", "aria-label": title2 },
        element2("span", { class: "title", "aria-hidden": "true" }, title2),
        ...toggles.map((each) => buttons.get(each))
      )
    );
    const scope = element2("div", { class: "scope" });
    const filter = createFilter(page);
    const [tree, details] = createSidePanels();
    if (tree) (_a = groups[0]) == null ? void 0 : _a.prepend(tree);
    const zoom = element2(
      "div",
      { class: "zoom", role: "group", "aria-label": "Zoom" },
      button("+", () => drawing.zoom(1.25), { "aria-label": "Zoom in", title: "Zoom in (+)" }),
      button("−", () => drawing.zoom(0.8), { "aria-label": "Zoom out", title: "Zoom out (−)" }),
      button("Fit", () => drawing.fit(), { title: "Fit the drawing into its frame (0)" })
    );
    part("stage").prepend(element2("div", { id: "view-bar" }, ...groups, filter.host, scope, element2("div", { class: "view-end" }, createShareButton(page), details)));
    part("stage").append(zoom);
    store.listen((state) => {
      filter.show(state.filter);
      for (const [toggle, host2] of buttons) host2.setAttribute("aria-pressed", String(toggle.get(state)));
      fill(scope, ...scopeOf(page, state));
    });
  }
  function createFilter({ store }) {
    const field = element2("input", {
      id: "filter",
      type: "search",
      placeholder: "Filter: name, type:, package:",
      title: "Draws what fits all words: a part of a name, /left/*, type:Image, package:nav, and -rviz for what shall not be there",
      "aria-label": "Filter the drawing by name, type: or package:",
      autocomplete: "off",
      spellcheck: "false"
    });
    let timer = 0;
    field.addEventListener("input", () => {
      window.clearTimeout(timer);
      timer = window.setTimeout(() => store.set({ filter: field.value.trim() }, "replace"), PAUSE3);
    });
    return {
      host: field,
      /** @param {string} text */
      show(text2) {
        if (document.activeElement !== field && field.value.trim() !== text2) field.value = text2;
      }
    };
  }
  function toggleButton({ store }, { label: label2, title: title2, get, change }) {
    return button(label2, () => store.set(change(store.get(), !get(store.get()))), { class: "toggle", title: title2 });
  }
  function scopeOf({ model, store }, state) {
    const focused = state.focus && containerOf(model.entry(state.entry).entry, state.grouping, state.focus);
    return [
      state.focus && element2(
        "span",
        {},
        "Focus: ",
        element2("b", {}, focused ? fullName(focused) : state.focus),
        " ",
        button("Leave", () => store.set({ focus: null }))
      ),
      state.hidden.size > 0 && element2(
        "span",
        {},
        `${number(state.hidden.size, "thing")} hidden `,
        button("Show all", () => store.set({ hidden: /* @__PURE__ */ new Set() }))
      ),
      state.expanded !== "auto" && button("Overview", () => store.set({ expanded: "auto" }), { title: "Expand as much as can be read at once" })
    ];
  }

  // launchlint/report/html/js/unpack.js
  var DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
  var PARTS = (
    /** @type {const} */
    ["containers", "nodes", "channels", "connections", "params"]
  );
  function read2(text2) {
    const [head2 = "", ...lines] = text2.split("\n");
    const data = unpack(JSON.parse(head2));
    data.entries.forEach((entry, index) => {
      let parts3 = null;
      for (const part2 of PARTS) {
        Object.defineProperty(entry, part2, { enumerable: true, get: () => (parts3 ??= unpack(JSON.parse(lines[index] ?? "{}")))[part2] });
      }
    });
    let library = null;
    Object.defineProperty(data, "library", { enumerable: true, get: () => library ??= unpack(JSON.parse(lines[data.entries.length] ?? "[]")) });
    return data;
  }
  function unpack(value) {
    if (Array.isArray(value)) return value.map(unpack);
    if (value === null || typeof value !== "object") return value;
    if (typeof value.$rows === "number") return rows(value.$rows, value.columns);
    return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, unpack(inner)]));
  }
  function rows(count3, columns) {
    const found2 = Array.from({ length: count3 }, () => ({}));
    for (const [key, column] of Object.entries(columns)) {
      cells(count3, column).forEach((cell, index) => {
        if (cell !== void 0) found2[index][key] = cell;
      });
    }
    return found2;
  }
  function cells(count3, column) {
    if ("$all" in column) return new Array(count3).fill(unpack(column.$all));
    if (!("$of" in column)) return list2(column);
    const distinct = list2(column.$of);
    const at = typeof column.$at === "string" ? Array.from(column.$at, (digit) => DIGITS.indexOf(digit)) : column.$at;
    return at.map((index) => distinct[index]);
  }
  function list2(value) {
    if (Array.isArray(value)) return value.map(unpack);
    let before = "";
    return value.$front.map((text2) => before = before.slice(0, DIGITS.indexOf(text2.charAt(0))) + text2.slice(1));
  }

  // launchlint/report/html/js/main.js
  function start() {
    const data = read2(part("launchlint-data").textContent ?? "");
    if (data.entries.length === 0) return;
    const model = createModel(data);
    const host2 = editor();
    const store = createStore(stateOf(model, location.hash || addressBefore(host2)), { write: (state) => addressOf(model, state), read: (hash) => stateOf(model, hash) });
    document.documentElement.classList.add("interactive");
    let fromDrawing = false;
    const selectFromDrawing = (selection) => {
      fromDrawing = true;
      store.set({ selection });
      fromDrawing = false;
    };
    const canvas = part("drawing");
    canvas.replaceChildren();
    const drawing = createDrawing(data, canvas, {
      select: selectFromDrawing,
      expand(container, open) {
        const expanded = drawing.expanded();
        if (open) expanded.add(container);
        else expanded.delete(container);
        store.set({ expanded });
      },
      moved: (place2) => store.set({ place: place2 }, "replace"),
      busy: (on) => canvas.classList.toggle("busy", on)
    });
    const page = { model, store, drawing };
    const landing = createLanding(page);
    createVerdict(page);
    const search = createControls(page, { help: () => help() });
    const tree = createTree(page);
    createViewBar(page);
    createPanel(page);
    const tables = createTables(page);
    createSheets(page, tables.open);
    const drawingKeys = createDrawingKeys(page);
    const shortcuts = createKeyboard(page, {
      search: search.focus,
      tree: () => tree.focus(),
      drawing: drawingKeys.focus,
      tables: tables.toggle,
      help: () => help(),
      landing: landing.show,
      change: createSteps(page)
    });
    const help = createHelp(shortcuts);
    preparePrint();
    followEditor(page, host2);
    createStage(page, { cameFromDrawing: () => fromDrawing, holdFocus: drawingKeys.hold });
  }
  start();
})();
