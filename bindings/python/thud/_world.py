"""Worlds, and what is in them."""

from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any, Dict, Iterable, NamedTuple, Optional, Sequence, Tuple, Union

from . import _convert
from ._convert import constant, fill, pair, plain
from ._native import ffi, lib
from ._records import (BodyState, JointState, Measure, Pos, Result, ShapeState, Stats, StepError,
                       Vec2)

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._records import BodyDefOptions, JointDefOptions, ShapeDefOptions, WorldDefOptions

Point = Union[Tuple[float, float], Sequence[float]]


class ThudError(Exception):
    """A call that the engine refused; it has changed nothing.

    result: the engine's code. The text is the engine's message, which names a value and its range."""

    def __init__(self, result: Result, message: str):
        super().__init__(message)
        self.result = result


@ffi.def_extern()
def thud_py_clock(context: Any) -> float:
    """Reads the clock of a world for the engine."""
    return float(ffi.from_handle(context)())


class StepEvents(NamedTuple):
    """The events of the last step, or of all steps of the last advance, each list a NumPy array
    with the fields of the engine's struct, which is a view of the world's memory."""

    begin: Any
    end: Any
    sensor_begin: Any
    sensor_end: Any
    sensor_begin_time: Any
    sensor_end_time: Any
    hit: Any
    quarantined: Any


