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
