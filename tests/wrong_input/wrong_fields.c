/* wrong_fields.c: explosions, wind, water, rolling resistance and grip that must be refused. */
#include "wrong_input.h"

#include <thud/thud_fields.h>

static const double not_a_drag[] = {NAN, INFINITY, -INFINITY, -1e-6, 1.001e6, 3e38};
static const double not_a_density[] = {NAN, INFINITY, -INFINITY, -1e-6, 1.001e12, 3e38};
static const double not_a_flow[] = {NAN, INFINITY, -INFINITY, -1.001e6, 1.001e6, 3e38};
static const double not_a_reach[] = {NAN, INFINITY, -INFINITY, -1e-9, 1.0000001e9, 1e300};
static const double not_an_impulse[] = {NAN, INFINITY, -INFINITY, -1.001e15, 1.001e15, 3e38};

static thud_explosion wide(void) {
    thud_explosion blast = thud_default_explosion();
    blast.center = (thud_pos){1, 3};
    blast.radius = 20;
    return blast;
}

#define EXPLOSION_REFUSED(set)                                             \
    do {                                                                   \
        thud_explosion blast = wide();                                     \
        set;                                                               \
        REFUSED(INVALID, thud_world_explode(w, &blast, &wrong_out.count)); \
    } while (0)

void wrong_explosions(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    EACH(x, not_a_place) {
        EXPLOSION_REFUSED(blast.center.x = x);
        EXPLOSION_REFUSED(blast.center.y = x);
    }
    EACH(x, not_a_reach) {
        EXPLOSION_REFUSED(blast.radius = x);
        EXPLOSION_REFUSED(blast.falloff = x);
    }
    EACH(x, not_an_impulse) {
        EXPLOSION_REFUSED(blast.impulse = (float)x);
    }
    EXPLOSION_REFUSED(blast.rays = 0);
    EXPLOSION_REFUSED(blast.rays = -1);
    EXPLOSION_REFUSED(blast.rays = THUD_EXPLOSION_RAYS_MAX + 1);
    EXPLOSION_REFUSED(blast.cover = (thud_cover)(THUD_COVER_ALL + 1));
    thud_explosion blast = wide();
    REFUSED(NULL, thud_world_explode(w, NULL, &wrong_out.count));
    REFUSED_UNTOLD(NULL, thud_world_explode(NULL, &blast, &wrong_out.count));
}

#define WATER_REFUSED(set)                                           \
    do {                                                             \
        thud_water water = thud_default_water();                     \
        set;                                                         \
        REFUSED(INVALID, thud_body_apply_buoyancy(w, ball, &water)); \
    } while (0)

static void wrong_grips(wrong_pair *p) {
    thud_world *w = p->here.world;
    thud_body_id ball = p->here.ball;
    thud_vec2 at = {0, 0}, axis = {1, 0};
    EACH(x, not_finite) {
        thud_vec2 off = {(float)x, 0}, slanted = {0, (float)x};
        REFUSED(INVALID, thud_body_apply_grip(w, ball, off, axis, 0, 1));
        REFUSED(INVALID, thud_body_apply_grip(w, ball, slanted, axis, 0, 1));
        REFUSED(INVALID, thud_body_apply_grip(w, ball, at, off, 0, 1));
        REFUSED(INVALID, thud_body_apply_grip(w, ball, at, slanted, 0, 1));
        REFUSED(INVALID, thud_body_apply_grip(w, ball, at, axis, 0, (float)x));
    }
    EACH(x, not_a_flow) {
        REFUSED(INVALID, thud_body_apply_grip(w, ball, at, axis, (float)x, 1));
    }
    REFUSED(INVALID, thud_body_apply_grip(w, ball, at, (thud_vec2){0, 0}, 0, 1));
    REFUSED(INVALID, thud_body_apply_grip(w, ball, at, axis, 0, -1));
    REFUSED(INVALID, thud_body_apply_grip(w, p->here.floor, at, axis, 0, 1));
    REFUSED(INVALID, thud_body_apply_grip(w, p->here.lift, at, axis, 0, 1));
    REFUSED(STALE, thud_body_apply_grip(w, p->here.gone, at, axis, 0, 1));
    REFUSED(STALE, thud_body_apply_grip(w, p->other.ball, at, axis, 0, 1));
    REFUSED_UNTOLD(NULL, thud_body_apply_grip(NULL, ball, at, axis, 0, 1));
}

