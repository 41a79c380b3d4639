/* bodies.c: guarantees of single bodies: kinds of bodies, motion under forces, limits of speed, and
 * bodies that are disabled or destroyed. */
#include "guarantee.h"
#include "yard.h"

/* ---- kinds ---- */

/* A kinematic plate moves at its velocity, and pushes the body in its path along. */
static void kinematic_bodies_push(trial *t) {
    form kind = (form)trial_pick(t, FORMS);
    thud_world *world = trial_make(t, trial_weightless(t));
    double speed = trial_draw(t, 1, 4);
    if (!world) {
        return;
    }
    thud_body_id plate = trial_add(t, world,
                                   (part){.kind = THUD_BODY_KINEMATIC,
                                          .form = UPRIGHT,
                                          .x = -1,
                                          .hx = 0.3,
                                          .hy = 1,
                                          .vx = speed});
    thud_body_id body = trial_drop(t, world, kind, 0, 0, 0.3);
    int steps = trial_steps(t, 1);
    trial_run(t, world, steps);
    thud_body_state p = trial_state(t, world, plate), b = trial_state(t, world, body);
    double way = -1 + speed * t->step * steps;
    if (fabs(p.position.x - way) > 1e-5 || fabs((double)p.velocity.x - speed) > 1e-6 * speed) {
        trial_fault(t, "the plate is at %g, not %g, at speed %g", p.position.x, way,
                    (double)p.velocity.x);
    }
    if (b.position.x - p.position.x < 0.55 || (double)b.velocity.x < 0.9 * speed) {
        trial_fault(t, "the body is %g ahead, at speed %g of %g", b.position.x - p.position.x,
                    (double)b.velocity.x, speed);
    }
}

/* Forces and collisions do not move static and kinematic bodies, and do not turn a body with an
 * AABB. */
static void what_cannot_move_does_not(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_body_def fixed = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id stiff = {0, 0};
    if (!world) {
        return;
    }
    thud_body_id floor = trial_wall(t, world, 0, -1, 5, 1);
    thud_body_id plate = trial_add(
        t, world,
        (part){.kind = THUD_BODY_KINEMATIC, .form = TURNED, .x = 2, .y = 1, .hx = 0.5, .hy = 0.2});
    thud_body_id box = trial_drop(t, world, UPRIGHT, 0, 0.5, 0.3);
    fixed.kind = THUD_BODY_DYNAMIC;
    fixed.fixed_rotation = true;
    fixed.position = trial_place(t, -2, 0.5);
    DO(t, thud_body_create(world, &fixed, &stiff));
    DO(t, thud_shape_create_obb(world, stiff, &shape, (thud_vec2){0, 0}, trial_speed(t, 0.3, 0.3),
                                0, NULL));
    for (int i = 0; i < 3; i++) {
        trial_add(t, world,
                  (part){.kind = THUD_BODY_DYNAMIC,
                         .form = BALL,
                         .x = 2 * i - 1.8,
                         .y = 2.5,
                         .hx = 0.4,
                         .vy = -8,
                         .spin = 9});
    }
    for (int k = 0; k < trial_steps(t, 0.5) && !trial_failed(t); k++) {
        DO(t, thud_body_apply_center_force(world, box, trial_speed(t, 0, 0)));
        DO(t, thud_body_apply_torque(world, box, 5.0f));
        trial_run(t, world, 1);
    }
    thud_pos place = trial_place(t, 0, -1), at = trial_place(t, 2, 1);
    thud_body_state s = {.mass = 0}, p = {.mass = 0};
    DO(t, thud_body_get_state(world, floor, &s));
    DO(t, thud_body_get_state(world, plate, &p));
    if (s.position.x != place.x || s.position.y != place.y || p.position.x != at.x ||
        p.position.y != at.y || p.angle != 0 || s.angle != 0) {
        trial_fault(t, "the floor is at %g, %g, the plate at %g, %g", s.position.x, s.position.y,
                    p.position.x, p.position.y);
    }
    if (trial_state(t, world, box).angle != 0 || trial_state(t, world, stiff).angle != 0) {
        trial_fault(t, "what must not turn is turned");
    }
}

/* ---- motion ---- */

/* After n steps of a fall the velocity is that of gravity, and the body is on the exact parabola,
 * up to rounding. */
static void falls_follow_gravity(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    thud_body_id body = trial_add(t, world,
                                  (part){.kind = THUD_BODY_DYNAMIC,
                                         .form = (form)trial_pick(t, FORMS),
                                         .hx = 0.3,
                                         .hy = 0.3,
                                         .vx = 2,
                                         .vy = 3});
    int steps = trial_steps(t, 0.7);
    trial_run(t, world, steps);
    thud_body_state s = trial_state(t, world, body);
    double time = steps * t->step, v = 3 - 10 * time, y = 3 * time - 5 * time * time;
    if (fabs((double)s.velocity.y - v) > 3e-4 || fabs(s.position.x - 2 * time) > 2e-5 ||
        fabs(s.position.y - y) > 1e-4) {
        trial_fault(t, "it is at %g, %g, not %g, %g, at speed %g, not %g", s.position.x,
                    s.position.y, 2 * time, y, (double)s.velocity.y, v);
    }
}

