/* test_kept_rules.c: collision rules in snapshots: a restored world has the rules of the time of
 * its snapshot; a forged snapshot with invalid rules is refused. */
#include "rules_support.h"
#include "refused_snapshot.h"

#include "hostile_memory.h"

#include "api/snapshot.h"

static thud_world_def def_of(int choice) {
    thud_world_def def = telling();
    def.detection = detections[choice % DETECTIONS];
    def.broadphase = broadphases[choice % BROADPHASES];
    return def;
}

/* An empty world of one of the detections and broadphases. */
static thud_world *bare(int choice) {
    return make_world(def_of(choice));
}

static void set(thud_world *w, uint32_t first, uint32_t second, const thud_rule *rule) {
    OK(thud_world_set_rule(w, first, second, rule));
}

/* Sets rules of all kinds: belts, bounces, one-way planks, categories that ignore each other, and
 * impulse limits. */
static void set_rules(thud_world *w) {
    thud_rule belt = thud_default_rule(), plank = rule_of_kind(THUD_RULE_ONE_WAY), ball = belt;
    thud_rule ignore = rule_of_kind(THUD_RULE_IGNORE);
    belt.surface_speed = 2;
    belt.friction = 0.9f;
    belt.event_impulse = 4;
    plank.solid_side = (thud_vec2){0.1f, 2};
    ball.restitution = 0.8f;
    set(w, GROUND, CRATE, &belt);
    set(w, CRATE, PLANK, &ignore);
    set(w, PLAYER, PLAYER | GROUND, &ball);
    set(w, PLANK, PLAYER, &plank);
}

/* Sets rules that differ as much as possible, also for pairs that had none. */
static void change_rules(thud_world *w) {
    thud_rule other = rule_of_kind(THUD_RULE_ONE_WAY), ignore = rule_of_kind(THUD_RULE_IGNORE);
    other.solid_side = (thud_vec2){1, 0};
    other.friction = 0;
    other.event_impulse = 0.5f;
    set(w, GROUND, CRATE, NULL);
    set(w, CRATE, PLANK, &other);
    set(w, PLAYER, GROUND, &ignore);
    set(w, PLAYER, PLAYER, NULL);
    set(w, PLAYER, PLANK, &other);
    set(w, CRATE, CRATE, &ignore);
    set(w, 1u << 31, UINT32_MAX >> 1, &other);
}

/* Crates and bouncing players around two planks. */
static thud_world *make_pile(int choice, bool with_rules) {
    thud_world *w = bare(choice);
    if (with_rules) {
        set_rules(w);
    }
    add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 12, 1);
    add(w, THUD_BODY_STATIC, PLANK, 2, -2, 2, 3, 0.1f);
    add(w, THUD_BODY_STATIC, PLANK, 1, 3, 3, 2, 0.1f);
    for (int i = 0; i < 24; i++) {
        uint32_t kind = i % 2 ? PLAYER : CRATE;
        thud_body_id body = add(w, THUD_BODY_DYNAMIC, kind, i % 3, i % 6 - 3, 1.0 + i, 0.4f, 0.4f);
        throw_up(w, body, (float)(i % 5) - 2, (float)(i % 7));
    }
    return w;
}

/* Asserts that both worlds have the same rules for all pairs of categories. */
static void same_rules(thud_world *a, thud_world *b) {
    for (int i = 0; i < 32 * 32; i++) {
        thud_rule rule[2];
        bool is_set[2], reversed[2];
        OK(thud_world_get_rule(a, 1u << i / 32, 1u << i % 32, &rule[0], &is_set[0], &reversed[0]));
        OK(thud_world_get_rule(b, 1u << i / 32, 1u << i % 32, &rule[1], &is_set[1], &reversed[1]));
        assert_true(is_set[0] == is_set[1] && reversed[0] == reversed[1]);
        assert_memory_equal(&rule[0], &rule[1], sizeof *rule);
    }
}

/* Asserts that both worlds had the same impulse events; returns their number. */
static int same_impulses(thud_world *a, thud_world *b) {
    int count[2];
    const thud_impulse_event *one = thud_impulse_events_of(a, &count[0]);
    const thud_impulse_event *two = thud_impulse_events_of(b, &count[1]);
    assert_int_equal(count[0], count[1]);
    for (int i = 0; i < count[0]; i++) {
        assert_int_equal(one[i].shape_a.index1, two[i].shape_a.index1);
        assert_int_equal(one[i].shape_b.index1, two[i].shape_b.index1);
        assert_true(one[i].point.x == two[i].point.x && one[i].point.y == two[i].point.y);
        assert_true(one[i].impulse == two[i].impulse);
    }
    return count[0];
}

/* Asserts that both worlds stay equal for 300 steps; returns how many impulse events there were. */
static int go_alike(thud_world *a, thud_world *b) {
    int impulses = same_impulses(a, b);
    same_rules(a, b);
    for (int i = 0; i < 300; i++) {
        OK(thud_world_step(a));
        OK(thud_world_step(b));
        if (thud_hash_of(a) != thud_hash_of(b)) {
            fail_msg("differs %d steps after the snapshot", i + 1);
        }
        assert_int_equal(thud_events_of(a).begin_count, thud_events_of(b).begin_count);
        impulses += same_impulses(a, b);
    }
    return impulses;
}

