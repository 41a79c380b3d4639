/* test_islands_motion.c: motion and contact impulses in islands that are solved directly, against
 * mechanics: loads, friction, moving ground, edits, bounces. */
#include "island_support.h"

static const thud_quality *const direct[] = {&thud_quality_high, &thud_quality_exact};
enum { DIRECT = 2 };

/* ---- loads ---- */

static void islands_heavy_on_light_keeps_its_height(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        for (float ratio = 10; ratio <= 1e5f; ratio *= 10) {
            thud_world *world = world_of(direct[q]);
            add_box(world, 0, 0.5, 0.5f, 0.5f);
            thud_body_id top = add_heavy(world, 0, 1.5, 0.5f, ratio);
            run(world, 300);
            near_to(lost_by(world, top, 1.5), 0, 1e-3);
            thud_world_destroy(world);
        }
    }
}

static void islands_heavy_on_light_sinks_little_at_default(void **state) {
    (void)state;
    thud_world *world = world_of(&thud_quality_default);
    add_box(world, 0, 0.5, 0.5f, 0.5f);
    thud_body_id top = add_heavy(world, 0, 1.5, 0.5f, 1000);
    run(world, 300);
    near_to(lost_by(world, top, 1.5), 0, 0.01);
    thud_world_destroy(world);
}

/* The top falls freely for a third of a second before the solver finds that the column sags, and
 * lands. */
static void islands_tall_columns_stand_at_default(void **state) {
    (void)state;
    enum { MOST = 200, SEEN = 60 };
    const int boxes[] = {60, 110, 150, MOST};
    for (int i = 0; i < 4; i++) {
        thud_world *world = world_of(&thud_quality_default);
        thud_body_id ids[MOST];
        add_column(world, 0, boxes[i], ids);
        run(world, SEEN);
        for (int k = SEEN; k < 600; k++) {
            run(world, 1);
            assert_int_equal(thud_stats_of(world).direct_bodies, boxes[i]);
            assert_int_equal(thud_stats_of(world).soft_islands, 0);
            assert_int_equal(thud_stats_of(world).factorings, 1);
        }
        near_to(lost_by(world, ids[boxes[i] - 1], boxes[i] - 0.5), 0, 2e-4);
        thud_world_destroy(world);
    }
}

static void islands_two_small_boxes_bear_one_a_hundred_times_as_large(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world *world = world_of(direct[q]);
        add_box(world, -3, 0.05, 0.05f, 0.05f);
        add_box(world, 3, 0.05, 0.05f, 0.05f);
        thud_body_id top = add_box(world, 0, 5.1, 5, 5);
        run(world, 300);
        near_to(lost_by(world, top, 5.1), 0, 1e-3 * 0.1 + 1e-4);
        near_to(state_of(world, top).angle, 0, 1e-5);
        thud_world_destroy(world);
    }
}

static void islands_column_of_fifty_keeps_its_height(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world *world = world_of(direct[q]);
        thud_body_id ids[50];
        add_column(world, 0, 50, ids);
        run(world, 300);
        near_to(lost_by(world, ids[49], 49.5), 0, 0.01);
        near_to(state_of(world, ids[49]).position.x, 0, 1e-3);
        thud_world_destroy(world);
    }
}

/* ---- friction ---- */

/* A box that slides at v stops after v^2 / (2 mu g). */
static void islands_box_slides_as_far_as_friction_lets_it(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        for (float v = 2; v <= 8; v *= 2) {
            thud_world *world = world_of(direct[q]);
            thud_shape_def def = thud_default_shape_def();
            def.friction = 0.15f; /* with the floor's 0.6: 0.3 */
            thud_body_id id = add_body(world, THUD_BODY_DYNAMIC, -20, 0.25, 0);
            add_shape(world, id, 1, 0.25f, false, &def);
            run(world, 30);
            double from = state_of(world, id).position.x;
            OK(thud_body_set_velocity(world, id, (thud_vec2){v, 0}, 0));
            run(world, 300);
            double way = state_of(world, id).position.x - from, wanted = v * v / (2 * 0.3 * G);
            near_to(way / wanted, 1, 1e-3);
            near_to(state_of(world, id).velocity.x, 0, 1e-6);
            thud_world_destroy(world);
        }
    }
}

