/* player.c: plays recordings (thud_recording.h); their format is in recording.h. */
#include "recording/play_call.h"
#include "recording/recorded_calls.h"
#include "recording/repeats.h"
#include "state/handles.h"
#include "thud/thud_all.h"

#include <string.h>

/* A keyframe: the place and size of its contents in the recording, and the number of steps before
 * it. */
typedef struct td_keyframe {
    size_t at, count;
    uint64_t steps;
} td_keyframe;

struct thud_player {
    td_play play;
    td_memory memory;
    thud_player_options options;
    const uint8_t *bytes;
    size_t count;
    size_t next;         /* where the next segment begins */
    td_array keyframes;  /* td_keyframe */
    td_array records;    /* uint8_t: of the segment under way */
    uint64_t waiting;    /* steps to be made before the next record */
    uint64_t first, end; /* the step numbers with which the recording begins and ends */
    uint64_t steps;      /* made so far */
    uint64_t same_at;    /* number of steps at the last hash that was equal */
    int64_t hashes;      /* number of hashes that were compared */
    uint64_t differs_at; /* steps at which play.differs was set */
    thud_body_id body;   /* the first body whose hash differed */
    bool ended;          /* the hash at the end has been compared */
};

/* Refuses a call, with the reason to the log of the options: there may be no world yet. */
static thud_result refuse(const thud_player_options *o, thud_result result, const char *message) {
    if (o->log) {
        o->log(result, message, o->log_context);
    }
    return result;
}

/* ---- segments ---- */

typedef struct segment {
    unsigned kind;
    uint32_t number;
    uint64_t steps;
    size_t at, count; /* its contents */
    size_t next;      /* the segment after it */
} segment;

/* The segment at a place. False where it is cut short. */
static bool read_segment(const uint8_t *bytes, size_t end, size_t at, segment *out) {
    td_reader from = {bytes, at, end, false};
    out->kind = td_read_byte(&from);
    out->number = (uint32_t)td_read_fixed(&from, 4);
    out->steps = td_read_fixed(&from, 8);
    uint64_t count = td_read_fixed(&from, 8);
    out->at = from.at;
    if (!td_read_bytes(&from, count) || !td_read_bytes(&from, TD_SEGMENT_SUM)) {
        return false;
    }
    out->count = (size_t)count;
    out->next = from.at;
    return true;
}

/* Whether the checksum after the contents is right. */
static bool is_whole(const uint8_t *bytes, size_t at, const segment *s) {
    td_reader sum = {bytes, s->at + s->count, s->next, false};
    return td_read_fixed(&sum, TD_SEGMENT_SUM) == td_stream_sum(bytes + at, s->at + s->count - at);
}

/* Walks over all segments, lists the keyframes, and tests everything that can be tested without a
 * world. Returns the reason why the bytes are refused, or null. */
static const char *find_segments(thud_player *p, bool *short_of_memory) {
    static const char damaged[] = "player: the recording is damaged or cut short";
    const uint8_t *bytes = p->bytes;
    if (p->count < TD_RECORDING_HEAD ||
        memcmp(bytes, TD_RECORDING_MAGIC, sizeof TD_RECORDING_MAGIC) != 0) {
        return "player: this is no recording";
    }
    td_reader version = {bytes, sizeof TD_RECORDING_MAGIC, p->count, false};
    if (td_read_fixed(&version, 4) != TD_RECORDING_VERSION) {
        return "player: the recording is of another version of thud";
    }
    segment s = {.kind = 0};
    uint32_t number = 0;
    for (size_t at = TD_RECORDING_HEAD; s.kind != TD_SEGMENT_END; at = s.next) {
        bool first = at == TD_RECORDING_HEAD;
        uint64_t before = first ? 0 : s.steps;
        if (!read_segment(bytes, p->count, at, &s) || !is_whole(bytes, at, &s) ||
            (!first && s.number != number + 1) || s.steps < before || s.steps > INT64_MAX ||
            (first && s.kind != TD_SEGMENT_KEYFRAME)) {
            return damaged;
        }
        number = s.number;
        if (s.kind == TD_SEGMENT_KEYFRAME) {
            if (!td_array_reserve(&p->memory, &p->keyframes, p->keyframes.count + 1)) {
                *short_of_memory = true;
                return "player: out of memory";
            }
            TD_PUSH(td_keyframe, &p->keyframes) = (td_keyframe){s.at, s.count, s.steps};
        }
    }
    p->first = TD_AT(td_keyframe, &p->keyframes, 0)->steps;
    p->end = s.steps;
    return s.next == p->count ? NULL : damaged;
}

