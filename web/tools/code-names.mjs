/**
 * Reads the names that the code of a scene can use from the typings of the package and of scenes,
 * when the page is built: for the list beside the code editor and for its completion. Each name has
 * the first paragraph of its comment, and an example: that of the comment's @example, or else one
 * made from its signature or default.
 */
import { fileURLToPath } from "node:url";
import ts from "typescript";

const path = (file) => fileURLToPath(new URL(`../${file}`, import.meta.url));
const SCENE = path("src/scene/scene.ts");
const PACKAGE = path("package/dist/index.d.ts");

/**
 * The types of joints that together have every option. Of an option that several have the comment
 * of the first is shown, so the most general come first.
 */
const JOINTS = ["HingeOptions", "DistanceOptions", "TargetOptions", "GearOptions"];

/**
 * The groups of the list. `types`: the types whose members are listed. `of`: only the methods that
 * this layer of the class World declares. `kinds`: the types of a union by their `kind`, instead of
 * members. `completes`: where the editor offers the names, anywhere ("plain") or after a dot
 * ("member").
 */
const GROUPS = [
  { title: "The function is given", types: ["SceneSetting"] },
  { title: "Options of createWorld", types: ["WorldOptions"] },
  { title: "A world: bodies", types: ["World"], of: "World" },
  { title: "A world: shapes", types: ["World"], of: "WorldShapes" },
  { title: "A world: joints", types: ["World"], of: "WorldJoints" },
  { title: "A world: changes", types: ["World"], of: "WorldEdits" },
  { title: "A world: pushes and points", types: ["World"], of: "WorldForces" },
  { title: "A world: wind, water, tyres, explosions", types: ["World"], of: "WorldFields" },
  { title: "A world: rules and listeners", types: ["World"], of: "WorldRules" },
  { title: "A world: what there is", types: ["World"], of: "WorldLists" },
  { title: "A world: what is where", types: ["World"], of: "WorldQueries" },
  { title: "A world: what happens", types: ["World"], of: "WorldViews" },
  { title: "A world: time and settings", types: ["World"], of: "WorldBase" },
  { title: "Options of createBody", types: ["BodyOptions"] },
  { title: "Options of shapes", types: ["CircleOptions", "ObbOptions"] },
  { title: "Kinds of joints", types: ["AnyJointOptions"], kinds: true },
  { title: "Options of createJoint", types: JOINTS },
  { title: "What drives a joint", types: ["Drive"] },
  { title: "The function returns", types: ["Scene"] },
  { title: "What update is given", types: ["Input"] },
  { title: "What paint returns", types: ["Paint"] },
  { title: "Marks", types: ["Mark"], kinds: true },
].map((group) => ({ ...group, completes: group.of ? "member" : "plain" }));

/** [{ title, completes, entries: [{ name, form, meaning }] }] */
export function readCodeNames() {
  const options = {
    target: ts.ScriptTarget.ES2022,
    module: ts.ModuleKind.ESNext,
    moduleResolution: ts.ModuleResolutionKind.Bundler,
    strict: true,
    types: [],
  };
  const program = ts.createProgram([SCENE, PACKAGE], options);
  const checker = program.getTypeChecker();
  const exported = [PACKAGE, SCENE].flatMap((file) =>
    checker.getExportsOfModule(checker.getSymbolAtLocation(program.getSourceFile(file))),
  );
  const typeOf = (name) => {
    const found = exported.find((symbol) => symbol.name === name);
    if (!found) throw new Error(`The typings have no ${name}, which the list beside the code names.`);
    const symbol = found.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(found) : found;
    return checker.getDeclaredTypeOfSymbol(symbol);
  };
  return GROUPS.map(({ title, completes, types, of, kinds }) => {
    const entries = types
      .map(typeOf)
      .flatMap((type) => (kinds ? marksOf(checker, type) : membersOf(checker, type, of)))
      // Where two types share a name, the entry of the first is kept.
      .filter(({ name }, i, all) => all.findIndex((entry) => entry.name === name) === i);
    // Names with an example come first: these are the ones that are used most.
    entries.sort((a, b) => Number(b.hasExample) - Number(a.hasExample));
    return { title, completes, entries: entries.map(({ hasExample, ...entry }) => entry) };
  });
}

