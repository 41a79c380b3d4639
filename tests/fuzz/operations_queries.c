/* operations_queries.c: rays, casts, overlaps and closest points of a world. */
#include "operations.h"

enum { ROOM = 4, MANY = 80 };

typedef struct way {
    thud_pos from;
    double dx, dy;
    thud_query_filter filter;
    bool filtered;
    int capacity;
} way;

static thud_query_filter query_filter(fuzz_session *s, unsigned byte) {
    thud_query_filter filter = COUNTED(thud_default_query_filter());
    filter.sensors = byte & 1;
    filter.mask = byte & 2 ? byte : filter.mask;
    filter.category = byte & 4 ? 1 : filter.category;
    filter.group = byte & 32 ? (int32_t)(byte >> 6) - 2 : 0;
    filter.ignore = byte & 64 ? s->now.bodies[byte % SESSION_BODIES] : filter.ignore;
    return filter;
}

/* The path of a cast with its filter and the capacity of its list. */
static way pick_way(fuzz_session *s) {
    way w = {.from = pick_place(s)};
    unsigned byte = next_byte(&s->bytes);
    w.dx = 2 * pick_coordinate(s);
    w.dy = 2 * pick_coordinate(s);
    w.filter = query_filter(s, byte);
    w.filtered = byte & 8;
    w.capacity = byte & 16 ? (int)(byte >> 5) - 1 : ROOM;
    w.capacity = w.capacity > ROOM ? 0 : w.capacity;
    return w;
}

/* The float as a double, converted before the caller's float mode is set, in which denormal floats
 * may become 0. */
static double widened(float value) {
    volatile double wide = (double)value;
    return wide;
}

/* Checks a hit and adds it to the digest. The path is in double precision from a point that a shift
 * may have rounded. */
static void check_hit(fuzz_session *s, const thud_ray_hit *hit) {
    double length = (double)hit->normal.x * (double)hit->normal.x +
                    (double)hit->normal.y * (double)hit->normal.y;
    note_bits(s, hit->shape.index1);
    note_place(s, hit->point);
    note_vector(s, hit->normal);
    note_number(s, hit->fraction);
    note_number(s, hit->depth);
    if (!(hit->fraction >= 0 && hit->fraction <= 1) || !(fabs(length - 1) < 1e-4) ||
        hit->depth < 0 || !COUNTED(thud_shape_is_valid(s->world, hit->shape))) {
        fuzz_fail(s, "%s: shape %u at %g, normal %g %g, depth %g", s->calls[s->depth].text,
                  hit->shape.index1, hit->fraction, (double)hit->normal.x, (double)hit->normal.y,
                  hit->depth);
    }
}

static void check_first(fuzz_session *s, bool hit, const thud_ray_hit *out) {
    if (s->result != THUD_OK || !hit) {
        call_untouched(s, out, sizeof *out);
        return;
    }
    check_hit(s, out);
}

static void check_all(fuzz_session *s, const way *w, const thud_ray_hit *out, int count) {
    if (s->result != THUD_OK) {
        return;
    }
    note_bits(s, (uint64_t)count);
    for (int i = 0; i < count && i < w->capacity; i++) {
        check_hit(s, &out[i]);
        if (i && out[i].fraction < out[i - 1].fraction) {
            fuzz_fail(s, "%s: hit %d comes before hit %d", s->calls[s->depth].text, i, i - 1);
        }
    }
}

#define FILTER(w) ((w).filtered ? &(w).filter : NULL)

#define FIRST(s, moving)                                                                        \
    do {                                                                                        \
        thud_ray_hit out;                                                                       \
        bool hit = false;                                                                       \
        memset(&out, CALL_FILL, sizeof out);                                                    \
        TRY(s, thud_world_cast_shape(s->world,                                                  \
                                     &(thud_shape_cast){w.from, moving, w.dx, w.dy, FILTER(w)}, \
                                     &hit, &out));                                              \
        check_first(s, hit, &out);                                                              \
    } while (0)

#define ALL(s, moving)                                                                           \
    do {                                                                                         \
        thud_ray_hit out[ROOM];                                                                  \
        int count = 0;                                                                           \
        TRY(s,                                                                                   \
            thud_world_cast_shape_all(s->world,                                                  \
                                      &(thud_shape_cast){w.from, moving, w.dx, w.dy, FILTER(w)}, \
                                      out, w.capacity, &count));                                 \
        check_all(s, &w, out, count);                                                            \
    } while (0)

void play_ray(fuzz_session *s) {
    way w = pick_way(s);
    thud_ray_hit out;
    bool hit = false;
    memset(&out, CALL_FILL, sizeof out);
    TRY(s, thud_world_cast_ray(s->world, &(thud_ray){w.from, w.dx, w.dy, FILTER(w)}, &hit, &out));
    check_first(s, hit, &out);
}

void play_ray_all(fuzz_session *s) {
    way w = pick_way(s);
    thud_ray_hit out[ROOM];
    int count = 0;
    TRY(s, thud_world_cast_ray_all(s->world, &(thud_ray){w.from, w.dx, w.dy, FILTER(w)}, out,
                                   w.capacity, &count));
    check_all(s, &w, out, count);
}

