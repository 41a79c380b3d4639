/* refused_snapshot.h: asserts that a world refuses a snapshot, and that its log names the
 * reason. */
#ifndef REFUSED_SNAPSHOT_H
#define REFUSED_SNAPSHOT_H

#include "snapshot_support.h"

/* The last message of the log. */
static char told[128];

static inline void keep(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    strncpy(told, message, sizeof told - 1);
}

/* The defaults, with a log that is kept in `told`. */
static inline thud_world_def telling(void) {
    thud_world_def def = thud_default_world_def();
    def.log = keep;
    return def;
}

/* Asserts that the world refuses these bytes with a message that contains `word`, and that the
 * world is unchanged. */
static inline void refused(thud_world *world, const void *bytes, size_t size, const char *word) {
    uint64_t before = digest_of(world);
    told[0] = 0;
    assert_int_equal(thud_world_restore(world, bytes, size), THUD_ERROR_INVALID);
    if (!strstr(told, word)) {
        fail_msg("'%s' does not contain '%s'", told, word);
    }
    assert_int_equal(digest_of(world), before);
}

#endif
