/* session.c: see session.h. */
#include "calls.h"
#include "oracles.h"
#include "pick.h"
#include "some_threads.h"

#include <thud/thud_testing.h>

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

_Noreturn void fuzz_fail(const fuzz_session *s, const char *format, ...) {
    static const char *const twins[] = {"none",     "broadphase", "baseline", "shift",
                                        "snapshot", "workers",    "memory",   "float mode"};
    va_list values;
    va_start(values, format);
    fprintf(stderr, "FINDING (twin: %s, %s; operation %d: %s%s): ", twins[s->twin],
            s->second ? "second" : "first", s->operations, s->operation ? s->operation : "none yet",
            s->depth ? ", inside a callback" : "");
    vfprintf(stderr, format, values);
    fprintf(stderr, "\n");
    va_end(values);
    abort();
}

/* ---- hooks ---- */

/* The world's allocator; an allocation fails when `memory_allowed` is 0. */
static void *allocate(size_t bytes, void *context) {
    fuzz_session *s = context;
    if (s->memory_allowed == 0) {
        s->memory_allowed = -2; /* this allocation fails, and all later ones succeed */
        return NULL;
    }
    s->memory_allowed -= s->memory_allowed > 0;
    s->memory_held++;
    return aligned_alloc(64, (bytes + 63) / 64 * 64);
}

static void release(void *block, size_t bytes, void *context) {
    (void)bytes;
    ((fuzz_session *)context)->memory_held--;
    free(block);
}

/* The world's log: checks and counts the messages. */
static void listen(thud_result result, const char *message, void *context) {
    fuzz_session *s = context;
    if (!message || !message[0] || (unsigned)result > THUD_ERROR_LOCKED) {
        fuzz_fail(s, "the log hears of result %d without a word", (int)result);
    }
    s->told++;
    s->heard = result;
}

/* The world's clock: advances by 0.1 ms per call. */
static double tell_time(void *context) {
    fuzz_session *s = context;
    return s->clock += 1e-4;
}

/* A job system without threads: the workers' tasks run one after the other. */
static void run_in_turn(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)context;
    for (int i = 0; i < workers; i++) {
        task(argument);
    }
}

/* Real threads for one in eight inputs, and for all if FUZZ_THREADS is set. */
static thud_job_system job_system(unsigned byte) {
    static thud_threads *threads;
    if (byte % 8 != 0 && !getenv("FUZZ_THREADS")) {
        return (thud_job_system){.run = run_in_turn,
                                 .workers = 2 + (int)(byte % 3),
                                 .stages = byte % 2 ? NULL : &thud_shared_stages_all,
                                 .share_from = 1};
    }
    threads = threads ? threads : some_threads(3);
    thud_job_system shared = thud_job_system_of(threads);
    shared.share_from = 1;
    return shared;
}

/* ---- settings ---- */

/* Reads the world's settings from the fuzzer's first bytes. */
static void take_settings(fuzz_session *s) {
    fuzz_bytes *b = &s->bytes;
    unsigned choices = next_byte(b), scales = next_byte(b), flags = next_byte(b);
    const thud_quality *quality = pick_quality(s, choices);
    thud_world_def def =
        scales < 240 ? thud_default_world_def_of(quality) : thud_default_small_world_def(quality);
    def.detection = pick_detection(s, choices / 4);
    def.sleeping = flags & 1 && def.parts; /* else make_world sets it */
    s->sleeping = flags & 1;
    def.contact_events = (flags & 6) != 6;
    def.gravity.y = flags & 8 ? 0.0f : def.gravity.y;
    def.max_error = flags & 16 && def.quality->islands ? 0.01 : 0.0;
    def.substeps = flags & 32 ? 1 + (int)(flags >> 6) : 0;
    def.restitution_threshold = flags & 64 ? 0.0f : def.restitution_threshold;
    static const double steps[] = {1.0 / 60, 1.0 / 30, 1.0 / 240, 1.0 / 60, 0.1, 1.0};
    def.time_step = steps[scales / 8 % 6];
    static const float units[] = {1, 1, 0.015625f, 64, 1, 0.001f, 1000, 3};
    def.length_scale = units[s->twin == TWIN_SHIFT ? scales % 5 : scales % 8];
    s->unit = (double)def.length_scale;
    def.gravity.y *= def.length_scale;
    if (flags & 128 && def.parts && s->twin != TWIN_SNAPSHOT && s->twin != TWIN_MEMORY) {
        def.time_budget = 1e-3;
    }
    s->def = def;
}

/* Sets allocator, log, clock and listeners. */
static void take_hooks(fuzz_session *s) {
    s->def.allocator = (thud_allocator){allocate, release, s};
    s->def.log = listen;
    s->def.clock = tell_time;
    s->def.log_context = s->def.clock_context = s->listeners.context = s;
    s->listeners.prologue = s->mood ? session_prologue : NULL;
    s->listeners.epilogue = s->mood ? session_epilogue : NULL;
}

/* Applies what distinguishes the second session from the first, by the kind of twin; the broadphase
 * of both follows from the byte. */
