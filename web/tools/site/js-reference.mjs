/** The pages of the reference in JavaScript, made of the package's typings. */
import { fileURLToPath } from "node:url";
import ts from "typescript";
import { escaped, proseOf } from "./prose.mjs";

const typings = (name) => fileURLToPath(new URL(`../../package/dist/${name}.d.ts`, import.meta.url));

/** The layers of the class World, each with what it is about. */
const LAYERS = {
  World: "Bodies",
  WorldShapes: "Shapes",
  WorldJoints: "Joints",
  WorldEdits: "Changes",
  WorldForces: "Pushes and points",
  WorldFields: "Wind, water, tyres, explosions",
  WorldRules: "Rules and listeners",
  WorldTextures: "Textures",
  WorldLists: "What there is",
  WorldQueries: "What is where",
  WorldViews: "What happens",
  WorldBase: "Time, settings, snapshots",
};

/** The modules that draw worlds, each with what its page begins with. */
const ADAPTERS = {
  canvas: "A world on a plain canvas, and dragging by pointers. [Guide](./guide-drawing.md#with-a-canvas-or-a-library)",
  pixi: "A world in PixiJS. Dragging has the options of [DragOptions](./js-canvas.md#DragOptions).",
  three: "A world in three.js. Dragging has the options of [DragOptions](./js-canvas.md#DragOptions).",
  phaser: "A world in Phaser. Dragging has the options of [DragOptions](./js-canvas.md#DragOptions).",
};

/** A declaration without its comment and export. */
function plainOf(node) {
  return node.getText().replace(/^export (declare )?/, "").replace(/\/\*\*.*?\*\/\s*/gs, "");
}

/** The comment of a declaration; `@throws` as a sentence, `@example` as code. */
function commentOf(node) {
  const [doc] = (node.jsDoc ?? []).slice(-1);
  if (!doc) return { text: "", example: "" };
  const words = (part) => ts.getTextOfJSDocComment(part) ?? "";
  const tags = [...(doc.tags ?? [])];
  const throws = tags.filter(({ tagName }) => tagName.text === "throws");
  const thrown = throws.map((tag) => `Throws ${tag.getText().replace(/^@throws\s*\{(\w+)\}/, "$1").replace(/^\s*\* ?/gm, "").trim()}`);
  const [example] = tags.filter(({ tagName }) => tagName.text === "example");
  return { text: [words(doc.comment), ...thrown].join("\n\n"), example: example ? words(example.comment).trim() : "" };
}

function bodyOf({ text, example }, link) {
  return proseOf(text, link) + (example ? `<pre class="signature">${link(example)}</pre>` : "");
}

const nameOf = (member) => member.name?.getText() ?? "";

