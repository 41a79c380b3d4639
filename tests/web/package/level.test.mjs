/** Tests the reader of Tiled maps: what objects become, and what it reports about the rest. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { ballLevel, level, levelFiles, readLevelFile, thud } from "../support/package.mjs";

const engine = await thud.load();
const { buildLevel, LevelError, readLevel } = level;

async function problemsOf(text) {
  try {
    await readLevel("test", text);
  } catch (error) {
    assert.ok(error instanceof LevelError, String(error));
    return error.problems.map((problem) => problem.text);
  }
  return [];
}

for (const file of levelFiles)
  test(`level_${file}_loads_without_problems`, async () => {
    const read = await readLevel(file, readLevelFile(file));
    assert.deepEqual(read.problems, []);
    assert.ok(read.bodies.length > 10);
    buildLevel(engine, read).close();
  });

test("map_says_whether_it_has_a_character", async () => {
  assert.equal((await readLevel("ball", ballLevel())).character, false);
  assert.equal((await readLevel("platform", readLevelFile("platform.tmj"))).character, true);
});

test("ellipse_of_equal_axes_becomes_circle_at_its_centre", async () => {
  const ball = (await readLevel("ball", ballLevel())).bodies[1];
  const [{ kind, radius, offset }] = ball.shapes;
  assert.deepEqual([kind, radius, offset], ["circle", 1, [0, 0]]);
  assert.deepEqual(ball.body.position, [10, 10]);
  assert.equal(ball.body.kind, "dynamic");
});

test("rotated_rectangle_turns_clockwise_about_its_top_left_corner", async () => {
  const box = { id: 3, x: 320, y: 160, width: 64, height: 32, rotation: 90 };
  const { shapes, body } = (await readLevel("box", ballLevel([box]))).bodies[2];
  assert.equal(shapes[0].kind, "obb");
  // Turned by 90 degrees about its corner, the box is below and to the left of it: its centre is at
  // (-0.5, -1) from the corner.
  assert.deepEqual(body.position, [9.5, 9]);
  assert.equal(body.angle, -Math.PI / 2);
});

test("unequal_ellipse_is_refused_by_object_id", async () => {
  const bad = { id: 77, x: 0, y: 0, width: 64, height: 32, ellipse: true };
  const problems = await problemsOf(ballLevel([bad]));
  assert.equal(problems.length, 1);
  assert.match(problems[0], /object 77: .*unequal axes/);
});

test("polygon_is_left_out_when_the_caller_chose_so", async () => {
  const bad = { id: 78, x: 0, y: 0, polygon: [] };
  const read = await readLevel("test", ballLevel([bad]), { skip: true });
  assert.equal(read.bodies.length, 2);
  assert.match(read.problems[0].text, /object 78: a polygon/);
});

test("line_that_turns_back_is_refused", async () => {
  const polyline = [
    { x: 0, y: 0 },
    { x: 9, y: 0 },
    { x: 5, y: 3 },
  ];
  const [problem] = await problemsOf(ballLevel([{ id: 5, x: 0, y: 0, polyline }]));
  assert.match(problem, /object 5: .*turns back/);
});

test("misspelt_property_is_noted", async () => {
  const properties = [{ name: "densty", type: "float", value: 2 }];
  const box = { id: 3, x: 0, y: 0, width: 32, height: 32, properties };
  const { problems } = await readLevel("test", ballLevel([box]));
  assert.deepEqual(problems.map(({ severity }) => severity), ["note"]);
  assert.match(problems[0].text, /densty/);
});

for (const [name, text, expected] of [
  ["text_that_is_no_json", "{", /not JSON/],
  ["json_that_is_no_map", "[1]", /not a Tiled map/],
  ["isometric_map", '{"type":"map","orientation":"isometric"}', /isometric/],
  ["map_without_size", '{"type":"map"}', /width is missing/],
])
  test(`${name}_is_refused_with_its_reason`, async () => {
    assert.ok((await problemsOf(text)).some((problem) => expected.test(problem)));
  });
