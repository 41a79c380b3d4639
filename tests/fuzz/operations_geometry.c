/* operations_geometry.c: operations of a fuzzer that call the geometry functions, which need no
 * world, with shapes and motions from the input's bytes, and check what they return. PURE,
 * which makes a call and demands that its output is unchanged where it is refused, and COUNTED are
 * in calls.h. */
#include "operations.h"

/* Tolerance of the squared length of unit vectors. Chosen, far above the rounding of doubles. */
#define UNIT_TOLERANCE 1e-6

/* Fails if the vector (x, y), a normal or a sine and cosine, has not the length 1. */
static void check_unit_vector(fuzz_session *s, double x, double y) {
    if (!(fabs(x * x + y * y - 1) < UNIT_TOLERANCE)) {
        fuzz_fail(s, "%s: the unit vector %g %g", s->calls[s->depth].text, x, y);
    }
}

/* Fails if `value`, a fraction of a ray or a motion, is not in [0, 1]. */
static void check_fraction(fuzz_session *s, double value) {
    if (!(value >= 0 && value <= 1)) {
        fuzz_fail(s, "%s: the fraction %g", s->calls[s->depth].text, value);
    }
}

/* Valid shapes overlap themselves, invalid ones overlap nothing. */
void play_check(fuzz_session *s) {
    thud_geometry shape = pick_geometry(s);
    fuzz_calls_made += 2;
    bool valid = thud_geometry_check(&shape) == THUD_OK;
    if (!valid && thud_geometry_overlap(&shape, &shape)) {
        fuzz_fail(s, "an invalid shape overlaps itself");
    }
    if (valid && !thud_geometry_overlap(&shape, &shape)) {
        fuzz_fail(s, "a valid shape does not overlap itself");
    }
}

void play_pair(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    double margin = fabs(pick_coordinate(s));
    thud_closest closest;
    thud_contacts contacts;
    PURE(s, closest, thud_geometry_closest(&a, &b, &closest));
    bool valid = s->result == THUD_OK;
    if (valid) {
        note_number(s, closest.distance);
        note_number(s, closest.ax + closest.ay + closest.bx + closest.by);
        check_unit_vector(s, closest.nx, closest.ny);
    }
    PURE(s, contacts, thud_geometry_contacts(&a, &b, margin, &contacts));
    if (s->result == THUD_OK) {
        if (contacts.count < 0 || contacts.count > 2 || !valid) {
            fuzz_fail(s, "%d contacts of %s shapes", contacts.count, valid ? "valid" : "invalid");
        }
        for (int i = 0; i < contacts.count; i++) {
            note_number(s, contacts.point[i].distance);
            check_unit_vector(s, contacts.point[i].nx, contacts.point[i].ny);
        }
    }
    bool overlap = COUNTED(thud_geometry_overlap(&a, &b));
    if (overlap != COUNTED(thud_geometry_overlap(&b, &a))) {
        fuzz_fail(s, "a overlaps b, and b not a");
    }
    if (overlap && !valid) {
        fuzz_fail(s, "invalid shapes overlap");
    }
}

/* Time of impact: the first time at which the shapes are within the distance `target`. */
void play_pair_impact(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    thud_motion motion_a = pick_motion(s), motion_b = pick_motion(s);
    struct {
        bool hit;
        double time;
    } out;
    /* At most two length scales, unless the number is hostile. Chosen. */
    double target = fabs(pick_coordinate(s)) / 8;
    PURE(s, out,
         thud_geometry_time_of_impact(&a, motion_a, &b, motion_b, target, &out.hit, &out.time));
    if (s->result == THUD_OK) {
        check_fraction(s, out.time);
    }
}

/* Time of collision: by bisection, when the shapes, which are apart at first and overlap at last,
 * began to overlap. */
void play_pair_collision(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    thud_motion motion_a = pick_motion(s), motion_b = pick_motion(s);
    struct {
        bool collided;
        double time;
    } out;
    /* 1e-6 to a half of the motion, unless the number is hostile. Chosen. */
    double tolerance = next_number(&s->bytes, 1e-6, 1.0 / 512);
    PURE(s, out,
         thud_geometry_time_of_collision(&a, motion_a, &b, motion_b, tolerance, &out.collided,
                                         &out.time));
    if (s->result == THUD_OK) {
        check_fraction(s, out.time);
    }
}

