/* broadphase.c: from moved bounds to new contacts.
 *
 * A contact exists exactly while the fat bounds of its shapes overlap, so a pair is new if and only
 * if the bounds that its shapes had before did not overlap: no table of pairs is needed. (In a
 * world so wide that bounds wrap around, they may seem to have overlapped; there the contacts of
 * the two bodies are searched instead.) Bodies that rest (static or asleep) have a grid of their
 * own, sorted anew only when one comes or goes. New pairs come in the order of the grids, then in
 * that of the moved list. */
#include "contact/contact.h"
#include "state/kinds.h"
#include "broadphase/pairs.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "api/step.h"

#include <string.h>

static bool is_awake(const thud_world *w, int shape) {
    return td_body_at(w, td_shape_at(w, shape)->body)->awake.at > 0;
}

/* ---- the grids ---- */

/* Made since the last step, and asked about before the next one: preview.h has it. */
static bool has_place(const thud_world *w, int shape) {
    return td_shape_proxy_at(w, shape)->margin > 0;
}

static bool list_proxy_set(thud_world *w, td_proxy_set *grid, bool awake) {
    td_array *list = &grid->list;
    if (grid->listed) {
        return true;
    }
    if (!td_array_reserve(&w->memory, list, w->shapes.count)) {
        return false;
    }
    list->count = 0;
    if (awake) {
        for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
            int i = td_body_at(w, td_body_of(w, slot))->first_shape;
            for (; i != TD_NONE; i = td_shape_at(w, i)->next) {
                if (has_place(w, i)) {
                    td_push_int(list, i);
                }
            }
        }
    } else {
        for (int i = 0; i < w->shapes.count; i++) {
            const td_shape *shape = td_shape_at(w, i);
            if ((shape->flags & TD_SHAPE_LIVE) && !td_kind_is_line(shape->kind) &&
                !is_awake(w, i) && has_place(w, i)) {
                td_push_int(list, i);
            }
        }
    }
    grid->listed = true;
    return true;
}

static bool refresh(thud_world *w, td_proxy_set *shapes, bool awake) {
    const thud_broadphase *kind = w->def.broadphase;
    /* Where a fifth moved, nearly everything is to be sorted anew next time as well. */
    bool quiet = awake && w->moved.count * 5 <= w->awake_shapes.list.count;
    return shapes->valid ||
           (quiet && kind->follow && kind->follow(w, shapes, w->moved.data, w->moved.count)) ||
           (list_proxy_set(w, shapes, awake) && kind->build(w, shapes, quiet));
}

bool td_broadphase_refresh(thud_world *w) {
    return refresh(w, &w->awake_shapes, true) && refresh(w, &w->rest_shapes, false);
}

/* ---- new pairs ---- */

/* Stamps every shape that shape a has a contact with; returns how many there are. */
static int stamp_partners(thud_world *w, int a) {
    uint32_t *stamps = w->scratch.stamps.data;
    if (++w->scratch.stamp == 0) { /* all of them were used: none may be taken for a new one */
        memset(stamps, 0, (size_t)w->scratch.stamps.capacity * sizeof *stamps);
        w->scratch.stamp = 1;
    }
    uint32_t stamp = w->scratch.stamp;
    int count = 0, e = td_body_at(w, td_shape_at(w, a)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, e / 2);
        if (contact->shape_a == a || contact->shape_b == a) {
            stamps[contact->shape_a == a ? contact->shape_b : contact->shape_a] = stamp;
            count++;
        }
    }
    return count;
}

/* In a crowd pairs take turns: by the step and by the pair, so that each has its turn in time. */
static unsigned turn_of(const thud_world *w, int a, int b) {
    return (unsigned)a + (unsigned)b + (unsigned)w->steps;
}

/* Adds those of the hits, all of which overlap shape a, that have no contact with it: whose bounds
 * did not overlap before; or, where that tells nothing, those that are not among its contacts.
 * `skipped`: bits of turns that it is not. */
