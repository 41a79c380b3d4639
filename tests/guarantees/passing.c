/* passing.c: guarantees of collision detection for moving bodies: what stops them (thin walls,
 * other moving bodies), and what does not (seams of ground, shapes that a teleport skips). */
#include "guarantee.h"
#include "yard.h"

#include <thud/thud_joint.h>

/* Lengths below are in length scales, speeds in length scales per second (trial.h). Shot i starts
 * left of x = 0, in a lane of its own at y = LANE_HEIGHT i, and flies to the right. */
enum { SHOTS = 6, LANE_HEIGHT = 4 };

/* Shots of detections that know a limit fly at up to this share of it. Chosen. */
#define LIMIT_SHARE 0.8
/* Largest speed of shots of detections without a limit. Chosen. */
#define UNLIMITED_SPEED 1e4

/* Half the height of a wall that no shot flies around. Chosen; below THUD_SIZE_MAX. */
#define HIGH_WALL 15000

/* The largest speed at which shots are tested against a static wall of this thickness: below the
 * limit of the trial's detection, if it has one (thud_detection.h). */
static double max_test_speed(trial *t, thud_world *world, double thickness) {
    double limit = 0;
    switch (t->set->value[DETECTION]) {
    case OVERLAP: /* a step's motion must be shorter than the wall is thick */
        return LIMIT_SHARE * thickness / t->step;
    case BISECT:
        DO(t, thud_world_get_bisection_limit(world, &limit));
        return LIMIT_SHARE * limit / t->scale;
    default: /* continuous and swept stop at any speed */
        return UNLIMITED_SPEED;
    }
}

/* Shots start between these x, at a speed between SLOWEST_SHARE of the largest and the largest. */
#define FIRST_X_MIN (-3.0)
#define FIRST_X_MAX (-1.0)
#define SLOWEST_SHARE 0.1

/* A random speed up to `max`, uniform in its logarithm. */
static double draw_speed(trial *t, double max) {
    return exp(trial_draw(t, log(SLOWEST_SHARE * max), log(max)));
}

/* Steps in which the slowest shot flies from FIRST_X_MIN to 0, and half a second at least. */
static int steps_to_wall(const trial *t, double max_speed) {
    double slowest = SLOWEST_SHARE * max_speed * t->step; /* length scales a step */
    return (int)fmax(trial_steps(t, 0.5), ceil(-FIRST_X_MIN / slowest));
}

/* Makes steps. Reports shots whose origin passes x = max_x, and those that keep their speed, so
 * that they have met nothing. */
static void expect_stopped(trial *t, thud_world *world, const thud_body_id *shot, int steps,
                           double max_x) {
    float first_speed[SHOTS];
    for (int i = 0; i < SHOTS; i++) {
        first_speed[i] = trial_state(t, world, shot[i]).velocity.x;
    }
    for (int k = 1; k <= steps && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        for (int i = 0; i < SHOTS; i++) {
            thud_body_state s = trial_state(t, world, shot[i]);
            if (s.position.x > max_x) {
                trial_fault(t, "step %d: shot %d, first at y %d, is at %g, %g", k, i,
                            LANE_HEIGHT * i, s.position.x, s.position.y);
            }
            if (k == steps && s.velocity.x >= first_speed[i]) {
                trial_fault(t, "shot %d has met nothing and is at x %g", i, s.position.x);
            }
        }
    }
}

/* Adds shot i at a speed; its form depends on i. Null detection: the world's. */
static thud_body_id shoot(trial *t, thud_world *world, int i, double speed,
                          const thud_detection *detection) {
    return trial_add(t, world,
                     (part){.kind = THUD_BODY_DYNAMIC,
                            .form = (form)(i % FORMS),
                            .x = trial_draw(t, FIRST_X_MIN, FIRST_X_MAX),
                            .y = LANE_HEIGHT * i,
                            .angle = i % FORMS == TURNED ? trial_draw(t, -1, 1) : 0,
                            .hx = 0.3,
                            .hy = 0.3,
                            .vx = speed,
                            .detection = detection});
}

/* The wall is between x = 0 and 2 half. Under overlap it is thicker, since a shot may move up to
 * its thickness in a step, and may sink in by 0.1 (chosen), as soft contacts do. */