static void wrong_waters(wrong_pair *p) {
    thud_world *w = p->here.world;
    thud_body_id ball = p->here.ball;
    EACH(x, not_a_place) {
        WATER_REFUSED(water.point.x = x);
        WATER_REFUSED(water.point.y = x);
    }
    EACH(x, not_a_density) {
        WATER_REFUSED(water.density = (float)x);
    }
    EACH(x, not_a_flow) {
        WATER_REFUSED(water.flow.x = (float)x);
        WATER_REFUSED(water.flow.y = (float)x);
    }
    EACH(x, not_a_drag) {
        WATER_REFUSED(water.linear_drag = (float)x);
        WATER_REFUSED(water.angular_drag = (float)x);
    }
    EACH(x, not_finite) {
        WATER_REFUSED(water.normal.x = (float)x);
    }
    WATER_REFUSED(water.normal.y = 0);
    WATER_REFUSED(water.normal.y = 1.01f);
    WATER_REFUSED(water.normal.y = 0.99f);
    REFUSED(NULL, thud_body_apply_buoyancy(w, ball, NULL));
}

void wrong_fields(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    thud_body_id ball = p->here.ball;
    thud_vec2 still = {0, 0};
    thud_water water = thud_default_water();
    wrong_waters(p);
    wrong_grips(p);
    EACH(x, not_a_flow) {
        thud_vec2 wind = {(float)x, 0}, gust = {0, (float)x};
        REFUSED(INVALID, thud_body_apply_wind(w, ball, wind, 1, 1, 1));
        REFUSED(INVALID, thud_body_apply_wind(w, ball, gust, 1, 1, 1));
    }
    EACH(x, not_a_density) {
        REFUSED(INVALID, thud_body_apply_wind(w, ball, still, (float)x, 1, 1));
    }
    EACH(x, not_a_drag) {
        REFUSED(INVALID, thud_body_apply_wind(w, ball, still, 1, (float)x, 1));
        REFUSED(INVALID, thud_body_apply_wind(w, ball, still, 1, 1, (float)x));
        REFUSED(INVALID, thud_body_apply_rolling_resistance(w, ball, (float)x));
    }
    const thud_body_id idle[] = {p->here.floor, p->here.lift};
    for (int i = 0; i < COUNT(idle); i++) {
        REFUSED(INVALID, thud_body_apply_wind(w, idle[i], still, 1, 1, 1));
        REFUSED(INVALID, thud_body_apply_buoyancy(w, idle[i], &water));
        REFUSED(INVALID, thud_body_apply_rolling_resistance(w, idle[i], 1));
    }
    const thud_body_id wrong[] = {
        {0, 0}, {4000, 1}, p->here.gone, p->other.ball, {UINT32_MAX, UINT32_MAX}};
    for (int i = 0; i < COUNT(wrong); i++) {
        REFUSED(STALE, thud_body_apply_wind(w, wrong[i], still, 1, 1, 1));
        REFUSED(STALE, thud_body_apply_buoyancy(w, wrong[i], &water));
        REFUSED(STALE, thud_body_apply_rolling_resistance(w, wrong[i], 1));
    }
    REFUSED_UNTOLD(NULL, thud_body_apply_wind(NULL, ball, still, 1, 1, 1));
    REFUSED_UNTOLD(NULL, thud_body_apply_buoyancy(NULL, ball, &water));
    REFUSED_UNTOLD(NULL, thud_body_apply_rolling_resistance(NULL, ball, 1));
}
