/* thud_math.h: the two vector types of all thud headers, sine and cosine, and angles.
 *
 * Functions of a world take a position as a thud_pos by value, and relative quantities as a
 * thud_vec2: velocities, forces, normals, and offsets and sizes in a body's frame. Two quantities
 * are passed as separate numbers, since they need double precision: the displacement (dx, dy) of a
 * ray or cast, and the sizes of a query's shape, as in thud_geometry. Geometry without a world is
 * in double precision throughout: its functions take and return coordinates as numbers (x, y; dx,
 * dy; nx, ny), and many points as an array of thud_pos. */
#ifndef THUD_MATH_H
#define THUD_MATH_H

#include "thud_result.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A relative quantity, in single precision. */
typedef struct thud_vec2 {
    float x, y;
} thud_vec2;

/* A position or point, in double precision. */
typedef struct thud_pos {
    double x, y;
} thud_pos;

/* Sine and cosine of an angle, rad, |angle| <= THUD_ANGLE_MAX, with the same bits from every
 * compiler and processor, which the C library does not guarantee. The error is below 1e-15.
 * THUD_ERROR_NULL, THUD_ERROR_INVALID. */
THUD_API thud_result thud_sincos(double angle, double *out_sine, double *out_cosine);

/* The angle in (-pi, pi], rad, with this sine and cosine. The sum of their squares must be 1 within
 * THUD_UNIT_ERROR. The result has the same bits everywhere, as with thud_sincos. It gives, for
 * example, the angle of an OBB in a thud_geometry. The error is below 1e-15 if the sum is 1.
 * THUD_ERROR_NULL, THUD_ERROR_INVALID. */
THUD_API thud_result thud_angle_of(double sine, double cosine, double *out_angle);

#ifdef __cplusplus
}
#endif

#endif
