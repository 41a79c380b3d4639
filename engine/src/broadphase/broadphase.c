/* broadphase.c: the broadphase stage of a step, which turns moved bounds into new contacts.
 *
 * Main invariant: a contact exists exactly while the fat bounds of its shapes overlap. Hence an
 * overlapping pair is new if and only if the bounds that its shapes had at the last broadphase did
 * not overlap (td_bounds_before), and no table of pairs is needed. The exceptions are shapes marked
 * TD_MARK_WOKEN and vast worlds (is_vast), whose bounds may wrap around and seem to have
 * overlapped: there the list of contacts of one of the bodies is searched instead. Touching shapes
 * may keep their contact a little longer: see may_have_contact in pairs.c.
 *
 * Two proxy sets are kept: one of the shapes of awake bodies, and one of those of static, sleeping
 * and disabled bodies (here: resting), which is sorted again only when a shape enters or leaves it.
 * Pairs are searched only around shapes on the list `moved`: shapes whose tight bounds have left
 * their fat bounds, new shapes, shapes of bodies that woke, and shapes whose pairs had to wait in a
 * crowded world (CROWD_PAIRS_BASE below). How a proxy set is ordered and swept is the choice of the
 * world's thud_broadphase: grid.c, those made of plane_sweep.c, or all_pairs.c. td_pairs_sort makes
 * the result independent of that choice, except in a crowded world. */
#include "contact/contact.h"
#include "state/kinds.h"
#include "broadphase/pairs.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "state/shared_stages.h"
#include "state/sleep_hooks.h"
#include "api/step.h"

#include <string.h>

/* Whether the body of the shape has an awake slot. */
static bool is_awake(const thud_world *w, int shape) {
    return td_body_at(w, td_shape_at(w, shape)->body)->awake.at > 0;
}

/* ---- the proxy sets ---- */

/* Whether the shape has a pose and bounds in the world. False for a shape made since the last step;
 * queries find such shapes by preview.h. */
static bool is_placed(const thud_world *w, int shape) {
    return td_shape_proxy_at(w, shape)->margin > 0;
}

/* Lists the shapes of a proxy set: those of awake bodies in the order of awake slots, or all others
 * in the order of their indices. Lines of ground are in neither. False when memory is short. */
static bool list_proxy_set(thud_world *w, td_proxy_set *set, bool awake) {
    td_array *list = &set->list;
    if (set->listed) {
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
                if (is_placed(w, i)) {
                    td_push_int(list, i);
                }
            }
        }
    } else {
        for (int i = 0; i < w->shapes.count; i++) {
            const td_shape *shape = td_shape_at(w, i);
            if ((shape->flags & TD_SHAPE_LIVE) && !td_kind_is_line(shape->kind) &&
                !is_awake(w, i) && is_placed(w, i)) {
                td_push_int(list, i);
            }
        }
    }
    set->listed = true;
    return true;
}

/* Brings a proxy set up to date with the shapes' fat bounds: in place where the broadphase can do
 * that, else by building it again. False when memory is short. */
static bool refresh(thud_world *w, td_proxy_set *shapes, bool awake) {
    const thud_broadphase *kind = w->def.broadphase;
    /* Where at most a fifth of the shapes has moved, a proxy set is updated in place, or built so
     * that later steps can update it in place. Where more move, most updates in place fail, since
     * some shape has left its cell. Chosen; not tuned. */
    bool few_moved = awake && w->moved.count * 5 <= w->awake_shapes.list.count;
    if (shapes->valid && shapes->woken && w->sleep_hooks) {
        w->sleep_hooks->drop_woken(w);
    }
    return shapes->valid ||
           (few_moved && kind->follow && kind->follow(w, shapes, w->moved.data, w->moved.count)) ||
           (list_proxy_set(w, shapes, awake) && kind->build(w, shapes, few_moved));
}

/* Brings both proxy sets up to date: the broadphase stage and queries need that. False when memory
 * is short. */
bool td_broadphase_refresh(thud_world *w) {
    return refresh(w, &w->awake_shapes, true) && refresh(w, &w->rest_shapes, false);
}

/* ---- new pairs ---- */

