/* test_textures_kept.c: textures in snapshots (thud_textured.h): a restored world has those of the
 * time of its snapshot; a forged snapshot with invalid textures is refused. */
#include "textured_support.h"

#include "hostile_memory.h"
#include "refused_snapshot.h"

#include "api/snapshot.h"

static double uneven(double x) {
    return 0.5 + 0.4 * sin(x);
}

static double other(double x) {
    return 0.5 - 0.01 * x;
}

static thud_world_def def_of(int choice) {
    thud_world_def def = telling();
    def.detection = detections[choice % DETECTIONS];
    return def;
}

/* Three lines below each other, of which the outer two have a texture (one with a table) where it
 * is wanted, and bodies that slide over the upper one. */
static textured make(int choice, bool has_textures) {
    textured t = {.world = make_world(def_of(choice))}, lower = t;
    add_ground(&lower, THUD_TERRAIN_FLAT, 0, 0.5f);
    OK(thud_body_set_transform(t.world, lower.body, (thud_pos){0, -40}, 0));
    if (has_textures) {
        const double u[] = {0, 0.3};
        const float table[] = {0.1f, 0.9f, 0.4f};
        OK(thud_shape_set_texture(t.world, lower.shape, &(thud_texture){u, 2, table, 3, true}));
    }
    add_ground(&lower, THUD_TERRAIN_UNIFORM, 0, 0.5f);
    OK(thud_body_set_transform(t.world, lower.body, (thud_pos){0, -80}, 0));
    add_ground(&t, THUD_TERRAIN_IRREGULAR, 0, 0.5f);
    if (has_textures) {
        set_friction(&t, uneven);
    }
    for (int i = 0; i < 10; i++) {
        thud_body_id body = add_body(t.world, THUD_BODY_DYNAMIC, 3 * i - 20, 0.5, 0);
        add_shape(t.world, body, 0.4f, i % 3 ? 0.3f : 0, false, NULL);
        OK(thud_body_set_velocity(t.world, body, (thud_vec2){9, -5}, 0));
    }
    return t;
}

/* Asserts that both worlds stay equal for 200 steps. */
static void go_alike(thud_world *a, thud_world *b) {
    for (int i = 0; i < 200; i++) {
        run(a, 1);
        run(b, 1);
        if (thud_hash_of(a) != thud_hash_of(b)) {
            fail_msg("differs %d steps after the snapshot", i + 1);
        }
    }
}

/* After the snapshot the texture changes, the line is dug, and the shape with the other texture is
 * destroyed. */
static void restored_world_has_the_textures_of_then(void **state) {
    (void)state;
    for (int choice = 0; choice < DETECTIONS; choice++) {
        textured never = make(choice, true), t = make(choice, true);
        run(never.world, 10);
        run(t.world, 10);
        saved s = save(t.world);
        set_friction(&t, other);
        OK(thud_shape_dig(t.world, t.shape, (thud_pos){0, 0}, 2));
        run(t.world, 10);
        OK(thud_shape_destroy(t.world, t.shape));
        run(t.world, 10);
        back_to(t.world, s);
        assert_true(friction_of(&t, 1) == friction_of(&never, 1));
        go_alike(never.world, t.world);
        thud_world_destroy(never.world);
        thud_world_destroy(t.world);
        free(s.bytes);
    }
}

static void another_world_takes_the_textures_over(void **state) {
    (void)state;
    for (int choice = 0; choice < 2 * DETECTIONS; choice++) {
        textured t = make(choice, true);
        thud_world *w = make_world(def_of(choice));
        if (choice % 2) {
            textured own = {.world = w};
            add_ground(&own, THUD_TERRAIN_UNIFORM, 0, 0.5f);
            set_friction(&own, other);
            run(w, 3);
        } else {
            OK(thud_world_use_textures(w));
            OK(thud_world_use_textures(w));
        }
        run(t.world, 10);
        saved s = save(t.world);
        back_to(w, s);
        saved again = save(w);
        assert_int_equal(s.size, again.size);
        assert_memory_equal(s.bytes, again.bytes, s.size);
        go_alike(t.world, w);
        thud_world_destroy(t.world);
        thud_world_destroy(w);
        free(s.bytes);
        free(again.bytes);
    }
}

static void snapshot_without_textures_takes_them_away(void **state) {
    (void)state;
    for (int choice = 0; choice < DETECTIONS; choice++) {
        textured never = make(choice, false), t = make(choice, false);
        run(never.world, 10);
        run(t.world, 10);
        saved s = save(t.world);
        set_friction(&t, uneven);
        run(t.world, 10);
        back_to(t.world, s);
        saved again = save(t.world);
        assert_int_equal(s.size, again.size);
        go_alike(never.world, t.world);
        thud_world_destroy(never.world);
        thud_world_destroy(t.world);
        free(s.bytes);
        free(again.bytes);
    }
}

static void world_that_never_had_textures_refuses_some(void **state) {
    (void)state;
    textured t = make(0, true), plain = make(0, false);
    run(t.world, 10);
    saved s = save(t.world);
    refused(plain.world, s.bytes, s.size, "has textures");
    OK(thud_world_use_textures(plain.world));
    back_to(plain.world, s);
    go_alike(t.world, plain.world);
    thud_world_destroy(t.world);
    thud_world_destroy(plain.world);
    free(s.bytes);
}

