/**
 * Tests matches without a network: what players tell each other over a line that delays, loses,
 * doubles and reorders packets, and what nobody may tell; invitations; and the game Car sumo.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, importTypeScript } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const { Peers } = await importTypeScript("src/worker/match-peers.ts");
const { descriptionOf, packInvitation, readDescription, unpackInvitation } = await importTypeScript(
  "src/panels/match/invitation.ts",
);
const { pack } = await importTypeScript("src/page/url.ts");
const engine = await thud.load();
const DEPTH = 90;

function randomBy(seed) {
  let state = seed;
  return (below) => {
    state = (state * 16807) % 2147483647;
    return Math.floor((below * state) / 2147483647);
  };
}

/** The browser of one player. `sent` has what it has sent; `damage` may change its world. */
async function openPlayer(players, own, send, now) {
  const built = await buildScene(engine, "sumo", { size: players });
  const { scene } = built;
  scene.match.begin(own);
  const player = { ...built, damage: null };
  const rollback = new thud.Rollback(scene.world, {
    idle: Array.from({ length: players }, () => 0),
    depth: DEPTH,
    state: scene.state,
    step(inputs, state) {
      scene.state = state;
      scene.match.step(inputs);
      player.damage?.(rollback.steps);
    },
  });
  scene.state = rollback.state;
  const { inputs } = scene.match;
  player.rollback = rollback;
  player.peers = new Peers({ rollback, players, own, inputs, depth: DEPTH, send, now });
  return player;
}

/** Steps that a packet is on its way: at least so many, and fewer than so many more. */
const [DELAY, JITTER] = [8, 6];

/**
 * A match over a line by which every tenth packet is lost, and others come twice or in another order.
 * `play(n)` makes n rounds: what has arrived is heard, and each player makes a step if it can.
 */
async function openMatch(players) {
  const random = randomBy(7);
  let round = 0;
  const packets = [];
  const send = (from) => (to, bytes, sure) => {
    const later = () => round + DELAY + (sure ? JITTER : random(JITTER));
    if (!sure && random(10) === 0) return;
    packets.push({ from, to, bytes, at: later() });
    if (!sure && random(10) === 0) packets.push({ from, to, bytes, at: later() });
  };
  const all = [];
  for (let own = 0; own < players; own++)
    all.push(await openPlayer(players, own, send(own), () => (round * 1000) / 60));
  const present = new Set(all.keys());
  return {
    all,
    present,
    play(rounds, inputOf = () => random(8)) {
      for (let i = 0; i < rounds; i++, round++) {
        const due = packets.filter(({ at }) => at <= round);
        for (const packet of due) packets.splice(packets.indexOf(packet), 1);
        for (const { from, to, bytes } of due) if (present.has(to)) all[to].peers.hear(from, bytes);
        for (const own of present) {
          const { peers, rollback } = all[own];
          peers.give(round % 9 === 0 ? inputOf(own) : 2 * (own % 2) || 1);
          rollback.advance();
          peers.tell();
        }
      }
    },
    close: () => all.forEach(({ close }) => close()),
  };
}

test("players_over_a_bad_line_stay_the_same_and_know_it", async () => {
  for (const players of [2, 4]) {
    const match = await openMatch(players);
    match.play(500);
    const [first] = match.all;
    for (const { peers, rollback } of match.all) {
      assert.equal(peers.refused, 0);
      assert.equal(peers.differs, -1);
      assert.ok(peers.equal > 10, `${peers.equal} equal hashes`);
      assert.ok(rollback.steps > 400, `${rollback.steps} steps`);
      assert.ok(rollback.replayed > 100, "nothing was late");
      assert.ok(peers.roundTrip > 50 && peers.roundTrip < 500, `${peers.roundTrip} ms`);
    }
    const step = Math.min(...match.all.map(({ rollback }) => rollback.confirmed));
    const hashes = match.all.map(({ rollback }) => rollback.hashAt(step));
    assert.deepEqual(hashes, Array(players).fill(first.rollback.hashAt(step)));
    match.close();
  }
});