static bool add_new(thud_world *w, int a, const int *hits, int count, unsigned skipped) {
    const td_bounds *before = td_bounds_before(w, a);
    const uint32_t *stamps = w->scratch.stamps.data;
    int own = *td_marks_at(w, a);
    bool stamped = false;
    for (int i = 0; i < count; i++) {
        if (turn_of(w, a, hits[i]) & skipped) {
            continue;
        }
        int marks = own | *td_marks_at(w, hits[i]);
        bool existed = false;
        if (td_bounds_tell_nothing(w, marks)) {
            if (!stamped) {
                stamp_partners(w, a);
                stamped = true;
            }
            existed = stamps[hits[i]] == w->scratch.stamp;
        } else if (!(marks & TD_MARK_FRESH)) {
            existed = td_bounds_overlap(before, td_bounds_before(w, hits[i]));
        }
        if (!existed && !td_pairs_add(w, a, hits[i], 0)) {
            return false;
        }
    }
    return true;
}

/* ---- crowds ---- */

/* Where everything overlaps everything, there are as many pairs as the square of the shapes. A
 * world becomes crowded when more pairs overlap than ENOUGH and ENOUGH_A_SHAPE for each of its
 * shapes; until then all pairs get their contacts at once. It stays so until fewer than half as
 * many overlap: a crowd that comes apart would else get all that are missing in the one step in
 * which it has just few enough. */
enum { ENOUGH = 8192, ENOUGH_A_SHAPE = 64 };

static int64_t enough(const thud_world *w) {
    return ENOUGH + ENOUGH_A_SHAPE * (int64_t)w->shapes.live;
}

/* In a crowded world, a shape looks in each step at about LOOKS of those that overlap it, which is
 * cheap, and gets new contacts with about PLACES of them, which is not; once it has PLACES contacts
 * it gets about one more a step. Sensors get contacts with all that are looked at. The others have
 * their turn in later steps: each within as many as the power of two by which they were divided. */
enum { LOOKS = 128, PLACES = 32 };

typedef struct search {
    thud_world *w;
    int64_t looks;
    bool crowded;
} search;

/* One less than the power of two that divides `count` down to `most`. */
static unsigned turns_for(int count, int most) {
    unsigned turns = 1;
    while ((unsigned)count > turns * (unsigned)most) {
        turns *= 2;
    }
    return turns - 1;
}

/* In a crowd: of a shape's pairs, those from `first` on, drops those that may not touch, and those
 * whose turn it is not; all passed `skipped`. Returns whether any may be missing. */
static bool take_turns(thud_world *w, int shape, int first, unsigned skipped) {
    td_array *pairs = &w->scratch.pairs;
    td_pairs_filter(w, first);
    int kept = first, most = stamp_partners(w, shape) < PLACES ? PLACES : 1;
    skipped += (skipped + 1) * turns_for(pairs->count - first, most);
    for (int i = first; i < pairs->count; i++) {
        const td_new_pair *pair = TD_AT(td_new_pair, pairs, i);
        bool sensor = td_senses(w, pair->a) || td_senses(w, pair->b);
        if (sensor || !(turn_of(w, pair->a, pair->b) & skipped)) {
            *TD_AT(td_new_pair, pairs, kept++) = *pair;
        }
    }
    pairs->count = kept;
    return skipped != 0;
}

static bool take_hits(void *context, int shape, const int *hits, int count) {
    search *s = context;
    thud_world *w = s->w;
    int first = w->scratch.pairs.count;
    unsigned skipped = s->crowded ? turns_for(count, LOOKS) : 0;
    if (!add_new(w, shape, hits, count, skipped)) {
        return false;
    }
    s->looks += count;
    if (s->crowded) {
        if (take_turns(w, shape, first, skipped)) {
            td_push_int(&w->scratch.crowded, shape);
        }
        return true;
    }
    s->crowded = s->looks > enough(w);
    return !s->crowded;
}

