/* wrong_casts.c: casts with callbacks, casts of many rays or shapes, and queries of one shape that
 * must be refused. */
#include "wrong_input.h"

#include <thud/thud_casts.h>

static double count_hit(const thud_ray_hit *hit, void *context) {
    (void)hit;
    (*(int *)context)++;
    return THUD_CAST_ON;
}

static const thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1};
static const thud_geometry no_shapes[] = {
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = NAN},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0},
    {.kind = THUD_SHAPE_AABB, .c = 1, .hx = 1, .hy = -1},
    {.kind = THUD_SHAPE_OBB, .c = 0, .s = 0, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_TERRAIN, .c = 1, .hx = 1, .hy = 1},
};

void wrong_casts_hit_by_hit(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_pos from = {0, 5};
    int asked = 0;
    EACH(x, not_a_place) {
        thud_pos nowhere = {x, 0}, nor_here = {0, x};
        REFUSED(INVALID,
                thud_world_cast_ray_each(w, &(thud_ray){nowhere, 1, 0, NULL}, count_hit, &asked));
        REFUSED(INVALID,
                thud_world_cast_ray_each(w, &(thud_ray){from, 0, x, NULL}, count_hit, &asked));
        REFUSED(INVALID,
                thud_world_cast_shape_each(w, &(thud_shape_cast){nor_here, disc, 1, 0, NULL},
                                           count_hit, &asked));
        REFUSED(INVALID, thud_world_cast_shape_each(w, &(thud_shape_cast){from, disc, x, 0, NULL},
                                                    count_hit, &asked));
    }
    for (int i = 0; i < COUNT(no_shapes); i++) {
        REFUSED(INVALID,
                thud_world_cast_shape_each(w, &(thud_shape_cast){from, no_shapes[i], 0, -9, NULL},
                                           count_hit, &asked));
    }
    REFUSED(NULL, thud_world_cast_ray_each(w, &(thud_ray){from, 0, -9, NULL}, NULL, NULL));
    REFUSED(NULL,
            thud_world_cast_shape_each(w, &(thud_shape_cast){from, disc, 0, -9, NULL}, NULL, NULL));
    REFUSED(NULL, thud_world_cast_shape_each(w, NULL, count_hit, &asked));
    REFUSED_UNTOLD(NULL, thud_world_cast_ray_each(NULL, &(thud_ray){from, 0, -9, NULL}, count_hit,
                                                  &asked));
    REFUSED_UNTOLD(NULL,
                   thud_world_cast_shape_each(NULL, &(thud_shape_cast){from, disc, 0, -9, NULL},
                                              count_hit, &asked));
    assert_int_equal(asked, 0);
}

void wrong_many_casts(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_ray_hit *hits = wrong_out.hits;
    /* The last ray of three is invalid. */
    thud_ray rays[3] = {{{0, 5}, 0, -9, NULL}, {{1, 5}, 0, -9, NULL}, {{2, 5}, 0, -9, NULL}};
    thud_shape_cast casts[3];
    for (int i = 0; i < 3; i++) {
        casts[i] = (thud_shape_cast){rays[i].origin, disc, 0, -9, NULL};
    }
    EACH(x, not_a_place) {
        rays[2].origin.x = x;
        REFUSED(INVALID, thud_world_cast_rays(w, rays, 3, hits));
        rays[2].origin.x = 2;
        rays[2].dy = x;
        REFUSED(INVALID, thud_world_cast_rays(w, rays, 3, hits));
        rays[2].dy = -9;
        casts[2].center.y = x;
        REFUSED(INVALID, thud_world_cast_shapes(w, casts, 3, hits));
        casts[2].center.y = 5;
        casts[2].dx = x;
        REFUSED(INVALID, thud_world_cast_shapes(w, casts, 3, hits));
        casts[2].dx = 0;
    }
    for (int i = 0; i < COUNT(no_shapes); i++) {
        casts[2].shape = no_shapes[i];
        REFUSED(INVALID, thud_world_cast_shapes(w, casts, 3, hits));
    }
    casts[2].shape = disc;
    REFUSED(INVALID, thud_world_cast_rays(w, rays, -1, hits));
    REFUSED(INVALID, thud_world_cast_shapes(w, casts, INT32_MIN, hits));
    REFUSED(NULL, thud_world_cast_rays(w, NULL, 3, hits));
    REFUSED(NULL, thud_world_cast_rays(w, rays, 3, NULL));
    REFUSED(NULL, thud_world_cast_shapes(w, NULL, 2, hits));
    REFUSED(NULL, thud_world_cast_shapes(w, casts, 2, NULL));
    REFUSED_UNTOLD(NULL, thud_world_cast_rays(NULL, rays, 3, hits));
    REFUSED_UNTOLD(NULL, thud_world_cast_shapes(NULL, casts, 2, hits));
}

void wrong_questions_to_a_shape(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_shape_id box = p->here.box_shape;
    thud_pos from = {0, 5}, bounds[2] = {{7, 7}, {7, 7}};
    thud_closest_hit *closest = &wrong_out.closest_hit;
    thud_ray_hit *hit = &wrong_out.hit;
    EACH(x, not_a_place) {
        thud_pos nowhere = {x, 0}, nor_here = {0, x};
        REFUSED(INVALID, thud_shape_cast_ray(w, box, nowhere, 1, 0, OUT_FLAG, hit));
        REFUSED(INVALID, thud_shape_cast_ray(w, box, from, x, 0, OUT_FLAG, hit));
        REFUSED(INVALID, thud_shape_contains_point(w, box, nor_here, OUT_FLAG));
        REFUSED(INVALID, thud_shape_closest_point(w, box, nowhere, closest));
    }
    const thud_shape_id wrong[] = {
        {0, 0}, {4000, 1}, p->here.gone_shape, p->other.box_shape, {UINT32_MAX, UINT32_MAX}};
    for (int i = 0; i < COUNT(wrong); i++) {
        REFUSED(STALE, thud_shape_cast_ray(w, wrong[i], from, 1, 0, OUT_FLAG, hit));
        REFUSED(STALE, thud_shape_contains_point(w, wrong[i], from, OUT_FLAG));
        REFUSED(STALE, thud_shape_closest_point(w, wrong[i], from, closest));
        REFUSED(STALE, thud_shape_get_bounds(w, wrong[i], &bounds[0], &bounds[1]));
    }
    REFUSED(INVALID, thud_shape_get_bounds(w, p->here.plain, &bounds[0], &bounds[1]));
    REFUSED(NULL, thud_shape_contains_point(w, box, from, NULL));
    REFUSED(NULL, thud_shape_closest_point(w, box, from, NULL));
    REFUSED(NULL, thud_shape_get_bounds(w, box, NULL, &bounds[1]));
    REFUSED(NULL, thud_shape_get_bounds(w, box, &bounds[0], NULL));
    REFUSED_UNTOLD(NULL, thud_shape_cast_ray(NULL, box, from, 1, 0, OUT_FLAG, hit));
    REFUSED_UNTOLD(NULL, thud_shape_contains_point(NULL, box, from, OUT_FLAG));
    REFUSED_UNTOLD(NULL, thud_shape_closest_point(NULL, box, from, closest));
    REFUSED_UNTOLD(NULL, thud_shape_get_bounds(NULL, box, &bounds[0], &bounds[1]));
    assert_true(bounds[0].x == 7 && bounds[0].y == 7 && bounds[1].x == 7 && bounds[1].y == 7);
}
