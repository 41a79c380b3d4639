/* test_sensors_random.c: random worlds whose bodies are created, destroyed, moved, put to sleep and
 * disabled. After every step the pairs that sensor events have left open are those that overlap by
 * geometry, which is tested for each pair of shapes. */
#include "engine_support.h"
#include "every_choice.h"
#include "share.h"

enum { BODIES = 26, SHAPES_MAX = 256, STEPS = 200, LINE = 9 };
/* Distance in metres below which a pair may count as overlapping or not. */
#define NEARLY 2e-4

/* A random world, and the pairs that its sensor events have left open. */
typedef struct chaos {
    thud_world *world;
    thud_body_id bodies[BODIES], ground;
    thud_shape_id line;
    uint64_t seed;
    /* Whether a sensor sees a shape, by their slots, according to the events so far. */
    bool open[SHAPES_MAX][SHAPES_MAX];
    int passed;
    int begun, asleep_begun; /* asleep: begun while neither body was awake */
} chaos;

static int pick(chaos *c, int count) {
    return (int)random_in(&c->seed, 0, (double)count);
}

/* ---- reference ---- */

/* A shape as the reference sees it. */
typedef struct seen_shape {
    bool there, sensor, awake;
    thud_body_kind kind;
    uint32_t body;
    thud_filter filter;
    bool is_line;
    thud_geometry placed;
    thud_terrain line;
} seen_shape;

/* Reads a shape with its pose, for the reference. */
static void look_at(const chaos *c, thud_shape_id id, seen_shape *out) {
    thud_shape_state shape;
    OK(thud_shape_get_state(c->world, id, &shape));
    thud_body_state body = state_of(c->world, shape.body);
    double x = (double)shape.offset.x, y = (double)shape.offset.y;
    double cs = (double)body.cosine, sn = (double)body.sine;
    *out = (seen_shape){.there = body.enabled,
                        .sensor = shape.sensor,
                        .awake = body.awake,
                        .kind = body.kind,
                        .body = shape.body.index1,
                        .filter = shape.filter,
                        .is_line = shape.kind == THUD_SHAPE_TERRAIN};
    out->placed = (thud_geometry){.kind = shape.kind,
                                  .x = body.position.x + cs * x - sn * y,
                                  .y = body.position.y + sn * x + cs * y,
                                  .c = shape.kind == THUD_SHAPE_OBB ? cs : 1.0,
                                  .s = shape.kind == THUD_SHAPE_OBB ? sn : 0.0,
                                  .hx = (double)shape.half_extents.x,
                                  .hy = (double)shape.half_extents.y};
    if (out->is_line) {
        OK(thud_shape_get_terrain(c->world, id, &out->line));
    }
}

/* Reads all shapes, by their slots. */
static void look_around(const chaos *c, seen_shape *shapes) {
    memset(shapes, 0, SHAPES_MAX * sizeof *shapes);
    for (int i = 0; i <= BODIES; i++) {
        thud_shape_id ids[16];
        int count = 0;
        thud_body_id body = i < BODIES ? c->bodies[i] : c->ground;
        if (thud_body_is_valid(c->world, body)) {
            OK(thud_body_get_shapes(c->world, body, ids, 16, &count));
        }
        for (int k = 0; k < count; k++) {
            assert_true(ids[k].index1 <= SHAPES_MAX);
            look_at(c, ids[k], &shapes[ids[k].index1 - 1]);
        }
    }
}

/* Whether filters let two shapes collide. */
static bool filters_meet(const thud_filter *a, const thud_filter *b) {
    return a->group == b->group && a->group ? a->group > 0
                                            : (a->mask & b->category) && (b->mask & a->category);
}

static double distance_of(const seen_shape *a, const seen_shape *b) {
    thud_closest c = {.distance = 1};
    if (a->is_line) {
        thud_geometry relative = b->placed;
        relative.x -= a->placed.x;
        relative.y -= a->placed.y;
        OK(thud_terrain_closest(&a->line, &relative, &c));
    } else {
        OK(thud_geometry_closest(&a->placed, &b->placed, &c));
    }
    return c.distance;
}

/* Asserts that the open pairs are those that overlap. */
static void check(const chaos *c, const seen_shape *shapes, int step) {
    for (int i = 0; i < SHAPES_MAX; i++) {
        for (int k = 0; k < SHAPES_MAX; k++) {
            const seen_shape *s = &shapes[i], *v = &shapes[k];
            bool may = s->there && v->there && s->sensor && s->body != v->body &&
                       (s->kind != THUD_BODY_STATIC || v->kind != THUD_BODY_STATIC) &&
                       filters_meet(&s->filter, &v->filter);
            double distance = !may ? 1 : v->is_line ? distance_of(v, s) : distance_of(s, v);
            if (c->open[i][k] != (distance < 0) && fabs(distance) > NEARLY) {
                fail_msg("step %d, seed %d: sensor %d (body kind %d) and shape %d (body kind %d), "
                         "%g apart: %s",
                         step, (int)c->seed, i, (int)s->kind, k, (int)v->kind, distance,
                         c->open[i][k] ? "seen" : "not seen");
            }
        }
    }
}

