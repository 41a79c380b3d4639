/* thud_testing.h: for tests of thud and of programs that use it. thud.h does not include this
 * header; a program that does not use it does not link it. */
#ifndef THUD_TESTING_H
#define THUD_TESTING_H

#include "thud.h"

#ifdef __cplusplus
extern "C" {
#endif

/* True: a world that is created from the def does not use AVX2. Its results are the same, bit for
 * bit, but a step takes longer. False, as by thud_default_world_def: it uses the widest
 * instructions that the processor has. THUD_ERROR_NULL; THUD_ERROR_INVALID for a def without its
 * cookie. */
THUD_API thud_result thud_world_def_set_baseline_simd(thud_world_def *def, bool baseline_simd);

#ifdef __cplusplus
}
#endif

#endif