/* Marks the partners of shape a: sets scratch.stamps of every shape that it has a contact with to
 * the new value of scratch.stamp. Returns how many there are. */
static int stamp_partners(thud_world *w, int a) {
    uint32_t *stamps = w->scratch.stamps.data;
    if (++w->scratch.stamp == 0) { /* wrapped around: clear stamps of old searches */
        memset(stamps, 0, (size_t)w->scratch.stamps.capacity * sizeof *stamps);
        w->scratch.stamp = 1;
    }
    uint32_t stamp = w->scratch.stamp;
    int count = 0, e = td_body_at(w, td_shape_at(w, a)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *contact = td_constraint_at(w, td_edge_constraint(e));
        if (contact->shape_a == a || contact->shape_b == a) {
            stamps[contact->shape_a == a ? contact->shape_b : contact->shape_a] = stamp;
            count++;
        }
    }
    return count;
}

/* In a crowded world the new pairs of a shape take turns, so that not all become contacts in one
 * step: a pair is looked at only in steps in which this number has no bit in common with a mask 2^k
 * - 1 (turn_mask). The number grows by 1 in each step, so that each pair has one turn in any 2^k
 * successive steps. */
static unsigned turn_number(const thud_world *w, int a, int b) {
    return (unsigned)a + (unsigned)b + (unsigned)w->steps;
}

/* `hits` are shapes whose bounds overlap those of shape a. Adds a pair with each hit that shape a
 * has no contact with: by the main invariant, one whose bounds did not overlap before, or, where
 * bounds tell nothing (td_bounds_tell_nothing), one that stamp_partners has not stamped. Leaves out
 * the pairs whose turn number has a bit of `skip_mask`. False when memory is short. */
static bool add_new_pairs(thud_world *w, int a, const int *hits, int count, unsigned skip_mask) {
    const td_bounds *before = td_bounds_before(w, a);
    const uint32_t *stamps = w->scratch.stamps.data;
    int own = *td_marks_at(w, a);
    bool stamped = false;
    for (int i = 0; i < count; i++) {
        if (turn_number(w, a, hits[i]) & skip_mask) {
            continue;
        }
        int marks = own | *td_marks_at(w, hits[i]);
        bool existed;
        if (td_bounds_tell_nothing(w, marks)) {
            if (!stamped) {
                stamp_partners(w, a);
                stamped = true;
            }
            existed = stamps[hits[i]] == w->scratch.stamp;
        } else {
            existed = td_bounds_had_met(w, marks, before, hits[i]);
        }
        if (!existed && !td_pairs_add(w, a, hits[i], 0)) {
            return false;
        }
    }
    return true;
}

/* ---- crowds ---- */

/* Where n shapes stand in one place, n^2 / 2 pairs overlap, and making that many contacts in one
 * step would take too long. A world becomes crowded when a sweep finds more overlapping pairs than
 * CROWD_PAIRS_BASE + CROWD_PAIRS_A_SHAPE times its shapes; until then every new pair gets its
 * contact in the step in which it is found. The world stays crowded until fewer than half as many
 * overlap: with one threshold, a crowd that disperses would get all contacts that it lacks in the
 * one step in which it falls below that threshold, which would take long. Both numbers are chosen.
 * For comparison: in a heap of equal circles each has 6 neighbours, which makes 3 pairs a shape;
 * and up to 207 shapes in one place (the solution n of n (n - 1) / 2 = 8192 + 64 n) do not make a
 * world crowded. */
enum { CROWD_PAIRS_BASE = 8192, CROWD_PAIRS_A_SHAPE = 64 };

/* Overlapping pairs above which the world is crowded. */
static int64_t crowd_threshold(const thud_world *w) {
    return CROWD_PAIRS_BASE + CROWD_PAIRS_A_SHAPE * (int64_t)w->shapes.live;
}

