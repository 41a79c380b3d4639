/**
 * Tests the numbers of the laboratory’s scenes against computations of their own: closed forms of
 * circles, separating axes of boxes, and where a step leaves a bullet.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

const rowOf = (paint, control, name) =>
  paint.readings[control].find(([label]) => label === name)?.[1];
const numberOf = (...asked) => Number.parseFloat(rowOf(...asked));
const near = (actual, expected, tolerance) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${actual}, not ${expected}`);

/** Opens a scene with this state; `paint` gives what it then shows. */
async function openLab(t, name, state = {}) {
  const built = await buildScene(engine, name);
  t.after(built.close);
  Object.assign(built.scene.state, state);
  return built.scene;
}

/** The state of two circles of these places, radii and ways, as the laboratory’s scenes have it. */
function circles([xA, yA, radiusA, wayXA, wayYA], [xB, yB, radiusB, wayXB, wayYB]) {
  return {
    ...{ kindA: "circle", xA, yA, widthA: 2 * radiusA, wayXA, wayYA },
    ...{ kindB: "circle", xB, yB, widthB: 2 * radiusB, wayXB, wayYB },
  };
}

// ---- Overlap and bisection ----

test("each_halving_halves_the_interval_around_the_time_of_impact_and_takes_one_test", async (t) => {
  // Centres 6 apart close in by 8: they touch when 2 are left, after a half of the way.
  const state = circles([-3, 2, 1, 4, 0], [3, 2, 1, -3, 0]);
  const scene = await openLab(t, "lab_bisection", state);
  const impact = 4 / 7;
  for (let halving = 0; halving <= 12; halving++) {
    scene.state.halving = halving;
    const paint = scene.paint();
    const [low, high] = rowOf(paint, "interval", "Interval").split(" to ").map(Number);
    near(low, Math.floor(impact * 2 ** halving) / 2 ** halving, 1e-5);
    near(high - low, 2 ** -halving, 2e-5);
    assert.equal(numberOf(paint, "interval", "Overlap tests spent"), 2 + halving);
    near(numberOf(paint, "interval", "The engine, to this length"), low, 1e-12);
    near(numberOf(paint, "interval", "Swept test, exact"), impact, 1e-5);
  }
});

test("bisection_finds_nothing_where_the_shapes_are_apart_at_the_end", async (t) => {
  const scene = await openLab(t, "lab_bisection", circles([-3, 2, 1, 8, 0], [3, 2, 1, -8, 0]));
  const paint = scene.paint();
  assert.equal(rowOf(paint, "interval", "Interval"), "no collision is found");
  assert.equal(numberOf(paint, "interval", "Overlap tests spent"), 2);
  near(numberOf(paint, "interval", "Swept test, exact"), 4 / 16, 1e-5);
  assert.match(paint.message, /misses/);
});

/** What each lane says once the bullets have flown with these settings. */
async function shoot(settings) {
  const session = await openSession(engine, "lab_bisection");
  for (const [name, value] of Object.entries(settings)) session.do({ kind: "set", name, value });
  const flight = Math.ceil((12 * settings.rate) / settings.speed);
  for (let i = 0; i < flight; i++) session.makeStep();
  const { paint } = session;
  const told = Object.fromEntries(
    ["overlap", "bisect", "swept"].map((name) => [name, rowOf(paint, "bound", `With ${name}`)]),
  );
  session.close();
  return { ...told, paint };
}

