/* platformer.c: a hero runs from coin to coin: over a pit, against a belt, up through planks, on a
 * lift. Another lift brings a crate up through a plank, which holds it then. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_edits.h>
#include <thud/thud_mover.h>
#include <thud/thud_reads.h>
#include <thud/thud_rules.h>

enum { SOLID = 1, PLANK = 2, CRATE = 4 }; /* categories */
enum { COINS = 8, STEPS = 60 * 60 };

static const thud_pos coins[COINS] = {{4, 1},  {11, 2}, {15, 1}, {18, 3},
                                      {18, 5}, {22, 9}, {28, 9}, {38, 1}};

static thud_body_id add_body(thud_world *world, thud_body_kind kind, double x, double y,
                             uint32_t category, double half_x, double half_y) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape box = {thud_aabb_at(0, 0, half_x, half_y), &shape_def};
    thud_body_id body;
    body_def.kind = kind;
    body_def.position = (thud_pos){x, y};
    shape_def.filter.category = category;
    thud_body_create_with_shapes(world, &body_def, &box, 1, &body, NULL);
    return body;
}

static void lay_level(thud_world *world) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def belt = thud_default_shape_def(), plank = belt, coin = belt;
    thud_body_shape level[7 + COINS] = {{thud_aabb_at(4, -0.5, 6, 0.5), NULL},
                                        {thud_aabb_at(16, -0.5, 4, 0.5), &belt},
                                        {thud_aabb_at(30, -0.5, 10, 0.5), NULL},
                                        {thud_aabb_at(27, 7.5, 3, 0.5), NULL},
                                        {thud_aabb_at(18, 2, 1.2, 0.1), &plank},
                                        {thud_aabb_at(18, 4, 1.2, 0.1), &plank},
                                        {thud_aabb_at(34, 4, 1.5, 0.1), &plank}};
    belt.surface_speed = -2;
    plank.filter.category = PLANK;
    coin.sensor = true;
    for (int i = 0; i < COINS; i++)
        level[7 + i] = (thud_body_shape){thud_circle_at(coins[i].x, coins[i].y, 0.2), &coin};
    thud_body_create_with_shapes(world, &body_def, level, 7 + COINS, NULL, NULL);
}

int main(void) {
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    thud_rule one_way = thud_default_rule();
    if (thud_world_create(&world_def, &world) != THUD_OK)
        return 1;
    one_way.meeting = THUD_ONE_WAY;
    thud_world_set_rule(world, PLANK, CRATE, &one_way);
    lay_level(world);
    thud_body_id lifts[2] = {add_body(world, THUD_KINEMATIC, 22, 0.2, PLANK, 1.4, 0.1),
                             add_body(world, THUD_KINEMATIC, 34, 0.2, SOLID, 1, 0.1)};
    thud_body_id crate = add_body(world, THUD_DYNAMIC, 34, 0.8, CRATE, 0.5, 0.5);

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
        for (int i = 0; i < report.sensor_count; i++) {
            thud_shape_destroy(world, report.sensors[i]);
            next++;
        }
    }
    thud_pos at;
    thud_body_position(world, crate, &at);
    printf("%d of %d coins in %.2f s; the crate is at %.2f\n", next, COINS, steps / 60.0, at.y);
    printf("hash %016llx\n", (unsigned long long)thud_world_hash(world));
    thud_world_destroy(world);
    return next < COINS;
}
