"""What the package adds to the engine: options, errors, views, and threads."""

import contextlib
import gc
import io
import os
import re
import threading
import time
from pathlib import Path

import numpy
import pytest

import thud

PROJECT = Path(os.environ["THUD_PROJECT"])


def falling(**options):
    world = thud.World(**options)
    world.body().terrain()
    ball = world.body("dynamic", position=(0, 5))
    ball.circle(0.5)
    return world, ball


def column(world, x, boxes, density_on_top=1.0):
    for row in range(boxes + 1):
        body = world.body("dynamic", position=(x, row + 0.5))
        body.obb(0.5, 0.5, density=density_on_top if row == boxes else 1.0)


def tall_stack():
    world = thud.World()
    world.body(position=(0, -1)).aabb(20, 1)
    column(world, 0, 29)
    return world


def heavy_on_light():
    world = thud.World()
    world.body(position=(0, -1)).aabb(24, 1)
    for group in range(2):
        for power in range(5):
            column(world, (power + 0.5 + group * 5 - 5) * 4, (1, 10)[group], 10.0 ** (power + 1))
    return world


def cradle():
    world = thud.World(gravity=(0, 0))
    bouncy = {"friction": 0, "restitution": 1}
    for side in (-1, 1):
        world.body(position=(side * 15.5, 0)).aabb(1, 8, **bouncy)
    for row in (1, 2, 3):
        for i in range(5):
            flying = i < row
            body = world.body("dynamic", position=(i - 2 - 6 * flying, 4 * (2 - row)), may_sleep=False,
                              velocity=(5 * flying, 0))
            body.circle(0.5, **bouncy)
    return world


@pytest.mark.parametrize("scene", [tall_stack, heavy_on_light, cradle])
def test_golden_hashes_are_those_of_c(scene):
    rows = dict(row.split() for row in
                (PROJECT / "tests/golden/hashes.txt").read_text(encoding="utf-8").splitlines())
    world = scene()
    world.step(120)
    assert f"{world.hash():016x}" == rows[scene.__name__]


PAGES = [path for path in ("bindings/python/README.md", *sorted(PROJECT.glob("web/site/*.md")))
         if "```python" in (PROJECT / path).read_text(encoding="utf-8")]


@pytest.mark.parametrize("page", PAGES, ids=lambda path: Path(path).stem)
def test_programs_of_pages_print_what_they_say(page):
    text = (PROJECT / page).read_text(encoding="utf-8")
    program = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
    said = re.findall(r"print\(.*\) +# (.*)", program)
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(program, {})
    assert len(said) == program.count("print(") and printed.getvalue().splitlines() == said


def test_refused_calls_raise_the_message_and_change_nothing():
    world, ball = falling()
    before = world.snapshot()
    with pytest.raises(thud.ThudError, match=r"friction is -1, not in \[0, 1000000\]") as caught:
        ball.circle(0.5, friction=-1)
    assert caught.value.result == thud.Result.ERROR_INVALID
    with pytest.raises(thud.ThudError) as caught:
        ball.set_velocity((float("nan"), 0))
    assert caught.value.result == thud.Result.ERROR_INVALID
    assert world.snapshot() == before
    ball.destroy()
    assert not ball.is_valid
    with pytest.raises(thud.ThudError) as caught:
        ball.state  # pylint: disable=pointless-statement
    assert caught.value.result == thud.Result.ERROR_STALE


@pytest.mark.parametrize("wrong, error, text", [
    (lambda: thud.World(gravty=(0, 0)), TypeError, "is it 'gravity'"),
    (lambda: thud.World(quality="hihg"), ValueError, "it has default, draft, exact, high"),
    (lambda: thud.World(gravity=1), TypeError, "gravity of a world"),
    (lambda: thud.World(gravity=(1, 2, 3)), ValueError, "3 numbers, not 2"),
    (lambda: thud.World(cookie=1), TypeError, "no option 'cookie'"),
    (lambda: thud.World(allocator={}), TypeError, "thud.lib"),
    (lambda: thud.World(clock=1.5), TypeError, "clock of a world: it is not a function"),
    (lambda: thud.World(clock=lambda: "now"), ValueError, "now"),
    (lambda: thud.World(time_budget=0.01), thud.ThudError, "time_budget lacks a clock"),
    (lambda: thud.World(substeps=1 << 40), OverflowError, "substeps of a world"),
    (lambda: thud.World(time_step=2.0), thud.ThudError, "time_step is 2"),
    (lambda: thud.World().body("dynamik"), ValueError, "it has dynamic, kinematic, static"),
    (lambda: falling()[0].joint("hinge", None, None, (0, 0), (1, 0)), TypeError, "takes 1 places"),
    (lambda: falling()[0].joint("glue", None, None, (0, 0)), ValueError, "no joint 'glue'"),
])
def test_wrong_options_are_refused_by_name(wrong, error, text):
    with pytest.raises(error, match=re.escape(text)):
        wrong()


