/** The settings that "Measure" compares, and the step rates that "Heavier" offers. */
import type { Quality } from "thud";

/** Steps per second. */
export const RATES = [60, 120, 240] as const;

/** Settings of Box2D; see Box2DOptions. */
export interface Box2DSetting {
  substeps: number;
  contactHertz?: number;
}

/** Settings of a thud world. */
export interface ThudSetting {
  engine: "thud";
  quality: Quality;
  /** 0: that of the quality. */
  substeps: number;
}

export type SeriesSetting = ThudSetting | ({ engine: "box2d" } & Box2DSetting);

/** thud's settings in "Measure". */
export const THUD: readonly ThudSetting[] = [
  { engine: "thud", quality: "draft", substeps: 0 },
  { engine: "thud", quality: "default", substeps: 0 },
  { engine: "thud", quality: "high", substeps: 0 },
  { engine: "thud", quality: "exact", substeps: 0 },
  // Only draft has no direct solver: with more substeps it shows what substeps alone achieve.
  { engine: "thud", quality: "draft", substeps: 4 },
  { engine: "thud", quality: "draft", substeps: 8 },
  { engine: "thud", quality: "draft", substeps: 16 },
];

/**
 * Box2D limits the contact frequency to an eighth of its substep rate; from 8 substeps on, more
 * substeps gain accuracy only with stiffer contacts, which the last two settings have.
 */
export const BOX2D: readonly SeriesSetting[] = [
  { engine: "box2d", substeps: 1 },
  { engine: "box2d", substeps: 2 },
  { engine: "box2d", substeps: 4 },
  { engine: "box2d", substeps: 8 },
  { engine: "box2d", substeps: 16 },
  { engine: "box2d", substeps: 8, contactHertz: 60 },
  { engine: "box2d", substeps: 16, contactHertz: 120 },
];

/** The setting's name in the table and the plot. */
export function labelOf(setting: SeriesSetting): string {
  const { substeps } = setting;
  if (setting.engine === "box2d")
    return `Box2D ${substeps}${setting.contactHertz ? " stiff" : ""}`;
  return substeps > 0 ? `soft ${substeps}` : setting.quality;
}
