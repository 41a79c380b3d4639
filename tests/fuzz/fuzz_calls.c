/* fuzz_calls.c: a fuzz target that makes calls of the whole API in any order, in two sessions that
 * must give the same results (session.h, twin_kind). It compares the digest after each operation.
 */
#include "calls.h"
#include "progress.h"
#include "target.h"

#include <stdlib.h>

/* Operations after which the second session goes on in a new world, restored from a snapshot. */
enum { REPLACED_EVERY = 7 };

static void play_all(fuzz_session *s) {
    while (!session_over(s)) {
        session_play(s);
        s->trace[s->operations++] = s->digest;
        if (s->asks) {
            session_question(s);
        }
        if (s->twin == TWIN_SNAPSHOT && s->second && s->operations % REPLACED_EVERY == 0) {
            uint64_t digest = s->digest;
            session_replace_world(s);
            s->digest = digest;
        }
    }
}

static void compare(fuzz_session *first, fuzz_session *second) {
    for (int i = 0; i < first->operations; i++) {
        if (first->trace[i] != second->trace[i]) {
            second->operations = i;
            fuzz_fail(second, "the twins differ");
        }
    }
    if (first->operations != second->operations) {
        fuzz_fail(second, "the twins have played %d and %d operations", first->operations,
                  second->operations);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static fuzz_session sessions[2];
    for (int i = 0; i < 2; i++) {
        session_open(&sessions[i], data, size, i == 1);
        play_all(&sessions[i]);
        session_close(&sessions[i]);
        if (sessions[0].twin == TWIN_NONE) {
            break;
        }
    }
    if (sessions[0].twin != TWIN_NONE) {
        compare(&sessions[0], &sessions[1]);
    }
    progress_tell();
    return 0;
}
