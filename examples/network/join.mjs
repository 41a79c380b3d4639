/**
 * Plays the game of a server by WebSocket, in browsers and in Node: what carries the messages of
 * peer.mjs to thud-serve (serve_websocket.c) and back.
 */
import { WelcomeReader, writeHello } from "thud";
import { Peer } from "./peer.mjs";

/** The share of the frames by which a peer is ahead that it waits in each frame, and the largest such share. */
const [CORRECTION, CORRECTION_MAX] = [0.02, 0.2];
/** A peer without a window runs its frames at least so often, milliseconds. */
const PAUSE = 4;

/**
 * Joins a game, which may have begun, and plays it to its end. `socket`: a WebSocket that connects;
 * `choose(peer)` returns the own input of the next step; `onFrame(peer)` is called after each, and ends
 * the connection by returning false. `token`: a number of 64 bits by which the server knows who comes
 * back; `watches`: not to play. Resolves to the peer, which the caller closes.
 * @throws {Error} where the connection ends before the game, or sends what no server sends.
 */
export function play(thud, socket, choose, { onFrame = () => {}, token = 0n, watches = false } = {}) {
  socket.binaryType = "arraybuffer";
  const reader = new WelcomeReader();
  let peer = null;
  let frame = 0; // milliseconds
  let next = 0;
  let timer = 0;
  let leaves = false;

  const tick = () => {
    const now = performance.now();
    next = Math.max(next, now - 1000);
    while (next <= now) {
      peer.net.give(choose(peer));
      peer.advance();
      socket.send(peer.net.write(0));
      const wait = Math.min(CORRECTION_MAX, Math.max(-CORRECTION_MAX, CORRECTION * peer.rollback.ahead));
      next += frame * (1 + wait);
      leaves = onFrame(peer) === false;
      if (!leaves && !peer.net.isDone) continue;
      clearInterval(timer);
      socket.close();
      return;
    }
  };
  const read = (bytes) => {
    if (peer) {
      peer.net.hear(0, bytes);
      return;
    }
    if (!reader.hear(bytes)) throw new Error("the server sent something else than a game");
    if (!reader.isWhole) return;
    peer = new Peer(thud, { reader });
    frame = 1000 / reader.welcome.rate;
    next = performance.now();
    timer = setInterval(() => guard(tick), PAUSE);
  };

  let reject;
  const guard = (work) => {
    try {
      work();
    } catch (error) {
      clearInterval(timer);
      reject(error);
      socket.close();
    }
  };
  return new Promise((resolve, refuse) => {
    reject = refuse;
    socket.onopen = () => socket.send(writeHello({ watches, token }));
    socket.onmessage = ({ data }) => guard(() => read(new Uint8Array(data)));
    socket.onerror = () => refuse(new Error(`no server answers at ${socket.url}`));
    socket.onclose = () => {
      clearInterval(timer);
      if (leaves || peer?.net.isDone) resolve(peer);
      else refuse(new Error(peer ? `the connection ended at step ${peer.steps} of ${peer.end}` : "the game is full"));
    };
  });
}
