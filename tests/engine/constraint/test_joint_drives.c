/* test_joint_drives.c: limits, springs and motors of joints: where a spring comes to rest, the
 * range of limits, the force that each reports, and that none exceeds its maximum force. */
#include "joint_support.h"

static const thud_vec2 middle = {0, 0};

/* ---- where a spring comes to rest ---- */

/* The distance at which a spring from a hook to a ball rests, in metres. `swapped`: the ball is
 * body a. `target` may be null: the default. `later` is set as the joint's length afterwards where
 * it is > 0. */
static double rests_at(const thud_quality *quality, bool swapped, const float *target,
                       float later) {
    thud_world_def def = weightless();
    def.quality = quality;
    thud_world *world = make_world(def);
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 3, 0, 0.1f);
    thud_joint_def spring =
        between(THUD_JOINT_DISTANCE, swapped ? ball : hook, swapped ? hook : ball, middle, middle);
    spring.length = 2;
    spring.drive[THUD_DIRECTION_ALONG].frequency = 5;
    spring.drive[THUD_DIRECTION_ALONG].damping = 1;
    spring.drive[THUD_DIRECTION_ALONG].target =
        target ? *target : spring.drive[THUD_DIRECTION_ALONG].target;
    thud_joint_id id = make(world, spring);
    if (later > 0) {
        run(world, 10);
        OK(thud_joint_set_length(world, id, later));
    }
    /* Setting the drive that was read changes nothing. */
    thud_joint_def copy;
    OK(thud_joint_get_def(world, id, &copy));
    assert_true(copy.drive[THUD_DIRECTION_ALONG].target ==
                spring.drive[THUD_DIRECTION_ALONG].target);
    OK(thud_joint_set_drive(world, id, THUD_DIRECTION_ALONG, &copy.drive[THUD_DIRECTION_ALONG]));
    run(world, 120);
    double at = joint_of(world, id).value[THUD_DIRECTION_ALONG];
    thud_world_destroy(world);
    return at;
}

static void spring_of_a_distance_rests_at_its_length(void **state) {
    (void)state;
    const float own = 1.5f;
    for (int i = 0; i < QUALITIES; i++) {
        for (int swapped = 0; swapped < 2; swapped++) {
            near_to(rests_at(qualities[i], swapped, NULL, 0), 2, 1e-3);
            near_to(rests_at(qualities[i], swapped, NULL, 1), 1, 1e-3);
            near_to(rests_at(qualities[i], swapped, &own, 0), 1.5, 1e-3);
            near_to(rests_at(qualities[i], swapped, &own, 1), 1.5, 1e-3);
        }
    }
}

/* The infinite default target, which means the joint's length, is valid for a distance joint alone;
 * its other wrong targets are refused. */
static void only_a_distance_has_a_length_for_a_target(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 3, 0, 0.1f);
    for (int kind = THUD_JOINT_HINGE; kind <= THUD_JOINT_TARGET; kind++) {
        thud_joint_def def = between((thud_joint_kind)kind, hook, ball, middle, middle);
        for (int k = 0; k < THUD_DIRECTION_COUNT; k++) {
            assert_true(def.drive[k].target == 0);
            def.drive[k].target = -INFINITY;
        }
        assert_int_equal(thud_joint_create(world, &def, NULL), THUD_ERROR_INVALID);
    }
    thud_joint_def def = between(THUD_JOINT_DISTANCE, hook, ball, middle, middle);
    const float wrong[] = {-1, INFINITY, NAN};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        def.drive[THUD_DIRECTION_ALONG].target = wrong[i];
        assert_int_equal(thud_joint_create(world, &def, NULL), THUD_ERROR_INVALID);
    }
    thud_world_destroy(world);
}

/* ---- limits ---- */

