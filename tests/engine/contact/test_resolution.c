/* test_resolution.c: what games build from callbacks and surfaces, under every detection: one-way
 * platforms, sensors, conveyor belts, sliding friction, teams. */
#include "resolution_support.h"

static bool same_shape(thud_shape_id a, thud_shape_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

/* ---- one-way platforms ---- */

/* A prologue that holds a body on the platform where the contact is on its top, the body does not
 * rise, and was not below the top a step ago. */
static bool one_way(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                    void *context) {
    (void)settings;
    if (!same_shape(contact->shape_a, *(const thud_shape_id *)context)) {
        return true;
    }
    float rise = state_of(world, contact->body_b).velocity.y;
    return contact->normal.y > 0.7f && rise < 0.2f && contact->separation > rise / 60 - 0.05f;
}

static void one_way_platform_lets_through_from_below_and_holds_from_above(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 0; kind < 3; kind++) {
            thud_shape_id platform;
            thud_world *world = make_world_with(detections[d], one_way, &platform, true);
            thud_body_id shelf = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
            platform = add_shape(world, shelf, 20, 0.1f, true, NULL);
            thud_body_id falls = add_kind(world, kind, 0, 8, NULL);
            thud_body_id jumps = add_kind(world, kind, 3, -3, NULL);
            thud_body_id turns_back = add_kind(world, kind, 6, -3, NULL);
            OK(thud_body_set_velocity(world, jumps, (thud_vec2){0, 12}, 0));
            OK(thud_body_set_velocity(world, turns_back, (thud_vec2){0, 7.7f}, 0));
            double highest = -3;
            for (int i = 0; i < 240; i++) {
                run(world, 1);
                highest = fmax(highest, state_of(world, jumps).position.y);
                assert_true(state_of(world, falls).position.y > 0.55);
            }
            near_to(highest, -3 + 12 * 12 / 20.0, 0.04); /* as high as in free flight */
            near_to(state_of(world, falls).position.y, 0.6, 0.01);
            near_to(state_of(world, jumps).position.y, 0.6, 0.01);
            near_to(state_of(world, turns_back).position.y, -3 + 7.7 * 4 - 5 * 16, 0.3);
            thud_world_destroy(world);
        }
    }
}

/* A prologue that vetoes every contact; the static body is body a. */
static bool refuse(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                   void *context) {
    (void)settings;
    assert_int_equal(state_of(world, contact->body_a).kind, THUD_BODY_STATIC);
    assert_int_equal(state_of(world, contact->body_b).kind, THUD_BODY_DYNAMIC);
    ++*(int *)context;
    return false;
}

/* A body at 300 m/s whose contact is vetoed passes a wall or a terrain at its full velocity. */
static void veto_lets_fast_bodies_through_a_wall_at_full_speed(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 0; kind < 3; kind++) {
            for (int ground = 0; ground < 2; ground++) {
                int asked = 0;
                thud_world *world = make_world_with(detections[d], refuse, &asked, false);
                thud_body_id wall = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
                thud_shape_def def = thud_default_shape_def();
                thud_terrain flat = {.kind = THUD_TERRAIN_FLAT};
                if (ground) {
                    OK(thud_shape_create_terrain(world, wall, &def, &flat, NULL));
                } else {
                    add_shape(world, wall, 20, 2, true, NULL);
                }
                /* inside of the wall in the first step */
                thud_body_id body = add_kind(world, kind, 0, 4, NULL);
                OK(thud_body_set_velocity(world, body, (thud_vec2){0, -300}, 0));
                run(world, 10);
                near_to(state_of(world, body).position.y, 4 - 50, 1e-3);
                assert_true(asked > 0);
                thud_world_destroy(world);
            }
        }
    }
}

/* ---- sensors ---- */

/* Begin and end events of a sensor give, at each step, the number of balls that overlap it by
 * geometry. */
static void sensor_knows_at_every_step_who_is_in(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        uint64_t seed = 5;
        thud_world *world = make_world_with(detections[d], NULL, NULL, false);
        thud_shape_def sensor = thud_default_shape_def();
        sensor.sensor = true;
        thud_body_id zone = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        add_shape(world, zone, 3, 3, true, &sensor);
        thud_body_id balls[30];
        for (int i = 0; i < 30; i++) {
            balls[i] = add_ball(world, random_in(&seed, -9, 9), random_in(&seed, -9, 9), 0.4f);
            thud_vec2 v = {(float)random_in(&seed, -4, 4), (float)random_in(&seed, -4, 4)};
            OK(thud_body_set_velocity(world, balls[i], v, 0));
        }
        int inside = 0, came = 0;
        for (int k = 0; k < 300; k++) {
            run(world, 1);
            int overlap = 0;
            thud_geometry box = {.kind = THUD_SHAPE_AABB, .c = 1, .hx = 3, .hy = 3};
            for (int i = 0; i < 30; i++) {
                thud_pos p = state_of(world, balls[i]).position;
                thud_geometry ball = {
                    .kind = THUD_SHAPE_CIRCLE, .x = p.x, .y = p.y, .c = 1, .hx = (double)0.4f};
                overlap += thud_geometry_overlap(&box, &ball);
            }
            thud_events e = thud_events_of(world);
            inside += e.sensor_begin_count - e.sensor_end_count;
            came += e.sensor_begin_count;
            assert_int_equal(inside, overlap);
        }
        assert_true(came > 5);
        thud_world_destroy(world);
    }
}

