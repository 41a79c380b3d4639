/**
 * Tests matches without a network: what players tell each other over a line that delays, loses,
 * doubles and reorders packets, and what nobody may tell; invitations; and the game Car sumo.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { buildScene, importTypeScript } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const { RollbackPeers, WelcomeReader } = thud;
const { descriptionOf, packInvitation, readDescription, unpackInvitation } = await importTypeScript(
  "src/panels/match/invitation.ts",
);
const { readMigration, readPacket, writeMigration, writePacket } = await import("../../../web/package/dist/net/messages.js");
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

/**
 * The browser of one player; `reader`: it joins this game, of the player `host`. `damage` may change its
 * world; `bare` is its world before anything was built in it.
 */
async function openPlayer(players, own, send, now, reader = null, host = 0) {
  let bare;
  const made = (world) => {
    if (reader) world.restore(reader.more);
    bare = world.snapshot();
  };
  const built = await buildScene({ createWorld: (...all) => {
    const world = engine.createWorld(...all);
    made(world);
    return world;
  } }, "sumo", { size: players });
  const { scene } = built;
  scene.match.begin(own < players ? own : null);
  const { inputs } = scene.match;
  const player = { ...built, damage: null, bare };
  const rollback = new thud.Rollback(scene.world, {
    idle: Array.from({ length: players }, () => inputs),
    depth: DEPTH,
    state: scene.state,
    step(held, state) {
      scene.state = state;
      scene.match.step(held.map((input) => (input === inputs ? null : input)));
      player.damage?.(rollback.steps);
    },
  });
  scene.state = rollback.state;
  player.rollback = rollback;
  const about = { rollback, inputs, delay: 2, send, now };
  player.peers = reader
    ? RollbackPeers.join(reader, { ...about, host })
    : new RollbackPeers({ ...about, players, own, depth: DEPTH });
  return player;
}

/** THUD_MIGRATIONS=100 plays so many matches whose hosts leave, each with another line. */
const MIGRATIONS = Number(process.env.THUD_MIGRATIONS ?? 4);

/** Steps that a packet is on its way: at least so many, and fewer than so many more. */
const [DELAY, JITTER] = [8, 6];

/**
 * A match over a line by which every tenth packet is lost, and others come twice or in another order.
 * `play(n)` makes n rounds: what has arrived is heard, and each player makes a step if it can.
 */
async function openMatch(players, here = players, seed = 7) {
  const random = randomBy(seed);
  let round = 0;
  const packets = [];
  const send = (from) => (to, bytes, sure) => {
    const later = () => round + DELAY + (sure ? JITTER : random(JITTER));
    if (!sure && random(10) === 0) return;
    packets.push({ from, to, bytes, at: later() });
    if (!sure && random(10) === 0) packets.push({ from, to, bytes, at: later() });
  };
  const now = () => (round * 1000) / 60;
  const all = [];
  for (let own = 0; own < here; own++) all.push(await openPlayer(players, own, send(own), now));
  let host = 0;
  const [first, ...others] = all;
  others.forEach(({ peers }, i) => {
    first.peers.start(i + 1);
    peers.connect(0);
  });
  for (let player = here; player < players; player++) first.peers.miss(player);
  const vanish = (own) => {
    present.delete(own);
    packets.splice(0, Infinity, ...packets.filter(({ from, to }) => from !== own && to !== own));
  };
  const present = new Set(all.keys());
  const match = {
    all,
    packets,
    present,
    /** Players who are told the game and tell what they have, and make no steps. */
    still: new Set(),
    play(rounds, inputOf = () => random(8)) {
      for (let i = 0; i < rounds; i++, round++) {
        const due = packets.filter(({ at }) => at <= round);
        for (const packet of due) packets.splice(packets.indexOf(packet), 1);
        for (const { from, to, bytes } of due) if (present.has(to)) all[to].peers.hear(from, bytes);
        for (const own of present) {
          const { peers } = all[own];
          if (match.still.has(own)) {
            peers.tell();
            continue;
          }
          peers.give(round % 9 === 0 ? inputOf(own) : 2 * (own % 2) || 1);
          peers.advance();
          while (peers.isBehind && peers.advance());
          peers.tell();
        }
      }
    },
    /** A player is gone: its browser has broken down. */
    drop(own) {
      vanish(own);
      return all[host].peers.lose(own);
    },
    /** The host is gone, and another player takes its place. Returns whom it refuses. */
    migrate(next) {
      vanish(host);
      host = next;
      for (const own of present) if (own !== next) all[own].peers.follow(next);
      const { peers } = all[next];
      while (peers.followers.size < present.size - 1) match.play(1);
      return peers.takeOver();
    },
    /** A player comes in the midst of the match; its scene takes so many rounds to be built. */
    async join(own, building = 0) {
      let messages;
      const { peers, bare } = all[host];
      while (!(messages = peers.invite(own, { more: bare }))) match.play(1);
      const reader = new WelcomeReader();
      for (const message of messages) assert.ok(reader.hear(message));
      match.play(building);
      all[own]?.close();
      all[own] = await openPlayer(players, own, send(own), now, reader, host);
      present.add(own);
    },
    /** The step that all have confirmed, and the hashes before it. */
    compare() {
      const ones = [...present].map((own) => all[own].rollback);
      const step = Math.min(...ones.map(({ confirmed }) => confirmed));
      const hashes = ones.map((rollback) => rollback.hashAt(step));
      assert.deepEqual(hashes, Array(ones.length).fill(hashes[0]), `step ${step}`);
      for (const own of present) assert.deepEqual([all[own].peers.differs, all[own].peers.refused], [-1, 0], `${own}`);
      return step;
    },
    close: () => all.forEach(({ close }) => close()),
  };
  return match;
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
  assert.equal(match.drop(2), false);
  match.play(200);
  for (const own of [0, 1]) {
    const { rollback, peers } = match.all[own];
    assert.equal(peers.isAbsent(2), true);
    assert.ok(rollback.steps > 350, `${rollback.steps} steps: it waits for who is gone`);
  }
  assert.ok(match.compare() > 300);
  assert.equal(match.drop(1), true, "nobody is left");
  match.close();
});

