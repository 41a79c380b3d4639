/* test_packed.c: packed snapshots are small, unpack to the same bytes, and are refused where they
 * are damaged, forged, or met by another base. */
#include "refused_snapshot.h"

#include "api/snapshot.h"

#include <thud/thud_joint.h>
#include <thud/thud_listeners.h>
#include <thud/thud_packed.h>

/* Bytes in memory of their own. */
static thud_bytes as_bytes(saved s) {
    return (thud_bytes){s.bytes, s.size};
}

static const thud_bytes none = {NULL, 0};

/* Packs; asserts that the size is the one that is told, within the bound of the header. */
static saved pack(const thud_world *world, thud_bytes base, saved snapshot) {
    saved packed = {NULL, 0};
    size_t written = 0, max = snapshot.size + snapshot.size / 8 + 2048;
    OK(thud_world_pack(world, base, as_bytes(snapshot), NULL, 0, &packed.size));
    assert_true(packed.size <= max);
    packed.bytes = malloc(max);
    OK(thud_world_pack(world, base, as_bytes(snapshot), packed.bytes, packed.size, &written));
    assert_int_equal(written, packed.size);
    char *roomy = malloc(max); /* as large as a packed snapshot may be: packed in one pass */
    OK(thud_world_pack(world, base, as_bytes(snapshot), roomy, max, &written));
    assert_int_equal(written, packed.size);
    assert_memory_equal(roomy, packed.bytes, packed.size);
    free(roomy);
    return packed;
}

/* Asserts that unpacking gives the snapshot. */
static void unpacks(const thud_world *world, thud_bytes base, saved packed, saved snapshot) {
    char *back = malloc(snapshot.size);
    size_t bytes = 0;
    OK(thud_world_unpack(world, base, as_bytes(packed), NULL, 0, &bytes));
    assert_int_equal(bytes, snapshot.size);
    bytes = 0;
    OK(thud_world_unpack(world, base, as_bytes(packed), back, snapshot.size, &bytes));
    assert_int_equal(bytes, snapshot.size);
    assert_memory_equal(back, snapshot.bytes, snapshot.size);
    free(back);
}

/* The sizes of a snapshot packed alone and against a base. */
typedef struct sizes {
    size_t alone, delta;
} sizes;

static sizes pack_both(const thud_world *world, saved base, saved snapshot) {
    saved alone = pack(world, none, snapshot), delta = pack(world, as_bytes(base), snapshot);
    unpacks(world, none, alone, snapshot);
    unpacks(world, as_bytes(base), delta, snapshot);
    free(alone.bytes);
    free(delta.bytes);
    return (sizes){alone.size, delta.size};
}

/* ---- sizes ---- */

/* Circles that fly about in a box without gravity. */
static thud_world *make_gas(int across) {
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){0, 0};
    thud_world *world = make_world(def);
    uint64_t seed = 7;
    for (int i = 0; i < across * across; i++) {
        thud_body_id ball = add_ball(world, 2.0 * (i % across), 2.0 * (i / across), 0.3f);
        thud_vec2 velocity = {(float)random_in(&seed, -3, 3), (float)random_in(&seed, -3, 3)};
        OK(thud_body_set_velocity(world, ball, velocity, (float)random_in(&seed, -1, 1)));
    }
    return world;
}

/* A wall of boxes, or circles in a pit. */
static thud_world *make_heap(bool boxes) {
    thud_world_def def = thud_default_world_def();
    def.sleeping = false;
    thud_world *world = make_world(def);
    add_floor(world, NULL);
    for (int i = 0; i < 400; i++) {
        double x = i % 20, y = 0.5 + i / 20;
        if (boxes) {
            add_box(world, x + 0.25 * (i / 20 % 2), y, 0.5f, 0.5f);
        } else {
            add_ball(world, 1.01 * x + 0.3 * (i / 20 % 2), y, 0.5f);
        }
    }
    return world;
}

/* Steps the world, and asserts sizes in bytes a body: the bounds that issue 30 sets. */
static void sizes_are_within(thud_world *world, int steps, size_t alone, size_t delta) {
    run(world, steps);
    size_t bodies = (size_t)thud_stats_of(world).bodies;
    saved base = save(world);
    run(world, 1);
    saved next = save(world);
    sizes s = pack_both(world, base, next);
    print_message("%zu bytes a body, alone %.1f, delta %.1f\n", next.size / bodies,
                  (double)s.alone / (double)bodies, (double)s.delta / (double)bodies);
    assert_true(s.alone <= alone * bodies && s.delta <= delta * bodies);
    sizes same = pack_both(world, next, next);
    assert_true(same.delta < 400); /* a byte a section, and the two heads */
    free(base.bytes);
    free(next.bytes);
    thud_world_destroy(world);
}