/* Limits and targets of angles may be +-pi in float, and no more. */
static void limits_and_targets_reach_pi(void **state) {
    (void)state;
    thud_world *world = make_world(weightless());
    thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
    thud_body_id ball = add_ball(world, 0, 0, 0.1f);
    thud_joint_def def = between(THUD_JOINT_HINGE, hook, ball, middle, middle);
    float pi = (float)PI;
    def.drive[THUD_DIRECTION_TURN].limited = true;
    def.drive[THUD_DIRECTION_TURN].lower = -pi;
    def.drive[THUD_DIRECTION_TURN].upper = pi;
    def.drive[THUD_DIRECTION_TURN].target = pi;
    thud_joint_id hinge = make(world, def);
    thud_drive more = def.drive[THUD_DIRECTION_TURN];
    more.upper = nextafterf(pi, 4);
    assert_int_equal(thud_joint_set_drive(world, hinge, THUD_DIRECTION_TURN, &more),
                     THUD_ERROR_INVALID);
    thud_world_destroy(world);
}

/* ---- forces of limit, spring and motor ---- */

/* A ball of 1 kg on a vertical slider lies on its lower limit: a motor as a brake carries a quarter
 * of its weight, a spring half of it, and the limit the rest. */
static void limit_spring_and_motor_are_told_apart(void **state) {
    (void)state;
    const double frequency = 2, omega = 2 * PI * frequency;
    for (int i = 0; i < 2 * QUALITIES; i++) {
        bool swapped = i % 2;
        thud_world *world = world_at(qualities[i / 2]);
        thud_body_id hook = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, 0, 0);
        add_shape(world, ball, 0.5f, 0.5f, false, NULL); /* mass: 1 kg */
        thud_joint_def def = between(THUD_JOINT_SLIDER, swapped ? ball : hook,
                                     swapped ? hook : ball, middle, middle);
        def.frame_a.angle = def.frame_b.angle = PI / 2;
        double up = swapped ? -1 : 1; /* seen from the ball, the hook rises as the ball falls */
        def.drive[THUD_DIRECTION_ALONG] =
            (thud_drive){.limited = true,
                         .lower = swapped ? -1 : 0,
                         .upper = swapped ? 0 : 1,
                         .frequency = (float)frequency,
                         .damping = 1,
                         .target = (float)(up * 0.5 * G / (omega * omega)),
                         .spring_force = 1e6f,
                         .motor_force = (float)(0.25 * G)};
        thud_joint_id slider = make(world, def);
        run(world, 60);
        thud_joint_state s = joint_of(world, slider);
        const thud_drive_forces *along = &s.drive[THUD_DIRECTION_ALONG];
        near_to(along->spring, up * 0.5 * G, 0.01 * G);
        near_to(along->limit + along->motor, up * 0.5 * G, 0.01 * G);
        assert_true(fabs((double)along->motor) <= 0.2501 * G);
        assert_true(up * (double)along->limit >= 0.24 * G);
        near_to(s.force.y, up * G, 0.01 * G);
        near_to(along->limit + along->spring + along->motor, s.force.y, 1e-4 * G);
        for (int k = THUD_DIRECTION_ACROSS; k <= THUD_DIRECTION_TURN; k++) {
            const thud_drive_forces *none = &s.drive[k];
            assert_true(none->limit == 0 && none->spring == 0 && none->motor == 0);
        }
        thud_world_destroy(world);
    }
}

/* ---- maximum forces ---- */

/* A target joint pulls a box near the top of a pyramid of 78 boxes towards `to`. Returns the
 * greatest force of its springs or of its motors, as a share of their maximum; *direct is the
 * number of steps in which the island was solved directly. */
