/* test_broadphases_random.c: random worlds with the same edits give the same results with each
 * broadphase, under every detection, while terrains are made, moved and dug under awake bodies: the
 * same contacts, events and callbacks in the same order, and the same bits of bodies. */
#include "engine_support.h"
#include "every_choice.h"
#include "share.h"
#include "state/world.h"

enum { BODIES = 70, STEPS = 90 };

/* A random world and what was recorded of it. */
typedef struct life {
    thud_world *world;
    thud_body_id bodies[BODIES], ground;
    thud_shape_id line;
    uint64_t seed;
    uint64_t told; /* hash of the arguments of callbacks */
    int lines_made, lines_moved, asked, events;
    uint64_t hash[STEPS][4]; /* hashes after each step: contacts, events, callbacks, bodies */
} life;

static void mix(uint64_t *hash, const void *data, size_t bytes) {
    for (size_t i = 0; i < bytes; i++) {
        *hash = (*hash ^ ((const unsigned char *)data)[i]) * 0x100000001b3u;
    }
}

static void mix_int(uint64_t *hash, uint32_t value) {
    mix(hash, &value, sizeof value);
}

static int pick(life *l, int count) {
    return (int)random_in(&l->seed, 0, (double)count);
}

/* ---- arguments of callbacks ---- */

/* A prologue: hashes its arguments, and vetoes a fifth of the contacts. */
static bool ask(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                void *context) {
    life *l = context;
    (void)world;
    l->asked++;
    mix_int(&l->told, contact->shape_a.index1);
    mix_int(&l->told, contact->shape_b.index1);
    mix(&l->told, &contact->point, sizeof contact->point);
    mix(&l->told, settings, sizeof *settings);
    return (contact->shape_a.index1 + contact->shape_b.index1) % 5 != 0;
}

/* An epilogue: hashes its arguments. */
static void tell(thud_world *world, const thud_contact *contact, void *context) {
    life *l = context;
    (void)world;
    mix_int(&l->told, contact->shape_a.index1);
    mix_int(&l->told, contact->shape_b.index1);
    mix(&l->told, &contact->normal_impulse, sizeof contact->normal_impulse);
}

/* ---- edits ---- */

static void add_random(life *l, int i) {
    thud_body_kind kind = pick(l, 7) ? THUD_BODY_DYNAMIC : (thud_body_kind)pick(l, 2);
    l->bodies[i] =
        add_body(l->world, kind, random_in(&l->seed, -9, 9), random_in(&l->seed, 0.5, 7), 0);
    for (int shapes = pick(l, 4) == 0; shapes >= 0; shapes--) {
        thud_shape_def def = thud_default_shape_def();
        def.sensor = pick(l, 6) == 0;
        def.restitution = pick(l, 3) == 0 ? 1.0f : 0.0f;
        def.filter.group = -(pick(l, 5) == 0);
        float x = (float)random_in(&l->seed, 0.05, 0.7), y = (float)random_in(&l->seed, 0.05, 0.7);
        add_shape(l->world, l->bodies[i], x, pick(l, 3) ? y : 0, pick(l, 2), &def);
    }
    if (kind != THUD_BODY_STATIC) {
        double most = pick(l, 4) ? 3 : 90;
        thud_vec2 v = {(float)random_in(&l->seed, -most, most),
                       (float)random_in(&l->seed, -most, most)};
        OK(thud_body_set_velocity(l->world, l->bodies[i], v, 0));
    }
}

/* Adds two layers of ground tiles and a wall at their end, in a scrambled order. */
static void add_tiles(life *l) {
    for (int i = 0; i < 64; i++) {
        int at = i * 29 % 64;
        double x = at < 48 ? at % 24 - 12 : 12, y = at < 48 ? -1.5 - at / 24 : at - 50;
        thud_body_id tile = add_body(l->world, THUD_BODY_STATIC, x, y, 0);
        add_shape(l->world, tile, 0.5f, 0.5f, i % 2, NULL);
    }
}

static void add_line(life *l) {
    thud_pos points[25];
    for (int i = 0; i < 25; i++) {
        points[i] = (thud_pos){i - 12.0, random_in(&l->seed, -0.5, 0.5)};
    }
    thud_terrain line = {.kind = pick(l, 2) ? THUD_TERRAIN_IRREGULAR : THUD_TERRAIN_UNIFORM,
                         .points = points,
                         .count = 25,
                         .x0 = -12.0,
                         .spacing = 1.0};
    thud_shape_def def = thud_default_shape_def();
    l->ground = add_body(l->world, THUD_BODY_STATIC, 0, random_in(&l->seed, 0, 2), 0);
    OK(thud_shape_create_terrain(l->world, l->ground, &def, &line, &l->line));
    l->lines_made++;
}

/* Makes a random edit of the terrain: a new one, a move, digging or raising. */
static void edit_line(life *l) {
    switch (pick(l, 4)) {
    case 0:
        OK(thud_body_destroy(l->world, l->ground));
        add_line(l);
        break;
    case 1:
        OK(thud_body_set_transform(l->world, l->ground,
                                   (thud_pos){random_in(&l->seed, -1, 1),
                                              random_in(&l->seed, 0, 2)},
                                   0));
        l->lines_moved++;
        break;
    case 2:
        OK(thud_shape_dig(l->world, l->line, (thud_pos){random_in(&l->seed, -8, 8), 0.2}, 0.7));
        break;
    default:
        OK(thud_shape_raise(l->world, l->line, random_in(&l->seed, -8, 8), 1.5, 0.4));
    }
}

