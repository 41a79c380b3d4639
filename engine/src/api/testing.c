/* testing.c: what thud_testing.h offers to tests. */
#include "thud/thud_testing.h"

#include "base/base.h"

thud_result thud_world_def_set_baseline_simd(thud_world_def *def, bool baseline_simd) {
    if (!def) {
        return THUD_ERROR_NULL;
    }
    if (def->cookie != TD_COOKIE && def->cookie != TD_COOKIE_BASELINE) {
        return THUD_ERROR_INVALID;
    }
    def->cookie = baseline_simd ? TD_COOKIE_BASELINE : TD_COOKIE;
    return THUD_OK;
}
