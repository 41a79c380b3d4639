/* wrong_bodies.c: body defs and edits of bodies that must be refused, and invalid handles. */
#include "wrong_input.h"

void wrong_bodies(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    const thud_body_def good = def;
#define BAD(field, value) \
    def = good;           \
    def.field = (value);  \
    REFUSED(INVALID, thud_body_create(w, &def, &wrong_out.body))
    BAD(kind, THUD_BODY_KIND_COUNT);
    BAD(kind, (thud_body_kind)-1);
    EACH(x, not_a_place) {
        BAD(position.x, x);
        BAD(position.y, x);
    }
    EACH(x, not_an_angle) {
        BAD(angle, x);
    }
    EACH(x, not_finite) {
        BAD(velocity.x, (float)x);
        BAD(velocity.y, (float)x);
        BAD(angular_velocity, (float)x);
        BAD(gravity_scale, (float)x);
        BAD(linear_damping, (float)x);
        BAD(angular_damping, (float)x);
    }
    BAD(linear_damping, -1e-30f);
    BAD(angular_damping, -1);
#undef BAD
    REFUSED(NULL, thud_body_create(w, NULL, &wrong_out.body));
    REFUSED_UNTOLD(NULL, thud_body_create(NULL, &good, &wrong_out.body));
}

void wrong_body_edits(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_body_id ball = p->here.ball, floor = p->here.floor, lift = p->here.lift;
    thud_vec2 one = {1, 1}, zero = {0, 0};
    thud_pos here = {0, 0};
    EACH(x, not_a_place) {
        REFUSED(INVALID, thud_body_set_transform(w, ball, (thud_pos){x, 0}, 0));
        REFUSED(INVALID, thud_body_set_transform(w, floor, (thud_pos){0, x}, 0));
        REFUSED(INVALID, thud_body_apply_impulse(w, ball, one, (thud_pos){x, 0}));
        REFUSED(INVALID, thud_body_apply_impulse(w, ball, one, (thud_pos){0, x}));
    }
    EACH(x, not_an_angle) {
        REFUSED(INVALID, thud_body_set_transform(w, ball, here, x));
    }
    EACH(x, not_finite) {
        float f = (float)x;
        REFUSED(INVALID, thud_body_set_velocity(w, ball, (thud_vec2){f, 0}, 0));
        REFUSED(INVALID, thud_body_set_velocity(w, lift, (thud_vec2){0, f}, 0));
        REFUSED(INVALID, thud_body_set_velocity(w, ball, zero, f));
        REFUSED(INVALID, thud_body_apply_impulse(w, ball, (thud_vec2){f, 0}, here));
        REFUSED(INVALID, thud_body_apply_impulse(w, ball, (thud_vec2){0, f}, here));
        REFUSED(INVALID, thud_body_apply_center_force(w, ball, (thud_vec2){f, 0}));
        REFUSED(INVALID, thud_body_apply_center_force(w, ball, (thud_vec2){0, f}));
        REFUSED(INVALID, thud_body_apply_torque(w, ball, f));
    }
    /* Bodies with AABBs cannot be turned, and forces, impulses and velocities of bodies that these
     * cannot move are refused. */
    REFUSED(INVALID, thud_body_get_shapes(w, ball, wrong_out.shapes, -1, &wrong_out.count));
    REFUSED(INVALID, thud_body_set_transform(w, p->here.plank, here, 0.1));
    REFUSED(INVALID, thud_body_set_transform(w, floor, here, 1));
    REFUSED(INVALID, thud_body_set_velocity(w, floor, zero, 0));
    REFUSED(INVALID, thud_body_apply_impulse(w, floor, one, here));
    REFUSED(INVALID, thud_body_apply_impulse(w, lift, one, here));
    REFUSED(INVALID, thud_body_apply_center_force(w, floor, one));
    REFUSED(INVALID, thud_body_apply_center_force(w, lift, one));
    REFUSED(INVALID, thud_body_set_awake(w, floor, true));
    REFUSED(INVALID, thud_body_set_awake(w, lift, false));
    REFUSED_UNTOLD(NULL, thud_body_set_transform(NULL, ball, here, 0));
    REFUSED_UNTOLD(NULL, thud_body_set_velocity(NULL, ball, one, 0));
    REFUSED_UNTOLD(NULL, thud_body_apply_impulse(NULL, ball, one, here));
    REFUSED_UNTOLD(NULL, thud_body_apply_center_force(NULL, ball, one));
    REFUSED_UNTOLD(NULL, thud_body_set_awake(NULL, ball, true));
    REFUSED_UNTOLD(NULL, thud_body_set_enabled(NULL, ball, false));
    REFUSED_UNTOLD(NULL, thud_body_set_user_data(NULL, ball, 7));
    REFUSED_UNTOLD(NULL, thud_body_get_state(NULL, ball, &wrong_out.body_state));
    REFUSED_UNTOLD(NULL, thud_body_get_shapes(NULL, ball, wrong_out.shapes, 4, &wrong_out.count));
    REFUSED_UNTOLD(NULL, thud_body_destroy(NULL, ball));
}

