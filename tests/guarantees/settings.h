/* settings.h: the settings on which a guarantee is tested: one value for each dimension.
 * THUD_GUARANTEES=full runs through the product of all dimensions. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include <thud/thud.h>

enum { QUALITY, DETECTION, BROADPHASE, SLEEPING, SCALE, STEP, WORKERS, DIMENSIONS };
enum { VALUES_MAX = 6 };
enum { DRAFT, DEFAULT, HIGH, EXACT };
enum { OVERLAP, CONTINUOUS, BISECT, SWEPT };

/* Each value is an index into `values` of its dimension. */
typedef struct settings {
    int value[DIMENSIONS];
} settings;

typedef struct dimension {
    const char *name;
    int count;
    const char *values[VALUES_MAX];
} dimension;

extern const dimension dimensions[DIMENSIONS];

/* The number of combinations, and the i-th of them. */
int settings_count(void);
settings settings_at(int i);

/* Writes and reads "quality=draft,detection=swept,...". settings_read accepts the dimensions in any
 * order, and returns false unless each is there once. */
enum { SETTINGS_TEXT = 160 };
void settings_write(const settings *s, char text[SETTINGS_TEXT]);
bool settings_read(const char *text, settings *out);

/* The engine's options and numbers for the values. */
const thud_quality *settings_quality(const settings *s);
const thud_detection *settings_detection(const settings *s);
const thud_broadphase *settings_broadphase(const settings *s);
bool settings_sleeping(const settings *s);
double settings_scale(const settings *s);
double settings_step(const settings *s);
int settings_workers(const settings *s);

#endif
