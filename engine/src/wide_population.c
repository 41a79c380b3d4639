/* wide_population.c: the bounds of a population, read from its shapes eight at a time. */
#include "wide_scan.h"

td_population_fill_fn TD_WIDE(td_population_fill);
int TD_WIDE(td_population_fill)(td_population *population, const td_stance *stance, const uint8_t *marks)
{
    int32_t *ids = population->ids.data, *moved = population->moved.data;
    int32_t *rows[4] = {population->min_x.data, population->min_y.data, population->max_x.data, population->max_y.data};
    int count = population->ids.count, moved_count = 0;
    /* The last eight may reach beyond the end, where any shape will do. */
    for (int i = count; i < count + TD_LANES; i++) {
        ids[i] = ids[count - 1];
    }
    for (int i = 0; i < count; i += TD_LANES) {
        i8 bounds[4];
        load_words(stance, ids + i, offsetof(td_stance, fat), bounds);
        for (int k = 0; k < 4; k++) {
            __builtin_memcpy(rows[k] + i, &bounds[k], sizeof bounds[k]);
        }
    }
    for (int i = 0; i < count; i++) {
        int32_t flag = -(int32_t)(marks[ids[i]] & 1);
        moved[i] = flag;
        moved_count -= flag;
    }
    return moved_count;
}
