/* settings.h: an engine with one of its settings, which is one point in the plots of the trade-off.
 */
#ifndef THUD_TRADEOFF_SETTINGS_H
#define THUD_TRADEOFF_SETTINGS_H

#include "engine.h"

typedef struct setting {
    const physics_engine *engine;
    const char *name;  /* unique within its engine */
    const char *curve; /* settings of a curve are listed from the cheapest to the most expensive */
    engine_settings with;
} setting;

enum { SETTINGS_MAX = 24 };

/* The settings of thud, followed by those of Box2D and Chipmunk if the build has them. */
extern const setting SETTINGS[];
extern const int SETTING_COUNT;

/* Whether the setting runs this scene: Chipmunk runs scenes with joints only. */
bool setting_goes_through(const setting *how, const scene *s);

#endif
