/* test_internal_edges_random.c: bodies are dropped and slid onto random heaps of static shapes,
 * which are side by side, flush, overlapping, or slightly offset. The bodies must not overlap a
 * shape, pass through it, or rest without support. Overlap is computed by exact geometry of every
 * pair (geometry_exact.h). A fault counts where the same world without internal edges
 * (contact/internal_edges.h) has none; faults of both are only limited in number. */
#include "engine_support.h"

#include "geometry_exact.h"
#include "geometry_random.h"
#include "state/world.h"

/* Static shapes and terrain vertices at most; steps of a case; step by which bodies have
 * settled. */
enum { STATICS = 9, VERTICES = 6, STEPS = 150, SETTLED = 120 };

/* Lengths in length scales; chosen. */
#define OVERLAP 0.012 /* of a settled body; soft contacts under a single body overlap by less */
#define NEAR 0.012    /* greatest distance of a resting body from its support */
#define REST 0.002    /* speed per second below which a body is at rest */

/* A case. Lengths are in length scales, and are scaled when the world is made. */
typedef struct heap {
    thud_geometry shapes[STATICS], body;
    double angles[STATICS], body_angle;
    int count;
    thud_pos line[VERTICES]; /* vertices of the terrain; there is none where `vertices` is 0 */
    int vertices;
    double scale, speed;
    float friction;
    const thud_detection *detection;
    const thud_quality *quality;
    bool joined; /* all shapes belong to one kinematic body */
} heap;

/* ---- heaps ---- */

/* A random size whose logarithm is uniform. */
static double draw_size(source *r, double least, double most) {
    return exp(draw(r, log(least), log(most)));
}

/* A gap between neighbours: 0, or about the tolerance up to which shapes count as flush. */
static double draw_gap(source *r) {
    static const double gaps[] = {0, 0, 0, 1e-5, 1e-4, 1e-3, 2e-3, 1e-2, 0.05};
    double gap = gaps[draw_below(r, 9)];
    return draw_below(r, 2) ? gap * draw(r, 0.8, 1.2) : -gap;
}

/* Rotates a shape; a rotated AABB becomes an OBB. */
static void turn_to(thud_geometry *shape, double *angle, double to) {
    *angle = to;
    shape->kind = to == 0.0 && shape->kind == THUD_SHAPE_AABB ? THUD_SHAPE_AABB : THUD_SHAPE_OBB;
    set_angle(shape, to);
}

/* Moves the shape to (u, v) in the frame's coordinates. */
static void move_in_frame(thud_geometry *shape, const thud_geometry *frame, double u, double v) {
    shape->x = frame->x + frame->c * u - frame->s * v;
    shape->y = frame->y + frame->s * u + frame->c * v;
}

/* Adds a box in a random relation to a box of the heap. */
static void add_related_box(source *r, heap *h) {
    int i = h->count++, of = draw_below(r, i);
    const thud_geometry *frame = &h->shapes[of];
    thud_geometry *box = &h->shapes[i];
    *box = (thud_geometry){.kind = draw_below(r, 2) ? THUD_SHAPE_AABB : THUD_SHAPE_OBB,
                           .c = 1.0,
                           .hx = draw_size(r, 0.05, 3),
                           .hy = draw_size(r, 0.05, 3)};
    if (draw_below(r, 3) == 0) {
        box->hx = frame->hx;
        box->hy = frame->hy;
    }
    turn_to(box, &h->angles[i], h->angles[of]);
    double side = draw_below(r, 2) ? 1.0 : -1.0, up = draw_below(r, 4) ? 1.0 : -1.0;
    double flush_v = up * (frame->hy - box->hy) + draw_gap(r);
    double flush_u = side * (frame->hx - box->hx) + draw_gap(r);
    switch (draw_below(r, 8)) {
    case 0: /* next to it, flush */
    case 1:
    case 2:
        move_in_frame(box, frame, side * (frame->hx + box->hx + draw_gap(r)), flush_v);
        break;
    case 3: /* on it or below it, with one side flush */
        move_in_frame(box, frame, flush_u, up * (frame->hy + box->hy + draw_gap(r)));
        break;
    case 4: /* inside it, flush */
        move_in_frame(box, frame, draw(r, -frame->hx, frame->hx), flush_v);
        break;
    case 5: /* anywhere across it */
        move_in_frame(box, frame, draw(r, -1, 1) * frame->hx, draw(r, -1, 1) * frame->hy);
        break;
    case 6: /* next to it, not flush */
        move_in_frame(box, frame, side * (frame->hx + box->hx + draw_gap(r)),
                      draw(r, -1, 1) * (frame->hy + box->hy));
        break;
    default: /* next to it, turned by a right angle, or by a little about an upper corner */
        if (draw_below(r, 2)) {
            box->hx = frame->hy;
            box->hy = frame->hx;
            turn_to(box, &h->angles[i], h->angles[of] + TD_PI / 2);
            move_in_frame(box, frame, draw_gap(r), draw_gap(r));
        } else {
            double turn = draw(r, -0.3, 0.3), c = cos(turn), s = sin(turn);
            turn_to(box, &h->angles[i], h->angles[of] + turn);
            double u = side * box->hx, v = -box->hy;
            move_in_frame(box, frame, side * frame->hx + c * u - s * v, frame->hy + s * u + c * v);
        }
    }
}

