// What stands in a world: every body with one shape, as a level from Tiled has them.

// [{ body, shape, ... and where it began }] of those whose states `fits` takes.
export function findBodies(world, fits) {
  const { count, handles } = world.shapeTable();
  const ids = Array.from({ length: count }, (_, i) => ({
    kind: "shape",
    index: handles[4 * i] - 1,
    generation: handles[4 * i + 1],
  }));
  return ids.flatMap((id) => {
    const shape = world.shapeStateOf(id);
    const { position, angle, velocity, kind, userData } = world.bodyStateOf(shape.body);
    const found = { body: shape.body, shape, position, angle, velocity, kind, userData };
    return fits(found) ? [found] : [];
  });
}

export function putBack(world, bodies) {
  for (const { body, position, angle, velocity } of bodies) {
    world.setTransform(body, position, angle);
    world.setVelocity(body, velocity);
  }
}