void play_cast_shape(fuzz_session *s) {
    way w = pick_way(s);
    thud_geometry shape = pick_centred_geometry(s);
    FIRST(s, shape);
}

void play_cast_shape_all(fuzz_session *s) {
    way w = pick_way(s);
    thud_geometry shape = pick_centred_geometry(s);
    ALL(s, shape);
}

void play_cast_circle(fuzz_session *s) {
    way w = pick_way(s);
    double radius = (double)pick_size(s);
    FIRST(s, thud_circle_at(0, 0, radius));
}

void play_cast_circle_all(fuzz_session *s) {
    way w = pick_way(s);
    double radius = (double)pick_size(s);
    ALL(s, thud_circle_at(0, 0, radius));
}

/* A turned box about the origin. It is made before the call: TRY calls in the floating-point mode
 * of the session, in which the last bits of sine and cosine would differ. */
static thud_geometry box_of(thud_vec2 half, double angle) {
    return thud_obb_at(0, 0, widened(half.x), widened(half.y), angle);
}

void play_cast_box(fuzz_session *s) {
    way w = pick_way(s);
    thud_vec2 half = pick_sizes(s);
    thud_geometry box = box_of(half, pick_angle(s));
    FIRST(s, box);
}

void play_cast_box_all(fuzz_session *s) {
    way w = pick_way(s);
    thud_vec2 half = pick_sizes(s);
    thud_geometry box = box_of(half, pick_angle(s));
    ALL(s, box);
}

/* ---- overlaps, and the closest ---- */

void play_overlap_shape(fuzz_session *s) {
    way w = pick_way(s);
    thud_geometry shape = pick_centred_geometry(s);
    TRY(s, thud_world_overlap_shape(s->world, w.from, shape, FILTER(w), session_overlap, s));
}

void play_overlap_circle(fuzz_session *s) {
    way w = pick_way(s);
    double radius = (double)pick_size(s);
    TRY(s, thud_world_overlap_shape(s->world, w.from, thud_circle_at(0, 0, radius), FILTER(w),
                                    session_overlap, s));
}

void play_overlap_aabb(fuzz_session *s) {
    way w = pick_way(s);
    thud_pos upper = pick_place(s);
    TRY(s, thud_world_overlap_aabb(s->world, w.from, upper, FILTER(w), session_overlap, s));
}

void play_overlap_obb(fuzz_session *s) {
    way w = pick_way(s);
    thud_vec2 half = pick_sizes(s);
    thud_geometry box = box_of(half, pick_angle(s));
    TRY(s, thud_world_overlap_shape(s->world, w.from, box, FILTER(w), session_overlap, s));
}

void play_closest(fuzz_session *s) {
    way w = pick_way(s);
    double most = fabs(w.dx);
    bool found = false;
    thud_closest_hit out;
    memset(&out, CALL_FILL, sizeof out);
    TRY(s, thud_world_closest(s->world, w.from, most, FILTER(w), &found, &out));
    if (s->result != THUD_OK || !found) {
        call_untouched(s, &out, sizeof out);
        return;
    }
    note_bits(s, out.shape.index1);
    note_place(s, out.point);
    note_vector(s, out.normal);
    note_number(s, out.distance);
    if (!(out.distance <= most) || !COUNTED(thud_shape_is_valid(s->world, out.shape))) {
        fuzz_fail(s, "the closest shape, %u, is at %g", out.shape.index1, out.distance);
    }
}

/* ---- casts with a callback for each hit, and many casts in one call ---- */

void play_ray_each(fuzz_session *s) {
    way w = pick_way(s);
    TRY(s, thud_world_cast_ray_each(s->world, &(thud_ray){w.from, w.dx, w.dy, FILTER(w)},
                                    session_cast, s));
}

void play_cast_each(fuzz_session *s) {
    way w = pick_way(s);
    thud_geometry shape = pick_centred_geometry(s);
    TRY(s, thud_world_cast_shape_each(s->world,
                                      &(thud_shape_cast){w.from, shape, w.dx, w.dy, FILTER(w)},
                                      session_cast, s));
}

static void check_many(fuzz_session *s, const thud_ray_hit *hits, int count) {
    if (s->result != THUD_OK) {
        call_untouched(s, hits, (size_t)(count > 0 ? count : 0) * sizeof *hits);
        return;
    }
    for (int i = 0; i < count; i++) {
        if (hits[i].shape.index1) {
            check_hit(s, &hits[i]);
        } else if (hits[i].fraction != 1) {
            fuzz_fail(s, "cast %d meets nothing at %g", i, hits[i].fraction);
        }
    }
}

/* A number of casts in one call, at most MANY; may be negative. */
static int pick_many(fuzz_session *s) {
    int count = next_count(&s->bytes, MANY);
    return count > MANY ? 0 : count;
}

