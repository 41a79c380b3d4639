/* pairs.c: the list scratch.pairs on its way from found overlaps to contacts: filtered, sorted by
 * shapes (radix sort), and made into contacts; see pairs.h. */
#include "broadphase/pairs.h"

#include "contact/contact.h"
#include "contact/internal_edges.h"

#include <string.h>

bool td_pairs_add(thud_world *w, int a, int b, int child) {
    td_array *pairs = &w->scratch.pairs;
    if (!td_array_reserve(&w->memory, pairs, pairs->count + 1)) {
        return false;
    }
    TD_PUSH(td_new_pair, pairs) = (td_new_pair){a, b, child};
    return true;
}

/* Shape and body records lie anywhere in memory. So that they are in the cache when a loop over
 * pairs comes to them, it prefetches the records of the pair that comes this many pairs later.
 * Chosen. */
enum { FETCH_SHAPES = 16, FETCH_BODIES = 8, FETCH_EDGES = 4 };

/* At pair i of a loop over `count` pairs: prefetches the shapes and bodies of later pairs. */
static void fetch_ahead(const thud_world *w, const td_new_pair *pair, int count, int i) {
    if (TD_HAS_PREFETCH && i + FETCH_SHAPES < count) {
        __builtin_prefetch(td_shape_at(w, pair[i + FETCH_SHAPES].a));
        __builtin_prefetch(td_shape_at(w, pair[i + FETCH_SHAPES].b));
    }
    if (TD_HAS_PREFETCH && i + FETCH_BODIES < count) {
        __builtin_prefetch(td_body_at(w, td_shape_at(w, pair[i + FETCH_BODIES].a)->body), 1);
        __builtin_prefetch(td_body_at(w, td_shape_at(w, pair[i + FETCH_BODIES].b)->body), 1);
    }
}

void td_pairs_filter(thud_world *w, int first) {
    td_array *pairs = &w->scratch.pairs;
    td_new_pair *pair = pairs->data;
    int kept_count = first, fetched = td_fetches(w) ? pairs->count : 0;
    for (int i = first; i < pairs->count; i++) {
        fetch_ahead(w, pair, fetched, i);
        if (td_pair_allowed(w, pair[i].a, pair[i].b) && td_pair_meets(w, pair[i].a, pair[i].b)) {
            pair[kept_count++] = pair[i];
        }
    }
    pairs->count = kept_count;
}

/* Up to this many pairs are sorted by insertion: for them, clearing and summing the tables of a
 * radix sort takes longer. Chosen; not tuned. */
enum { INSERTED_MAX = 32 };

/* The sort key of a pair: shape a, then shape b. */
static uint64_t key_of(const td_new_pair *pair) {
    return (uint64_t)(uint32_t)pair->a << 32 | (uint32_t)pair->b;
}

/* The radix sort goes by digits of 8 bits: its table of 256 counts fits the first cache. */
enum { DIGIT_BITS = 8, BUCKETS = 1 << DIGIT_BITS };

/* The digit of a pair's key at bit `shift`. */
static unsigned digit_of(const td_new_pair *pair, int shift) {
    return (unsigned)(key_of(pair) >> shift) & (BUCKETS - 1);
}

/* One stable pass of a radix sort, by the digit at bit `shift`. */
static void sort_pass(const td_new_pair *from, td_new_pair *to, int count, int shift) {
    int starts[BUCKETS] = {0}, sum = 0;
    for (int i = 0; i < count; i++) {
        starts[digit_of(&from[i], shift)]++;
    }
    for (int i = 0; i < BUCKETS; i++) {
        int here = starts[i];
        starts[i] = sum;
        sum += here;
    }
    for (int i = 0; i < count; i++) {
        to[starts[digit_of(&from[i], shift)]++] = from[i];
    }
}

