/* test_rule_scenes.c: at every quality, the scenes of collision rules behave as their descriptions
 * say: one-way planks hold and carry, crates break at their impulse limit, kinds of bodies collide
 * by the timetable. */
#include "stage.h"

#include <thud/thud_lists.h>
#include <thud/thud_rules.h>

/* ---- planks ---- */

/* Order of bodies in the scene: walls and roof, ice, trampolines, planks, then balls and crates
 * alternately. */
enum { LOWEST_PLANK = 5, PLANKS = 2, FIRST_LOOSE = LOWEST_PLANK + PLANKS };

/* What is known of a body at a plank. */
typedef struct crossing {
    bool above; /* since it was last beside the plank, it has been completely above it */
    bool below; /* and completely below it */
} crossing;

/* What bodies did at the planks. */
typedef struct tally {
    int risen;          /* passages through a plank, upward */
    int ahead, against; /* steps in which a body on a plank moved with its belt, or against it */
} tally;

/* Updates what is known of a body at a plank; fails where it sinks through. */
static void look_at(const stage *t, int plank, int index, crossing *c, tally *sum) {
    const scene *s = &t->scene;
    const scene_shape *board = &s->shapes[s->bodies[LOWEST_PLANK + plank].first_shape];
    double top = s->bodies[LOWEST_PLANK + plank].y + board->hy;
    thud_body_state b = body(t, index);
    bool ball = s->shapes[s->bodies[index].first_shape].kind == SCENE_CIRCLE;
    double reach = ball ? 0.35 : 0.5;
    if (fabs(b.position.x) > board->hx - 0.5) {
        *c = (crossing){false, false};
        return;
    }
    if (c->above && b.position.y < top)
        fail_msg("body %d sank through plank %d at x = %g", index, plank, b.position.x);
    bool above = b.position.y > top + reach, below = b.position.y < top - 2 * board->hy - reach;
    if (above && c->below)
        sum->risen++;
    c->below = below || (c->below && !above);
    c->above = above || c->above;
    if (c->above && b.position.y < top + reach && fabs((double)b.velocity.y) < 0.1) {
        double speed = (double)b.velocity.x * (ball ? 1 : -1);
        sum->ahead += speed > 0.2;
        sum->against += speed < -0.2;
    }
}

/* Bodies rise through planks and never sink through, and belts carry balls and crates in opposite
 * directions. */
static void planks_let_rise_and_hold_and_carry_by_kind(void **state) {
    (void)state;
    enum { SIZE = 30 };
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("planks", SIZE, qualities[q]);
        crossing crossings[SIZE][PLANKS] = {0};
        tally sum = {0}, early = {0};
        for (int step = 0; step < 1800; step++) {
            run_whole(&t, 1);
            for (int i = 0; i < SIZE; i++)
                for (int p = 0; p < PLANKS; p++)
                    look_at(&t, p, FIRST_LOOSE + i, &crossings[i][p], &sum);
            if (step == 120)
                early = sum;
        }
        assert_true(early.risen >= 25);
        assert_true(sum.risen > early.risen); /* trampolines threw bodies through planks again */
        assert_true(sum.ahead > 5000 && sum.ahead > 15 * sum.against);
        close_stage(&t);
    }
}

/* ---- crates ---- */

static int body_count(const stage *t) {
    int count;
    OK(thud_world_get_bodies(t->world, NULL, 0, &count));
    return count;
}

/* Mass of all dynamic bodies in kg; asserts that each is finite and within the scene. */
static double whole_mass(const stage *t) {
    thud_body_id ids[400];
    int count;
    double sum = 0;
    OK(thud_world_get_bodies(t->world, ids, 400, &count));
    for (int i = 0; i < count; i++) {
        thud_body_state b = state_of(t->world, ids[i]);
        assert_true(isfinite(b.position.x) && fabs(b.position.x) < 30);
        assert_true(isfinite(b.position.y) && b.position.y >= -0.5);
        if (b.kind == THUD_BODY_DYNAMIC)
            sum += (double)b.mass;
    }
    return sum;
}

