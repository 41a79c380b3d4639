/**
 * The section Heavier of the panel Trade: finds, in the laboratory's worker, the number of bodies
 * up to which each engine makes its steps in time at a rate of 60 Hz or more.
 */
import type { App } from "../../page/app";
import { choiceBar, make } from "../../page/dom";
import { say } from "../../page/messages";
import { findScene } from "../../scene/registry";
import type { HeavierProgress, Holding } from "../../worker/measure-heavier";
import { RATES } from "../../worker/measure-settings";
import type { Laboratory } from "./laboratory";
import { missesText } from "../misses";
import { countText, timeText } from "./text";
import { Work } from "./work";

/** Scenes that are offered if the running one has a single size. Chosen. */
const OFFERED = ["circle_pit", "mixed_terrain", "pyramid", "tumbler"];

const NAMES = { thud: "thud", box2d: "Box2D" } as const;

/** Builds the section. */
export function createHeavier(app: App, laboratory: Laboratory): HTMLElement {
  let hertz: number = RATES[0];
  const rates = RATES.map((rate) => ({ value: String(rate), label: `${rate} Hz` }));
  const rate = choiceBar("rate", "Steps a second", "", rates, (value) => (hertz = Number(value)));
  rate.show(String(hertz));
  const answer = make("p", { class: "answer" });
  const more = make("ul", { class: "explained" });
  const work = new Work("Make it heavier", laboratory, async (work) => {
    answer.textContent = "";
    more.replaceChildren();
    const found = await laboratory.ask(
      "heavier",
      { scene: laboratory.request, sizes: app.scene!.sizes!, hertz },
      (progress) => work.report(null, progressText(progress)),
      () => work.report(null, "A step takes seconds: cancel, or wait."),
    );
    if (!found) return "Cancelled.";
    answer.textContent = `${missesText(found.misses)} ${answerText(found.holdings, hertz)}`.trim();
    more.replaceChildren(...found.holdings.map((holding) => make("li", {}, detailText(holding))));
    say(answer.textContent);
    return found.withoutBox2D ? `Without Box2D. ${found.withoutBox2D}` : "";
  });
  const offers = OFFERED.map((name) => {
    const button = make("button", { class: "wide" }, findScene(name)?.title ?? name);
    button.addEventListener("click", () => void app.open(name));
    return button;
  });
  const instead = make(
    "div",
    {},
    make("p", { class: "explained" }, "This scene has one size only. Scenes to make heavier:"),
    make("div", { class: "actions" }, ...offers),
  );
  const able = make("div", {}, rate.element, work.element, answer, more);
  const show = () => {
    const sized = Boolean(app.scene?.sizes);
    able.hidden = !sized;
    instead.hidden = sized;
  };
  app.listen({ run: show });
  show();
  return make(
    "section",
    { class: "trade-part", "aria-labelledby": "heavier-heading" },
    make("h3", { id: "heavier-heading" }, "Heavier"),
    make(
      "p",
      { class: "explained" },
      "More and more bodies, until an engine cannot keep up: until in the slowest of the first " +
        "four seconds more than half of its steps take too long. What fails is tried again, and " +
        "what held last once more: the answer lies between the two sizes. No body may sleep " +
        "meanwhile. Box2D has its usual 4 substeps, thud what is set above.",
    ),
    able,
    instead,
  );
}

/** "thud with 800 bodies: 4.2 ms a step; Box2D holds 600": the size being tried, and results. */
function progressText({ trying, holdings }: HeavierProgress): string {
  const { engine, bodies, milliseconds } = trying;
  const known = holdings.flatMap(({ engine: name, held }) =>
    held ? [`${NAMES[name]} holds ${countText(held.bodies)}`] : [],
  );
  const now = `${NAMES[engine]} with ${countText(bodies)} bodies: ${timeText(milliseconds)} a step`;
  return [now, ...known].join("; ");
}

/** "thud holds 5,400 to 5,900 bodies at 60 Hz, Box2D 2,100 to 2,300 here." */
function answerText(holdings: readonly Holding[], hertz: number): string {
  const parts = holdings.map(({ engine, held, missed }, i) => {
    const name = `${NAMES[engine]}${i === 0 ? " holds" : ""}`;
    const rate = i === 0 ? ` bodies at ${hertz} Hz` : "";
    if (!held) return `${name} not even ${countText(missed!.bodies)}${rate}`;
    if (!missed) return `${name} all ${countText(held.bodies)}${rate}`;
    return `${name} ${countText(held.bodies)} to ${countText(missed.bodies)}${rate}`;
  });
  return `${parts.join(", ")} here.`;
}

/** One engine's result in detail. */
function detailText({ engine, held, missed }: Holding): string {
  const parts = [];
  if (held)
    parts.push(
      `with ${countText(held.bodies)} bodies a step took ${timeText(held.milliseconds)} in the ` +
        "slowest second",
    );
  if (missed) parts.push(`${countText(missed.bodies)} were too many`);
  else parts.push("the scene has no larger size");
  return `${NAMES[engine]}: ${parts.join("; ")}.`;
}
