/** Finds the option that a misspelt or foreign name probably means, for the error message. */
import { DRIVE_OPTIONS } from "../generated/slots.js";

/**
 * Names that other engines use, in lower case, and the options that they stand for: the first one
 * that the call has is suggested. The text in brackets is added to the suggestion.
 */
const OTHERS: Readonly<Record<string, readonly string[]>> = {
  width: ["halfWidth (half of it)"],
  w: ["halfWidth (half of it)"],
  hx: ["halfWidth"],
  height: ["halfHeight (half of it)"],
  h: ["halfHeight (half of it)"],
  hy: ["halfHeight"],
  halfextents: ["halfWidth (and halfHeight)"],
  size: ["halfWidth (half of it, and halfHeight)", "radius"],
  r: ["radius"],
  diameter: ["radius (half of it)"],
  exclude: ["ignore"],
  except: ["ignore"],
  skip: ["ignore"],
  bullet: ["detection"],
  ccd: ["detection"],
  type: ["kind"],
  meeting: ["kind"],
  isstatic: ["kind"],
  mass: ["density (mass per area)", "shapes (their density, or setMass)"],
  density: ["shapes (it is an option of these)"],
  friction: ["shapes (it is an option of these)"],
  restitution: ["shapes (it is an option of these)"],
  sensor: ["shapes (it is an option of these)"],
  issensor: ["sensor"],
  trigger: ["sensor"],
  bounce: ["restitution"],
  bounciness: ["restitution"],
  rotation: ["angle"],
  allowsleep: ["maySleep", "sleeping"],
  cansleep: ["maySleep", "sleeping"],
  collisionfilter: ["category (and mask)"],
  layer: ["category"],
  dt: ["timeStep"],
  fixture: ["shapes"],
  fixtures: ["shapes"],
  shape: ["shapes"],
  x: ["position", "offset", "center"],
  y: ["position", "offset", "center"],
  pos: ["position"],
  anchor: ["at"],
  anchora: ["from", "at"],
  anchorb: ["to", "at"],
  localanchora: ["frameA"],
  localanchorb: ["frameB"],
  stiffness: ["frequency", "contactStiffness", "along (its frequency)"],
  maxmotortorque: ["motorForce"],
  maxmotorforce: ["motorForce"],
  maxforce: ["motorForce"],
  enablelimit: ["lower (and upper)"],
  enablemotor: ["motorSpeed (and motorForce)"],
};

/**
 * Directions of joints, the likeliest first: where an option of a drive belongs that is given to
 * the joint itself.
 */
const DRIVES = ["turn", "along", "across"];

/**
 * The text that the message about the unknown option `name` ends with. It suggests the one of
 * `names` with the fewest edits, if these are at most a third of the letters; among equals the one
 * with the same first letter. Nothing where none is that near.
 */
export function tellNearest(name: string, names: readonly string[]): string {
  const drive = DRIVES.find((one) => names.includes(one));
  if (drive && (DRIVE_OPTIONS as readonly string[]).includes(name))
    return `; it is one of "${drive}": ${drive}: { ${name}: … }`;
  for (const told of OTHERS[name.toLowerCase()] ?? []) {
    const [known, ...rest] = told.split(" ");
    if (names.includes(known)) return `; the nearest is "${known}"${rest.map((one) => ` ${one}`).join("")}`;
  }
  const edits = names.map(
    (known) => distance(name.toLowerCase(), known.toLowerCase()) - Number(known[0] === name[0]) / 2,
  );
  const least = Math.min(...edits);
  return least <= Math.max(1, name.length / 3) ? `; the nearest is "${names[edits.indexOf(least)]}"` : "";
}

/** The Levenshtein distance of two words: letters to insert, delete or replace. Row by row. */
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