test("bullet_passes_paper_by_overlap_and_bisection_only_beyond_the_bound", async () => {
  let passed = 0;
  for (const rate of [30, 60, 240])
    for (const speed of [5, 11, 40, 97])
      for (const thickness of [0.02, 0.1, 0.3]) {
        const { paint, overlap, bisect, swept } = await shoot({ rate, speed, thickness });
        const where = `${rate} steps a second, speed ${speed}, thickness ${thickness}`;
        const motion = speed / rate;
        const thinnest = Math.min(thickness, 0.2);
        const kept = motion < thinnest;
        near(numberOf(paint, "bound", "Speed × step"), motion, 6e-4);
        near(numberOf(paint, "bound", "Speed at the bound"), thinnest * rate, 6e-3);
        assert.equal(rowOf(paint, "bound", "Bound"), kept ? "kept: is caught" : "broken: may pass");
        assert.equal(swept, "is caught", where);
        if (kept) assert.deepEqual([overlap, bisect], ["is caught", "is caught"], where);
        // Bisection catches a bullet if one of its poses touches the paper. It may also catch one
        // that comes within the skin of contacts, which none does here.
        const reach = 0.5 * thickness + 0.1;
        let poses = 0;
        for (let i = 0; i * motion <= 12; i++) if (Math.abs(i * motion - 6) <= reach) poses++;
        assert.equal(numberOf(paint, "bound", "Poses that touch the paper"), poses, where);
        assert.equal(bisect, poses > 0 ? "is caught" : "passes", where);
        if (poses === 0) assert.equal(overlap, "passes", where);
        if (bisect === "passes") passed++;
        // Poses behind the paper are drawn in the lanes of those that pass alone.
        const behind = paint.marks.filter(
          ({ kind, x, y, opacity }) => kind === "circle" && y < -2 && x > 0 && opacity < 1,
        );
        const passing = [overlap, bisect].filter((outcome) => outcome === "passes").length;
        assert.equal(new Set(behind.map(({ y }) => y)).size, passing, where);
      }
  assert.ok(passed > 3, "some settings let it pass");
});

test("limit_that_the_scene_tells_is_that_of_its_world", async () => {
  const session = await openSession(engine, "lab_bisection");
  session.do({ kind: "set", name: "thickness", value: 0.06 });
  session.do({ kind: "set", name: "rate", value: 90 });
  session.makeStep();
  near(session.world.bisectionLimit(), numberOf(session.paint, "bound", "Speed at the bound"), 1e-2);
  const mark = session.paint.marks.find(({ text }) => text?.startsWith("speed × step"));
  assert.equal(mark.ink, "bad");
  session.do({ kind: "set", name: "speed", value: 1 });
  assert.equal(session.paint.marks.find(({ text }) => text?.startsWith("speed × step")).ink, "good");
  session.close();
});

// ---- Swept ----

test("quadratic_of_two_circles_has_its_smaller_root_at_the_time_of_impact", async (t) => {
  const scene = await openLab(t, "lab_swept");
  const cases = [
    [[-3, 0, 1, 4, 0], [3, 0, 1, -4, 0]],
    [[-3, 1, 0.7, 6, -1], [2, 0.4, 0.5, -1, 0.3]],
    [[-4, 2, 1, 3, 0], [4, 2, 1, 0, 0]], // both roots after the step
    [[-4, 3, 0.5, 8, 0], [4, 0, 0.5, -8, 0]], // they pass each other
  ];
  for (const [first, second] of cases) {
    Object.assign(scene.state, circles(first, second));
    const paint = scene.paint();
    const [px, py, vx, vy] = [0, 1, 3, 4].map((k) => second[k] - first[k]);
    const reach = first[2] + second[2];
    near(numberOf(paint, "equation", "a = v·v"), vx ** 2 + vy ** 2, 6e-5);
    near(numberOf(paint, "equation", "b = 2 p·v"), 2 * (px * vx + py * vy), 6e-5);
    near(numberOf(paint, "equation", "c = p·p − R²"), px ** 2 + py ** 2 - reach ** 2, 6e-5);
    // The distance without a formula, at many times.
    const distanceAt = (time) => Math.hypot(px + time * vx, py + time * vy);
    const times = Array.from({ length: 200001 }, (_, i) => i / 200000);
    const met = times.find((time) => distanceAt(time) <= reach);
    const told = rowOf(paint, "equation", "Time of impact, by the engine");
    const [smaller] = rowOf(paint, "equation", "Roots").split(" and ").map(Number);
    if (met === undefined) assert.equal(told, "never in this step");
    else {
      near(Number(told), met, 1e-4);
      near(smaller, met, 1e-4);
    }
    const least = times.reduce((best, time) => Math.min(best, distanceAt(time)), Infinity);
    near(numberOf(paint, "nearest", "Centres, at their nearest"), least, 1e-4);
    near(numberOf(paint, "nearest", "Between the surfaces"), least - reach, 1e-4);
  }
  assert.ok(numberOf(scene.paint(), "equation", "Discriminant b² − 4 a c") < 0);
  assert.equal(rowOf(scene.paint(), "equation", "Roots"), "none");
});

