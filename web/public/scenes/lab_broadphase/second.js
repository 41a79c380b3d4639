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
    /**
     * The counts of a step after which all circles are where they are in the shown world. As in
     * any world only those search that have left the margin around their bounds.
     */
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
        make(state, radii); // in its first step all circles are new, and all search
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
