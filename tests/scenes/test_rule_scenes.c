/* test_rule_scenes.c: the scenes of rules between kinds of shapes do what they are to show, at
 * every quality. */
#include "stage.h"

#include <thud/thud_rules.h>
#include <thud/thud_snapshot.h>

/* ---- planks ---- */

/* Walls and roof, the ice, the trampolines, then the planks, then balls and crates in turns. */
enum { LOWEST_PLANK = 5, PLANKS = 2, FIRST_LOOSE = LOWEST_PLANK + PLANKS };

typedef struct crossing {
    bool above; /* it has been clear of the plank on its upper side, and not left it sideways */
    bool below; /* the same of its lower side */
} crossing;

/* What became of bodies at the planks. */
typedef struct tally {
    int risen;          /* through a plank */
    int ahead, against; /* steps in which one that lay on a plank moved as its belt runs, or not */
} tally;

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

static void planks_let_rise_and_hold_and_carry_by_kind(void **state) {
    (void)state;
    enum { SIZE = 30 };
    for (int q = 0; q < QUALITIES; q++) {
        stage t = open_stage("planks", SIZE, q);
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
        assert_true(sum.risen > early.risen); /* trampolines throw them up again */
        assert_true(sum.ahead > 5000 && sum.ahead > 15 * sum.against);
        close_stage(&t);
    }
}

/* ---- all of them ---- */

static void restored_scene_goes_on_with_its_rules(void **state) {
    (void)state;
    static const char *const names[] = {"planks"};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        stage a = open_stage(names[n], 0, 1), b = open_stage(names[n], 0, 1);
        for (int i = 0; i < 300; i++)
            OK(scene_step_thud(&a.scene.fields, a.world));
        size_t size;
        OK(thud_world_snapshot_size(a.world, &size));
        void *bytes = malloc(size);
        OK(thud_world_snapshot(a.world, bytes, size, NULL));
        OK(thud_world_restore(b.world, bytes, size));
        free(bytes);
        for (int i = 0; i < 120; i++) {
            OK(scene_step_thud(&a.scene.fields, a.world));
            OK(scene_step_thud(&b.scene.fields, b.world));
        }
        assert_true(thud_world_hash(a.world) == thud_world_hash(b.world));
        close_stage(&a);
        close_stage(&b);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planks_let_rise_and_hold_and_carry_by_kind),
        cmocka_unit_test(restored_scene_goes_on_with_its_rules),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
