/** `Proof` runs a scene in a worker of its own and returns hashes of its state; references for them
 * were computed when the page was built (web/tools/hashes.mjs). */
import type { ChosenWasm } from "../../wasm/choose";
import { Client } from "../../page/client";
import { type State, USUAL } from "../../page/url";
import type { SceneRequest, StateHash } from "../../worker/protocol";
import known from "../../../generated/hashes.json";

/** Hashes of a scene on the machine that built the page. */
export interface Reference {
  hashes: readonly StateHash[];
  /** The hash in the native engine of the same scene at this size; null if there is none. */
  native: { size: number; step: number; hash: string } | null;
}

/** A scene's entry in hashes.json. */
interface Known {
  hashes: string[];
  native?: { size: number; hash: string };
}

/** Steps from one reference hash to the next. */
export const EVERY = known.every;

/** The reference of a scene; null if it has none, as a visitor's own scene. */
export function referenceOf(scene: string): Reference | null {
  const found = (known.scenes as Record<string, Known | undefined>)[scene];
  if (!found) return null;
  return {
    hashes: found.hashes.map((hash, i) => ({ step: (i + 1) * EVERY, hash })),
    native: found.native ? { ...found.native, step: known.nativeSteps } : null,
  };
}

/** Whether the reference holds for a state: size, seed, code and all choices are the defaults. */
export function isUsual({ size, seed, code, choices, scene }: State): boolean {
  const chosen = Object.keys(USUAL) as (keyof typeof USUAL)[];
  return (
    size === undefined &&
    seed === 0 &&
    code === null &&
    referenceOf(scene) !== null &&
    chosen.every((name) => choices[name] === USUAL[name])
  );
}

/** Steps in one question to the worker, after which progress is reported. Chosen. */
const PART = 20;

/** A worker that makes steps and returns hashes. */
export class Proof {
  readonly #client = new Client({
    frame: () => {},
    trouble: () => {},
    // No message: the visitor sees the progress and can stop the check.
    stuck: () => {},
  });

  constructor(private readonly wasm: ChosenWasm) {}

  /** Runs the scene from its beginning and returns the hashes after these steps, which ascend.
   * `progress` is called with the number of steps made. */
  async run(
    request: SceneRequest,
    steps: readonly number[],
    progress: (step: number) => void,
  ): Promise<StateHash[]> {
    await this.#client.load(this.wasm);
    await this.#client.ask("run", request);
    const hashes: StateHash[] = [];
    let made = 0;
    for (const step of steps)
      while (made < step) {
        const next = Math.min(step, made + PART);
        const answer = await this.#client.ask("advance", { steps: next - made });
        made = next;
        progress(made);
        if (made === step) hashes.push(answer);
      }
    return hashes;
  }

  /** Terminates the worker; a `run` that has not finished rejects. */
  close(): void {
    this.#client.close();
  }
}

/** The step of the first hash that differs from the reference; null if all are equal. */
export function firstDifference(
  hashes: readonly StateHash[],
  reference: readonly StateHash[],
): number | null {
  return hashes.find(({ hash }, i) => hash !== reference[i].hash)?.step ?? null;
}
