// Where the numbers of a listener’s row stand: LISTENED_ROW of the package, those that are used here.

export const ROW = {
  ...{ bodyA: 4, bodyB: 6, normal: 8, point: 10, normalImpulse: 13 },
  ...{ collide: 16, friction: 17, restitution: 18, length: 20 },
};
