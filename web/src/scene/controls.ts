/**
 * Controls that a scene has in the panel Values, and texts that are shown there. All are plain
 * data.
 */

/** A control sets the value of its `name` in the scene's `state`. */
export type Control = ChoiceControl | CheckControl | SliderControl | MatrixControl;

export interface ChoiceControl extends Named {
  kind: "choice";
  options: readonly { value: string; label: string }[];
}

export interface CheckControl extends Named {
  kind: "check";
  /** What the control shows, in a sentence. */
  about: string;
}

export interface SliderControl extends Named {
  kind: "slider";
  least: number;
  most: number;
  step: number;
}

/**
 * A table with one word for each pair of `names`. Its value is a string of digits, row by row: each
 * is the index of the pair's word in `words`.
 */
export interface MatrixControl extends Named {
  kind: "matrix";
  names: readonly string[];
  words: readonly string[];
  /** For a name with itself, only the first `alone` words can be chosen. */
  alone: number;
}

interface Named {
  name: string;
  label: string;
  /** Successive controls of one group stand under this heading. */
  group: string;
}

export type Setting = string | number | boolean;
export type Settings = Readonly<Record<string, Setting>>;

/** Rows of a name and a value, by the name of the control below which they are shown. */
export type Readings = Readonly<Record<string, readonly (readonly [name: string, value: string])[]>>;

/** The values of a scene's controls. */
export function settingsOf(controls: readonly Control[], state: object | undefined): Settings {
  const values = (state ?? {}) as Readonly<Record<string, Setting>>;
  return Object.fromEntries(controls.map(({ name }) => [name, values[name]]));
}
