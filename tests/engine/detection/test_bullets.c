/* test_bullets.c: swept bullets hit light walls, which then rotate and hit others: nothing passes
 * through anything, and bodies in contact with a rotating wall do not sink into it. And bodies that
 * are not swept must not pass through swept ones. */
#include "engine_support.h"

enum { BULLETS = 200, STEPS = 240 };

/* Bullets and the wall that each flies at. */
typedef struct range {
    thud_world *world;
    thud_body_id bullets[BULLETS], walls[BULLETS];
} range;

/* Light walls, each with a bullet flying at it; bullets are boxes or circles. */
static range make_range(bool boxes) {
    thud_world_def def = weightless();
    def.sleeping = false;
    range r = {.world = make_world(def)};
    thud_shape_def shape = thud_default_shape_def();
    shape.restitution = 0.3f;
    uint64_t seed = 7;
    for (int i = 0; i < BULLETS; i++) {
        double x = i / 40 * 40.0, y = i % 40 * 3.0;
        r.walls[i] = add_body(r.world, THUD_BODY_DYNAMIC, x + 20, y, 0);
        add_shape(r.world, r.walls[i], 0.05f, 1, false, &shape);
        thud_body_def bullet = thud_default_body_def();
        bullet.kind = THUD_BODY_DYNAMIC;
        bullet.position = (thud_pos){x, y + random_in(&seed, -0.5, 0.5)};
        bullet.velocity = (thud_vec2){(float)random_in(&seed, 50, 350), 0};
        bullet.detection = &thud_detection_swept;
        OK(thud_body_create(r.world, &bullet, &r.bullets[i]));
        add_shape(r.world, r.bullets[i], 0.1f, boxes ? 0.05f : 0, false, &shape);
    }
    return r;
}

/* The bullet's place in the wall's frame. */
static thud_pos seen_from(const thud_body_state *wall, const thud_body_state *bullet) {
    double x = bullet->position.x - wall->position.x, y = bullet->position.y - wall->position.y;
    double c = (double)wall->cosine, s = (double)wall->sine;
    return (thud_pos){c * x + s * y, c * y - s * x};
}

static void bullets_at_light_walls_never_pass_nor_sink_in(void **state) {
    (void)state;
    static thud_pos before[BULLETS][BULLETS];
    for (int boxes = 0; boxes < 2; boxes++) {
        range r = make_range(boxes);
        for (int step = 0; step < STEPS; step++) {
            thud_body_state bullets[BULLETS], walls[BULLETS];
            run(r.world, 1);
            for (int i = 0; i < BULLETS; i++) {
                bullets[i] = state_of(r.world, r.bullets[i]);
                walls[i] = state_of(r.world, r.walls[i]);
            }
            for (int i = 0; i < BULLETS * BULLETS; i++) {
                int b = i / BULLETS, w = i % BULLETS;
                thud_pos p = seen_from(&walls[w], &bullets[b]), q = before[b][w];
                before[b][w] = p;
                bool near =
                    fabs(p.y) < 0.9 && fabs(q.y) < 0.9 && fabs(p.x) < 0.6 && fabs(q.x) < 0.6;
                if (near && step && p.x * q.x < 0) {
                    fail_msg("step %d: bullet %d passed wall %d", step, b, w);
                }
                if (fabs(p.y) < 0.9 && fabs(p.x) < 0.03 + (boxes ? 0.05 : 0.1)) {
                    fail_msg("step %d: bullet %d is in wall %d", step, b, w);
                }
            }
        }
        thud_world_destroy(r.world);
    }
}

/* A bar that only rotates, or that also flies by, and a swept ball that it hits. */
static void what_is_not_swept_itself_passes_no_swept_body(void **state) {
    (void)state;
    uint64_t seed = 5;
    for (int i = 0; i < 100; i++) {
        thud_world *world = make_world(weightless());
        bool spins = i % 2, moves = i / 2 % 2;
        thud_body_def def = thud_default_body_def();
        thud_body_id bar, ball;
        thud_shape_def heavy = thud_default_shape_def();
        heavy.density = 1000;
        def.kind = moves ? THUD_BODY_DYNAMIC : THUD_BODY_KINEMATIC;
        def.position.x = spins ? 0 : -random_in(&seed, 1, 3);
        def.angular_velocity = spins ? (float)random_in(&seed, 10, 80) : 0;
        def.velocity.x = spins ? 0 : (float)random_in(&seed, 30, 300);
        OK(thud_body_create(world, &def, &bar));
        add_shape(world, bar, spins ? 1 : 0.02f, spins ? 0.02f : 1, false, &heavy);
        def = thud_default_body_def();
        def.kind = THUD_BODY_DYNAMIC;
        def.position = spins ? (thud_pos){0, random_in(&seed, 0.4, 0.8)} : (thud_pos){0, 0};
        def.detection = &thud_detection_swept;
        OK(thud_body_create(world, &def, &ball));
        add_shape(world, ball, 0.05f, 0, false, NULL);
        int met = 0;
        for (int step = 0; step < 30 && !met; step++) {
            run(world, 1);
            met = thud_stats_of(world).impacts;
        }
        if (!met) {
            fail_msg("bar %d of %g rad/s passed", i, (double)def.angular_velocity);
        }
        thud_world_destroy(world);
    }
}

/* A bar that rotates far enough in a step to pass the ball is counted as not bisectable; a slow
 * bar, and a ball that rotates in its place, are not. */
static void bar_that_spins_past_a_bisected_ball_is_counted(void **state) {
    (void)state;
    for (int i = 0; i < 40; i++) {
        thud_world_def def = weightless();
        def.detection = &thud_detection_bisect;
        thud_world *world = make_world(def);
        thud_body_id bar =
            add_body(world, i % 2 ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC, 0, 0, 0.05 * i);
        add_shape(world, bar, 1, 0.1f, false, NULL);
        OK(thud_body_set_velocity(world, bar, (thud_vec2){0, 0}, i < 20 ? 30 : 3));
        thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0.8, 0.02 * i - 0.4, 0);
        add_shape(world, ball, 0.1f, 0, false, NULL);
        OK(thud_body_set_velocity(world, ball, (thud_vec2){0, 0}, 40));
        run(world, 1);
        assert_int_equal(thud_stats_of(world).unbisectable, i < 20);
        thud_world_destroy(world);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bullets_at_light_walls_never_pass_nor_sink_in),
        cmocka_unit_test(what_is_not_swept_itself_passes_no_swept_body),
        cmocka_unit_test(bar_that_spins_past_a_bisected_ball_is_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
