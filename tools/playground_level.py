"""Makes the level assets/levels/playground.tmj, which has joints of each kind. tools/make_levels.py
calls it with the other levels. Lengths are in metres, which are tiles, with y up."""

import math

from tiled_map import Map

GROUND = 6
# Category and mask of bodies that collide with nothing, not even with each other. A mask of 0 would
# also hide them from queries.
THROUGH = {"category": 32, "mask": 16}


class Playground:
    """The map, its layers, and short functions that add static and dynamic bodies and joints. Each
    returns the id of its object."""

    def __init__(self):
        self.map = Map(60, 30, title="Playground", camera_x=30.0, camera_y=13.4, camera_height=34.0,
                       about="Swings, a seesaw, a big wheel and a car on its way over a rope "
                             "bridge and a drawbridge: all of it hangs on joints.")
        self.ground = self.map.object_layer("ground", friction=0.9)
        self.bodies = self.map.object_layer("bodies", body="dynamic", friction=0.7)
        self.joints = self.map.object_layer("joints")

    def box(self, x, y, width, height, degrees=0, **custom):
        return self.map.box(self.bodies, x, y, width, height, degrees, custom=custom)

    def circle(self, x, y, radius, **custom):
        return self.map.circle(self.bodies, x, y, radius, custom=custom)

    def still(self, x, y, width, height, degrees=0, **custom):
        """A static box."""
        return self.map.box(self.ground, x, y, width, height, degrees, custom=custom)

    def tie(self, kind, places, a=None, b=None, **custom):
        """A joint, see Map.tie."""
        return self.map.tie(self.joints, kind, places, a, b, **custom)

    def plank(self, start, end, thickness, **custom):
        """A dynamic box from one place to another."""
        (x0, y0), (x1, y1) = start, end
        degrees = -math.degrees(math.atan2(y1 - y0, x1 - x0))
        return self.box((x0 + x1) / 2, (y0 + y1) / 2, math.hypot(x1 - x0, y1 - y0), thickness,
                        degrees, **custom)

    def chain(self, places, thickness, a=None, b=None, **custom):
        """Boxes from place to place with hinges between them; the first hangs on body a, the last
        on body b or on nothing."""
        for start, end in zip(places, places[1:]):
            link = self.plank(start, end, thickness, **custom)
            self.tie("hinge", [start], a, link)
            a = link
        if b is not None:
            self.tie("hinge", [places[-1]], a, b)


def between(start, end, count):
    """count + 1 places at equal distances from start to end."""
    (x0, y0), (x1, y1) = start, end
    return [(x0 + (x1 - x0) * i / count, y0 + (y1 - y0) * i / count) for i in range(count + 1)]


def draw_ground(p):
    p.map.line(p.ground, [
        (0, 12), (1, 12), (1.8, 6.6), (3, GROUND), (29.5, GROUND), (31, 6.3), (31.6, 6.3),
        (32.4, 2.6), (34, 1.6), (39, 1.4), (41.6, 2.6), (42.4, 6.3), (43, 6.3), (44.3, GROUND),
        (45.4, GROUND), (45.6, 3), (51, 3), (51.2, GROUND), (58.6, GROUND), (58.8, 7),
        (59.2, 12), (60, 12)], name="ground")
    p.still(-0.5, 40, 1, 60)
    p.still(60.5, 40, 1, 60)
    p.still(58.2, 7.2, 0.3, 2.4, friction=0.05)  # the car cannot climb it


def draw_swings(p):
    """Two swings on chains below one beam, which start at different heights."""
    beam = p.still(8.2, 13, 8, 0.3)
    for x, lean in ((4.4, 7), (12.0, -7)):
        p.still(x, 9.4, 0.22, 7, lean, sensor=True)
    for x, degrees in ((6.2, -34), (10.4, -24)):
        a = math.radians(degrees)
        hooks = [(x + side, 12.85) for side in (-0.55, 0.55)]
        ends = [(hook + 5 * math.sin(a), y - 5 * math.cos(a)) for hook, y in hooks]
        middle = ((ends[0][0] + ends[1][0]) / 2, ends[0][1])
        seat = p.box(*middle, 1.4, 0.18, density=5.0)
        child = p.box(middle[0], middle[1] + 0.39, 0.4, 0.6, density=0.6)
        p.tie("weld", [(middle[0], middle[1] + 0.09)], seat, child)
        for hook, end in zip(hooks, ends):
            p.chain(between(hook, end, 8), 0.1, beam, seat, density=2.0, **THROUGH)


