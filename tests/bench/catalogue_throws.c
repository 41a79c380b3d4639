/* catalogue_throws.c: balls thrown at an upright wall, against their parabolas. What is wrong with
 * the place of a hit is the engine's integration, the straight way that a test of motions takes for
 * the curve, and, of the tests that know only the ends of steps, the rest of the step. */
#include "catalogue.h"
#include "catalogue_ways.h"

#include <math.h>

enum { BALLS = 64, RATE_COUNT = 4 };

static const double RATES[RATE_COUNT] = {30, 60, 120, 240}; /* steps a second */
static const double GRAVITY = 10, RADIUS = 0.1, WALL_FACE = 20, VX = 20, VY = 5;

typedef struct throw_errors {
    double flight; /* worst distance of a centre from its parabola at the end of a step, before the
                      hit */
    double worst, sum; /* of the places of the hits, along the wall */
    int hits;
} throw_errors;

/* The wall, then the balls, which do not meet each other; they are thrown from all parts of a
 * step's way. */
static void fill(scene *s, double time_step) {
    s->gravity_y = -GRAVITY;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 0.5};
    scene_static_box(s, WALL_FACE + 1, 0, 1, 1000);
    for (int i = 0; i < BALLS; i++) {
        scene_body *ball = scene_dynamic_circle(s, -VX * time_step * i / BALLS, i, RADIUS);
        ball->vx = VX;
        ball->vy = VY;
        s->shapes[s->shape_count - 1].group = -1;
    }
}

static double height_after(const scene_body *ball, double time) {
    return ball->y + VY * time - 0.5 * GRAVITY * time * time;
}

static double time_of_hit(const scene_body *ball) {
    return (WALL_FACE - RADIUS - ball->x) / VX;
}

static void compare_flights(const scene *s, const way_world *w, double time, throw_errors *e) {
    for (int i = 1; i < w->count; i++) {
        const scene_body *ball = &s->bodies[i];
        thud_body_state now;
        if (time > time_of_hit(ball) - 0.05 ||
            thud_body_get(w->world, w->bodies[i], &now) != THUD_OK)
            continue;
        double dx = now.position.x - (ball->x + VX * time);
        double dy = now.position.y - height_after(ball, time);
        e->flight = fmax(e->flight, hypot(dx, dy));
    }
}

/* A ball's first hit only: it falls along the wall afterwards. */
static void compare_hits(const scene *s, const way_world *w, bool *hit, throw_errors *e) {
    thud_events events = thud_world_events(w->world);
    for (int k = 0; k < events.hit_count; k++) {
        const thud_hit_event *event = &events.hit[k];
        thud_shape_state a, b;
        if (thud_shape_get(w->world, event->shape_a, &a) != THUD_OK ||
            thud_shape_get(w->world, event->shape_b, &b) != THUD_OK)
            continue;
        /* Slots are given out in the scene's order, and the wall's is the first. */
        uint32_t i = (a.body.index1 > b.body.index1 ? a.body.index1 : b.body.index1) - 1;
        if (hit[i])
            continue;
        hit[i] = true;
        const scene_body *ball = &s->bodies[i];
        double error = fabs(event->point.y - height_after(ball, time_of_hit(ball)));
        e->worst = fmax(e->worst, error);
        e->sum += error;
        e->hits++;
    }
}

static bool throw_all(const thud_detection *detection, double time_step, throw_errors *e) {
    scene s;
    way_world w = {0};
    bool hit[BALLS + 1] = {false};
    scene_init(&s);
    fill(&s, time_step);
    *e = (throw_errors){0};
    bool ok = way_open(&w, &s, detection, time_step);
    int steps = (int)(1.2 * WALL_FACE / VX / time_step);
    for (int i = 1; ok && i <= steps; i++) {
        ok = way_step(&w);
        compare_flights(&s, &w, i * time_step, e);
        compare_hits(&s, &w, hit, e);
    }
    way_close(&w);
    scene_free(&s);
    if (ok && e->hits != BALLS)
        fprintf(stderr, "thud-catalogue: %d of %d thrown balls hit the wall\n", e->hits, BALLS);
    return ok && e->hits == BALLS;
}

bool catalogue_throws(bool quick, json *out) {
    bool ok = true;
    printf("%-10s %7s %10s %10s %10s %10s\n", "detection", "1/step", "flight mm", "mean mm",
           "worst mm", "g h^2/8 mm");
    json_begin_array(out, "throws");
    for (int way = 0; way < WAY_COUNT; way++)
        for (int i = quick ? RATE_COUNT - 2 : 0; ok && i < RATE_COUNT; i++) {
            double h = 1 / RATES[i], chord = GRAVITY * h * h / 8;
            const char *name = thud_detection_name(way_at(way));
            throw_errors e;
            ok = throw_all(way_at(way), h, &e);
            if (!ok)
                break;
            printf("%-10s %7g %10.3f %10.3f %10.3f %10.3f\n", name, RATES[i], e.flight * 1e3,
                   e.sum / e.hits * 1e3, e.worst * 1e3, chord * 1e3);
            json_begin_object(out, NULL);
            json_text(out, "detection", name);
            json_number(out, "rate", RATES[i]);
            json_number(out, "flight", e.flight);
            json_number(out, "mean", e.sum / e.hits);
            json_number(out, "worst", e.worst);
            json_number(out, "chord", chord);
            json_end(out);
        }
    json_end(out);
    return ok;
}
