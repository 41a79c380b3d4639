import { CanvasView } from "thud/canvas";
import { HEIGHT, makeScene, run, SCALE, WIDTH } from "./scene.js";

const canvas = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT });
document.body.append(canvas);
const { world, ball, things } = await makeScene();
const view = new CanvasView(world, canvas, { scale: SCALE });
for (const { body, size, round, colour } of things)
  view.add(body, (context) => {
    context.fillStyle = `#${colour.toString(16)}`;
    context.beginPath();
    if (round) context.arc(0, 0, size / 2, 0, 2 * Math.PI);
    else context.rect(-size / 2, -size / 2, size, size);
    context.fill();
  });
view.drag();

run({
  world,
  ball,
  canvas,
  picture(seconds) {
    const { alpha } = world.advance(seconds);
    view.draw(alpha);
    if (location.search === "?debug") view.debug({ shapes: true, contacts: true, joints: true });
    return alpha;
  },
});
