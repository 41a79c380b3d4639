/**
 * Reads and writes the page's state as its address. Parameters hold the scene, its size and seed,
 * choices that differ from the defaults, and the camera; the part after the #, which browsers do
 * not send to servers, holds the visitor's code, level or measured result.
 */
import { BROADPHASES, DETECTIONS, QUALITIES } from "thud";
import { OVERLAYS, type OverlayName } from "../scene/overlays";
import type { Choices, Match, Recording } from "../worker/protocol";

/** Speeds that the page offers, in simulated seconds per second. */
export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;
export const DETECTION_CHOICES = ["auto", ...DETECTIONS] as const;
/** Limits of overlap that the page offers, in length scales (sizes of a typical body, which the
 * scene states); 0 is no limit. */
export const MAX_ERRORS = [0, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001] as const;

/** Steps per second, and greatest speeds in length scales per second, that the page offers; 0 is the
 * scene's own. */
export const STEP_RATES = [0, 15, 30, 60, 90, 120, 180, 240, 480, 1000] as const;
export const TOP_SPEEDS = [0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000] as const;

/** Greatest step whose hash a link may ask to compare: a minute at 60 Hz. Chosen. */
const MOST_STEPS = 3600;

/** The default choices, which the address leaves out. */
export const USUAL: Choices = {
  quality: "default",
  substeps: 0,
  detection: "auto",
  broadphase: "grid",
  maxError: 0,
  stepRate: 0,
  topSpeed: 0,
};

/** How Box2D is drawn: in a view beside thud's, as outlines over thud's bodies, or not at all. */
export const SPLITS = ["side", "over", "none"] as const;
/** Numbers of substeps of Box2D that the page offers; its manual recommends 4. */
export const BOX2D_SUBSTEPS = [1, 2, 4, 8, 16] as const;

/** Choices of the panel Versus. */
export interface Versus {
  split: (typeof SPLITS)[number];
  substeps: (typeof BOX2D_SUBSTEPS)[number];
}

export const USUAL_VERSUS: Versus = { split: "side", substeps: 4 };

/** Overlays that are shown until the visitor chooses others. */
export const USUAL_OVERLAYS: readonly OverlayName[] = ["sleeping"];

/** Bytes that a text in an address may have when unpacked. Chosen. */
const LONGEST_TEXT = 2 ** 20;
/** Characters of a packed level in an address at most: programs through which links are sent cut
 * longer ones. Chosen. */
export const LONGEST_LEVEL = 32_000;

/** A place of the camera: the point of the world in the middle of the view, and the scale. */
export interface Place {
  x: number;
  y: number;
  /** CSS pixels a world unit. */
  scale: number;
}

/** The range of `Place.scale`, and of its distance from the origin along either axis in world
 * units, that an address may ask for. Chosen. */
const SCALES = [1e-9, 1e9] as const;
const FARTHEST = 1e9;

/** A link's statement of what the state's hash was on its sender's machine. */
export interface Claim {
  /** Steps from the scene's beginning, without any input. */
  step: number;
  hash: string;
}

/** A level from the visitor's files; see own-level.ts. */
export interface OwnLevel {
  /** The map's file name without its ending. */
  name: string;
  /** Texts by the names under which the scene reads them. */
  files: Record<string, string>;
}

/** All that the address can hold. */
export interface State {
  scene: string;
  /** The level of the scene "own_level", which runs levels of visitors; null in other scenes. */
  level: OwnLevel | null;
  /** What the scene "recording" plays, which no address holds; null in other scenes. */
  recording: Recording | null;
  /** The match that the scene is played in, which no address holds; null: none. */
  match: Match | null;
  /** A packed invitation to a match, or the answer to one; see panels/match/invitation.ts. */
  invite: string | null;
  /** The scene's size, such as a number of bodies; undefined: the scene's usual size. */
  size?: number;
  seed: number;
  choices: Choices;
  versus: Versus;
  speed: number;
  paused: boolean;
  /** The chosen overlays, without those that only the scene asks for. */
  overlays: readonly OverlayName[];
  /** Where the visitor has moved the view; null: the scene's own view. */
  camera: Place | null;
  /** The visitor's code in place of the scene's file; null: the file. */
  code: string | null;
  /** A packed result of "Measure" that came with the link; see panels/trade/result.ts. */
  result: string | null;
  /** The name of the open panel. */
  panel: string | null;
  claim: Claim | null;
}

