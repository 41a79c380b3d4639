/* fuzz_snapshots.c: a fuzz target for snapshots with changed bytes and correct checksums, restored
 * into the world that they were taken from. Either such a snapshot is refused, the log hook is
 * called and the world's hash stays the same. Or it is accepted; then the world must be safe to
 * destroy, and must behave as before once it is restored from a good snapshot.
 *
 * An input is a session as of fuzz_calls.c, followed by MUTATIONS changes of four bytes: two for
 * the place, one for the kind of change, one for the value. */
#include "calls.h"
#include "oracles.h"
#include "progress.h"
#include "target.h"

#include "api/snapshot.h"

#include <stdlib.h>

enum { MUTATIONS = 6, MUTATION = 4, STEPS = 3 };

/* The byte of the snapshot to change. Half of the changes are in the head, which most checks
 * concern, the others are anywhere. */
static size_t place_of(unsigned value, size_t bytes) {
    size_t from = sizeof(char[8]) + sizeof(uint64_t), head = sizeof(td_snapshot_head);
    size_t range = value & 0x8000 ? (head < bytes ? head : bytes) - from : bytes - from;
    return from + (value & 0x7fff) * 8191u % range;
}

/* Changes one byte or word of a snapshot; `m` chooses the place and the change. */
static void mutate(char *snapshot, size_t bytes, const uint8_t *m) {
    static const int32_t words[] = {-1, 0, 1, INT32_MAX, INT32_MIN, 65536, 1 << 26, 255};
    size_t at = place_of(m[0] | (unsigned)m[1] << 8, bytes), word = at & ~(size_t)3;
    int32_t value;
    switch (m[2] % 4) {
    case 0:
        snapshot[at] ^= (char)m[3];
        return;
    case 1:
        value = words[m[3] % 8];
        break;
    default:
        memcpy(&value, snapshot + word, sizeof value);
        value = (int32_t)((uint32_t)value + (m[2] & 4 ? m[3] : 0u - m[3]));
    }
    if (word + sizeof value <= bytes) {
        memcpy(snapshot + word, &value, sizeof value);
    }
}

/* Recomputes the checksum, so that restoring reaches the changed data. */
static void mend_checksum(char *snapshot, size_t bytes) {
    size_t from = offsetof(td_snapshot_head, checksum) + sizeof(uint64_t);
    uint64_t sum = td_snapshot_checksum(snapshot + from, bytes - from);
    memcpy(snapshot + offsetof(td_snapshot_head, checksum), &sum, sizeof sum);
}

/* Restores the good snapshot and makes the steps again; their hashes must be those of the first
 * time. */
static void goes_on(fuzz_session *s, const char *good, size_t bytes, const uint64_t hash[STEPS]) {
    TRY(s, thud_world_restore(s->world, good, bytes));
    if (s->result != THUD_OK) {
        fuzz_fail(s, "a good snapshot is refused: %s", thud_result_text(s->result));
    }
    for (int i = 0; i < STEPS; i++) {
        TRY(s, thud_world_step(s->world));
        if (s->result != THUD_OK || thud_hash_of(s->world) != hash[i]) {
            fuzz_fail(s, "%d steps after a good snapshot the world is another one", i + 1);
        }
    }
}

static void restore_changed(fuzz_session *s, const uint8_t *changes, size_t count) {
    size_t bytes = 0;
    uint64_t hash[STEPS];
    s->operation = "restoring what was changed";
    s->mood = 0; /* callbacks make no more calls, so that the steps are the same */
    TRY(s, thud_world_get_snapshot_size(s->world, &bytes));
    char *good = malloc(bytes), *bad = malloc(bytes);
    TRY(s, thud_world_snapshot(s->world, good, bytes, NULL));
    unsigned asked = s->asked;
    for (int i = 0; i < STEPS; i++) {
        TRY(s, thud_world_step(s->world));
        hash[i] = thud_hash_of(s->world);
    }
    memcpy(bad, good, bytes);
    for (size_t i = 0; i < count; i++) {
        mutate(bad, bytes, changes + i * MUTATION);
    }
    mend_checksum(bad, bytes);
    fuzz_calls_made++;
    int told = s->told;
    uint64_t before = thud_hash_of(s->world);
    thud_result result = thud_world_restore(s->world, bad, bytes);
    if (result != THUD_OK && (s->told == told || thud_hash_of(s->world) != before)) {
        fuzz_fail(s, "a changed snapshot is refused unheard, or the world has changed");
    }
    s->asked = asked;
    goes_on(s, good, bytes, hash);
    free(good);
    free(bad);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static fuzz_session session;
    size_t changes = size < MUTATIONS * MUTATION ? 0 : MUTATIONS;
    size -= changes * MUTATION;
    session_open(&session, data, size, true);
    while (!session_over(&session)) {
        session_play(&session);
        session.operations++;
    }
    restore_changed(&session, data + size, changes);
    /* Not session_close, which checks events: the restore has gone back to a time before the steps
     * whose events are in the ledger. */
    thud_world_destroy(session.world);
    thud_world_destroy(session.other);
    free(session.snapshot);
    free(session.image);
    if (session.memory_held != 0) {
        fuzz_fail(&session, "%ld blocks of memory were not given back", session.memory_held);
    }
    progress_tell();
    return 0;
}
