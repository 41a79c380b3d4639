// The world in which tests are counted. It is made anew when another broadphase, cell size or other
// sizes of circles are chosen, since a world keeps its broadphase.

const STEPS = 120; // so many counts of the past are kept, for the chart

export function createSecond(thud, size) {
  let world = null;
  let bodies = [];
  let made = "";
  let step = -1;
  let last = null;
  const past = [];

  function make({ broadphase, cellSize }, radii) {
    world?.close();
    world = thud.createWorld({ gravity: [0, 0], broadphase, cellSize });
    bodies = Array.from({ length: size }, () => world.createBody({ kind: "dynamic", maySleep: false }));
    bodies.forEach((body, i) => world.createCircle(body, { radius: radii[i], mask: 0 }));
  }

  return {
    /** The counts of a step in which all circles have moved to where they are in the shown world. */
    count(shown, places, radii, state) {
      const wanted = `${state.broadphase} ${state.cellSize} ${state.arranged}`;
      const now = shown.stats().steps;
      if (wanted === made && now === step) return { counts: last, past };
      const poses = shown.poses();
      const put = () => {
        bodies.forEach((body, i) => {
          const at = 4 * places[i].index;
          world.setTransform(body, [poses[at], poses[at + 1]]);
        });
        world.step();
      };
      if (wanted !== made) {
        make(state, radii);
        put(); // so that what is new in the first step, the order of the lists, is not counted
        made = wanted;
      }
      put();
      step = now;
      last = world.broadphaseCounts();
      past.push(last.tested);
      if (past.length > STEPS) past.shift();
      return { counts: last, past };
    },
    close() {
      world?.close();
      world = null;
      made = "";
    },
  };
}
