// Boxes 10, 100, 1,000 ... times as heavy stand on light ones: left on one, right on a column of
// ten. How far do they sink?

export const title = "Heavy on light";
export const about =
  "Boxes 10, 100, 1,000 … times as heavy stand on light ones; how far do they sink?";
export const menu = { group: "Piles and stacks", place: 380 };
export const size = { means: "powers of ten", usual: 5, least: 1, most: 8 };

const EXPONENTS = ["", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸"];

export default function ({ createWorld, size }) {
  const spacing = 4;
  const world = createWorld();
  const ground = world.createBody({ position: [0, -1] });
  world.createAabb(ground, { halfWidth: spacing * (size + 1), halfHeight: 1 });

  const marks = []; // how many times as heavy
  const box = (x, y, density) => {
    const body = world.createBody({ kind: "dynamic", position: [x, y] });
    world.createObb(body, { halfWidth: 0.5, halfHeight: 0.5, density });
  };
  for (const [group, light] of [1, 10].entries())
    for (let i = 0; i < size; i++) {
      const x = (i + 0.5 + group * size - size) * spacing;
      for (let k = 0; k < light; k++) box(x, k + 0.5, 1);
      box(x, light + 0.5, 10 ** (i + 1));
      const text = `×10${EXPONENTS[i]}`;
      marks.push({ kind: "text", x, y: -1, text, ink: "ink", size: 12 });
    }

  return {
    world,
    view: { x: 0, y: 5, height: 16, width: 2 * spacing * size },
    spawn: [0, 15],
    paint: () => ({ marks }),
  };
}