static void take_twin(fuzz_session *s, unsigned byte) {
    static const thud_broadphase *const broadphases[] = {
        &thud_broadphase_grid,    &thud_broadphase_sweep,        &thud_broadphase_all,
        &thud_broadphase_sweep_y, &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
    static const float cells[] = {0, 0, 0, 0.01f, 1, 1000};
    bool other = s->second;
    s->def.broadphase = broadphases[(byte + (other && s->twin == TWIN_BROADPHASE)) % 6];
    s->def.cell_size =
        cells[(byte / 8 + (other && s->twin == TWIN_BROADPHASE)) % 6] * s->def.length_scale;
    thud_world_def_set_baseline_simd(&s->def, other && s->twin == TWIN_BASELINE);
    if (other && s->twin == TWIN_SHIFT) {
        double unit = s->unit;
        s->shift_x = byte & 4 ? 1e7 * unit : -65536 * unit;
        s->shift_y = byte & 8 ? -9999999 * unit : 12345 * unit;
    }
    if (other && s->twin == TWIN_WORKERS) {
        s->def.job_system = job_system(byte);
    }
}

static void make_world(fuzz_session *s, thud_world **out) {
    thud_result result = COUNTED(thud_world_create(&s->def, out));
    if (result != THUD_OK) {
        fuzz_fail(s, "no world: %s", thud_result_text(result));
    }
    if (s->sleeping) {
        COUNTED(thud_world_set_sleeping(*out, true));
    }
    COUNTED(thud_world_use_step_error(*out));
    COUNTED(thud_world_use_joints(*out));
    COUNTED(thud_world_set_listeners(*out, &s->listeners));
    if (s->told_categories) {
        COUNTED(
            thud_world_set_category_epilogue(*out, s->told_categories, session_object_epilogue, s));
    }
    COUNTED(thud_world_use_rules(*out));
    COUNTED(thud_world_use_textures(*out));
    session_take_filter(s, *out);
}

static void make_foreign_handles(fuzz_session *s) {
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    make_world(s, &s->other);
    for (int i = 0; i < 3; i++) {
        if (thud_body_create(s->other, &body, &s->foreign_body) != THUD_OK ||
            thud_shape_create_circle(s->other, s->foreign_body, &shape, (thud_vec2){0, 0},
                                     (float)s->unit, &s->foreign_shape) != THUD_OK) {
            fuzz_fail(s, "no foreign handles");
        }
    }
}

void session_open(fuzz_session *s, const uint8_t *data, size_t size, bool second) {
    memset(s, 0, sizeof *s);
    s->bytes = (fuzz_bytes){data, data + size, false};
    s->second = second;
    s->memory_allowed = -1;
    s->twin = (twin_kind)next_choice(&s->bytes, TWIN_COUNT);
    unsigned manner = next_byte(&s->bytes), twin = next_byte(&s->bytes);
    s->asks = second && twin & 128;
    static const int moods[] = {0, 9, 4, 2};
    s->mood = moods[manner / 2 % 4];
    take_settings(s);
    for (int i = 0; i < SESSION_SCRIPT; i++) {
        s->script[i] = (uint8_t)next_byte(&s->bytes);
    }
    take_twin(s, twin);
    take_hooks(s);
    s->now.mover = thud_default_mover(
        (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .y = 2 * s->unit, .c = 1, .hx = 0.4 * s->unit});
    s->now.mover.shape.x += s->shift_x;
    s->now.mover.shape.y += s->shift_y;
    make_world(s, &s->world);
    make_foreign_handles(s);
    session_populate(s, (int)(manner >> 3));
    s->bytes.hostile = manner & 1;
}

bool session_over(const fuzz_session *s) {
    return s->bytes.at == s->bytes.end || s->operations == SESSION_OPERATIONS_MAX;
}

void session_replace_world(fuzz_session *s) {
    size_t bytes = 0;
    thud_world *next = NULL;
    s->operation = "going on in another world";
    TRY(s, thud_world_get_snapshot_size(s->world, &bytes));
    char *snapshot = malloc(bytes);
    TRY(s, thud_world_snapshot(s->world, snapshot, bytes, NULL));
    make_world(s, &next);
    thud_result result = COUNTED(thud_world_restore(next, snapshot, bytes));
    if (result != THUD_OK) {
        fuzz_fail(s, "a snapshot is refused: %s", thud_result_text(result));
    }
    if (thud_hash_of(next) != thud_hash_of(s->world)) {
        fuzz_fail(s, "a world has another hash than the one that it was restored from");
    }
    COUNTED(thud_world_destroy(s->world));
    s->world = next;
    free(snapshot);
}

void session_question(fuzz_session *s) {
    thud_pos middle = {s->shift_x, s->shift_y + 2 * s->unit};
    thud_ray_hit hit;
    bool met;
    size_t bytes = 0;
    s->operation = "a question";
    thud_world_cast_ray(s->world, &(thud_ray){middle, 8 * s->unit, -2 * s->unit, NULL}, &met, &hit);
    thud_measure_of(s->world);
    thud_step_error_of(s->world);
    if (thud_world_get_snapshot_size(s->world, &bytes) == THUD_OK) {
        char *snapshot = malloc(bytes);
        thud_world_snapshot(s->world, snapshot, bytes, NULL);
        free(snapshot);
    }
    fuzz_calls_made += 5;
}

void session_close(fuzz_session *s) {
    s->operation = "the end";
    s->closing = true;
    s->mood = 0;
    oracle_end(s);
    fuzz_calls_made += 2;
    thud_world_destroy(s->world);
    thud_world_destroy(s->other);
    free(s->snapshot);
    free(s->call_snapshots);
    if (s->memory_held != 0) {
        fuzz_fail(s, "%ld blocks of memory were not given back", s->memory_held);
    }
}