test("players_join_late_leave_and_come_back_over_a_bad_line", async () => {
  const match = await openMatch(4, 2);
  match.play(150);
  await match.join(2);
  match.play(120);
  assert.equal(match.all[2].peers.isAbsent(2), false, "the third plays");
  match.drop(1);
  match.play(40);
  await match.join(3);
  await match.join(1);
  match.play(200);
  for (const { peers, rollback } of match.all) {
    assert.deepEqual([0, 1, 2, 3].map((player) => peers.isAbsent(player)), [false, false, false, false]);
    assert.ok(rollback.steps > 400, `${rollback.steps} steps`);
  }
  assert.ok(match.compare() > 400);
  assert.ok(match.all[0].scene.state.players.every(({ here }) => here));
  // Who has gone for long comes back to a match that went on.
  match.drop(3);
  match.play(400);
  await match.join(3);
  match.play(200);
  assert.ok(match.compare() > 900);
  assert.equal(match.all[3].peers.isAbsent(3), false);
  match.close();
});

test("who_joins_catches_up_with_what_was_played_while_its_scene_was_built", async () => {
  const match = await openMatch(3, 2);
  match.play(60);
  match.still.add(2);
  await match.join(2, 100);
  match.play(50);
  match.still.delete(2);
  match.play(60);
  const [host, , joined] = match.all;
  const behind = host.rollback.steps - joined.rollback.steps;
  assert.ok(behind < 20, `${behind} steps behind`);
  assert.equal(joined.peers.isAbsent(2), false, "it plays");
  assert.ok(host.rollback.steps > 260, `${host.rollback.steps} steps: it is waited for`);
  assert.ok(match.compare() > 230);
  match.close();
});

test("who_only_watches_has_the_same_game_and_nobody_waits_for_it", async () => {
  const match = await openMatch(2);
  match.play(100);
  await match.join(2);
  match.play(200);
  assert.ok(match.all[0].rollback.steps > 250);
  assert.ok(match.compare() > 200);
  match.present.delete(2);
  match.play(200);
  assert.ok(match.all[0].rollback.steps > 450, "it is waited for");
  match.close();
});

test("match_goes_on_without_its_host_which_comes_back_as_a_guest", async () => {
  for (let seed = 1; seed <= MIGRATIONS; seed++) {
    const match = await openMatch(4, 4, seed);
    const absent = (own) => [0, 1, 2, 3].filter((player) => match.all[own].peers.isAbsent(player));
    match.play(60 + 7 * seed);
    const before = match.all[1].rollback.steps;
    assert.deepEqual(match.migrate(1), []);
    match.play(120);
    assert.ok(match.compare() > before + 60, `${before} steps, and then ${match.compare()}`);
    for (const own of [1, 2, 3]) assert.deepEqual(absent(own), [0]);
    await match.join(0);
    match.play(120);
    match.compare();
    for (const own of [0, 1, 2, 3]) assert.deepEqual(absent(own), []);
    // The next host has given up its place before, and come back.
    const then = match.all[2].rollback.steps;
    match.drop(3);
    match.play(seed);
    assert.deepEqual(match.migrate(0), []);
    match.play(120);
    assert.ok(match.compare() > then + 60);
    for (const own of [0, 2]) assert.deepEqual(absent(own), [1, 3]);
    match.close();
  }
});

