/**
 * Draws the bodies by WebGL2, by one instanced call per pane. The poses of a frame are copied to
 * textures as they are; the vertex shader fetches and interpolates them, so that JavaScript does no
 * work per body.
 */
import type { Shapes } from "../scene/frame";
import { ROW } from "../scene/shape-table";
import type { Camera, Pane } from "./camera";
import type { Poses } from "./poses";
import { type Look, type Renderer, WEBGL } from "./renderer";
import { linkProgram, LOOKS, TEXTURE_WIDTH } from "./shaders";

/** Names of the uniforms; shaders.ts says what they are. */
const UNIFORMS = [
  "before", "now", "slots", "alpha", "offset", "scale", "shift", "pixels", "ratio", "look",
  "outlineColour",
] as const;
type Uniforms = Record<(typeof UNIFORMS)[number], WebGLUniformLocation | null>;

export class WebglRenderer implements Renderer {
  readonly name = "webgl2";
  readonly canvas: HTMLCanvasElement;
  readonly #gl: WebGL2RenderingContext;
  readonly #uniforms: Uniforms;
  readonly #rows: WebGLBuffer;
  readonly #stateColours: WebGLBuffer;
  readonly #plainColours: WebGLBuffer;
  readonly #states: Record<Poses["engine"], { before: PoseTexture; now: PoseTexture }>;
  /**
   * Number of rows to draw of thud's bodies (without those that the scene paints itself), and of
   * the other engine's.
   */
  #count = 0;
  #all = 0;
  #ratio = 1;

  /**
   * Null if WebGL2 is not available. After a context was restored, a new renderer is created on the
   * same canvas.
   */
  static create(canvas: HTMLCanvasElement): WebglRenderer | null {
    const gl = canvas.getContext("webgl2", WEBGL);
    if (!gl) return null;
    try {
      return new WebglRenderer(canvas, gl);
    } catch (error) {
      console.warn("WebGL2 cannot be used:", error);
      return null;
    }
  }

  private constructor(canvas: HTMLCanvasElement, gl: WebGL2RenderingContext) {
    this.canvas = canvas;
    this.#gl = gl;
    const program = linkProgram(gl);
    gl.useProgram(program);
    this.#uniforms = Object.fromEntries(
      UNIFORMS.map((name) => [name, gl.getUniformLocation(program, name)]),
    ) as Uniforms;
    gl.bindVertexArray(gl.createVertexArray());
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    this.#rows = instanceBuffer(gl, gl.FLOAT, 4 * ROW, [
      { location: 1, size: 4, offset: 0 },
      { location: 2, size: 4, offset: 16 },
      { location: 3, size: 2, offset: 32 },
    ]);
    const colour = { size: 4, offset: 0 };
    this.#stateColours = instanceBuffer(gl, gl.UNSIGNED_BYTE, 4, [{ location: 4, ...colour }]);
    this.#plainColours = instanceBuffer(gl, gl.UNSIGNED_BYTE, 4, [{ location: 5, ...colour }]);
    const states = () => ({ before: new PoseTexture(gl), now: new PoseTexture(gl) });
    this.#states = { thud: states(), box2d: states() };
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.enable(gl.SCISSOR_TEST);
  }

  resize(width: number, height: number, ratio: number): void {
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
  }

  setShapes(shapes: Shapes): void {
    this.#count = shapes.count;
    this.#all = shapes.all;
    const data = shapes.rows.subarray(0, shapes.all * ROW);
    this.#fill(this.#rows, data, this.#gl.STATIC_DRAW);
  }

  setColours(state: Uint8Array, plain: Uint8Array): void {
    this.#fill(this.#stateColours, state, this.#gl.DYNAMIC_DRAW);
    this.#fill(this.#plainColours, plain, this.#gl.STATIC_DRAW);
  }

  #fill(buffer: WebGLBuffer, data: Float32Array | Uint8Array, usage: number): void {
    this.#gl.bindBuffer(this.#gl.ARRAY_BUFFER, buffer);
    this.#gl.bufferData(this.#gl.ARRAY_BUFFER, data, usage);
  }

  clear(): void {
    const gl = this.#gl;
    gl.scissor(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
  }

  draw(poses: Poses, camera: Camera, pane: Pane, look: Look): void {
    const gl = this.#gl;
    if (gl.isContextLost() || this.#all === 0) return;
    const ratio = this.#ratio;
    const { before, now } = this.#states[poses.engine];
    before.hold(0, poses.before);
    now.hold(1, poses.now);

    // WebGL counts rows of pixels from the bottom.
    const left = Math.round(pane.left * ratio);
    const right = Math.round((pane.left + pane.width) * ratio);
    const top = Math.round(pane.top * ratio);
    const bottom = Math.round((pane.top + pane.height) * ratio);
    const box = [left, this.canvas.height - bottom, right - left, bottom - top] as const;
    gl.viewport(...box);
    gl.scissor(...box);

    const uniforms = this.#uniforms;
    gl.uniform1i(uniforms.before, 0);
    gl.uniform1i(uniforms.now, 1);
    gl.uniform2i(uniforms.slots, poses.before.length / 4, poses.now.length / 4);
    gl.uniform1f(uniforms.alpha, poses.alpha);
    gl.uniform2f(uniforms.offset, ...poses.offset);
    gl.uniform2f(uniforms.scale, (2 * camera.scale) / pane.width, (2 * camera.scale) / pane.height);
    gl.uniform2f(
      uniforms.shift,
      (2 * (pane.middleX - pane.left)) / pane.width - 1,
      1 - (2 * (pane.middleY - pane.top)) / pane.height,
    );
    gl.uniform1f(uniforms.pixels, camera.scale * ratio);
    gl.uniform1f(uniforms.ratio, ratio);
    gl.uniform1i(uniforms.look, LOOKS[look.kind]);
    if (look.kind === "outline") {
      const [red, green, blue] = look.colour;
      gl.uniform3f(uniforms.outlineColour, red / 255, green / 255, blue / 255);
    }
    const rows = poses.engine === "thud" ? this.#count : this.#all;
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, rows);
  }
}

