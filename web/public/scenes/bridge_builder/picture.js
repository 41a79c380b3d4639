// What is drawn over the bodies: the plan, the bridge by its strain, vehicles, water, and the
// figures and words at the top.

import { NODE_RADIUS, STRUT_HALF } from "./bridge.js";
import { BED, placeOf, ROAD_HALF, ROWS, VIEW } from "./levels.js";
import {
  beamsAlong, costOf, isRoad, joinsSame, lengthOf, refusal, wishOf,
} from "./plan.js";

export function picture(world, levels, vehicles, game) {
  const level = levels[game.level];
  const marks = [];
  for (const gorge of levels) paintGorge(marks, gorge);
  if (game.phase === "plan") paintPlan(marks, level, game);
  else paintBridge(marks, world, level, game.bridge);
  for (const vehicle of vehicles) paintVehicle(marks, world, vehicle);
  if (game.phase === "won") paintStars(marks, level, game);
  for (const effect of game.effects) paintEffect(marks, effect);
  return {
    marks,
    figures: figures(levels, level, game),
    message: message(levels, game),
    buttons: buttons(levels, game),
    follow: follow(world, level, vehicles[game.level], game.phase),
  };
}

/** What happens in the gorge is in sight; on a narrow screen the view goes along a little. */
function follow(world, { x, width }, vehicle, phase) {
  const middle = x + width / 2;
  const ahead = phase === "plan" ? 0 : world.bodyStateOf(vehicle.chassis).position[0] - middle;
  const reach = width / 2;
  return [middle + 0.4 * Math.max(-reach, Math.min(reach, ahead)), VIEW.y];
}

function figures(levels, level, game) {
  const stars = game.stars.reduce((sum, one) => sum + one, 0);
  const strains = game.bridge ? game.bridge.beams.map(({ strain }) => strain) : [];
  const all = [
    { label: "Gorge", value: `${game.level + 1} of ${levels.length}` },
    { label: "Money", value: `${level.budget - costOf(game.plan.beams)}` },
    { label: "Stars", value: `${stars} of ${3 * levels.length}` },
  ];
  if (!game.bridge) return all;
  const load = game.broken > 0 ? `${game.broken} broken` : `${percent(Math.max(0, ...strains))}`;
  return [...all, { label: "Strain", value: load }];
}

function percent(share) {
  return `${Math.round(100 * share)} %`;
}

function message(levels, { phase, note, level, plan, broken, first, stars }) {
  if (phase === "drive")
    return broken > 0 ? "It breaks!" : "Beams turn from green to red before they break.";
  if (phase === "lost")
    return broken > 0 ? "The bridge gave way. Make it stronger." : "That is no way across.";
  if (phase === "won" && level === levels.length - 1)
    return `${note} All gorges are crossed: ${stars.reduce((a, b) => a + b)} stars.`;
  if (note) return note;
  return plan.beams.length === 0
    ? "Drag across the gorge from ring to ring: that is the road. Then prop it with triangles."
    : first.length > 0
      ? "What is red broke first: prop it there with triangles."
      : "Triangles hold. Tap the middle of a beam to remove it.";
}

/** What stands on the buttons of the keys. */
function buttons(levels, { phase, level }) {
  if (phase === "plan") return { left: "Undo", right: "Clear", fire: "Drive" };
  if (phase === "drive") return { fire: "Stop" };
  if (phase === "lost") return { fire: "Back to the plan" };
  return { left: "Again", fire: level === levels.length - 1 ? "New game" : "Next gorge" };
}

/** Water, and a flag where to go. */
function paintGorge(marks, { x, width }) {
  const water = { kind: "box", halfWidth: width / 2 - 0.1, ink: "rival", filled: true };
  marks.push({ ...water, x: x + width / 2, y: BED + 0.6, halfHeight: 0.6, opacity: 0.4 });
  const pole = x + width + 1.3;
  const top = ROAD_HALF + 2.4;
  marks.push({ kind: "line", points: [[pole, ROAD_HALF], [pole, top]], ink: "soft", width: 3 });
  const cloth = { halfWidth: 0.5, halfHeight: 0.32, ink: "gold", filled: true };
  marks.push({ kind: "box", x: pole + 0.5, y: top - 0.3, ...cloth });
}

function paintPlan(marks, level, { plan, first }) {
  const { beams, selected, press, pointer } = plan;
  for (let column = 0; column <= level.columns; column++)
    for (let row = -ROWS; row <= ROWS; row++)
      paintDot(marks, level, [column, row], { radius: 0.07, ink: "soft", opacity: 0.6 });
  for (const beam of beams) {
    const broke = first.some((other) => joinsSame(beam, other));
    paintBeam(marks, level, beam, broke ? "bad" : isRoad(beam) ? "ink" : "accent");
  }
  for (const { from, to } of beams)
    for (const end of [from, to])
      paintDot(marks, level, end, { radius: NODE_RADIUS, ink: "ink" });
  for (const end of level.anchors) {
    paintDot(marks, level, end, { radius: 0.22, ink: "gold" });
    paintDot(marks, level, end, { radius: 0.42, ink: "gold", filled: false });
  }
  if (press) paintWish(marks, level, wishOf(level, beams, selected, press, pointer), beams);
  else if (selected) paintDot(marks, level, selected, { radius: 0.6, ink: "good", filled: false });
}

