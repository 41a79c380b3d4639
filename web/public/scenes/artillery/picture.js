// What is drawn over the bodies: tanks, shell, aim, wind, explosions, and the figures at the top.

import { MOST_SPEED } from "./controls.js";
import { flightAt } from "./flight.js";
import { barrel, SHELL_RADIUS, TANK } from "./tanks.js";

const INKS = ["player", "rival"];

/** `most` is a tank's health at the start; `own`: over a network, the tank of this screen. */
export function picture({ world, view, state: game }, tanks, shell, most, own) {
  const marks = [];
  tanks.forEach((tank, i) => {
    const { health, angle } = game.tanks[i];
    paintTank(marks, world, tank, angle, health > 0 ? INKS[i] : "soft");
    const [x, y] = world.bodyStateOf(tank.body).position;
    if (health === 0) paintSmoke(marks, x, y + 0.6, game.waited);
    paintHealth(marks, x, y + 2.7, health / most);
  });
  if (game.phase === "choose") paintChoice(marks, view);
  else paintWind(marks, view, game.wind);
  if (game.phase === "aim") paintAim(marks, world, tanks[game.turn], game);
  if (game.phase === "fly") paintShell(marks, world, shell, game);
  game.effects.forEach((effect) => paintEffect(marks, effect));
  return {
    marks,
    figures: figures(game, own),
    message: game.online ? messageOf(game, own) : game.message,
    follow: follow(world, view, shell, game),
  };
}

/** The view stands still, tanks and all, as long as the shell or what it does is in sight. */
function follow(world, view, shell, game) {
  const ring = game.effects.find(({ kind }) => kind === "ring");
  const place = game.phase === "fly" ? world.bodyStateOf(shell).position : ring && [ring.x, ring.y];
  if (!place) return [view.x, view.y];
  const out = Math.max(0, Math.min(20, Math.abs(place[0] - view.x) - 0.4 * view.width));
  const x = view.x + out * Math.sign(place[0] - view.x);
  return [x, Math.max(view.y, place[1] - 0.35 * view.height)];
}

const SIDES = ["Left", "Right"];

function messageOf({ waits, phase, turn, waited, message }, own) {
  if (waits) return "Waiting for the other player.";
  if (phase !== "aim") return message;
  if (turn !== own) return `${SIDES[turn]} aims.`;
  const which = waited < 150 ? `Yours is the ${SIDES[own].toLowerCase()} tank. ` : "";
  return `${which}Your turn: aim, set the power and fire.`;
}

function figures(game, own) {
  const names = game.computer ? ["You", "Computer"] : SIDES.map((side, i) => (game.online && i === own ? "You" : side));
  const health = names.map((label, i) => ({ label, value: `${game.tanks[i].health}` }));
  if (game.phase === "choose") return health;
  const { angle, speed } = game.tanks[game.turn];
  const elevation = angle > 90 ? 180 - angle : angle;
  return [
    ...health,
    { label: "Wind", value: `${Math.abs(game.wind).toFixed(1)} ${game.wind < 0 ? "←" : "→"}` },
    { label: "Angle", value: `${Math.round(elevation)}° ${angle > 90 ? "←" : "→"}` },
    { label: "Power", value: `${Math.round((100 * speed) / MOST_SPEED)} %` },
  ];
}

function paintTank(marks, world, tank, aim, ink) {
  const { position, angle } = world.bodyStateOf(tank.body);
  const [x, y] = position;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const place = (across, up) => [x + across * c - up * s, y + across * s + up * c];
  const { pivot, muzzle } = barrel(world, tank, aim);
  marks.push({
    kind: "box",
    x: (pivot[0] + muzzle[0]) / 2,
    y: (pivot[1] + muzzle[1]) / 2,
    halfWidth: Math.hypot(muzzle[0] - pivot[0], muzzle[1] - pivot[1]) / 2,
    halfHeight: 0.13,
    angle: (aim * Math.PI) / 180,
    ink,
    filled: true,
  });
  marks.push({ kind: "circle", x: pivot[0], y: pivot[1], radius: 0.5, ink, filled: true });
  const [hx, hy] = place(0, 0.12);
  const hull = { halfWidth: TANK.halfWidth, halfHeight: 0.32, round: 0.2 };
  marks.push({ kind: "box", x: hx, y: hy, ...hull, angle, ink, filled: true });
  for (const across of [-0.85, -0.28, 0.28, 0.85]) {
    const [wx, wy] = place(across, -TANK.halfHeight + 0.24);
    marks.push({ kind: "circle", x: wx, y: wy, radius: 0.24, ink: "soft", filled: true });
  }
}

function paintHealth(marks, x, y, share) {
  const half = 1.5;
  const bar = { kind: "box", y, halfHeight: 0.2, round: 0.1, filled: true };
  const ink = share > 0.6 ? "good" : share > 0.3 ? "gold" : "bad";
  marks.push({ ...bar, x, halfWidth: half, ink: "soft", opacity: 0.5 });
  marks.push({ ...bar, x: x - half * (1 - share), halfWidth: half * share, ink });
}

