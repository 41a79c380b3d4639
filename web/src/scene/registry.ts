/** The scenes that the page offers, in the order in which it offers them: as their modules say. */
import titles from "virtual:scene-titles";

export const GROUPS: readonly string[] = Object.keys(titles);

export interface SceneEntry {
  /** As in an address: lower case and underscores. */
  name: string;
  title: string;
  group: string;
}

export const SCENES: readonly SceneEntry[] = GROUPS.flatMap((group) =>
  Object.entries(titles[group]!).map(([name, title]) => ({ name, title, group })),
);

/** What a visitor sees first. */
export { FIRST_SCENE } from "./first";

export function findScene(name: string): SceneEntry | undefined {
  return SCENES.find((scene) => scene.name === name);
}

/** The address of its module, relative to the page's. */
export function sceneFile(name: string): string {
  return `scenes/${name}.js`;
}

/** The address of its picture, relative to the page's. */
export function thumbnailFile(name: string): string {
  return `thumbs/${name}.svg`;
}
