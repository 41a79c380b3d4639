/* thud_fields.h: forces that depend on a body's shapes, position or motion: explosions, wind,
 * water, rolling resistance and grip. All are computed in closed form over circles, AABBs and OBBs;
 * sensors are left out. A program that does not use this header does not link it.
 *
 * Wind, water, rolling resistance and grip are applied to one body by one call, before each step,
 * and act during that step, as forces do (thud_forces.h); with thud_world_advance, call them in
 * thud_step_calls.before. They do not wake bodies: they have no effect on a sleeping, disabled or
 * quarantined body, and a body at rest in the water falls asleep there. To wake a body by a rising
 * wind call thud_body_set_awake. Inside a callback they are THUD_ERROR_LOCKED. The force on each
 * shape is computed as if the body had no other shapes.
 *
 * A braking force never adds energy to the motion relative to air, water or ground, however long
 * the time step is: the force of a step is reduced to the one that removes the most of this energy.
 *
 * All return THUD_ERROR_NULL for a null pointer where none is allowed, THUD_ERROR_STALE,
 * THUD_ERROR_INVALID for a value that is not finite or out of range, for a body that is not
 * dynamic, and if a force would be larger than THUD_FORCE_MAX; then nothing has changed. */
#ifndef THUD_FIELDS_H
#define THUD_FIELDS_H

#include "thud.h"
#include "thud_forces.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- explosions ---- */

/* Which bodies shield a shape from an explosion. Sensors do not, and a body does not shield its own
 * shapes. */
typedef enum thud_cover {
    THUD_COVER_NONE = 0, /* none */
    THUD_COVER_STATIC,   /* static and kinematic bodies, terrain */
    THUD_COVER_ALL       /* every other body */
} thud_cover;

/* What thud_world_explode does. */
typedef struct thud_explosion {
    thud_pos center; /* |x|, |y| <= THUD_PLACE_MAX length scales */
    double radius; /* length, [0, THUD_PLACE_MAX length scales]; default 0. Within it the impulse is
                      constant */
    double falloff;   /* length, [0, THUD_PLACE_MAX length scales]; default 0. Over this distance
                         beyond the radius the impulse falls linearly to 0. Radius and falloff must
                         not both be 0 */
    float impulse;    /* impulse per length of a shape, measured at a right angle to the direction
                         from the centre: mass/s, |.| <= THUD_EXPLOSION_MAX; negative: towards the
                         centre; default 1 */
    thud_cover cover; /* default THUD_COVER_ALL */
    int rays;         /* rays to each shape, [1, THUD_EXPLOSION_RAYS_MAX]; default 5 */
    thud_query_filter filter; /* which shapes are pushed; sensors never are. The body `ignore` also
                                 does not shield others. Default all */
    uint32_t cookie;          /* set by thud_default_explosion */
} thud_explosion;

/* An explosion with the defaults. */
THUD_API thud_explosion thud_default_explosion(void);

/* Applies impulses to the dynamic bodies around the centre, away from it, at once. Inside a
 * callback they act during the next step, as other impulses do (thud_forces.h). THUD_ERROR_MEMORY,
 * inside a callback or not. *out_pushed (may be null): the number of bodies that got an
 * impulse. Sleeping bodies wake.
 *
 * The side of a shape that faces the centre is divided into `rays` pieces of equal width, measured
 * at a right angle to the direction from the centre to the shape's nearest point; parts beyond the
 * reach of the explosion are left out. Each piece gets its share of the impulse at its middle, away
 * from the centre, unless a shape lies between the centre and this point: a shape may be partly
 * shielded. A shape that contains the centre gets the whole impulse, at its own centre, and shields
 * no other: so place an explosion at a wall a little outside of it, along the normal of the hit. */
THUD_API thud_result thud_world_explode(thud_world *world, const thud_explosion *explosion,
                                        int *out_pushed);

/* ---- wind ---- */

/* Drag and lift of air that moves at the velocity `wind` (length/s, |x|, |y| <= THUD_FLOW_MAX
 * length scales a second) and has this density (mass/length^2, [0, THUD_FLUID_DENSITY_MAX]). The
 * coefficients drag and lift are in [0, THUD_DRAG_MAX], and about 1 for plates.
 *
 * With u the velocity of a point of the body relative to the air, each edge of a box that faces the
 * flow gets
 *
 *     drag  -density / 2 * drag * |u| * L * u
 *     lift  -density / 2 * lift * |u|^2 * L * p
 *
 * where L is the length of the edge measured at a right angle to u, and p the component of the
 * edge's unit outward normal at a right angle to u. The integral over an edge of a rotating body is
 * exact for drag, and by two-point quadrature for lift. A circle counts as an edge as long as its
 * diameter, through its centre; its lift comes from its rotation (Magnus effect). Lift does no
 * work, and is limited by the energy that drag removes: without drag there is no lift. */
