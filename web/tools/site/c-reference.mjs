/** The pages of the reference in C, one for each header, made of bindings/api.json. */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { escaped, proseOf } from "./prose.mjs";

const API = fileURLToPath(new URL("../../../bindings/api.json", import.meta.url));

/** Headers without declarations of their own. */
const EMPTY = ["thud_all.h"];

/** The lists of the file in the order in which a section of a page has them. */
const KINDS = ["enums", "aliases", "structs", "callbacks", "variables", "constants", "functions"];

export const readApi = () => JSON.parse(readFileSync(API, "utf8"));

export const pageOf = (header) => `c-${header.replace(/\.h$/, "")}`;

/** The headers that have a page. */
export const headersOf = (api) => api.headers.filter(({ name }) => !EMPTY.includes(name));

/** The address of each name of the interface, enumerators among them. */
function addressesOf(api) {
  const addresses = new Map();
  for (const kind of KINDS)
    for (const item of api[kind]) {
      addresses.set(item.name, `./${pageOf(item.header)}.html#${item.name}`);
      for (const { name } of item.values ?? []) addresses.set(name, `./${pageOf(item.header)}.html#${item.name}`);
    }
  for (const { name } of headersOf(api)) addresses.set(name, `./${pageOf(name)}.html`);
  return addresses;
}

/** Escaped text in which the interface's names are links, but `self` is none. */
function linker(addresses) {
  return (text, self) =>
    escaped(text).replace(/\b(?:thud|THUD)_\w+(?:\.h\b)?/g, (name) => {
      const address = name === self ? undefined : addresses.get(name);
      return address ? `<a href="${address}">${name}</a>` : name;
    });
}

/** `type name`, or an array's or a function pointer's declaration, as C writes it. */
function declared(type, name) {
  const array = /^(.*?)( ?\[.*\])$/.exec(type);
  if (array) return `${array[1]} ${name}${array[2].trim()}`;
  return type.endsWith("*") ? `${type}${name}` : `${type} ${name}`;
}

function signatureOf({ name, returns, parameters, inline }) {
  const list = parameters.map((one) => declared(one.type, one.name)).join(",\n    ");
  const head = declared(returns, name);
  const flat = `${head}(${list.replace(/\n */g, " ")})`;
  return `${inline ? "static inline " : ""}${flat.length < 74 ? flat : `${head}(\n    ${list})`};`;
}

/** Terms with their meanings: the fields of a struct, values of an enum, parameters with a comment. */
function terms(rows, link) {
  if (rows.length === 0) return "";
  const row = ({ term, of = "", comment }) =>
    `<div><dt><code>${escaped(term)}</code> ${of && `<span>${link(of.replace("_Bool", "bool"))}</span>`}</dt><dd>${proseOf(comment, link)}</dd></div>`;
  return `<dl class="terms">${rows.map(row).join("")}</dl>`;
}

const BODY = {
  functions: (item, link) => {
    const told = item.parameters.filter(({ comment }) => comment);
    const errors = item.errors.length > 0 ? `<p class="errors">Fails with ${item.errors.map((one) => link(one)).join(", ")}.</p>` : "";
    return (
      `<pre class="signature">${link(signatureOf(item), item.name)}</pre>${proseOf(item.comment, link)}` +
      terms(told.map((one) => ({ term: one.name, of: one.type, comment: one.comment })), link) +
      errors
    );
  },
  callbacks: (item, link) => `<pre class="signature">typedef ${link(signatureOf(item), item.name)}</pre>${proseOf(item.comment, link)}`,
  structs: (item, link) => {
    const fields = (item.fields ?? []).filter(({ name }) => name !== "cookie");
    return proseOf(item.comment === item.section ? "" : item.comment, link) + terms(fields.map((one) => ({ term: one.name, of: one.type, comment: one.comment })), link);
  },
  enums: (item, link) => proseOf(item.comment, link) + terms(item.values.map((one) => ({ term: one.name, comment: one.comment })), link),
  aliases: (item, link) => `<pre class="signature">typedef ${link(declared(item.type, item.name), item.name)};</pre>${proseOf(item.comment, link)}`,
  variables: (item, link) => `<pre class="signature">extern ${link(declared(item.type, item.name), item.name)};</pre>${proseOf(item.comment, link)}`,
  constants: (item, link) => `<pre class="signature">#define ${escaped(`${item.name} ${item.text}`)}</pre>${proseOf(item.comment, link)}`,
};

/** The first sentence of a header's comment, without its name. */
function aboutOf({ name, comment }) {
  const [first] = comment.replace(`${name}: `, "").split(/\n\s*\n/);
  return first.replace(/\s+/g, " ").replace(/^(.*?[.:])(?: .*)?$/, "$1").replace(/:$/, ".");
}

/** The text of the page of a header, in Markdown. */
function textOf(api, header, link) {
  const items = KINDS.flatMap((kind) =>
    api[kind].filter((one) => one.header === header.name).map((item) => ({ kind, item })),
  );
  // In the order of the header, in which functions stand in most sections.
  const inOrder = [...items.filter(({ kind }) => kind === "functions"), ...items];
  const sections = [...new Set(inOrder.map(({ item }) => item.section))];
  const parts = sections.map((section) => {
    const own = items.filter(({ item }) => item.section === section);
    const title = section ? `## ${section[0].toUpperCase()}${section.slice(1)}\n\n` : "## Declarations\n\n";
    const texts = own.map(({ kind, item }) => {
      const group = item.group ? `<div class="group">${proseOf(item.group, link)}</div>` : "";
      return `### ${item.name} {#${item.name}}\n\n<div v-pre class="item">${BODY[kind](item, link)}${group}</div>\n`;
    });
    return title + texts.join("\n");
  });
  const head = header.comment.replace(`${header.name}: `, "");
  const intro = `${head[0].toUpperCase()}${head.slice(1)}`;
  return `# ${header.name}\n\n<div v-pre class="item">${proseOf(intro, link)}</div>\n\n${parts.join("\n")}`;
}

/** The pages as [name, text in Markdown]. */
export function cPages() {
  const api = readApi();
  const link = linker(addressesOf(api));
  return headersOf(api).map((header) => [pageOf(header.name), textOf(api, header, link)]);
}

/** The headers with a sentence each, for the list of pages. */
export function cHeaders() {
  const api = readApi();
  const count = (name) => api.functions.filter(({ header }) => header === name).length;
  return headersOf(api).map((header) => ({
    name: header.name,
    page: pageOf(header.name),
    about: aboutOf(header),
    functions: count(header.name),
  }));
}