test("sagitta_is_that_of_the_parabola_and_the_swept_ball_flies_on_it", async () => {
  for (const [gravity, step] of [[10, 0.3], [0, 0.5], [30, 0.1], [10, 0.02]]) {
    const session = await openSession(engine, "lab_swept");
    session.do({ kind: "set", name: "gravity", value: gravity });
    session.do({ kind: "set", name: "step", value: step });
    for (let i = 0; i < 5; i++) session.makeStep();
    const { paint } = session;
    near(numberOf(paint, "sagitta", "g dt²/8"), (gravity * step ** 2) / 8, 6e-6);
    near(numberOf(paint, "sagitta", "Parabola above the straight way"), (gravity * step ** 2) / 8, 6e-6);
    assert.ok(numberOf(paint, "sagitta", "The engine’s ball off the parabola") < 1e-4);
    const { trace } = session.scene.state;
    assert.equal(trace.length, 6);
    const [x0, y0] = trace[0];
    trace.forEach(([x, y], i) => {
      near(x, x0 + 4.6 * i * step, 1e-4);
      near(y, y0 + 7 * i * step - 0.5 * gravity * (i * step) ** 2, 1e-4);
    });
    session.close();
  }
});

// ---- Minkowski ----

test("segment_enters_the_sum_when_the_swept_shapes_meet", async (t) => {
  const scene = await openLab(t, "lab_minkowski");
  const tell = (state) => {
    Object.assign(scene.state, state);
    const paint = scene.paint();
    const row = (name) => rowOf(paint, "sum", name);
    return [row("The segment enters the sum at"), row("The swept shapes meet at")];
  };
  // Two circles are a closed form: the sum is a circle of both radii.
  const round = circles([-3, 0, 1, 0, 0], [3, 0, 0.5, -6, 0]);
  assert.deepEqual(tell(round), ["0.7500", "0.7500"]);
  for (const kindA of ["circle", "aabb", "obb"])
    for (const kindB of ["circle", "aabb", "obb"])
      for (const wayYB of [-3, 0.5, 4]) {
        const [enters, meets] = tell({ kindA, kindB, xA: -2, yA: 0, xB: 3, yB: 1, wayXB: -5, wayYB });
        assert.equal(enters, meets, `${kindA} ${kindB} ${wayYB}`);
      }
  assert.deepEqual(tell({ wayYB: 6 }), ["never", "never"]);
});

/** The area of a polygon. */
const areaOf = (points) =>
  points.reduce((sum, [x, y], i) => {
    const [u, v] = points[(i + 1) % points.length];
    return sum + 0.5 * (x * v - u * y);
  }, 0);

test("sum_grows_from_the_shape_itself_to_the_whole_sum", async (t) => {
  const scene = await openLab(t, "lab_minkowski", {
    ...{ kindA: "aabb", widthA: 3, heightA: 1.6, kindB: "aabb", widthB: 2, heightB: 1.2 },
  });
  for (const grown of [0, 0.25, 0.5, 1]) {
    scene.state.grown = grown;
    const outline = scene.paint().marks.find(({ kind, filled }) => kind === "line" && filled).points;
    near(areaOf(outline.slice(0, -1)), (3 + 2 * grown) * (1.6 + 1.2 * grown), 1e-6);
  }
});

