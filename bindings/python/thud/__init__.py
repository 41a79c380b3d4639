"""thud: rigid bodies in two dimensions, for games; the same bits on every machine.

    import thud

    world = thud.World(gravity=(0, -10))
    world.body().terrain()
    ball = world.body("dynamic", position=(0, 5))
    ball.circle(0.5)
    world.step(120)
    print(ball.position.y)

Units are the caller's own; y is up, angles are radians, counter-clockwise. Every field of the
engine's defs is an option of the same name. Enums and objects of the engine are named in lower case
without their prefix: kind="dynamic", quality="high". A call that is refused has changed nothing,
and raises ThudError with the engine's message. All of the C interface is in `ffi` and `lib`.
"""

from ._batch import Batch
from ._native import ffi, lib
from ._records import *  # noqa: F403
from ._world import Body, Joint, Shape, StepEvents, ThudError, World

__version__ = ".".join(str(part) for part in (
    lib.THUD_VERSION_MAJOR, lib.THUD_VERSION_MINOR, lib.THUD_VERSION_PATCH))
__all__ = ["Batch", "Body", "Joint", "Shape", "StepEvents", "ThudError", "World", "ffi", "lib"]
