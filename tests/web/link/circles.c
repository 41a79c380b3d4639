/* circles.c: a program that uses circles only, at quality draft unless QUALITY is defined, to
 * measure its size when linked. */
#include <thud/thud.h>

/* Results of calls are not checked: a failure shows in the height that is returned. */
#pragma GCC diagnostic ignored "-Wunused-result"

#if defined(__wasm__)
#define EXPORT(name) __attribute__((export_name(name)))
#else
#define EXPORT(name)
#endif

/* The def that links no more than is used, unless a program takes another one. */
#ifndef WORLD_DEF_OF
#define WORLD_DEF_OF thud_default_small_world_def
#endif
#ifndef QUALITY
#define QUALITY thud_quality_draft
#endif

static thud_world *open_world(void) {
    thud_world_def def = WORLD_DEF_OF(&QUALITY);
    thud_world *world = NULL;
    thud_world_create(&def, &world);
    return world;
}

static thud_body_id add_body(thud_world *world, thud_body_kind kind, double y) {
    thud_body_def def = thud_default_body_def();
    thud_body_id id;
    def.kind = kind;
    def.position = (thud_pos){0, y};
    thud_body_create(world, &def, &id);
    return id;
}

/* Makes the steps, destroys the world, and returns the height of the body. */
static double height_after(thud_world *world, thud_body_id body, int steps) {
    for (int i = 0; i < steps; i++) {
        thud_world_step(world);
    }
    thud_body_state state;
    thud_body_get_state(world, body, &state);
    thud_world_destroy(world);
    return state.position.y;
}

/* A ball of radius 0.5 falls on one of radius 100 whose top is at 0; returns its height after
 * `steps`. */
EXPORT("circle_height") double circle_height(int steps) {
    thud_world *world = open_world();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, -100);
    thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 3);
    thud_shape_create_circle(world, ground, &shape, (thud_vec2){0, 0}, 100, NULL);
    thud_shape_create_circle(world, ball, &shape, (thud_vec2){0, 0}, 0.5f, NULL);
    return height_after(world, ball, steps);
}
