/* joints.c: guarantees of joints: how exactly locked directions are kept, forces of motors and
 * springs, breaking, collisions of connected bodies, and joints of destroyed bodies. */
#include "guarantee.h"
#include "trial.h"

#include <thud/thud_joint.h>

/* A def with anchors at x on body a and at -x on body b, in length scales. */
static thud_joint_def between(trial *t, thud_joint_kind kind, thud_body_id a, thud_body_id b,
                              double x) {
    thud_joint_def def = thud_default_joint_def(kind);
    def.body_a = a;
    def.body_b = b;
    def.frame_a.position = trial_speed(t, x, 0);
    def.frame_b.position = trial_speed(t, -x, 0);
    return def;
}

static thud_joint_id make(trial *t, thud_world *world, const thud_joint_def *def) {
    thud_joint_id joint = {0, 0};
    DO(t, thud_joint_create(world, def, &joint));
    return joint;
}

/* The joint's state, with the gap in length scales. */
static thud_joint_state state_of(trial *t, const thud_world *world, thud_joint_id joint) {
    thud_joint_state state = {.gap = 0};
    DO(t, thud_joint_get_state(world, joint, &state));
    state.gap /= t->scale;
    return state;
}

/* A static body without a shape. */
static thud_body_id hook_at(trial *t, thud_world *world, double x, double y) {
    thud_body_def def = thud_default_body_def();
    thud_body_id hook = {0, 0};
    def.position = trial_place(t, x, y);
    DO(t, thud_body_create(world, &def, &hook));
    return hook;
}

/* A chain of three links, each 0.8 length scales long, swings from the horizontal; its gaps stay
 * small. */
static void joints_hold_what_they_lock(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_joint_id joint[3];
    if (!world) {
        return;
    }
    thud_body_id last = hook_at(t, world, 0, 5);
    for (int i = 0; i < 3; i++) {
        thud_body_id link = trial_drop(t, world, TURNED, 0.4 + 0.8 * i, 5, 0.1);
        thud_joint_kind kind = i == 1 ? THUD_JOINT_WELD : THUD_JOINT_HINGE;
        thud_joint_def def = between(t, kind, last, link, 0.4);
        if (i == 0) {
            def.frame_a.position = (thud_vec2){0, 0};
        }
        joint[i] = make(t, world, &def);
        last = link;
    }
    for (int k = 0; k < trial_steps(t, 2) && !trial_failed(t); k++) {
        DO(t, thud_world_step(world));
        for (int i = 0; i < 3; i++) {
            thud_joint_state s = state_of(t, world, joint[i]);
            if (!(s.gap < 0.1) || !(s.angle_gap < 0.3)) {
                trial_fault(t, "step %d: joint %d is open by %g and %g rad", k, i, s.gap,
                            s.angle_gap);
            }
        }
    }
}

/* Joints that begin open: a load on a rope, a link on a hinge, and a chain of three links whose top
 * hinge is open. */
enum { LINKS = 3, OPEN = 2 + LINKS };

typedef struct open_joints {
    thud_world *world;
    thud_body_id hook;
    thud_joint_id joint[OPEN];
} open_joints;

static open_joints hang(trial *t) {
    open_joints o = {.world = trial_make(t, trial_def(t))};
    if (!o.world) {
        return o;
    }
    thud_joint_def rope = between(t, THUD_JOINT_DISTANCE, hook_at(t, o.world, -5, 10),
                                  trial_drop(t, o.world, UPRIGHT, -5, 4, 0.5), 0);
    rope.length = (float)(6 * t->scale);
    o.joint[0] = make(t, o.world, &rope);
    o.hook = hook_at(t, o.world, 0, 10);
    thud_joint_def hinge =
        between(t, THUD_JOINT_HINGE, o.hook, trial_drop(t, o.world, TURNED, 0, 9, 0.5), 0);
    hinge.frame_b.position = trial_speed(t, 0, 1);
    o.joint[1] = make(t, o.world, &hinge);
    thud_body_id last = hook_at(t, o.world, 5, 10);
    for (int i = 0; i < LINKS; i++) {
        thud_body_id link = trial_drop(t, o.world, TURNED, 5, 5 - i, 0.2);
        hinge = between(t, THUD_JOINT_HINGE, last, link, 0);
        hinge.frame_a.position = trial_speed(t, 0, i ? -0.5 : 0);
        hinge.frame_b.position = trial_speed(t, 0, 0.5);
        o.joint[2 + i] = make(t, o.world, &hinge);
        last = link;
    }
    return o;
}

/* After two seconds the rope is shortened by 4 length scales and the hook raised by as much. The
 * gaps that the world reports are those of the joints, and after 5 seconds all are closed and
 * asleep. */