/* ---- a world that is edited in every step ---- */

static void add_random_shape(chaos *c, thud_body_id body) {
    static const thud_filter filters[] = {
        {1, UINT32_MAX, 0}, {2, UINT32_MAX, 0}, {4, 2, 0}, {1, UINT32_MAX, -1}, {8, 0, 2}};
    thud_shape_def def = thud_default_shape_def();
    def.sensor = pick(c, 3) == 0;
    def.filter = filters[pick(c, 2) ? 0 : pick(c, 5)];
    float x = (float)random_in(&c->seed, 0.1, 0.8), y = (float)random_in(&c->seed, 0.1, 0.8);
    thud_vec2 offset = {(float)random_in(&c->seed, -0.4, 0.4), 0};
    if (pick(c, 3) == 0) {
        OK(thud_shape_create_circle(c->world, body, &def, offset, x, NULL));
    } else {
        OK(thud_shape_create_obb(c->world, body, &def, offset, (thud_vec2){x, y}, 0, NULL));
    }
}

static void add_random_body(chaos *c, int i) {
    thud_body_kind kind = (thud_body_kind)(pick(c, 5) > 2 ? THUD_BODY_DYNAMIC : pick(c, 3));
    c->bodies[i] = add_body(c->world, kind, random_in(&c->seed, -6, 6), random_in(&c->seed, -1, 5),
                            random_in(&c->seed, -1, 1));
    for (int shapes = pick(c, 2); shapes >= 0; shapes--) {
        add_random_shape(c, c->bodies[i]);
    }
    if (kind == THUD_BODY_KINEMATIC) {
        thud_vec2 v = {(float)random_in(&c->seed, -2, 2), (float)random_in(&c->seed, -1, 1)};
        OK(thud_body_set_velocity(c->world, c->bodies[i], v, 0.5f));
    }
}

static void add_ground(chaos *c) {
    thud_pos points[LINE];
    for (int i = 0; i < LINE; i++) {
        points[i] = (thud_pos){2 * i - 8.0, random_in(&c->seed, -1.3, -0.7)};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = LINE};
    thud_shape_def def = thud_default_shape_def();
    def.sensor = pick(c, 4) == 0;
    c->ground = add_body(c->world, THUD_BODY_STATIC, 0, 0, 0);
    OK(thud_shape_create_terrain(c->world, c->ground, &def, &line, &c->line));
    def.sensor = false;
    OK(thud_shape_create_aabb(c->world, c->ground, &def, (thud_vec2){0, -4}, (thud_vec2){14, 1},
                              NULL));
}

static void edit_ground(chaos *c) {
    double x = random_in(&c->seed, -7, 7);
    switch (pick(c, 4)) {
    case 0:
        OK(thud_body_destroy(c->world, c->ground));
        add_ground(c);
        break;
    case 1:
        OK(thud_body_set_transform(c->world, c->ground, (thud_pos){0, random_in(&c->seed, -1, 1)},
                                   0));
        break;
    case 2:
        OK(thud_shape_dig(c->world, c->line, (thud_pos){x, -1}, 0.5));
        break;
    default:
        OK(thud_shape_raise(c->world, c->line, x, 1.0, 0.4));
    }
}

static void edit(chaos *c) {
    thud_world *w = c->world;
    int i = pick(c, BODIES);
    thud_body_id body = c->bodies[i];
    thud_shape_id shapes[16];
    int count;
    if (!thud_body_is_valid(w, body)) {
        add_random_body(c, i);
        return;
    }
    switch (pick(c, 7)) {
    case 0:
        OK(thud_body_destroy(w, body));
        break;
    case 1:
    case 2:
        OK(thud_body_set_transform(w, body,
                                   (thud_pos){random_in(&c->seed, -6, 6),
                                              random_in(&c->seed, -1, 4)},
                                   random_in(&c->seed, -1, 1)));
        break;
    case 3:
        OK(thud_body_set_enabled(w, body, pick(c, 3) != 0));
        break;
    case 4:
        if (state_of(w, body).shape_count < 4) {
            add_random_shape(c, body);
        }
        break;
    case 5:
        if (state_of(w, body).kind == THUD_BODY_DYNAMIC) {
            OK(thud_body_set_awake(w, body, pick(c, 4) == 0));
        }
        break;
    default:
        OK(thud_body_get_shapes(w, body, shapes, 16, &count));
        if (count > 1) {
            OK(thud_shape_destroy(w, shapes[pick(c, count)]));
        }
    }
}

