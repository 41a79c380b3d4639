/* fuzz_snapshots.c: a fuzz target for snapshots with changed bytes and correct checksums, restored
 * into the world that they were taken from. Such a snapshot may be refused: then the log hook must
 * be called, and the world's hash stay the same. Or it may be accepted: then the world must be safe
 * to destroy, and must behave as before once it is restored from a good snapshot.
 *
 * An input is a session in the format of fuzz_calls.c, followed by MUTATIONS changes of
 * MUTATION_BYTES each: two for the place, one for the kind of change, one for the value. An input
 * that is shorter than these changes is a session alone. */
#include "calls.h"
#include "oracles.h"
#include "progress.h"
#include "target.h"

#include "api/snapshot.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
    MUTATIONS = 6,
    MUTATION_BYTES = 4,
    STEPS = 3, /* made after the good snapshot, and once more after restoring it */
    /* The first byte that the checksum covers. The magic and the checksum, before it, stay as they
     * are: a snapshot with another magic or checksum is refused before any other check. */
    CHECKED_FROM = offsetof(td_snapshot_head, checksum) + sizeof(uint64_t)
};

/* Spreads the 15 bits of a place over snapshots of more than 32 KiB: a prime, so that hardly any
 * size of a snapshot has a factor in common with it. Chosen. */
#define PLACE_FACTOR 8191u

/* The offset of the byte to change, by 16 bits of the input. The highest bit chooses the head,
 * which most checks concern, or the whole snapshot. */
static size_t offset_of_change(unsigned value, size_t bytes) {
    size_t head = sizeof(td_snapshot_head), end = value & 0x8000 && head < bytes ? head : bytes;
    return CHECKED_FROM + (value & 0x7fff) * PLACE_FACTOR % (end - CHECKED_FROM);
}

/* Changes one byte or word of a snapshot; `m`, MUTATION_BYTES of the input, chooses the place and
 * the change. */
static void mutate(char *snapshot, size_t bytes, const uint8_t *m) {
    /* Values at which counts, indices and sizes are likely to be mistaken. */
    static const int32_t words[] = {-1, 0, 1, INT32_MAX, INT32_MIN, 65536, 1 << 26, 255};
    size_t at = offset_of_change(m[0] | (unsigned)m[1] << 8, bytes), word = at & ~(size_t)3;
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
    uint64_t sum = td_snapshot_checksum(snapshot + CHECKED_FROM, bytes - CHECKED_FROM);
    memcpy(snapshot + offsetof(td_snapshot_head, checksum), &sum, sizeof sum);
}

/* Takes a snapshot of the world, in memory from malloc. */
static char *take_snapshot(fuzz_session *s, size_t *bytes) {
    TRY(s, thud_world_get_snapshot_size(s->world, bytes));
    char *snapshot = malloc(*bytes);
    TRY(s, thud_world_snapshot(s->world, snapshot, *bytes, NULL));
    if (s->result != THUD_OK || *bytes <= CHECKED_FROM) {
        fuzz_fail(s, "no snapshot, of %zu bytes: %s", *bytes, thud_result_text(s->result));
    }
    return snapshot;
}

/* Restores the good snapshot and makes the steps again; their hashes must be those of the first
 * time. */
static void repeat_steps(fuzz_session *s, const char *good, size_t bytes,
                         const uint64_t hash[STEPS]) {
    TRY(s, thud_world_restore(s->world, good, bytes));
    if (s->result != THUD_OK) {
        fuzz_fail(s, "a good snapshot is refused: %s", thud_result_text(s->result));
    }
    for (int i = 0; i < STEPS; i++) {
        TRY(s, thud_world_step(s->world));
        if (s->result != THUD_OK || thud_hash_of(s->world) != hash[i]) {
            fuzz_fail(s, "%d steps after a good snapshot the world has another hash", i + 1);
        }
    }
}

/* Takes a good snapshot and makes STEPS steps; restores a snapshot with `count` changes; then
 * restores the good one, and makes the steps again. */
static void restore_changed(fuzz_session *s, const uint8_t *changes, size_t count) {
    size_t bytes = 0;
    uint64_t hash[STEPS];
    s->operation = "restoring a changed snapshot";
    s->mood = 0; /* callbacks make no more calls, so that the steps are the same */
    char *good = take_snapshot(s, &bytes), *bad = malloc(bytes);
    /* What callbacks do follows from this count: the repeated steps start from the same one. */
    unsigned callbacks = s->asked;
    for (int i = 0; i < STEPS; i++) {
        TRY(s, thud_world_step(s->world));
        hash[i] = thud_hash_of(s->world);
    }
    memcpy(bad, good, bytes);
    for (size_t i = 0; i < count; i++) {
        mutate(bad, bytes, changes + i * MUTATION_BYTES);
    }
    mend_checksum(bad, bytes);
    int messages = s->told;
    uint64_t before = thud_hash_of(s->world);
    thud_result result = COUNTED(thud_world_restore(s->world, bad, bytes));
    if (result != THUD_OK && (s->told == messages || thud_hash_of(s->world) != before)) {
        fuzz_fail(s, "a changed snapshot is refused without a log message, or the world changed");
    }
    s->asked = callbacks;
    repeat_steps(s, good, bytes, hash);
    free(good);
    free(bad);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    static fuzz_session session;
    size_t changes = size < MUTATIONS * MUTATION_BYTES ? 0 : MUTATIONS;
    size -= changes * MUTATION_BYTES;
    /* As the second session of its twins, the one with workers, a shift or failing allocations. */
    bool second = true;
    session_open(&session, data, size, second);
    while (!session_over(&session)) {
        session_play(&session);
        session.operations++;
    }
    restore_changed(&session, data + size, changes);
    /* Not session_close, which checks that every begin event in the pair_ledgers had its end: the
     * restored world is older than events that the ledgers have. */
    thud_world_destroy(session.world);
    thud_world_destroy(session.other);
    free(session.snapshot);
    free(session.call_snapshots);
    if (session.memory_held != 0) {
        fuzz_fail(&session, "%ld blocks of memory were not given back", session.memory_held);
    }
    progress_tell();
    return 0;
}
