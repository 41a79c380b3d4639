/* test_query_worlds.c: queries of random worlds against the geometry functions, which need no
 * world, applied to every single shape; and the same answers, bit for bit, with every broadphase.
 *
 * A case is one query of one world. Where a result changes within the distance GRAZE, either answer
 * is accepted: the world keeps positions to 2^-32 and rotations in single precision. */
#include "engine_support.h"
#include "geometry_random.h"

enum { SHAPES = 60, QUERIES = 100, BROADPHASES = 6, ROOM = 2 * SHAPES };

/* In metres. Chosen, above those errors for the worlds' extent of 60. */
#define GRAZE 2e-5

/* The same shapes in three worlds, one for each broadphase, and in arrays for the reference. */
typedef struct worlds {
    thud_world *world[BROADPHASES];
    thud_pos origin; /* of all positions below */
    int count;
    thud_shape_id ids[SHAPES];
    thud_geometry placed[SHAPES];
    thud_terrain terrain[SHAPES]; /* of kind THUD_SHAPE_TERRAIN, whose origin is that of `placed` */
    thud_pos points[SHAPES][6];
    thud_filter filter[SHAPES];
    bool sensor[SHAPES];
} worlds;

/* ---- making ---- */

static thud_terrain draw_terrain(source *r, thud_pos *points) {
    thud_terrain t = {.kind = (thud_terrain_kind)draw_below(r, 3), .points = points, .count = 6};
    t.slope = draw(r, -0.8, 0.8);
    t.x0 = draw(r, -20, 0);
    t.spacing = draw(r, 1, 6);
    double x = t.x0;
    for (int i = 0; i < 6; i++) {
        points[i] = (thud_pos){x, draw(r, -4, 4)};
        x += draw(r, 0.3, 6);
    }
    return t;
}

/* Adds the same terrain to the three worlds. */
static void add_terrain(worlds *w, source *r, const thud_shape_def *def) {
    int n = w->count++;
    thud_pos at = {(float)draw(r, -10, 10), (float)draw(r, -30, -10)};
    w->terrain[n] = draw_terrain(r, w->points[n]);
    w->placed[n] = (thud_geometry){.kind = THUD_SHAPE_TERRAIN, .x = at.x, .y = at.y};
    for (int b = 0; b < BROADPHASES; b++) {
        thud_body_id body =
            add_body(w->world[b], THUD_BODY_STATIC, w->origin.x + at.x, w->origin.y + at.y, 0);
        OK(thud_shape_create_terrain(w->world[b], body, def, &w->terrain[n], &w->ids[n]));
    }
}

/* Adds the same circle or box to the three worlds. */
static void add_solid(worlds *w, source *r, const thud_shape_def *def) {
    int n = w->count++;
    thud_geometry shape = draw_shape(r);
    shape.hx = (float)fmax(shape.hx, 1e-3);
    shape.hy = (float)shape.hy;
    double angle = shape.kind == THUD_SHAPE_OBB ? draw(r, -3, 3) : 0;
    shape.x = (float)draw(r, -25, 25);
    shape.y = (float)draw(r, -20, 25);
    set_angle(&shape, angle);
    w->placed[n] = shape;
    thud_body_kind kind = (thud_body_kind)draw_below(r, 3);
    for (int b = 0; b < BROADPHASES; b++) {
        thud_body_id body =
            add_body(w->world[b], kind, w->origin.x + shape.x, w->origin.y + shape.y, angle);
        w->ids[n] = add_shape(w->world[b], body, (float)shape.hx, (float)shape.hy,
                              shape.kind == THUD_SHAPE_AABB, def);
    }
}

/* A prologue with which overlapping shapes are not pushed apart. */
static bool ignore(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                   void *context) {
    (void)settings;
    (void)world;
    (void)contact;
    (void)context;
    return false;
}

