/* boxes.c: a program that uses circles and AABBs, to measure its size when linked. */
#include "circles.c"

/* A box with half height 0.5 falls on a box whose top is at 0; returns its height after `steps`. */
EXPORT("box_height") double box_height(int steps) {
    thud_world *world = open_world();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, -1),
                 box = add_body(world, THUD_BODY_DYNAMIC, 3);
    thud_shape_create_aabb(world, ground, &shape, (thud_vec2){0, 0}, (thud_vec2){10, 1}, NULL);
    thud_shape_create_aabb(world, box, &shape, (thud_vec2){0, 0}, (thud_vec2){0.5f, 0.5f}, NULL);
    return height_after(world, box, steps);
}
