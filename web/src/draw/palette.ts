/** Colours of the canvases in both themes. The colours of controls are in the style sheets. */
import type { Ink } from "../scene/scene";

export type Rgb = readonly [red: number, green: number, blue: number];

export interface Theme {
  readonly dark: boolean;
  readonly skyTop: string;
  readonly skyBottom: string;
  readonly grid: string;
  readonly gridStrong: string;
  readonly soilTop: string;
  readonly soilBottom: string;
  /** A translucent colour, which darkens the soil below each of its layers. */
  readonly layer: string;
  readonly turf: string;
  readonly grass: string;
  readonly fixed: Rgb;
  readonly kinematic: Rgb;
  readonly sensor: Rgb;
  /** The colour that colours of sleeping bodies are mixed with. */
  readonly sleep: Rgb;
  /** The outline of Box2D's bodies over those of thud. */
  readonly box2d: Rgb;
  readonly inks: Readonly<Record<Ink, string>>;
  /** Colours of filled shapes, where they may be brighter than text and lines of the same ink. */
  readonly fills: Readonly<Partial<Record<Ink, string>>>;
  /** The outline around text and thin lines, which keeps them readable over anything. */
  readonly halo: string;
  /**
   * Colours of the engine's debug drawing by the name of the style. Styles that are not here get
   * one by their number.
   */
  readonly styles: Readonly<Record<string, string>>;
  readonly joints: JointInks;
  /** A Minkowski sum of shapes that are apart, and of shapes that overlap. */
  readonly sum: string;
  readonly sumOverlapping: string;
}

/** Colours of joints. */
export interface JointInks {
  /** Rods, pins, plates and rails; and the edge around them. */
  readonly metal: string;
  readonly edge: string;
  readonly rope: string;
  readonly spring: string;
  readonly gear: string;
  /** Rubber bands (kind "target"), marks of joints that are open, and arrows of forces. */
  readonly band: string;
  readonly open: string;
  readonly force: string;
}

/** Colours of dynamic bodies, from the first that was created to the last. */
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
  skyBottom: "#1a2433",
  grid: "rgba(148, 170, 210, 0.045)",
  gridStrong: "rgba(148, 170, 210, 0.10)",
  soilTop: "#303a48",
  soilBottom: "#181e29",
  layer: "rgba(6, 9, 16, 0.14)",
  turf: "#2f6b4d",
  grass: "#6fcf8e",
  fixed: [66, 80, 104],
  kinematic: [122, 142, 178],
  sensor: [104, 211, 197],
  sleep: [38, 48, 66],
  box2d: [255, 92, 214],
  inks: {
    ink: "#eef2f9",
    soft: "#9fb0cb",
    accent: "#ff9468",
    good: "#6ee7a0",
    bad: "#ff8080",
    gold: "#ffd166",
    water: "#4fb3ee",
    player: "#ff9d5c",
    rival: "#6cc4ff",
  },
  fills: {},
  halo: "#0f1521",
  styles: {
    bounds: "rgba(125, 211, 252, 0.75)",
    cell: "rgba(167, 139, 250, 0.45)",
    contact: "#ffe08a",
    normal: "#ff8fa3",
    interval: "#4dd0e1",
    "interval overlapping": "#ffd166",
    pair: "rgba(176, 190, 197, 0.8)",
    "pair touching": "#ffd166",
    "pair candidate": "rgba(129, 140, 248, 0.85)",
    "solved directly": "#ffffff",
    manifold: "#ffe08a",
    depth: "#ff6b6b",
    impulse: "#7cf5c4",
    motion: "#f78fb3",
    joint: "rgba(226, 234, 247, 0.7)",
    "joint axis": "#7dd3fc",
    "joint limit": "#ffd166",
  },
  joints: {
    metal: "#dbe4f2",
    edge: "#0f1521",
    rope: "#e6c68f",
    spring: "#8fd8ff",
    gear: "rgba(226, 234, 247, 0.55)",
    band: "#ff9468",
    open: "#ff5f7a",
    force: "#7cf5c4",
  },
  sum: "#7cf5c4",
  sumOverlapping: "#ff8fa3",
};