def draw_seesaw(p):
    post = p.still(17, 6.6, 0.7, 1.2)
    plank = p.box(17, 7.4, 8, 0.25, 12, density=1.5, friction=0.9)
    p.tie("hinge", [(17, 7.4)], post, plank, turn_lower=-0.09, turn_upper=0.45,
          turn_motor_force=1.0)
    for x, y, size in ((20.2, 7.2, 0.8), (19.2, 7.4, 0.7)):
        p.box(x, y + 0.1, size, size, 12, density=0.7)
    p.box(14.6, 17, 1.4, 1.4, density=2.5)


def draw_big_wheel(p):
    """A cross with gondolas that a motor turns, and a gear from its axle to a small wheel."""
    x, y, arm, half = 25, 15.5, 5, 0.15
    axle = p.still(x, y, 0.5, 0.5, sensor=True)
    outline = [(-half, arm), (half, arm), (half, half), (arm, half), (arm, -half), (half, -half),
               (half, -arm), (-half, -arm), (-half, -half), (-arm, -half), (-arm, half),
               (-half, half)]
    cross = p.map.line(p.bodies, [(x + px, y + py) for px, py in outline], "polygon")
    hub = p.tie("hinge", [(x, y)], axle, cross, turn_motor_speed=0.6, turn_motor_force=4000.0)
    for px, py in ((arm, 0), (0, arm), (-arm, 0), (0, -arm)):
        px, py = x + px * 0.96, y + py * 0.96
        gondola = p.box(px, py - 0.7, 1.3, 0.9, density=0.8)
        p.tie("hinge", [(px, py)], cross, gondola, turn_motor_force=1.5)
    small = p.circle(x + 7.4, y, 1.2)
    turned = p.tie("hinge", [(x + 7.4, y)], b=small)
    p.tie("gear", [(x, y), (x + 7.4, y)], hub, turned, ratio=0.25)
    mark = p.box(x + 7.4, y + 1.7, 0.3, 1.0)
    p.tie("weld", [(x + 7.4, y + 1.2)], small, mark)


def draw_bridges(p):
    """A rope bridge, which hangs on the world, and a drawbridge that a motor lowers."""
    count, sag, x0, x1 = 14, 0.45, 31.6, 42.4

    def rope(i):
        t = 2 * i / count - 1
        return x0 + (x1 - x0) * i / count, 6.15 - sag * (1 - t * t)
    places = [rope(i) for i in range(count + 1)]
    before = None
    for start, end in zip(places, places[1:]):
        link = p.plank(start, end, 0.2, density=6.0, friction=0.9)
        p.tie("hinge", [start], before, link, turn_motor_force=4.0)  # friction between planks
        before = link
    p.tie("hinge", [places[-1]], b=before)

    up = math.radians(72)
    start = (45.75, 5.85)
    bridge = p.plank(start, (start[0] + 5.1 * math.cos(up), start[1] + 5.1 * math.sin(up)), 0.3,
                     density=1.5, friction=0.9)
    p.tie("hinge", [start], b=bridge, turn_lower=-round(up, 4), turn_upper=0.0,
          turn_motor_speed=-0.3, turn_motor_force=600.0)


