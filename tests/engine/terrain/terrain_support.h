/* terrain_support.h: terrains that tests edit, and bodies on them. The line of a terrain is the
 * polyline of its points. */
#ifndef TERRAIN_SUPPORT_H
#define TERRAIN_SUPPORT_H

#include "engine_support.h"

enum { POINTS_MAX = 4000 }; /* of a copied line */

/* A world with a terrain. */
typedef struct ground {
    thud_world *world;
    thud_body_id body;
    thud_shape_id shape;
} ground;

static inline thud_shape_id add_terrain(thud_world *world, thud_body_id body,
                                        const thud_terrain *line) {
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id shape;
    OK(thud_shape_create_terrain(world, body, &def, line, &shape));
    return shape;
}

/* Level ground at height 0 from -50 to 50, with a vertex every 0.5. */
static inline ground level_ground(thud_terrain_kind kind, thud_world_def def) {
    thud_pos points[201];
    for (int i = 0; i < 201; i++) {
        points[i] = (thud_pos){-50 + 0.5 * i, 0};
    }
    ground g = {.world = make_world(def)};
    thud_terrain line = {.kind = kind, .x0 = -50, .spacing = 0.5, .points = points, .count = 201};
    g.body = add_body(g.world, THUD_BODY_STATIC, 0, 0, 0);
    g.shape = add_terrain(g.world, g.body, &line);
    return g;
}

/* The present line of the ground, which must be valid. */
static inline thud_terrain line_of(const ground *g) {
    thud_terrain line;
    OK(thud_shape_get_terrain(g->world, g->shape, &line));
    OK(thud_terrain_check(&line));
    return line;
}

static inline double height_of(const thud_terrain *line, double x) {
    thud_terrain_sample sample;
    OK(thud_terrain_sample_at(line, x, &sample));
    return sample.height;
}

static inline double height_at(const ground *g, double x) {
    thud_terrain line = line_of(g);
    return height_of(&line, x);
}

/* A copy of the line that stays valid after edits, with its points in `points`. */
static inline thud_terrain copy_line(const ground *g, thud_pos points[POINTS_MAX]) {
    thud_terrain line = line_of(g);
    assert_in_range(line.count, 2, POINTS_MAX);
    memcpy(points, line.points, (size_t)line.count * sizeof *points);
    line.points = points;
    return line;
}

/* Asserts that the ground's line has these points exactly. */
static inline void assert_line_is(const ground *g, const thud_terrain *wanted) {
    thud_terrain line = line_of(g);
    assert_int_equal(line.count, wanted->count);
    assert_memory_equal(line.points, wanted->points, (size_t)line.count * sizeof *line.points);
}

static inline bool awake(const ground *g, thud_body_id body) {
    return state_of(g->world, body).awake;
}

/* A stack of boxes of half extent 0.25; returns the top one. */
static inline thud_body_id add_stack(const ground *g, double x, int boxes) {
    thud_body_id top = {0, 0};
    for (int i = 0; i < boxes; i++) {
        top = add_box(g->world, x, 0.25 + 0.5 * i, 0.25f, 0.25f);
    }
    return top;
}

/* Walls at both ends, so that nothing rolls off. */
static inline void add_walls(const ground *g) {
    add_shape(g->world, add_body(g->world, THUD_BODY_STATIC, -30, 0, 0), 1, 30, true, NULL);
    add_shape(g->world, add_body(g->world, THUD_BODY_STATIC, 30, 0, 0), 1, 30, true, NULL);
}

/* Steps until every body sleeps, at most 601 steps. */
static inline void run_to_sleep(const ground *g) {
    run(g->world, 1);
    for (int i = 0; i < 600 && thud_stats_of(g->world).awake_bodies; i++) {
        run(g->world, 1);
    }
    assert_int_equal(thud_stats_of(g->world).awake_bodies, 0);
}

#endif