/* ---- state ---- */

/* Restores the world from the packed snapshot that comes next. */
static thud_result read_state(thud_player *p, td_reader *from) {
    thud_world *w = p->play.world;
    uint64_t count = td_read_count(from);
    thud_bytes packed = {td_read_bytes(from, count), (size_t)count}, none = {NULL, 0};
    size_t bytes = 0;
    if (!packed.data) {
        return td_refuse(w, THUD_ERROR_INVALID, "player: the recording contradicts itself");
    }
    thud_result result = thud_world_unpack(w, none, packed, NULL, 0, &bytes);
    if (result != THUD_OK) {
        return result;
    }
    char *snapshot = td_memory_get(&p->memory, bytes);
    if (!snapshot) {
        return td_refuse(w, THUD_ERROR_MEMORY, "player: out of memory");
    }
    result = thud_world_unpack(w, none, packed, snapshot, bytes, &bytes);
    result = result == THUD_OK ? thud_world_restore(w, snapshot, bytes) : result;
    td_memory_put(&p->memory, snapshot, bytes);
    return result;
}

/* Goes to a keyframe. */
static thud_result go_to(thud_player *p, const td_keyframe *keyframe) {
    td_reader from = {p->bytes, keyframe->at, keyframe->at + keyframe->count, false};
    thud_world_def def = thud_default_world_def();
    if (!td_recording_read_def(&from, &def)) {
        return td_refuse(p->play.world, THUD_ERROR_INVALID,
                         "player: the recording contradicts itself");
    }
    unsigned calls = td_read_byte(&from);
    uint32_t without = (uint32_t)td_read_count(&from);
    thud_result result = read_state(p, &from);
    if (result != THUD_OK) {
        return result;
    }
    if (!td_play_set_callbacks(&p->play, calls, without)) {
        return td_refuse(p->play.world, THUD_ERROR_MEMORY, "player: out of memory");
    }
    p->play.from = (td_reader){p->bytes, 0, 0, false};
    p->play.frame = NULL;
    p->play.differs = p->play.short_of_memory = p->ended = false;
    p->body = (thud_body_id){0, 0};
    p->next = keyframe->at + keyframe->count + TD_SEGMENT_SUM;
    p->waiting = 0;
    p->steps = p->same_at = keyframe->steps;
    return THUD_OK;
}

/* ---- calls ---- */

/* Calls options.call for a call whose arguments are not known, with the result that it had. */
static void tell_result(td_play *p, const char *name, thud_result recorded) {
    const thud_player_options *o = &((thud_player *)p)->options; /* `play` is its first member */
    if (o->call) {
        o->call(&(thud_played_call){.name = name, .result = recorded}, o->context);
    }
}

