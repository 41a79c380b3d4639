/* passing.c: guarantees of collision detection for moving bodies: what stops them (thin walls,
 * other moving bodies), and what does not (seams of ground, shapes that a teleport skips). */
#include "guarantee.h"
#include "yard.h"

#include <thud/thud_joint.h>

enum { SHOTS = 6 };

/* The largest speed, in length scales per second, at which a body of half extents 0.3 is promised
 * to collide with a wall of this thickness, by the rules of the trial's detection
 * (thud_detection.h). */
static double fastest(trial *t, thud_world *world, double thickness) {
    double limit = 0;
    switch (t->set->value[DETECTION]) {
    case OVERLAP:
        return 0.8 * thickness / t->step;
    case BISECT:
        DO(t, thud_world_get_bisection_limit(world, &limit));
        return 0.8 * limit / t->scale;
    default:
        return 1e4;
    }
}

/* A random speed between a tenth of `most` and `most`, uniform in its logarithm. */
static double draw_speed(trial *t, double most) {
    return exp(trial_draw(t, log(0.1 * most), log(most)));
}

/* Reports shots that have passed x = reach. Each shot starts at the left in a row of its own, at y0
 * + 4 i. */
static void expect_stopped(trial *t, thud_world *world, const thud_body_id *shot, double y0,
                           double reach) {
    for (int i = 0; i < SHOTS && !trial_failed(t); i++) {
        thud_body_state s = trial_state(t, world, shot[i]);
        if (s.position.x > reach) {
            trial_fault(t, "shot %d, first at y %g, is at %g, %g", i, y0 + 4 * i, s.position.x,
                        s.position.y);
        }
    }
}

/* Adds a body that flies along x at `speed`; `i` is its lane and form. */
static thud_body_id shoot(trial *t, thud_world *world, int i, double speed,
                          const thud_detection *detection) {
    return trial_add(t, world,
                     (part){.kind = THUD_BODY_DYNAMIC,
                            .form = (form)(i % FORMS),
                            .x = trial_draw(t, -3, -1),
                            .y = 4 * i,
                            .angle = i % FORMS == TURNED ? trial_draw(t, -1, 1) : 0,
                            .hx = 0.3,
                            .hy = 0.3,
                            .vx = speed,
                            .detection = detection});
}

static void thin_static_walls_stop(trial *t) {
    bool overlap = t->set->value[DETECTION] == OVERLAP;
    double half = overlap ? 0.2 : 0.01;
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id shot[SHOTS];
    if (!world) {
        return;
    }
    trial_wall(t, world, half, 0, half, 15000);
    double most = fastest(t, world, 2 * half);
    for (int i = 0; i < SHOTS; i++) {
        shot[i] = shoot(t, world, i, draw_speed(t, most), NULL);
    }
    int steps = most * t->step > 0.01 ? trial_steps(t, fmin(0.5, 400 * t->step)) : 10;
    trial_run(t, world, steps);
    expect_stopped(t, world, shot, 0, overlap ? 0.1 : 0);
}

/* Shot and plate both move: a shot that began on the left of its plate stays there, unless it goes
 * round the plate's end. */
static void moving_bodies_meet(trial *t) {
    bool swept = t->set->value[DETECTION] == SWEPT;
    double half = swept ? 0.02 : 0.3;
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id shot[SHOTS], plate[SHOTS];
    if (!world) {
        return;
    }
    for (int i = 0; i < SHOTS; i++) {
        plate[i] = trial_add(t, world,
                             (part){.kind = THUD_BODY_DYNAMIC,
                                    .form = UPRIGHT,
                                    .x = half,
                                    .y = 4 * i,
                                    .hx = half,
                                    .hy = 1.5});
        shot[i] = shoot(t, world, i, 0, NULL);
    }
    double limit = 0;
    DO(t, thud_world_get_bisection_limit(world, &limit));
    double most = swept ? 3e3 : fmin(0.4 * 2 * half / t->step, 0.4 * limit / t->scale);
    for (int i = 0; i < SHOTS; i++) {
        double u = draw_speed(t, most), v = trial_draw(t, 0, most);
        DO(t, thud_body_set_velocity(world, shot[i], trial_speed(t, u, 0), 0));
        DO(t, thud_body_set_velocity(world, plate[i], trial_speed(t, -v, 0), 0));
    }
    for (int k = 0; k < 200 && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        for (int i = 0; i < SHOTS; i++) {
            thud_pos at = trial_state(t, world, shot[i]).position;
            thud_pos wall = trial_state(t, world, plate[i]).position;
            if (at.x > wall.x && fabs(at.y - wall.y) < 1.5) {
                trial_fault(t, "step %d: shot %d is at %g, the plate at %g", k, i, at.x, wall.x);
            }
        }
    }
}

