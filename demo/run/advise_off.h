/* advise_off.h: finds out which parts of a scene or of the engine a scene does not need, by running
 * it without each of them. */
#ifndef THUD_RUN_ADVISE_OFF_H
#define THUD_RUN_ADVISE_OFF_H

#include "advise_link.h"
#include "advise_settings.h"
#include "without.h"

/* A part of the scene or of the engine that was left out. */
typedef struct advise_off {
    const char *name; /* a name that the option --without takes; or "detection", which stands for
                         detection at the end of steps only */
    advise_setting setting; /* the run without it */
    double moved;  /* length scales: the greatest distance of a body's place at the end of the run
                      without the part from its place with it */
    bool same;     /* no bit of any body differs */
    bool needless; /* the error is within the limit without it, and no body ends further off than
                      this limit */
    bool saves;    /* time, a hundredth of the memory, or linked code */
    advise_link link;
} advise_off;

enum { ADVISE_OFFS_MAX = WITHOUT_PARTS + 1 };

typedef struct advise_offs {
    int base; /* index of the setting at which the parts were left out: the advised one; if none is,
                 the nearest to what was asked for */
    advise_link link; /* of that setting */
    advise_off offs[ADVISE_OFFS_MAX];
    int count;
} advise_offs;

/* Runs the scene without each part that it has. False after a message; *out has to be freed in
 * either case. */
bool advise_switch_off(const advise_series *series, const scene *s, advise_offs *out);
void advise_offs_free(advise_offs *offs);

#endif
