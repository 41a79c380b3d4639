/** The overlays: what can be drawn over the bodies. */
export const OVERLAYS = [
  "contacts",
  "normals",
  "bounds",
  "cells",
  "islands",
  "sleeping",
  "stages",
  "axes",
  "pairs",
  "motions",
  "colours",
  "sums",
  "impulses",
  "joints",
] as const;
export type OverlayName = (typeof OVERLAYS)[number];
