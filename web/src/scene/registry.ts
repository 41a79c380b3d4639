/** The scenes that the page offers, in the order in which it offers them. */

export const GROUPS = [
  "Games",
  "Levels from Tiled",
  "Piles and stacks",
  "In motion",
  "How it is done",
  "Crowds and extremes",
] as const;
export type Group = (typeof GROUPS)[number];

export interface SceneEntry {
  /** As in an address: lower case and underscores. */
  name: string;
  title: string;
  /** What to look at, in one sentence. */
  about: string;
  group: Group;
  /** After how many steps its thumbnail is taken. */
  thumbnailStep: number;
}

type Row = readonly [name: string, title: string, about: string, thumbnailStep?: number];

const ROWS: Record<Group, readonly Row[]> = {
  Games: [
    ["platformer_game", "Platformer", "Run, jump and ride lifts through a level made in Tiled."],
    ["artillery", "Artillery", "Two players take turns on hills that every shell digs into."],
  ],
  "Levels from Tiled": [
    ["quarry", "Quarry", "Rubble of every size and weight slides down the benches of a quarry."],
    ["towers", "Towers and a wrecking ball", "A heavy ball flies into five towers of blocks."],
    ["mountain", "Mountain drive", "Wheels and boulders roll over a real ridge in Tennessee."],
  ],
  "Piles and stacks": [
    ["pyramid", "Pyramid", "A pyramid of boxes stands on its base and does not spread."],
    ["circle_pit", "Circle pit", "Circles of many sizes fall into a pit and settle into a heap."],
    [
      "mixed_terrain",
      "Mixed bodies on terrain",
      "Circles and boxes rain on irregular ground and gather in its valleys.",
    ],
    ["digging", "Digging", "Boxes and balls on real hills: dig the ground away under them."],
    [
      "tall_stack",
      "Tall stack",
      "A single column of boxes stands; its height tells how soft the contacts are.",
    ],
    [
      "heavy_on_light",
      "Heavy on light",
      "Boxes up to 100,000 times as heavy stand on light ones; how far do they sink?",
    ],
  ],
  "In motion": [
    ["tumbler", "Tumbler", "A turning drum churns boxes without end; none escapes."],
    [
      "tumbler_half",
      "Tumbler, half circles",
      "The same drum with circles and boxes, which flow like gravel.",
    ],
    ["smash", "Smash", "A heavy box flies into a block of small ones: watch the shock run."],
    [
      "cradle",
      "Newton's cradle",
      "As many balls leave on one side as arrive on the other, at the same speed.",
    ],
    [
      "slopes",
      "Rolling and sliding",
      "Discs roll down four slopes; of the boxes only those on the two steep ones slide.",
    ],
    [
      "bullets",
      "Bullets at thin walls",
      "Bullets of up to 100 km/s bounce between walls 2 cm thick; none gets out.",
    ],
    ["gas", "Gas", "Elastic circles fly about in a closed box; watch the energy."],
  ],
  "How it is done": [
    [
      "detection",
      "Four ways of detection",
      "Overlap, continuous, bisect, swept: bullets pass thin walls in the first lane and the third.",
    ],
    [
      "minkowski",
      "Minkowski sums",
      "Drag the shapes: they overlap where the second's centre is in the sum about the first.",
    ],
    [
      "broadphases",
      "Broadphases",
      "The cells of the grid; with the plane sweep, the sorted intervals below.",
    ],
  ],
  "Crowds and extremes": [
    [
      "platformer",
      "Platformer tiles",
      "Upright boxes run over storeys of separate tiles; gliders keep their speed.",
    ],
    ["sizes", "From 5 cm to 20 m", "Sizes differ by 400 times in one heap; none is crushed."],
    ["one_spot", "All in one spot", "A crowd collapses in one spot of a world 10 km wide."],
    ["asleep", "Twenty thousand asleep", "What sleeps costs nothing; a hundred circles stay awake."],
  ],
};

export const SCENES: readonly SceneEntry[] = GROUPS.flatMap((group) =>
  ROWS[group].map(([name, title, about, thumbnailStep = 60]) => ({
    name,
    title,
    about,
    group,
    thumbnailStep,
  })),
);

export function findScene(name: string): SceneEntry | undefined {
  return SCENES.find((scene) => scene.name === name);
}

/** The address of its module, relative to the page's. */
export function sceneFile(name: string): string {
  return `scenes/${name}.js`;
}

/** The address of its picture, relative to the page's. */
export function thumbnailFile(name: string): string {
  return `thumbs/${name}.svg`;
}
