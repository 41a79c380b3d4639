/* wide_axis_sweep.c: overlaps within a proxy set that is one list (sorted_axis.h), eight bounds at
 * a time. Where the set has keys it is sorted by the least coordinate along set->axis, and a shape
 * is tested against those after it up to the first that begins beyond its end; without keys,
 * against all after it.
 *
 * Coordinates of keys are doubles in bounds quanta from set->reference. Ranges end at a multiple of
 * eight shapes, so that up to seven shapes more are tested than necessary. */
#include "broadphase/wide_scan.h"

/* The end of the range from index `from` that holds every shape that begins at or before `max`, to
 * a multiple of eight lanes; the end of the set where it is not sorted. */
TD_INLINE int end_of_overlaps(const td_proxy_set *set, int from, double max) {
    const td_sweep_key *keys = set->keys.data;
    int count = set->ids.count;
    while (from < count && (!keys || keys[from].min <= max)) {
        from += TD_LANES;
    }
    return from < count ? from : count;
}

/* The first index whose shape may reach the coordinate `min`: it does not begin further below that
 * than the widest shape is wide. By binary search; 0 where the set is not sorted. */
TD_INLINE int first_reaching(const td_proxy_set *set, double min) {
    const td_sweep_key *keys = set->keys.data;
    int low = 0, high = keys ? set->ids.count : 0;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (keys[middle].min < min - set->widest[set->axis]) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* The least (min_of) and the greatest (max_of) coordinate of the i-th shape's bounds along
 * set->axis, in bounds quanta from set->reference. In a set without keys, which is not sorted,
 * nobody uses the results: min_of is 0 there, and max_of the width of the bounds. */
TD_INLINE double min_of(const td_proxy_set *set, int i) {
    const td_sweep_key *keys = set->keys.data;
    return keys ? keys[i].min : 0.0;
}

TD_INLINE double max_of(const scan *s, int i) {
    int32_t extent = s->set->axis == TD_AXIS_X ? td_wrap_sub(s->max_x[i], s->min_x[i])
                                               : td_wrap_sub(s->max_y[i], s->min_y[i]);
    return min_of(s->set, i) + (double)extent;
}

/* Tests the i-th shape against the shapes before it that have not moved. Those that moved search
 * themselves, and find the pair. */
TD_INLINE void scan_unmoved_before(scan *s, int i) {
    int first = first_reaching(s->set, min_of(s->set, i));
    if (first < i) {
        scan_span(s, first, i, SCAN_UNMOVED);
    }
}

td_sweep_fn TD_WIDE(td_sorted_axis_sweep);
bool TD_WIDE(td_sorted_axis_sweep)(const td_proxy_set *set, td_memory *memory,
                                   const td_shape_proxy *proxy, td_array *hits, td_hits_fn *report,
                                   void *context, int64_t *tested) {
    (void)proxy;
    scan s = begin_scan(set, memory, hits);
    bool done = true, every = td_sweeps_every(set);
    for (int i = set->head; i < set->ids.count - set->tail && done; i++) {
        if (!every && !s.moved[i]) {
            continue;
        }
        td_bounds b = bounds_at(&s, i);
        set_query(&s, &b);
        int reach = end_of_overlaps(set, i + 1, max_of(&s, i));
        done = reserve_hits(&s, every ? reach - i : reach);
        if (done && i + 1 < reach) {
            scan_span(&s, i + 1, reach, s.moved[i] ? SCAN_ALL : SCAN_MOVED);
        }
        if (done && !every) {
            scan_unmoved_before(&s, i);
        }
        done = done && report_hits(&s, i, report, context);
    }
    *tested += s.tested;
    return done;
}

td_find_fn TD_WIDE(td_sorted_axis_find);
bool TD_WIDE(td_sorted_axis_find)(const td_proxy_set *set, td_memory *memory,
                                  const td_bounds *bounds, td_position near_place, td_array *hits,
                                  int64_t *tested) {
    scan s = begin_scan(set, memory, hits);
    set_query(&s, bounds);
    bool along_x = set->axis == TD_AXIS_X;
    int64_t begin =
        along_x ? td_unwrap(bounds->min_x, near_place.x) : td_unwrap(bounds->min_y, near_place.y);
    int32_t extent = along_x ? td_wrap_sub(bounds->max_x, bounds->min_x)
                             : td_wrap_sub(bounds->max_y, bounds->min_y);
    double min = (double)(begin - set->reference[set->axis]);
    int first = first_reaching(set, min);
    int end = end_of_overlaps(set, first, min + (double)extent);
    if (!reserve_hits(&s, end - first)) {
        return false;
    }
    if (first < end) {
        scan_span(&s, first, end, SCAN_ALL);
    }
    count_hits(&s);
    if (tested) {
        *tested += s.tested;
    }
    return true;
}
