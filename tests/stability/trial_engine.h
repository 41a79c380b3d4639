/* trial_engine.h: what trial.c asks of an engine. */
#ifndef THUD_STABILITY_TRIAL_ENGINE_H
#define THUD_STABILITY_TRIAL_ENGINE_H

#include "trial.h"

typedef struct trial_engine {
    /* Null when it fails. */
    void *(*create)(const ledger *l, entrant e, const scene *s, const trial_settings *settings);
    void (*destroy)(void *world);
    bool (*step)(void *world);
    bool (*set_time_step)(void *world, double seconds);
    void (*read)(void *world, contender_body *bodies); /* places in the world */
    void (*pose)(void *world, int body, thud_pos origin, thud_pose *out);
    bool (*renew)(void *world, const scene *s, int body);
    bool (*misuse)(void *world, int body, misuse call, double value);
    uint64_t (*bytes)(void *world);
    uint64_t (*allocations)(void *world);
} trial_engine;

/* misuse_thud.c: whether it was refused. */
bool misuse_thud(thud_world *w, thud_body_id body, misuse call, double x);

extern const trial_engine TRIAL_THUD;
extern const trial_engine TRIAL_BOX2D; /* only where THUD_BOX2D_BUILD is defined */

#endif
