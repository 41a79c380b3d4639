/* api_recording.c: exports for recordings, in thud-recorded.wasm alone, where all of this layer is
 * compiled with thud_recorded.h. */
#include "api.h"

#include <thud/thud_recording.h>

#include <stdlib.h>
#include <string.h>

/* ---- recording ---- */

/* Begins to record a world. Slots out: list, whose address is that of the recorder. */
int api_recorder_begin(thud_world *world, double hash_steps, int body_hashes, double keyframe_steps,
                       double ring_steps, int queries) {
    thud_recorder *recorder = NULL;
    thud_recorder_options options = {.hash_steps = api_to_int(hash_steps),
                                     .body_hashes = body_hashes != 0,
                                     .keyframe_steps = api_to_int(keyframe_steps),
                                     .ring_steps = api_to_int(ring_steps),
                                     .queries = queries != 0};
    thud_result result = thud_recorder_begin(world, &options, &recorder);
    api_slots.list.address = (double)(uintptr_t)recorder;
    return result;
}

/* Ends it; THUD_ERROR_LOCKED inside a callback, where thud_recorder_end does nothing. Its world
 * may have been destroyed before. */
int api_recorder_end(thud_recorder *recorder) {
    thud_bytes bytes;
    thud_result result = thud_recorder_get_bytes(recorder, &bytes);
    thud_recorder_end(recorder);
    return result == THUD_ERROR_LOCKED ? result : THUD_OK;
}

/* Slots out: list of bytes, valid until the next recorded call. */
int api_recorder_bytes(thud_recorder *recorder) {
    thud_bytes bytes = {NULL, 0};
    thud_result result = thud_recorder_get_bytes(recorder, &bytes);
    api_slots.list.address = (double)(uintptr_t)bytes.data;
    api_slots.list.count = (double)bytes.count;
    return result;
}

int api_recorder_chunk(thud_recorder *recorder, const char *name, const char *bytes,
                       uint32_t count) {
    return thud_recorder_add_chunk(recorder, name, (thud_bytes){count ? bytes : NULL, count});
}

/* ---- playing ---- */

/* A player, the bytes that it plays, and the chunks of what it played last: for each the lengths of
 * its name and its bytes, 4 bytes each, and then both. Of the last step, not of a seek, also the
 * calls, if they are wanted: for each the length of its name, its result, what it returned, the
 * number of its values, whether it is a query and the number of its hits, 4 bytes each, then the
 * name, for each value a double and a byte, and for each hit 8 doubles: shape, point, normal,
 * fraction, depth. */
typedef struct playback {
    thud_player *player;
    char *bytes;
    api_buffer chunks, calls;
    bool keeps; /* calls are wanted */
    bool steps; /* a step is being played */
    int news;   /* steps, the present one included, in which shapes or terrains may change: those
                   of a call that changes them, which inside a callback waits for the next step */
} playback;

/* Whether a call may change the shape table or the line of a terrain. */
static bool changes_shapes(const char *name) {
    static const char *const others[] = {"thud_body_create",      "thud_body_create_with_shapes",
                                         "thud_body_make",        "thud_body_destroy",
                                         "thud_body_set_enabled", "thud_body_set_kind",
                                         "thud_world_restore"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        if (strcmp(name, others[i]) == 0)
            return true;
    }
    return strncmp(name, "thud_shape_", 11) == 0;
}

static void keep_chunk(const char *name, thud_bytes bytes, void *context) {
    playback *p = context;
    uint32_t lengths[] = {(uint32_t)strlen(name), (uint32_t)bytes.count};
    api_buffer_push(&p->chunks, lengths, sizeof lengths);
    api_buffer_push(&p->chunks, name, lengths[0]);
    api_buffer_push(&p->chunks, bytes.data, bytes.count);
}

