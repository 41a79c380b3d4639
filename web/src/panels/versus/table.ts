/** `Table`: the figures of both engines side by side, the better one of each row emphasized. */
import { make } from "../../page/dom";
import { BUDGET } from "../../shared/step-times";
import { type Engine, ENGINES, type Figures, NAMES } from "./tally";
import { compareDepths, compareTimes, type Comparison } from "./words";

/** A row of the table: how it is labelled, and how its text is made from an engine's figures. */
interface Row {
  label: string;
  hint: string;
  text(figures: Figures): string;
  /** Which engine's figure is the better; without it a row compares nothing. */
  compare?(thud: Figures, box2d: Figures, lengthScale: number): Comparison | null;
  /** Whether the row is shown; without it the row always is. */
  shown?(figures: Figures): boolean;
}

/** The text of a figure that is not known. */
const NOTHING = "–";
const ENERGY = new Intl.NumberFormat("en", {
  notation: "compact",
  maximumSignificantDigits: 3,
  signDisplay: "exceptZero",
});

/** Rows that are shown in scenes with joints. */
const JOINT_ROWS: readonly Row[] = [
  {
    label: "Joint gap now",
    hint: "By how much the joint that is open the most is open, in the world’s unit",
    text: ({ joints }) => depth(joints?.gap ?? 0),
    compare: (thud, box2d, scale) =>
      compareDepths(thud.joints?.gap ?? 0, box2d.joints?.gap ?? 0, scale),
    shown: ({ joints }) => joints !== null,
  },
  {
    label: "Joint gap, worst",
    hint: "The widest gap of a joint since both began",
    text: ({ joints }) => depth(joints?.ever ?? 0),
    compare: (thud, box2d, scale) =>
      compareDepths(thud.joints?.ever ?? 0, box2d.joints?.ever ?? 0, scale),
    shown: ({ joints }) => joints !== null,
  },
  {
    label: "Joint turned now",
    hint: "By how much a joint is turned that lets its bodies not turn, or only so far",
    text: ({ joints }) => `${(((joints?.angle ?? 0) * 180) / Math.PI).toFixed(2)}°`,
    shown: ({ joints }) => joints !== null,
  },
];

/** All rows. Without a clock that times single steps, the mean is shown and no percentile. */
function rowsOf(fineClock: boolean): Row[] {
  const share = ({ typical }: Figures) =>
    typical === null ? NOTHING : `${((100 * typical) / BUDGET).toFixed(typical < 1 ? 1 : 0)} %`;
  const typical: Row = {
    label: fineClock ? "Step, median" : "Step, mean",
    hint: "Of the last 240 steps in which both had bodies awake; without drawing and measuring",
    text: (figures) => milliseconds(figures.typical),
    compare: (thud, box2d) => compareTimes(thud.typical ?? 0, box2d.typical ?? 0),
  };
  const p99: Row = {
    label: "Step, p99",
    hint: "99 of 100 of those steps were quicker; the first 30 of a comparison do not count",
    text: (figures) => milliseconds(figures.p99),
    compare: (thud, box2d) => compareTimes(thud.p99 ?? 0, box2d.p99 ?? 0),
  };
  return [
    typical,
    ...(fineClock ? [p99] : []),
    { label: "Share of 16.7 ms", hint: "Of the time for a step, at 60 a second", text: share },
    {
      label: "Overlap now",
      hint: "How deep the worst pair of bodies overlaps, in the world’s unit; sleeping ones too",
      text: ({ now }) => depth(now),
      compare: (thud, box2d, scale) => compareDepths(thud.now, box2d.now, scale),
    },
    {
      label: "Overlap, mean",
      hint: "The worst pair’s overlap, on average over the steps measured since both began",
      text: ({ mean }) => depth(mean),
      compare: (thud, box2d, scale) => compareDepths(thud.mean, box2d.mean, scale),
    },
    {
      label: "Overlap, worst",
      hint: "The deepest overlap since both began",
      text: ({ ever }) => depth(ever),
      compare: (thud, box2d, scale) => compareDepths(thud.ever, box2d.ever, scale),
    },
    ...JOINT_ROWS,
    {
      label: "Energy since start",
      hint: "Change of kinetic and potential energy; only hands and motors may add any",
      text: ({ energyChange }) => ENERGY.format(energyChange),
    },
    {
      label: "Bodies",
      hint: "Those that have shapes",
      text: ({ bodies }) => bodies.toLocaleString("en"),
    },
    {
      label: "Awake",
      hint: "Bodies that move or have just moved; those that sleep cost nearly nothing",
      text: ({ awake }) => awake.toLocaleString("en"),
    },
  ];
}

export class Table {
  readonly element: HTMLTableElement;
  readonly #rows: Row[];
  readonly #cells: { [engine in Engine]: HTMLTableCellElement[] };
  readonly #settings: { [engine in Engine]: HTMLElement };

  constructor(fineClock: boolean) {
    this.#rows = rowsOf(fineClock);
    const cells = () => this.#rows.map(() => make("td", {}, NOTHING));
    this.#cells = { thud: cells(), box2d: cells() };
    this.#settings = { thud: make("small"), box2d: make("small") };
    const heads = ENGINES.map((engine) =>
      make("th", { scope: "col", class: engine }, `${NAMES[engine]} `, this.#settings[engine]),
    );
    const rows = this.#rows.map(({ label, hint }, i) =>
      make(
        "tr",
        { title: hint },
        make("th", { scope: "row" }, label),
        ...ENGINES.map((engine) => this.#cells[engine][i]),
      ),
    );
    this.element = make(
      "table",
      { id: "versus-table" },
      make("caption", { class: "unseen" }, "thud and Box2D in the same scene"),
      make("thead", {}, make("tr", {}, make("td"), ...heads)),
      make("tbody", {}, ...rows),
    );
  }

  /** Shows under each engine's name the settings that it runs with. */
  setSettings(thud: string, box2d: string): void {
    this.#settings.thud.textContent = thud;
    this.#settings.box2d.textContent = box2d;
  }

  /** Shows figures; null: nothing has been measured. The better ones are emphasized if
   * `comparable`, that is if both engines run the same scene. */
  show(
    figures: { [engine in Engine]: Figures } | null,
    lengthScale: number,
    comparable: boolean,
  ): void {
    this.#rows.forEach((row, i) => {
      const shown = !row.shown || (figures !== null && row.shown(figures.thud));
      this.element.tBodies[0].rows[i].hidden = !shown;
      const better =
        figures && comparable && row.compare?.(figures.thud, figures.box2d, lengthScale)?.better;
      for (const engine of ENGINES) {
        const cell = this.#cells[engine][i];
        const text = figures ? row.text(figures[engine]) : NOTHING;
        if (cell.textContent !== text) cell.textContent = text;
        cell.classList.toggle("better", engine === better);
      }
    });
  }
}

/** A time with its unit, to about three significant digits. */
function milliseconds(value: number | null): string {
  if (value === null) return NOTHING;
  return `${value.toFixed(value < 1 ? 3 : value < 10 ? 2 : 1)} ms`;
}

/** A length with two significant digits; less than 1e-5 is "0". */
function depth(value: number): string {
  if (value < 1e-5) return "0";
  return value.toFixed(Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(value)))));
}
