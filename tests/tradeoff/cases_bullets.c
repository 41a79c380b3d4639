/* cases_bullets.c: the case "bullets": fast small bodies shot at thin walls; the error is the share
 * that passes through. */
#include "case.h"
#include "random.h"

#include <math.h>

static const double WALL_HALF = 2, BULLET = 0.1;

/* Lane i has a wall, 0.02 m thick, and a bullet that flies at it, bodies 2 i and 2 i + 1. Speeds
 * are 10 to 10^5 m/s; bullets are circles, AABBs and OBBs; every second fifteen walls are dynamic,
 * with ten times a bullet's mass. Bullets are marked as such, as both engines advise: swept in
 * thud, isBullet in Box2D. */
static bool fill_bullets(scene *s, int size) {
    static const double SPEEDS[] = {1e1, 1e2, 1e3, 1e4, 1e5};
    scene_random random = {6};
    s->gravity_y = 0;
    for (int i = 0; i < size; i++) {
        double y = 6.0 * i, speed = SPEEDS[i % 5];
        int kind = i / 5 % 3;
        bool gives_way = i / 15 % 2 == 1;
        s->material = (scene_material){.density = 5, .friction = 0.1, .restitution = 0.5};
        scene_add_body(s, gives_way ? SCENE_DYNAMIC : SCENE_STATIC, 0, y)->fixed_rotation = true;
        scene_add_aabb(s, 0.01, WALL_HALF);
        s->material.density = 1;
        scene_body *bullet = scene_add_body(s, SCENE_DYNAMIC, scene_random_range(&random, -3, -1),
                                            scene_grid(y + scene_random_range(&random, -1, 1)));
        bullet->x = scene_grid(bullet->x);
        bullet->vx = speed;
        bullet->detection = SCENE_SWEPT;
        bullet->angular_velocity = kind == 2 ? 5 : 0;
        if (kind == 0)
            scene_add_circle(s, BULLET);
        else if (kind == 1)
            scene_add_aabb(s, BULLET, BULLET);
        else
            scene_add_obb(s, BULLET, BULLET);
    }
    return !s->failed;
}

/* A bullet may leave along the wall, but not be behind it. */
static double share_passed(const sighting *now) {
    int passed = 0, lanes = now->scene->body_count / 2;
    for (int i = 0; i < lanes; i++)
        passed += now->bodies[2 * i + 1].x > now->bodies[2 * i].x;
    return (double)passed / lanes;
}

const tradeoff_case case_bullets = {
    .name = "bullets",
    .title = "Bullets",
    .about = "Small bodies fly at 10 to 100,000 m/s at walls of 2 cm, of which half give way.",
    .error = "share that passes through",
    .unit = "",
    .size = 300,
    .quick_size = 60,
    .steps = 60,
    .quick_steps = 30,
    .floor = 1e-3,
    .chance = 1,
    .fold = CASE_WORST,
    .fill = fill_bullets,
    .error_of = share_passed,
};