/** Puffs that rise for a second and a half, one after the other, over a tank that is done for. */
function paintSmoke(marks, x, y, clock) {
  for (let i = 0; i < 6; i++) {
    const share = (clock / 90 + i / 6) % 1;
    const puff = { radius: 0.3 + 0.7 * share, opacity: 0.5 * (1 - share) };
    const place = { x: x + 0.4 * Math.sin(5 * share + i), y: y + 4 * share };
    marks.push({ kind: "circle", ...place, ...puff, ink: "soft", filled: true });
  }
}

/** Above the tanks, and in a low window below the figures. */
function paintChoice(marks, view) {
  const y = view.y + 2.5;
  const choices = [
    [-10.5, "player", "← One player"],
    [10.5, "rival", "Two players →"],
  ];
  for (const [x, ink, text] of choices) {
    const button = { halfWidth: 9, halfHeight: 2.6, round: 1 };
    marks.push({ kind: "box", x, y, ...button, ink, opacity: 0.2, filled: true });
    marks.push({ kind: "box", x, y, ...button, ink });
    marks.push({ kind: "text", x, y, text, ink: "ink", size: 16 });
  }
}

/** An arrow above the field, as long as the wind is strong. */
function paintWind(marks, view, wind) {
  const y = view.y + 0.3 * view.height;
  const tip = view.x + 2.4 * wind;
  const back = tip - Math.sign(wind) * 0.7;
  const arrow = { kind: "line", ink: "accent", width: 3 };
  marks.push({ kind: "text", x: view.x, y: y + 1.3, text: "Wind", ink: "ink" });
  marks.push({ ...arrow, points: [[view.x - 2.4 * wind, y], [tip, y]] });
  marks.push({ ...arrow, points: [[back, y + 0.6], [tip, y], [back, y - 0.6]] });
}

/** Whose turn it is, the first part of the flight, and the slingshot's string. */
function paintAim(marks, world, tank, game) {
  const { angle, speed } = game.tanks[game.turn];
  const ink = INKS[game.turn];
  const { pivot, muzzle, direction } = barrel(world, tank, angle);
  const bob = 0.25 * Math.sin(game.waited / 8);
  const [x, y] = [world.bodyStateOf(tank.body).position[0], pivot[1] + 3.4 + bob];
  const pointer = [[x - 0.6, y + 0.8], [x, y], [x + 0.6, y + 0.8]];
  marks.push({ kind: "line", points: pointer, ink, width: 4 });
  if (game.computer && game.turn === 1) return;
  const velocity = [speed * direction[0], speed * direction[1]];
  for (let i = 1; i <= 12; i++) {
    const [px, py] = flightAt(muzzle, velocity, game.wind, 0.07 * i);
    const dot = { radius: 0.16, opacity: 1 - i / 14 };
    marks.push({ kind: "circle", x: px, y: py, ...dot, ink, filled: true });
  }
  if (!game.pull) return;
  const { from, by } = game.pull;
  const end = [from[0] - by[0], from[1] - by[1]];
  marks.push({ kind: "line", points: [from, end], ink, dashed: true });
  marks.push({ kind: "circle", x: from[0], y: from[1], radius: 0.25, ink, filled: true });
  marks.push({ kind: "circle", x: end[0], y: end[1], radius: 0.6, ink });
}

function paintShell(marks, world, shell, { trail }) {
  const [x, y] = world.bodyStateOf(shell).position;
  for (let i = 0; i < 16; i++) {
    const [tx, ty] = trail[trail.length - 16 + i] ?? trail[0] ?? [x, y];
    const puff = { radius: 0.06 + 0.01 * i, opacity: (i + 1) / 24 };
    marks.push({ kind: "circle", x: tx, y: ty, ...puff, ink: "ink", filled: true });
  }
  marks.push({ kind: "circle", x, y, radius: SHELL_RADIUS + 0.06, ink: "ink", filled: true });
}

function paintEffect(marks, { kind, x, y, age, life, radius, text }) {
  const share = age / life;
  const opacity = 1 - share;
  if (kind === "loss") {
    marks.push({ kind: "text", x, y: y + 2 * share, text, ink: "bad", size: 18 });
    return;
  }
  const grown = radius * Math.sqrt(share);
  const fire = { kind: "circle", x, y, ink: "gold", filled: true };
  marks.push({ ...fire, radius: 0.7 * grown, opacity: 0.7 * opacity });
  if (kind === "flash") return;
  marks.push({ kind: "circle", x, y, radius: grown, ink: "bad", opacity });
  for (let i = 0; i < 12; i++) {
    const angle = (i * Math.PI) / 6;
    const far = grown * (0.7 + 0.15 * ((i * 5) % 4)); // sparks fly unequally far
    const place = { x: x + far * Math.cos(angle), y: y + far * Math.sin(angle) };
    marks.push({ kind: "circle", ...place, radius: 0.15 * opacity, ink: "gold", filled: true });
  }
}
