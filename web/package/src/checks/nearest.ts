/** What a misspelt option is likely to mean. */

/** To be told after the name that nobody knows. Of two as near it is the one that begins alike. */
export function tellNearest(name: string, names: readonly string[]): string {
  const edits = names.map(
    (known) => distance(name.toLowerCase(), known.toLowerCase()) - Number(known[0] === name[0]) / 2,
  );
  return `; the nearest is "${names[edits.indexOf(Math.min(...edits))]}"`;
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