static void restored_world_goes_by_the_rules_of_then(void **unused) {
    (void)unused;
    for (int choice = 0; choice < DETECTIONS * BROADPHASES; choice++) {
        thud_world *never = make_pile(choice, true), *w = make_pile(choice, true);
        steps(never, 70 + choice);
        steps(w, 70 + choice);
        saved s = save(w);
        change_rules(w);
        steps(w, 50);
        back_to(w, s);
        assert_true(go_alike(never, w) > 0);
        thud_world_destroy(never);
        thud_world_destroy(w);
        free(s.bytes);
    }
}

/* The snapshot is restored into a new world, and into one that had other rules. */
static void another_world_takes_the_rules_over(void **unused) {
    (void)unused;
    for (int choice = 0; choice < 2 * DETECTIONS; choice++) {
        thud_world *w = make_pile(choice, true), *other = bare(choice);
        if (choice % 2) {
            change_rules(other);
            add(other, THUD_BODY_DYNAMIC, CRATE, 2, 0, 0, 1, 1);
            steps(other, 3);
        } else {
            OK(thud_world_use_rules(other));
        }
        steps(w, 40 + choice);
        saved s = save(w);
        back_to(other, s);
        saved again = save(other);
        assert_int_equal(s.size, again.size);
        assert_true(go_alike(w, other) > 0);
        thud_world_destroy(w);
        thud_world_destroy(other);
        free(s.bytes);
        free(again.bytes);
    }
}

static void snapshot_without_rules_takes_them_away(void **unused) {
    (void)unused;
    for (int choice = 0; choice < DETECTIONS; choice++) {
        thud_world *never = make_pile(choice, false), *w = make_pile(choice, false);
        steps(never, 60);
        steps(w, 60);
        saved s = save(w);
        set_rules(w);
        steps(w, 60);
        back_to(w, s);
        assert_int_equal(go_alike(never, w), 0);
        thud_world_destroy(never);
        thud_world_destroy(w);
        free(s.bytes);
    }
}

/* Rules enlarge a snapshot by one record for each pair of categories with a rule, and by nothing
 * else. */
static void snapshot_is_longer_by_what_is_set_alone(void **unused) {
    (void)unused;
    thud_world *w = bare(0);
    size_t none, one, gone;
    thud_rule ignore = rule_of_kind(THUD_RULE_IGNORE);
    OK(thud_world_get_snapshot_size(w, &none));
    set(w, CRATE | PLAYER, CRATE | PLAYER, &ignore); /* three pairs of categories */
    OK(thud_world_get_snapshot_size(w, &one));
    assert_int_equal(one - none, 3 * sizeof(td_kept_rule));
    set(w, UINT32_MAX, UINT32_MAX, &ignore);
    OK(thud_world_get_snapshot_size(w, &one));
    assert_int_equal(one - none, TD_RULES_MAX * sizeof(td_kept_rule));
    saved s = save(w);
    set(w, UINT32_MAX, UINT32_MAX, NULL);
    OK(thud_world_get_snapshot_size(w, &gone));
    assert_int_equal(gone, none);
    back_to(w, s);
    OK(thud_world_get_snapshot_size(w, &gone));
    assert_int_equal(gone, one);
    thud_world_destroy(w);
    free(s.bytes);
}

static bool none_meets(const thud_world *world, thud_shape_id a, thud_shape_id b, void *context) {
    (void)world, (void)a, (void)b, (void)context;
    return false;
}

/* The filter's answers about existing pairs stay valid until it is set again. */
static void filter_stays_as_the_world_has_it(void **unused) {
    (void)unused;
    thud_world *w = bare(0);
    add(w, THUD_BODY_STATIC, GROUND, 2, 0, -1, 20, 1);
    thud_body_id crate = add(w, THUD_BODY_DYNAMIC, CRATE, 2, 0, 4, 0.5f, 0.5f);
    saved s = save(w);
    OK(thud_world_set_filter(w, none_meets, NULL));
    steps(w, 10);
    back_to(w, s);
    steps(w, 120);
    assert_true(get(w, crate).position.y < -2);
    thud_world_destroy(w);
    free(s.bytes);
}

/* ---- refused ---- */

/* A world that never had rules refuses a snapshot with rules; after thud_world_use_rules it
 * restores it. */
