/* asking.c: guarantees of queries: rays, casts, overlaps, closest points and character movers of a
 * world give the same results as tests of the query against each single shape (thud_geometry.h),
 * for shapes and query filters drawn at random. */
#include "guarantee.h"

#include <thud/thud_casts.h>
#include <thud/thud_edits.h>
#include <thud/thud_mover.h>
#include <thud/thud_prediction.h>

enum { FOUND = 14 };

typedef struct crowd {
    thud_world *world;
    thud_body_id body[FOUND];
    thud_shape_id shape[FOUND];
    thud_geometry placed[FOUND];
    thud_filter filter[FOUND];
    bool sensor[FOUND];
} crowd;

/* Creates bodies of all kinds and forms at random places, every fifth of them a sensor. False if
 * the world could not be created. */
static bool make_crowd(trial *t, crowd *c) {
    c->world = trial_make(t, trial_weightless(t));
    for (int i = 0; i < FOUND && c->world; i++) {
        thud_shape_def def = thud_default_shape_def();
        def.filter.category = i % 3 == 2 ? 2 : 1;
        c->filter[i] = def.filter;
        c->sensor[i] = def.sensor = i % 5 == 4;
        c->body[i] = trial_add(t, c->world,
                               (part){.kind = (thud_body_kind)(i % 3),
                                      .form = (form)trial_pick(t, FORMS),
                                      .x = trial_draw(t, -4, 4),
                                      .y = trial_draw(t, -4, 4),
                                      .hx = trial_draw(t, 0.1, 0.8),
                                      .hy = trial_draw(t, 0.1, 0.8),
                                      .vx = i % 3 ? trial_draw(t, -2, 2) : 0,
                                      .shape = &def});
        c->shape[i] = trial_shape(t, c->world, c->body[i]);
    }
    return c->world != NULL;
}

/* Runs some steps, then moves bodies by edits that no step has processed yet, and stores each
 * shape's instance, at which queries have to find it. */
static void stir(trial *t, crowd *c) {
    trial_run(t, c->world, 3);
    for (int i = 0; i < 3; i++) {
        DO(t, thud_body_set_transform(c->world, c->body[trial_pick(t, FOUND)],
                                      trial_place(t, trial_draw(t, -4, 4), 0), 0));
    }
    for (int i = 0; i < FOUND; i++) {
        c->placed[i] = trial_placed(t, c->world, c->body[i]);
    }
}

/* The shape's index in the crowd, or FOUND if it is not in it. */
static int number_of(const crowd *c, thud_shape_id shape) {
    int i = 0;
    while (i < FOUND && c->shape[i].index1 != shape.index1) {
        i++;
    }
    return i;
}

/* Whether shape i passes the query filter, by the rule that thud_queries.h states. */
static bool asked_for(const crowd *c, const thud_query_filter *f, int i) {
    return (!c->sensor[i] || f->sensors) && (f->mask & c->filter[i].category) &&
           (c->filter[i].mask & f->category);
}

static thud_query_filter draw_query(trial *t) {
    thud_query_filter f = thud_default_query_filter();
    f.mask = trial_pick(t, 2) ? 1 : UINT32_MAX;
    f.sensors = trial_pick(t, 2);
    return f;
}

