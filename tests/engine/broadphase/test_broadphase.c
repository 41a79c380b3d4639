/* test_broadphase.c: while a random world is edited and runs, contacts exist exactly for the pairs
 * of shapes whose fat bounds overlap, and every broadphase makes the same ones in the same order.
 * The reference is the test of all pairs. */
#include "engine_support.h"
#include "every_choice.h"

#include "contact/contact.h"
#include "state/world.h"

/* A random world that is edited while it runs. */
typedef struct chaos {
    thud_world *world;
    thud_body_id bodies[400];
    int count;
    uint64_t seed;
    double width, small, large;
} chaos;

static void add_random(chaos *c) {
    bool fixed = random_in(&c->seed, 0, 1) < 0.2;
    double x = random_in(&c->seed, -c->width, c->width);
    double y = random_in(&c->seed, -c->width, c->width);
    /* The logarithm of sizes is uniform, so small ones are as frequent as large ones. */
    float size = (float)(c->small * pow(c->large / c->small, random_in(&c->seed, 0, 1)));
    thud_body_id id = add_body(c->world, fixed ? THUD_BODY_STATIC : THUD_BODY_DYNAMIC, x, y, 0);
    int kind = (int)random_in(&c->seed, 0, 3);
    add_shape(c->world, id, size, kind ? size * 0.7f : 0, kind == 1, NULL);
    if (!fixed) {
        thud_vec2 v = {(float)random_in(&c->seed, -9, 9), (float)random_in(&c->seed, -9, 9)};
        OK(thud_body_set_velocity(c->world, id, v, 0));
    }
    c->bodies[c->count++] = id;
}

static bool is_of(const td_contact *contact, int a, int b) {
    return (contact->shape_a == a && contact->shape_b == b) ||
           (contact->shape_a == b && contact->shape_b == a);
}

static bool has_contact(const thud_world *w, int a, int b) {
    int e = td_body_at(w, td_shape_at(w, a)->body)->first_constraint;
    for (; e != TD_NONE; e = td_next_edge(w, e)) {
        if (is_of(td_contact_at(w, e / 2), a, b)) {
            return true;
        }
    }
    return false;
}

/* The bounds that the broadphase used in the last step. */
static const td_bounds *bounds_seen(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED ? td_at(&w->previous_fat, shape)
                                                  : td_fat_at(w, shape);
}

/* Asserts that contacts and overlapping bounds are the same pairs. Bounds may have grown after the
 * broadphase of the step, so those from when pairs were last made are used. `crowd`: pairs may
 * still be missing. */
static void check(const thud_world *w, bool crowd) {
    int pairs = 0, missing = 0;
    for (int a = 0; a < w->shapes.count; a++) {
        const td_shape *shape_a = td_shape_at(w, a);
        for (int b = a + 1; b < w->shapes.count; b++) {
            const td_shape *shape_b = td_shape_at(w, b);
            if (!((shape_a->flags & shape_b->flags) & TD_SHAPE_LIVE) || !td_pair_allowed(w, a, b)) {
                continue;
            }
            const td_bounds *of_a = bounds_seen(w, a), *of_b = bounds_seen(w, b);
            /* Fixed-point bounds wrap around at great distances, so only near pairs are
             * compared. */
            const td_position *p = &td_shape_proxy_at(w, a)->center,
                              *q = &td_shape_proxy_at(w, b)->center;
            double most = 1e5 * TD_FIXED_ONE;
            bool near_by = fabs((double)(p->x - q->x)) < most && fabs((double)(p->y - q->y)) < most;
            bool overlap = near_by && td_bounds_overlap(of_a, of_b);
            /* Inside a crowd a pair may be deferred; then one of its shapes is marked for the next
             * step. */
            if (crowd && overlap && !has_contact(w, a, b) &&
                (*td_marks_at(w, a) | *td_marks_at(w, b)) & TD_MARK_WOKEN) {
                missing++;
            } else if (overlap != has_contact(w, a, b)) {
                fail_msg("shapes %d and %d: overlap %d, contact %d", a, b, overlap,
                         has_contact(w, a, b));
            }
            pairs += overlap;
        }
    }
    assert_int_equal(pairs - missing, w->constraints.live);
}

/* Hash of all contacts with their indices, which depend on when each was made. */
static uint64_t list_hash(const thud_world *w, uint64_t hash) {
    for (int i = 0; i < w->constraints.count; i++) {
        const td_contact *contact = td_contact_at(w, i);
        int words[] = {contact->live, contact->shape_a, contact->shape_b, contact->child};
        for (int k = 0; k < 4 && contact->live; k++) {
            hash = (hash ^ (uint64_t)(uint32_t)words[k]) * 0x100000001b3u;
        }
    }
    return hash;
}

