/* walker.c: walking linkages: Theo Jansen's, with the lengths that he published, and Joe Klann's,
 * as drawn in his patent (US 6,260,862). One motor turns the crank; all other joints are hinges.
 *
 * Bodies: the ground (irregular terrain), then for each walker its frame, its crank and its legs.
 */
#include "walker.h"

#include "parts.h"
#include "scene_facts.h"
#include "scenes.h"

#include <math.h>

/* The state of adding a walker. A leg is described in coordinates relative to the crank's axle, for
 * the left side; it is mirrored for the right side. */
typedef struct builder {
    scene *scene;
    scene_point axle;   /* the crank's axle in the world */
    double scale, side; /* metres per unit of the leg's description; -1: mirrored */
    int frame, crank;
} builder;

/* A place of the leg's description in the world. */
static scene_point place(const builder *b, scene_point p) {
    return (scene_point){b->axle.x + b->side * b->scale * p.x, b->axle.y + b->scale * p.y};
}

/* The distance of two places. */
static double away(scene_point a, scene_point b) {
    double dx = b.x - a.x, dy = b.y - a.y;
    return sqrt(dx * dx + dy * dy);
}

static int bar(const builder *b, scene_point from, scene_point to) {
    return part_bar(b->scene, place(b, from), place(b, to), 0.06, 0);
}

/* Adds a body that connects three places, by two bars, or by three if `closed`. */
static int plate(const builder *b, scene_point p, scene_point q, scene_point r, bool closed) {
    int body = bar(b, p, q);
    part_add_bar(b->scene, place(b, q), place(b, r), 0.06);
    if (closed)
        part_add_bar(b->scene, place(b, r), place(b, p), 0.06);
    return body;
}

/* Adds a foot to the latest body. */
static void foot(const builder *b, scene_point p) {
    scene *s = b->scene;
    scene_shape *shape = scene_add_circle(s, 0.14);
    scene_point at = place(b, p);
    if (s->failed)
        return;
    shape->x = at.x - s->bodies[s->body_count - 1].x;
    shape->y = at.y - s->bodies[s->body_count - 1].y;
    shape->material.friction = 1.5;
}

/* Hinges two bodies together. */
static void pin(const builder *b, int one, int other, scene_point p) {
    part_hinge(b->scene, one, other, place(b, p));
}

/* Adds a leg of Jansen's. Lengths are in his units, named by his letters. The crank has radius 15;
 * the fixed axle is 38 beside the crank's and 7.8 below. */
static void add_jansen_leg(const builder *b, scene_point crank) {
    const double j = 50, k = 61.9, b_ = 41.5, c = 39.3, d = 40.1, e = 55.8, f = 39.4, g = 36.7,
                 h = 65.7, i = 49;
    const scene_point fixed = {-38, -7.8};
    scene_point top = part_meeting(fixed, b_, crank, j);
    scene_point low = part_meeting(crank, k, fixed, c);
    scene_point out = part_meeting(fixed, d, top, e);
    scene_point knee = part_meeting(low, g, out, f);
    scene_point toe = part_meeting(low, i, knee, h);
    int upper_rod = bar(b, crank, top), lower_rod = bar(b, crank, low);
    int upper = plate(b, fixed, top, out, true), rocker = bar(b, fixed, low);
    int link = bar(b, out, knee);
    int leg = plate(b, knee, low, toe, true);
    foot(b, toe);
    pin(b, b->crank, upper_rod, crank);
    pin(b, b->crank, lower_rod, crank);
    pin(b, b->frame, upper, fixed);
    pin(b, b->frame, rocker, fixed);
    pin(b, upper_rod, upper, top);
    pin(b, lower_rod, leg, low);
    pin(b, rocker, leg, low);
    pin(b, upper, link, out);
    pin(b, link, leg, knee);
}

/* Adds a leg of Klann's. The places are those with the crank horizontal, relative to its axle; at
 * other angles of the crank the lengths between them are kept. */