static void gas_and_heaps_pack_small(void **state) {
    (void)state;
    sizes_are_within(make_gas(20), 60, 100, 30);
    sizes_are_within(make_heap(false), 300, 200, 60);
    sizes_are_within(make_heap(true), 300, 200, 60);
}

/* ---- the same bytes ---- */

/* Changes the yard: bodies come and go, ground is dug, joints are made, bodies sleep. */
static void change(const yard *y, int time) {
    uint64_t seed = 99 + (uint64_t)time * 1013;
    random_in(&seed, 0, 1);
    double x = random_in(&seed, -12, 12), dice = random_in(&seed, 0, 1);
    thud_body_id some = y->heap[(int)random_in(&seed, 0, 11.9)];
    bool lives = thud_body_is_valid(y->world, some);
    if (dice < 0.2) {
        add_box(y->world, x, 12, 0.4f, 0.3f);
    } else if (dice < 0.3) {
        OK(thud_shape_dig(y->world, y->ground, (thud_pos){x, 0.5}, 0.8));
    } else if (dice < 0.4 && lives) {
        OK(thud_body_destroy(y->world, some));
    } else if (dice < 0.5 && lives) {
        thud_joint_def def = thud_default_joint_def(THUD_JOINT_HINGE);
        def.body_a = y->ball;
        def.body_b = some;
        thud_joint_id joint;
        OK(thud_joint_create(y->world, &def, &joint));
    } else if (dice < 0.7 && lives) {
        OK(thud_body_set_velocity(y->world, some, (thud_vec2){(float)x, 6}, 1));
    }
}

/* In random games of every detection, whatever lies between base and snapshot. */
static void unpacked_bytes_are_those_that_were_packed(void **state) {
    (void)state;
    const thud_detection *const detections[] = {NULL, &thud_detection_continuous,
                                                &thud_detection_bisect, &thud_detection_swept};
    for (int d = 0; d < 4; d++) {
        thud_world_def def = thud_default_world_def();
        def.detection = detections[d];
        yard y = make_yard(&def);
        saved first = save(y.world), base = save(y.world);
        for (int time = 0; time < 90; time++) {
            change(&y, time);
            if (time % 7 != 3) {
                run(y.world, 1);
            }
            saved next = save(y.world);
            pack_both(y.world, base, next);
            pack_both(y.world, next, base); /* back in time */
            pack_both(y.world, first, next);
            free(base.bytes);
            base = next;
        }
        free(first.bytes);
        free(base.bytes);
        thud_world_destroy(y.world);
    }
}

/* Motions that are no numbers, and infinite ones, have no bits that processors agree on. */
static void snapshot_with_wild_numbers_unpacks(void **state) {
    (void)state;
    thud_world *world = make_gas(6);
    run(world, 3);
    saved base = save(world), next = save(world);
    uint64_t seed = 5;
    for (size_t at = sizeof(td_snapshot_head) + 4000; at + 4 <= next.size; at += 44) {
        const uint32_t wild[] = {0x7fc00000u, 0xff800000u, 0x7f800001u, 0x7f7fffffu, UINT32_MAX};
        memcpy(next.bytes + at, &wild[(int)random_in(&seed, 0, 4.9)], 4);
    }
    uint64_t sum = td_snapshot_checksum(next.bytes + TD_SNAPSHOT_SUMMED_FROM,
                                        next.size - TD_SNAPSHOT_SUMMED_FROM);
    memcpy(next.bytes + offsetof(td_snapshot_head, checksum), &sum, sizeof sum);
    pack_both(world, base, next);
    pack_both(world, next, base);
    free(base.bytes);
    free(next.bytes);
    thud_world_destroy(world);
}

/* ---- refusals ---- */

/* A world with a log, a base, a snapshot, and what is packed. */
typedef struct ready {
    yard y;
    saved base, snapshot, packed;
    char *out; /* room for the snapshot, filled with 7 */
    int asked; /* calls of the prologue */
} ready;

