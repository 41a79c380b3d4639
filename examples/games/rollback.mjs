/**
 * Air hockey between two peers over a slow network. Neither waits for the other: each predicts that
 * the other's input has not changed, and where that was wrong restores that step and runs the steps
 * since then again.
 */
import { aabb, circle, load, Rollback } from "thud";

const STEPS = 1800; // of the match
const LATEST = 12; // the largest delay of an input, steps
const IDLE = 4; // an input of 0 to 8: x is its remainder by 3, y its quotient, each minus 1
const [PUCK, STRIKER] = [1, 2]; // categories

const thud = await load();

/** The game as one peer has it: its world, with puck and strikers, and its rollback. */
function createPeer() {
  const world = thud.createWorld({ gravity: [0, 0] });
  const wall = (halfWidth, halfHeight, x, y, mask = PUCK | STRIKER) =>
    aabb(halfWidth, halfHeight, { offset: [x, y], mask, restitution: 0.9 });
  const sides = [wall(10, 0.5, 0, 5.5), wall(10, 0.5, 0, -5.5)];
  const goals = [-10, 10].flatMap((x) => [wall(0.5, 1, x, -4), wall(0.5, 1, x, 4)]);
  world.createBody({ shapes: [...sides, ...goals, wall(0.1, 5, 0, 0, STRIKER)] });
  const addDisc = (x, radius, category, linearDamping) => {
    const shapes = [circle(radius, { category, restitution: 0.9, friction: 0 })];
    return world.createBody({ kind: "dynamic", position: [x, 0], linearDamping, shapes });
  };
  const puck = addDisc(0, 0.5, PUCK, 0.1);
  const strikers = [addDisc(-6, 0.8, STRIKER, 3), addDisc(6, 0.8, STRIKER, 3)];
  world.setVelocity(puck, [6, 4]);

  const step = (inputs, score) => {
    inputs.forEach((held, player) => {
      world.applyCenterForce(strikers[player], [80 * ((held % 3) - 1), 80 * (Math.floor(held / 3) - 1)]);
    });
    world.step();
    const [x] = world.positionOf(puck);
    if (Math.abs(x) < 10.5) return;
    score[x > 0 ? 0 : 1]++;
    world.setTransform(puck, [0, 0]);
    world.setVelocity(puck, [6 * Math.sign(x), 4]);
  };
  const rollback = new Rollback(world, { idle: [IDLE, IDLE], step, state: [0, 0], depth: LATEST });
  return { world, puck, strikers, rollback };
}

/**
 * The input of a computer player, which moves behind the puck and pushes it, or guards its goal.
 */
function choose({ world, puck, strikers }, player) {
  const side = 2 * player - 1;
  const [x, y] = world.positionOf(strikers[player]);
  const [px, py] = world.positionOf(puck);
  const behind = [px + 2 * side, py > 0 ? py - 2 : py + 2];
  const to = px * side < 0 ? [6 * side, py / 2] : (x - px) * side > 0.6 ? [px, py] : behind;
  const push = (way) => (Math.abs(way) < 0.2 ? 0 : Math.sign(way));
  return IDLE + push(to[0] - x) + 3 * push(to[1] - y);
}

let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;

const peers = [createPeer(), createPeer()];
const [one, two] = peers.map(({ rollback }) => rollback);
let packets = [];
let unlike = 0;
for (let now = 0; now < STEPS; now++) {
  for (const { to, input } of packets.filter(({ due }) => due <= now)) to.input(...input);
  packets = packets.filter(({ due }) => due > now);
  peers.forEach((peer, player) => {
    const input = [player, now, choose(peer, player)];
    const due = now + 3 + Math.floor((LATEST - 2) * random());
    packets.push({ due, to: player === 0 ? two : one, input });
    peer.rollback.input(...input);
    peer.rollback.advance();
  });
  const known = Math.min(one.confirmed, two.confirmed);
  if (one.hashAt(known) !== two.hashAt(known)) unlike++;
}
for (const { to, input } of packets) to.input(...input);
if (one.hashAt(STEPS) !== two.hashAt(STEPS)) unlike++;

console.log(`score ${one.state.join(" : ")}, ${one.replayed + two.replayed} steps played again`);
console.log(`${unlike} unlike hashes, ${one.hashAt(STEPS)}`);
process.exitCode = unlike === 0 ? 0 : 1;