/* A snapshot with bytes changed and a valid checksum. */
static void forge(saved s, char *forged, size_t at, const void *value, size_t bytes) {
    memcpy(forged, s.bytes, s.size);
    memcpy(forged + at, value, bytes);
    size_t summed = offsetof(td_snapshot_head, bytes);
    uint64_t sum = td_snapshot_checksum(forged + summed, s.size - summed);
    memcpy(forged + offsetof(td_snapshot_head, checksum), &sum, sizeof sum);
}

static void textures_out_of_range_are_refused(void **state) {
    (void)state;
    const double values[] = {-1, 1e7, __builtin_nan("")}, coordinates[] = {2e9, __builtin_inf()};
    const float entries[] = {-1, 1e7f, __builtin_nanf("")};
    textured t = make(0, true);
    run(t.world, 10);
    saved s = save(t.world);
    trail next = walk(t.world, 20);
    back_to(t.world, s);
    td_snapshot_head head;
    memcpy(&head, s.bytes, sizeof head);
    size_t first = sizeof head + (size_t)td_snapshot_textured_at(&head);
    size_t second = first + 16 + 2 * sizeof(double) + 3 * sizeof(float);
    assert_int_equal(second + 16 + VERTICES * sizeof(double), s.size);
    char *forged = malloc(s.size);
    const struct {
        size_t at, bytes;
        const void *value;
    } changes[] = {{second + 16, 8, &values[0]},     {second + 16, 8, &values[1]},
                   {s.size - 8, 8, &values[2]},      {first + 16, 8, &coordinates[0]},
                   {first + 24, 8, &coordinates[1]}, {second - 12, 4, &entries[0]},
                   {second - 8, 4, &entries[1]},     {second - 4, 4, &entries[2]}};
    for (size_t i = 0; i < sizeof changes / sizeof *changes; i++) {
        forge(s, forged, changes[i].at, changes[i].value, changes[i].bytes);
        refused(t.world, forged, s.size, "contradicts itself");
    }
    /* The four numbers of each head: terrain, vertices, entries, repeats. */
    for (int field = 0; field < 8; field++) {
        size_t at = (field < 4 ? first : second) + 4 * (size_t)(field % 4);
        int32_t was;
        memcpy(&was, s.bytes + at, sizeof was);
        for (int k = 0; k < 4; k++) {
            const int32_t odd[] = {-1, INT32_MAX, INT32_MIN, was + 3};
            forge(s, forged, at, &odd[k], sizeof *odd);
            refused(t.world, forged, s.size, "contradicts itself");
        }
    }
    for (uint64_t bytes = 0; bytes < 3000; bytes++) {
        if (bytes != head.textured) {
            forge(s, forged, offsetof(td_snapshot_head, textured), &bytes, sizeof bytes);
            refused(t.world, forged, s.size, "contradicts itself");
        }
    }
    /* One vertex and two entries more take as many bytes, but the line has two vertices. */
    const int32_t fewer[] = {1, 5};
    forge(s, forged, first + 4, fewer, sizeof fewer);
    refused(t.world, forged, s.size, "contradicts itself");
    /* A size that wraps around, with a list that is longer by as much. */
    td_snapshot_head wrong = head;
    int more = (int)(head.textured / sizeof(td_deferred_edit)) + 2;
    wrong.parts[TD_SNAPSHOT_DEFERRED].used += more;
    wrong.textured -= (uint64_t)more * sizeof(td_deferred_edit);
    assert_true(wrong.textured > head.bytes);
    forge(s, forged, 0, &wrong, sizeof wrong);
    refused(t.world, forged, s.size, "contradicts itself");
    walks_again(t.world, &next, "forged");
    free(forged);
    free(s.bytes);
    thud_world_destroy(t.world);
}

static void without_memory_textures_stay_as_they_were(void **state) {
    (void)state;
    textured from = make(0, true);
    run(from.world, 10);
    saved s = save(from.world);
    thud_result result = THUD_ERROR_MEMORY;
    for (long allowed = 0; result != THUD_OK; allowed++) {
        thud_world_def def = def_of(0);
        def.allocator = hostile_memory();
        memory_allowed = -1;
        memory_held = 0;
        textured t = {.world = make_world(def)};
        memory_allowed = 0;
        assert_int_equal(thud_world_use_textures(t.world), THUD_ERROR_MEMORY);
        memory_allowed = -1;
        add_ground(&t, THUD_TERRAIN_FLAT, 0, 0.5f);
        set_friction(&t, other);
        memory_allowed = allowed;
        result = thud_world_restore(t.world, s.bytes, s.size);
        memory_allowed = -1;
        assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
        if (result == THUD_OK) {
            assert_true(friction_of(&from, 1) ==
                        friction_of(&(textured){.world = t.world, .shape = from.shape}, 1));
        } else {
            near_to((double)friction_of(&t, 20), other(20), 1e-6);
            run(t.world, 2);
        }
        thud_world_destroy(t.world);
        assert_int_equal(memory_held, 0);
    }
    thud_world_destroy(from.world);
    free(s.bytes);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_world_has_the_textures_of_then),
        cmocka_unit_test(another_world_takes_the_textures_over),
        cmocka_unit_test(snapshot_without_textures_takes_them_away),
        cmocka_unit_test(world_that_never_had_textures_refuses_some),
        cmocka_unit_test(textures_out_of_range_are_refused),
        cmocka_unit_test(without_memory_textures_stay_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
