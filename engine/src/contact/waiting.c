/* waiting.c: tests waiting contacts in scratch blocks, by the kernels that compute manifolds. */
#include "contact/waiting.h"

#include "contact/contact.h"
#include "contact/internal_edges.h"
#include "state/shape.h"

#include <string.h>

enum {
    TEST_BLOCKS = 32
}; /* scratch blocks of a thread, so that it tests 256 contacts at once. Chosen. */

/* The input of the kernels, without the outputs `has_offsets` and `separated`. */
static td_collide_context context_of(const thud_world *w) {
    return (td_collide_context){
        .proxy = w->proxy.data,
        .velocity = w->velocity.data,
        .quantum = w->quantum,
        .margin = TD_SPECULATIVE * w->length_scale,
        .skin = w->skin,
        .axis_tolerance = 0.1f * TD_SLOP * w->length_scale, /* 0.0005 length scales. Chosen. */
    };
}

int td_collide_blocks(thud_world *w, int kind, td_block *const *blocks, int count,
                      td_block **separated, int *separated_count) {
    td_collide_context context = context_of(w);
    int has_offsets = 0;
    context.has_offsets = &has_offsets;
    context.separated = separated;
    context.separated_count = separated_count;
    if (w->kinds[kind]->collide) {
        w->kinds[kind]->collide(blocks, count, &context);
    } else {
        w->kinds[kind]->collide_world(w, blocks, count, &context);
    }
    return has_offsets;
}

bool td_waiting_reserve(thud_world *w, int threads) {
    td_array *blocks = &w->scratch.test_blocks, *list = &w->scratch.test_list;
    blocks->stride = (int)td_form_bytes(TD_FORM_TWO_CACHED);
    return td_array_reserve(&w->memory, blocks, threads * TEST_BLOCKS) &&
           td_array_reserve(&w->memory, list, threads * TEST_BLOCKS);
}

/* Runs the kind's kernel on contacts in scratch blocks, and lists those that touch. */
static void test_contacts(thud_world *w, int kind, const int *contacts, int count,
                          const td_waiting_found *found) {
    int first = TD_HAS_THREADS ? found->thread * TEST_BLOCKS : 0;
    td_block **list = (td_block **)w->scratch.test_list.data + first;
    int blocks = (count + TD_LANES - 1) / TD_LANES;
    for (int i = 0; i < blocks; i++) {
        td_block *block = list[i] = td_at(&w->scratch.test_blocks, first + i);
        memset(block, 0, td_form_bytes(TD_FORM_TWO_CACHED));
        block->has_offsets = 1;
        block->used = td_min_int(count - i * TD_LANES, TD_LANES);
        for (int lane = 0; lane < block->used; lane++) {
            int index = contacts[i * TD_LANES + lane];
            const td_contact *contact = td_contact_at(w, index);
            block->constraint[lane] = index;
            block->shape_a[lane] = contact->shape_a;
            block->shape_b[lane] = contact->shape_b;
            block->mark[lane].internal_edges =
                td_internal_edges_of(td_shape_at(w, contact->shape_a),
                                     td_shape_at(w, contact->shape_b));
        }
    }
    td_block *separated[TEST_BLOCKS + 1];
    int separated_count = 0;
    td_collide_blocks(w, kind, list, blocks, separated, &separated_count);
    for (int i = 0; i < blocks; i++) {
        if (w->internal_edges) {
            w->internal_edges->amend(w, list[i], kind);
        }
        for (unsigned bits = list[i]->touching; bits; bits &= bits - 1) {
            td_push_int(found->begins, list[i]->constraint[__builtin_ctz(bits)]);
        }
    }
}

/* Waiting contacts that are collected for the exact test. */
typedef struct batch {
    thud_world *w;
    int kind;
    const td_waiting_found *found;
    int count;
    int contacts[TEST_BLOCKS * TD_LANES];
} batch;

/* Tests the collected contacts and empties the batch. */
static void test_batch(batch *b) {
    if (b->count) {
        test_contacts(b->w, b->kind, b->contacts, b->count, b->found);
    }
    b->count = 0;
}

static void add_to_batch(batch *b, int contact) {
    b->contacts[b->count++] = contact;
    if (b->count == TEST_BLOCKS * TD_LANES) {
        test_batch(b);
    }
}

/* Collects the contacts whose bounds overlap and lists those whose bounds have parted, one by one:
 * for kinds without a sift function, and in a vast world. */
static void sift_singly(batch *b, const int *waiting, int count) {
    for (int i = 0; i < count; i++) {
        if (td_contact_bounds_meet(b->w, td_contact_at(b->w, waiting[i]))) {
            add_to_batch(b, waiting[i]);
        } else {
            td_push_int(b->found->ends, waiting[i]);
        }
    }
}

/* sift_singly for eight contacts at a time. It also leaves out contacts whose bounds overlap but
 * whose separation is above the speculative margin by a cheap lower bound; they keep waiting. */
static void sift_widely(batch *b, const int *waiting, int count) {
    thud_world *w = b->w;
    td_sift_fn *sift = w->kinds[b->kind]->sift;
    td_collide_context context = context_of(w);
    int fetched = td_fetches(w) ? count : 0;
    for (int first = 0; first < count; first += TD_LANES) {
        int32_t shape_a[TD_LANES], shape_b[TD_LANES];
        int used = td_min_int(count - first, TD_LANES);
        for (int i = 0; i < TD_LANES; i++) {
            const td_contact *contact = td_contact_at(w, waiting[first + td_min_int(i, used - 1)]);
            shape_a[i] = contact->shape_a;
            shape_b[i] = contact->shape_b;
            /* The contacts are prefetched four groups ahead, and their proxies two. Chosen. */
            if (first + i + 4 * TD_LANES < fetched) {
                __builtin_prefetch(td_contact_at(w, waiting[first + i + 4 * TD_LANES]));
            }
            if (first + i + 2 * TD_LANES < fetched) {
                contact = td_contact_at(w, waiting[first + i + 2 * TD_LANES]);
                __builtin_prefetch(td_shape_proxy_at(w, contact->shape_a));
                __builtin_prefetch(td_shape_proxy_at(w, contact->shape_b));
            }
        }
        td_sifted sifted = sift(shape_a, shape_b, &context);
        unsigned here = (1u << used) - 1u;
        for (unsigned bits = sifted.bounds_apart & here; bits; bits &= bits - 1) {
            td_push_int(b->found->ends, waiting[first + __builtin_ctz(bits)]);
        }
        for (unsigned bits = sifted.near & here; bits; bits &= bits - 1) {
            add_to_batch(b, waiting[first + __builtin_ctz(bits)]);
        }
    }
}

void td_waiting_test(thud_world *w, int kind, const int *contacts, int count,
                     const td_waiting_found *found) {
    batch b = {.w = w, .kind = kind, .found = found};
    if (w->kinds[kind]->sift && !w->vast) {
        sift_widely(&b, contacts, count);
    } else {
        sift_singly(&b, contacts, count);
    }
    test_batch(&b);
}

void td_waiting_test_all(thud_world *w) {
    td_waiting_found found = {&w->scratch.begins, &w->scratch.ends, 0};
    for (int kind = 0; kind < TD_PAIR_TOUCH_COUNT; kind++) {
        if (w->waiting[kind].count) {
            td_waiting_test(w, kind, w->waiting[kind].data, w->waiting[kind].count, &found);
        }
    }
}
