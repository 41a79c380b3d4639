/* thud_math.h: the two vector types that every thud header speaks.
 *
 * Of a world, a place is a thud_pos by value, and what is relative a thud_vec2: a velocity, force,
 * normal, an offset or size in a body's frame. Two are numbers of their own, since single precision
 * is too coarse for them: the way of a ray or cast (dx, dy), and the sizes of a shape that a query
 * has about a place, which go with thud_shape_instance. Geometry without a world is in double
 * precision throughout: its functions take and give coordinates as numbers (x, y; dx, dy; nx, ny),
 * and many points as an array of thud_pos. */
#ifndef THUD_MATH_H
#define THUD_MATH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a shared library shows. THUD_SHARED comes with the CMake target of one; THUD_BUILDS is for
 * building it. */
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

/* Of calls that make something: a compiler warns where nobody looks whether they were refused. */
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

typedef struct thud_vec2 {
    float x, y;
} thud_vec2;

typedef struct thud_pos {
    double x, y;
} thud_pos;

/* Results of every call that can fail. A call that fails changes nothing. */
typedef enum thud_result {
    THUD_OK = 0,
    THUD_ERROR_NULL,    /* a pointer that must not be null is null */
    THUD_ERROR_INVALID, /* a value is not finite or outside its documented range */
    THUD_ERROR_STALE,   /* a handle names nothing: destroyed, never made, or of another world */
    THUD_ERROR_MEMORY,  /* the allocator refused; the world is as before the call */
    THUD_ERROR_LOCKED   /* not allowed inside a callback */
} thud_result;

/* A short English sentence for a result; a static string, never null. */
THUD_API const char *thud_result_text(thud_result result);

/* Sine and cosine with the same bits from every compiler and processor, which the C library's do
 * not promise. |angle| <= THUD_ANGLE_MAX; the error stays below 1e-15. THUD_ERROR_NULL,
 * THUD_ERROR_INVALID. */
THUD_API thud_result thud_sincos(double angle, double *sine, double *cosine);

#ifdef __cplusplus
}
#endif

#endif
