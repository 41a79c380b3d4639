// What is drawn over the bodies: the cars in their players’ colours, and the figures at the top.

import { CABIN, HULL, TIP, WHEEL } from "./cars.js";
import { GOAL, present, READY } from "./rules.js";

const INKS = ["player", "rival", "good", "gold"];
const COLOURS = ["Orange", "Blue", "Green", "Yellow"];

export function picture(world, arena, cars, state, own) {
  const marks = [];
  cars.forEach((car, i) => {
    if (!state.players[i].gone) paintCar(marks, world, car, INKS[i]);
  });
  cars.forEach((car, i) => {
    const { gone } = state.players[i];
    const [x, y] = world.positionOf(car.hull);
    const name = nameOf(state, i, own);
    if (!gone) marks.push({ kind: "text", x, y: y + 1.15, text: name, ink: INKS[i], size: 13 });
  });
  return {
    marks,
    figures: state.players.flatMap(({ score, here }, i) => (
      here ? [{ label: nameOf(state, i, own), value: `${score} of ${GOAL}` }] : []
    )),
    message: messageOf(state, own),
  };
}

function nameOf({ alone, friend }, i, own) {
  if (!alone) return i === own ? "You" : COLOURS[i];
  if (friend) return i < 2 ? COLOURS[i] : "Computer";
  return i === 0 ? "You" : cars(i);
}

const cars = (i) => (i === 1 ? "Computer" : `Computer ${i}`);

function messageOf(state, own) {
  const { phase, waited, winner } = state;
  if (present(state) < 2) return "Waiting for another player.";
  if (phase === "ready" && waited < READY - 90) {
    if (state.alone) return "Push the others off.";
    return own < 0 ? "Who stays longest gets a point." : `Yours is the ${COLOURS[own].toLowerCase()} car: push the others off.`;
  }
  if (phase === "ready") return String(Math.ceil((READY - waited) / 30));
  if (phase === "fight") return waited < 40 ? "Go!" : "";
  if (winner < 0) return "Nobody stayed: no point.";
  const name = nameOf(state, winner, own);
  const [wins, stays] = name === "You" ? ["win the game", "stay"] : ["wins the game", "stays"];
  return phase === "won" ? `${name} ${wins}!` : `${name} ${stays}: a point.`;
}

function paintCar(marks, world, car, ink) {
  const [x, y] = world.positionOf(car.hull);
  const { cosine, sine, angle } = world.rotationOf(car.hull);
  const { halfWidth: wide, halfHeight: high } = HULL;
  const place = ([along, up]) => [x + cosine * along - sine * up, y + sine * along + cosine * up];
  const box = ({ offset, halfWidth, halfHeight }, colour, round) => {
    const [bx, by] = place(offset);
    marks.push({ kind: "box", x: bx, y: by, halfWidth, halfHeight, round, angle, ink: colour, filled: true });
  };
  const right = [[wide, high], [wide, -0.1 * high], TIP, [wide, -high]];
  const left = right.map(([along, up]) => [-along, up]).reverse();
  marks.push({ kind: "line", points: [...right, ...left].map(place), ink, filled: true });
  box(CABIN, ink, 0.14);
  box({ ...CABIN, halfWidth: 0.28, halfHeight: 0.1 }, "soft", 0.05);
  for (const wheel of car.wheels) {
    const [wx, wy] = world.positionOf(wheel);
    const turned = world.rotationOf(wheel);
    const [dx, dy] = [0.7 * WHEEL * turned.cosine, 0.7 * WHEEL * turned.sine];
    marks.push({ kind: "circle", x: wx, y: wy, radius: WHEEL, ink: "soft", filled: true });
    marks.push({ kind: "line", points: [[wx - dx, wy - dy], [wx + dx, wy + dy]], ink: "ink", width: 2 });
  }
}