static void rays_hit_the_nearest(trial *t) {
    crowd c;
    if (!make_crowd(t, &c)) {
        return;
    }
    for (int k = 0; k < 12 && !trial_failed(t); k++) {
        thud_query_filter f = draw_query(t);
        double x = trial_draw(t, -5, 5), y = trial_draw(t, -5, 5), nearest = 2, nx, ny, at;
        double dx = trial_draw(t, -9, 9), dy = trial_draw(t, -9, 9);
        thud_ray_hit hit[FOUND];
        bool any = false;
        int count = 0, expected = 0;
        stir(t, &c);
        for (int i = 0; i < FOUND; i++) {
            if (asked_for(&c, &f, i) &&
                thud_geometry_cast_ray(&c.placed[i], (thud_segment){x, y, dx, dy}, &at, &nx, &ny)) {
                expected++;
                nearest = fmin(nearest, at);
            }
        }
        thud_pos from = {x * t->scale, y * t->scale};
        DO(t, thud_world_cast_ray(c.world, &(thud_ray){from, dx * t->scale, dy * t->scale, &f},
                                  &any, hit));
        if (any != (nearest < 2) || (any && fabs(hit[0].fraction - nearest) > 1e-4)) {
            trial_fault(t, "ray %d: found %d at %g, not %g", k, any, any ? hit[0].fraction : -1,
                        nearest);
        }
        DO(t, thud_world_cast_ray_all(c.world, &(thud_ray){from, dx * t->scale, dy * t->scale, &f},
                                      hit, FOUND, &count));
        for (int i = 0; i < count && i < FOUND; i++) {
            if (!asked_for(&c, &f, number_of(&c, hit[i].shape)) ||
                (i && hit[i].fraction < hit[i - 1].fraction)) {
                trial_fault(t, "ray %d: its hit %d is not asked for, or out of order", k, i);
            }
        }
        if (abs(count - expected) > 0) {
            trial_fault(t, "ray %d: %d hits, not %d", k, count, expected);
        }
    }
}

/* The hits that a cast reports one by one, until the callback ends the cast. */
typedef struct hearing {
    thud_ray_hit hit[FOUND];
    int count, last; /* index of the hit at which the callback ends the cast */
} hearing;

/* Records a hit, and ends the cast at the hit whose number is `last`. */
static double hear(const thud_ray_hit *hit, void *context) {
    hearing *h = context;
    if (h->count < FOUND) {
        h->hit[h->count] = *hit;
    }
    return h->count++ == h->last ? THUD_CAST_END : THUD_CAST_ON;
}

static void casts_hit_by_hit_tell_what_all_do(trial *t) {
    crowd c;
    if (!make_crowd(t, &c)) {
        return;
    }
    for (int k = 0; k < 12 && !trial_failed(t); k++) {
        thud_query_filter f = draw_query(t);
        thud_pos from = {trial_draw(t, -5, 5) * t->scale, trial_draw(t, -5, 5) * t->scale};
        double dx = trial_draw(t, -9, 9) * t->scale, dy = trial_draw(t, -9, 9) * t->scale;
        thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0.3 * t->scale};
        thud_ray_hit all[FOUND];
        hearing h = {.last = k % 3 ? FOUND : k % 4};
        int count = 0;
        stir(t, &c);
        if (k % 2) {
            DO(t,
               thud_world_cast_ray_all(c.world, &(thud_ray){from, dx, dy, &f}, all, FOUND, &count));
            DO(t, thud_world_cast_ray_each(c.world, &(thud_ray){from, dx, dy, &f}, hear, &h));
        } else {
            DO(t, thud_world_cast_shape_all(c.world, &(thud_shape_cast){from, ball, dx, dy, &f},
                                            all, FOUND, &count));
            DO(t, thud_world_cast_shape_each(c.world, &(thud_shape_cast){from, ball, dx, dy, &f},
                                             hear, &h));
        }
        int expected = count <= h.last ? count : h.last + 1;
        if (h.count != expected) {
            trial_fault(t, "cast %d: told of %d, not %d", k, h.count, expected);
        }
        for (int i = 0; i < expected && i < h.count && i < FOUND; i++) {
            if (memcmp(&h.hit[i], &all[i], sizeof all[i]) != 0) {
                trial_fault(t, "cast %d: its hit %d is another", k, i);
            }
        }
    }
}

typedef struct list {
    const crowd *c;
    bool found[FOUND + 1];
    uint32_t last;
    bool disordered;
} list;

/* Marks a shape as found, and checks that shapes come in the order of their handles. */
static bool note(thud_shape_id shape, void *context) {
    list *l = context;
    l->found[number_of(l->c, shape)] = true;
    l->disordered |= shape.index1 < l->last;
    l->last = shape.index1;
    return true;
}