static void thin_static_walls_stop(trial *t) {
    bool overlap = t->set->value[DETECTION] == OVERLAP;
    double half = overlap ? 0.2 : 0.01; /* half the wall's thickness */
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id shot[SHOTS];
    if (!world) {
        return;
    }
    trial_wall(t, world, half, 0, half, HIGH_WALL);
    double max = max_test_speed(t, world, 2 * half);
    for (int i = 0; i < SHOTS; i++) {
        shot[i] = shoot(t, world, i, draw_speed(t, max), NULL);
    }
    expect_stopped(t, world, shot, steps_to_wall(t, max), overlap ? 0.1 : 0);
}

/* Half the height of a plate in moving_bodies_meet. */
#define PLATE_HALF_HEIGHT 1.5

/* Shot and plate both move: a shot that began on the left of its plate stays there, unless it goes
 * round the plate's end. */
static void moving_bodies_meet(trial *t) {
    bool swept = t->set->value[DETECTION] == SWEPT;
    double half = swept ? 0.02 : 0.3; /* half a plate's thickness */
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
                                    .y = LANE_HEIGHT * i,
                                    .hx = half,
                                    .hy = PLATE_HALF_HEIGHT});
        shot[i] = shoot(t, world, i, 0, NULL);
    }
    /* Both may have the largest speed, so that each gets half of what the detection allows. Swept
     * has no limit; 3,000 is chosen. */
    double limit = 0;
    DO(t, thud_world_get_bisection_limit(world, &limit));
    double allowed = fmin(2 * half / t->step, limit / t->scale);
    double max = swept ? 3e3 : 0.5 * LIMIT_SHARE * allowed;
    for (int i = 0; i < SHOTS; i++) {
        double u = draw_speed(t, max), v = trial_draw(t, 0, max);
        DO(t, thud_body_set_velocity(world, shot[i], trial_speed(t, u, 0), 0));
        DO(t, thud_body_set_velocity(world, plate[i], trial_speed(t, -v, 0), 0));
    }
    /* The slowest shot moves by 0.024 a step, 4.8 in 200 steps, and starts at most 3 away. */
    for (int k = 0; k < 200 && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        for (int i = 0; i < SHOTS; i++) {
            thud_pos at = trial_state(t, world, shot[i]).position;
            thud_pos wall = trial_state(t, world, plate[i]).position;
            if (at.x > wall.x && fabs(at.y - wall.y) < PLATE_HALF_HEIGHT) {
                trial_fault(t, "step %d: shot %d is at %g, the plate at %g", k, i, at.x, wall.x);
            }
        }
    }
}

/* Of two detections in a pair the higher one decides (overlap < continuous < bisect < swept). Swept
 * shots meet a thin static wall at x = 2 in a world of any detection; in every second lane they
 * meet a thin plate before it, which moves and has the world's detection. */
static void bodies_own_detection_decides(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id shot[SHOTS], plate[SHOTS];
    if (!world) {
        return;
    }
    trial_wall(t, world, 2.01, 0, 0.01, HIGH_WALL);
    for (int i = 0; i < SHOTS; i++) {
        if (i % 2) {
            plate[i] = trial_add(t, world,
                                 (part){.kind = THUD_BODY_DYNAMIC,
                                        .form = UPRIGHT,
                                        .x = -0.3,
                                        .y = LANE_HEIGHT * i,
                                        .hx = 0.02,
                                        .hy = 1});
        }
        shot[i] = shoot(t, world, i, draw_speed(t, UNLIMITED_SPEED), &thud_detection_swept);
    }
    expect_stopped(t, world, shot, 20, 2);
    for (int i = 1; i < SHOTS; i += 2) {
        double at = trial_state(t, world, shot[i]).position.x;
        double plate_at = trial_state(t, world, plate[i]).position.x;
        if (at > plate_at) {
            trial_fault(t, "shot %d is at %g, past its plate at %g", i, at, plate_at);
        }
    }
}

enum { GAS_BODIES = 8 };

/* Bounds of the overlap of two swept bodies, in length scales: the growth in a step that
 * thud_detection.h allows touching shapes under a load, and the depth at any time, chosen. */
#define OVERLAP_GROWTH_MAX 3.5e-4
#define OVERLAP_MAX 5e-3

