/* bullets.c: fast small bodies between static walls 0.02 m thick, which they must not pass through.
 *
 * Each lane is a closed room: four static walls, then the bullet. Speeds are from 10 to 10^5 m/s;
 * the shape is a circle, a box that cannot rotate (AABB) or a box that can (OBB). */
#include "scene_facts.h"
#include "scenes.h"

static void add_lane(scene *s, double y, double speed, int kind) {
    const double thin = 0.01; /* half a wall's thickness */
    const double half_width = 12, half_height = 0.9;
    scene_static_box(s, 0, y - half_height, half_width, thin);
    scene_static_box(s, 0, y + half_height, half_width, thin);
    scene_static_box(s, -half_width, y, thin, half_height);
    scene_static_box(s, half_width, y, thin, half_height);
    scene_body *bullet = scene_add_body(s, SCENE_DYNAMIC, -half_width + 1, y);
    bullet->vx = speed;
    bullet->vy = 0.01 * speed;
    bullet->angular_velocity = kind == 2 ? 5 : 0;
    if (kind == 0)
        scene_add_circle(s, 0.1);
    else if (kind == 1)
        scene_add_aabb(s, 0.15, 0.1);
    else
        scene_add_obb(s, 0.15, 0.1);
}

static void fill(scene *s, int size) {
    s->gravity_y = 0;
    s->material = (scene_material){.density = 1, .friction = 0.1, .restitution = 0.9};
    const double speeds[] = {1e1, 1e2, 1e3, 1e4, 1e5};
    for (int i = 0; i < size; i++)
        add_lane(s, (0.5 * (size - 1) - i) * 2, speeds[i % 5], i / 5 % 3);
    s->camera_height = 2.2 * size;
    s->spawn_x = -20;
}

const scene_info scene_bullets = {SCENE_FACTS(bullets), .place = 130, .fill = fill};