/* ---- conveyor belts and friction ---- */

static void box_on_a_belt_gains_speed_by_friction_up_to_the_belts(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 1; kind < 3; kind++) {
            for (int side = -1; side <= 1; side += 2) {
                thud_world *world = make_world_with(detections[d], NULL, NULL, true);
                thud_shape_def belt = surface(0.5f, 4), box = surface(0.5f, 0);
                add_floor(world, &belt);
                /* With side -1 the box hangs under the belt, where the surface moves the other
                 * way. */
                OK(thud_world_set_gravity(world, (thud_vec2){0, -10.0f * (float)side}));
                double y = -1 + side * (1.5 + gap_at_rest(d));
                thud_body_id rider = add_kind(world, kind, 0, y, &box);
                run(world, 12);
                near_to((double)state_of(world, rider).velocity.x, side * 0.5 * 10 * 0.2, 0.03);
                run(world, 100);
                near_to((double)state_of(world, rider).velocity.x, side * 4, 0.01);
                assert_true(state_of(world, rider).awake);
                thud_world_destroy(world);
            }
        }
    }
}

/* A body whose own surface moves (a tank's tracks) drives over static ground at that speed. */
static void tracked_body_drives_over_still_ground(void **state) {
    (void)state;
    thud_world *world = make_world(thud_default_world_def());
    thud_shape_def tracks = surface(0.8f, 3);
    add_floor(world, NULL);
    thud_body_id tank = add_kind(world, 2, 0, 0.5, &tracks);
    run(world, 120);
    near_to((double)state_of(world, tank).velocity.x, 3, 0.01);
    thud_world_destroy(world);
}

static void sliding_box_stops_after_the_distance_of_coulomb(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int quality = 0; quality < QUALITIES; quality++) {
            thud_world *world = make_world_with(detections[d], NULL, NULL, true);
            OK(thud_world_set_quality(world, qualities[quality]));
            /* the friction of the pair: sqrt(0.25 * 0.64) = 0.4 */
            thud_shape_def floor = surface(0.25f, 0), box = surface(0.64f, 0);
            add_floor(world, &floor);
            thud_body_id slider = add_body(world, THUD_BODY_DYNAMIC, 0, 0.5 + gap_at_rest(d), 0);
            add_shape(world, slider, 0.5f, 0.5f, true, &box);
            OK(thud_body_set_velocity(world, slider, (thud_vec2){8, 0}, 0));
            run(world, 180);
            near_to(state_of(world, slider).position.x, 8 * 8 / (2 * 0.4 * 10), 0.08);
            near_to((double)state_of(world, slider).velocity.x, 0, 1e-4);
            thud_world_destroy(world);
        }
    }
}

/* ---- teams ---- */

/* A prologue that vetoes contacts within a team. */
static bool teams(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)settings;
    (void)context;
    return state_of(world, contact->body_a).user_data != state_of(world, contact->body_b).user_data;
}

/* A player of a team, which is its filter group or else its user data. */
static thud_body_id add_player(thud_world *world, bool by_group, int team, int kind, double x,
                               float v) {
    thud_shape_def def = thud_default_shape_def();
    def.filter.group = by_group ? -team : 0;
    def.restitution = 1;
    def.friction = 0;
    thud_body_id player = add_kind(world, kind, x, 0, &def);
    OK(thud_body_set_user_data(world, player, (uint64_t)team));
    OK(thud_body_set_velocity(world, player, (thud_vec2){v, 0}, 0));
    return player;
}

static void team_mates_pass_through_each_other_and_opponents_collide(void **state) {
    (void)state;
    for (int d = 0; d < DETECTIONS; d++) {
        for (int kind = 0; kind < 3; kind++) {
            for (int how = 0; how < 4; how++) {
                bool by_group = how & 1, mates = how & 2;
                thud_world *world =
                    make_world_with(detections[d], by_group ? NULL : teams, NULL, false);
                thud_body_id a = add_player(world, by_group, 1, kind, -2, 4);
                thud_body_id b = add_player(world, by_group, mates ? 1 : 2, kind, 2, -4);
                run(world, 60);
                double wanted = mates ? 4 : -4;
                double lost = mates ? 0 : 0.01;
                near_to((double)state_of(world, a).velocity.x, wanted, lost);
                near_to((double)state_of(world, b).velocity.x, -wanted, lost);
                near_to(state_of(world, a).position.x, mates ? 2 : -3, 0.2 + lost);
                thud_world_destroy(world);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_way_platform_lets_through_from_below_and_holds_from_above),
        cmocka_unit_test(veto_lets_fast_bodies_through_a_wall_at_full_speed),
        cmocka_unit_test(sensor_knows_at_every_step_who_is_in),
        cmocka_unit_test(box_on_a_belt_gains_speed_by_friction_up_to_the_belts),
        cmocka_unit_test(tracked_body_drives_over_still_ground),
        cmocka_unit_test(sliding_box_stops_after_the_distance_of_coulomb),
        cmocka_unit_test(team_mates_pass_through_each_other_and_opponents_collide),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
