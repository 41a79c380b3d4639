/** What the worlds of other engines in examples are drawn and advanced by. */

/** Styles of `World.draw` of thud: static, dynamic, sleeping. */
export const styleOf = (isStatic, isAwake) => (isStatic ? 0 : isAwake ? 2 : 3);

/** Makes whole steps of 1/60 s of the time that passes. */
export function steps(step) {
  let left = 0;
  return (seconds) => {
    for (left += seconds; left >= 1 / 60; left -= 1 / 60) step();
  };
}

/** A row of a circle. */
export const circleOf = ({ x, y }, radius, angle) => [x, y, radius, radius, Math.cos(angle), Math.sin(angle), 1];
