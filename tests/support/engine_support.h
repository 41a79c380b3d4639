/* engine_support.h: helpers with which tests create small worlds, bodies and shapes, run them, and
 * read them. Each asserts that the call succeeds. */
#ifndef ENGINE_SUPPORT_H
#define ENGINE_SUPPORT_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <thud/thud.h>
#include <thud/thud_listeners.h>

#define OK(call) assert_int_equal((call), THUD_OK)

static const thud_quality *const qualities[] = {&thud_quality_draft, &thud_quality_default,
                                                &thud_quality_high, &thud_quality_exact};
enum { QUALITIES = 4 };

static inline thud_world *make_world(thud_world_def def) {
    thud_world *world = NULL;
    OK(thud_world_create(&def, &world));
    return world;
}

/* Sets the listeners one by one; null: none. */
static inline void set_listeners(thud_world *world, thud_prologue_fn *prologue,
                                 thud_epilogue_fn *epilogue, void *context) {
    OK(thud_world_set_listeners(
        world, &(thud_listeners){.prologue = prologue, .epilogue = epilogue, .context = context}));
}

/* The defaults, without gravity and without sleeping. */
static inline thud_world_def weightless(void) {
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){0, 0};
    def.sleeping = false;
    return def;
}

static inline thud_body_id add_body(thud_world *world, thud_body_kind kind, double x, double y,
                                    double angle) {
    thud_body_def def = thud_default_body_def();
    thud_body_id id;
    def.kind = kind;
    def.position = (thud_pos){x, y};
    def.angle = angle;
    OK(thud_body_create(world, &def, &id));
    return id;
}

/* Adds a circle of radius hx where hy is 0, else a box with half extents hx, hy: an AABB where it
 * is `upright`, else an OBB. `def` may be null: defaults. */
static inline thud_shape_id add_shape(thud_world *world, thud_body_id body, float hx, float hy,
                                      bool upright, const thud_shape_def *def) {
    thud_shape_def plain = thud_default_shape_def();
    thud_shape_id id;
    const thud_shape_def *used = def ? def : &plain;
    thud_vec2 zero = {0, 0}, half = {hx, hy};
    if (hy == 0) {
        OK(thud_shape_create_circle(world, body, used, zero, hx, &id));
    } else if (upright) {
        OK(thud_shape_create_aabb(world, body, used, zero, half, &id));
    } else {
        OK(thud_shape_create_obb(world, body, used, zero, half, 0, &id));
    }
    return id;
}

static inline thud_body_id add_ball(thud_world *world, double x, double y, float r) {
    thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
    add_shape(world, id, r, 0, false, NULL);
    return id;
}

static inline thud_body_id add_box(thud_world *world, double x, double y, float hx, float hy) {
    thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, x, y, 0);
    add_shape(world, id, hx, hy, false, NULL);
    return id;
}

/* Adds a static box whose top is at y = 0, and which reaches from x = -100 to 100. */
static inline thud_body_id add_floor(thud_world *world, const thud_shape_def *def) {
    thud_body_id id = add_body(world, THUD_BODY_STATIC, 0, -1, 0);
    add_shape(world, id, 100, 1, true, def);
    return id;
}

static inline thud_body_state state_of(const thud_world *world, thud_body_id id) {
    thud_body_state state;
    OK(thud_body_get_state(world, id, &state));
    return state;
}

static inline void run(thud_world *world, int steps) {
    for (int i = 0; i < steps; i++) {
        OK(thud_world_step(world));
    }
}

/* Asserts that |value - wanted| <= tolerance; fails for NaN as well. */
static inline void near_to(double value, double wanted, double tolerance) {
    if (!(fabs(value - wanted) <= tolerance)) {
        fail_msg("%.9g is not within %g of %.9g", value, tolerance, wanted);
    }
}

/* A number in [low, high) by xorshift64 (Marsaglia 2003), and the next state in *seed, which must
 * not be 0. */
static inline double random_in(uint64_t *seed, double low, double high) {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 7;
    *seed ^= *seed << 17;
    return low + (high - low) * (double)(*seed >> 11) / 9007199254740992.0;
}

#endif
