/* score.c: the meter of oracle.h: it scores a state by geometry and masses alone. Depths and gaps
 * are computed by ../measure, which the reference simulation does not use, so that it can be scored
 * too. */
#include "oracle.h"

#include "joint_gaps.h"
#include "model.h"
#include "pairs.h"
#include "touch.h"

#include <math.h>
#include <stdlib.h>

struct oracle_meter {
    model model;
    near_pairs near;
    double *margins; /* m, distance below which a shape touches others */
};

oracle_meter *oracle_meter_create(const scene *s) {
    oracle_meter *meter = calloc(1, sizeof *meter);
    if (!meter)
        return NULL;
    if (!model_init(&meter->model, s)) {
        free(meter);
        return NULL;
    }
    meter->margins = calloc((size_t)meter->model.shape_count + 1, sizeof *meter->margins);
    if (!meter->margins || !near_pairs_init(&meter->near, &meter->model)) {
        oracle_meter_destroy(meter);
        return NULL;
    }
    for (int i = 0; i < meter->model.shape_count; i++)
        if (isfinite(meter->model.shapes[i].size))
            meter->margins[i] = ORACLE_TOUCH * meter->model.shapes[i].size;
    return meter;
}

void oracle_meter_destroy(oracle_meter *meter) {
    if (!meter)
        return;
    model_free(&meter->model);
    near_pairs_free(&meter->near);
    free(meter->margins);
    free(meter);
}

static bool is_finite(const engine_body *b) {
    return isfinite(b->x) && isfinite(b->y) && isfinite(b->cosine) && isfinite(b->sine) &&
           hypot(b->cosine, b->sine) > 0 && isfinite(b->vx) && isfinite(b->vy) &&
           isfinite(b->angular_velocity);
}

static scene_point center_of(const model_body *body, const engine_body *at) {
    return (scene_point){at->x + body->center_x * at->cosine - body->center_y * at->sine,
                         at->y + body->center_x * at->sine + body->center_y * at->cosine};
}

/* Adds a body's energy and momentum to the sums. */
static void weigh_body(const scene *s, int index, const model_body *body, const engine_body *at,
                       oracle_score *score) {
    scene_point center = center_of(body, at);
    double vx = at->vx, vy = at->vy, spin = body->inertia > 0 ? at->angular_velocity : 0;
    double scale = s->bodies[index].gravity_scale;
    double gravity = hypot(s->gravity_x, s->gravity_y);
    double height =
        gravity > 0 ? -(s->gravity_x * center.x + s->gravity_y * center.y) / gravity : center.y;
    score->kinetic_energy += 0.5 * (body->mass * (vx * vx + vy * vy) + body->inertia * spin * spin);
    score->potential_energy -=
        body->mass * scale * (s->gravity_x * center.x + s->gravity_y * center.y);
    score->momentum_x += body->mass * vx;
    score->momentum_y += body->mass * vy;
    score->angular_momentum += body->mass * (center.x * vy - center.y * vx) + body->inertia * spin;
    score->speed_max = fmax(score->speed_max, hypot(vx, vy));
    score->height = fmax(score->height, height);
}

/* The velocity of the body's point at (x, y). */
static scene_point velocity_at(const model_body *body, const engine_body *at, double x, double y) {
    scene_point center = center_of(body, at);
    return (scene_point){at->vx - at->angular_velocity * (y - center.y),
                         at->vy + at->angular_velocity * (x - center.x)};
}

/* Sums from which the means are computed. */
typedef struct tally {
    double depths, relative_depths, squares;
    long points;
} tally;