/* Calls options.call for a call that was accepted. `found`: the hits of a query, else null. */
static void tell_call(td_play *p, const td_recorded_call *call, const td_decoded *decoded,
                      const td_decoded *found) {
    thud_player *player = (thud_player *)p; /* `play` is its first member */
    const thud_player_options *o = &player->options;
    if (!o->call) {
        return;
    }
    thud_played_call told = {.name = call->name,
                             .value_count = td_call_values(call, decoded, NULL),
                             .returned = td_call_returned(call, decoded),
                             .query = call->query};
    size_t bytes = ((size_t)told.value_count + 1) * sizeof(thud_call_value);
    thud_call_value *values = td_memory_get(&player->memory, bytes);
    if (!values) {
        p->short_of_memory = true;
        return;
    }
    td_call_values(call, decoded, values);
    told.values = values;
    if (found) {
        told.hit_count = *(const int *)found->args[0];
        told.hits = found->values[1].pointer;
    }
    o->call(&told, o->context);
    td_memory_put(&player->memory, values, bytes);
}

/* Reads arguments, or the hits of a query. False, with the reason in *p, where that fails. */
static bool decode(td_play *p, const td_recorded_call *call, td_decoded *out) {
    bool done = td_codec_read(p->world, &p->from, call, out);
    p->short_of_memory |= out->short_of_memory;
    p->from.broken |= !done && !out->short_of_memory;
    return done;
}

/* Tells of a query, whose arguments have been read, and whose hits come next. */
static void play_query(td_play *p, const td_recorded_call *call, const td_decoded *decoded) {
    td_decoded found = {.memory = p->memory};
    if (decode(p, &td_recorded_hits, &found)) {
        tell_call(p, call, decoded, &found);
    }
    td_decoded_free(&found);
}

/* Makes the call of this number, and compares what it returns. `opened`: records of its callbacks
 * come next. */
static void make_recorded_call(td_play *p, int number, td_decoded *decoded, bool opened) {
    const td_recorded_call *call = &td_recorded_calls[number];
    td_play_frame frame = {.outer = p->frame};
    if (opened) {
        td_play_next_callback(p, &frame);
    }
    p->frame = &frame;
    thud_result result = td_play_call(p, p->world, number, decoded);
    p->frame = frame.outer;
    tell_call(p, call, decoded, NULL);
    if (td_play_goes_on(p)) {
        p->short_of_memory = result == THUD_ERROR_MEMORY;
        p->differs = !p->short_of_memory &&
                     (result != THUD_OK || (opened && td_read_byte(&p->from) != TD_RECORD_CLOSE) ||
                      !td_codec_same_outs(p->world, &p->from, call, decoded));
    }
}

/* Plays the call of this number, whose arguments come next. `opened`: they are followed by records
 * of its callbacks. */
static void play_call(td_play *p, uint64_t number, bool opened) {
    if (number >= TD_CALL_COUNT) {
        p->from.broken = true;
        return;
    }
    const td_recorded_call *call = &td_recorded_calls[number];
    td_decoded decoded = {.memory = p->memory, .pass = td_play_pass};
    if (decode(p, call, &decoded)) {
        if (call->query) {
            play_query(p, call, &decoded);
        } else {
            make_recorded_call(p, (int)number, &decoded, opened);
        }
    }
    td_decoded_free(&decoded);
}

/* td_play.record. */
static void play_nested(td_play *p, unsigned record) {
    if (record == TD_RECORD_LOCKED) {
        bool locked = p->world->locked;
        p->world->locked = true;
        play_nested(p, td_read_byte(&p->from));
        p->world->locked = locked;
    } else if (record == TD_RECORD_OPEN) {
        play_call(p, td_read_count(&p->from), true);
    } else if (record >= TD_RECORD_CALL) {
        play_call(p, record - TD_RECORD_CALL, false);
    } else {
        p->from.broken = true;
    }
}

/* ---- making and destroying ---- */

void thud_player_destroy(thud_player *p) {
    if (!p) {
        return;
    }
    thud_world_destroy(p->play.world);
    td_memory memory = p->memory;
    td_array_free(&memory, &p->keyframes);
    td_array_free(&memory, &p->records);
    td_memory_put(&memory, p, sizeof *p);
}

/* Creates the world of the first keyframe, with everything plugged in that a snapshot may need. A
 * recorded world may lack the parts that thud_default_small_world_def leaves out; the snapshot then
 * says which. */