/* Many rays from one point in different directions. */
void play_rays(fuzz_session *s) {
    way w = pick_way(s);
    int count = pick_many(s);
    thud_ray rays[MANY];
    thud_ray_hit hits[MANY];
    for (int i = 0; i < MANY; i++) {
        double part = 0.125 * (i % 17 - 8);
        rays[i] = (thud_ray){w.from, w.dx * part, w.dy * (1 - part), FILTER(w)};
    }
    memset(hits, CALL_FILL, sizeof hits);
    TRY(s, thud_world_cast_rays(s->world, rays, count, hits));
    check_many(s, hits, count);
}

void play_casts(fuzz_session *s) {
    way w = pick_way(s);
    int count = pick_many(s);
    thud_geometry shapes[2] = {pick_centred_geometry(s), pick_centred_geometry(s)};
    thud_shape_cast casts[MANY];
    thud_ray_hit hits[MANY];
    for (int i = 0; i < MANY; i++) {
        double part = 0.125 * (i % 17 - 8);
        casts[i] =
            (thud_shape_cast){w.from, shapes[i % 2], w.dx * part, w.dy * (1 - part), FILTER(w)};
    }
    memset(hits, CALL_FILL, sizeof hits);
    TRY(s, thud_world_cast_shapes(s->world, casts, count, hits));
    check_many(s, hits, count);
}

/* ---- queries of one shape ---- */

void play_meets_ray(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    way w = pick_way(s);
    thud_ray_hit out;
    bool hit = false;
    memset(&out, CALL_FILL, sizeof out);
    TRY(s, thud_shape_cast_ray(s->world, shape, w.from, w.dx, w.dy, &hit, &out));
    check_first(s, hit, &out);
}

void play_shape_point(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    thud_pos at = pick_place(s);
    bool inside = false;
    thud_closest_hit out;
    memset(&out, CALL_FILL, sizeof out);
    TRY(s, thud_shape_contains_point(s->world, shape, at, &inside));
    note_bits(s, inside);
    TRY(s, thud_shape_closest_point(s->world, shape, at, &out));
    if (s->result != THUD_OK) {
        call_untouched(s, &out, sizeof out);
        return;
    }
    note_place(s, out.point);
    note_vector(s, out.normal);
    note_number(s, out.distance);
    if (inside != (out.distance <= 0)) {
        fuzz_fail(s, "a point is %s at the distance %g", inside ? "inside" : "outside",
                  out.distance);
    }
}

void play_shape_bounds(fuzz_session *s) {
    thud_shape_id shape = pick_shape(s);
    thud_pos box[2];
    memset(box, CALL_FILL, sizeof box);
    TRY(s, thud_shape_get_bounds(s->world, shape, &box[0], &box[1]));
    if (s->result != THUD_OK) {
        call_untouched(s, box, sizeof box);
        return;
    }
    note_place(s, box[0]);
    note_place(s, box[1]);
    if (!(box[0].x < box[1].x && box[0].y <= box[1].y)) {
        fuzz_fail(s, "bounds from %g %g to %g %g", box[0].x, box[0].y, box[1].x, box[1].y);
    }
}

/* ---- poses to come ---- */

/* Checks where a body will be after at most `seconds`, and adds it to the digest. */
static void check_prediction(fuzz_session *s, const thud_prediction *p, double seconds) {
    note_bits(s, p->body.index1);
    note_place(s, p->position);
    note_number(s, p->angle);
    note_vector(s, p->velocity);
    note_number(s, (double)p->angular_velocity);
    note_number(s, p->seconds);
    note_bits(s, p->met.index1);
    bool met = p->met.index1 > 0;
    if (!(p->seconds >= 0 && p->seconds <= seconds) || (!met && p->seconds < seconds) ||
        (met && !COUNTED(thud_shape_is_valid(s->world, p->met)))) {
        fuzz_fail(s, "%s: after %g of %g s it meets %u", s->calls[s->depth].text, p->seconds,
                  seconds, p->met.index1);
    }
}

void play_prediction(fuzz_session *s) {
    thud_body_id bodies[2] = {pick_body(s), pick_body(s)};
    unsigned byte = next_byte(&s->bytes);
    double seconds = byte == 255 ? NAN : (byte - 4) / 16.0;
    int count = byte % 16 == 15 ? -1 : (int)(byte % 3), all = -7;
    thud_prediction free[2], stopped[2], awake[ROOM];
    memset(free, CALL_FILL, sizeof free);
    memset(stopped, CALL_FILL, sizeof stopped);
    TRY(s, thud_world_extrapolate(s->world, bodies, count, seconds, free));
    thud_result result = s->result;
    TRY(s, thud_world_predict(s->world, bodies, count, seconds, stopped));
    for (int i = 0; i < count && s->result == THUD_OK && result == THUD_OK; i++) {
        check_prediction(s, &free[i], seconds);
        check_prediction(s, &stopped[i], seconds);
    }
    if (s->result != THUD_OK) {
        call_untouched(s, stopped, sizeof stopped);
    }
    TRY(s, thud_world_extrapolate_awake(s->world, seconds, awake, byte & 1 ? ROOM : 0, &all));
    for (int i = 0; i < all && i < (byte & 1 ? ROOM : 0) && s->result == THUD_OK; i++) {
        check_prediction(s, &awake[i], seconds);
    }
}
