/* session.c: see session.h. */
#include "session_parts.h"

#include <act_thud.h>
#include <build_thud.h>

#include <thud/thud_fields.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

#include <SDL.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Last: the calls of this file are recorded. */
#include <thud/thud_recorded.h>

/* s. Max time that the steps of a frame may take: frames that take longer make the viewer sluggish.
 * The world then runs slower than its speed says. Chosen. */
static const double STEPPING_BUDGET = 0.040;
/* Max number of steps in a frame. */
enum { STEPS_PER_FRAME = 16 };

double session_clock(void *context) {
    (void)context;
    return (double)SDL_GetPerformanceCounter() / (double)SDL_GetPerformanceFrequency();
}

void session_log(thud_result result, const char *text, void *context) {
    session *s = context;
    snprintf(s->message, sizeof s->message, "%s: %s", thud_result_text(result), text);
}

void session_init(session *s) {
    *s = (session){.quality = QUALITY_DEFAULT,
                   .detection = DETECTION_DEFAULT,
                   .broadphase = BROADPHASE_DEFAULT,
                   .speed = 1,
                   .alpha = 1};
    scene_init(&s->scene);
}

void session_destroy_world(session *s) {
    last_seconds_end(&s->last);
    if (s->played)
        playback_close(s->played);
    else
        thud_world_destroy(s->world);
    s->played = NULL;
    s->world = NULL;
}

void session_free(session *s) {
    session_destroy_world(s);
    thud_threads_destroy(s->threads);
    scene_free(&s->scene);
    free(s->bodies);
    free(s->shapes);
    free(s->joints);
    *s = (session){0};
}

bool session_grow(void **block, int *capacity, int wanted, size_t size) {
    int room = *capacity > 0 ? *capacity : 64;
    while (room < wanted)
        room *= 2;
    if (room == *capacity)
        return true;
    void *grown = realloc(*block, (size_t)room * size);
    if (!grown)
        return false;
    *block = grown;
    *capacity = room;
    return true;
}

/* Max distance of a shape's points from the body's origin; an upper bound. */
static float shape_reach(const session_shape *shape) {
    if (shape->kind == THUD_SHAPE_TERRAIN)
        return INFINITY;
    return hypotf(shape->offset.x, shape->offset.y) + hypotf(shape->half.x, shape->half.y);
}

/* Appends a body and its shapes to the lists for drawing. False if memory runs out. */
static bool list_body(session *s, thud_body_id id) {
    thud_body_state body;
    if (thud_body_get_state(s->world, id, &body) != THUD_OK ||
        !session_grow((void **)&s->bodies, &s->body_capacity, s->body_count + 1,
                      sizeof *s->bodies) ||
        !session_grow((void **)&s->shapes, &s->shape_capacity, s->shape_count + body.shape_count,
                      sizeof *s->shapes))
        return false;
    thud_shape_id *ids = malloc((size_t)body.shape_count * sizeof *ids + 1);
    if (!ids)
        return false;
    int count = 0;
    thud_body_get_shapes(s->world, id, ids, body.shape_count, &count);
    session_body entry = {.id = id, .kind = body.kind, .first_shape = s->shape_count};
    for (int i = 0; i < count; i++) {
        thud_shape_state shape;
        if (thud_shape_get_state(s->world, ids[i], &shape) != THUD_OK)
            continue;
        session_shape *listed = &s->shapes[s->shape_count++];
        *listed = (session_shape){ids[i],
                                  shape.kind,
                                  shape.offset,
                                  shape.half_extents,
                                  (float)cos(shape.angle),
                                  (float)sin(shape.angle),
                                  shape.sensor};
        entry.reach = fmaxf(entry.reach, shape_reach(listed));
        entry.shape_count++;
    }
    free(ids);
    s->bodies[s->body_count++] = entry;
    return true;
}

bool session_list_bodies(session *s, const thud_body_id *ids, int count) {
    s->body_count = s->shape_count = 0;
    for (int i = 0; i < count; i++)
        if (!list_body(s, ids[i])) {
            snprintf(s->message, sizeof s->message, "Out of memory while listing the bodies.");
            return false;
        }
    return true;
}

bool session_list_joints(session *s) {
    s->joint_count = 0;
    if (!session_grow((void **)&s->joints, &s->joint_capacity, s->scene.joint_count,
                      sizeof *s->joints)) {
        snprintf(s->message, sizeof s->message, "Out of memory while listing the joints.");
        return false;
    }
    thud_world_get_joints(s->world, s->joints, s->scene.joint_count, &s->joint_count);
    return true;
}

void session_show_world(session *s, thud_world *world, scene fresh, double time_step) {
    scene_free(&s->scene);
    s->world = world;
    s->scene = fresh;
    s->time_step = time_step;
    s->alpha = 1;
    s->missed = (session_missed){0};
    s->pair[0] = s->pair[1] = 0;
    for (int i = 0; i < SESSION_BLASTS; i++)
        s->blasts[i].step = -1e9;
}

