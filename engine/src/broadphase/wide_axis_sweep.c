/* wide_axis_sweep.c: finding the overlapping bounds of a proxy set in one row, eight at a time:
 * among all that follow, or, where the row is sorted, among those that begin before a shape ends.
 */
#include "broadphase/wide_scan.h"

/* Where the row is sorted: none from here on begins at or before `most`. */
TD_INLINE int end_of(const td_proxy_set *row, int from, double most) {
    const td_sweep_key *keys = row->keys.data;
    int count = row->ids.count;
    while (from < count && (!keys || keys[from].least <= most)) {
        from += TD_LANES;
    }
    return from < count ? from : count;
}

/* The first that may reach `least`: half of what is left is thrown away each time. */
TD_INLINE int begin_of(const td_proxy_set *row, double least) {
    const td_sweep_key *keys = row->keys.data;
    int low = 0, high = keys ? row->ids.count : 0;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (keys[middle].least < least - row->widest) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* Coordinates at which the i-th shape begins and ends, where the row is sorted. */
TD_INLINE double least_of(const td_proxy_set *row, int i) {
    const td_sweep_key *keys = row->keys.data;
    return keys ? keys[i].least : 0.0;
}

TD_INLINE double most_of(const scan *s, int i) {
    return least_of(s->set, i) + (double)td_wrap_sub(s->max_x[i], s->min_x[i]);
}

/* Those before the i-th that have not moved; the others find it themselves. */
TD_INLINE void scan_before(scan *s, int i) {
    int first = begin_of(s->set, least_of(s->set, i));
    if (first < i) {
        scan_span(s, first, i, HEED_UNMOVED);
    }
}

td_sweep_fn TD_WIDE(td_sorted_axis_sweep);
bool TD_WIDE(td_sorted_axis_sweep)(const td_proxy_set *row, td_memory *memory,
                                   const td_shape_proxy *proxy, bool every, td_array *hits,
                                   td_hits_fn *tell, void *context) {
    (void)proxy;
    scan s = begin_scan(row, memory, hits);
    for (int i = 0; i < row->ids.count; i++) {
        if (!every && !s.moved[i]) {
            continue;
        }
        td_bounds b = bounds_at(&s, i);
        set_box(&s, &b);
        int end = end_of(row, i + 1, most_of(&s, i));
        if (!room(&s, every ? end - i : end)) {
            return false;
        }
        if (i + 1 < end) {
            scan_span(&s, i + 1, end, s.moved[i] ? HEED_ALL : HEED_MOVED);
        }
        if (!every) {
            scan_before(&s, i);
        }
        if (!tell_hits(&s, i, tell, context)) {
            return false;
        }
    }
    return true;
}

td_find_fn TD_WIDE(td_sorted_axis_find);
bool TD_WIDE(td_sorted_axis_find)(const td_proxy_set *row, td_memory *memory,
                                  const td_bounds *bounds, td_position near_place, td_array *hits) {
    scan s = begin_scan(row, memory, hits);
    set_box(&s, bounds);
    double least = (double)(td_unwrap(bounds->min_x, near_place.x) - row->reference);
    int first = begin_of(row, least);
    int end = end_of(row, first, least + (double)td_wrap_sub(bounds->max_x, bounds->min_x));
    if (!room(&s, end - first)) {
        return false;
    }
    if (first < end) {
        scan_span(&s, first, end, HEED_ALL);
    }
    count_hits(&s);
    return true;
}
