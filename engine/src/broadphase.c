/* broadphase.c: from moved bounds to new contacts.
 *
 * A contact exists exactly while the fat bounds of its shapes overlap, so a pair is new if and only
 * if the bounds that its shapes had before did not overlap: no table of pairs is needed. (In a world
 * so wide that bounds wrap around, they may seem to have overlapped; there the contacts of the two
 * bodies are searched instead.) Bodies that
 * rest (static or asleep) have a grid of their own, sorted anew only when one comes or goes. New
 * pairs come in the order of the grids, then in that of the moved list. */
#include "contact.h"
#include "kinds.h"
#include "shape.h"
#include "step.h"

#include <string.h>

typedef struct td_new_pair {
    int32_t a, b, child;
} td_new_pair;

static bool is_awake(const thud_world *w, int shape)
{
    return td_body_at(w, td_shape_at(w, shape)->body)->awake > 0;
}

/* ---- the grids ---- */

static bool list_population(thud_world *w, td_grid *grid, bool awake)
{
    td_array *list = &grid->list;
    list->stride = (int)sizeof(int);
    if (grid->listed) {
        return true;
    }
    if (!td_array_reserve(&w->memory, list, w->shapes.count)) {
        return false;
    }
    list->count = 0;
    if (awake) {
        const int *bodies = w->body_of.data;
        for (int slot = 1; slot < w->body_of.count; slot++) {
            int i = td_body_at(w, bodies[slot])->first_shape;
            for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
                td_push_int(list, i);
            }
        }
    } else {
        for (int i = 0; i < w->shapes.count; i++) {
            const td_shape *shape = td_shape_at(w, i);
            if ((shape->flags & TD_SHAPE_LIVE) && shape->kind != THUD_TERRAIN && !is_awake(w, i)) {
                td_push_int(list, i);
            }
        }
    }
    grid->listed = true;
    return true;
}

static bool refresh(thud_world *w, td_grid *grid, bool awake)
{
    /* Where a fifth moved, nearly everything is to be sorted anew next time as well. */
    bool quiet = awake && w->moved.count * 5 <= w->awake_grid.list.count;
    return grid->valid ||
           (quiet && td_grid_follow(w, grid, w->moved.data, w->moved.count)) ||
           (list_population(w, grid, awake) && td_grid_build(w, grid, quiet));
}

bool td_broadphase_refresh(thud_world *w)
{
    return refresh(w, &w->awake_grid, true) && refresh(w, &w->rest_grid, false);
}

/* ---- new pairs ---- */

static const td_bounds *bounds_before(const thud_world *w, int shape)
{
    return *td_marks_at(w, shape) & TD_MARK_MOVED ? td_at(&w->was, shape) : td_fat_at(w, shape);
}

static bool has_contact(const thud_world *w, int a, int b, int child)
{
    int e = td_body_at(w, td_shape_at(w, b)->body)->first_contact;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_contact *contact = td_contact_at(w, e / 2);
        if (((contact->shape_a == a && contact->shape_b == b) ||
             (contact->shape_a == b && contact->shape_b == a)) &&
            contact->child == child) {
            return true;
        }
    }
    return false;
}

/* Whether the pair, whose bounds overlap now, had its contact already. `a_before` and `a_marks` are
 * those of shape a. */
static inline bool existed(const thud_world *w, int a, const td_bounds *a_before, int a_marks, int b)
{
    int marks = a_marks | *td_marks_at(w, b);
    if (marks & TD_MARK_FRESH) {
        return false;
    }
    return marks & TD_MARK_WOKEN || w->vast ? has_contact(w, a, b, 0)
                                            : td_bounds_overlap(a_before, bounds_before(w, b));
}

static bool add_pair(thud_world *w, int a, int b, int child)
{
    td_array *pairs = &w->scratch.pairs;
    if (!td_array_reserve(&w->memory, pairs, pairs->count + 1)) {
        return false;
    }
    *(td_new_pair *)td_at(pairs, pairs->count++) = (td_new_pair){a, b, child};
    return true;
}

/* Keeps those of the hits, all of which overlap shape a, that are new. */
static bool add_new(thud_world *w, int a, const int *hits, int count)
{
    const td_bounds *before = bounds_before(w, a);
    int marks = *td_marks_at(w, a);
    for (int i = 0; i < count; i++) {
        if (!existed(w, a, before, marks, hits[i]) && !add_pair(w, a, hits[i], 0)) {
            return false;
        }
    }
    return true;
}

