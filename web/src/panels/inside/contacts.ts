/**
 * The part Contacts of the panel Inside: the pairs that touched or met in the last step, and the
 * microscope, which takes one of them apart: every number of its collision with its formula, and
 * the steps of its resolution as pictures (pictures.ts).
 */
import type { Vec2 } from "thud";
import type { App } from "../../page/app";
import { make } from "../../page/dom";
import { say } from "../../page/messages";
import type { Collision, ContactList, Met, Side } from "../../worker/microscope";
import { resolutionPictures } from "./pictures";
import * as values from "./values";
import { fillList, type Row } from "./values";

/** Smaller numbers are rounding errors of the formulas, and shown as 0. Chosen. */
const ROUNDING = 1e-9;
const tidy = (value: number) => (Math.abs(value) < ROUNDING ? 0 : value);
const numberText = (value: number) => values.numberText(tidy(value));
const placeText = ([x, y]: Vec2) => values.placeText([tidy(x), tidy(y)]);

/** Milliseconds between two requests for the list while the scene runs. Chosen. */
const REFRESH = 400;

export class ContactsPart {
  readonly element: HTMLElement;
  /** Whether this part is shown; while it is not, nothing is asked for. */
  seen = false;
  readonly #app: App;
  /** The slot of the body that the part Body shows, or null. */
  readonly #slotOf: () => number | null;
  readonly #only = make("input", { type: "checkbox", name: "contacts-only" });
  readonly #onlyWord = make("span");
  readonly #hint = make("p", { class: "quiet", role: "status" });
  readonly #list = make("table", { id: "contacts" });
  readonly #scope = make("div", { id: "microscope" });
  /** The pair in the microscope; null: none. */
  #pair: Met | null = null;
  /**
   * The next list is of a step in which something met: the strongest new contact is then shown in
   * the microscope.
   */
  #takesNew = false;
  /** The visitor has chosen a pair: the focus goes to the microscope's head when it is shown. */
  #goesThere = false;
  /** The number of the step that is shown, and of the last question; an answer to an older one is
   * dropped. */
  #step = -1;
  #asked = 0;
  #askedAt = 0;
  #stop: (() => void) | null = null;

  constructor(app: App, slotOf: () => number | null) {
    this.#app = app;
    this.#slotOf = slotOf;
    const next = make("button", { class: "wide", id: "next-contact" }, "To the next collision");
    const step = make("button", { class: "wide" }, "One step");
    next.addEventListener("click", () => void this.#runOn());
    step.addEventListener("click", () => app.stepOnce());
    this.#only.addEventListener("change", () => this.#askAnew());
    this.element = make(
      "section",
      { class: "part", "aria-label": "Contacts" },
      make("div", { class: "pair" }, next, step),
      make("label", { class: "only" }, this.#only, this.#onlyWord),
      this.#hint,
      this.#list,
      this.#scope,
    );
  }

  /** The panel is opened. */
  watch(): void {
    this.#stop = this.#app.listen({
      run: () => {
        this.#pair = null;
        this.#step = -1;
        this.#goesThere = false;
        this.#scope.replaceChildren();
      },
      frame: (frame) => {
        const now = performance.now();
        const due = this.#app.state.paused || now - this.#askedAt >= REFRESH;
        if (this.seen && due && frame.step !== this.#step) this.#askAnew();
      },
    });
  }

  /** The panel is closed. */
  rest(): void {
    this.#stop?.();
  }

  /** This part has come into view. */
  shown(): void {
    const slot = this.#slotOf();
    this.#only.disabled = slot === null;
    if (slot === null) this.#only.checked = false;
    this.#onlyWord.textContent =
      slot === null ? "Only those of one body: keep it in Body first" : `Only those of body ${slot}`;
    this.#askAnew();
  }

  /** Makes steps until something meets. */
  async #runOn(): Promise<void> {
    const app = this.#app;
    if (!app.state.paused) app.setPaused(true);
    try {
      const met = await app.client.ask("runToContact", {});
      this.#pair = null;
      this.#takesNew = met;
      this.#scope.replaceChildren();
      if (!met) say("Nothing met in twenty seconds.");
      app.refresh();
      this.#askAnew();
    } catch (error) {
      this.#fail(error);
    }
  }

