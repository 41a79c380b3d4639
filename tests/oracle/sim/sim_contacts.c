/* sim_contacts.c: finds the contacts of the reference simulation from the places of the bodies. */
#include "sim/sim.h"

#include "touch.h"

#include <math.h>
#include <stdlib.h>

/* A contact is created if its gap is below this share of the size plus the distance that the bodies
 * can travel. */
static const double ALERT = 1e-3;

bool sim_list_add(contact_list *list, const contact *c) {
    if (list->count == list->capacity) {
        int capacity = list->capacity > 0 ? 2 * list->capacity : 256;
        contact *grown = realloc(list->contacts, (size_t)capacity * sizeof *grown);
        if (!grown)
            return false;
        list->contacts = grown;
        list->capacity = capacity;
    }
    list->contacts[list->count++] = *c;
    return true;
}

static int smaller(int a, int b) {
    return a < b ? a : b;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

/* In most scenes bodies that were created one after the other are near each other, so that sorting
 * by bodies keeps the matrix near its diagonal. */
static int contact_order(const void *left, const void *right) {
    const contact *c = left, *d = right;
    int high = larger(c->body_a, c->body_b) - larger(d->body_a, d->body_b);
    int low = smaller(c->body_a, c->body_b) - smaller(d->body_a, d->body_b);
    return high != 0                  ? high
           : low != 0                 ? low
           : c->shape_a != d->shape_a ? c->shape_a - d->shape_a
           : c->shape_b != d->shape_b ? c->shape_b - d->shape_b
                                      : c->feature - d->feature;
}

static const contact *same_contact(const contact_list *list, const contact *like) {
    if (list->count == 0)
        return NULL;
    return bsearch(like, list->contacts, (size_t)list->count, sizeof *like, contact_order);
}

/* Upper bound of the distance that a shape can travel in the time, m. Contact forces may increase
 * it, which the next step takes into account. */
static double travel(const oracle *o, const model_shape *shape, double time) {
    const motion *v = &o->velocities[shape->body];
    const scene *s = o->model.scene;
    const scene_body *body = &s->bodies[shape->body];
    double fall = o->model.bodies[shape->body].dynamic
                      ? fabs(body->gravity_scale) * hypot(s->gravity_x, s->gravity_y) * time
                      : 0;
    double arm = shape->reach + hypot(shape->solid.x - o->places[shape->body].x,
                                      shape->solid.y - o->places[shape->body].y);
    return (hypot(v->x, v->y) + fall + fabs(v->turn) * arm) * time;
}

static bool add_point(oracle *o, near_pair pair, const touch_point *p) {
    const model_shape *a = &o->model.shapes[pair.a], *b = &o->model.shapes[pair.b];
    const scene_material *one = &a->source->material, *other = &b->source->material;
    const motion *place_a = &o->places[a->body], *place_b = &o->places[b->body];
    contact c = {
        .body_a = a->body,
        .body_b = b->body,
        .shape_a = pair.a,
        .shape_b = pair.b,
        .feature = p->feature,
        .x = p->x,
        .y = p->y,
        .normal_x = p->normal_x,
        .normal_y = p->normal_y,
        .arm_ax = p->x - place_a->x,
        .arm_ay = p->y - place_a->y,
        .arm_bx = p->x - place_b->x,
        .arm_by = p->y - place_b->y,
        .gap = p->gap,
        .size = fmin(a->size, b->size),
        .friction = sqrt(one->friction * other->friction),
        .restitution = fmax(one->restitution, other->restitution),
    };
    const contact *before = same_contact(&o->active, &c);
    /* A new contact is assumed open, unless its gap is closed. From this guess a column of contacts
     * closes from the ground up, one contact in each iteration. */
    c.state = before ? before->state : c.gap <= SIM_CLOSED * c.size ? CONTACT_STICK : CONTACT_OPEN;
    return sim_list_add(&o->found, &c);
}

bool sim_find_contacts(oracle *o, double time) {
    model *m = &o->model;
    for (int i = 0; i < m->scene->body_count; i++) {
        const motion *at = &o->places[i];
        double c = cos(at->turn), s = sin(at->turn);
        const model_body *body = &m->bodies[i];
        model_place(m, i,
                    (model_pose){at->x - body->center_x * c + body->center_y * s,
                                 at->y - body->center_x * s - body->center_y * c, c, s});
    }
    for (int i = 0; i < m->shape_count; i++) {
        double alert = isfinite(m->shapes[i].size) ? ALERT * m->shapes[i].size : 0;
        o->margins[i] = m->shapes[i].ground ? 0 : travel(o, &m->shapes[i], time) + alert;
    }
    if (!near_pairs_find(&o->near, m, o->margins))
        return false;
    o->found.count = 0;
    for (int i = 0; i < o->near.count; i++) {
        near_pair pair = o->near.pairs[i];
        const model_shape *a = &m->shapes[pair.a], *b = &m->shapes[pair.b];
        double margin = o->margins[pair.a] + o->margins[pair.b];
        touch_point points[TOUCH_GROUND_POINTS];
        int count = a->ground ? touch_ground(&a->line, &b->solid, margin, points)
                              : touch_pair(&a->solid, &b->solid, margin, points, NULL);
        for (int p = 0; p < count; p++)
            if (!add_point(o, pair, &points[p]))
                return false;
    }
    if (o->found.count > 0)
        qsort(o->found.contacts, (size_t)o->found.count, sizeof *o->found.contacts, contact_order);
    return true;
}
