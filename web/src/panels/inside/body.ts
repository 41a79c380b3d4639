/**
 * The part Body of the panel Inside: the state, shapes, contacts and joints of the body under the
 * pointer, also on a small card beside the pointer. A click pins a body, which then stays in the
 * panel.
 */
import type { ShapeState } from "thud";
import type { App } from "../../page/app";
import { byId, make } from "../../page/dom";
import { isTouch } from "../../page/how";
import { say } from "../../page/messages";
import type { Hovered, Stage } from "../../page/stage";
import type { BodyReport, Tie, Touch } from "../../worker/inspect";
import { degreesText, fillList, numberText, placeText, type Row } from "./values";

/** CSS pixels from the pointer to the card. Chosen. */
const AWAY = 16;

/** The collision mask of a shape that meets all categories. */
const ALL_BITS = 0xffffffff;
/** Rows of the tables of contacts and of joints at most. Chosen. */
const MOST_ROWS = 12;
/** The text while no body is shown. */
const HOW = isTouch()
  ? "Tap a body to see its state."
  : "Point at a body to see its state; a click keeps it here. Q takes the body at the crosshair.";
const CONTACT_HEAD = headOf("Touches", "Points", "Depth", "Impulse", "Friction");
const JOINT_HEAD = headOf("Tied to", "By", "Gap", "Turned", "Force", "Torque");

export class BodyPart {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #stage: Stage;
  readonly #picked: () => void;
  readonly #card = make("dl", { id: "body-card", class: "panel", "aria-hidden": "true" });
  readonly #title = make("h3");
  readonly #hint = make("p", { class: "quiet" });
  readonly #state = make("dl", { class: "facts", id: "body-state" });
  readonly #shapes = make("div");
  readonly #contacts = make("table", { id: "body-contacts" });
  readonly #joints = make("table", { id: "body-joints" });
  readonly #release = make("button", { class: "wide" }, "Let go of it");
  #hovered: Hovered | null = null;
  /** The slot (index in `Frame.now`) of the pinned body; null: none. */
  #pinned: number | null = null;
  /** A question to the worker is open. */
  #asking = false;
  /** Ends listening to the app. */
  #stop: (() => void) | null = null;

  /** `picked` is called when a body was clicked, so that this part is shown. */
  constructor(app: App, stage: Stage, picked: () => void) {
    this.#app = app;
    this.#stage = stage;
    this.#picked = picked;
    this.#release.addEventListener("click", () => this.#pin(null));
    this.element = make(
      "section",
      { class: "part", "aria-label": "Body" },
      this.#title,
      this.#hint,
      this.#state,
      this.#joints,
      this.#contacts,
      this.#shapes,
      this.#release,
    );
    this.#clear();
  }

  /** The slot of the body that is kept; null: none. */
  get pinned(): number | null {
    return this.#pinned;
  }

