/* crane.c: a crane sets a lintel on two piers. A spring moves its trolley along the jib, with
 * little swing, while the winch pays out rope: a motor of a distance joint that stops at a limit.
 *
 * Bodies: the ground (flat terrain), the crane (which collides with nothing), the piers' blocks row
 * by row, the trolley, the hook, the lintel. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

/* Height of the jib, and x of the mast, m. */
static const double JIB = 13, MAST = -9;

static int add_crane(scene *s) {
    const double half = 0.7, reach = 10, back = 5;
    int crane = s->body_count;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    for (int side = -1; side <= 1; side += 2)
        part_add_bar(s, (scene_point){MAST + side * half, 0},
                     (scene_point){MAST + side * half, JIB + 1.4}, 0.1);
    for (int i = 0; i < 9; i++) {
        double left = MAST - half, right = MAST + half;
        part_add_bar(s, (scene_point){i % 2 ? right : left, 1.5 * i},
                     (scene_point){i % 2 ? left : right, 1.5 * (i + 1)}, 0.05);
    }
    part_add_bar(s, (scene_point){MAST - back, JIB + 0.5}, (scene_point){reach, JIB + 0.5}, 0.1);
    part_add_bar(s, (scene_point){MAST - half, JIB + 1.3}, (scene_point){reach - 1, JIB + 1.3},
                 0.07);
    for (int i = 0; i < 18; i++) {
        double x = MAST + half + i;
        part_add_bar(s, (scene_point){x, i % 2 ? JIB + 1.3 : JIB + 0.5},
                     (scene_point){x + 1, i % 2 ? JIB + 0.5 : JIB + 1.3}, 0.04);
    }
    part_add_bar(s, (scene_point){MAST, JIB + 1.3}, (scene_point){MAST, JIB + 4}, 0.1);
    part_add_bar(s, (scene_point){MAST, JIB + 4}, (scene_point){reach - 3, JIB + 1.3}, 0.05);
    part_add_bar(s, (scene_point){MAST, JIB + 4}, (scene_point){MAST - back, JIB + 0.6}, 0.05);
    part_add_bar(s, (scene_point){MAST - back + 0.8, JIB - 1.4},
                 (scene_point){MAST - back + 0.8, JIB + 0.4}, 0.8);
    for (int i = 0; !s->failed && i < s->bodies[crane].shape_count; i++)
        s->shapes[s->bodies[crane].first_shape + i].mask = PART_MEETS_NOTHING;
    return crane;
}

static void add_piers(scene *s, int size) {
    const double hx = 0.6, hy = 0.4;
    for (int i = 0; i < size; i++)
        for (int side = -1; side <= 1; side += 2)
            part_box(s, 3 + side * 2.4, hy + 2 * hy * i, hx, hy);
}

/* Adds trolley, hook and lintel: a rope from the trolley to the hook, and two from the hook to the
 * lintel. The trolley moves from x to `end`; the rope becomes longer by `drop`. */
static void add_load(scene *s, int crane, double x, double end, double drop) {
    const double half = 3.1;
    double hook_y = JIB - 2.4, lintel_y = hook_y - 2;
    s->material.density = 40;
    int trolley = part_box(s, x, JIB + 0.1, 0.5, 0.22);
    int hook = part_circle(s, x, hook_y, 0.22);
    s->material.density = 20;
    int lintel = part_box(s, x, lintel_y, half, 0.3);
    for (int i = hook; !s->failed && i <= lintel; i++)
        s->bodies[i].linear_damping = s->bodies[i].angular_damping = 0.3;
    part_keep_apart(s, trolley, -2);
    scene_joint *rail = scene_tie(s, SCENE_SLIDER, crane, trolley, x, JIB + 0.1, 0);
    scene_drive *drive = &rail->drive[SCENE_ALONG];
    double weight = 10 * (part_mass(s, trolley) + part_mass(s, hook) + part_mass(s, lintel));
    drive->limited = true;
    drive->lower = -1;
    drive->upper = end - x + 1;
    drive->frequency = 0.3;
    drive->damping = 1.5;
    drive->target = end - x;
    drive->spring_force = 0.06 * weight; /* small, so that the trolley starts gently */
    scene_joint *rope = scene_tie_distance(s, trolley, hook, x, JIB + 0.1, x, hook_y);
    drive = &rope->drive[SCENE_ALONG];
    drive->limited = true;
    drive->lower = 1;
    drive->upper = rope->length + drop;
    drive->motor_speed = 0.35;
    drive->motor_force = 3 * weight;
    for (int side = -1; side <= 1; side += 2) {
        scene_joint *strap =
            scene_tie_distance(s, hook, lintel, x, hook_y, x + side * 0.8 * half, lintel_y + 0.3);
        strap->drive[SCENE_ALONG].limited = true;
        strap->drive[SCENE_ALONG].upper = strap->length;
    }
}

static void fill(scene *s, int size) {
    const double top = 0.8 * size, from = -5, to = 3.4;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    int crane = add_crane(s);
    s->material = (scene_material){.density = 20, .friction = 0.8};
    add_piers(s, size);
    /* 0.8 m more than the lintel's height above the piers, so that the ropes go slack. */
    add_load(s, crane, from, to, JIB - 4.7 - top + 0.8);
    s->camera_x = -1.5;
    s->camera_y = 8;
    s->camera_height = 20.5;
    s->camera_width = 26;
    s->spawn_x = 3;
    s->spawn_y = 11;
}

const scene_info scene_crane = {SCENE_FACTS(crane), .place = 235, .fill = fill};
