/* test_slides.c: a body slides over ground of many pieces as over the same ground of one piece, at
 * every quality and detection: static tiles, shapes of one body, which may itself move, and
 * terrains between boxes. Measured are the greatest differences of height and of speed between the
 * two runs. Boxes used to stop or to hop there, by up to a sixth of their size, under `bisect` and
 * `swept` at high and exact, and on every raft. */
#include "engine_support.h"
#include "every_choice.h"
#include "share.h"

/* Length of the ground; steps until the slider has settled. */
enum { LENGTH = 60, SETTLE = 30 };

typedef enum floor_kind {
    TILES,       /* a static body each */
    SHAPES,      /* five on each static body */
    STILL_RAFT,  /* one kinematic body of boxes */
    MOVING_RAFT, /* the same, moving against the slider */
    HEAVY_RAFT,  /* one dynamic body, without gravity */
    LINES,       /* alternating with boxes */
    FLOORS
} floor_kind;

enum { CIRCLE, AABB, OBB, THREE_OBBS, MOVERS };

/* A case. */
typedef struct slide {
    floor_kind floor;
    bool upright; /* AABBs; else OBBs */
    int mover;
    double speed;
    float friction;
    const thud_quality *quality;
    const thud_detection *detection;
} slide;

static thud_shape_def surface_of(const slide *s) {
    thud_shape_def def = thud_default_shape_def();
    def.friction = s->friction;
    def.density = s->floor == HEAVY_RAFT ? 1e5f : 1.0f;
    return def;
}

static void add_piece(thud_world *world, const slide *s, thud_body_id body, double from,
                      double length) {
    thud_shape_def def = surface_of(s);
    thud_vec2 at = {(float)(from + 0.5 * length), -0.5f}, half = {(float)(0.5 * length), 0.5f};
    if (s->upright) {
        OK(thud_shape_create_aabb(world, body, &def, at, half, NULL));
    } else {
        OK(thud_shape_create_obb(world, body, &def, at, half, 0, NULL));
    }
}

static void add_line(thud_world *world, const slide *s, double from, int length) {
    thud_pos points[LENGTH + 1];
    for (int i = 0; i <= length; i++) {
        points[i] = (thud_pos){from + i, 0};
    }
    thud_shape_def def = surface_of(s);
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = length + 1};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &def, &line,
                                 NULL));
}

/* Adds pieces of length 1, or one piece of the whole length. */
static void add_pieces(thud_world *world, const slide *s, thud_body_id body, bool whole, int from,
                       int length) {
    for (int i = 0; i < (whole ? 1 : length); i++) {
        add_piece(world, s, body, from + i, whole ? length : 1);
    }
}

/* Adds the case's ground, in one piece (`whole`) or in many. */
static void add_ground(thud_world *world, const slide *s, bool whole) {
    int step = s->floor == TILES ? 1 : s->floor == SHAPES ? 5 : 10;
    if (s->floor == LINES && whole) {
        add_line(world, s, 0, LENGTH);
    } else if (s->floor == LINES) {
        for (int i = 0; i < LENGTH; i += 2 * step) {
            add_line(world, s, i, step);
            add_piece(world, s, add_body(world, THUD_BODY_STATIC, 0, 0, 0), i + step, step);
        }
    } else if (s->floor < STILL_RAFT) {
        for (int i = 0; i < LENGTH; i += whole ? LENGTH : step) {
            thud_body_id body = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            add_pieces(world, s, body, whole, i, whole ? LENGTH : step);
        }
    } else {
        thud_body_def def = thud_default_body_def();
        thud_body_id raft;
        def.kind = s->floor == HEAVY_RAFT ? THUD_BODY_DYNAMIC : THUD_BODY_KINEMATIC;
        def.velocity.x = s->floor == MOVING_RAFT ? -1 : 0;
        def.gravity_scale = 0;
        OK(thud_body_create(world, &def, &raft));
        add_pieces(world, s, raft, whole, 0, LENGTH);
    }
}

static thud_body_id add_mover(thud_world *world, const slide *s) {
    thud_shape_def def = thud_default_shape_def();
    def.friction = s->friction;
    thud_body_id body = add_body(world, THUD_BODY_DYNAMIC, 5.3, (s->mover ? 0.3 : 0.5) + 0.004, 0);
    if (s->mover != THREE_OBBS) {
        add_shape(world, body, s->mover ? 0.4f : 0.5f, s->mover ? 0.3f : 0, s->mover == AABB, &def);
    }
    for (int i = -1; i <= 1 && s->mover == THREE_OBBS; i++) {
        thud_vec2 at = {0.4f * (float)i, 0}, half = {0.2f, 0.3f};
        OK(thud_shape_create_obb(world, body, &def, at, half, 0, NULL));
    }
    return body;
}

/* Motion of the slider, by steps. */
typedef struct track {
    double x[400], y[400], speed[400];
    int steps;
} track;

