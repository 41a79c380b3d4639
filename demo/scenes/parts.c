/* parts.c: see parts.h. */
#include "parts.h"

#include <math.h>

static const double PI = 3.141592653589793;

/* Half the angle is taken twice by tan(a / 2) = tan(a) / (1 + sqrt(1 + tan(a)^2)), after a first
 * half from x and y; then the series of atan, whose next term is below the last bit. */
double part_angle(double x, double y) {
    if (x < 0)
        return (y < 0 ? -PI : PI) - part_angle(-x, y);
    double t = y / (x + sqrt(x * x + y * y));
    t = t / (1 + sqrt(1 + t * t));
    t = t / (1 + sqrt(1 + t * t));
    double square = t * t, sum = 0;
    for (int n = 21; n >= 1; n -= 2)
        sum = 1.0 / n - square * sum;
    return 8 * t * sum;
}

int part_box(scene *s, double x, double y, double hx, double hy) {
    scene_dynamic_box(s, x, y, hx, hy);
    return s->body_count - 1;
}

int part_circle(scene *s, double x, double y, double radius) {
    scene_dynamic_circle(s, x, y, radius);
    return s->body_count - 1;
}

/* Adds a bar from a to b to the latest body, at the body's origin. */
static scene_shape *add_bar(scene *s, scene_point a, scene_point b, double half, double short_of) {
    double dx = b.x - a.x, dy = b.y - a.y;
    scene_shape *shape = scene_add_obb(s, 0.5 * sqrt(dx * dx + dy * dy) - short_of, half);
    shape->angle = part_angle(dx, dy);
    return shape;
}

int part_bar(scene *s, scene_point a, scene_point b, double half, double short_of) {
    scene_add_body(s, SCENE_DYNAMIC, 0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
    add_bar(s, a, b, half, short_of);
    return s->body_count - 1;
}

scene_shape *part_add_bar(scene *s, scene_point a, scene_point b, double half) {
    scene_shape *shape = add_bar(s, a, b, half, 0);
    if (!s->failed) {
        const scene_body *body = &s->bodies[s->body_count - 1];
        shape->x = 0.5 * (a.x + b.x) - body->x;
        shape->y = 0.5 * (a.y + b.y) - body->y;
    }
    return shape;
}

scene_joint *part_hinge(scene *s, int a, int b, scene_point at) {
    return scene_tie(s, SCENE_HINGE, a, b, at.x, at.y, 0);
}

void part_keep_apart(scene *s, int first, int group) {
    if (s->failed || first >= s->body_count)
        return;
    for (int i = s->bodies[first].first_shape; i < s->shape_count; i++)
        s->shapes[i].group = group;
}

double part_mass(const scene *s, int body) {
    double mass = 0;
    if (s->failed)
        return 1;
    for (int i = 0; i < s->bodies[body].shape_count; i++) {
        const scene_shape *shape = &s->shapes[s->bodies[body].first_shape + i];
        double area =
            shape->kind == SCENE_CIRCLE ? PI * shape->hx * shape->hx : 4 * shape->hx * shape->hy;
        mass += area * shape->material.density;
    }
    return mass;
}

/* The suspension is tuned like that of a car: by the frequency f of the body's bounce, with
 * stiffness k = m (2 pi f)^2 for the share m of its mass that the wheel carries. A joint's
 * frequency refers to the effective mass of both bodies along it, m' = 1 / (1 / body + 1 / wheel),
 * which is nearly the wheel's. For the same k it has to be f sqrt(m / m'), and for the same damper
 * the damping ratio is larger by the same factor. The body's weight compresses the spring by g / (2
 * pi f)^2; the spring's target is set lower by that. */
scene_joint *part_wheel(scene *s, int body, int wheels, double x, double y, double radius) {
    const double bounce = 1.5, ratio = 0.4, travel = 0.35 * radius;
    int wheel = part_circle(s, x, y, radius);
    double whole = part_mass(s, body), own = part_mass(s, wheel);
    double stiffer = sqrt(whole / wheels * (1 / whole + 1 / own));
    scene_joint *axle = scene_tie(s, SCENE_WHEEL, body, wheel, x, y, 0.5 * PI);
    scene_drive *spring = &axle->drive[SCENE_ALONG];
    spring->frequency = bounce * stiffer;
    spring->damping = ratio * stiffer;
    spring->target = s->gravity_y / (4 * PI * PI * bounce * bounce);
    spring->limited = true;
    spring->lower = -travel;
    spring->upper = travel;
    if (spring->target < -travel)
        spring->target = -travel;
    return axle;
}

scene_point part_meeting(scene_point a, double ra, scene_point b, double rb) {
    double dx = b.x - a.x, dy = b.y - a.y;
    double square = dx * dx + dy * dy;
    double along = 0.5 * ((ra * ra - rb * rb) / square + 1);
    double aside = sqrt(ra * ra / square - along * along);
    return (scene_point){a.x + along * dx - aside * dy, a.y + along * dy + aside * dx};
}
