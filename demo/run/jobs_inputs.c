/* jobs_inputs.c: reads the scripted inputs of a job, and runs a job with them. */
#include "jobs.h"

#include "load.h"
#include "random.h"
#include "run.h"

#include <thud/thud_edits.h>
#include <thud/thud_fields.h>
#include <thud/thud_lists.h>

#include <cjson/cJSON.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Largest number in an input. Below the largest float, so that it can be rounded to one; the engine
 * refuses what it cannot use. */
static const double NUMBER_MAX = 1e30;

/* Whether the item is a number that can be rounded to a float. */
static bool read_number(const cJSON *item, double *out) {
    if (!cJSON_IsNumber(item) || !(fabs(item->valuedouble) <= NUMBER_MAX))
        return false;
    *out = item->valuedouble;
    return true;
}

static bool read_pair(const cJSON *item, double *x, double *y) {
    return cJSON_IsArray(item) && cJSON_GetArraySize(item) == 2 && read_number(item->child, x) &&
           read_number(item->child->next, y);
}

/* Reads a whole number in 0..high. */
static bool read_whole(const cJSON *item, long high, long *out) {
    if (!cJSON_IsNumber(item) || !(item->valuedouble >= 0 && item->valuedouble <= (double)high) ||
        item->valuedouble != floor(item->valuedouble))
        return false;
    *out = (long)item->valuedouble;
    return true;
}

/* Reads what a kind of input has. Returns how many fields that are, without its step; 0 if one is
 * missing or wrong. */
static int read_push(const cJSON *json, job_input *in) {
    long body;
    if (!read_whole(cJSON_GetObjectItemCaseSensitive(json, "push"), 2147483646, &body) ||
        !read_pair(cJSON_GetObjectItemCaseSensitive(json, "impulse"), &in->x, &in->y))
        return 0;
    in->kind = JOB_PUSH;
    in->body = (int)body;
    return 2;
}

static int read_drop(const cJSON *json, job_input *in) {
    const char *what = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "drop"));
    const cJSON *velocity = cJSON_GetObjectItemCaseSensitive(json, "velocity");
    if (!what || (strcmp(what, "circle") != 0 && strcmp(what, "box") != 0) ||
        !read_pair(cJSON_GetObjectItemCaseSensitive(json, "at"), &in->x, &in->y) ||
        !read_number(cJSON_GetObjectItemCaseSensitive(json, "size"), &in->size) ||
        (velocity && !read_pair(velocity, &in->vx, &in->vy)))
        return 0;
    in->kind = strcmp(what, "box") == 0 ? JOB_DROP_BOX : JOB_DROP_CIRCLE;
    return velocity ? 4 : 3;
}

static int read_explode(const cJSON *json, job_input *in) {
    if (!read_pair(cJSON_GetObjectItemCaseSensitive(json, "explode"), &in->x, &in->y) ||
        !read_number(cJSON_GetObjectItemCaseSensitive(json, "radius"), &in->radius) ||
        !read_number(cJSON_GetObjectItemCaseSensitive(json, "falloff"), &in->falloff) ||
        !read_number(cJSON_GetObjectItemCaseSensitive(json, "impulse"), &in->impulse))
        return 0;
    in->kind = JOB_EXPLODE;
    return 4;
}

static bool read_input(const cJSON *json, long steps, job_input *in) {
    *in = (job_input){0};
    int fields = cJSON_GetObjectItemCaseSensitive(json, "push")   ? read_push(json, in)
                 : cJSON_GetObjectItemCaseSensitive(json, "drop") ? read_drop(json, in)
                                                                  : read_explode(json, in);
    return fields > 0 && cJSON_GetArraySize(json) == fields + 1 &&
           read_whole(cJSON_GetObjectItemCaseSensitive(json, "step"), steps - 1, &in->step);
}

bool job_inputs_read(const cJSON *json, job *j, char *why) {
    int count = cJSON_IsArray(json) ? cJSON_GetArraySize(json) : -1;
    if (count < 0 || count > JOB_INPUTS_MAX) {
        snprintf(why, RUN_FAILURE_MAX, "inputs is a list of at most %d inputs", JOB_INPUTS_MAX);
        return false;
    }
    j->inputs = calloc((size_t)count + 1, sizeof *j->inputs);
    if (!j->inputs) {
        snprintf(why, RUN_FAILURE_MAX, "out of memory");
        return false;
    }
    for (const cJSON *item = json->child; item; item = item->next)
        if (!read_input(item, j->options.steps, &j->inputs[j->input_count++])) {
            snprintf(why, RUN_FAILURE_MAX,
                     "input %d is none of {step, push, impulse: [x, y]}, {step, drop: \"circle\" "
                     "or \"box\", at: [x, y], size, velocity: [x, y]} and {step, explode: [x, y], "
                     "radius, falloff, impulse}, with a step from 0 to %ld",
                     j->input_count, j->options.steps - 1);
            return false;
        }
    return true;
}

