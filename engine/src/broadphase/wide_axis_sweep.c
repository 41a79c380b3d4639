/* wide_axis_sweep.c: overlaps within a proxy set that is one list (sorted_axis.h), eight bounds at
 * a time. Where the set has keys it is sorted by min_x, and a shape is tested against those after
 * it up to the first that begins beyond its max_x; without keys, against all after it.
 *
 * Coordinates of keys are doubles in bounds quanta from set->reference. */
#include "broadphase/wide_scan.h"

/* The end of the range from index `from` that holds every shape whose min_x is at most max_x, to a
 * multiple of eight lanes; the end of the set where it is not sorted. */
TD_INLINE int end_of_overlaps(const td_proxy_set *set, int from, double max_x) {
    const td_sweep_key *keys = set->keys.data;
    int count = set->ids.count;
    while (from < count && (!keys || keys[from].min_x <= max_x)) {
        from += TD_LANES;
    }
    return from < count ? from : count;
}

/* The first index whose shape may reach the coordinate `min_x`: its min_x is not below that by more
 * than the widest shape. By binary search; 0 where the set is not sorted. */
TD_INLINE int first_reaching(const td_proxy_set *set, double min_x) {
    const td_sweep_key *keys = set->keys.data;
    int low = 0, high = keys ? set->ids.count : 0;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (keys[middle].min_x < min_x - set->widest) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/* Coordinates of min_x and max_x of the i-th shape; min_x counts as 0 where the set is not sorted.
 */
TD_INLINE double min_x_of(const td_proxy_set *set, int i) {
    const td_sweep_key *keys = set->keys.data;
    return keys ? keys[i].min_x : 0.0;
}

TD_INLINE double max_x_of(const scan *s, int i) {
    return min_x_of(s->set, i) + (double)td_wrap_sub(s->max_x[i], s->min_x[i]);
}

/* Tests the shapes before the i-th that have not moved; those that moved find the pair
 * themselves. */
TD_INLINE void scan_unmoved_before(scan *s, int i) {
    int first = first_reaching(s->set, min_x_of(s->set, i));
    if (first < i) {
        scan_span(s, first, i, SCAN_UNMOVED);
    }
}

td_sweep_fn TD_WIDE(td_sorted_axis_sweep);
bool TD_WIDE(td_sorted_axis_sweep)(const td_proxy_set *set, td_memory *memory,
                                   const td_shape_proxy *proxy, bool every, td_array *hits,
                                   td_hits_fn *report, void *context) {
    (void)proxy;
    scan s = begin_scan(set, memory, hits);
    for (int i = 0; i < set->ids.count; i++) {
        if (!every && !s.moved[i]) {
            continue;
        }
        td_bounds b = bounds_at(&s, i);
        set_query(&s, &b);
        int end = end_of_overlaps(set, i + 1, max_x_of(&s, i));
        if (!reserve_hits(&s, every ? end - i : end)) {
            return false;
        }
        if (i + 1 < end) {
            scan_span(&s, i + 1, end, s.moved[i] ? SCAN_ALL : SCAN_MOVED);
        }
        if (!every) {
            scan_unmoved_before(&s, i);
        }
        if (!report_hits(&s, i, report, context)) {
            return false;
        }
    }
    return true;
}

td_find_fn TD_WIDE(td_sorted_axis_find);
bool TD_WIDE(td_sorted_axis_find)(const td_proxy_set *set, td_memory *memory,
                                  const td_bounds *bounds, td_position near_place, td_array *hits) {
    scan s = begin_scan(set, memory, hits);
    set_query(&s, bounds);
    double min_x = (double)(td_unwrap(bounds->min_x, near_place.x) - set->reference);
    int first = first_reaching(set, min_x);
    int end =
        end_of_overlaps(set, first, min_x + (double)td_wrap_sub(bounds->max_x, bounds->min_x));
    if (!reserve_hits(&s, end - first)) {
        return false;
    }
    if (first < end) {
        scan_span(&s, first, end, SCAN_ALL);
    }
    count_hits(&s);
    return true;
}
