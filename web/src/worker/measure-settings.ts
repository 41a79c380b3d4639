/** What "Measure" compares, and how often "Heavier" wants a step. */
import type { Quality } from "thud";

/** Steps a second. */
export const RATES = [60, 120, 240] as const;

/** How Box2D is set; see Box2DOptions. */
export interface Box2DSetting {
  substeps: number;
  contactHertz?: number;
}

export interface ThudSetting {
  engine: "thud";
  quality: Quality;
  /** 0: the quality's. */
  substeps: number;
}

export type SeriesSetting = ThudSetting | ({ engine: "box2d" } & Box2DSetting);

export const THUD: readonly ThudSetting[] = [
  { engine: "thud", quality: "draft", substeps: 0 },
  { engine: "thud", quality: "default", substeps: 0 },
  { engine: "thud", quality: "high", substeps: 0 },
  { engine: "thud", quality: "exact", substeps: 0 },
  // Draft alone has no direct solver: with more substeps it shows what those do by themselves.
  { engine: "thud", quality: "draft", substeps: 4 },
  { engine: "thud", quality: "draft", substeps: 8 },
  { engine: "thud", quality: "draft", substeps: 16 },
];

/** From 8 substeps on Box2D gains by stiffer contacts only, of which it takes so many at most. */
export const BOX2D: readonly SeriesSetting[] = [
  { engine: "box2d", substeps: 1 },
  { engine: "box2d", substeps: 2 },
  { engine: "box2d", substeps: 4 },
  { engine: "box2d", substeps: 8 },
  { engine: "box2d", substeps: 16 },
  { engine: "box2d", substeps: 8, contactHertz: 60 },
  { engine: "box2d", substeps: 16, contactHertz: 120 },
];

export function labelOf(setting: SeriesSetting): string {
  const { substeps } = setting;
  if (setting.engine === "box2d")
    return `Box2D ${substeps}${setting.contactHertz ? " stiff" : ""}`;
  return substeps > 0 ? `soft ${substeps}` : setting.quality;
}
