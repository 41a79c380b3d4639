// The two shapes as the calls of “thud/geometry” take them, and what these calls tell.

/** Thickness of what stands for a segment: shapes have a size. */
export const THIN = 1e-9;

export function capsuleOf(state, letter) {
  const end = (i) => [state[`x${letter}${i}`], state[`y${letter}${i}`]];
  return { kind: "capsule", from: end(1), to: end(2), radius: state[`radius${letter}`] };
}

export function otherOf(state) {
  const { kindB: kind, xB1, yB1, radiusB, widthB, heightB, angleB } = state;
  if (kind === "capsule") return capsuleOf(state, "B");
  const center = [xB1, yB1];
  if (kind === "circle") return { kind, center, radius: radiusB };
  const box = { kind, center, halfWidth: widthB / 2, halfHeight: heightB / 2 };
  return kind === "aabb" ? box : { ...box, angle: (angleB * Math.PI) / 180 };
}

export function look(thud, geometry, state) {
  const [a, b] = [capsuleOf(state, "A"), otherOf(state)];
  const way = [a.to[0] - a.from[0], a.to[1] - a.from[1]];
  const closest = geometry.capsuleClosest(thud, a, b);
  const segment = geometry.capsuleClosest(thud, { ...a, radius: THIN }, b);
  // A circle at its start is a capsule whose ends coincide.
  const circle = { ...a, to: a.from };
  const impact = geometry.capsuleTimeOfImpact(thud, circle, way, b, [0, 0]);
  return { a, b, way, closest, segment: segment.distance + THIN, impact };
}