/* Drops the pairs that may not touch. Their records lie all over memory, hence are
 * asked for early. */
static void filter_pairs(thud_world *w)
{
    td_array *pairs = &w->scratch.pairs;
    td_new_pair *pair = pairs->data;
    int kept = 0;
    for (int i = 0; i < pairs->count; i++) {
        if (i + 16 < pairs->count) {
            __builtin_prefetch(td_shape_at(w, pair[i + 16].a));
            __builtin_prefetch(td_shape_at(w, pair[i + 16].b));
        }
        if (i + 8 < pairs->count) {
            __builtin_prefetch(td_body_at(w, td_shape_at(w, pair[i + 8].a)->body), 1);
            __builtin_prefetch(td_body_at(w, td_shape_at(w, pair[i + 8].b)->body), 1);
        }
        if (td_pair_allowed(w, pair[i].a, pair[i].b) && td_pair_meets(w, pair[i].a, pair[i].b)) {
            pair[kept++] = pair[i];
        }
    }
    pairs->count = kept;
}

static bool query(thud_world *w, const td_grid *grid, int shape)
{
    w->scratch.hits.count = 0;
    return TD_PICK_WIDE(w, td_grid_query)(grid, &w->memory, td_fat_at(w, shape),
                                          td_stance_at(w, shape)->center, &w->scratch.hits);
}

/* Every pair of awake shapes of which one moved. */
static bool pair_awake(thud_world *w)
{
    td_array *hits = &w->scratch.hits, *runs = &w->scratch.hit_runs;
    const td_grid *grid = &w->awake_grid;
    bool every = grid->moved_count * 2 > grid->ids.count;
    hits->count = 0;
    if (!TD_PICK_WIDE(w, td_grid_sweep)(grid, &w->memory, w->stance.data, every, runs, hits)) {
        return false;
    }
    const int *hit = hits->data;
    int first = 0;
    for (int i = 0; i < runs->count; i++) {
        const td_hit_run *run = td_at(runs, i);
        if (!add_new(w, run->shape, hit + first, run->end - first)) {
            return false;
        }
        first = run->end;
    }
    return true;
}

static bool moved(const thud_world *w, int shape)
{
    return *td_marks_at(w, shape) & TD_MARK_MOVED;
}

/* A shape at rest against awake ones; where both moved the pair comes once more from the other. */
static bool pair_resting(thud_world *w, int shape, bool with_moved)
{
    if (td_shape_at(w, shape)->kind == THUD_TERRAIN || !query(w, &w->awake_grid, shape)) {
        return td_shape_at(w, shape)->kind == THUD_TERRAIN;
    }
    for (int k = 0; k < w->scratch.hits.count; k++) {
        const int *other = td_at(&w->scratch.hits, k);
        if (moved(w, *other) == with_moved && !add_new(w, shape, other, 1)) {
            return false;
        }
    }
    return true;
}

static bool pair_moved(thud_world *w, int shape)
{
    return query(w, &w->rest_grid, shape) &&
           add_new(w, shape, w->scratch.hits.data, w->scratch.hits.count);
}

/* Every pair of an awake shape and one at rest of which one moved. Where few rest, they look for
 * what moved rather than the other way around. */
static bool pair_across(thud_world *w)
{
    const td_array *rest = &w->rest_grid.ids;
    bool few = rest->count * 8 < w->awake_grid.moved_count;
    for (int i = 0; i < rest->count && few; i++) {
        if (!pair_resting(w, *(int *)td_at(rest, i), true)) {
            return false;
        }
    }
    bool moved_rest = w->awake_grid.moved_count < w->moved.count;
    if (few && !moved_rest) {
        return true;
    }
    for (int i = 0; i < w->moved.count; i++) {
        int shape = *(int *)td_at(&w->moved, i);
        bool done = is_awake(w, shape) ? few || rest->count == 0 || pair_moved(w, shape)
                                       : pair_resting(w, shape, false);
        if (!done) {
            return false;
        }
    }
    return true;
}

/* ---- terrain: each segment is a shape of its own, found by its index ---- */

