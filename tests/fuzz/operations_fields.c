/* operations_fields.c: explosions, wind, water, rolling resistance and grip. Their effect on bodies
 * enters the digest with the next step. */
#include "operations.h"

#include <thud/thud_fields.h>

void play_explosion(fuzz_session *s) {
    thud_explosion blast = thud_default_explosion();
    int pushed = -7;
    blast.center = pick_place(s);
    blast.radius = next_number(&s->bytes, 0, 0.0625) * s->unit;
    blast.falloff = next_number(&s->bytes, 0, 0.0625) * s->unit;
    blast.impulse = next_float(&s->bytes, -4, 0.125);
    blast.rays = next_count(&s->bytes, THUD_EXPLOSION_RAYS_MAX);
    unsigned byte = next_byte(&s->bytes);
    blast.cover = (thud_cover)(byte % 4);
    blast.filter.sensors = byte & 4;
    blast.filter.mask = byte & 8 ? byte : blast.filter.mask;
    blast.filter.ignore = byte & 16 ? pick_body(s) : blast.filter.ignore;
    TRY(s, thud_world_explode(s->world, &blast, byte == 77 ? NULL : &pushed));
    if (s->result == THUD_OK ? pushed < 0 && byte != 77 : pushed != -7) {
        fuzz_fail(s, "an explosion pushes %d", pushed);
    }
    note_bits(s, (uint64_t)pushed);
}

void play_wind(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_vec2 wind = pick_velocity(s);
    float density = next_float(&s->bytes, 0, 0.0625);
    float drag = next_float(&s->bytes, 0, 0.0625), lift = next_float(&s->bytes, 0, 0.0625);
    TRY(s, thud_body_apply_wind(s->world, body, wind, density, drag, lift));
}

void play_water(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_water water = thud_default_water();
    water.point = pick_place(s);
    water.density = next_float(&s->bytes, 0, 0.0625);
    water.flow = pick_velocity(s);
    water.linear_drag = next_float(&s->bytes, 0, 0.25);
    water.angular_drag = next_float(&s->bytes, 0, 0.25);
    double angle = pick_angle(s), x = 0, y = 1;
    if (COUNTED(thud_sincos(angle, &x, &y)) == THUD_OK) {
        water.normal = (thud_vec2){(float)x, (float)y};
    } else {
        water.normal.x = (float)angle;
    }
    bool any = next_byte(&s->bytes) != 77;
    TRY(s, thud_body_apply_buoyancy(s->world, body, any ? &water : NULL));
}

void play_rolling(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    float coefficient = next_float(&s->bytes, 0, 0.0078125);
    TRY(s, thud_body_apply_rolling_resistance(s->world, body, coefficient));
}

void play_grip(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_vec2 point = pick_velocity(s), axis = pick_velocity(s);
    float speed = pick_speed(s), most = next_float(&s->bytes, 0, 4);
    TRY(s, thud_body_apply_grip(s->world, body, point, axis, speed, most));
}

void play_below(fuzz_session *s) {
    thud_geometry shape = pick_geometry(s);
    struct {
        double area;
        thud_pos centroid;
    } out;
    double x = pick_coordinate(s), y = pick_coordinate(s);
    thud_vec2 normal = {next_float(&s->bytes, -1, 0.0078125), 0};
    normal.y = normal.x * normal.x <= 1 ? sqrtf(1 - normal.x * normal.x) : normal.x;
    PURE(s, out,
         thud_geometry_area_below(&shape,
                                  (thud_half_plane){x, y, (double)normal.x, (double)normal.y},
                                  &out.area, &out.centroid.x, &out.centroid.y));
    if (s->result != THUD_OK) {
        return;
    }
    note_number(s, out.area);
    note_number(s, out.centroid.x);
    note_number(s, out.centroid.y);
    double most =
        shape.kind == THUD_SHAPE_CIRCLE ? 3.15 * shape.hx * shape.hx : 4 * shape.hx * shape.hy;
    if (!(out.area >= 0 && out.area <= 1.001 * most)) {
        fuzz_fail(s, "%g of %g is below a line", out.area, most);
    }
}
