/* recorder.c: the frames of recorded calls, segments, hashes and keyframes; see recorder.h, and
 * recording.h for the format. Nothing here fails a call of the world: if memory is short, the
 * recording ends, and thud_recorder_get_bytes returns an error. */
#include "recording/recorder.h"

#include "recording/repeats.h"
#include "rules/rules.h"
#include "sessions/packed.h"
#include "state/handles.h"
#include "thud/thud_snapshot.h"

#include <string.h>

/* Defaults of options: a hash every 60 steps, which are a second at 60 Hz, and four keyframes in
 * the length of a ring. Chosen. */
enum { HASH_STEPS = 60, KEYFRAMES_A_RING = 4 };

/* Bytes of records after which a segment ends, so that the search for repeats, at the end of the
 * segment, does not delay a step for long. Chosen. */
enum { SEGMENT_BYTES = 1 << 14 };

/* ---- segments ---- */

/* Adds a segment with these contents to `whole`. */
static void write_segment(thud_recorder *r, unsigned kind, uint64_t steps, const void *contents,
                          size_t count) {
    td_writer *to = &r->whole;
    size_t at = to->count;
    td_write_byte(to, kind);
    td_write_fixed(to, r->number++, 4);
    td_write_fixed(to, steps, 8);
    td_write_fixed(to, count, 8);
    td_write_bytes(to, contents, count);
    uint64_t sum = to->broken ? 0 : td_stream_sum(to->bytes + at, to->count - at);
    td_write_fixed(to, sum, TD_SEGMENT_SUM);
    if (r->options.ring_steps > 0 && kind != TD_SEGMENT_END) {
        if (td_array_reserve(&r->memory, &r->places, r->places.count + 1)) {
            TD_PUSH(td_segment_place, &r->places) =
                (td_segment_place){at, steps, kind == TD_SEGMENT_KEYFRAME};
        } else {
            r->failed = true;
        }
    }
    r->failed |= to->broken || r->records.broken;
}

/* Passes the finished segments to the sink, and drops them. */
static void deliver(thud_recorder *r) {
    if (r->options.sink && !r->failed && r->whole.count > 0) {
        r->failed = !r->options.sink(r->whole.bytes, r->whole.count, r->options.context);
        r->whole.count = 0;
    }
}

/* Ends the segment of records under way, if it has any. */
static void finish_records(thud_recorder *r) {
    td_record_flush_steps(r);
    if (r->records.count > 0) {
        td_writer *to = &r->shorter;
        td_write_count(to, r->records.count);
        td_repeats_write(to, r->records.bytes, r->records.count);
        r->failed |= to->broken;
        write_segment(r, TD_SEGMENT_CALLS, r->begun, to->bytes, to->count);
        r->records.count = to->count = 0;
    }
    r->begun = r->time;
}

/* With a ring, finds the latest keyframe after which at least ring_steps steps are recorded, and
 * drops all segments before it. The recording then begins with that keyframe. */
static void drop_segments(thud_recorder *r) {
    int first = 0;
    for (int i = 1; i < r->places.count; i++) {
        const td_segment_place *place = TD_AT(td_segment_place, &r->places, i);
        if (place->keyframe && place->steps + (uint64_t)r->options.ring_steps <= r->time) {
            first = i;
        }
    }
    if (first == 0 || r->failed) {
        return;
    }
    td_segment_place *places = r->places.data;
    size_t dropped = places[first].at - TD_RECORDING_HEAD;
    memmove(r->whole.bytes + TD_RECORDING_HEAD, r->whole.bytes + TD_RECORDING_HEAD + dropped,
            r->whole.count - TD_RECORDING_HEAD - dropped);
    r->whole.count -= dropped;
    r->places.count -= first;
    for (int i = 0; i < r->places.count; i++) {
        places[i] = places[i + first];
        places[i].at -= dropped;
    }
}

/* Writes the length of a packed snapshot of the world, and the snapshot. */
static void write_state(thud_recorder *r, td_writer *to) {
    thud_world *w = r->world;
    size_t bytes = 0, packed = 0;
    thud_world_get_snapshot_size(w, &bytes);
    size_t room = td_packed_max(bytes);
    char *snapshot = td_memory_get(&r->memory, bytes + room);
    if (!snapshot) {
        r->failed = true;
        return;
    }
    thud_world_snapshot(w, snapshot, bytes, NULL);
    thud_world_pack(w, (thud_bytes){NULL, 0}, (thud_bytes){snapshot, bytes}, snapshot + bytes, room,
                    &packed);
    td_write_count(to, packed);
    td_write_bytes(to, snapshot + bytes, packed);
    td_memory_put(&r->memory, snapshot, bytes + room);
}

