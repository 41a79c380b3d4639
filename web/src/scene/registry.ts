/** The scenes in the page's menu, in its order, as their modules say. */
import titles from "virtual:scene-titles";

export const GROUPS: readonly string[] = Object.keys(titles);

export interface SceneEntry {
  /** The name of the module's file, as in the page's address: lower case and underscores. */
  name: string;
  title: string;
  group: string;
}

export const SCENES: readonly SceneEntry[] = GROUPS.flatMap((group) =>
  Object.entries(titles[group]!).map(([name, title]) => ({ name, title, group })),
);

/** The scene that a visitor sees first. */
export { FIRST_SCENE } from "./first";

export function findScene(name: string): SceneEntry | undefined {
  return SCENES.find((scene) => scene.name === name);
}

/** The address of the scene's module, relative to the page's. */
export function sceneFile(name: string): string {
  return `scenes/${name}.js`;
}

/** The address of the scene's picture, relative to the page's. */
export function thumbnailFile(name: string): string {
  return `thumbs/${name}.svg`;
}
