/* wide_grid.c: where the shapes of a grid belong, eight at a time. */
#include "broadphase/wide_scan.h"

TD_INLINE i8 i8_min(i8 a, i8 b) {
    return i8_pick(a < b, a, b);
}

TD_INLINE i8 i8_max(i8 a, i8 b) {
    return i8_pick(a > b, a, b);
}

TD_INLINE i8 half_up(i8 low, i8 high) {
    return (i8)((u8)low + ((u8)i8_wrap_sub(high, low) >> 1));
}

TD_INLINE void store_doubles(double *to, i8 x) {
    d4 low = __builtin_convertvector(__builtin_shufflevector(x, x, 0, 1, 2, 3), d4);
    d4 high = __builtin_convertvector(__builtin_shufflevector(x, x, 4, 5, 6, 7), d4);
    __builtin_memcpy(to, &low, sizeof low);
    __builtin_memcpy(to + 4, &high, sizeof high);
}

/* Sizes mostly agree, and are then noted at once. */
TD_INLINE void note_sizes(i8 extent, int *set) {
    f8 f = __builtin_convertvector(i8_max(extent, i8_all(1)), f8);
    i8 size = (i8)((u8)f >> TD_SIZE_SHIFT) - i8_all(TD_SIZE_ZERO);
    i8 other = size - i8_all(size[0]);
    if (i8_bits(other | -other) == 0) {
        set[size[0]] = 1;
        return;
    }
    for (int i = 0; i < TD_LANES; i++) {
        set[size[i]] = 1;
    }
}

td_grid_measure_fn TD_WIDE(td_grid_measure);
bool TD_WIDE(td_grid_measure)(const td_shape_proxy *proxy, td_grid_measures *m) {
    const int32_t *ids = m->list;
    i8 least_x = i8_all(INT32_MAX), least_y = least_x, most_x = i8_all(INT32_MIN), most_y = most_x;
    i8 far = i8_all(0);
    const td_position *middle = &proxy[ids[0]].center;
    i8 ref_x = i8_all(td_coarse(middle->x)), ref_y = i8_all(td_coarse(middle->y));
    i8 whole_x = i8_all((int32_t)(middle->x >> 32)), whole_y = i8_all((int32_t)(middle->y >> 32));
    for (int i = 0; i < m->count; i += TD_LANES) {
        int32_t last[TD_LANES];
        const int32_t *eight = ids + i;
        if (m->count - i < TD_LANES) { /* the last shape fills the eight up */
            for (int k = 0; k < TD_LANES; k++) {
                last[k] = ids[i + k < m->count ? i + k : m->count - 1];
            }
            eight = last;
        }
        i8 place[4], b[4];
        load_words(proxy, eight, offsetof(td_shape_proxy, center), place);
        load_words(proxy, eight, offsetof(td_shape_proxy, fat), b);
        /* Whole length scales away from the first: an eighth of the way around the bounds. */
        i8 off_x = i8_wrap_sub(place[1], whole_x), off_y = i8_wrap_sub(place[3], whole_y);
        far |= (off_x > i8_all(TD_NEAR)) | (off_x < i8_all(-TD_NEAR)) | (off_y > i8_all(TD_NEAR)) |
               (off_y < i8_all(-TD_NEAR));
        i8 x = i8_wrap_sub(half_up(b[0], b[2]), ref_x), y = i8_wrap_sub(half_up(b[1], b[3]), ref_y);
        i8 extent = i8_max(i8_wrap_sub(b[2], b[0]), i8_wrap_sub(b[3], b[1]));
        least_x = i8_min(least_x, x);
        least_y = i8_min(least_y, y);
        most_x = i8_max(most_x, x);
        most_y = i8_max(most_y, y);
        store_doubles(m->x + i, x);
        store_doubles(m->y + i, y);
        __builtin_memcpy(m->extent + i, &extent, sizeof extent);
        note_sizes(extent, m->set);
    }
    m->least_x = m->least_y = INT32_MAX;
    m->most_x = m->most_y = INT32_MIN;
    for (int i = 0; i < TD_LANES; i++) {
        m->least_x = least_x[i] < m->least_x ? least_x[i] : m->least_x;
        m->least_y = least_y[i] < m->least_y ? least_y[i] : m->least_y;
        m->most_x = most_x[i] > m->most_x ? most_x[i] : m->most_x;
        m->most_y = most_y[i] > m->most_y ? most_y[i] : m->most_y;
    }
    return i8_bits(far) == 0;
}

static void cells_one_by_one(const td_level *levels, td_grid_measures *m) {
    for (int i = 0; i < m->count; i++) {
        const td_level *level = &levels[m->level[i]];
        /* Not below the origin, so that truncation rounds down. */
        m->cell[i] =
            (int32_t)td_grid_cell(level, (int64_t)((m->x[i] - m->least_x) * level->inv_cell),
                                  (int64_t)((m->y[i] - m->least_y) * level->inv_cell));
    }
}

TD_INLINE u8 indices(const double *x, double least, double inv_cell) {
    d4 a, b;
    __builtin_memcpy(&a, x, sizeof a);
    __builtin_memcpy(&b, x + 4, sizeof b);
    i4 low = __builtin_convertvector((a - least) * inv_cell, i4);
    i4 high = __builtin_convertvector((b - least) * inv_cell, i4);
    return (u8)__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

td_grid_cells_fn TD_WIDE(td_grid_cells);
void TD_WIDE(td_grid_cells)(const td_level *levels, td_grid_measures *m) {
    const td_level *level = &levels[m->level[0]];
    double most = 0x1p30 * (double)level->cell;
    if (level->count < m->count || m->most_x - m->least_x > most || m->most_y - m->least_y > most) {
        cells_one_by_one(levels, m);
        return;
    }
    for (int i = 0; i < m->count; i += TD_LANES) {
        u8 column = indices(m->x + i, m->least_x, level->inv_cell);
        u8 row = indices(m->y + i, m->least_y, level->inv_cell);
        u8 cell = (column + 1u + (row + 1u) * level->row) & level->mask;
        __builtin_memcpy(m->cell + i, &cell, sizeof cell);
    }
}