  /** Asks for the contacts of the present step, and for the pair in the microscope. */
  #askAnew(): void {
    void this.#ask(++this.#asked);
  }

  async #ask(number: number): Promise<void> {
    this.#askedAt = performance.now();
    const { client, state } = this.#app;
    const slot = this.#only.checked ? this.#slotOf() : null;
    try {
      const list = await client.ask("contacts", { slot });
      if (number !== this.#asked) return;
      this.#step = list.step;
      this.#showList(list);
      // The steps ended at a collision: of those that began then, the strongest is taken apart.
      if (this.#takesNew) this.#pair = list.contacts.find(({ began }) => began) ?? null;
      this.#takesNew = false;
      if (this.#pair && state.paused) await this.#open(this.#pair, list.step, number);
    } catch (error) {
      if (number === this.#asked) this.#fail(error);
    }
  }

  #showList({ step, contacts, count }: ContactList): void {
    const more = count - contacts.length;
    this.#hint.textContent =
      count === 0
        ? `Step ${step}: nothing touches.`
        : `Step ${step}: ${count} ${count === 1 ? "contact" : "contacts"}, largest impulse first` +
          `${more > 0 ? `; ${more} more are not shown` : ""}.`;
    const focused = (document.activeElement as HTMLElement | null)?.dataset.pair;
    const head = ["Bodies", "Met at", "Impulse"].map((text) => make("th", { scope: "col" }, text));
    const rows = contacts.map((met) => {
      const name = `${met.bodyA} and ${met.bodyB}`;
      const key = [met.a.index, met.b.index].join();
      const button = make(
        "button",
        { "data-pair": key, "aria-label": `Take apart bodies ${name}` },
        `${name}${met.began ? ", new" : ""}`,
      );
      button.addEventListener("click", () => void this.#choose(met, step));
      const speed = met.speed > 0 ? numberText(met.speed) : "–";
      return make(
        "tr",
        {},
        make("th", { scope: "row" }, button),
        make("td", {}, speed),
        make("td", {}, numberText(met.impulse)),
      );
    });
    this.#list.hidden = count === 0;
    this.#list.replaceChildren(
      make("thead", {}, make("tr", {}, ...head)),
      make("tbody", {}, ...rows),
    );
    if (focused)
      this.#list.querySelector<HTMLButtonElement>(`[data-pair="${focused}"]`)?.focus();
  }

  /** The visitor has chosen a pair of the list. */
  async #choose(met: Met, step: number): Promise<void> {
    const app = this.#app;
    if (!app.state.paused) app.setPaused(true);
    this.#pair = met;
    this.#goesThere = true;
    try {
      await this.#open(met, step, this.#asked);
    } catch (error) {
      this.#fail(error);
    }
  }

  async #open(met: Met, step: number, number: number): Promise<void> {
    const { a, b } = met;
    const found = await this.#app.client.ask("examine", { pair: { a, b }, step });
    if (number !== this.#asked || met !== this.#pair) return;
    const open = this.#goesThere || this.#scope.contains(document.activeElement);
    this.#goesThere = false;
    this.#scope.replaceChildren(...microscope(found));
    if (open) this.#scope.querySelector("h3")?.focus();
  }

  #fail(error: unknown): void {
    this.#goesThere = false;
    this.#scope.replaceChildren(
      make("p", { class: "quiet" }, error instanceof Error ? error.message : String(error)),
    );
  }
}

const signed = (value: number) => (value < 0 ? `(${numberText(value)})` : numberText(value));

/** All that is shown of a pair. */
function microscope(found: Collision): HTMLElement[] {
  const { bodyA, bodyB, step, formula } = found;
  const title = make(
    "h3",
    { tabindex: "-1" },
    `Bodies ${bodyA.slot} (a) and ${bodyB.slot} (b) in step ${step}`,
  );
  return [
    title,
    facts("scope-meeting", meetingRows(found)),
    make("h4", {}, "The overlap resolved, in four steps, and the swept answer"),
    resolutionPictures(found),
    make("h4", {}, "Impulse, by the formulas"),
    facts("scope-formula", formulaRows(found)),
    make("h4", {}, "Velocities before and after"),
    velocityTable(found),
    make("p", { class: "quiet" }, aboutGravity(found)),
    make(
      "p",
      { class: "quiet" },
      formula.impulse === 0
        ? "The two part already, so that no impulse acts."
        : "A rule between kinds, a listener, a moving surface or other contacts in the same step " +
          "change what the engine does; the formulas know of this pair alone.",
    ),
  ];
}

function facts(id: string, rows: readonly Row[]): HTMLElement {
  const list = make("dl", { class: "facts", id });
  fillList(list, rows);
  return list;
}