/* In a pair of two moving bodies the higher of both detections decides. */
static void bodies_own_detection_decides(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id shot[SHOTS];
    if (!world) {
        return;
    }
    trial_wall(t, world, 0.01, 0, 0.01, 15000);
    for (int i = 0; i < SHOTS; i++) {
        bool plate = i % 2;
        if (plate) {
            trial_add(t, world,
                      (part){.kind = THUD_BODY_DYNAMIC,
                             .form = UPRIGHT,
                             .x = -0.3,
                             .y = 4 * i,
                             .hx = 0.02,
                             .hy = 1});
        }
        shot[i] = shoot(t, world, i, draw_speed(t, 1e4), &thud_detection_swept);
    }
    trial_run(t, world, 20);
    expect_stopped(t, world, shot, 0, 0);
}

enum { GAS = 8 };

/* The penetration depth of two bodies in length scales; 0 if they are apart. */
static double overlap_of(trial *t, thud_world *world, thud_body_id a, thud_body_id b) {
    thud_geometry one = trial_placed(t, world, a), other = trial_placed(t, world, b);
    thud_closest c = {.distance = 1};
    DO(t, thud_geometry_closest(&one, &other, &c));
    return fmax(-c.distance, 0);
}

/* Bodies that are apart do not come to overlap by more than the load that presses them together
 * explains. */
static void swept_bodies_keep_apart(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id body[GAS];
    double overlap[GAS * GAS] = {0};
    if (!world) {
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        trial_wall(t, world, side * 4.0, 0, 1, 5);
        trial_wall(t, world, 0, side * 4.0, 5, 1);
    }
    for (int i = 0; i < GAS; i++) {
        body[i] = trial_add(t, world,
                            (part){.kind = THUD_BODY_DYNAMIC,
                                   .form = (form)(i % FORMS),
                                   .x = i % 3 * 1.5 - 1.5,
                                   .y = i / 3 * 1.5 - 1.5,
                                   .hx = 0.3,
                                   .hy = 0.2,
                                   .vx = trial_draw(t, -30, 30),
                                   .vy = trial_draw(t, -30, 30)});
    }
    for (int k = 0; k < 40 && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        for (int i = 0; i < GAS * GAS; i++) {
            int a = i / GAS, b = i % GAS;
            double now = a < b ? overlap_of(t, world, body[a], body[b]) : 0;
            if (now > overlap[i] + 3.5e-4 || now > 5e-3) {
                trial_fault(t, "step %d: %d and %d overlap by %g, before by %g", k, a, b, now,
                            overlap[i]);
            }
            overlap[i] = now;
        }
    }
}

enum { ROPES = 4 };

/* Ropes from bodies in the room to hooks outside of its walls and its floor, shortened by 3 length
 * scales per second without regard to what is in between. */
typedef struct winches {
    thud_joint_id rope[ROPES];
    thud_drive drive[ROPES];
} winches;

static winches reel_from_outside(yard *y) {
    static const double at[ROPES][2] = {{0, -6}, {12, 4}, {-12, 4}, {3, -6}};
    trial *t = y->t;
    winches w;
    for (int i = 0; i < ROPES; i++) {
        thud_joint_def def = thud_default_joint_def(THUD_JOINT_DISTANCE);
        thud_body_def hook = thud_default_body_def();
        thud_pos from = trial_place(t, at[i][0], at[i][1]);
        thud_body_state s = {.mass = 0};
        def.body_b = y->body[3 * i];
        hook.position = from;
        DO(t, thud_body_create(y->world, &hook, &def.body_a));
        DO(t, thud_body_get_state(y->world, def.body_b, &s));
        def.drive[THUD_DIRECTION_ALONG].limited = true;
        def.drive[THUD_DIRECTION_ALONG].upper =
            (float)hypot(s.position.x - from.x, s.position.y - from.y);
        w.drive[i] = def.drive[THUD_DIRECTION_ALONG];
        DO(t, thud_joint_create(y->world, &def, &w.rope[i]));
    }
    return w;
}

/* Shortens the ropes by a step, but keeps each at most 0.1 length scales shorter than the distance
 * that it spans. A rope that is much too short, after an edit has moved its body away, pulls the
 * body faster than `overlap` and `bisect` can detect; without this rule 3 of 4,000 such rooms lose
 * a body (thud_joint.h). */
static void reel_in(trial *t, thud_world *world, winches *w) {
    for (int i = 0; i < ROPES; i++) {
        thud_joint_state s = {.gap = 0};
        if (!thud_joint_is_valid(world, w->rope[i])) {
            continue;
        }
        DO(t, thud_joint_get_state(world, w->rope[i], &s));
        double length = (double)w->drive[i].upper - 3 * t->scale * t->step;
        double taut = s.value[THUD_DIRECTION_ALONG] - 0.1 * t->scale;
        w->drive[i].upper = (float)fmax(fmax(length, taut), 0.1 * t->scale);
        DO(t, thud_joint_set_drive(world, w->rope[i], THUD_DIRECTION_ALONG, &w->drive[i]));
    }
}

