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

enum { SETTINGS_MAX = 16 };

/* Those of thud, and then those of Box2D where the build has it. */
extern const setting SETTINGS[];
extern const int SETTING_COUNT;

#endif
