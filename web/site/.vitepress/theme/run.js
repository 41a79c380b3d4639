/** A run of an example: a worker with its code, which sends a picture whenever it is asked for one. */

/**
 * Milliseconds after which an example whose worker does not answer is ended: its code runs without
 * an end. A worker that waits for a download answers, however long the download takes. Chosen.
 */
const PATIENCE = 5000;
/** Milliseconds from an answer of the worker to the next question whether it answers. Chosen. */
const PAUSE = 1000;

export class Run {
  paused = false;
  #worker = new Worker(new URL("./live-worker.js", import.meta.url), { type: "module" });
  #picture;
  #hear;
  #frame = 0;
  #last = 0;
  /** Of the next question, or of the patience with an answer. */
  #timer = 0;
  #waiting = false;
  #hand = null;

  /**
   * `hear.began` is called when the code has run to its end, `hear.printed` with each line that it
   * prints, `hear.failed` with the message of an error.
   */
  constructor(code, picture, hear) {
    this.#picture = picture;
    this.#hear = hear;
    this.#worker.onmessage = ({ data }) => this.#receive(data);
    this.#worker.onerror = ({ message }) => hear.failed(message || "The example does not start.");
    this.#ask({ code });
    this.#frame = requestAnimationFrame((now) => this.#tick(now));
  }

  end() {
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#timer);
    this.#worker.terminate();
    this.#worker = null;
  }

  /** Begins to drag the body under the pointer. */
  grab(event) {
    const { currentTarget: canvas, pointerId } = event;
    const move = (moved) => {
      this.#hand = this.#picture.placeOf(moved);
    };
    const leave = () => {
      this.#hand = null;
      canvas.removeEventListener("pointermove", move);
    };
    canvas.setPointerCapture(pointerId);
    canvas.addEventListener("pointermove", move);
    for (const end of ["pointerup", "pointercancel"])
      canvas.addEventListener(end, leave, { once: true });
    move(event);
  }

  #tick(now) {
    this.#frame = requestAnimationFrame((next) => this.#tick(next));
    const seconds = Math.min(0.1, (now - (this.#last || now)) / 1000);
    this.#last = now;
    if (this.#waiting) return;
    // Shapes are coloured in turn, so that one that leaves the picture must not leave the list.
    const { lower, upper } = this.#picture.region(4);
    this.#ask({ seconds: this.paused ? 0 : seconds, lower, upper, hand: this.#hand });
  }

  #ask(message) {
    this.#waiting = true;
    this.#worker.postMessage(message);
  }

  /** Asks the worker whether its code returns to the loop of events. */
  #watch() {
    this.#worker.postMessage({ answer: true });
    this.#timer = setTimeout(() => this.#hear.failed("The code does not answer and was ended."), PATIENCE);
  }

  #receive({ answered, printed, failed, shapes, lines }) {
    if (!this.#worker) return;
    if (answered) {
      clearTimeout(this.#timer);
      this.#timer = setTimeout(() => this.#watch(), PAUSE);
      return;
    }
    if (printed !== undefined) return this.#hear.printed(printed);
    if (failed) return this.#hear.failed(failed);
    this.#waiting = false;
    this.#hear.began();
    if (shapes) this.#picture.draw(shapes, lines);
  }
}
