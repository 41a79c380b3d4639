#!/usr/bin/env node
/**
 * Measures the time of a first visit of the page until the first paint and until the scene has run
 * its first step.
 */
import { launchChromium, servePage } from "./browser.mjs";

const USAGE = `usage: node first-load.mjs [RUNS]

Opens the page of web/dist in a new Chromium RUNS times (5 by default), with nothing kept of former
visits, and prints medians in milliseconds from the start of the navigation: until the browser
painted for the first time, and until the scene had made its first step. Each with Canvas 2D, where
the browser needs no graphics card, and with WebGL, which takes most of a second by itself where
the browser emulates the card.
`;

/** Bytes of a megabit. */
const MEGABIT = 1e6 / 8;
/**
 * An emulated network: latency in ms, throughput in bytes a second. Chosen, as of a mobile network.
 */
const NETWORK = { latency: 40, downloadThroughput: 10 * MEGABIT, uploadThroughput: 5 * MEGABIT };
/** `slower`: the factor by which Chromium throttles the processor. */
const SLOW = { slower: 4, network: NETWORK };
const CONDITIONS = [
  { name: "Canvas 2D", webgl: false, slower: 1 },
  { name: "Canvas 2D, processor 4 times slower, 10 Mbit/s, 40 ms", webgl: false, ...SLOW },
  { name: "WebGL", webgl: true, slower: 1 },
  { name: "WebGL, processor 4 times slower, 10 Mbit/s, 40 ms", webgl: true, ...SLOW },
];

const [word = "5", ...rest] = process.argv.slice(2);
if (word === "--help" || word === "-h") {
  process.stdout.write(USAGE);
  process.exit(0);
}
const runs = Number(word);
if (!Number.isInteger(runs) || runs < 1 || rest.length > 0) {
  process.stderr.write(`first-load: RUNS is a whole number from 1 on\n\n${USAGE}`);
  process.exit(2);
}

/** One visit in a new browser with an empty cache. Returns the two times, ms. */
async function visit(url, { webgl, slower, network }) {
  const browser = await launchChromium({ webgl });
  try {
    const page = await browser.newPage();
    const session = await page.context().newCDPSession(page);
    await session.send("Emulation.setCPUThrottlingRate", { rate: slower });
    if (network) {
      await session.send("Network.enable");
      await session.send("Network.emulateNetworkConditions", { offline: false, ...network });
    }
    await page.addInitScript(() => {
      const look = () => {
        if (Number(document.querySelector("#hud")?.dataset.steps) > 0)
          window.firstStep = performance.now();
        else requestAnimationFrame(look);
      };
      requestAnimationFrame(look);
    });
    await page.goto(url);
    const step = await page.waitForFunction(() => window.firstStep, null, { timeout: 120_000 });
    const paint = await page.evaluate(
      () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime ?? NaN,
    );
    return { paint, step: await step.jsonValue() };
  } finally {
    await browser.close();
  }
}

function median(numbers) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return Math.round(sorted[Math.floor(sorted.length / 2)]);
}

const server = await servePage();
for (const condition of CONDITIONS) {
  const visits = [];
  for (let i = 0; i < runs; i++) visits.push(await visit(server.url, condition));
  const paint = median(visits.map((one) => one.paint));
  const step = median(visits.map((one) => one.step));
  console.log(`${condition.name}: first paint ${paint} ms, running after ${step} ms`);
}
await server.close();
