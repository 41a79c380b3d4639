/**
 * `Result`: the series of "Measure" with the browser, date and scene of the measurement. Converts
 * it to plain text and to a packed form in the page's address, and back.
 */
import type { App } from "../../page/app";
import { pack, unpack, writeState } from "../../page/url";
import type { Series, SeriesRow } from "../../worker/measure";
import { BOX2D, labelOf, type SeriesSetting, THUD } from "../../worker/measure-settings";
import { missesText } from "../misses";
import { choicesText, countText, errorText, plainTime } from "./text";

export interface Result extends Series {
  /** The scene's title, with its size. */
  title: string;
  /** What is chosen besides quality, and "with changed code", where they differ from the defaults; or "". */
  setUp: string;
  browser: string;
  /** navigator.hardwareConcurrency. */
  processors: number;
  /** ISO 8601, to the minute. */
  date: string;
}

/** The result of a series that was measured just now in this browser. */
export function describeResult(app: App, series: Series): Result {
  const { scene, state } = app;
  const size = scene?.sizes ? ` (${countText(scene.size)} ${scene.sizes.means})` : "";
  const choices = { ...state.choices, quality: "default" as const, substeps: 0, maxError: 0 };
  const unusual = [choicesText(choices)].filter((text) => text !== "default");
  if (state.code !== null) unusual.push("with changed code");
  return {
    ...series,
    rows: series.rows.map(rounded),
    title: app.title + size,
    setUp: unusual.join(", ").replace(/^default /, ""),
    browser: browserName(navigator.userAgent),
    processors: navigator.hardwareConcurrency,
    date: `${new Date().toISOString().slice(0, 16)}Z`,
  };
}

/** A row with its figures rounded to four significant digits, which is finer than they are measured
 * and keeps links short. */
function rounded(row: SeriesRow): SeriesRow {
  const round = (x: number) => Number(x.toPrecision(4));
  const { typical, p99, worst, mean, own } = row;
  return {
    ...row,
    typical: round(typical),
    p99: round(p99),
    worst: round(worst),
    mean: round(mean),
    own: own === null ? null : round(own),
  };
}

/** "Firefox 140 on Linux", from the browser's user-agent string. */
function browserName(agent: string): string {
  const known = [
    ["Edge", /Edg\/(\d+)/],
    ["Opera", /OPR\/(\d+)/],
    ["Firefox", /Firefox\/(\d+)/],
    ["Chrome", /Chrom(?:e|ium)\/(\d+)/],
    ["Safari", /Version\/(\d+).*Safari/],
  ] as const;
  const found = known.find(([, pattern]) => pattern.test(agent));
  const system = /Android|iPhone|iPad|Windows|Mac OS X|CrOS|Linux/.exec(agent)?.[0];
  const name = found ? `${found[0]} ${found[1].exec(agent)![1]}` : "a browser";
  return system ? `${name} on ${system}` : name;
}

/** The scene's title with what differs from the defaults. */
export function titleOf({ title, setUp }: Result): string {
  return setUp ? `${title}, ${setUp}` : title;
}

/** "Firefox 140 on Linux, 8 processors, July 4, 2026". */
export function whereMeasured({ browser, processors, date }: Result): string {
  const day = new Date(date).toLocaleDateString("en", { dateStyle: "long" });
  return `${browser}, ${processors} processors, ${day}`;
}

/** The columns of the table of a result. */
export const COLUMNS = ["setting", "ms", "p99", "worst", "mean"] as const;

/** The cells of a row, in the order of COLUMNS; a row cut short has its number of steps. */
export function cellsOf(row: SeriesRow, series: Series): string[] {
  const { setting, typical, p99, worst, mean, steps } = row;
  const early = steps < series.steps ? ` (${steps} steps)` : "";
  return [
    labelOf(setting) + early,
    plainTime(typical),
    plainTime(p99),
    errorText(worst),
    errorText(mean),
  ];
}