test("player_who_leaves_is_absent_for_all_from_the_same_step_on", async () => {
  const match = await openMatch(3);
  match.play(200);
  match.present.delete(2);
  assert.equal(match.all[0].peers.lose(2), false);
  match.play(200);
  const both = [0, 1].map((own) => match.all[own]);
  for (const { peers, rollback } of both) {
    assert.deepEqual([...peers.gone], [2]);
    assert.equal(peers.differs, -1);
    assert.ok(rollback.steps > 350, `${rollback.steps} steps: it waits for who is gone`);
  }
  const step = Math.min(...both.map(({ rollback }) => rollback.confirmed));
  assert.ok(step > 300);
  assert.equal(both[0].rollback.hashAt(step), both[1].rollback.hashAt(step));
  assert.equal(match.all[0].peers.lose(1), true, "nobody is left");
  match.close();
});

test("world_that_is_changed_secretly_is_found_and_its_body_named", async () => {
  const match = await openMatch(2);
  const [{ scene }, cheat] = match.all;
  const body = scene.hidden[0];
  cheat.damage = (step) => {
    const { world } = cheat.scene;
    if (step >= 200) world.setVelocity(world.bodyAt(body), [0, 1]);
  };
  match.play(500);
  for (const { peers } of match.all) {
    assert.ok(peers.differs >= 200, `${peers.differs}`);
    assert.equal(peers.difference.bodySlot, body);
    assert.equal(peers.difference.player, -1, "the inputs were told alike");
  }
  match.close();
});

test("what_no_player_can_say_is_refused_and_changes_nothing", async () => {
  const match = await openMatch(2);
  const told = [];
  const [{ peers, rollback, scene }, other] = match.all;
  match.play(60, () => 1);
  // A packet that the other player has sent, to be damaged.
  const { peers: liar, close } = await openPlayer(2, 1, (_, bytes) => told.push(bytes), () => 0);
  liar.give(1);
  liar.tell();
  const packet = told.at(-1);
  const state = () => [scene.world.hash(), rollback.steps, rollback.confirmed, rollback.leadOver(1)];
  const before = state();
  const refused = (bytes, what) => {
    const count = peers.refused;
    peers.hear(1, Uint8Array.from(bytes));
    assert.equal(peers.refused, count + 1, what);
    assert.deepEqual(state(), before, what);
  };
  const changed = (at, ...values) => {
    const bytes = Uint8Array.from(packet);
    bytes.set(values, at);
    return bytes;
  };
  const head = 30 + 8;
  peers.hear(1, packet);
  assert.deepEqual([peers.refused, state()], [0, before], "nothing new, and right");
  refused(changed(0, 9), "no such kind");
  refused(changed(1, 3), "another number of players");
  refused(changed(6, 0x7f, 0xff), "a lead that cannot be");
  refused(changed(30, 0x7f), "inputs acknowledged that nobody gave");
  refused(changed(head, 0), "an input of mine");
  refused(changed(head, 2), "a player that there is not");
  refused(changed(head + 5, 200), "more inputs than there are bytes");
  const next = rollback.steps - rollback.leadOver(1);
  refused(changed(head + 1, 0, 0, next >> 8, next & 255, 1, 8), "an input that there is not");
  refused(changed(head + 6, 5), "another input than was told before");
  for (let length = 1; length < packet.length; length++)
    if (length !== head) refused(packet.subarray(0, length), `${length} bytes`);
  refused([...packet, 1], "more bytes");
  refused([2, 1, 2, 3], "no report");
  refused([3, 1, 0, 0, 0, 1], "only who invited says who left");
  peers.hear(7, Uint8Array.from(packet));
  peers.hear(1, new Uint8Array());
  assert.deepEqual(state(), before, "nobody, and nothing");
  // Random bytes of all kinds.
  const random = randomBy(3);
  for (let i = 0; i < 2000; i++) {
    const bytes = Uint8Array.from(packet);
    for (let k = 0; k <= random(4); k++) bytes[random(bytes.length)] = random(256);
    peers.hear(1, bytes);
  }
  match.play(200);
  assert.ok(other.rollback.steps > 200, "the match goes on");
  close();
  match.close();
});

// ---- invitations ----

