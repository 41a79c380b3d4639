/* wrong_queries.c: queries, character movers and drawings with invalid arguments. */
#include "wrong_input.h"

static bool count_shape(thud_shape_id shape, void *context) {
    (void)shape;
    (*(int *)context)++;
    return true;
}

/* Shapes that thud_geometry_check refuses. */
static const thud_geometry no_shapes[] = {
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = NAN},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 0},
    {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = -1},
    {.kind = THUD_SHAPE_CIRCLE, .x = NAN, .c = 1, .hx = 1},
    {.kind = THUD_SHAPE_AABB, .c = 1, .hx = 1, .hy = 0},
    {.kind = THUD_SHAPE_AABB, .c = 0.6, .s = 0.8, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .c = 0, .s = 0, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_OBB, .c = 1, .s = INFINITY, .hx = 1, .hy = 1},
    {.kind = THUD_SHAPE_TERRAIN, .c = 1, .hx = 1, .hy = 1},
    {.kind = (thud_shape_kind)99, .c = 1, .hx = 1, .hy = 1},
};
static const thud_geometry disc = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = 1};
static const double not_a_length[] = {NAN, INFINITY, -INFINITY, 0, -1};

void wrong_rays_and_casts(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_pos from = {0, 5};
    thud_ray_hit *hit = &wrong_out.hit, *hits = wrong_out.hits;
    int *count = &wrong_out.count;
    EACH(x, not_a_place) {
        thud_pos nowhere = {x, 0}, nor_here = {0, x};
        REFUSED(INVALID, thud_world_cast_ray(w, &(thud_ray){nowhere, 1, 0, NULL}, OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_ray(w, &(thud_ray){nor_here, 1, 0, NULL}, OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_ray(w, &(thud_ray){from, x, 0, NULL}, OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_ray(w, &(thud_ray){from, 0, x, NULL}, OUT_FLAG, hit));
        REFUSED(INVALID,
                thud_world_cast_ray_all(w, &(thud_ray){nowhere, 1, 0, NULL}, hits, 4, count));
        REFUSED(INVALID, thud_world_cast_ray_all(w, &(thud_ray){from, 0, x, NULL}, hits, 4, count));
        REFUSED(INVALID, thud_world_cast_shape(w, &(thud_shape_cast){nowhere, disc, 1, 0, NULL},
                                               OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(w, &(thud_shape_cast){from, disc, x, 0, NULL},
                                                   hits, 4, count));
        REFUSED(INVALID, thud_world_cast_shape(w,
                                               &(thud_shape_cast){nor_here, thud_circle_at(0, 0, 1),
                                                                  1, 0, NULL},
                                               OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(w,
                                                   &(thud_shape_cast){from, thud_circle_at(0, 0, 1),
                                                                      x, 0, NULL},
                                                   hits, 4, count));
        REFUSED(INVALID, thud_world_cast_shape(
                             w, &(thud_shape_cast){nowhere, thud_obb_at(0, 0, 1, 1, 0), 1, 0, NULL},
                             OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(
                             w, &(thud_shape_cast){from, thud_obb_at(0, 0, 1, 1, 0), 0, x, NULL},
                             hits, 4, count));
    }
    EACH(x, not_a_length) {
        REFUSED(INVALID,
                thud_world_cast_shape(w,
                                      &(thud_shape_cast){from, thud_circle_at(0, 0, x), 1, 0, NULL},
                                      OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(w,
                                                   &(thud_shape_cast){from, thud_circle_at(0, 0, x),
                                                                      1, 0, NULL},
                                                   hits, 4, count));
        REFUSED(INVALID, thud_world_cast_shape(w,
                                               &(thud_shape_cast){from, thud_obb_at(0, 0, x, 1, 0),
                                                                  1, 0, NULL},
                                               OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(
                             w, &(thud_shape_cast){from, thud_obb_at(0, 0, 1, x, 1), 1, 0, NULL},
                             hits, 4, count));
    }
    EACH(x, not_an_angle) {
        REFUSED(INVALID, thud_world_cast_shape(w,
                                               &(thud_shape_cast){from, thud_obb_at(0, 0, 1, 1, x),
                                                                  1, 0, NULL},
                                               OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(
                             w, &(thud_shape_cast){from, thud_obb_at(0, 0, 1, 1, x), 1, 0, NULL},
                             hits, 4, count));
    }
    for (int i = 0; i < COUNT(no_shapes); i++) {
        const thud_geometry *none = &no_shapes[i];
        REFUSED(INVALID, thud_world_cast_shape(w, &(thud_shape_cast){from, *none, 1, 0, NULL},
                                               OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_cast_shape_all(w, &(thud_shape_cast){from, *none, 1, 0, NULL},
                                                   hits, 4, count));
    }
    REFUSED(INVALID, thud_world_cast_ray_all(w, &(thud_ray){from, 0, -9, NULL}, hits, -1, count));
    REFUSED(INVALID, thud_world_cast_shape_all(w, &(thud_shape_cast){from, disc, 0, -9, NULL}, hits,
                                               -1, count));
    REFUSED(INVALID, thud_world_cast_shape_all(w,
                                               &(thud_shape_cast){from, thud_circle_at(0, 0, 1), 0,
                                                                  -9, NULL},
                                               hits, INT32_MIN, count));
    REFUSED(NULL, thud_world_cast_ray_all(w, &(thud_ray){from, 0, -9, NULL}, NULL, 4, count));
    REFUSED(NULL, thud_world_cast_shape_all(w, &(thud_shape_cast){from, disc, 0, -9, NULL}, NULL, 4,
                                            count));
    REFUSED(NULL, thud_world_cast_shape(w, NULL, OUT_FLAG, hit));
    REFUSED(NULL, thud_world_cast_shape_all(w, NULL, hits, 4, count));
    REFUSED_UNTOLD(NULL, thud_world_cast_ray(NULL, &(thud_ray){from, 1, 0, NULL}, OUT_FLAG, hit));
    REFUSED_UNTOLD(NULL,
                   thud_world_cast_ray_all(NULL, &(thud_ray){from, 1, 0, NULL}, hits, 4, count));
    REFUSED_UNTOLD(NULL, thud_world_cast_shape(NULL, &(thud_shape_cast){from, disc, 1, 0, NULL},
                                               OUT_FLAG, hit));
    REFUSED_UNTOLD(NULL, thud_world_cast_shape_all(NULL, &(thud_shape_cast){from, disc, 1, 0, NULL},
                                                   hits, 4, count));
}

void wrong_overlaps_and_closest(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_pos from = {3, 1};
    int asked = 0;
    thud_closest_hit *hit = &wrong_out.closest_hit;
    EACH(x, not_a_place) {
        thud_pos nowhere = {x, 0}, nor_here = {0, x};
        REFUSED(INVALID, thud_world_overlap_shape(w, nowhere, disc, NULL, count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_shape(w, nor_here, thud_circle_at(0, 0, 1), NULL,
                                                  count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_aabb(w, nowhere, from, NULL, count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_aabb(w, from, nor_here, NULL, count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_shape(w, nowhere, thud_obb_at(0, 0, 1, 1, 1), NULL,
                                                  count_shape, &asked));
        REFUSED(INVALID, thud_world_closest(w, nowhere, 10, NULL, OUT_FLAG, hit));
        REFUSED(INVALID, thud_world_closest(w, nor_here, 10, NULL, OUT_FLAG, hit));
        REFUSED(INVALID,
                thud_body_get_volume(w, p->here.box, THUD_SHAPE_OBB, nowhere, &wrong_out.volume));
    }
    EACH(x, not_a_length) {
        REFUSED(INVALID, thud_world_overlap_shape(w, from, thud_circle_at(0, 0, x), NULL,
                                                  count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_shape(w, from, thud_obb_at(0, 0, x, 1, 1), NULL,
                                                  count_shape, &asked));
        REFUSED(INVALID, thud_world_overlap_shape(w, from, thud_obb_at(0, 0, 1, x, 1), NULL,
                                                  count_shape, &asked));
    }
    EACH(x, not_an_angle) {
        REFUSED(INVALID, thud_world_overlap_shape(w, from, thud_obb_at(0, 0, 1, 1, x), NULL,
                                                  count_shape, &asked));
    }
    for (int i = 0; i < COUNT(no_shapes); i++) {
        REFUSED(INVALID,
                thud_world_overlap_shape(w, from, no_shapes[i], NULL, count_shape, &asked));
    }
    const double not_a_distance[] = {NAN, INFINITY, -INFINITY, -1e-9, 1.1e9, 1e300};
    EACH(x, not_a_distance) {
        REFUSED(INVALID, thud_world_closest(w, from, x, NULL, OUT_FLAG, hit));
    }
    REFUSED(INVALID, thud_world_overlap_aabb(w, from, (thud_pos){2, 2}, NULL, count_shape, &asked));
    REFUSED(NULL, thud_world_overlap_shape(w, from, disc, NULL, NULL, NULL));
    REFUSED(NULL, thud_world_overlap_aabb(w, from, from, NULL, NULL, NULL));
    REFUSED_UNTOLD(NULL, thud_world_overlap_shape(NULL, from, disc, NULL, count_shape, &asked));
    REFUSED_UNTOLD(NULL, thud_world_overlap_aabb(NULL, from, from, NULL, count_shape, &asked));
    REFUSED_UNTOLD(NULL, thud_world_closest(NULL, from, 10, NULL, OUT_FLAG, hit));
    assert_int_equal(asked, 0);
    /* A body with an endless line, or without shapes, has no bounding volume. */
    thud_volume *volume = &wrong_out.volume;
    thud_shape_state plain;
    OK(thud_shape_get_state(w, p->here.plain, &plain));
    REFUSED(INVALID, thud_body_get_volume(w, plain.body, THUD_SHAPE_AABB, from, volume));
    REFUSED(INVALID, thud_body_get_volume(w, p->here.bare, THUD_SHAPE_AABB, from, volume));
    REFUSED(INVALID, thud_body_get_volume(w, p->here.box, THUD_SHAPE_TERRAIN, from, volume));
    REFUSED(INVALID, thud_body_get_volume(w, p->here.box, (thud_shape_kind)-1, from, volume));
    REFUSED(NULL, thud_body_get_volume(w, p->here.box, THUD_SHAPE_AABB, from, NULL));
    REFUSED_UNTOLD(NULL, thud_body_get_volume(NULL, p->here.box, THUD_SHAPE_AABB, from, volume));
}

void wrong_movers(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_mover *mover = &p->here.mover;
    thud_mover good, *const out_of = mover;
    thud_mover_report *report = &wrong_out.report;
    const thud_vec2 walk = {1, 0};
    const double dt = 1.0 / 60;
    /* A field of the village's mover is set to an invalid value; the refused call must not change
     * the mover. */
#define BAD(wanted, field, value)                                                           \
    good = *mover;                                                                          \
    mover->field = (value);                                                                 \
    {                                                                                       \
        thud_mover before = *mover;                                                         \
        thud_result result_ = thud_mover_move(w, out_of, walk, dt, report);                 \
        assert_memory_equal(mover, &before, sizeof before);                                 \
        *mover = good;                                                                      \
        wrong_check(p, result_, THUD_ERROR_##wanted, 1, "mover with bad " #field, __FILE__, \
                    __LINE__);                                                              \
    }
    EACH(x, not_finite) {
        float f = (float)x;
        BAD(INVALID, shape.x, x);
        BAD(INVALID, shape.y, x);
        BAD(INVALID, shape.hx, x);
        BAD(INVALID, up.x, f);
        BAD(INVALID, up.y, f);
        BAD(INVALID, skin, x);
        BAD(INVALID, max_slope, x);
        BAD(INVALID, step_height, x);
        BAD(INVALID, snap_distance, x);
        BAD(INVALID, push_force, x);
        REFUSED(INVALID, thud_mover_move(w, mover, (thud_vec2){f, 0}, dt, report));
        REFUSED(INVALID, thud_mover_move(w, mover, (thud_vec2){0, f}, dt, report));
        REFUSED(INVALID, thud_mover_move(w, mover, walk, x, report));
    }
    BAD(INVALID, shape.x, 1e10);
    BAD(INVALID, shape.hx, 0);
    BAD(INVALID, shape.hx, -1);
    BAD(INVALID, shape.kind, THUD_SHAPE_TERRAIN);
    BAD(INVALID, shape.kind, (thud_shape_kind)77);
    BAD(INVALID, up.y, 0.5f);
    BAD(INVALID, skin, 0);
    BAD(INVALID, skin, -1);
    BAD(INVALID, max_slope, -0.1);
    BAD(INVALID, max_slope, 1.6);
    BAD(INVALID, step_height, -1);
    BAD(INVALID, snap_distance, -1);
    BAD(INVALID, push_force, -1);
    BAD(INVALID, body, p->here.box);
    BAD(INVALID, body, p->here.floor);
    BAD(STALE, body, p->here.gone);
    BAD(STALE, body, p->other.lift);
#undef BAD
    REFUSED(INVALID, thud_mover_move(w, mover, walk, 0, report));
    REFUSED(INVALID, thud_mover_move(w, mover, walk, -dt, report));
    REFUSED(INVALID, thud_mover_move(w, mover, walk, 1.001, report));
    REFUSED(INVALID, thud_mover_move(w, mover, (thud_vec2){3e38f, 3e38f}, dt, report));
    REFUSED(NULL, thud_mover_move(w, NULL, walk, dt, report));
    REFUSED_UNTOLD(NULL, thud_mover_move(NULL, mover, walk, dt, report));
}

void wrong_drawings(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    const thud_debug_draw all = {.flags = 0xff, .lower = {-50, -50}, .upper = {50, 50}};
    thud_debug_draw draw;
#define BAD(field, value) \
    draw = all;           \
    draw.field = (value); \
    REFUSED(INVALID, thud_world_draw(w, &draw))
    EACH(x, not_a_place) {
        BAD(origin.x, x);
        BAD(origin.y, x);
        BAD(lower.x, x);
        BAD(lower.y, x);
        BAD(upper.x, x);
        BAD(upper.y, x);
    }
#undef BAD
    REFUSED(NULL, thud_world_draw(w, NULL));
    REFUSED_UNTOLD(NULL, thud_world_draw(NULL, &all));
}
