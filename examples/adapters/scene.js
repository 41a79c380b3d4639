/** What all pages of this folder show: a room with a pile of crates and a red ball, which can be dragged. */
import { circle, load, obb, walls } from "thud";

export const SCALE = 40; // pixels a metre
export const [WIDTH, HEIGHT] = [640, 480]; // pixels
const RED = 0xff0000;
const BROWN = 0xb08050;

export async function makeScene() {
  const thud = await load();
  const world = thud.createWorld();
  world.createBody({ shapes: walls(8, 6, 1) });
  const place = (i) => [(i % 6) - 2.5, -5.5 + Math.floor(i / 6)];
  const crates = world.createBodies({ kind: "dynamic", shapes: [obb(0.5, 0.5)] }, Array.from({ length: 18 }, (_, i) => place(i)));
  const ball = world.createBody({ kind: "dynamic", position: [-5, 3], velocity: [6, 0], shapes: [circle(0.6, { restitution: 0.5 })] });
  const things = crates.map((body) => ({ body, size: 1, round: false, colour: BROWN }));
  return { world, ball, things: [...things, { body: ball, size: 1.2, round: true, colour: RED }] };
}

/** Calls `picture` with the seconds since the last picture, at the rate of the display, while `running`. */
export function run(example) {
  globalThis.example = Object.assign(example, { running: true }); // for the console
  let last = NaN;
  requestAnimationFrame(function frame(now) {
    if (example.running) example.picture(Math.min((now - last) / 1000 || 0, 0.1));
    last = now;
    requestAnimationFrame(frame);
  });
}
