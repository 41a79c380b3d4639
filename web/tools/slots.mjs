#!/usr/bin/env node
/**
 * Writes web/package/src/generated/slots.ts: the index of each number in the module's slots and
 * rows, computed from the structs of web/wasm/slots.h and rows.h, as const enums, which the
 * compiler replaces by their numbers.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const here = (file) => fileURLToPath(new URL(`../${file}`, import.meta.url));
const camel = (name) => name.replace(/_(\w)/g, (_, letter) => letter.toUpperCase());
const capital = (name) => name[0].toUpperCase() + name.slice(1);

/** A declaration in a struct, and one of the members that it declares. */
const MEMBERS = /(?:struct\s+(\w+)|double|float|uint32_t)\s+([^;]+);/g;
const MEMBER = /^(\w+)(?:\[(\d+)\])?$/;

/**
 * Parses the structs of a C text such as slots.h. Returns by the struct's name its length (a count
 * of numbers) and its members, each { name, at, length, part }; `part`: the member is a struct
 * itself. Throws for a member of another form.
 */
export function readStructs(text) {
  const structs = new Map();
  const plain = text.replace(/\/\*[\s\S]*?\*\//g, "");
  for (const [, name, body] of plain.matchAll(/^struct (\w+) \{([^}]*)\};/gm)) {
    const members = [];
    let length = 0;
    for (const [, part, list] of body.matchAll(MEMBERS))
      for (const word of list.split(",").map((one) => one.trim())) {
        const [, member, count = "1"] = MEMBER.exec(word) ?? refuse(`${name}: ${word}`);
        const each = part === undefined ? 1 : (structs.get(part)?.length ?? refuse(part));
        members.push({ name: camel(member), at: length, length: each * count, part: !!part });
        length += each * count;
      }
    structs.set(name, { members, length });
  }
  return structs;
}

function refuse(what) {
  throw new Error(`web/wasm/slots.h: ${what} cannot be read`);
}

/** The source of slots.ts. */
export function typescriptOf(structs) {
  const parts = [...structs].map(([name, { members, length }]) => {
    const places = members.map((member) => `  ${member.name} = ${member.at},\n`).join("");
    return `export const enum ${capital(camel(name))}At {\n${places}  length = ${length},\n}\n`;
  });
  for (const [name, { members }] of structs) {
    if (!name.endsWith("_options")) continue;
    const names = members
      .filter(({ part }) => !part)
      .flatMap((member) => [member.name, ...(member.length === 2 ? ["."] : [])]);
    const words = names.map((one) => `  ${JSON.stringify(one)},\n`).join("");
    parts.push(`export const ${name.toUpperCase()} = [\n${words}] as const;\n`);
  }
  const head = "/** Made of web/wasm/slots.h by web/tools/slots.mjs; see there. */\n";
  return [head, ...parts].join("\n");
}

export const STRUCTS = readStructs(
  ["rows", "slots"].map((name) => readFileSync(here(`wasm/${name}.h`), "utf8")).join("\n"),
);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  mkdirSync(here("package/src/generated"), { recursive: true });
  writeFileSync(here("package/src/generated/slots.ts"), typescriptOf(STRUCTS));
}