static void add_klann_leg(const builder *b, scene_point crank) {
    const scene_point high = {-0.233, 0.616}, deep = {-0.59, -0.176};
    const scene_point pin0 = {-0.268, 0}, elbow0 = {-0.858, 0}, knee0 = {-1.367, 0.116},
                      hip0 = {-0.733, 0.75}, toe0 = {-1.599, -0.75};
    scene_point elbow = part_meeting(deep, away(deep, elbow0), crank, away(pin0, elbow0));
    scene_point knee = part_meeting(elbow, away(elbow0, knee0), crank, away(pin0, knee0));
    scene_point hip = part_meeting(knee, away(knee0, hip0), high, away(high, hip0));
    scene_point toe = part_meeting(hip, away(hip0, toe0), knee, away(knee0, toe0));
    int arm = plate(b, crank, elbow, knee, false);
    int lower = bar(b, deep, elbow), upper = bar(b, high, hip);
    int leg = plate(b, hip, knee, toe, false);
    foot(b, toe);
    pin(b, b->crank, arm, crank);
    pin(b, b->frame, lower, deep);
    pin(b, lower, arm, elbow);
    pin(b, b->frame, upper, high);
    pin(b, upper, leg, hip);
    pin(b, arm, leg, knee);
}

/* The crank's pins, as fractions of its radius: at thirds of a turn, and at halves. */
static const scene_point THIRDS[] = {{1, 0},
                                     {-0.5, 0.8660254037844386},
                                     {-0.5, -0.8660254037844386}};
static const scene_point HALVES[] = {{-1, 0}, {1, 0}};

typedef struct make {
    const scene_point *turns;
    int turn_count;
    double scale, radius, height; /* of the leg's units: factor to metres, the crank's radius, its
                                     axle's height above the ground */
    scene_point fixed[2];         /* the hinges of the legs on the frame */
    double speed;                 /* of the crank, rad/s */
    void (*add_leg)(const builder *b, scene_point crank);
} make;

static const make MAKES[] = {
    {THIRDS, 3, 0.045, 15, 95, {{-38, -7.8}, {-38, -7.8}}, -2, add_jansen_leg},
    {HALVES, 2, 2.1, 0.268, 0.82, {{-0.233, 0.616}, {-0.59, -0.176}}, 2.4, add_klann_leg},
};

void walker_add(scene *s, int number, double x) {
    const make *m = &MAKES[number % 2];
    builder b = {.scene = s, .axle = {x, m->scale * m->height}, .scale = m->scale, .side = 1};
    s->material.density = 60;
    b.frame = s->body_count;
    scene_add_body(s, SCENE_DYNAMIC, b.axle.x, b.axle.y);
    for (int i = 0; i < 2; i++) {
        scene_point left = place(&b, m->fixed[i]);
        part_add_bar(s, left, (scene_point){2 * b.axle.x - left.x, left.y}, 0.1);
    }
    s->material.density = 2;
    b.crank = part_circle(s, b.axle.x, b.axle.y, m->scale * m->radius);
    scene_joint *motor = part_hinge(s, b.frame, b.crank, b.axle);
    motor->drive[SCENE_TURN].motor_speed = m->speed;
    for (int i = 0; i < m->turn_count; i++)
        for (int side = -1; side <= 1; side += 2) {
            b.side = side;
            m->add_leg(&b,
                       (scene_point){side * m->radius * m->turns[i].x, m->radius * m->turns[i].y});
        }
    double weight = 0;
    for (int i = b.frame; i < s->body_count; i++)
        weight += 10 * part_mass(s, i);
    for (int i = 0; !s->failed && i < s->joint_count; i++)
        if (s->joints[i].body[0] == b.frame && s->joints[i].body[1] == b.crank)
            s->joints[i].drive[SCENE_TURN].motor_force = 4 * weight * m->scale * m->radius;
    part_keep_apart(s, b.frame, -1 - number);
}

static void fill(scene *s, int size) {
    double right = 12.0 * size;
    const scene_point land[] = {{-60, 3},          {-40, 0},          {right, 0},
                                {right + 6, 0.4},  {right + 10, 0.2}, {right + 17, 0.9},
                                {right + 24, 0.5}, {right + 40, 4}};
    s->material = (scene_material){.density = 2, .friction = 0.9};
    scene_add_body(s, SCENE_STATIC, 0, 0);
    scene_add_irregular(s, land, sizeof land / sizeof land[0]);
    for (int i = 0; i < size; i++)
        walker_add(s, i, 12.0 * (i - 0.5 * (size - 1)));
    s->camera_y = 4;
    s->camera_x = 3;
    s->camera_height = 9 + 6.5 * size;
    s->camera_width = 14 * size;
    s->spawn_y = 9;
}

const scene_info scene_walker = {SCENE_FACTS(walker), .place = 270, .fill = fill};
