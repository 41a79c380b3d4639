/* newtons_cradle.c: three Newton's cradles, one above the other: touching balls side by side, each
 * on a string of its own from a bar.
 *
 * Bodies: for each cradle, from the top, the bar, then `size` balls from left to right. In cradle k
 * (1, 2, 3) the first k balls are lifted to the left on their strings, by the angle of a triangle
 * with the sides 3, 4 and 5. As many should swing out on the right, to the same height, and back.
 */
#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

static void fill(scene *s, int size) {
    const double string = 3, radius = 0.5, pitch = 5;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    for (int lifted = 1; lifted <= 3; lifted++) {
        double top = pitch * (2 - lifted) + 0.5 * string;
        int bar = s->body_count;
        scene_static_box(s, 0, top + 0.125, 0.5 * size + 0.25, 0.125);
        for (int i = 0; i < size; i++) {
            bool swings = i < lifted;
            double x = i - 0.5 * (size - 1);
            double ball_x = swings ? x - 0.6 * string : x;
            double ball_y = top - (swings ? 0.8 : 1) * string;
            int ball = part_circle(s, ball_x, ball_y, radius);
            s->bodies[ball].may_sleep = false;
            scene_tie_distance(s, bar, ball, x, top, ball_x, ball_y);
        }
    }
    s->camera_height = 3 * pitch + 1;
    s->camera_width = size + 7;
    s->spawn_y = 2 * pitch;
}

const scene_info scene_newtons_cradle = {SCENE_FACTS(newtons_cradle), .place = 205, .fill = fill};