/** A buffer with `stride` bytes per instance, and the attributes that are read from it. */
function instanceBuffer(
  gl: WebGL2RenderingContext,
  type: number,
  stride: number,
  attributes: readonly { location: number; size: number; offset: number }[],
): WebGLBuffer {
  const buffer = gl.createBuffer();
  gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
  for (const { location, size, offset } of attributes) {
    gl.enableVertexAttribArray(location);
    gl.vertexAttribPointer(location, size, type, type === gl.UNSIGNED_BYTE, stride, offset);
    gl.vertexAttribDivisor(location, 1);
  }
  return buffer;
}

/** Poses in a texture, one per texel. */
class PoseTexture {
  readonly #gl: WebGL2RenderingContext;
  readonly #texture: WebGLTexture;
  #rows = 0;
  #held: Float32Array | null = null;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  }

  /**
   * Binds the texture to a texture unit, with these poses in it. The same array is uploaded only
   * once.
   */
  hold(unit: number, poses: Float32Array): void {
    const gl = this.#gl;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, this.#texture);
    if (this.#held === poses) return;
    this.#held = poses;
    const slots = Math.floor(poses.length / 4);
    this.#grow(Math.max(1, Math.ceil(slots / TEXTURE_WIDTH)));
    const full = Math.floor(slots / TEXTURE_WIDTH);
    const rest = slots - full * TEXTURE_WIDTH;
    if (full > 0) this.#put(0, TEXTURE_WIDTH, full, poses);
    if (rest > 0) this.#put(full, rest, 1, poses);
  }

  /** Makes room for so many rows of poses. */
  #grow(rows: number): void {
    if (rows <= this.#rows) return;
    this.#rows = Math.max(rows, 2 * this.#rows);
    const gl = this.#gl;
    gl.texImage2D(
      gl.TEXTURE_2D, 0, gl.RGBA32F, TEXTURE_WIDTH, this.#rows, 0, gl.RGBA, gl.FLOAT, null,
    );
  }

  /** Uploads rows of poses, from row y on. */
  #put(y: number, width: number, height: number, poses: Float32Array): void {
    const gl = this.#gl;
    const at = 4 * y * TEXTURE_WIDTH;
    gl.texSubImage2D(
      gl.TEXTURE_2D, 0, 0, y, width, height, gl.RGBA, gl.FLOAT, poses, at,
    );
  }
}
