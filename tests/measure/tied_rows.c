/* tied_rows.c: scenes of bodies connected in a row: chains, beams, bridges, pendulums. See
 * tied_scenes.h. */
#include "tied_scenes.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* The shape that was added last does not collide with others of the same `thing`. */
static void belong(scene *s, int thing) {
    if (s->shape_count > 0)
        s->shapes[s->shape_count - 1].group = -1 - thing;
}

enum { SHAPE_BOX, SHAPE_CIRCLE };

static scene_body *add_part(scene *s, int thing, int shape, double x, double y, double hx,
                            double hy, double kg) {
    double area = shape == SHAPE_CIRCLE ? PI * hx * hx : 4 * hx * hy;
    s->material.density = kg / area;
    scene_body *body = shape == SHAPE_CIRCLE ? scene_dynamic_circle(s, x, y, hx)
                                             : scene_dynamic_box(s, x, y, hx, hy);
    belong(s, thing);
    return body;
}

static const double LINK = 0.5, BALL = 0.5;

/* Adds a chain that begins at (x, y) and is hinged to body `from`. */
static void add_chain(scene *s, int thing, const chain_scene *c, int from, double x, double y) {
    double right = c->level ? 1 : 0, down = c->level ? 0 : 1;
    for (int i = 0; i < c->links; i++) {
        double along = (i + 0.5) * LINK;
        double hx = c->level ? 0.5 * LINK : 0.125 * LINK, hy = c->level ? 0.125 * LINK : 0.5 * LINK;
        add_part(s, thing, SHAPE_BOX, x + along * right, y - along * down, hx, hy, 1);
    }
    double along = c->links * LINK + BALL;
    add_part(s, thing, SHAPE_CIRCLE, x + along * right, y - along * down, BALL, 0, c->weight);
    int first = s->body_count - 1 - c->links;
    for (int i = 0; i <= c->links; i++)
        scene_tie(s, SCENE_HINGE, i == 0 ? from : first + i - 1, first + i, x + i * LINK * right,
                  y - i * LINK * down, 0);
}

void fill_chain(scene *s, const chain_scene *c) {
    scene_static_box(s, 0, 0, 0.125, 0.125);
    belong(s, 0);
    add_chain(s, 0, c, 0, 0, 0);
}

double chain_length(const chain_scene *c) {
    return c->links * LINK;
}

void fill_chains(scene *s, int count) {
    for (int i = 0; i < count; i++) {
        chain_scene c = {.links = 50, .weight = 10, .level = true};
        double y = 2.0 * i;
        scene_static_box(s, 0, y, 0.125, 0.125);
        belong(s, 0);
        add_chain(s, 0, &c, s->body_count - 1, 0, y);
    }
}

void fill_cantilever(scene *s, int boxes, double tip) {
    static const double SIZE = 0.5;
    scene_static_box(s, -0.5, 0, 0.5, 2);
    belong(s, 0);
    for (int i = 0; i < boxes + (tip > 0); i++) {
        double kg = i < boxes ? SIZE * SIZE : tip;
        add_part(s, 0, SHAPE_BOX, (i + 0.5) * SIZE, 0, 0.5 * SIZE, 0.5 * SIZE, kg);
        scene_tie(s, SCENE_WELD, i, i + 1, i * SIZE, 0, 0);
    }
}

static const double PLANK = 1, PLANK_KG = 5;

static bool has_weight(const bridge_scene *b, int plank) {
    return (plank + 1) * b->weights / b->planks > plank * b->weights / b->planks;
}

/* A row of planks that hangs from a post, which pulls with the forces (across, up), in weights of a
 * plank. */
typedef struct hanging {
    double x, y, lowest; /* end of the planks relative to the post, and lowest point, m */
    double up;           /* vertical force at the end */
    double angle;        /* of the last plank, rad */
} hanging;

static void hang_next(const bridge_scene *b, int plank, double across, hanging *h) {
    double load = 1 + (has_weight(b, plank) ? b->kg / PLANK_KG : 0);
    h->angle = -atan2(h->up - 0.5 * load, across);
    h->up -= load;
    h->x += PLANK * cos(h->angle);
    h->y += PLANK * sin(h->angle);
    h->lowest = fmin(h->lowest, h->y);
}

static hanging hang_all(const bridge_scene *b, double across, double up) {
    hanging h = {.up = up};
    for (int i = 0; i < b->planks; i++)
        hang_next(b, i, across, &h);
    h.x -= b->span;
    return h;
}

/* Finds the forces at the left post with which the planks end at the right post, by Newton's method
 * in the logarithms of both forces, with numerical derivatives. */
