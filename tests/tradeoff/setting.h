/* setting.h: an engine at one of its settings, which is one point of the trade-off. */
#ifndef THUD_TRADEOFF_SETTING_H
#define THUD_TRADEOFF_SETTING_H

#include "contender.h"

#include <thud/thud_detection.h>
#include <thud/thud_quality.h>

typedef struct setting setting;

/* How the engine is driven; bodies are read as a contender of the benchmark reads them. */
typedef struct setting_engine {
    const char *name;
    /* Sleeping off, a step of 1/60 s, one thread. Null when it fails, and a line on stderr says
     * why. The scene must outlive the world. */
    void *(*create)(const scene *s, const setting *how);
    void (*destroy)(void *world); /* null is fine */
    bool (*step)(void *world);
    void (*read)(void *world, contender_body *bodies); /* in the scene's order */
} setting_engine;

struct setting {
    const setting_engine *engine;
    const char *name;            /* unique among those of its engine */
    const char *curve;           /* settings of one curve go from cheap to dear in their order */
    const thud_quality *quality; /* thud */
    const thud_detection *detection; /* thud: null takes the quality's */
    int substeps;                    /* Box2D */
    double contact_hertz;            /* Box2D: b2WorldDef.contactHertz */
};

enum { SETTINGS_MAX = 16 };

/* Those of thud, and those of Box2D where the build has it. */
extern const setting SETTINGS_THUD[], SETTINGS_BOX2D[];
extern const int SETTINGS_THUD_COUNT, SETTINGS_BOX2D_COUNT;

#endif
