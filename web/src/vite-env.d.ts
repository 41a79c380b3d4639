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

/** What a scene's text can use, read from the typings; see tools/code-names.mjs. */
declare module "virtual:code-names" {
  export const GROUPS: readonly {
    title: string;
    /** Where its names are offered: as they are, or only after a dot. */
    completes: "plain" | "member";
    /** An example or form, and what it does. */
    entries: readonly { name: string; form: string; meaning: string }[];
  }[];
}
