/// <reference types="vite/client" />

/** Titles of scenes by name by group; see tools/scene-texts.mjs. */
declare module "virtual:scene-titles" {
  const titles: Readonly<Record<string, Readonly<Record<string, string>>>>;
  export default titles;
}

/** What to look at, by the scene's name. */
declare module "virtual:scene-abouts" {
  const abouts: Readonly<Record<string, string>>;
  export default abouts;
}