/** The result as plain text with a table. */
export function resultText(result: Result): string {
  const rows = [[...COLUMNS], ...result.rows.map((row) => cellsOf(row, result))];
  const widths = COLUMNS.map((_, i) => Math.max(...rows.map((row) => row[i].length)));
  const lines = rows.map((row) =>
    row.map((cell, i) => (i === 0 ? cell.padEnd(widths[0]) : cell.padStart(widths[i]))).join("  "),
  );
  const misses = missesText(result.misses);
  return [
    ...(misses === "" ? [] : [misses, ""]),
    `${titleOf(result)}: ${countText(result.bodies)} bodies, ${result.steps} steps`,
    whereMeasured(result),
    "ms: of a step, median; worst, mean: overlap in length scales",
    "",
    ...lines,
    "",
  ].join("\n");
}

/** An address that shows the result, with its scene. */
export async function resultLink(app: App, result: Result): Promise<string> {
  const packed = await pack(JSON.stringify(shorten(result)));
  const address = await writeState({ ...app.state, panel: "trade", result: packed });
  return new URL(address, location.href).href;
}

/** The result in an address; null if it is damaged. */
export async function readResult(packed: string): Promise<Result | null> {
  try {
    return lengthen(JSON.parse((await unpack(packed)) ?? "null"));
  } catch {
    return null;
  }
}

/** Settings of a series; the packed form names a row's setting by its index here. */
const SETTINGS: readonly SeriesSetting[] = [...THUD, ...BOX2D];
/** Version of the packed form. Version 1, which lacks `misses`, is not read. */
const VERSION = 2;
/** Properties in the packed form, in its order: of rows, and the texts and numbers of the
 * result. */
const FIGURES = ["typical", "p99", "worst", "mean", "own", "steps"] as const;
const TEXTS = ["title", "setUp", "browser", "date", "withoutBox2D"] as const;
const NUMBERS = ["processors", "timeStep", "bodies", "steps"] as const;

/** The packed form: an array of version, texts, numbers, rows and misses. A row is an array of its
 * setting's index in SETTINGS and its figures. */
function shorten(result: Result): unknown {
  return [
    VERSION,
    TEXTS.map((name) => result[name]),
    NUMBERS.map((name) => result[name]),
    result.rows.map((row) => [
      SETTINGS.findIndex((setting) => labelOf(setting) === labelOf(row.setting)),
      ...FIGURES.map((name) => row[name]),
    ]),
    result.misses,
  ];
}

/** The result from its packed form; null if any part is invalid, since links may come from
 * anyone. */
function lengthen(data: unknown): Result | null {
  if (!Array.isArray(data) || data[0] !== VERSION) return null;
  const [, texts, numbers, rows, misses] = data as unknown[];
  if (!Array.isArray(misses) || misses.length > 100 || !misses.every(isText)) return null;
  if (!isListOf(texts, TEXTS.length, isText)) return null;
  if (!isListOf(numbers, NUMBERS.length, isNumber)) return null;
  if (!Array.isArray(rows) || rows.length === 0 || rows.length > SETTINGS.length) return null;
  const found: SeriesRow[] = [];
  for (const row of rows as unknown[]) {
    if (!Array.isArray(row)) return null;
    const [place, ...figures] = row as unknown[];
    const setting = SETTINGS[place as number];
    const [typical, p99, worst, mean, own, steps] = figures;
    if (!setting || !isListOf([typical, p99, worst, mean, steps], 5, isNumber)) return null;
    if (own !== null && !isNumber(own)) return null;
    found.push({ setting, typical, p99, worst, mean, own, steps } as SeriesRow);
  }
  const named = (names: readonly string[], values: readonly unknown[]) =>
    Object.fromEntries(names.map((name, i) => [name, values[i]]));
  const result = { ...named(TEXTS, texts), ...named(NUMBERS, numbers), rows: found, uses: null, misses } as Result;
  return Number.isNaN(Date.parse(result.date)) ? null : result;
}

/** Whether a value is an array of this length whose elements all satisfy `is`. */
function isListOf<T>(list: unknown, length: number, is: (x: unknown) => x is T): list is T[] {
  return Array.isArray(list) && list.length === length && list.every(is);
}

const isText = (x: unknown): x is string => typeof x === "string" && x.length < 200;
const isNumber = (x: unknown): x is number =>
  typeof x === "number" && Number.isFinite(x) && x >= 0;
