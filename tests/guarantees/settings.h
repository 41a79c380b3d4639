/* settings.h: what a guarantee is tried on: one value of each dimension. The product of them all is
 * what `THUD_GUARANTEES=full` runs through. */
#ifndef SETTINGS_H
#define SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include <thud/thud.h>

enum { QUALITY, DETECTION, BROADPHASE, SLEEPING, SCALE, STEP, WORKERS, DIMENSIONS };
enum { VALUES_MAX = 4 };
enum { DRAFT, DEFAULT, HIGH, EXACT };
enum { OVERLAP, CONTINUOUS, BISECT, SWEPT };

/* A value is its number among those of its dimension. */
typedef struct settings {
    int value[DIMENSIONS];
} settings;

typedef struct dimension {
    const char *name;
    int count;
    const char *values[VALUES_MAX];
} dimension;

extern const dimension dimensions[DIMENSIONS];

/* How many settings there are in all, and the i-th of them. */
int settings_count(void);
settings settings_at(int i);

/* As "quality=draft,detection=swept,..."; settings_read wants each dimension once, in any order. */
enum { SETTINGS_TEXT = 160 };
void settings_write(const settings *s, char text[SETTINGS_TEXT]);
bool settings_read(const char *text, settings *out);

/* What the values mean. */
const thud_quality *settings_quality(const settings *s);
const thud_detection *settings_detection(const settings *s);
const thud_broadphase *settings_broadphase(const settings *s);
bool settings_sleeping(const settings *s);
double settings_scale(const settings *s);
double settings_step(const settings *s);
int settings_workers(const settings *s);

#endif
