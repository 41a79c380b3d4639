/* linkage.c: see linkage.h. */
#include "linkage.h"

#include "model.h"
#include "sim/skyline.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

enum { MOST_ROWS = 3, ROUNDS = 3 };

/* A constraint of a joint: a scalar that must be 0. Each body has three coordinates: x and y of the
 * centre of mass, and the angle. */
typedef struct row {
    int joint;
    double a[3],
        b[3]; /* its derivatives by the coordinates of both bodies (row of the Jacobian J) */
    double gap, bend; /* value, and -J' v: the part of its second time derivative that velocities
                         cause */
} row;

struct linkage {
    model model;
    const scene *scene;
    double step;
    int numbers, row_count;
    double *state;              /* `numbers` coordinates, followed by as many velocities */
    double *slope[4], *between; /* slopes and intermediate state of the Runge-Kutta rule */
    row *rows;
    double *force; /* Lagrange multiplier of each row */
    skyline matrix;
};

static bool is_driven(const scene_joint *j) {
    for (int i = 0; i < SCENE_DIRECTIONS; i++)
        if (j->drive[i].limited || j->drive[i].frequency > 0 || j->drive[i].motor_force > 0)
            return true;
    return false;
}

/* Number of constraints of a joint; -1 for kinds and drives that are not supported. */
static int rows_of(const scene_joint *j) {
    static const int COUNTS[] = {
        [SCENE_DISTANCE] = 1, [SCENE_HINGE] = 2,   [SCENE_SLIDER] = 2, [SCENE_WELD] = 3,
        [SCENE_WHEEL] = 1,    [SCENE_TARGET] = -1, [SCENE_FILTER] = 0, [SCENE_GEAR] = -1};
    return is_driven(j) ? -1 : COUNTS[j->kind];
}

void linkage_destroy(linkage *l) {
    if (!l)
        return;
    model_free(&l->model);
    skyline_free(&l->matrix);
    free(l->state);
    free(l->rows);
    free(l->force);
    free(l);
}

/* Whether two joints have a dynamic body in common. */
static bool shares_a_body(const linkage *l, int one, int other) {
    const scene_joint *j = &l->scene->joints[one], *k = &l->scene->joints[other];
    for (int i = 0; i < 4; i++)
        if (j->body[i / 2] == k->body[i % 2] && l->model.bodies[j->body[i / 2]].dynamic)
            return true;
    return false;
}

/* Computes the matrix's profile: a row is coupled with the rows of joints that share a dynamic
 * body. */
static void find_profile(linkage *l) {
    int count = 0;
    l->matrix.size = l->row_count;
    for (int i = 0; i < l->scene->joint_count; i++) {
        int first = 0, before = 0;
        while (before < i && !shares_a_body(l, i, before))
            first += rows_of(&l->scene->joints[before++]);
        for (int k = rows_of(&l->scene->joints[i]); k > 0; k--)
            l->matrix.first[count++] = first;
    }
}

static bool take_memory(linkage *l) {
    size_t n = 2 * (size_t)l->numbers;
    l->state = calloc(6 * n + 1, sizeof *l->state);
    l->rows = calloc((size_t)l->row_count + MOST_ROWS, sizeof *l->rows);
    l->force = calloc((size_t)l->row_count + 1, sizeof *l->force);
    if (!l->state || !l->rows || !l->force || !skyline_init(&l->matrix, l->row_count + 1))
        return false;
    for (int i = 0; i < 4; i++)
        l->slope[i] = l->state + (size_t)(i + 1) * n;
    l->between = l->state + 5 * n;
    find_profile(l);
    return true;
}

static void place_bodies(linkage *l) {
    for (int i = 0; i < l->scene->body_count; i++) {
        const scene_body *b = &l->scene->bodies[i];
        const model_body *m = &l->model.bodies[i];
        double *q = l->state + 3 * i, *v = q + l->numbers;
        q[0] = b->x + cos(b->angle) * m->center_x - sin(b->angle) * m->center_y;
        q[1] = b->y + sin(b->angle) * m->center_x + cos(b->angle) * m->center_y;
        q[2] = b->angle;
        v[0] = b->vx, v[1] = b->vy, v[2] = b->angular_velocity;
    }
}

linkage *linkage_create(const scene *s, double step) {
    linkage *l = calloc(1, sizeof *l);
    bool ok = l && !s->failed && isfinite(step) && step >= 0 && model_init(&l->model, s);
    if (!ok) {
        free(l);
        return NULL;
    }
    l->scene = s;
    l->step = step > 0 ? step : 1.0 / 1920;
    l->numbers = 3 * s->body_count;
    for (int i = 0; ok && i < s->joint_count; i++) {
        int count = rows_of(&s->joints[i]);
        ok = count >= 0;
        l->row_count += ok ? count : 0;
    }
    if (!ok || !take_memory(l)) {
        linkage_destroy(l);
        return NULL;
    }
    place_bodies(l);
    return l;
}

/* One side of a joint: the arm from the centre of mass to the anchor, the anchor's position and
 * velocity, the angular velocity, and the angle of the frame. */
