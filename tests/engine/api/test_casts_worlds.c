/* test_casts_worlds.c: casts in random worlds, with a callback for each hit and many at once,
 * against a query of every single shape; and filters in every query. They give the same with every
 * broadphase, far from the origin, and with any number of workers. */
#include "engine_support.h"
#include "some_threads.h"

#include <thud/thud_casts.h>

enum { SOLIDS = 90, LINES = 2, SHAPES = SOLIDS + LINES, RAYS = 200 };

/* A random world and what the reference needs of it. */
typedef struct crowd {
    thud_world *world;
    thud_pos origin;
    thud_body_id body[SHAPES];
    thud_shape_id shape[SHAPES];
    thud_filter filter[SHAPES];
    bool sensor[SHAPES], disabled[SHAPES];
} crowd;

/* Multiples of 1/1024, which remain exact where the world is shifted. */
static double grid_in(uint64_t *seed, double low, double high) {
    return floor(random_in(seed, low, high) * 1024) / 1024;
}

/* A random number from 0 to count - 1. */
static int below(uint64_t *seed, int count) {
    return (int)random_in(seed, 0, count);
}

/* A random def for shape i, whose filter and sensor flag are kept for the reference. */
static thud_shape_def draw_def(crowd *c, int i, uint64_t *seed) {
    static const int32_t groups[] = {0, 0, -3, 3};
    thud_shape_def def = thud_default_shape_def();
    def.filter.category = 1u << below(seed, 3);
    def.filter.mask = below(seed, 4) ? UINT32_MAX : 2;
    def.filter.group = groups[below(seed, 4)];
    def.sensor = i < SOLIDS && below(seed, 6) == 0;
    c->filter[i] = def.filter;
    c->sensor[i] = def.sensor;
    return def;
}

/* Adds shape i as a terrain. */
static void add_line(crowd *c, int i, uint64_t *seed) {
    static const thud_pos points[] = {{-24, 1}, {-13, -3}, {-2, 2}, {5, -1}, {11, 0}, {25, 4}};
    thud_terrain line = {.kind = i % 2 ? THUD_TERRAIN_UNIFORM : THUD_TERRAIN_IRREGULAR,
                         .x0 = -20,
                         .spacing = 8,
                         .points = points,
                         .count = 6};
    thud_shape_def def = draw_def(c, i, seed);
    c->body[i] = add_body(c->world, THUD_BODY_STATIC, c->origin.x, c->origin.y - 9 - 2 * i % 3, 0);
    OK(thud_shape_create_terrain(c->world, c->body[i], &def, &line, &c->shape[i]));
}

/* Adds shape i as a random circle or box, some of them disabled. */
static void add_solid(crowd *c, int i, uint64_t *seed) {
    thud_shape_def def = draw_def(c, i, seed);
    double x = grid_in(seed, -25, 25), y = grid_in(seed, -12, 25);
    int kind = below(seed, 3);
    c->body[i] = add_body(c->world, (thud_body_kind)below(seed, 3), c->origin.x + x,
                          c->origin.y + y, kind == 2 ? random_in(seed, -3, 3) : 0);
    float hx = (float)random_in(seed, 0.1, 2.5), hy = (float)random_in(seed, 0.1, 2.5);
    c->shape[i] = add_shape(c->world, c->body[i], hx, kind ? hy : 0, kind == 1, &def);
    c->disabled[i] = below(seed, 9) == 0;
    OK(thud_body_set_enabled(c->world, c->body[i], !c->disabled[i]));
}

static void make_crowd(crowd *c, uint64_t seed, double shift, int broadphase,
                       thud_job_system jobs) {
    static const thud_broadphase *const all[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                 &thud_broadphase_all};
    thud_world_def def = weightless();
    def.broadphase = all[broadphase];
    def.job_system = jobs;
    memset(c, 0, sizeof *c);
    c->world = make_world(def);
    c->origin = (thud_pos){shift, -shift};
    for (int i = 0; i < SHAPES; i++) {
        if (i % 40 == 39) {
            add_line(c, i, &seed);
        } else {
            add_solid(c, i, &seed);
        }
    }
}