/* Limits for one shape in one step of a crowded world. The shapes that overlap it are divided into
 * a power of two of parts, each of about CROWD_TESTS_A_SHAPE shapes or fewer, and each step tests
 * one part. A test is cheap: it reads filters and contact lists. For n shapes in one spot there are
 * fewer than 2 n / CROWD_TESTS_A_SHAPE parts (if more than one): hence each pair is tested within
 * the n / 64 steps that thud_detection.h promises. The new pairs that the filters allow are divided
 * again, into a second power of two of parts, so that about CROWD_CONTACTS_A_SHAPE of them become
 * contacts in a step, or about one if the shape has that many contacts already. A contact is
 * expensive, since the narrowphase works on it from then on; a pair may have to wait for it for as
 * many steps as the product of both powers. A pair with a sensor becomes a contact as soon as it is
 * tested. Both limits are chosen. */
enum { CROWD_TESTS_A_SHAPE = 128, CROWD_CONTACTS_A_SHAPE = 32 };

/* A mask for turn_number, 2^k - 1: the pairs are divided into 2^k parts, the least power of two
 * with which a part of `count` pairs has at most `max`. */
static unsigned turn_mask(int count, int max) {
    unsigned turns = 1;
    while ((unsigned)count > turns * (unsigned)max) {
        turns *= 2;
    }
    return turns - 1;
}

/* In a crowded world: removes pairs of a shape from scratch.pairs, where its new pairs begin at
 * index `first`: those that filters rule out, and those that have no turn in this step, except for
 * pairs of sensors. `skip_mask` is the mask that the pairs have passed already. Returns whether the
 * shape may have pairs left for later steps. */
static bool keep_pairs_in_turn(thud_world *w, int shape, int first, unsigned skip_mask) {
    td_array *pairs = &w->scratch.pairs;
    td_pairs_filter(w, first);
    int kept_count = first,
        max = stamp_partners(w, shape) < CROWD_CONTACTS_A_SHAPE ? CROWD_CONTACTS_A_SHAPE : 1;
    skip_mask += (skip_mask + 1) * turn_mask(pairs->count - first, max);
    for (int i = first; i < pairs->count; i++) {
        const td_new_pair *pair = TD_AT(td_new_pair, pairs, i);
        bool sensor = td_senses(w, pair->a) || td_senses(w, pair->b);
        if (sensor || !(turn_number(w, pair->a, pair->b) & skip_mask)) {
            *TD_AT(td_new_pair, pairs, kept_count++) = *pair;
        }
    }
    pairs->count = kept_count;
    return skip_mask != 0;
}

/* Adds the new pairs of all hits that hold_hits has collected. False when memory is short. */
static bool add_held(td_pair_search *s) {
    int first = 0;
    bool done = true;
    for (int i = 0; i < s->shape_count && done; i++) {
        done = add_new_pairs(s->w, s->shapes[i], s->hits + first, s->counts[i], 0);
        first += s->counts[i];
    }
    s->held = s->shape_count = 0;
    return done;
}

/* Keeps the hits of a shape, the shapes that overlap it, in the search, and prefetches their
 * bounds, so that add_held finds these in the cache. If there are too many hits to keep, it adds
 * their pairs at once. False when memory is short. */
static bool hold_hits(td_pair_search *s, int shape, const int *hits, int count) {
    if (!td_fetches(s->w)) {
        return add_new_pairs(s->w, shape, hits, count, 0);
    }
    if (s->held + count > TD_HELD_MAX && !add_held(s)) {
        return false;
    }
    if (count > TD_HELD_MAX) {
        return add_new_pairs(s->w, shape, hits, count, 0);
    }
    td_bounds_before_fetch(s->w, shape);
    for (int i = 0; i < count; i++) {
        td_bounds_before_fetch(s->w, hits[i]);
        s->hits[s->held++] = hits[i];
    }
    s->shapes[s->shape_count] = shape;
    s->counts[s->shape_count++] = count;
    return true;
}

/* The sweep's td_hits_fn: adds the new pairs of one shape. False, which ends the sweep, when memory
 * is short, and when the pairs make an uncrowded world crowded (the sweep is then done again). */
static bool add_hits(void *context, int shape, const int *hits, int count) {
    td_pair_search *s = context;
    thud_world *w = s->w;
    int first = w->scratch.pairs.count;
    s->overlaps += count;
    if (s->crowded) {
        unsigned skip_mask = turn_mask(count, CROWD_TESTS_A_SHAPE);
        if (!add_new_pairs(w, shape, hits, count, skip_mask)) {
            return false;
        }
        if (keep_pairs_in_turn(w, shape, first, skip_mask)) {
            td_push_int(&w->scratch.crowded, shape);
        }
        return true;
    }
    s->crowded = s->overlaps > s->overlaps_max;
    return !s->crowded && hold_hits(s, shape, hits, count);
}

