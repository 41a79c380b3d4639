/** Prints a refused value for an error message. */

/** Characters of the printed value; the rest is cut off. Chosen. */
const LONGEST = 60;
/** Elements of a list that are printed: more would not fit into LONGEST. */
const ITEMS = 20;

/**
 * The value as it would be written in a program: strings in quotes, lists and objects with their
 * contents, nested ones at most one level deep.
 */
export function show(value: unknown): string {
  const told = written(value, 0);
  return told.length > LONGEST ? `${told.slice(0, LONGEST)}…` : told;
}

/** The value in full; `depth`: the number of lists and objects around it. */
function written(value: unknown, depth: number): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (typeof value === "function") return "a function";
  if (typeof value !== "object" || value === null) return String(value);
  const isList = Array.isArray(value) || ArrayBuffer.isView(value);
  if (depth > 1) return isList ? "[…]" : "{…}";
  const values = isList
    ? Array.from(value as ArrayLike<unknown>).slice(0, ITEMS).map((one) => written(one, depth + 1))
    : Object.entries(value).map(([name, one]) => `${name}: ${written(one, depth + 1)}`);
  if (isList) return `[${values.join(", ")}]`;
  return values.length > 0 ? `{ ${values.join(", ")} }` : "{}";
}
