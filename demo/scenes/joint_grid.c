/* joint_grid.c: a plate of `size` times `size` circles, each hinged to its neighbours, which hangs
 * from static circles in the middle of its upper edge. A circle can rotate only with its
 * neighbours, and the static ones cannot rotate, so the plate is rigid: where it sags, hinges have
 * opened. The circles do not collide with each other.
 *
 * Bodies: column by column from the left, each from the top down. */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

static void fill(scene *s, int size) {
    const double radius = 0.4;
    int held = size / 2;
    for (int i = 0; i < size; i++)
        for (int k = 0; k < size; k++) {
            bool still = k == 0 && i >= held - 3 && i <= held + 3;
            double x = i - 0.5 * (size - 1);
            scene_add_body(s, still ? SCENE_STATIC : SCENE_DYNAMIC, x, -k);
            scene_add_circle(s, radius)->group = -1;
            int body = s->body_count - 1;
            if (k > 0)
                part_hinge(s, body - 1, body, (scene_point){x, 0.5 - k});
            /* No joint between two static circles. */
            if (i > 0 && !(still && i > held - 3))
                part_hinge(s, body - size, body, (scene_point){x - 0.5, -k});
        }
    s->camera_y = -0.6 * size;
    s->camera_height = 1.35 * size + 2;
    s->camera_width = size + 2;
    s->spawn_y = 3;
}

const scene_info scene_joint_grid = {SCENE_FACTS(joint_grid), .max_size = 300, .place = 330,
                                     .fill = fill};
