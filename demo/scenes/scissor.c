/* scissor.c: a scissor lift of `size` stages raises 100 times its own mass. A motor pulls its
 * sliding foot inwards until a limit.
 *
 * Bodies: the ground (flat terrain), the two bars of each stage from the bottom, the sliding foot,
 * the platform with its load, the sliding head. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Length of a bar; horizontal distance of its ends at the start, and raised; half the width of a
 * bar; height of the lowest hinges. All in m. */
static const double BAR = 3, FROM = 2.88, TO = 2.7, HALF = 0.07, FEET = 0.3;

/* Adds a small body at `at`, hinged to `bar`, that slides along the x axis of `carrier`. Returns
 * the slider. */
static scene_joint *add_slide(scene *s, int carrier, int bar, scene_point at) {
    int slide = part_circle(s, at.x, at.y, 0.12);
    part_hinge(s, bar, slide, at);
    return scene_tie(s, SCENE_SLIDER, carrier, slide, at.x, at.y, 0);
}

static void fill(scene *s, int size) {
    double height = sqrt(BAR * BAR - FROM * FROM), x = -0.5 * FROM;
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_flat(s, 0);
    s->material.density = 5;
    int first = s->body_count, left = 0, right = 0;
    for (int i = 0; i < size; i++) {
        double low = FEET + i * height, high = FEET + (i + 1) * height;
        int rising = part_bar(s, (scene_point){x, low}, (scene_point){-x, high}, HALF, 0);
        int falling = part_bar(s, (scene_point){-x, low}, (scene_point){x, high}, HALF, 0);
        part_hinge(s, rising, falling, (scene_point){0, 0.5 * (low + high)});
        part_hinge(s, i > 0 ? left : 0, rising, (scene_point){x, low});
        if (i > 0)
            part_hinge(s, right, falling, (scene_point){-x, low});
        left = falling;
        right = rising;
    }
    double load = 0;
    for (int i = first; i < s->body_count; i++)
        load += 100 * part_mass(s, i);
    scene_joint *foot = add_slide(s, 0, first + 1, (scene_point){-x, FEET});
    double top = FEET + size * height;
    foot->drive[SCENE_ALONG].limited = true;
    foot->drive[SCENE_ALONG].lower = TO - FROM;
    foot->drive[SCENE_ALONG].upper = 0.01;
    foot->drive[SCENE_ALONG].motor_speed = -0.04;
    foot->drive[SCENE_ALONG].motor_force = 20 * load * size * FROM / height;
    s->material.density = load / (4 * 1.7 * 1);
    int platform = s->body_count;
    scene_add_body(s, SCENE_DYNAMIC, 0, top);
    scene_add_obb(s, 1.7, 1)->y = 1.2;
    part_hinge(s, left, platform, (scene_point){x, top});
    s->material.density = 5;
    add_slide(s, platform, right, (scene_point){-x, top});
    part_keep_apart(s, first, -1);
    double reach = FEET + size * sqrt(BAR * BAR - TO * TO) + 3;
    s->camera_y = 0.47 * reach;
    s->camera_height = 1.12 * reach + 1;
    s->spawn_x = 4;
    s->spawn_y = 6;
}

const scene_info scene_scissor = {SCENE_FACTS(scissor), .place = 280, .fill = fill};
