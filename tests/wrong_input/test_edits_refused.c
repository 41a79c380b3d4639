/* test_edits_refused.c: tests the edits of bodies and shapes, forces and points (thud_edits.h,
 * thud_forces.h). Each is refused inside callbacks, without memory, and for values beyond its
 * range, and then changes nothing; at the ends of the range it succeeds. */
#include "village.h"

#include "hostile_memory.h"

#include <float.h>

#include <thud/thud_edits.h>
#include <thud/thud_forces.h>
#include <thud/thud_locks.h>
#include <thud/thud_reads.h>

/* A slab far below the village, with many balls on it. */
typedef struct place {
    village v;
    thud_body_id slab, ball;
    thud_shape_id slab_shape, ball_shape, box_shape;
    int asked;
} place;

typedef struct edit {
    const char *name;
    thud_result (*make)(place *p);
} edit;

static thud_result set_filter(place *p) {
    return thud_shape_set_filter(p->v.world, p->slab_shape, (thud_filter){1, 0, 0});
}

static thud_result set_friction(place *p) {
    return thud_shape_set_friction(p->v.world, p->slab_shape, 0.25f);
}

static thud_result set_restitution(place *p) {
    return thud_shape_set_restitution(p->v.world, p->slab_shape, 0.25f);
}

static thud_result set_surface_speed(place *p) {
    return thud_shape_set_surface_speed(p->v.world, p->slab_shape, 2);
}

static thud_result set_density(place *p) {
    return thud_shape_set_density(p->v.world, p->ball_shape, 3);
}

static thud_result set_sensor(place *p) {
    return thud_shape_set_sensor(p->v.world, p->slab_shape, true);
}

static thud_result set_events(place *p) {
    return thud_shape_set_events(p->v.world, p->ball_shape, false);
}

static thud_result set_radius(place *p) {
    return thud_shape_set_radius(p->v.world, p->ball_shape, 0.6f);
}

static thud_result set_half_extents(place *p) {
    return thud_shape_set_half_extents(p->v.world, p->slab_shape, (thud_vec2){100, 0.5f});
}

static thud_result move_slab(place *p) {
    return thud_body_set_kind(p->v.world, p->slab, THUD_BODY_KINEMATIC);
}

static thud_result drop_slab(place *p) {
    return thud_body_set_kind(p->v.world, p->slab, THUD_BODY_DYNAMIC);
}

static thud_result stop_ball(place *p) {
    return thud_body_set_kind(p->v.world, p->ball, THUD_BODY_STATIC);
}

static thud_result set_damping(place *p) {
    return thud_body_set_damping(p->v.world, p->ball, 1, 1);
}

static thud_result set_gravity_scale(place *p) {
    return thud_body_set_gravity_scale(p->v.world, p->ball, -1);
}

static thud_result set_fixed_rotation(place *p) {
    return thud_body_set_fixed_rotation(p->v.world, p->ball, true);
}

static thud_result set_detection(place *p) {
    return thud_body_set_detection(p->v.world, p->ball, &thud_detection_swept);
}

static thud_result set_may_sleep(place *p) {
    return thud_body_set_may_sleep(p->v.world, p->ball, false);
}

static thud_result set_locks(place *p) {
    return thud_body_set_locks(p->v.world, p->ball, true, true);
}

static thud_result set_mass(place *p) {
    thud_mass mass = {2, 1, {0.1f, 0}};
    return thud_body_set_mass(p->v.world, p->ball, &mass);
}

static const edit edits[] = {
    {"filter", set_filter},
    {"friction", set_friction},
    {"restitution", set_restitution},
    {"surface speed", set_surface_speed},
    {"density", set_density},
    {"sensor", set_sensor},
    {"events", set_events},
    {"radius", set_radius},
    {"half extents", set_half_extents},
    {"kinematic slab", move_slab},
    {"dynamic slab", drop_slab},
    {"static ball", stop_ball},
    {"damping", set_damping},
    {"gravity scale", set_gravity_scale},
    {"fixed rotation", set_fixed_rotation},
    {"detection", set_detection},
    {"may sleep", set_may_sleep},
    {"mass", set_mass},
    {"locks", set_locks},
};
enum { EDITS = sizeof edits / sizeof *edits };

/* A village with a slab below 250 balls and a box apart from them. */
static void make_place(place *p, thud_world_def def) {
    *p = (place){.asked = -1};
    village_make(&p->v, def);
    p->slab = add_body(p->v.world, THUD_BODY_STATIC, 0, -50, 0);
    p->slab_shape = add_shape(p->v.world, p->slab, 150, 1, false, NULL);
    for (int i = 0; i < 250; i++) {
        p->ball = add_body(p->v.world, THUD_BODY_DYNAMIC, 1.1 * (i - 125), -48.5, 0);
        p->ball_shape = add_shape(p->v.world, p->ball, 0.5f, 0, false, NULL);
    }
    p->box_shape = add_shape(p->v.world, add_body(p->v.world, THUD_BODY_DYNAMIC, 160, 90, 0), 1, 1,
                             false, NULL);
    for (int i = 0; i < 10; i++) {
        village_step(&p->v);
    }
}