static void find_forces(const bridge_scene *b, double *across, double *up) {
    static const double STEP = 1e-6;
    *across = b->planks + b->weights * b->kg / PLANK_KG;
    *up = 0.5 * *across;
    for (int i = 0; i < 200; i++) {
        hanging off = hang_all(b, *across, *up);
        hanging one = hang_all(b, *across * (1 + STEP), *up);
        hanging two = hang_all(b, *across, *up * (1 + STEP));
        double xa = (one.x - off.x) / STEP, ya = (one.y - off.y) / STEP;
        double xu = (two.x - off.x) / STEP, yu = (two.y - off.y) / STEP;
        double det = xa * yu - ya * xu;
        double by_across = (yu * off.x - xu * off.y) / det;
        double by_up = (xa * off.y - ya * off.x) / det;
        /* Each force changes by at most a half, so that both stay positive. */
        double part = fmin(1, 0.5 / fmax(fabs(by_across), fabs(by_up)));
        *across *= 1 - part * by_across;
        *up *= 1 - part * by_up;
    }
}

double bridge_sag(const bridge_scene *b) {
    double across, up;
    find_forces(b, &across, &up);
    return -hang_all(b, across, up).lowest;
}

/* Adds posts and planks; returns the index of the first plank. */
static int add_planks(scene *s, int thing, const bridge_scene *b, double x, double y) {
    scene_static_box(s, x - 0.25, y, 0.25, 0.25);
    belong(s, thing);
    scene_static_box(s, x + b->span + 0.25, y, 0.25, 0.25);
    belong(s, thing);
    int first = s->body_count;
    hanging h = {0};
    double across;
    find_forces(b, &across, &h.up);
    for (int i = 0; i < b->planks; i++) {
        hanging before = h;
        hang_next(b, i, across, &h);
        scene_body *plank =
            add_part(s, thing, SHAPE_BOX, x + 0.5 * (before.x + h.x), y + 0.5 * (before.y + h.y),
                     0.5 * PLANK, 0.125 * PLANK, PLANK_KG);
        plank->linear_damping = plank->angular_damping = 0.5;
        s->shapes[s->shape_count - 1].angle = h.angle;
        scene_tie(s, SCENE_HINGE, i == 0 ? first - 2 : first + i - 1, first + i, x + before.x,
                  y + before.y, 0);
    }
    scene_tie(s, SCENE_HINGE, first + b->planks - 1, first - 1, x + b->span, y, 0);
    return first;
}

void fill_bridge(scene *s, const bridge_scene *b) {
    int first = add_planks(s, 0, b, 0, 0);
    for (int i = 0; i < b->planks; i++) {
        if (!has_weight(b, i))
            continue;
        double x = s->bodies[first + i].x, y = s->bodies[first + i].y;
        scene_body *weight = add_part(s, 0, SHAPE_CIRCLE, x, y - 0.5, 0.25, 0, b->kg);
        weight->linear_damping = weight->angular_damping = 0.5;
        scene_tie(s, SCENE_HINGE, first + i, s->body_count - 1, x, y, 0);
    }
}

void fill_bridges(scene *s, int count) {
    for (int i = 0; i < count; i++) {
        bridge_scene b = {.planks = 50, .span = 48};
        double y = 20.0 * i;
        int first = add_planks(s, 0, &b, 0, y);
        for (int k = 0; k < 10; k++) {
            const scene_body *plank = &s->bodies[first + 5 * k + 2];
            s->material.density = 20;
            scene_dynamic_box(s, plank->x, plank->y + 1.5 + 0.25 * (k % 3), 0.5, 0.5);
        }
    }
}

void fill_boxed_bridge(scene *s, int planks) {
    bridge_scene b = {.planks = planks, .span = 0.96 * planks};
    int first = add_planks(s, 0, &b, 0, 0);
    for (int i = 2; i < planks; i += 5) {
        double x = s->bodies[first + i].x, y = s->bodies[first + i].y;
        double angle = s->shapes[s->bodies[first + i].first_shape].angle;
        s->material.density = 20;
        scene_dynamic_box(s, x - 0.395 * sin(angle), y + 0.395 * cos(angle), 0.25, 0.25);
        s->shapes[s->shape_count - 1].angle = angle;
    }
}

void fill_pendulum(scene *s, int bars) {
    scene_static_box(s, 0, 0, 0.125, 0.125);
    belong(s, 0);
    for (int i = 0; i < bars; i++)
        add_part(s, 0, SHAPE_BOX, i + 0.5, 0, 0.5, 0.0625, 1);
    for (int i = 0; i < bars; i++)
        scene_tie(s, SCENE_HINGE, i, i + 1, i, 0, 0);
}