typedef struct side {
    double rx, ry, x, y, vx, vy, spin, tilt;
} side;

/* Position, velocity and angle of a joint's anchor on one of its bodies. */
static side side_of(const linkage *l, const scene_joint *j, int which, const double *state) {
    int body = j->body[which];
    const model_body *m = &l->model.bodies[body];
    const double *q = state + 3 * body, *v = q + l->numbers;
    double c = cos(q[2]), s = sin(q[2]);
    double x = j->x[which] - m->center_x, y = j->y[which] - m->center_y;
    side e = {.rx = c * x - s * y,
              .ry = s * x + c * y,
              .spin = v[2],
              .tilt = q[2] + j->angle[which]};
    e.x = q[0] + e.rx, e.y = q[1] + e.ry;
    e.vx = v[0] - v[2] * e.ry, e.vy = v[1] + v[2] * e.rx;
    return e;
}

/* The constraint n . (b - a) = 0, where n is fixed in the world, or rotates with body a. */
static row row_along(const side *a, const side *b, double nx, double ny, bool turns) {
    double dx = b->x - a->x, dy = b->y - a->y, vx = b->vx - a->vx, vy = b->vy - a->vy;
    double w = turns ? a->spin : 0, lever = turns ? dx * ny - dy * nx : 0;
    double inwards_x = a->spin * a->spin * a->rx - b->spin * b->spin * b->rx;
    double inwards_y = a->spin * a->spin * a->ry - b->spin * b->spin * b->ry;
    double gap = nx * dx + ny * dy;
    return (row){.a = {-nx, -ny, -(a->rx * ny - a->ry * nx) - lever},
                 .b = {nx, ny, b->rx * ny - b->ry * nx},
                 .gap = gap,
                 .bend =
                     nx * inwards_x + ny * inwards_y + 2 * w * (nx * vy - ny * vx) - w * w * gap};
}

/* The constraint of a rod: the anchors' distance is `length`. */
static row row_of_rod(const side *a, const side *b, double length) {
    double dx = b->x - a->x, dy = b->y - a->y, far = hypot(dx, dy);
    row r = row_along(a, b, dx / far, dy / far, false);
    double across = (dx * (b->vy - a->vy) - dy * (b->vx - a->vx)) / far;
    r.gap = far - length;
    r.bend += across * across / far;
    return r;
}

/* The constraint that the frames have the same angle. */
static row row_of_turn(const side *a, const side *b) {
    return (row){.a = {0, 0, -1}, .b = {0, 0, 1}, .gap = remainder(b->tilt - a->tilt, 2 * PI)};
}

/* Writes the constraints of a joint and returns their number. */
static int make_rows(const linkage *l, int joint, const double *state, row *rows) {
    const scene_joint *j = &l->scene->joints[joint];
    side a = side_of(l, j, 0, state), b = side_of(l, j, 1, state);
    int count = 0;
    if (j->kind == SCENE_DISTANCE)
        rows[count++] = row_of_rod(&a, &b, j->length);
    if (j->kind == SCENE_HINGE || j->kind == SCENE_WELD) {
        rows[count++] = row_along(&a, &b, 1, 0, false);
        rows[count++] = row_along(&a, &b, 0, 1, false);
    }
    if (j->kind == SCENE_SLIDER || j->kind == SCENE_WHEEL)
        rows[count++] = row_along(&a, &b, -sin(a.tilt), cos(a.tilt), true);
    if (j->kind == SCENE_SLIDER || j->kind == SCENE_WELD)
        rows[count++] = row_of_turn(&a, &b);
    for (int i = 0; i < count; i++)
        rows[i].joint = joint;
    return count;
}

static double inverse_mass(const linkage *l, int body, int number) {
    const model_body *m = &l->model.bodies[body];
    return number < 2 ? m->inverse_mass : m->inverse_inertia;
}

/* The derivatives of a row by the coordinates of body a or b of its joint. */
static const double *part(const row *r, int which) {
    return which == 0 ? r->a : r->b;
}

/* An element of J M^-1 J^T. */
static double coupling(const linkage *l, const row *r, const row *q) {
    const int *bodies = l->scene->joints[r->joint].body, *others = l->scene->joints[q->joint].body;
    double sum = 0;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            for (int n = 0; n < 3 && bodies[i] == others[k]; n++)
                sum += part(r, i)[n] * part(q, k)[n] * inverse_mass(l, bodies[i], n);
    return sum;
}

/* Computes the rows and the factors of J M^-1 J^T at a state. False if the matrix is singular. */
static bool look_at(linkage *l, const double *state) {
    skyline *w = &l->matrix;
    int count = 0;
    for (int i = 0; i < l->scene->joint_count; i++)
        count += make_rows(l, i, state, l->rows + count);
    skyline_clear(w);
    for (int i = 0; i < count; i++) {
        for (int k = w->first[i]; k < i; k++) {
            double value = coupling(l, &l->rows[i], &l->rows[k]);
            skyline_add(w, i, k, value);
            skyline_add(w, k, i, value);
        }
        skyline_add(w, i, i, coupling(l, &l->rows[i], &l->rows[i]));
    }
    return skyline_factor(w);
}