/* A force acts for one step, an impulse at once. */
static void forces_act_for_one_step(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    if (!world) {
        return;
    }
    thud_body_id body = trial_drop(t, world, BALL, 0, 0, 0.3);
    float mass = trial_state(t, world, body).mass;
    thud_vec2 force = trial_speed(t, 5 * (double)mass, 0), push = trial_speed(t, 0, (double)mass);
    DO(t, thud_body_apply_center_force(world, body, force));
    trial_run(t, world, 1);
    double first = (double)trial_state(t, world, body).velocity.x;
    trial_run(t, world, 3);
    double later = (double)trial_state(t, world, body).velocity.x;
    thud_body_state s = {.mass = 0};
    DO(t, thud_body_get_state(world, body, &s));
    DO(t, thud_body_apply_impulse(world, body, push, s.center));
    double up = (double)trial_state(t, world, body).velocity.y;
    if (fabs(first - 5 * t->step) > 1e-5 || later != first || fabs(up - 1) > 1e-5) {
        trial_fault(t, "speed %g, later %g, of %g; by the impulse %g of 1", first, later,
                    5 * t->step, up);
    }
}

/* No force or impulse makes a body move or turn faster than the world's limits. */
static void speeds_have_their_limits(trial *t) {
    thud_world_def def = trial_def(t);
    def.maximum_speed = 1e3f;
    thud_world *world = trial_make(t, def);
    if (!world) {
        return;
    }
    thud_body_id body = trial_drop(t, world, TURNED, 0, 0, 0.3);
    for (int k = 0; k < 5 && !trial_failed(t); k++) {
        thud_vec2 hard = {(float)trial_draw(t, -1e20, 1e20), (float)trial_draw(t, -1e20, 1e20)};
        DO(t, thud_body_apply_center_force(world, body, hard));
        DO(t, thud_body_apply_torque(world, body, 1e25f));
        trial_run(t, world, 1);
        thud_body_state s = trial_state(t, world, body);
        double most = fmax(fabs((double)s.velocity.x), fabs((double)s.velocity.y));
        if (!(most <= 1001 && most > 900 * trial_unit(t) / t->scale &&
              fabs((double)s.angular_velocity) <= 1.0001e8)) {
            trial_fault(t, "step %d: speed %g, spin %g", k, most, (double)s.angular_velocity);
        }
    }
}

/* A fast body with high friction throws off the bodies that touch it; their speed stays below the
 * world's maximum_speed too, except after an impact within the step. */
static void what_is_thrown_off_has_its_limit(trial *t) {
    thud_world_def def = trial_weightless(t);
    thud_shape_def rough = thud_default_shape_def();
    def.maximum_speed = 100;
    rough.friction = 10;
    rough.density = 100;
    thud_world *world = trial_make(t, def);
    for (int k = 0; k < 8 && world && !trial_failed(t); k++) {
        trial_add(t, world,
                  (part){.kind = THUD_BODY_DYNAMIC,
                         .form = k % 2 ? TURNED : BALL,
                         .x = 20 * k,
                         .hx = 0.5,
                         .hy = 0.5,
                         .spin = 2e4 * (k + 1),
                         .shape = &rough});
        thud_body_id thrown = trial_drop(t, world, BALL, 20 * k + 0.55, 0.05 * k, 0.1);
        for (int i = 0; i < 4; i++) {
            trial_run(t, world, 1);
            thud_body_state s = trial_state(t, world, thrown);
            double speed = fmax(fabs((double)s.velocity.x), fabs((double)s.velocity.y));
            if (!(speed <= 100.1 || thud_stats_of(world).impacts)) {
                trial_fault(t, "what is thrown off is at speed %g", speed);
            }
        }
    }
}

/* Under forces near the limit of floats, every body stays finite or is reported as quarantined. */
static void all_is_finite(trial *t) {
    thud_world_def def = trial_def(t);
    int frozen = 0, told = 0;
    yard y;
    yard_make(&y, t, def, 0);
    for (int k = 0; k < 40 && !trial_failed(t); k++) {
        thud_body_id body = y.body[trial_pick(t, YARD_BODIES)];
        thud_vec2 hard = {(float)trial_draw(t, 2e38, 3e38), (float)trial_draw(t, -3e38, 3e38)};
        for (int twice = 0; twice < 2 && k % 4 == 0; twice++) { /* twice this is more than a float
                                                                   can hold */
            DO(t, thud_body_apply_center_force(y.world, body, hard));
            DO(t, thud_body_apply_torque(y.world, body, k % 8 ? 1e25f : 0));
        }
        yard_step(&y);
        told += thud_events_of(y.world).quarantined_count;
        for (int i = 0; i < YARD_BODIES && !trial_failed(t); i++) {
            thud_body_state s = trial_state(t, y.world, y.body[i]);
            double speed = hypot((double)s.velocity.x, (double)s.velocity.y);
            if (!(isfinite(s.position.x) && isfinite(s.position.y) && isfinite(s.angle) &&
                  isfinite((double)s.angular_velocity) && isfinite(speed))) {
                trial_fault(t, "step %d: body %d at %g, %g, speed %g", k, i, s.position.x,
                            s.position.y, speed);
            }
            frozen += s.quarantined && k == 39;
        }
        thud_step_error e = thud_step_error_of(y.world);
        if (!(isfinite(e.penetration_max) && isfinite(e.penetration_mean) && isfinite(e.residual) &&
              isfinite(e.energy_change))) {
            trial_fault(t, "step %d: errors are %g, %g, %g, %g", k, e.penetration_max,
                        e.penetration_mean, e.residual, e.energy_change);
        }
    }
    if (told == 0 || told < frozen) {
        trial_fault(t, "%d bodies are quarantined, and %d were told of", frozen, told);
    }
}

