/* tumbler.c: a drum of four walls, one kinematic body, rotates and churns its load: boxes, or in
 * the second scene boxes and circles alternately. */
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

static void fill_drum(scene *s, int size, int circle_every) {
    const double half = 0.125;
    const double spacing = 0.28;
    int columns = (int)ceil(sqrt(size));
    double inner = columns * 0.22; /* half the drum's width, m; the load starts inside */
    if (inner < 1)
        inner = 1;
    const double wall = 0.5;
    scene_body *drum = scene_add_body(s, SCENE_KINEMATIC, 0, inner);
    drum->angular_velocity = 0.4363323129985824; /* 25 degrees per second */
    scene_add_obb(s, wall, inner + 2 * wall)->x = inner + wall;
    scene_add_obb(s, wall, inner + 2 * wall)->x = -inner - wall;
    scene_add_obb(s, inner + 2 * wall, wall)->y = inner + wall;
    scene_add_obb(s, inner + 2 * wall, wall)->y = -inner - wall;
    for (int i = 0; i < size; i++) {
        double x = (i % columns - 0.5 * (columns - 1)) * spacing;
        double y = (i / columns - 0.5 * (columns - 1)) * spacing + inner;
        if (circle_every > 0 && i % circle_every == 0)
            scene_dynamic_circle(s, x, y, half);
        else
            scene_dynamic_box(s, x, y, half, half);
    }
    s->camera_y = inner;
    s->camera_height = 3.2 * inner;
    s->spawn_y = inner;
}

static void fill_boxes(scene *s, int size) {
    fill_drum(s, size, 0);
}

static void fill_half(scene *s, int size) {
    fill_drum(s, size, 2);
}

const scene_info scene_tumbler = {SCENE_FACTS(tumbler), .place = 40, .fill = fill_boxes};

const scene_info scene_tumbler_half = {SCENE_FACTS(tumbler_half), .place = 50, .fill = fill_half};