/* Puts the shapes of a proxy set whose bounds overlap `bounds`, which lie near those of `shape`,
 * into scratch.found_shapes. False when memory is short. */
static bool query(thud_world *w, const td_proxy_set *set, const td_bounds *bounds, int shape) {
    w->scratch.found_shapes.count = 0;
    return w->def.broadphase->find[w->wide](set, &w->memory, bounds,
                                            td_shape_proxy_at(w, shape)->center,
                                            &w->scratch.found_shapes, &w->broadphase.tested);
}

/* Searches all pairs of awake shapes of which one moved. False where add_hits ended the search or
 * memory is short. */
static bool sweep(td_pair_search *s) {
    thud_world *w = s->w;
    s->overlaps = s->held = s->shape_count = 0;
    const td_proxy_set *set = &w->awake_shapes;
    const thud_shared_stages *shared = TD_HAS_THREADS ? w->def.job_system.stages : NULL;
    w->scratch.found_shapes.count = w->scratch.pairs.count = 0;
    return (shared ? shared->sweep
                   : w->def.broadphase->sweep[w->wide])(set, &w->memory, w->proxy.data,
                                                        &w->scratch.found_shapes, add_hits, s,
                                                        &w->broadphase.tested) &&
           (!td_fetches(w) || add_held(s));
}

/* Whether the world was crowded in the last step (had too many overlapping bounds:
 * CROWD_PAIRS_BASE). It shows in the first shape of the moved list: after such a step
 * requeue_crowded puts the shapes whose pairs take turns there, and marks them. */
static bool was_crowded(const thud_world *w) {
    return *td_marks_at(w, td_int_at(&w->moved, 0)) & TD_MARK_CROWDED;
}

/* Adds every new pair of awake shapes of which one moved, in a crowded world only those whose turn
 * it is. Sets *crowded to whether the world is crowded in the next step. False when out of memory.
 */
static bool find_awake_pairs(thud_world *w, bool *crowded) {
    bool before = was_crowded(w);
    td_pair_search s;
    s.w = w;
    s.overlaps_max = crowd_threshold(w);
    s.crowded = before;
    w->scratch.crowded.count = 0;
    bool done = td_array_reserve(&w->memory, &w->scratch.crowded, w->awake_shapes.ids.count) &&
                (sweep(&s) || (s.crowded && !before && sweep(&s)));
    w->broadphase.found += s.overlaps;
    *crowded = s.crowded && 2 * s.overlaps > s.overlaps_max;
    return done;
}

/* Whether the shape is on the moved list. */
static bool has_moved(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED;
}

/* Adds the new pairs of a resting shape with the awake shapes that moved (`with_moved`), or with
 * the awake shapes that did not move. Does nothing for TD_NONE, a shape that has left the set, and
 * for terrain. False when memory is short. */
static bool find_awake_pairs_of(thud_world *w, int shape, bool with_moved) {
    if (shape == TD_NONE || td_kind_is_line(td_shape_at(w, shape)->kind)) {
        return true;
    }
    if (!query(w, &w->awake_shapes, td_fat_at(w, shape), shape)) {
        return false;
    }
    for (int k = 0; k < w->scratch.found_shapes.count; k++) {
        const int *other = TD_AT(int, &w->scratch.found_shapes, k);
        bool finds = has_moved(w, *other) == with_moved;
        w->broadphase.found += finds;
        if (finds && !add_new_pairs(w, shape, other, 1, 0)) {
            return false;
        }
    }
    return true;
}

/* Adds the new pairs of a resting shape that moved with other resting shapes, where one of the two
 * is a sensor: the only pairs that have contacts without an awake body. Where both moved, the shape
 * of lower index adds the pair. False when memory is short. */