class World:
    """A world that advances in steps of 1/60 s, or another `time_step`.

    Options are the fields of thud_world_def. `clock` is a function such as time.perf_counter: it times
    the stages of each step, and a `time_budget` needs it. It is read several times a step, by the
    thread that steps, and neither calls the world nor raises. A world is used by one thread at a time; a call during
    step(), advance() or a Batch's step on another thread is refused. It is freed when nothing refers to it, or by close()."""

    def __init__(self, **options: "Unpack[WorldDefOptions]"):
        self._world: Any = None
        self._stepping = False
        context = lib.thud_py_context_create()
        if context == ffi.NULL:
            raise MemoryError("no memory for a world")
        self._context = ffi.gc(context, lib.thud_py_context_destroy)
        given = dict(options)
        for owned in ("allocator", "log", "log_context", "job_system", "clock_context"):
            if owned in given:
                raise TypeError(f"{owned} is a matter of C, for which thud.lib is")
        def_ = ffi.new("thud_world_def *", lib.thud_default_world_def())
        clock = given.pop("clock", None)
        fill(def_, given, "a world")
        if clock is not None:
            if not callable(clock):
                raise TypeError("clock of a world: it is not a function")
            float(clock())
            self._clock = ffi.new_handle(clock)  # keeps the function
            def_.clock, def_.clock_context = lib.thud_py_clock, self._clock
        self._check(lib.thud_py_context_create_world(self._context, def_))
        self._world = lib.thud_py_context_world(self._context)

    # ---- the world itself ----

    @property
    def pointer(self) -> Any:
        """The thud_world * for calls of thud.lib. RuntimeError for a world that was closed."""
        if self._world is None:
            raise RuntimeError("the world is closed")
        if self._stepping:
            raise ThudError(Result.ERROR_LOCKED, "another thread is stepping this world")
        return self._world

    def close(self) -> None:
        """Frees the world. Views of its memory keep what they show. ThudError inside a callback of
        the world, which then stays open."""
        if self._world is not None:
            self.pointer  # pylint: disable=pointless-statement; refused during a step
            if not lib.thud_py_context_end_world(self._context):
                self._check(lib.THUD_ERROR_LOCKED)
            self._world = None
            ffi.release(self._context)

    def __enter__(self) -> "World":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def _check(self, result: int) -> None:
        if result != lib.THUD_OK:
            # The engine logs the reason of whatever it refuses, but for some pointers that are null.
            message = ffi.string(lib.thud_py_context_message(self._context))
            raise ThudError(Result(result), (message or ffi.string(lib.thud_result_text(result))).decode())

    def call(self, name: str, *arguments: Any) -> None:
        """Calls thud_NAME(world, ...) of the C interface; ThudError if it is refused."""
        self._check(getattr(lib, f"thud_{name}")(self.pointer, *arguments))

    def read(self, name: str, kind: str, *arguments: Any) -> Any:
        """What thud_NAME(world, ..., out) writes to a value of this type of C."""
        out = ffi.new(f"{kind} *")
        self.call(name, *arguments, out)
        return plain(out[0])

    # ---- time ----

    def step(self, steps: int = 1) -> None:
        """Runs steps; Python's other threads run meanwhile."""
        pointer = self.pointer
        self._stepping = True
        try:
            for _ in range(steps):
                self._check(lib.thud_world_step(pointer))
        finally:
            self._stepping = False

    def advance(self, elapsed: float, max_steps: int = 4) -> Tuple[int, float]:
        """Runs the whole steps that fit into this time (s) and the rest of earlier calls, at most
        max_steps. Returns how many ran, and alpha in [0, 1) for poses()."""
        steps, alpha = ffi.new("int *"), ffi.new("double *")
        pointer = self.pointer
        self._stepping = True
        try:
            self._check(lib.thud_world_advance(pointer, elapsed, max_steps, steps, alpha))
        finally:
            self._stepping = False
        return steps[0], alpha[0]

    # ---- what is in it ----

    def body(self, kind: str = "static", **options: "Unpack[BodyDefOptions]") -> "Body":
        """A new body: "static", "kinematic" or "dynamic". Options are the fields of thud_body_def."""
        def_ = ffi.new("thud_body_def *", lib.thud_default_body_def())
        fill(def_, {"kind": kind, **options}, "a body")
        out = ffi.new("thud_body_id *")
        self.call("body_create", def_, out)
        return Body(self, out[0])

    def joint(self, kind: str, body_a: Any, body_b: Any, *places: Any,
              **options: "Unpack[JointDefOptions]") -> "Joint":
        """A new joint at places in the world: "hinge", "weld" and "target" with a point, "slider" and
        "wheel" with a point and an axis, "rod" with the points that it connects, "rope" with these and a
        length. Without places it is of a thud_joint_kind, and its frames are those of the options.
        Options are the fields of thud_joint_def; `along`, `across` and `turn` are mappings with the
        fields of its drives."""
        if places:
            make = getattr(lib, f"thud_{kind}_at", None)
            if make is None:
                raise ValueError(f"there is no joint {kind!r} at places in the world")
            kinds = ffi.typeof(make).args[1:]
            if len(kinds) != 2 + len(places):
                raise TypeError(f"a {kind} takes {len(kinds) - 2} places, not {len(places)}")
            values = [pair(kind_.cname, place) if kind_.kind == "struct" else place
                      for kind_, place in zip(kinds[2:], places)]
            made = make(self.pointer, body_a.handle, body_b.handle, *values)
        else:
            made = lib.thud_default_joint_def(constant("thud_joint_kind", kind))
        def_ = ffi.new("thud_joint_def *", made)
        given: Dict[str, Any] = {} if places else {"body_a": body_a, "body_b": body_b}
        given.update(options)
        for word in ("along", "across", "turn"):
            if word in given:
                fill(def_.drive[constant("thud_direction", word)], given.pop(word), word)
        fill(def_, given, "a joint")
        out = ffi.new("thud_joint_id *")
        self.call("joint_create", def_, out)
        return Joint(self, out[0])

    def bodies(self) -> "list[Body]":
        """All bodies, in the order of their slots."""
        count = self.read("world_get_bodies", "int", ffi.NULL, 0)
        out = ffi.new("thud_body_id[]", max(count, 1))
        self.call("world_get_bodies", out, count, ffi.new("int *"))
        return [Body(self, ffi.new("thud_body_id *", out[i])[0]) for i in range(count)]

    # ---- reading ----

    def view(self, pointer: Any, count: int) -> Any:
        """An array of the world as a NumPy array, without a copy and read-only. Values are those of
        the present until the world's next call; after that they may be old."""
        if _convert.numpy is None:
            raise ImportError("views of a world need NumPy")
        kind = ffi.typeof(pointer).item
        dtype = _dtype(kind)
        if count == 0:
            return _convert.numpy.empty(0, dtype)
        array = _convert.numpy.frombuffer(self._held(pointer, count * ffi.sizeof(kind)), dtype)
        array.flags.writeable = False
        return array

    def _held(self, pointer: Any, size: int) -> Any:
        """A buffer of the world's memory, which is kept as long as the buffer."""
        context = ffi.cast("thud_py_context *", self._context)
        period = lib.thud_py_context_hold(context)
        return ffi.buffer(ffi.gc(pointer, lambda _: lib.thud_py_context_let_go(context, period)), size)

    def poses(self, alpha: float = 1.0, origin: Point = (0.0, 0.0)) -> Any:
        """The poses of all bodies by slot (Body.slot), between the last two steps: rows of x, y,
        relative to `origin`, and cosine and sine of the angle; NaN where a slot has no body. A view
        without a copy, read-only: a float32 array of NumPy, or a memoryview without NumPy. It has the
        present values until the world's next call."""
        out, count = ffi.new("thud_pose **"), ffi.new("int *")
        self.call("world_get_poses", pair("thud_pos", origin), alpha,
                  ffi.cast("thud_pose const **", out), count)
        if count[0] == 0:
            return _convert.numpy.empty((0, 4), "f4") if _convert.numpy else memoryview(b"")
        held = self._held(out[0], count[0] * ffi.sizeof("thud_pose"))
        if _convert.numpy is None:
            return memoryview(held).cast("B").cast("f", (count[0], 4)).toreadonly()
        rows = _convert.numpy.frombuffer(held, "f4").reshape(-1, 4)
        rows.flags.writeable = False
        return rows

    def events(self) -> StepEvents:
        """The events of the last step, or of all steps of the last advance; views as of view()."""
        out = ffi.new("thud_events *")
        self.call("world_get_events", out)
        count_of = {"sensor_begin_time": "sensor_begin_count", "sensor_end_time": "sensor_end_count"}
        return StepEvents(*(self.view(getattr(out, name), getattr(out, count_of.get(name, f"{name}_count")))
                        for name in StepEvents._fields))

    def step_error(self) -> StepError:
        """What the last step got wrong."""
        return self.read("world_get_step_error", "thud_step_error")

    def measure(self) -> Measure:
        """Penetration and energy of the present state."""
        return self.read("world_get_measure", "thud_measure")

    def stats(self) -> Stats:
        return self.read("world_get_stats", "thud_stats")

    def hash(self) -> int:
        """A hash of the exact position, angle and velocity of every body."""
        return self.read("world_get_hash", "uint64_t")

    def cast_ray(self, origin: Point, by: Point) -> Any:
        """The first shape on the way from `origin` by this displacement, as a RayHit, or None."""
        ray, out = ffi.new("thud_ray *"), ffi.new("thud_ray_hit *")
        ray.origin = tuple(origin)
        ray.dx, ray.dy = by
        hit = ffi.new("_Bool *")
        self.call("world_cast_ray", ray, hit, out)
        return plain(out[0]) if hit[0] else None

    # ---- snapshots ----

    def snapshot(self) -> bytes:
        """The whole state, for restore()."""
        size = self.read("world_get_snapshot_size", "size_t")
        buffer = ffi.new("char[]", size)
        self.call("world_snapshot", buffer, size, ffi.NULL)
        return bytes(ffi.buffer(buffer))

    def restore(self, snapshot: bytes) -> None:
        """Goes back to a snapshot of this world, or of one with the same options."""
        self.call("world_restore", ffi.from_buffer(snapshot), len(snapshot))


