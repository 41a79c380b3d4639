/* thud_fields.h: forces on bodies from what is around them: an explosion, wind, water, and the
 * ground that a ball rolls on or a tyre grips. All are closed forms over circles, AABBs and OBBs;
 * sensors take no part. A program that uses none of this does not link it.
 *
 * Wind, water and rolling resistance are asked for body by body before each step, and act through
 * that step, as forces do (thud_forces.h); with thud_world_advance, in thud_step_calls.before. They
 * wake nobody: a sleeping, disabled or quarantined body is left alone, and one that is at rest in
 * the water falls asleep there. Who wants a rising wind to wake a body does so by
 * thud_body_set_awake. Inside a callback they are THUD_ERROR_LOCKED. Where a body has several
 * shapes, each counts as if it stood alone.
 *
 * What brakes never adds to the energy of the motion against the air, water or ground, however long
 * the time step: of the step's push so much is given as takes the most of that energy, and the rest
 * is left.
 *
 * All return THUD_ERROR_NULL for a null pointer where none is allowed, THUD_ERROR_STALE,
 * THUD_ERROR_INVALID for a value that is not finite or beyond its range, for a body that is not
 * dynamic, and where a push would be beyond THUD_PUSH_MAX; then nothing has changed. */
#ifndef THUD_FIELDS_H
#define THUD_FIELDS_H

#include "thud.h"
#include "thud_forces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- explosions ---- */

/* What hides a shape from an explosion; sensors never do, nor does a body hide itself. */
typedef enum thud_cover {
    THUD_COVER_NONE = 0, /* nothing */
    THUD_COVER_STATIC,   /* static and kinematic bodies, terrain */
    THUD_COVER_ALL       /* every other body */
} thud_cover;

typedef struct thud_explosion {
    thud_pos center;  /* |x|, |y| <= THUD_PLACE_MAX length scales */
    double radius;    /* length, [0, THUD_PLACE_MAX length scales]; default 0; up to here all of it
                         arrives */
    double falloff;   /* length, [0, THUD_PLACE_MAX length scales]; default 0: over so much more it
                         falls to nothing, linearly. One of the two must be above 0 */
    float impulse;    /* mass/s: for each length of a shape across the way from the centre; |.| <=
                         THUD_EXPLOSION_MAX, below 0 it draws in; default 1 */
    thud_cover cover; /* default THUD_COVER_ALL */
    int rays;         /* for each shape, [1, THUD_EXPLOSION_RAYS_MAX]; default 5 */
    thud_query_filter filter; /* who is pushed; sensors never are. Who is to be ignored neither
                                 hides anything. Default everybody */
    uint32_t cookie;          /* of thud_default_explosion */
} thud_explosion;

THUD_API thud_explosion thud_default_explosion(void);

/* Pushes the dynamic bodies about the centre away from it, at once; inside a callback through the
 * next step, as impulses (thud_forces.h) are, and with THUD_ERROR_MEMORY where those give it.
 * *pushed, which may be null, is how many bodies got something. Sleeping bodies wake.
 *
 * The side of a shape that faces the centre is cut into `rays` pieces, as wide as each other across
 * the way from the centre to the nearest point; what is farther across than the explosion reaches
 * is left out. Each piece gets its part of the impulse in its middle, away from the centre, unless
 * something stands between the two: so cover is partial. A shape that has the centre in it gets all
 * of it, in its own middle. What the centre is in hides nothing: explode a little off a wall, by
 * the normal of the hit. */
THUD_API thud_result thud_world_explode(thud_world *world, const thud_explosion *explosion,
                                        int *pushed);

/* ---- wind ---- */

/* Air of this velocity (length/s, |x|, |y| <= THUD_FLOW_MAX length scales) and density
 * (mass/length^2, [0, THUD_FLUID_DENSITY_MAX]) flows about the body; drag and lift are in [0,
 * THUD_DRAG_MAX], about 1 for plates.
 *
 * With u the velocity of a place of the body against the air: each edge of a box that goes into the
 * wind is pushed by density / 2 * drag * |u| times its length across u, against u, and by
 * density / 2 * lift * |u| times that, across u, as far as the edge slants. The sum over the edge,
 * turning included, is exact for drag, and for lift of two points. A circle counts with its
 * diameter, in its middle; its lift is that of its spin (Magnus). Lift takes no energy, so without
 * drag there is none to give, and none is given. */
