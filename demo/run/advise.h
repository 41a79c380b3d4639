/* advise.h: measures what a scene requires, and prints the cheapest setting that meets an error. */
#ifndef THUD_RUN_ADVISE_H
#define THUD_RUN_ADVISE_H

#include "advise_growth.h"
#include "advise_off.h"
#include "advise_settings.h"
#include "uses.h"

/* What was measured of a scene. */
typedef struct advice {
    const run_options *options;
    const scene *scene;
    advise_series series;
    uses uses;        /* at the setting that the command line names */
    run_outcome used; /* of that run */
    advise_offs offs;
    advise_growth growth; /* at the advised setting, or the nearest */
} advice;

/* Measures and prints, and draws a picture if the options name one. False after a message. */
bool advise(const run_options *options, const scene *s);

/* A setting in a few words: "draft, swept, 8 substeps". At most ADVISE_NAME_MAX characters. */
enum { ADVISE_NAME_MAX = 96 };
void advise_name(const run_options *how, char *out);

void advise_print_text(const advice *a);
/* Prints one JSON object. False if memory runs out. */
bool advise_print_json(const advice *a);
/* Writes the error of each setting over its time as SVG. False after a message. */
bool advise_draw(const advice *a, const char *path);

#endif