/* ---- coming and going ---- */

static bool count_one(thud_shape_id shape, void *context) {
    (void)shape;
    ++*(int *)context;
    return true;
}

/* How many shapes overlap a small circle at that place. */
static int found_at(trial *t, thud_world *world, double x, double y) {
    int found = 0;
    DO(t, thud_world_overlap_shape(world, trial_place(t, x, y),
                                   thud_circle_at(0, 0, 0.05 * t->scale), NULL, count_one, &found));
    return found;
}

/* Nothing collides with a disabled body or finds it by a query; enabled again, it has the same
 * state as before. */
static void disabled_bodies_are_not_there(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    double speed = 0.3 / t->step;
    if (!world) {
        return;
    }
    thud_body_id plate = trial_add(
        t, world,
        (part){.kind = THUD_BODY_KINEMATIC, .form = UPRIGHT, .hx = 0.4, .hy = 1, .vy = 0.001});
    thud_body_id still = trial_drop(t, world, BALL, -0.69, 0, 0.3); /* touches the plate */
    trial_run(t, world, 1);
    int before = found_at(t, world, 0, 0);
    DO(t, thud_body_set_enabled(world, plate, false));
    int out = found_at(t, world, 0, 0);
    thud_body_id shot = trial_add(t, world,
                                  (part){.kind = THUD_BODY_DYNAMIC,
                                         .form = BALL,
                                         .x = -2,
                                         .y = 0.65,
                                         .hx = 0.3,
                                         .vx = speed});
    trial_run(t, world, 1);
    int ends = thud_events_of(world).end_count;
    trial_run(t, world, 19);
    double x = trial_state(t, world, shot).position.x;
    DO(t, thud_body_set_enabled(world, plate, true));
    int back = found_at(t, world, 0, 0);
    double kept = (double)trial_state(t, world, plate).velocity.y;
    if (before != 1 || out != 0 || back != 1 || ends != 1 || fabs(kept - 0.001) > 1e-6 ||
        fabs(x - (-2 + 20 * 0.3)) > 1e-3) {
        trial_fault(t, "found %d, %d, %d; %d ended; the shot is at %g; its speed was kept as %g",
                    before, out, back, ends, x, kept);
    }
    (void)still;
}

/* Handles of a destroyed body are stale, also when its slot has a new body, and its contacts end
 * with events. */
static void destroyed_bodies_are_gone(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_body_state s;
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 5, 1);
    thud_body_id below = trial_drop(t, world, UPRIGHT, 0, 0.3, 0.3);
    thud_body_id above = trial_drop(t, world, UPRIGHT, 0, 0.9, 0.3);
    trial_run(t, world, trial_steps(t, 2.5));
    thud_shape_id shape = trial_shape(t, world, below);
    DO(t, thud_body_destroy(world, below));
    REFUSED(t, thud_body_get_state(world, below, &s), THUD_ERROR_STALE);
    REFUSED(t, thud_shape_destroy(world, shape), THUD_ERROR_STALE);
    trial_run(t, world, 1);
    int ends = thud_events_of(world).end_count;
    trial_run(t, world, trial_steps(t, 1));
    double y = trial_state(t, world, above).position.y;
    if (ends != 2 || fabs(y - 0.3) > 0.02) {
        trial_fault(t, "%d contacts ended, and what stood on it is at %g", ends, y);
    }
    bool reused = false;
    for (int i = 0; i < 8; i++) {
        reused |= trial_drop(t, world, BALL, 3 + i, 0.3, 0.3).index1 == below.index1;
    }
    if (!reused || thud_body_is_valid(world, below) || thud_shape_is_valid(world, shape)) {
        trial_fault(t, "its slot is %s, and its handle valid again",
                    reused ? "another's" : "empty");
    }
}

const guarantee guarantees_of_bodies[] = {
    GUARANTEE(all_is_finite),
    GUARANTEE(destroyed_bodies_are_gone),
    GUARANTEE(disabled_bodies_are_not_there),
    GUARANTEE(falls_follow_gravity),
    GUARANTEE(forces_act_for_one_step),
    GUARANTEE(kinematic_bodies_push),
    GUARANTEE(speeds_have_their_limits),
    GUARANTEE(what_cannot_move_does_not),
    GUARANTEE(what_is_thrown_off_has_its_limit),
    {.name = NULL},
};
