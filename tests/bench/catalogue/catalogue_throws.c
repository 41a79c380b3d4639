/* catalogue_throws.c: throws balls at a vertical wall and compares their paths and the places of
 * their hits with parabolas. The error of a hit has three parts: the engine's integration, the
 * straight line that motion tests use instead of the curve, and, for detections that test poses at
 * the ends of steps only, the rest of the step. The same balls in a world without the wall isolate
 * the first: the error of the detection is the distance of the hit from the parabola through the
 * two ends of the step, in that world, in which the ball hits. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"

#include <math.h>

enum { BALLS = 64, RATE_COUNT = 4 };

static const double RATES[RATE_COUNT] = {30, 60, 120, 240}; /* steps per second */
static const double GRAVITY = 10, RADIUS = 0.1, WALL_FACE = 20, VX = 20, VY = 5;

typedef struct throw_errors {
    double flight;      /* m: largest distance of a centre from its parabola at the end of a step */
    double worst, sum;  /* m: distance of the hits, along the wall, from their parabolas */
    double early, late; /* m: largest distance before the wall, and depth inside it, at the hit */
    double bend;        /* m: largest difference in height between a hit and the parabola through
                           the ends of the step */
    int hits;
} throw_errors;

typedef struct throws {
    scene with_wall, without;
    way_world worlds[2];                          /* with the wall, and without */
    thud_pos before[BALLS + 1], after[BALLS + 1]; /* places at both ends of the last step without
                                                     the wall */
    bool hit[BALLS + 1];
    double time_step;
} throws;

/* The wall (or, without it, a box far away) and the balls, which do not collide with each other.
 * Their starts are spread over the distance that they fly in a step. */
static void fill(scene *s, bool with_wall, double time_step) {
    scene_init(s);
    s->gravity_y = -GRAVITY;
    s->material = (scene_material){.density = 1, .friction = 0, .restitution = 0.5};
    scene_static_box(s, with_wall ? WALL_FACE + 1 : 1e6, 0, 1, 1000);
    for (int i = 0; i < BALLS; i++) {
        scene_body *ball = scene_dynamic_circle(s, -VX * time_step * i / BALLS, i, RADIUS);
        ball->vx = VX;
        ball->vy = VY;
        s->shapes[s->shape_count - 1].group = -1;
    }
}

/* Makes a step in both worlds and records the free balls' positions before and after it. */
static bool step_both(throws *t) {
    way_world *free_world = &t->worlds[1];
    for (int i = 0; i < free_world->count; i++) {
        thud_body_state now;
        if (thud_body_get_state(free_world->world, free_world->bodies[i], &now) != THUD_OK)
            return false;
        t->before[i] = now.position;
    }
    if (!way_step(&t->worlds[0]) || !way_step(free_world))
        return false;
    for (int i = 0; i < free_world->count; i++) {
        thud_body_state now;
        if (thud_body_get_state(free_world->world, free_world->bodies[i], &now) != THUD_OK)
            return false;
        t->after[i] = now.position;
    }
    return true;
}

/* The height of a thrown ball after `time` seconds, by the parabola. */
static double height_after(const scene_body *ball, double time) {
    return ball->y + VY * time - 0.5 * GRAVITY * time * time;
}

/* Updates the largest distance of a free ball from its parabola. */
static void compare_flights(const throws *t, double time, throw_errors *e) {
    for (int i = 1; i <= BALLS; i++) {
        const scene_body *ball = &t->without.bodies[i];
        double dx = t->after[i].x - (ball->x + VX * time);
        double dy = t->after[i].y - height_after(ball, time);
        e->flight = fmax(e->flight, hypot(dx, dy));
    }
}

/* The height at x of the parabola through both ends of the last step. At fraction f of the step h
 * it is g h^2 f (1 - f) / 2 above the straight line. */
static double height_at(const throws *t, int ball, double x) {
    const thud_pos *from = &t->before[ball], *to = &t->after[ball];
    double h = t->time_step, f = (x - from->x) / (to->x - from->x);
    return from->y + f * (to->y - from->y) + 0.5 * GRAVITY * h * h * f * (1 - f);
}

