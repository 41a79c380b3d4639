/* session_played.c: the recording that a session shows; see session.h. */
#include "session_parts.h"

#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Max time that a seek in a recording may take of a frame, s. Chosen. */
static const double SEEKING_BUDGET = 0.040;

/* A joint as scenes have it, from its def. All joints have to be listed. */
static scene_joint joint_of(const session *s, const thud_joint_def *def) {
    scene_joint j = {.kind = (scene_joint_kind)def->kind,
                     .x = {def->frame_a.position.x, def->frame_b.position.x},
                     .y = {def->frame_a.position.y, def->frame_b.position.y},
                     .angle = {def->frame_a.angle, def->frame_b.angle},
                     .length = def->length,
                     .ratio = def->ratio};
    for (int i = 0; i < THUD_DIRECTION_COUNT; i++) {
        const thud_drive *d = &def->drive[i];
        j.drive[i] =
            (scene_drive){d->limited, d->lower,        d->upper,       d->frequency,  d->damping,
                          d->target,  d->spring_force, d->motor_speed, d->motor_force};
    }
    for (int side = 0; side < 2 && def->kind == THUD_JOINT_GEAR; side++)
        for (int i = 0; i < s->joint_count; i++)
            if (s->joints[i].index1 == def->gear[side].index1)
                j.body[side] = i;
    return j;
}

/* Lists all joints of the world, and how scenes would have them. False if memory runs out. */
static bool list_all_joints(session *s) {
    scene *made = &s->scene;
    thud_world_get_joints(s->world, NULL, 0, &made->joint_count);
    if (!session_grow((void **)&made->joints, &made->joint_capacity, made->joint_count,
                      sizeof *made->joints) ||
        !session_list_joints(s)) {
        made->joint_count = s->joint_count = 0;
        return false;
    }
    for (int i = 0; i < s->joint_count; i++) {
        thud_joint_def def;
        made->joints[i] = thud_joint_get_def(s->world, s->joints[i], &def) == THUD_OK
                              ? joint_of(s, &def)
                              : (scene_joint){.kind = SCENE_FILTER};
    }
    return true;
}

bool session_list_played(session *s) {
    if (!s->played || !s->played->changed)
        return true;
    int count = 0;
    thud_world_get_bodies(s->world, NULL, 0, &count);
    thud_body_id *ids = malloc((size_t)count * sizeof *ids + 1);
    bool listed = ids && thud_world_get_bodies(s->world, ids, count, &count) == THUD_OK &&
                  session_list_bodies(s, ids, count) && list_all_joints(s);
    free(ids);
    s->played->changed = false;
    thud_step_settings settings;
    if (thud_world_get_step_settings(s->world, &settings) == THUD_OK)
        s->time_step = settings.time_step;
    if (!listed)
        snprintf(s->message, sizeof s->message, "Out of memory while listing the bodies.");
    return listed;
}

void session_tell_end(session *s) {
    if (playback_goes_on(s->played))
        return;
    s->paused = true;
    if (s->played->progress.differs)
        playback_tell_difference(s->played, s->message);
    else if (s->played->stopped)
        snprintf(s->message, sizeof s->message, "%s", s->played->why);
}

bool session_go_on_seeking(session *s) {
    if (!s->played || s->played->target < 0)
        return false;
    if (!playback_work(s->played, SEEKING_BUDGET) && s->played->stopped)
        session_tell_end(s);
    session_list_played(s);
    s->alpha = 1;
    return true;
}

/* The view of a recording that does not say how it is to be shown: what moves, with as much around
 * it; if nothing moves, what there is. Bounds are of the centres of bodies. */
static void fit_view(session *s) {
    static const double LEAST = 12; /* m, height of the view. Chosen, as the next. */
    static const double ROOM = 1.6;
    thud_pos low = {INFINITY, INFINITY}, high = {-INFINITY, -INFINITY};
    for (int pass = 0; pass < 2 && !(low.x <= high.x); pass++)
        for (int i = 0; i < s->body_count; i++) {
            thud_body_state body;
            if ((pass == 0 && s->bodies[i].kind == THUD_BODY_STATIC) ||
                thud_body_get_state(s->world, s->bodies[i].id, &body) != THUD_OK)
                continue;
            low = (thud_pos){fmin(low.x, body.center.x), fmin(low.y, body.center.y)};
            high = (thud_pos){fmax(high.x, body.center.x), fmax(high.y, body.center.y)};
        }
    if (!(low.x <= high.x))
        low = high = (thud_pos){0, 0};
    s->scene.camera_x = 0.5 * (low.x + high.x);
    s->scene.camera_y = 0.5 * (low.y + high.y);
    s->scene.camera_height = fmax(ROOM * (high.y - low.y), LEAST);
    s->scene.camera_width = ROOM * (high.x - low.x);
}

/* The recording as a scene, for drawing. False if memory runs out. */
static bool fill_scene(scene *out, const playback *p, const thud_step_settings *settings) {
    enum { ABOUT_MAX = 120 };
    const playback_view *view = &p->view;
    size_t name = strlen(p->name) + 1;
    scene_init(out);
    out->owned_text = malloc(name + ABOUT_MAX);
    if (!out->owned_text)
        return false;
    memcpy(out->owned_text, p->name, name);
    char *about = out->owned_text + name;
    long long steps = p->progress.end - p->progress.first;
    snprintf(about, ABOUT_MAX, "A recording of %lld steps, %.1f s.", steps,
             (double)steps * settings->time_step);
    out->name = out->title = out->owned_text;
    out->about = about;
    out->gravity_x = settings->gravity.x;
    out->gravity_y = settings->gravity.y;
    out->length_scale = view->length_scale;
    out->camera_x = view->x;
    out->camera_y = view->y;
    out->camera_height = view->height;
    out->camera_width = view->width;
    return true;
}

bool session_open_recording(session *s, const char *path) {
    scene fresh;
    thud_step_settings settings;
    s->message[0] = '\0';
    playback *p = playback_open(path, s->threads, session_clock, s->message);
    if (!p)
        return false;
    thud_world_get_step_settings(p->world, &settings);
    if (!fill_scene(&fresh, p, &settings)) {
        snprintf(s->message, sizeof s->message, "Out of memory.");
        playback_close(p);
        return false;
    }
    session_destroy_world(s);
    session_show_world(s, p->world, fresh, settings.time_step);
    s->played = p;
    p->log = session_log;
    p->log_context = s;
    if (session_list_played(s) && !(p->view.height > 0))
        fit_view(s);
    return true;
}

void session_seek(session *s, int64_t step) {
    if (!s->played)
        return;
    s->message[0] = '\0';
    playback_seek(s->played, step);
}

void session_fork(session *s) {
    playback *p = s->played;
    if (!p)
        return;
    s->message[0] = '\0';
    if (p->forked)
        session_seek(s, p->progress.steps);
    else if (!playback_fork(p))
        snprintf(s->message, sizeof s->message,
                 "This step is not the one that was recorded: go back, and fork there.");
}

void session_save_last(session *s) {
    if (s->played)
        snprintf(s->message, sizeof s->message,
                 "Only scenes and levels are recorded, and this is a recording.");
    else
        last_seconds_save(&s->last, &s->scene, s->message, sizeof s->message);
}

bool session_yields(session *s) {
    if (!s->played || s->played->forked)
        return true;
    snprintf(s->message, sizeof s->message,
             "A recording plays as it was made. Fork it (H) to change what happens.");
    return false;
}
