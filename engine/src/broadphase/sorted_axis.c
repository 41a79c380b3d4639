/* sorted_axis.c: fills a proxy set whose order is given; see sorted_axis.h. */
#include "broadphase/sorted_axis.h"

#include "state/kinds.h"

/* Computes the range of centres, and copies bounds and moved flags. */
void td_sorted_axis_fill(thud_world *w, td_proxy_set *set) {
    const int32_t *ids = set->ids.data;
    set->origin_x = set->origin_y = INT64_MAX;
    set->end_x = set->end_y = INT64_MIN;
    for (int i = 0; i < set->ids.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, ids[i]);
        const td_bounds *b = &proxy->fat;
        int64_t x = td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x);
        int64_t y = td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y);
        set->origin_x = x < set->origin_x ? x : set->origin_x;
        set->origin_y = y < set->origin_y ? y : set->origin_y;
        set->end_x = x > set->end_x ? x : set->end_x;
        set->end_y = y > set->end_y ? y : set->end_y;
    }
    set->moved_count =
        set->ids.count ? TD_PICK_WIDE(w, td_proxy_set_fill)(set, w->proxy.data, w->marks.data) : 0;
    set->valid = true;
}
