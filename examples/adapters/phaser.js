import Phaser from "phaser";
import { PhaserView } from "thud/phaser";
import { HEIGHT, makeScene, SCALE, WIDTH } from "./scene.js";

const { world, ball, things } = await makeScene();
let alpha = 0;
let view;
let seen;

function create() {
  this.cameras.main.centerOn(0, 0);
  view = new PhaserView(world, this, { scale: SCALE });
  for (const { body, size, round, colour } of things) {
    const pixels = SCALE * size;
    view.add(body, round ? this.add.circle(0, 0, pixels / 2, colour) : this.add.rectangle(0, 0, pixels, pixels, colour));
  }
  view.drag();
  seen = this.add.graphics();
  globalThis.example = example; // for the console
}

function update(_time, milliseconds) {
  alpha = world.advance(Math.min(milliseconds / 1000, 0.1)).alpha;
  view.update(alpha);
  if (location.search === "?debug") view.debug(seen, { shapes: true, contacts: true, lower: [-8, -6], upper: [8, 6] });
}

const game = new Phaser.Game({
  width: WIDTH,
  height: HEIGHT,
  backgroundColor: "#ffffff",
  banner: false,
  audio: { noAudio: true },
  scene: { create, update },
});
const example = {
  world,
  ball,
  get canvas() {
    return game.canvas;
  },
  set running(on) {
    if (on) game.loop.wake();
    else game.loop.sleep();
  },
  picture(seconds) {
    game.step(performance.now(), 1000 * seconds);
    return alpha;
  },
};