static void joints_close_before_they_sleep(trial *t) {
    open_joints o = hang(t);
    double widest = 0;
    if (!o.world) {
        return;
    }
    trial_run(t, o.world, trial_steps(t, 2));
    DO(t, thud_joint_set_length(o.world, o.joint[0], (float)(2 * t->scale)));
    DO(t, thud_body_set_transform(o.world, o.hook, trial_place(t, 0, 14), 0));
    for (int k = 0; k < trial_steps(t, 5) && !trial_failed(t); k++) {
        DO(t, thud_world_step(o.world));
        widest = 0;
        for (int i = 0; i < OPEN; i++) {
            widest = fmax(widest, state_of(t, o.world, o.joint[i]).gap);
        }
        double told = thud_step_error_of(o.world).joint_gap_max / t->scale;
        if (!(fabs(told - widest) <= 1e-6 * widest)) {
            trial_fault(t, "step %d: %g is told of a gap of %g", k, told, widest);
        }
    }
    int awake = thud_stats_of(o.world).awake_bodies;
    if (!(widest < 0.02) || (settings_sleeping(t->set) && awake)) {
        trial_fault(t, "%d are awake, with a gap of %g", awake, widest);
    }
}

/* A target joint that pulls a body along and across towards a post, by springs or by motors with
 * maximum forces of some multiples of the body's weight. */
typedef struct capped {
    thud_joint_id joint;
    bool motors;
    double most[2];
} capped;

static capped pull_at(trial *t, thud_world *world, thud_body_id body) {
    capped c = {.motors = trial_pick(t, 2)};
    thud_body_state state = {.mass = 0};
    DO(t, thud_body_get_state(world, body, &state));
    double weight = state.mass * hypot(0, (double)trial_def(t).gravity.y);
    bool same = trial_pick(t, 2);
    thud_joint_def def = between(t, THUD_JOINT_TARGET, hook_at(t, world, 0, 0), body, 0);
    def.frame_a.angle = trial_draw(t, -3, 3);
    for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
        thud_drive *d = &def.drive[k];
        float most = (float)(weight * trial_draw(t, 0.5, 8)), way = (float)trial_draw(t, -20, 20);
        c.most[k] =
            k == THUD_DIRECTION_ACROSS && same ? c.most[THUD_DIRECTION_ALONG] : (double)most;
        d->frequency = c.motors ? 0 : (float)trial_draw(t, 1, 20);
        d->target = way * (float)t->scale;
        d->motor_speed = way * (float)t->scale;
        d->spring_force = (float)c.most[k];
        d->motor_force = c.motors ? (float)c.most[k] : 0;
    }
    c.joint = make(t, world, &def);
    return c;
}

/* Reports a motor or spring force above its maximum. */
static void look_at_forces(trial *t, const thud_world *world, const capped *c, int step) {
    thud_joint_state s = state_of(t, world, c->joint);
    double force[2], room = 1.0001;
    for (int k = THUD_DIRECTION_ALONG; k <= THUD_DIRECTION_ACROSS; k++) {
        force[k] = (double)fabsf(c->motors ? s.drive[k].motor : s.drive[k].spring) / c->most[k];
    }
    double along = force[0] * c->most[0], across = force[1] * c->most[1];
    double both = hypot(along, across) / fmax(c->most[0], c->most[1]);
    if (!(force[0] <= room) || !(force[1] <= room) || !(both <= room)) {
        trial_fault(t, "step %d: %s of %g and %g times the caps, together %g of the greater one",
                    step, c->motors ? "motors" : "springs", force[0], force[1], both);
    }
}

/* Target joints pull at bodies at the bottom, in the middle and on top of a heap, and at the end of
 * a chain; no drive exceeds its maximum force. */
static void drives_keep_their_forces(trial *t) {
    enum { COLUMNS = 3, ROWS = 3, LINKS_PULLED = 3, TARGETS = 4 };
    thud_world *world = trial_make(t, trial_def(t));
    thud_body_id body[TARGETS], last;
    capped pull[TARGETS];
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 20, 1);
    for (int i = 0; i < COLUMNS * ROWS; i++) {
        form kind = i % 2 ? TURNED : UPRIGHT;
        thud_body_id id =
            trial_drop(t, world, kind, 0.9 * (i % COLUMNS), 0.4 + 0.8 * (i / COLUMNS), 0.4);
        body[i / COLUMNS] = i % COLUMNS == 1 ? id : body[i / COLUMNS];
    }
    last = hook_at(t, world, 8, 6);
    for (int i = 0; i < LINKS_PULLED; i++) {
        thud_body_id link = trial_drop(t, world, TURNED, 8.4 + 0.8 * i, 6, 0.1);
        thud_joint_def def = between(t, THUD_JOINT_HINGE, last, link, 0.4);
        def.frame_a.position = i ? def.frame_a.position : (thud_vec2){0, 0};
        make(t, world, &def);
        body[ROWS] = last = link;
    }
    trial_run(t, world, trial_steps(t, 0.25));
    for (int i = 0; i < TARGETS; i++) {
        pull[i] = pull_at(t, world, body[i]);
    }
    for (int k = 0; k < trial_steps(t, 1.5) && !trial_failed(t); k++) {
        DO(t, thud_world_step(world));
        for (int i = 0; i < TARGETS; i++) {
            look_at_forces(t, world, &pull[i], k);
        }
    }
}

