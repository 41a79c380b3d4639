/* asleep.c: shelves with small stacks that fall asleep, below a closed box of 100 moving circles
 * that never sleep. With sleeping on, a step should cost no more than the 100 circles. */
#include "gas.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Boxes in a stack, and circles that never sleep. */
enum { PER_STACK = 5, AWAKE = 100 };

static void fill(scene *s, int size) {
    const double stack_spacing = 2, shelf_spacing = 7;
    int stacks = (size + PER_STACK - 1) / PER_STACK;
    int per_shelf = (int)ceil(sqrt(stacks * shelf_spacing / stack_spacing));
    int shelves = (stacks + per_shelf - 1) / per_shelf;
    for (int i = 0; i < shelves; i++)
        scene_static_box(s, 0, i * shelf_spacing - 0.5, 0.5 * stack_spacing * per_shelf + 1, 0.5);
    for (int i = 0; i < size; i++) {
        int stack = i / PER_STACK;
        double x = (stack % per_shelf - 0.5 * (per_shelf - 1)) * stack_spacing;
        double y = stack / per_shelf * shelf_spacing + i % PER_STACK + 0.5;
        scene_dynamic_box(s, x, y, 0.5, 0.5);
    }
    double top = shelves * shelf_spacing;
    double box = 12;
    scene_add_gas(s, 0, top + box, AWAKE);
    s->camera_y = 0.5 * (top + 2 * box);
    s->camera_height = 1.1 * (top + 2 * box);
    s->spawn_y = top + 2 * box;
}

const scene_info scene_asleep = {SCENE_FACTS(asleep), .place = 160, .max_size = 1000000,
                                 .fill = fill};
