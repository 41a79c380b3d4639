/**
 * Bodies by WebGL2: one instanced draw call. The poses go from wasm memory into a texture as they
 * are, and the vertex shader looks up its body's; no work per body is done in JavaScript.
 */
import type { Camera } from "../camera";
import type { Theme } from "./palette";
import { type Renderer, rowColour } from "./renderer";
import { CIRCLE, ROW, type Shapes, STATIC } from "./shapes";

const TEXTURE_WIDTH = 1024;
/** Bytes of an instance: ten floats of the row, and a colour. */
const STRIDE = 4 * ROW + 4;

const VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 head;  // slot, shape kind, body kind, sensor
layout(location = 2) in vec4 place; // offset, half extents
layout(location = 3) in vec2 turn;
layout(location = 4) in vec4 colour;
layout(location = 5) in float awake;
uniform sampler2D poses;
uniform vec2 scale;  // metres to clip space
uniform vec2 shift;
uniform float pixels; // device pixels a metre
out vec2 local;
out vec2 upright;
flat out vec2 extent;
flat out vec4 tint;
flat out vec4 traits; // circle, fixed, sensor, awake

vec2 rotate(vec2 r, vec2 v) { return vec2(r.x * v.x - r.y * v.y, r.y * v.x + r.x * v.y); }

