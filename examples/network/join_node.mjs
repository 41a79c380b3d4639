/**
 * Joins the game of thud-serve from Node, and drives at random: node join_node.mjs --help. It needs
 * Node's own WebSocket (Node 22 or later), or else the package ws.
 */
import { parseArgs } from "node:util";
import { load } from "thud";
import { carsInput } from "./cars.mjs";
import { play } from "./join.mjs";

const USAGE = `usage: node join_node.mjs [OPTION...]

  --server URL   default ws://localhost:8081
  --seed N       of the inputs, from 0 on; default 2
  --token N      a number from 1 on by which the server knows who comes back; default none
  --leave N      leave before this step
  --watch        do not play
  --help         this`;

function fail(message) {
  console.error(`join_node: ${message}`);
  process.exit(2);
}

function readOptions() {
  const options = {
    server: { type: "string", default: "ws://localhost:8081" },
    seed: { type: "string", default: "2" },
    token: { type: "string", default: "0" },
    leave: { type: "string" },
    watch: { type: "boolean", default: false },
    help: { type: "boolean", short: "h" },
  };
  try {
    return parseArgs({ options }).values;
  } catch (error) {
    return fail(`${error.message.split(/[.\n]/)[0]}; --help lists the options`);
  }
}

const { server, seed, token, leave, watch, help } = readOptions();
if (help) {
  console.log(USAGE);
  process.exit();
}
for (const [name, text] of Object.entries({ seed, token, leave: leave ?? "0" }))
  if (!/^\d{1,9}$/.test(text)) fail(`--${name} needs a whole number from 0 on, not '${text}'`);
if (!/^wss?:\/\/./.test(server)) fail(`--server needs an address such as ws://localhost:8081, not '${server}'`);

const Socket = globalThis.WebSocket ?? (await import("ws")).WebSocket;
const thud = await load();
try {
  const choose = (peer) => carsInput(Number(seed), peer.me, peer.steps);
  const onFrame = ({ steps }) => !leave || steps < Number(leave);
  const peer = await play(thud, new Socket(server, "thud"), choose, { onFrame, token: BigInt(token), watches: watch });
  const { me, rollback, net } = peer;
  console.log(`player ${me}: ${peer.steps} steps, ${rollback.replayed} run again, ${net.refused} messages refused`);
  console.log(`hash ${peer.hash}`);
  if (net.differs >= 0) console.error(`join_node: another player has another game from step ${net.differs} on`);
  process.exitCode = net.differs >= 0 ? 1 : 0;
  peer.close();
} catch (error) {
  console.error(`join_node: ${error.message}`);
  process.exitCode = 1;
}