/* The index of a shape in the crowd. */
static int number_of(const crowd *c, thud_shape_id shape) {
    for (int i = 0; i < SHAPES; i++) {
        if (c->shape[i].index1 == shape.index1 && c->shape[i].generation == shape.generation) {
            return i;
        }
    }
    fail_msg("a shape was reported that does not exist");
    return -1;
}

/* Whether shape i passes the filter (reference). */
static bool passes(const crowd *c, int i, const thud_query_filter *f) {
    if (c->disabled[i] || (c->sensor[i] && !f->sensors) ||
        (f->ignore.index1 == c->body[i].index1 && f->ignore.generation == c->body[i].generation)) {
        return false;
    }
    if (f->group != 0 && f->group == c->filter[i].group) {
        return f->group > 0;
    }
    return (c->filter[i].category & f->mask) && (c->filter[i].mask & f->category);
}

/* A random cast: from `at` by (dx, dy), of a ray or of `shape`. */
typedef struct query {
    thud_pos at;
    double dx, dy;
    thud_geometry shape;
    thud_query_filter filter;
} query;

static query draw_query(const crowd *c, uint64_t *seed) {
    static const int32_t groups[] = {0, 0, -3, 3};
    query q = {.filter = thud_default_query_filter(), .shape = {.kind = THUD_SHAPE_CIRCLE, .c = 1}};
    q.at = (thud_pos){c->origin.x + grid_in(seed, -28, 28), c->origin.y + grid_in(seed, -8, 28)};
    double reach = below(seed, 2) ? 60 : 5;
    q.dx = below(seed, 8) ? grid_in(seed, -reach, reach) : 0;
    q.dy = below(seed, 8) ? grid_in(seed, -reach, reach) : 0;
    q.shape.hx = random_in(seed, 0.1, 1.5);
    if (below(seed, 2)) {
        q.shape.kind = THUD_SHAPE_AABB;
        q.shape.hy = random_in(seed, 0.1, 1.5);
    }
    q.filter.mask = below(seed, 2) ? UINT32_MAX : (uint32_t)below(seed, 8);
    q.filter.category = below(seed, 2) ? UINT32_MAX : (uint32_t)below(seed, 4);
    q.filter.group = groups[below(seed, 4)];
    if (!q.filter.mask && !q.filter.category) {
        q.filter.mask = 1; /* a filter that passes nothing is refused: test_log.c */
    }
    q.filter.sensors = below(seed, 2);
    int ignored = below(seed, SHAPES);
    q.filter.ignore = below(seed, 2) ? c->body[ignored] : (thud_body_id){0, 0};
    q.filter.ignore.generation += below(seed, 4) == 0; /* a stale handle: no body is ignored */
    return q;
}

static bool same_hit(const thud_ray_hit *a, const thud_ray_hit *b) {
    return a->shape.index1 == b->shape.index1 && a->shape.generation == b->shape.generation &&
           a->fraction == b->fraction && a->point.x == b->point.x && a->point.y == b->point.y &&
           a->normal.x == b->normal.x && a->normal.y == b->normal.y && a->depth == b->depth;
}

/* Order by fraction, then by slot, for qsort. */
static int by_order(const void *left, const void *right) {
    const thud_ray_hit *a = left, *b = right;
    if (a->fraction != b->fraction) {
        return a->fraction < b->fraction ? -1 : 1;
    }
    return a->shape.index1 < b->shape.index1 ? -1 : 1;
}

/* Reference: the hits of each shape that passes, sorted by fraction, then by slot. */
static int ask_all(const crowd *c, const query *q, thud_ray_hit *hits) {
    int count = 0;
    for (int i = 0; i < SHAPES; i++) {
        bool hit = false;
        OK(thud_shape_cast_ray(c->world, c->shape[i], q->at, q->dx, q->dy, &hit, &hits[count]));
        count += hit && passes(c, i, &q->filter);
    }
    qsort(hits, (size_t)count, sizeof *hits, by_order);
    return count;
}

/* ---- callbacks for each hit ---- */

/* What a cast's or an overlap's callback was given, and its answers. */
typedef struct listener {
    thud_ray_hit hits[SHAPES];
    int count;
    uint64_t *seed; /* of random answers; null: it always continues */
    double answers[SHAPES];
} listener;

