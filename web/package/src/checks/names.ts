/** Refuses options with an unknown name, so that a misspelt option is not ignored. */
import { ThudError } from "../error.js";
import { checkValue, nearest, shown } from "./hook.js";

type Names = readonly string[];

/**
 * Throws "invalid" where `options` is no object, where an option is in neither `names` nor `others`
 * (the message has the nearest name), and where a value is not of its option's type.
 */
export function checkOptions(
  what: string,
  options: object,
  names: Names,
  others: Names = [],
): void {
  if (typeof options !== "object" || options === null)
    throw new ThudError("invalid", `${what}: options are an object: ${shown(options)}`);
  // Unlike Object.keys this loop allocates nothing.
  for (const name in options) {
    if (!names.includes(name) && !others.includes(name)) refuse(what, name, [...names, ...others]);
    checkValue(what, name, options);
  }
}

function refuse(what: string, name: string, names: Names): never {
  throw new ThudError("invalid", `${what}: no option is called "${name}"${nearest(name, names)}`);
}