void main() {
  int slot = int(head.x);
  vec4 pose = texelFetch(poses, ivec2(slot % ${TEXTURE_WIDTH}, slot / ${TEXTURE_WIDTH}), 0);
  bool circle = head.y == ${CIRCLE}.0;
  extent = circle ? place.zz : place.zw;
  vec2 rotation = rotate(pose.zw, turn);
  local = corner * (extent + 1.0 / pixels);
  upright = rotate(rotation, local);
  vec2 at = pose.xy + rotate(pose.zw, place.xy) + upright;
  tint = colour;
  traits = vec4(circle ? 1.0 : 0.0, head.z == ${STATIC}.0 ? 1.0 : 0.0, head.w, awake);
  gl_Position = isnan(pose.x) ? vec4(2.0, 2.0, 0.0, 1.0) : vec4(at * scale + shift, 0.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec2 local;
in vec2 upright;
flat in vec2 extent;
flat in vec4 tint;
flat in vec4 traits;
uniform float pixels;
uniform vec3 sleep;
out vec4 result;

void main() {
  bool circle = traits.x > 0.5;
  bool fixedBody = traits.y > 0.5;
  float size = min(extent.x, extent.y);
  float inside; // metres to the surface, negative inside
  if (circle) {
    inside = length(local) - extent.x;
  } else {
    float corner = fixedBody ? 0.0 : 0.16 * size;
    vec2 q = abs(local) - extent + corner;
    inside = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - corner;
  }
  float cover = clamp(0.5 - inside * pixels, 0.0, 1.0);
  float depth = -inside * pixels;
  float sizeInPixels = size * pixels;

  // Light from above, softer on what does not move.
  float reach = circle ? extent.x : length(extent) * 0.75;
  float light = clamp(upright.y / reach, -1.0, 1.0);
  vec3 base = tint.rgb * (1.0 + (fixedBody ? 0.05 : 0.14) * light);
  if (circle) base *= 1.06 - 0.12 * dot(local, local) / (extent.x * extent.x);

  // A darker rim keeps neighbours apart; it fades where bodies are a few pixels small.
  float width = clamp(sizeInPixels * 0.14, 0.8, 2.4);
  float rim = (1.0 - smoothstep(width - 0.6, width + 0.6, depth)) * smoothstep(1.5, 5.0, sizeInPixels);
  base *= 1.0 - (fixedBody ? 0.18 : 0.34) * rim;

  // A bead near the rim shows how a circle turns.
  if (circle && sizeInPixels > 5.0 && !fixedBody) {
    float bead = length(local - vec2(0.56 * extent.x, 0.0)) - 0.17 * extent.x;
    base = mix(base, mix(base, vec3(1.0), 0.6), clamp(0.5 - bead * pixels, 0.0, 1.0));
  }

  if (traits.w < 0.5 && !fixedBody) base = mix(base, sleep, 0.55);
  float alpha = cover * (traits.z > 0.5 ? 0.28 : 1.0);
  result = vec4(base * alpha, alpha);
}`;

export class WebglRenderer implements Renderer {
  readonly name = "webgl2";
  readonly #gl: WebGL2RenderingContext;
  readonly #canvas: HTMLCanvasElement;
  #program!: WebGLProgram;
  #instances!: WebGLBuffer;
  #awake!: WebGLBuffer;
  #uniforms!: Record<"poses" | "scale" | "shift" | "pixels" | "sleep", WebGLUniformLocation>;
  #rows = 0;
  #count = 0;
  #ratio = 1;
  #sleep: readonly number[] = [0, 0, 0];

  /** Null where WebGL2 is missing. */
  static create(canvas: HTMLCanvasElement): WebglRenderer | null {
    const gl = canvas.getContext("webgl2", { alpha: true, antialias: false, depth: false });
    if (!gl) return null;
    try {
      return new WebglRenderer(canvas, gl);
    } catch (error) {
      console.warn("WebGL2 cannot be used:", error);
      return null;
    }
  }

  private constructor(canvas: HTMLCanvasElement, gl: WebGL2RenderingContext) {
    this.#canvas = canvas;
    this.#gl = gl;
    this.#setUp();
  }

  #setUp(): void {
    const gl = this.#gl;
    this.#program = link(gl, VERTEX, FRAGMENT);
    const uniform = (name: string) => gl.getUniformLocation(this.#program, name)!;
    this.#uniforms = {
      poses: uniform("poses"),
      scale: uniform("scale"),
      shift: uniform("shift"),
      pixels: uniform("pixels"),
      sleep: uniform("sleep"),
    };
    gl.bindVertexArray(gl.createVertexArray());
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);

    this.#instances = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#instances);
    const perInstance = (location: number, size: number, type: number, at: number) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, type, type === gl.UNSIGNED_BYTE, STRIDE, at);
      gl.vertexAttribDivisor(location, 1);
    };
    perInstance(1, 4, gl.FLOAT, 0);
    perInstance(2, 4, gl.FLOAT, 16);
    perInstance(3, 2, gl.FLOAT, 32);
    perInstance(4, 4, gl.UNSIGNED_BYTE, 40);

    this.#awake = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#awake);
    gl.enableVertexAttribArray(5);
    gl.vertexAttribPointer(5, 1, gl.UNSIGNED_BYTE, false, 0, 0);
    gl.vertexAttribDivisor(5, 1);

    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.useProgram(this.#program);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    this.#rows = 0;
  }

  resize(width: number, height: number, ratio: number): void {
    this.#canvas.width = Math.round(width * ratio);
    this.#canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
    this.#gl.viewport(0, 0, this.#canvas.width, this.#canvas.height);
  }

  setShapes(shapes: Shapes, theme: Theme): void {
    const gl = this.#gl;
    this.#count = shapes.count;
    this.#sleep = theme.sleep.map((value) => value / 255);
    const data = new ArrayBuffer(Math.max(1, shapes.count) * STRIDE);
    const bytes = new Uint8Array(data);
    const floats = new Float32Array(data);
    for (let i = 0; i < shapes.count; i++) {
      floats.set(shapes.rows.subarray(i * ROW, (i + 1) * ROW), (i * STRIDE) / 4);
      bytes.set([...rowColour(shapes, i, theme).map(Math.round), 255], i * STRIDE + 4 * ROW);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#instances);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    this.setAwake(new Uint8Array(Math.max(1, shapes.count)).fill(1));
    const rows = Math.max(1, Math.ceil(shapes.slots / TEXTURE_WIDTH));
    if (rows > this.#rows) {
      this.#rows = Math.max(rows, 2 * this.#rows);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, TEXTURE_WIDTH, this.#rows, 0, gl.RGBA, gl.FLOAT, null);
    }
  }

  setAwake(awake: Uint8Array): void {
    const gl = this.#gl;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#awake);
    gl.bufferData(gl.ARRAY_BUFFER, awake, gl.DYNAMIC_DRAW);
  }

  draw(poses: Float32Array, camera: Camera): void {
    const gl = this.#gl;
    if (gl.isContextLost()) return;
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT);
    if (this.#count === 0) return;
    this.#upload(poses);
    const { poses: sampler, scale, shift, pixels, sleep } = this.#uniforms;
    gl.uniform1i(sampler, 0);
    gl.uniform2f(scale, (2 * camera.scale) / camera.width, (2 * camera.scale) / camera.height);
    gl.uniform2f(
      shift,
      (2 * camera.middleX) / camera.width - 1,
      1 - (2 * camera.middleY) / camera.height,
    );
    gl.uniform1f(pixels, camera.scale * this.#ratio);
    gl.uniform3f(sleep, this.#sleep[0], this.#sleep[1], this.#sleep[2]);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.#count);
  }

  #upload(poses: Float32Array): void {
    const gl = this.#gl;
    const count = Math.min(poses.length / 4, this.#rows * TEXTURE_WIDTH);
    const full = Math.floor(count / TEXTURE_WIDTH);
    const rest = count - full * TEXTURE_WIDTH;
    const put = (y: number, width: number, height: number) =>
      gl.texSubImage2D(
        gl.TEXTURE_2D, 0, 0, y, width, height, gl.RGBA, gl.FLOAT, poses, 4 * y * TEXTURE_WIDTH,
      );
    if (full > 0) put(0, TEXTURE_WIDTH, full);
    if (rest > 0) put(full, rest, 1);
  }
}

function link(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type)!;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
      throw new Error(gl.getShaderInfoLog(shader) ?? "a shader does not compile");
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS))
    throw new Error(gl.getProgramInfoLog(program) ?? "the shaders do not link");
  return program;
}
