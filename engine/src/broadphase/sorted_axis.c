/* sorted_axis.c: see sorted_axis.h. */
#include "broadphase/sorted_axis.h"

#include "state/kinds.h"

void td_sorted_axis_fill(thud_world *w, td_proxy_set *row) {
    const int32_t *ids = row->ids.data;
    row->origin_x = row->origin_y = INT64_MAX;
    row->end_x = row->end_y = INT64_MIN;
    for (int i = 0; i < row->ids.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(w, ids[i]);
        const td_bounds *b = &proxy->fat;
        int64_t x = td_unwrap(td_middle(b->min_x, b->max_x), proxy->center.x);
        int64_t y = td_unwrap(td_middle(b->min_y, b->max_y), proxy->center.y);
        row->origin_x = x < row->origin_x ? x : row->origin_x;
        row->origin_y = y < row->origin_y ? y : row->origin_y;
        row->end_x = x > row->end_x ? x : row->end_x;
        row->end_y = y > row->end_y ? y : row->end_y;
    }
    row->moved_count =
        row->ids.count ? TD_PICK_WIDE(w, td_proxy_set_fill)(row, w->proxy.data, w->marks.data) : 0;
    row->valid = true;
}