/* Adds a terrain that begins next to an upper corner of a box. */
static void add_line(source *r, heap *h) {
    const thud_geometry *box = &h->shapes[draw_below(r, h->count)];
    double side = draw_below(r, 2) ? 1.0 : -1.0, x = box->x + side * (box->hx + draw_gap(r));
    double y = box->y + box->hy + draw_gap(r);
    h->vertices = VERTICES;
    for (int i = 0; i < VERTICES; i++) {
        h->line[side > 0 ? i : VERTICES - 1 - i] = (thud_pos){x, y};
        x += side * draw_size(r, 0.1, 3);
        y += draw_below(r, 2) ? 0.0 : draw(r, -0.5, 0.3);
    }
}

/* Whether the body is at least 0.05 away from all shapes. */
static bool is_clear(const heap *h, const thud_geometry *body) {
    solid b = solid_of(body, 0, 0);
    for (int i = 0; i < h->count; i++) {
        solid s = solid_of(&h->shapes[i], 0, 0);
        if (solids_distance(&s, &b) < 0.05L) {
            return false;
        }
    }
    for (int i = 0; i < h->vertices; i++) {
        if (fabs(h->line[i].x - body->x) < 8 && h->line[i].y > body->y - 2.5) {
            return false;
        }
    }
    return true;
}

/* Adds the body that falls, somewhat above a shape and overlapping none. */
static void add_faller(source *r, heap *h) {
    static const thud_shape_kind kinds[] = {THUD_SHAPE_CIRCLE, THUD_SHAPE_AABB, THUD_SHAPE_OBB};
    const thud_geometry *over = &h->shapes[draw_below(r, h->count)];
    thud_geometry *b = &h->body;
    *b = (thud_geometry){.kind = kinds[draw_below(r, 3)], .c = 1.0, .hx = draw_size(r, 0.05, 1)};
    b->hy = b->kind == THUD_SHAPE_CIRCLE ? 0 : draw_size(r, 0.05, 1);
    h->body_angle = b->kind == THUD_SHAPE_OBB && draw_below(r, 2) ? draw(r, -3, 3) : 0;
    set_angle(b, h->body_angle);
    b->x = over->x + draw(r, -1, 1) * over->hx;
    b->y = over->y;
    while (!is_clear(h, b)) {
        b->y += 0.1;
    }
    h->speed = draw_below(r, 2) ? 0 : draw(r, -5, 5);
}

/* Draws a case. */
static heap draw_heap(source *r) {
    static const double scales[] = {1, 1, 0.01, 100};
    heap h = {.count = 1, .scale = scales[draw_below(r, 4)]};
    double angle = draw_below(r, 3) ? 0.0 : draw_below(r, 2) ? draw(r, -0.6, 0.6) : TD_PI / 2;
    h.shapes[0] = (thud_geometry){.kind = THUD_SHAPE_AABB,
                                  .c = 1.0,
                                  .hx = draw_size(r, 0.5, 20),
                                  .hy = draw_size(r, 0.2, 5)};
    turn_to(&h.shapes[0], &h.angles[0], angle);
    int boxes = 2 + draw_below(r, STATICS - 2);
    while (h.count < boxes) {
        add_related_box(r, &h);
    }
    if (draw_below(r, 4) == 0) {
        const thud_geometry *box = &h.shapes[draw_below(r, boxes)];
        h.shapes[h.count++] = (thud_geometry){.kind = THUD_SHAPE_CIRCLE,
                                              .c = 1.0,
                                              .hx = 0.5,
                                              .x = box->x,
                                              .y = box->y + box->hy - 0.5};
    }
    if (draw_below(r, 4) == 0) {
        add_line(r, &h);
    }
    h.friction = draw_below(r, 3) ? 0.6f : 0.0f;
    h.detection = draw_below(r, 4) ? &thud_detection_continuous : &thud_detection_swept;
    add_faller(r, &h);
    h.quality = draw_below(r, 2)   ? &thud_quality_default
                : draw_below(r, 2) ? &thud_quality_high
                                   : &thud_quality_exact;
    h.detection = draw_below(r, 8) ? h.detection : &thud_detection_bisect;
    h.joined = draw_below(r, 4) == 0;
    return h;
}