/* The product J x of a row. */
static double along_row(const linkage *l, const row *r, const double *x) {
    const int *bodies = l->scene->joints[r->joint].body;
    double sum = 0;
    for (int i = 0; i < 2; i++)
        for (int n = 0; n < 3; n++)
            sum += part(r, i)[n] * x[3 * bodies[i] + n];
    return sum;
}

/* x += M^-1 J^T force. */
static void push(const linkage *l, double *x) {
    for (int k = 0; k < l->row_count; k++) {
        const row *r = &l->rows[k];
        const int *bodies = l->scene->joints[r->joint].body;
        for (int i = 0; i < 2; i++)
            for (int n = 0; n < 3; n++)
                x[3 * bodies[i] + n] += inverse_mass(l, bodies[i], n) * part(r, i)[n] * l->force[k];
    }
}

/* The time derivative of the state: velocities and accelerations. */
static bool find_slope(linkage *l, const double *state, double *slope) {
    const scene *s = l->scene;
    int n = l->numbers;
    double *acceleration = slope + n;
    memcpy(slope, state + n, (size_t)n * sizeof *slope);
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *b = &s->bodies[i];
        const double *v = slope + 3 * i;
        double *a = acceleration + 3 * i, moves = l->model.bodies[i].dynamic ? 1 : 0;
        a[0] = moves * (b->gravity_scale * s->gravity_x - b->linear_damping * v[0]);
        a[1] = moves * (b->gravity_scale * s->gravity_y - b->linear_damping * v[1]);
        a[2] = moves * -b->angular_damping * v[2];
    }
    if (!look_at(l, state))
        return false;
    for (int k = 0; k < l->row_count; k++)
        l->force[k] = -along_row(l, &l->rows[k], acceleration) - l->rows[k].bend;
    skyline_solve(&l->matrix, l->force);
    push(l, acceleration);
    return true;
}

/* Projects the coordinates onto the constraints with ROUNDS Newton steps, and the velocities once.
 */
static bool project(linkage *l) {
    for (int round = 0; round < ROUNDS; round++) {
        if (!look_at(l, l->state))
            return false;
        for (int k = 0; k < l->row_count; k++)
            l->force[k] = -l->rows[k].gap;
        skyline_solve(&l->matrix, l->force);
        push(l, l->state);
    }
    for (int k = 0; k < l->row_count; k++)
        l->force[k] = -along_row(l, &l->rows[k], l->state + l->numbers);
    skyline_solve(&l->matrix, l->force);
    push(l, l->state + l->numbers);
    return true;
}

/* A step of h seconds by the Runge-Kutta rule. */
static bool take_step(linkage *l, double h) {
    static const double REACH[] = {0.5, 0.5, 1}, SHARE[] = {1, 2, 2, 1};
    int n = 2 * l->numbers;
    bool ok = find_slope(l, l->state, l->slope[0]);
    for (int k = 1; ok && k < 4; k++) {
        for (int i = 0; i < n; i++)
            l->between[i] = l->state[i] + REACH[k - 1] * h * l->slope[k - 1][i];
        ok = find_slope(l, l->between, l->slope[k]);
    }
    for (int k = 0; ok && k < 4; k++)
        for (int i = 0; i < n; i++)
            l->state[i] += h / 6 * SHARE[k] * l->slope[k][i];
    return ok && project(l);
}

bool linkage_advance(linkage *l, double seconds) {
    bool ok = isfinite(seconds) && seconds >= 0;
    int steps = ok ? (int)ceil(seconds / l->step - 1e-9) : 0;
    for (int i = 0; ok && i < steps; i++)
        ok = take_step(l, seconds / steps);
    return ok;
}

void linkage_read(const linkage *l, engine_body *bodies) {
    for (int i = 0; i < l->scene->body_count; i++) {
        const model_body *m = &l->model.bodies[i];
        const double *q = l->state + 3 * i, *v = q + l->numbers;
        double c = cos(q[2]), s = sin(q[2]);
        bodies[i] = (engine_body){.x = q[0] - (c * m->center_x - s * m->center_y),
                                  .y = q[1] - (s * m->center_x + c * m->center_y),
                                  .cosine = c,
                                  .sine = s,
                                  .vx = v[0],
                                  .vy = v[1],
                                  .angular_velocity = v[2],
                                  .mass = m->mass,
                                  .inertia = m->inertia,
                                  .awake = true};
    }
}

bool linkage_force(linkage *l, int joint, double *x, double *y) {
    *x = *y = 0;
    if (!find_slope(l, l->state, l->slope[0]))
        return false;
    for (int k = 0; k < l->row_count; k++)
        if (l->rows[k].joint == joint) {
            *x += l->rows[k].b[0] * l->force[k];
            *y += l->rows[k].b[1] * l->force[k];
        }
    return true;
}