/* Impact and closest approach of two circles, in closed form. */
void play_approach(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    thud_motion motion_a = pick_motion(s), motion_b = pick_motion(s);
    thud_approach out;
    PURE(s, out, thud_geometry_approach(&a, motion_a, &b, motion_b, &out));
    if (s->result == THUD_OK) {
        check_fraction(s, out.time); /* of the impact */
        check_fraction(s, out.min_distance_time);
        note_number(s, out.min_distance);
    }
}

/* Bisectable: an overlap test at the end of the motions cannot miss that a shape passed through the
 * middle of the other. Never true for invalid shapes. */
void play_bisectable(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    thud_motion motion_a = pick_motion(s), motion_b = pick_motion(s);
    bool valid = thud_geometry_check(&a) == THUD_OK && thud_geometry_check(&b) == THUD_OK;
    if (COUNTED(thud_geometry_is_bisectable(&a, motion_a, &b, motion_b)) && !valid) {
        fuzz_fail(s, "the motion of invalid shapes is bisectable");
    }
}

static thud_segment pick_segment(fuzz_session *s) {
    thud_pos from = {pick_coordinate(s), pick_coordinate(s)};
    thud_pos vector = {pick_coordinate(s), pick_coordinate(s)};
    return (thud_segment){.x = from.x, .y = from.y, .dx = vector.x, .dy = vector.y};
}

void play_shape_ray(fuzz_session *s) {
    thud_geometry shape = pick_geometry(s);
    thud_segment ray = pick_segment(s);
    double fraction, nx, ny;
    s->calls[s->depth].text = "thud_geometry_cast_ray"; /* for messages; COUNTED does not set it */
    if (COUNTED(thud_geometry_cast_ray(&shape, ray, &fraction, &nx, &ny))) {
        check_fraction(s, fraction);
        check_unit_vector(s, nx, ny);
    }
}

/* The Minkowski sum of two shapes: a point in it, its distance from a point, a ray against it. */
void play_minkowski(fuzz_session *s) {
    thud_geometry a = pick_geometry(s), b = pick_geometry(s);
    thud_segment ray = pick_segment(s);
    thud_minkowski sum;
    PURE(s, sum, thud_minkowski_sum(&a, &b, &sum));
    if (s->result != THUD_OK) {
        return;
    }
    struct {
        double distance, nx, ny;
    } nearest;
    struct {
        bool any;
        double fraction, nx, ny;
    } hit;
    bool inside; /* compared with nothing: only that the call writes nothing where it is refused */
    PURE(s, inside, thud_minkowski_contains(&sum, ray.x, ray.y, &inside));
    PURE(s, nearest,
         thud_minkowski_distance(&sum, ray.x, ray.y, &nearest.distance, &nearest.nx, &nearest.ny));
    if (s->result == THUD_OK) {
        note_number(s, nearest.distance);
        check_unit_vector(s, nearest.nx, nearest.ny);
    }
    PURE(s, hit, thud_minkowski_cast(&sum, ray, &hit.any, &hit.fraction, &hit.nx, &hit.ny));
    if (s->result == THUD_OK) {
        check_fraction(s, hit.fraction);
        if (hit.any) {
            check_unit_vector(s, hit.nx, hit.ny);
        }
    }
}

void play_sincos(fuzz_session *s) {
    double angle = pick_angle(s) * 1000; /* up to a thousand turns: the range reduction */
    struct {
        double sine, cosine;
    } out;
    PURE(s, out, thud_sincos(angle, &out.sine, &out.cosine));
    if (s->result == THUD_OK) {
        check_unit_vector(s, out.sine, out.cosine);
    }
}

/* The angle of a sine and a cosine, of which not all belong together. */
void play_angle_of(fuzz_session *s) {
    double angle = pick_angle(s), other = pick_coordinate(s), sine = other, cosine = other, found;
    if (COUNTED(thud_sincos(angle, &sine, &cosine)) == THUD_OK && next_choice(&s->bytes, 4) == 0) {
        sine = other;
    }
    PURE(s, found, thud_angle_of(sine, cosine, &found));
    if (s->result == THUD_OK) {
        note_number(s, found);
        if (fabs(found) > 3.2) {
            fuzz_fail(s, "an angle of %g", found);
        }
    }
}

/* A polygon approximated by shapes; few random points are a polygon, so half of them are put around
 * a circle. */
