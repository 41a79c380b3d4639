/* operations_lines.c: functions of terrain lines without a world. A line that thud_terrain_check
 * refuses may give results without a meaning, but must not make a function crash or read out of
 * bounds. */
#include "operations.h"

typedef struct ground {
    thud_pos points[PICK_POINTS];
    thud_terrain line;
    bool valid;
} ground;

/* With such lines the memory sanitizer reports branches on values that were never written; under it
 * they are left out. */
#if defined(__has_feature)
#if __has_feature(memory_sanitizer)
#define ONLY_VALID
#endif
#endif

/* A line from the fuzzer's bytes, and whether it is valid. */
static void pick_ground(fuzz_session *s, ground *g) {
    g->line = pick_line(s, g->points);
    g->valid = COUNTED(thud_terrain_check(&g->line)) == THUD_OK;
#ifdef ONLY_VALID
    if (!g->valid) {
        g->line = (thud_terrain){.kind = THUD_TERRAIN_FLAT};
        g->valid = true;
    }
#endif
}

/* Fails if a valid line gives a normal whose length is not 1. */
static void normal_of(fuzz_session *s, const ground *g, double nx, double ny) {
    if (g->valid && !(fabs(nx * nx + ny * ny - 1) < 1e-6)) {
        fuzz_fail(s, "%s: the normal %g %g", s->calls[s->depth].text, nx, ny);
    }
}

/* Fails if a valid line gives a value that is not finite. */
static void finite_of(fuzz_session *s, const ground *g, double value) {
    if (g->valid && !isfinite(value)) {
        fuzz_fail(s, "%s: %g", s->calls[s->depth].text, value);
    }
}

void play_line_sample(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    double x = pick_coordinate(s), to = x + (double)pick_size(s);
    thud_terrain_sample sample;
    PURE(s, sample, thud_terrain_sample_at(&g.line, x, &sample));
    if (s->result == THUD_OK) {
        finite_of(s, &g, sample.height);
        normal_of(s, &g, sample.nx, sample.ny);
        thud_uv corners[PICK_POINTS] = {{0, 0}, {1, 0}}, uv;
        int count = next_count(&s->bytes, PICK_POINTS);
        count = count > PICK_POINTS ? 0 : count;
        PURE(s, uv, thud_terrain_texture_at(&sample, corners, count, &uv));
        if (s->result == THUD_OK) {
            finite_of(s, &g, uv.u);
            finite_of(s, &g, uv.v);
        }
    }
    int first = 0, last = -1;
    COUNTED(thud_terrain_segments(&g.line, x, to, &first, &last));
    if (g.valid && first <= last && g.line.kind != THUD_TERRAIN_FLAT &&
        (first < 0 || last > g.line.count - 2)) {
        fuzz_fail(s, "segments %d to %d of %d points", first, last, g.line.count);
    }
}

void play_line_shape(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    thud_geometry shape = pick_geometry(s);
    double margin = fabs(pick_coordinate(s)) / 4;
    thud_closest closest;
    thud_contacts contacts;
    bool overlap = COUNTED(thud_terrain_overlap(&g.line, &shape));
    PURE(s, closest, thud_terrain_closest(&g.line, &shape, &closest));
    if (s->result == THUD_OK) {
        finite_of(s, &g, closest.distance + closest.ax + closest.ay + closest.bx + closest.by);
        normal_of(s, &g, closest.nx, closest.ny);
    } else if (overlap && g.valid) {
        fuzz_fail(s, "a shape that is none overlaps the ground");
    }
    PURE(s, contacts, thud_terrain_contacts(&g.line, &shape, margin, &contacts));
    if (s->result == THUD_OK) {
        for (int i = 0; i < contacts.count && i < 2; i++) {
            finite_of(s, &g, contacts.point[i].distance);
            normal_of(s, &g, contacts.point[i].nx, contacts.point[i].ny);
        }
    }
}

void play_line_impact(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    thud_geometry shape = pick_geometry(s);
    thud_motion motion = pick_motion(s);
    struct {
        bool hit;
        double time;
    } out;
    PURE(s, out, thud_terrain_time_of_impact(&g.line, &shape, motion, 0.001, &out.hit, &out.time));
    if (s->result == THUD_OK && g.valid && !(out.time >= 0 && out.time <= 1)) {
        fuzz_fail(s, "thud_terrain_time_of_impact: %g", out.time);
    }
    PURE(s, out,
         thud_terrain_time_of_collision(&g.line, &shape, motion, 1e-6, &out.hit, &out.time));
    if (s->result == THUD_OK && g.valid && !(out.time >= 0 && out.time <= 1)) {
        fuzz_fail(s, "thud_terrain_time_of_collision: %g", out.time);
    }
}

void play_line_ray(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    thud_pos from = {pick_coordinate(s), pick_coordinate(s)};
    thud_pos along = {pick_coordinate(s), pick_coordinate(s)};
    double at, nx, ny;
    s->calls[s->depth].text = "thud_terrain_cast_ray";
    if (COUNTED(thud_terrain_cast_ray(&g.line, (thud_segment){from.x, from.y, along.x, along.y},
                                      &at, &nx, &ny))) {
        normal_of(s, &g, nx, ny);
        if (g.valid && !(at >= 0 && at <= 1)) {
            fuzz_fail(s, "thud_terrain_cast_ray: %g", at);
        }
    }
}

void play_foot(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    double x = pick_coordinate(s), width = (double)pick_size(s);
    thud_foot foot;
    PURE(s, foot, thud_terrain_place_foot(&g.line, x, width, &foot));
    if (s->result == THUD_OK) {
        finite_of(s, &g, foot.height);
        finite_of(s, &g, foot.x);
        normal_of(s, &g, foot.nx, foot.ny);
    }
}

void play_line_capsule(fuzz_session *s) {
    ground g;
    pick_ground(s, &g);
    thud_capsule capsule = pick_capsule(s);
    thud_motion motion = pick_motion(s);
    motion.turn = 0;
    thud_closest closest;
    struct {
        bool hit;
        double time;
    } impact;
    PURE(s, closest, thud_terrain_capsule_closest(&g.line, &capsule, &closest));
    if (s->result == THUD_OK) {
        finite_of(s, &g, closest.distance);
        normal_of(s, &g, closest.nx, closest.ny);
    }
    PURE(s, impact,
         thud_terrain_capsule_time_of_impact(&g.line, &capsule, motion, 0, &impact.hit,
                                             &impact.time));
    if (s->result == THUD_OK && g.valid && !(impact.time >= 0 && impact.time <= 1)) {
        fuzz_fail(s, "a capsule meets the line at %g", impact.time);
    }
}
