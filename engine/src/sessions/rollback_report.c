/* rollback_report.c: what peers whose hashes differ tell each other, to find the first step and
 * body that differ. rollback-report.ts of the package writes and reads the same bytes.
 *
 * A report, all numbers with their low bytes first:
 *     uint32  MARK
 *     uint32  number of players
 *     int64   the first step of the hashes
 *     uint32  number of hashes
 *     uint32  number of bodies
 *     int64   the step of the bodies; -1: none
 *     uint32  1 where the inputs of the step before that one follow; else 0
 *     uint64  by step, the hash of the world before it
 *     uint64  by player, its input
 *             by body, in the order of slots: uint32, its slot; uint64, its hash
 *     uint64  checksum of all before it */
#include "sessions/rollback.h"

#include "state/body.h"
#include "thud/thud.h"
#include "thud/thud_reads.h"

#include <string.h>

static const uint32_t MARK = 0x32526474; /* "tdR2" */

enum { HEAD_BYTES = 36, HASH_BYTES = 8, BODY_BYTES = 12, SUM_BYTES = 8 };

/* A report's head. */
typedef struct report {
    int64_t first, step;
    int64_t hashes, bodies;
    bool has_inputs;
} report;

static size_t bytes_of(const thud_rollback *r, const report *p) {
    size_t inputs = p->has_inputs ? (size_t)r->options.players : 0;
    return HEAD_BYTES + HASH_BYTES * ((size_t)p->hashes + inputs) + BODY_BYTES * (size_t)p->bodies +
           SUM_BYTES;
}

/* ---- hashes ---- */

/* FNV-1a (Fowler, Noll, Vo), by words of 64 bits in place of bytes, with high bits folded into low
 * ones. */
static uint64_t mix(uint64_t hash, uint64_t word) {
    hash = (hash ^ word) * 0x100000001b3ull;
    return hash ^ hash >> 29;
}

static const uint64_t MIX_START = 0xcbf29ce484222325ull;

static uint64_t checksum(const uint8_t *bytes, size_t count) {
    uint64_t sum = MIX_START;
    for (size_t i = 0; i < count; i++) {
        sum = mix(sum, bytes[i]);
    }
    return sum;
}

