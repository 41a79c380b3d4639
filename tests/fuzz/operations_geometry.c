/* operations_geometry.c: functions of shapes without a world. */
#include "operations.h"

/* A normal must have the length 1, a fraction must be in [0, 1]. */
static void unit_normal(fuzz_session *s, double nx, double ny) {
    if (!(fabs(nx * nx + ny * ny - 1) < 1e-6)) {
        fuzz_fail(s, "%s: the normal %g %g", s->calls[s->depth].text, nx, ny);
    }
}

/* Fails if `value` is not in 0 to 1. */
static void fraction(fuzz_session *s, double value) {
    if (!(value >= 0 && value <= 1)) {
        fuzz_fail(s, "%s: the fraction %g", s->calls[s->depth].text, value);
    }
}

void play_check(fuzz_session *s) {
    thud_geometry shape = pick_instance(s, false);
    fuzz_calls_made += 2;
    bool valid = thud_geometry_check(&shape) == THUD_OK;
    if (!valid && thud_geometry_overlap(&shape, &shape)) {
        fuzz_fail(s, "a shape that is none overlaps itself");
    }
    if (valid && !thud_geometry_overlap(&shape, &shape)) {
        fuzz_fail(s, "a shape does not overlap itself");
    }
}

void play_pair(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    double margin = fabs(pick_coordinate(s));
    thud_closest closest;
    thud_contacts contacts;
    PURE(s, closest, thud_geometry_closest(&a, &b, &closest));
    if (s->result == THUD_OK) {
        note_number(s, closest.distance);
        note_number(s, closest.ax + closest.ay + closest.bx + closest.by);
        unit_normal(s, closest.nx, closest.ny);
    }
    bool valid = s->result == THUD_OK;
    PURE(s, contacts, thud_geometry_contacts(&a, &b, margin, &contacts));
    if (s->result == THUD_OK) {
        if (contacts.count < 0 || contacts.count > 2 || !valid) {
            fuzz_fail(s, "%d contacts", contacts.count);
        }
        for (int i = 0; i < contacts.count; i++) {
            note_number(s, contacts.point[i].distance);
            unit_normal(s, contacts.point[i].nx, contacts.point[i].ny);
        }
    }
    bool overlap = COUNTED(thud_geometry_overlap(&a, &b));
    if (overlap != COUNTED(thud_geometry_overlap(&b, &a))) {
        fuzz_fail(s, "a overlaps b, and b not a");
    }
    if (overlap && !valid) {
        fuzz_fail(s, "shapes that are none overlap");
    }
}

void play_pair_impact(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    thud_motion of_a = pick_motion(s), of_b = pick_motion(s);
    struct {
        bool hit;
        double time;
    } out;
    double target = fabs(pick_coordinate(s)) / 8;
    PURE(s, out, thud_geometry_time_of_impact(&a, of_a, &b, of_b, target, &out.hit, &out.time));
    if (s->result == THUD_OK) {
        fraction(s, out.time);
    }
}

void play_pair_collision(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    thud_motion of_a = pick_motion(s), of_b = pick_motion(s);
    struct {
        bool collided;
        double time;
    } out;
    double tolerance = next_number(&s->bytes, 1e-6, 1.0 / 512);
    PURE(s, out,
         thud_geometry_time_of_collision(&a, of_a, &b, of_b, tolerance, &out.collided, &out.time));
    if (s->result == THUD_OK) {
        fraction(s, out.time);
    }
}

void play_approach(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    thud_motion of_a = pick_motion(s), of_b = pick_motion(s);
    thud_approach out;
    PURE(s, out, thud_geometry_approach(&a, of_a, &b, of_b, &out));
    if (s->result == THUD_OK) {
        fraction(s, out.time);
        fraction(s, out.min_distance_time);
        note_number(s, out.min_distance);
    }
}

void play_bisectable(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    thud_motion of_a = pick_motion(s), of_b = pick_motion(s);
    bool valid = thud_geometry_check(&a) == THUD_OK && thud_geometry_check(&b) == THUD_OK;
    if (COUNTED(thud_geometry_is_bisectable(&a, of_a, &b, of_b)) && !valid) {
        fuzz_fail(s, "shapes that are none can be bisected");
    }
}

void play_shape_ray(fuzz_session *s) {
    thud_geometry shape = pick_instance(s, false);
    thud_pos from = {pick_coordinate(s), pick_coordinate(s)};
    thud_pos along = {pick_coordinate(s), pick_coordinate(s)};
    double at, nx, ny;
    s->calls[s->depth].text = "thud_geometry_cast_ray";
    if (COUNTED(thud_geometry_cast_ray(&shape, (thud_segment){from.x, from.y, along.x, along.y},
                                       &at, &nx, &ny))) {
        fraction(s, at);
        unit_normal(s, nx, ny);
    }
}

void play_minkowski(fuzz_session *s) {
    thud_geometry a = pick_instance(s, false), b = pick_instance(s, false);
    thud_pos p = {pick_coordinate(s), pick_coordinate(s)};
    thud_pos d = {pick_coordinate(s), pick_coordinate(s)};
    thud_minkowski sum;
    PURE(s, sum, thud_minkowski_sum(&a, &b, &sum));
    if (s->result != THUD_OK) {
        return;
    }
    struct {
        double distance, nx, ny;
    } nearest;
    struct {
        bool hit;
        double fraction, nx, ny;
    } met;
    bool inside;
    PURE(s, inside, thud_minkowski_contains(&sum, p.x, p.y, &inside));
    PURE(s, nearest,
         thud_minkowski_distance(&sum, p.x, p.y, &nearest.distance, &nearest.nx, &nearest.ny));
    if (s->result == THUD_OK) {
        note_number(s, nearest.distance);
        unit_normal(s, nearest.nx, nearest.ny);
    }
    PURE(s, met,
         thud_minkowski_cast(&sum, (thud_segment){p.x, p.y, d.x, d.y}, &met.hit, &met.fraction,
                             &met.nx, &met.ny));
    if (s->result == THUD_OK) {
        fraction(s, met.fraction);
        if (met.hit) {
            unit_normal(s, met.nx, met.ny);
        }
    }
}

void play_sincos(fuzz_session *s) {
    double angle = pick_angle(s) * 1000;
    struct {
        double sine, cosine;
    } out;
    PURE(s, out, thud_sincos(angle, &out.sine, &out.cosine));
    if (s->result == THUD_OK) {
        unit_normal(s, out.sine, out.cosine);
    }
}