def draw_car(p):
    """A car with suspension and a motor in both wheels."""
    x, y = 22.5, GROUND + 0.75
    body = [(-1.6, 0.3), (-0.9, 0.3), (-0.9, 0.85), (0.5, 0.85), (0.5, 0.3), (1.6, 0.3),
            (1.6, -0.25), (-1.6, -0.25)]
    chassis = p.map.line(p.bodies, [(x + px, y + py) for px, py in body], "polygon", name="car")
    for side in (-1.05, 1.05):
        wheel = p.circle(x + side, y - 0.3, 0.45, friction=1.2)
        p.tie("wheel", [(x + side, y - 0.3)], chassis, wheel, along_frequency=4.0,
              along_lower=-0.25, along_upper=0.25, turn_motor_speed=-9.0, turn_motor_force=14.0)


def draw_palm(p, x, leaning):
    """A palm of welds with springs: a trunk and leaves, which sway at first."""
    before, y = None, float(GROUND)
    for i in range(7):
        top = (x + leaning * (i + 1) ** 1.6 / 14, y + 0.8)
        start = (x + leaning * i ** 1.6 / 14, y)
        trunk = p.plank(start, top, 0.42 - 0.03 * i, density=0.8, **THROUGH)
        p.tie("weld", [start], before, trunk, turn_frequency=45.0 - 5.0 * i, turn_damping=0.02)
        before, y = trunk, top[1]
    for degrees in (-15, 25, 65, 115, 155, 195):
        a = math.radians(degrees)
        end = (top[0] + 1.5 * math.cos(a), top[1] + 1.5 * math.sin(a))
        leaf = p.plank(top, end, 0.16, density=0.15, **THROUGH)
        p.tie("weld", [top], before, leaf, turn_frequency=4.0, turn_damping=0.1)


def draw_balloons(p):
    """Balloons and a kite with negative gravity, on strings."""
    for i, (dx, dy) in enumerate(((-1.2, 5.0), (0.1, 5.8), (1.4, 5.1))):
        x, y = 55.6 + 0.12 * i, GROUND + 0.05
        top = (55.6 + dx, y + dy)
        balloon = p.circle(top[0], top[1] + 0.55, 0.55, density=0.3, gravity_scale=-2.0,
                           linear_damping=0.4)
        p.chain(between((x, y), top, 9), 0.06, None, balloon, density=0.3, **THROUGH)
    kite = p.box(57, 16, 1.6, 0.2, -20, density=0.4, gravity_scale=-1.0)
    p.tie("distance", [(56.6, GROUND), (57, 16)], b=kite, along_lower=0.0)


def draw_air(p):
    """A tray that a target joint holds in the air, and a mat on a spring with a ball on it."""
    tray = p.box(38.5, 17.5, 4.4, 0.25, density=1.0)
    p.tie("target", [(38.5, 17.5)], b=tray, along_frequency=1.2, across_frequency=1.2,
          turn_frequency=1.2, turn_damping=0.4)
    for i in range(3):
        for k in range(3 - i):
            p.box(38.5 + 0.82 * (k - (2 - i) / 2), 18.05 + 0.8 * i, 0.78, 0.78, density=0.4)
    mat = p.box(48.3, 11, 3, 0.25, density=1.0)
    p.tie("slider", [(48.3, 11), (48.3, 12)], b=mat, along_frequency=2.2, along_damping=0.05,
          along_lower=-1.5, along_upper=1.5)
    for x in (46.6, 50.0):
        p.still(x, 11.2, 0.2, 2.6)
    p.circle(48.3, 18, 0.6, density=0.7, restitution=0.4)


def draw_pit(p):
    """Balls in the pit below the rope bridge."""
    for i in range(48):
        p.circle(33.9 + 0.56 * (i % 12) + 0.05 * (i // 12), 2.2 + 0.6 * (i // 12), 0.26,
                 density=0.4, restitution=0.3)


def playground():
    """Writes the level."""
    p = Playground()
    draw_ground(p)
    draw_swings(p)
    draw_seesaw(p)
    draw_big_wheel(p)
    draw_bridges(p)
    draw_car(p)
    draw_palm(p, 2.6, -1)
    draw_palm(p, 52.4, 1)
    draw_balloons(p)
    draw_air(p)
    draw_pit(p)
    p.map.spawn(p.map.object_layer("places"), 30, 22)
    p.map.write("playground")