test("last_player_goes_on_alone_and_the_host_that_was_lost_joins_it", async () => {
  const match = await openMatch(2);
  match.play(100);
  assert.deepEqual(match.migrate(1), []);
  match.play(200);
  const [, { rollback, peers }] = match.all;
  assert.ok(rollback.steps > 290, `${rollback.steps} steps: it waits for who is gone`);
  assert.equal(rollback.confirmed, rollback.steps);
  await match.join(0);
  match.play(150);
  assert.ok(match.compare() > 380);
  assert.equal(peers.isAbsent(0), false);
  assert.equal(match.drop(0), true, "nobody is left");
  match.close();
});

test("who_has_joined_late_takes_the_place_of_the_host_for_players_and_for_who_watches", async () => {
  for (const pause of [0, 5, 40]) {
    const match = await openMatch(4, 2);
    match.play(100);
    match.drop(1);
    match.play(30);
    await match.join(2);
    match.play(80);
    await match.join(3);
    await match.join(4);
    match.play(pause);
    // The fourth may be about to enter.
    assert.deepEqual(match.migrate(2), []);
    match.play(150);
    assert.ok(match.compare() > 250);
    await match.join(1);
    match.play(150);
    assert.ok(match.compare() > 400);
    for (const own of [1, 2, 3, 4])
      assert.deepEqual([0, 1, 2, 3].map((player) => match.all[own].peers.isAbsent(player)), [true, false, false, false]);
    match.close();
  }
});

