/**
 * The page's end of the messages to a physics worker (worker/protocol.ts): questions, which have
 * one answer each; commands, which have none; and ticks, each of which a frame answers.
 */
import type { Frame } from "../scene/frame";
import type { Command } from "../worker/commands";
import type {
  Look,
  Progress,
  QuestionName,
  Questions,
  ToPage,
  ToWorker,
  Trouble,
} from "../worker/protocol";
import type { ChosenWasm } from "../wasm/choose";

/** Milliseconds without a message from the worker after which it counts as stuck. Chosen; texts of
 * the page say "eight seconds". */
const STUCK = 8000;

/** The worker answered a question with an error. */
export class TroubleError extends Error {
  constructor(readonly trouble: Trouble) {
    super(trouble.message);
  }
}

/** A question has no answer because its worker was terminated, or failed to load or run; of a
 * failure `ClientListeners.trouble` is called too. */
export class EndedError extends Error {}

export interface ClientListeners {
  frame(frame: Frame): void;
  /** Run number `run` of a scene threw; the worker itself failed where there is no number. */
  trouble(trouble: Trouble, run?: number): void;
  /** An answer is due and no message came for STUCK; `close` or `restart` terminates the worker. */
  stuck(): void;
  /** A message has come after `stuck` was called. */
  answers?(): void;
}

/** A question whose answer has not come; `report` gets its progress messages. */
interface Waiting {
  resolve(value: unknown): void;
  reject(error: Error): void;
  report(progress: unknown): void;
}

/** One worker and the questions that wait for it. */
export class Client {
  readonly #listeners: ClientListeners;
  readonly #waiting = new Map<number, Waiting>();
  #worker: Worker;
  #asked = 0;
  #ticking = false;
  #timer = 0;
  #stuck = false;

  constructor(listeners: ClientListeners) {
    this.#listeners = listeners;
    this.#worker = this.#start();
  }

  /**
   * Loads the engine into the worker; must come before any other question. Resolves to its number
   * of threads.
   */
  load({ wasm, rest, threads }: ChosenWasm): Promise<number> {
    return this.ask("load", { wasm, rest, threads, page: document.baseURI });
  }

  /** Terminates the worker and creates another one, which must `load` the engine again. */
  restart(): void {
    this.close();
    this.#worker = this.#start();
  }

  /** Terminates the worker and rejects all open questions with `EndedError`. */
  close(): void {
    this.#worker.terminate();
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#ticking = this.#stuck = false;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const { reject } of waiting) reject(new EndedError("The physics worker was ended."));
  }

  /** Asks a question, with which `transfer` goes to the worker; rejects with `TroubleError` or `EndedError`. */
  ask<Name extends QuestionName>(
    name: Name,
    value: Questions[Name]["ask"],
    report: (progress: Progress<Name>) => void = () => {},
    transfer: Transferable[] = [],
  ): Promise<Questions[Name]["answer"]> {
    const id = ++this.#asked;
    const answer = new Promise<unknown>((resolve, reject) =>
      this.#waiting.set(id, { resolve, reject, report: (news) => report(news as Progress<Name>) }),
    );
    try {
      this.#send({ kind: "ask", id, name, value }, transfer);
    } catch (error) {
      // What cannot be sent is not waited for.
      this.#waiting.delete(id);
      return Promise.reject(error);
    }
    return answer as Promise<Questions[Name]["answer"]>;
  }

  /** Sends a command, which has no answer; an error in it is reported as `trouble`. */
  do(command: Command): void {
    this.#send({ kind: "command", command });
  }

  /** Whether a tick is unanswered; another one would only queue up. */
  get ticking(): boolean {
    return this.#ticking;
  }

  /** Requests steps of scene number `run` up to step `until`, and then a frame. */
  tick(run: number, until: number, look: Look): void {
    this.#ticking = true;
    this.#send({ kind: "tick", run, until, look });
  }

  /** Creates a worker. */
  #start(): Worker {
    const worker = new Worker(new URL("../worker/worker.ts", import.meta.url), {
      type: "module",
      name: "thud physics",
    });
    worker.onmessage = ({ data }: MessageEvent<ToPage>) => this.#receive(data);
    worker.onerror = (event) => {
      event.preventDefault();
      const message = event.message || "The physics worker could not be started.";
      for (const { reject } of this.#waiting.values()) reject(new EndedError(message));
      this.#waiting.clear();
      this.#listeners.trouble({ message });
    };
    return worker;
  }

  #send(message: ToWorker, transfer: Transferable[] = []): void {
    this.#worker.postMessage(message, transfer);
    if (message.kind !== "command" && this.#timer === 0) this.#watch();
  }

  /** Restarts the timeout that finds a stuck worker; stops it if no answer is due. */
  #watch(): void {
    clearTimeout(this.#timer);
    this.#timer =
      this.#ticking || this.#waiting.size > 0
        ? window.setTimeout(() => this.#tellStuck(), STUCK)
        : 0;
  }

  #tellStuck(): void {
    this.#stuck = true;
    this.#listeners.stuck();
  }

  /** Passes a message of the worker to the question or the listener that it is for. */
  #receive(message: ToPage): void {
    if (this.#stuck) this.#listeners.answers?.();
    this.#stuck = false;
    if (message.kind === "answer") {
      const waiting = this.#waiting.get(message.id);
      this.#waiting.delete(message.id);
      if (message.trouble) waiting?.reject(new TroubleError(message.trouble));
      else waiting?.resolve(message.value);
    } else if (message.kind === "progress") {
      this.#waiting.get(message.id)?.report(message.value);
    } else {
      this.#ticking = false;
      if (message.kind === "frame") this.#listeners.frame(message.frame);
      else this.#listeners.trouble(message.trouble, message.run);
    }
    this.#watch();
  }
}