/** The value of a list that a text stands for; undefined if it is none of them. */
function oneOf<T extends string | number>(known: readonly T[], text: string | null): T | undefined {
  return known.find((value) => String(value) === text);
}

/** The whole number that a text stands for; undefined if it is none or out of range. */
function wholeIn(text: string | null, least: number, most: number): number | undefined {
  if (text === null || !/^\d{1,9}$/.test(text)) return undefined;
  const number = Number(text);
  return number >= least && number <= most ? number : undefined;
}

/** The state in an address. Invalid parts are left out or replaced by defaults; damaged code and a
 * damaged level are null. */
export async function readState(address: URL): Promise<Partial<State>> {
  const params = address.searchParams;
  const state: Partial<State> = {};
  // Older links name a level's scene with the parameter "level".
  const scene = params.get("scene") ?? params.get("level");
  if (scene) state.scene = scene;
  state.size = wholeIn(params.get("size"), 1, 1e6);
  state.seed = wholeIn(params.get("seed"), 0, 999_999_999) ?? 0;
  state.choices = {
    quality: oneOf(QUALITIES, params.get("quality")) ?? USUAL.quality,
    substeps: wholeIn(params.get("substeps"), 1, 64) ?? USUAL.substeps,
    detection: oneOf(DETECTION_CHOICES, params.get("detection")) ?? USUAL.detection,
    broadphase: oneOf(BROADPHASES, params.get("broadphase")) ?? USUAL.broadphase,
    maxError: oneOf(MAX_ERRORS, params.get("error")) ?? USUAL.maxError,
    stepRate: oneOf(STEP_RATES, params.get("rate")) ?? USUAL.stepRate,
    topSpeed: oneOf(TOP_SPEEDS, params.get("top")) ?? USUAL.topSpeed,
  };
  state.versus = {
    split: oneOf(SPLITS, params.get("split")) ?? USUAL_VERSUS.split,
    substeps: oneOf(BOX2D_SUBSTEPS, params.get("box2d")) ?? USUAL_VERSUS.substeps,
  };
  const speed = oneOf(SPEEDS, params.get("speed"));
  if (speed) state.speed = speed;
  if (params.has("paused")) state.paused = params.get("paused") !== "0";
  state.panel = params.get("panel");
  const show = params.get("show")?.split(",");
  state.overlays = show ? OVERLAYS.filter((name) => show.includes(name)) : USUAL_OVERLAYS;
  state.camera = readPlace(params.get("view"));
  const step = wholeIn(params.get("step"), 1, MOST_STEPS);
  const hash = params.get("hash");
  if (step && hash && /^[0-9a-f]{16}$/.test(hash)) state.claim = { step, hash };
  const after = new URLSearchParams(address.hash.slice(1));
  const packed = after.get("code");
  if (packed !== null) state.code = await unpack(packed);
  state.result = after.get("result");
  state.invite = after.get("invite");
  const level = after.get("level");
  if (level !== null) state.level = await unpackLevel(level);
  return state;
}