static void write_keyframe(thud_recorder *r) {
    finish_records(r);
    td_writer *to = &r->records;
    td_recording_write_def(to, r->world);
    td_write_byte(to, r->calls);
    td_write_count(to, r->without);
    write_state(r, to);
    write_segment(r, TD_SEGMENT_KEYFRAME, r->time, to->bytes, to->count);
    to->count = 0;
    r->keyed_at = r->time;
    drop_segments(r);
}

/* Writes the end segment: the present number of steps, and the hash of the world. */
static void write_end(thud_recorder *r) {
    uint64_t hash = 0;
    finish_records(r);
    thud_world_get_hash(r->world, &hash);
    td_writer *to = &r->records;
    td_write_fixed(to, hash, 8);
    write_segment(r, TD_SEGMENT_END, r->time, to->bytes, to->count);
    to->count = 0;
}

/* ---- hashes ---- */

static void write_hash(thud_recorder *r) {
    const thud_world *w = r->world;
    td_writer *to = &r->records;
    uint64_t hash = 0;
    td_record_flush_steps(r);
    thud_world_get_hash(w, &hash);
    td_write_byte(to, r->options.body_hashes ? TD_RECORD_BODIES : TD_RECORD_HASH);
    td_write_fixed(to, hash, 8);
    if (r->options.body_hashes) {
        td_write_count(to, (uint64_t)w->bodies.count);
        for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
            td_write_fixed(to, td_recording_body_hash(w, i), 2);
        }
    }
}

/* Called after every call that is not within another: writes a hash, ends the segment or writes a
 * keyframe, if it is due. */
static void take_stock(thud_recorder *r) {
    const thud_world *w = r->world;
    bool finishes = r->records.count > SEGMENT_BYTES;
    if (r->time - r->hashed_at >= (uint64_t)r->options.hash_steps) {
        /* No hash while nothing changes and all bodies sleep. Awake slot 0 stands for static
         * bodies, so that a count of 1 means that none is awake. */
        if (r->changed || w->body_of.count > 1) {
            write_hash(r);
            finishes |= r->options.sink != NULL;
        }
        r->hashed_at = r->time;
        r->changed = false;
    }
    if (finishes) {
        finish_records(r);
        deliver(r);
    }
    if (r->options.keyframe_steps > 0 &&
        r->time - r->keyed_at >= (uint64_t)r->options.keyframe_steps) {
        write_keyframe(r);
        deliver(r);
    }
}

/* ---- frames ---- */

/* Whether no call of the world is under way, so that a snapshot of it can be taken. */
static bool is_between_calls(const thud_recorder *r) {
    return !r->frame && !r->world->locked && !r->world->advancing;
}

/* Writes a snapshot of the world if it was changed by calls that are not recorded (`stale`). */
static void catch_up(thud_recorder *r) {
    r->stale |= r->world->steps != r->steps;
    if (r->stale) {
        td_record_flush_steps(r);
        td_write_byte(&r->records, TD_RECORD_STATE);
        write_state(r, &r->records);
        r->stale = false;
        r->changed = true;
        r->steps = r->world->steps;
    }
}

void td_record_open(td_record_frame *frame, thud_world *w, int call, const void *const *args) {
    thud_recorder *r = w ? w->recorder : NULL;
    *frame = (td_record_frame){.recorder = r && !r->failed ? r : NULL};
    if (!frame->recorder) {
        return;
    }
    if (is_between_calls(r)) {
        catch_up(r);
        td_record_take_callbacks(r);
    }
    frame->outer = r->frame;
    frame->call = call;
    frame->args = args;
    frame->locked = w->locked && !r->locked;
    r->frame = frame;
}

/* Writes a call that has returned THUD_OK. */
static void write_call(thud_recorder *r, td_record_frame *frame) {
    const td_recorded_call *call = &td_recorded_calls[frame->call];
    td_writer *to = &r->records;
    bool step = frame->call == TD_CALL_WORLD_STEP && !frame->opened && !frame->outer;
    r->changed |= !step && !call->query;
    if (step && !frame->locked) {
        r->waiting++;
        return;
    }
    if (frame->opened) {
        td_write_byte(to, TD_RECORD_CLOSE);
    } else {
        td_record_place(r, frame);
        td_write_byte(to, TD_RECORD_CALL + (unsigned)frame->call);
        td_codec_write(r->world, to, call, frame->args);
    }
    td_codec_write_outs(r->world, to, call, frame->args);
    if (call->query) {
        const void *const found[] = {&frame->hit_count, &frame->hits};
        td_codec_write(r->world, to, &td_recorded_hits, found);
    }
}

