/**
 * The panel Inside, which shows the engine at work. It has five parts, of which one is shown:
 * overlays, one body, contacts, the stages of a step, and the state's hash.
 */
import type { App } from "../../page/app";
import type { Panel } from "../../page/dock";
import { choiceBar, make } from "../../page/dom";
import type { Stage } from "../../page/stage";
import { BodyPart } from "./body";
import { CheckPart } from "./check";
import { ContactsPart } from "./contacts";
import { overlaysPart } from "./overlays";
import { StepPart } from "./step";
import "../../style/inside.css";

const PARTS = ["show", "body", "contacts", "step", "bits"] as const;
type PartName = (typeof PARTS)[number];
const LABELS: Record<PartName, string> = {
  show: "Overlays",
  body: "Body",
  contacts: "Contacts",
  step: "Step",
  bits: "Same bits",
};

export function createPanel(app: App, stage: Stage): Panel {
  const body = new BodyPart(app, stage, () => show("body"));
  const contacts = new ContactsPart(app, () => body.pinned);
  const step = new StepPart(app);
  const check = new CheckPart(app);
  const elements: Record<PartName, HTMLElement> = {
    show: overlaysPart(app, stage),
    body: body.element,
    contacts: contacts.element,
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
    contacts.seen = part === "contacts";
    step.seen = part === "step";
    check.seen = part === "bits";
    if (contacts.seen) contacts.shown();
    // While paused no frame would come, and the part that is shown now would stay empty.
    app.refresh();
  }
  show(app.state.claim ? "bits" : "show");
  /** A scene that is about contacts opens the panel at them. */
  const begin = () => {
    if (app.scene?.panel === "contacts") show("contacts");
  };
  app.listen({ run: begin });
  begin();

  return {
    element: make("div", { class: "inside" }, bar.element, ...Object.values(elements)),
    opened() {
      body.watch();
      contacts.watch();
      step.watch();
      check.watch();
    },
    closed() {
      body.rest();
      contacts.rest();
      step.rest();
      check.rest();
    },
  };
}
