// What the panel and the figures say of the present fall, and the line over the picture.

const number = (value) => value.toFixed(2).replace("-0.00", "0.00");
const speed = (pair) => (pair ? `${number(pair[0])}, ${number(pair[1])} m/s` : "not yet");

export function tell(state) {
  const { fall } = state;
  return {
    figures: [
      { label: "Prologue asked", value: `${fall.asked}` },
      { label: "Changed", value: `${fall.answered}` },
      { label: "Told: world", value: `${fall.world}` },
      { label: "ball", value: `${fall.ball}` },
      { label: "pads", value: `${fall.pads}` },
    ],
    readings: {
      asks: [
        ["Asked", times(fall.asked)],
        ["Answered otherwise", times(fall.answered)],
        ["Velocity before", speed(fall.before)],
        ["Velocity after", speed(fall.after)],
        ["Energy that was decided", `${number(fall.energy)} J`],
      ],
      toWorld: [["Called", times(fall.world)], ["Impulse that it was told", `${number(fall.impulse)} Ns`]],
      toBall: [["Called", times(fall.ball)]],
      toPads: [["Called", times(fall.pads)]],
    },
    message: message(state),
  };
}

const times = (count) => (count === 1 ? "once" : `${count} times`);

const WORDS = {
  plain: () => "as the surfaces say",
  surface: ({ friction, restitution }) => `friction ${friction}, restitution ${restitution}`,
  veto: () => "a veto: the two do not collide",
  kicker: ({ speed: away }) => `${away} m/s away from the pad`,
  portal: ({ turn }) => `through, with the velocity turned by ${turn}°`,
};

/** Without counts, which change in every step: it is said aloud. */
function message(state) {
  const { fall, answer } = state;
  if (!state.asks) return "Nobody is asked: the two collide as their surfaces say.";
  if (fall.asked === 0) return "The ball falls. The prologue is asked once the two are about to touch.";
  const told = [["the world", fall.world], ["the ball", fall.ball], ["the pads", fall.pads]];
  const names = told.filter(([, count]) => count > 0).map(([name]) => name);
  const heard = names.length > 0 ? `Told what was done: ${names.join(", ")}.` : "No epilogue is told.";
  return `The prologue was asked, and answered: ${WORDS[answer](state)}. ${heard}`;
}