static void make_worlds(worlds *w, source *r) {
    const thud_broadphase *const all[BROADPHASES] = {
        &thud_broadphase_grid,    &thud_broadphase_sweep,        &thud_broadphase_all,
        &thud_broadphase_sweep_y, &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
    for (int b = 0; b < BROADPHASES; b++) {
        thud_world_def def = weightless();
        def.broadphase = all[b];
        w->world[b] = make_world(def);
        set_listeners(w->world[b], ignore, NULL, NULL);
    }
    double shift = draw_below(r, 3) == 0 ? 1e6 : 0;
    w->origin = (thud_pos){shift, -shift};
    w->count = 0;
    int terrains = draw_below(r, 4), count = terrains + 1 + draw_below(r, SHAPES - 4);
    for (int i = 0; i < count; i++) {
        thud_shape_def def = thud_default_shape_def();
        def.filter.category = 1u << draw_below(r, 3);
        def.sensor = i >= terrains && draw_below(r, 6) == 0;
        w->filter[i] = def.filter;
        w->sensor[i] = def.sensor;
        if (i < terrains) {
            add_terrain(w, r, &def);
        } else {
            add_solid(w, r, &def);
        }
    }
}

static void drop_worlds(worlds *w) {
    for (int b = 0; b < BROADPHASES; b++) {
        thud_world_destroy(w->world[b]);
    }
}

/* ---- reference: one shape, without a world ---- */

/* Whether shape i passes the filter (reference). */
static bool passes(const worlds *w, int i, const thud_query_filter *filter) {
    return (filter->sensors || !w->sensor[i]) && (w->filter[i].category & filter->mask);
}

/* The shape with its extents enlarged by `by`. */
static thud_geometry grown(const thud_geometry *shape, double by) {
    thud_geometry p = *shape;
    p.hx = fmax(p.hx + by, 1e-9);
    p.hy = p.kind == THUD_SHAPE_CIRCLE ? 0 : fmax(p.hy + by, 1e-9);
    return p;
}

/* A random query at (x, y), which moves by (dx, dy) where it is a cast. */
typedef struct query {
    thud_geometry shape; /* about (0, 0), in the worlds' frame; not used by rays and points */
    bool pointlike;
    double x, y, dx, dy;
    thud_query_filter filter;
} query;

/* Whether shape i, enlarged by `by`, is hit; *fraction is when. */
static bool meets(const worlds *w, int i, const query *q, double by, double *fraction) {
    double x = q->x, y = q->y;
    bool hit = false;
    *fraction = 2;
    if (w->placed[i].kind == THUD_SHAPE_TERRAIN) {
        x -= w->placed[i].x;
        y -= w->placed[i].y;
        if (q->pointlike) {
            return thud_terrain_cast_ray(&w->terrain[i], (thud_segment){x, y - by, q->dx, q->dy},
                                         fraction, NULL, NULL);
        }
        thud_geometry moving = grown(&q->shape, by);
        moving.x = x;
        moving.y = y;
        OK(thud_terrain_time_of_impact(&w->terrain[i], &moving, (thud_motion){q->dx, q->dy, 0}, 0,
                                       &hit, fraction));
        return hit;
    }
    thud_geometry still = grown(&w->placed[i], by), moving = q->shape;
    if (q->pointlike) {
        return thud_geometry_cast_ray(&still, (thud_segment){x, y, q->dx, q->dy}, fraction, NULL,
                                      NULL);
    }
    moving.x = x;
    moving.y = y;
    OK(thud_geometry_time_of_impact(&moving, (thud_motion){q->dx, q->dy, 0}, &still,
                                    (thud_motion){0}, 0, &hit, fraction));
    return hit;
}

/* Distance of shape i from another one, by the geometry functions (reference). */
static double distance_to(const worlds *w, int i, const thud_geometry *shape) {
    thud_closest c;
    thud_geometry other = *shape;
    if (w->placed[i].kind == THUD_SHAPE_TERRAIN) {
        other.x -= w->placed[i].x;
        other.y -= w->placed[i].y;
        OK(thud_terrain_closest(&w->terrain[i], &other, &c));
    } else {
        OK(thud_geometry_closest(&w->placed[i], &other, &c));
    }
    return c.distance;
}

static int index_of(const worlds *w, thud_shape_id id) {
    for (int i = 0; i < w->count; i++) {
        if (w->ids[i].index1 == id.index1) {
            return i;
        }
    }
    fail_msg("a shape was reported that does not exist");
    return -1;
}

static query draw_query(source *r) {
    query q = {.shape = draw_shape(r), .filter = thud_default_query_filter()};
    q.shape.x = q.shape.y = 0;
    q.pointlike = draw_below(r, 3) == 0;
    q.x = draw(r, -30, 30);
    q.y = draw(r, -25, 30);
    double reach = draw_below(r, 2) ? 60 : 6;
    q.dx = draw_below(r, 8) ? draw(r, -reach, reach) : 0;
    q.dy = draw_below(r, 8) ? draw(r, -reach, reach) : 0;
    q.filter.mask = draw_below(r, 2) ? UINT32_MAX : (uint32_t)draw_below(r, 8);
    q.filter.sensors = draw_below(r, 2);
    return q;
}

/* ---- casts ---- */

static int cast_all(const worlds *w, int b, const query *q, thud_ray_hit *hits, int capacity) {
    int count = -1;
    thud_pos at = {w->origin.x + q->x, w->origin.y + q->y};
    if (q->pointlike) {
        OK(thud_world_cast_ray_all(w->world[b], &(thud_ray){at, q->dx, q->dy, &q->filter}, hits,
                                   capacity, &count));
    } else {
        OK(thud_world_cast_shape_all(w->world[b],
                                     &(thud_shape_cast){at, q->shape, q->dx, q->dy, &q->filter},
                                     hits, capacity, &count));
    }
    return count;
}

static bool cast_first(const worlds *w, int b, const query *q, thud_ray_hit *hit) {
    bool any = false;
    thud_pos at = {w->origin.x + q->x, w->origin.y + q->y};
    if (q->pointlike) {
        OK(thud_world_cast_ray(w->world[b], &(thud_ray){at, q->dx, q->dy, &q->filter}, &any, hit));
    } else {
        OK(thud_world_cast_shape(w->world[b],
                                 &(thud_shape_cast){at, q->shape, q->dx, q->dy, &q->filter}, &any,
                                 hit));
    }
    return any;
}

static bool same_hit(const thud_ray_hit *a, const thud_ray_hit *b) {
    return a->shape.index1 == b->shape.index1 && a->fraction == b->fraction &&
           a->point.x == b->point.x && a->point.y == b->point.y && a->normal.x == b->normal.x &&
           a->normal.y == b->normal.y;
}

/* Asserts that the hit's point is on the surface of the shape, and that the query's shape touches
 * it at that fraction. */
static void check_hit(const worlds *w, const query *q, const thud_ray_hit *hit) {
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1e-9};
    int i = index_of(w, hit->shape);
    point.x = hit->point.x - w->origin.x;
    point.y = hit->point.y - w->origin.y;
    near_to(distance_to(w, i, &point), 0, GRAZE);
    near_to(hypot((double)hit->normal.x, (double)hit->normal.y), 1, 1e-5);
    if (!q->pointlike) {
        thud_geometry there = q->shape;
        there.x = q->x + hit->fraction * q->dx;
        there.y = q->y + hit->fraction * q->dy;
        double distance = distance_to(w, i, &there);
        assert_true(distance <= GRAZE && (hit->fraction == 0 || distance >= -GRAZE));
        double against = (double)hit->normal.x * q->dx + (double)hit->normal.y * q->dy;
        assert_true(hit->fraction == 0 || against <= 1e-3 * hypot(q->dx, q->dy));
    }
}

