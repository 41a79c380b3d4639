/**
 * Builds a linkage with every kind of joint. tests/web/link/joints.c builds the same in C, and both
 * must give the same hash.
 */
export function buildLinkage(world) {
  const circle = { radius: 0.375, offset: [0.25, 0] };
  const add = (kind, x, y) => {
    const body = world.createBody({ kind, position: [x, y] });
    world.createCircle(body, circle);
    return body;
  };
  const wall = add("static", 0, 8);
  const links = Array.from({ length: 6 }, (_, i) => add("dynamic", 1.5 + 1.5 * i, 8));
  const tie = (kind, bodyA, bodyB, x, options = {}) =>
    world.createJoint({ kind, bodyA, bodyB, at: [x, 8], angle: 0, ...options });
  tie("hinge", wall, links[0], 0.75, { turn: { lower: -1, upper: 0.5 } });
  const weld = tie("weld", links[0], links[1], 2.25, { turn: { frequency: 4 }, breakForce: 200 });
  const [bodyA, bodyB] = [links[1], links[2]];
  world.createJoint({ kind: "distance", bodyA, bodyB, length: 1, along: { lower: 0, upper: 2 } });
  tie("slider", links[2], links[3], 5.25, { angle: 0.5, along: { lower: -0.5, upper: 0.25 } });
  tie("wheel", links[3], links[4], 7.5, { angle: 1.5, along: { frequency: 3 } });
  const spring = { frequency: 2 };
  tie("target", wall, links[5], 9, { along: spring, across: spring });
  world.createJoint({ kind: "filter", bodyA: links[4], bodyB: links[5] });
  const [jointA, jointB] = [-4, -6].map((x, i) => {
    const wheel = add("dynamic", x, 5);
    const turn = { motorSpeed: 3, motorForce: i === 0 ? 5 : 0 };
    return world.createJoint({ kind: "hinge", bodyA: wall, bodyB: wheel, at: [x, 5], turn });
  });
  world.createJoint({ kind: "gear", jointA, jointB, ratio: -2 });
  return { world, wall, links, weld };
}
