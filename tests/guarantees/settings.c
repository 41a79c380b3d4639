/* settings.c: see settings.h. */
#include "settings.h"

#include <stdio.h>
#include <string.h>

const dimension dimensions[DIMENSIONS] = {
    [QUALITY] = {"quality", 4, {"draft", "default", "high", "exact"}},
    [DETECTION] = {"detection", 4, {"overlap", "continuous", "bisect", "swept"}},
    [BROADPHASE] = {"broadphase",
                    6,
                    {"grid", "sweep", "sweep_y", "sweep_widest", "sweep_both", "all"}},
    [SLEEPING] = {"sleeping", 2, {"off", "on"}},
    [SCALE] = {"scale", 3, {"1e-3", "1", "1e3"}},
    [STEP] = {"step", 3, {"1/30", "1/60", "1/240"}},
    [WORKERS] = {"workers", 2, {"1", "2"}},
};

int settings_count(void) {
    int count = 1;
    for (int d = 0; d < DIMENSIONS; d++) {
        count *= dimensions[d].count;
    }
    return count;
}

settings settings_at(int i) {
    settings s;
    for (int d = 0; d < DIMENSIONS; d++) {
        s.value[d] = i % dimensions[d].count;
        i /= dimensions[d].count;
    }
    return s;
}

void settings_write(const settings *s, char text[SETTINGS_TEXT]) {
    text[0] = 0;
    for (int d = 0; d < DIMENSIONS; d++) {
        size_t used = strlen(text);
        snprintf(text + used, SETTINGS_TEXT - used, "%s%s=%s", d ? "," : "", dimensions[d].name,
                 dimensions[d].values[s->value[d]]);
    }
}

/* Whether `text` is "name=value" of this dimension and value. */
static bool is_value(const char *text, size_t length, const dimension *d, int value) {
    size_t name = strlen(d->name), rest = strlen(d->values[value]);
    return length == name + 1 + rest && memcmp(text, d->name, name) == 0 && text[name] == '=' &&
           memcmp(text + name + 1, d->values[value], rest) == 0;
}

bool settings_read(const char *text, settings *out) {
    unsigned seen = 0;
    while (*text) {
        size_t length = strcspn(text, ",");
        unsigned before = seen;
        for (int d = 0; d < DIMENSIONS; d++) {
            for (int v = 0; v < dimensions[d].count && !(before >> d & 1); v++) {
                if (is_value(text, length, &dimensions[d], v)) {
                    out->value[d] = v;
                    seen |= 1u << d;
                }
            }
        }
        if (seen == before) {
            return false;
        }
        text += length + (text[length] == ',');
    }
    return seen == (1u << DIMENSIONS) - 1;
}

const thud_quality *settings_quality(const settings *s) {
    static const thud_quality *const qualities[] = {&thud_quality_draft, &thud_quality_default,
                                                    &thud_quality_high, &thud_quality_exact};
    return qualities[s->value[QUALITY]];
}

const thud_detection *settings_detection(const settings *s) {
    static const thud_detection *const detections[] = {&thud_detection_overlap,
                                                       &thud_detection_continuous,
                                                       &thud_detection_bisect,
                                                       &thud_detection_swept};
    return detections[s->value[DETECTION]];
}

const thud_broadphase *settings_broadphase(const settings *s) {
    static const thud_broadphase *const broadphases[] = {
        &thud_broadphase_grid,         &thud_broadphase_sweep,      &thud_broadphase_sweep_y,
        &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both, &thud_broadphase_all};
    return broadphases[s->value[BROADPHASE]];
}

bool settings_sleeping(const settings *s) {
    return s->value[SLEEPING] == 1;
}

double settings_scale(const settings *s) {
    static const double scales[] = {1e-3, 1.0, 1e3};
    return scales[s->value[SCALE]];
}

double settings_step(const settings *s) {
    static const double steps[] = {1.0 / 30.0, 1.0 / 60.0, 1.0 / 240.0};
    return steps[s->value[STEP]];
}

int settings_workers(const settings *s) {
    return s->value[WORKERS] + 1;
}