static thud_result make_world(thud_player *p) {
    const thud_player_options *o = &p->options;
    const td_keyframe *keyframe = TD_AT(td_keyframe, &p->keyframes, 0);
    td_reader from = {p->bytes, keyframe->at, keyframe->at + keyframe->count, false};
    thud_world_def def = thud_default_world_def();
    if (!td_recording_read_def(&from, &def)) {
        return refuse(o, THUD_ERROR_INVALID, "player: the recording contradicts itself");
    }
    def.allocator = o->allocator;
    def.log = o->log;
    def.log_context = o->log_context;
    def.job_system = o->job_system;
    def.clock = o->clock;
    def.clock_context = o->clock_context;
    thud_result result = thud_world_create(&def, &p->play.world);
    if (result == THUD_OK) {
        p->play.world->def.parts = NULL; /* the snapshot of the keyframe plugs in the parts that the
                                            recorded world had */
    }
    result = result == THUD_OK ? thud_world_use_joints(p->play.world) : result;
    result = result == THUD_OK ? thud_world_use_rules(p->play.world) : result;
    return result == THUD_OK ? thud_world_use_textures(p->play.world) : result;
}

thud_result thud_player_create(thud_bytes recording, const thud_player_options *options,
                               thud_player **out) {
    static const thud_player_options defaults;
    thud_player_options o = options ? *options : defaults;
    if (!recording.data || !out) {
        return refuse(&o, THUD_ERROR_NULL, "player: recording or out is null");
    }
    if (!o.allocator.allocate != !o.allocator.release) {
        return refuse(&o, THUD_ERROR_INVALID, "player: the allocator lacks a function");
    }
    td_memory memory = td_memory_make(o.allocator);
    thud_player *p = td_memory_get(&memory, sizeof *p);
    if (!p) {
        return refuse(&o, THUD_ERROR_MEMORY, "player: out of memory");
    }
    *p = (thud_player){.memory = memory,
                       .options = o,
                       .bytes = recording.data,
                       .count = recording.count,
                       .keyframes = {.stride = (int)sizeof(td_keyframe)},
                       .records = {.stride = 1}};
    p->play.memory = &p->memory;
    p->play.record = play_nested;
    bool short_of_memory = false;
    const char *error = find_segments(p, &short_of_memory);
    thud_result result = short_of_memory ? THUD_ERROR_MEMORY : THUD_ERROR_INVALID;
    if (error) {
        refuse(&o, result, error);
    } else {
        result = make_world(p);
        result = result == THUD_OK ? go_to(p, TD_AT(td_keyframe, &p->keyframes, 0)) : result;
    }
    if (result != THUD_OK) {
        thud_player_destroy(p);
        return result;
    }
    *out = p;
    return THUD_OK;
}

/* ---- playing ---- */

/* Whether the hash of the world equals the next 8 bytes; if not, sets play.differs. */
static bool is_same_hash(thud_player *p, td_reader *from) {
    uint64_t hash = 0;
    thud_world_get_hash(p->play.world, &hash);
    if (td_read_fixed(from, 8) != hash) {
        p->play.differs = true;
        return false;
    }
    p->hashes++;
    p->same_at = p->steps;
    return true;
}

/* Reads the hashes of bodies. If the world's hash differed (`same` is false), stores the first body
 * whose hash differs. */
static void compare_bodies(thud_player *p, td_reader *from, bool same) {
    const thud_world *w = p->play.world;
    uint64_t count = td_read_count(from);
    for (uint64_t i = 0; i < count && !from->broken; i++) {
        uint16_t hash = (uint16_t)td_read_fixed(from, 2);
        td_body_index body = {(int32_t)i};
        bool there = i < (uint64_t)w->bodies.count;
        if (!same && !p->body.index1 && there && td_recording_body_hash(w, body) != hash) {
            p->body = td_body_handle(w, body);
        }
    }
}

