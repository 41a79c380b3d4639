// Car sumo: push the others off the platform, whose ends fall away. One plays against the computer,
// two at one keyboard, and two to four over a network: `match` is what the page needs for that. It runs
// steps again when a key of another player arrives late, so that all that changes stands in the world
// and in `state`, and `step` depends on them and on the players’ inputs alone.
// Change the rules below, or the files that they are made of in scenes/sumo.

import { buildArena } from "./sumo/arena.js";
import { think } from "./sumo/bot.js";
import { buildCars, drive, INPUTS, inputOf } from "./sumo/cars.js";
import { picture } from "./sumo/picture.js";
import { attend, judge, newGame } from "./sumo/rules.js";

export const title = "Car sumo";
export const about = "Push the other cars off the platform: alone, at one keyboard, or with a friend by a link.";
export const menu = { group: "Games", place: 125 };
export const size = { means: "cars", usual: 2, least: 2, most: 4 };

export default function ({ createWorld, grid, size }) {
  const world = createWorld({ gravity: [0, -14], timeStep: 1 / 60, sleeping: false });
  const arena = buildArena(world, size);
  const cars = buildCars(world, grid, arena, size);
  const wide = 2 * arena.half;
  let own = 0; // the car of whoever looks at this screen; -1: they only watch
  const scene = {
    world,
    view: { x: 0, y: 1.2, height: 12, width: wide + 4, tall: { x: 0, y: -0.5, height: 12, width: wide + 1.5 } },
    keys: {
      left: "drive",
      right: "drive",
      up: "hop",
      restart: "begin anew",
      left2: "drive the second car",
      right2: "drive the second car",
      up2: "let it hop",
    },
    hidden: cars.flatMap((car) => car.parts.map(({ body }) => body.index)),
    state: newGame(size),
    update({ held }) {
      const { state } = scene;
      if (held.restart) begin();
      // Who presses a key of the second player takes the second car from the computer.
      const inputs = [inputOf(held.left, held.right, held.up), inputOf(held.left2, held.right2, held.up2)];
      if (inputs[1]) state.friend = true;
      const players = state.friend ? 2 : 1;
      const all = cars.map((_, i) => (i < players ? inputs[i] : think(world, arena, cars, state, i)));
      drive(world, cars, state, all);
    },
    stepped: () => judge(world, arena, cars, scene.state),
    paint: () => picture(world, arena, cars, scene.state, own),
    match: {
      inputs: INPUTS,
      input: (held) => inputOf(held.left || held.left2, held.right || held.right2, held.up || held.up2),
      begin(player) {
        own = player ?? -1;
        scene.state.alone = false;
      },
      step(inputs) {
        attend(world, arena, cars, scene.state, inputs);
        drive(world, cars, scene.state, inputs);
        world.step();
        judge(world, arena, cars, scene.state);
      },
    },
  };
  return scene;

  function begin() {
    Object.assign(scene.state, { ...newGame(size), friend: scene.state.friend });
    arena.mend(world);
    cars.forEach((car, i) => car.place(world, arena.half, i, size));
  }
}