const SDP = [
  "v=0",
  "m=application 58297 UDP/DTLS/SCTP webrtc-datachannel",
  "a=candidate:1 1 udp 2113937151 192.0.2.2 58297 typ host generation 0",
  "a=candidate:2 1 UDP 2113942271 fd00::2 55251 typ host",
  "a=candidate:3 1 udp 1677729535 198.51.100.7 4000 typ srflx raddr 192.0.2.2 rport 58297",
  "a=candidate:4 1 udp 2113937151 0b4f2f46-3a4c-4e0a-9f4e-2b8f4a7a1c11.local 5000 typ host",
  "a=candidate:5 1 TCP 2105458943 192.0.2.2 9 typ host tcptype active",
  "a=ice-ufrag:CqPI",
  "a=ice-pwd:98aE1X5ofDYQ1yc4vhyD4x1y",
  `a=fingerprint:sha-256 ${Array(32).fill("AB").join(":")}`,
  "a=setup:actpass",
  "",
].join("\r\n");

test("invitation_holds_what_a_browser_is_reached_by_and_is_short", async () => {
  const own = readDescription({ type: "offer", sdp: SDP });
  const text = await packInvitation(own);
  assert.ok(text.length < 300, `${text.length} characters`);
  for (const link of [text, ` ${text}\n`, `https://example.org/?scene=sumo#invite=${text}`])
    assert.deepEqual(await unpackInvitation(link), own);
  const { type, sdp } = descriptionOf(own);
  assert.equal(type, "offer");
  assert.deepEqual(readDescription({ type, sdp }), own);
  assert.equal(own.candidates.length, 4, "without TCP");
});

test("invitation_that_is_damaged_or_says_more_than_it_may_is_refused", async () => {
  const right = ["o", "CqPI", "98aE1X5ofDYQ1yc4vhyD4x1y", "ab".repeat(32), "actpass", "", "192.0.2.2,5000,0"];
  const read = async (fields) => unpackInvitation(await pack(fields.join(" ")));
  assert.ok(await read(right));
  const wrong = (at, value) => right.map((one, i) => (i === at ? value : one));
  const CASES = [
    wrong(0, "x"),
    wrong(1, "ab\r\na=x"),
    wrong(1, "abc"),
    wrong(2, "short"),
    wrong(3, "zz".repeat(32)),
    wrong(4, "active"),
    wrong(5, "CqPI"),
    wrong(6, "example.org,5000,0"),
    wrong(6, "192.0.2.2,0,0"),
    wrong(6, "192.0.2.2,70000,0"),
    wrong(6, "192.0.2.2\r\na=x,5000,0"),
    wrong(6, ""),
    [...right, ...Array(12).fill(right[6])],
    right.slice(0, 5),
    [],
  ];
  for (const fields of CASES) assert.equal(await read(fields), null, JSON.stringify(fields));
  const text = await pack(right.join(" "));
  for (const damaged of ["", "?", text.slice(0, -4), "AAAA", `${text}!`])
    assert.equal(await unpackInvitation(damaged), null, damaged);
});

// ---- the game alone ----

async function openGame(size = 2) {
  const built = await buildScene(engine, "sumo", { size });
  const { scene } = built;
  let step = 0;
  const run = (count, held = {}) => {
    for (let i = 0; i < count; i++) {
      scene.update({ step: step++, held });
      scene.world.step();
      scene.stepped();
    }
  };
  return { ...built, run };
}

test("computer_pushes_a_car_that_stands_still_off_the_platform", async () => {
  for (const size of [2, 3, 4]) {
    const { scene, run, close } = await openGame(size);
    for (let step = 0; step < 60 * 300 && scene.state.phase !== "won"; step++) run(1);
    assert.notEqual(scene.state.winner, 0, `${size} cars`);
    assert.match(scene.paint().message, /^Computer( [23])? wins the game!$/);
    assert.equal(scene.paint().figures.length, size);
    close();
  }
});

test("second_player_takes_the_second_car_and_the_platform_gets_shorter", async () => {
  const { scene, run, close } = await openGame();
  const place = () => scene.world.positionOf(scene.world.bodyAt(scene.hidden[3]))[0];
  run(1, { up2: true });
  run(130);
  const before = place();
  run(20, { left2: true });
  assert.ok(place() < before, "the second car drives left");
  run(20, { right2: true });
  const stands = place();
  run(60 * 13);
  assert.ok(Math.abs(place() - stands) < 2, "the computer no longer drives it");
  assert.ok(scene.state.fallen > 0, "no piece has fallen");
  run(1, { restart: true });
  assert.equal(scene.state.fallen, 0);
  assert.equal(scene.state.friend, true);
  assert.equal(scene.paint().figures[1].label, "Blue");
  close();
});
