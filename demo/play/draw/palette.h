/* palette.h: all colours of the viewer. */
#ifndef THUD_PLAY_PALETTE_H
#define THUD_PLAY_PALETTE_H

#include <SDL.h>

#define RGB(hex) ((SDL_Color){((hex) >> 16) & 0xFF, ((hex) >> 8) & 0xFF, (hex)&0xFF, 0xFF})
#define RGBA(hex, alpha) \
    ((SDL_Color){((hex) >> 16) & 0xFF, ((hex) >> 8) & 0xFF, (hex)&0xFF, (alpha)})

/* The background: night blue, a little lighter towards the horizon. */
#define COLOR_SKY_TOP RGB(0x12161F)
#define COLOR_SKY_BOTTOM RGB(0x1C2330)
#define COLOR_GRID RGBA(0x8FA3C0, 16)
#define COLOR_AXIS RGBA(0x8FA3C0, 44)

#define COLOR_STATIC RGB(0x66738A)
#define COLOR_KINEMATIC RGB(0xE8E2D0)
#define COLOR_SENSOR RGB(0xC792EA)
#define COLOR_GROUND RGB(0x3A4658)
#define COLOR_GROUND_DEEP RGB(0x232B38)
#define COLOR_SURFACE RGB(0x9DB38A)
/* Textured ground: rock, grass, ice and sand, and the footprints on it. */
#define COLOR_MATERIALS \
    { RGB(0x8D99AE), RGB(0x8CC265), RGB(0x5AA9E6), RGB(0xF2B134) }
#define COLOR_PRINT RGBA(0x10141C, 0xC0)
#define COLOR_CHARACTER RGB(0xFF8A5C)
#define COLOR_WATER RGB(0x4AA8E0)
#define COLOR_WATER_DEEP RGB(0x15457E)
#define COLOR_SURFACE_OF_WATER RGBA(0xBFE6FF, 0xB0)
#define COLOR_BLAST RGB(0xFFD27A)
#define COLOR_QUARANTINED RGB(0xFF3B5C)

/* Dynamic bodies, chosen by their number or handle. */
#define COLOR_BODIES \
    { RGB(0x5AA9E6), RGB(0xF2B134), RGB(0x4FC1A6), RGB(0xEE6C4D), RGB(0xA78BDA), RGB(0x8CC265) }
enum { COLOR_BODY_COUNT = 6 };

#define COLOR_CONTACT RGB(0xFF4D6D)
#define COLOR_NORMAL RGB(0x7CF5C4)
#define COLOR_BOUNDS RGB(0xFF9F5A)
#define COLOR_CELL RGB(0x5C7CFA)
#define COLOR_ISLAND RGB(0xD65DB1)
#define COLOR_SLEEPING RGB(0x7A86A0)
#define COLOR_TIMINGS RGB(0xF7E27E)
#define COLOR_INTERVAL RGB(0x4DD0E1)
#define COLOR_PAIR RGB(0xB0BEC5)
#define COLOR_TOUCHING RGB(0xFFD166)
#define COLOR_MOTION RGB(0xF78FB3)
#define COLOR_SUM RGB(0x7CF5C4)
#define COLOR_GRAB RGB(0xFFFFFF)
#define COLOR_JOINT RGB(0xF4E9CD)
#define COLOR_JOINT_SPRING RGB(0xB9D8C2)
#define COLOR_FORCE RGB(0xFFC857)
#define COLOR_OPEN RGB(0xFF6B6B)

/* One per stage, in the order of thud_stage. */
#define COLOR_STAGES                                                                              \
    {                                                                                             \
        RGB(0x8D99AE), RGB(0x5C7CFA), RGB(0x5AA9E6), RGB(0x4FC1A6), RGB(0xF2B134), RGB(0xEE6C4D), \
            RGB(0xFF4D6D), RGB(0xA78BDA), RGB(0xE8E2D0)                                           \
    }

#define COLOR_PANEL RGB(0x171C26)
#define COLOR_PANEL_EDGE RGB(0x2C3546)
#define COLOR_WIDGET RGB(0x252D3C)
#define COLOR_WIDGET_HOVER RGB(0x323D51)
#define COLOR_WIDGET_ON RGB(0x3A6EA5)
#define COLOR_TEXT RGB(0xD9E1EE)
#define COLOR_TEXT_DIM RGB(0x8592A8)
#define COLOR_TEXT_STRONG RGB(0xFFFFFF)
#define COLOR_ERROR RGB(0xFF8A8A)
#define COLOR_SHADE RGBA(0x10141C, 0xD8)

/* The colour between a (t = 0) and b (t = 1), alpha included. */
static inline SDL_Color color_mix(SDL_Color a, SDL_Color b, float t) {
    return (SDL_Color){(Uint8)(a.r + (b.r - a.r) * t + 0.5f), (Uint8)(a.g + (b.g - a.g) * t + 0.5f),
                       (Uint8)(a.b + (b.b - a.b) * t + 0.5f),
                       (Uint8)(a.a + (b.a - a.a) * t + 0.5f)};
}

static inline SDL_Color color_fade(SDL_Color color, float alpha) {
    color.a = (Uint8)(color.a * alpha + 0.5f);
    return color;
}

#endif