/** The address of a state, from its ? on. */
export async function writeState(state: State): Promise<string> {
  const { scene, size, seed, choices, versus, speed, paused, overlays, camera, panel, claim } =
    state;
  const params = new URLSearchParams({ scene });
  const put = (name: string, value: string | number, usual: string | number) => {
    if (value !== usual) params.set(name, String(value));
  };
  // In a match the size is the number of its players. The address leaves it out, so that a reload
  // runs the usual size.
  if (size !== undefined && !state.match) params.set("size", String(size));
  put("seed", seed, 0);
  put("quality", choices.quality, USUAL.quality);
  put("substeps", choices.substeps, USUAL.substeps);
  put("detection", choices.detection, USUAL.detection);
  put("broadphase", choices.broadphase, USUAL.broadphase);
  put("error", choices.maxError, USUAL.maxError);
  put("rate", choices.stepRate, USUAL.stepRate);
  put("top", choices.topSpeed, USUAL.topSpeed);
  put("split", versus.split, USUAL_VERSUS.split);
  put("box2d", versus.substeps, USUAL_VERSUS.substeps);
  put("speed", speed, 1);
  if (paused) params.set("paused", "1");
  put("show", overlays.join(), USUAL_OVERLAYS.join());
  if (panel) params.set("panel", panel);
  if (camera) params.set("view", placeText(camera));
  if (claim) {
    params.set("step", String(claim.step));
    params.set("hash", claim.hash);
  }
  const after = [];
  if (state.code !== null) after.push(`code=${await pack(state.code)}`);
  if (state.invite !== null) after.push(`invite=${state.invite}`);
  if (state.result !== null) after.push(`result=${state.result}`);
  const level = state.level && (await packLevel(state.level));
  if (level) after.push(`level=${level}`);
  const hash = after.length > 0 ? `#${after.join("&")}` : "";
  return `?${params.toString().replaceAll("%2C", ",")}${hash}`;
}

/** Levels that were packed, each once, since the address is written often. */
const packedLevels = new WeakMap<OwnLevel, Promise<string>>();

/** A level as text for an address; null if that is longer than LONGEST_LEVEL. */
async function packLevel(level: OwnLevel): Promise<string | null> {
  if (!packedLevels.has(level)) packedLevels.set(level, pack(JSON.stringify(level)));
  const packed = await packedLevels.get(level)!.catch(() => "");
  return packed.length <= LONGEST_LEVEL ? packed : null;
}

/** The level from such a text; null if the text is damaged. */
async function unpackLevel(packed: string): Promise<OwnLevel | null> {
  try {
    const { name, files } = JSON.parse((await unpack(packed)) ?? "") as OwnLevel;
    const texts = [name, ...Object.values(files)];
    return texts.every((text) => typeof text === "string") ? { name, files } : null;
  } catch {
    return null;
  }
}

/** The camera's place "x,y,scale"; null if the text is none or out of range. */
function readPlace(text: string | null): Place | null {
  const numbers = (text ?? "").split(",").map(Number);
  if (numbers.length !== 3 || !numbers.every(Number.isFinite)) return null;
  const [x, y, scale] = numbers;
  if (Math.abs(x) > FARTHEST || Math.abs(y) > FARTHEST) return null;
  const [least, most] = SCALES;
  return scale >= least && scale <= most ? { x, y, scale } : null;
}

/** The text "x,y,scale" of a place, exact to a hundredth of a CSS pixel. */
function placeText({ x, y, scale }: Place): string {
  const digits = Math.max(0, Math.ceil(Math.log10(scale)) + 2);
  return `${x.toFixed(digits)},${y.toFixed(digits)},${Number(scale.toPrecision(5))}`;
}

/** A text in characters that an address may contain: deflated, then base64 with - and _ in place of
 * + and /. */
export async function pack(text: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  const packed = await through(bytes, new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of packed) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The text that `pack` has packed; null if it is damaged or longer than LONGEST_TEXT. */
export async function unpack(packed: string): Promise<string | null> {
  try {
    const binary = atob(packed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
    const text = await through(bytes, new DecompressionStream("deflate-raw"));
    return new TextDecoder("utf-8", { fatal: true }).decode(text);
  } catch {
    return null;
  }
}

/** Compresses or decompresses bytes. Throws if the result is longer than LONGEST_TEXT, since a
 * short address may decompress to gigabytes. */
async function through(
  bytes: Uint8Array<ArrayBuffer>,
  stream: CompressionStream | DecompressionStream,
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts: BlobPart[] = [];
  let length = 0;
  for (let next = await reader.read(); next.value; next = await reader.read()) {
    parts.push(next.value);
    length += next.value.length;
    if (length > LONGEST_TEXT) {
      await reader.cancel();
      throw new RangeError("too long");
    }
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
