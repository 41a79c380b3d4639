// What the scenes of the group “Joints” are made of: a part is a body with the shapes that are put
// on it. Everything is said by places in the world; bodies start unturned, and shapes are turned in
// them instead. Math.cos and the like may differ between browsers, so that there are none here.

export const PI = 3.141592653589793;

/** A mask that no shape’s category is in: nothing meets such a shape, but the pointer finds it. */
export const NOTHING = 2 ** 30;

/** The angle of a direction, by square roots and a series alone. */
export function angleOf(x, y) {
  if (x < 0) return (y < 0 ? -PI : PI) - angleOf(-x, y);
  // The tangent of an angle's half, three times.
  let t = y / (x + Math.sqrt(x * x + y * y));
  t = t / (1 + Math.sqrt(1 + t * t));
  t = t / (1 + Math.sqrt(1 + t * t));
  let sum = 0;
  for (let n = 21; n >= 1; n -= 2) sum = 1 / n - t * t * sum;
  return 8 * t * sum;
}

/** Where two circles meet, on the left of the way from a to b. */
export function meeting(a, radiusA, b, radiusB) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const square = dx * dx + dy * dy;
  const along = 0.5 * ((radiusA * radiusA - radiusB * radiusB) / square + 1);
  const aside = Math.sqrt((radiusA * radiusA) / square - along * along);
  return [a[0] + along * dx - aside * dy, a[1] + along * dy + aside * dx];
}

/** The keys of what `drive` drives. */
export const DRIVING = { left: "drive back", right: "drive on" };

/** Motors turn as the keys say, and go on so; `axles` are joints and their speeds ahead. */
export function drive(world, state, axles, held) {
  const wanted = held.left ? -1 : held.right ? 1 : state.direction;
  if (wanted === state.direction) return;
  state.direction = wanted;
  for (const { joint, speed } of axles)
    world.setDrive(joint, "turn", { motorSpeed: -wanted * speed });
}

/** Makes parts of one world, and joints between them. */
export function partsOf(world, grid) {
  const create = (kind, [x, y], options) => {
    const position = [grid(x), grid(y)];
    const body = world.createBody({ kind, position, ...options });
    return { body, x: position[0], y: position[1], mass: 0 };
  };
  const weigh = (part, area, { density = 1 }) => {
    part.mass += area * density;
    return part;
  };
  // A place in the part's frame.
  const seen = (part, [x, y]) => [grid(x) - part.x, grid(y) - part.y];

  const parts = {
    fixed: (at = [0, 0]) => create("static", at),
    moving: (at, options) => create("dynamic", at, options),

    addBox(part, halfWidth, halfHeight, { offset = [0, 0], angle = 0, ...material } = {}) {
      world.createObb(part.body, { halfWidth, halfHeight, offset, angle, ...material });
      return weigh(part, 4 * halfWidth * halfHeight, material);
    },
    addCircle(part, radius, { offset = [0, 0], ...material } = {}) {
      world.createCircle(part.body, { radius, offset, ...material });
      return weigh(part, PI * radius * radius, material);
    },
    /** A bar from place to place, 2 · half wide; it ends `shortOf` before both. */
    addBar(part, a, b, half, { shortOf = 0, ...material } = {}) {
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      return parts.addBox(part, 0.5 * Math.sqrt(dx * dx + dy * dy) - shortOf, half, {
        offset: [0.5 * (a[0] + b[0]) - part.x, 0.5 * (a[1] + b[1]) - part.y],
        angle: angleOf(dx, dy),
        ...material,
      });
    },

    box: (at, halfWidth, halfHeight, material, options) =>
      parts.addBox(create("dynamic", at, options), halfWidth, halfHeight, material),
    circle: (at, radius, material, options) =>
      parts.addCircle(create("dynamic", at, options), radius, material),
    /** A body that is one bar. */
    bar(a, b, half, { shortOf = 0, ...material } = {}, options) {
      const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
      const middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
      const part = create("dynamic", middle, options);
      const length = 0.5 * Math.sqrt(dx * dx + dy * dy) - shortOf;
      return parts.addBox(part, length, half, { angle: angleOf(dx, dy), ...material });
    },

    /** Ties b to a at a place, with the joint's axis at an angle. */
    tie: (kind, a, b, at, { angle = 0, ...options } = {}) =>
      world.createJoint({
        kind,
        bodyA: a.body,
        bodyB: b.body,
        frameA: { position: seen(a, at), angle },
        frameB: { position: seen(b, at), angle },
        ...options,
      }),
    hinge: (a, b, at, options) => parts.tie("hinge", a, b, at, options),
    /** From a place of a to one of b: a rod, or what `options`, given its length, makes of it. */
    link(a, b, from, to, options = () => ({})) {
      const [dx, dy] = [grid(to[0]) - grid(from[0]), grid(to[1]) - grid(from[1])];
      const length = Math.sqrt(dx * dx + dy * dy);
      return world.createJoint({
        kind: "distance",
        bodyA: a.body,
        bodyB: b.body,
        frameA: { position: seen(a, from) },
        frameB: { position: seen(b, to) },
        length,
        ...options(length),
      });
    },

    /**
     * A wheel on a sprung axle that goes up and down in the body, which has `wheels` of them. The
     * suspension is tuned as that of a car is: by the frequency f at which the body would bounce,
     * stiffness k = m (2πf)² for the share m of its mass that the wheel carries. A joint’s frequency
     * is about the mass that both bodies have along it, m′ = 1 / (1/body + 1/wheel), which is nearly
     * the wheel’s: the same k takes f √(m/m′), and the same damper a ratio that is larger by as
     * much. Under the body’s weight the spring gives way by g / (2πf)²: its rest is lower by that.
     */
    wheel(body, wheels, at, radius, turn, material) {
      const [bounce, ratio, travel, gravity] = [1.5, 0.4, 0.35 * radius, -10];
      const wheel = parts.circle(at, radius, material);
      const stiffer = Math.sqrt((body.mass / wheels) * (1 / body.mass + 1 / wheel.mass));
      const along = {
        frequency: bounce * stiffer,
        damping: ratio * stiffer,
        target: Math.max(-travel, gravity / (4 * PI * PI * bounce * bounce)),
        lower: -travel,
        upper: travel,
      };
      const joint = parts.tie("wheel", body, wheel, at, { angle: 0.5 * PI, along, turn });
      return { ...wheel, joint };
    },
  };
  return parts;
}
