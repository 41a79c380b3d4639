/** Options are known by name: a misspelt one must not be passed over in silence. */
import { ThudError } from "../error.js";

type Names = readonly string[];

/** Throws for an option that is not among `names` and `others`, and tells the nearest that is. */
export function checkNames(what: string, options: object, names: Names, others: Names = []): void {
  if (typeof options !== "object" || options === null)
    throw new ThudError("invalid", `${what}: options are an object: ${options}`);
  // Unlike a list of keys this makes nothing.
  for (const name in options)
    if (!names.includes(name) && !others.includes(name)) refuse(what, name, [...names, ...others]);
}

function refuse(what: string, name: string, names: Names): never {
  const edits = names.map((known) => distance(name.toLowerCase(), known.toLowerCase()));
  const nearest = names[edits.indexOf(Math.min(...edits))];
  const told = `no option is called "${name}"; the nearest is "${nearest}"`;
  throw new ThudError("invalid", `${what}: ${told}`);
}

/** Letters to put in, take out or change between two words (Levenshtein), row by row. */
function distance(from: string, to: string): number {
  let row = Array.from({ length: to.length + 1 }, (_, i) => i);
  for (const letter of from) {
    let last = row[0] + 1;
    row = row.map((above, i) => {
      if (i > 0) last = Math.min(last + 1, above + 1, row[i - 1] + Number(letter !== to[i - 1]));
      return last;
    });
  }
  return row[to.length];
}