static uint64_t bits_of(float x) {
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static uint64_t bits_of_double(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

/* A hash of where a body is and how it moves: of numbers that programs in all languages can read.
 */
static uint64_t hash_of_body(const thud_world *w, td_body_index body) {
    thud_body_id id = td_body_handle(w, body);
    thud_pos place;
    double angle;
    thud_vec2 v;
    float spin;
    thud_body_get_position(w, id, &place);
    thud_body_get_rotation(w, id, &angle, NULL, NULL);
    thud_body_get_velocity(w, id, &v, &spin);
    uint64_t hash = mix(MIX_START, bits_of_double(place.x));
    hash = mix(hash, bits_of_double(place.y));
    hash = mix(hash, bits_of_double(angle));
    hash = mix(hash, bits_of(v.x) | bits_of(v.y) << 32);
    return mix(hash, bits_of(spin));
}

/* ---- steps ---- */

/* Sets the first step whose hash a report has, and the number of hashes. */
static void find_steps(const thud_rollback *r, report *out) {
    out->first = td_rollback_oldest(r);
    int64_t end = thud_progress_of(r).confirmed + 1;
    out->hashes = end > out->first ? end - out->first : 0;
}

static uint64_t hash_before(const thud_rollback *r, int64_t step) {
    return step < r->steps ? td_rollback_saved(r, step)->hash : thud_hash_of(r->world);
}

/* Whether this peer has played the step before this one, so that a report can have its inputs. */
static bool has_inputs_before(const thud_rollback *r, int64_t step) {
    return step > r->first;
}

/* Restores the world as it was before a step; come_back undoes it. The present is saved in the
 * place of the next step, where the oldest snapshot is not needed any more. */
static thud_result go_back(thud_rollback *r, int64_t step) {
    thud_result result = THUD_OK;
    if (step < r->steps) {
        result = td_rollback_save_step(r, r->steps);
        result = result == THUD_OK ? td_rollback_restore_step(r, step) : result;
    }
    return result;
}

/* Undoes go_back. If the present cannot be restored, marks the steps from the restored one on to be
 * played again. */
static thud_result come_back(thud_rollback *r) {
    thud_result result = r->at < r->steps ? td_rollback_restore_step(r, r->steps) : THUD_OK;
    if (result != THUD_OK) {
        r->first_wrong = r->at;
    }
    return result;
}

/* ---- reports ---- */

static int64_t count_bodies(const thud_world *w) {
    int64_t count = 0;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        count += td_body_lives(w, i);
    }
    return count;
}

/* Writes the report of the world that go_back has restored. `present`: the hash of the present
 * world. */
static void write_report(const thud_rollback *r, const report *p, uint64_t present, uint8_t *out) {
    uint8_t *at = td_put_number(out, MARK, 4);
    at = td_put_number(at, (uint64_t)r->options.players, 4);
    at = td_put_number(at, (uint64_t)p->first, 8);
    at = td_put_number(at, (uint64_t)p->hashes, 4);
    at = td_put_number(at, (uint64_t)p->bodies, 4);
    at = td_put_number(at, (uint64_t)p->step, 8);
    at = td_put_number(at, p->has_inputs, 4);
    for (int64_t i = 0; i < p->hashes; i++) {
        int64_t step = p->first + i;
        at = td_put_number(at, step < r->steps ? td_rollback_saved(r, step)->hash : present,
                           HASH_BYTES);
    }
    for (int i = 0; p->has_inputs && i < r->options.players; i++) {
        at = td_put_number(at, td_rollback_saved(r, p->step - 1)->inputs[i], HASH_BYTES);
    }
    for (td_body_index i = {0}; p->step >= 0 && i.at < r->world->bodies.count; i.at++) {
        if (td_body_lives(r->world, i)) {
            at = td_put_number(at, (uint64_t)i.at, 4);
            at = td_put_number(at, hash_of_body(r->world, i), HASH_BYTES);
        }
    }
    td_put_number(at, checksum(out, (size_t)(at - out)), SUM_BYTES);
}

thud_result thud_rollback_report(thud_rollback *r, int64_t step, void *buffer, size_t capacity,
                                 size_t *out_bytes) {
    thud_result result = td_rollback_settle_for(r, buffer, capacity, out_bytes);
    if (result != THUD_OK) {
        return result;
    }
    report p = {.step = step};
    find_steps(r, &p);
    bool is_detailed = step != -1;
    if (is_detailed && (step < p.first || step >= p.first + p.hashes)) {
        return td_refuse(r->world, THUD_ERROR_INVALID,
                         "rollback: the step of the report is not confirmed, or not kept");
    }
    p.has_inputs = is_detailed && has_inputs_before(r, step);
    uint64_t present = thud_hash_of(r->world);
    result = is_detailed ? go_back(r, step) : THUD_OK;
    if (result != THUD_OK) {
        return result;
    }
    p.bodies = is_detailed ? count_bodies(r->world) : 0;
    size_t bytes = bytes_of(r, &p);
    bool fits = !buffer || capacity >= bytes;
    if (buffer && fits) {
        write_report(r, &p, present, buffer);
    }
    result = come_back(r);
    if (!fits) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: the buffer is too small");
    }
    *out_bytes = bytes;
    return result;
}

/* ---- comparing ---- */

/* Reads the head. False for bytes that are no report of a game with so many players. */
static bool read_head(const thud_rollback *r, const uint8_t *from, size_t bytes, report *out) {
    if (bytes < HEAD_BYTES + SUM_BYTES || td_number_at(from, 4) != MARK ||
        td_number_at(from + 4, 4) != (uint64_t)r->options.players ||
        td_number_at(from + bytes - SUM_BYTES, SUM_BYTES) != checksum(from, bytes - SUM_BYTES)) {
        return false;
    }
    *out = (report){.first = (int64_t)td_number_at(from + 8, 8),
                    .hashes = (int64_t)td_number_at(from + 16, 4),
                    .bodies = (int64_t)td_number_at(from + 20, 4),
                    .step = (int64_t)td_number_at(from + 24, 8),
                    .has_inputs = td_number_at(from + 32, 4) == 1};
    return td_number_at(from + 32, 4) <= 1 && out->first >= 0 && out->first < TD_NO_STEP / 2 &&
           bytes_of(r, out) == bytes && (out->step >= 0 || (out->step == -1 && !out->bodies));
}

