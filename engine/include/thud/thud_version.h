/* thud_version.h: which thud this is. CMake, and with it what is installed, reads the three numbers
 * here. Before 1.0.0 a program is built for one minor version. */
#ifndef THUD_VERSION_H
#define THUD_VERSION_H

#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

#define THUD_VERSION_MAJOR 0
#define THUD_VERSION_MINOR 1
#define THUD_VERSION_PATCH 0

/* In one number, which rises with each version. */
#define THUD_VERSION (THUD_VERSION_MAJOR * 1000000 + THUD_VERSION_MINOR * 1000 + THUD_VERSION_PATCH)

/* Of the library that is linked: not that of the headers where a shared library is another one. */
THUD_API int thud_version(void);

#ifdef __cplusplus
}
#endif

#endif