export const LIGHT: Theme = {
  dark: false,
  skyTop: "#f3f7fc",
  skyBottom: "#faf6ef",
  grid: "rgba(60, 80, 120, 0.055)",
  gridStrong: "rgba(60, 80, 120, 0.12)",
  soilTop: "#cfc6b8",
  soilBottom: "#e9e3d9",
  layer: "rgba(120, 96, 60, 0.07)",
  turf: "#8fc49a",
  grass: "#3f8f58",
  fixed: [150, 163, 184],
  kinematic: [92, 110, 142],
  sensor: [20, 150, 138],
  sleep: [208, 212, 219],
  box2d: [190, 0, 140],
  inks: {
    ink: "#1b2230",
    soft: "#56637a",
    accent: "#b8431f",
    good: "#14713c",
    bad: "#c22727",
    gold: "#8a5a00",
    water: "#1673b5",
    player: "#b5480c",
    rival: "#1f63b8",
  },
  fills: { gold: "#eab020", water: "#2f93d8" },
  halo: "#fbfaf7",
  styles: {
    bounds: "rgba(2, 100, 170, 0.75)",
    cell: "rgba(109, 40, 217, 0.40)",
    contact: "#8a2be2",
    normal: "#d6336c",
    interval: "#0b7285",
    "interval overlapping": "#c76a00",
    pair: "rgba(73, 80, 87, 0.8)",
    "pair touching": "#c76a00",
    "pair candidate": "rgba(67, 56, 202, 0.8)",
    "solved directly": "#1b2230",
    manifold: "#8a2be2",
    depth: "#c92a2a",
    impulse: "#087f5b",
    motion: "#c2255c",
    joint: "rgba(27, 34, 48, 0.7)",
    "joint axis": "#0264aa",
    "joint limit": "#a35200",
  },
  joints: {
    metal: "#2b3546",
    edge: "#fbfaf7",
    rope: "#7a4f16",
    spring: "#14599c",
    gear: "rgba(27, 34, 48, 0.6)",
    band: "#b8431f",
    open: "#c8102e",
    force: "#087f5b",
  },
  sum: "#087f5b",
  sumOverlapping: "#d6336c",
};

/** The colour of RAMP at t, from 0 to 1, interpolated linearly. */
export function rampColour(t: number): Rgb {
  const at = Math.min(1, Math.max(0, t)) * (RAMP.length - 1);
  const i = Math.min(RAMP.length - 2, Math.floor(at));
  return mix(RAMP[i], RAMP[i + 1], at - i);
}

/** The linear interpolation from a (t = 0) to b (t = 1). */
export function mix(a: Rgb, b: Rgb, t: number): Rgb {
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
}

/** A CSS colour, with each channel multiplied by `factor`. */
export function cssColour(colour: Rgb, factor = 1, alpha = 1): string {
  const part = (value: number) => Math.min(255, Math.round(value * factor));
  return `rgb(${part(colour[0])} ${part(colour[1])} ${part(colour[2])} / ${alpha})`;
}

/**
 * A colour for a number (an island, a solver colour). Hues of successive numbers are the golden
 * angle apart, so that small numbers get distinct hues.
 */
export function classColour(number: number, dark: boolean): Rgb {
  return hslColour((number * 137.508) % 360, 0.62, dark ? 0.62 : 0.54);
}

/** A colour by hue in degrees, saturation and lightness from 0 to 1: CSS Color 4, section 7.1. */
function hslColour(hue: number, saturation: number, lightness: number): Rgb {
  const reach = saturation * Math.min(lightness, 1 - lightness);
  const channel = (n: number) => {
    const k = (n + hue / 30) % 12;
    return 255 * (lightness - reach * Math.max(-1, Math.min(k - 3, 9 - k, 1)));
  };
  return [channel(0), channel(8), channel(4)];
}