/* A cast's callback: notes the hit and its answer, random or THUD_CAST_ON. */
static double hear(const thud_ray_hit *hit, void *context) {
    listener *l = context;
    assert_true(l->count < SHAPES);
    double answer = THUD_CAST_ON;
    if (l->seed) {
        const double answers[] = {THUD_CAST_IGNORE,
                                  -0.0001,
                                  THUD_CAST_ON,
                                  7,
                                  1.0,
                                  hit->fraction,
                                  hit->fraction + 0.1,
                                  THUD_CAST_END,
                                  random_in(l->seed, 0, 1.5),
                                  INFINITY};
        answer = answers[below(l->seed, 10)];
    }
    l->answers[l->count] = answer;
    l->hits[l->count++] = *hit;
    return answer;
}

/* Asserts that the callback was given the hits of the sorted list that its answers left. */
static void check_told(const listener *l, const thud_ray_hit *all, int count) {
    double limit = INFINITY;
    int told = 0;
    for (int i = 0; i < count && all[i].fraction < limit; i++) {
        assert_true(told < l->count);
        assert_true(same_hit(&l->hits[told], &all[i]));
        double answer = l->answers[told++];
        limit = answer >= 0 && answer < 1 && answer < limit ? answer : limit;
    }
    assert_int_equal(told, l->count);
}

/* Asserts that the list of all hits is the reference's, and that the callback is given what its
 * answers leave of it. */
static void check_each(const crowd *c, const query *q, uint64_t *answers) {
    thud_ray_hit all[SHAPES], found[SHAPES];
    listener heard = {.seed = answers};
    int count = ask_all(c, q, all), listed = -1;
    OK(thud_world_cast_ray_all(c->world, &(thud_ray){q->at, q->dx, q->dy, &q->filter}, found,
                               SHAPES, &listed));
    assert_int_equal(listed, count);
    for (int i = 0; i < count; i++) {
        assert_true(same_hit(&found[i], &all[i]));
    }
    OK(thud_world_cast_ray_each(c->world, &(thud_ray){q->at, q->dx, q->dy, &q->filter}, hear,
                                &heard));
    check_told(&heard, all, count);
    OK(thud_world_cast_shape_all(c->world,
                                 &(thud_shape_cast){q->at, q->shape, q->dx, q->dy, &q->filter}, all,
                                 SHAPES, &count));
    heard.count = 0;
    OK(thud_world_cast_shape_each(c->world,
                                  &(thud_shape_cast){q->at, q->shape, q->dx, q->dy, &q->filter},
                                  hear, &heard));
    check_told(&heard, all, count);
}

static void hits_are_told_in_order_until_the_answers_end_the_way(void **state) {
    (void)state;
    static crowd c;
    for (int world = 0; world < 12; world++) {
        uint64_t seed = 77 + (uint64_t)world, answers = 5;
        make_crowd(&c, seed, world % 2 ? 1e7 : 0, world % 3, (thud_job_system){0});
        for (int i = 0; i < 300; i++) {
            if (i == 150) {
                run(c.world, 1);
            }
            query q = draw_query(&c, &seed);
            check_each(&c, &q, i % 2 ? &answers : NULL);
        }
        thud_world_destroy(c.world);
    }
}

/* ---- filters ---- */

/* An overlap's callback: notes the shape. */
static bool note(thud_shape_id shape, void *context) {
    listener *l = context;
    l->hits[l->count++].shape = shape;
    return true;
}

/* Shape casts and overlaps report the shapes that pass the filter and overlap, and no others. */
static void check_filters(const crowd *c, const query *q) {
    listener swept = {.count = 0}, over = {.count = 0};
    thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = q->shape.hx};
    OK(thud_world_cast_shape_each(c->world, &(thud_shape_cast){q->at, disc, 0, 0, &q->filter}, hear,
                                  &swept));
    OK(thud_world_overlap_shape(c->world, q->at, disc, &q->filter, note, &over));
    bool wanted_any = false, found = false;
    double least = 20;
    int wanted = 0, slack = 0;
    for (int i = 0; i < SHAPES; i++) {
        thud_closest_hit hit;
        OK(thud_shape_closest_point(c->world, c->shape[i], q->at, &hit));
        bool inside;
        OK(thud_shape_contains_point(c->world, c->shape[i], q->at, &inside));
        assert_int_equal(inside, hit.distance <= 0);
        if (passes(c, i, &q->filter)) {
            wanted += hit.distance <= disc.hx;
            slack += fabs(hit.distance - disc.hx) < 1e-6;
            wanted_any = wanted_any || hit.distance <= 20;
            least = hit.distance < least ? hit.distance : least;
        }
    }
    assert_true(abs(over.count - wanted) <= slack && abs(swept.count - wanted) <= slack);
    for (int i = 0; i < over.count; i++) {
        assert_true(passes(c, number_of(c, over.hits[i].shape), &q->filter));
    }
    for (int i = 0; i < swept.count; i++) {
        assert_true(passes(c, number_of(c, swept.hits[i].shape), &q->filter));
    }
    thud_closest_hit closest;
    OK(thud_world_closest(c->world, q->at, 20, &q->filter, &found, &closest));
    assert_int_equal(found, wanted_any);
    if (found) {
        assert_true(closest.distance == least);
        assert_true(passes(c, number_of(c, closest.shape), &q->filter));
    }
}

