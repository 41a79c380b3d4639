/* thud_result.h: the results of calls, and the attributes of public functions. Included by all
 * headers of thud. */
#ifndef THUD_RESULT_H
#define THUD_RESULT_H

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

/* Marks calls that create something: a compiler warns if their result is not used. */
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

/* The result of calls that can fail. A call that fails has changed nothing, unless its comment says
 * otherwise. */
typedef enum thud_result {
    THUD_OK = 0,
    THUD_ERROR_NULL,    /* a pointer that must not be null is null */
    THUD_ERROR_INVALID, /* a value is not finite or outside its documented range */
    THUD_ERROR_STALE,   /* a handle is not valid: its object was destroyed, never existed, or
                           belongs to another world */
    THUD_ERROR_MEMORY,  /* the allocator returned null */
    THUD_ERROR_LOCKED   /* not allowed inside a callback */
} thud_result;

/* A short English sentence for a result; a static string, never null. */
THUD_API const char *thud_result_text(thud_result result);

#ifdef __cplusplus
}
#endif

#endif