bool job_inputs_fit(const job *j, const scene *s, char *why) {
    for (int i = 0; i < j->input_count; i++) {
        const job_input *in = &j->inputs[i];
        if (in->kind != JOB_PUSH ||
            (in->body < s->body_count && s->bodies[in->body].kind == SCENE_DYNAMIC))
            continue;
        snprintf(why, RUN_FAILURE_MAX, "input %d pushes body %d, and the scene has %s", i + 1,
                 in->body,
                 in->body < s->body_count ? "a body there that does not move freely" : "fewer");
        return false;
    }
    return true;
}

/* What a run of a job needs between its steps. */
typedef struct job_acting {
    const job *job;
    thud_body_id *bodies; /* by index in scene.bodies */
    int body_count;
    char *failure; /* where to write what fails */
} job_acting;

static thud_result push(thud_world *world, thud_body_id body, const job_input *in) {
    thud_body_state state;
    thud_result result = thud_body_get_state(world, body, &state);
    if (result != THUD_OK)
        return result;
    return thud_body_apply_impulse(world, body, (thud_vec2){(float)in->x, (float)in->y},
                                   state.center);
}

static thud_result drop(thud_world *world, const job_input *in) {
    thud_body_def def = thud_default_body_def();
    def.kind = THUD_BODY_DYNAMIC;
    def.position = (thud_pos){in->x, in->y};
    def.velocity = (thud_vec2){(float)in->vx, (float)in->vy};
    double half = 0.5 * in->size;
    thud_body_shape shape = {.shape = in->kind == JOB_DROP_BOX ? thud_obb_at(0, 0, half, half, 0)
                                                               : thud_circle_at(0, 0, half)};
    return thud_body_create_with_shapes(world, &def, &shape, 1, NULL, NULL);
}

static thud_result explode(thud_world *world, const job_input *in) {
    thud_explosion explosion = thud_default_explosion();
    explosion.center = (thud_pos){in->x, in->y};
    explosion.radius = in->radius;
    explosion.falloff = in->falloff;
    explosion.impulse = (float)in->impulse;
    return thud_world_explode(world, &explosion, NULL);
}

/* Carries out the inputs that come after so many steps. */
static bool act(thud_world *world, long steps, const job_acting *a) {
    for (int i = 0; i < a->job->input_count; i++) {
        const job_input *in = &a->job->inputs[i];
        if (in->step != steps)
            continue;
        thud_result result = in->kind == JOB_PUSH      ? push(world, a->bodies[in->body], in)
                             : in->kind == JOB_EXPLODE ? explode(world, in)
                                                       : drop(world, in);
        if (result != THUD_OK) {
            snprintf(a->failure, RUN_FAILURE_MAX, "input %d failed after step %ld: %s", i + 1,
                     steps, thud_result_text(result));
            return false;
        }
    }
    return true;
}

/* The first bodies of a new world are those of the scene, in their order. */
static bool on_built(thud_world *world, void *context) {
    job_acting *a = context;
    int count = 0;
    a->bodies = calloc((size_t)a->body_count + 1, sizeof *a->bodies);
    if (!a->bodies) {
        snprintf(a->failure, RUN_FAILURE_MAX, "out of memory");
        return false;
    }
    thud_world_get_bodies(world, a->bodies, a->body_count, &count);
    return act(world, 0, a);
}

static bool on_step(thud_world *world, const run_outcome *so_far, void *context) {
    return act(world, so_far->steps, context);
}

/* Changes the velocities of dynamic bodies by what follows from the job's seed. */
static void shake(const job *j, scene *s) {
    double most = j->shake < 0 ? 0.01 * s->length_scale : j->shake;
    scene_random random = {(uint64_t)j->seed};
    for (int i = 0; j->seed > 0 && i < s->body_count; i++) {
        scene_body *body = &s->bodies[i];
        if (body->kind != SCENE_DYNAMIC)
            continue;
        body->vx += scene_random_range(&random, -most, most);
        body->vy += scene_random_range(&random, -most, most);
    }
}

bool job_run(const job *j, run_outcome *out, double *error, char *failure) {
    /* cJSON, by which levels are read, writes the place of an error to a variable that all threads
     * share. */
    static pthread_mutex_t loading = PTHREAD_MUTEX_INITIALIZER;
    scene s;
    run_options options = j->options;
    options.failure = failure;
    pthread_mutex_lock(&loading);
    bool loaded = run_load(&options, &s);
    pthread_mutex_unlock(&loading);
    if (!loaded) {
        snprintf(failure, RUN_FAILURE_MAX, "the scene cannot be loaded any more");
        return false;
    }
    shake(j, &s);
    job_acting acting = {.job = j, .body_count = s.body_count, .failure = failure};
    run_watch watch = {on_built, on_step, &acting};
    bool done = run_scene(&options, &s, &watch, out);
    if (done)
        *error = run_error_of(out, &s);
    free(acting.bodies);
    scene_free(&s);
    return done;
}
