/* draw_pairs.c: see draw_pairs.h. */
#include "draw/draw_pairs.h"

#include "draw/draw_measures.h"
#include "draw/draw_sums.h"

#include <thud/thud_reads.h>

#include <string.h>

static const char *const NAMES[PAIR_LOOKS] = {"sum", "closest", "bounds"};

const char *pair_look_name(pair_look look) {
    return NAMES[look];
}

int pair_look_find(const char *name) {
    for (int i = 0; i < PAIR_LOOKS; i++)
        if (strcmp(name, NAMES[i]) == 0)
            return i;
    return -1;
}

/* The only shape of the body in a slot, with its pose and motion. False if there is none, or if it
 * is a terrain. */
static bool placed_at(const session *s, const thud_pose *poses, int count, int slot,
                      thud_geometry *out, thud_motion *motion) {
    for (int i = 0; i < s->body_count && slot < count; i++) {
        const session_body *body = &s->bodies[i];
        if ((int)body->id.index1 - 1 != slot || body->shape_count != 1)
            continue;
        const session_shape *shape = &s->shapes[body->first_shape];
        const thud_pose *p = &poses[slot];
        thud_vec2 velocity = {0, 0};
        float turn = 0;
        thud_body_get_velocity(s->world, body->id, &velocity, &turn);
        *motion = (thud_motion){velocity.x, velocity.y, turn};
        *out = (thud_geometry){.kind = shape->kind,
                               .x = p->x + p->c * shape->offset.x - p->s * shape->offset.y,
                               .y = p->y + p->s * shape->offset.x + p->c * shape->offset.y,
                               .c = p->c * shape->c - p->s * shape->s,
                               .s = p->s * shape->c + p->c * shape->s,
                               .hx = shape->half.x,
                               .hy = shape->half.y};
        return shape->kind != THUD_SHAPE_TERRAIN;
    }
    return false;
}

void draw_pairs(canvas *c, const camera *view, session *s, pair_look look) {
    int count = 0;
    const thud_pose *poses = thud_poses_of(s->world, view->center, s->alpha, &count);
    for (int i = 0; i < s->scene.sum_pairs; i++) {
        thud_geometry a, b;
        thud_motion by_a, by_b;
        if (!placed_at(s, poses, count, 2 * i, &a, &by_a) ||
            !placed_at(s, poses, count, 2 * i + 1, &b, &by_b))
            continue;
        if (look == PAIR_SUM) {
            draw_sum(c, view, &a, &b);
        } else if (look == PAIR_CLOSEST) {
            draw_closest(c, view, &a, &b);
            draw_impact(c, view, &a, by_a, &b, by_b);
        } else {
            draw_volumes(c, view, &a);
            draw_volumes(c, view, &b);
        }
    }
}