/** What letting go would do. */
function paintWish(marks, level, { add, remove, select }, beams) {
  if (remove !== undefined) paintBeam(marks, level, beams[remove], "bad");
  if (select) paintDot(marks, level, select, { radius: 0.6, ink: "good", filled: false });
  if (!add) return;
  const [from, to] = add;
  const added = beamsAlong(beams, from, to);
  const refused = refusal(level, beams, added) !== "";
  for (const beam of added) paintBeam(marks, level, beam, refused ? "bad" : "good");
  paintDot(marks, level, from, { radius: 0.6, ink: "good", filled: false });
  paintDot(marks, level, to, { radius: 0.6, ink: refused ? "bad" : "good", filled: false });
  const [x, y] = placeOf(level, to);
  const cost = `−${costOf(added)}`;
  if (!refused) marks.push({ kind: "text", x, y: y + 1.4, text: cost, ink: "good", size: 16 });
  else paintRefusal(marks, level, refusal(level, beams, added));
}

/** Above the middle, where a phone shows all of it. */
function paintRefusal(marks, { x, width }, text) {
  const place = { x: x + width / 2, y: placeOf({ x }, [0, ROWS])[1] + 1.2 };
  marks.push({ kind: "text", ...place, text, ink: "bad", size: 15 });
}

function paintDot(marks, level, place, look) {
  const [x, y] = placeOf(level, place);
  marks.push({ kind: "circle", x, y, filled: true, ...look });
}

function paintBeam(marks, level, beam, ink) {
  const [x0, y0] = placeOf(level, beam.from);
  const [x1, y1] = placeOf(level, beam.to);
  marks.push({
    kind: "box",
    x: (x0 + x1) / 2,
    y: (y0 + y1) / 2,
    halfWidth: lengthOf(beam) / 2,
    halfHeight: isRoad(beam) ? ROAD_HALF : STRUT_HALF,
    angle: Math.atan2(y1 - y0, x1 - x0),
    round: 0.08,
    ink,
    filled: true,
  });
}

/** Green, through gold, to red. */
function paintBridge(marks, world, level, { beams, nodes }) {
  for (const { body, road, halfLength, strain, broken } of beams) {
    const { position, angle } = world.bodyStateOf(body);
    const look = {
      kind: "box",
      x: position[0],
      y: position[1],
      angle,
      halfWidth: halfLength,
      halfHeight: road ? ROAD_HALF : STRUT_HALF,
      round: 0.08,
      filled: true,
    };
    const half = strain < 0.5;
    const over = half ? "gold" : "bad";
    marks.push({ ...look, ink: broken ? "soft" : half ? "good" : "gold" });
    marks.push({ ...look, ink: over, opacity: broken ? 0 : half ? 2 * strain : 2 * strain - 1 });
  }
  for (const body of nodes) {
    const [x, y] = world.bodyStateOf(body).position;
    marks.push({ kind: "circle", x, y, radius: NODE_RADIUS, ink: "ink", filled: true });
  }
  for (const end of level.anchors) paintDot(marks, level, end, { radius: 0.22, ink: "gold" });
}

function paintVehicle(marks, world, { kind, chassis, wheels }) {
  const { position, angle } = world.bodyStateOf(chassis);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const box = (x, y, halfWidth, halfHeight, ink) =>
    marks.push({
      kind: "box",
      x: position[0] + c * x - s * y,
      y: position[1] + s * x + c * y,
      halfWidth,
      halfHeight,
      angle,
      round: 0.12,
      ink,
      filled: true,
    });
  const inks = ["soft", ...kind.inks];
  kind.boxes.forEach((sizes, i) => box(...sizes.slice(0, 4), inks[i]));
  box(...kind.window, "ink");
  for (const wheel of wheels) {
    const state = world.bodyStateOf(wheel);
    const [wx, wy] = state.position;
    const tyre = { kind: "circle", x: wx, y: wy, filled: true };
    marks.push({ ...tyre, radius: kind.radius, ink: "ink" });
    marks.push({ ...tyre, radius: 0.5 * kind.radius, ink: "soft" });
    const dx = kind.radius * Math.cos(state.angle);
    const dy = kind.radius * Math.sin(state.angle);
    const points = [[wx - dx, wy - dy], [wx + dx, wy + dy]];
    marks.push({ kind: "line", points, ink: "soft", width: 2 });
  }
}

/** They come one after the other. */
function paintStars(marks, { x, width }, { waited, stars, level }) {
  for (let i = 0; i < 3; i++) {
    const share = Math.min(1, Math.max(0, (waited - 15 * i) / 15));
    const place = { x: x + width / 2 + 2.6 * (i - 1), y: 5 + (i === 1 ? 0.6 : 0) };
    const got = i < stars[level];
    const size = Math.max(1, Math.round((got ? 52 : 40) * share));
    marks.push({ kind: "text", ...place, text: got ? "★" : "☆", ink: "gold", size });
  }
}

/** A beam that broke: a ring, and sparks. */
function paintEffect(marks, { x, y, age, life }) {
  const share = age / life;
  const far = 1.6 * Math.sqrt(share);
  const fading = { ink: "bad", opacity: 1 - share };
  marks.push({ kind: "circle", x, y, radius: far, ...fading });
  for (let i = 0; i < 6; i++) {
    const at = { x: x + far * Math.cos(i + y), y: y + far * Math.sin(i + y) };
    marks.push({ kind: "circle", ...at, radius: 0.09, ...fading, filled: true });
  }
}
