/** Hands a terrain line to the module, for the calls of geometry/. */
import type { Engine } from "../engine.js";
import { ThudError } from "../error.js";
import { withLine } from "../terrain-line.js";
import type { Terrain } from "../types.js";
import { checkGeometry } from "./pair.js";

/** Sets the module's line for the time of `use`, a call of it, whose result is checked. */
export function onLine(engine: Engine, call: string, line: Terrain, use: () => number): void {
  const result = withLine(engine, call, line, (...fields) => {
    if (engine.exports.api_line_set(...fields) !== 0)
      throw new ThudError(
        "invalid",
        `${call}: a line has two or more vertices, x increases strictly, and all numbers are in range`,
      );
    return use();
  });
  checkGeometry(call, result);
}