/* Makes a random edit of a body. */
static void edit(life *l) {
    int i = pick(l, BODIES);
    switch (pick(l, 3)) {
    case 0:
        OK(thud_body_destroy(l->world, l->bodies[i]));
        add_random(l, i);
        break;
    case 1:
        OK(thud_body_set_transform(l->world, l->bodies[i],
                                   (thud_pos){random_in(&l->seed, -9, 9),
                                              random_in(&l->seed, 0.5, 7)},
                                   0));
        break;
    default:
        OK(thud_body_set_enabled(l->world, l->bodies[i], pick(l, 3) != 0));
    }
}

/* ---- records ---- */

/* Adds the events of a list, and their number, to the hash. */
static void mix_pairs(uint64_t *hash, const thud_contact_event *e, int count) {
    for (int i = 0; i < count; i++) {
        mix_int(hash, e[i].shape_a.index1);
        mix_int(hash, e[i].shape_b.index1);
    }
    mix_int(hash, (uint32_t)count);
}

/* Adds the state after a step to the four hashes. */
static void note(life *l, uint64_t hash[4]) {
    const thud_world *w = l->world;
    for (int i = 0; i < w->constraints.count; i++) {
        const td_contact *c = td_contact_at(w, i);
        mix_int(&hash[0], c->live);
        if (c->live) {
            mix_int(&hash[0], (uint32_t)c->shape_a);
            mix_int(&hash[0], (uint32_t)c->shape_b);
            mix_int(&hash[0], (uint32_t)c->child);
        }
    }
    thud_events e = thud_events_of(w);
    mix_pairs(&hash[1], e.begin, e.begin_count);
    mix_pairs(&hash[1], e.end, e.end_count);
    mix_pairs(&hash[1], e.sensor_begin, e.sensor_begin_count);
    mix_pairs(&hash[1], e.sensor_end, e.sensor_end_count);
    for (int i = 0; i < e.hit_count; i++) {
        mix_int(&hash[1], e.hit[i].shape_a.index1);
        mix(&hash[1], &e.hit[i].point, sizeof e.hit[i].point);
    }
    l->events += e.begin_count + e.sensor_begin_count;
    hash[2] = l->told;
    for (int i = 0; i < BODIES; i++) {
        thud_body_state s = state_of(w, l->bodies[i]);
        mix(&hash[3], &s.position, sizeof s.position);
        mix(&hash[3], &s.velocity, sizeof s.velocity);
        mix(&hash[3], &s.angle, sizeof s.angle);
    }
}

/* Runs the world of a seed, and records each step. */
static life *live(const thud_broadphase *broadphase, float cell_size,
                  const thud_detection *detection, uint64_t seed) {
    life *l = calloc(1, sizeof *l);
    assert_non_null(l);
    thud_world_def def = thud_default_world_def();
    def.broadphase = broadphase;
    def.cell_size = cell_size;
    def.detection = detection;
    l->seed = seed * 7919;
    l->world = make_world(def);
    if (seed % 2) {
        set_listeners(l->world, ask, tell, l);
    }
    add_tiles(l);
    for (int i = 0; i < BODIES; i++) {
        add_random(l, i);
    }
    add_line(l);
    for (int step = 0; step < STEPS; step++) {
        if (step % 6 == 5) {
            edit_line(l);
        }
        for (int edits = pick(l, 3); edits > 0; edits--) {
            edit(l);
        }
        OK(thud_world_step(l->world));
        note(l, l->hash[step]);
    }
    thud_world_destroy(l->world);
    return l;
}

static void random_lives_are_the_same_with_every_broadphase(void **state) {
    (void)state;
    static const char *const what[] = {"contacts", "events", "callbacks", "bodies"};
    int made = 0, moved = 0, asked = 0, events = 0;
    for (uint64_t seed = 1; seed <= (uint64_t)share_of(12); seed++) {
        for (int d = 0; d < 4; d++) {
            /* The grid with cells of a size of the seed's own follows the other broadphases. */
            static const float cell_sizes[] = {1e-4f, 0.3f, 1.0f, 3.0f, 1000.0f, 0.7f};
            life *first = live(broadphases[0], 0, detections[d], seed);
            for (int b = 1; b <= BROADPHASES_IN_ALL; b++) {
                bool own = b == BROADPHASES_IN_ALL;
                const thud_broadphase *broadphase = broadphases[own ? 0 : b];
                life *other = live(broadphase, own ? cell_sizes[seed % 6] : 0, detections[d], seed);
                for (int i = 0; i < 4 * STEPS; i++) {
                    if (first->hash[i / 4][i % 4] != other->hash[i / 4][i % 4]) {
                        fail_msg("seed %d, %s, %s: other %s in step %d", (int)seed,
                                 thud_broadphase_name(broadphase),
                                 thud_detection_name(detections[d]), what[i % 4], i / 4);
                    }
                }
                free(other);
            }
            made += first->lines_made;
            moved += first->lines_moved;
            asked += first->asked;
            events += first->events;
            free(first);
        }
    }
    assert_true(made > share_of(100) && moved > share_of(100));
    assert_true(asked > share_of(10000) && events > share_of(10000));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_lives_are_the_same_with_every_broadphase),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
