/* wide_scan.h: tests eight bounds at a time against one, for the files that sweep a proxy set.
 *
 * Bounds a and b overlap where none of the differences a.max - b.min and b.max - a.min, along x and
 * y, is negative; so the sign bit of their bitwise or decides. Differences wrap around, as bounds
 * do. */
#ifndef TD_WIDE_SCAN_H
#define TD_WIDE_SCAN_H

#include "broadphase/proxy_set.h"

#include <stddef.h>

/* Loads four 32-bit words, at an offset, of each of eight proxies: out[k] has the k-th word. */
TD_INLINE void load_four_words(const td_shape_proxy *proxy, const int32_t *ids, size_t offset,
                               i8 out[4]) {
    const float *r[TD_LANES];
    for (int i = 0; i < TD_LANES; i++) {
        r[i] = (const float *)(const void *)((const char *)&proxy[ids[i]] + offset);
    }
    td_rows rows = td_transpose(f8_two(r[0], r[4]), f8_two(r[1], r[5]), f8_two(r[2], r[6]),
                                f8_two(r[3], r[7]));
    out[0] = (i8)rows.x, out[1] = (i8)rows.y, out[2] = (i8)rows.z, out[3] = (i8)rows.w;
}

/* Prefetches eight proxies. The order of ids has no pattern in memory that a hardware prefetcher
 * could follow. */
TD_INLINE void fetch_eight_proxies(const td_shape_proxy *proxy, const int32_t *ids) {
    for (int i = 0; i < TD_LANES; i++) {
        __builtin_prefetch(&proxy[ids[i]]);
    }
}

/* The distance, in shapes, at which loops over all proxies prefetch. Chosen. */
enum { FETCH_AHEAD = 6 * TD_LANES };

/* A search in a proxy set: the bounds of the query, and the hits so far. */
typedef struct scan {
    const td_proxy_set *set;
    /* The set's arrays. */
    const int32_t *ids, *min_x, *min_y, *max_x, *max_y, *moved, *starts;
    td_memory *memory;
    td_array *hits;
    int32_t *out, *limit; /* where the next hit is written, and the end of hits' memory */
    /* The bounds of the query, in all lanes. */
    i8 query_min_x, query_min_y, query_max_x, query_max_y;
    int64_t tested; /* number of bounds compared with those of the query */
} scan;

/* Which overlapping shapes are hits: all, those that moved, or those that did not. */
typedef enum scan_filter { SCAN_ALL, SCAN_MOVED, SCAN_UNMOVED } scan_filter;

/* Sets out and limit from the hits, whose memory may have moved. */
TD_INLINE void set_output(scan *s) {
    int32_t *data = s->hits->data; /* null before the first reservation */
    s->out = data ? data + s->hits->count : NULL;
    s->limit = data ? data + s->hits->capacity : NULL;
}

/* Sets the count of the hits to what was written, and returns it. */
TD_INLINE int count_hits(scan *s) {
    s->hits->count = (int)(s->out - (int32_t *)s->hits->data);
    return s->hits->count;
}

/* A scan of a set that appends to `hits`. */
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
    set_output(&s);
    return s;
}

/* Sets the bounds of the query. */
TD_INLINE void set_query(scan *s, const td_bounds *b) {
    s->query_min_x = i8_all(b->min_x);
    s->query_min_y = i8_all(b->min_y);
    s->query_max_x = i8_all(b->max_x);
    s->query_max_y = i8_all(b->max_y);
}

/* The bounds of the i-th shape of the set. */
TD_INLINE td_bounds bounds_at(const scan *s, int i) {
    return (td_bounds){s->min_x[i], s->min_y[i], s->max_x[i], s->max_y[i]};
}

/* A bit for each of the eight shapes from index `at` on that overlaps and passes the filter. */
TD_INLINE unsigned overlaps(const scan *s, int at, scan_filter which) {
    i8 apart = i8_wrap_sub(s->query_max_x, i8_load(s->min_x + at)) |
               i8_wrap_sub(i8_load(s->max_x + at), s->query_min_x) |
               i8_wrap_sub(s->query_max_y, i8_load(s->min_y + at)) |
               i8_wrap_sub(i8_load(s->max_y + at), s->query_min_y);
    i8 found = ~apart;
    if (which != SCAN_ALL) {
        i8 moved = i8_load(s->moved + at);
        found &= which == SCAN_MOVED ? moved : ~moved;
    }
    return i8_bits(found);
}

/* Makes room for `more` hits, and for eight ints behind them, since i8_pack may write eight at
 * once. False when memory is short. */
TD_INLINE bool reserve_hits(scan *s, int more) {
    if (s->limit - s->out >= more + TD_LANES) {
        return true;
    }
    if (!td_array_reserve(s->memory, s->hits, count_hits(s) + more + TD_LANES)) {
        return false;
    }
    set_output(s);
    return true;
}

/* Reports the hits of the i-th shape, if any, and clears them. False where `report` ends the sweep.
 */
TD_INLINE bool report_hits(scan *s, int i, td_hits_fn *report, void *context) {
    int found = count_hits(s);
    s->out = s->hits->data;
    return found == 0 || report(context, s->ids[i], s->hits->data, found);
}

/* Appends the hits among the shapes from .. to - 1, for which there is room. Most ranges hold at
 * most eight shapes, and many none. The first eight shapes from `from` on are tested even if the
 * range is empty: a branch that the processor cannot predict costs more than a test. */
TD_INLINE void scan_span(scan *s, int from, int to, scan_filter which) {
    int at = from;
    s->tested += to - from;
    do {
        unsigned bits = overlaps(s, at, which);
        int left = to - at;
        bits &= left < TD_LANES ? (1u << left) - 1u : 0xffu;
        s->out += i8_pack(s->out, s->ids + at, bits);
        at += TD_LANES;
    } while (at < to);
}

#endif
