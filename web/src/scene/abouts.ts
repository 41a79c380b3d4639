/**
 * By the name of a scene, one sentence that says what to look at. Gathered from the scene modules
 * by tools/scene-texts.mjs, and loaded after the first picture.
 */
import abouts from "virtual:scene-abouts";

export const ABOUTS: Readonly<Record<string, string>> = abouts;
