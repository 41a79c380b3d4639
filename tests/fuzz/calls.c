/* calls.c: see calls.h. */
#include "calls.h"

#include "base/simd.h"

#include <stdlib.h>

uint64_t fuzz_calls_made;

/* ---- the caller's floating-point mode ---- */

#if defined(TD_FLOAT_MODE_OWN)
static void take_mode(const fuzz_session *s) {
#if defined(__SSE2__)
    static const td_float_mode modes[] = {0x1f80u | 0x8040u, 0x1f80u | 0x4000u, 0x1f80u | 0x2000u,
                                          0x1f80u | 0x6000u | 0x8040u};
#else
    static const td_float_mode modes[] = {1u << 24, 1u << 22, 2u << 22, 3u << 22 | 1u << 24};
#endif
    if (s->twin == TWIN_FLOAT_MODE && s->second) {
        td_float_mode mode = modes[s->script[0] % 4];
        TD_FLOAT_MODE_SET(mode);
    }
}

static void leave_mode(const fuzz_session *s) {
    if (s->twin == TWIN_FLOAT_MODE && s->second) {
        td_float_mode mode = TD_FLOAT_MODE_OWN;
        TD_FLOAT_MODE_SET(mode);
    }
}
#else
static void take_mode(const fuzz_session *s) {
    (void)s;
}

static void leave_mode(const fuzz_session *s) {
    (void)s;
}
#endif

/* ---- calls ---- */

/* The number of allocations that the present call may make before one fails; -1 if none fails.
 * Between 0 and 7: in each call of the second memory twin, in one of 16 calls where numbers are
 * hostile. */
static long allowed(fuzz_session *s) {
    bool all = s->twin == TWIN_MEMORY && s->second, some = s->twin == TWIN_NONE && s->bytes.hostile;
    if (s->closing || !(all || some)) {
        return -1;
    }
    unsigned dice = s->memory_round++ * 2654435761u + s->script[1] * 40503u;
    return all || dice >> 28 == 0 ? (long)(dice >> 16 & 7) : -1;
}

/* The world's snapshot is taken before each 8th call, and compared if that call is refused. Chosen,
 * for speed. */
enum { SNAPSHOT_EVERY = 8 };

/* Writes a snapshot of the world into one half of s->call_snapshots: the first before a call, the
 * second `after` it. Returns its bytes; 0 if it cannot be taken. */
static size_t take_call_snapshot(fuzz_session *s, bool after) {
    size_t bytes = 0;
    if (thud_world_get_snapshot_size(s->world, &bytes) != THUD_OK) {
        return 0;
    }
    if (2 * bytes > s->call_snapshots_room && !after) {
        s->call_snapshots_room = 2 * bytes;
        s->call_snapshots = realloc(s->call_snapshots, s->call_snapshots_room);
    }
    size_t half = s->call_snapshots_room / 2;
    char *out = s->call_snapshots + (after ? half : 0);
    bool taken = bytes <= half && thud_world_snapshot(s->world, out, half, NULL) == THUD_OK;
    return taken ? bytes : 0;
}

/* Fails if the world's snapshot differs from that before the call. */
static void compare_call_snapshots(fuzz_session *s, const session_call *call) {
    size_t half = s->call_snapshots_room / 2, bytes = call->snapshot_bytes;
    if (bytes && (take_call_snapshot(s, true) != bytes ||
                  memcmp(s->call_snapshots, s->call_snapshots + half, bytes) != 0)) {
        fuzz_fail(s, "%s: %s, and yet a snapshot of the world has changed", call->text,
                  thud_result_text(s->result));
    }
}

void call_begin(fuzz_session *s, const char *text) {
    session_call *call = &s->calls[s->depth];
    fuzz_calls_made++;
    call->again = call->text == text && call->again;
    call->text = text;
    bool snapshot = s->depth == 0 && fuzz_calls_made % SNAPSHOT_EVERY == 0;
    call->snapshot_bytes = snapshot ? take_call_snapshot(s, false) : 0;
    call->told = s->told;
    call->hash = thud_hash_of(s->world);
    call->stats = thud_stats_of(s->world);
    call->outer = s->memory_allowed;
    s->memory_allowed = call->again ? -1 : allowed(s);
    take_mode(s);
}

