/* cases.c: all cases, in the order of the page. */
#include "case.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const tradeoff_case *const CASES[] = {
    &case_column_30, &case_column_100, &case_pyramid, &case_heavy_on_light,
    &case_rubble,    &case_pit,        &case_slope,   &case_rolling,
    &case_gas,       &case_cradle,     &case_bullets, &case_chain,
    &case_bridge,    &case_ragdolls,   &case_cars,
};

int cases_count(void) {
    return sizeof CASES / sizeof CASES[0];
}

const tradeoff_case *cases_at(int index) {
    return index >= 0 && index < cases_count() ? CASES[index] : NULL;
}

const tradeoff_case *cases_find(const char *name) {
    for (int i = 0; i < cases_count(); i++)
        if (strcmp(CASES[i]->name, name) == 0)
            return CASES[i];
    return NULL;
}

double case_deepest_overlap(const sighting *now) {
    return now->score.penetration_max;
}

bool case_fill(const tradeoff_case *c, bool quick, scene *s) {
    int size = quick ? c->quick_size : c->size;
    bool ok;
    if (c->built_in) {
        ok = scenes_fill(c->built_in, size, s);
    } else {
        scene_init(s);
        s->name = c->name;
        ok = c->fill(s, size);
    }
    if (ok)
        return true;
    fprintf(stderr, "thud-tradeoff: %s: the scene could not be made\n", c->name);
    scene_free(s);
    return false;
}