static double worst_pull(const thud_quality *quality, thud_vec2 to, bool motors, int *direct) {
    enum { ROWS = 12, PULLED = 8, STEPS = 90 };
    const float most = 200;
    thud_world *world = world_of(quality);
    thud_body_id post = add_body(world, THUD_BODY_STATIC, 0, 0, 0), box = {0};
    for (int row = 0; row < ROWS; row++) {
        for (int i = 0; i < ROWS - row; i++) {
            thud_body_id id = add_box(world, i + 0.5 * row, row + 0.5, 0.5f, 0.5f);
            box = row == PULLED && i == (ROWS - PULLED) / 2 ? id : box;
        }
    }
    run(world, 30);
    thud_joint_def def = between(THUD_JOINT_TARGET, post, box, to, middle);
    for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
        thud_drive *d = &def.drive[k];
        d->frequency = motors ? 0 : 20;
        d->spring_force = most;
        d->motor_force = motors ? most : 0;
        d->motor_speed = 20;
    }
    thud_joint_id target = make(world, def);
    double worst = 0;
    for (int i = 0; i < STEPS; i++) {
        run(world, 1);
        thud_joint_state now = joint_of(world, target);
        double pull[2];
        for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
            thud_drive_forces force = now.drive[k];
            pull[k] = (double)(motors ? force.motor : force.spring);
        }
        worst = fmax(worst, hypot(pull[0], pull[1]) / (double)most);
        *direct += thud_stats_of(world).direct_islands > 0;
    }
    thud_world_destroy(world);
    return worst;
}

/* At every quality a target joint pulls with its maximum force and no more, in a pile of boxes. */
static void springs_and_motors_keep_their_caps_in_a_pile(void **state) {
    (void)state;
    const thud_vec2 to[] = {{60, 0.5f}, {6, 60}, {60, 60}};
    for (int i = 0; i < QUALITIES; i++) {
        int direct = 0;
        double motor = worst_pull(qualities[i], middle, true, &direct);
        assert_true(motor > 0.99 && motor < 1.0001);
        for (size_t k = 0; k < sizeof to / sizeof *to; k++) {
            double spring = worst_pull(qualities[i], to[k], false, &direct);
            /* 5.7 at exact where the solver does not bound it */
            assert_true(spring > 0.99 && spring < 1.0001);
        }
        assert_true(direct > 0 || i < 2);
    }
}

/* ---- one maximum force for both directions of a target ---- */

static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum { DETECTIONS = sizeof detections / sizeof *detections };

/* What keeps the pulled box from following: nothing, a corner of two walls, or a weld to the
 * post. */
typedef enum holding { FREE, CORNER, WELDED, HOLDINGS } holding;

/* A case: how a target joint pulls a box. */
typedef struct pull {
    const thud_quality *quality;
    const thud_detection *detection;
    holding by;
    bool motors;    /* else springs */
    bool kinematic; /* whether the post is kinematic; else it is static */
    float most[2];
} pull;

/* A case's world. */
typedef struct pulled {
    thud_world *world;
    thud_body_id box;
    thud_joint_id target;
    pull how;
} pulled;

/* Sets both directions of the joint to pull in this direction, in radians. */
static void aim(const pulled *p, double angle) {
    for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
        double part = k == THUD_DIRECTION_ALONG ? cos(angle) : sin(angle);
        thud_drive drive = thud_default_joint_def(THUD_JOINT_TARGET).drive[k];
        drive.frequency = p->how.motors ? 0 : 3;
        drive.target = (float)(1000 * part);
        drive.spring_force = p->how.most[k];
        drive.motor_force = p->how.motors ? p->how.most[k] : 0;
        drive.motor_speed = (float)(1000 * part);
        OK(thud_joint_set_drive(p->world, p->target, (thud_direction)k, &drive));
    }
}

