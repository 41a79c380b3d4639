/* rest.c: guarantees of resting bodies: sleep and waking, penetration depth, the reported errors,
 * and energy. */
#include "guarantee.h"
#include "yard.h"

enum { STACK = 3 };

/* A stack of three boxes and a ball beside it, on a floor. */
typedef struct heap {
    thud_world *world;
    thud_body_id floor, box[STACK], ball;
} heap;

static heap make_heap(trial *t, thud_world_def def) {
    heap h = {.world = trial_make(t, def)};
    if (h.world) {
        h.floor = trial_wall(t, h.world, 0, -1, 20, 1);
        for (int i = 0; i < STACK; i++) {
            h.box[i] = trial_drop(t, h.world, i == 1 ? UPRIGHT : TURNED, 0, 0.4 + 0.8 * i, 0.4);
        }
        h.ball = trial_drop(t, h.world, BALL, 2, 0.3, 0.3);
    }
    return h;
}

/* The largest penetration depth between bodies that stand on each other, in length scales, computed
 * by thud_geometry_closest. */
static double deepest(trial *t, const heap *h) {
    double most = 0;
    for (int i = 0; i <= STACK; i++) {
        thud_body_id below = i == 0 || i == STACK ? h->floor : h->box[i - 1];
        thud_geometry a = trial_placed(t, h->world, below);
        thud_geometry b = trial_placed(t, h->world, i < STACK ? h->box[i] : h->ball);
        thud_closest c = {.distance = 0};
        DO(t, thud_geometry_closest(&a, &b, &c));
        most = fmax(most, -c.distance);
    }
    return most;
}

/* ---- sleep ---- */

static void what_rests_stays_and_sleeps(trial *t) {
    heap h = make_heap(t, trial_def(t));
    if (!h.world) {
        return;
    }
    trial_run(t, h.world, trial_steps(t, 3));
    int awake = thud_stats_of(h.world).awake_bodies;
    uint64_t hash = thud_hash_of(h.world);
    if ((awake == 0) != settings_sleeping(t->set)) {
        trial_fault(t, "%d bodies are awake", awake);
    }
    trial_run(t, h.world, 5);
    if (awake == 0 && thud_hash_of(h.world) != hash) {
        trial_fault(t, "a body moved in its sleep");
    }
    for (int i = 0; i < STACK && !trial_failed(t); i++) {
        thud_body_state s = trial_state(t, h.world, h.box[i]);
        if (fabs(s.position.x) > 0.01 || fabs(s.position.y - 0.4 - 0.8 * i) > 0.02) {
            trial_fault(t, "box %d is at %g, %g", i, s.position.x, s.position.y);
        }
    }
}

/* Two boxes that begin 6 length scales deep in each other and in the floor separate before they
 * fall asleep. */
static void overlaps_part_before_they_sleep(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    thud_body_id below = trial_wall(t, world, 0, -4, 20, 4);
    thud_body_id box[2] = {trial_drop(t, world, TURNED, 0, 0, 4),
                           trial_drop(t, world, UPRIGHT, 0, 2, 4)};
    trial_run(t, world, trial_steps(t, 10));
    int awake = thud_stats_of(world).awake_bodies;
    double deepest =
        fmax(trial_state(t, world, below).position.y + 8 - trial_state(t, world, box[0]).position.y,
             trial_state(t, world, box[0]).position.y + 8 -
                 trial_state(t, world, box[1]).position.y);
    if (!(deepest < 0.05) || (settings_sleeping(t->set) && awake)) {
        trial_fault(t, "%d are awake, %g deep", awake, deepest);
    }
}

enum { NUDGES = 8 };

/* One of NUDGES edits that must wake the stack. */
static void nudge(trial *t, heap *h, int what) {
    thud_vec2 up = trial_speed(t, 0, 30 * t->scale * t->scale);
    thud_pos middle = trial_place(t, 0, 2);
    switch (what) {
    case 0:
        DO(t, thud_body_set_velocity(h->world, h->box[2], trial_speed(t, 1, 0), 0));
        break;
    case 1:
        DO(t, thud_body_apply_impulse(h->world, h->box[2], trial_speed(t, t->scale * t->scale, 0),
                                      middle));
        break;
    case 2:
        DO(t, thud_body_apply_center_force(h->world, h->box[2], up));
        break;
    case 3:
        DO(t, thud_body_set_transform(h->world, h->floor, trial_place(t, 0, -3), 0));
        break;
    case 4:
        DO(t, thud_body_destroy(h->world, h->box[0]));
        break;
    case 5:
        DO(t, thud_body_set_enabled(h->world, h->box[0], false));
        break;
    case 6:
        DO(t, thud_world_set_gravity(h->world, trial_speed(t, 5, -5)));
        break;
    default:
        trial_add(t, h->world,
                  (part){.kind = THUD_BODY_DYNAMIC,
                         .form = BALL,
                         .x = 0,
                         .y = 2.85,
                         .hx = 0.4,
                         .vy = -3});
    }
}

