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
  group: Group;
}

type Row = readonly [name: string, title: string];

const ROWS: Record<Group, readonly Row[]> = {
  Games: [
    ["platformer_game", "Platformer"],
    ["artillery", "Artillery duel"],
  ],
  "Levels from Tiled": [
    ["quarry", "Quarry"],
    ["platform", "Platforms"],
    ["towers", "Towers and a wrecking ball"],
    ["mountain", "Mountain walk"],
  ],
  "Piles and stacks": [
    ["circle_pit", "Circle pit"],
    ["pyramid", "Pyramid"],
    ["brick_wall", "Brick wall"],
    ["digging", "Digging"],
    ["avalanche", "Avalanche"],
    ["mixed_terrain", "Mixed bodies on terrain"],
    ["tall_stack", "Tall stack"],
    ["heavy_on_light", "Heavy on light"],
  ],
  "In motion": [
    ["dominoes", "Dominoes"],
    ["hourglass", "Hourglass"],
    ["conveyors", "Conveyor belts"],
    ["pistons", "Pistons"],
    ["tumbler", "Tumbler"],
    ["tumbler_half", "Tumbler, half of it circles"],
    ["smash", "Smash"],
    ["cradle", "Newton's cradle"],
    ["bounce", "Bouncing"],
    ["slopes", "Rolling and sliding"],
    ["bullets", "Bullets at thin walls"],
    ["gas", "Gas"],
  ],
  "How it is done": [
    ["sketch", "A scene of your own"],
    ["detection", "Four ways of detection"],
    ["galton_board", "Galton board"],
    ["filters", "Filters"],
    ["minkowski", "Minkowski sums"],
    ["broadphases", "Broadphases"],
  ],
  "Crowds and extremes": [
    ["far_away", "10,000 km away"],
    ["sizes", "From 5 cm to 20 m"],
    ["platformer", "Platformer tiles"],
    ["one_spot", "All in one spot"],
    ["asleep", "Twenty thousand asleep"],
  ],
};

export const SCENES: readonly SceneEntry[] = GROUPS.flatMap((group) =>
  ROWS[group].map(([name, title]) => ({ name, title, group })),
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
