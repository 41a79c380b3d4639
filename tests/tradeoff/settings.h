/* settings.h: an engine at one of its settings, which is one point of the trade-off. */
#ifndef THUD_TRADEOFF_SETTINGS_H
#define THUD_TRADEOFF_SETTINGS_H

#include "engine.h"

typedef struct setting {
    const physics_engine *engine;
    const char *name;  /* unique among those of its engine */
    const char *curve; /* settings of one curve go from cheap to dear in their order */
    engine_settings with;
} setting;

enum { SETTINGS_MAX = 24 };

/* Those of thud, and then those of Box2D and Chipmunk where the build has them. */
extern const setting SETTINGS[];
extern const int SETTING_COUNT;

/* Chipmunk is asked of joints alone. */
bool setting_goes_through(const setting *how, const scene *s);

#endif
