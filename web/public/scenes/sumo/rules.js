// Rounds, who is out, and the platform that gets shorter.

export const READY = 120; // steps before a round
const AFTER = 130; // steps from the end of a round to the next
const WON = 260; // steps from the end of a game to the next
const FIRST_DROP = 60 * 8; // steps of a round before the first pieces fall
const NEXT_DROP = 60 * 4;
const LONGEST = 60 * 40; // steps of a round: then the car nearest to the middle wins it
export const GOAL = 3; // rounds that win the game
const OUT = -1.6; // a car that is lower is out
const GONE = -8; // and is taken away when it is as low as that

export function newGame(size) {
  return {
    phase: "ready", // then "fight" and "over" in turn, and "won"
    waited: 0, // steps in this phase
    steps: 0,
    fallen: 0, // pairs of pieces
    began: 0, // of these, in this round before it began
    winner: -1, // of the last round
    alone: true, // nobody plays over a network
    friend: false, // a second player at this keyboard
    players: Array.from({ length: size }, () => ({ score: 0, here: true, out: false, gone: false, wanted: 0, rest: 0 })),
  };
}

/** After each step. */
export function judge(world, arena, cars, state) {
  state.steps++;
  state.waited++;
  takeAway(world, cars, state);
  if (state.phase === "ready" && state.waited >= READY) enter(state, "fight");
  else if (state.phase === "fight") fight(world, arena, cars, state);
  else if (state.phase === "over" && state.waited >= AFTER) nextRound(world, arena, cars, state);
  else if (state.phase === "won" && state.waited >= WON) {
    for (const player of state.players) player.score = 0;
    nextRound(world, arena, cars, state);
  }
}

function enter(state, phase) {
  state.phase = phase;
  state.waited = 0;
}

function takeAway(world, cars, state) {
  cars.forEach((car, i) => {
    const player = state.players[i];
    if (player.gone) return;
    const [, y] = world.positionOf(car.hull);
    if (y < OUT && state.phase === "fight") player.out = true;
    if (y >= GONE) return;
    player.gone = true;
    car.remove(world);
  });
}

function fight(world, arena, cars, state) {
  const drops = state.waited - FIRST_DROP - NEXT_DROP * (state.fallen - state.began);
  if (drops === 0 && state.fallen < arena.pieces.length) arena.drop(world, state.fallen++);
  const inside = cars.map((_, i) => i).filter((i) => !state.players[i].out);
  if (inside.length > 1 && state.waited < LONGEST) return;
  const distance = (i) => Math.abs(world.positionOf(cars[i].hull)[0]);
  state.winner = inside.reduce((best, i) => (best < 0 || distance(i) < distance(best) ? i : best), -1);
  const score = state.winner < 0 ? 0 : ++state.players[state.winner].score;
  enter(state, score === GOAL ? "won" : "over");
}

/** Over a network: who has left has no input. The car goes; who comes plays from the next round on. */
export function attend(world, arena, cars, state, inputs) {
  let changed = false;
  inputs.forEach((input, i) => {
    const player = state.players[i];
    if (player.here === (input !== null)) return;
    changed = true;
    player.here = input !== null;
    player.out = player.gone = true;
    cars[i].remove(world);
  });
  const isAlone = present(state) < 2;
  if (changed && (isAlone || state.phase === "ready")) nextRound(world, arena, cars, state);
  if (isAlone) state.waited = 0;
}

export const present = ({ players }) => players.filter(({ here }) => here).length;

/** The platform is as long as those who are there need. */
function nextRound(world, arena, cars, state) {
  arena.mend(world);
  const count = present(state);
  state.fallen = state.began = cars.length - Math.max(2, count);
  for (let pair = 0; pair < state.began; pair++) arena.drop(world, pair);
  let place = 0;
  cars.forEach((car, i) => {
    const player = state.players[i];
    Object.assign(player, { out: !player.here, gone: !player.here, rest: 0 });
    if (player.here) car.place(world, arena.left(state.began), place++, count);
  });
  enter(state, "ready");
}