def test_a_clock_times_stages_and_keeps_to_a_budget():
    readings = iter(range(1 << 20))
    slow, _ = falling(clock=lambda: next(readings) * 0.01, time_budget=0.001)
    before = slow.stats().steps
    slow.step(20)
    assert slow.stats().steps == before + 20 and slow.stats().substeps == 1
    assert slow.stats().step_seconds > 0.05 and min(slow.stats().stage_seconds) >= 0
    fast, _ = falling(clock=time.perf_counter, time_budget=1.0)
    gc.collect()
    with thud.Batch([fast, slow], threads=2) as batch:
        batch.step(30)
    assert fast.stats().substeps == 4 and 0 < fast.stats().step_seconds < 1
    assert falling()[0].stats().step_seconds == 0


def test_views_of_structs_have_their_arrays():
    world, _ = falling(clock=time.perf_counter)
    world.step()
    stats = thud.ffi.new("thud_stats *")
    world.call("world_get_stats", stats)
    view = world.view(stats, 1)
    assert view["stage_seconds"].shape == (1, len(stats.stage_seconds))
    assert view["stage_seconds"][0].tolist() == list(stats.stage_seconds)
    assert view["steps"][0] == 1 and not view.flags.writeable


def test_objects_of_the_engine_are_options_by_name():
    world, _ = falling(quality="high", detection="swept", broadphase="sweep", sleeping=False)
    plain, _ = falling()
    world.step(), plain.step()
    assert (world.stats().substeps, plain.stats().substeps) == (8, 4)


def test_poses_are_a_view_that_cannot_be_written():
    world, ball = falling()
    world.step()
    poses = world.poses()
    assert poses.dtype == numpy.float32 and not poses.flags.owndata
    assert poses[ball.slot].tolist() == pytest.approx([0, ball.position.y, 1, 0])
    address = poses.__array_interface__["data"][0]
    world.step()
    assert world.poses().__array_interface__["data"][0] == address, "a copy"
    with pytest.raises(ValueError, match="read-only"):
        poses[0] = 0
    other = world.poses(0.0, origin=(0, 4))
    assert other[ball.slot, 1] > world.poses(1.0, origin=(0, 4))[ball.slot, 1]


def test_views_outlive_their_world():
    """Under glibc, MALLOC_PERTURB_ overwrites what is freed."""
    world, _ = falling()
    world.step(30)
    poses = world.poses()[1:]
    before = poses.copy()
    world.close()
    del world
    gc.collect()
    assert numpy.array_equal(poses, before)


def test_memory_does_not_grow_while_there_is_always_a_view():
    world, _ = falling()
    ground = world.body()
    sizes, poses = [], None
    for round_ in range(2400):
        shape = ground.terrain(points=[(i, i % 3) for i in range(300)])
        world.step()
        poses = world.poses()
        shape.destroy()
        if round_ % 800 == 799:
            with open("/proc/self/statm", encoding="ascii") as file:
                sizes.append(int(file.read().split()[1]))
    assert len(poses) > 0
    assert sizes[2] - sizes[1] < 400, sizes  # pages; each round would keep two


def test_closed_worlds_are_refused():
    with thud.World() as world:
        body = world.body()
    for call in (world.step, world.poses, world.body, lambda: body.state):
        with pytest.raises(RuntimeError, match="closed"):
            call()
    world.close()


def test_a_world_is_not_closed_inside_its_callback():
    world, errors = falling()[0], []

    @thud.ffi.callback("void(thud_world *, void *)")
    def before(_world, _context):
        try:
            world.close()
        except thud.ThudError as error:
            errors.append(error)

    calls = thud.ffi.new("thud_step_calls *", {"before": before})
    world.call("world_advance_with", 0.02, 1, calls, thud.ffi.NULL, thud.ffi.NULL)
    assert [error.result for error in errors] == [thud.Result.ERROR_LOCKED]
    world.step()
    world.close()


def test_an_error_has_no_reason_of_another():
    world, ball = falling()
    with pytest.raises(thud.ThudError, match="density"):
        ball.circle(0.5, density=-1)
    with pytest.raises(thud.ThudError, match="null"):
        world.call("world_get_stats", thud.ffi.NULL)


