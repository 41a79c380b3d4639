/* pick.h: arguments for operations, decoded from the session's bytes: places, lengths, and handles
 * of the session's world. */
#ifndef FUZZ_PICK_H
#define FUZZ_PICK_H

#include "session.h"

/* A coordinate without the shift. In shift twins it is on a grid of 1/8 length scale, which a shift
 * does not round. */
static inline double pick_coordinate(fuzz_session *s) {
    double value = next_number(&s->bytes, -16, 0.125);
    bool grid = fabs(value) <= 16;
    if (s->twin == TWIN_SHIFT && !(grid && value * 8 == rint(value * 8))) {
        return value - value; /* NaN for a value that is not finite, otherwise 0; the same in both
                                 twins */
    }
    return grid ? value * s->unit : value;
}

static inline thud_pos pick_place(fuzz_session *s) {
    double x = pick_coordinate(s), y = pick_coordinate(s);
    return (thud_pos){x + s->shift_x, y + s->shift_y};
}

/* A size in (0, 4] length scales. */
static inline float pick_size(fuzz_session *s) {
    float value = next_float(&s->bytes, 0.0625, 0.015625);
    return value >= 0.0625f && value <= 4.0f ? value * (float)s->unit : value;
}

static inline thud_vec2 pick_sizes(fuzz_session *s) {
    float x = pick_size(s);
    return (thud_vec2){x, pick_size(s)};
}

static inline float pick_speed(fuzz_session *s) {
    float value = next_float(&s->bytes, -32, 0.25);
    return fabsf(value) <= 32.0f ? value * (float)s->unit : value;
}

static inline thud_vec2 pick_velocity(fuzz_session *s) {
    float x = pick_speed(s);
    return (thud_vec2){x, pick_speed(s)};
}

static inline double pick_angle(fuzz_session *s) {
    return next_number(&s->bytes, -6.4, 0.05);
}

/* A motion, for functions of shapes without a world. */
static inline thud_motion pick_motion(fuzz_session *s) {
    double x = pick_coordinate(s), y = pick_coordinate(s);
    return (thud_motion){x, y, pick_angle(s)};
}

/* ---- qualities and detections ---- */

/* Quality exact is left out for memory twins: its swept bodies are held at their place if there is
 * no memory to find which bodies they may meet, which changes the result. */
static inline const thud_quality *pick_quality(const fuzz_session *s, unsigned byte) {
    static const thud_quality *const qualities[] = {&thud_quality_default, &thud_quality_draft,
                                                    &thud_quality_high, &thud_quality_exact};
    return qualities[byte % (s->twin == TWIN_MEMORY ? 3 : 4)];
}

/* Null is the world's or the quality's detection. */
static inline const thud_detection *pick_detection(const fuzz_session *s, unsigned byte) {
    static const thud_detection *const detections[] = {NULL, &thud_detection_overlap,
                                                       &thud_detection_continuous,
                                                       &thud_detection_bisect,
                                                       &thud_detection_swept};
    return detections[byte % (s->twin == TWIN_MEMORY ? 4 : 5)];
}

/* ---- handles ---- */

/* Bytes from here on mean a handle that is null, stale, of another world, or invented. */
enum { FIRST_WRONG_HANDLE = 232 };

static inline thud_body_id pick_body(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    if (byte < FIRST_WRONG_HANDLE) {
        return s->now.bodies[byte % SESSION_BODIES];
    }
    switch (byte % 4) {
    case 0:
        return (thud_body_id){0, 0};
    case 1:
        return s->foreign_body;
    case 2:
        return (thud_body_id){byte - 200, next_byte(&s->bytes) * 0x01010101u};
    default:
        return s->gone_bodies[byte / 4 % SESSION_GONE];
    }
}

static inline thud_shape_id pick_shape(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    if (byte < FIRST_WRONG_HANDLE) {
        return s->now.shapes[byte % SESSION_SHAPES];
    }
    switch (byte % 4) {
    case 0:
        return (thud_shape_id){0, 0};
    case 1:
        return s->foreign_shape;
    case 2:
        return (thud_shape_id){byte - 200, next_byte(&s->bytes) * 0x01010101u};
    default:
        return s->gone_shapes[byte / 4 % SESSION_GONE];
    }
}

/* ---- shapes and lines without a world ---- */

/* A shape for the two functions below. */
static inline thud_geometry pick_geometry_with(fuzz_session *s, bool centred) {
    unsigned kind = next_byte(&s->bytes);
    thud_geometry shape = {.kind = (thud_shape_kind)(kind % 3), .c = 1};
    shape.x = centred ? 0 : pick_coordinate(s);
    shape.y = centred ? 0 : pick_coordinate(s);
    shape.hx = (double)pick_size(s);
    shape.hy = shape.kind == THUD_SHAPE_CIRCLE ? 0 : (double)pick_size(s);
    if (shape.kind == THUD_SHAPE_OBB) {
        double angle = pick_angle(s);
        if (thud_sincos(angle, &shape.s, &shape.c) != THUD_OK) {
            shape.c = angle;
        }
    }
    if (s->bytes.hostile && kind >= 250) {
        shape.kind = (thud_shape_kind)(kind - 248);
    }
    return shape;
}

/* A shape anywhere, valid in most cases. */
static inline thud_geometry pick_geometry(fuzz_session *s) {
    return pick_geometry_with(s, false);
}

/* A shape with its centre at the origin, valid in most cases, for a caller that places it. */
static inline thud_geometry pick_centred_geometry(fuzz_session *s) {
    return pick_geometry_with(s, true);
}

enum { PICK_POINTS = 12 };

/* A terrain line that is valid in most cases and refers to `points`. */
static inline thud_terrain pick_line(fuzz_session *s, thud_pos points[PICK_POINTS]) {
    thud_terrain line = {.kind = (thud_terrain_kind)next_choice(&s->bytes, 3)};
    line.slope = next_number(&s->bytes, -2, 1.0 / 64);
    line.x0 = pick_coordinate(s);
    line.spacing = (double)pick_size(s);
    line.points = points;
    line.count = 2 + next_choice(&s->bytes, PICK_POINTS - 1);
    double x = line.x0;
    for (int i = 0; i < PICK_POINTS; i++) {
        points[i] = (thud_pos){x, i < line.count ? pick_coordinate(s) * 0.25 : 0};
        x += i < line.count ? (double)pick_size(s) : 1;
    }
    if (s->bytes.hostile && next_chance(&s->bytes, 16)) {
        line.count = next_count(&s->bytes, PICK_POINTS);
        line.count = line.count > PICK_POINTS ? 1 : line.count;
    }
    return line;
}

#endif