/* A box rests on a body that it has no joint with, and falls through one that a joint connects it
 * with. */
static void tied_bodies_pass_through_each_other(trial *t) {
    thud_joint_kind kind = trial_pick(t, 2) ? THUD_JOINT_FILTER : THUD_JOINT_DISTANCE;
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 5, 1);
    thud_body_id shelf = trial_wall(t, world, 0, 1.5, 2, 0.25);
    thud_body_id tied = trial_drop(t, world, TURNED, -0.6, 2.2, 0.3);
    thud_body_id other = trial_drop(t, world, TURNED, 0.6, 2.2, 0.3);
    thud_joint_def def = between(t, kind, shelf, tied, 0);
    def.drive[THUD_DIRECTION_ALONG].limited =
        kind == THUD_JOINT_DISTANCE; /* a rope, which is never taut */
    def.drive[THUD_DIRECTION_ALONG].upper = (float)(5 * t->scale);
    make(t, world, &def);
    trial_run(t, world, trial_steps(t, 2));
    double low = trial_state(t, world, tied).position.y;
    double high = trial_state(t, world, other).position.y;
    if (fabs(low - 0.3) > 0.05 || fabs(high - 2.05) > 0.05) {
        trial_fault(t, "the tied one is at %g, the other one at %g", low, high);
    }
}

/* Of two bodies that hang side by side, the one whose joint has a breaking force below its weight
 * falls, with one event. */
static void joints_break_where_they_bear_too_much(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    if (!world) {
        return;
    }
    int events = 0;
    thud_joint_id joint[2];
    for (int i = 0; i < 2; i++) {
        thud_body_id body = trial_drop(t, world, BALL, 2 * i, 4, 0.3);
        thud_body_state state = {.mass = 0};
        DO(t, thud_body_get_state(world, body, &state));
        thud_joint_def def = between(t, THUD_JOINT_DISTANCE, hook_at(t, world, 2 * i, 5), body, 0);
        double weight = state.mass * (double)hypotf(0, trial_def(t).gravity.y);
        def.length = (float)t->scale;
        def.break_force = (float)((i ? 3 : 0.3) * weight);
        joint[i] = make(t, world, &def);
    }
    for (int k = 0; k < trial_steps(t, 1) && !trial_failed(t); k++) {
        int count = 0;
        DO(t, thud_world_step(world));
        thud_joint_events_of(world, &count);
        events += count;
    }
    if (events != 1 || thud_joint_is_valid(world, joint[0]) ||
        !thud_joint_is_valid(world, joint[1])) {
        trial_fault(t, "%d events; the weak one is %s, the strong one %s", events,
                    thud_joint_is_valid(world, joint[0]) ? "there" : "gone",
                    thud_joint_is_valid(world, joint[1]) ? "there" : "gone");
    }
}

/* Destroying one of its bodies destroys a joint; the other body moves freely. */
static void joints_are_gone_with_their_bodies(trial *t) {
    thud_world *world = trial_make(t, trial_weightless(t));
    if (!world) {
        return;
    }
    thud_body_id a = trial_drop(t, world, BALL, -0.5, 3, 0.3);
    thud_body_id b = trial_drop(t, world, BALL, 0.5, 3, 0.3);
    thud_joint_def def = between(t, THUD_JOINT_HINGE, a, b, 0.5);
    thud_joint_id joint = make(t, world, &def);
    trial_run(t, world, 3);
    DO(t, thud_body_destroy(world, trial_pick(t, 2) ? a : b));
    trial_run(t, world, 1);
    int listed = -1;
    DO(t, thud_world_get_joints(world, NULL, 0, &listed));
    if (thud_joint_is_valid(world, joint) || listed != 0) {
        trial_fault(t, "the joint is %s, and %d are listed",
                    thud_joint_is_valid(world, joint) ? "valid" : "gone", listed);
    }
    trial_run(t, world, 3);
}

const guarantee guarantees_of_joints[] = {
    GUARANTEE(drives_keep_their_forces),
    GUARANTEE(joints_are_gone_with_their_bodies),
    GUARANTEE(joints_break_where_they_bear_too_much),
    GUARANTEE(joints_close_before_they_sleep),
    GUARANTEE(joints_hold_what_they_lock),
    GUARANTEE(tied_bodies_pass_through_each_other),
    {.name = NULL},
};
