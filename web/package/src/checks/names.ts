/** Options are known by name: a misspelt one must not be passed over in silence. */
import { ThudError } from "../error.js";
import { checkValue, nearest, shown } from "./hook.js";

type Names = readonly string[];

/** Throws for an option that is not among `names` and `others`, and tells the nearest that is. */
export function checkNames(what: string, options: object, names: Names, others: Names = []): void {
  if (typeof options !== "object" || options === null)
    throw new ThudError("invalid", `${what}: options are an object: ${shown(options)}`);
  // Unlike a list of keys this makes nothing.
  for (const name in options) {
    if (!names.includes(name) && !others.includes(name)) refuse(what, name, [...names, ...others]);
    checkValue(what, name, options);
  }
}

function refuse(what: string, name: string, names: Names): never {
  throw new ThudError("invalid", `${what}: no option is called "${name}"${nearest(name, names)}`);
}
