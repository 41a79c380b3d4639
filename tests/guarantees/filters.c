/* filters.c: guarantees of filters and of rules that ignore pairs: which shapes collide, and that
 * no callback or event reports a pair that is filtered out. */
#include "guarantee.h"

#include <thud/thud_rules.h>

enum { BODIES = 9 };

typedef struct company {
    trial *t;
    thud_filter filter[BODIES];
    thud_shape_id shape[BODIES];
    int meetings;
} company;

/* Whether two filters let their shapes collide, by the rule that the header states. */
static bool meet(const thud_filter *a, const thud_filter *b) {
    if (a->group == b->group && a->group != 0) {
        return a->group > 0;
    }
    return (a->mask & b->category) && (b->mask & a->category);
}

static int number_of(const company *c, thud_shape_id shape) {
    int i = 0;
    while (i < BODIES && c->shape[i].index1 != shape.index1) {
        i++;
    }
    return i;
}

/* Reports a pair that was seen in a callback or event although its filters forbid it. */
static void expect_meet(company *c, thud_shape_id a, thud_shape_id b, const char *where) {
    int i = number_of(c, a), k = number_of(c, b);
    if (i == BODIES || k == BODIES) {
        return;
    }
    c->meetings++;
    if (!meet(&c->filter[i], &c->filter[k])) {
        trial_fault(c->t, "%s: %d and %d meet", where, i, k);
    }
}

/* A prologue: the pair's filters must allow it. */
static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *wanted,
                void *context) {
    (void)world;
    (void)wanted;
    expect_meet(context, contact->shape_a, contact->shape_b, "prologue");
    return true;
}

/* An epilogue: the pair's filters must allow it. */
static void tell(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    expect_meet(context, contact->shape_a, contact->shape_b, "epilogue");
}

static thud_filter draw_filter(trial *t) {
    static const thud_filter some[] = {{1, UINT32_MAX, 0},  {2, UINT32_MAX, 0}, {4, 2, 0},
                                       {1, UINT32_MAX, -1}, {8, 0, 2},          {1, UINT32_MAX, 2}};
    return some[trial_pick(t, 6)];
}

/* Adds bodies of all kinds with random filters; the last shape is a sensor. */
static void add_company(trial *t, thud_world *world, company *c) {
    for (int i = 0; i < BODIES; i++) {
        thud_shape_def def = thud_default_shape_def();
        c->filter[i] = def.filter = draw_filter(t);
        def.sensor = i == BODIES - 1;
        thud_body_id body = trial_add(t, world,
                                      (part){.kind = i == 0   ? THUD_BODY_STATIC
                                                     : i == 1 ? THUD_BODY_KINEMATIC
                                                              : THUD_BODY_DYNAMIC,
                                             .form = (form)trial_pick(t, FORMS),
                                             .x = trial_draw(t, -2, 2),
                                             .y = trial_draw(t, -2, 2),
                                             .hx = trial_draw(t, 0.2, 0.6),
                                             .hy = trial_draw(t, 0.2, 0.6),
                                             .vx = i ? trial_draw(t, -20, 20) : 0,
                                             .vy = i ? trial_draw(t, -20, 20) : 0,
                                             .shape = &def});
        c->shape[i] = trial_shape(t, world, body);
    }
}

/* No callback, contact event or sensor event reports a pair that its filters keep apart. */
static void filters_keep_apart(trial *t) {
    company c = {.t = t};
    thud_world_def def = trial_weightless(t);
    thud_world *world = trial_make(t, def);
    trial_listen(t, world, ask, tell, &c);
    if (!world) {
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        trial_wall(t, world, side * 4.0, 0, 1, 5);
        trial_wall(t, world, 0, side * 4.0, 5, 1);
    }
    add_company(t, world, &c);
    for (int k = 0; k < 40 && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        thud_events e = thud_events_of(world);
        for (int i = 0; i < e.begin_count; i++) {
            expect_meet(&c, e.begin[i].shape_a, e.begin[i].shape_b, "begin");
        }
        for (int i = 0; i < e.hit_count; i++) {
            expect_meet(&c, e.hit[i].shape_a, e.hit[i].shape_b, "hit");
        }
        for (int i = 0; i < e.sensor_begin_count; i++) {
            expect_meet(&c, e.sensor_begin[i].shape_a, e.sensor_begin[i].shape_b, "sensor");
        }
    }
}

