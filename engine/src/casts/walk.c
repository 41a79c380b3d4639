/* walk.c: see walk.h. */
#include "casts/walk.h"

#include "state/handles.h"
#include "state/preview.h"

static void *give_nothing(size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    return NULL;
}

static bool after(const td_walk *walk, const thud_ray_hit *hit) {
    return td_hit_before(&walk->last, hit);
}

/* Lines are looked at only when the walk has come past the last one that was met. */
static void look_for_ground(td_walk *walk) {
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
    look_for_ground(&walk);
    return walk;
}

/* ---- pieces ---- */

/* No place of the world lies further out; nearer, differences of places fit in 64 bits. */
static td_position corner(const thud_world *w, thud_pos at) {
    double most = (THUD_PLACE_MAX + 2.0 * (double)THUD_SIZE_MAX) * (double)w->unit;
    return td_place_from(w, (thud_pos){td_clamp(at.x, -most, most), td_clamp(at.y, -most, most)});
}

/* Lists what may be met in a piece; false where that takes more room than there is, or bounds,
 * which wrap around, cannot tell. */
static bool list(td_walk *walk, double from) {
    const thud_world *w = walk->world;
    thud_pos lower, upper;
    td_piece_bounds(walk->way, from, walk->to, &lower, &upper);
    td_position low = corner(w, lower), high = corner(w, upper);
    int64_t most = (int64_t)((double)THUD_SIZE_MAX * TD_FIXED_ONE);
    if (high.x - low.x > most || high.y - low.y > most) {
        return false;
    }
    td_bounds bounds = {td_coarse(low.x), td_coarse(low.y), td_coarse(high.x) + 1,
                        td_coarse(high.y) + 1};
    td_memory none = {.hooks = {.allocate = give_nothing}};
    walk->found.count = 0;
    return td_preview_find(w, &none, &bounds, low, &walk->found);
}

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

/* Keeps what is met in the piece, after the last hit and before the ground. */
static void keep_met(const td_walk *walk, double limit, td_nearest *k) {
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
        keep_met(walk, limit, k);
        if (k->count > k->capacity) { /* the others come next time */
            k->count = k->capacity;
            walk->last = k->hits[k->count - 1];
        } else if (walk->ground.fraction <= walk->to) {
            /* What is met with it is told before it, or next time. */
            walk->last = k->count ? k->hits[k->count - 1] : walk->ground;
            if (k->count == 0) {
                k->count = walk->ground.fraction < limit;
                k->hits[0] = walk->ground;
                look_for_ground(walk);
            }
        } else {
            walk->last = (thud_ray_hit){.shape = {UINT32_MAX, 0}, .fraction = walk->to};
            walk->under_way = false;
        }
    }
}
