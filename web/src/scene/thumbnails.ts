/**
 * The step, size and view at which each scene is drawn as a small picture (tools/thumbnails.mjs).
 */
import type { View } from "./scene";

export interface Thumbnail {
  /** Number of steps before the picture. Default 60. */
  steps?: number;
  /** Default: the scene's usual size. */
  size?: number;
  /** Default: the scene's own view. */
  view?: View;
}

/** By the name of a scene. A scene without an entry has the defaults. */
export const THUMBNAILS: Readonly<Record<string, Thumbnail>> = {
  platformer_game: { view: { x: 17.5, y: 9, height: 20 } },
  game_car: { view: { x: 0, y: 0, height: 46 } },
  game_platformer: { view: { x: 7, y: 3, height: 16 } },
  artillery: { view: { x: -11.5, y: 0.5, height: 12 } },
  sumo: { steps: 205, view: { x: -2.5, y: 0.6, height: 7 } },
  quarry: { steps: 240 },
  playground: { steps: 150, view: { x: 26, y: 12, height: 22 } },
  platform: { steps: 90, view: { x: 36, y: 13, height: 22 } },
  mountain: { steps: 90, view: { x: 210, y: 22, height: 44 } },
  circle_pit: { size: 500, steps: 90 },
  pyramid: { size: 22 },
  brick_wall: { steps: 75 },
  avalanche: { size: 800, steps: 170 },
  mixed_terrain: { size: 120, steps: 150, view: { x: 0, y: 3, height: 18 } },
  tall_stack: { size: 14 },
  dominoes: { size: 18, steps: 330 },
  hourglass: { size: 2000, steps: 400 },
  conveyors: { steps: 420 },
  pistons: { steps: 200 },
  tumbler: { size: 300, steps: 150 },
  tumbler_half: { size: 300, steps: 100 },
  smash: { size: 500, steps: 45 },
  cradle: { steps: 30 },
  bounce: { steps: 130 },
  slopes: { size: 12, steps: 45, view: { x: 30, y: 4, height: 12 } },
  bullets: { size: 3, steps: 3, view: { x: -9, y: 0, height: 6 } },
  gas: { size: 250, steps: 90 },
  newtons_cradle: { steps: 8 },
  bridge: { steps: 330, view: { x: 0, y: -1, height: 20 } },
  chain: { steps: 200 },
  wrecking_ball: { steps: 105 },
  crane: { steps: 300 },
  ragdolls: { steps: 75, view: { x: -2.5, y: 4.6, height: 7 } },
  cars: { steps: 250, view: { x: -2, y: 6, height: 18 } },
  trebuchet: { steps: 330 },
  walker: { steps: 100, view: { x: 1, y: 3.6, height: 16 } },
  textured: { steps: 240, view: { x: 7.5, y: 1.8, height: 7 } },
  scissor: { size: 8, steps: 1 },
  clock: { steps: 90, view: { x: 0, y: 0.6, height: 18.6 } },
  blobs: { size: 10, steps: 90, view: { x: 0, y: 4.5, height: 12 } },
  joint_grid: { size: 12 },
  boats: { steps: 45, view: { x: -1.5, y: 0.6, height: 14 } },
  flags: { steps: 290, view: { x: -5, y: 4.6, height: 12 } },
  explosion: { steps: 74, view: { x: -1.5, y: 4.2, height: 13 } },
  planks: { size: 20, steps: 250, view: { x: 0, y: 7, height: 19 } },
  crates: { steps: 80, view: { x: 0, y: 3.6, height: 11 } },
  meetings: { steps: 200 },
  galton_board: { steps: 1500 },
  filters: { size: 300, steps: 90 },
  minkowski: { size: 1 },
  far_away: { steps: 75 },
  sizes: { size: 500, steps: 200 },
  platformer: { size: 120 },
  one_spot: { size: 500, steps: 80 },
  asleep: { size: 160 },
};