static void measure_pair(const model *m, near_pair pair, const engine_body *bodies,
                         oracle_score *score, tally *sums) {
    const model_shape *a = &m->shapes[pair.a], *b = &m->shapes[pair.b];
    double size = fmin(a->size, b->size), margin = ORACLE_TOUCH * size;
    touch_point points[TOUCH_GROUND_POINTS];
    int count = a->ground ? touch_ground(&a->line, &b->solid, margin, points)
                          : touch_pair(&a->solid, &b->solid, margin, points, NULL);
    double depth = fmax(0, a->ground ? depth_in_ground(&a->line, &b->solid)
                                     : depth_of_pair(&a->solid, &b->solid));
    if (count == 0 && depth == 0)
        return;
    score->touching++;
    sums->depths += depth;
    sums->relative_depths += depth / size;
    score->penetration_max = fmax(score->penetration_max, depth);
    score->relative_max = fmax(score->relative_max, depth / size);
    for (int i = 0; i < count; i++) {
        const touch_point *p = &points[i];
        scene_point of_a = velocity_at(&m->bodies[a->body], &bodies[a->body], p->x, p->y);
        scene_point of_b = velocity_at(&m->bodies[b->body], &bodies[b->body], p->x, p->y);
        double approach =
            fmax(0, (of_a.x - of_b.x) * p->normal_x + (of_a.y - of_b.y) * p->normal_y);
        score->approach_max = fmax(score->approach_max, approach);
        sums->squares += approach * approach;
        sums->points++;
    }
}

bool oracle_measure(oracle_meter *meter, const engine_body *bodies, oracle_score *score) {
    model *m = &meter->model;
    *score = (oracle_score){.height = -HUGE_VAL};
    for (int i = 0; i < m->scene->body_count; i++) {
        bool good = is_finite(&bodies[i]);
        model_pose pose = {NAN, NAN, 1, 0};
        if (good)
            pose = (model_pose){bodies[i].x, bodies[i].y, bodies[i].cosine, bodies[i].sine};
        model_place(m, i, pose);
        score->lost += !good;
        if (good && m->bodies[i].dynamic)
            weigh_body(m->scene, i, &m->bodies[i], &bodies[i], score);
    }
    score->energy = score->kinetic_energy + score->potential_energy;
    if (!near_pairs_find(&meter->near, m, meter->margins)) {
        *score = (oracle_score){0};
        return false;
    }
    joint_gaps gaps = {0};
    joint_gaps_sample(m->scene, bodies, &gaps);
    score->gap_max = gaps.worst.length;
    score->gap_mean = joint_gaps_mean(&gaps);
    score->gap_angle = fmax(gaps.worst.angle, gaps.worst.beyond_angle);
    tally sums = {0};
    for (int i = 0; i < meter->near.count; i++)
        measure_pair(m, meter->near.pairs[i], bodies, score, &sums);
    if (score->touching > 0) {
        score->penetration_mean = sums.depths / score->touching;
        score->relative_mean = sums.relative_depths / score->touching;
    }
    if (sums.points > 0)
        score->approach_rms = sqrt(sums.squares / (double)sums.points);
    return true;
}

static double angle_between(const engine_body *a, const engine_body *b) {
    double across = a->cosine * b->sine - a->sine * b->cosine;
    double along = a->cosine * b->cosine + a->sine * b->sine;
    return fabs(atan2(across, along));
}

oracle_deviation oracle_compare(const scene *s, const engine_body *expected,
                                const engine_body *actual) {
    oracle_deviation d = {0};
    model m;
    double squares = 0;
    int count = 0;
    bool good = model_init(&m, s);
    for (int i = 0; good && i < s->body_count; i++) {
        if (!m.bodies[i].dynamic)
            continue;
        const engine_body *a = &expected[i], *b = &actual[i];
        good = is_finite(a) && is_finite(b);
        scene_point p = center_of(&m.bodies[i], a), q = center_of(&m.bodies[i], b);
        double distance = hypot(q.x - p.x, q.y - p.y);
        d.position_max = fmax(d.position_max, distance);
        d.angle_max = fmax(d.angle_max, angle_between(a, b));
        d.velocity_max = fmax(d.velocity_max, hypot(b->vx - a->vx, b->vy - a->vy));
        squares += distance * distance;
        count++;
    }
    model_free(&m);
    if (!good)
        return (oracle_deviation){HUGE_VAL, HUGE_VAL, HUGE_VAL, HUGE_VAL};
    d.position_rms = count > 0 ? sqrt(squares / count) : 0;
    return d;
}