bool session_load(session *s, const catalog_entry *entry) {
    scene fresh;
    s->message[0] = '\0';
    if (!catalog_fill(entry, &fresh, s->message, sizeof s->message))
        return false;
    thud_world_def def = thud_default_world_def();
    def.quality = QUALITIES[s->quality];
    def.detection = DETECTIONS[s->detection].detection;
    def.broadphase = BROADPHASES[s->broadphase].broadphase;
    if (s->step_rate > 0)
        def.time_step = 1.0 / s->step_rate;
    if (s->top_speed > 0)
        def.maximum_speed = (float)s->top_speed;
    def.job_system = thud_job_system_of(s->threads);
    def.log = session_log;
    def.log_context = s;
    def.clock = session_clock;
    thud_world *world = NULL;
    thud_body_id *ids = malloc((size_t)fresh.body_count * sizeof *ids + 1);
    thud_result result =
        ids ? scene_build_thud(&fresh, &def, &world, ids, NULL) : THUD_ERROR_MEMORY;
    if (result != THUD_OK) {
        if (s->message[0] == '\0')
            snprintf(s->message, sizeof s->message, "%s", thud_result_text(result));
        free(ids);
        scene_free(&fresh);
        return false;
    }
    session_destroy_world(s);
    session_show_world(s, world, fresh, def.time_step);
    last_seconds_begin(&s->last, world, def.time_step, &s->scene);
    bool listed = session_list_bodies(s, ids, fresh.body_count) && session_list_joints(s);
    for (int i = 0; i < s->body_count; i++)
        s->bodies[i].look = fresh.bodies[i].look;
    free(ids);
    return listed;
}

static bool is_listed(const session *s, thud_body_id id) {
    for (int i = 0; i < s->body_count; i++)
        if (s->bodies[i].id.index1 == id.index1)
            return true;
    return false;
}

/* After a step in which bodies broke: removes them from the list, and adds their pieces. */
static void list_pieces(session *s) {
    int kept = 0, count = 0, bodies = (int)thud_stats_of(s->world).bodies;
    if (s->scene.fields.breaks == 0 || bodies == s->body_count)
        return;
    for (int i = 0; i < s->body_count; i++)
        if (thud_body_is_valid(s->world, s->bodies[i].id))
            s->bodies[kept++] = s->bodies[i];
    s->body_count = kept;
    thud_body_id *ids = malloc((size_t)bodies * sizeof *ids + 1);
    bool listed = ids && thud_world_get_bodies(s->world, ids, bodies, &count) == THUD_OK;
    for (int i = 0; i < count && listed; i++)
        listed = is_listed(s, ids[i]) || list_body(s, ids[i]);
    free(ids);
    if (!listed)
        snprintf(s->message, sizeof s->message, "Out of memory while listing the bodies.");
}

/* Says what went wrong, and how to report it. */
static void offer_recording(session *s, const char *what) {
    snprintf(s->message, sizeof s->message, "%s: T saves a recording of what led to it.", what);
}

/* One step of the world, with what follows from it. Does nothing more if the step fails. */
static void run_step(session *s) {
    if (s->played && !playback_goes_on(s->played)) {
        session_tell_end(s);
        return;
    }
    if (s->played) {
        playback_step(s->played);
        session_tell_end(s);
    } else if (scene_step_thud(&s->scene.fields, s->world) != THUD_OK) {
        offer_recording(s, "This step failed");
        return;
    } else {
        if (thud_events_of(s->world).quarantined_count > 0)
            offer_recording(s, "A body was stopped, since its state was not finite");
        last_seconds_stepped(&s->last, &s->scene);
        list_pieces(s);
    }
    thud_stats stats = thud_stats_of(s->world);
    s->missed.held += stats.held_bodies;
    s->missed.seconds += stats.held_seconds;
    s->missed.fast += stats.unbisectable;
    if (s->stepped)
        s->stepped(s, s->stepped_context);
}

/* Like thud_world_advance, but each step is a run_step. `elapsed` is in world seconds. At most
 * `steps_max` steps are run; time beyond them is dropped. */
static void advance(session *s, double elapsed, int steps_max) {
    double due = s->alpha * s->time_step + elapsed;
    for (; due >= s->time_step && steps_max > 0 && !s->paused; steps_max--) {
        run_step(s);
        due -= s->time_step;
    }
    s->alpha = s->paused ? 1 : fmod(due, s->time_step) / s->time_step;
}

void session_advance(session *s, double elapsed) {
    if (session_go_on_seeking(s) || s->paused || !s->world)
        return;
    double step_seconds = thud_stats_of(s->world).step_seconds;
    int steps_max = STEPS_PER_FRAME;
    if (step_seconds * STEPS_PER_FRAME > STEPPING_BUDGET)
        steps_max = (int)fmax(1, STEPPING_BUDGET / step_seconds);
    advance(s, elapsed * s->speed, steps_max);
    session_list_played(s);
}