  /** The panel is opened. */
  watch(): void {
    this.#card.hidden = true;
    byId("stage").append(this.#card);
    this.#stage.onHover = (hovered) => this.#hover(hovered);
    this.#stage.onPick = (slot) => this.#pin(slot);
    this.#stop = this.#app.listen({
      frame: () => void this.#ask(),
      run: () => this.#pin(null),
    });
  }

  /** The panel is closed. */
  rest(): void {
    this.#stage.onHover = this.#stage.onPick = null;
    this.#stop?.();
    this.#hover(null);
    this.#pin(null);
    this.#card.remove();
  }

  /** Another body, or none, is under the pointer, or the pointer has moved. */
  #hover(hovered: Hovered | null): void {
    const same = hovered?.slot === this.#hovered?.slot;
    this.#hovered = hovered;
    this.#outline();
    if (!hovered) {
      this.#card.hidden = true;
      if (this.#pinned === null) this.#clear();
    } else {
      this.#place(hovered);
      if (!same) void this.#ask();
    }
  }

  /** Pins a body; null unpins it. */
  #pin(slot: number | null): void {
    const lets = slot === null && this.#pinned !== null;
    this.#pinned = slot;
    this.#outline();
    if (slot === null) {
      if (lets && !this.#hovered) this.#clear();
      return;
    }
    this.#picked();
    say(`Body ${slot} is shown`);
    void this.#ask();
  }

  /** Has the pinned body outlined, or else the one under the pointer. */
  #outline(): void {
    this.#stage.outlined = this.#pinned ?? this.#hovered?.slot ?? null;
    if (this.#stage.view.shown.has("sums")) this.#app.refresh();
  }

  /** Asks the worker for the bodies in the panel and on the card, unless a question is open; each
   * frame asks again. */
  async #ask(): Promise<void> {
    const inPanel = this.#pinned ?? this.#hovered?.slot;
    if (this.#asking || inPanel === undefined || document.hidden) return;
    this.#asking = true;
    try {
      const { client } = this.#app;
      const report = await client.ask("inspect", { slot: inPanel });
      const onCard =
        this.#hovered && this.#hovered.slot !== inPanel
          ? await client.ask("inspect", { slot: this.#hovered.slot })
          : report;
      this.#show(report, inPanel);
      this.#showCard(onCard);
    } catch {
      // The scene has ended; the next scene's frames ask again.
    }
    this.#asking = false;
    // Another body may have come under the pointer meanwhile.
    if ((this.#pinned ?? this.#hovered?.slot ?? inPanel) !== inPanel) void this.#ask();
  }

  /** Shows a report in the panel; null: the body has been removed. */
  #show(report: BodyReport | null, slot: number): void {
    if ((this.#pinned ?? this.#hovered?.slot) !== slot) return;
    if (!report) {
      this.#pin(null);
      this.#clear("The body is gone.");
      return;
    }
    this.#title.textContent = `Body ${slot}, ${report.state.kind}`;
    this.#hint.textContent = this.#pinned === null ? "Click it to keep it here." : "";
    this.#release.hidden = this.#pinned === null;
    fillList(this.#state, rowsOf(report));
    this.#showContacts(report.contacts);
    this.#showJoints(report.joints);
    this.#showShapes(report.shapes);
  }

  #showContacts(contacts: readonly Touch[]): void {
    const rows = contacts.map(({ other, points, depth, impulse, friction }) => [
      `body ${other}`,
      String(points),
      ...[depth, impulse, friction].map(numberText),
    ]);
    fillTable(this.#contacts, CONTACT_HEAD, rows);
  }

  #showJoints(joints: readonly Tie[]): void {
    const rows = joints.map(({ kind, other, enabled, gap, angleGap, force, torque }) => [
      `body ${other}`,
      enabled ? kind : `${kind}, off`,
      numberText(gap),
      degreesText(angleGap),
      ...[force, torque].map(numberText),
    ]);
    fillTable(this.#joints, JOINT_HEAD, rows);
  }

  #showShapes(shapes: readonly ShapeState[]): void {
    while (this.#shapes.children.length > shapes.length) this.#shapes.lastElementChild!.remove();
    while (this.#shapes.children.length < shapes.length)
      this.#shapes.append(make("div", {}, make("h4"), make("dl", { class: "facts" })));
    shapes.forEach((shape, i) => {
      const [title, list] = this.#shapes.children[i].children;
      title.textContent = `Shape${shapes.length > 1 ? ` ${i + 1}` : ""}: ${shape.kind}`;
      fillList(list as HTMLDListElement, shapeRows(shape));
    });
  }

  /** Shows a report on the card, if it is of the body under the pointer. */
  #showCard(report: BodyReport | null): void {
    const hovered = this.#hovered;
    this.#card.hidden = !report || hovered?.slot !== report.slot;
    if (!report || !hovered) return;
    const { state } = report;
    fillList(this.#card as HTMLDListElement, [
      [`Body ${report.slot}`, wordsOf(report)],
      ["position", placeText(state.position)],
      ["speed", numberText(Math.hypot(...state.velocity))],
      ["spin", numberText(state.angularVelocity)],
      ...(state.kind === "dynamic" ? ([["mass", numberText(state.mass)]] as const) : []),
    ]);
    this.#place(hovered);
  }

  /** Places the card beside the pointer, on the side where the window has room. */
  #place({ screenX, screenY }: Hovered): void {
    const { offsetWidth, offsetHeight, style } = this.#card;
    const left = screenX + AWAY + offsetWidth > innerWidth ? -AWAY - offsetWidth : AWAY;
    const top = screenY + AWAY + offsetHeight > innerHeight ? -AWAY - offsetHeight : AWAY;
    style.left = `${screenX + left}px`;
    style.top = `${screenY + top}px`;
  }

  /** Shows no body. */
  #clear(hint = ""): void {
    this.#title.textContent = "No body";
    this.#hint.textContent = hint || HOW;
    this.#release.hidden = true;
    this.#state.replaceChildren();
    this.#shapes.replaceChildren();
    this.#contacts.hidden = this.#joints.hidden = true;
  }
}

/** The head of a table with these columns. */
function headOf(...texts: string[]): HTMLElement {
  const cells = texts.map((text) => make("th", { scope: "col" }, text));
  return make("thead", {}, make("tr", {}, ...cells));
}

/** Fills a table with at most MOST_ROWS rows, whose first cell is the row's header; hides it if
 * there are none. */
function fillTable(table: HTMLElement, head: HTMLElement, rows: readonly string[][]): void {
  table.hidden = rows.length === 0;
  const shown = rows.slice(0, MOST_ROWS).map(([first, ...others]) => {
    const cells = others.map((text) => make("td", {}, text));
    return make("tr", {}, make("th", { scope: "row" }, first), ...cells);
  });
  const more = rows.length - shown.length;
  table.replaceChildren(
    make("caption", { class: "quiet" }, more > 0 ? `And ${more} more.` : ""),
    head,
    make("tbody", {}, ...shown),
  );
}

/** The body's state in a word. */
function wordsOf({ state }: BodyReport): string {
  if (!state.enabled) return "switched off";
  if (state.quarantined) return "quarantined: not finite";
  if (state.kind === "static") return "static";
  return state.awake ? "awake" : "asleep";
}

/** The rows of a body's state; those that say nothing for its kind or are defaults are left out. */
function rowsOf(report: BodyReport): Row[] {
  const { state } = report;
  const rows: Row[] = [
    ["state", wordsOf(report)],
    ["position", placeText(state.position)],
    ["angle", degreesText(state.angle)],
  ];
  if (state.kind !== "static")
    rows.push(
      ["velocity", placeText(state.velocity)],
      ["speed", numberText(Math.hypot(...state.velocity))],
      ["spin, rad/s", numberText(state.angularVelocity)],
    );
  if (state.kind === "dynamic")
    rows.push(
      ["mass", numberText(state.mass)],
      ["inertia", state.inertia > 0 ? numberText(state.inertia) : "does not turn"],
    );
  if (state.kind === "dynamic" && placeText(state.center) !== placeText(state.position))
    rows.push(["centre of mass", placeText(state.center)]);
  if (report.contacts.some(({ direct }) => direct)) rows.push(["its island", "solved directly"]);
  if (state.kind === "dynamic" && state.gravityScale !== 1)
    rows.push(["gravity", `× ${numberText(state.gravityScale)}`]);
  return rows;
}

/** The rows of a shape's state, without defaults. */
function shapeRows(shape: ShapeState): Row[] {
  const rows: Row[] = [];
  if (shape.kind === "circle") rows.push(["radius", numberText(shape.radius)]);
  else if (shape.kind !== "terrain")
    rows.push([
      "size",
      `${numberText(2 * shape.halfWidth)} × ${numberText(2 * shape.halfHeight)}`,
    ]);
  if (shape.sensor) rows.push(["sensor", "reports, does not collide"]);
  else
    rows.push(
      ["friction", numberText(shape.friction)],
      ["restitution", numberText(shape.restitution)],
    );
  rows.push(["density", numberText(shape.density)]);
  if (shape.surfaceSpeed !== 0) rows.push(["surface speed", numberText(shape.surfaceSpeed)]);
  if (shape.group !== 0) rows.push(["group", String(shape.group)]);
  if (shape.category !== 1 || shape.mask >>> 0 !== ALL_BITS)
    rows.push(["category, mask", `${bits(shape.category)}, ${bits(shape.mask)}`]);
  return rows;
}

/** 32 bits as a hexadecimal number. */
function bits(value: number): string {
  return `0x${(value >>> 0).toString(16)}`;
}
