/**
 * Plays a game on a plain canvas, in a folder of your own: index.html?pool, by any bundler, or by
 * `npx vite`. Keys: arrows, Space, Enter; the pointer where the game heeds it.
 */
import { load } from "thud";
import { CanvasView } from "thud/canvas";
import { NO_KEYS, settingOf, stepOf } from "./step.js";

const KEYS = { ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", Space: "fire", Enter: "restart" };
const INKS = {
  ...{ ink: "#eef2f9", soft: "#9fb0cb", accent: "#ff9468", good: "#6ee7a0", bad: "#ff8080" },
  ...{ gold: "#ffd166", water: "#4fb3ee", player: "#ff9d5c", rival: "#6cc4ff" },
};
const STEP = 1 / 60; // s

const name = location.search.slice(1) || "brick_breaker";
const { default: setUp, title } = await import(`./${name}.mjs`);
const game = await setUp(settingOf(await load()));
document.title = title;

const canvas = document.querySelector("canvas");
const view = new CanvasView(game.world, canvas);
const held = { ...NO_KEYS };
let pointer = null;
for (const type of ["keydown", "keyup"])
  addEventListener(type, (event) => {
    const key = event.code === "Space" && !("fire" in game.keys) ? "up" : KEYS[event.code];
    if (!key) return;
    held[key] = type === "keydown";
    event.preventDefault();
  });
for (const type of ["pointerdown", "pointermove", "pointerup", "pointercancel"])
  canvas.addEventListener(type, (event) => {
    const [x, y] = view.placeOf(event);
    pointer = { x, y, down: event.buttons > 0 };
  });

/** Draws a mark in the world's units, with y up. */
function draw(context, mark) {
  const { kind, ink, opacity = 1, width = 2, filled = kind === "figure" } = mark;
  context.save();
  context.globalAlpha = opacity;
  context.strokeStyle = context.fillStyle = INKS[ink];
  context.lineWidth = width / view.scale;
  context.beginPath();
  if (kind === "line") for (const [x, y] of mark.points) context.lineTo(x, y);
  else {
    context.translate(mark.x, mark.y);
    context.rotate(mark.angle ?? 0);
    if (kind === "circle") context.arc(0, 0, mark.radius, 0, 2 * Math.PI);
    else context.rect(-mark.halfWidth, -mark.halfHeight, 2 * mark.halfWidth, 2 * mark.halfHeight);
  }
  if (filled) context.fill();
  else context.stroke();
  context.restore();
}

function picture() {
  const ratio = devicePixelRatio;
  [canvas.width, canvas.height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
  const { x, y, width, height } = game.view;
  const { follow = [x, y], marks, figures, message } = game.paint();
  view.center = follow;
  view.scale = Math.min(canvas.width / width, canvas.height / height);
  view.draw(1);
  view.debug({ shapes: true });
  const { context } = view;
  context.setTransform(view.scale, 0, 0, -view.scale, canvas.width / 2, canvas.height / 2);
  context.translate(-follow[0], -follow[1]);
  for (const mark of marks) draw(context, mark);
  const text = `${figures.map(({ label, value }) => `${label} ${value}`).join(" · ")} · ${message}`;
  const line = document.querySelector("p");
  if (line.textContent !== text) line.textContent = text;
}

let [last, time, step] = [NaN, 0, 0];
requestAnimationFrame(function frame(now) {
  time += Math.min((now - last) / 1000 || 0, 0.1);
  last = now;
  for (; time >= STEP; time -= STEP) stepOf(game, step++, { held, pointer });
  picture();
  requestAnimationFrame(frame);
});
globalThis.game = game; // for the console