/* The penetration depth of two bodies in length scales; 0 if they are apart. */
static double overlap_of(trial *t, thud_world *world, thud_body_id a, thud_body_id b) {
    thud_geometry one = trial_placed(t, world, a), other = trial_placed(t, world, b);
    thud_closest c = {.distance = 1};
    DO(t, thud_geometry_closest(&one, &other, &c));
    return fmax(-c.distance, 0);
}

/* Bodies that fly about in a closed box, and press each other together as they collide, overlap by
 * no more than these bounds. */
static void swept_bodies_keep_apart(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    thud_body_id body[GAS_BODIES];
    double overlap[GAS_BODIES * GAS_BODIES] = {0};
    if (!world) {
        return;
    }
    for (int side = -1; side <= 1; side += 2) {
        trial_wall(t, world, side * 4.0, 0, 1, 5);
        trial_wall(t, world, 0, side * 4.0, 5, 1);
    }
    for (int i = 0; i < GAS_BODIES; i++) {
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
        for (int i = 0; i < GAS_BODIES * GAS_BODIES; i++) {
            int a = i / GAS_BODIES, b = i % GAS_BODIES;
            double now = a < b ? overlap_of(t, world, body[a], body[b]) : 0;
            if (now > overlap[i] + OVERLAP_GROWTH_MAX || now > OVERLAP_MAX) {
                trial_fault(t, "step %d: %d and %d overlap by %g, before by %g", k, a, b, now,
                            overlap[i]);
            }
            overlap[i] = now;
        }
    }
}

enum { ROPES = 4 };

/* Speed at which a rope is shortened, length scales a second; the most by which it may be shorter
 * than the distance that it spans; and its smallest length, both length scales. Chosen. */
#define REEL_SPEED 3
#define REEL_SLACK 0.1
#define ROPE_LENGTH_MIN 0.1

/* Ropes from bodies in the yard's room to hooks outside of its walls and below its floor. They are
 * shortened without regard to what is in between, and so press the bodies against walls and floor.
 */
typedef struct ropes {
    thud_joint_id joint[ROPES];
    thud_drive limits[ROPES]; /* of the joints' direction along: upper is the rope's length, in the
                                 world's unit */
} ropes;

/* Ties bodies that collide to a hook each; body 6 is a sensor. */
static ropes make_ropes(yard *y) {
    static const double hooks[ROPES][2] = {{0, -6}, {12, 4}, {-12, 4}, {3, -6}};
    static const int tied[ROPES] = {0, 3, 7, 9};
    trial *t = y->t;
    ropes r;
    for (int i = 0; i < ROPES; i++) {
        thud_joint_def def = thud_default_joint_def(THUD_JOINT_DISTANCE);
        thud_body_def hook = thud_default_body_def();
        thud_pos from = trial_place(t, hooks[i][0], hooks[i][1]);
        thud_body_state s = {.mass = 0};
        def.body_b = y->body[tied[i]];
        hook.position = from;
        DO(t, thud_body_create(y->world, &hook, &def.body_a));
        DO(t, thud_body_get_state(y->world, def.body_b, &s));
        thud_drive *limits = &def.drive[THUD_DIRECTION_ALONG];
        limits->limited = true;
        limits->upper = (float)hypot(s.position.x - from.x, s.position.y - from.y);
        r.limits[i] = *limits;
        DO(t, thud_joint_create(y->world, &def, &r.joint[i]));
    }
    return r;
}

/* Shortens the ropes by what they lose in a step, but keeps each at most REEL_SLACK shorter than
 * the distance that it spans. A rope that is much too short, after an edit has moved its body away,
 * pulls the body faster than `overlap` and `bisect` can detect: without this rule 3 of 4,000 trials
 * lost a body. thud_joint.h names the limit. */
static void shorten_ropes(trial *t, thud_world *world, ropes *r) {
    for (int i = 0; i < ROPES; i++) {
        thud_joint_state s = {.gap = 0};
        if (!thud_joint_is_valid(world, r->joint[i])) {
            continue; /* its body was destroyed by an edit */
        }
        DO(t, thud_joint_get_state(world, r->joint[i], &s));
        double length = (double)r->limits[i].upper - REEL_SPEED * t->scale * t->step;
        double taut = s.value[THUD_DIRECTION_ALONG] - REEL_SLACK * t->scale;
        r->limits[i].upper = (float)fmax(fmax(length, taut), ROPE_LENGTH_MIN * t->scale);
        DO(t, thud_joint_set_drive(world, r->joint[i], THUD_DIRECTION_ALONG, &r->limits[i]));
    }
}

