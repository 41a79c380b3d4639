// The mean error of the puck, lengths, over a minute of the game by seed 0 without jitter and loss,
// by delay in ms: tests/web/worker/latency.test.mjs measures it anew.

export const MEASURED = {
  delays: [0, 50, 100, 200, 400],
  last: [0, 0, 0, 0, 0],
  reckoned: [0, 0, 0, 0, 0],
  swept: [0, 0, 0, 0, 0],
  rollback: [0, 0, 0, 0, 0],
};