static void crates_break_into_four_by_the_impulses_that_reached_their_limit(void **state) {
    (void)state;
    enum { CRATES = 36, FIRST = 3, LANDING = 40, STACK = 4 };
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("crates", CRATES, qualities[q]);
        const float most = (float)t.scene.fields.rules[0].event_impulse;
        double mass = whole_mass(&t);
        int breaking = 0;
        for (int step = 0; step < 900; step++) {
            int before = body_count(&t), events, whole = 0;
            OK(scene_step_thud(&t.scene.fields, t.world));
            const thud_impulse_event *e = thud_impulse_events_of(t.world, &events);
            for (int i = 0; i < events; i++)
                assert_true(e[i].impulse > most);
            for (int i = 0; i < CRATES; i++)
                whole += thud_body_is_valid(t.world, t.bodies[FIRST + i]);
            int now = body_count(&t);
            assert_int_equal(now, t.scene.body_count + 3 * (CRATES - whole));
            assert_true(events > 0 || now == before);
            assert_true(step > LANDING || whole == CRATES); /* the stacks carry their own weight */
            breaking += now > before;
        }
        /* Each of the three weights broke a crate of the stack that it fell onto, and the stacks
         * between them stand. */
        assert_true(breaking >= 3);
        for (int stack = 0; stack < CRATES / STACK; stack += 3)
            assert_false(thud_body_is_valid(t.world, t.bodies[FIRST + STACK * stack + STACK - 1]));
        int whole = 0;
        for (int i = 0; i < CRATES; i++)
            whole += thud_body_is_valid(t.world, t.bodies[FIRST + i]);
        assert_true(whole >= CRATES / 6);
        assert_true(fabs(whole_mass(&t) - mass) < 1e-3 * mass);
        close_stage(&t);
    }
}

/* ---- meetings ---- */

/* How bodies of kinds a and b meet by the present rules. */
static thud_rule_kind rule_kind_of(const stage *t, int a, int b) {
    thud_rule rule;
    OK(thud_world_get_rule(t->world, 2u << a, 2u << b, &rule, NULL, NULL));
    return rule.kind;
}

/* Pairs of bodies, one of each kind, whose centres are nearer than 0.5 m, less than the width of
 * the thinner one. */
static int overlaps(const stage *t, int a, int b) {
    int count = 0;
    for (int i = 1 + a; i < t->scene.body_count; i += 4)
        for (int k = 1 + b; k < t->scene.body_count; k += 4) {
            thud_pos p = body(t, i).position, q = body(t, k).position;
            count += i != k && hypot(p.x - q.x, p.y - q.y) < 0.5;
        }
    return count;
}

static void kinds_meet_by_the_timetable(void **state) {
    (void)state;
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("meetings", 100, qualities[q]);
        assert_int_equal(rule_kind_of(&t, 0, 1), THUD_RULE_IGNORE);
        assert_int_equal(rule_kind_of(&t, 2, 3), THUD_RULE_ONE_WAY);
        run_whole(&t, 61);
        assert_int_equal(rule_kind_of(&t, 0, 1), THUD_RULE_COLLIDE);
        assert_int_equal(rule_kind_of(&t, 0, 2), THUD_RULE_IGNORE);
        assert_int_equal(rule_kind_of(&t, 1, 1), THUD_RULE_COLLIDE);
        run_whole(&t, 30);
        assert_int_equal(rule_kind_of(&t, 1, 1), THUD_RULE_IGNORE);
        run_whole(&t, 600);
        assert_int_equal(rule_kind_of(&t, 2, 3), THUD_RULE_COLLIDE);
        assert_int_equal(rule_kind_of(&t, 1, 3), THUD_RULE_ONE_WAY);
        /* Bodies of kinds that ignore each other overlap, those of kinds that collide do not. */
        int apart = overlaps(&t, 0, 1) + overlaps(&t, 0, 3) + overlaps(&t, 1, 2) +
                    overlaps(&t, 2, 3) + overlaps(&t, 0, 0) + overlaps(&t, 2, 2);
        if (overlaps(&t, 0, 2) < 10 || overlaps(&t, 1, 1) < 10 || apart > 6)
            fail_msg("quality %d: %d and %d overlap, %d do not", q, overlaps(&t, 0, 2),
                     overlaps(&t, 1, 1), apart);
        close_stage(&t);
    }
}

/* ---- all scenes of rules ---- */

static void restored_scene_goes_on_with_its_rules(void **state) {
    (void)state;
    static const char *const names[] = {"planks", "crates", "meetings"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++)
        restored_goes_on(names[n], 55, 120);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planks_let_rise_and_hold_and_carry_by_kind),
        cmocka_unit_test(crates_break_into_four_by_the_impulses_that_reached_their_limit),
        cmocka_unit_test(kinds_meet_by_the_timetable),
        cmocka_unit_test(restored_scene_goes_on_with_its_rules),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
