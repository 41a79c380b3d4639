/** What a visitor sets beside a scene, in the panel Values, and what is read out there. Plain data. */

/** Its value is the one of that name in the scene's `state`. */
export type Control = ChoiceControl | CheckControl | SliderControl | MatrixControl;

export interface ChoiceControl extends Named {
  kind: "choice";
  options: readonly { value: string; label: string }[];
}

export interface CheckControl extends Named {
  kind: "check";
  /** What it shows, in a sentence. */
  about: string;
}

export interface SliderControl extends Named {
  kind: "slider";
  least: number;
  most: number;
  step: number;
}

/** A word for each two of `names`; its value has their numbers as digits, row by row. */
export interface MatrixControl extends Named {
  kind: "matrix";
  names: readonly string[];
  words: readonly string[];
  /** Of one with itself: the first so many words. */
  alone: number;
}

interface Named {
  name: string;
  label: string;
  /** Controls of one group, which follow each other, have it as their heading. */
  group: string;
}

export type Setting = string | number | boolean;
export type Settings = Readonly<Record<string, Setting>>;

/** Rows of a name and a value, by the name of the control that they stand under. */
export type Readings = Readonly<Record<string, readonly (readonly [name: string, value: string])[]>>;

/** The values of a scene's controls. */
export function settingsOf(controls: readonly Control[], state: object | undefined): Settings {
  const values = (state ?? {}) as Readonly<Record<string, Setting>>;
  return Object.fromEntries(controls.map(({ name }) => [name, values[name]]));
}
