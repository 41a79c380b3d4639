/* thud_math.h: the two vector types of all thud headers, the results of calls, and macros.
 *
 * Calls of a world take a place as a thud_pos by value, and relative quantities as a thud_vec2:
 * velocities, forces, normals, and offsets and sizes in a body's frame. Two quantities are passed
 * as single numbers, since they need double precision: the displacement (dx, dy) of a ray or cast,
 * and the sizes of a query's shape, as in thud_geometry. Geometry without a world is in
 * double precision throughout: its functions take and return coordinates as numbers (x, y; dx, dy;
 * nx, ny), and many points as an array of thud_pos. */
#ifndef THUD_MATH_H
#define THUD_MATH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Marks the functions that a shared library exports. The CMake target of the shared library defines
 * THUD_SHARED for its users; THUD_BUILDS is defined while the library itself is built. */
#if defined(_WIN32)
#if defined(THUD_SHARED) && defined(THUD_BUILDS)
#define THUD_API __declspec(dllexport)
#elif defined(THUD_SHARED)
#define THUD_API __declspec(dllimport)
#else
#define THUD_API
#endif
#else
#define THUD_API __attribute__((visibility("default")))
#endif

/* Marks calls that create something: a compiler warns where their result is not used. */
#if (defined(__cplusplus) && __cplusplus >= 201703L) || \
    (defined(__STDC_VERSION__) && __STDC_VERSION__ >= 202311L)
#define THUD_NODISCARD [[nodiscard]]
#elif defined(__GNUC__)
#define THUD_NODISCARD __attribute__((warn_unused_result))
#elif defined(_MSC_VER)
#include <sal.h>
#define THUD_NODISCARD _Check_return_
#else
#define THUD_NODISCARD
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* A relative quantity, in single precision. */
typedef struct thud_vec2 {
    float x, y;
} thud_vec2;

/* A place in the world, or a point, in double precision. */
typedef struct thud_pos {
    double x, y;
} thud_pos;

/* The result of every call that can fail. A call that fails has changed nothing. */
typedef enum thud_result {
    THUD_OK = 0,
    THUD_ERROR_NULL,    /* a pointer that must not be null is null */
    THUD_ERROR_INVALID, /* a value is not finite or outside its documented range */
    THUD_ERROR_STALE,   /* a handle names nothing: destroyed, never made, or of another world */
    THUD_ERROR_MEMORY,  /* the allocator returned null; the world is as before the call */
    THUD_ERROR_LOCKED   /* not allowed inside a callback */
} thud_result;

/* A short English sentence for a result; a static string, never null. */
THUD_API const char *thud_result_text(thud_result result);

/* Sine and cosine of an angle, rad, |angle| <= THUD_ANGLE_MAX, with the same bits from every
 * compiler and processor, which the C library does not guarantee. The error is below 1e-15.
 * THUD_ERROR_NULL, THUD_ERROR_INVALID. */
THUD_API thud_result thud_sincos(double angle, double *sine, double *cosine);

#ifdef __cplusplus
}
#endif

#endif
