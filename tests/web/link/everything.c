/* everything.c: a program that uses every kind of shape, queries and debug drawing, to measure its
 * size when linked. */
#define QUALITY thud_quality_default
#define WORLD_DEF_OF thud_default_world_def_of
#include "boxes.c"

EXPORT("oriented_height") double oriented_height(int steps) {
    thud_world *world = open_world();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0),
                 box = add_body(world, THUD_BODY_DYNAMIC, 3);
    thud_terrain line = {.kind = THUD_TERRAIN_FLAT};
    thud_shape_create_terrain(world, ground, &shape, &line, NULL);
    thud_shape_create_obb(world, box, &shape, (thud_vec2){0, 0}, (thud_vec2){0.5f, 0.5f}, 0, NULL);
    return height_after(world, box, steps);
}

/* Casts a ray down from height 10 to the ground, which is 1 thick, and draws the world; returns the
 * hit's fraction. */
EXPORT("ray_fraction") double ray_fraction(void) {
    thud_world *world = open_world();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id ground = add_body(world, THUD_BODY_STATIC, -1);
    thud_shape_create_obb(world, ground, &shape, (thud_vec2){0, 0}, (thud_vec2){10, 1}, 0, NULL);
    thud_query_filter filter = thud_default_query_filter();
    thud_ray_hit hit = {0};
    bool met = false;
    thud_world_cast_ray(world, &(thud_ray){(thud_pos){0, 10}, 0, -20, &filter}, &met, &hit);
    thud_hash_of(world);
    thud_measure_of(world);
    thud_world_draw(world, &(thud_debug_draw){.flags = ~0u, .upper = {1, 1}});
    thud_world_destroy(world);
    return met ? hit.fraction : -1;
}
