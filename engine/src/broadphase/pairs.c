/* pairs.c: see pairs.h. */
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

/* Records lie all over memory, hence are asked for early. */
void td_pairs_filter(thud_world *w, int first) {
    td_array *pairs = &w->scratch.pairs;
    td_new_pair *pair = pairs->data;
    int kept = first;
    for (int i = first; i < pairs->count; i++) {
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

enum { DIGIT = 8, BUCKETS = 1 << DIGIT };

/* One pass of a radix sort, by `shift` of the first or the second shape. */
static void sort_pass(const td_new_pair *from, td_new_pair *to, int count, bool second, int shift) {
    int starts[BUCKETS] = {0}, sum = 0;
    for (int i = 0; i < count; i++) {
        starts[(second ? from[i].b : from[i].a) >> shift & (BUCKETS - 1)]++;
    }
    for (int i = 0; i < BUCKETS; i++) {
        int here = starts[i];
        starts[i] = sum;
        sum += here;
    }
    for (int i = 0; i < count; i++) {
        to[starts[(second ? from[i].b : from[i].a) >> shift & (BUCKETS - 1)]++] = from[i];
    }
}

bool td_pairs_sort(thud_world *w) {
    td_array *pairs = &w->scratch.pairs;
    int count = pairs->count;
    if (!td_array_reserve(&w->memory, pairs, 2 * count)) {
        return false;
    }
    td_new_pair *at = pairs->data, *other = count ? at + count : at;
    for (int i = 0; i < count; i++) {
        if (at[i].a > at[i].b) {
            at[i] = (td_new_pair){at[i].b, at[i].a, at[i].child};
        }
    }
    for (int second = 1; second >= 0; second--) {
        for (int shift = 0; w->shapes.count >> shift > 0; shift += DIGIT) {
            sort_pass(at, other, count, second, shift);
            td_new_pair *t = at;
            at = other;
            other = t;
        }
    }
    if (at != pairs->data) {
        memcpy(pairs->data, at, (size_t)count * sizeof *at);
    }
    return true;
}

/* Both bodies' contacts are walked in turns: the shorter list decides. In a crowd both are long. */
bool td_pair_has_contact(const thud_world *w, const td_new_pair *p) {
    const td_shape *a = td_shape_at(w, p->a), *b = td_shape_at(w, p->b);
    int e = td_body_at(w, a->body)->first_constraint;
    int f = td_body_at(w, b->body)->first_constraint;
    while (e != TD_NONE && f != TD_NONE) {
        const td_constraint *c = td_constraint_at(w, e / 2);
        if (c->shape_a == p->a && c->shape_b == p->b && c->child == p->child) {
            return true;
        }
        int next = td_next_edge(w, e);
        e = f;
        f = next;
    }
    return false;
}

/* Two that touch keep their contact when their fat bounds part: those reach less far than a
 * manifold that is kept, or than the speculative margin about small shapes. Once the bounds meet
 * again the pair seems to be new; likewise one with a line where bounds tell nothing. Where they
 * tell nothing of two other shapes, the search for pairs has looked through the contacts of one of
 * them already. */
static bool seems_new(const thud_world *w, const td_new_pair *p) {
    bool line =
        td_kind_is_line(td_shape_at(w, p->a)->kind) || td_kind_is_line(td_shape_at(w, p->b)->kind);
    int marks = *td_marks_at(w, p->a) | *td_marks_at(w, p->b);
    return !(marks & TD_MARK_FRESH || (!line && td_bounds_tell_nothing(w, marks)));
}

bool td_pairs_create(thud_world *w) {
    td_array *pairs = &w->scratch.pairs;
    int more[TD_CONSTRAINT_KINDS] = {0};
    for (int i = 0; i < pairs->count; i++) {
        td_new_pair *pair = TD_AT(td_new_pair, pairs, i);
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
        td_pair_kind kind = td_pair_of(w, &pair->a, &pair->b);
        if (!(seems_new(w, pair) && td_pair_has_contact(w, pair))) {
            td_contact_create(w, kind, pair->a, pair->b, pair->child);
        }
    }
    return true;
}