static void play_chunk(thud_player *p, td_reader *from) {
    uint64_t length = td_read_count(from);
    const uint8_t *name = td_read_bytes(from, length);
    uint64_t count = td_read_count(from);
    thud_bytes bytes = {td_read_bytes(from, count), (size_t)count};
    if (from->broken || !p->options.chunk) {
        return;
    }
    char *text = td_memory_get(&p->memory, (size_t)length + 1);
    if (!text) {
        p->play.short_of_memory = true;
        return;
    }
    memcpy(text, name, (size_t)length);
    p->options.chunk(text, bytes, p->options.context);
    td_memory_put(&p->memory, text, (size_t)length + 1);
}

/* Plays the next record, which is not within a call. */
static void play_record(thud_player *p) {
    td_play *play = &p->play;
    td_reader *from = &play->from;
    uint64_t before = play->world->steps;
    unsigned record = td_read_byte(from);
    switch (record) {
    case TD_RECORD_STEPS:
        p->waiting = td_read_count(from);
        break;
    case TD_RECORD_HASH:
        is_same_hash(p, from);
        break;
    case TD_RECORD_BODIES: {
        bool same = is_same_hash(p, from);
        compare_bodies(p, from, same);
        break;
    }
    case TD_RECORD_STATE: {
        thud_result result = read_state(p, from);
        play->short_of_memory |= result == THUD_ERROR_MEMORY;
        from->broken |= result == THUD_ERROR_INVALID;
        tell_result(play, "thud_world_restore", result);
        break;
    }
    case TD_RECORD_LISTENERS: {
        unsigned calls = td_read_byte(from);
        play->short_of_memory |= !td_play_set_callbacks(play, calls, (uint32_t)td_read_count(from));
        break;
    }
    case TD_RECORD_CHUNK:
        play_chunk(p, from);
        break;
    case TD_RECORD_REFUSED: {
        uint64_t number = td_read_count(from);
        thud_result result = (thud_result)td_read_byte(from);
        if (number < TD_CALL_COUNT && !from->broken) {
            tell_result(play, td_recorded_calls[number].name, result);
        }
        break;
    }
    default:
        play_nested(play, record);
        p->steps += play->world->steps - before;
    }
}

/* Begins to read the records of a segment. */
static void begin_records(thud_player *p, const segment *s) {
    td_reader from = {p->bytes, s->at, s->at + s->count, false};
    uint64_t count = td_read_count(&from);
    bool fits = !from.broken && count <= INT32_MAX;
    p->play.short_of_memory = fits && !td_array_reserve(&p->memory, &p->records, (int)count + 1);
    if (p->play.short_of_memory) {
        return;
    }
    fits = fits && td_repeats_read(&from, p->records.data, (size_t)count);
    p->play.from = (td_reader){p->records.data, 0, fits ? (size_t)count : 0, !fits};
}

/* Begins the next segment. The contents of a keyframe are skipped, since the world is in that state
 * already after the records before it. In the end segment the hash is compared, if it has one. */
static void begin_segment(thud_player *p) {
    segment s;
    if (!read_segment(p->bytes, p->count, p->next, &s)) {
        p->play.from.broken = true;
        return;
    }
    if (s.kind == TD_SEGMENT_END) {
        td_reader from = {p->bytes, s.at, s.at + s.count, false};
        if (s.count > 0) {
            is_same_hash(p, &from);
        }
        p->ended = true;
        return;
    }
    p->next = s.next;
    if (s.kind == TD_SEGMENT_CALLS) {
        begin_records(p, &s);
    }
}

/* Whether a hash comes next. It is that of the world after the steps before it, so that it is
 * compared even if playing is to stop at this step. */
static bool is_before_hash(const thud_player *p) {
    const td_reader *from = &p->play.from;
    return p->waiting == 0 && from->at < from->end &&
           (from->bytes[from->at] == TD_RECORD_HASH || from->bytes[from->at] == TD_RECORD_BODIES);
}

