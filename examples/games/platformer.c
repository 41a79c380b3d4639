/* platformer.c: a character (a mover) collects coins: over a pit, against a conveyor belt, up
 * through planks and on a lift. Another lift takes a crate up through a plank, on which it then
 * rests, by a one-way rule. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

/* STEPS: the longest game, one minute. PLANK, CRATE: categories. */
enum { COINS = 8, STEPS = 60 * 60, PLANK = 2, CRATE = 4 };

static const thud_pos coins[COINS] = {{4, 1},  {11, 2}, {15, 1}, {18, 3},
                                      {18, 5}, {22, 9}, {28, 9}, {38, 1}};

static void lay_level(thud_world *world) {
    thud_body_options belt = {.surface_speed = -2}, plank = {.category = PLANK},
                      coin = {.sensor = true};
    thud_rule one_way = thud_default_rule();
    thud_body_make(world, thud_aabb_at(4, -0.5, 6, 0.5), NULL);
    thud_body_make(world, thud_aabb_at(16, -0.5, 4, 0.5), &belt);
    thud_body_make(world, thud_aabb_at(30, -0.5, 10, 0.5), NULL);
    thud_body_make(world, thud_aabb_at(27, 7.5, 3, 0.5), NULL);
    thud_body_make(world, thud_aabb_at(18, 2, 1.2, 0.1), &plank);
    thud_body_make(world, thud_aabb_at(18, 4, 1.2, 0.1), &plank);
    thud_body_make(world, thud_aabb_at(34, 4, 1.5, 0.1), &plank);
    for (int i = 0; i < COINS; i++)
        thud_body_make(world, thud_circle_at(coins[i].x, coins[i].y, 0.2), &coin);
    one_way.kind = THUD_RULE_ONE_WAY;
    thud_world_set_rule(world, PLANK, CRATE, &one_way);
}

int main(void) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    thud_body_options lift = {.kind = THUD_BODY_KINEMATIC}, plank = {lift.kind, .category = PLANK};
    thud_body_options heavy = {.kind = THUD_BODY_DYNAMIC, .category = CRATE};
    thud_body_id lifts[2] = {thud_body_make(world, thud_aabb_at(22, 0.2, 1.4, 0.1), &plank),
                             thud_body_make(world, thud_aabb_at(34, 0.2, 1, 0.1), &lift)};
    thud_body_id crate = thud_body_make(world, thud_aabb_at(34, 0.8, 0.5, 0.5), &heavy);
    lay_level(world);

    thud_mover hero = thud_default_mover(thud_aabb_at(0, 0.7, 0.4, 0.6));
    thud_one_way planks = {PLANK, false};
    hero.pass = thud_mover_passes_one_way;
    hero.context = &planks;
    hero.filter.sensors = true;
    hero.push_force = 20;
    thud_mover_report report = {0};
    int next = 0, steps = 0;
    for (; next < COINS && steps < STEPS; steps++) {
        for (int i = 0; i < 2; i++)
            thud_body_set_velocity(world, lifts[i], (thud_vec2){0, steps % 480 < 240 ? 2 : -2}, 0);
        thud_world_step(world);
        double x = coins[next].x - hero.shape.x, y = coins[next].y - hero.shape.y;
        thud_vec2 velocity = {(float)fmax(-5, fmin(5, 5 * x)), report.velocity.y - 20 / 60.0f};
        if (hero.on_ground)
            velocity.y = fabs(x) < 2.5 && y > 0.8 ? 10 : 0;
        thud_mover_move(world, &hero, velocity, 1 / 60.0, &report);
        for (int i = 0; i < report.sensor_count; i++, next++)
            thud_shape_destroy(world, report.sensors[i]);
    }
    printf("%d of %d coins in %.2f s; the crate is at %.2f\n", next, COINS, steps / 60.0,
           thud_position_of(world, crate).y);
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(world));
    thud_world_destroy(world);
    return next < COINS;
}