static bool find_resting_sensor_pairs_of(thud_world *w, int shape) {
    bool own = td_senses(w, shape);
    if ((!own && !w->mobile_sensors) || td_kind_is_line(td_shape_at(w, shape)->kind)) {
        return true;
    }
    bool done = query(w, &w->rest_shapes, td_fat_at(w, shape), shape);
    for (int k = 0; k < w->scratch.found_shapes.count && done; k++) {
        const int *other = TD_AT(int, &w->scratch.found_shapes, k);
        bool finds = (own || td_senses(w, *other)) && !(has_moved(w, *other) && *other < shape);
        w->broadphase.found += finds;
        done = !finds || add_new_pairs(w, shape, other, 1, 0);
    }
    return done;
}

/* Adds the new pairs of an awake shape with resting ones. False when memory is short. */
static bool find_resting_pairs_of(thud_world *w, int shape) {
    if (!query(w, &w->rest_shapes, td_fat_at(w, shape), shape)) {
        return false;
    }
    w->broadphase.found += w->scratch.found_shapes.count;
    return add_new_pairs(w, shape, w->scratch.found_shapes.data, w->scratch.found_shapes.count, 0);
}

/* If there is less than one resting shape for this many awake shapes that moved, each resting shape
 * queries the set of awake shapes; else each awake shape that moved queries the resting set.
 * Chosen; not tuned. */
enum { MOVED_PER_RESTING = 8 };
/* One query around all awake shapes that moved counts the resting shapes near them. The query is
 * made only if it is expected to find fewer than this many resting shapes for each awake shape that
 * moved, on the assumption that resting shapes are spread evenly. Chosen: to query for one moved
 * shape costs as much as to find a hundred shapes, so that the count costs little even where it
 * turns out too high to be used. */
enum { RESTING_PER_MOVED = 4 };

/* Sets *few to a list of the resting shapes that shall query the awake set: all resting shapes, or
 * those that overlap the one box around all awake shapes that moved. Sets *few to null if neither
 * list is known to be short enough: less than one for every MOVED_PER_RESTING awake shapes that
 * moved. False when memory is short. A world that is made without this function (thud_parts) finds
 * the same pairs by more queries: each moved awake shape queries the resting set. */
bool td_broadphase_few_resting(thud_world *w, const td_array **few) {
    td_scratch *scratch = &w->scratch;
    const td_proxy_set *rest = &w->rest_shapes;
    int few_max = (w->awake_shapes.moved_count - 1) / MOVED_PER_RESTING, last = TD_NONE;
    *few = rest->ids.count <= few_max ? &rest->ids : NULL;
    if (*few || few_max <= 0 || w->vast) {
        return true;
    }
    td_bounds moved = {0};
    for (int i = 0; i < w->moved.count; i++) {
        int shape = td_int_at(&w->moved, i);
        if (is_awake(w, shape)) {
            const td_bounds *b = td_fat_at(w, shape);
            moved = td_bounds_around(last == TD_NONE ? b : &moved, b);
            last = shape;
        }
    }
    double area = (double)td_wrap_sub(moved.max_x, moved.min_x) *
                  (double)td_wrap_sub(moved.max_y, moved.min_y);
    double whole = (double)(rest->end_x - rest->origin_x) * (double)(rest->end_y - rest->origin_y);
    if (rest->ids.count * area >= RESTING_PER_MOVED * whole * w->awake_shapes.moved_count) {
        return true;
    }
    if (!query(w, rest, &moved, last)) {
        return false;
    }
    if (scratch->found_shapes.count <= few_max) {
        td_array found = scratch->found_shapes;
        scratch->found_shapes = scratch->near_rest;
        scratch->near_rest = found;
        *few = &scratch->near_rest;
    }
    return true;
}

/* Adds every new pair of an awake and a resting shape of which one moved, and of two resting ones
 * with a sensor. Where few resting shapes are near the awake shapes that moved, each of these
 * resting shapes queries the awake set; else each moved awake shape queries the resting set.
 * Resting shapes that moved also query the awake set for shapes that did not move, unless all awake
 * shapes moved, as in the first step. False when memory is short. */
