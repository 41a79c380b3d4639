/**
 * What the program that players join tells them, besides the messages of peer.mjs: that the game
 * begins, and that a player has left. The layout of the bytes stands in host.c.
 */
import { isSealed } from "./peer.mjs";

const WELCOME = 0x31574e54; // "TNW1"
const LEAVE = 0x314c4e54; // "TNL1"
const [WELCOME_BYTES, LEAVE_HEAD, SUM] = [20, 10, 4];

/** The own number, the number of players, steps a second, steps and depth; null: no welcome. */
export function readWelcome(bytes) {
  if (bytes.length !== WELCOME_BYTES || !isSealed(bytes, WELCOME, WELCOME_BYTES)) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const [me, players] = [bytes[4], bytes[5]];
  const [rate, end, depth] = [view.getUint16(6, true), view.getUint32(8, true), view.getUint32(12, true)];
  return { me, players, rate, end, depth };
}

/** Tells a peer who has left; false: the bytes say no such thing. */
export function readLeave(peer, bytes) {
  const count = bytes[5];
  if (!isSealed(bytes, LEAVE, LEAVE_HEAD + SUM) || bytes.length !== LEAVE_HEAD + count + SUM) return false;
  const [player, step] = [bytes[4], new DataView(bytes.buffer, bytes.byteOffset).getUint32(6, true)];
  if (player >= peer.players || !peer.tells(player)) return false;
  const { heard } = peer.others[player];
  if (step < heard || step - heard > count) return false;
  peer.part(player, step, bytes.slice(LEAVE_HEAD, LEAVE_HEAD + count));
  return true;
}