void play_approximate(fuzz_session *s) {
    thud_pos points[PICK_POINTS];
    int count = next_count(&s->bytes, PICK_POINTS);
    count = count > PICK_POINTS ? -1 : count;
    bool around = next_choice(&s->bytes, 2) == 0;
    for (int i = 0; i < PICK_POINTS; i++) {
        points[i] = i < count ? (thud_pos){pick_coordinate(s), pick_coordinate(s)} : (thud_pos){0};
        double sine = 0, cosine = 0, far = fabs(points[i].x) + s->unit;
        if (around && i < count) {
            thud_sincos(6.283 * i / count, &sine, &cosine);
            points[i] = (thud_pos){far * cosine, far * sine};
        }
    }
    const char *reason = "";
    bool valid = COUNTED(thud_polygon_check(points, count, &reason)) == THUD_OK;
    if (valid == (reason != NULL)) {
        fuzz_fail(s, "thud_polygon_check: a reason, or none");
    }
    thud_approximate_options options = {
        .shapes_max = next_choice(&s->bytes, s->bytes.hostile ? 9 : 6),
        .kinds = (thud_approximate_kind)next_choice(&s->bytes, s->bytes.hostile ? 4 : 3),
        .distance = next_choice(&s->bytes, 2) ? (double)pick_size(s) : 0};
    struct {
        thud_geometry shapes[9];
        thud_approximation found;
    } out;
    PURE(s, out, thud_approximate(points, count, &options, out.shapes, &out.found));
    if (s->result != THUD_OK) {
        return;
    }
    if (!valid || out.found.count < 1 || out.found.count > options.shapes_max ||
        !(out.found.missed >= 0 && out.found.extra >= 0 && out.found.overlap >= 0)) {
        fuzz_fail(s, "thud_approximate: %d shapes, missed %g", out.found.count, out.found.missed);
    }
    note_number(s, out.found.distance);
    for (int i = 0; i < out.found.count; i++) {
        if (COUNTED(thud_geometry_check(&out.shapes[i])) != THUD_OK) {
            fuzz_fail(s, "thud_approximate: a shape that is none");
        }
    }
}

/* ---- capsules ---- */

thud_capsule pick_capsule(fuzz_session *s) {
    thud_capsule c = {pick_coordinate(s), pick_coordinate(s), pick_coordinate(s),
                      pick_coordinate(s), (double)pick_size(s)};
    return c;
}

/* Capsules against a shape and each other; motions that turn are refused. */
void play_capsule(fuzz_session *s) {
    thud_capsule a = pick_capsule(s), b = pick_capsule(s);
    thud_geometry shape = pick_geometry(s);
    thud_motion motion_a = pick_motion(s), motion_b = pick_motion(s);
    motion_a.turn = next_choice(&s->bytes, 8) == 0 ? motion_a.turn : 0;
    motion_b.turn = 0;
    double target = next_choice(&s->bytes, 2) ? (double)pick_size(s) : 0;
    bool valid = COUNTED(thud_capsule_check(&a)) == THUD_OK;
    thud_closest closest;
    thud_capsule covered;
    struct {
        bool hit;
        double time;
    } impact;
    for (int i = 0; i < 2; i++) {
        if (i == 0) {
            PURE(s, closest, thud_capsule_closest(&a, &shape, &closest));
        } else {
            PURE(s, closest, thud_capsules_closest(&a, &b, &closest));
        }
        if (s->result == THUD_OK) {
            note_number(s, closest.distance);
            check_unit_vector(s, closest.nx, closest.ny);
        }
        if (s->result == THUD_OK && !valid) {
            fuzz_fail(s, "a capsule that is none has a distance");
        }
        if (i == 0) {
            PURE(s, impact,
                 thud_capsule_time_of_impact(&a, motion_a, &shape, motion_b, target, &impact.hit,
                                             &impact.time));
        } else {
            PURE(s, impact,
                 thud_capsules_time_of_impact(&a, motion_a, &b, motion_b, target, &impact.hit,
                                              &impact.time));
        }
        if (s->result == THUD_OK) {
            check_fraction(s, impact.time);
        }
    }
    PURE(s, covered, thud_capsule_of_motion(&shape, motion_a, &covered));
    if (s->result == THUD_OK && COUNTED(thud_capsule_check(&covered)) != THUD_OK) {
        fuzz_fail(s, "thud_capsule_of_motion: a capsule that is none");
    }
}