test("what_a_new_host_is_told_wrongly_is_refused_and_who_tells_it_is_left_out", async () => {
  const openGap = async () => {
    const match = await openMatch(3);
    match.play(100);
    match.present.delete(0);
    match.all[2].peers.follow(1);
    const { bytes } = match.packets.at(-1);
    const { peers, rollback } = match.all[1];
    return { match, peers, bytes, right: readMigration(bytes, 3, 8), steps: rollback.steps };
  };
  const { match, peers, bytes, right, steps } = await openGap();
  const isHeard = (message) => {
    peers.hear(2, message);
    return peers.followers.has(2);
  };
  for (let length = 0; length < bytes.length; length++) assert.equal(isHeard(bytes.subarray(0, length)), false);
  const random = randomBy(3);
  for (let i = 0; i < 500; i++) {
    const damaged = Uint8Array.from(bytes);
    damaged[random(damaged.length)] ^= 1 << random(8);
    assert.equal(isHeard(damaged), false);
  }
  assert.equal(isHeard(writeMigration({ ...right, from: 0 })), false, "of another");
  assert.throws(() => match.all[0].peers.takeOver(), /takes the place/);
  assert.throws(() => peers.follow(1), /another player/);
  match.close();
  const event = { enters: false, player: 0, step: steps + 5 };
  const wrongRun = (player, first, ...inputs) => ({
    runs: right.runs.map((run, i) => (i === player ? { ...run, first, inputs: Uint8Array.from(inputs) } : run)),
  });
  for (const wrong of [
    { events: [{ ...event, player: 1 }] },
    { events: [{ ...event, enters: true }] },
    { events: [{ ...event, step: 1 }] },
    { events: [event, event] },
    { firstEvent: 3 },
    wrongRun(0, 50, 7, 7),
    wrongRun(2, 50, 7, 7),
    wrongRun(0, steps + 80, 1),
    wrongRun(1, steps + 3, 1),
  ]) {
    const { match, peers } = await openGap();
    peers.hear(2, writeMigration({ ...right, ...wrong }));
    assert.deepEqual([...peers.followers], [2]);
    assert.deepEqual(peers.takeOver(), [2], JSON.stringify(wrong));
    match.present.delete(2);
    match.play(100);
    assert.ok(match.all[1].rollback.confirmed > steps + 90, "it goes on alone");
    match.close();
  }
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
  const [{ peers, rollback, scene }, other] = match.all;
  match.play(60, () => 1);
  const state = () => [scene.world.hash(), rollback.steps, rollback.confirmed, rollback.leadOver(1)];
  const packet = readPacket(other.peers.write(0), 2, 8);
  const [run] = packet.runs;
  peers.hear(1, writePacket(packet));
  assert.equal(peers.refused, 0, "right");
  const before = state();
  const refused = (bytes, what) => {
    const count = peers.refused;
    const now = state();
    peers.hear(1, bytes);
    assert.equal(peers.refused, count + 1, what);
    assert.deepEqual(state(), now, what);
  };
  const known = peers.write(1) && rollback.steps - rollback.leadOver(1);
  for (const [what, wrong] of Object.entries({
    "of another": { from: 0 },
    "of nobody": { from: 40 },
    "a lead that cannot be": { lead: 1001 },
    "inputs acknowledged that nobody gave": { acks: [[0, 100000]] },
    "a player that there is not": { acks: [[2, 1]] },
    "too many of them": { acks: Array(3).fill([0, 1]) },
    "an input of mine": { runs: [{ ...run, player: 0 }] },
    "inputs of a player that there is not": { runs: [{ ...run, player: 2 }] },
    "an input that there is not": { runs: [{ player: 1, first: known, inputs: Uint8Array.of(8) }] },
    "another input than was told before": { runs: [{ player: 1, first: known - 1, inputs: Uint8Array.of(5) }] },
    "no inputs": { runs: [{ player: 1, first: known, inputs: new Uint8Array() }] },
    "too many inputs": { runs: [{ player: 1, first: known, inputs: new Uint8Array(121) }] },
    "events that only who invited says": { events: { known: 0, first: 0, list: [{ enters: true, player: 1, step: 1 }] } },
    "events that nobody said": { events: { known: 1, first: 0, list: [] } },
  }))
    refused(writePacket({ ...packet, ...wrong }), what);
  const bytes = writePacket(packet);
  for (let length = 0; length < bytes.length; length++) refused(bytes.subarray(0, length), `${length} bytes`);
  refused(Uint8Array.of(...bytes, 1), "more bytes");
  const random = randomBy(3);
  for (let i = 0; i < 2000; i++) {
    const damaged = Uint8Array.from(bytes);
    damaged[random(bytes.length)] ^= 1 << random(8);
    refused(damaged, "a bit");
  }
  refused(rollback.report().slice(1), "no report");
  refused(rollback.report().slice(0, -1), "a part of a report");
  peers.hear(7, bytes);
  assert.deepEqual(state(), before, "nobody");
  const guest = other.peers;
  const fromHost = readPacket(peers.write(1), 2, 8);
  for (const wrong of [{ first: 5 }, { list: [{ enters: false, player: 1, step: 9 }] }, { list: [{ enters: true, player: 2, step: 9 }] }]) {
    const count = guest.refused;
    const event = { enters: true, player: 0, step: 9 };
    guest.hear(0, writePacket({ ...fromHost, events: { known: 1, first: 0, list: [event], ...wrong } }));
    assert.equal(guest.refused, count + 1, JSON.stringify(wrong));
  }
  match.play(200);
  assert.ok(other.rollback.steps > 200, "the match goes on");
  match.close();
});

/** A rollback of an empty world. */
function emptyRollback(depth, players) {
  const world = engine.createWorld();
  const idle = Array.from({ length: players }, () => 0);
  return new thud.Rollback(world, { idle, step: () => world.step(), depth });
}

/** A round of one player. */
function playOne(peers) {
  peers.give(0);
  peers.advance();
  while (peers.isBehind && peers.advance());
}

test("impossible_events_of_a_host_are_refused_and_the_game_goes_on", () => {
  const none = { from: 0, lead: 0, hashStep: -1, hash: 0n, time: null, acks: [] };
  const runs = [0, 2].map((player) => ({ player, first: 0, inputs: new Uint8Array(10) }));
  const leaves = (player, step) => ({ enters: false, player, step });
  for (const list of [
    [{ enters: true, player: 0, step: 20 }],
    [leaves(0, 1)],
    [leaves(2, 40), leaves(2, 45)],
    [leaves(2, 0)],
  ]) {
    const rollback = emptyRollback(30, 3);
    const peers = new RollbackPeers({ rollback, players: 3, own: 1, inputs: 4, depth: 30, now: null });
    peers.connect(0);
    peers.hear(0, writePacket({ ...none, events: { known: 0, first: 0, list: [] }, runs }));
    for (let i = 0; i < 12; i++) playOne(peers);
    peers.hear(0, writePacket({ ...none, events: { known: list.length, first: 0, list }, runs: [] }));
    assert.equal(peers.refused, 1, JSON.stringify(list));
    const before = rollback.steps;
    for (let i = 0; i < 5; i++) playOne(peers);
    assert.ok(rollback.steps > before, JSON.stringify(list));
  }
});

