/* guarantee.c: see guarantee.h. */
#include "guarantee.h"

int guarantees_all(const guarantee *out[GUARANTEES_MAX]) {
    static const guarantee *const tables[] = {
        guarantees_of_asking,    guarantees_of_bits,   guarantees_of_bodies,
        guarantees_of_callbacks, guarantees_of_events, guarantees_of_features,
        guarantees_of_filters,   guarantees_of_joints, guarantees_of_passing,
        guarantees_of_refusal,   guarantees_of_rest,   guarantees_of_state,
    };
    int count = 0;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
        for (const guarantee *g = tables[i]; g->name && count < GUARANTEES_MAX; g++) {
            out[count++] = g;
        }
    }
    return count;
}

bool guarantee_covers(const guarantee *g, const settings *s) {
    for (int i = 0; i < EXCEPTIONS_MAX && g->except[i].reason; i++) {
        if (g->except[i].values & BIT(s->value[g->except[i].dimension])) {
            return false;
        }
    }
    return true;
}