/* Whether the bodies of a report are in the order of their slots, and the slots are in range.
 * Reports come from other peers, and may be forged. */
static bool is_in_order(const uint8_t *bodies, int64_t count) {
    int64_t before = -1;
    for (int64_t i = 0; i < count; i++) {
        int64_t slot = (int64_t)td_number_at(bodies + i * BODY_BYTES, 4);
        if (slot <= before || slot >= INT32_MAX) {
            return false;
        }
        before = slot;
    }
    return true;
}

/* The first step whose hashes in the report and here differ; -1: none. */
static int64_t first_difference(const thud_rollback *r, const report *p, const uint8_t *hashes) {
    report own;
    find_steps(r, &own);
    for (int64_t i = 0; i < p->hashes; i++) {
        int64_t step = p->first + i;
        if (step >= own.first && step < own.first + own.hashes &&
            td_number_at(hashes + i * HASH_BYTES, HASH_BYTES) != hash_before(r, step)) {
            return step;
        }
    }
    return -1;
}

static void note_body(thud_rollback_difference *out, int64_t slot, thud_body_id body) {
    if (out->bodies++ == 0) {
        out->body_slot = (int)slot;
        out->body = body;
    }
}

/* Compares the bodies of the report with those of the world. The world must be as it was before the
 * report's step. */
static void compare_bodies(const thud_rollback *r, const report *p, const uint8_t *bodies,
                           thud_rollback_difference *out) {
    const thud_world *w = r->world;
    int64_t next = 0;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        const uint8_t *body = bodies + next * BODY_BYTES;
        bool here = td_body_lives(w, i);
        bool there = next < p->bodies && td_number_at(body, 4) == (uint64_t)i.at;
        if (here != there || (here && hash_of_body(w, i) != td_number_at(body + 4, HASH_BYTES))) {
            note_body(out, i.at, here ? td_body_handle(w, i) : (thud_body_id){0, 0});
        }
        next += there;
    }
    for (; next < p->bodies; next++) {
        note_body(out, (int64_t)td_number_at(bodies + next * BODY_BYTES, 4), (thud_body_id){0, 0});
    }
}

thud_result thud_rollback_compare(thud_rollback *r, const void *from, size_t bytes,
                                  thud_rollback_difference *out) {
    thud_result result = thud_rollback_settle(r);
    if (result != THUD_OK) {
        return result;
    }
    if (!from || !out) {
        return td_refuse(r->world, THUD_ERROR_NULL, "rollback: report or out is null");
    }
    report p;
    const uint8_t *hashes = (const uint8_t *)from + HEAD_BYTES;
    if (!read_head(r, from, bytes, &p)) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: no report, or a damaged one");
    }
    const uint8_t *inputs = hashes + p.hashes * HASH_BYTES;
    const uint8_t *bodies = inputs + (p.has_inputs ? HASH_BYTES * r->options.players : 0);
    if (!is_in_order(bodies, p.bodies)) {
        return td_refuse(r->world, THUD_ERROR_INVALID, "rollback: no report, or a damaged one");
    }
    thud_rollback_difference found = {.step = first_difference(r, &p, hashes),
                                      .body_slot = -1,
                                      .player = -1};
    found.is_detailed = found.step >= 0 && found.step == p.step;
    if (found.is_detailed) {
        bool both = p.has_inputs && has_inputs_before(r, p.step);
        for (int i = r->options.players - 1; both && i >= 0; i--) {
            bool same = td_number_at(inputs + HASH_BYTES * i, HASH_BYTES) ==
                        td_rollback_saved(r, p.step - 1)->inputs[i];
            found.player = same ? found.player : i;
        }
        result = go_back(r, p.step);
        if (result != THUD_OK) {
            return result;
        }
        compare_bodies(r, &p, bodies, &found);
        result = come_back(r);
    }
    if (result == THUD_OK) {
        *out = found;
    }
    return result;
}
