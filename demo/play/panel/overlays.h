/* overlays.h: what can be shown on top of the bodies, by name. */
#ifndef THUD_PLAY_OVERLAYS_H
#define THUD_PLAY_OVERLAYS_H

#include <SDL.h>
#include <stdbool.h>

typedef enum overlay {
    OVERLAY_CONTACTS = 0,
    OVERLAY_NORMALS,
    OVERLAY_BOUNDS,
    OVERLAY_CELLS,
    OVERLAY_ISLANDS,  /* bodies take their island's colour */
    OVERLAY_SLEEPING, /* sleeping bodies are dimmed */
    OVERLAY_TIMINGS,
    OVERLAY_AXES,    /* the plane sweep's sorted intervals */
    OVERLAY_PAIRS,   /* whose bounds overlap */
    OVERLAY_MOTIONS, /* swept volumes of what is fast */
    OVERLAY_JOINTS,
    OVERLAY_FORCES, /* of joints, and where they are open */
    OVERLAY_COUNT
} overlay;

typedef unsigned overlay_set; /* bit 1 << overlay */

static const overlay_set OVERLAYS_DEFAULT = 1u << OVERLAY_SLEEPING | 1u << OVERLAY_JOINTS;

const char *overlay_name(overlay which);
char overlay_key(overlay which); /* a digit, or a capital letter */
SDL_Color overlay_color(overlay which);

static inline bool overlays_have(overlay_set set, overlay which) {
    return (set >> which & 1) != 0;
}

/* Those that a scene asks for: `show` is its scene_show. */
overlay_set overlays_of_scene(unsigned show);

/* Reads names separated by commas, "all" or "none". False if there is an unknown one. */
bool overlays_parse(const char *list, overlay_set *out);

#endif
