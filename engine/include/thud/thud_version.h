/* thud_version.h: the version of thud. CMake reads the three numbers here, also for the installed
 * package. Before 1.0.0, programs must be recompiled for each minor version. */
#ifndef THUD_VERSION_H
#define THUD_VERSION_H

#include "thud_math.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The version has three parts. All are whole numbers; a change of the first or second may need a
 * change of programs. */
#define THUD_VERSION_MAJOR 0
#define THUD_VERSION_MINOR 2
#define THUD_VERSION_PATCH 0

/* As one number, which rises with each version. */
#define THUD_VERSION (THUD_VERSION_MAJOR * 1000000 + THUD_VERSION_MINOR * 1000 + THUD_VERSION_PATCH)

/* The version of the library that is linked, which may differ from THUD_VERSION with a shared
 * library. */
THUD_API int thud_version(void);

#ifdef __cplusplus
}
#endif

#endif
