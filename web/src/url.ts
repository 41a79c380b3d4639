/** The page's state in its URL: ?scene=pyramid or ?level=quarry, and what is not the default. */
import {
  type Broadphase,
  BROADPHASES,
  type Detection,
  DETECTIONS,
  QUALITIES,
  type Quality,
} from "thud";

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2] as const;

export interface State {
  kind: "scene" | "level";
  name: string;
  quality: Quality;
  detection: Detection;
  broadphase: Broadphase;
  speed: number;
  paused: boolean;
}

export function readState(search: string): Partial<State> {
  const params = new URLSearchParams(search);
  const state: Partial<State> = {};
  const level = params.get("level");
  const name = level ?? params.get("scene");
  if (name) Object.assign(state, { kind: level ? "level" : "scene", name });
  const quality = QUALITIES.find((known) => known === params.get("quality"));
  if (quality) state.quality = quality;
  const detection = DETECTIONS.find((known) => known === params.get("detection"));
  if (detection) state.detection = detection;
  const broadphase = BROADPHASES.find((known) => known === params.get("broadphase"));
  if (broadphase) state.broadphase = broadphase;
  const speed = SPEEDS.find((known) => String(known) === params.get("speed"));
  if (speed) state.speed = speed;
  if (params.has("paused")) state.paused = params.get("paused") !== "0";
  return state;
}

export function writeState(state: State): void {
  const params = new URLSearchParams({ [state.kind]: state.name });
  if (state.quality !== "default") params.set("quality", state.quality);
  if (state.detection !== "continuous") params.set("detection", state.detection);
  if (state.broadphase !== "grid") params.set("broadphase", state.broadphase);
  if (state.speed !== 1) params.set("speed", String(state.speed));
  if (state.paused) params.set("paused", "1");
  history.replaceState(null, "", `?${params}`);
}
