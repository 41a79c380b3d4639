/** A measured series with where it was measured, as text, as a file and as part of an address. */
import type { App } from "../../page/app";
import { pack, unpack, writeState } from "../../page/url";
import type { Series, SeriesRow } from "../../worker/measure";
import { BOX2D, labelOf, type SeriesSetting, THUD } from "../../worker/measure-settings";
import { missesText } from "../misses";
import { choicesText, countText, errorText, plainTime } from "./text";

export interface Result extends Series {
  /** Of the scene, with its size. */
  title: string;
  /** Detection, broadphase and code, where they are not the usual. */
  setUp: string;
  browser: string;
  processors: number;
  /** ISO, to the minute. */
  date: string;
}

export function describeResult(app: App, series: Series): Result {
  const { scene, state } = app;
  const size = scene?.sizes ? ` (${countText(scene.size)} ${scene.sizes.means})` : "";
  const { detection, broadphase } = state.choices;
  const choices = { ...state.choices, quality: "default" as const, substeps: 0, maxError: 0 };
  const unusual = detection === "auto" && broadphase === "grid" ? [] : [choicesText(choices)];
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

/** To four digits, which is more than is measured and keeps links short. */
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

/** "Firefox 140 on Linux": no more of the browser than a reader needs. */
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

export function titleOf({ title, setUp }: Result): string {
  return setUp ? `${title}, ${setUp}` : title;
}

export function whereMeasured({ browser, processors, date }: Result): string {
  const day = new Date(date).toLocaleDateString("en", { dateStyle: "long" });
  return `${browser}, ${processors} processors, ${day}`;
}

export const COLUMNS = ["setting", "ms", "p99", "worst", "mean"] as const;

/** As in COLUMNS. */
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

/** A table in plain text. */
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

/** An address that shows the result again, with the scene that it is of. */
export async function resultLink(app: App, result: Result): Promise<string> {
  const packed = await pack(JSON.stringify(shorten(result)));
  const address = await writeState({ ...app.state, panel: "trade", result: packed });
  return new URL(address, location.href).href;
}

/** Null if it is damaged. */
export async function readResult(packed: string): Promise<Result | null> {
  try {
    return lengthen(JSON.parse((await unpack(packed)) ?? "null"));
  } catch {
    return null;
  }
}

const SETTINGS: readonly SeriesSetting[] = [...THUD, ...BOX2D];
/** Links of the first say nothing of what Box2D was not given, and are not shown. */
const VERSION = 2;
const FIGURES = ["typical", "p99", "worst", "mean", "own", "steps"] as const;
const TEXTS = ["title", "setUp", "browser", "date", "withoutBox2D"] as const;
const NUMBERS = ["processors", "timeStep", "bodies", "steps"] as const;

/**
 * Version, texts, numbers, for each row its setting's place in SETTINGS and its figures, and what
 * Box2D was not given.
 */
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

/** Trusts nothing: anyone can make a link. */
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
  const result = { ...named(TEXTS, texts), ...named(NUMBERS, numbers), rows: found, misses } as Result;
  return Number.isNaN(Date.parse(result.date)) ? null : result;
}

function isListOf<T>(list: unknown, length: number, is: (x: unknown) => x is T): list is T[] {
  return Array.isArray(list) && list.length === length && list.every(is);
}

const isText = (x: unknown): x is string => typeof x === "string" && x.length < 200;
const isNumber = (x: unknown): x is number =>
  typeof x === "number" && Number.isFinite(x) && x >= 0;
