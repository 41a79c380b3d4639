/* platformer.c: a hero runs from coin to coin: over a pit, against a belt, up through planks, on a
 * lift. Another lift brings a crate up through a plank, which holds it then. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_mover.h>
#include <thud/thud_reads.h>
#include <thud/thud_rules.h>

enum { SOLID = 1, PLANK = 2, COIN = 4, CRATE = 8 }; /* categories */
enum { COINS = 8, STEPS = 60 * 60 };

static const thud_pos coins[COINS] = {{4, 1},  {11, 2}, {15, 1}, {18, 3},
                                      {18, 5}, {22, 9}, {28, 9}, {38, 1}};

static thud_body_id add_box(thud_world *world, thud_body_kind kind, uint32_t category, double x,
                            double y, float half_x, float half_y, float speed) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_id body;
    body_def.kind = kind;
    body_def.position = (thud_pos){x, y};
    shape_def.filter.category = category;
    shape_def.sensor = category == COIN;
    shape_def.surface_speed = speed;
    thud_body_create(world, &body_def, &body);
    thud_shape_create_aabb(world, body, &shape_def, (thud_vec2){0, 0}, (thud_vec2){half_x, half_y},
                           NULL);
    return body;
}

int main(void) {
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    thud_rule one_way = thud_default_rule();
    if (thud_world_create(&world_def, &world) != THUD_OK)
        return 1;
    one_way.meeting = THUD_ONE_WAY;
    thud_world_set_rule(world, PLANK, CRATE, &one_way);
    add_box(world, THUD_STATIC, SOLID, 4, -0.5, 6, 0.5f, 0);
    add_box(world, THUD_STATIC, SOLID, 16, -0.5, 4, 0.5f, -2);
    add_box(world, THUD_STATIC, SOLID, 30, -0.5, 10, 0.5f, 0);
    add_box(world, THUD_STATIC, SOLID, 27, 7.5, 3, 0.5f, 0);
    add_box(world, THUD_STATIC, PLANK, 18, 2, 1.2f, 0.1f, 0);
    add_box(world, THUD_STATIC, PLANK, 18, 4, 1.2f, 0.1f, 0);
    add_box(world, THUD_STATIC, PLANK, 34, 4, 1.5f, 0.1f, 0);
    for (int i = 0; i < COINS; i++)
        add_box(world, THUD_STATIC, COIN, coins[i].x, coins[i].y, 0.2f, 0.2f, 0);
    thud_body_id lifts[2] = {add_box(world, THUD_KINEMATIC, PLANK, 22, 0.2, 1.4f, 0.1f, 0),
                             add_box(world, THUD_KINEMATIC, SOLID, 34, 0.2, 1.0f, 0.1f, 0)};
    thud_body_id crate = add_box(world, THUD_DYNAMIC, CRATE, 34, 0.8, 0.5f, 0.5f, 0);

    thud_mover hero = thud_default_mover((thud_shape_instance){THUD_AABB, 0, 0.7, 1, 0, 0.4, 0.6});
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
            thud_body_id coin;
            thud_shape_body(world, report.sensors[i], &coin);
            thud_body_destroy(world, coin);
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