static bool query(thud_world *w, const td_proxy_set *grid, int shape) {
    w->scratch.hits.count = 0;
    return w->def.broadphase->find[w->wide](grid, &w->memory, td_fat_at(w, shape),
                                            td_shape_proxy_at(w, shape)->center, &w->scratch.hits);
}

static bool sweep(search *s) {
    thud_world *w = s->w;
    s->looks = 0;
    const td_proxy_set *grid = &w->awake_shapes;
    bool every = grid->moved_count * 2 > grid->ids.count;
    w->scratch.hits.count = w->scratch.pairs.count = 0;
    return w->def.broadphase->sweep[w->wide](grid, &w->memory, w->proxy.data, every,
                                             &w->scratch.hits, take_hits, s);
}

/* Shapes of a crowd are the first that moved: look_again. */
static bool was_crowded(const thud_world *w) {
    return *td_marks_at(w, td_int_at(&w->moved, 0)) & TD_MARK_CROWDED;
}

/* Every pair of awake shapes of which one moved, or, in a crowd, whose turn it is. Sets whether the
 * next search is one in a crowd as well. */
static bool pair_awake(thud_world *w, bool *crowded) {
    bool before = was_crowded(w);
    search s = {.w = w, .crowded = before};
    w->scratch.crowded.count = 0;
    bool done = td_array_reserve(&w->memory, &w->scratch.crowded, w->awake_shapes.ids.count) &&
                (sweep(&s) || (s.crowded && !before && sweep(&s)));
    *crowded = s.crowded && s.looks > enough(w) / 2;
    return done;
}

static bool moved(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED;
}

/* A shape at rest against awake ones; where both moved the pair comes once more from the other. */
static bool pair_resting(thud_world *w, int shape, bool with_moved) {
    if (td_kind_is_line(td_shape_at(w, shape)->kind)) {
        return true;
    }
    if (!query(w, &w->awake_shapes, shape)) {
        return false;
    }
    for (int k = 0; k < w->scratch.hits.count; k++) {
        const int *other = TD_AT(int, &w->scratch.hits, k);
        if (moved(w, *other) == with_moved && !add_new(w, shape, other, 1, 0)) {
            return false;
        }
    }
    return true;
}

/* A sensor sees who sleeps where it comes to, and one that sleeps what comes to it. Where both
 * moved, the lower shape finds the pair. */
static bool pair_sensed(thud_world *w, int shape) {
    bool own = td_senses(w, shape);
    if ((!own && !w->mobile_sensors) || td_kind_is_line(td_shape_at(w, shape)->kind)) {
        return true;
    }
    bool done = query(w, &w->rest_shapes, shape);
    for (int k = 0; k < w->scratch.hits.count && done; k++) {
        const int *other = TD_AT(int, &w->scratch.hits, k);
        bool finds = (own || td_senses(w, *other)) && !(moved(w, *other) && *other < shape);
        done = !finds || add_new(w, shape, other, 1, 0);
    }
    return done;
}

static bool pair_moved(thud_world *w, int shape) {
    return query(w, &w->rest_shapes, shape) &&
           add_new(w, shape, w->scratch.hits.data, w->scratch.hits.count, 0);
}

/* Every pair of an awake shape and one at rest of which one moved. Where few rest, they look for
 * what moved rather than the other way around. Those that came to rest or moved there look for
 * awake ones that did not move, if there are any: in a world's first step there are none. */