/* The inside of the yard's room (yard.c): |x| <= 5 and 0 <= y <= 10. By how far a body's origin may
 * be beyond its walls and ceiling, and below its floor, length scales. Chosen; not tuned. */
#define ROOM_HALF_WIDTH 5
#define ROOM_HEIGHT 10
#define WALL_TOLERANCE 0.1
#define FLOOR_TOLERANCE 0.3

static bool is_in_room(thud_pos at) {
    return fabs(at.x) < ROOM_HALF_WIDTH + WALL_TOLERANCE && at.y > -FLOOR_TOLERANCE &&
           at.y < ROOM_HEIGHT + WALL_TOLERANCE;
}

static bool is_sensor(trial *t, thud_world *world, thud_body_id body) {
    thud_shape_state s = {.sensor = false};
    DO(t, thud_shape_get_state(world, trial_shape(t, world, body), &s));
    return s.sensor;
}

/* The yard has no other joints, which could pull a body out. Sensors leave the room, as they
 * collide with nothing. */
static void nothing_is_lost(trial *t) {
    yard y;
    yard_make_loose(&y, t, trial_def(t), 0);
    ropes r = make_ropes(&y);
    for (int k = 0; k < trial_steps(t, 1) && !trial_failed(t); k++) {
        shorten_ropes(t, y.world, &r);
        yard_step(&y);
        for (int i = 0; i < YARD_BODIES && !trial_failed(t); i++) {
            thud_body_state s = trial_state(t, y.world, y.body[i]);
            if (s.enabled && !is_sensor(t, y.world, y.body[i]) && !is_in_room(s.position)) {
                trial_fault(t, "step %d: body %d is at %g, %g", k, i, s.position.x, s.position.y);
            }
        }
    }
}

/* Ground along y = 0: boxes 1 wide (AABBs and OBBs by turns), which a terrain line of segments 1.5
 * long continues. */
enum { GROUND_BOXES = 24, GROUND_POINTS = 11 };

static void make_seams(trial *t, thud_world *world, const thud_shape_def *smooth) {
    thud_pos points[GROUND_POINTS];
    thud_body_def def = thud_default_body_def();
    thud_body_id body;
    for (int i = 0; i < GROUND_BOXES; i++) {
        trial_add(t, world,
                  (part){.form = i % 2 ? UPRIGHT : TURNED,
                         .x = i + 0.5,
                         .y = -0.5,
                         .hx = 0.5,
                         .hy = 0.5,
                         .shape = smooth});
    }
    for (int i = 0; i < GROUND_POINTS; i++) {
        points[i] = trial_place(t, GROUND_BOXES + 1.5 * i, 0);
    }
    DO(t, thud_body_create(world, &def, &body));
    DO(t, thud_shape_create_terrain(world, body, smooth,
                                    &(thud_terrain){.kind = THUD_TERRAIN_IRREGULAR,
                                                    .points = points,
                                                    .count = GROUND_POINTS},
                                    NULL));
}

/* A slider starts at x = 1.3 and goes 27 to the right: over all other boxes and nearly three
 * segments of the line. */
#define SLIDE_LENGTH 27.0
/* Largest change of its speed, as a share of it, and of its height. Chosen; not tuned. */
#define SLIDE_TOLERANCE 1e-3

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
    for (int k = 0; k < trial_steps(t, SLIDE_LENGTH / speed) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        thud_body_state s = trial_state(t, world, slider);
        hop = fmax(hop, fabs(s.position.y - rest));
        if (fabs((double)s.velocity.x - speed) > SLIDE_TOLERANCE * speed || hop > SLIDE_TOLERANCE) {
            trial_fault(t, "form %d at x = %g: speed %g of %g, hop %g", (int)kind, s.position.x,
                        (double)s.velocity.x, speed, hop);
        }
    }
}

/* A body that is set to a place stands exactly there, has collided with nothing in between, and its
 * contact with a ball ends. */
static void teleports_meet_nothing(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, 0, 0.5, 4);
    thud_body_id body = trial_drop(t, world, (form)trial_pick(t, FORMS), -2, 0, 0.3);
    trial_drop(t, world, BALL, -1.5, 0, 0.3); /* touches the body */
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
