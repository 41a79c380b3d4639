/**
 * The panel Inside, which shows the engine at work. It has four parts, of which one is shown:
 * overlays, one body, the stages of a step, and the state's hash.
 */
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { choiceBar, make } from "../../page/dom";
import type { Stage } from "../../page/stage";
import { BodyPart } from "./body";
import { CheckPart } from "./check";
import { overlaysPart } from "./overlays";
import { StepPart } from "./step";
import "../../style/inside.css";

const PARTS = ["show", "body", "step", "bits"] as const;
type PartName = (typeof PARTS)[number];
const LABELS: Record<PartName, string> = {
  show: "Overlays",
  body: "Body",
  step: "Step",
  bits: "Same bits",
};

export function createPanel(app: App, stage: Stage): Panel {
  const body = new BodyPart(app, stage, () => show("body"));
  const step = new StepPart(app);
  const check = new CheckPart(app);
  const elements: Record<PartName, HTMLElement> = {
    show: overlaysPart(app, stage),
    body: body.element,
    step: step.element,
    bits: check.element,
  };
  const bar = choiceBar(
    "inside",
    "Look at",
    "",
    PARTS.map((value) => ({ value, label: LABELS[value] })),
    (value) => show(value),
  );
  bar.element.classList.add("parts");
  /** Shows a part and hides the others. */
  function show(part: PartName): void {
    bar.show(part);
    for (const name of PARTS) elements[name].hidden = name !== part;
    step.seen = part === "step";
    check.seen = part === "bits";
    // While paused no frame would come, and the part that is shown now would stay empty.
    app.refresh();
  }
  show(app.state.claim ? "bits" : "show");

  return {
    element: make("div", { class: "inside" }, bar.element, ...Object.values(elements)),
    opened() {
      body.watch();
      step.watch();
      check.watch();
    },
    closed() {
      body.rest();
      step.rest();
      check.rest();
    },
  };
}
