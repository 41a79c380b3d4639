/* viewer.c: see viewer.h. */
#include "viewer.h"

#include "draw/draw_character.h"
#include "draw/draw_fields.h"
#include "draw/draw_joints.h"
#include "draw/draw_overlays.h"
#include "draw/draw_queries.h"
#include "draw/draw_world.h"
#include "panel/hud.h"
#include "draw/palette.h"
#include "panel/panel.h"
#include "panel/timeline.h"

#include <math.h>
#include <stdio.h>

/* Height of the view that follows a character, in length scales, and the rate at which it does,
 * 1/s. */
static const double CHARACTER_VIEW = 20, FOLLOW_RATE = 6;

/* The speeds to choose from, world seconds per real second. */
static const double SPEEDS[] = {0.1, 0.25, 0.5, 1, 2, 4};
enum { SPEED_COUNT = sizeof SPEEDS / sizeof SPEEDS[0] };

void viewer_init(viewer *v) {
    *v = (viewer){.selected = -1, .overlays = OVERLAYS_DEFAULT};
    session_init(&v->session);
}

void viewer_free(viewer *v) {
    session_free(&v->session);
    catalog_free(&v->catalog);
    canvas_free(&v->canvas);
}

static void stepped(session *s, void *context) {
    character_step(context, s);
}

/* Builds the world of an entry, with its character. */
static bool load(viewer *v, int entry) {
    grab_end(&v->grab, &v->session); /* its joint belongs to the world that is destroyed */
    if (!session_load(&v->session, &v->catalog.entries[entry]))
        return false;
    character_start(&v->character, &v->session);
    v->session.stepped = v->character.present ? stepped : NULL;
    v->session.stepped_context = &v->character;
    timings_clear(&v->timings);
    return true;
}

bool viewer_open(viewer *v, int entry) {
    if (entry < 0 || entry >= v->catalog.count || !load(v, entry))
        return false;
    v->selected = entry;
    v->reveal = true;
    v->overlays &= ~v->lent;
    v->lent = overlays_of_scene(v->session.scene.show) & ~v->overlays;
    v->overlays |= v->lent;
    viewer_look_home(v);
    return true;
}

bool viewer_open_recording(viewer *v, const char *path) {
    grab_end(&v->grab, &v->session);
    if (!session_open_recording(&v->session, path))
        return false;
    v->character.present = false;
    v->session.stepped = NULL;
    v->selected = -1;
    v->scrubbing = false;
    v->overlays &= ~v->lent;
    v->lent = 0;
    timings_clear(&v->timings);
    viewer_layout(v);
    viewer_look_home(v);
    return true;
}

bool viewer_open_file(viewer *v, const char *path) {
    bool opened = false;
    if (playback_is_recording(path)) {
        opened = viewer_open_recording(v, path);
    } else {
        int entry = catalog_find(&v->catalog, path);
        if (entry >= 0)
            opened = viewer_open(v, entry);
        else
            snprintf(v->session.message, sizeof v->session.message,
                     "%.200s is neither a recording nor a level.", path);
    }
    v->session.paused &= !opened;
    return opened;
}

void viewer_reset(viewer *v) {
    if (v->selected >= 0)
        load(v, v->selected);
    else if (v->session.played) {
        grab_end(&v->grab, &v->session);
        session_seek(&v->session, v->session.played->progress.first);
    }
}

void viewer_look_home(viewer *v) {
    const scene *s = &v->session.scene;
    thud_pos center = {s->camera_x, s->camera_y};
    if (v->character.present)
        camera_look(&v->camera, character_place(&v->character, 1), CHARACTER_VIEW * s->length_scale,
                    0);
    else
        camera_look(&v->camera, center, s->camera_height, s->camera_width);
}

void viewer_toggle_overlay(viewer *v, overlay which) {
    v->overlays ^= 1u << which;
    v->lent &= ~(1u << which);
}

/* Whether the scene can be built anew with another detection or broadphase: not where a recording
 * is played. Then it also writes the reason into the session's message. */
static bool may_rebuild(viewer *v) {
    if (v->session.played)
        snprintf(v->session.message, sizeof v->session.message,
                 "A recording keeps the detection and the broadphase that it was made with.");
    return !v->session.played;
}

void viewer_set_detection(viewer *v, int detection) {
    if (!may_rebuild(v))
        return;
    v->session.detection = detection;
    viewer_reset(v);
}

void viewer_set_broadphase(viewer *v, int broadphase) {
    if (!may_rebuild(v))
        return;
    v->session.broadphase = broadphase;
    viewer_reset(v);
}

