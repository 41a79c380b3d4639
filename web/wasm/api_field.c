/* api_field.c: exports for explosions, wind, water, rolling resistance and grip, which call the
 * functions of thud_fields.h; and tyres, which are computed here. api.h has the conventions. */
#include "api.h"

#include <thud/thud_fields.h>
#include <thud/thud_forces.h>
#include <thud/thud_reads.h>

#include <math.h>

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

/* Slots in: explosion_options. Slots out: number, of the bodies that got an impulse. */
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

/* Slots in: water_options. */
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

int api_body_apply_rolling_resistance(thud_world *world, uint32_t index1, uint32_t generation,
                                      double coefficient) {
    return thud_body_apply_rolling_resistance(world, api_body(index1, generation),
                                              (float)coefficient);
}

int api_body_apply_grip(thud_world *world, uint32_t index1, uint32_t generation, double x, double y,
                        double along_x, double along_y, double speed, double most) {
    thud_vec2 point = {(float)x, (float)y}, axis = {(float)along_x, (float)along_y};
    return thud_body_apply_grip(world, api_body(index1, generation), point, axis, (float)speed,
                                (float)most);
}

/* ---- tyres ---- */

/* The maximum of thrust, brake and grip: mass * length / s^2 (THUD_FORCE_MAX). */
static const double MOST_FORCE = 1e30;

/* The point of a body to which the tyre's impulses are applied. */
typedef struct pushed {
    thud_world *world;
    thud_body_id body;
    thud_pos point;
    thud_body_state state;
} pushed;

/* The velocity of the point times the vector (x, y), length/s: the speed along it where it is a
 * unit vector. */
static double speed_along(const pushed *p, double x, double y) {
    thud_vec2 v = {0};
    (void)thud_body_get_velocity_at(p->world, p->body, p->point, &v);
    return (double)v.x * x + (double)v.y * y;
}

/* The change of the point's speed along a unit vector by a unit impulse along it: the inverse
 * effective mass 1/m + (r x n)^2 / I. */
static double yielding(const pushed *p, double x, double y) {
    const thud_body_state *s = &p->state;
    double arm = (p->point.x - s->center.x) * y - (p->point.y - s->center.y) * x;
    double turning = s->inertia > 0.0f ? arm * arm / (double)s->inertia : 0.0;
    return 1.0 / (double)s->mass + turning;
}

/* Applies an impulse along a unit vector at the point. */
static thud_result push(const pushed *p, double x, double y, double impulse) {
    if (impulse == 0.0) /* an impulse of 0 would wake the body */
        return THUD_OK;
    thud_vec2 along = {(float)(x * impulse), (float)(y * impulse)};
    return thud_body_apply_impulse(p->world, p->body, along, p->point);
}

/* The value limited to [-most, most]. */
static double clamp(double value, double most) {
    return fmax(-most, fmin(most, value));
}

/* Whether the value is in [least, MOST_FORCE]; false for NaN. */
static bool is_force(double value, double least) {
    return value >= least && value <= MOST_FORCE;
}

/* Applies the impulses of a tyre in one step: first along its rolling direction (thrust, and a
 * brake that at most stops it), within the grip; then across it, where the rest of the grip at most
 * stops the sliding. The second is computed from the velocity after the first. Slots in:
 * tyre_options. Slots out: number, the speed across the rolling direction that is left, length/s.
 */
int api_body_apply_tyre(thud_world *world, uint32_t index1, uint32_t generation) {
    const struct tyre_options s = api_slots.tyre_options;
    if (!is_force(s.thrust, -MOST_FORCE) || !is_force(s.brake, 0.0) || !is_force(s.grip, 0.0))
        return THUD_ERROR_INVALID;
    pushed p = {.world = world, .body = api_body(index1, generation)};
    double sine = 0.0, cosine = 1.0;
    thud_step_settings settings;
    thud_vec2 at = {(float)s.at[0], (float)s.at[1]};
    thud_result result = thud_sincos(s.steer, &sine, &cosine);
    if (result == THUD_OK)
        result = thud_body_get_world_point(world, p.body, at, &p.point);
    if (result == THUD_OK)
        result = thud_body_get_state(world, p.body, &p.state);
    if (result == THUD_OK)
        result = thud_world_get_step_settings(world, &settings);
    if (result != THUD_OK)
        return result;

    /* Earlier impulses may have made the velocity infinite; the tyre's impulse would then not be a
     * number. The sum of x and y is finite only if both are. */
    if (!isfinite(speed_along(&p, 1.0, 1.0)))
        return api_refuse("apply tyre: the body's velocity is not finite");

    double turned_x = (double)p.state.cosine, turned_y = (double)p.state.sine;
    double x = turned_x * cosine - turned_y * sine, y = turned_y * cosine + turned_x * sine;
    double dt = settings.time_step, grip = s.grip * dt;
    if (p.state.mass > 0.0f) {
        double drive = s.thrust * dt;
        double stop = -speed_along(&p, x, y) / yielding(&p, x, y);
        double along = clamp(drive + clamp(stop - drive, s.brake * dt), grip);
        result = push(&p, x, y, along);
        double across = -speed_along(&p, -y, x) / yielding(&p, -y, x);
        if (result == THUD_OK)
            result = push(&p, -y, x, clamp(across, sqrt(fmax(0.0, grip * grip - along * along))));
    }
    api_slots.number.value = fabs(speed_along(&p, -y, x));
    return result;
}
