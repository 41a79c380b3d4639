import { Application, Container, Graphics } from "pixi.js";
import { PixiView } from "thud/pixi";
import { HEIGHT, makeScene, run, SCALE, WIDTH } from "./scene.js";

const app = new Application();
await app.init({ width: WIDTH, height: HEIGHT, background: "white", antialias: true, autoStart: false });
document.body.append(app.canvas);
const camera = app.stage.addChild(new Container({ x: WIDTH / 2, y: HEIGHT / 2 }));
const { world, ball, things } = await makeScene();
const view = new PixiView(world, camera, { scale: SCALE });
for (const { body, size, round, colour } of things) {
  const pixels = SCALE * size;
  const shape = new Graphics();
  if (round) shape.circle(0, 0, pixels / 2);
  else shape.rect(-pixels / 2, -pixels / 2, pixels, pixels);
  view.add(body, shape.fill(colour));
}
view.drag(app);
const seen = camera.addChild(new Graphics());

run({
  world,
  ball,
  canvas: app.canvas,
  picture(seconds) {
    const { alpha } = world.advance(seconds);
    view.update(alpha);
    if (location.search === "?debug") view.debug(seen, { shapes: true, contacts: true, lower: [-8, -6], upper: [8, 6] });
    app.render();
    return alpha;
  },
});
