/* wrong_shapes.c: shape defs, terrain lines and edits of lines that must be refused. */
#include "wrong_input.h"

void wrong_shapes(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_body_id box = p->here.box, lift = p->here.lift;
    const thud_shape_def good = thud_default_shape_def();
    thud_shape_def def;
    thud_vec2 zero = {0, 0}, one = {1, 1};
#define BAD(field, value) \
    def = good;           \
    def.field = (value);  \
    REFUSED(INVALID, thud_shape_create_circle(w, box, &def, zero, 1, &wrong_out.shape))
    EACH(x, not_finite) {
        BAD(density, (float)x);
        BAD(friction, (float)x);
        BAD(restitution, (float)x);
        BAD(surface_speed, (float)x);
    }
    BAD(density, -1);
    BAD(density, 3e38f);
    BAD(friction, -1e-30f);
    BAD(friction, 3e38f);
    BAD(restitution, -0.1f);
    BAD(restitution, 1.0001f);
    BAD(surface_speed, 1.1e6f);
    BAD(surface_speed, -3e38f);
#undef BAD
    EACH(x, not_a_size) {
        float f = (float)x;
        REFUSED(INVALID, thud_shape_create_circle(w, box, &good, zero, f, &wrong_out.shape));
        REFUSED(INVALID, thud_shape_create_aabb(w, p->here.plank, &good, zero, (thud_vec2){f, 1},
                                                &wrong_out.shape));
        REFUSED(INVALID, thud_shape_create_aabb(w, p->here.plank, &good, zero, (thud_vec2){1, f},
                                                &wrong_out.shape));
        REFUSED(INVALID,
                thud_shape_create_obb(w, box, &good, zero, (thud_vec2){f, 1}, 0, &wrong_out.shape));
        REFUSED(INVALID,
                thud_shape_create_obb(w, box, &good, zero, (thud_vec2){1, f}, 0, &wrong_out.shape));
    }
    const double not_an_offset[] = {NAN, INFINITY, -INFINITY, 16400, -3e38};
    EACH(x, not_an_offset) {
        thud_vec2 aside = {(float)x, 0}, above = {0, (float)x};
        REFUSED(INVALID, thud_shape_create_circle(w, box, &good, aside, 1, &wrong_out.shape));
        REFUSED(INVALID,
                thud_shape_create_aabb(w, p->here.plank, &good, above, one, &wrong_out.shape));
        REFUSED(INVALID, thud_shape_create_obb(w, box, &good, above, one, 0, &wrong_out.shape));
    }
    EACH(x, not_an_angle) {
        REFUSED(INVALID, thud_shape_create_obb(w, box, &good, zero, one, x, &wrong_out.shape));
    }
    /* A body that rotates cannot have AABBs. */
    REFUSED(INVALID, thud_shape_create_aabb(w, lift, &good, zero, one, &wrong_out.shape));
    REFUSED(NULL, thud_shape_create_circle(w, box, NULL, zero, 1, &wrong_out.shape));
    REFUSED(NULL, thud_shape_create_aabb(w, box, NULL, zero, one, &wrong_out.shape));
    REFUSED(NULL, thud_shape_create_obb(w, box, NULL, zero, one, 0, &wrong_out.shape));
    REFUSED_UNTOLD(NULL, thud_shape_create_circle(NULL, box, &good, zero, 1, &wrong_out.shape));
    REFUSED_UNTOLD(NULL, thud_shape_create_aabb(NULL, box, &good, zero, one, &wrong_out.shape));
    REFUSED_UNTOLD(NULL, thud_shape_create_obb(NULL, box, &good, zero, one, 0, &wrong_out.shape));
    REFUSED_UNTOLD(NULL, thud_shape_get_state(NULL, p->here.hill, &wrong_out.shape_state));
    REFUSED_UNTOLD(NULL, thud_shape_destroy(NULL, p->here.hill));
}

void wrong_terrains(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_body_id floor = p->here.floor;
    thud_shape_def def = thud_default_shape_def();
    thud_pos points[3];
    const thud_pos good[3] = {{0, 0}, {1, 2}, {4, 0}};
    const thud_terrain hill = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    const thud_terrain dunes = {.kind = THUD_TERRAIN_UNIFORM,
                                .spacing = 1,
                                .points = points,
                                .count = 3};
    const thud_terrain plain = {.kind = THUD_TERRAIN_FLAT};
    thud_terrain line;
#define MAKE_LINE thud_shape_create_terrain(w, floor, &def, &line, &wrong_out.shape)
#define BAD(terrain, field, value) \
    line = terrain;                \
    line.field = (value);          \
    REFUSED(INVALID, MAKE_LINE)
#define BAD_POINT(terrain, field, value) \
    line = terrain;                      \
    points[1].field = (value);           \
    REFUSED(INVALID, MAKE_LINE);         \
    points[1] = good[1]
    memcpy(points, good, sizeof points);
    EACH(x, not_finite) {
        BAD(plain, slope, x);
        BAD(dunes, x0, x);
        BAD(dunes, spacing, x);
        BAD_POINT(hill, x, x);
        BAD_POINT(hill, y, x);
        BAD_POINT(dunes, y, x);
    }
    BAD(plain, slope, 101);
    BAD(plain, slope, -1e300);
    BAD(dunes, spacing, 0);
    BAD(dunes, spacing, -1);
    BAD(dunes, count, 1);
    BAD(dunes, count, 0);
    BAD(dunes, count, -3);
    BAD(hill, count, 1);
    BAD(hill, count, INT32_MIN);
    BAD(hill, kind, (thud_terrain_kind)3);
    BAD(hill, kind, (thud_terrain_kind)-1);
    BAD_POINT(hill, x, 0); /* x does not increase */
    BAD_POINT(hill, x, -1);
    BAD_POINT(hill, x, 5); /* beyond the next vertex */
    line = hill;
    line.points = NULL;
    REFUSED(NULL, MAKE_LINE);
    line = dunes;
    line.points = NULL;
    REFUSED(NULL, MAKE_LINE);
#undef BAD_POINT
#undef BAD
#undef MAKE_LINE
    const thud_body_id moving[] = {p->here.ball, p->here.lift, p->here.plank};
    for (int i = 0; i < COUNT(moving); i++) {
        REFUSED(INVALID, thud_shape_create_terrain(w, moving[i], &def, &plain, &wrong_out.shape));
    }
    REFUSED(NULL, thud_shape_create_terrain(w, floor, NULL, &plain, &wrong_out.shape));
    REFUSED(NULL, thud_shape_create_terrain(w, floor, &def, NULL, &wrong_out.shape));
    REFUSED_UNTOLD(NULL, thud_shape_create_terrain(NULL, floor, &def, &plain, &wrong_out.shape));
    REFUSED(INVALID, thud_shape_get_terrain(w, p->here.box_shape, &wrong_out.terrain));
    REFUSED_UNTOLD(NULL, thud_shape_get_terrain(NULL, p->here.hill, &wrong_out.terrain));
}

