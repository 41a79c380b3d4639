/** The package has types, but not for the paths of its two builds. */
declare module "*/Box2D.deluxe.mjs" {
  const start: typeof import("box2d3-wasm");
  export default start;
}
declare module "*/Box2D.compat.mjs" {
  const start: typeof import("box2d3-wasm");
  export default start;
}