/* Slides the body over the ground and records its motion. */
static track run_slide(const slide *s, bool whole) {
    thud_world_def def = thud_default_world_def_of(s->quality);
    def.sleeping = false;
    def.detection = s->detection;
    thud_world *world = make_world(def);
    add_ground(world, s, whole);
    thud_body_id body = add_mover(world, s);
    run(world, SETTLE);
    OK(thud_body_set_velocity(world, body, (thud_vec2){(float)s->speed, 0}, 0));
    track t = {.steps = (int)fmin(240, (LENGTH - 10) / s->speed * 60)};
    for (int i = 0; i < t.steps; i++) {
        run(world, 1);
        thud_body_state at = state_of(world, body);
        t.x[i] = at.position.x;
        t.y[i] = at.position.y;
        t.speed[i] = (double)at.velocity.x;
        assert_int_equal(thud_stats_of(world).held_bodies, 0);
    }
    thud_world_destroy(world);
    return t;
}

/* Bounds of the difference in height and of the relative loss of speed. A soft contact gives way a
 * little where the body passes to the next piece, and friction depends on it, more so where the
 * ground itself moves, and where pieces lie on pieces. Under bisect and swept contacts are solved
 * directly, and keep any gap up to 0.003 at draft and default, so that the height may differ by as
 * much as load presses a contact together in a step. */
static void limits_of(const slide *s, double *hop, double *loss) {
    bool draft = s->quality == &thud_quality_draft,
         moves = s->floor >= STILL_RAFT && s->floor < LINES;
    bool cheap = draft || s->quality == &thud_quality_default;
    bool direct = s->detection == &thud_detection_bisect || s->detection == &thud_detection_swept;
    bool soft = cheap && !direct;
    *hop = cheap && direct ? 2e-4 : !soft ? 1e-4 : (draft ? 6e-4 : 1e-4) * (moves ? 3 : 1);
    *loss = !soft || s->friction == 0 ? 1e-3 : draft ? 0.02 : 0.01;
    if (s->mover == THREE_OBBS && s->quality != &thud_quality_exact) {
        *hop = 2.5e-3;
        *loss = s->friction == 0 ? 5e-3 : 0.06;
    }
}

/* Asserts that the slider moves over pieces as over the whole ground, within the bounds. */
static void compare(const slide *s) {
    track whole = run_slide(s, true), pieces = run_slide(s, false);
    double most_hop, most_loss, hop = 0, loss = 0;
    limits_of(s, &most_hop, &most_loss);
    for (int i = 0; i < whole.steps; i++) {
        hop = fmax(hop, fabs(pieces.y[i] - whole.y[i]));
        loss = fmax(loss, fabs(pieces.speed[i] - whole.speed[i]) / s->speed);
    }
    if (!(hop <= most_hop && loss <= most_loss)) {
        int quality = 0;
        while (qualities[quality] != s->quality) {
            quality++;
        }
        fail_msg("floor %d of %s, mover %d at %g, friction %g, quality %d, %s: hop %g, loss %g",
                 (int)s->floor, s->upright ? "AABBs" : "OBBs", s->mover, s->speed,
                 (double)s->friction, quality, thud_detection_name(s->detection), hop, loss);
    }
}

/* Where a build runs a share of the settings (TEST_SHARE), each value of each setting occurs as
 * long as TEST_SHARE has no factor 2 or 5. */
static void compare_all(floor_kind floor) {
    const double speeds[] = {3.117, 9.37, 31.77, 120};
    for (int i = 0; i < QUALITIES * 4 * MOVERS * 2 * 2 * 4; i += TEST_SHARE) {
        int rest = i;
        slide s = {.floor = floor, .quality = qualities[rest % QUALITIES]};
        s.detection = detections[(rest /= QUALITIES) % 4];
        s.mover = (rest /= 4) % MOVERS;
        s.upright = (rest /= MOVERS) % 2;
        s.friction = (rest /= 2) % 2 ? 0.6f : 0.0f;
        s.speed = speeds[(rest /= 2) % 4];
        compare(&s);
    }
}

static void static_tiles_are_slid_over_as_one_floor(void **state) {
    (void)state;
    compare_all(TILES);
}

static void shapes_of_static_bodies_are_slid_over_as_one_floor(void **state) {
    (void)state;
    compare_all(SHAPES);
}

static void boxes_of_a_kinematic_body_are_slid_over_as_one_floor(void **state) {
    (void)state;
    compare_all(STILL_RAFT);
    compare_all(MOVING_RAFT);
}

static void boxes_of_a_dynamic_body_are_slid_over_as_one_floor(void **state) {
    (void)state;
    compare_all(HEAVY_RAFT);
}

static void lines_between_boxes_are_slid_over_as_one_floor(void **state) {
    (void)state;
    compare_all(LINES);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(static_tiles_are_slid_over_as_one_floor),
        cmocka_unit_test(shapes_of_static_bodies_are_slid_over_as_one_floor),
        cmocka_unit_test(boxes_of_a_kinematic_body_are_slid_over_as_one_floor),
        cmocka_unit_test(boxes_of_a_dynamic_body_are_slid_over_as_one_floor),
        cmocka_unit_test(lines_between_boxes_are_slid_over_as_one_floor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
