/* wide_scan.h: eight bounds at a time against one, for the files that sweep a proxy set.
 *
 * Bounds overlap where none of four differences is negative, so one sign bit a lane decides. */
#ifndef TD_WIDE_SCAN_H
#define TD_WIDE_SCAN_H

#include "broadphase/proxy_set.h"

#include <stddef.h>

/* Four words of each of eight proxies. */
TD_INLINE void load_words(const td_shape_proxy *proxy, const int32_t *ids, size_t offset,
                          i8 out[4]) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)(const void *)((const char *)&proxy[ids[i]] + offset);
    }
    td_rows rows =
        td_turn(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]), f8_two(r[3], r[7]));
    out[0] = (i8)rows.x, out[1] = (i8)rows.y, out[2] = (i8)rows.z, out[3] = (i8)rows.w;
}

typedef struct scan {
    const td_proxy_set *set;
    const int32_t *ids, *min_x, *min_y, *max_x, *max_y, *moved, *starts;
    td_memory *memory;
    td_array *hits;
    int32_t *out, *limit; /* where the next hit goes, and the end of the room */
    i8 box_min_x, box_min_y, box_max_x, box_max_y;
} scan;

/* Which of the overlapping shapes count. */
typedef enum heed { HEED_ALL, HEED_MOVED, HEED_UNMOVED } heed;

TD_INLINE void set_room(scan *s) {
    int32_t *data = s->hits->data; /* null as long as there is no room */
    s->out = data ? data + s->hits->count : NULL;
    s->limit = data ? data + s->hits->capacity : NULL;
}

/* What was found so far, as the hits' count. */
TD_INLINE int count_hits(scan *s) {
    s->hits->count = (int)(s->out - (int32_t *)s->hits->data);
    return s->hits->count;
}

TD_INLINE scan begin_scan(const td_proxy_set *set, td_memory *memory, td_array *hits) {
    scan s = {.set = set,
              .ids = set->ids.data,
              .min_x = set->min_x.data,
              .min_y = set->min_y.data,
              .max_x = set->max_x.data,
              .max_y = set->max_y.data,
              .moved = set->moved.data,
              .starts = set->starts.data,
              .memory = memory,
              .hits = hits};
    set_room(&s);
    return s;
}

TD_INLINE void set_box(scan *s, const td_bounds *b) {
    s->box_min_x = i8_all(b->min_x);
    s->box_min_y = i8_all(b->min_y);
    s->box_max_x = i8_all(b->max_x);
    s->box_max_y = i8_all(b->max_y);
}

TD_INLINE td_bounds bounds_at(const scan *s, int i) {
    return (td_bounds){s->min_x[i], s->min_y[i], s->max_x[i], s->max_y[i]};
}

/* Overlapping lanes among the eight from `at` on. */
TD_INLINE unsigned test(const scan *s, int at, heed which) {
    i8 apart = i8_wrap_sub(s->box_max_x, i8_load(s->min_x + at)) |
               i8_wrap_sub(i8_load(s->max_x + at), s->box_min_x) |
               i8_wrap_sub(s->box_max_y, i8_load(s->min_y + at)) |
               i8_wrap_sub(i8_load(s->max_y + at), s->box_min_y);
    i8 found = ~apart;
    if (which != HEED_ALL) {
        i8 moved = i8_load(s->moved + at);
        found &= which == HEED_MOVED ? moved : ~moved;
    }
    return i8_bits(found);
}

/* Room for `more` hits and what packing writes beyond. */
TD_INLINE bool room(scan *s, int more) {
    if (s->limit - s->out >= more + TD_LANES) {
        return true;
    }
    if (!td_array_reserve(s->memory, s->hits, count_hits(s) + more + TD_LANES)) {
        return false;
    }
    set_room(s);
    return true;
}

/* Tells what was found of the i-th shape, and begins anew. */
TD_INLINE bool tell_hits(scan *s, int i, td_hits_fn *tell, void *context) {
    int found = count_hits(s);
    s->out = s->hits->data;
    return found == 0 || tell(context, s->ids[i], s->hits->data, found);
}

/* Most ranges hold no more than eight, many of them none: the first eight are always tested, since
 * a branch that nobody can foretell costs more. */
TD_INLINE void scan_span(scan *s, int from, int to, heed which) {
    int at = from;
    do {
        unsigned bits = test(s, at, which);
        int left = to - at;
        bits &= left < TD_LANES ? (1u << left) - 1u : 0xffu;
        s->out += i8_pack(s->out, s->ids + at, bits);
        at += TD_LANES;
    } while (at < to);
}

#endif
