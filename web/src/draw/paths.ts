/** Collects many outlines of one style in as few paths as browsers draw quickly. */

/** Contours per path. Browsers are many times slower with far more or far fewer. */
export const CONTOURS = 64;

export class Paths {
  readonly #paths: Path2D[] = [];
  #contours = 0;

  /** The path that takes the next contour. */
  next(): Path2D {
    if (this.#contours++ % CONTOURS === 0) this.#paths.push(new Path2D());
    return this.#paths[this.#paths.length - 1];
  }

  stroke(context: CanvasRenderingContext2D): void {
    for (const path of this.#paths) context.stroke(path);
  }

  fill(context: CanvasRenderingContext2D): void {
    for (const path of this.#paths) context.fill(path);
  }
}

/** The paths of a key, created if there are none yet. */
export function pathsOf(all: Map<number, Paths>, key: number): Paths {
  const known = all.get(key);
  if (known) return known;
  const paths = new Paths();
  all.set(key, paths);
  return paths;
}
