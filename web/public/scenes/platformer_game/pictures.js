// What the game draws besides the bodies of the world. Lengths are metres.

const SPIKE = 0.5; // about the width of one

// Its upper side holds, the rest does not: the dashes say so.
export function plank(x, y, halfWidth, halfHeight) {
  const top = y + halfHeight;
  const points = [[x - halfWidth, top], [x + halfWidth, top]];
  return [{ kind: "line", points, ink: "soft", width: 3, dashed: true }];
}

export function coin(x, y, radius) {
  return [
    { kind: "circle", x, y, radius, ink: "gold", filled: true },
    { kind: "circle", x, y, radius: 0.6 * radius, ink: "ink", opacity: 0.4 },
  ];
}

export function spikes(x, y, halfWidth, halfHeight) {
  const count = Math.round((2 * halfWidth) / SPIKE);
  const points = Array.from({ length: 2 * count + 1 }, (_, i) => [
    x - halfWidth + (i * halfWidth) / count,
    y + (i % 2 === 0 ? -halfHeight : halfHeight),
  ]);
  return [{ kind: "line", points, ink: "bad", width: 3 }];
}

// A pole with a pennant, which goes up once the figure has been there.
export function checkpoint(x, y, halfHeight, reached) {
  const top = y + halfHeight;
  const pennant = reached ? top : y;
  const ink = reached ? "good" : "soft";
  return [
    { kind: "line", points: [[x, y - halfHeight], [x, top]], ink, width: 3 },
    {
      kind: "line",
      points: [[x, pennant], [x + 0.8, pennant - 0.3], [x, pennant - 0.6]],
      ink,
      width: 3,
    },
  ];
}

// A chequered flag.
export function goal(x, y, halfHeight) {
  const top = y + halfHeight;
  const dark = [0, 2, 5, 7]; // of two rows of four squares
  return [
    { kind: "line", points: [[x, y - halfHeight], [x, top]], ink: "ink", width: 4 },
    { kind: "box", x: x + 0.8, y: top - 0.4, halfWidth: 0.8, halfHeight: 0.4, ink: "ink" },
    ...dark.map((i) => ({
      kind: "box",
      x: x + 0.2 + 0.4 * (i % 4),
      y: top - 0.2 - 0.4 * Math.floor(i / 4),
      halfWidth: 0.2,
      halfHeight: 0.2,
      ink: "ink",
      filled: true,
    })),
  ];
}
