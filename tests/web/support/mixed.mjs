/**
 * Plays the odd players of thud-mixed in WebAssembly (tests/network/thud_mixed.c, where the bytes that
 * they exchange are described).
 */
import { spawn } from "node:child_process";
import { pathToFileURL } from "node:url";

const [DEPTH, END] = [60, 0xffffffff];

/** Reads a stream's bytes in pieces of a given length. */
function readerOf(stream) {
  const iterator = stream[Symbol.asyncIterator]();
  let left = Buffer.alloc(0);
  return async (count) => {
    while (left.length < count) {
      const { value, done } = await iterator.next();
      if (done) throw new Error("thud-mixed has ended too early");
      left = Buffer.concat([left, value]);
    }
    const piece = left.subarray(0, count);
    left = left.subarray(count);
    return piece;
  };
}

/**
 * Plays a game of so many steps; `examples`: a folder of examples/network beside which the package is
 * found. Returns how both sides ended: hashes, reports, and what thud-mixed counted.
 */
export async function playMixed({ program, examples, thud, players, steps, seed }) {
  const from = (name) => import(pathToFileURL(`${examples}/${name}`));
  const [{ Peer }, { carsInput }] = [await from("peer.mjs"), await from("cars.mjs")];
  const child = spawn(program, [players, steps, seed].map(String), { stdio: ["pipe", "pipe", "inherit"] });
  const ended = new Promise((resolve) => child.on("close", resolve));
  child.stdin.on("error", () => {}); // its end is told by the output's
  const read = readerOf(child.stdout);
  const peers = [];
  for (let me = 1; me < players; me += 2) peers[me] = new Peer(thud, { me, players, depth: DEPTH, end: steps, mesh: true });
  const own = peers.filter(Boolean);

  const playFrame = (arrived) => {
    const out = [];
    for (const peer of own) {
      for (const [to, bytes] of arrived) if (to === peer.me) peer.net.hear(bytes[4], bytes);
      peer.net.give(carsInput(seed, peer.me, peer.steps));
      for (let to = 0; to < players; to++) {
        if (!peer.net.tells(to)) continue;
        const bytes = peer.net.write(to);
        out.push(Uint8Array.of(peer.me, to, bytes.length & 255, bytes.length >> 8), bytes);
      }
      peer.advance();
    }
    const head = Buffer.alloc(5);
    head.writeUInt8(own.every((peer) => peer.net.isDone) ? 1 : 0, 0);
    head.writeUInt32LE(out.length / 2, 1);
    child.stdin.write(Buffer.concat([head, ...out]));
  };

  const number = async () => (await read(4)).readUInt32LE();
  for (;;) {
    const count = await number();
    if (count === END) break;
    const arrived = [];
    for (let i = 0; i < count; i++) {
      const head = await read(3);
      arrived.push([head[0], new Uint8Array(await read(head.readUInt16LE(1)))]);
    }
    playFrame(arrived);
  }
  const hash = (await read(8)).readBigUInt64LE().toString(16).padStart(16, "0");
  const report = new Uint8Array(await read(await number()));
  const counts = JSON.parse((await read(await number())).toString());
  const native = new Uint8Array(await read(await number()));
  const given = own[0].rollback.snapshot();
  const length = Buffer.alloc(4);
  length.writeUInt32LE(given.length);
  child.stdin.write(Buffer.concat([length, given]));
  const returned = new Uint8Array(await read(await number()));
  child.stdin.end();
  const joins = new Peer(thud, { me: 0, players, depth: DEPTH });
  joins.rollback.restore(native);
  const games = { native, kept: joins.rollback.snapshot(), given, returned, hash: joins.hash };
  joins.close();
  const ends = own.map((peer) => ({
    hash: peer.hash,
    report: peer.rollback.report(steps),
    difference: peer.rollback.compare(report),
    differs: peer.net.differs,
    replayed: peer.rollback.replayed,
  }));
  own.forEach((peer) => peer.close());
  return { code: await ended, hash, report, counts, ends, games };
}
