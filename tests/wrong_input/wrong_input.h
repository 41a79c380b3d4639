/* wrong_input.h: helpers for calls that must be refused. Each call is made in one of two equal
 * villages (village.h). Afterwards, and in the following steps, both must still be equal, outputs
 * must be unchanged, and the log of a world must have got the reason. */
#ifndef WRONG_INPUT_H
#define WRONG_INPUT_H

#include "village.h"

#include <thud/thud_draw.h>
#include <thud/thud_minkowski.h>

typedef struct wrong_pair {
    village here, twin; /* calls are made in `here` */
    village other;      /* a world whose handles are foreign to `here` */
    int refused;        /* number of calls so far */
    int complaints;     /* number of calls that were not refused correctly */
} wrong_pair;

/* Outputs of the calls, filled with a pattern that no call writes. */
typedef struct wrong_outputs {
    thud_body_id body;
    thud_shape_id shape;
    thud_body_state body_state;
    thud_shape_state shape_state;
    thud_shape_id shapes[4];
    thud_terrain terrain;
    thud_ray_hit hit, hits[4];
    thud_closest_hit closest_hit;
    thud_volume volume;
    thud_mover_report report;
    thud_minkowski sum;
    thud_closest closest;
    thud_contacts contacts;
    thud_approach approach;
    thud_terrain_sample sample;
    thud_foot foot;
    thud_uv uv;
    double number, nx, ny;
    int count;
    unsigned char flag; /* a bool that is filled with the pattern */
    thud_world *world;
} wrong_outputs;

extern wrong_outputs wrong_out;
#define OUT_FLAG ((bool *)&wrong_out.flag)

extern int wrong_total; /* refused calls of all tables */

int wrong_setup(void **state);
int wrong_teardown(void **state);

/* Checks a refused call; `told`: number of messages that the log of `here` must have got. */
void wrong_check(wrong_pair *p, thud_result got, thud_result wanted, int told, const char *call,
                 const char *file, int line);

#define REFUSED(wanted, call) \
    wrong_check(p, (call), THUD_ERROR_##wanted, 1, #call, __FILE__, __LINE__)
/* For calls without a world, which has the log. */
#define REFUSED_UNTOLD(wanted, call) \
    wrong_check(p, (call), THUD_ERROR_##wanted, 0, #call, __FILE__, __LINE__)

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const double not_finite[] = {NAN, INFINITY, -INFINITY};
static const double not_a_place[] = {NAN, INFINITY, -INFINITY, 1.0000001e9, -1e10, 1e300};
static const double not_an_angle[] = {NAN, INFINITY, -INFINITY, 1.1e6, -1e300};
static const double not_a_size[] = {NAN, INFINITY, -INFINITY, 0,     -0.0,
                                    -1,  9e-5,     5e-324,    16385, 3e38};

/* Loop over the values x of a list. */
#define EACH(x, list)                                    \
    for (int x##_at = 0; x##_at < COUNT(list); x##_at++) \
        for (double x = (list)[x##_at], *x##_once = &x; x##_once; x##_once = NULL)

/* The tables; each is a cmocka test. */
void wrong_worlds(void **state);
void wrong_settings(void **state);
void wrong_bodies(void **state);
void wrong_body_edits(void **state);
void wrong_shapes(void **state);
void wrong_terrains(void **state);
void wrong_terrain_edits(void **state);
void wrong_handles(void **state);
void wrong_rays_and_casts(void **state);
void wrong_overlaps_and_closest(void **state);
void wrong_casts_hit_by_hit(void **state);
void wrong_many_casts(void **state);
void wrong_questions_to_a_shape(void **state);
void wrong_explosions(void **state);
void wrong_fields(void **state);
void wrong_movers(void **state);
void wrong_drawings(void **state);
void wrong_geometry(void **state);
void wrong_ground_geometry(void **state);
void wrong_volumes(void **state);
void wrong_sums(void **state);

#endif
