/* tied_crowds.c: scenes with many joints: ragdolls and a grid. See tied_scenes.h. */
#include "tied_scenes.h"

#include "random.h"

/* The parts of a figure that stands at (0, 0): place, half extents, the part that it is hinged to,
 * the hinge's place and its limits in rad. */
static const struct part {
    double x, y, hx, hy; /* hy 0: a circle */
    int on;
    double tie_x, tie_y, lower, upper;
} PARTS[] = {
    {0, 0.95, 0.15, 0.1, -1, 0, 0, 0, 0},
    {0, 1.3, 0.15, 0.25, 0, 0, 1.05, -0.5, 0.5},
    {0, 1.68, 0.12, 0, 1, 0, 1.55, -0.5, 0.5},
    {-0.22, 1.33, 0.05, 0.15, 1, -0.22, 1.48, -2, 2},
    {0.22, 1.33, 0.05, 0.15, 1, 0.22, 1.48, -2, 2},
    {-0.22, 1.04, 0.04, 0.15, 3, -0.22, 1.19, 0, 2},
    {0.22, 1.04, 0.04, 0.15, 4, 0.22, 1.19, 0, 2},
    {-0.09, 0.65, 0.07, 0.2, 0, -0.09, 0.87, -1, 1.5},
    {0.09, 0.65, 0.07, 0.2, 0, 0.09, 0.87, -1, 1.5},
    {-0.09, 0.23, 0.06, 0.22, 7, -0.09, 0.45, -2, 0},
    {0.09, 0.23, 0.06, 0.22, 8, 0.09, 0.45, -2, 0},
};

enum { PART_COUNT = sizeof PARTS / sizeof PARTS[0], COLUMNS = 20 };

static void add_ragdoll(scene *s, int index, double x, double y, double spin) {
    int first = s->body_count;
    s->material.density = 100;
    for (int i = 0; i < PART_COUNT; i++) {
        const struct part *p = &PARTS[i];
        scene_body *body = p->hy > 0 ? scene_dynamic_box(s, x + p->x, y + p->y, p->hx, p->hy)
                                     : scene_dynamic_circle(s, x + p->x, y + p->y, p->hx);
        /* The whole figure rotates about its pelvis. */
        body->angular_velocity = spin;
        body->vx = -spin * (p->y - PARTS[0].y);
        body->vy = spin * p->x;
        s->shapes[s->shape_count - 1].group = -1 - index;
    }
    for (int i = 1; i < PART_COUNT; i++) {
        const struct part *p = &PARTS[i];
        scene_joint *joint =
            scene_tie(s, SCENE_HINGE, first + p->on, first + i, x + p->tie_x, y + p->tie_y, 0);
        joint->drive[SCENE_TURN].limited = true;
        joint->drive[SCENE_TURN].lower = p->lower;
        joint->drive[SCENE_TURN].upper = p->upper;
    }
}

void fill_ragdolls(scene *s, int count) {
    int columns = count < COLUMNS ? count : COLUMNS;
    double width = 1.25 * columns + 10;
    for (int i = 0; i < columns; i++)
        scene_static_box(s, 1.25 * i, -0.25 * i - 5, 0.625, 5);
    scene_static_box(s, -1.625, 10, 1, 20);
    scene_static_box(s, 1.25 * columns + 0.375 + 0.5 * width, -0.25 * columns - 5, 0.5 * width, 5);
    scene_random random = {11};
    for (int i = 0; i < count; i++) {
        double x = 1.25 * (i % columns) + scene_random_range(&random, -0.125, 0.125);
        double y = 1 + 2.25 * (i / columns) - 0.25 * (i % columns);
        add_ragdoll(s, i, x, y, scene_random_range(&random, -2, 2));
    }
}

void fill_ragdoll_heap(scene *s, int count) {
    int columns = 1;
    while (2 * columns * columns < count)
        columns++;
    double half = 0.75 * columns + 0.75;
    scene_static_box(s, 0, -0.5, half + 2, 0.5);
    scene_static_box(s, -half - 1, 20, 1, 20);
    scene_static_box(s, half + 1, 20, 1, 20);
    scene_random random = {7};
    for (int i = 0; i < count; i++) {
        double x =
            1.5 * (i % columns - 0.5 * (columns - 1)) + scene_random_range(&random, -0.125, 0.125);
        add_ragdoll(s, i, x, 0.25 + 2.25 * (i / columns), scene_random_range(&random, -2, 2));
    }
}

void fill_joint_grid(scene *s, int side) {
    for (int column = 0; column < side; column++)
        for (int row = 0; row < side; row++) {
            bool held = row == 0 && column >= side / 2 - 3 && column <= side / 2 + 3;
            scene_add_body(s, held ? SCENE_STATIC : SCENE_DYNAMIC, column, -row);
            scene_add_circle(s, 0.4)->group = -1;
            int me = column * side + row, left = me - side;
            if (row > 0)
                scene_tie(s, SCENE_HINGE, me - 1, me, column, -row + 0.5, 0);
            if (column > 0 && (!held || s->bodies[left].kind == SCENE_DYNAMIC))
                scene_tie(s, SCENE_HINGE, left, me, column - 0.5, -row, 0);
        }
}
