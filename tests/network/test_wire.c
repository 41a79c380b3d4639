/* test_wire.c: the simulated network (wire.h): what is sent arrives after its delay, in the shares
 * that were asked for, and the same again with the same seed. */
#include "wire.h"

#include "engine_support.h"

enum { SENT = 20000 };

/* What arrived of SENT datagrams, one each millisecond, which carry their numbers. */
typedef struct outcome {
    int copies[SENT];
    int delivered;
    double soonest, latest; /* ms from sending */
    uint64_t hash;          /* of numbers in the order of their arrival */
    wire_counts counts;
} outcome;

static outcome send_all(const wire_options *options) {
    outcome out = {.soonest = 1e9};
    wire *w = wire_create(options);
    assert_non_null(w);
    for (int now = 0; now < SENT + 1000; now++) {
        if (now < SENT) {
            assert_true(wire_send(w, 0, 1, now, &now, sizeof now));
        }
        unsigned char bytes[WIRE_BYTES_MAX];
        int number, from, count;
        assert_int_equal(wire_receive(w, 0, now, bytes, NULL), -1);
        while ((count = wire_receive(w, 1, now, bytes, &from)) >= 0) {
            assert_int_equal(count, sizeof number);
            assert_int_equal(from, 0);
            memcpy(&number, bytes, sizeof number);
            out.copies[number]++;
            out.delivered++;
            out.soonest = fmin(out.soonest, now - number);
            out.latest = fmax(out.latest, now - number);
            out.hash = out.hash * 31 + (uint64_t)number;
        }
    }
    out.counts = wire_counts_of(w);
    wire_destroy(w);
    return out;
}

static void a_steady_wire_delivers_all_in_order_after_its_delay(void **state) {
    (void)state;
    static outcome found;
    found = send_all(&(wire_options){.delay = 60, .seed = 1});
    assert_int_equal(found.delivered, SENT);
    assert_true(found.soonest == 60 && found.latest == 60);
    assert_true(found.counts.overtaken == 0 && found.counts.lost == 0);
    for (int i = 0; i < SENT; i++) {
        assert_int_equal(found.copies[i], 1);
    }
}

/* A share of SENT events that is off by this much has a chance of less than one in a million. */
static void near_share(double found, double share) {
    near_to(found / SENT, share, 5 * sqrt(share * (1 - share) / SENT));
}

static void shares_are_those_that_were_asked_for(void **state) {
    (void)state;
    static outcome found;
    found = send_all(&(wire_options){.delay = 30,
                                     .jitter = 40,
                                     .loss = 0.1,
                                     .duplicates = 0.05,
                                     .held = 0.08,
                                     .held_for = 50,
                                     .seed = 2});
    int lost = 0, twice = 0;
    for (int i = 0; i < SENT; i++) {
        lost += found.copies[i] == 0;
        twice += found.copies[i] == 2;
    }
    near_share(lost, 0.1);
    near_share(twice, 0.9 * 0.05);
    near_share((double)found.counts.held, 0.9 * 1.05 * 0.08);
    assert_true(found.soonest >= 30 && found.soonest <= 31);
    assert_true(found.latest > 110 && found.latest <= 121);
    assert_true(found.counts.overtaken > SENT / 4);
    assert_true(found.counts.sent == SENT && found.counts.lost == lost);
    assert_true(found.counts.duplicated == twice && found.counts.delivered == found.delivered);
}

static void a_seed_decides_everything(void **state) {
    (void)state;
    static outcome a, b, c;
    wire_options options = {.delay = 30, .jitter = 40, .loss = 0.1, .duplicates = 0.1, .seed = 3};
    a = send_all(&options);
    b = send_all(&options);
    options.seed = 4;
    c = send_all(&options);
    assert_true(a.hash == b.hash && a.delivered == b.delivered);
    assert_true(a.hash != c.hash);
}

static void what_is_on_its_way_to_a_player_is_cut(void **state) {
    (void)state;
    unsigned char bytes[WIRE_BYTES_MAX];
    wire *w = wire_create(&(wire_options){.delay = 5});
    assert_non_null(w);
    assert_true(wire_send(w, 0, 1, 0, "a", 1) && wire_send(w, 1, 2, 0, "b", 1) &&
                wire_send(w, 0, 2, 0, "c", 1));
    wire_cut(w, 1);
    assert_int_equal(wire_receive(w, 1, 9, bytes, NULL), -1);
    assert_int_equal(wire_receive(w, 2, 9, bytes, NULL), 1);
    assert_int_equal(bytes[0], 'c');
    assert_int_equal(wire_receive(w, 2, 9, bytes, NULL), -1);
    wire_destroy(w);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_steady_wire_delivers_all_in_order_after_its_delay),
        cmocka_unit_test(shares_are_those_that_were_asked_for),
        cmocka_unit_test(a_seed_decides_everything),
        cmocka_unit_test(what_is_on_its_way_to_a_player_is_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