void wrong_terrain_edits(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_shape_id hill = p->here.hill, dunes = p->here.dunes;
    const thud_shape_id no_line[] = {p->here.box_shape, p->here.plain};
    const double heights[] = {0, 1, 2}, worse[] = {0, NAN, 2}, endless[] = {INFINITY};
    const thud_pos fine[] = {{1, 0}, {2, 0}}, back[] = {{2, 0}, {1, 0}}, twice[] = {{1, 0}, {1, 0}};
    const thud_pos hole[] = {{1, 0}, {1.5, NAN}}, high[] = {{1, 0}, {2, 2e9}};
    const thud_pos *const unsorted[] = {back, twice, hole, high};
    thud_pos at = {200, 2};
    for (int i = 0; i < COUNT(no_line); i++) {
        REFUSED(INVALID, thud_shape_set_heights(w, no_line[i], 0, heights, 1));
        REFUSED(INVALID, thud_shape_dig(w, no_line[i], at, 1));
        REFUSED(INVALID, thud_shape_raise(w, no_line[i], 200, 1, 1));
        REFUSED(INVALID, thud_shape_replace_range(w, no_line[i], 0, 3, fine, 2));
    }
    EACH(x, not_a_place) {
        REFUSED(INVALID, thud_shape_dig(w, hill, (thud_pos){x, 0}, 1));
        REFUSED(INVALID, thud_shape_raise(w, hill, x, 1, 1));
        REFUSED(INVALID, thud_shape_raise(w, hill, 200, 1, x));
    }
    EACH(x, not_finite) {
        REFUSED(INVALID, thud_shape_dig(w, hill, (thud_pos){200, x}, 1));
    }
    EACH(x, not_a_size) {
        REFUSED(INVALID, thud_shape_dig(w, dunes, (thud_pos){300, 0}, x));
        REFUSED(INVALID, thud_shape_raise(w, dunes, 300, x, 1));
    }
    for (int i = 0; i < COUNT(unsorted); i++) {
        REFUSED(INVALID, thud_shape_replace_range(w, hill, 0, 3, unsorted[i], 2));
    }
    REFUSED(INVALID, thud_shape_replace_range(w, hill, NAN, 3, fine, 2));
    REFUSED(INVALID, thud_shape_replace_range(w, hill, 0, NAN, fine, 2));
    REFUSED(INVALID, thud_shape_replace_range(w, hill, 3, 0, fine, 2));
    REFUSED(INVALID, thud_shape_replace_range(w, hill, 1.5, 3, fine, 2));
    REFUSED(INVALID, thud_shape_replace_range(w, hill, 0, 3, fine, -1));
    REFUSED(INVALID, thud_shape_replace_range(w, hill, -100, 100, fine, 1)); /* one vertex would be
                                                                                left */
    REFUSED(INVALID, thud_shape_replace_range(w, hill, -100, 100, NULL, 0));
    REFUSED(INVALID, thud_shape_replace_range(w, dunes, 0, 3, fine, 2));
    REFUSED(NULL, thud_shape_replace_range(w, hill, 0, 3, NULL, 2));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, -1, heights, 1));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, 4, heights, 2));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, INT32_MAX, heights, 3));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, 0, heights, -1));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, 0, heights, INT32_MAX));
    REFUSED(INVALID, thud_shape_set_heights(w, dunes, 0, worse, 3));
    REFUSED(INVALID, thud_shape_set_heights(w, hill, 4, endless, 1));
    REFUSED(NULL, thud_shape_set_heights(w, dunes, 0, NULL, 1));
    REFUSED_UNTOLD(NULL, thud_shape_set_heights(NULL, dunes, 0, heights, 1));
    REFUSED_UNTOLD(NULL, thud_shape_dig(NULL, hill, at, 1));
    REFUSED_UNTOLD(NULL, thud_shape_raise(NULL, hill, 200, 1, 1));
    REFUSED_UNTOLD(NULL, thud_shape_replace_range(NULL, hill, 0, 3, fine, 2));
}