/* Puts all bodies to sleep. */
static void lull(chaos *c) {
    for (int i = 0; i < BODIES; i++) {
        if (thud_body_is_valid(c->world, c->bodies[i]) &&
            state_of(c->world, c->bodies[i]).kind == THUD_BODY_DYNAMIC) {
            OK(thud_body_set_awake(c->world, c->bodies[i], false));
        }
    }
}

/* Moves a static body while others sleep. */
static void shift_still(chaos *c) {
    int i = pick(c, BODIES), tried = 0;
    while (tried < BODIES && !(thud_body_is_valid(c->world, c->bodies[i]) &&
                               state_of(c->world, c->bodies[i]).kind == THUD_BODY_STATIC)) {
        i = (i + 1) % BODIES;
        tried++;
    }
    if (tried < BODIES) {
        thud_pos at = {random_in(&c->seed, -6, 6), random_in(&c->seed, -1, 2)};
        OK(thud_body_set_transform(c->world, c->bodies[i], at, random_in(&c->seed, -1, 1)));
    }
}

/* Index of a pair in a list of events, or -1. */
static int place_of(const thud_contact_event *pair, const thud_contact_event *list, int count) {
    int i = count - 1;
    while (i >= 0 && memcmp(pair, &list[i], sizeof *pair) != 0) {
        i--;
    }
    return i;
}

/* Books the events of a step. A pair that ended and was not open has passed: it began in the same
 * step. */
static void book(chaos *c, const seen_shape *shapes) {
    thud_events e = thud_events_of(c->world);
    for (int i = 0; i < e.sensor_end_count; i++) {
        const thud_contact_event *pair = &e.sensor_end[i];
        bool *open = &c->open[pair->shape_a.index1 - 1][pair->shape_b.index1 - 1];
        int begun = place_of(pair, e.sensor_begin, e.sensor_begin_count);
        assert_true(*open || begun >= 0);
        c->passed += !*open;
        assert_true(*open || e.sensor_begin_time[begun] <= e.sensor_end_time[i]);
        *open = !*open;
    }
    for (int i = 0; i < e.sensor_begin_count; i++) {
        const thud_contact_event *pair = &e.sensor_begin[i];
        bool *open = &c->open[pair->shape_a.index1 - 1][pair->shape_b.index1 - 1];
        assert_true(e.sensor_begin_time[i] >= 0 && e.sensor_begin_time[i] <= 1);
        if (*open) {
            assert_true(place_of(pair, e.sensor_end, e.sensor_end_count) >= 0);
            *open = false;
            continue;
        }
        *open = true;
        c->begun++;
        c->asleep_begun +=
            !shapes[pair->shape_a.index1 - 1].awake && !shapes[pair->shape_b.index1 - 1].awake;
    }
}

/* Counts over all worlds, asserted at the end. */
static int asleep_in_all, begun_in_all;

static void run_chaos(const thud_detection *detection, const thud_broadphase *broadphase,
                      uint64_t seed) {
    chaos *c = calloc(1, sizeof *c);
    seen_shape *shapes = calloc(SHAPES_MAX, sizeof *shapes);
    thud_world_def def = thud_default_world_def();
    def.detection = detection;
    def.broadphase = broadphase;
    def.contact_events = seed % 2 == 0; /* sensor events do not depend on it */
    c->seed = seed;
    c->world = make_world(def);
    add_ground(c);
    for (int i = 0; i < BODIES; i++) {
        add_random_body(c, i);
    }
    for (int i = 0; i < STEPS; i++) {
        bool quiet = i % 100 > 20; /* long enough for islands to fall asleep */
        for (int edits = pick(c, 4); edits > 0; edits--) {
            quiet ? shift_still(c) : edit(c);
        }
        if (!quiet && pick(c, 6) == 0) {
            edit_ground(c);
        }
        if (i % 100 == 40) {
            lull(c);
        }
        run(c->world, 1);
        look_around(c, shapes);
        book(c, shapes);
        check(c, shapes, i);
    }
    begun_in_all += c->begun;
    asleep_in_all += c->asleep_begun;
    thud_world_destroy(c->world);
    free(shapes);
    free(c);
}

static void sensors_see_what_geometry_does_in_every_world(void **state) {
    (void)state;
    for (int d = 0; d < 4; d++) {
        for (int b = 0; b < 3; b++) {
            /* Chosen: in most worlds nothing begins while both bodies sleep. */
            uint64_t first = 10;
            for (uint64_t seed = first; seed < first + (uint64_t)share_of(4); seed++) {
                run_chaos(detections[d], broadphases[b], seed * 104729 + (uint64_t)d);
            }
        }
    }
    assert_true(begun_in_all > share_of(2000));
    assert_true(asleep_in_all > share_of(30));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sensors_see_what_geometry_does_in_every_world),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