def test_events_are_structs_of_the_engine():
    world, ball = falling()
    begun, hits = [], []
    for _ in range(120):
        world.step()
        events = world.events()
        begun += events.begin.tolist()
        hits += events.hit.tolist()
    assert len(begun) == 1 and len(hits) == 1
    assert {begun[0][0][0], begun[0][1][0]} == {1, 2}  # index1 of the two shapes
    (_, _, point, normal, speed) = hits[0]
    assert speed == pytest.approx(9.5, abs=0.2) and abs(normal[1]) == 1 and abs(point[1]) < 0.1
    del ball


def test_snapshots_bring_back_the_bits():
    world, _ = falling()
    world.step(30)
    kept, hash_then = world.snapshot(), world.hash()
    world.step(30)
    hash_later = world.hash()
    world.restore(kept)
    assert world.hash() == hash_then != hash_later
    world.step(30)
    assert world.hash() == hash_later
    with pytest.raises(thud.ThudError):
        world.restore(kept[:-1])


def test_rays_and_lists():
    world, ball = falling()
    hit = world.cast_ray((0, 10), (0, -20))
    assert hit.point == (0, 5.5) and hit.normal == (0, 1)
    assert world.cast_ray((0, 10), (0, 1)) is None
    assert world.bodies()[1] == ball and len(world.bodies()) == 2


def test_batches_have_the_bits_of_single_worlds():
    worlds = [tall_stack() for _ in range(9)]
    for number, world in enumerate(worlds):
        world.bodies()[-1].set_velocity((number, 0))
    alone = worlds[3].snapshot()
    with thud.Batch(worlds, threads=3) as batch:
        batch.step(40)
    hashes = [world.hash() for world in worlds]
    assert len(set(hashes)) == 9
    worlds[3].restore(alone)
    worlds[3].step(40)
    assert worlds[3].hash() == hashes[3]
    with pytest.raises(ValueError, match="twice"):
        thud.Batch([worlds[0], worlds[0]])


def test_a_batch_that_is_interrupted_keeps_its_worlds_until_their_parts_end(monkeypatch):
    worlds = [tall_stack() for _ in range(4)]
    for world in worlds:
        world.call("world_set_sleeping", False)

    def interrupt(_future):
        raise KeyboardInterrupt

    with thud.Batch(worlds, threads=2) as batch:
        with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
            patch.setattr("concurrent.futures.Future.result", interrupt)
            batch.step(5000)
        refused, seen = 0, []
        for world in worlds:
            try:
                seen.append((world, world.stats().steps))
            except thud.ThudError:
                refused += 1
        assert refused > 0
        # What is not refused is not stepped any more.
        time.sleep(0.05)
        assert all(world.stats().steps == steps for world, steps in seen)
    for world in worlds:
        world.step()


def test_a_step_leaves_pythons_lock_to_other_threads_and_keeps_them_out():
    world, refused = tall_stack(), []

    def steps():
        while not refused and time.monotonic() < end:
            world.step(10)

    end = time.monotonic() + 20
    thread = threading.Thread(target=steps)
    thread.start()
    while not refused and thread.is_alive():
        try:
            world.pointer  # pylint: disable=pointless-statement
        except thud.ThudError as error:
            refused.append(error)
    thread.join()
    assert refused and refused[0].result == thud.Result.ERROR_LOCKED
    world.step()


def test_every_public_function_is_there():
    import json
    api = json.loads((PROJECT / "bindings/api.json").read_text(encoding="utf-8"))
    names = {entry["name"] for entry in api["functions"] + api["variables"] + api["constants"]}
    assert len(names) > 300 and names - set(dir(thud.lib)) == set()


def test_types_are_those_of_the_headers():
    import thud._records as records
    assert records.StepError._fields[:2] == ("penetration_max", "penetration_mean")
    assert "Units" not in records.StepError.__doc__ and "penetration" in records.StepError.__doc__
    assert set(records.WorldDefOptions.__annotations__) >= {"gravity", "time_step", "quality"}
    folder = Path(thud.__file__).parent
    assert (folder / "py.typed").is_file() and (folder / "_native.pyi").is_file()
    names = re.findall(r"^class (\w+)", (folder / "_records.py").read_text(encoding="utf-8"), re.M)
    assert len(names) > 90 and len(names) == len(set(names))
    assert thud.BodyKind.DYNAMIC == thud.lib.THUD_BODY_DYNAMIC
