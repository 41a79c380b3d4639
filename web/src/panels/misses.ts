/** What a comparison with Box2D says first: what Box2D is not given of the scene. */

/** Of the scene that runs, or was measured: what Box2D is not given; "" where it is given all. */
export function missesText(misses: readonly string[]): string {
  if (misses.length === 0) return "";
  const last = misses.at(-1)!;
  const all = misses.length > 1 ? `${misses.slice(0, -1).join(", ")} and ${last}` : last;
  return (
    `Not comparable: Box2D is not given ${all}. That acts in thud alone, so the two do not run ` +
    "the same scene, and neither is called faster or more accurate."
  );
}