/* A shot at each of a row of plates stops at those that its filter lets it collide with, and flies
 * through others without any effect. */
static void filters_decide_who_stops(trial *t) {
    double speed = 0.3 / t->step;
    for (int k = 0; k < 6 && !trial_failed(t); k++) {
        thud_shape_def shot = thud_default_shape_def(), plate = thud_default_shape_def();
        shot.filter = draw_filter(t);
        plate.filter = draw_filter(t);
        bool moves = trial_pick(t, 2);
        thud_world *world = trial_make(t, trial_weightless(t));
        if (!world) {
            return;
        }
        trial_add(t, world,
                  (part){.kind = moves ? THUD_BODY_KINEMATIC : THUD_BODY_STATIC,
                         .form = trial_pick(t, 2) ? UPRIGHT : TURNED,
                         .hx = 0.4,
                         .hy = 3,
                         .shape = &plate});
        thud_body_id body = trial_add(t, world,
                                      (part){.kind = THUD_BODY_DYNAMIC,
                                             .form = (form)(k % FORMS),
                                             .x = -2,
                                             .hx = 0.3,
                                             .hy = 0.3,
                                             .vx = speed,
                                             .shape = &shot});
        int steps = 20;
        trial_run(t, world, steps);
        double x = trial_state(t, world, body).position.x, flown = -2 + speed * t->step * steps;
        bool stops = meet(&shot.filter, &plate.filter);
        if (stops ? x > 0 : fabs(x - flown) > 1e-3) {
            trial_fault(t, "shot %d is at %g, on its own at %g; they %s", k, x, flown,
                        stops ? "meet" : "do not meet");
        }
    }
}

/* Two categories with a rule that ignores their pairs. */
static void kinds_that_ignore_each_other_do_not_meet(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    for (int k = 0; k < 4 && world && !trial_failed(t); k++) {
        double speed = 0.3 / t->step, y = 4.0 * k;
        bool ignores = k % 2 == 0;
        thud_shape_def wall = thud_default_shape_def(), shot = wall;
        thud_rule rule = thud_default_rule();
        wall.filter.category = 1u << (2 * k + 1);
        shot.filter.category = 1u << (2 * k + 2);
        rule.kind = ignores ? THUD_RULE_IGNORE : THUD_RULE_COLLIDE;
        DO(t, thud_world_set_rule(world, wall.filter.category, shot.filter.category, &rule));
        trial_add(t, world,
                  (part){.kind = THUD_BODY_STATIC,
                         .form = UPRIGHT,
                         .y = y,
                         .hx = 0.4,
                         .hy = 1,
                         .shape = &wall});
        thud_body_id body = trial_add(t, world,
                                      (part){.kind = THUD_BODY_DYNAMIC,
                                             .form = (form)(k % FORMS),
                                             .x = -2,
                                             .y = y,
                                             .hx = 0.3,
                                             .hy = 0.3,
                                             .vx = speed,
                                             .shape = &shot});
        trial_run(t, world, 20);
        double x = trial_state(t, world, body).position.x;
        if (ignores ? fabs(x - 4) > 1e-3 : x > 0) {
            trial_fault(t, "shot %d of kinds that %s is at %g", k, ignores ? "ignore" : "collide",
                        x);
        }
    }
}

const guarantee guarantees_of_filters[] = {
    GUARANTEE(filters_decide_who_stops),
    GUARANTEE(filters_keep_apart),
    GUARANTEE(kinds_that_ignore_each_other_do_not_meet),
    {.name = NULL},
};
