/* debug_draw.c: thud_world_draw: checks the request, brings bounds and islands up to date, and runs
 * the parts of drawing that its flags name, in a fixed order. This file draws the shapes;
 * draw_detection.c and draw_contacts.c draw the rest. */
#include "constraint/joint_hooks.h"
#include "state/body.h"
#include "api/debug_draw.h"
#include "state/handles.h"
#include "state/preview.h"
#include "api/step.h"
#include "islands/label.h"

/* The style in which a shape is drawn: a sensor's, or that of its body's kind and of whether the
 * body sleeps. */
static thud_style style_of(const td_drawing *d, const td_shape *shape) {
    const td_body *body = td_body_at(d->w, shape->body);
    if (shape->flags & TD_SHAPE_SENSOR) {
        return THUD_STYLE_SENSOR;
    }
    if (body->kind == THUD_BODY_STATIC) {
        return THUD_STYLE_STATIC;
    }
    return body->awake.at < 0                  ? THUD_STYLE_SLEEPING
           : body->kind == THUD_BODY_KINEMATIC ? THUD_STYLE_KINEMATIC
                                               : THUD_STYLE_DYNAMIC;
}

/* Draws the segments of a terrain between the left and right edges of the view. */
static void draw_terrain(const td_drawing *d, int index, thud_style style) {
    const td_position *center = &td_preview_proxy(d->w, index)->center;
    thud_terrain terrain = td_terrain_view(d->w, index);
    double x_min = (double)(d->lower.x - center->x) / d->w->to_fixed;
    double x_max = (double)(d->upper.x - center->x) / d->w->to_fixed;
    int first, last;
    thud_terrain_segments(&terrain, x_min, x_max, &first, &last);
    for (int i = first; i <= last && d->draw->line; i++) {
        thud_pos p = {x_min, terrain.slope * x_min}, q = {x_max, terrain.slope * x_max};
        if (terrain.kind != THUD_TERRAIN_FLAT) {
            p = terrain.points[i];
            q = terrain.points[i + 1];
        }
        thud_vec2 at = td_drawing_local(d, *center);
        d->draw->line((thud_vec2){at.x + (float)p.x, at.y + (float)p.y},
                      (thud_vec2){at.x + (float)q.x, at.y + (float)q.y}, style, d->draw->context);
    }
}

/* `island`: the island's number, or -1. */
static void draw_shape(const td_drawing *d, int index, int island) {
    const td_shape *shape = td_shape_at(d->w, index);
    const td_shape_proxy *proxy = td_preview_proxy(d->w, index);
    thud_style style = style_of(d, shape);
    thud_vec2 at = td_drawing_local(d, proxy->center);
    const td_pose *pose = td_pose_at(d->w, shape->body);
    switch ((thud_shape_kind)shape->kind) {
    case THUD_SHAPE_CIRCLE:
        if (d->draw->circle) {
            d->draw->circle(at, shape->half_x, pose->c, pose->s, style, island, d->draw->context);
        }
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        if (d->draw->box) {
            d->draw->box(at, (thud_vec2){shape->half_x, shape->half_y}, proxy->c, proxy->s, style,
                         island, d->draw->context);
        }
        break;
    case THUD_SHAPE_TERRAIN:
        draw_terrain(d, index, style);
        break;
    }
}

/* Draws the shapes whose fat bounds overlap the view, and those bounds, as the flags say. */
static void draw_shapes(const td_drawing *d) {
    const thud_world *w = d->w;
    unsigned flags = d->draw->flags;
    const td_awake_slot *islands = flags & THUD_DRAW_ISLANDS ? w->scratch.parents.data : NULL;
    for (int i = 0; i < w->shapes.count; i++) {
        const td_shape *shape = td_shape_at(w, i);
        if ((shape->flags & (TD_SHAPE_LIVE | TD_SHAPE_WAITS)) != TD_SHAPE_LIVE) {
            continue;
        }
        const td_shape_proxy *proxy = td_preview_proxy(w, i);
        const td_bounds *b = &proxy->fat;
        const td_position *center = &proxy->center;
        int64_t x0 = td_unwrap(b->min_x, center->x), x1 = td_unwrap(b->max_x, center->x);
        int64_t y0 = td_unwrap(b->min_y, center->y), y1 = td_unwrap(b->max_y, center->y);
        bool seen = td_kind_is_line(shape->kind) ||
                    (x1 >= d->lower.x >> TD_COARSE_SHIFT && x0 <= d->upper.x >> TD_COARSE_SHIFT &&
                     y1 >= d->lower.y >> TD_COARSE_SHIFT && y0 <= d->upper.y >> TD_COARSE_SHIFT);
        const td_body *body = td_body_at(w, shape->body);
        if (seen && (flags & (THUD_DRAW_SHAPES | THUD_DRAW_ISLANDS))) {
            draw_shape(d, i, islands && body->awake.at > 0 ? islands[body->awake.at].at : -1);
        }
        if (seen && (flags & THUD_DRAW_SHAPE_BOUNDS) && !td_kind_is_line(shape->kind)) {
            td_drawing_bounds(d, x0, y0, x1, y1, THUD_STYLE_BOUNDS);
        }
    }
}

thud_result thud_world_draw(thud_world *w, const thud_debug_draw *draw) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !draw) {
        return td_refuse(w, THUD_ERROR_NULL, "draw: world or draw is null");
    }
    if (!td_place_valid(w, draw->origin.x, draw->origin.y) ||
        !td_place_valid(w, draw->lower.x, draw->lower.y) ||
        !td_place_valid(w, draw->upper.x, draw->upper.y)) {
        return td_refuse(w, THUD_ERROR_INVALID, "draw: origin or box is out of range");
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "draw: not inside a callback");
    }
    if (!td_preview_make(w) || !td_broadphase_refresh(w) ||
        ((draw->flags & THUD_DRAW_ISLANDS) && !td_islands_label(w, false))) {
        return td_refuse(w, THUD_ERROR_MEMORY, "draw: out of memory");
    }
    td_drawing d = {w, draw, td_place_from(w, draw->origin), td_place_from(w, draw->lower),
                    td_place_from(w, draw->upper)};
    static const struct {
        unsigned flags;
        void (*run)(const td_drawing *d);
    } parts[] = {
        {THUD_DRAW_SHAPES | THUD_DRAW_ISLANDS | THUD_DRAW_SHAPE_BOUNDS, draw_shapes},
        {THUD_DRAW_CELLS, td_draw_cells},
        {THUD_DRAW_AXES, td_draw_intervals},
        {THUD_DRAW_MOTIONS, td_draw_motions},
        {THUD_DRAW_PAIRS, td_draw_pairs},
        {THUD_DRAW_STAGES, td_draw_stages},
        {THUD_DRAW_COLOURS, td_draw_colours},
        {THUD_DRAW_ISLANDS, td_draw_direct},
        {THUD_DRAW_CONTACTS, td_draw_contacts},
        {THUD_DRAW_MANIFOLDS, td_draw_manifolds},
    };
    w->locked = true;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++) {
        if (draw->flags & parts[i].flags) {
            parts[i].run(&d);
        }
    }
    if (w->joint_hooks) {
        w->joint_hooks->draw(&d);
    }
    w->locked = false;
    return THUD_OK;
}