test("host_goes_on_where_a_player_is_lost_that_was_told_to_enter", () => {
  const [depth, delay] = [16, 8];
  const options = { inputs: 4, delay, now: null };
  let sent = [];
  const back = [];
  const host = new RollbackPeers({
    ...options,
    depth,
    rollback: emptyRollback(depth, 2),
    players: 2,
    own: 0,
    send: (_, bytes) => sent.push(bytes),
  });
  host.miss(1);
  for (let i = 0; i < 120; i++) {
    playOne(host);
    host.tell();
  }
  const reader = new WelcomeReader();
  for (const bytes of host.invite(1)) reader.hear(bytes);
  const send = (_, bytes) => back.push(bytes);
  const guest = RollbackPeers.join(reader, { ...options, rollback: emptyRollback(depth, 2), send });
  let told = false;
  for (let i = 0; i < 60 && !told; i++) {
    sent = [];
    playOne(host);
    host.tell();
    for (const bytes of sent) guest.hear(0, bytes);
    playOne(guest);
    guest.tell();
    for (const bytes of back.splice(0)) host.hear(1, bytes);
    told = sent.some((bytes) => readPacket(bytes, 2, 4)?.events?.list.some(({ enters }) => enters));
  }
  assert.ok(told, "it is told to enter");
  host.lose(1);
  for (let i = 0; i < 100; i++) playOne(host);
});

test("damaged_welcome_is_no_welcome", async () => {
  const match = await openMatch(2, 1);
  match.play(30);
  const messages = match.all[0].peers.invite(1, { more: match.all[0].bare });
  assert.ok(messages.length > 1);
  const random = randomBy(5);
  for (const [i, message] of messages.entries())
    for (let k = 0; k < 50; k++) {
      const reader = new WelcomeReader();
      for (const right of messages.slice(0, i)) assert.ok(reader.hear(right));
      const damaged = Uint8Array.from(message);
      damaged[random(message.length)] ^= 1 << random(8);
      assert.equal(reader.hear(damaged), false);
      assert.equal(reader.hear(message.subarray(0, random(message.length))), false);
      assert.equal(reader.hear(messages[(i + 1) % messages.length]), false, "in another order");
      for (const right of messages.slice(i)) assert.ok(reader.hear(right));
      assert.ok(reader.isWhole);
    }
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

test("inputs_of_a_long_match_do_not_fill_the_memory", () => {
  setFlagsFromString("--expose-gc");
  const collect = runInNewContext("gc");
  const [STEPS, ROUND] = [120_000, 40_000];
  const queue = [];
  const all = [0, 1].map((own) => {
    const known = [0, 0];
    // A game that has no world.
    const rollback = {
      steps: 0,
      get confirmed() {
        return Math.min(this.steps, ...known);
      },
      get settled() {
        return this.steps;
      },
      input: (player, step) => (known[player] = step + 1),
      advance() {
        if (this.steps - this.confirmed >= DEPTH) return false;
        this.steps++;
        return true;
      },
      hashAt: () => "0",
      leadOver: () => 0,
      hearLead: () => {},
    };
    const send = (to, bytes) => queue.push([own, to, bytes]);
    return { rollback, peers: new RollbackPeers({ rollback, players: 2, own, inputs: 2, depth: DEPTH, delay: 2, send }) };
  });
  all[0].peers.start(1);
  all[1].peers.connect(0);
  const heap = [];
  while (all[1].rollback.steps < STEPS) {
    for (const { peers } of all) {
      peers.give(1);
      peers.advance();
      peers.tell();
    }
    for (const [from, to, bytes] of queue.splice(0)) all[to].peers.hear(from, bytes);
    if (all[1].rollback.steps % ROUND !== 0) continue;
    collect();
    heap.push(process.memoryUsage().heapUsed);
  }
  assert.ok(all.every(({ peers }) => peers.refused === 0 && peers.equal > STEPS / 8), "they have not played");
  // All inputs since the first round would take 2.6 MB, in lists of both players here and there.
  assert.ok(heap.at(-1) - heap[0] < 1e6, heap.join(" "));
});