static void world_that_never_had_rules_refuses_some(void **unused) {
    (void)unused;
    thud_world *w = make_pile(0, true), *other = make_pile(0, false);
    steps(w, 20);
    saved s = save(w);
    refused(other, s.bytes, s.size, "has rules");
    assert_int_equal(thud_world_use_rules(NULL), THUD_ERROR_NULL);
    OK(thud_world_use_rules(other));
    OK(thud_world_use_rules(other));
    back_to(other, s);
    go_alike(w, other);
    thud_world_destroy(w);
    thud_world_destroy(other);
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

static void rules_out_of_range_are_refused(void **unused) {
    (void)unused;
    const float beyond[] = {-1, 1e9f, __builtin_inff(), -__builtin_inff()};
    const int32_t cells[] = {-1, TD_RULE_KINDS * TD_RULE_KINDS, INT32_MAX, INT32_MIN, 0};
    const int32_t kinds[] = {-1, THUD_RULE_KIND_COUNT, INT32_MAX};
    const size_t floats[] = {offsetof(thud_rule, friction), offsetof(thud_rule, restitution)};
    thud_world *w = make_pile(0, true);
    steps(w, 60);
    saved s = save(w);
    trail next = walk(w, 20);
    back_to(w, s);
    td_snapshot_head head;
    memcpy(&head, s.bytes, sizeof head);
    assert_int_equal(head.ruled.rules, 5);
    size_t first = sizeof head + (size_t)td_snapshot_ruled_at(&head);
    char *forged = malloc(s.size);
    for (int i = 1; i < head.ruled.rules; i++) {
        size_t rule = first + (size_t)i * sizeof(td_kept_rule);
        for (size_t k = 0; k < sizeof cells / sizeof *cells; k++) {
            forge(s, forged, rule + offsetof(td_kept_rule, cell), &cells[k], sizeof *cells);
            refused(w, forged, s.size, "contradicts itself");
        }
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
            forge(s, forged, rule + offsetof(thud_rule, kind), &kinds[k], sizeof *kinds);
            refused(w, forged, s.size, "contradicts itself");
        }
        for (size_t k = 0; k < sizeof beyond / sizeof *beyond; k++) {
            for (size_t f = 0; f < sizeof floats / sizeof *floats; f++) {
                forge(s, forged, rule + floats[f], &beyond[k], sizeof *beyond);
                refused(w, forged, s.size, "contradicts itself");
            }
        }
        const thud_vec2 sides[] = {{0, 0}, {__builtin_nanf(""), 1}, {1, __builtin_inff()}};
        for (size_t k = 0; k < sizeof sides / sizeof *sides; k++) {
            forge(s, forged, rule + offsetof(thud_rule, solid_side), &sides[k], sizeof *sides);
            refused(w, forged, s.size, "contradicts itself");
        }
        forge(s, forged, rule + offsetof(thud_rule, surface_speed), &beyond[2], sizeof *beyond);
        refused(w, forged, s.size, "contradicts itself");
        forge(s, forged, rule + offsetof(thud_rule, event_impulse), &beyond[0], sizeof *beyond);
        refused(w, forged, s.size, "contradicts itself");
    }
    for (int32_t count = -2; count < 700; count++) {
        forge(s, forged, offsetof(td_snapshot_head, ruled.rules), &count, sizeof count);
        if (count != head.ruled.rules) {
            refused(w, forged, s.size, "contradicts itself");
        }
        forge(s, forged, offsetof(td_snapshot_head, ruled.impulses), &count, sizeof count);
        if (count != head.ruled.impulses) {
            refused(w, forged, s.size, "contradicts itself");
        }
    }
    walks_again(w, &next, "forged");
    free(forged);
    free(s.bytes);
    thud_world_destroy(w);
}

static void without_memory_rules_stay_as_they_were(void **unused) {
    (void)unused;
    thud_world_def def = def_of(0);
    thud_world *from = make_pile(0, true), *twin = bare(0);
    saved s = {NULL, 0};
    for (int count = 0; count == 0;) {
        steps(from, 1);
        thud_impulse_events_of(from, &count);
    }
    s = save(from);
    change_rules(twin);
    def.allocator = hostile_memory();
    memory_held = 0;
    thud_result result = THUD_ERROR_MEMORY;
    for (long allowed = 0; result != THUD_OK; allowed++) {
        thud_world *w = make_world(def);
        memory_allowed = 0;
        assert_int_equal(thud_world_use_rules(w), THUD_ERROR_MEMORY);
        memory_allowed = -1;
        change_rules(w);
        memory_allowed = allowed;
        result = thud_world_restore(w, s.bytes, s.size);
        memory_allowed = -1;
        same_rules(w, result == THUD_OK ? from : twin);
        assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
        if (result == THUD_OK) {
            assert_true(same_impulses(w, from) > 0);
        }
        thud_world_destroy(w);
        assert_int_equal(memory_held, 0);
    }
    thud_world_destroy(from);
    thud_world_destroy(twin);
    free(s.bytes);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(restored_world_goes_by_the_rules_of_then),
        cmocka_unit_test(another_world_takes_the_rules_over),
        cmocka_unit_test(snapshot_without_rules_takes_them_away),
        cmocka_unit_test(snapshot_is_longer_by_what_is_set_alone),
        cmocka_unit_test(filter_stays_as_the_world_has_it),
        cmocka_unit_test(world_that_never_had_rules_refuses_some),
        cmocka_unit_test(rules_out_of_range_are_refused),
        cmocka_unit_test(without_memory_rules_stay_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
