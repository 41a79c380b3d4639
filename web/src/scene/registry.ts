/** The scenes that the page offers, in the order in which it offers them. */
import type { View } from "./scene";

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
  thumbnail: Thumbnail;
}

/** When and at what size a scene looks best as a small picture. */
export interface Thumbnail {
  /** Default 60. */
  steps?: number;
  /** Default the scene's usual size. */
  size?: number;
  /** Default the scene's own view. */
  view?: View;
}

type Row = readonly [name: string, title: string, about: string, thumbnail?: Thumbnail];

const ROWS: Record<Group, readonly Row[]> = {
  Games: [
    [
      "platformer_game",
      "Platformer",
      "Run, jump and ride lifts through a level made in Tiled.",
      { view: { x: 17.5, y: 9, height: 20 } },
    ],
    [
      "artillery",
      "Artillery duel",
      "Against the computer or a friend, on real hills that every shell digs into.",
      { view: { x: -11.5, y: 0.5, height: 12 } },
    ],
  ],
  "Levels from Tiled": [
    [
      "quarry",
      "Quarry",
      "Rubble of every size and weight slides down the benches of a quarry.",
      { steps: 240 },
    ],
    [
      "platform",
      "Platforms",
      "Walk on stairs, planks and lifts, among crates and balls.",
      { steps: 90, view: { x: 36, y: 13, height: 22 } },
    ],
    ["towers", "Towers and a wrecking ball", "A heavy ball flies into five towers of blocks."],
    [
      "mountain",
      "Mountain drive",
      "Walk a real ridge in Tennessee among rolling wheels and boulders.",
      { steps: 90, view: { x: 210, y: 22, height: 44 } },
    ],
  ],
  "Piles and stacks": [
    [
      "circle_pit",
      "Circle pit",
      "Ten thousand circles fall into a pit and settle into a heap.",
      { size: 500, steps: 90 },
    ],
    [
      "pyramid",
      "Pyramid",
      "A pyramid of boxes stands on its base and does not spread.",
      { size: 22 },
    ],
    [
      "brick_wall",
      "Brick wall",
      "A heavy ball flies into a wall of loose bricks; explode what is left.",
      { steps: 75 },
    ],
    ["digging", "Digging", "Boxes and balls on real hills: dig the ground away under them."],
    [
      "avalanche",
      "Avalanche",
      "Rubble comes down both sides of a real mountain until friction holds it.",
      { size: 800, steps: 170 },
    ],
    [
      "mixed_terrain",
      "Mixed bodies on terrain",
      "Circles and boxes rain on irregular ground and gather in its valleys.",
      { size: 120, steps: 150, view: { x: 0, y: 3, height: 18 } },
    ],
    [
      "tall_stack",
      "Tall stack",
      "A single column of boxes stands; its height tells how soft the contacts are.",
      { size: 14 },
    ],
    [
      "heavy_on_light",
      "Heavy on light",
      "Boxes up to 100,000 times as heavy stand on light ones; how far do they sink?",
    ],
  ],
  "In motion": [
    [
      "dominoes",
      "Dominoes",
      "Each knocks over one a little larger, until a giant falls.",
      { size: 18, steps: 330 },
    ],
    [
      "hourglass",
      "Hourglass",
      "Three thousand grains run through a neck; every half minute the glass turns.",
      { size: 2000, steps: 400 },
    ],
    [
      "conveyors",
      "Conveyor belts",
      "Belts whose surface runs carry parcels to and fro, round and round.",
      { steps: 420 },
    ],
    [
      "pistons",
      "Pistons",
      "Forty pistons run as a wave and carry what lies on them.",
      { steps: 200 },
    ],
    [
      "tumbler",
      "Tumbler",
      "A turning drum churns boxes without end; none escapes.",
      { size: 300, steps: 150 },
    ],
    [
      "tumbler_half",
      "Tumbler, half circles",
      "The same drum with circles and boxes, which flow like gravel.",
      { size: 300, steps: 100 },
    ],
    [
      "smash",
      "Smash",
      "A heavy box flies into a block of small ones: watch the shock run.",
      { size: 500, steps: 45 },
    ],
    [
      "cradle",
      "Newton's cradle",
      "As many balls leave on one side as arrive on the other, at the same speed.",
      { steps: 30 },
    ],
    [
      "bounce",
      "Bouncing",
      "Restitution from 0 to 1: the last ball should never tire.",
      { steps: 130 },
    ],
    [
      "slopes",
      "Rolling and sliding",
      "Discs roll down four slopes; of the boxes only those on the two steep ones slide.",
      { size: 12, steps: 45, view: { x: 30, y: 4, height: 12 } },
    ],
    [
      "bullets",
      "Bullets at thin walls",
      "Bullets of up to 100 km/s bounce between walls 2 cm thick; none gets out.",
      { size: 3, steps: 3, view: { x: -9, y: 0, height: 6 } },
    ],
    [
      "gas",
      "Gas",
      "Elastic circles fly about in a closed box; watch the energy.",
      { size: 250, steps: 90 },
    ],
  ],
  "How it is done": [
    [
      "sketch",
      "A scene of your own",
      "A small one to start from: open Code, change a number, press Run.",
    ],
    [
      "detection",
      "Four ways of detection",
      "Overlap, continuous, bisect, swept: in two of the lanes bullets pass thin walls.",
    ],
    [
      "galton_board",
      "Galton board",
      "Sensors count the balls that reach each bin: the numbers come out bell-shaped.",
      { steps: 1500 },
    ],
    [
      "filters",
      "Filters",
      "Two heaps in one pit, circles and boxes, that do not know of each other.",
      { size: 300, steps: 90 },
    ],
    [
      "minkowski",
      "Minkowski sums",
      "Drag the shapes: they overlap where the second's centre is in the sum about the first.",
      { size: 1 },
    ],
    [
      "broadphases",
      "Broadphases",
      "The cells of the grid; with the plane sweep, the sorted intervals below.",
    ],
  ],
  "Crowds and extremes": [
    [
      "far_away",
      "10,000 km away",
      "A heap 10,000 km from the origin, and how far it is from its twin at the origin.",
      { steps: 75 },
    ],
    [
      "sizes",
      "From 5 cm to 20 m",
      "Sizes differ by 400 times in one heap; none is crushed.",
      { size: 500, steps: 200 },
    ],
    [
      "platformer",
      "Platformer tiles",
      "Upright boxes run over storeys of separate tiles; gliders keep their speed.",
      { size: 120 },
    ],
    [
      "one_spot",
      "All in one spot",
      "A crowd collapses in one spot of a world 10 km wide.",
      { size: 500, steps: 80 },
    ],
    [
      "asleep",
      "Twenty thousand asleep",
      "What sleeps costs nothing; a hundred circles stay awake.",
      { size: 160 },
    ],
  ],
};

export const SCENES: readonly SceneEntry[] = GROUPS.flatMap((group) =>
  ROWS[group].map(([name, title, about, thumbnail = {}]) => ({
    name,
    title,
    about,
    group,
    thumbnail,
  })),
);

/** What a visitor sees first. */
export const FIRST_SCENE = "brick_wall";

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