/* An edit of one body of a stack wakes it and the bodies above it; the ball beside them sleeps on,
 * except where gravity or the floor was edited. */
static void edits_wake_who_touches(trial *t) {
    int what = trial_pick(t, NUDGES);
    heap h = make_heap(t, trial_def(t));
    if (!h.world) {
        return;
    }
    trial_run(t, h.world, trial_steps(t, 3));
    bool slept = thud_stats_of(h.world).awake_bodies == 0;
    double before = trial_state(t, h.world, h.box[2]).position.y;
    nudge(t, &h, what);
    trial_run(t, h.world, 2 + trial_steps(t, 0.03));
    thud_body_state top = trial_state(t, h.world, h.box[2]);
    bool ball = trial_state(t, h.world, h.ball).awake, all = what == 3 || what == 6;
    if (!slept || !top.awake || ball != all) {
        trial_fault(t, "edit %d: slept %d, top awake %d, ball awake %d", what, slept, top.awake,
                    ball);
    }
    if ((what == 3 || what == 4 || what == 5) &&
        !(top.position.y < before - 10 * t->step * t->step)) {
        trial_fault(t, "edit %d: the top fell by %g", what, before - top.position.y);
    }
}

/* ---- depth ---- */

/* The largest allowed depth of a stack of three, in length scales, 1 second after it was created.
 * Soft contacts overlap in proportion to the square of the time step. */
static double depth_allowed(const trial *t) {
    static const double most[] = {[DRAFT] = 0.003, [DEFAULT] = 0.0008, [HIGH] = 0, [EXACT] = 0};
    return most[t->set->value[QUALITY]] * (60 * t->step) * (60 * t->step) + 5e-6;
}

static void what_rests_overlaps_little(trial *t) {
    heap h = make_heap(t, trial_def(t));
    if (!h.world) {
        return;
    }
    trial_run(t, h.world, trial_steps(t, 1));
    double depth = deepest(t, &h);
    if (depth > depth_allowed(t)) {
        trial_fault(t, "it overlaps by %g, not %g", depth, depth_allowed(t));
    }
}

/* A heap that begins overlapped: the maximum and the number of overlaps that the step reports agree
 * with thud_measure_of and with geometry, except where the detection moves bodies after the
 * solver. */
static void error_tells_the_overlap(trial *t) {
    thud_world_def def = trial_def(t);
    def.sleeping = false;
    heap h = make_heap(t, def);
    if (!h.world) {
        return;
    }
    for (int i = 0; i < STACK; i++) {
        DO(t, thud_body_set_transform(h.world, h.box[i], trial_place(t, 0, 0.38 + 0.77 * i), 0));
    }
    int compared = 0;
    for (int k = 0; k < 40 && !trial_failed(t); k++) {
        trial_run(t, h.world, 1);
        thud_stats s = thud_stats_of(h.world);
        if (s.impacts || s.held_bodies) {
            continue;
        }
        compared++;
        double told = thud_step_error_of(h.world).penetration_max / t->scale;
        double measured = thud_measure_of(h.world).penetration_max / t->scale;
        double depth = deepest(t, &h);
        if (fabs(told - depth) > 2e-5 + 1e-3 * depth ||
            fabs(measured - depth) > 2e-5 + 1e-3 * depth) {
            trial_fault(t, "step %d: %g is told, %g measured, of %g", k, told, measured, depth);
        }
    }
    if (compared == 0) {
        trial_fault(t, "detection moved bodies in every step");
    }
}

/* A heavy box on a light one, in a world with max_error: at rest the overlap stays below it. */
static void max_error_is_kept_at_rest(trial *t) {
    thud_shape_def heavy = thud_default_shape_def();
    thud_world_def def = trial_def(t);
    def.max_error = 1e-3 * t->scale;
    heavy.density = 10; /* density ratio that quality default would leave to the soft solver */
    thud_world *world = trial_make(t, def);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 5, 1);
    trial_drop(t, world, TURNED, 0, 0.3, 0.3);
    trial_add(t, world,
              (part){.kind = THUD_BODY_DYNAMIC,
                     .form = TURNED,
                     .y = 1,
                     .hx = 0.4,
                     .hy = 0.4,
                     .shape = &heavy});
    trial_run(t, world, trial_steps(t, 1.5));
    double depth = thud_measure_of(world).penetration_max;
    if (depth > def.max_error) {
        trial_fault(t, "it overlaps by %g of %g", depth, def.max_error);
    }
}