static bool pair_across(thud_world *w) {
    const td_array *rest = &w->rest_shapes.ids;
    bool all_moved = w->awake_shapes.moved_count == w->awake_shapes.ids.count;
    bool few = rest->count * 8 < w->awake_shapes.moved_count;
    for (int i = 0; i < rest->count && few; i++) {
        if (!pair_resting(w, td_int_at(rest, i), true)) {
            return false;
        }
    }
    bool moved_rest = w->awake_shapes.moved_count < w->moved.count;
    if (few && !moved_rest) {
        return true;
    }
    for (int i = 0; i < w->moved.count; i++) {
        int shape = td_int_at(&w->moved, i);
        bool done = is_awake(w, shape)
                        ? few || rest->count == 0 || pair_moved(w, shape)
                        : (all_moved || pair_resting(w, shape, false)) && pair_sensed(w, shape);
        if (!done) {
            return false;
        }
    }
    return true;
}

/* ---- the stage ---- */

/* Wider than half the way around the bounds. */
static bool is_vast(const thud_world *w) {
    const td_proxy_set *a = &w->awake_shapes, *b = &w->rest_shapes;
    int64_t low_x = INT64_MAX, low_y = INT64_MAX, high_x = INT64_MIN, high_y = INT64_MIN;
    for (int i = 0; i < 2; i++) {
        const td_proxy_set *grid = i ? b : a;
        if (grid->ids.count) {
            low_x = grid->origin_x < low_x ? grid->origin_x : low_x;
            low_y = grid->origin_y < low_y ? grid->origin_y : low_y;
            high_x = grid->end_x > high_x ? grid->end_x : high_x;
            high_y = grid->end_y > high_y ? grid->end_y : high_y;
        }
    }
    return low_x <= high_x && (high_x - low_x > INT32_MAX / 2 || high_y - low_y > INT32_MAX / 2);
}

/* Static shapes that came or moved may stand next to others. */
static bool find_internal_edges(thud_world *w) {
    bool any = w->internal_edges && w->awake_shapes.moved_count < w->moved.count;
    for (int i = 0; i < w->moved.count && any; i++) {
        int shape = td_int_at(&w->moved, i);
        if (!is_awake(w, shape) && !w->internal_edges->find(w, shape)) {
            return false;
        }
    }
    return true;
}

/* Shapes in a crowd have pairs that are not listed yet. `crowded`: so is the world in the next
 * step, which a snapshot takes along with their marks. */
static void look_again(thud_world *w, bool crowded) {
    int marks = TD_MARK_WOKEN | (crowded ? TD_MARK_CROWDED : 0);
    for (int i = 0; i < w->scratch.crowded.count; i++) {
        int shape = td_int_at(&w->scratch.crowded, i);
        td_shape_mark_moved(w, shape);
        *td_marks_at(w, shape) |= (uint8_t)marks;
    }
}

static void clear_marks(thud_world *w) {
    if (w->moved.count * 4 > w->shapes.count) {
        memset(w->marks.data, 0, (size_t)w->shapes.count);
        return;
    }
    for (int i = 0; i < w->moved.count; i++) {
        *td_marks_at(w, td_int_at(&w->moved, i)) = 0;
    }
}

bool td_broadphase(thud_world *w) {
    if (w->moved.count == 0) {
        return true;
    }
    if (!td_array_reserve(&w->memory, &w->scratch.stamps, w->shapes.count) ||
        !td_broadphase_refresh(w)) {
        return false;
    }
    /* A body that was far away a step ago may be near now, hence both. */
    bool vast = is_vast(w);
    w->vast |= vast;
    bool crowded = false;
    if (!pair_awake(w, &crowded) || !pair_across(w)) {
        return false;
    }
    td_pairs_filter(w, 0);
    if (!find_internal_edges(w) || (w->ground && !w->ground->add_pairs(w)) || !td_pairs_sort(w) ||
        !td_pairs_create(w)) {
        return false;
    }
    clear_marks(w);
    if (w->awake_shapes.loose) {
        memset(w->awake_shapes.moved.data, 0, (size_t)w->awake_shapes.ids.count * sizeof(int32_t));
    }
    w->moved.count = 0;
    look_again(w, crowded);
    w->vast = vast;
    return true;
}