function meetingRows(found: Collision): Row[] {
  const { normal, point, separation, restitution, bounce, friction, threshold, reported } = found;
  const rows: Row[] = [
    ["normal n, from a to b", placeText(normal)],
    ["point", placeText(point)],
    separation < 0
      ? ["depth before the step", numberText(-separation)]
      : ["gap before the step", numberText(separation)],
    ["restitution e", numberText(restitution)],
    ["friction μ", numberText(friction)],
  ];
  if (bounce !== restitution)
    rows.push(["e at this speed", `0: slower than ${numberText(threshold)}`]);
  if (reported > 0) rows.push(["closing speed, by the step", numberText(reported)]);
  return rows;
}

/** Each formula with its numbers. */
function formulaRows({ formula, bounce, friction }: Collision): Row[] {
  const f = formula;
  const e = numberText(bounce);
  const terms = [f.a.inverseMass, f.b.inverseMass, f.a.turning, f.b.turning].map(numberText);
  const rows: Row[] = [
    ["v_n = (v_b − v_a) · n", numberText(f.normalSpeed)],
    ["v_t, across it", numberText(f.tangentSpeed)],
    ["r_a × n, r_b × n", `${numberText(f.a.arm)}, ${numberText(f.b.arm)}`],
    [
      "k = 1/m_a + 1/m_b + (r_a×n)²/I_a + (r_b×n)²/I_b",
      `${terms.join(" + ")} = ${numberText(f.response)}`,
    ],
    [
      "j = −(1 + e) v_n / k",
      f.impulse === 0
        ? "0"
        : `−(1 + ${e}) · ${signed(f.normalSpeed)} / ${numberText(f.response)} = ${numberText(f.impulse)}`,
    ],
    [
      "v_n′ = −e v_n, before friction",
      f.impulse === 0
        ? numberText(f.normalSpeedAfter)
        : `−${e} · ${signed(f.normalSpeed)} = ${numberText(f.normalSpeedAfter)}`,
    ],
    [
      "μ j, the bound of friction",
      `${numberText(friction)} · ${numberText(f.impulse)} = ${numberText(friction * f.impulse)}`,
    ],
    [
      f.slides ? "j_t = ± μ j: it slides" : "j_t = −v_t / k_t: it grips",
      numberText(f.frictionImpulse),
    ],
  ];
  return rows;
}

function velocityTable(found: Collision): HTMLElement {
  const { bodyA, bodyB, formula, measured, arriving } = found;
  const head = ["", "Before", "After", "By formula"].map((text) =>
    make("th", { scope: "col" }, text),
  );
  const sum = ([x, y]: Vec2, [u, v]: Vec2): Vec2 => [x + u, y + v];
  const none: Vec2 = [0, 0];
  const rowsOf = (letter: string, side: Side, after: { velocity: Vec2; spin: number }) => [
    [
      `v_${letter}`,
      placeText(side.before.velocity),
      placeText(side.after.velocity),
      placeText(sum(after.velocity, arriving ? none : side.gravity)),
    ],
    [`ω_${letter}`, ...[side.before.spin, side.after.spin, after.spin].map(numberText)],
  ];
  const rows = [
    ...rowsOf("a", bodyA, formula.a),
    ...rowsOf("b", bodyB, formula.b),
    ["v_n", ...[measured.normalBefore, measured.normalAfter, formula.normalSpeedFinal].map(numberText)],
    ["v_t", ...[measured.tangentBefore, measured.tangentAfter, formula.tangentSpeedFinal].map(numberText)],
  ];
  const lines = rows.map(([name, ...cells]) =>
    make(
      "tr",
      {},
      make("th", { scope: "row" }, name),
      ...cells.map((text) => make("td", {}, text)),
    ),
  );
  return make(
    "table",
    { id: "scope-velocities" },
    make("thead", {}, make("tr", {}, ...head)),
    make("tbody", {}, ...lines),
  );
}

function aboutGravity({ arriving, bodyA, bodyB }: Collision): string {
  const pulls = [bodyA, bodyB].some(({ gravity }) => Math.hypot(...gravity) > 0);
  if (!pulls) return "Gravity pulls neither of them.";
  return arriving
    ? "They meet within the step: the formulas begin with gravity’s share of it in v."
    : "They overlap as the step begins. The formulas act first, and then gravity’s share of the " +
        "step is added to v_a and v_b.";
}
