/* meetings.c: bodies of four kinds in a rotating drum. The collision rules of the kinds change by a
 * timetable, until a user sets one.
 *
 * Bodies: the drum (kinematic), then one of each kind in turn. Their rotation is fixed, so that the
 * solid side of a one-way rule stays on top, and they never sleep, so that setting a rule wakes no
 * body. */
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* TURN: rad/s, 25 degrees a second. */
static const double HALF = 0.3, APART = 0.7, TURN = 0.4363323129985824;

enum { KINDS = 4 };

static uint32_t kind(int index) {
    return 2u << index;
}

static void change(scene *s, int step, int first, int second, scene_rule_kind meeting) {
    scene_add_rule(s, kind(first), kind(second), meeting)->step = step;
}

static void fill(scene *s, int size) {
    int columns = (int)ceil(sqrt((double)size));
    double inner = 1.5 + 0.5 * columns, thin = 0.5, along = inner + 1;
    s->material = (scene_material){.density = 1, .friction = 0.6};
    scene_add_body(s, SCENE_KINEMATIC, 0, inner)->angular_velocity = TURN;
    for (int side = 1; side >= -1; side -= 2)
        scene_add_obb(s, thin, along)->x = side * (inner + thin);
    for (int side = 1; side >= -1; side -= 2)
        scene_add_obb(s, along, thin)->y = side * (inner + thin);
    for (int i = 0; i < size; i++) {
        double x = (i % columns - 0.5 * (columns - 1)) * APART;
        double y = (i / columns - 0.5 * (columns - 1)) * APART + inner;
        scene_body *body = i % 2 == 0 ? scene_dynamic_circle(s, x, y, HALF)
                                      : scene_dynamic_box(s, x, y, HALF, HALF);
        body->fixed_rotation = true;
        body->may_sleep = false;
        body->look = 1 + i % KINDS;
        if (!s->failed)
            s->shapes[s->shape_count - 1].category = kind(i % KINDS);
    }
    change(s, 0, 0, 1, SCENE_IGNORE);
    change(s, 0, 2, 3, SCENE_ONE_WAY);
    change(s, 60, 0, 1, SCENE_COLLIDE);
    change(s, 60, 0, 2, SCENE_IGNORE);
    change(s, 90, 1, 1, SCENE_IGNORE);
    change(s, 300, 1, 3, SCENE_ONE_WAY);
    change(s, 300, 2, 3, SCENE_COLLIDE);
    s->kinds = KINDS;
    s->camera_y = inner;
    s->camera_height = 3.2 * inner;
    s->camera_width = 3 * inner;
    s->spawn_y = inner;
}

const scene_info scene_meetings = {SCENE_FACTS(meetings), .place = 366, .fill = fill};
