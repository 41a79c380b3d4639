/* stack.c: see stack.h. */
#include "extremes/stack.h"

#include <math.h>

void stack_init(scene *s, int count, double size) {
    scene_init(s);
    scene_static_box(s, 0, -size, 10 * size, size);
    /* Not scene_dynamic_box's positions: they are rounded to multiples of 2^-16, too coarse for the
     * smallest size. */
    for (int i = 0; i < count; i++)
        scene_dynamic_box(s, 0, 0, 0.5 * size, 0.5 * size)->y = (i + 0.5) * size;
    s->bodies[0].y = -size;
}

double stack_lost(trial *t, int body, double size) {
    const engine_body *now = trial_read(t);
    const scene_body *start = trial_scene(t)->bodies;
    for (int i = 1; i <= body; i++)
        if (!(fabs(now[i].x - start[i].x) <= 0.5 * size))
            return INFINITY;
    return (start[body].y - now[body].y) / size;
}