void session_step(session *s) {
    if (!s->world)
        return;
    if (s->played)
        playback_work(s->played, INFINITY);
    run_step(s);
    session_list_played(s);
    s->alpha = 1;
}

void session_set_quality(session *s, int quality) {
    if (!session_yields(s))
        return;
    s->quality = quality;
    if (s->world)
        thud_world_set_quality(s->world, QUALITIES[quality]);
}

int session_quality(const session *s) {
    thud_step_settings settings;
    if (!s->world || thud_world_get_step_settings(s->world, &settings) != THUD_OK)
        return s->quality;
    for (int i = 0; i < QUALITY_CHOICES; i++)
        if (strcmp(settings.quality.name, QUALITIES[i]->name) == 0)
            return i;
    return -1;
}

int session_detection(const session *s) {
    thud_step_settings settings;
    if (!s->played || thud_world_get_step_settings(s->world, &settings) != THUD_OK)
        return s->detection;
    for (int i = 1; i < DETECTION_CHOICES; i++)
        if (settings.quality.detection == DETECTIONS[i].detection)
            return i;
    return DETECTION_DEFAULT;
}

void session_spawn(session *s, thud_shape_kind kind, thud_pos at, float size) {
    if (!s->world || !session_yields(s))
        return;
    float half = 0.5f * size * (float)s->scene.length_scale;
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id id;
    body.kind = THUD_BODY_DYNAMIC;
    body.position = at;
    if (thud_body_create(s->world, &body, &id) != THUD_OK)
        return;
    thud_vec2 center = {0, 0};
    thud_result made = THUD_ERROR_INVALID;
    switch (kind) {
    case THUD_SHAPE_CIRCLE:
        made = thud_shape_create_circle(s->world, id, &shape, center, half, NULL);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        made =
            thud_shape_create_obb(s->world, id, &shape, center, (thud_vec2){half, half}, 0, NULL);
        break;
    case THUD_SHAPE_TERRAIN: /* cannot be added by a user */
        break;
    }
    if (made != THUD_OK || !list_body(s, id))
        thud_body_destroy(s->world, id);
}

/* In length scales: radius with the full impulse, and width of the falloff to zero around it; and
 * the speed in length scales per second that a box of density 1 with sides of a length scale gets
 * within the radius. */
static const double BLAST_RADIUS = 1.5, BLAST_FALLOFF = 6, BLAST_SPEED = 30;

void session_explode(session *s, thud_pos at) {
    if (!s->world || !session_yields(s))
        return;
    double unit = s->scene.length_scale;
    thud_explosion explosion = thud_default_explosion();
    explosion.center = at;
    explosion.radius = BLAST_RADIUS * unit;
    explosion.falloff = BLAST_FALLOFF * unit;
    explosion.impulse = (float)(BLAST_SPEED * unit * unit);
    s->message[0] = '\0';
    if (thud_world_explode(s->world, &explosion, NULL) == THUD_OK) {
        s->blasts[s->next_blast] = (session_blast){at, (double)thud_stats_of(s->world).steps};
        s->next_blast = (s->next_blast + 1) % SESSION_BLASTS;
    }
}

typedef struct picking {
    session *session;
    thud_pos at;
    thud_body_kind kind;
    bool found;
    double distance; /* from the place to the centre of the nearest body so far */
    thud_body_id body;
} picking;

/* The query's callback: keeps the body whose centre is nearest. */
static bool pick_nearest(thud_shape_id id, void *context) {
    picking *p = context;
    thud_shape_state shape;
    thud_body_state body;
    if (thud_shape_get_state(p->session->world, id, &shape) != THUD_OK ||
        thud_body_get_state(p->session->world, shape.body, &body) != THUD_OK ||
        body.kind != p->kind)
        return true;
    double distance = hypot(body.center.x - p->at.x, body.center.y - p->at.y);
    if (!p->found || distance < p->distance) {
        p->found = true;
        p->distance = distance;
        p->body = shape.body;
    }
    return true;
}

bool session_pick(session *s, thud_pos at, double margin, thud_body_kind kind, thud_body_id *out) {
    if (!s->world)
        return false;
    picking p = {.session = s, .at = at, .kind = kind};
    thud_geometry spot = {.kind = THUD_SHAPE_CIRCLE, .c = 1, .hx = margin};
    thud_world_overlap_shape(s->world, at, spot, NULL, pick_nearest, &p);
    if (p.found)
        *out = p.body;
    return p.found;
}

void session_remove(session *s, thud_body_id body) {
    if (!s->world || !session_yields(s) || thud_body_destroy(s->world, body) != THUD_OK)
        return;
    for (int i = 0; i < s->body_count; i++)
        if (s->bodies[i].id.index1 == body.index1) {
            memmove(&s->bodies[i], &s->bodies[i + 1],
                    (size_t)(s->body_count - i - 1) * sizeof *s->bodies);
            s->body_count--;
            return;
        }
}