static void overlaps_find_all(trial *t) {
    crowd c;
    if (!make_crowd(t, &c)) {
        return;
    }
    for (int k = 0; k < 12 && !trial_failed(t); k++) {
        thud_query_filter f = draw_query(t);
        list l = {.c = &c};
        double angle = trial_draw(t, -1, 1);
        thud_geometry box = {.kind = THUD_SHAPE_OBB,
                             .x = trial_draw(t, -4, 4),
                             .y = trial_draw(t, -4, 4),
                             .c = cos(angle),
                             .s = sin(angle),
                             .hx = trial_draw(t, 0.1, 3),
                             .hy = trial_draw(t, 0.1, 3)};
        stir(t, &c);
        DO(t,
           thud_world_overlap_shape(c.world, (thud_pos){box.x * t->scale, box.y * t->scale},
                                    thud_obb_at(0, 0, box.hx * t->scale, box.hy * t->scale, angle),
                                    &f, note, &l));
        for (int i = 0; i < FOUND && !trial_failed(t); i++) {
            thud_closest near = {.distance = 1};
            DO(t, thud_geometry_closest(&box, &c.placed[i], &near));
            bool wanted = near.distance <= 0 && asked_for(&c, &f, i);
            if (l.found[i] != wanted && (fabs(near.distance) > 1e-5 || l.found[i])) {
                trial_fault(t, "box %d: shape %d, %g away, %s", k, i, near.distance,
                            l.found[i] ? "found" : "not found");
            }
        }
        if (l.found[FOUND] || l.disordered) {
            trial_fault(t, "box %d: found in no order", k);
        }
    }
}

static void closest_is_the_closest(trial *t) {
    crowd c;
    if (!make_crowd(t, &c)) {
        return;
    }
    for (int k = 0; k < 12 && !trial_failed(t); k++) {
        thud_query_filter f = draw_query(t);
        thud_geometry point = {.kind = THUD_SHAPE_CIRCLE,
                               .x = trial_draw(t, -5, 5),
                               .y = trial_draw(t, -5, 5),
                               .c = 1,
                               .hx = 1e-6};
        double nearest = 1.5;
        bool found = false;
        thud_closest_hit hit = {.distance = 9};
        stir(t, &c);
        for (int i = 0; i < FOUND; i++) {
            thud_closest near = {.distance = 9};
            DO(t, thud_geometry_closest(&c.placed[i], &point, &near));
            nearest = asked_for(&c, &f, i) ? fmin(nearest, near.distance) : nearest;
        }
        DO(t, thud_world_closest(c.world, (thud_pos){point.x * t->scale, point.y * t->scale},
                                 1.5 * t->scale, &f, &found, &hit));
        double distance = found ? hit.distance / t->scale : 1.5;
        if (fabs(distance - nearest) > 1e-4) {
            trial_fault(t, "point %d: %g away, not %g", k, distance, nearest);
        }
    }
}

/* Cast shapes stop where they touch the first shape on their path, and touch none before. */
static void casts_stop_at_the_first(trial *t) {
    crowd c;
    if (!make_crowd(t, &c)) {
        return;
    }
    for (int k = 0; k < 12 && !trial_failed(t); k++) {
        thud_query_filter f = draw_query(t);
        double x = trial_draw(t, -5, 5), y = trial_draw(t, -5, 5), r = trial_draw(t, 0.05, 0.6);
        double dx = trial_draw(t, -9, 9), dy = trial_draw(t, -9, 9), first = 2, at;
        thud_ray_hit out = {.fraction = 2};
        bool hit = false, meets;
        stir(t, &c);
        thud_geometry ball = {.kind = THUD_SHAPE_CIRCLE, .x = x, .y = y, .c = 1, .hx = r};
        for (int i = 0; i < FOUND; i++) {
            thud_motion still = {0}, way = {dx, dy, 0};
            if (asked_for(&c, &f, i)) {
                DO(t,
                   thud_geometry_time_of_impact(&ball, way, &c.placed[i], still, 0, &meets, &at));
                first = meets ? fmin(first, at) : first;
            }
        }
        DO(t, thud_world_cast_shape(c.world,
                                    &(thud_shape_cast){(thud_pos){x * t->scale, y * t->scale},
                                                       thud_circle_at(0, 0, r * t->scale),
                                                       dx * t->scale, dy * t->scale, &f},
                                    &hit, &out));
        if (hit != (first < 2) || (hit && fabs(out.fraction - first) > 1e-3)) {
            trial_fault(t, "cast %d: %d at %g, not %g", k, hit, out.fraction, first);
        }
    }
}

