/** Colours of the drawing, in both themes. Controls have theirs in style.css. */

export type Rgb = readonly [red: number, green: number, blue: number];

export interface Theme {
  readonly dark: boolean;
  readonly skyTop: string;
  readonly skyBottom: string;
  readonly grid: string;
  readonly gridStrong: string;
  readonly groundTop: string;
  readonly groundBottom: string;
  readonly groundLine: string;
  /** Colours of moving bodies, from the first one created to the last. */
  readonly ramp: readonly Rgb[];
  readonly fixed: Rgb;
  readonly kinematic: Rgb;
  readonly sensor: Rgb;
  /** What sleeping bodies fade towards. */
  readonly sleep: Rgb;
  readonly contact: string;
  readonly normal: string;
  readonly bounds: string;
  readonly cell: string;
  readonly interval: string;
  readonly pair: string;
  readonly touching: string;
  readonly motion: string;
  readonly sum: string;
  readonly pull: string;
  readonly character: string;
}

const RAMP: readonly Rgb[] = [
  [239, 83, 80],
  [245, 124, 82],
  [250, 173, 99],
  [250, 214, 145],
  [170, 214, 176],
  [88, 184, 190],
  [66, 141, 205],
  [98, 105, 200],
  [141, 94, 184],
];

export const DARK: Theme = {
  dark: true,
  skyTop: "#0b0f17",
  skyBottom: "#1a2231",
  grid: "rgba(148, 170, 210, 0.045)",
  gridStrong: "rgba(148, 170, 210, 0.10)",
  groundTop: "#2b3648",
  groundBottom: "#141a25",
  groundLine: "#7f95b8",
  ramp: RAMP,
  fixed: [64, 78, 102],
  kinematic: [122, 142, 178],
  sensor: [104, 211, 197],
  sleep: [38, 48, 66],
  contact: "#ffe08a",
  normal: "#ff8fa3",
  bounds: "rgba(125, 211, 252, 0.75)",
  cell: "rgba(167, 139, 250, 0.45)",
  interval: "#4dd0e1",
  pair: "rgba(176, 190, 197, 0.8)",
  touching: "#ffd166",
  motion: "#f78fb3",
  sum: "#7cf5c4",
  pull: "#ffffff",
  character: "#ff8a5c",
};

export const LIGHT: Theme = {
  dark: false,
  skyTop: "#f7f5f0",
  skyBottom: "#e6ebf2",
  grid: "rgba(60, 80, 120, 0.05)",
  gridStrong: "rgba(60, 80, 120, 0.11)",
  groundTop: "#c3ccd9",
  groundBottom: "#dfe5ed",
  groundLine: "#5f7391",
  ramp: RAMP,
  fixed: [150, 163, 184],
  kinematic: [92, 110, 142],
  sensor: [20, 150, 138],
  sleep: [205, 212, 222],
  contact: "#8a2be2",
  normal: "#d6336c",
  bounds: "rgba(2, 100, 170, 0.75)",
  cell: "rgba(109, 40, 217, 0.40)",
  interval: "#0b7285",
  pair: "rgba(73, 80, 87, 0.8)",
  touching: "#c76a00",
  motion: "#c2255c",
  sum: "#087f5b",
  pull: "#1b2230",
  character: "#d9480f",
};

/** A colour of the ramp; t from 0 to 1. */
export function rampColour(theme: Theme, t: number): Rgb {
  const at = Math.min(1, Math.max(0, t)) * (theme.ramp.length - 1);
  const i = Math.min(theme.ramp.length - 2, Math.floor(at));
  const mix = at - i;
  const [a, b] = [theme.ramp[i], theme.ramp[i + 1]];
  return [0, 1, 2].map((k) => a[k] + (b[k] - a[k]) * mix) as unknown as Rgb;
}

export function cssColour(colour: Rgb, factor = 1): string {
  const part = (value: number) => Math.min(255, Math.round(value * factor));
  return `rgb(${part(colour[0])} ${part(colour[1])} ${part(colour[2])})`;
}

/** A distinct colour for every island, by the golden angle. */
export function islandColour(island: number, dark: boolean): string {
  return `hsl(${(island * 137.508) % 360} 70% ${dark ? 62 : 48}%)`;
}