static ready make_ready(void) {
    thud_world_def def = telling();
    ready r = {.y = make_yard(&def)};
    run(r.y.world, 30);
    r.base = save(r.y.world);
    run(r.y.world, 1);
    r.snapshot = save(r.y.world);
    r.packed = pack(r.y.world, as_bytes(r.base), r.snapshot);
    r.out = malloc(r.snapshot.size);
    memset(r.out, 7, r.snapshot.size);
    return r;
}

static void end(ready *r) {
    thud_world_destroy(r->y.world);
    free(r->base.bytes);
    free(r->snapshot.bytes);
    free(r->packed.bytes);
    free(r->out);
}

/* Asserts a result with a message that contains `word`, and that nothing was written. */
static void says(ready *r, thud_result result, thud_result expected, const char *word,
                 size_t bytes) {
    if (result != expected || !strstr(told, word) || bytes != 7) {
        fail_msg("%d, '%s', not %d, '%s'; %zu", (int)result, told, (int)expected, word, bytes);
    }
    for (size_t i = 0; i < r->snapshot.size; i++) {
        assert_int_equal(r->out[i], 7);
    }
    told[0] = 0;
}

static void pack_says(ready *r, thud_bytes base, thud_bytes snapshot, size_t capacity,
                      const char *word) {
    size_t bytes = 7;
    thud_result result = thud_world_pack(r->y.world, base, snapshot, r->out, capacity, &bytes);
    says(r, result, THUD_ERROR_INVALID, word, bytes);
}

static void unpack_says(ready *r, thud_bytes base, thud_bytes packed, size_t capacity,
                        const char *word) {
    size_t bytes = 7;
    thud_result result = thud_world_unpack(r->y.world, base, packed, r->out, capacity, &bytes);
    says(r, result, THUD_ERROR_INVALID, word, bytes);
}

static void every_damage_is_refused_and_nothing_written(void **state) {
    (void)state;
    ready r = make_ready();
    thud_bytes base = as_bytes(r.base), packed = as_bytes(r.packed);
    size_t room = r.snapshot.size;
    for (size_t i = 0; i < r.packed.size; i++) {
        r.packed.bytes[i] ^= (char)(1 << i % 8);
        unpack_says(&r, base, packed, room, "unpack: ");
        r.packed.bytes[i] ^= (char)(1 << i % 8);
    }
    for (size_t i = 0; i < r.base.size; i += 37) {
        r.base.bytes[i] ^= 16;
        unpack_says(&r, base, packed, room, "not the base");
        pack_says(&r, base, as_bytes(r.snapshot), room, "no whole snapshot");
        pack_says(&r, as_bytes(r.snapshot), base, room, "no whole snapshot");
        r.base.bytes[i] ^= 16;
    }
    for (size_t size = 0; size < r.packed.size; size += 11) {
        unpack_says(&r, base, (thud_bytes){r.packed.bytes, size}, room,
                    size < 56 ? "too short" : "cut short");
    }
    unpack_says(&r, none, packed, room, "not the base");
    unpack_says(&r, as_bytes(r.snapshot), packed, room, "not the base");
    unpack_says(&r, base, as_bytes(r.snapshot), room, "no packed snapshot");
    unpack_says(&r, base, packed, room - 1, "too small");
    pack_says(&r, base, as_bytes(r.snapshot), r.packed.size - 1, "too small");
    pack_says(&r, base, packed, room, "no whole snapshot");
    pack_says(&r, base, (thud_bytes){r.snapshot.bytes, 9}, room, "no whole snapshot");
    unpacks(r.y.world, base, r.packed, r.snapshot); /* what was refused did no harm */
    end(&r);
}

/* Packed bytes of another version, with a correct checksum. */
static void another_version_is_refused(void **state) {
    (void)state;
    ready r = make_ready();
    enum { VERSION_AT = 16 };
    r.packed.bytes[VERSION_AT]++;
    uint64_t sum = td_snapshot_checksum(r.packed.bytes + VERSION_AT, r.packed.size - VERSION_AT);
    memcpy(r.packed.bytes + VERSION_AT - sizeof sum, &sum, sizeof sum);
    unpack_says(&r, as_bytes(r.base), as_bytes(r.packed), r.snapshot.size, "another version");
    end(&r);
}

