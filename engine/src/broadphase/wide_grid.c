/* wide_grid.c: measures the shapes of a grid (centres, extents, size classes) and finds the cell of
 * each, eight at a time; see grid.h. */
#include "broadphase/wide_scan.h"

TD_INLINE i8 i8_min(i8 a, i8 b) {
    return i8_pick(a < b, a, b);
}

TD_INLINE i8 i8_max(i8 a, i8 b) {
    return i8_pick(a > b, a, b);
}

/* td_middle of eight. */
TD_INLINE i8 middle(i8 low, i8 high) {
    return (i8)((u8)low + ((u8)i8_wrap_sub(high, low) >> 1));
}

/* Stores eight ints as doubles. */
TD_INLINE void store_doubles(double *to, i8 x) {
    d4 low = __builtin_convertvector(__builtin_shufflevector(x, x, 0, 1, 2, 3), d4);
    d4 high = __builtin_convertvector(__builtin_shufflevector(x, x, 4, 5, 6, 7), d4);
    __builtin_memcpy(to, &low, sizeof low);
    __builtin_memcpy(to + 4, &high, sizeof high);
}

/* Sets has_size of eight extents' classes; where all are of one class, which is common, at once. */
TD_INLINE void mark_size_classes(i8 extent, int *has_size) {
    f8 f = __builtin_convertvector(i8_max(extent, i8_all(1)), f8);
    i8 size = (i8)((u8)f >> TD_SIZE_SHIFT) - i8_all(TD_SIZE_OF_ONE);
    i8 other = size - i8_all(size[0]);
    if (i8_bits(other | -other) == 0) {
        has_size[size[0]] = 1;
        return;
    }
    for (int i = 0; i < TD_LANES; i++) {
        has_size[size[i]] = 1;
    }
}

td_grid_measure_fn TD_WIDE(td_grid_measure);
bool TD_WIDE(td_grid_measure)(const td_shape_proxy *proxy, td_grid_measures *m) {
    const int32_t *ids = m->list;
    i8 min_x = i8_all(INT32_MAX), min_y = min_x, max_x = i8_all(INT32_MIN), max_y = max_x;
    i8 far = i8_all(0);
    const td_position *first_center = &proxy[ids[0]].center;
    i8 ref_x = i8_all(td_coarse(first_center->x)), ref_y = i8_all(td_coarse(first_center->y));
    i8 whole_x = i8_all((int32_t)(first_center->x >> 32)),
       whole_y = i8_all((int32_t)(first_center->y >> 32));
    for (int i = 0; i < m->count; i += TD_LANES) {
        int32_t last[TD_LANES];
        const int32_t *eight = ids + i;
        if (m->count - i < TD_LANES) { /* the last shape fills the eight up */
            for (int k = 0; k < TD_LANES; k++) {
                last[k] = ids[i + k < m->count ? i + k : m->count - 1];
            }
            eight = last;
        }
        if (TD_HAS_PREFETCH && i + FETCH_AHEAD + TD_LANES <= m->count) {
            fetch_eight_proxies(proxy, ids + i + FETCH_AHEAD);
        }
        i8 place[4], b[4];
        load_four_words(proxy, eight, offsetof(td_shape_proxy, center), place);
        load_four_words(proxy, eight, offsetof(td_shape_proxy, fat), b);
        /* Distance from the first centre in whole length scales: the high words of positions. */
        i8 off_x = i8_wrap_sub(place[1], whole_x), off_y = i8_wrap_sub(place[3], whole_y);
        far |= (off_x > i8_all(TD_GRID_NEAR)) | (off_x < i8_all(-TD_GRID_NEAR)) |
               (off_y > i8_all(TD_GRID_NEAR)) | (off_y < i8_all(-TD_GRID_NEAR));
        i8 x = i8_wrap_sub(middle(b[0], b[2]), ref_x), y = i8_wrap_sub(middle(b[1], b[3]), ref_y);
        i8 extent = i8_max(i8_wrap_sub(b[2], b[0]), i8_wrap_sub(b[3], b[1]));
        min_x = i8_min(min_x, x);
        min_y = i8_min(min_y, y);
        max_x = i8_max(max_x, x);
        max_y = i8_max(max_y, y);
        store_doubles(m->x + i, x);
        store_doubles(m->y + i, y);
        __builtin_memcpy(m->extent + i, &extent, sizeof extent);
        mark_size_classes(extent, m->has_size);
    }
    m->min_x = m->min_y = INT32_MAX;
    m->max_x = m->max_y = INT32_MIN;
    for (int i = 0; i < TD_LANES; i++) {
        m->min_x = min_x[i] < m->min_x ? min_x[i] : m->min_x;
        m->min_y = min_y[i] < m->min_y ? min_y[i] : m->min_y;
        m->max_x = max_x[i] > m->max_x ? max_x[i] : m->max_x;
        m->max_y = max_y[i] > m->max_y ? max_y[i] : m->max_y;
    }
    return i8_bits(far) == 0;
}

/* td_grid_cells for several levels, and for indices beyond 32 bits. */
static void cells_one_by_one(const td_level *levels, td_grid_measures *m) {
    for (int i = 0; i < m->count; i++) {
        const td_level *level = &levels[m->level[i]];
        /* x and y are not below the origin, so that truncation rounds down. */
        m->cell[i] = (int32_t)td_grid_cell(level, (int64_t)((m->x[i] - m->min_x) * level->inv_cell),
                                           (int64_t)((m->y[i] - m->min_y) * level->inv_cell));
    }
}

/* Columns or rows of eight coordinates. */
TD_INLINE u8 indices(const double *x, double min, double inv_cell) {
    d4 a, b;
    __builtin_memcpy(&a, x, sizeof a);
    __builtin_memcpy(&b, x + 4, sizeof b);
    i4 low = __builtin_convertvector((a - min) * inv_cell, i4);
    i4 high = __builtin_convertvector((b - min) * inv_cell, i4);
    return (u8)__builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
}

td_grid_cells_fn TD_WIDE(td_grid_cells);
void TD_WIDE(td_grid_cells)(const td_level *levels, td_grid_measures *m) {
    const td_level *level = &levels[m->level[0]];
    double max = 0x1p30 * (double)level->cell;
    if (level->count < m->count || m->max_x - m->min_x > max || m->max_y - m->min_y > max) {
        cells_one_by_one(levels, m);
        return;
    }
    for (int i = 0; i < m->count; i += TD_LANES) {
        u8 column = indices(m->x + i, m->min_x, level->inv_cell);
        u8 row = indices(m->y + i, m->min_y, level->inv_cell);
        u8 cell = (column + 1u + (row + 1u) * level->row) & level->mask;
        __builtin_memcpy(m->cell + i, &cell, sizeof cell);
    }
}
