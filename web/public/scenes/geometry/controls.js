// Controls of two shapes, which the state has by names that end in the shape’s letter.

const KINDS = [
  { value: "circle", label: "Circle" },
  { value: "aabb", label: "AABB" },
  { value: "obb", label: "OBB" },
];

/** What is set of a shape by number; the letter ends the names in the state. */
export const slidersOf = (letter) =>
  [
    ["x", "Place, x", -8, 8, 0.05],
    ["y", "Place, y", -5, 5, 0.05],
    ["angle", "Angle, °", -180, 180, 1],
    ["width", "Width", 0.4, 5, 0.1],
    ["height", "Height", 0.4, 5, 0.1],
    ["wayX", "Way, x", -12, 12, 0.1],
    ["wayY", "Way, y", -8, 8, 0.1],
  ].map(([name, label, least, most, step]) => {
    const group = `Shape ${letter} by numbers`;
    return slider(name + letter, label, least, most, step, group);
  });

export const slider = (name, label, least, most, step, group) => (
  { kind: "slider", name, label, least, most, step, group }
);
export const kindOf = (letter) => (
  { kind: "choice", name: `kind${letter}`, label: letter, options: KINDS, group: "Shapes" }
);
export const check = (name, label, about, group = "Look at") => (
  { kind: "check", name, label, about, group }
);