void viewer_toggle_pause(viewer *v) {
    const playback *p = v->session.played;
    if (p && v->session.paused) {
        v->session.message[0] = '\0';
        /* After the end it plays from the start again. */
        if (!p->forked && p->target < 0 && p->progress.steps == p->progress.end)
            session_seek(&v->session, p->progress.first);
    }
    v->session.paused = !v->session.paused;
    if (v->session.paused)
        /* Overlays show the state after the last step, so poses must not be interpolated. */
        v->session.alpha = 1;
}

void viewer_single_step(viewer *v) {
    v->session.paused = true;
    viewer_step_once(v);
}

void viewer_go_to(viewer *v, int64_t step) {
    if (!v->session.played)
        return;
    grab_end(&v->grab, &v->session);
    v->session.paused = true;
    session_seek(&v->session, step);
}

void viewer_go(viewer *v, int steps) {
    const playback *p = v->session.played;
    if (p && p->forked && steps > 0)
        viewer_single_step(v);
    else if (p)
        viewer_go_to(v, (p->target < 0 ? p->progress.steps : p->target) + steps);
}

void viewer_fork(viewer *v) {
    grab_end(&v->grab, &v->session);
    session_fork(&v->session);
}

void viewer_change_speed(viewer *v, int direction) {
    int nearest = 0;
    while (nearest + 1 < SPEED_COUNT && SPEEDS[nearest] < v->session.speed)
        nearest++;
    nearest += direction;
    nearest = nearest < 0 ? 0 : nearest >= SPEED_COUNT ? SPEED_COUNT - 1 : nearest;
    v->session.speed = SPEEDS[nearest];
}

void viewer_spawn_at_home(viewer *v, thud_shape_kind kind) {
    const scene *s = &v->session.scene;
    session_spawn(&v->session, kind, (thud_pos){s->spawn_x, s->spawn_y}, 1);
}

void viewer_layout(viewer *v) {
    float left = v->bare ? 0 : panel_width(&v->canvas);
    SDL_FRect view = {left, 0, (float)v->canvas.width - left, (float)v->canvas.height};
    if (view.w < 1)
        view.w = 1;
    camera_set_view(&v->camera, view);
}

/* Adds the last step's times to the graph, if there was a step. */
static void record_timings(viewer *v, uint64_t steps_before) {
    if (!v->session.world)
        return;
    thud_stats stats = thud_stats_of(v->session.world);
    if (stats.steps != steps_before)
        timings_add(&v->timings, &stats);
}

/* Moves the camera exponentially towards the character while the character moves. While it stands,
 * the user may move the camera. */
static void follow_character(viewer *v, double elapsed) {
    const character *c = &v->character;
    if (!c->present || v->panning || v->session.paused || !character_moves(c))
        return;
    thud_pos at = character_place(c, v->session.alpha);
    double part = 1 - exp(-FOLLOW_RATE * elapsed);
    v->camera.center.x += part * (at.x - v->camera.center.x);
    v->camera.center.y += part * (at.y - v->camera.center.y);
}

void viewer_advance(viewer *v, double elapsed) {
    uint64_t before = v->session.world ? thud_stats_of(v->session.world).steps : 0;
    session_advance(&v->session, elapsed);
    follow_character(v, elapsed);
    record_timings(v, before);
}

void viewer_step_once(viewer *v) {
    uint64_t before = v->session.world ? thud_stats_of(v->session.world).steps : 0;
    session_step(&v->session);
    record_timings(v, before);
}

void viewer_draw(viewer *v) {
    canvas *c = &v->canvas;
    draw_background(c, &v->camera);
    if (v->session.world) {
        draw_world(c, &v->camera, &v->session, v->overlays);
        if (v->character.present)
            draw_character(c, &v->camera, &v->character, v->session.alpha);
        if (overlays_have(v->overlays, OVERLAY_JOINTS))
            draw_joints(c, &v->camera, &v->session);
        draw_fields(c, &v->camera, &v->session);
        draw_pairs(c, &v->camera, &v->session, v->pair_look);
        draw_texture(c, &v->camera, &v->session, &v->prints);
        draw_overlays(c, &v->camera, &v->session, v->overlays, v->bare ? 0 : hud_footer(v));
        if (overlays_have(v->overlays, OVERLAY_FORCES))
            draw_joint_forces(c, &v->camera, &v->session);
        thud_pos anchor;
        if (v->lists_calls && v->session.played)
            draw_queries(c, &v->camera, v->session.played);
        timeline_mark(v);
        if (grab_anchor(&v->grab, &v->session, &anchor))
            draw_pull(c, &v->camera, anchor, v->grab.target);
    }
    if (!v->bare) {
        hud_draw(v);
        panel_draw(v);
    } else if (overlays_have(v->overlays, OVERLAY_TIMINGS)) {
        timings_draw(&v->timings, c, hud_footer(v));
    }
    canvas_flush(c);
    SDL_RenderPresent(c->renderer);
}
