/* overlays.c: see overlays.h. */
#include "panel/overlays.h"

#include "draw/palette.h"

#include <scene.h>

#include <string.h>

static const char *const NAMES[OVERLAY_COUNT] = {"contacts", "normals",  "bounds",  "cells",
                                                 "islands",  "sleeping", "timings", "axes",
                                                 "pairs",    "motions",  "joints",  "forces"};

const char *overlay_name(overlay which) {
    return NAMES[which];
}

char overlay_key(overlay which) {
    return "1234567890JK"[which];
}

SDL_Color overlay_color(overlay which) {
    static const SDL_Color colors[OVERLAY_COUNT] = {COLOR_CONTACT, COLOR_NORMAL,   COLOR_BOUNDS,
                                                    COLOR_CELL,    COLOR_ISLAND,   COLOR_SLEEPING,
                                                    COLOR_TIMINGS, COLOR_INTERVAL, COLOR_PAIR,
                                                    COLOR_MOTION,  COLOR_JOINT,    COLOR_FORCE};
    return colors[which];
}

overlay_set overlays_of_scene(unsigned show) {
    overlay_set set = 0;
    if (show & SCENE_SHOW_CELLS)
        set |= 1u << OVERLAY_CELLS;
    if (show & SCENE_SHOW_AXES)
        set |= 1u << OVERLAY_AXES;
    if (show & SCENE_SHOW_MOTIONS)
        set |= 1u << OVERLAY_MOTIONS;
    return set;
}

static bool same(const char *text, size_t length, const char *name) {
    return strlen(name) == length && strncmp(text, name, length) == 0;
}

/* Adds the overlay of a name, all, or none to *set. False if the name is unknown. */
static bool parse_one(const char *text, size_t length, overlay_set *set) {
    if (same(text, length, "none"))
        return true;
    for (int i = 0; i < OVERLAY_COUNT; i++)
        if (same(text, length, NAMES[i])) {
            *set |= 1u << i;
            return true;
        }
    if (!same(text, length, "all"))
        return false;
    *set = (1u << OVERLAY_COUNT) - 1;
    return true;
}

bool overlays_parse(const char *list, overlay_set *out) {
    overlay_set set = 0;
    for (;;) {
        size_t length = strcspn(list, ",");
        if (!parse_one(list, length, &set))
            return false;
        if (list[length] == '\0')
            break;
        list += length + 1;
    }
    *out = set;
    return true;
}
