/* viewer.h: the state of the viewer, and the actions of its keys and buttons. */
#ifndef THUD_PLAY_VIEWER_H
#define THUD_PLAY_VIEWER_H

#include "draw/camera.h"
#include "draw/canvas.h"
#include "draw/draw_pairs.h"
#include "draw/draw_texture.h"
#include "panel/catalog.h"
#include "character.h"
#include "grab.h"
#include "panel/overlays.h"
#include "session.h"
#include "panel/timings.h"
#include "panel/ui.h"

typedef struct viewer {
    catalog catalog;
    int selected; /* index in the catalog; -1: none, a recording is shown */
    session session;
    camera camera;
    canvas canvas;
    grab grab;
    character character;
    overlay_set overlays;
    /* Those of `overlays` that are on only because the scene shows them; they go off with the
     * scene. */
    overlay_set lent;
    pair_look pair_look;
    timings timings;
    texture_prints prints;
    ui ui;
    bool bare; /* the picture alone: no panel and no texts */
    bool panning;
    bool scrubbing;       /* the pointer holds the line of a recording's steps */
    bool lists_calls;     /* the calls of the present step of a recording are listed */
    float list_scroll;    /* of the panel's list, pixels */
    bool reveal;          /* the list has to scroll to the selected entry in the next frame */
    double frame_seconds; /* mean time between frames, s; 0 for pictures */
    bool quit;
} viewer;

void viewer_init(viewer *v);
void viewer_free(viewer *v);

/* Loads an entry of the catalog and moves the camera to it. False, and the session's message says
 * why, if that fails; then everything stays. */
bool viewer_open(viewer *v, int entry);
/* Opens a recording, and moves the camera to it. False as viewer_open. */
bool viewer_open_recording(viewer *v, const char *path);
/* Opens a file that a user brought, a recording or a level, and plays it. False as viewer_open. */
bool viewer_open_file(viewer *v, const char *path);
/* Builds the scene anew, or goes to the first step of a recording; the camera stays. */
void viewer_reset(viewer *v);
/* Moves the camera to the scene's first view, or to the character. */
void viewer_look_home(viewer *v);
void viewer_toggle_overlay(viewer *v, overlay which);
/* Both build the scene anew with the chosen system; not of a recording, which `message` says. */
void viewer_set_detection(viewer *v, int detection);
void viewer_set_broadphase(viewer *v, int broadphase);
void viewer_toggle_pause(viewer *v);
void viewer_single_step(viewer *v); /* pauses, and runs one step */
/* Pauses, and goes so many steps forward, or back if negative, in a recording. */
void viewer_go(viewer *v, int steps);
void viewer_go_to(viewer *v, int64_t step); /* the same, to a step */
void viewer_fork(viewer *v);                /* session_fork, and what is held is let go */
/* To the next faster (1) or slower (-1) speed of a list. */
void viewer_change_speed(viewer *v, int direction);
void viewer_spawn_at_home(viewer *v, thud_shape_kind kind);

/* Divides the output between panel and world. Has to be called when the output's size or `bare`
 * changes. */
void viewer_layout(viewer *v);

/* Advances the world, the camera and the timings by `elapsed` real seconds. */
void viewer_advance(viewer *v, double elapsed);
/* Runs one step without a clock, for pictures that have to be the same every time. */
void viewer_step_once(viewer *v);
void viewer_draw(viewer *v);

#endif