static void keep_call(const thud_played_call *call, void *context) {
    playback *p = context;
    uint32_t head[] = {(uint32_t)strlen(call->name),
                       (uint32_t)call->result,
                       call->returned,
                       (uint32_t)call->value_count,
                       call->query,
                       (uint32_t)call->hit_count};
    if (!call->query && changes_shapes(call->name))
        p->news = 2;
    if (!p->steps || !p->keeps)
        return;
    api_buffer_push(&p->calls, head, sizeof head);
    api_buffer_push(&p->calls, call->name, head[0]);
    for (int i = 0; i < call->value_count; i++) {
        api_buffer_push(&p->calls, &call->values[i].number, sizeof call->values[i].number);
        api_buffer_push(&p->calls, &call->values[i].handle, 1);
    }
    for (int i = 0; i < call->hit_count; i++) {
        const thud_ray_hit *h = &call->hits[i];
        double numbers[] = {h->shape.index1, h->shape.generation, h->point.x,  h->point.y,
                            h->normal.x,     h->normal.y,         h->fraction, h->depth};
        api_buffer_push(&p->calls, numbers, sizeof numbers);
    }
}

/* Frees a player with its world and its bytes. */
void api_player_destroy(playback *p) {
    if (p == NULL)
        return;
    thud_player_destroy(p->player);
    free(p->chunks.data);
    free(p->calls.data);
    free(p->bytes);
    free(p);
}

/* Opens a recording; the bytes, from malloc, belong to the player from now on. `calls`: they are
 * wanted. Slots out: list, whose address is that of the player. */
int api_player_create(char *bytes, uint32_t count, int calls) {
    playback *p = calloc(1, sizeof *p);
    api_slots.list.address = (double)(uintptr_t)p;
    if (p == NULL) {
        free(bytes);
        return THUD_ERROR_MEMORY;
    }
    p->bytes = bytes;
    p->keeps = calls != 0;
    thud_player_options options = {.log = api_world_def().log,
                                   .chunk = keep_chunk,
                                   .call = keep_call,
                                   .context = p};
    thud_result result = thud_player_create((thud_bytes){bytes, count}, &options, &p->player);
    if (result != THUD_OK)
        api_player_destroy(p);
    return result;
}

/* Plays one step. Slots out: list, whose count is 1 unless the recording has ended, and whose
 * address is 1 if shapes or terrains may have changed. */
int api_player_step(playback *p) {
    bool stepped = false;
    api_buffer_clear(&p->chunks);
    api_buffer_clear(&p->calls);
    p->steps = true;
    thud_result result = thud_player_step(p->player, &stepped);
    p->steps = false;
    api_slots.list.count = stepped;
    api_slots.list.address = p->news > 0;
    p->news -= p->news > 0;
    result = result == THUD_OK ? api_buffer_result(&p->chunks) : result;
    return result == THUD_OK ? api_buffer_result(&p->calls) : result;
}

int api_player_seek(playback *p, double step) {
    api_buffer_clear(&p->chunks);
    api_buffer_clear(&p->calls);
    thud_result result = thud_player_seek(p->player, api_to_int(step));
    return result == THUD_OK ? api_buffer_result(&p->chunks) : result;
}

/* Slots out: list, whose count is the step of the last keyframe at or before a step. */
int api_player_keyframe(const playback *p, double step) {
    int64_t keyframe = 0;
    thud_result result = thud_player_get_keyframe(p->player, api_to_int(step), &keyframe);
    api_slots.list.count = (double)keyframe;
    return result;
}

thud_world *api_player_world(const playback *p) {
    thud_world *world = NULL;
    thud_player_get_world(p->player, &world);
    return world;
}

/* Slots out: list of bytes, the chunks of the last call. */
void api_player_chunks(const playback *p) {
    api_slots.list.address = (double)(uintptr_t)p->chunks.data;
    api_slots.list.count = (double)p->chunks.bytes;
}

/* Slots out: list of bytes, the calls of the last step. */
void api_player_calls(const playback *p) {
    api_slots.list.address = (double)(uintptr_t)p->calls.data;
    api_slots.list.count = (double)p->calls.bytes;
}

/* The fields of thud_player_progress, in their order, the body as two numbers; valid until the next
 * call. */
const double *api_player_progress(const playback *p) {
    static double numbers[9];
    thud_player_progress progress;
    if (thud_player_get_progress(p->player, &progress) == THUD_OK) {
        numbers[0] = (double)progress.first;
        numbers[1] = (double)progress.end;
        numbers[2] = (double)progress.steps;
        numbers[3] = (double)progress.hashes;
        numbers[4] = progress.differs;
        numbers[5] = (double)progress.differs_after;
        numbers[6] = (double)progress.differs_at;
        numbers[7] = progress.body.index1;
        numbers[8] = progress.body.generation;
    }
    return numbers;
}
