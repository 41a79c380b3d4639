/* crowd.c: see crowd.h. */
#include "catalogue/crowd.h"

#include "random.h"

#include <math.h>
#include <thud/thud_listeners.h>

enum { WALLS = 4, SEED = 9 };

/* A random radius. A new `scene_random` with SEED gives the same sequence of radii each time. */
static double next_radius(const crowd *c, scene_random *random) {
    double octave = c->least;
    while (2 * octave <= c->most && scene_random_range(random, 0, 1) < 0.5)
        octave *= 2;
    return fmin(octave * scene_random_range(random, 1, 2), c->most);
}

double crowd_area_filled(const crowd *c, double part) {
    scene_random random = {SEED};
    double sum = 0;
    for (int i = 0; i < c->bodies; i++) {
        double radius = next_radius(c, &random);
        sum += 3.14159265358979 * radius * radius;
    }
    return sum / c->bodies / part;
}

/* Gives the body this speed in a random direction, that of a random point of the unit disc:
 * uniform, without trigonometry. */
static void set_flying(scene_body *body, double speed, scene_random *random) {
    double x, y, length;
    do {
        x = scene_random_range(random, -1, 1);
        y = scene_random_range(random, -1, 1);
        length = hypot(x, y);
    } while (length < 0.1 || length > 1);
    body->vx = speed * x / length;
    body->vy = speed * y / length;
}

void crowd_fill(const crowd *c, scene *s) {
    double half =
        0.5 * sqrt(c->area * c->bodies); /* half the side of the square with the centres */
    double wall = half + c->most;
    s->gravity_y = 0;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    scene_static_box(s, 0, -wall - 1, wall + 2, 1);
    scene_static_box(s, 0, wall + 1, wall + 2, 1);
    scene_static_box(s, -wall - 1, 0, 1, wall);
    scene_static_box(s, wall + 1, 0, 1, wall);
    scene_random sizes = {SEED}, places = {SEED + 1};
    for (int i = 0; i < c->bodies; i++) {
        double x = scene_random_range(&places, -half, half);
        double y = scene_random_range(&places, -half, half);
        scene_body *body = scene_dynamic_circle(s, x, y, next_radius(c, &sizes));
        if (i < c->moving * c->bodies)
            set_flying(body, c->speed, &places);
    }
}

static bool is_wall(thud_body_id body) {
    return body.index1 <= WALLS;
}

/* A prologue that lets bodies collide with the walls only. */
static bool throws_back(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)world, (void)settings, (void)context;
    return is_wall(contact->body_a) || is_wall(contact->body_b);
}

void crowd_passes_through(thud_world *world) {
    thud_world_set_listeners(world, &(thud_listeners){.prologue = throws_back});
}

long crowd_overlaps(const scene *s) {
    long count = 0;
    for (int i = WALLS; i < s->body_count; i++)
        for (int k = WALLS; k < i; k++) {
            const scene_body *a = &s->bodies[i], *b = &s->bodies[k];
            double reach = s->shapes[a->first_shape].hx + s->shapes[b->first_shape].hx;
            double dx = a->x - b->x, dy = a->y - b->y;
            count += dx * dx + dy * dy <= reach * reach;
        }
    return count;
}
