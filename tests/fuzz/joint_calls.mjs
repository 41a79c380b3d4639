/** Random calls of joints, for calls.mjs. */
import { thud } from "../web/support/package.mjs";

/** The directions that each kind of joint drives. */
const DRIVEN = {
  distance: ["along"],
  hinge: ["turn"],
  slider: ["along"],
  weld: thud.DIRECTIONS,
  wheel: ["along", "turn"],
  target: thud.DIRECTIONS,
};

function driveOf(s) {
  const drive = { damping: s.number(0, 2), target: s.number(-1, 1) };
  if (s.below(2)) drive.lower = s.number(-2, 0);
  if (s.below(2)) drive.upper = s.number(0, 2);
  if (s.below(2)) drive.frequency = s.number(0, 20);
  if (s.below(2)) drive.motorForce = s.number(0, 50);
  drive.motorSpeed = s.number(-5, 5);
  drive.springForce = s.number(0, 100);
  return s.options(drive);
}

function frameOf(s) {
  return s.options({ position: s.place(), angle: s.number(-4, 4) });
}

/** The anchors of a joint: by places in the world, or by frames. */
function placeOf(s, kind) {
  if (s.below(3) === 0) return { frameA: frameOf(s), frameB: frameOf(s) };
  if (kind === "distance") return s.pick([{ from: s.place(), to: s.place() }, {}]);
  return { at: s.place(), ...s.pick([{}, { axis: s.vector() }, { angle: 1 }]) };
}

function optionsOf(s) {
  const kind = s.pick(thud.JOINT_KINDS);
  const common = { userData: s.below(99), collideConnected: s.below(2) === 0 };
  const breaks = s.pick([{}, {}, { breakForce: s.number(0, 500) }, { breakTorque: 9 }]);
  const gear = { jointA: s.joint(), jointB: s.joint(), ratio: s.number(-3, 3) };
  if (kind === "gear") return { kind, ...common, ...breaks, ...gear };
  const made = { kind, ...common, ...breaks, bodyA: s.body(), bodyB: s.body() };
  if (kind === "filter") return made;
  if (s.below(2)) made[s.pick(DRIVEN[kind])] = driveOf(s);
  if (kind === "distance" && s.below(2)) made.length = s.number(0.1, 5);
  return { ...made, ...placeOf(s, kind) };
}

export const JOINT_CALLS = {
  createJoint: (s) => s.keep(s.joints, s.world.createJoint(s.options(optionsOf(s)))),
  jointStateOf: (s) => s.world.jointStateOf(s.joint()),
  jointOptionsOf: (s) => {
    const options = s.world.jointOptionsOf(s.joint());
    s.keep(s.joints, s.world.createJoint(options));
    return options;
  },
  setDrive: (s) => s.world.setDrive(s.joint(), s.pick(thud.DIRECTIONS), driveOf(s)),
  setJointLength: (s) => s.world.setJointLength(s.joint(), s.number(0.1, 5)),
  setJointFrame: (s) => s.world.setJointFrame(s.joint(), s.pick(["a", "b", "c"]), frameOf(s)),
  setJointBreaking: (s) => {
    const options = { breakForce: s.number(0, 900), onlyReports: s.below(2) === 0 };
    s.world.setJointBreaking(s.joint(), s.options(options));
  },
  setJointEnabled: (s) => s.world.setJointEnabled(s.joint(), s.below(2) === 0),
  setJointUserData: (s) => s.world.setJointUserData(s.joint(), s.number(0, 9)),
  joints: (s) => {
    const joints = s.world.joints();
    for (const joint of joints)
      if (!s.world.isValid(joint)) throw new Error("a joint is listed that is not there");
    return joints;
  },
  jointsOf: (s) => s.world.jointsOf(s.body()),
  jointEvents: (s) => s.world.jointEvents(),
  jointTable: (s) => {
    const { count } = s.world.jointTable(s.number(0, 1), ...s.place()); // not checked: limits may be infinite
    if (count > s.world.joints().length) throw new Error("the table has more joints than the world");
  },
  useJoints: (s) => s.world.useJoints(),
};