/* ---- worlds ---- */

static thud_body_id add_placed(thud_world *world, const heap *h, const thud_geometry *p,
                               double angle, bool moves) {
    thud_shape_def def = thud_default_shape_def();
    def.friction = h->friction;
    thud_body_id body = add_body(world, moves ? THUD_BODY_DYNAMIC : THUD_BODY_STATIC,
                                 p->x * h->scale, p->y * h->scale, angle);
    add_shape(world, body, (float)(p->hx * h->scale), (float)(p->hy * h->scale),
              p->kind == THUD_SHAPE_AABB, &def);
    return body;
}

/* AABBs would keep the body from rotating; it is kinematic and does not, so that the boxes of
 * either kind keep the rotations of the heap. */
static void add_joined(thud_world *world, const heap *h) {
    thud_body_id body = add_body(world, THUD_BODY_KINEMATIC, 0, 0, 0);
    thud_shape_def def = thud_default_shape_def();
    def.friction = h->friction;
    for (int i = 0; i < h->count; i++) {
        const thud_geometry *p = &h->shapes[i];
        thud_vec2 at = {(float)(p->x * h->scale), (float)(p->y * h->scale)};
        thud_vec2 half = {(float)(p->hx * h->scale), (float)(p->hy * h->scale)};
        if (p->kind == THUD_SHAPE_CIRCLE) {
            OK(thud_shape_create_circle(world, body, &def, at, half.x, NULL));
        } else if (p->kind == THUD_SHAPE_AABB) {
            OK(thud_shape_create_aabb(world, body, &def, at, half, NULL));
        } else {
            OK(thud_shape_create_obb(world, body, &def, at, half, h->angles[i], NULL));
        }
    }
}

/* Creates the case's world, with internal edges where `seams` is set, else without them. */
static thud_world *make_heap(const heap *h, bool seams, thud_body_id *body) {
    thud_world_def def = thud_default_world_def_of(h->quality);
    def.length_scale = (float)h->scale;
    def.gravity.y = (float)(-10 * h->scale);
    def.detection = h->detection;
    thud_world *world = make_world(def);
    for (int i = 0; i < h->count && !h->joined; i++) {
        add_placed(world, h, &h->shapes[i], h->angles[i], false);
    }
    if (h->joined) {
        add_joined(world, h);
    }
    if (h->vertices) {
        thud_pos points[VERTICES];
        for (int i = 0; i < VERTICES; i++) {
            points[i] = (thud_pos){h->line[i].x * h->scale, h->line[i].y * h->scale};
        }
        thud_shape_def shape = thud_default_shape_def();
        shape.friction = h->friction;
        thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = VERTICES};
        thud_body_id ground = add_body(world, THUD_BODY_STATIC, 0, 0, 0);
        OK(thud_shape_create_terrain(world, ground, &shape, &line, NULL));
    }
    *body = add_placed(world, h, &h->body, h->body_angle, true);
    OK(thud_body_set_velocity(world, *body, (thud_vec2){(float)(h->speed * h->scale), 0}, 0));
    world->internal_edges = seams ? world->internal_edges : NULL;
    return world;
}

/* ---- outcomes ---- */

/* What happened to the body. Lengths in length scales. */
typedef struct outcome {
    double overlap; /* deepest overlap with a shape, in the best step after it settled */
    double nearest; /* distance from the nearest shape at the end */
    double inside;  /* greatest depth of its centre in a shape */
    double speed;   /* at the end */
    double energy;  /* greatest gain per mass, in (length scales / s)^2 */
    double x, y;
} outcome;

/* Distance of the body from the nearest shape or the terrain, in length scales; exact except at the
 * terrain's ends. */
static double least_distance(const heap *h, const thud_geometry *body) {
    solid b = solid_of(body, 0, 0);
    double least = 1e9;
    for (int i = 0; i < h->count; i++) {
        solid s = solid_of(&h->shapes[i], 0, 0);
        least = fmin(least, (double)solids_distance(&s, &b));
    }
    for (int k = 0; k < 48 && h->vertices; k++) {
        thud_pos p = outline(body, k / 48.0);
        for (int i = 0; i + 1 < VERTICES; i++) {
            const thud_pos *from = &h->line[i], *to = from + 1;
            double x = body->x + p.x - from->x, width = to->x - from->x;
            double slope = (to->y - from->y) / width;
            if (x >= 0 && x <= width) {
                double above = (body->y + p.y - from->y - slope * x) / hypot(1, slope);
                double left = h->line[0].x - body->x - p.x;
                double right = body->x + p.x - h->line[VERTICES - 1].x;
                least = fmin(least, fmax(above, fmax(left, right)));
            }
        }
    }
    return least;
}

