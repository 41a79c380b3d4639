/* draw_joints.c: see draw_joints.h. A joint is drawn at its frames in the interpolated poses of its
 * bodies; the scene says how it was made. */
#include "draw/draw_joints.h"

#include "draw/palette.h"

#include <math.h>
#include <stdio.h>

typedef struct sketch {
    canvas *canvas;
    const camera *view;
    session *session;
    const thud_pose *poses;
    int pose_count;
    float size; /* radius of a hinge, pixels */
} sketch;

/* A joint in pixels, y down. Axes are unit vectors. */
typedef struct placed {
    const scene_joint *made;
    thud_joint_state state;
    SDL_FPoint a, b;
    SDL_FPoint axis_a, axis_b;
} placed;

/* What drawing the joints needs, with the size of a joint by that of the scene's bodies. */
static sketch begin(canvas *c, const camera *view, session *s) {
    sketch k = {.canvas = c, .view = view, .session = s};
    k.poses = thud_poses_of(s->world, view->center, s->alpha, &k.pose_count);
    float wanted = 0.09f * (float)(s->scene.length_scale * view->scale);
    k.size = fmaxf(1.3f * c->unit, fminf(wanted, 4.5f * c->unit));
    return k;
}

/* The frame of a side of a joint. False if the body has no pose. */
static bool frame_of(const sketch *k, thud_body_id body, const scene_joint *made, int side,
                     SDL_FPoint *at, SDL_FPoint *axis) {
    int slot = (int)body.index1 - 1;
    if (slot < 0 || slot >= k->pose_count || isnan(k->poses[slot].x))
        return false;
    thud_pose p = k->poses[slot];
    float x = (float)made->x[side], y = (float)made->y[side];
    float c = (float)cos(made->angle[side]), s = (float)sin(made->angle[side]);
    *at = camera_from_center(k->view, p.x + p.c * x - p.s * y, p.y + p.s * x + p.c * y);
    *axis = (SDL_FPoint){p.c * c - p.s * s, -(p.s * c + p.c * s)};
    return true;
}

/* Whether a point is in the view, or at most 12 hinge radii outside of it. */
static bool in_view(const sketch *k, SDL_FPoint p) {
    const SDL_FRect *r = &k->view->view;
    float margin = 12 * k->size;
    return p.x > r->x - margin && p.x < r->x + r->w + margin && p.y > r->y - margin &&
           p.y < r->y + r->h + margin;
}

/* Computes where a joint is. False if there is nothing to draw: the joint no longer exists or is
 * disabled, is a filter or gear, or is outside of the view. */
static bool place_joint(const sketch *k, int index, placed *out) {
    const session *s = k->session;
    out->made = &s->scene.joints[index];
    if (out->made->kind == SCENE_FILTER || out->made->kind == SCENE_GEAR ||
        !thud_joint_is_valid(s->world, s->joints[index]) ||
        thud_joint_get_state(s->world, s->joints[index], &out->state) != THUD_OK ||
        !out->state.enabled)
        return false;
    return frame_of(k, out->state.body_a, out->made, 0, &out->a, &out->axis_a) &&
           frame_of(k, out->state.body_b, out->made, 1, &out->b, &out->axis_b) &&
           (in_view(k, out->a) || in_view(k, out->b));
}

/* The larger distance from a body's origin to the joint, in pixels: about the distance to the next
 * joint. */
static float room_of(const sketch *k, const scene_joint *made) {
    double farthest = fmax(hypot(made->x[0], made->y[0]), hypot(made->x[1], made->y[1]));
    return (float)(farthest * k->view->scale);
}

/* The sketch with a smaller size for joints of small bodies, so that a row of joints does not merge
 * into a line. */
static sketch fitting(sketch k, const placed *p) {
    float room = room_of(&k, p->made);
    if (room > 0)
        k.size = fminf(k.size, 0.4f * room);
    return k;
}

