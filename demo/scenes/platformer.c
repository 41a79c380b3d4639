/* platformer.c: boxes that never rotate, over storeys of tiles with gaps and stairs. */
#include "random.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* Height of a storey in tiles, and number of tiles for each body. */
enum { STOREY = 6, TILES_PER_BODY = 5 };

typedef struct layout {
    scene *s;
    int left; /* number of tiles that are still to be placed */
} layout;

static void tile(layout *l, int x, int y) {
    if (l->left > 0) {
        scene_static_box(l->s, x, y, 0.5, 0.5);
        l->left--;
    }
}

/* Adds one storey: platforms of 5 to 14 tiles with gaps between them, stairs on some of them, and a
 * wall at both ends. The lowest storey has no gaps. */
static void lay_storey(layout *l, scene_random *random, int width, int base) {
    for (int y = base; y < base + STOREY; y++) {
        tile(l, -1, y);
        tile(l, width, y);
    }
    int x = 0;
    while (x < width) {
        int end = x + (int)scene_random_range(random, 5, 15);
        bool stairs = scene_random_range(random, 0, 1) < 0.3;
        for (int i = 0; x < end && x < width; x++, i++) {
            tile(l, x, base);
            for (int step = 1; stairs && step <= i && step <= 3; step++)
                tile(l, x, base + step);
        }
        int gap = (int)scene_random_range(random, 2, 5);
        for (int i = 0; i < gap && x < width; i++, x++)
            if (base == 0)
                tile(l, x, base);
    }
}

/* Adds the moving bodies. Every fourth has no friction and slides over the seams of the tiles until
 * it meets a wall or a gap. */
static void add_walkers(scene *s, scene_random *random, int size, int width, int storeys) {
    int per_storey = (size + storeys - 1) / storeys;
    double spacing = (double)width / (per_storey + 1);
    for (int i = 0; i < size; i++) {
        double x = (i % per_storey + 1) * spacing;
        double y = i / per_storey * STOREY + 4.5;
        double hx = scene_random_range(random, 0.2, 0.4);
        double hy = scene_random_range(random, 0.2, 0.45);
        double vx = scene_random_range(random, 1, 5);
        s->material.friction = i % 4 == 0 ? 0 : 0.3;
        scene_add_body(s, SCENE_DYNAMIC, x, y)->vx = i % 2 == 0 ? vx : -vx;
        scene_add_aabb(s, hx, hy);
    }
}

static void fill(scene *s, int size) {
    layout l = {s, TILES_PER_BODY * size};
    int width = (int)(4 * sqrt(l.left)) + 4;
    scene_random random = {3};
    int storeys = 0;
    while (l.left > 0)
        lay_storey(&l, &random, width, STOREY * storeys++);
    add_walkers(s, &random, size, width, storeys);
    s->camera_x = 0.5 * width;
    s->camera_y = 0.5 * STOREY * storeys;
    s->camera_height = 1.1 * STOREY * storeys;
    s->spawn_x = s->camera_x;
    s->spawn_y = STOREY * storeys + 2;
}

const scene_info scene_platformer = {SCENE_FACTS(platformer), .place = 70, .fill = fill};
