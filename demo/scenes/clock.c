/* clock.c: a clock that is driven by a falling weight. Gears lead to an escape wheel. The pallets
 * of the anchor release its teeth one at a time as the pendulum swings, and each tooth pushes the
 * pendulum on.
 *
 * Bodies: the case, which collides with nothing; the anchor with its pendulum; the escape wheel;
 * the other wheels in the order of the gear train; the hands; the weight. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Number of teeth of the escape wheel, and the category bits of teeth and pallets. */
enum { TEETH = 15, TOOTH = 2, PALLET = 4 };

/* RIM: radius of the escape wheel, m. SPAN: sine and cosine of 42 degrees, the angle at the wheel's
 * axle between the vertical and each pallet. The two pallets span 3.5 teeth of 24 degrees, so that
 * the wheel advances by half a pitch at each swing. */
static const double RIM = 2, SPAN_SINE = 0.6691306063588582, SPAN_COSINE = 0.7431448254773942;
/* Rotations by a fifteenth, a twelfth and a thirtieth of a turn, as cosine and sine. */
static const scene_point FIFTEENTH = {0.9135454576426009, 0.4067366430758002};
static const scene_point TWELFTH = {0.8660254037844386, 0.5};
static const scene_point THIRTIETH = {0.9781476007338057, 0.20791169081775934};

/* Centre of the dial, m. */
static const scene_point DIAL = {-3.5, -1.4};

/* The vector p rotated by the unit vector `by`. */
static scene_point turned(scene_point p, scene_point by) {
    return (scene_point){p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x};
}

/* The point at the distance `radius` from `center` in a direction, which is a unit vector. */
static scene_point from(scene_point center, scene_point direction, double radius) {
    return (scene_point){center.x + radius * direction.x, center.y + radius * direction.y};
}

/* Sets the filter of all shapes from `first_shape` on. */
static void set_filter(scene *s, int first_shape, unsigned category, unsigned mask) {
    for (int i = first_shape; !s->failed && i < s->shape_count; i++) {
        s->shapes[i].category = category;
        s->shapes[i].mask = mask;
    }
}

/* Adds the case with the dial. Returns the body. */
static int add_case(scene *s) {
    int body = s->body_count;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    part_add_bar(s, (scene_point){-7, -8.4}, (scene_point){7, -8.4}, 0.25);
    part_add_bar(s, (scene_point){-6.6, -8.4}, (scene_point){-6.6, 7.2}, 0.2);
    part_add_bar(s, (scene_point){6.6, -8.4}, (scene_point){6.6, 7.2}, 0.2);
    part_add_bar(s, (scene_point){-7.2, 7.2}, (scene_point){0, 9.4}, 0.2);
    part_add_bar(s, (scene_point){7.2, 7.2}, (scene_point){0, 9.4}, 0.2);
    scene_point direction = {0, 1};
    for (int i = 0; i < 2 * TEETH; i++) {
        scene_point next = turned(direction, THIRTIETH);
        part_add_bar(s, from(DIAL, direction, 2.4), from(DIAL, next, 2.4), 0.06);
        direction = next;
    }
    direction = (scene_point){0, 1};
    for (int i = 0; i < 12; i++) {
        part_add_bar(s, from(DIAL, direction, 2.05), from(DIAL, direction, 2.4), 0.05);
        direction = turned(direction, TWELFTH);
    }
    set_filter(s, 0, 1, PART_MEETS_NOTHING);
    return body;
}

/* Adds the anchor: two pallets on arms, which touch the rim of the escape wheel, and the pendulum
 * below. */
static int add_anchor(scene *s, int frame, scene_point wheel) {
    const double pallet = 0.12, length = 6.6;
    scene_point pivot = {wheel.x, wheel.y + RIM / SPAN_COSINE};
    int body = s->body_count, first = s->shape_count;
    scene_add_body(s, SCENE_DYNAMIC, pivot.x, pivot.y);
    s->material.density = 4;
    for (int side = -1; side <= 1; side += 2) {
        scene_point knee = from(pivot, (scene_point){side * SPAN_COSINE, -SPAN_SINE + 0.3}, 1.9);
        scene_point end = from(wheel, (scene_point){side * SPAN_SINE, SPAN_COSINE}, RIM + 0.04);
        part_add_bar(s, pivot, knee, 0.09);
        part_add_bar(s, knee, end, 0.07);
    }
    part_add_bar(s, pivot, (scene_point){pivot.x, pivot.y - length}, 0.06);
    s->material.density = 30;
    scene_add_circle(s, 0.75)->y = -length;
    set_filter(s, first, 1, PART_MEETS_NOTHING);
    s->material.density = 4;
    first = s->shape_count;
    for (int side = -1; side <= 1; side += 2) {
        scene_point end = from(wheel, (scene_point){side * SPAN_SINE, SPAN_COSINE}, RIM + 0.04);
        scene_shape *shape = scene_add_circle(s, pallet);
        shape->x = end.x - pivot.x;
        shape->y = end.y - pivot.y;
    }
    set_filter(s, first, PALLET, TOOTH);
    part_hinge(s, frame, body, pivot);
    return body;
}

