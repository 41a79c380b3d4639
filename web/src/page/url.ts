/**
 * The page's state in its address: the scene, its size and seed, what was chosen and is not the
 * usual, the camera, and after the # the visitor's own code or level, which no server ever sees.
 */
import { BROADPHASES, DETECTIONS, QUALITIES } from "thud";
import { OVERLAYS, type OverlayName } from "../scene/overlays";
import type { Choices } from "../worker/protocol";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4] as const;
export const DETECTION_CHOICES = ["auto", ...DETECTIONS] as const;
/** In length scales; 0 is none. */
export const MAX_ERRORS = [0, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001] as const;

/** That a link may ask to be compared after: a minute. */
const MOST_STEPS = 3600;

export const USUAL: Choices = {
  quality: "default",
  substeps: 0,
  detection: "auto",
  broadphase: "grid",
  maxError: 0,
};

/** How Box2D is shown beside thud, or as outlines over it. */
export const SPLITS = ["side", "over", "none"] as const;
/** Of Box2D; 4 is what its manual recommends. */
export const BOX2D_SUBSTEPS = [1, 2, 4, 8, 16] as const;

export interface Versus {
  split: (typeof SPLITS)[number];
  substeps: (typeof BOX2D_SUBSTEPS)[number];
}

export const USUAL_VERSUS: Versus = { split: "side", substeps: 4 };

/** What is shown over the bodies, unless chosen. */
export const USUAL_OVERLAYS: readonly OverlayName[] = ["sleeping"];

/** Bytes of a scene's or level's text that an address may bring. */
const LONGEST_TEXT = 2 ** 20;
/** Letters of a packed level that an address may have: longer ones are cut where they are sent. */
export const LONGEST_LEVEL = 32_000;

export interface Place {
  x: number;
  y: number;
  /** CSS pixels a world unit. */
  scale: number;
}

/** What an address may ask for: CSS pixels a world unit, and world units from the origin. */
const SCALES = [1e-9, 1e9] as const;
const FARTHEST = 1e9;

export interface Claim {
  /** From the scene's beginning, with nobody's hands in it. */
  step: number;
  hash: string;
}

/** A level that the visitor brought. */
export interface OwnLevel {
  /** Of its file. */
  name: string;
  /** Texts by the names that the scene reads them by. */
  files: Record<string, string>;
}

export interface State {
  scene: string;
  /** Of the scene that runs levels of visitors. */
  level: OwnLevel | null;
  size?: number;
  seed: number;
  choices: Choices;
  versus: Versus;
  speed: number;
  paused: boolean;
  /** Without those that the scene is about. */
  overlays: readonly OverlayName[];
  /** Null: as the scene says. */
  camera: Place | null;
  code: string | null;
  /** Figures measured elsewhere, packed; see panels/trade/result.ts. */
  result: string | null;
  /** An open panel. */
  panel: string | null;
  /** What the state's hash was on the machine of whoever sent the link. */
  claim: Claim | null;
}

function oneOf<T extends string | number>(known: readonly T[], text: string | null): T | undefined {
  return known.find((value) => String(value) === text);
}

function wholeIn(text: string | null, least: number, most: number): number | undefined {
  if (text === null || !/^\d{1,9}$/.test(text)) return undefined;
  const number = Number(text);
  return number >= least && number <= most ? number : undefined;
}

/**
 * What an address says; what it says wrongly is as if it were not there, but damaged code, which
 * is null.
 */
export async function readState(address: URL): Promise<Partial<State>> {
  const params = address.searchParams;
  const state: Partial<State> = {};
  // Links to levels looked so once.
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
  if (show) state.overlays = OVERLAYS.filter((name) => show.includes(name));
  state.camera = readPlace(params.get("view"));
  const step = wholeIn(params.get("step"), 1, MOST_STEPS);
  const hash = params.get("hash");
  if (step && hash && /^[0-9a-f]{16}$/.test(hash)) state.claim = { step, hash };
  const after = new URLSearchParams(address.hash.slice(1));
  const packed = after.get("code");
  if (packed !== null) state.code = await unpack(packed);
  state.result = after.get("result");
  const level = after.get("level");
  if (level !== null) state.level = await unpackLevel(level);
  return state;
}

export async function writeState(state: State): Promise<string> {
  const { scene, size, seed, choices, versus, speed, paused, overlays, camera, panel, claim } =
    state;
  const params = new URLSearchParams({ scene });
  const put = (name: string, value: string | number, usual: string | number) => {
    if (value !== usual) params.set(name, String(value));
  };
  if (size !== undefined) params.set("size", String(size));
  put("seed", seed, 0);
  put("quality", choices.quality, USUAL.quality);
  put("substeps", choices.substeps, USUAL.substeps);
  put("detection", choices.detection, USUAL.detection);
  put("broadphase", choices.broadphase, USUAL.broadphase);
  put("error", choices.maxError, USUAL.maxError);
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
  if (state.result !== null) after.push(`result=${state.result}`);
  const level = state.level && (await packLevel(state.level));
  if (level) after.push(`level=${level}`);
  const hash = after.length > 0 ? `#${after.join("&")}` : "";
  return `?${params.toString().replaceAll("%2C", ",")}${hash}`;
}

const packedLevels = new WeakMap<OwnLevel, Promise<string>>();

/** Null if it is too long for an address. */
async function packLevel(level: OwnLevel): Promise<string | null> {
  // Addresses are written often.
  if (!packedLevels.has(level)) packedLevels.set(level, pack(JSON.stringify(level)));
  const packed = await packedLevels.get(level)!.catch(() => "");
  return packed.length <= LONGEST_LEVEL ? packed : null;
}

async function unpackLevel(packed: string): Promise<OwnLevel | null> {
  try {
    const { name, files } = JSON.parse((await unpack(packed)) ?? "") as OwnLevel;
    const texts = [name, ...Object.values(files)];
    return texts.every((text) => typeof text === "string") ? { name, files } : null;
  } catch {
    return null;
  }
}

function readPlace(text: string | null): Place | null {
  const numbers = (text ?? "").split(",").map(Number);
  if (numbers.length !== 3 || !numbers.every(Number.isFinite)) return null;
  const [x, y, scale] = numbers;
  if (Math.abs(x) > FARTHEST || Math.abs(y) > FARTHEST) return null;
  const [least, most] = SCALES;
  return scale >= least && scale <= most ? { x, y, scale } : null;
}

/** To a hundredth of a pixel. */
function placeText({ x, y, scale }: Place): string {
  const digits = Math.max(0, Math.ceil(Math.log10(scale)) + 2);
  return `${x.toFixed(digits)},${y.toFixed(digits)},${Number(scale.toPrecision(5))}`;
}

/** A text as letters that an address may hold: deflated, base64 with - and _. */
export async function pack(text: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  const packed = await through(bytes, new CompressionStream("deflate-raw"));
  let binary = "";
  for (const byte of packed) binary += String.fromCharCode(byte);
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** Null if it is damaged or too long. */
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

/** Throws where more comes out than any scene is long: a short address may hold gigabytes. */
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