THUD_API thud_result thud_body_apply_wind(thud_world *world, thud_body_id body, thud_vec2 wind,
                                          float density, float drag, float lift);

/* ---- water ---- */

typedef struct thud_water {
    thud_pos point;     /* on the water line; |x|, |y| <= THUD_PLACE_MAX length scales;
                           default (0, 0) */
    thud_vec2 normal;   /* out of the water; of length 1 within THUD_NORMAL_ERROR; default (0, 1) */
    float density;      /* mass/length^2, [0, THUD_FLUID_DENSITY_MAX]; default 1 */
    thud_vec2 flow;     /* length/s, |x|, |y| <= THUD_FLOW_MAX length scales; default (0, 0) */
    float linear_drag;  /* 1/s, [0, THUD_DRAG_MAX]; default 2: the part below the line is braked
                           by so much of the momentum of the water in whose place it is */
    float angular_drag; /* 1/s, [0, THUD_DRAG_MAX]; default 2: ... of its spin, as of a disc of that
                           area */
    uint32_t cookie;    /* of thud_default_water */
} thud_water;

THUD_API thud_water thud_default_water(void);

/* Lifts the body by the weight of the water in whose place it is, by the world's gravity, at the
 * middle of the part that is below the line; so it floats at the draught that the densities say.
 * That part is the one of half a time step later at the velocity now, by which what bobs never
 * gains height. A body whose draught is below gravity * time_step^2 bobs all the same. */
THUD_API thud_result thud_body_apply_buoyancy(thud_world *world, thud_body_id body,
                                              const thud_water *water);

/* Area and centroid of the part of a shape below the line through (x, y), |x|, |y| <=
 * THUD_COORDINATE_MAX, whose normal (nx, ny) has length 1 within THUD_NORMAL_ERROR; pure. The
 * centroid is the shape's own centre where there is no such part. No output may be null. Exact to
 * 1e-15 of the shape's size, squared for the area; the centroid of a circle's part, which is so
 * thin that its area drowns in that, lies within the part.
 */
THUD_API thud_result thud_shape_below(const thud_shape_instance *shape, double x, double y,
                                      double nx, double ny, double *area, double *center_x,
                                      double *center_y);

/* ---- rolling resistance ---- */

/* Brakes the turning of a body against what its circles touch, as grass does a ball: by a torque of
 * coefficient * radius * normal force of the last step. The coefficient, in [0, THUD_DRAG_MAX], is
 * a slope: a disc that rolls is slowed by 2/3 of it, times gravity. At most the turning stops; what
 * is touched is not turned. On a slope a ball is slowed, not held. THUD_ERROR_MEMORY as queries. */
THUD_API thud_result thud_body_apply_rolling_resistance(thud_world *world, thud_body_id body,
                                                        float coefficient);

/* ---- tyres, and the ground under who is seen from above ---- */

/* Brings a point of a body, in the body's frame from its origin, to a speed along an axis, of any
 * length but 0 and likewise in the body's frame, by a force along it of at most `most`, in [0,
 * THUD_PUSH_MAX]: at speed 0 it holds, as a tyre grips across its way and a table brakes what
 * slides; at another it drives, as a motor. |speed| <= THUD_FLOW_MAX length scales a second; |x|,
 * |y| of the point <= THUD_SIZE_MAX length scales.
 *
 * It counts what gravity and the forces so far will give the point, and takes the mass that the
 * body shows there: so the step ends at that speed, or on the way to it, and never beyond; at 0 it
 * adds nothing to the energy that the step would have without it. */
THUD_API thud_result thud_body_apply_grip(thud_world *world, thud_body_id body, thud_vec2 point,
                                          thud_vec2 axis, float speed, float most);

#ifdef __cplusplus
}
#endif

#endif
