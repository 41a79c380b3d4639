// Bounding volumes around two shapes and around a crowd: the area that they waste, the false alarms
// that they give, and what a test takes. Beside them a proxy, which bounds nothing: it misses hits.

import { check, kindOf, slider, slidersOf } from "./geometry/controls.js";
import { drag } from "./geometry/hands.js";
import { addClock, LETTERS, shapeOf } from "./geometry/look.js";
import { boundsOf, countCrowd, KINDS, makeCrowd, moved } from "./lab_volumes/crowd.js";
import { paintVolumes } from "./lab_volumes/picture.js";
import { tellVolumes } from "./lab_volumes/tell.js";

export const title = "Bounding volumes";
export const about = "Circle, AABB and OBB: the area they waste, their false alarms, and what a test takes.";
export const menu = { group: "Laboratory", place: 156 };
export const size = { means: "shapes", usual: 40, least: 2, most: 200 };

const NAMES = { circle: "Circle", aabb: "AABB", obb: "OBB", proxy: "Proxy" };
const ABOUTS = {
  circle: "One distance to compare. It suits round shapes, and is the same however they turn.",
  aabb: "Two intervals to compare. It suits what stands upright.",
  obb: "It turns with its shape, and wastes least.",
  proxy: "A circle of the shape’s area in its place. It is no bound: corners stick out of it.",
};

const CONTROLS = [
  {
    kind: "choice",
    name: "drawn",
    label: "Draw",
    options: KINDS.map((value) => ({ value, label: NAMES[value] })),
    group: "Volumes",
  },
  ...KINDS.map((kind) => check(kind, NAMES[kind], ABOUTS[kind], "Volumes")),
  slider("slender", "Length over width", 1, 12, 0.5, "Crowd"),
  slider("turned", "Turned by, °", 0, 90, 1, "Crowd"),
  check("exact", "The exact test", "What every pair of volumes that overlap has to take then, beside the tests of the volumes.", "Crowd"),
  kindOf("A"),
  kindOf("B"),
  ...[...slidersOf("A"), ...slidersOf("B")].filter(({ name }) => !name.startsWith("way")),
];

export default async function ({ createWorld, loadGeometry, thud, random, seed, size }) {
  const geometry = await loadGeometry();
  const clock = addClock(thud, geometry);
  const state = {
    ...{ drawn: "aabb", circle: true, aabb: true, obb: true, proxy: true, exact: true },
    ...{ slender: 4, turned: 30 },
    ...{ kindA: "obb", xA: -3.4, yA: 3.2, angleA: 30, widthA: 3.4, heightA: 0.9 },
    ...{ kindB: "obb", xB: -1.1, yB: 3.5, angleB: -75, widthB: 2.6, heightB: 0.8 },
    grip: null, // what the pointer holds
    near: null, // what it would take
  };
  /** The crowd is counted anew only where what it is made of has changed. */
  let [counted, made] = [null, ""];
  const crowdNow = () => {
    const wanted = [state.slender, state.turned].join();
    if (wanted === made) return counted;
    made = wanted;
    const shapes = makeCrowd(random(seed + 7), size).map((one) => moved(one, state));
    counted = countCrowd(thud, geometry, shapes);
    return counted;
  };
  return {
    world: createWorld({ gravity: [0, 0] }),
    view: { x: 0, y: 0.3, height: 13, width: 13 },
    pointer: true,
    controls: CONTROLS,
    state,
    pointed: (pointer) => drag(state, pointer),
    paint() {
      const shapes = LETTERS.map((letter) => shapeOf(state, letter));
      const bounds = boundsOf(thud, geometry, shapes);
      const overlaps = geometry.closest(thud, ...shapes).overlaps;
      const seen = { shapes, bounds, overlaps, crowd: crowdNow() };
      const costs = clock.costs({
        shapes,
        bounds: Object.fromEntries(KINDS.map((kind) => {
          const [first, second] = bounds[kind].volumes;
          return [kind, { first, second }];
        })),
      });
      return { ...paintVolumes(state, seen), ...tellVolumes(seen, costs) };
    },
  };
}
