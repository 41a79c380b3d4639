/* catalogue_walls.c: circles and rotating boxes fly at walls 2 cm thick, static walls and heavy
 * dynamic ones, at 10 to 100,000 m/s; counts how many are beyond the wall afterwards. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"
#include "engine.h"
#include "progress.h"
#include "random.h"

#include <math.h>

enum { LANES = 64, QUICK_LANES = 8, SPEED_COUNT = 5, WALL_COUNT = 2 };

static const double SPEEDS[SPEED_COUNT] = {1e1, 1e2, 1e3, 1e4, 1e5};
static const char *const WALLS[WALL_COUNT] = {"static", "dynamic"};

/* A wall and a bullet for each lane, in this order. The distances at the start are spread over the
 * motion of a step. */
static void fill(scene *s, int lanes, bool dynamic, double speed) {
    scene_random random = {8};
    s->gravity_y = 0;
    s->material = (scene_material){.density = 1, .friction = 0.1, .restitution = 0.5};
    for (int i = 0; i < lanes; i++) {
        double y = 4.0 * i;
        scene_add_body(s, dynamic ? SCENE_DYNAMIC : SCENE_STATIC, 0, y);
        scene_add_obb(s, 0.01, 1)->material.density = 100;
        double run_up = 1 + scene_random_range(&random, 0, speed * ENGINE_TIME_STEP);
        scene_body *bullet = scene_add_body(s, SCENE_DYNAMIC, -run_up, y);
        bullet->vx = speed;
        if (i % 2) {
            bullet->angular_velocity = 5;
            scene_add_obb(s, 0.15, 0.1);
        } else {
            scene_add_circle(s, 0.1);
        }
    }
}

/* A lane with a body that cannot be read counts as passed. */
static int count_passed(const way_world *w) {
    int passed = 0;
    for (int i = 0; i + 1 < w->count; i += 2) {
        thud_body_state wall, bullet;
        bool known = thud_body_get_state(w->world, w->bodies[i], &wall) == THUD_OK &&
                     thud_body_get_state(w->world, w->bodies[i + 1], &bullet) == THUD_OK;
        passed += !(known && bullet.position.x < wall.position.x);
    }
    return passed;
}

/* The share of bullets that pass, 0 to 1; below 0 on failure. */
static double fire(const thud_detection *detection, bool dynamic, double speed, int lanes) {
    scene s;
    way_world w = {0};
    scene_init(&s);
    fill(&s, lanes, dynamic, speed);
    bool ok = way_open(&w, &s, detection, ENGINE_TIME_STEP);
    /* A bullet starts at most 1 m and a step's motion before the wall. */
    int steps = (int)ceil(1 / (speed * ENGINE_TIME_STEP)) + 4;
    for (int i = 0; ok && i < steps; i++)
        ok = way_step(&w);
    double share = ok ? (double)count_passed(&w) / lanes : -1;
    way_close(&w);
    scene_free(&s);
    return share;
}

static bool fire_at_all_speeds(int way, int wall, int lanes, json *out) {
    const char *name = thud_detection_name(way_at(way));
    json_begin_object(out, NULL);
    json_text(out, "detection", name);
    json_text(out, "wall", WALLS[wall]);
    json_number(out, "lanes", lanes);
    json_begin_array(out, "speeds");
    printf("%-8s %-10s", WALLS[wall], name);
    bool ok = true;
    for (int i = 0; ok && i < SPEED_COUNT; i++) {
        double share = fire(way_at(way), wall == 1, SPEEDS[i], lanes);
        ok = share >= 0;
        printf(" %8.1f", 100 * share);
        json_begin_object(out, NULL);
        json_number(out, "speed", SPEEDS[i]);
        json_number(out, "passed", share);
        json_end(out);
    }
    printf("\n");
    json_end(out);
    json_end(out);
    return ok;
}

bool catalogue_walls(bool quick, json *out) {
    bool ok = true;
    printf("%-8s %-10s", "% of", "m/s");
    for (int i = 0; i < SPEED_COUNT; i++)
        printf(" %8g", SPEEDS[i]);
    printf("\n");
    json_begin_array(out, "walls");
    for (int wall = 0; wall < WALL_COUNT; wall++)
        for (int way = 0; ok && way < WAY_COUNT; way++)
            ok = fire_at_all_speeds(way, wall, quick ? QUICK_LANES : LANES, out);
    json_end(out);
    return ok;
}
