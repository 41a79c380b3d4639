/** A run of an example: a worker with its code, which sends a picture whenever it is asked for one. */

/** Milliseconds after which an example that does not answer is ended. Chosen. */
const PATIENCE = 5000;

export class Run {
  paused = false;
  #worker = new Worker(new URL("./live-worker.js", import.meta.url), { type: "module" });
  #picture;
  #hear;
  #frame = 0;
  #last = 0;
  #timer = 0;
  #waiting = false;
  #hand = null;

  /** `hear`: called with each line that the code prints, and with the message of an error. */
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
    this.#timer = setTimeout(() => this.#hear.failed("The code does not answer and was ended."), PATIENCE);
  }

  #receive({ printed, failed, shapes, lines }) {
    if (!this.#worker) return;
    if (printed !== undefined) return this.#hear.printed(printed);
    clearTimeout(this.#timer);
    if (failed) return this.#hear.failed(failed);
    this.#waiting = false;
    if (shapes) this.#picture.draw(shapes, lines);
  }
}
