/* advise_growth.c: see advise_growth.h. */
#define _POSIX_C_SOURCE 200809L

#include "advise_growth.h"

#include "load.h"
#include "scenes.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

/* Fewer steps show nothing. */
enum { STEPS_MIN = 4 };
/* The range is narrow enough where the broken size has at most this times as many bodies. */
static const double NEAR = 1.1;

static double seconds_now(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Runs one size: once counting what it uses, and once more for its times. */
static bool measure(advise_growth *out, run_options how, int size) {
    advise_size *row = &out->sizes[out->count++];
    *row = (advise_size){.size = size, .setting = {.how = how}};
    row->setting.how.size = size;
    scene s;
    if (!run_load(&row->setting.how, &s))
        return false;
    row->bodies = s.body_count;
    run_outcome counted;
    bool done = advise_run(&row->setting, &s) &&
                uses_count(&row->setting.how, &s, &counted, &row->uses) &&
                (row->setting.ms <= out->budget_ms || advise_run(&row->setting, &s));
    scene_free(&s);
    row->broken = row->setting.error > how.max_error ? ADVISE_TOO_WRONG
                  : row->setting.ms > out->budget_ms ? ADVISE_TOO_SLOW
                                                     : ADVISE_HOLDS;
    return done;
}

/* The size to try next; 0: none. */
static int next_size(const advise_growth *g, const scene_info *info) {
    const advise_size *held = g->held >= 0 ? &g->sizes[g->held] : NULL;
    const advise_size *missed = g->missed >= 0 ? &g->sizes[g->missed] : NULL;
    if (!held)
        return missed && missed->size / 2 >= info->min_size && missed->size > 1 ? missed->size / 2
                                                                                : 0;
    if (!missed) {
        int size = held->size > info->max_size / 2 ? info->max_size : 2 * held->size;
        return size > held->size ? size : 0;
    }
    if (missed->bodies <= NEAR * held->bodies)
        return 0;
    int between = (int)round(sqrt((double)held->size * missed->size));
    return between > held->size && between < missed->size ? between : 0;
}

/* Keeps the last size as the largest that holds or the smallest that is broken. */
static void sort_in(advise_growth *g) {
    int last = g->count - 1;
    bool broken = g->sizes[last].broken != ADVISE_HOLDS;
    int *kept = broken ? &g->missed : &g->held;
    if (*kept < 0 || (g->sizes[last].size < g->sizes[*kept].size) == broken)
        *kept = last;
}

/* Runs the scene with one factor. False after a message. */
static bool try_factor(advise_strain *out, double factor, run_options how) {
    advise_setting *setting = &out->tried[out->count];
    *setting = (advise_setting){.how = how};
    out->factors[out->count++] = factor;
    scene s;
    if (!run_load(&how, &s))
        return false;
    bool done = advise_run(setting, &s);
    scene_free(&s);
    out->broke = setting->error > how.max_error;
    return done;
}

static bool strain_speed(const run_options *how, advise_strain *out) {
    for (int k = 0; k < ADVISE_FACTORS_MAX && !out->broke; k++) {
        double factor = (double)(1 << k);
        run_options faster = *how;
        faster.rate /= factor;
        faster.steps = (long)round((double)how->steps / factor);
        if (faster.steps < STEPS_MIN || faster.rate * THUD_TIME_STEP_MAX < 1)
            return true;
        if (!try_factor(out, factor, faster))
            return false;
    }
    return true;
}

static bool strain_mass(const run_options *how, const scene *s, advise_strain *out) {
    double density = 0;
    for (int i = 0; i < s->shape_count; i++)
        density = fmax(density, s->shapes[i].material.density);
    for (int k = 0; k < ADVISE_FACTORS_MAX && !out->broke; k++) {
        run_options heavier = *how;
        heavier.heavier *= pow(10, k);
        if (density * heavier.heavier > THUD_DENSITY_MAX || heavier.heavier > RUN_HEAVIER_MAX)
            return true;
        if (!try_factor(out, pow(10, k), heavier))
            return false;
    }
    return true;
}

static bool grow_sizes(const run_options *how, advise_growth *out) {
    const scene_info *info = scenes_find(how->source);
    if (!info) {
        out->why_not = "a level has one size";
        return true;
    }
    double begun = seconds_now(), last = 0;
    int size = how->size > 0 ? how->size : info->default_size;
    while (size > 0 && out->count < ADVISE_SIZES_MAX) {
        /* A size is not begun where it would take too long, by the time of the one before. */
        double start = seconds_now();
        const advise_size *before = out->count > 0 ? &out->sizes[out->count - 1] : NULL;
        double larger = before ? fmax(1, (double)size / before->size) : 1;
        if (start - begun + larger * last >= how->patience) {
            out->gave_up = true;
            return true;
        }
        advise_progress("trying sizes", out->count + 1, ADVISE_SIZES_MAX);
        if (!measure(out, *how, size))
            return false;
        sort_in(out);
        last = seconds_now() - start;
        size = next_size(out, info);
    }
    return true;
}

bool advise_grow(const run_options *how, const scene *s, advise_growth *out) {
    *out = (advise_growth){.held = -1,
                           .missed = -1,
                           .budget_ms = isfinite(how->budget) ? how->budget : 1000.0 / 60};
    if (!grow_sizes(how, out))
        return false;
    if (scene_has_fields(s) || s->fields.breaks != 0)
        out->no_speeds = "its fields and rules act by numbers of steps";
    else if (!strain_speed(how, &out->faster))
        return false;
    return strain_mass(how, s, &out->heavier);
}

advise_first advise_first_of(const advise_growth *g) {
    advise_first first = {"", INFINITY};
    const advise_strain *strains[] = {&g->faster, &g->heavier};
    static const char *const NAMES[] = {"speed", "mass"};
    if (g->missed >= 0)
        first = (advise_first){g->sizes[g->missed].broken == ADVISE_TOO_SLOW ? "time" : "size",
                               (double)g->sizes[g->missed].size / g->sizes[0].size};
    for (int i = 0; i < 2; i++)
        if (strains[i]->broke && strains[i]->factors[strains[i]->count - 1] < first.factor)
            first = (advise_first){NAMES[i], strains[i]->factors[strains[i]->count - 1]};
    return first;
}

static void free_strain(advise_strain *strain) {
    for (int i = 0; i < strain->count; i++)
        advise_setting_free(&strain->tried[i]);
}

void advise_growth_free(advise_growth *growth) {
    for (int i = 0; i < growth->count; i++)
        advise_setting_free(&growth->sizes[i].setting);
    free_strain(&growth->faster);
    free_strain(&growth->heavier);
}