static bool find_mixed_pairs(thud_world *w) {
    bool all_moved = w->awake_shapes.moved_count == w->awake_shapes.ids.count;
    const td_array *few = NULL;
    if (w->few_resting && !w->few_resting(w, &few)) {
        return false;
    }
    for (int i = 0; few && i < few->count; i++) {
        if (!find_awake_pairs_of(w, td_int_at(few, i), true)) {
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
                        ? few || w->rest_shapes.ids.count == 0 || find_resting_pairs_of(w, shape)
                        : (all_moved || find_awake_pairs_of(w, shape, false)) &&
                              find_resting_sensor_pairs_of(w, shape);
        if (!done) {
            return false;
        }
    }
    return true;
}

/* ---- the stage ---- */

/* Whether the centres of all shapes span more than 2^30 bounds quanta (2^16 length scales) along an
 * axis: a quarter of the range after which bounds wrap around. Differences of bounds are correct up
 * to half of that range. A quarter of the range is for the distances of centres, the other quarter
 * for the extents of the shapes. */
static bool is_vast(const thud_world *w) {
    const td_proxy_set *a = &w->awake_shapes, *b = &w->rest_shapes;
    int64_t low_x = INT64_MAX, low_y = INT64_MAX, high_x = INT64_MIN, high_y = INT64_MIN;
    for (int i = 0; i < 2; i++) {
        const td_proxy_set *set = i ? b : a;
        if (set->ids.count) {
            low_x = set->origin_x < low_x ? set->origin_x : low_x;
            low_y = set->origin_y < low_y ? set->origin_y : low_y;
            high_x = set->end_x > high_x ? set->end_x : high_x;
            high_y = set->end_y > high_y ? set->end_y : high_y;
        }
    }
    return low_x <= high_x && (high_x - low_x > INT32_MAX / 2 || high_y - low_y > INT32_MAX / 2);
}

/* Looks up anew which edges of the resting shapes that moved are internal: covered by a
 * neighbouring static shape (internal_edges.h). False when memory is short. */
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

/* Puts the shapes that may have pairs left for later steps onto the moved list of the next step.
 * TD_MARK_WOKEN makes that step search their contact lists, since their bounds do not tell which
 * pairs are new. Whether the world is crowded is stored as the mark TD_MARK_CROWDED (was_crowded),
 * since snapshots contain the marks. */
static void requeue_crowded(thud_world *w, bool crowded) {
    int marks = TD_MARK_WOKEN | (crowded ? TD_MARK_CROWDED : 0);
    for (int i = 0; i < w->scratch.crowded.count; i++) {
        int shape = td_int_at(&w->scratch.crowded, i);
        td_shape_mark_moved(w, shape);
        *td_marks_at(w, shape) |= (uint8_t)marks;
    }
}

/* Clears the marks of the shapes on the moved list: all marks at once where the list is long. */
static void clear_marks(thud_world *w) {
    if (w->moved.count * 4 > w->shapes.count) {
        memset(w->marks.data, 0, (size_t)w->shapes.count);
        return;
    }
    for (int i = 0; i < w->moved.count; i++) {
        *td_marks_at(w, td_int_at(&w->moved, i)) = 0;
    }
}

/* The stage: finds all new pairs, filters and sorts them, makes contacts of them, and empties the
 * moved list. False when memory is short: then the step can be tried again. */
bool td_broadphase(thud_world *w) {
    w->broadphase = (td_broadphase_counts){.moved = w->moved.count};
    if (w->moved.count == 0) {
        return true;
    }
    if (!td_array_reserve(&w->memory, &w->scratch.stamps, w->shapes.count) ||
        !td_broadphase_refresh(w)) {
        return false;
    }
    w->broadphase.sort_moves = w->awake_shapes.sort_moves + w->rest_shapes.sort_moves;
    w->awake_shapes.sort_moves = w->rest_shapes.sort_moves = 0;
    /* The test for new pairs also compares the bounds that shapes had before this step. So a world
     * that was vast then (so wide that bounds wrap around: is_vast) is treated as vast for one step
     * more. */
    bool vast = is_vast(w);
    w->vast |= vast;
    bool crowded = false;
    if (!find_awake_pairs(w, &crowded) || !find_mixed_pairs(w)) {
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
    requeue_crowded(w, crowded);
    w->vast = vast;
    return true;
}