/* A box on a box that slides on ice: momentum is conserved while friction makes their velocities
 * equal. */
static void islands_friction_keeps_momentum(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_shape_def ice = thud_default_shape_def();
        ice.friction = 0;
        thud_world_def def = def_of(direct[q]);
        def.sleeping = false;
        thud_world *world = make_world(def);
        add_floor(world, &ice);
        thud_body_id low = add_box(world, 0, 0.5, 4, 0.5f), top = add_box(world, 0, 1.5, 1, 0.5f);
        run(world, 10);
        OK(thud_body_set_velocity(world, low, (thud_vec2){4, 0}, 0));
        run(world, 120);
        near_to(state_of(world, low).velocity.x, 3.2, 1e-3); /* masses 8 and 2 */
        near_to(state_of(world, top).velocity.x, 3.2, 1e-3);
        thud_world_destroy(world);
    }
}

/* A disk of mass m slides on a plank of mass M, on ice, until it rolls: the impulse of friction is
 * v / (3 / m + 1 / M). */
static void islands_sliding_disk_comes_to_roll(void **state) {
    (void)state;
    for (int disk_first = 0; disk_first < 2; disk_first++) {
        thud_shape_def ice = thud_default_shape_def();
        ice.friction = 0;
        thud_world_def def = def_of(&thud_quality_exact);
        def.sleeping = false;
        thud_world *world = make_world(def);
        add_floor(world, &ice);
        thud_body_id disk = disk_first ? add_ball(world, -6, 1, 0.5f) : (thud_body_id){0};
        thud_body_id plank = add_box(world, 0, 0.25, 8, 0.25f);
        disk = disk_first ? disk : add_ball(world, -6, 1, 0.5f);
        run(world, 10);
        OK(thud_body_set_velocity(world, disk, (thud_vec2){3, 0}, 0));
        run(world, 60);
        double mass = state_of(world, disk).mass;
        double impulse = 3 / (3 / mass + 1 / (double)state_of(world, plank).mass);
        near_to(state_of(world, disk).velocity.x, 3 - impulse / mass, 1e-3);
        near_to(state_of(world, disk).angular_velocity, -2 * impulse / (0.5 * mass), 1e-3);
        near_to(state_of(world, plank).velocity.x, impulse / 8, 1e-3);
        thud_world_destroy(world);
    }
}

/* What an epilogue counts. */
typedef struct ledger {
    double impulse; /* into the floor */
    /* greatest excess of friction over its bound, as a share of the greatest load */
    double over;
    double load;
    int contacts;
} ledger;

/* An epilogue, for a floor at y = 0 and friction 0.6 everywhere. */
static void note(thud_world *world, const thud_contact *contact, void *context) {
    ledger *l = context;
    double bound = 0.6 * (double)contact->normal_impulse;
    l->contacts++;
    l->over = fmax(l->over, fabs((double)contact->tangent_impulse) - bound);
    l->load = fmax(l->load, (double)contact->normal_impulse);
    if (state_of(world, contact->body_a).kind == THUD_BODY_STATIC) {
        l->impulse += (double)contact->normal_impulse * (double)contact->normal.y;
    }
}

static thud_world *noted_world(const thud_quality *quality, ledger *l) {
    thud_world_def def = def_of(quality);
    def.sleeping = false;
    thud_world *world = make_world(def);
    set_listeners(world, NULL, note, l);
    add_floor(world, NULL);
    return world;
}

static void islands_at_rest_keep_friction_within_its_bound(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        ledger l = {0};
        thud_world *world = noted_world(direct[q], &l);
        for (int row = 0; row < 6; row++) {
            for (int i = 0; i < 6 - row; i++) {
                add_box(world, i + 0.5 * row, row + 0.5, 0.5f, 0.5f);
            }
        }
        run(world, 120);
        for (int i = 0; i < 60; i++) {
            l = (ledger){0};
            run(world, 1);
            assert_true(l.over <= 0.02 * l.load);
        }
        thud_world_destroy(world);
    }
}