/* Depth of the body's centre in a shape; 0 outside. */
static double middle_inside(const heap *h, const thud_geometry *body) {
    double most = 0;
    for (int i = 0; i < h->count; i++) {
        const thud_geometry *s = &h->shapes[i];
        most = fmax(most, -point_distance(s, body->x - s->x, body->y - s->y));
    }
    return most;
}

/* Runs the heap with or without internal edges. */
static outcome watch(const heap *h, bool seams) {
    thud_body_id id;
    thud_world *world = make_heap(h, seams, &id);
    outcome out = {.overlap = 1e9};
    double start = 0.5 * h->speed * h->speed + 10 * h->body.y;
    for (int step = 1; step <= STEPS; step++) {
        run(world, 1);
        thud_body_state s = state_of(world, id);
        thud_geometry now = h->body;
        now.x = s.position.x / h->scale;
        now.y = s.position.y / h->scale;
        set_angle(&now, s.angle);
        out.x = now.x;
        out.y = now.y;
        out.speed = hypot((double)s.velocity.x, (double)s.velocity.y) / h->scale;
        out.inside = fmax(out.inside, middle_inside(h, &now));
        out.energy = fmax(out.energy, out.speed * (0.5 * out.speed - 0.1) + 10 * now.y - start);
        if (step > SETTLED) {
            out.nearest = least_distance(h, &now);
            out.overlap = fmin(out.overlap, -out.nearest);
        }
        if (now.y < -60) { /* it has fallen beside the heap */
            break;
        }
    }
    thud_world_destroy(world);
    return out;
}

/* What is wrong with an outcome; null: nothing. The bounds of depth and energy are chosen. */
static const char *fault_of(const outcome *o) {
    return o->overlap > OVERLAP                   ? "overlaps"
           : o->inside > 0.02                     ? "was inside"
           : o->speed < REST && o->nearest > NEAR ? "rests on nothing"
           : o->energy > 0.3                      ? "gained energy"
                                                  : NULL;
}

/* Prints a case and its outcome, so that a failure can be repeated. */
static void describe(const heap *h, const outcome *o) {
    for (int i = 0; i < h->count; i++) {
        const thud_geometry *s = &h->shapes[i];
        print_message("  kind %d at %.9g, %.9g half %.9g, %.9g angle %.9g\n", (int)s->kind, s->x,
                      s->y, s->hx, s->hy, h->angles[i]);
    }
    for (int i = 0; i < h->vertices; i++) {
        print_message("  vertex %.9g, %.9g\n", h->line[i].x, h->line[i].y);
    }
    const thud_geometry *b = &h->body;
    print_message(
        "  body: kind %d at %.9g, %.9g half %.9g, %.9g angle %.9g speed %.9g scale %g "
        "friction %g %s %s%s\n  ends at %.9g, %.9g: overlap %g, inside %g, speed %g, nearest "
        "%g, energy %g\n",
        (int)b->kind, b->x, b->y, b->hx, b->hy, h->body_angle, h->speed, h->scale,
        (double)h->friction, thud_detection_name(h->detection),
        h->quality->islands ? "direct" : "soft", h->joined ? " joined" : "", o->x, o->y, o->overlap,
        o->inside, o->speed, o->nearest, o->energy);
}

static void bodies_on_random_heaps_never_overlap_them_nor_rest_on_nothing(void **state) {
    (void)state;
    int faults = 0, not_of_seams = 0, count = case_count(8000);
    for (int i = 0; i < count; i++) {
        source r = {0x9e3779b97f4a7c15ull * (uint64_t)(i + 1)};
        heap h = draw_heap(&r);
        outcome o = watch(&h, true);
        const char *fault = fault_of(&o);
        if (!fault) {
            continue;
        }
        outcome plain = watch(&h, false);
        if (fault_of(&plain)) {
            not_of_seams++;
        } else {
            print_message("heap %d: %s\n", i, fault);
            describe(&h, &o);
            faults++;
        }
    }
    assert_int_equal(faults, 0);
    assert_true(not_of_seams <= 5 + count / 500);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bodies_on_random_heaps_never_overlap_them_nor_rest_on_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