@functools.lru_cache(maxsize=None)
def _dtype(kind: Any) -> Any:
    return _convert.dtype_of(kind)


class _Object:
    """A handle in a world. It does not keep the object: a destroyed one is refused as stale."""

    _noun = ""

    def __init__(self, world: World, handle: Any):
        self.world = world
        self.handle = handle

    @property
    def slot(self) -> int:
        return self.handle.index1 - 1

    @property
    def is_valid(self) -> bool:
        return bool(getattr(lib, f"thud_{self._noun}_is_valid")(self.world.pointer, self.handle))

    def call(self, name: str, *arguments: Any) -> None:
        """Calls thud_NOUN_NAME(world, handle, ...) of the C interface."""
        self.world.call(f"{self._noun}_{name}", self.handle, *arguments)

    def destroy(self) -> None:
        self.call("destroy")

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, type(self)) and self.world is other.world and \
            (self.handle.index1, self.handle.generation) == (other.handle.index1, other.handle.generation)

    def __hash__(self) -> int:
        return hash((self.handle.index1, self.handle.generation))

    def __repr__(self) -> str:
        return f"<thud.{type(self).__name__} {self.slot}>"


class Body(_Object):
    """A body of a world."""

    _noun = "body"

    @property
    def state(self) -> BodyState:
        """All values of the body."""
        return self.world.read("body_get_state", "thud_body_state", self.handle)

    @property
    def position(self) -> Pos:
        """Of the body's origin."""
        return self.world.read("body_get_position", "thud_pos", self.handle)

    @property
    def angle(self) -> float:
        """In (-pi, pi]."""
        return self.state.angle

    @property
    def velocity(self) -> Vec2:
        """Of the centre of mass, length/s."""
        return self.state.velocity

    @property
    def angular_velocity(self) -> float:
        """rad/s"""
        return self.state.angular_velocity

    def set_transform(self, position: Point, angle: float = 0.0) -> None:
        self.call("set_transform", pair("thud_pos", position), angle)

    def set_velocity(self, velocity: Point, angular_velocity: float = 0.0) -> None:
        self.call("set_velocity", pair("thud_vec2", velocity), angular_velocity)

    def apply_impulse(self, impulse: Point, point: Optional[Point] = None) -> None:
        """mass * length / s, at a point of the world, or else at the centre of mass."""
        self.call("apply_impulse", pair("thud_vec2", impulse),
                  pair("thud_pos", self.state.center if point is None else point))

    def apply_force(self, force: Point) -> None:
        """mass * length / s^2 at the centre of mass, during the next step or advance."""
        self.call("apply_center_force", pair("thud_vec2", force))

    def apply_torque(self, torque: float) -> None:
        """mass * length^2 / s^2, likewise."""
        self.call("apply_torque", torque)

    def set_awake(self, awake: bool) -> None:
        self.call("set_awake", awake)

    def set_enabled(self, enabled: bool) -> None:
        self.call("set_enabled", enabled)

    # ---- shapes: options are the fields of thud_shape_def ----

    def circle(self, radius: float, offset: Point = (0.0, 0.0), **options: "Unpack[ShapeDefOptions]") -> "Shape":
        return self._shape("circle", options, pair("thud_vec2", offset), radius)

    def aabb(self, half_width: float, half_height: float, offset: Point = (0.0, 0.0),
             **options: "Unpack[ShapeDefOptions]") -> "Shape":
        """A box that stays parallel to the axes, and keeps its body from turning."""
        return self._shape("aabb", options, pair("thud_vec2", offset),
                           pair("thud_vec2", (half_width, half_height)))

    def obb(self, half_width: float, half_height: float, offset: Point = (0.0, 0.0), angle: float = 0.0,
            **options: "Unpack[ShapeDefOptions]") -> "Shape":
        """A box that turns with its body."""
        return self._shape("obb", options, pair("thud_vec2", offset),
                           pair("thud_vec2", (half_width, half_height)), angle)

    def terrain(self, points: Optional[Iterable[Point]] = None, slope: float = 0.0,
                **options: "Unpack[ShapeDefOptions]") -> "Shape":
        """A ground line through points with rising x; without points a straight line of this slope
        through the body's origin. Only on a static body with angle 0."""
        line = ffi.new("thud_terrain *")
        if points is None:
            line.kind, line.slope = lib.THUD_TERRAIN_FLAT, slope
        else:
            places = ffi.new("thud_pos[]", [tuple(point) for point in points])
            line.kind, line.points, line.count = lib.THUD_TERRAIN_IRREGULAR, places, len(places)
        return self._shape("terrain", options, line)

    def _shape(self, kind: str, options: Any, *arguments: Any) -> "Shape":
        def_ = ffi.new("thud_shape_def *", lib.thud_default_shape_def())
        fill(def_, options, "a shape")
        out = ffi.new("thud_shape_id *")
        self.world.call(f"shape_create_{kind}", self.handle, def_, *arguments, out)
        return Shape(self.world, out[0])


class Shape(_Object):
    """A shape of a body."""

    _noun = "shape"

    @property
    def state(self) -> ShapeState:
        """All values of the shape."""
        return self.world.read("shape_get_state", "thud_shape_state", self.handle)

    def dig(self, center: Point, radius: float) -> None:
        """Removes the ground of a terrain inside a circle."""
        self.call("dig", pair("thud_pos", center), radius)


class Joint(_Object):
    """A joint between two bodies."""

    _noun = "joint"

    @property
    def state(self) -> JointState:
        """Coordinates, gaps and forces of the joint."""
        return self.world.read("joint_get_state", "thud_joint_state", self.handle)
