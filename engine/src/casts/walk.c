/* walk.c: finds the hits of a path in order, a few at a time. State between calls is the last hit
 * that was returned (`last`): a call searches for hits after it. A path is searched in pieces
 * (path.h). Terrains are not in the broadphase; the first hit on any of them (`ground`) is found by
 * testing all of them, and the next one is searched in the same way each time the walk has returned
 * `ground`. See walk.h. */
#include "casts/walk.h"

#include "state/handles.h"
#include "state/preview.h"

/* An allocator that always fails: a walk must not allocate. */
static void *allocate_nothing(size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    return NULL;
}

/* Whether a hit comes after the last one that was returned. */
static bool after(const td_walk *walk, const thud_ray_hit *hit) {
    return td_hit_before(&walk->last, hit);
}

/* Sets `ground` to the first hit on a terrain after `last`. */
static void find_ground(td_walk *walk) {
    const thud_world *w = walk->world;
    walk->ground.fraction = 2.0;
    for (int i = 0; i < w->terrains.count; i++) {
        int shape = td_terrain_record_at(w, i)->shape;
        thud_ray_hit hit;
        if (shape != TD_NONE && td_path_meets(w, shape, walk->way, &hit)) {
            hit.shape = td_shape_handle(w, shape);
            if (after(walk, &hit) && td_hit_before(&hit, &walk->ground)) {
                walk->ground = hit;
            }
        }
    }
}

td_walk td_walk_begin(const thud_world *w, const td_path *way, int *room, int size) {
    td_walk walk = {.world = w,
                    .way = way,
                    .found = {.data = room, .capacity = size, .stride = (int)sizeof(int)},
                    .next = td_piece_first(w, way),
                    .last = {.fraction = -1.0}};
    find_ground(&walk);
    return walk;
}

/* ---- pieces ---- */

/* The position of a corner of a box, held to the outermost place that any part of a shape can
 * reach: differences of such positions fit in 64 bits. */
static td_position clamped_place(const thud_world *w, thud_pos at) {
    double max = (THUD_PLACE_MAX + 2.0 * (double)THUD_SIZE_MAX) * (double)w->length_scale;
    return td_place_from(w, (thud_pos){td_clamp(at.x, -max, max), td_clamp(at.y, -max, max)});
}

/* Lists the candidates of the piece from `from` to walk->to. False where there are more than the
 * room holds, or the box is so wide that its bounds, which wrap around, would be ambiguous. */
static bool list(td_walk *walk, double from) {
    const thud_world *w = walk->world;
    thud_pos lower, upper;
    td_piece_bounds(walk->way, from, walk->to, &lower, &upper);
    td_position low = clamped_place(w, lower), high = clamped_place(w, upper);
    int64_t max = (int64_t)((double)THUD_SIZE_MAX * TD_FIXED_ONE);
    if (high.x - low.x > max || high.y - low.y > max) {
        return false;
    }
    td_bounds bounds = {td_coarse(low.x), td_coarse(low.y), td_coarse(high.x) + 1,
                        td_coarse(high.y) + 1};
    td_memory none = {.hooks = {.allocate = allocate_nothing}};
    walk->found.count = 0;
    return td_preview_find(w, &none, &bounds, low, &walk->found);
}

/* Begins the piece after the last hit. Where its candidates cannot be listed the piece is the rest
 * of the path, and all shapes are candidates. */
static void begin_piece(td_walk *walk) {
    double from = td_max_double(walk->last.fraction, 0.0);
    walk->under_way = true;
    walk->to = td_piece_end(from, walk->next);
    walk->every = !list(walk, from);
    if (walk->every) {
        walk->to = 1.0;
    }
    walk->next = td_piece_next(walk->next, walk->found.count);
}

/* Keeps the hits of the candidates that lie in the piece, after `last`, below `limit` and before
 * `ground`. */
static void keep_hits(const td_walk *walk, double limit, td_nearest *k) {
    const thud_world *w = walk->world;
    int count = walk->every ? w->shapes.count : walk->found.count;
    for (int i = 0; i < count; i++) {
        int index = walk->every ? i : td_int_at(&walk->found, i);
        thud_ray_hit hit;
        if ((walk->every && td_kind_is_line(td_shape_at(w, index)->kind)) ||
            !td_path_meets(w, index, walk->way, &hit)) {
            continue;
        }
        hit.shape = td_shape_handle(w, index);
        if (after(walk, &hit) && hit.fraction <= walk->to && hit.fraction < limit &&
            td_hit_before(&hit, &walk->ground)) {
            td_nearest_keep(k, &hit);
        }
    }
}

void td_walk_next(td_walk *walk, double limit, td_nearest *k) {
    k->count = 0;
    while (k->count == 0 && (walk->under_way || walk->last.fraction < 1.0) &&
           walk->last.fraction < limit) {
        if (!walk->under_way) {
            begin_piece(walk);
        }
        keep_hits(walk, limit, k);
        if (k->count > k->capacity) { /* the next call returns the others */
            k->count = k->capacity;
            walk->last = k->hits[k->count - 1];
        } else if (walk->ground.fraction <= walk->to) {
            /* `ground` is in this piece. If the call has found hits before it, they are returned
             * first, and the next call returns `ground`. If it has found none, `ground` is returned
             * now. */
            walk->last = k->count ? k->hits[k->count - 1] : walk->ground;
            if (k->count == 0) {
                k->count = walk->ground.fraction < limit;
                k->hits[0] = walk->ground;
                find_ground(walk);
            }
        } else {
            /* The piece is done: `last` comes after every hit at its end. */
            walk->last = (thud_ray_hit){.shape = {UINT32_MAX, 0}, .fraction = walk->to};
            walk->under_way = false;
        }
    }
}