static bool is_step(int call) {
    return call == TD_CALL_WORLD_STEP || call == TD_CALL_WORLD_ADVANCE ||
           call == TD_CALL_WORLD_ADVANCE_WITH;
}

/* Writes that a call outside callbacks was refused. If calls within its callbacks were recorded,
 * removes its records instead. Then, and after a step that ran out of memory, the world may have
 * changed: catch_up writes a snapshot. */
static void write_refusal(thud_recorder *r, td_record_frame *frame, thud_result result) {
    if (frame->opened) {
        r->records.count = frame->start;
        r->stale = true;
    } else if (!frame->outer) {
        td_record_flush_steps(r);
        td_write_byte(&r->records, TD_RECORD_REFUSED);
        td_write_count(&r->records, (uint64_t)frame->call);
        td_write_byte(&r->records, result);
    }
    r->stale |= is_step(frame->call) && result == THUD_ERROR_MEMORY;
}

thud_result td_record_close(td_record_frame *frame, thud_result result) {
    thud_recorder *r = frame->recorder;
    if (!r) {
        return result;
    }
    r->frame = frame->outer;
    if (result == THUD_OK) {
        write_call(r, frame);
    } else {
        write_refusal(r, frame, result);
    }
    if (is_between_calls(r)) {
        if (result == THUD_OK) {
            r->time += r->world->steps - r->steps;
            r->steps = r->world->steps;
        }
        catch_up(r);
        take_stock(r);
    }
    r->failed |= r->records.broken;
    return result;
}

void td_record_query(thud_world *w, int call, const void *const *args, const thud_ray_hit *hits,
                     int count) {
    if (!td_records_queries(w)) {
        return;
    }
    td_record_frame frame;
    td_record_open(&frame, w, call, args);
    frame.hits = hits;
    frame.hit_count = count;
    td_record_close(&frame, THUD_OK);
}

void td_record_restored(thud_world *w) {
    thud_recorder *r = w ? w->recorder : NULL;
    if (r && !r->failed) {
        r->stale = true;
    }
}

/* ---- the public calls ---- */

/* Why options are refused; null: they are valid. */
static const char *error_of(const thud_world *w, const thud_recorder_options *o, td_reason *why) {
    double max = THUD_RECORDING_STEPS_MAX;
    if (!td_in(why, "recorder: hash_steps", o->hash_steps, 0.0, max) ||
        !td_in(why, "recorder: keyframe_steps", o->keyframe_steps, 0.0, max) ||
        !td_in(why, "recorder: ring_steps", o->ring_steps, 0.0, max)) {
        return why->text;
    }
    if (o->sink && o->ring_steps > 0) {
        return "recorder: a ring is kept in memory, and has no sink";
    }
    if (w->recorder) {
        return "recorder: the world is being recorded";
    }
    return w->def.time_budget > 0.0 ? "recorder: a world with a time_budget depends on the clock"
                                    : NULL;
}

static void free_recorder(thud_recorder *r) {
    td_memory memory = r->memory;
    td_writer_free(&r->whole);
    td_writer_free(&r->records);
    td_writer_free(&r->shorter);
    td_array_free(&memory, &r->places);
    td_memory_put(&memory, r, sizeof *r);
}