/* A character mover walks through a tunnel of static shapes, and never overlaps any of them. */
static void movers_enter_nothing(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_mover_report report;
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 8, 1);
    trial_wall(t, world, 6, 3, 1, 4);
    trial_add(t, world, (part){.form = TURNED, .x = 3, .angle = 0.4, .hx = 1, .hy = 0.3});
    trial_wall(t, world, 0.5, 0, 0.4, 0.15);
    thud_pos start = trial_place(t, -3, 1);
    thud_geometry shape = {.kind = trial_pick(t, 2) ? THUD_SHAPE_CIRCLE : THUD_SHAPE_AABB,
                           .x = start.x,
                           .y = start.y,
                           .c = 1,
                           .hx = 0.4 * t->scale};
    shape.hy = shape.kind == THUD_SHAPE_CIRCLE ? 0 : shape.hx;
    thud_mover mover = thud_default_mover(shape);
    for (int k = 0; k < trial_steps(t, 2.5) && !trial_failed(t); k++) {
        thud_closest_hit near = {.distance = 9};
        bool found;
        trial_run(t, world, 1);
        DO(t, thud_mover_move(world, &mover, trial_speed(t, 4, -3), t->step, &report));
        thud_pos at = {mover.shape.x, mover.shape.y};
        DO(t, thud_world_closest(world, at, 9 * t->scale, NULL, &found, &near));
        if (near.distance < mover.shape.hx * (1 - 1e-3)) {
            trial_fault(t, "move %d: at %g, %g it is %g into a wall", k, at.x / t->scale,
                        at.y / t->scale, (mover.shape.hx - near.distance) / t->scale);
        }
    }
    if (!(mover.shape.x > 3 * t->scale && mover.on_ground)) {
        trial_fault(t, "it came to %g", mover.shape.x / t->scale);
    }
}

/* How far a flight of a second may end from where it was told to, length scales: single precision
 * rounds a speed of 16 by 5e-7 in each step. Chosen. */
#define FLIGHT_TOLERANCE 1e-4

static void free_flight_goes_where_it_is_told(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    form f = (form)trial_pick(t, FORMS);
    thud_body_id body = trial_add(t, world,
                                  (part){.kind = THUD_BODY_DYNAMIC,
                                         .form = f,
                                         .x = trial_draw(t, -4, 4),
                                         .y = trial_draw(t, -4, 4),
                                         .hx = 0.4,
                                         .hy = 0.3,
                                         .vx = trial_draw(t, -5, 5),
                                         .vy = trial_draw(t, 0, 8)});
    DO(t, thud_body_set_damping(world, body, (float)trial_draw(t, 0, 3), 1));
    for (int k = 0; k < 3 && !trial_failed(t); k++) {
        int steps = trial_steps(t, 0.33);
        thud_prediction told = {.seconds = -1}, stopped = {.seconds = -1};
        DO(t, thud_world_extrapolate(world, &body, 1, steps * t->step, &told));
        DO(t, thud_world_predict(world, &body, 1, steps * t->step, &stopped));
        trial_run(t, world, steps);
        thud_body_state state;
        DO(t, thud_body_get_state(world, body, &state));
        double dx = state.position.x - told.position.x, dy = state.position.y - told.position.y;
        if (!(hypot(dx, dy) <= FLIGHT_TOLERANCE * t->scale) ||
            !(cos(state.angle - told.angle) > 1 - 1e-8)) {
            trial_fault(t, "after %d steps it is off by %g, %g", steps, dx / t->scale,
                        dy / t->scale);
        }
        if (stopped.met.index1 || stopped.position.x != told.position.x ||
            stopped.position.y != told.position.y) {
            trial_fault(t, "after %d steps it stops though it meets nothing", steps);
        }
    }
}

const guarantee guarantees_of_asking[] = {
    GUARANTEE(casts_hit_by_hit_tell_what_all_do),
    GUARANTEE(casts_stop_at_the_first),
    GUARANTEE(closest_is_the_closest),
    GUARANTEE(free_flight_goes_where_it_is_told),
    GUARANTEE(movers_enter_nothing),
    GUARANTEE(overlaps_find_all),
    GUARANTEE(rays_hit_the_nearest),
    {.name = NULL},
};
