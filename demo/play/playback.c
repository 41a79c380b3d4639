/* playback.c: see playback.h. */
#include "playback.h"

#include <cjson/cJSON.h>
#include <scene.h>
#include <whole_file.h>

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The first bytes of a recording, its terminating 0 included: TD_RECORDING_MAGIC in
 * engine/src/recording/recording.h. */
static const char MAGIC[] = "thudrec";

/* Lengths beyond which a view is not one. */
static const double VIEW_MAX = 1e9;

/* ---- files ---- */

bool playback_is_recording(const char *path) {
    char first[sizeof MAGIC];
    FILE *file = fopen(path, "rb");
    bool is = file && fread(first, 1, sizeof first, file) == sizeof first &&
              memcmp(first, MAGIC, sizeof first) == 0;
    if (file)
        fclose(file);
    return is;
}

/* "reports/fall.rec" becomes "fall", in memory from malloc. Null if that runs out. */
static char *name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    const char *from = slash ? slash + 1 : path;
    const char *dot = strrchr(from, '.');
    size_t length = dot && dot > from ? (size_t)(dot - from) : strlen(from);
    char *name = malloc(length + 1);
    if (name) {
        memcpy(name, from, length);
        name[length] = '\0';
    }
    return name;
}

/* ---- what the player tells ---- */

/* The log of the player and its world. */
static void hear_log(thud_result result, const char *text, void *context) {
    playback *p = context;
    static const char player[] = "player: ";
    size_t prefix = strncmp(text, player, sizeof player - 1) == 0 ? sizeof player - 1 : 0;
    snprintf(p->why, sizeof p->why, "%s", text + prefix);
    if (p->log && prefix == 0)
        p->log(result, text, p->log_context);
}

/* A field of the view. False if it is there and is no number within its bounds. */
static bool read_number(const cJSON *from, const char *name, double low, double *out) {
    const cJSON *value = cJSON_GetObjectItemCaseSensitive(from, name);
    if (value &&
        !(cJSON_IsNumber(value) && value->valuedouble >= low && value->valuedouble <= VIEW_MAX))
        return false;
    *out = value ? value->valuedouble : *out;
    return true;
}

/* Reads the view from the chunk; a damaged one is passed over. */
static void hear_chunk(const char *name, thud_bytes bytes, void *context) {
    playback *p = context;
    if (strcmp(name, SCENE_SHOWN) != 0)
        return;
    cJSON *json = cJSON_ParseWithLength(bytes.data, bytes.count);
    const cJSON *view = cJSON_GetObjectItemCaseSensitive(json, "view");
    playback_view seen = {.length_scale = 1};
    if (read_number(view, "x", -VIEW_MAX, &seen.x) && read_number(view, "y", -VIEW_MAX, &seen.y) &&
        read_number(view, "height", 0, &seen.height) &&
        read_number(view, "width", 0, &seen.width) &&
        read_number(json, "lengthScale", THUD_LENGTH_SCALE_MIN, &seen.length_scale))
        p->view = seen;
    cJSON_Delete(json);
}

/* Appends formatted text to a line of PLAYBACK_TEXT_MAX characters, as far as there is room. */
#define APPEND(line, used, ...)                                                                    \
    ((used) =                                                                                      \
         (used) < PLAYBACK_TEXT_MAX                                                                \
             ? (used) + (size_t)snprintf((line) + (used), PLAYBACK_TEXT_MAX - (used), __VA_ARGS__) \
             : (used))

/* Writes a call as C would have it, handles as # and their number. */
static void write_call(const thud_played_call *call, char *line) {
    size_t used = 0;
    APPEND(line, used, "%s", call->name);
    if (call->result != THUD_OK) {
        APPEND(line, used, ": refused, %s", thud_result_text(call->result));
        return;
    }
    APPEND(line, used, "(");
    for (int i = 0; i < call->value_count; i++) {
        double number = call->values[i].number;
        bool whole = number == rint(number) && fabs(number) < 1e15;
        APPEND(line, used,
               call->values[i].handle ? "%s#%.0f"
               : whole                ? "%s%.0f"
                                      : "%s%.4g",
               i > 0 ? ", " : "", number);
    }
    APPEND(line, used, ")");
    if (call->returned)
        APPEND(line, used, " = #%" PRIu32, call->returned);
    if (call->query)
        APPEND(line, used, ": %d hit%s", call->hit_count, call->hit_count == 1 ? "" : "s");
    if (used >= PLAYBACK_TEXT_MAX)
        strcpy(line + PLAYBACK_TEXT_MAX - 4, "...");
}

