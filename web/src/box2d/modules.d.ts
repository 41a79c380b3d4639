/** The package has types, but not under the names of its flavours' modules. */
declare module "*/Box2D.deluxe.mjs" {
  const start: typeof import("box2d3-wasm");
  export default start;
}
declare module "*/Box2D.compat.mjs" {
  const start: typeof import("box2d3-wasm");
  export default start;
}