/* Handles that are invented, stale (their slots have new bodies), of a later generation, of another
 * world, or of a destroyed world. */
void wrong_handles(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    village dead;
    village_make(&dead, thud_default_world_def());
    thud_body_id dead_body = dead.box;
    thud_shape_id dead_shape = dead.box_shape, dead_line = dead.hill;
    village_free(&dead);
    const thud_body_id ball = p->here.ball;
    const thud_body_id bodies[] = {
        {0, 0},
        {UINT32_MAX, UINT32_MAX},
        {ball.index1, 0},
        {ball.index1, ball.generation + 1},
        {ball.index1 + 1, ball.generation + 1},
        {0x80000000u, ball.generation},
        p->here.gone,
        p->other.ball,
        p->other.floor,
        dead_body,
    };
    const thud_shape_id shape = p->here.ball_shape;
    const thud_shape_id shapes[] = {
        {0, 0},
        {UINT32_MAX, UINT32_MAX},
        {shape.index1, 0},
        {shape.index1, shape.generation + 1},
        {0x80000000u, shape.generation},
        p->here.gone_shape,
        p->other.ball_shape,
        p->other.hill,
        dead_shape,
        dead_line,
    };
    const double heights[] = {0, 0};
    const thud_pos points[] = {{1, 0}, {2, 0}};
    const thud_terrain line = {.kind = THUD_TERRAIN_FLAT};
    thud_shape_def def = thud_default_shape_def();
    thud_vec2 one = {1, 1};
    thud_pos here = {0, 0};
    for (int i = 0; i < COUNT(bodies); i++) {
        thud_body_id b = bodies[i];
        assert_false(thud_body_is_valid(w, b));
        REFUSED(STALE, thud_body_get_state(w, b, &wrong_out.body_state));
        REFUSED(STALE, thud_body_destroy(w, b));
        REFUSED(STALE, thud_body_set_transform(w, b, here, 0));
        REFUSED(STALE, thud_body_set_velocity(w, b, one, 0));
        REFUSED(STALE, thud_body_apply_impulse(w, b, one, here));
        REFUSED(STALE, thud_body_apply_center_force(w, b, one));
        REFUSED(STALE, thud_body_set_awake(w, b, true));
        REFUSED(STALE, thud_body_set_enabled(w, b, false));
        REFUSED(STALE, thud_body_set_user_data(w, b, 7));
        REFUSED(STALE, thud_body_get_shapes(w, b, wrong_out.shapes, 4, &wrong_out.count));
        REFUSED(STALE, thud_body_get_volume(w, b, THUD_SHAPE_AABB, here, &wrong_out.volume));
        REFUSED(STALE, thud_shape_create_circle(w, b, &def, one, 1, &wrong_out.shape));
        REFUSED(STALE, thud_shape_create_aabb(w, b, &def, one, one, &wrong_out.shape));
        REFUSED(STALE, thud_shape_create_obb(w, b, &def, one, one, 0, &wrong_out.shape));
        REFUSED(STALE, thud_shape_create_terrain(w, b, &def, &line, &wrong_out.shape));
    }
    for (int i = 0; i < COUNT(shapes); i++) {
        thud_shape_id s = shapes[i];
        assert_false(thud_shape_is_valid(w, s));
        REFUSED(STALE, thud_shape_get_state(w, s, &wrong_out.shape_state));
        REFUSED(STALE, thud_shape_destroy(w, s));
        REFUSED(STALE, thud_shape_get_terrain(w, s, &wrong_out.terrain));
        REFUSED(STALE, thud_shape_set_heights(w, s, 0, heights, 2));
        REFUSED(STALE, thud_shape_dig(w, s, here, 1));
        REFUSED(STALE, thud_shape_raise(w, s, 0, 1, 1));
        REFUSED(STALE, thud_shape_replace_range(w, s, 0, 3, points, 2));
    }
    assert_false(thud_body_is_valid(NULL, ball));
    assert_false(thud_shape_is_valid(NULL, shape));
}