/* Adds a wheel with its pinion (radius `pinion`), hinged to the case. Returns the index of its
 * hinge. */
static int add_wheel(scene *s, int frame, scene_point at, double radius, double pinion) {
    int first = s->shape_count;
    s->material.density = 1;
    int body = part_circle(s, at.x, at.y, pinion);
    scene_point direction = {1, 0};
    for (int i = 0; i < 2 * TEETH; i++) {
        scene_point next = turned(direction, THIRTIETH);
        part_add_bar(s, from(at, direction, radius - 0.16), from(at, next, radius - 0.16), 0.06);
        part_add_bar(s, from(at, direction, radius - 0.16), from(at, direction, radius + 0.1),
                     0.05);
        if (i % 10 == 0)
            part_add_bar(s, at, from(at, direction, radius - 0.16), 0.07);
        direction = next;
    }
    set_filter(s, first, 1, PART_MEETS_NOTHING);
    part_hinge(s, frame, body, at);
    return s->joint_count - 1;
}

/* Adds the escape wheel. Returns the index of its hinge. */
static int add_escape_wheel(scene *s, int frame, scene_point at) {
    s->material.density = 1;
    int first = s->shape_count, body = part_circle(s, at.x, at.y, 0.6);
    scene_point direction = {0, 1};
    for (int i = 0; i < TEETH; i++) {
        scene_point next = turned(direction, FIFTEENTH);
        part_add_bar(s, from(at, direction, 1.25), from(at, next, 1.25), 0.07);
        if (i % 5 == 0)
            part_add_bar(s, at, from(at, direction, 1.25), 0.08);
        direction = next;
    }
    set_filter(s, first, 1, PART_MEETS_NOTHING);
    first = s->shape_count;
    for (int i = 0; i < TEETH; i++) {
        part_add_bar(s, from(at, direction, 1.25), from(at, direction, RIM), 0.035);
        direction = turned(direction, FIFTEENTH);
    }
    set_filter(s, first, TOOTH, PALLET);
    part_hinge(s, frame, body, at);
    return s->joint_count - 1;
}

/* Adds a hand of the dial. Returns the index of its hinge. */
static int add_hand(scene *s, int frame, scene_point at, double length, double half) {
    int first = s->shape_count;
    s->material.density = 1;
    int body = part_circle(s, at.x, at.y, 2 * half);
    part_add_bar(s, at, (scene_point){at.x, at.y + length}, half);
    set_filter(s, first, 1, PART_MEETS_NOTHING);
    part_hinge(s, frame, body, at);
    return s->joint_count - 1;
}

/* Adds the weight on its rail below the drum. Returns the index of its slider. */
static int add_weight(scene *s, int frame, scene_point drum) {
    int weight = part_box(s, drum.x, drum.y - 2, 0.45, 0.7);
    set_filter(s, s->shape_count - 1, 1, PART_MEETS_NOTHING);
    scene_joint *rail =
        scene_tie(s, SCENE_SLIDER, frame, weight, drum.x, drum.y - 2, 0.5 * 3.141592653589793);
    rail->drive[SCENE_ALONG].limited = true;
    rail->drive[SCENE_ALONG].lower = -5;
    rail->drive[SCENE_ALONG].upper = 0.5;
    return s->joint_count - 1;
}

static void fill(scene *s, int size) {
    /* The radii of a wheel and the pinion that drives it add up to the distance of their axles. */
    const scene_point escape = {0, 3.4}, second = {2.304, 2.728}, third = {3.074, 0.088};
    const double load = 220.0 * size, drum = 0.6;
    s->material = (scene_material){.density = 1, .friction = 0};
    int frame = add_case(s);
    int anchor = add_anchor(s, frame, escape);
    int first_hinge = add_escape_wheel(s, frame, escape);
    int second_hinge = add_wheel(s, frame, second, 1.8, 0.55);
    int third_hinge = add_wheel(s, frame, third, 2.2, drum);
    int minute_hinge = add_hand(s, frame, DIAL, 1.9, 0.08);
    int hour_hinge = add_hand(s, frame, DIAL, 1.3, 0.12);
    s->material.density = load / (4 * 0.45 * 0.7);
    int slide = add_weight(s, frame, (scene_point){third.x + drum, third.y});
    /* A pinion has a third, or a quarter, of the radius of the wheel that it meshes with. */
    scene_tie_gear(s, first_hinge, second_hinge, 3);
    scene_tie_gear(s, second_hinge, third_hinge, 4);
    /* The weight sinks by the drum's radius times the angle by which the drum turns clockwise. */
    scene_tie_gear(s, slide, third_hinge, -drum);
    scene_tie_gear(s, first_hinge, minute_hinge, -2);
    scene_tie_gear(s, minute_hinge, hour_hinge, -12);
    if (!s->failed) {
        s->bodies[anchor].angular_velocity = 0.18;
        s->bodies[anchor].angular_damping = 0.02;
    }
    for (int i = anchor; i < s->body_count; i++)
        s->bodies[i].may_sleep = false;
    s->camera_y = 0.4;
    s->camera_height = 20;
    s->camera_width = 16;
    s->spawn_x = 10;
}

const scene_info scene_clock = {SCENE_FACTS(clock), .place = 290, .fill = fill};