/* The sum of the impulses into the floor is the weight times the time. */
static void islands_epilogue_adds_up_to_the_weight(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        ledger l = {0};
        thud_world *world = noted_world(direct[q], &l);
        add_column(world, 0, 10, NULL);
        add_box(world, 10, 0.5, 0.5f, 0.5f);
        add_heavy(world, 10, 1.5, 0.5f, 100);
        run(world, 60);
        for (int i = 0; i < 30; i++) {
            l = (ledger){0};
            run(world, 1);
            assert_int_equal(l.contacts, 12);
            near_to(l.impulse / ((10 + 1 + 100) * G * STEP), 1, 1e-3);
        }
        thud_world_destroy(world);
    }
}

/* ---- moving ground and walls ---- */

static void islands_belt_carries_boxes_at_its_speed(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world_def def = def_of(direct[q]);
        def.sleeping = false;
        thud_world *world = make_world(def);
        thud_shape_def belt = thud_default_shape_def();
        belt.surface_speed = 2;
        add_floor(world, &belt);
        thud_body_id low = add_box(world, -20, 0.5, 1, 0.5f);
        thud_body_id top = add_box(world, -20, 1.5, 1, 0.5f);
        run(world, 10);
        near_to(state_of(world, low).velocity.x, 0.6 * G * 10 * STEP, 0.01);
        run(world, 110);
        double from = state_of(world, low).position.x;
        run(world, 60);
        near_to(state_of(world, low).position.x - from, 2, 1e-4);
        near_to(state_of(world, top).velocity.x, 2, 1e-4);
        thud_world_destroy(world);
    }
}

static void islands_kinematic_wall_pushes_a_row_at_its_speed(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world *world = world_of(direct[q]);
        thud_body_id wall = add_body(world, THUD_BODY_KINEMATIC, -1, 1, 0), row[5];
        add_shape(world, wall, 0.5f, 0.9f, false, NULL);
        OK(thud_body_set_velocity(world, wall, (thud_vec2){1, 0}, 0));
        for (int i = 0; i < 5; i++) {
            row[i] = add_box(world, i * 1.05, 0.5, 0.5f, 0.5f);
        }
        run(world, 180);
        if (direct[q]->island_slow_steps ==
            0) { /* a sliding row takes as few factorisations as a resting one */
            assert_in_range(thud_stats_of(world).factorings, 1, 2);
        }
        double front = state_of(world, wall).position.x + 0.5;
        for (int i = 0; i < 5; i++) {
            near_to(state_of(world, row[i]).velocity.x, 1, 1e-3);
            near_to(state_of(world, row[i]).position.x, front + i + 0.5, 0.005 * (i + 1));
        }
        thud_world_destroy(world);
    }
}

/* A column on a rising kinematic body has its velocity and keeps its height. */
static void islands_lift_takes_a_column_along(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world_def def = def_of(direct[q]);
        thud_world *world = make_world(def);
        thud_body_id lift = add_body(world, THUD_BODY_KINEMATIC, 0, -0.5, 0), ids[10];
        add_shape(world, lift, 2, 0.5f, false, NULL);
        add_column(world, 0, 10, ids);
        run(world, 10);
        OK(thud_body_set_velocity(world, lift, (thud_vec2){0, 0.5f}, 0));
        run(world, 240);
        double top = state_of(world, lift).position.y + 0.5;
        assert_int_equal(thud_stats_of(world).direct_bodies, 10);
        near_to(state_of(world, ids[9]).velocity.y, 0.5, 1e-3);
        near_to(lost_by(world, ids[9], top + 9.5), 0, 0.01);
        thud_world_destroy(world);
    }
}

/* ---- vetoes and edits ---- */

/* The body whose contacts the prologue vetoes. */
static thud_body_id vetoed;

static bool veto(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                 void *context) {
    (void)world, (void)settings, (void)context;
    return contact->body_a.index1 != vetoed.index1 && contact->body_b.index1 != vetoed.index1;
}

/* The prologue vetoes all contacts of the middle box of three: it falls alone, and the upper one
 * comes to rest on the lower one. */