/* Compares the first hit of each ball; after it the ball falls along the wall. */
static void compare_hits(throws *t, throw_errors *e) {
    thud_world *world = t->worlds[0].world;
    thud_events events = thud_events_of(world);
    for (int k = 0; k < events.hit_count; k++) {
        const thud_hit_event *event = &events.hit[k];
        thud_shape_state a, b;
        if (thud_shape_get_state(world, event->shape_a, &a) != THUD_OK ||
            thud_shape_get_state(world, event->shape_b, &b) != THUD_OK)
            continue;
        /* Slots of bodies follow the scene's order, and the wall's is the first. */
        uint32_t i = (a.body.index1 > b.body.index1 ? a.body.index1 : b.body.index1) - 1;
        if (t->hit[i])
            continue;
        t->hit[i] = true;
        const scene_body *ball = &t->with_wall.bodies[i];
        double y = height_after(ball, (WALL_FACE - RADIUS - ball->x) / VX);
        double error = fabs(event->point.y - y);
        /* The reported point is in the middle of the gap or of the overlap. */
        double depth = 2 * (event->point.x - WALL_FACE);
        double height = height_at(t, (int)i, WALL_FACE + depth - RADIUS);
        e->worst = fmax(e->worst, error);
        e->sum += error;
        e->early = fmax(e->early, -depth);
        e->late = fmax(e->late, depth);
        e->bend = fmax(e->bend, fabs(event->point.y - height));
        e->hits++;
    }
}

static bool throw_all(const thud_detection *detection, double time_step, throw_errors *e) {
    throws t = {.time_step = time_step};
    *e = (throw_errors){0};
    fill(&t.with_wall, true, time_step);
    fill(&t.without, false, time_step);
    bool ok = way_open(&t.worlds[0], &t.with_wall, detection, time_step) &&
              way_open(&t.worlds[1], &t.without, detection, time_step);
    int steps = (int)(1.2 * WALL_FACE / VX / time_step);
    for (int i = 1; ok && i <= steps; i++) {
        ok = step_both(&t);
        compare_flights(&t, i * time_step, e);
        compare_hits(&t, e);
    }
    for (int k = 0; k < 2; k++)
        way_close(&t.worlds[k]);
    scene_free(&t.with_wall);
    scene_free(&t.without);
    if (ok && e->hits != BALLS)
        fprintf(stderr, "thud-catalogue: %d of %d thrown balls hit the wall\n", e->hits, BALLS);
    return ok && e->hits == BALLS;
}

bool catalogue_throws(bool quick, json *out) {
    bool ok = true;
    printf("%-10s %7s %10s %10s %10s %10s %10s %10s %10s\n", "detection", "1/step", "flight mm",
           "mean mm", "worst mm", "early mm", "late mm", "bend mm", "g h^2/8 mm");
    json_begin_array(out, "throws");
    for (int way = 0; way < WAY_COUNT; way++)
        for (int i = quick ? RATE_COUNT - 2 : 0; ok && i < RATE_COUNT; i++) {
            double h = 1 / RATES[i], chord = GRAVITY * h * h / 8;
            const char *name = thud_detection_name(way_at(way));
            throw_errors e;
            ok = throw_all(way_at(way), h, &e);
            if (!ok)
                break;
            printf("%-10s %7g %10.3f %10.3f %10.3f %10.3f %10.3f %10.3f %10.3f\n", name, RATES[i],
                   e.flight * 1e3, e.sum / e.hits * 1e3, e.worst * 1e3, e.early * 1e3, e.late * 1e3,
                   e.bend * 1e3, chord * 1e3);
            json_begin_object(out, NULL);
            json_text(out, "detection", name);
            json_number(out, "rate", RATES[i]);
            json_number(out, "flight", e.flight);
            json_number(out, "mean", e.sum / e.hits);
            json_number(out, "worst", e.worst);
            json_number(out, "early", e.early);
            json_number(out, "late", e.late);
            json_number(out, "bend", e.bend);
            json_number(out, "chord", chord);
            json_end(out);
        }
    json_end(out);
    return ok;
}
