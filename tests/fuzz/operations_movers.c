/* operations_movers.c: character movers, and restoring snapshots. */
#include "operations.h"

#include <thud/thud_packed.h>

#include <stdlib.h>

/* Whether two movers have the same place and ground, which a move changes. */
static bool same_mover(const thud_mover *a, const thud_mover *b) {
    bool shape = memcmp(&a->shape.x, &b->shape.x, 2 * sizeof a->shape.x) == 0;
    return shape && a->on_ground == b->on_ground &&
           a->ground_shape.index1 == b->ground_shape.index1 &&
           a->ground_body.index1 == b->ground_body.index1;
}

void play_mover(fuzz_session *s) {
    thud_vec2 velocity = pick_velocity(s);
    unsigned byte = next_byte(&s->bytes);
    double dt = byte & 128 ? next_number(&s->bytes, 0, 1.0 / 256) : 1.0 / 60;
    thud_mover_report report;
    memset(&report, CALL_FILL, sizeof report);
    s->now.mover.pass = byte & 1 ? session_pass : NULL;
    s->now.mover.context = s;
    s->now.mover.filter.sensors = byte & 2;
    thud_mover before = s->now.mover;
    TRY(s, thud_mover_move(s->world, &s->now.mover, velocity, dt, &report));
    if (s->result != THUD_OK) {
        call_untouched(s, &report, sizeof report);
        if (!same_mover(&before, &s->now.mover)) {
            fuzz_fail(s, "a mover has changed though its move was refused");
        }
        return;
    }
    if (s->twin == TWIN_SHIFT) {
        return; /* a mover's place is in double precision, which a shift rounds */
    }
    note_place(s, (thud_pos){s->now.mover.shape.x, s->now.mover.shape.y});
    note_vector(s, report.velocity);
    note_vector(s, report.ground_velocity);
    note_number(s, report.depth);
    note_bits(s, (uint64_t)report.hit_count);
    note_bits(s, (uint64_t)report.sensor_count);
    if (report.hit_count < 0 || report.hit_count > THUD_MOVER_HITS || report.sensor_count < 0 ||
        report.sensor_count > THUD_MOVER_SENSORS) {
        fuzz_fail(s, "a mover has met %d shapes and %d sensors", report.hit_count,
                  report.sensor_count);
    }
    for (int i = 0; i < report.hit_count; i++) {
        note_bits(s, report.hits[i].shape.index1);
        note_place(s, report.hits[i].point);
        note_vector(s, report.hits[i].normal);
    }
}

void play_mover_settings(fuzz_session *s) {
    thud_mover *m = &s->now.mover;
    m->max_slope = next_number(&s->bytes, 0, 1.0 / 160);
    m->step_height = next_number(&s->bytes, 0, 1.0 / 64) * s->unit;
    m->snap_distance = next_number(&s->bytes, 0, 1.0 / 64) * s->unit;
    m->push_force = next_number(&s->bytes, 0, 1) * s->unit;
    m->body = next_choice(&s->bytes, 3) ? m->body : pick_body(s);
    m->up = next_choice(&s->bytes, 4) ? (thud_vec2){0, 1} : (thud_vec2){0, 0};
    if (s->twin == TWIN_SHIFT) {
        m->push_force = 0;
        m->body = (thud_body_id){0, 0};
    }
}

void play_mover_place(fuzz_session *s) {
    thud_pos place = pick_place(s);
    thud_geometry shape = pick_centred_geometry(s);
    shape.x = place.x;
    shape.y = place.y;
    thud_mover made = COUNTED(thud_default_mover(shape));
    made.body = s->now.mover.body;
    s->now.mover = made;
}

/* ---- snapshots ---- */

void play_snapshot(fuzz_session *s) {
    size_t bytes = 0, written = 0;
    TRY(s, thud_world_get_snapshot_size(s->world, &bytes));
    if (s->result != THUD_OK) {
        return;
    }
    char *buffer = malloc(bytes);
    TRY(s, thud_world_snapshot(s->world, buffer, bytes, &written));
    if (s->result != THUD_OK || written != bytes) {
        fuzz_fail(s, "a snapshot of %zu bytes has %zu: %s", bytes, written,
                  thud_result_text(s->result));
    }
    free(s->snapshot);
    s->snapshot = buffer;
    s->snapshot_bytes = bytes;
    s->kept = s->now;
}

/* Packs a snapshot of the world, alone or against the kept one. It unpacks to the same bytes, and
 * is refused where a byte is damaged. */
static void pack_present(fuzz_session *s) {
    size_t bytes = 0, size = 0, back_size = 0;
    TRY(s, thud_world_get_snapshot_size(s->world, &bytes));
    if (s->result != THUD_OK) {
        return;
    }
    size_t room = bytes + bytes / 8 + 2048;
    char *now = malloc(bytes), *packed = malloc(room), *back = malloc(bytes);
    memset(back, CALL_FILL, bytes);
    TRY(s, thud_world_snapshot(s->world, now, bytes, NULL));
    thud_bytes base = {s->snapshot, s->snapshot_bytes};
    if (bytes % 16 == 0) {
        base = (thud_bytes){NULL, 0};
    }
    TRY(s, thud_world_pack(s->world, base, (thud_bytes){now, bytes}, packed, room, &size));
    if (s->result != THUD_OK) {
        fuzz_fail(s, "a snapshot is not packed: %s", thud_result_text(s->result));
    }
    size_t at = s->digest % size;
    packed[at] ^= 1;
    TRY(s, thud_world_unpack(s->world, base, (thud_bytes){packed, size}, back, bytes, &back_size));
    if (s->result != THUD_ERROR_INVALID) {
        fuzz_fail(s, "a packed snapshot whose byte %zu is damaged is unpacked", at);
    }
    call_untouched(s, back, bytes);
    packed[at] ^= 1;
    TRY(s, thud_world_unpack(s->world, base, (thud_bytes){packed, size}, back, bytes, &back_size));
    if (s->result != THUD_OK || back_size != bytes || memcmp(back, now, bytes) != 0) {
        fuzz_fail(s, "what was packed is not unpacked: %s", thud_result_text(s->result));
    }
    free(now);
    free(packed);
    free(back);
}

void play_restore(fuzz_session *s) {
    if (!s->snapshot) {
        return;
    }
    pack_present(s);
    TRY(s, thud_world_restore(s->world, s->snapshot, s->snapshot_bytes));
    if (s->result == THUD_OK) {
        s->now = s->kept;
        s->destroyed_inside++; /* it is unknown what callbacks had destroyed when the snapshot was
                                  taken */
    } else if (s->result != THUD_ERROR_LOCKED) {
        fuzz_fail(s, "a snapshot is refused: %s", thud_result_text(s->result));
    }
}

void play_restore_damaged(fuzz_session *s) {
    if (!s->snapshot) {
        return;
    }
    size_t at = next_byte(&s->bytes) * 257u % s->snapshot_bytes;
    char flip = (char)(1 + next_choice(&s->bytes, 255));
    s->snapshot[at] ^= flip;
    TRY(s, thud_world_restore(s->world, s->snapshot, s->snapshot_bytes));
    s->snapshot[at] ^= flip;
    if (s->result == THUD_OK) {
        fuzz_fail(s, "a snapshot whose byte %zu is damaged is taken", at);
    }
    TRY(s, thud_world_restore(s->world, s->snapshot, s->snapshot_bytes - at % 16 - 1));
    if (s->result == THUD_OK) {
        fuzz_fail(s, "a snapshot that is cut short is taken");
    }
}