/* Runs steps with random edits and checks each; returns a hash of the contacts after each step. */
static uint64_t live_through(chaos *c, int steps) {
    int most = 0;
    uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < 150; i++) {
        add_random(c);
    }
    for (int step = 0; step < steps; step++) {
        int victim = (int)random_in(&c->seed, 0, c->count);
        double fate = random_in(&c->seed, 0, 1);
        if (fate < 0.1) {
            OK(thud_body_destroy(c->world, c->bodies[victim]));
            c->bodies[victim] = c->bodies[--c->count];
        } else if (fate < 0.3) {
            thud_pos to = {random_in(&c->seed, -c->width, c->width),
                           random_in(&c->seed, -c->width, c->width)};
            OK(thud_body_set_transform(c->world, c->bodies[victim], to, 0));
        } else if (fate < 0.5) {
            add_random(c);
        }
        OK(thud_world_step(c->world));
        check(c->world, false);
        hash = list_hash(c->world, hash);
        most = c->world->constraints.live > most ? c->world->constraints.live : most;
    }
    assert_true(most > 3);
    thud_world_destroy(c->world);
    return hash;
}

/* Runs the same edits with each broadphase and asserts that the contacts are the same at the same
 * time. */
static void live_with_each(chaos begin, thud_world_def def, bool floor, int steps) {
    uint64_t hash[BROADPHASES_IN_ALL];
    for (int k = 0; k < BROADPHASES_IN_ALL; k++) {
        chaos c = begin;
        def.broadphase = broadphases[k];
        c.world = make_world(def);
        if (floor) {
            add_floor(c.world, NULL);
        }
        hash[k] = live_through(&c, steps);
        if (hash[k] != hash[0]) {
            fail_msg("%s makes other contacts than the grid", thud_broadphase_name(def.broadphase));
        }
    }
}

static void contacts_are_the_overlapping_bounds_in_a_crowd(void **state) {
    (void)state;
    live_with_each((chaos){.seed = 7, .width = 8, .small = 0.3, .large = 0.6}, weightless(), false,
                   120);
}

static void contacts_are_the_overlapping_bounds_with_sizes_from_small_to_large(void **state) {
    (void)state;
    live_with_each((chaos){.seed = 8, .width = 60, .small = 0.05, .large = 20}, weightless(), false,
                   120);
}

static void contacts_are_the_overlapping_bounds_in_a_sparse_wide_world(void **state) {
    (void)state;
    live_with_each((chaos){.seed = 9, .width = 1.5e5, .small = 500, .large = 11000}, weightless(),
                   false, 60);
}

static void contacts_are_the_overlapping_bounds_in_one_spot(void **state) {
    (void)state;
    live_with_each((chaos){.seed = 10, .width = 0.2, .small = 0.4, .large = 0.5}, weightless(),
                   false, 40);
}

static void contacts_are_the_overlapping_bounds_while_islands_sleep_and_wake(void **state) {
    (void)state;
    chaos begin = {.seed = 11, .width = 12, .small = 0.3, .large = 0.9};
    live_with_each(begin, thud_default_world_def(), true, 200);
}

/* Six hundred circles in one place have 180,000 pairs. The world keeps a bounded number of contacts
 * at a time, and has every overlapping pair once the circles have come apart. */
static void crowd_in_one_place_has_bounded_contacts_and_comes_apart(void **state) {
    (void)state;
    enum { CIRCLES = 600 };
    thud_world *world = make_world(weightless());
    uint64_t seed = 12;
    for (int i = 0; i < CIRCLES; i++) {
        thud_body_def body = thud_default_body_def();
        thud_shape_def shape = thud_default_shape_def();
        thud_body_id id;
        body.kind = THUD_BODY_DYNAMIC;
        body.position = (thud_pos){random_in(&seed, -0.05, 0.05), random_in(&seed, -0.05, 0.05)};
        OK(thud_body_create(world, &body, &id));
        OK(thud_shape_create_circle(world, id, &shape, (thud_vec2){0, 0}, 0.25f, NULL));
    }
    for (int step = 0; step < 240; step++) {
        OK(thud_world_step(world));
        check(world, true);
        assert_true(world->constraints.live < 96 * CIRCLES);
    }
    assert_true(thud_measure_of(world).penetration_max < 0.25);
    check(world, false);
    thud_world_destroy(world);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_are_the_overlapping_bounds_in_a_crowd),
        cmocka_unit_test(contacts_are_the_overlapping_bounds_with_sizes_from_small_to_large),
        cmocka_unit_test(contacts_are_the_overlapping_bounds_in_a_sparse_wide_world),
        cmocka_unit_test(contacts_are_the_overlapping_bounds_in_one_spot),
        cmocka_unit_test(contacts_are_the_overlapping_bounds_while_islands_sleep_and_wake),
        cmocka_unit_test(crowd_in_one_place_has_bounded_contacts_and_comes_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