/* The point at a distance along an axis. */
static SDL_FPoint along(SDL_FPoint from, SDL_FPoint axis, float length) {
    return (SDL_FPoint){from.x + axis.x * length, from.y + axis.y * length};
}

/* The point at a distance perpendicular to an axis. */
static SDL_FPoint across(SDL_FPoint from, SDL_FPoint axis, float length) {
    return (SDL_FPoint){from.x - axis.y * length, from.y + axis.x * length};
}

static float distance(SDL_FPoint a, SDL_FPoint b) {
    return hypotf(b.x - a.x, b.y - a.y);
}

static void draw_disc(const sketch *k, SDL_FPoint at, float radius) {
    canvas_style style = {COLOR_SKY_TOP, COLOR_JOINT, fminf(1.3f * k->canvas->unit, 0.6f * radius)};
    canvas_circle(k->canvas, at, radius, style);
}

static void draw_dot(const sketch *k, SDL_FPoint at) {
    canvas_circle(k->canvas, at, 0.6f * k->size, (canvas_style){COLOR_JOINT, COLOR_JOINT, 0});
}

/* Draws a spring between two points. `rest` is its length at rest in pixels, by which the number of
 * its windings is chosen. */
static void draw_spring(const sketch *k, SDL_FPoint a, SDL_FPoint b, float rest) {
    float length = distance(a, b), unit = k->canvas->unit;
    SDL_Color color = color_fade(COLOR_JOINT_SPRING, 0.7f);
    if (length < 2 * k->size) {
        canvas_line(k->canvas, a, b, unit, color);
        return;
    }
    int turns = (int)fmaxf(3, fminf(rest / (2.4f * k->size), 10));
    SDL_FPoint axis = {(b.x - a.x) / length, (b.y - a.y) / length};
    float lead = 0.14f * length, step = (length - 2 * lead) / (float)(2 * turns);
    SDL_FPoint last = a;
    for (int i = 0; i <= 2 * turns; i++) {
        SDL_FPoint next = along(a, axis, lead + step * (float)i);
        if (i > 0 && i < 2 * turns)
            next = across(next, axis, i % 2 ? 0.7f * k->size : -0.7f * k->size);
        canvas_line(k->canvas, last, next, 1.1f * unit, color);
        last = next;
    }
    canvas_line(k->canvas, last, b, 1.1f * unit, color);
}

/* Draws a rope of a length in pixels. If it is not taut, it sags in a parabola of about this
 * length. */
static void draw_rope(const sketch *k, SDL_FPoint a, SDL_FPoint b, float length) {
    enum { PIECES = 12 };
    float straight = distance(a, b);
    float spare = fmaxf(0, length - straight);
    float sag = fminf(sqrtf(0.375f * straight * spare) + 0.5f * spare, length);
    SDL_FPoint last = a;
    for (int i = 1; i <= PIECES; i++) {
        float t = (float)i / PIECES;
        SDL_FPoint next = {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t + 4 * sag * t * (1 - t)};
        canvas_line(k->canvas, last, next, 1.3f * k->canvas->unit, COLOR_JOINT);
        last = next;
    }
}

/* Draws a distance joint: as a spring, a rope (drawn taut if a winch's motor holds it) or a rod. */
static void draw_distance(const sketch *k, const placed *p) {
    const scene_drive *drive = &p->made->drive[SCENE_ALONG];
    float scale = (float)k->view->scale;
    if (drive->frequency > 0)
        draw_spring(k, p->a, p->b, (float)p->made->length * scale);
    else if (drive->limited)
        draw_rope(k, p->a, p->b, drive->motor_force > 0 ? 0 : (float)drive->upper * scale);
    else
        canvas_line(k->canvas, p->a, p->b, 2 * k->canvas->unit, COLOR_JOINT);
    draw_dot(k, p->a);
    draw_dot(k, p->b);
}

