/**
 * The GLSL of the WebGL2 renderer. Each shape is one instance of a quad. The vertex shader fetches
 * the two poses of the shape's body, interpolates them (poseBetween of poses.ts) and places the
 * quad; the fragment shader computes the signed distance to the shape's surface, and from it
 * coverage, shade and rim.
 *
 * An outline is not drawn of static bodies, because they are at the same places in both engines.
 * `isNumber` tests the bits of a float, because compilers of shaders may assume that isnan is
 * false. A shape that is smaller than a pixel is enlarged, so that it remains visible.
 */
import { LEAST_LENGTH } from "./poses";
import { OUTLINE } from "./renderer";
import { CIRCLE, DYNAMIC, STATIC } from "../scene/shape-table";

/** Poses per row of a texture of poses. */
export const TEXTURE_WIDTH = 1024;
/** Values of the uniform `look`; see Look in renderer.ts. */
export const LOOKS = { state: 0, plain: 1, outline: 2 } as const;

const VERTEX = `#version 300 es
precision highp float;
precision highp int;
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 head;  // slot, shape kind, body kind, sensor
layout(location = 2) in vec4 place; // offset, half extents
layout(location = 3) in vec2 turn;
layout(location = 4) in vec4 stateColour;
layout(location = 5) in vec4 plainColour;
uniform highp sampler2D before;
uniform highp sampler2D now;
uniform ivec2 slots;  // in the two textures
uniform float alpha;
uniform vec2 offset;  // metres from the camera to the poses' origin
uniform vec2 scale;   // metres to clip space
uniform vec2 shift;
uniform float pixels; // device pixels a metre
uniform int look;
uniform vec3 outlineColour;
out vec2 local;
out vec2 upright;
flat out vec2 extent;
flat out vec4 tint;
flat out int circle;
flat out int free;

vec2 rotate(vec2 r, vec2 v) { return vec2(r.x * v.x - r.y * v.y, r.y * v.x + r.x * v.y); }

// By its bits: a compiler may take isnan for false.
bool isNumber(float x) { return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u; }

vec4 poseBetween(int slot, vec4 last) {
  if (slot >= slots.x) return last;
  vec4 first = texelFetch(before, ivec2(slot % ${TEXTURE_WIDTH}, slot / ${TEXTURE_WIDTH}), 0);
  if (!isNumber(first.x)) return last;
  vec4 between = mix(first, last, alpha);
  float size = length(between.zw);
  return vec4(between.xy, size > ${LEAST_LENGTH} ? between.zw / size : last.zw);
}

void main() {
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
  int slot = int(head.x);
  // Static bodies stand where the other engine's stand.
  if (slot >= slots.y || (look == ${LOOKS.outline} && head.z == ${STATIC}.0)) return;
  vec4 last = texelFetch(now, ivec2(slot % ${TEXTURE_WIDTH}, slot / ${TEXTURE_WIDTH}), 0);
  if (!isNumber(last.x)) return;
  vec4 pose = poseBetween(slot, last);
  circle = head.y == ${CIRCLE}.0 ? 1 : 0;
  free = head.z == ${DYNAMIC}.0 ? 1 : 0;
  // What is smaller than a pixel can still be seen.
  extent = max(circle == 1 ? place.zz : place.zw, 0.6 / pixels);
  vec2 rotation = rotate(pose.zw, turn);
  local = corner * (extent + 1.5 / pixels);
  upright = rotate(rotation, local);
  vec2 at = pose.xy + offset + rotate(pose.zw, place.xy) + upright;
  tint = look == ${LOOKS.state} ? stateColour : plainColour;
  if (look == ${LOOKS.outline}) tint = vec4(outlineColour, 1.0);
  gl_Position = vec4(at * scale + shift, 0.0, 1.0);
}`;

const FRAGMENT = `#version 300 es
precision highp float;
precision highp int;
in vec2 local;
in vec2 upright;
flat in vec2 extent;
flat in vec4 tint;
flat in int circle;
flat in int free;
uniform float pixels;
uniform float ratio; // device pixels a CSS pixel
uniform int look;
out vec4 result;

void main() {
  float size = min(extent.x, extent.y);
  float surface; // metres to it, negative inside
  if (circle == 1) {
    surface = length(local) - extent.x;
  } else {
    float corner = free == 1 ? min(0.14 * size, 5.0 * ratio / pixels) : 0.0;
    vec2 q = abs(local) - extent + corner;
    surface = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0) - corner;
  }
  float depth = -surface * pixels;
  float cover = clamp(0.5 + depth, 0.0, 1.0);
  if (look == ${LOOKS.outline}) {
    float part = ${OUTLINE.part} * size * pixels / ratio;
    float stroke = ratio * clamp(part, ${OUTLINE.least}, ${OUTLINE.most});
    cover *= clamp(0.5 + stroke - depth, 0.0, 1.0);
    result = vec4(tint.rgb * cover, cover);
    return;
  }

  // Light from above, softer on what does not move.
  float reach = circle == 1 ? extent.x : length(extent) * 0.75;
  float light = clamp(upright.y / reach, -1.0, 1.0);
  vec3 base = tint.rgb * (1.0 + (free == 1 ? 0.13 : 0.025) * light);
  if (circle == 1) base *= 1.06 - 0.12 * dot(local, local) / (extent.x * extent.x);

  // A darker rim keeps neighbours apart; it fades where bodies are a few pixels small.
  float small = size * pixels;
  float width = clamp(small * 0.12, 0.9, 1.6 * ratio);
  float rim = (1.0 - smoothstep(width - 0.6, width + 0.6, depth)) * smoothstep(1.5, 5.0, small);
  base *= 1.0 - (free == 1 ? 0.38 : 0.16) * rim;
  // Inside it a bright line where the light meets the edge.
  if (free == 1) {
    float line = 1.0 - smoothstep(0.4, 1.0, abs(depth - width - 0.8) / ratio);
    base += 0.12 * line * max(light, 0.0) * smoothstep(6.0, 14.0, small);
  }

  // A bead near the rim shows how a circle turns.
  if (circle == 1 && small > 5.0 && free == 1) {
    float bead = length(local - vec2(0.58 * extent.x, 0.0)) - 0.15 * extent.x;
    base = mix(base, mix(base, vec3(1.0), 0.65), clamp(0.5 - bead * pixels, 0.0, 1.0));
  }
  float opacity = cover * tint.a;
  result = vec4(base * opacity, opacity);
}`;

/** Compiles and links both shaders. Throws the compiler's message if that fails. */
export function linkProgram(gl: WebGL2RenderingContext): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, VERTEX],
    [gl.FRAGMENT_SHADER, FRAGMENT],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error("the context is lost");
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
