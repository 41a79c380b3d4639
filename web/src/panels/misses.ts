/** The text with which comparisons begin where parts of the scene cannot be built in Box2D. */

/** Says that thud and Box2D are not comparable, since Box2D lacks `misses` (a few words each). ""
 * without any. */
export function missesText(misses: readonly string[]): string {
  if (misses.length === 0) return "";
  const last = misses.at(-1)!;
  const all = misses.length > 1 ? `${misses.slice(0, -1).join(", ")} and ${last}` : last;
  return (
    `Not comparable: Box2D is not given ${all}. That acts in thud alone, so the two do not run ` +
    "the same scene, and neither is called faster or more accurate."
  );
}