static void nothing_is_lost(trial *t) {
    yard y;
    yard_make_loose(&y, t, trial_def(t), 0);
    winches w = reel_from_outside(&y);
    for (int k = 0; k < 2 * trial_steps(t, 0.5) && !trial_failed(t); k++) {
        reel_in(t, y.world, &w);
        yard_step(&y);
        for (int i = 0; i < YARD_BODIES && !trial_failed(t); i++) {
            thud_body_state s = trial_state(t, y.world, y.body[i]);
            bool sensor = i % 7 == 6;
            if (!sensor && s.enabled &&
                !(fabs(s.position.x) < 5.1 && s.position.y > -0.3 && s.position.y < 10.1)) {
                trial_fault(t, "step %d: body %d is at %g, %g", k, i, s.position.x, s.position.y);
            }
        }
    }
}

/* A ground of boxes (AABBs and OBBs by turns), which a terrain line continues. */
static void make_seams(trial *t, thud_world *world, const thud_shape_def *smooth) {
    thud_pos points[11];
    thud_body_def def = thud_default_body_def();
    thud_body_id body;
    for (int i = 0; i < 24; i++) {
        trial_add(t, world,
                  (part){.form = i % 2 ? UPRIGHT : TURNED,
                         .x = i + 0.5,
                         .y = -0.5,
                         .hx = 0.5,
                         .hy = 0.5,
                         .shape = smooth});
    }
    for (int i = 0; i < 11; i++) {
        points[i] = trial_place(t, 24 + 1.5 * i, 0);
    }
    DO(t, thud_body_create(world, &def, &body));
    DO(t,
       thud_shape_create_terrain(
           world, body, smooth,
           &(thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 11}, NULL));
}

static void seams_catch_nothing(trial *t) {
    thud_shape_def smooth = thud_default_shape_def();
    smooth.friction = 0;
    form kind = (form)trial_pick(t, FORMS);
    double speed = trial_draw(t, 3, 9), hop = 0;
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    make_seams(t, world, &smooth);
    thud_body_id slider = trial_add(t, world,
                                    (part){.kind = THUD_BODY_DYNAMIC,
                                           .form = kind,
                                           .x = 1.3,
                                           .y = 0.3,
                                           .hx = 0.3,
                                           .hy = 0.3,
                                           .shape = &smooth});
    trial_run(t, world, trial_steps(t, 0.5));
    double rest = trial_state(t, world, slider).position.y;
    DO(t, thud_body_set_velocity(world, slider, trial_speed(t, speed, 0), 0));
    for (int k = 0; k < trial_steps(t, 27.0 / speed) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        thud_body_state s = trial_state(t, world, slider);
        hop = fmax(hop, fabs(s.position.y - rest));
        if (fabs((double)s.velocity.x - speed) > 1e-3 * speed || hop > 1e-3) {
            trial_fault(t, "form %d at x = %g: speed %g of %g, hop %g", (int)kind, s.position.x,
                        (double)s.velocity.x, speed, hop);
        }
    }
}

/* A body that is set to a place stands exactly there, and has collided with nothing in between. */
static void teleports_meet_nothing(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, 0, 0.5, 4);
    thud_body_id body = trial_drop(t, world, (form)trial_pick(t, FORMS), -2, 0, 0.3);
    thud_body_id other = trial_drop(t, world, BALL, -1.5, 0, 0.3); /* touches the body */
    trial_run(t, world, 2);
    thud_pos to = trial_place(t, 3, 1);
    DO(t, thud_body_set_transform(world, body, to, 0));
    DO(t, thud_body_set_velocity(world, body, (thud_vec2){0, 0}, 0));
    trial_run(t, world, 1);
    thud_body_state s = {.mass = 0};
    DO(t, thud_body_get_state(world, body, &s));
    thud_events e = thud_events_of(world);
    if (s.position.x != to.x || s.position.y != to.y || e.begin_count || e.hit_count) {
        trial_fault(t, "it is at %g, %g, and %d began", s.position.x, s.position.y, e.begin_count);
    }
    if (e.end_count != 1 || thud_stats_of(world).contacts != 0) {
        trial_fault(t, "%d of its contacts ended", e.end_count);
    }
    (void)other;
}

const guarantee guarantees_of_passing[] = {
    GUARANTEE(bodies_own_detection_decides),
    GUARANTEE(moving_bodies_meet),
    GUARANTEE(nothing_is_lost),
    GUARANTEE(seams_catch_nothing),
    GUARANTEE_EXCEPT(swept_bodies_keep_apart,
                     {DETECTION, ALL_BUT(SWEPT),
                      "the soft contacts of the others begin by overlapping"}),
    GUARANTEE(teleports_meet_nothing),
    GUARANTEE(thin_static_walls_stop),
    {.name = NULL},
};