/* The shape whose seven numbers begin at `at`, about the centre (x, y). */
static thud_geometry shape_at(const thud_call_value *at, double x, double y) {
    return (thud_geometry){.kind = (thud_shape_kind)at[0].number,
                           .x = x + at[1].number,
                           .y = y + at[2].number,
                           .c = at[3].number,
                           .s = at[4].number,
                           .hx = at[5].number,
                           .hy = at[6].number};
}

/* Reads where a query looked from its arguments, which begin with two numbers each time: a place.
 * False for queries of many rays or shapes at once, which are listed, and not drawn. */
static bool read_query(const thud_played_call *call, playback_query *out) {
    const char *name = call->name + strlen("thud_world_");
    const thud_call_value *v = call->values;
    double x = v[0].number, y = v[1].number;
    *out = (playback_query){.points = true};
    if (strncmp(name, "cast_ray", 8) == 0 && strcmp(name, "cast_rays") != 0) {
        out->ray = true;
        out->shape = thud_circle_at(x, y, 0);
        out->dx = v[2].number;
        out->dy = v[3].number;
    } else if (strncmp(name, "cast_shape", 10) == 0 && strcmp(name, "cast_shapes") != 0) {
        out->shape = shape_at(v + 2, x, y);
        out->dx = v[9].number;
        out->dy = v[10].number;
    } else if (strcmp(name, "overlap_shape") == 0) {
        out->shape = shape_at(v + 2, x, y);
        out->points = false;
    } else if (strcmp(name, "overlap_aabb") == 0) {
        double right = v[2].number, top = v[3].number;
        out->shape = thud_aabb_at((x + right) / 2, (y + top) / 2, (right - x) / 2, (top - y) / 2);
        out->points = false;
    } else if (strcmp(name, "closest") == 0) {
        out->ray = true;
        out->shape = thud_circle_at(x, y, 0);
        if (call->hit_count > 0) {
            out->dx = call->hits[0].point.x - x;
            out->dy = call->hits[0].point.y - y;
        }
    } else {
        return false;
    }
    return true;
}

static void hear_query(const thud_played_call *call, playback *p) {
    playback_query *q = &p->queries[p->query_count];
    if (p->query_count == PLAYBACK_QUERIES_MAX || !read_query(call, q))
        return;
    q->hit_count = call->hit_count < PLAYBACK_HITS_MAX ? call->hit_count : PLAYBACK_HITS_MAX;
    for (int i = 0; i < q->hit_count; i++)
        q->hits[i] = call->hits[i];
    p->query_count++;
}

static void hear_call(const thud_played_call *call, void *context) {
    playback *p = context;
    if (call->query)
        hear_query(call, p);
    if (call->result == THUD_OK && strcmp(call->name, "thud_world_step") == 0)
        return;
    p->changed |= !call->query;
    if (p->call_count < PLAYBACK_CALLS_MAX)
        write_call(call, p->calls[p->call_count]);
    p->call_count++;
}

/* ---- opening ---- */

void playback_close(playback *p) {
    if (!p)
        return;
    thud_player_destroy(p->player);
    free(p->bytes);
    free(p->name);
    free(p);
}

/* What has become of the player after a call that returned `result`. */
static void look(playback *p, thud_result result) {
    thud_player_get_progress(p->player, &p->progress);
    p->stopped = result != THUD_OK;
}

/* Reads how the recording is to be shown. The chunk comes with the first step, which is played in
 * advance; if it differs, that is told when it is played again. */
static void read_view(playback *p) {
    p->view.length_scale = 1;
    thud_player_step(p->player, NULL);
    look(p, thud_player_seek(p->player, p->progress.first));
    p->call_count = p->query_count = 0;
    p->why[0] = '\0';
}

