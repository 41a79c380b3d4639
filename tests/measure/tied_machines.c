/* tied_machines.c: scenes of doors, sliders, linkages, springs and cars. See tied_scenes.h. */
#include "tied_scenes.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* The shape that was added last gets the group of shapes that do not collide with each other. */
static void belong(scene *s) {
    if (s->shape_count > 0)
        s->shapes[s->shape_count - 1].group = -1;
}

/* Adds a bar of `kg` between two points, a body at angle 0 with a turned shape. Returns its index.
 */
static int add_bar(scene *s, double ax, double ay, double bx, double by, double kg) {
    double half = 0.5 * hypot(bx - ax, by - ay);
    s->material.density = kg / (4 * half * 0.05);
    scene_dynamic_box(s, 0.5 * (ax + bx), 0.5 * (ay + by), half, 0.05);
    s->shapes[s->shape_count - 1].angle = atan2(by - ay, bx - ax);
    belong(s);
    return s->body_count - 1;
}

void fill_scissor(scene *s, int stages, double kg) {
    static const double WIDE = 0.75; /* half the width of a stage, m */
    scene_static_box(s, 0, -0.5, 2, 0.5);
    belong(s);
    int falling = 0, rising = 0; /* bars of the stage below that descend or ascend to the right */
    for (int i = 0; i < stages; i++) {
        int left = falling, right = rising; /* bodies that the feet are hinged to */
        rising = add_bar(s, -WIDE, i, WIDE, i + 1, 1);
        falling = add_bar(s, -WIDE, i + 1, WIDE, i, 1);
        scene_tie(s, SCENE_HINGE, left, rising, -WIDE, i, 0);
        scene_tie(s, SCENE_HINGE, right, falling, WIDE, i, 0);
        scene_tie(s, SCENE_HINGE, rising, falling, 0, i + 0.5, 0);
    }
    s->material.density = kg / (2 * WIDE * 0.5);
    scene_dynamic_box(s, 0, stages + 0.25, WIDE, 0.25);
    belong(s);
    int platform = s->body_count - 1;
    scene_tie(s, SCENE_HINGE, platform, falling, -WIDE, stages, 0);
    scene_tie(s, SCENE_WHEEL, platform, rising, WIDE, stages, 0);
}

void fill_door(scene *s) {
    const double speed = 10, kg = 10, knob = 100, arm = 0.875;
    s->gravity_y = 0;
    scene_static_box(s, 0, 0, 0.05, 0.05);
    belong(s);
    s->material.density = kg / (4 * 1 * 0.05);
    scene_body *door = scene_dynamic_box(s, 1, 0, 1, 0.05);
    belong(s);
    door->angular_velocity = speed;
    door->vy = speed * (1 + arm * knob / (kg + knob));
    s->material.density = knob / (PI * 0.125 * 0.125);
    scene_add_circle(s, 0.125)->x = arm;
    belong(s);
    scene_joint *hinge = scene_tie(s, SCENE_HINGE, 0, 1, 0, 0, 0);
    hinge->drive[SCENE_TURN].limited = true;
    hinge->drive[SCENE_TURN].lower = -0.5;
    hinge->drive[SCENE_TURN].upper = 0.5;
}

void fill_slider(scene *s, bool hung) {
    scene_static_box(s, 0, -5, 0.5, 0.5);
    belong(s);
    s->material.density = 1;
    scene_dynamic_box(s, 0, 0, 0.5, 0.5);
    scene_tie(s, SCENE_SLIDER, 0, 1, 0, 0, 0);
    s->material.density = 100 / (PI * 0.25);
    if (hung) {
        scene_dynamic_circle(s, 0.5, -1, 0.5);
        scene_tie(s, SCENE_HINGE, 1, 2, 0.5, -0.5, 0);
    } else {
        scene_dynamic_circle(s, 0.25, 2, 0.5)->vy = -10;
    }
}

void fill_four_bar(scene *s) {
    scene_static_box(s, 0, 0, 0.125, 0.125);
    belong(s);
    int crank = add_bar(s, 0, 0, 0, 1, 1), coupler = add_bar(s, 0, 1, 4, 3, 1);
    int rocker = add_bar(s, 4, 3, 4, 0, 100);
    scene_joint *motor = scene_tie(s, SCENE_HINGE, 0, crank, 0, 0, 0);
    motor->drive[SCENE_TURN].motor_speed = 2 * PI;
    motor->drive[SCENE_TURN].motor_force = 1e5;
    scene_tie(s, SCENE_HINGE, crank, coupler, 0, 1, 0);
    scene_tie(s, SCENE_HINGE, coupler, rocker, 4, 3, 0);
    scene_tie(s, SCENE_HINGE, rocker, 0, 4, 0, 0);
}

void fill_spring(scene *s, scene_joint_kind kind, double frequency, double damping) {
    s->gravity_y = 0;
    scene_static_box(s, 0, 0, 0.5, 0.5);
    belong(s);
    scene_dynamic_box(s, kind == SCENE_DISTANCE ? 2 : 0, 0, 0.5, 0.5);
    belong(s);
    scene_joint *joint = kind == SCENE_DISTANCE ? scene_tie_distance(s, 0, 1, 0, 0, 2, 0)
                                                : scene_tie(s, kind, 0, 1, 0, 0, 0);
    scene_drive *d = &joint->drive[kind == SCENE_HINGE ? SCENE_TURN : SCENE_ALONG];
    d->frequency = frequency;
    d->damping = damping;
    d->target = 0.25 + (kind == SCENE_DISTANCE ? 2 : 0);
}

/* A line with a height each half metre, with bumps that become higher. */
static void add_bumps(scene *s, double length) {
    enum { MOST = 1000 };
    double heights[MOST];
    int count = (int)fmin(MOST, 2 * length);
    for (int i = 0; i < count; i++)
        heights[i] = scene_grid(0.2 * (i % 4 < 2) * (i > 20) + 0.1 * (i % 7 == 3) * (i > 40));
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_uniform(s, -10, 0.5, heights, count);
}

static void add_car(scene *s, int index, double x, double y) {
    s->material.density = 50;
    scene_dynamic_box(s, x, y, 1, 0.25);
    s->shapes[s->shape_count - 1].group = -2 - index;
    int chassis = s->body_count - 1;
    for (int side = -1; side <= 1; side += 2) {
        s->material.density = 30;
        s->material.friction = 0.9;
        scene_dynamic_circle(s, x + 0.75 * side, y - 0.375, 0.3125);
        s->shapes[s->shape_count - 1].group = -2 - index;
        scene_joint *wheel = scene_tie(s, SCENE_WHEEL, chassis, s->body_count - 1, x + 0.75 * side,
                                       y - 0.375, PI / 2);
        wheel->drive[SCENE_ALONG] = (scene_drive){.limited = true,
                                                  .lower = -0.25,
                                                  .upper = 0.25,
                                                  .frequency = 4,
                                                  .damping = 0.7,
                                                  .spring_force = 1e30};
        wheel->drive[SCENE_TURN].motor_speed = -15;
        wheel->drive[SCENE_TURN].motor_force = 40;
    }
}

void fill_cars(scene *s, int count) {
    add_bumps(s, 10 + 4.0 * count + 200);
    for (int i = 0; i < count; i++)
        add_car(s, i, 4.0 * i, 0.75);
}