static bool pair_terrain(thud_world *w, int terrain_shape, int shape)
{
    const td_stance *stance = td_stance_at(w, shape);
    if (td_terrain_below(w, terrain_shape, stance->center, &stance->fat)) {
        return true;
    }
    thud_terrain terrain = td_terrain_view(w, terrain_shape);
    int marks = *td_marks_at(w, terrain_shape) | *td_marks_at(w, shape);
    if (!td_pair_allowed(w, terrain_shape, shape)) {
        return true;
    }
    int first, last;
    td_place at = td_stance_at(w, shape)->center;
    td_terrain_segments_of(w, terrain_shape, &terrain, at, td_fat_at(w, shape), &first, &last);
    for (int i = first; i <= last; i++) {
        if (!td_terrain_reaches(w, terrain_shape, &terrain, at, td_fat_at(w, shape), i)) {
            continue;
        }
        bool old = false;
        if (marks & TD_MARK_WOKEN || w->vast) {
            old = has_contact(w, terrain_shape, shape, i);
        } else if (!(marks & TD_MARK_FRESH)) {
            old = td_terrain_reaches(w, terrain_shape, &terrain, at, bounds_before(w, shape), i);
        }
        if (!old && !add_pair(w, terrain_shape, shape, i)) {
            return false;
        }
    }
    return true;
}

static bool pair_terrains(thud_world *w)
{
    for (int t = 0; t < w->terrains.count; t++) {
        const td_terrain_record *record = td_slot_at(&w->terrains, t);
        if (record->shape == TD_NONE) {
            continue;
        }
        if (*td_marks_at(w, record->shape) & TD_MARK_FRESH) {
            const td_array *all = &w->awake_grid.ids;
            for (int i = 0; i < all->count; i++) {
                if (!pair_terrain(w, record->shape, *(int *)td_at(all, i))) {
                    return false;
                }
            }
            continue;
        }
        for (int i = 0; i < w->moved.count; i++) {
            int shape = *(int *)td_at(&w->moved, i);
            if (is_awake(w, shape) && !pair_terrain(w, record->shape, shape)) {
                return false;
            }
        }
    }
    return true;
}

/* ---- the stage ---- */

static bool create_contacts(thud_world *w)
{
    td_array *pairs = &w->scratch.pairs;
    int more[TD_PAIR_COUNT] = {0};
    for (int i = 0; i < pairs->count; i++) {
        td_new_pair *pair = td_at(pairs, i);
        more[td_pair_of(w, &pair->a, &pair->b)]++;
    }
    if (!td_contacts_reserve(w, more)) {
        return false;
    }
    for (int i = 0; i < pairs->count; i++) {
        td_new_pair *pair = td_at(pairs, i);
        td_pair_kind kind = td_pair_of(w, &pair->a, &pair->b);
        td_contact_create(w, kind, pair->a, pair->b, pair->child);
    }
    return true;
}

/* Wider than half the way around the bounds. */
static bool is_vast(const thud_world *w)
{
    const td_grid *a = &w->awake_grid, *b = &w->rest_grid;
    int64_t low_x = INT64_MAX, low_y = INT64_MAX, high_x = INT64_MIN, high_y = INT64_MIN;
    for (int i = 0; i < 2; i++) {
        const td_grid *grid = i ? b : a;
        if (grid->ids.count) {
            low_x = grid->origin_x < low_x ? grid->origin_x : low_x;
            low_y = grid->origin_y < low_y ? grid->origin_y : low_y;
            high_x = grid->end_x > high_x ? grid->end_x : high_x;
            high_y = grid->end_y > high_y ? grid->end_y : high_y;
        }
    }
    return high_x > low_x + INT32_MAX / 2 || high_y > low_y + INT32_MAX / 2;
}

static void clear_marks(thud_world *w)
{
    if (w->moved.count * 4 > w->shapes.count) {
        memset(w->marks.data, 0, (size_t)w->shapes.count);
        return;
    }
    for (int i = 0; i < w->moved.count; i++) {
        *td_marks_at(w, *(int *)td_at(&w->moved, i)) = 0;
    }
}

bool td_broadphase(thud_world *w)
{
    if (w->moved.count == 0) {
        return true;
    }
    w->scratch.pairs.count = 0;
    if (!td_broadphase_refresh(w)) {
        return false;
    }
    /* A body that was far away a step ago may be near now, hence both. */
    bool vast = is_vast(w);
    w->vast |= vast;
    if (!pair_awake(w) || !pair_across(w)) {
        return false;
    }
    filter_pairs(w);
    if (!pair_terrains(w) || !create_contacts(w)) {
        return false;
    }
    clear_marks(w);
    if (w->awake_grid.loose) {
        memset(w->awake_grid.moved.data, 0, (size_t)w->awake_grid.ids.count * sizeof(int32_t));
    }
    w->moved.count = 0;
    w->vast = vast;
    return true;
}