/* Checks a cast that lists all hits against the reference, and the first hit and the other
 * broadphases against the list. */
static void check_cast(const worlds *w, const query *q) {
    thud_ray_hit hits[ROOM], others[ROOM], first;
    int count = cast_all(w, 0, q, hits, ROOM);
    bool told[SHAPES] = {false};
    for (int k = 0; k < count; k++) {
        int i = index_of(w, hits[k].shape);
        double fraction;
        assert_false(told[i]);
        told[i] = true;
        assert_true(passes(w, i, &q->filter));
        assert_true(k == 0 || hits[k - 1].fraction < hits[k].fraction ||
                    (hits[k - 1].fraction == hits[k].fraction &&
                     hits[k - 1].shape.index1 < hits[k].shape.index1));
        /* A ray may start inside of the enlarged shape. */
        assert_true(meets(w, i, q, GRAZE, &fraction) || q->pointlike);
        check_hit(w, q, &hits[k]);
    }
    for (int i = 0; i < w->count; i++) {
        double fraction;
        if (!told[i] && passes(w, i, &q->filter) && meets(w, i, q, -GRAZE, &fraction)) {
            bool inside = q->pointlike && !meets(w, i, q, 0, &fraction);
            assert_true(inside);
        }
    }
    assert_int_equal(cast_first(w, 0, q, &first), count > 0);
    assert_true(count == 0 || same_hit(&first, &hits[0]));
    for (int b = 1; b < BROADPHASES; b++) {
        assert_int_equal(cast_all(w, b, q, others, 3), count);
        for (int k = 0; k < count && k < 3; k++) {
            assert_true(same_hit(&hits[k], &others[k]));
        }
    }
}

