/** Runs a scene once more, in a worker of its own, for the hashes of its state. */
import type { ChosenWasm } from "../../wasm/choose";
import { Client } from "../../page/client";
import { type State, USUAL } from "../../page/url";
import type { SceneRequest, StateHash } from "../../worker/protocol";
import known from "../../../generated/hashes.json";

/** What a scene came to where the page was built. */
export interface Reference {
  hashes: readonly StateHash[];
  /** The native engine's, of the same scene, for this size. */
  native: { size: number; step: number; hash: string } | null;
}

interface Known {
  hashes: string[];
  native?: { size: number; hash: string };
}

export const EVERY = known.every;

/** Null for a scene of the visitor's own. */
export function referenceOf(scene: string): Reference | null {
  const found = (known.scenes as Record<string, Known | undefined>)[scene];
  if (!found) return null;
  return {
    hashes: found.hashes.map((hash, i) => ({ step: (i + 1) * EVERY, hash })),
    native: found.native ? { ...found.native, step: known.nativeSteps } : null,
  };
}

/** Whether a reference holds: nothing is chosen that changes what happens. */
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

/** Steps between two signs of life. */
const PART = 20;

/** A worker that makes steps and tells hashes. */
export class Proof {
  readonly #client = new Client({
    frame: () => {},
    trouble: () => {},
    // Whoever does not want to wait ends it.
    stuck: () => {},
  });

  constructor(private readonly wasm: ChosenWasm) {}

  /** Hashes of a new world after these steps, which rise. */
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

  /** Ends the worker; what runs is rejected. */
  close(): void {
    this.#client.close();
  }
}

/** Where the first difference is; null without one. */
export function firstDifference(
  hashes: readonly StateHash[],
  reference: readonly StateHash[],
): number | null {
  return hashes.find(({ hash }, i) => hash !== reference[i].hash)?.step ?? null;
}
