/* viewer.h: the whole viewer's state, and what a key or a button can do to it. */
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
    int selected; /* in the catalog */
    session session;
    camera camera;
    canvas canvas;
    grab grab;
    character character;
    overlay_set overlays;
    overlay_set lent; /* of the overlays those that the scene asked for, and takes along */
    pair_look pair_look;
    timings timings;
    texture_prints prints;
    ui ui;
    bool bare; /* the picture alone: no panel, no texts */
    bool panning;
    float list_scroll;    /* of the panel's list, in pixels */
    bool reveal;          /* the list has to scroll to the selected entry */
    double frame_seconds; /* smoothed time between frames; 0 where time is not real */
    bool quit;
} viewer;

void viewer_init(viewer *v);
void viewer_free(viewer *v);

/* Loads the catalog's entry and looks at it; on failure everything stays, and the session's
 * message says why. */
bool viewer_open(viewer *v, int entry);
void viewer_reset(viewer *v); /* the same world from its start, seen from the same place */
void viewer_look_home(viewer *v);
void viewer_toggle_overlay(viewer *v, overlay which);
/* Start the scene anew with another one. */
void viewer_set_detection(viewer *v, int detection);
void viewer_set_broadphase(viewer *v, int broadphase);
void viewer_toggle_pause(viewer *v);
void viewer_single_step(viewer *v);                 /* pauses first */
void viewer_change_speed(viewer *v, int direction); /* to the next of a row of speeds */
void viewer_spawn_at_home(viewer *v, thud_shape_kind kind);

/* Divides the output between panel and world. Call when either changes. */
void viewer_layout(viewer *v);

/* Moves time on by `elapsed` seconds. */
void viewer_advance(viewer *v, double elapsed);
/* One step and no clock: for pictures that must come out the same every time. */
void viewer_step_once(viewer *v);
void viewer_draw(viewer *v);

#endif