playback *playback_open(const char *path, thud_threads *threads, thud_clock_fn *clock, char *why) {
    playback *p = malloc(sizeof *p);
    size_t count = 0;
    if (!p) {
        snprintf(why, PLAYBACK_WHY_MAX, "%s: out of memory", path);
        return NULL;
    }
    *p = (playback){.clock = clock, .target = -1, .changed = true};
    p->name = name_of(path);
    p->bytes = p->name ? whole_file_read(path, SIZE_MAX - 1, &count) : NULL;
    thud_player_options options = {.log = hear_log,
                                   .log_context = p,
                                   .job_system = thud_job_system_of(threads),
                                   .chunk = hear_chunk,
                                   .call = hear_call,
                                   .context = p,
                                   .clock = clock};
    if (!p->bytes)
        snprintf(why, PLAYBACK_WHY_MAX, "%.200s cannot be read", path);
    else if (thud_player_create((thud_bytes){p->bytes, count}, &options, &p->player) != THUD_OK)
        snprintf(why, PLAYBACK_WHY_MAX, "%.80s cannot be played: %.120s", path, p->why);
    if (!p->player) {
        playback_close(p);
        return NULL;
    }
    thud_player_get_world(p->player, &p->world);
    thud_player_get_progress(p->player, &p->progress);
    read_view(p);
    return p;
}

/* ---- steps ---- */

bool playback_goes_on(const playback *p) {
    return p->forked || (!p->stopped && p->progress.steps < p->progress.end);
}

/* Plays the next step. Calls after the last one are played with it, and the last hash is
 * compared. */
static void play_step(playback *p) {
    p->call_count = p->query_count = 0;
    thud_result result = thud_player_step(p->player, NULL);
    look(p, result);
    if (result == THUD_OK && p->progress.steps == p->progress.end)
        look(p, thud_player_step(p->player, NULL));
}

void playback_step(playback *p) {
    if (p->forked)
        p->forked_steps += thud_world_step(p->world) == THUD_OK;
    else if (playback_goes_on(p))
        play_step(p);
}

/* Makes the player go back to a keyframe with its next seek, which it does not for a step where it
 * stands already: after a fork the world is not that of the step. */
static void leave_step(playback *p) {
    if (p->progress.steps == p->progress.first)
        look(p, thud_player_step(p->player, NULL));
    look(p, thud_player_seek(p->player, p->progress.first));
}

void playback_seek(playback *p, int64_t step) {
    const thud_player_progress *at = &p->progress;
    step = step < at->first ? at->first : step > at->end ? at->end : step;
    if (p->forked)
        leave_step(p);
    else if (step == at->steps && !p->stopped) {
        p->target = -1;
        return;
    }
    p->forked = false;
    p->changed = true;
    p->call_count = p->query_count = 0;
    p->target = step;
    /* The list of calls has to show those that led to the step: so the step before it is sought,
     * and the last step played. */
    int64_t before = step > at->first ? step - 1 : step, from = at->first;
    thud_player_get_keyframe(p->player, before, &from);
    if (p->stopped || before < at->steps || from > at->steps)
        look(p, thud_player_seek(p->player, from));
}

bool playback_work(playback *p, double seconds) {
    double until = p->clock(NULL) + seconds;
    while (p->target > p->progress.steps && playback_goes_on(p) && p->clock(NULL) < until)
        play_step(p);
    if (p->target <= p->progress.steps || !playback_goes_on(p))
        p->target = -1;
    return p->target >= 0;
}

bool playback_fork(playback *p) {
    if (p->stopped)
        return false;
    p->target = -1;
    p->forked = true;
    p->forked_steps = 0;
    p->call_count = p->query_count = 0;
    return true;
}

void playback_tell_difference(const playback *p, char *out) {
    const thud_player_progress *at = &p->progress;
    int used = snprintf(out, PLAYBACK_WHY_MAX,
                        "The state differs after step %" PRId64 ", at step %" PRId64,
                        at->differs_after, at->differs_at);
    if (at->body.index1)
        snprintf(out + used, PLAYBACK_WHY_MAX - (size_t)used,
                 ", first in the body of slot %" PRIu32 " (#%" PRIu32 ")", at->body.index1 - 1,
                 at->body.index1);
}