test("ground_grows_by_a_shape_and_the_segment_enters_it_when_the_shape_meets_the_ground", async (t) => {
  const scene = await openLab(t, "lab_minkowski", { against: "terrain" });
  for (const kindB of ["circle", "aabb", "obb"])
    for (const wayXB of [-6, -1, 3]) {
      Object.assign(scene.state, { kindB, xB: 1, yB: 2, wayXB, wayYB: -7 });
      const paint = scene.paint();
      const [enters, meets] = ["The segment enters the sum at", "The swept shapes meet at"].map(
        (name) => numberOf(paint, "sum", name),
      );
      // The line of the sum has corners 0.075 apart; between them it is straight.
      near(enters, meets, 0.002);
      assert.ok(meets > 0.1 && meets < 1);
    }
  // Above level ground a box is half as high as itself when it lies: 4 to -1.3 + 0.6.
  Object.assign(scene.state, { kindB: "aabb", xB: 6.75, yB: 4, widthB: 0.4, heightB: 1.2, wayXB: 0, wayYB: -8 });
  near(numberOf(scene.paint(), "sum", "The swept shapes meet at"), (4 + 1.3 - 0.6) / 8, 1e-4);
});

// ---- Bounding volumes ----

/** Whether two boxes overlap, by their separating axes. */
function boxesOverlap(a, b) {
  const axesOf = ({ angle = 0 }) => [
    [Math.cos(angle), Math.sin(angle)],
    [-Math.sin(angle), Math.cos(angle)],
  ];
  const reachOf = (box, [x, y]) => {
    const [along, across] = axesOf(box);
    return (
      box.halfWidth * Math.abs(along[0] * x + along[1] * y) +
      box.halfHeight * Math.abs(across[0] * x + across[1] * y)
    );
  };
  return [...axesOf(a), ...axesOf(b)].every(([x, y]) => {
    const apart = (b.center[0] - a.center[0]) * x + (b.center[1] - a.center[1]) * y;
    return Math.abs(apart) <= reachOf(a, [x, y]) + reachOf(b, [x, y]);
  });
}

/** The shapes of a crowd as they are drawn: filled boxes of this ink. */
const crowdOf = ({ marks }) =>
  marks
    .filter(({ kind, ink, filled }) => kind === "box" && ink === "accent" && filled)
    .map((mark) => ({ ...mark, center: [mark.x, mark.y] }));

test("crowd_is_counted_as_separating_axes_count_it", async (t) => {
  const scene = await openLab(t, "lab_volumes");
  for (const [slender, turned] of [[1, 0], [4, 30], [10, 90]]) {
    Object.assign(scene.state, { slender, turned });
    const paint = scene.paint();
    const shapes = crowdOf(paint);
    assert.equal(shapes.length, 40);
    const tests = {
      circle: ({ halfWidth: w, halfHeight: h }) => Math.hypot(w, h),
      proxy: ({ halfWidth: w, halfHeight: h }) => Math.sqrt((4 * w * h) / Math.PI),
    };
    const upright = (box) => {
      const [c, s] = [Math.abs(Math.cos(box.angle)), Math.abs(Math.sin(box.angle))];
      const halfWidth = box.halfWidth * c + box.halfHeight * s;
      const halfHeight = box.halfWidth * s + box.halfHeight * c;
      return { center: box.center, halfWidth, halfHeight, area: 4 * halfWidth * halfHeight };
    };
    const meets = {
      circle: (a, b) => Math.hypot(a.x - b.x, a.y - b.y) <= tests.circle(a) + tests.circle(b),
      aabb: (a, b) => boxesOverlap(upright(a), upright(b)),
      obb: boxesOverlap,
      proxy: (a, b) => Math.hypot(a.x - b.x, a.y - b.y) <= tests.proxy(a) + tests.proxy(b),
    };
    let hits = 0;
    const counts = Object.fromEntries(Object.keys(meets).map((kind) => [kind, { alarms: 0, missed: 0 }]));
    shapes.forEach((a, i) => shapes.slice(0, i).forEach((b) => {
      const hit = boxesOverlap(a, b);
      if (hit) hits++;
      for (const [kind, meet] of Object.entries(meets)) {
        if (meet(a, b) && !hit) counts[kind].alarms++;
        if (!meet(a, b) && hit) counts[kind].missed++;
      }
    }));
    assert.equal(numberOf(paint, "exact", "Of them overlap"), hits);
    assert.equal(numberOf(paint, "exact", "Pairs of the crowd"), 780);
    for (const [kind, { alarms, missed }] of Object.entries(counts)) {
      assert.equal(numberOf(paint, kind, "False alarms"), alarms, kind);
      assert.equal(numberOf(paint, kind, "Missed"), missed, kind);
      if (kind !== "proxy") assert.equal(missed, 0, kind);
    }
    const area = (of) => shapes.reduce((sum, shape) => sum + of(shape), 0);
    const filled = area(({ halfWidth, halfHeight }) => 4 * halfWidth * halfHeight);
    const wasted = (of) => `${Math.round(100 * (1 - filled / area(of)))} %`;
    assert.equal(rowOf(paint, "aabb", "Area wasted, crowd"), wasted((box) => upright(box).area));
    const round = wasted((box) => Math.PI * tests.circle(box) ** 2);
    assert.equal(rowOf(paint, "circle", "Area wasted, crowd"), round);
    assert.equal(rowOf(paint, "obb", "Area wasted, crowd"), "0 %");
    if (slender === 10) assert.ok(counts.proxy.missed > 0 && counts.circle.alarms > counts.aabb.alarms);
  }
});