/* Creates a case's world, with the box pulled in the direction of `angle`. */
static pulled begin_pull(pull how, double angle) {
    thud_world_def def = weightless();
    def.quality = how.quality;
    def.detection = how.detection;
    pulled p = {.world = make_world(def), .how = how};
    thud_body_id post =
        add_body(p.world, how.kinematic ? THUD_BODY_KINEMATIC : THUD_BODY_STATIC, 0, 0, 0);
    thud_shape_def smooth = thud_default_shape_def();
    smooth.friction = 0;
    p.box = add_body(p.world, THUD_BODY_DYNAMIC, 0, 0, 0); /* mass: 1 kg */
    add_shape(p.world, p.box, 0.5f, 0.5f, false, &smooth);
    if (how.by == CORNER) {
        add_shape(p.world, add_body(p.world, THUD_BODY_STATIC, 1.5, 0, 0), 1, 3, false, &smooth);
        add_shape(p.world, add_body(p.world, THUD_BODY_STATIC, 0, 1.5, 0), 3, 1, false, &smooth);
    } else if (how.by == WELDED) {
        make(p.world, between(THUD_JOINT_WELD, post, p.box, middle, middle));
    }
    p.target = make(p.world, between(THUD_JOINT_TARGET, post, p.box, middle, middle));
    aim(&p, angle);
    return p;
}

/* The force of the joint on the box in N. */
static thud_vec2 force_now(const pulled *p) {
    thud_joint_state now = joint_of(p->world, p->target);
    thud_vec2 force = {0, 0};
    for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
        thud_drive_forces all = now.drive[k];
        *(k ? &force.y : &force.x) = p->how.motors ? all.motor : all.spring;
    }
    return force;
}

static double length_of(thud_vec2 v) {
    return hypot((double)v.x, (double)v.y);
}

/* Case i of all combinations. */
static pull pull_number(int i) {
    return (pull){.kinematic = i % 2,
                  .motors = i / 2 % 2,
                  .by = i / 4 % HOLDINGS,
                  .detection = detections[i / (4 * HOLDINGS) % DETECTIONS],
                  .quality = qualities[i / (4 * HOLDINGS * DETECTIONS)]};
}
enum { PULLS = 4 * HOLDINGS * DETECTIONS * QUALITIES };

static void target_pulls_with_its_cap_in_any_direction(void **state) {
    (void)state;
    enum { STEPS = 30, ANGLES = 7 };
    for (int i = 0; i < PULLS; i++) {
        for (int k = 0; k < ANGLES; k++) {
            double angle = 0.5 * PI * k / (ANGLES - 1), worst = 0;
            pull how = pull_number(i);
            how.most[0] = how.most[1] = 50;
            pulled p = begin_pull(how, angle);
            for (int n = 0; n < STEPS; n++) {
                run(p.world, 1);
                worst = fmax(worst, length_of(force_now(&p)));
            }
            thud_vec2 force = force_now(&p), v = state_of(p.world, p.box).velocity;
            /* 1.41 times 50 where each direction has a maximum of its own */
            assert_true(worst < 1.0001 * 50);
            assert_true(length_of(force) > 0.99 * 50);
            near_to(force.x, 50 * cos(angle), 0.02 * 50);
            near_to(force.y, 50 * sin(angle), 0.02 * 50);
            near_to(length_of(v), how.by == FREE ? 50 * STEPS * STEP : 0, 0.01 * 50 * STEPS * STEP);
            thud_world_destroy(p.world);
        }
    }
}

/* A direction with a lower maximum keeps to that; the total force is bounded by the greater
 * maximum. */
static void weaker_direction_of_a_target_keeps_its_own_cap(void **state) {
    (void)state;
    for (int i = 0; i < PULLS; i++) {
        pull how = pull_number(i);
        how.most[0] = 50;
        how.most[1] = 20;
        for (int k = 0; k < 3; k++) {
            double angle = k * PI / 6;
            pulled p = begin_pull(how, angle);
            run(p.world, 20);
            thud_vec2 force = force_now(&p);
            double across = fmin(20, 50 * sin(angle));
            near_to(force.y, across, 0.02 * 50);
            near_to(force.x, sqrt(50 * 50 - across * across), 0.02 * 50);
            thud_world_destroy(p.world);
        }
    }
}