/** The members of a class or interface that a program may use, without constructors. */
function membersOf(node) {
  return node.members.filter((member) => {
    const flags = ts.getCombinedModifierFlags(member);
    const hidden = flags & (ts.ModifierFlags.Private | ts.ModifierFlags.Protected);
    return !hidden && !ts.isConstructorDeclaration(member) && !/^[#[]/.test(nameOf(member));
  });
}

/** The constructors of a class that a program calls. */
function constructorsOf(node) {
  return node.members.filter((member) => ts.isConstructorDeclaration(member) && member.parameters.length > 0);
}

/** Overloads of a method are one entry. */
function together(members) {
  const byName = new Map();
  for (const member of members) byName.set(nameOf(member), [...(byName.get(nameOf(member)) ?? []), member]);
  return [...byName.values()];
}

function methodOf(members, link) {
  const name = nameOf(members[0]);
  const signatures = members.map((member) => plainOf(member)).join("\n");
  const comments = members.map(commentOf).filter(({ text, example }) => text || example);
  return `### ${name} {#${name}}\n\n<div v-pre class="item"><pre class="signature">${link(signatures, name)}</pre>${comments.map((one) => bodyOf(one, link)).join("")}</div>\n`;
}

function declarationOf(name, nodes, link) {
  const [node] = nodes;
  const comments = nodes.map(commentOf).map((one) => bodyOf(one, link)).join("");
  if ((ts.isInterfaceDeclaration(node) || ts.isClassDeclaration(node)) && node.members.length > 0) {
    const bases = (node.heritageClauses ?? []).map((clause) => clause.getText()).join(" ");
    const kind = ts.isClassDeclaration(node) ? "class" : "interface";
    const rows = [...constructorsOf(node), ...membersOf(node)].map((member) => {
      const text = plainOf(member).replace(/;$/, "").replace(/^readonly /, "");
      const long = text.length > 60 || /[\n{]/.test(text);
      const shown = long ? `<pre class="signature">${link(text, name)}</pre>` : `<code>${link(text, name)}</code>`;
      return `<div${long ? ' class="long"' : ""}><dt>${shown}</dt><dd>${bodyOf(commentOf(member), link)}</dd></div>`;
    });
    return `<pre class="signature">${kind} ${link(`${name} ${bases}`.trim(), name)}</pre>${comments}<dl class="terms">${rows.join("")}</dl>`;
  }
  return `<pre class="signature">${link(nodes.map(plainOf).join("\n"), name)}</pre>${comments}`;
}

/** The pages as [name, text in Markdown]. */
export function jsPages() {
  const files = ["index", "geometry/index", "level", ...Object.keys(ADAPTERS), "recording"].map(typings);
  const options = { target: ts.ScriptTarget.ES2022, module: ts.ModuleKind.ESNext, moduleResolution: ts.ModuleResolutionKind.Bundler, types: [] };
  const program = ts.createProgram(files, options);
  const checker = program.getTypeChecker();
  const exportsOf = (file) =>
    checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file))).map((symbol) => {
      const own = symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol;
      const nodes = own.declarations.map((node) => (ts.isVariableDeclaration(node) ? node.parent.parent : node));
      return { name: symbol.name, nodes };
    });
  const [main, geometry, level, ...more] = files.map(exportsOf);
  const isType = ({ nodes: [node] }) => ts.isInterfaceDeclaration(node) || ts.isTypeAliasDeclaration(node) || ts.isVariableStatement(node);
  const world = main.find(({ name }) => name === "World");
  const rest = main.filter((one) => one !== world);
  const inMain = new Set(main.map(({ name }) => name));
  const lists = {
    "js-engine": rest.filter((one) => !isType(one)),
    "js-types": rest.filter(isType),
    "js-geometry": geometry.filter(({ name }) => !inMain.has(name)),
    "js-level": level.filter(({ name }) => !inMain.has(name)),
  };
  // Drag and its options, which all adapters export, stand on the page of the first.
  const told = new Set(inMain);
  for (const [i, name] of [...Object.keys(ADAPTERS), "recording"].entries()) {
    lists[`js-${name}`] = more[i].filter((one) => !told.has(one.name));
    for (const one of more[i]) told.add(one.name);
  }

  const addresses = new Map([["World", "./js-world.html"]]);
  for (const [page, list] of Object.entries(lists))
    for (const { name } of list) addresses.set(name, `./${page}.html#${name}`);
  const link = (text, self) =>
    escaped(text).replace(/\b[A-Z]\w+\b/g, (name) =>
      name !== self && addresses.has(name) ? `<a href="${addresses.get(name)}">${name}</a>` : name,
    );

  const layers = [];
  for (let type = checker.getDeclaredTypeOfSymbol(checker.getSymbolAtLocation(world.nodes[0].name)); type; [type] = type.getBaseTypes?.() ?? []) {
    const [node] = type.symbol.declarations;
    const title = LAYERS[type.symbol.name];
    const members = membersOf(node);
    if (members.length > 0 && !title) throw new Error(`the reference has no title for ${type.symbol.name}`);
    layers.push({ title, members });
  }
  const titles = Object.values(LAYERS);
  layers.sort((a, b) => titles.indexOf(a.title) - titles.indexOf(b.title));
  const worldText = layers
    .filter(({ members }) => members.length > 0)
    .map(({ title, members }) => `## ${title} {#about-${title.toLowerCase().replace(/\W+/g, "-")}}\n\n${together(members).map((one) => methodOf(one, link)).join("\n")}`)
    .join("\n");

  const page = (title, intro, list) =>
    `# ${title}\n\n${intro}\n\n${list.map(({ name, nodes }) => `## ${name} {#${name}}\n\n<div v-pre class="item">${declarationOf(name, nodes, link)}</div>\n`).join("\n")}`;
  return [
    ["js-world", `# World\n\nA world of bodies, made by \`engine.createWorld(options)\`. Every method, by what it is about.\n\n${worldText}`],
    ["js-engine", page("Engine, movers and functions", "What `thud` exports beside the class [World](./js-world.md).", lists["js-engine"])],
    ["js-types", page("Options and results", "The types of `thud`: what calls are given and what they return.", lists["js-types"])],
    ["js-geometry", page("thud/geometry", "Two shapes without a world: distances, times of impact, bounding volumes. The first argument of each call is the engine.", lists["js-geometry"])],
    ["js-level", page("thud/level", "Maps of the Tiled editor.", lists["js-level"])],
    ...Object.entries(ADAPTERS).map(([name, about]) => [`js-${name}`, page(`thud/${name}`, about, lists[`js-${name}`])]),
    ["js-recording", page("thud/recording", "Recordings of the calls that change a world, and a player. [Guide](./guide-recordings.md)", lists["js-recording"])],
  ];
}
