// What is drawn beside and over the circles: the tests of the last steps against n² / 2 and
// n log₂ n, on a scale on which each line is ten times the one below, and the grid's cells.

const POINTS = 120;

export function chart(past, counts, size, half) {
  const left = 1.25 * half;
  const width = 1.05 * half;
  const most = Math.max(2, Math.log10(Math.max((size * (size - 1)) / 2, 1)) + 0.3);
  const height = (value) => (Math.log10(Math.max(value, 1)) / most) * 2 * half - half;
  const line = (label, value, ink) => [
    {
      ...{ kind: "line", ink, dashed: true },
      points: [
        [left, height(value)],
        [left + width, height(value)],
      ],
    },
    { kind: "text", x: left + 0.5 * width, y: height(value) + 0.05 * half, text: label, ink },
  ];
  const points = Array.from({ length: POINTS }, (_, i) => [
    left + (width * i) / (POINTS - 1),
    height(past[Math.max(0, past.length - POINTS + i)] ?? counts.tested),
  ]);
  return [
    { kind: "line", points: [[left, half], [left, -half], [left + width, -half]], ink: "soft" },
    ...line("n (n − 1) / 2", (size * (size - 1)) / 2, "bad"),
    ...line("n log₂ n", size * Math.log2(size), "gold"),
    ...line("pairs found", counts.found, "good"),
    { kind: "line", points, ink: "accent", width: 3 },
    {
      ...{ kind: "text", text: "pairs tested", ink: "accent" },
      ...{ x: left + 0.5 * width, y: height(counts.tested) - 0.11 * half },
    },
  ];
}

/** The lines between cells of a size by hand, which begin at the least centre, as the engine's do. */
export function lattice({ broadphase, cellSize }, poses, bodies, half) {
  if (broadphase !== "grid" || cellSize === 0) return [];
  const least = (k) => bodies.reduce((low, { index }) => Math.min(low, poses[4 * index + k]), Infinity);
  const [x0, y0] = [least(0), least(1)];
  const count = Math.ceil((2 * half) / cellSize) + 1;
  const far = (count - 1) * cellSize;
  return Array.from({ length: count }, (_, i) => i * cellSize).flatMap((at) => [
    { kind: "line", points: [[x0 + at, y0], [x0 + at, y0 + far]], ink: "soft", width: 1 },
    { kind: "line", points: [[x0, y0 + at], [x0 + far, y0 + at]], ink: "soft", width: 1 },
  ]);
}
