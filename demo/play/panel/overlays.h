/* overlays.h: the overlays that can be drawn over the bodies, and their names. */
#ifndef THUD_PLAY_OVERLAYS_H
#define THUD_PLAY_OVERLAYS_H

#include <SDL.h>
#include <stdbool.h>

typedef enum overlay {
    OVERLAY_CONTACTS = 0,
    OVERLAY_NORMALS,
    OVERLAY_BOUNDS,
    OVERLAY_CELLS,
    OVERLAY_ISLANDS,  /* bodies have the colour of their island */
    OVERLAY_SLEEPING, /* sleeping bodies are dimmed */
    OVERLAY_TIMINGS,
    OVERLAY_AXES,    /* the sorted intervals of the sweep broadphase */
    OVERLAY_PAIRS,   /* pairs of shapes whose bounds overlap */
    OVERLAY_MOTIONS, /* swept volumes of fast bodies */
    OVERLAY_JOINTS,
    OVERLAY_FORCES, /* forces of joints, and gaps of open joints */
    OVERLAY_COUNT
} overlay;

typedef unsigned overlay_set; /* bits 1 << overlay */

static const overlay_set OVERLAYS_DEFAULT = 1u << OVERLAY_SLEEPING | 1u << OVERLAY_JOINTS;

const char *overlay_name(overlay which);
char overlay_key(overlay which); /* the key that toggles it: a digit, or a capital letter */
SDL_Color overlay_color(overlay which);

static inline bool overlays_have(overlay_set set, overlay which) {
    return (set >> which & 1) != 0;
}

/* The overlays that a scene asks for by its scene.show. */
overlay_set overlays_of_scene(unsigned show);

/* Parses names separated by commas, "all" or "none". False if one is unknown. */
bool overlays_parse(const char *list, overlay_set *out);

#endif