/* Draws the range of angles that body b may have relative to a, and its current angle. */
static void draw_turn_limits(const sketch *k, const placed *p) {
    enum { PIECES = 16 };
    const scene_drive *turn = &p->made->drive[SCENE_TURN];
    float radius = 3 * k->size;
    if (!turn->limited || radius < 13 * k->canvas->unit)
        return;
    SDL_Color color = color_fade(COLOR_JOINT, 0.25f);
    double start = atan2(-p->axis_a.y, p->axis_a.x) + turn->lower;
    double step = (turn->upper - turn->lower) / PIECES;
    SDL_FPoint last = p->b;
    for (int i = 0; i <= PIECES; i++) {
        double angle = start + step * i;
        SDL_FPoint axis = {(float)cos(angle), -(float)sin(angle)};
        SDL_FPoint next = along(p->b, axis, radius);
        canvas_line(k->canvas, last, next, k->canvas->unit, color);
        last = next;
    }
    canvas_line(k->canvas, last, p->b, k->canvas->unit, color);
    canvas_line(k->canvas, p->b, along(p->b, p->axis_b, radius), k->canvas->unit,
                color_fade(COLOR_JOINT, 0.6f));
}

/* Draws the rail of a slider: between its limits, or some length in both directions. */
static void draw_rail(const sketch *k, const placed *p) {
    const scene_drive *drive = &p->made->drive[SCENE_ALONG];
    float scale = (float)k->view->scale, unit = k->canvas->unit;
    float free = 2 * (float)k->session->scene.length_scale * scale;
    float lower = drive->limited ? (float)drive->lower * scale : -free;
    float upper = drive->limited ? (float)drive->upper * scale : free;
    SDL_Color color = color_fade(COLOR_JOINT, drive->limited ? 0.5f : 0.25f);
    SDL_FPoint ends[2] = {along(p->a, p->axis_a, lower), along(p->a, p->axis_a, upper)};
    canvas_line(k->canvas, ends[0], ends[1], 1.2f * unit, color);
    for (int i = 0; drive->limited && i < 2; i++)
        canvas_line(k->canvas, across(ends[i], p->axis_a, -k->size),
                    across(ends[i], p->axis_a, k->size), 1.2f * unit, color);
    canvas_style style = {COLOR_SKY_TOP, COLOR_JOINT, 1.2f * unit};
    canvas_box(k->canvas, p->b, p->axis_b, (SDL_FPoint){1.5f * k->size, 0.9f * k->size}, style);
}

/* Draws an axle with its spring, from the wheel up to a point above the upper limit, by the range
 * of the limits. */
static void draw_wheel(const sketch *k, const placed *p) {
    const scene_drive *drive = &p->made->drive[SCENE_ALONG];
    float scale = (float)k->view->scale;
    float travel = drive->limited ? (float)(drive->upper - drive->lower) : 0.5f;
    float top = (float)(drive->limited ? drive->upper : 0.25) + travel;
    if (drive->frequency > 0)
        draw_spring(k, along(p->a, p->axis_a, top * scale), p->b, top * scale);
    draw_turn_limits(k, p);
    draw_disc(k, p->b, 1.2f * k->size);
}

static void draw_joint(const sketch *k, const placed *p) {
    switch (p->made->kind) {
    case SCENE_DISTANCE:
        draw_distance(k, p);
        break;
    case SCENE_HINGE:
        draw_turn_limits(k, p);
        draw_disc(k, p->b, k->size);
        break;
    case SCENE_SLIDER:
        draw_rail(k, p);
        break;
    case SCENE_WELD:
        canvas_box(k->canvas, p->b, p->axis_b, (SDL_FPoint){0.9f * k->size, 0.9f * k->size},
                   (canvas_style){COLOR_JOINT, COLOR_JOINT, 0});
        break;
    case SCENE_WHEEL:
        draw_wheel(k, p);
        break;
    case SCENE_TARGET:
        canvas_line(k->canvas, p->a, p->b, k->canvas->unit, color_fade(COLOR_JOINT, 0.5f));
        draw_dot(k, p->b);
        break;
    case SCENE_FILTER:
    case SCENE_GEAR: /* place_joint excludes filters, draw_gear draws gears */
        break;
    }
}

