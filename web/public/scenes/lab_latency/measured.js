// The mean error of the puck, lengths, over a minute of the game by seed 0 without jitter and loss,
// by delay in ms: tests/web/worker/latency.test.mjs measures it anew.

export const MEASURED = {
  delays: [0, 50, 100, 200, 400],
  last: [0, 0.4215, 0.8056, 1.4867, 2.618],
  reckoned: [0, 0.0803, 0.2479, 0.743, 2.1769],
  swept: [0, 0.0632, 0.1843, 0.5, 1.3184],
  rollback: [0, 0.0153, 0.0455, 0.13, 0.3853],
};