/* A direction has the whole maximum once the other one has no drive any more. */
static void direction_that_is_left_alone_has_its_whole_cap(void **state) {
    (void)state;
    for (int i = 0; i < PULLS; i++) {
        pull how = pull_number(i);
        how.most[0] = how.most[1] = 50;
        pulled p = begin_pull(how, PI / 4);
        run(p.world, 5);
        thud_drive none = thud_default_joint_def(THUD_JOINT_TARGET).drive[THUD_DIRECTION_ALONG];
        OK(thud_joint_set_drive(p.world, p.target, THUD_DIRECTION_ALONG, &none));
        run(p.world, 5);
        near_to(force_now(&p).x, 0, 1e-6);
        near_to(force_now(&p).y, 50, 0.5);
        thud_world_destroy(p.world);
    }
}

/* The target's direction turns by 5 degrees a step, through each axis; the force follows it and
 * keeps its magnitude. */
static void force_of_a_target_turns_with_its_direction(void **state) {
    (void)state;
    enum { STEPS = 72, FIRST = 10 };
    for (int i = 0; i < PULLS; i++) {
        pull how = pull_number(i);
        how.most[0] = how.most[1] = 50;
        if (how.by != WELDED) {
            continue;
        }
        pulled p = begin_pull(how, 0.1);
        thud_vec2 before = {0, 0};
        for (int n = 0; n < STEPS + FIRST; n++) {
            aim(&p, 0.1 + 2 * PI * n / STEPS);
            run(p.world, 1);
            thud_vec2 force = force_now(&p);
            thud_vec2 change = {force.x - before.x, force.y - before.y};
            double length = length_of(force), turned = length_of(change);
            assert_true(length < 1.0001 * 50);
            assert_true(n < FIRST || (length > 0.9 * 50 && turned < 0.2 * 50));
            before = force;
        }
        thud_world_destroy(p.world);
    }
}

/* A motor with target speed 0 in both directions acts as friction with a ground seen from above: it
 * holds a body against a smaller force in any direction, and slows a moving body without turning
 * its path. */
static void motor_of_both_directions_is_friction(void **state) {
    (void)state;
    for (int i = 0; i < 2 * QUALITIES; i++) {
        for (int k = 0; k < 7; k++) {
            thud_world_def def = weightless();
            def.quality = qualities[i / 2];
            double angle = k * PI / 12, push = i % 2 ? 9.5 : 12;
            def.gravity = (thud_vec2){(float)(push * cos(angle)), (float)(push * sin(angle))};
            thud_world *world = make_world(def);
            thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            thud_body_id box = add_box(world, 0, 0, 0.5f, 0.5f); /* mass: 1 kg */
            thud_joint_def rub = between(THUD_JOINT_TARGET, ground, box, middle, middle);
            rub.drive[THUD_DIRECTION_ALONG].motor_force =
                rub.drive[THUD_DIRECTION_ACROSS].motor_force = 10;
            make(world, rub);
            run(world, 60);
            thud_body_state s = state_of(world, box);
            double speed = push > 10 ? 2 : 0, along = speed * 0.5;
            near_to(s.velocity.x, speed * cos(angle), 0.06);
            near_to(s.velocity.y, speed * sin(angle), 0.06);
            near_to(s.position.x, along * cos(angle), 0.06);
            near_to(s.position.y, along * sin(angle), 0.06);
            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spring_of_a_distance_rests_at_its_length),
        cmocka_unit_test(only_a_distance_has_a_length_for_a_target),
        cmocka_unit_test(limits_and_targets_reach_pi),
        cmocka_unit_test(limit_spring_and_motor_are_told_apart),
        cmocka_unit_test(springs_and_motors_keep_their_caps_in_a_pile),
        cmocka_unit_test(target_pulls_with_its_cap_in_any_direction),
        cmocka_unit_test(weaker_direction_of_a_target_keeps_its_own_cap),
        cmocka_unit_test(direction_that_is_left_alone_has_its_whole_cap),
        cmocka_unit_test(force_of_a_target_turns_with_its_direction),
        cmocka_unit_test(motor_of_both_directions_is_friction),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