/* Draws a faint line between the two joints that a gear connects. */
static void draw_gear(const sketch *k, int index) {
    const session *s = k->session;
    const scene_joint *gear = &s->scene.joints[index];
    placed first, second;
    if (gear->kind == SCENE_GEAR && thud_joint_is_valid(s->world, s->joints[index]) &&
        place_joint(k, gear->body[0], &first) && place_joint(k, gear->body[1], &second))
        canvas_line(k->canvas, first.b, second.b, k->canvas->unit, color_fade(COLOR_JOINT, 0.25f));
}

void draw_joints(canvas *c, const camera *view, session *s) {
    sketch k = begin(c, view, s);
    placed p;
    for (int i = 0; i < s->joint_count; i++)
        draw_gear(&k, i);
    for (int i = 0; i < s->joint_count; i++)
        if (place_joint(&k, i, &p)) {
            sketch own = fitting(k, &p);
            draw_joint(&own, &p);
        }
}

/* Draws an arrow. A force of length 1, the largest, has an arrow of `reach` pixels; smaller ones
 * are also narrower. */
static void draw_arrow(const sketch *k, SDL_FPoint from, thud_vec2 force, float reach) {
    float share = hypotf(force.x, force.y), length = share * reach, unit = k->canvas->unit;
    float head = fminf(4 * unit, 0.3f * length);
    if (length < unit)
        return;
    float width = fmaxf(0.8f * unit, fminf(3.5f * unit, reach / 6) * share);
    SDL_FPoint axis = {force.x / share, -force.y / share}, tip = along(from, axis, length);
    SDL_FPoint neck = along(tip, axis, -1.4f * head);
    canvas_line(k->canvas, from, tip, width, COLOR_FORCE);
    for (int side = -1; side <= 1; side += 2)
        canvas_line(k->canvas, tip, across(neck, axis, (float)side * head), width, COLOR_FORCE);
}

/* Writes the widest gap beside its joint, unless it is negligible. */
static void tell_gap(const sketch *k, SDL_FPoint at, double gap) {
    char text[48];
    double length = gap / k->session->scene.length_scale;
    if (length < 1e-6)
        return;
    snprintf(text, sizeof text, gap < 1e-3 ? "gap %.1e" : "gap %.3f", gap);
    canvas_text(k->canvas, at.x + 3 * k->size, at.y - 2 * k->size, COLOR_OPEN, text);
}

void draw_joint_forces(canvas *c, const camera *view, session *s) {
    sketch k = begin(c, view, s);
    placed p;
    float largest = 0, room = 0;
    double widest = 0;
    int count = 0;
    SDL_FPoint place = {0, 0};
    for (int i = 0; i < s->joint_count; i++)
        if (place_joint(&k, i, &p)) {
            largest = fmaxf(largest, hypotf(p.state.force.x, p.state.force.y));
            room += room_of(&k, p.made);
            count++;
        }
    float reach = fmaxf(6 * c->unit, fminf(1.6f * room / fmaxf(1, (float)count), 36 * c->unit));
    for (int i = 0; i < s->joint_count; i++) {
        if (!place_joint(&k, i, &p))
            continue;
        float open = (float)fmin(1, 100 * p.state.gap / s->scene.length_scale);
        if (open > 0.01f)
            canvas_ring(c, p.b, 2 * fitting(k, &p).size, 1.5f * c->unit,
                        color_fade(COLOR_OPEN, open));
        if (p.state.gap > widest) {
            widest = p.state.gap;
            place = p.b;
        }
        thud_vec2 force = p.state.force;
        if (largest > 0)
            draw_arrow(&k, p.b, (thud_vec2){force.x / largest, force.y / largest}, reach);
    }
    tell_gap(&k, place, widest);
}