/** The members of a type, or with `of` the public methods that the class of that name declares. */
function membersOf(checker, type, of) {
  const hidden = ts.ModifierFlags.Private | ts.ModifierFlags.Protected;
  const isCalled = (symbol) =>
    symbol.flags & ts.SymbolFlags.Method &&
    symbol.parent.name === of &&
    !(ts.getCombinedModifierFlags(symbol.valueDeclaration) & hidden) &&
    ts.isIdentifier(symbol.valueDeclaration.name);
  const members = checker.getPropertiesOfType(type).filter((symbol) => !of || isCalled(symbol));
  return members.map((symbol) => {
    const meaning = meaningOf(checker, symbol);
    const example = exampleOf(checker, symbol);
    const form = example ?? formOf(checker, symbol, meaning, of);
    return { name: symbol.name, form, meaning, hasExample: example !== undefined };
  });
}

/** The types of a union by their `kind`, each with a list of its optional members. */
function marksOf(checker, union) {
  return union.types.map((type) => {
    const members = checker.getPropertiesOfType(type);
    const kind = members.find(({ name }) => name === "kind");
    const name = checker.getTypeOfSymbol(kind).value;
    const optional = members.filter(({ flags }) => flags & ts.SymbolFlags.Optional);
    const may = optional.map((member) => member.name).join(", ");
    const meaning = [meaningOf(checker, type.symbol), may && `It may have: ${may}.`];
    const example = exampleOf(checker, type.symbol);
    return {
      name,
      form: example ?? `{ kind: "${name}", … }`,
      meaning: meaning.filter(Boolean).join(" "),
      hasExample: example !== undefined,
    };
  });
}

/** The first paragraph of a comment, as plain text. */
function meaningOf(checker, symbol) {
  const text = ts.displayPartsToString(symbol.getDocumentationComment(checker));
  return text.split(/\n\s*\n/)[0].replaceAll("`", "").replace(/\s+/g, " ").trim();
}

/** The text of the comment's @example; undefined where it has none. */
function exampleOf(checker, symbol) {
  const tag = symbol.getJsDocTags(checker).find(({ name }) => name === "example");
  return tag && ts.displayPartsToString(tag.text).trim();
}

/**
 * An example made from a signature, "world.setAwake(body, awake)", or from the default in the
 * comment, "friction: 0.6"; of a flag the opposite of its default, "sensor: true".
 */
function formOf(checker, symbol, meaning, of) {
  const type = checker.getNonNullableType(checker.getTypeOfSymbol(symbol));
  const [signature] = type.getCallSignatures();
  if (signature) {
    const parameters = signature.parameters.map((parameter) => {
      const optional = checker.isOptionalParameter(parameter.valueDeclaration);
      return parameter.name + (optional ? "?" : "");
    });
    return `${of ? "world." : ""}${symbol.name}(${parameters.join(", ")})`;
  }
  const [, usual] = /\bDefault ("[^"]*"|\[[^\]]*\]|-?[\d./]+\d|-?\d|true|false)/.exec(meaning) ?? [];
  if (usual === "true" || usual === "false") return `${symbol.name}: ${usual === "false"}`;
  return `${symbol.name}: ${usual ?? checker.typeToString(type)}`;
}

const MODULE = "virtual:code-names";

/** The plugin of Vite that provides the list as a virtual module. */
export function codeNames() {
  return {
    name: "code-names",
    resolveId: (id) => (id === MODULE ? `\0${MODULE}` : null),
    load(id) {
      if (id !== `\0${MODULE}`) return null;
      for (const file of [SCENE, PACKAGE]) this.addWatchFile(file);
      return `export const GROUPS = ${JSON.stringify(readCodeNames())};`;
    },
  };
}