static void null_arguments_are_refused(void **state) {
    (void)state;
    ready r = make_ready();
    thud_bytes base = as_bytes(r.base), now = as_bytes(r.snapshot), packed = as_bytes(r.packed);
    thud_bytes hollow = {NULL, 9};
    size_t bytes = 7, room = r.snapshot.size;
    const thud_world *w = r.y.world;
    const thud_result results[] = {
        thud_world_pack(NULL, base, now, r.out, room, &bytes),
        thud_world_pack(w, hollow, now, r.out, room, &bytes),
        thud_world_pack(w, base, hollow, r.out, room, &bytes),
        thud_world_pack(w, base, now, NULL, room, &bytes),
        thud_world_pack(w, base, now, r.out, room, NULL),
        thud_world_unpack(NULL, base, packed, r.out, room, &bytes),
        thud_world_unpack(w, hollow, packed, r.out, room, &bytes),
        thud_world_unpack(w, base, hollow, r.out, room, &bytes),
        thud_world_unpack(w, base, packed, NULL, room, &bytes),
        thud_world_unpack(w, base, packed, r.out, room, NULL),
    };
    for (size_t i = 0; i < sizeof results / sizeof *results; i++) {
        says(&r, results[i], THUD_ERROR_NULL, "", bytes);
    }
    end(&r);
}

/* A prologue that packs and unpacks. */
static bool try_inside(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    (void)contact, (void)settings;
    ready *r = context;
    size_t bytes = 7, room = r->snapshot.size;
    thud_result result =
        thud_world_pack(world, as_bytes(r->base), as_bytes(r->snapshot), r->out, room, &bytes);
    says(r, result, THUD_ERROR_LOCKED, "inside a callback", bytes);
    result = thud_world_unpack(world, as_bytes(r->base), as_bytes(r->packed), r->out, room, &bytes);
    says(r, result, THUD_ERROR_LOCKED, "inside a callback", bytes);
    r->asked++;
    return true;
}

/* Bytes with a correct checksum that no packing wrote: refused, or by chance taken, but nothing
 * beyond the buffer is written (the sanitizers see to that). */
static void forged_bytes_do_no_harm(void **state) {
    (void)state;
    ready r = make_ready();
    saved alone = pack(r.y.world, none, r.snapshot);
    uint64_t seed = 3;
    int refusals = 0;
    enum { ROUNDS = 3000, SUMMED_FROM = 16, HEAD = 56 };
    for (int round = 0; round < ROUNDS; round++) {
        saved from = round % 2 ? alone : r.packed;
        thud_bytes base = round % 2 ? none : as_bytes(r.base);
        size_t size = round % 5 ? from.size : (size_t)random_in(&seed, HEAD, (double)from.size);
        char *forged = malloc(size);
        memcpy(forged, from.bytes, size);
        for (int k = 0; k < 1 + round % 4; k++) {
            size_t first = round % 3 ? HEAD : SUMMED_FROM;
            forged[(size_t)random_in(&seed, (double)first, (double)size - 0.5)] =
                (char)(unsigned char)random_in(&seed, 0, 255);
        }
        uint64_t count = size, sum;
        memcpy(forged + SUMMED_FROM + sizeof count, &count, sizeof count); /* after the version */
        sum = td_snapshot_checksum(forged + SUMMED_FROM, size - SUMMED_FROM);
        memcpy(forged + SUMMED_FROM - sizeof sum, &sum, sizeof sum);
        size_t bytes;
        refusals += thud_world_unpack(r.y.world, base, (thud_bytes){forged, size}, r.out,
                                      r.snapshot.size, &bytes) != THUD_OK;
        free(forged);
    }
    print_message("%d of %d refused\n", refusals, ROUNDS);
    assert_true(refusals > ROUNDS * 9 / 10);
    unpacks(r.y.world, none, alone, r.snapshot);
    free(alone.bytes);
    end(&r);
}

static void calls_inside_callbacks_are_refused(void **state) {
    (void)state;
    ready r = make_ready();
    set_listeners(r.y.world, try_inside, NULL, &r);
    run(r.y.world, 60);
    assert_true(r.asked > 0);
    end(&r);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gas_and_heaps_pack_small),
        cmocka_unit_test(unpacked_bytes_are_those_that_were_packed),
        cmocka_unit_test(snapshot_with_wild_numbers_unpacks),
        cmocka_unit_test(every_damage_is_refused_and_nothing_written),
        cmocka_unit_test(another_version_is_refused),
        cmocka_unit_test(null_arguments_are_refused),
        cmocka_unit_test(calls_inside_callbacks_are_refused),
        cmocka_unit_test(forged_bytes_do_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