static void islands_leave_out_what_a_prologue_vetoes(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world_def def = def_of(direct[q]);
        def.sleeping = false;
        thud_world *world = make_world(def);
        set_listeners(world, veto, NULL, NULL);
        add_floor(world, NULL);
        thud_body_id ids[3];
        add_column(world, 0, 3, ids);
        vetoed = ids[1];
        run(world, 30);
        near_to(state_of(world, ids[1]).velocity.y, -G * 30 * STEP, 1e-3);
        near_to(state_of(world, ids[0]).position.y, 0.5, 1e-3);
        run(world, 90);
        near_to(state_of(world, ids[2]).position.y, 1.5, 5e-3);
        assert_int_equal(thud_stats_of(world).direct_bodies, 2);
        thud_world_destroy(world);
    }
}

/* One body is destroyed and another disabled: the bodies above them come down, and stay there. */
static void islands_go_on_without_bodies_that_vanish(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        thud_world *world = world_of(direct[q]);
        thud_body_id ids[8];
        add_column(world, 0, 8, ids);
        run(world, 30);
        assert_int_equal(thud_stats_of(world).direct_bodies, 8);
        OK(thud_body_destroy(world, ids[3]));
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_bodies, 7);
        run(world, 120);
        near_to(lost_by(world, ids[7], 6.5), 0, 0.01);
        OK(thud_body_set_enabled(world, ids[5], false));
        run(world, 1);
        assert_int_equal(thud_stats_of(world).direct_bodies, 6);
        run(world, 120);
        near_to(lost_by(world, ids[7], 5.5), 0, 0.01);
        thud_world_destroy(world);
    }
}

/* ---- bounces ---- */

/* A ball that is dropped from height h onto the floor, or onto a block of 10^4 times its density,
 * rises to e^2 h. */
static void islands_ball_bounces_to_the_square_of_its_restitution(void **state) {
    (void)state;
    for (int q = 0; q < DIRECT; q++) {
        for (int on_block = 0; on_block < 2; on_block++) {
            thud_world *world = world_of(direct[q]);
            double ground = 2 * on_block, highest = 0;
            if (on_block) {
                add_heavy(world, 0, 1, 1, 1e4f);
            }
            thud_shape_def def = thud_default_shape_def();
            def.restitution = 0.7f;
            thud_body_id ball = add_body(world, THUD_BODY_DYNAMIC, 0, ground + 5.5, 0);
            add_shape(world, ball, 0.5f, 0, false, &def);
            bool up = false;
            for (int i = 0; i < 180; i++) {
                run(world, 1);
                up |= state_of(world, ball).velocity.y > 1;
                double height = state_of(world, ball).position.y - 0.5 - ground;
                highest = up && height > highest ? height : highest;
            }
            near_to(highest / (0.49 * 5), 1, 0.03);
            thud_world_destroy(world);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(islands_heavy_on_light_keeps_its_height),
        cmocka_unit_test(islands_heavy_on_light_sinks_little_at_default),
        cmocka_unit_test(islands_tall_columns_stand_at_default),
        cmocka_unit_test(islands_two_small_boxes_bear_one_a_hundred_times_as_large),
        cmocka_unit_test(islands_column_of_fifty_keeps_its_height),
        cmocka_unit_test(islands_box_slides_as_far_as_friction_lets_it),
        cmocka_unit_test(islands_friction_keeps_momentum),
        cmocka_unit_test(islands_sliding_disk_comes_to_roll),
        cmocka_unit_test(islands_at_rest_keep_friction_within_its_bound),
        cmocka_unit_test(islands_epilogue_adds_up_to_the_weight),
        cmocka_unit_test(islands_belt_carries_boxes_at_its_speed),
        cmocka_unit_test(islands_kinematic_wall_pushes_a_row_at_its_speed),
        cmocka_unit_test(islands_lift_takes_a_column_along),
        cmocka_unit_test(islands_leave_out_what_a_prologue_vetoes),
        cmocka_unit_test(islands_go_on_without_bodies_that_vanish),
        cmocka_unit_test(islands_ball_bounces_to_the_square_of_its_restitution),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