/* ---- inside callbacks ---- */

/* Called by callbacks: makes all edits, which must be refused. */
static void try_all(place *p) {
    for (int i = 0; i < EDITS && p->asked >= 0; i++) {
        if (edits[i].make(p) != THUD_ERROR_LOCKED) {
            fail_msg("%s is not refused inside a callback", edits[i].name);
        }
    }
    if (p->asked >= 0) {
        thud_pos position;
        p->asked++;
        OK(thud_body_get_position(p->v.world, p->ball, &position));
        OK(thud_shape_set_user_data(p->v.world, p->ball_shape, 5));
    }
}

static bool prologue(thud_world *world, const thud_contact *contact,
                     thud_contact_settings *settings, void *context) {
    (void)world, (void)contact, (void)settings;
    try_all(context);
    return true;
}

static void epilogue(thud_world *world, const thud_contact *contact, void *context) {
    (void)world, (void)contact;
    try_all(context);
}

static void every_change_is_refused_inside_callbacks(void **state) {
    (void)state;
    place here, twin;
    thud_world_def def = thud_default_world_def();
    make_place(&here, def);
    set_listeners(here.v.world, prologue, epilogue, &here);
    make_place(&twin, def);
    set_listeners(twin.v.world, prologue, epilogue, &twin);
    here.asked = 0;
    for (int i = 0; i < 5; i++) {
        village_step(&here.v);
        village_step(&twin.v);
        assert_int_equal(thud_hash_of(here.v.world), thud_hash_of(twin.v.world));
    }
    assert_true(here.asked > 500);
    assert_true(here.v.told >= here.asked * EDITS);
    village_free(&here.v);
    village_free(&twin.v);
}

/* ---- without memory ---- */

/* Makes the edit with its first, second, ... allocation failing until it succeeds, and checks that
 * each failure changes nothing. Returns the number of failures. */
static long fail_until_done(place *here, const edit *e) {
    for (long failures = 0;; failures++) {
        uint64_t hash = thud_hash_of(here->v.world);
        char *before = village_text(&here->v);
        memory_allowed = failures;
        thud_result result = e->make(here);
        memory_allowed = -1;
        if (result == THUD_OK) {
            free(before);
            return failures;
        }
        char *after = village_text(&here->v);
        if (result != THUD_ERROR_MEMORY || thud_hash_of(here->v.world) != hash) {
            fail_msg("%s: '%s', or the world has changed", e->name, thud_result_text(result));
        }
        free(before);
        free(after);
        assert_true(failures < 100);
    }
}

/* The twin's memory never fails. Both must have the same state in all following steps, also in what
 * the API does not show. */
static void every_change_without_memory_changes_nothing(void **state) {
    (void)state;
    long failures = 0;
    for (int i = 0; i < EDITS; i++) {
        thud_world_def def = thud_default_world_def();
        place here, twin;
        def.allocator = hostile_memory();
        make_place(&here, def);
        make_place(&twin, def);
        failures += fail_until_done(&here, &edits[i]);
        OK(edits[i].make(&twin));
        for (int k = 0; k < 40; k++) {
            village_step(&here.v);
            village_step(&twin.v);
            if (thud_hash_of(here.v.world) != thud_hash_of(twin.v.world)) {
                fail_msg("%s: differs at step %d from a call that never failed", edits[i].name, k);
            }
        }
        village_free(&here.v);
        village_free(&twin.v);
        assert_int_equal(memory_held, 0);
    }
    print_message("%ld allocations failed\n", failures);
    assert_true(failures >= 4);
}

/* ---- ranges ---- */

typedef struct range {
    const char *name;
    thud_result (*make)(place *p, float value);
    float least, most;
} range;

#define RANGE_CALL(name, ...)                    \
    static thud_result name(place *p, float x) { \
        thud_world *w = p->v.world;              \
        thud_pos at = {0, 0};                    \
        thud_mass m = {1, 1, {0, 0}};            \
        thud_vec2 v = {0, 0};                    \
        (void)at, (void)m, (void)v;              \
        return __VA_ARGS__;                      \
    }

