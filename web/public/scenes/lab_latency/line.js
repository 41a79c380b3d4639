// The line between the peers. A packet is sent after each step; it is delayed, by more or less
// where the line jitters, and may be lost. Each has all inputs so far, so that what is lost comes
// with the next.

import { chance } from "./players.js";
import { TIME_STEP } from "./rink.js";

/** Steps that are looked back for a packet that has arrived: longer than any delay. */
export const LONGEST = 110;

/** Whether the packet that was sent to a peer after this many steps has arrived after `now` steps. */
function arrived(sent, now, peer, { delay, jitter, loss, seed }) {
  if (chance(sent, 31 * seed + 2 * peer) * 50 + 50 < loss) return false;
  const late = delay + jitter * 0.5 * (1 + chance(sent, 31 * seed + 2 * peer + 1));
  return sent + Math.round(late / 1000 / TIME_STEP) <= now;
}

/** The newest packet that a peer has after `now` steps, not older than `before`. */
export function newest(now, peer, before, settings) {
  const oldest = Math.max(before, now - LONGEST);
  for (let sent = now; sent > oldest; sent--) if (arrived(sent, now, peer, settings)) return sent;
  return oldest;
}