/* ---- overlaps and closest points ---- */

typedef struct list {
    int count;
    uint32_t index1[ROOM];
} list;

static bool append(thud_shape_id shape, void *context) {
    list *l = context;
    l->index1[l->count++] = shape.index1;
    return true;
}

/* Checks an overlap against the distances of all shapes, with each broadphase. */
static void check_overlap(const worlds *w, const query *q) {
    list found[BROADPHASES] = {0};
    thud_geometry there = q->shape;
    there.x = q->x;
    there.y = q->y;
    for (int b = 0; b < BROADPHASES; b++) {
        thud_pos at = {w->origin.x + q->x, w->origin.y + q->y};
        OK(thud_world_overlap_shape(w->world[b], at, q->shape, &q->filter, append, &found[b]));
        assert_int_equal(found[b].count, found[0].count);
        assert_memory_equal(found[b].index1, found[0].index1, sizeof found[0].index1);
    }
    int next = 0;
    for (int i = 0; i < w->count; i++) {
        bool told = next < found[0].count && found[0].index1[next] == w->ids[i].index1;
        double distance = distance_to(w, i, &there);
        next += told;
        assert_true(told ? passes(w, i, &q->filter) && distance <= GRAZE
                         : !passes(w, i, &q->filter) || distance >= -GRAZE);
    }
    assert_int_equal(next, found[0].count);
}

/* Checks the closest shape to a point against the distances of all shapes, with each broadphase. */
static void check_closest(const worlds *w, source *r, const query *q) {
    double most = draw_below(r, 2) ? draw(r, 0, 5) : draw(r, 0, 200), least = 1e300;
    thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .x = q->x, .y = q->y, .c = 1, .hx = 1e-9};
    for (int i = 0; i < w->count; i++) {
        double distance = distance_to(w, i, &point) + 1e-9;
        least = passes(w, i, &q->filter) && distance < least ? distance : least;
    }
    thud_closest_hit hit[BROADPHASES];
    for (int b = 0; b < BROADPHASES; b++) {
        bool found = false;
        memset(&hit[b], 0, sizeof hit[b]);
        thud_pos at = {w->origin.x + q->x, w->origin.y + q->y};
        OK(thud_world_closest(w->world[b], at, most, &q->filter, &found, &hit[b]));
        assert_true(found ? least <= most + GRAZE : least >= most - GRAZE);
        assert_memory_equal(&hit[b].distance, &hit[0].distance, sizeof(double));
        assert_int_equal(hit[b].shape.index1, hit[0].shape.index1);
        if (found) {
            near_to(hit[b].distance, least, GRAZE);
            point.x = hit[b].point.x - w->origin.x;
            point.y = hit[b].point.y - w->origin.y;
            near_to(distance_to(w, index_of(w, hit[b].shape), &point), 0, GRAZE);
        }
    }
}

/* The number of cases: THUD_CASES of the environment, else the usual one. */
static long cases_wanted(long usual) {
    const char *wanted = getenv("THUD_CASES");
    return wanted ? strtol(wanted, NULL, 10) : usual;
}

static void queries_of_random_worlds_agree_with_every_shape_asked_one_by_one(void **state) {
    (void)state;
    source r = {2024};
    static worlds w;
    long cases = cases_wanted(20000);
    for (long k = 0; k < cases; k++) {
        if (k % QUERIES == 0) {
            make_worlds(&w, &r);
        } else if (k % QUERIES == QUERIES / 2) {
            for (int b = 0; b < BROADPHASES; b++) {
                /* Nothing moves, but a step has updated sleeping, bounds and the broadphase's
                 * populations. */
                run(w.world[b], 1);
            }
        }
        query q = draw_query(&r);
        check_cast(&w, &q);
        check_overlap(&w, &q);
        check_closest(&w, &r, &q);
        if (k % QUERIES == QUERIES - 1 || k == cases - 1) {
            drop_worlds(&w);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(queries_of_random_worlds_agree_with_every_shape_asked_one_by_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