RANGE_CALL(friction, thud_shape_set_friction(w, p->ball_shape, x))
RANGE_CALL(restitution, thud_shape_set_restitution(w, p->ball_shape, x))
RANGE_CALL(surface_speed, thud_shape_set_surface_speed(w, p->ball_shape, x))
RANGE_CALL(density, thud_shape_set_density(w, p->ball_shape, x))
RANGE_CALL(radius, thud_shape_set_radius(w, p->ball_shape, x))
RANGE_CALL(half_x, thud_shape_set_half_extents(w, p->box_shape, (thud_vec2){x, 1}))
RANGE_CALL(half_y, thud_shape_set_half_extents(w, p->box_shape, (thud_vec2){1, x}))
RANGE_CALL(static_half, thud_shape_set_half_extents(w, p->slab_shape, (thud_vec2){x, 1}))
RANGE_CALL(linear_damping, thud_body_set_damping(w, p->ball, x, 0))
RANGE_CALL(angular_damping, thud_body_set_damping(w, p->ball, 0, x))
RANGE_CALL(gravity_scale, thud_body_set_gravity_scale(w, p->ball, x))
RANGE_CALL(mass, (m.mass = x, thud_body_set_mass(w, p->ball, &m)))
RANGE_CALL(inertia, (m.inertia = x, thud_body_set_mass(w, p->ball, &m)))
RANGE_CALL(center_x, (m.center.x = x, thud_body_set_mass(w, p->ball, &m)))
RANGE_CALL(center_y, (m.center.y = x, thud_body_set_mass(w, p->ball, &m)))
RANGE_CALL(force, (v.x = x, thud_body_apply_force(w, p->ball, v, at)))
RANGE_CALL(impulse, (v.y = x, thud_body_apply_center_impulse(w, p->ball, v)))
RANGE_CALL(spin, thud_body_apply_angular_impulse(w, p->ball, x))
RANGE_CALL(far_force, (at.x = (double)x, thud_body_apply_force(w, p->ball, v, at)))
RANGE_CALL(target_angle, thud_body_set_target(w, p->v.lift, (thud_pos){-6, 1}, (double)x))

/* The ranges of edits for a ball of mass and inertia 1. */
static const range ranges[] = {
    {"friction", friction, 0, THUD_FRICTION_MAX},
    {"restitution", restitution, 0, 1},
    {"surface speed", surface_speed, -THUD_SURFACE_SPEED_MAX, THUD_SURFACE_SPEED_MAX},
    {"density", density, 0, 1e12f},
    {"radius", radius, 1e-4f, 16384},
    {"half extent x", half_x, 1e-4f, 16384},
    {"half extent y", half_y, 1e-4f, 16384},
    {"half extent of what is static", static_half, 1e-4f, 32000},
    {"linear damping", linear_damping, 0, FLT_MAX},
    {"angular damping", angular_damping, 0, FLT_MAX},
    {"gravity scale", gravity_scale, -FLT_MAX, FLT_MAX},
    {"mass", mass, THUD_MASS_MIN, THUD_MASS_MAX},
    {"inertia", inertia, THUD_MASS_MIN, THUD_MASS_MAX},
    {"center x", center_x, -16384, 16384},
    {"center y", center_y, -16384, 16384},
    {"force", force, -THUD_FORCE_MAX, THUD_FORCE_MAX},
    {"impulse", impulse, -THUD_FORCE_MAX, THUD_FORCE_MAX},
    {"angular impulse", spin, -THUD_FORCE_MAX, THUD_FORCE_MAX},
    {"place of a force", far_force, -1e9f, 1e9f},
    {"angle of a target", target_angle, -1e6f, 1e6f},
};
enum { RANGES = sizeof ranges / sizeof *ranges };

/* A village with one ball far from the slab; `which` is a row of `ranges`. From row 15 on the ball
 * has mass and inertia 1. */
static void make_lone(place *p, int which) {
    thud_mass one = {1, 1, {0, 0}};
    *p = (place){.asked = -1};
    village_make(&p->v, weightless());
    p->slab = add_body(p->v.world, THUD_BODY_STATIC, 0, -500, 0);
    p->slab_shape = add_shape(p->v.world, p->slab, 1, 1, false, NULL);
    p->ball = add_body(p->v.world, THUD_BODY_DYNAMIC, 0, 0, 0);
    p->ball_shape = add_shape(p->v.world, p->ball, 0.5f, 0, false, NULL);
    p->box_shape = add_shape(p->v.world, p->ball, 1, 1, false, NULL);
    if (which >= 15) {
        OK(thud_body_set_mass(p->v.world, p->ball, &one));
        OK(thud_body_set_transform(p->v.world, p->ball, (thud_pos){0, 0}, 0));
    }
}

static void ranges_are_those_that_headers_state(void **state) {
    (void)state;
    for (int i = 0; i < RANGES; i++) {
        const range *r = &ranges[i];
        place p;
        make_lone(&p, i);
        float beyond[] = {nextafterf(r->least, -INFINITY), nextafterf(r->most, INFINITY), NAN,
                          -INFINITY, INFINITY};
        uint64_t hash = thud_hash_of(p.v.world);
        for (int k = 0; k < 5; k++) {
            int told = p.v.told;
            thud_result result = r->make(&p, beyond[k]);
            if (result != THUD_ERROR_INVALID || p.v.told != told + 1 ||
                thud_hash_of(p.v.world) != hash) {
                fail_msg("%s: %g is not refused, or changes something", r->name, (double)beyond[k]);
            }
        }
        if (r->make(&p, r->least) != THUD_OK || r->make(&p, r->most) != THUD_OK) {
            fail_msg("%s: an end of its range is refused", r->name);
        }
        village_free(&p.v);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_change_is_refused_inside_callbacks),
        cmocka_unit_test(every_change_without_memory_changes_nothing),
        cmocka_unit_test(ranges_are_those_that_headers_state),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
