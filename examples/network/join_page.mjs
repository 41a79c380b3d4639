/**
 * Joins the game of the server that the page came from, draws it, and drives by keys or touch; with
 * ?seed=N the car drives at random.
 */
import { load } from "thud";
import { carsInput, HALF_LENGTH, HALF_WIDTH, IDLE } from "./cars.mjs";
import { play } from "./join.mjs";

const state = document.querySelector("#state");
const canvas = document.querySelector("canvas");
const held = new Set();
let touched = null; // where, from -1 to 1 across and along the canvas

addEventListener("keydown", ({ key }) => held.add(key));
addEventListener("keyup", ({ key }) => held.delete(key));
for (const name of ["pointerdown", "pointermove", "pointerup", "pointercancel"])
  canvas.addEventListener(name, ({ buttons, offsetX, offsetY }) => {
    const place = [(2 * offsetX) / canvas.clientWidth - 1, 1 - (2 * offsetY) / canvas.clientHeight];
    touched = buttons ? place : null;
  });

/** The input by what is held: 3 * (drive + 1) + turn + 1. */
function steer({ world, bodies, me }) {
  if (touched) {
    const [x, y] = world.positionOf(bodies.cars[me]);
    const wanted = Math.atan2(touched[1] * HALF_WIDTH - y, touched[0] * HALF_LENGTH - x);
    const off = wanted - world.rotationOf(bodies.cars[me]).angle;
    const turn = Math.sin(off) > 0.1 ? 1 : Math.sin(off) < -0.1 ? -1 : 0;
    return 6 + turn + 1;
  }
  const axis = (less, more) => (held.has(more) ? 1 : 0) - (held.has(less) ? 1 : 0);
  return IDLE + 3 * axis("ArrowDown", "ArrowUp") + axis("ArrowRight", "ArrowLeft");
}

function draw({ world, bodies, me, steps, end }) {
  const context = canvas.getContext("2d");
  canvas.width = canvas.clientWidth * devicePixelRatio;
  canvas.height = canvas.clientHeight * devicePixelRatio;
  const scale = Math.min(canvas.width / (2 * HALF_LENGTH + 2), canvas.height / (2 * HALF_WIDTH + 2));
  const place = (body, fill, path) => {
    const [[x, y], { cosine, sine }] = [world.positionOf(body), world.rotationOf(body)];
    const [c, s] = [scale * cosine, scale * sine];
    context.setTransform(c, -s, -s, -c, canvas.width / 2 + scale * x, canvas.height / 2 - scale * y);
    context.fillStyle = fill;
    context.beginPath();
    path();
    context.fill();
  };
  context.setTransform(scale, 0, 0, scale, canvas.width / 2, canvas.height / 2);
  context.fillStyle = "#ddd";
  context.fillRect(-HALF_LENGTH, -HALF_WIDTH, 2 * HALF_LENGTH, 2 * HALF_WIDTH);
  bodies.cars.forEach((car, player) =>
    place(car, player === me ? "#c22" : "#26c", () => {
      context.rect(-0.8, -0.4, 1.6, 0.8);
      context.rect(0.8, -0.2, 0.15, 0.4); // the front
    }),
  );
  place(bodies.ball, "#284", () => context.arc(0, 0, 0.5, 0, 2 * Math.PI));
  for (const crate of bodies.crates) place(crate, "#975", () => context.rect(-0.5, -0.5, 1, 1));
  state.textContent = `Player ${me}, step ${steps} of ${end}`;
}

const seed = new URLSearchParams(location.search).get("seed");
const choose = seed === null ? steer : (peer) => carsInput(Number(seed), peer.me, peer.steps);
let peer = null;
let isOver = false;
const onFrame = (playing) => {
  peer = playing;
};
/** A page that is loaded anew comes back as who it was. */
sessionStorage.token ??= crypto.getRandomValues(new BigUint64Array(1))[0].toString();
const token = BigInt(sessionStorage.token);
const show = () => {
  if (isOver) return;
  if (peer) draw(peer);
  requestAnimationFrame(show);
};
show();
try {
  const thud = await load();
  const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}`, "thud");
  peer = await play(thud, socket, choose, { onFrame, token });
  draw(peer);
  const other = peer.net.differs < 0 ? "" : "; another player had another game";
  state.textContent = `The game is over after ${peer.end} steps, hash ${peer.hash}${other}`;
} catch (error) {
  state.textContent = `The game has ended: ${error.message}`;
}
isOver = true;