static void filters_hold_in_every_query(void **state) {
    (void)state;
    static crowd c;
    for (int world = 0; world < 6; world++) {
        uint64_t seed = 900 + (uint64_t)world;
        make_crowd(&c, seed, world % 2 ? -1e7 : 0, world % 3, (thud_job_system){0});
        for (int i = 0; i < 300; i++) {
            query q = draw_query(&c, &seed);
            check_filters(&c, &q);
        }
        thud_world_destroy(c.world);
    }
}

/* ---- many casts at once ---- */

/* Asserts that a hit of many casts at once equals that of the single cast. */
static void check_one(const crowd *c, const query *q, const thud_ray_hit *got, bool ray) {
    thud_ray_hit one = {.fraction = 1, .point = {q->at.x + q->dx, q->at.y + q->dy}};
    if (ray) {
        OK(thud_world_cast_ray(c->world, &(thud_ray){q->at, q->dx, q->dy, &q->filter}, NULL, &one));
    } else {
        OK(thud_world_cast_shape(c->world,
                                 &(thud_shape_cast){q->at, q->shape, q->dx, q->dy, &q->filter},
                                 NULL, &one));
    }
    assert_true(same_hit(&one, got));
}

/* Makes many casts at once and asserts that each equals the single cast. */
static void check_many(const crowd *c, uint64_t seed, int count) {
    static query q[RAYS];
    static thud_ray rays[RAYS];
    static thud_shape_cast casts[RAYS];
    static thud_ray_hit hits[RAYS + 1];
    for (int i = 0; i < count; i++) {
        q[i] = draw_query(c, &seed);
        rays[i] = (thud_ray){q[i].at, q[i].dx, q[i].dy, &q[i].filter};
        casts[i] = (thud_shape_cast){q[i].at, q[i].shape, q[i].dx, q[i].dy, &q[i].filter};
    }
    hits[count].fraction = 42;
    OK(thud_world_cast_rays(c->world, rays, count, hits));
    for (int i = 0; i < count; i++) {
        check_one(c, &q[i], &hits[i], true);
    }
    OK(thud_world_cast_shapes(c->world, casts, count, hits));
    for (int i = 0; i < count; i++) {
        check_one(c, &q[i], &hits[i], false);
    }
    assert_true(hits[count].fraction == 42);
}

static void many_casts_are_those_made_one_by_one_with_any_number_of_workers(void **state) {
    (void)state;
    static crowd c;
    const int workers[] = {0, 1, 4, 8};
    for (int k = 0; k < 12; k++) {
        thud_threads *threads = workers[k % 4] ? some_threads(workers[k % 4]) : NULL;
        make_crowd(&c, 31, k % 2 ? 1e7 : 0, k % 3,
                   threads ? thud_job_system_of(threads) : (thud_job_system){0});
        for (int round = 0; round < 3; round++) {
            check_many(&c, 7 + (uint64_t)round, RAYS);
            check_many(&c, 70 + (uint64_t)round, 63 + round);
            check_many(&c, 8, round);
            run(c.world, 1);
        }
        thud_world_destroy(c.world);
        if (threads) {
            thud_threads_destroy(threads);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hits_are_told_in_order_until_the_answers_end_the_way),
        cmocka_unit_test(filters_hold_in_every_query),
        cmocka_unit_test(many_casts_are_those_made_one_by_one_with_any_number_of_workers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