thud_result thud_recorder_begin(thud_world *w, const thud_recorder_options *options,
                                thud_recorder **out) {
    static const thud_recorder_options defaults;
    thud_recorder_options o = options ? *options : defaults;
    td_reason why;
    if (!w || !out) {
        return td_refuse(w, THUD_ERROR_NULL, "recorder: world or out is null");
    }
    if (w->locked || w->advancing) {
        return td_refuse(w, THUD_ERROR_LOCKED, "recorder: not inside a callback");
    }
    const char *error = error_of(w, &o, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    td_memory memory = td_memory_make(w->def.allocator);
    thud_recorder *r = td_memory_get(&memory, sizeof *r);
    if (!r) {
        return td_refuse(w, THUD_ERROR_MEMORY, "recorder: out of memory");
    }
    o.hash_steps = o.hash_steps ? o.hash_steps : HASH_STEPS;
    if (o.ring_steps > 0 && o.keyframe_steps == 0) {
        o.keyframe_steps = td_max_int(o.ring_steps / KEYFRAMES_A_RING, 1);
    }
    *r = (thud_recorder){.world = w,
                         .memory = memory,
                         .options = o,
                         .whole = {.memory = memory},
                         .records = {.memory = memory},
                         .shorter = {.memory = memory},
                         .places = {.stride = (int)sizeof(td_segment_place)},
                         .steps = w->steps};
    td_write_bytes(&r->whole, TD_RECORDING_MAGIC, sizeof TD_RECORDING_MAGIC);
    td_write_fixed(&r->whole, TD_RECORDING_VERSION, 4);
    w->recorder = r;
    td_record_take_callbacks(r);
    r->records.count = 0; /* drops the TD_RECORD_LISTENERS just written: the keyframe, which is
                             written next, lists the callbacks itself */
    write_keyframe(r);
    deliver(r);
    if (r->failed) {
        td_record_return_callbacks(r);
        w->recorder = NULL;
        free_recorder(r);
        return td_refuse(w, THUD_ERROR_MEMORY, "recorder: out of memory, or the sink has failed");
    }
    *out = r;
    return THUD_OK;
}

void td_record_leave_world(thud_world *w) {
    thud_recorder *r = w ? w->recorder : NULL;
    if (!r || w->locked || w->advancing) {
        return;
    }
    if (!r->failed) {
        catch_up(r);
        write_end(r);
        deliver(r);
    }
    td_record_return_callbacks(r);
    w->recorder = NULL;
    r->world = NULL;
}

void thud_recorder_end(thud_recorder *r) {
    if (!r) {
        return;
    }
    if (r->world && (r->world->locked || r->world->advancing)) {
        td_refuse(r->world, THUD_ERROR_LOCKED, "recorder end: not inside a callback");
        return;
    }
    td_record_leave_world(r->world);
    free_recorder(r);
}

/* Refuses a call for a recording that has failed, and inside a callback. */
static thud_result check(const thud_recorder *r) {
    const thud_world *w = r->world;
    if (w && (r->frame || w->locked || w->advancing)) {
        return td_refuse(w, THUD_ERROR_LOCKED, "recorder: not inside a callback");
    }
    return r->failed ? td_refuse(w, THUD_ERROR_MEMORY,
                                 "recorder: memory was short, and the recording has ended")
                     : THUD_OK;
}

thud_result thud_recorder_salvage(thud_recorder *r, thud_bytes *out) {
    if (!r || !out) {
        return THUD_ERROR_NULL;
    }
    if (r->options.sink) {
        return THUD_ERROR_INVALID;
    }
    td_record_frame *frame = r->frame;
    while (frame && frame->outer) {
        frame = frame->outer;
    }
    if (frame && frame->opened) {
        r->records.count = frame->start; /* removes the records of the call under way: without its
                                            end it cannot be played */
    }
    if (r->world && !r->failed) {
        if (frame && is_step(frame->call)) {
            uint64_t steps = r->world->steps - r->steps + 1;
            r->waiting += steps;
            r->time += steps;
        }
        finish_records(r);
        write_segment(r, TD_SEGMENT_END, r->time, NULL, 0);
    }
    bool done = !r->failed;
    r->failed = true;
    r->frame = NULL;
    *out = (thud_bytes){r->whole.bytes, r->whole.count};
    return done ? THUD_OK : THUD_ERROR_MEMORY;
}

thud_result thud_recorder_get_bytes(thud_recorder *r, thud_bytes *out) {
    if (!r || !out) {
        return THUD_ERROR_NULL;
    }
    thud_result result = check(r);
    if (result == THUD_OK && r->options.sink) {
        result = td_refuse(r->world, THUD_ERROR_INVALID, "recorder: the sink has the bytes");
    }
    if (result != THUD_OK) {
        return result;
    }
    if (!r->world) { /* it was finished with its world */
        *out = (thud_bytes){r->whole.bytes, r->whole.count};
        return THUD_OK;
    }
    catch_up(r);
    finish_records(r);
    size_t count = r->whole.count;
    uint32_t number = r->number;
    write_end(r);
    if (r->failed) {
        return td_refuse(r->world, THUD_ERROR_MEMORY, "recorder: out of memory");
    }
    *out = (thud_bytes){r->whole.bytes, r->whole.count};
    /* The recording goes on: the next segment will overwrite the end segment, which stays in memory
     * until then. */
    r->whole.count = count;
    r->number = number;
    return THUD_OK;
}

thud_result thud_recorder_add_chunk(thud_recorder *r, const char *name, thud_bytes bytes) {
    if (!r || !name || (!bytes.data && bytes.count > 0)) {
        return THUD_ERROR_NULL;
    }
    thud_result result = check(r);
    if (result != THUD_OK || !r->world) {
        return result;
    }
    catch_up(r);
    td_record_flush_steps(r);
    size_t length = strlen(name);
    td_write_byte(&r->records, TD_RECORD_CHUNK);
    td_write_count(&r->records, length);
    td_write_bytes(&r->records, name, length);
    td_write_count(&r->records, bytes.count);
    td_write_bytes(&r->records, bytes.data, bytes.count);
    r->failed |= r->records.broken;
    return check(r);
}