/* The result of a call of the player: THUD_OK while records can be played on, else the error, with
 * the reason in the log. */
static thud_result result_of(thud_player *p) {
    td_play *play = &p->play;
    if (play->short_of_memory) {
        return td_refuse(play->world, THUD_ERROR_MEMORY, "player: out of memory");
    }
    if (play->from.broken) {
        return td_refuse(play->world, THUD_ERROR_INVALID,
                         "player: the recording contradicts itself");
    }
    if (play->differs) {
        p->differs_at = p->steps;
        return td_refuse(play->world, THUD_ERROR_INVALID,
                         "player: the world differs from the recording");
    }
    return THUD_OK;
}

thud_result thud_player_step(thud_player *p, bool *out_stepped) {
    if (!p) {
        return THUD_ERROR_NULL;
    }
    td_play *play = &p->play;
    uint64_t before = p->steps;
    while (td_play_goes_on(play) && !p->ended && (p->steps == before || is_before_hash(p))) {
        if (p->waiting > 0) {
            p->waiting--;
            play_call(play, TD_CALL_WORLD_STEP, false);
            p->steps += td_play_goes_on(play);
        } else if (play->from.at == play->from.end) {
            begin_segment(p);
        } else {
            play_record(p);
        }
    }
    if (out_stepped) {
        *out_stepped = p->steps != before;
    }
    return result_of(p);
}

/* The last keyframe at or before a step. Null, with the reason in the log, for a step that the
 * recording does not have. */
static const td_keyframe *keyframe_before(const thud_player *p, int64_t step) {
    if (step < (int64_t)p->first || step > (int64_t)p->end) {
        td_refuse(p->play.world, THUD_ERROR_INVALID, "player: there is no such step");
        return NULL;
    }
    const td_keyframe *from = NULL;
    for (int i = 0; i < p->keyframes.count; i++) {
        const td_keyframe *k = TD_AT(td_keyframe, &p->keyframes, i);
        from = k->steps <= (uint64_t)step ? k : from;
    }
    return from;
}

thud_result thud_player_get_keyframe(const thud_player *p, int64_t step, int64_t *out_step) {
    if (!p || !out_step) {
        return THUD_ERROR_NULL;
    }
    const td_keyframe *from = keyframe_before(p, step);
    if (!from) {
        return THUD_ERROR_INVALID;
    }
    *out_step = (int64_t)from->steps;
    return THUD_OK;
}

thud_result thud_player_seek(thud_player *p, int64_t step) {
    if (!p) {
        return THUD_ERROR_NULL;
    }
    const td_keyframe *from = keyframe_before(p, step);
    if (!from) {
        return THUD_ERROR_INVALID;
    }
    bool back = (uint64_t)step < p->steps || !td_play_goes_on(&p->play);
    thud_result result = back || from->steps > p->steps ? go_to(p, from) : THUD_OK;
    bool stepped = true;
    while (result == THUD_OK && stepped && p->steps < (uint64_t)step) {
        result = thud_player_step(p, &stepped);
    }
    return result;
}

thud_result thud_player_get_world(thud_player *p, thud_world **out) {
    if (!p || !out) {
        return THUD_ERROR_NULL;
    }
    *out = p->play.world;
    return THUD_OK;
}

thud_result thud_player_get_progress(const thud_player *p, thud_player_progress *out) {
    if (!p || !out) {
        return THUD_ERROR_NULL;
    }
    *out = (thud_player_progress){.first = (int64_t)p->first,
                                  .end = (int64_t)p->end,
                                  .steps = (int64_t)p->steps,
                                  .hashes = p->hashes,
                                  .differs = p->play.differs,
                                  .differs_after = (int64_t)p->same_at,
                                  .differs_at = (int64_t)p->differs_at,
                                  .body = p->body};
    return THUD_OK;
}
