/* textured_support.h: worlds whose ground has a texture (thud_textured.h). */
#ifndef TEXTURED_SUPPORT_H
#define TEXTURED_SUPPORT_H

#include "engine_support.h"
#include "every_choice.h"

#include <thud/thud_edits.h>
#include <thud/thud_rules.h>
#include <thud/thud_textured.h>

enum { DETECTIONS = 4, LINES = 3, VERTICES = 161 };

/* The friction of a line, given by x from its origin. */
typedef double friction_fn(double x);

typedef struct textured {
    thud_world *world;
    thud_body_id body;
    thud_shape_id shape;
    thud_terrain line;
    thud_pos points[VERTICES];
} textured;

/* Adds level ground from -40 to 40, of one of the three kinds of line, with vertices about half a
 * unit apart, on a body at (x, 0). */
static inline void add_ground(textured *t, thud_terrain_kind kind, double x, float friction) {
    thud_shape_def def = thud_default_shape_def();
    uint64_t seed = 17;
    for (int i = 0; i < VERTICES; i++) {
        bool end = i == 0 || i == VERTICES - 1;
        double jitter = kind == THUD_TERRAIN_IRREGULAR && !end ? random_in(&seed, -0.2, 0.2) : 0;
        t->points[i] = (thud_pos){-40 + 0.5 * i + jitter, 0};
    }
    t->line = (thud_terrain){
        .kind = kind, .x0 = -40, .spacing = 0.5, .points = t->points, .count = VERTICES};
    if (kind == THUD_TERRAIN_FLAT) {
        t->line = (thud_terrain){.kind = kind};
    }
    def.friction = friction;
    t->body = add_body(t->world, THUD_BODY_STATIC, x, 0, 0);
    OK(thud_shape_create_terrain(t->world, t->body, &def, &t->line, &t->shape));
}

/* Gives the ground the friction at its vertices. */
static inline void set_friction(textured *t, friction_fn *friction) {
    double values[VERTICES];
    thud_terrain line;
    OK(thud_shape_get_terrain(t->world, t->shape, &line));
    int count = line.kind == THUD_TERRAIN_FLAT ? 2 : line.count;
    for (int i = 0; i < count; i++) {
        values[i] = friction(line.kind == THUD_TERRAIN_FLAT ? i : line.points[i].x);
    }
    OK(thud_shape_set_texture(t->world, t->shape,
                              &(thud_texture){.vertices = values, .count = count}));
}

static inline float friction_of(const textured *t, double x) {
    float friction = -1;
    OK(thud_shape_get_friction_at(t->world, t->shape, x, &friction));
    return friction;
}

#endif