bool td_pairs_sort(thud_world *w) {
    td_array *pairs = &w->scratch.pairs;
    int count = pairs->count;
    if (!td_array_reserve(&w->memory, pairs, 2 * count)) {
        return false;
    }
    td_new_pair *from = pairs->data, *to = count ? from + count : from;
    bool few = count <= INSERTED_MAX;
    for (int i = 0; i < count; i++) {
        td_new_pair pair = from[i];
        pair.a = td_min_int(from[i].a, from[i].b);
        pair.b = td_max_int(from[i].a, from[i].b);
        int at = i;
        for (; few && at > 0 && key_of(&from[at - 1]) > key_of(&pair); at--) {
            from[at] = from[at - 1];
        }
        from[at] = pair;
    }
    if (few) {
        return true;
    }
    for (int shift = 0; shift < 64; shift += DIGIT_BITS) {
        /* Either half of a key is an index below shapes.count. Where that count has no bits at the
         * digit or above it, the digit is 0 in all keys, and its pass is skipped. */
        if (w->shapes.count >> shift % 32 > 0) {
            sort_pass(from, to, count, shift);
            td_new_pair *t = from;
            from = to;
            to = t;
        }
    }
    if (from != pairs->data) {
        memcpy(pairs->data, from, (size_t)count * sizeof *from);
    }
    return true;
}

/* Walks the constraint lists of both bodies in alternation, so that the shorter list ends the
 * search. In a crowd both are long. */
bool td_pair_has_contact(const thud_world *w, const td_new_pair *p) {
    const td_shape *a = td_shape_at(w, p->a), *b = td_shape_at(w, p->b);
    int e = td_body_at(w, a->body)->first_constraint;
    int f = td_body_at(w, b->body)->first_constraint;
    while (e != TD_NONE && f != TD_NONE) {
        const td_constraint *c = td_constraint_at(w, td_edge_constraint(e));
        if (c->shape_a == p->a && c->shape_b == p->b && c->child == p->child) {
            return true;
        }
        int next = td_next_edge(w, e);
        e = f;
        f = next;
    }
    return false;
}

/* Whether a pair that seems new may have a contact already, so that the bodies' lists of contacts
 * must be searched. Touching shapes keep their contact when their fat bounds no longer overlap,
 * since a small shape's contact may exist at a distance at which its fat bounds do not reach the
 * other shape's (speculative margin, cached manifold). When the bounds overlap again, the pair
 * seems new. A pair with a new shape (TD_MARK_FRESH) has no contact. For a woken shape and in a
 * vast world the bounds do not tell which pairs are new (td_bounds_tell_nothing): there
 * add_new_pairs has searched the lists already, except for pairs with a line of ground. */
static bool may_have_contact(const thud_world *w, const td_new_pair *p) {
    bool line =
        td_kind_is_line(td_shape_at(w, p->a)->kind) || td_kind_is_line(td_shape_at(w, p->b)->kind);
    int marks = *td_marks_at(w, p->a) | *td_marks_at(w, p->b);
    return !(marks & TD_MARK_FRESH || (!line && td_bounds_tell_nothing(w, marks)));
}

/* Prefetches the heads of the lists of edges of both bodies of the pair FETCH_EDGES ahead, to
 * which a new contact is linked. */
static void fetch_lists_ahead(const thud_world *w, const td_new_pair *pair, int count, int i) {
    for (int side = 0; TD_HAS_PREFETCH && i + FETCH_EDGES < count && side < 2; side++) {
        const td_shape *shape =
            td_shape_at(w, side ? pair[i + FETCH_EDGES].b : pair[i + FETCH_EDGES].a);
        int head = td_body_at(w, shape->body)->first_constraint;
        if (head != TD_NONE) {
            __builtin_prefetch(td_constraint_at(w, td_edge_constraint(head)), 1);
        }
    }
}

bool td_pairs_create(thud_world *w) {
    td_array *pairs = &w->scratch.pairs;
    int more[TD_CONSTRAINT_KINDS] = {0}, fetched = td_fetches(w) ? pairs->count : 0;
    for (int i = 0; i < pairs->count; i++) {
        td_new_pair *pair = TD_AT(td_new_pair, pairs, i);
        fetch_ahead(w, pairs->data, fetched, i);
        more[td_pair_of(w, &pair->a, &pair->b)]++;
        if ((td_shape_at(w, pair->a)->flags & TD_SHAPE_UNSEEN) &&
            !w->internal_edges->see(w, pair->a)) {
            return false;
        }
    }
    if (!td_constraints_reserve(w, more)) {
        return false;
    }
    for (int i = 0; i < pairs->count; i++) {
        td_new_pair *pair = TD_AT(td_new_pair, pairs, i);
        fetch_lists_ahead(w, pairs->data, fetched, i);
        td_pair_kind kind = td_pair_of(w, &pair->a, &pair->b);
        if (!(may_have_contact(w, pair) && td_pair_has_contact(w, pair))) {
            td_contact_create(w, kind, pair->a, pair->b, pair->child);
        }
    }
    return true;
}
