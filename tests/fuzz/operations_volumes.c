/* operations_volumes.c: functions of bounding volumes. */
#include "operations.h"

static thud_shape_kind pick_kind(fuzz_session *s) {
    return (thud_shape_kind)next_choice(&s->bytes, s->bytes.hostile ? 4 : 3);
}

static void check_volume(fuzz_session *s, const thud_volume *volume) {
    if (s->result == THUD_OK && COUNTED(thud_volume_check(volume)) != THUD_OK) {
        fuzz_fail(s, "%s: a volume that is none", s->calls[s->depth].text);
    }
}

/* A volume around a shape must contain it. */
static void check_around(fuzz_session *s, const thud_volume *volume, const thud_volume *inner) {
    bool inside;
    if (s->result == THUD_OK) {
        check_volume(s, volume);
        PURE(s, inside, thud_volume_contains(volume, inner, &inside));
        if (s->result != THUD_OK || !inside) {
            fuzz_fail(s, "a volume does not contain what it is around");
        }
    }
}

void play_volume_fit(fuzz_session *s) {
    thud_shape_kind kind = pick_kind(s);
    thud_geometry shape = pick_geometry(s);
    thud_motion motion = pick_motion(s);
    thud_volume volume;
    PURE(s, volume, thud_volume_around_shape(kind, &shape, &volume));
    check_around(s, &volume, &shape);
    PURE(s, volume, thud_volume_around_motion(kind, &shape, motion, &volume));
    check_around(s, &volume, &shape);
    thud_pos points[PICK_POINTS];
    thud_terrain line = pick_line(s, points);
    double from = pick_coordinate(s), to = from + 4 * (double)pick_size(s);
    PURE(s, volume, thud_volume_around_terrain(kind, &line, from, to, &volume));
    check_volume(s, &volume);
}

void play_volume_points(fuzz_session *s) {
    thud_shape_kind kind = pick_kind(s);
    thud_pos points[PICK_POINTS];
    thud_volume volume;
    int count = next_count(&s->bytes, PICK_POINTS);
    count = count > PICK_POINTS ? -1 : count;
    for (int i = 0; i < PICK_POINTS; i++) {
        points[i] = i < count ? (thud_pos){pick_coordinate(s), pick_coordinate(s)} : (thud_pos){0};
    }
    PURE(s, volume, thud_volume_around_points(kind, points, count, &volume));
    if (s->result != THUD_OK) {
        return;
    }
    check_volume(s, &volume);
    for (int i = 0; i < count; i++) {
        bool inside;
        PURE(s, inside, thud_volume_contains_point(&volume, points[i].x, points[i].y, &inside));
        if (s->result != THUD_OK || !inside) {
            fuzz_fail(s, "a volume does not contain point %d that it is around", i);
        }
    }
}

void play_volume_merge(fuzz_session *s) {
    thud_shape_kind kind = pick_kind(s);
    thud_volume a = pick_geometry(s), b = pick_geometry(s), both;
    PURE(s, both, thud_volume_merge(kind, &a, &b, &both));
    if (s->result == THUD_OK) {
        check_around(s, &both, &a);
        s->result = THUD_OK;
        check_around(s, &both, &b);
    }
}

void play_volume_tests(fuzz_session *s) {
    thud_volume a = pick_geometry(s), b = pick_geometry(s);
    bool overlap, other, inside;
    PURE(s, overlap, thud_volumes_overlap(&a, &b, &overlap));
    if (s->result != THUD_OK) {
        return;
    }
    PURE(s, other, thud_volumes_overlap(&b, &a, &other));
    if (s->result != THUD_OK || overlap != other) {
        fuzz_fail(s, "a overlaps b, and b not a");
    }
    PURE(s, inside, thud_volume_contains(&a, &b, &inside));
    if (s->result != THUD_OK || (inside && !overlap)) {
        fuzz_fail(s, "a volume holds another one, and they do not overlap");
    }
}
