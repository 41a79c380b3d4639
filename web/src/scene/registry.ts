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
  Games: [],
  "Levels from Tiled": [],
  "Piles and stacks": [
    ["pyramid", "Pyramid", "A pyramid of boxes stands on its base and does not spread."],
    ["circle_pit", "Circle pit", "Circles of many sizes fall into a pit and settle into a heap."],
    [
      "tall_stack",
      "Tall stack",
      "A single column of boxes stands; its height tells how soft the contacts are.",
    ],
  ],
  "In motion": [],
  "How it is done": [],
  "Crowds and extremes": [],
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
