/* api_field.c: forces on bodies from what is around them. */
#include "api.h"

#include <thud/thud_fields.h>

/* Slots out: explosion_options. */
void api_explosion_defaults(void) {
    thud_explosion e = thud_default_explosion();
    api_slots.explosion_options = (struct explosion_options){
        .center = {e.center.x, e.center.y},
        .radius = e.radius,
        .falloff = e.falloff,
        .impulse = (double)e.impulse,
        .cover = e.cover,
        .rays = e.rays,
    };
}

/* From the slots of api_explosion_defaults, with the filter behind them. Slots out: number, how
 * many bodies were pushed. */
int api_world_explode(thud_world *world) {
    const struct explosion_options *s = &api_slots.explosion_options;
    thud_explosion explosion = thud_default_explosion();
    explosion.center = (thud_pos){s->center[0], s->center[1]};
    explosion.radius = s->radius;
    explosion.falloff = s->falloff;
    explosion.impulse = (float)s->impulse;
    explosion.cover = (thud_cover)api_to_int(s->cover);
    explosion.rays = api_to_int(s->rays);
    explosion.filter = api_filter(&s->filter);
    int pushed = 0;
    thud_result result = thud_world_explode(world, &explosion, &pushed);
    api_slots.number.value = pushed;
    return result;
}

int api_body_apply_wind(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                        double density, double drag, double lift) {
    return thud_body_apply_wind(world, api_body(index1, generation),
                                (thud_vec2){(float)x, (float)y}, (float)density, (float)drag,
                                (float)lift);
}

/* Slots out: water_options. */
void api_water_defaults(void) {
    thud_water w = thud_default_water();
    api_slots.water_options = (struct water_options){
        .point = {w.point.x, w.point.y},
        .normal = {(double)w.normal.x, (double)w.normal.y},
        .density = (double)w.density,
        .flow = {(double)w.flow.x, (double)w.flow.y},
        .linear_drag = (double)w.linear_drag,
        .angular_drag = (double)w.angular_drag,
    };
}

/* From the slots of api_water_defaults. */
int api_body_apply_buoyancy(thud_world *world, uint32_t index1, uint32_t generation) {
    const struct water_options *s = &api_slots.water_options;
    thud_water water = thud_default_water();
    water.point = (thud_pos){s->point[0], s->point[1]};
    water.normal = (thud_vec2){(float)s->normal[0], (float)s->normal[1]};
    water.density = (float)s->density;
    water.flow = (thud_vec2){(float)s->flow[0], (float)s->flow[1]};
    water.linear_drag = (float)s->linear_drag;
    water.angular_drag = (float)s->angular_drag;
    return thud_body_apply_buoyancy(world, api_body(index1, generation), &water);
}

int api_body_apply_rolling(thud_world *world, uint32_t index1, uint32_t generation,
                           double coefficient) {
    return thud_body_apply_rolling_resistance(world, api_body(index1, generation),
                                              (float)coefficient);
}
