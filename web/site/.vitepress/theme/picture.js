/** Draws a world's shapes and joints into a canvas, in the colours of the site. */

/** Numbers of a shape and of a line in the lists of `World.draw`. */
const SHAPE = 9;
const LINE = 5;
/** Styles of `World.draw` (DRAW_STYLES of the package). */
const STATIC = 0;
const KINEMATIC = 1;
const SLEEPING = 3;
const SENSOR = 4;
/** How much of the background is seen through a shape of some styles. */
const FAINT = { [SLEEPING]: 0.45, [SENSOR]: 0.25 };
/** Colours of dynamic bodies in turn, those of the page of scenes. */
const RAMP = ["#ef5350", "#f57c52", "#faad63", "#fad691", "#aad6b0", "#58b8be", "#428dcd", "#6269c8"];

export class Picture {
  #canvas;
  #middle;
  #width;

  /** `view`: "X,Y,WIDTH", the middle of the picture in the world, and how wide it is there. */
  constructor(canvas, view = "0,4,18") {
    this.#canvas = canvas;
    const [x, y, width] = view.split(",").map(Number);
    this.#middle = [x, y];
    this.#width = width;
  }

  /** Pixels of the style sheet for a unit of length. */
  get #scale() {
    return this.#canvas.clientWidth / this.#width;
  }

  /**
   * The lower left and upper right corners of what is shown, or of a region around its middle that
   * is so many times as large.
   */
  region(times = 1) {
    const [x, y] = this.#middle;
    const half = [this.#width / 2, this.#canvas.clientHeight / this.#scale / 2].map((one) => one * times);
    return { lower: [x - half[0], y - half[1]], upper: [x + half[0], y + half[1]] };
  }

  /** The place in the world under a pointer. */
  placeOf({ clientX, clientY }) {
    const { left, top } = this.#canvas.getBoundingClientRect();
    const { lower, upper } = this.region();
    return [lower[0] + (clientX - left) / this.#scale, upper[1] - (clientY - top) / this.#scale];
  }

  draw(shapes, lines) {
    const canvas = this.#canvas;
    const { clientWidth: width, clientHeight: height } = canvas;
    const ratio = devicePixelRatio;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const context = canvas.getContext("2d");
    const style = getComputedStyle(canvas);
    const colour = (name) => style.getPropertyValue(name);
    const scale = this.#scale;
    const [x, y] = this.#middle;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.setTransform(
      ratio * scale,
      0,
      0,
      -ratio * scale,
      ratio * (width / 2 - x * scale),
      ratio * (height / 2 + y * scale),
    );
    context.lineWidth = 1.5 / scale;
    context.lineJoin = context.lineCap = "round";
    const fixed = { [STATIC]: "--live-fixed", [KINEMATIC]: "--live-moved", [SENSOR]: "--live-sensor" };
    const edge = colour("--live-edge");
    let count = 0;
    for (let at = 0; at < shapes.length; at += SHAPE) {
      const [cx, cy, hx, hy, cosine, sine, isCircle, kind] = shapes.subarray(at, at + SHAPE);
      const inTurn = RAMP[count++ % RAMP.length];
      context.save();
      context.transform(cosine, sine, -sine, cosine, cx, cy);
      context.beginPath();
      if (isCircle) context.arc(0, 0, hx, 0, 2 * Math.PI);
      else context.rect(-hx, -hy, 2 * hx, 2 * hy);
      context.globalAlpha = FAINT[kind] ?? 1;
      context.fillStyle = fixed[kind] ? colour(fixed[kind]) : inTurn;
      context.fill();
      context.globalAlpha = 1;
      context.strokeStyle = kind === SENSOR ? colour("--live-sensor") : edge;
      context.stroke();
      if (isCircle && kind !== SENSOR) {
        context.beginPath();
        context.moveTo(0, 0);
        context.lineTo(hx, 0);
        context.stroke();
      }
      context.restore();
    }
    context.strokeStyle = colour("--live-line");
    context.lineWidth = 2.5 / scale;
    context.beginPath();
    for (let at = 0; at < lines.length; at += LINE) {
      context.moveTo(lines[at], lines[at + 1]);
      context.lineTo(lines[at + 2], lines[at + 3]);
    }
    context.stroke();
  }
}