THUD_API thud_result thud_body_apply_wind(thud_world *world, thud_body_id body, thud_vec2 wind,
                                          float density, float drag, float lift);

/* ---- water ---- */

/* Water below a straight line. */
typedef struct thud_water {
    thud_pos point;    /* a point of the water line, |x|, |y| <= THUD_PLACE_MAX length scales;
                          default (0, 0) */
    thud_vec2 normal;  /* out of the water, of length 1 within THUD_NORMAL_ERROR; default (0, 1) */
    float density;     /* mass/length^2, [0, THUD_FLUID_DENSITY_MAX]; default 1 */
    thud_vec2 flow;    /* velocity of the water, length/s, |x|, |y| <= THUD_FLOW_MAX length scales a
                          second; default (0, 0) */
    float linear_drag; /* 1/s, [0, THUD_DRAG_MAX]; default 2. The drag force is this, times the mass
                          of the displaced water, times the velocity relative to the water */
    float angular_drag; /* 1/s, [0, THUD_DRAG_MAX]; default 2. The same for rotation, with the
                           moment of inertia of a disc of the submerged area */
    uint32_t cookie;    /* set by thud_default_water */
} thud_water;

/* Water with the defaults. */
THUD_API thud_water thud_default_water(void);

/* Buoyancy and drag of a body in water. The buoyancy is the weight of the displaced water, by the
 * world's gravity, and acts at the centroid of the part below the water line: the body floats at
 * the depth that follows from the densities. The submerged part is computed for the pose half a
 * time step later at the present velocity, so that a bobbing body does not gain height. A body that
 * floats at a depth of less than gravity * time_step^2 keeps bobbing. */
THUD_API thud_result thud_body_apply_buoyancy(thud_world *world, thud_body_id body,
                                              const thud_water *water);

/* The half plane below the line through (x, y), |x|, |y| <= THUD_COORDINATE_MAX, whose normal
 * (nx, ny) points out of it and has length 1 within THUD_NORMAL_ERROR. */
typedef struct thud_half_plane {
    double x, y, nx, ny;
} thud_half_plane;

/* Area and centroid of the part of a shape in the half plane. A pure function. If the part is
 * empty, the centroid is the shape's centre. No output may be null. Exact to 1e-15 of the shape's
 * size, or of its square for the area; if a circle's part is so thin that its area is smaller than
 * that, the centroid is some point of the part. */
THUD_API thud_result thud_geometry_area_below(const thud_geometry *shape, thud_half_plane below,
                                              double *out_area, double *out_center_x,
                                              double *out_center_y);

/* ---- rolling resistance ---- */

/* Rolling resistance of the circles of a body, such as a ball on grass: a torque of coefficient *
 * radius * (normal force of the last step) against the rotation relative to the bodies that the
 * circles touch. The coefficient is in [0, THUD_DRAG_MAX]; on level ground it decelerates a rolling
 * disc by 2/3 * coefficient * gravity. The torque at most stops the rotation, and does not act on
 * the other body. On a slope it slows a ball down, but does not hold it. */
THUD_API thud_result thud_body_apply_rolling_resistance(thud_world *world, thud_body_id body,
                                                        float coefficient);

/* ---- grip: tyres, and friction in games seen from above ---- */

/* Drives a point of a body towards a speed along an axis, by a force along the axis of at most
 * `max_force`, in [0, THUD_FORCE_MAX]. Point and axis are in the body's frame; the axis has any
 * length but 0. At speed 0 the force brakes, like a tyre sideways or a table under a sliding piece;
 * at another speed it drives, like a motor. |speed| <= THUD_FLOW_MAX length scales a second; |x|,
 * |y| of the point <= THUD_SIZE_MAX length scales.
 *
 * The force accounts for the velocity that gravity and the forces applied so far will give the
 * point in the step, and for the effective mass of the body at the point. If no contact, joint,
 * damping or later force acts on the body, the point has reached the speed at the end of the step,
 * or is nearer to it, but never beyond it. At speed 0 the force
 * adds no energy. */
THUD_API thud_result thud_body_apply_grip(thud_world *world, thud_body_id body, thud_vec2 point,
                                          thud_vec2 axis, float speed, float max_force);

#ifdef __cplusplus
}
#endif

#endif
