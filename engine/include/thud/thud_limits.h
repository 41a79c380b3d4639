/* thud_limits.h: the ranges of all values. The comment of each field and argument names its limits.
 * Values equal to a limit are allowed; values beyond it and values that are not finite are
 * THUD_ERROR_INVALID. A value without a limit may be any finite number.
 *
 * "length scales": multiples of thud_world_def.length_scale, rounded down to a power of two. */
#ifndef THUD_LIMITS_H
#define THUD_LIMITS_H

/* ---- worlds ---- */

#define THUD_LENGTH_SCALE_MIN 1e-6f      /* thud_world_def.length_scale, length */
#define THUD_LENGTH_SCALE_MAX 1e6f       /* likewise */
#define THUD_TIME_STEP_MAX 1.0           /* s */
#define THUD_ADVANCE_MAX 1e9             /* s, `elapsed` of thud_world_advance */
#define THUD_AHEAD_MAX 60.0              /* s, how far ahead a pose is extrapolated or predicted */
#define THUD_TIME_BUDGET_MAX 1.0         /* s */
#define THUD_MAX_ERROR_MAX 1e9           /* length */
#define THUD_SPEED_MAX 1e6f              /* length scales a second, of the speeds in a world def */
#define THUD_SUBSTEPS_MAX 64             /* a step */
#define THUD_CONTACT_STIFFNESS_MIN 0.01f /* frequency divided by the substep rate */
#define THUD_CONTACT_STIFFNESS_MAX 0.5f  /* likewise */
#define THUD_CONTACT_DAMPING_MAX 100.0f  /* damping ratio */
#define THUD_ISLAND_LIMIT_MAX                                                                \
    16384 /* bodies; the search for an elimination order takes the square of this in bits of \
             memory */
#define THUD_ISLAND_SLOW_STEPS_MAX 1000 /* steps */
#define THUD_WORKERS_MAX 64             /* workers of a job system */

/* ---- bodies and shapes ---- */

#define THUD_PLACE_MAX 1e9 /* |x|, |y| of a place in the world, length scales */
#define THUD_ANGLE_MAX 1e6 /* |angle|, radians */
/* |radians| a second; a step clamps angular velocities to it, only so that values stay finite. */
#define THUD_ANGULAR_SPEED_MAX 1e8f
#define THUD_SIZE_MIN 1e-4f           /* radius or half extent, length scales */
#define THUD_SIZE_MAX 16384.0f        /* the same, and |x|, |y| of a shape in its body's frame */
#define THUD_STATIC_SIZE_MAX 32000.0f /* radius or half extent on a static body, length scales */
#define THUD_DENSITY_MAX 1e12f        /* mass/length^2; a larger value is probably in wrong units */
#define THUD_FRICTION_MAX 1e6f        /* coefficient */
#define THUD_RESTITUTION_MAX 1.0f     /* of a shape */
#define THUD_PAIR_RESTITUTION_MAX 4.0f /* of a pair, by a rule or a prologue */
#define THUD_SURFACE_SPEED_MAX 1e6f    /* |speed|, length scales a second */
#define THUD_MASS_MIN 1e-30f           /* thud_mass.mass, and its inertia unless that is 0 */
#define THUD_MASS_MAX 1e30f            /* likewise */

/* ---- forces and fields ---- */

/* Of the calls of thud_forces.h and thud_fields.h: |component| of a force, torque, impulse or
 * angular impulse, of the force into which an impulse is converted inside a callback, and of the
 * change of velocity by an impulse. */
#define THUD_FORCE_MAX 1e30f
#define THUD_DRAG_MAX \
    1e6f /* coefficients of drag, lift and rolling resistance; drag in water, 1/s */
#define THUD_FLOW_MAX 1e6f /* |component| of the velocity of wind and water, length scales/s */
#define THUD_FLUID_DENSITY_MAX 1e12f /* of air and water, mass/length^2 */
#define THUD_EXPLOSION_MAX 1e15f     /* |impulse| for each length, mass/s */
#define THUD_EXPLOSION_RAYS_MAX 16   /* rays for each shape */

/* ---- joints ---- */

#define THUD_JOINT_LENGTH_MAX 1e6f        /* length scales; of motors, length scales a second */
#define THUD_JOINT_ANGLE_MAX 3.1415927f   /* |radians| of limits and targets: pi as a float */
#define THUD_JOINT_ANGULAR_SPEED_MAX 1e6f /* |radians| a second, of motors */
#define THUD_JOINT_FREQUENCY_MAX 1e4f     /* Hz */
#define THUD_JOINT_DAMPING_MAX 1e3f       /* ratio */
#define THUD_JOINT_FORCE_MAX 1e30f        /* also torque */
#define THUD_GEAR_RATIO_MIN 1e-4f         /* |ratio| */
#define THUD_GEAR_RATIO_MAX 1e4f          /* likewise */

/* ---- movers ---- */

#define THUD_MOVER_SLOPE_MAX 1.55   /* radians */
#define THUD_MOVER_STEP_MAX 1e6     /* length, step_height and snap_distance */
#define THUD_MOVER_DISTANCE_MAX 1e6 /* length, |velocity| * dt of one move */
#define THUD_MOVER_FORCE_MAX 1e30   /* mass * length / s^2 */

/* ---- rollback ---- */

#define THUD_ROLLBACK_PLAYERS_MAX 64 /* players */
#define THUD_ROLLBACK_DEPTH_MAX 1000 /* steps */

/* ---- recordings ---- */

#define THUD_RECORDING_STEPS_MAX 1000000000 /* steps */

/* ---- geometry without a world, in the caller's own lengths ---- */

/* |x|, |y| and extents of shapes, points, and target distances: no two places in a world are
 * further apart, 2 * THUD_PLACE_MAX * THUD_LENGTH_SCALE_MAX. */
#define THUD_COORDINATE_MAX 2e15
#define THUD_VOLUME_MAX 1e16           /* the same of bounding volumes and Minkowski sums */
#define THUD_TOLERANCE_MIN 1e-15       /* of a time of collision, as a fraction of the motion */
#define THUD_POLYGON_PLACE_MAX 1e12    /* |x|, |y| of points */
#define THUD_POLYGON_POINTS_MAX 256    /* points */
#define THUD_POLYGON_AREA_MIN 1e-3     /* of the square of the larger of width and height */
#define THUD_APPROXIMATE_SHAPES_MAX 64 /* shapes in place of a polygon */
/* The squared length of (c, s) of a shape and of `up` of a mover must differ from 1 by less than
 * this. */
#define THUD_UNIT_ERROR 1e-5
/* The length of the normal of a water line may differ from 1 by this. */
#define THUD_NORMAL_ERROR 1e-3
#define THUD_TERRAIN_SLOPE_MAX 100.0     /* |rise over run| of a flat line */
#define THUD_TERRAIN_PLACE_MAX 1e9       /* |x|, |y| of vertices */
#define THUD_TERRAIN_COUNT_MAX 100000000 /* vertices */

#endif
