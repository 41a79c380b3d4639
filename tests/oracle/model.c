/* model.c: see model.h. Masses and moments of inertia by formula (disc r^2/2, box (a^2 + b^2)/12,
 * parallel axis theorem), and placing of shapes. */
#include "model.h"

#include <math.h>
#include <stdlib.h>

static const double PI = 3.14159265358979323846;

/* m: half the length of the segment that represents an endless line. */
static const double FLAT_HALF_WIDTH = 1e6;

static bool is_ground(const scene_shape *shape) {
    return shape->kind == SCENE_TERRAIN_FLAT || shape->kind == SCENE_TERRAIN_UNIFORM ||
           shape->kind == SCENE_TERRAIN_IRREGULAR;
}

static int vertex_count(const scene_shape *shape) {
    return shape->kind == SCENE_TERRAIN_FLAT ? 2 : shape->point_count;
}

static double area_of(const scene_shape *shape) {
    return shape->kind == SCENE_CIRCLE ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
}

/* Moment of inertia over mass, about the shape's own centre, m^2. */
static double gyration_squared(const scene_shape *shape) {
    double squares = shape->hx * shape->hx + shape->hy * shape->hy;
    return shape->kind == SCENE_CIRCLE ? squares / 2 : squares / 3;
}

/* Mass, centre and moment of inertia of a body. Sensors have mass too. */
static model_body weigh(const scene *s, const scene_body *source) {
    model_body body = {.dynamic = source->kind == SCENE_DYNAMIC};
    if (!body.dynamic)
        return body;
    const scene_shape *shapes = &s->shapes[source->first_shape];
    for (int i = 0; i < source->shape_count; i++) {
        double mass = shapes[i].material.density * area_of(&shapes[i]);
        body.mass += mass;
        body.center_x += mass * shapes[i].x;
        body.center_y += mass * shapes[i].y;
    }
    /* As in the engines, a dynamic body without mass gets 1 kg. */
    if (!(body.mass > 0)) {
        body.mass = body.inverse_mass = 1;
        return body;
    }
    body.center_x /= body.mass;
    body.center_y /= body.mass;
    body.inverse_mass = 1 / body.mass;
    if (source->fixed_rotation)
        return body;
    for (int i = 0; i < source->shape_count; i++) {
        double dx = shapes[i].x - body.center_x, dy = shapes[i].y - body.center_y;
        body.inertia += shapes[i].material.density * area_of(&shapes[i]) *
                        (gyration_squared(&shapes[i]) + dx * dx + dy * dy);
    }
    body.inverse_inertia = 1 / body.inertia;
    return body;
}

static depth_ground line_of(const scene *s, const scene_body *body, const scene_shape *shape,
                            scene_point *points) {
    int count = vertex_count(shape);
    for (int i = 0; i < count; i++) {
        double flat_x = i == 0 ? -FLAT_HALF_WIDTH : FLAT_HALF_WIDTH;
        scene_point p = shape->kind == SCENE_TERRAIN_FLAT
                            ? (scene_point){flat_x, shape->slope * flat_x}
                            : s->points[shape->first_point + i];
        points[i] = (scene_point){body->x + p.x, body->y + p.y};
    }
    return (depth_ground){points, count};
}

static void add_shapes(model *m) {
    scene_point *points = m->points;
    for (int b = 0; b < m->scene->body_count; b++) {
        const scene_body *body = &m->scene->bodies[b];
        for (int i = 0; i < body->shape_count; i++) {
            const scene_shape *source = &m->scene->shapes[body->first_shape + i];
            if (source->sensor)
                continue;
            model_shape *shape = &m->shapes[m->shape_count++];
            bool circle = source->kind == SCENE_CIRCLE;
            *shape = (model_shape){
                .source = source,
                .body = b,
                .ground = is_ground(source),
                .solid = {.circle = circle, .hx = source->hx, .hy = source->hy},
                .reach = circle ? source->hx : hypot(source->hx, source->hy),
                .size = HUGE_VAL,
            };
            if (shape->ground) {
                shape->line = line_of(m->scene, body, source, points);
                points += shape->line.count;
            } else if (m->bodies[b].dynamic) {
                shape->size = 2 * (circle ? source->hx : fmin(source->hx, source->hy));
            }
        }
    }
}

bool model_init(model *m, const scene *s) {
    size_t point_count = 0;
    for (int i = 0; i < s->shape_count; i++)
        if (is_ground(&s->shapes[i]))
            point_count += (size_t)vertex_count(&s->shapes[i]);
    *m = (model){
        .scene = s,
        .bodies = calloc((size_t)s->body_count + 1, sizeof *m->bodies),
        .shapes = calloc((size_t)s->shape_count + 1, sizeof *m->shapes),
        .points = calloc(point_count + 1, sizeof *m->points),
    };
    if (!tied_pairs_init(&m->tied, s) || !m->bodies || !m->shapes || !m->points) {
        model_free(m);
        return false;
    }
    for (int i = 0; i < s->body_count; i++)
        m->bodies[i] = weigh(s, &s->bodies[i]);
    add_shapes(m);
    return true;
}

void model_free(model *m) {
    free(m->bodies);
    free(m->shapes);
    free(m->points);
    tied_pairs_free(&m->tied);
    *m = (model){0};
}

static void place_shape(model_shape *shape, model_pose pose) {
    const scene_shape *source = shape->source;
    double c = pose.cosine, s = pose.sine;
    shape->solid.x = pose.x + source->x * c - source->y * s;
    shape->solid.y = pose.y + source->x * s + source->y * c;
    double turn_c = 1, turn_s = 0;
    if (source->kind == SCENE_OBB) {
        turn_c = cos(source->angle);
        turn_s = sin(source->angle);
    }
    /* Rotations in single precision are unit vectors to seven digits only. */
    double length = hypot(c, s);
    shape->solid.cosine = (c * turn_c - s * turn_s) / length;
    shape->solid.sine = (s * turn_c + c * turn_s) / length;
    if (!(length > 0 && isfinite(shape->solid.x) && isfinite(shape->solid.y)))
        shape->solid.x = shape->solid.y = NAN;
}

void model_place(model *m, int body, model_pose pose) {
    /* Shapes are in the order of their bodies: binary search for the body's first one. */
    int low = 0, high = m->shape_count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (m->shapes[middle].body < body)
            low = middle + 1;
        else
            high = middle;
    }
    for (int i = low; i < m->shape_count && m->shapes[i].body == body; i++)
        if (!m->shapes[i].ground)
            place_shape(&m->shapes[i], pose);
}

bool model_may_collide(const model *m, const model_shape *a, const model_shape *b) {
    const scene_shape *one = a->source, *other = b->source;
    if (a->body == b->body || (!m->bodies[a->body].dynamic && !m->bodies[b->body].dynamic) ||
        tied_pairs_have(&m->tied, a->body, b->body))
        return false;
    if (one->group == other->group && one->group != 0)
        return one->group > 0;
    return (one->category & other->mask) != 0 && (other->category & one->mask) != 0;
}
