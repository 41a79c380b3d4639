/**
 * What to look at in each scene, in one sentence; by the scene's name. Gathered from the modules by
 * tools/scene-texts.mjs. Not needed at first.
 */
import abouts from "virtual:scene-abouts";

export const ABOUTS: Readonly<Record<string, string>> = abouts;
