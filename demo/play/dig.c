/* dig.c: see dig.h. */
#include "dig.h"

#include <stdio.h>

/* Last: the calls of this file are recorded. */
#include <thud/thud_recorded.h>

/* In length scales of the scene. */
static const double CRATER_RADIUS = 1.5;
static const double MOUND_RADIUS = 2;
static const double MOUND_HEIGHT = 0.4;

static thud_result dig_shape(session *s, thud_shape_id shape, thud_pos at, bool mound) {
    double unit = s->scene.length_scale;
    return mound ? thud_shape_raise(s->world, shape, at.x, MOUND_RADIUS * unit, MOUND_HEIGHT * unit)
                 : thud_shape_dig(s->world, shape, at, CRATER_RADIUS * unit);
}

/* Digs or raises every terrain line with vertices. A message says so if there is none. */
static void dig(session *s, thud_pos at, bool mound) {
    if (!s->world || !session_yields(s))
        return;
    s->message[0] = '\0';
    int lines = 0;
    for (int i = 0; i < s->shape_count; i++) {
        thud_terrain terrain;
        if (s->shapes[i].kind != THUD_SHAPE_TERRAIN ||
            thud_shape_get_terrain(s->world, s->shapes[i].id, &terrain) != THUD_OK ||
            terrain.kind == THUD_TERRAIN_FLAT)
            continue;
        lines++;
        if (dig_shape(s, s->shapes[i].id, at, mound) != THUD_OK)
            return; /* log_message has stored the message */
    }
    if (lines == 0)
        snprintf(s->message, sizeof s->message,
                 "There is no ground to dig here: try the scene Digging.");
}

void dig_crater(session *s, thud_pos at) {
    dig(s, at, false);
}

void dig_mound(session *s, thud_pos at) {
    dig(s, at, true);
}
