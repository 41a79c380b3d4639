/* verdict.c: see verdict.h. Overlap and gaps are judged wherever speed is, so that speed cannot be
 * bought with accuracy. */
#include "verdict.h"

#include <stdio.h>
#include <string.h>

static const double SAME = 1e-5; /* m: differences of overlap or gaps below this count as equal.
                                    Chosen. */

const race_entry *verdict_rival(const race_result *result) {
    for (int e = 1; e < result->entry_count; e++)
        if (strcmp(result->entries[e].engine, "box2d") == 0)
            return &result->entries[e];
    return NULL;
}

verdict verdict_of(const race_result *result) {
    const race_entry *own = &result->entries[0], *rival = verdict_rival(result);
    verdict v = {.limit = result->limit_ms > 0 && own->time.max > result->limit_ms};
    if (result->target > 0 && rival) {
        v.median = rival->time.median < result->target * own->time.median;
        v.p99 = rival->time.p99 < result->target * own->time.p99;
        v.worst = rival->time.max < result->target * own->time.max;
        v.overlap = own->overlap.worst > rival->overlap.worst + SAME ||
                    penetration_mean(&own->overlap) > penetration_mean(&rival->overlap) + SAME ||
                    own->overlap.lost > 0;
        v.gap = own->gaps.worst.length > rival->gaps.worst.length + SAME ||
                joint_gaps_mean(&own->gaps) > joint_gaps_mean(&rival->gaps) + SAME;
    }
    return v;
}

bool verdict_holds(verdict v) {
    return !(v.median || v.p99 || v.worst || v.overlap || v.gap || v.limit);
}

void verdict_text(const race_result *result, char *out, size_t size) {
    verdict v = verdict_of(result);
    out[0] = '\0';
    if (result->limit_ms <= 0 && !(result->target > 0 && verdict_rival(result)))
        return;
    if (verdict_holds(v)) {
        snprintf(out, size, "holds");
        return;
    }
    const struct {
        bool missed;
        const char *name;
    } parts[] = {{v.median, "median"},   {v.p99, "p99"}, {v.worst, "worst"},
                 {v.overlap, "overlap"}, {v.gap, "gap"}, {v.limit, "limit"}};
    size_t used = (size_t)snprintf(out, size, "misses:");
    const char *between = " ";
    for (size_t i = 0; i < sizeof parts / sizeof parts[0] && used < size; i++) {
        if (!parts[i].missed)
            continue;
        used += (size_t)snprintf(out + used, size - used, "%s%s", between, parts[i].name);
        between = ", ";
    }
}