test("proxy_misses_what_the_outline_hits_and_every_bound_tells", async (t) => {
  const upright = { widthA: 0.5, heightA: 4, widthB: 4, heightB: 0.5 };
  const corner = { kindA: "aabb", xA: -2, yA: 0, kindB: "aabb", xB: 0, yB: 1.7, ...upright };
  const scene = await openLab(t, "lab_volumes", corner);
  const paint = scene.paint();
  for (const kind of ["circle", "aabb", "obb"])
    assert.equal(rowOf(paint, kind, "A and B by it"), "overlap", kind);
  assert.equal(rowOf(paint, "proxy", "A and B by it"), "apart");
  assert.match(paint.message, /proxies miss/);
  for (let i = 0; i < 6; i++) scene.paint();
  const last = scene.paint();
  const kinds = ["circle", "aabb", "obb", "proxy", "exact"];
  const times = kinds.map((kind) => numberOf(last, kind, "A test takes"));
  assert.ok(times.every((time) => time > 0), times.join());
  // Which test is the dearest is told by these times, and by nothing that is fixed.
  for (const [row, of] of [["Cheapest test", Math.min], ["Dearest test", Math.max]]) {
    const [name, time] = rowOf(last, "exact", row).split(", ");
    assert.equal(Number.parseFloat(time), of(...times), row);
    assert.equal(times[kinds.indexOf(name.toLowerCase())], of(...times), row);
  }
});

// ---- choices of the panel Trade ----

test("chosen_step_rate_and_greatest_speed_replace_the_scene_s_and_are_left_out_unless_chosen", async () => {
  const choices = { quality: "default", substeps: 0, detection: "auto", broadphase: "grid", maxError: 0 };
  const open = (stepRate, topSpeed) =>
    openSession(engine, "lab_swept", { choices: { ...choices, stepRate, topSpeed } });
  const usual = await open(0, 0);
  assert.equal(usual.timeStep, 0.3, "the scene's own");
  usual.close();
  const slow = await open(120, 2);
  assert.equal(slow.timeStep, 1 / 120);
  slow.makeStep();
  const [x, y] = slow.world.bodyStateOf(slow.world.bodies()[0]).velocity;
  // The ball is thrown with 4.6 along x and 7 along y.
  assert.ok(Math.abs(x) <= 2 && Math.abs(y) <= 2, `${x}, ${y}`);
  slow.close();
});
