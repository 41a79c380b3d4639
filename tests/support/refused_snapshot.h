/* refused_snapshot.h: a world that refuses a snapshot, and what its log hears of that. */
#ifndef REFUSED_SNAPSHOT_H
#define REFUSED_SNAPSHOT_H

#include "snapshot_support.h"

static char told[128];

static inline void keep(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    strncpy(told, message, sizeof told - 1);
}

/* Its log is kept in `told`. */
static inline thud_world_def telling(void) {
    thud_world_def def = thud_default_world_def();
    def.log = keep;
    return def;
}

/* For a reason in which the word stands; and the world is as it was. */
static inline void refused(thud_world *world, const void *bytes, size_t size, const char *word) {
    uint64_t before = digest_of(world);
    told[0] = 0;
    assert_int_equal(thud_world_restore(world, bytes, size), THUD_ERROR_INVALID);
    if (!strstr(told, word)) {
        fail_msg("'%s' does not tell of '%s'", told, word);
    }
    assert_int_equal(digest_of(world), before);
}

#endif
