/* wide_proxy_set.c: copies the fat bounds and the moved marks of the shapes in td_proxy_set.ids
 * into the set's arrays, eight at a time. */
#include "broadphase/wide_scan.h"

td_proxy_set_fill_fn TD_WIDE(td_proxy_set_fill);
int TD_WIDE(td_proxy_set_fill)(td_proxy_set *set, const td_shape_proxy *proxy,
                               const uint8_t *marks) {
    int32_t *ids = set->ids.data, *moved = set->moved.data;
    int32_t *rows[4] = {set->min_x.data, set->min_y.data, set->max_x.data, set->max_y.data};
    int count = set->ids.count, moved_count = 0;
    /* The loop below reads eight ids at a time, and may read beyond the last one. The ids there
     * must be valid, but the bounds that it writes for them are never used. */
    for (int i = count; i < count + TD_LANES; i++) {
        ids[i] = ids[count - 1];
    }
    for (int i = 0; i < count; i += TD_LANES) {
        if (TD_HAS_PREFETCH && i + FETCH_AHEAD < count) {
            fetch_eight_proxies(proxy, ids + i + FETCH_AHEAD);
        }
        i8 bounds[4];
        load_four_words(proxy, ids + i, offsetof(td_shape_proxy, fat), bounds);
        for (int k = 0; k < 4; k++) {
            __builtin_memcpy(rows[k] + i, &bounds[k], sizeof bounds[k]);
        }
    }
    for (int i = 0; i < count; i++) { /* bit 0 is TD_MARK_MOVED */
        int32_t flag = -(int32_t)(marks[ids[i]] & 1);
        moved[i] = flag;
        moved_count -= flag;
    }
    return moved_count;
}