/* ---- energy ---- */

static double energy_of(const thud_world *world) {
    thud_measure m = thud_measure_of(world);
    return m.kinetic_energy + m.potential_energy;
}

/* Bodies without restitution that fall into a box never have more energy than at the beginning
 * (1e-5 for rounding). */
static void falling_gains_no_energy(trial *t) {
    thud_world_def def = trial_def(t);
    def.sleeping = false;
    thud_world *world = trial_make(t, def);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 3, 1);
    trial_wall(t, world, -3, 2, 0.5, 4);
    trial_wall(t, world, 3, 2, 0.5, 4);
    for (int i = 0; i < 8; i++) {
        trial_add(t, world,
                  (part){.kind = THUD_BODY_DYNAMIC,
                         .form = (form)(i % FORMS),
                         .x = i % 3 * 1.2 - 1.2,
                         .y = 1 + i / 3,
                         .hx = 0.35,
                         .hy = 0.35,
                         .vx = trial_draw(t, -4, 4),
                         .spin = i % FORMS == UPRIGHT ? 0 : trial_draw(t, -4, 4)});
    }
    double first = energy_of(world);
    for (int k = 0; k < trial_steps(t, 1.5) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        double now = energy_of(world);
        if (now > first * (1 + 1e-5)) {
            trial_fault(t, "step %d: energy %g, at first %g", k, now, first);
        }
    }
}

/* The energy change that a step reports is that of kinetic and potential energy, in steps without
 * impacts and held bodies. */
static void error_tells_the_energy_change(trial *t) {
    thud_world_def def = trial_def(t);
    def.sleeping = false;
    yard y;
    yard_make(&y, t, def, 0);
    for (int k = 0; k < 40 && !trial_failed(t); k++) {
        double before = energy_of(y.world);
        trial_run(t, y.world, 1);
        thud_measure m = thud_measure_of(y.world);
        thud_stats s = thud_stats_of(y.world);
        double change = m.kinetic_energy + m.potential_energy - before;
        double told = thud_step_error_of(y.world).energy_change;
        double slack = 3e-6 * (m.kinetic_energy + fabs(before));
        if (s.impacts == 0 && s.held_bodies == 0 && fabs(change - told) > slack) {
            trial_fault(t, "step %d: energy changed by %g, told %g", k, change, told);
        }
    }
}

/* A ball of restitution 1 between walls, under gravity and without friction, keeps its energy. */
static void elastic_bodies_keep_their_energy(trial *t) {
    thud_shape_def elastic = thud_default_shape_def();
    thud_world_def def = trial_def(t);
    elastic.restitution = 1;
    elastic.friction = 0;
    thud_world *world = trial_make(t, def);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 5, 1);
    trial_wall(t, world, -4, 5, 1, 9);
    trial_wall(t, world, 4, 5, 1, 9);
    trial_add(t, world,
              (part){.kind = THUD_BODY_DYNAMIC,
                     .form = BALL,
                     .x = 0.5,
                     .y = 2,
                     .hx = 0.3,
                     .vx = 3.3,
                     .shape = &elastic});
    double first = energy_of(world);
    trial_run(t, world, trial_steps(t, 4));
    double last = energy_of(world);
    if (fabs(last - first) > 1e-5 * first) {
        trial_fault(t, "energy %g became %g", first, last);
    }
}

const guarantee guarantees_of_rest[] = {
    GUARANTEE_EXCEPT(edits_wake_who_touches, {SLEEPING, BIT(0), "nothing sleeps"}),
    GUARANTEE_EXCEPT(elastic_bodies_keep_their_energy,
                     {DETECTION, ALL_BUT(SWEPT), "only swept bodies bounce where they meet"}),
    GUARANTEE(error_tells_the_energy_change),
    GUARANTEE(error_tells_the_overlap),
    GUARANTEE(falling_gains_no_energy),
    GUARANTEE_EXCEPT(max_error_is_kept_at_rest,
                     {QUALITY, BIT(DRAFT), "it has no island solver, and a max_error is refused"}),
    GUARANTEE(overlaps_part_before_they_sleep),
    GUARANTEE(what_rests_overlaps_little),
    GUARANTEE(what_rests_stays_and_sleeps),
    {.name = NULL},
};
