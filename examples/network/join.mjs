/**
 * Plays the game of a server by WebSocket, in browsers and in Node: what carries the messages of
 * peer.mjs to thud-serve (serve_websocket.c) and back.
 */
import { readLeave, readWelcome } from "./host.mjs";
import { Peer } from "./peer.mjs";

/** The share of the frames by which a peer is ahead that it waits in each frame, and the largest such share. */
const [CORRECTION, CORRECTION_MAX] = [0.02, 0.2];
/** A peer without a window runs its frames at least so often, milliseconds. */
const PAUSE = 4;

/**
 * Joins a game and plays it to its end. `socket`: a WebSocket that connects; `choose(peer)` returns
 * the own input of the next step; `onFrame(peer)` is called after each. Resolves to the peer, which
 * the caller closes.
 * @throws {Error} where the connection ends before the game, or sends what no server sends.
 */
export function play(thud, socket, choose, onFrame = () => {}) {
  socket.binaryType = "arraybuffer";
  let peer = null;
  let frame = 0; // milliseconds
  let next = 0;
  let timer = 0;

  const send = () => {
    for (let player = 0; player < peer.players; player++) {
      if (!peer.tells(player)) continue;
      const message = peer.write(player);
      const bytes = new Uint8Array(1 + message.length);
      bytes[0] = player;
      bytes.set(message, 1);
      socket.send(bytes);
    }
  };
  const tick = () => {
    const now = performance.now();
    next = Math.max(next, now - 1000);
    while (next <= now) {
      peer.press(choose(peer));
      peer.advance();
      send();
      const wait = Math.min(CORRECTION_MAX, Math.max(-CORRECTION_MAX, CORRECTION * peer.rollback.ahead));
      next += frame * (1 + wait);
      onFrame(peer);
      if (!peer.isDone) continue;
      clearInterval(timer);
      socket.close();
      return;
    }
  };
  const read = (bytes) => {
    if (peer) {
      if (!readLeave(peer, bytes)) peer.read(bytes);
      return;
    }
    const game = readWelcome(bytes);
    if (!game) throw new Error("the server sent something else than a welcome");
    peer = new Peer(thud, game);
    frame = 1000 / game.rate;
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
    socket.onmessage = ({ data }) => guard(() => read(new Uint8Array(data)));
    socket.onerror = () => refuse(new Error(`no server answers at ${socket.url}`));
    socket.onclose = () => {
      clearInterval(timer);
      if (peer?.isDone) resolve(peer);
      else refuse(new Error(peer ? `the connection ended at step ${peer.steps} of ${peer.end}` : "the game is full"));
    };
  });
}