/* A refused call must call the log hook and leave the world as it was. */
static void check_refusal(fuzz_session *s, const session_call *call) {
    if (s->told == call->told && s->result != THUD_ERROR_NULL) {
        fuzz_fail(s, "%s: %s, and the log hears nothing", call->text, thud_result_text(s->result));
    }
    if (s->result == THUD_ERROR_MEMORY) {
        return; /* waiting edits may have been applied; the twins are compared instead */
    }
    thud_stats stats = thud_stats_of(s->world);
    if (thud_hash_of(s->world) != call->hash || stats.steps != call->stats.steps ||
        stats.bodies != call->stats.bodies || stats.shapes != call->stats.shapes ||
        stats.awake_bodies != call->stats.awake_bodies || stats.contacts != call->stats.contacts ||
        stats.pairs != call->stats.pairs) {
        fuzz_fail(s, "%s: %s, and yet the world has changed", call->text,
                  thud_result_text(s->result));
    }
    compare_call_snapshots(s, call);
}

/* Checks a call's result. True if the call ran out of memory for the first time: it is then made
 * again without failing allocations. */
bool call_again(fuzz_session *s) {
    session_call *call = &s->calls[s->depth];
    leave_mode(s);
    bool short_of_memory = s->memory_allowed == -2;
    s->memory_allowed = call->outer;
    if ((unsigned)s->result > THUD_ERROR_LOCKED) {
        fuzz_fail(s, "%s: result %d", call->text, (int)s->result);
    }
    if (s->result != THUD_OK) {
        check_refusal(s, call);
    }
    if (s->result == THUD_ERROR_MEMORY && !short_of_memory) {
        fuzz_fail(s, "%s: out of memory, of which there is enough", call->text);
    }
    call->again = s->result == THUD_ERROR_MEMORY && !call->again;
    if (!call->again) {
        note_bits(s, (uint64_t)s->result);
    }
    return call->again;
}

void call_untouched(fuzz_session *s, const void *out, size_t bytes) {
    const unsigned char *at = out;
    for (size_t i = 0; i < bytes; i++) {
        if (at[i] != CALL_FILL) {
            fuzz_fail(s, "%s: refused, and yet byte %zu of what it gives is written",
                      s->calls[s->depth].text, i);
        }
    }
}

void call_pure(fuzz_session *s, const char *text, const void *out, size_t bytes) {
    fuzz_calls_made++;
    s->calls[s->depth].text = text;
    if ((unsigned)s->result > THUD_ERROR_LOCKED || s->result == THUD_ERROR_STALE ||
        s->result == THUD_ERROR_MEMORY || s->result == THUD_ERROR_LOCKED) {
        fuzz_fail(s, "%s: result %d", text, (int)s->result);
    }
    if (s->result != THUD_OK) {
        call_untouched(s, out, bytes);
    }
}

/* ---- the digest, in which twins must agree ---- */

void note_bits(fuzz_session *s, uint64_t bits) {
    s->digest = (s->digest ^ bits) * 0x100000001b3u;
    s->digest ^= s->digest >> 29;
}

void note_number(fuzz_session *s, double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    if (!isfinite(value)) {
        fuzz_fail(s, "%s: gives %g", s->calls[s->depth].text, value);
    }
    note_bits(s, bits);
}

void note_place(fuzz_session *s, thud_pos place) {
    if (!isfinite(place.x) || !isfinite(place.y)) {
        fuzz_fail(s, "%s: gives the place %g %g", s->calls[s->depth].text, place.x, place.y);
    }
    if (s->twin != TWIN_SHIFT) {
        note_number(s, place.x);
        note_number(s, place.y);
    }
}

void note_vector(fuzz_session *s, thud_vec2 value) {
    note_number(s, (double)value.x);
    note_number(s, (double)value.y);
}
