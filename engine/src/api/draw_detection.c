/* draw_detection.c: draws what collision detection worked on: the cells of the grid broadphase, the
 * sorted intervals of the plane sweep (sweep and prune), the pairs that the broadphase found, and
 * the swept volumes of fast shapes. */
#include "api/debug_draw.h"
#include "detection/trajectory.h"
#include "contact/contact.h"
#include "geometry/shape_instance.h"
#include "state/shape.h"

/* ---- cells ---- */

/* Draws the cells that awake shapes lie in. Shapes are sorted by cell, so that a cell is drawn once
 * for a run of shapes in it. With another broadphase than the grid all levels are empty. */
void td_draw_cells(const td_drawing *d) {
    const td_proxy_set *grid = &d->w->awake_shapes;
    const int *ids = grid->ids.data;
    for (int l = 0; l < TD_LEVELS; l++) {
        const td_level *level = &grid->levels[l];
        int64_t column = 0, row = 0;
        for (int i = level->first; i < level->first + level->count; i++) {
            const td_bounds *b = td_fat_at(d->w, ids[i]);
            const td_position *at = &td_shape_proxy_at(d->w, ids[i])->center;
            int64_t x = td_unwrap(b->min_x, at->x) + td_wrap_sub(b->max_x, b->min_x) / 2;
            int64_t y = td_unwrap(b->min_y, at->y) + td_wrap_sub(b->max_y, b->min_y) / 2;
            /* Two cells may have the same hash; their column and row tell them apart. */
            x = td_grid_index(x - grid->origin_x, level->inv_cell);
            y = td_grid_index(y - grid->origin_y, level->inv_cell);
            if (i > level->first && x == column && y == row) {
                continue;
            }
            column = x;
            row = y;
            int64_t size = level->cell + level->cell / 65536;
            x = grid->origin_x + x * size;
            y = grid->origin_y + y * size;
            td_drawing_bounds(d, x, y, x + size, y + size, THUD_STYLE_CELL);
        }
    }
}

/* ---- sorted intervals ---- */

enum {
    /* Rows of bars, one above the other; where more intervals overlap, bars cover each other.
     * Chosen; thud_draw.h promises 12. */
    ROWS = 12,
    /* Height of the view divided by the height of a row. Chosen: the 2 * 12 rows of both proxy sets
       take a quarter of the view. */
    ROWS_A_VIEW = 90
};

/* The first row whose last bar ends left of `min`, so that bars side by side share a row; without
 * one the row whose last bar ends furthest left. `taken`: where the last bar of each row ends, in
 * quanta of td_bounds. */
static int free_row(const double *taken, double min) {
    int best = 0;
    for (int i = 0; i < ROWS; i++) {
        if (taken[i] < min) {
            return i;
        }
        best = taken[i] < taken[best] ? i : best;
    }
    return best;
}

/* Draws the sorted intervals of one proxy set (of thud_broadphase_sweep_both only those along its
 * first axis). Intervals along x are bars above the lower edge of the view, those along y beside
 * its left edge. `rows`: rows that are in use already. Returns the number in use afterwards.
 * Broadphases other than the plane sweep keep no intervals, and nothing is drawn. */
static int draw_intervals(const td_drawing *d, const td_proxy_set *set, int rows) {
    const td_sweep_key *keys = set->keys.data;
    double taken[ROWS], furthest = -0x1p80;
    bool along_x = set->axis == TD_AXIS_X;
    int64_t reference = set->reference[set->axis];
    int64_t low = along_x ? d->lower.x : d->lower.y, high = along_x ? d->upper.x : d->upper.y;
    double first = (double)(low >> TD_COARSE_SHIFT) - (double)reference;
    double last = (double)(high >> TD_COARSE_SHIFT) - (double)reference;
    float height = (float)(d->draw->upper.y - d->draw->lower.y) / ROWS_A_VIEW;
    int used = 0;
    for (int i = 0; i < ROWS; i++) {
        taken[i] = -0x1p80;
    }
    int count = set->keys.count ? set->ids.count : 0;
    for (int i = 0; i < count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(d->w, keys[i].shape);
        const td_bounds *b = &proxy->fat;
        double min = keys[i].min;
        double max = min + (double)(along_x ? td_wrap_sub(b->max_x, b->min_x)
                                            : td_wrap_sub(b->max_y, b->min_y));
        bool overlaps = furthest >= min || (i + 1 < count && keys[i + 1].min <= max);
        furthest = td_max_double(furthest, max);
        if (max < first || min > last) {
            continue;
        }
        int at = free_row(taken, min);
        taken[at] = max;
        used = td_max_int(used, at + 1);
        int64_t quantum = 1 << TD_COARSE_SHIFT;
        td_position from = d->lower, to = d->lower;
        *(along_x ? &from.x : &from.y) = (reference + (int64_t)min) * quantum;
        *(along_x ? &to.x : &to.y) = (reference + (int64_t)max) * quantum;
        thud_vec2 p = td_drawing_local(d, from), q = td_drawing_local(d, to);
        float aside = height * (float)(rows + at + 1);
        *(along_x ? &p.y : &p.x) += aside;
        *(along_x ? &q.y : &q.x) += aside;
        td_drawing_line(d, p, q, overlaps ? THUD_STYLE_INTERVAL_OVERLAPPING : THUD_STYLE_INTERVAL);
    }
    return rows + used;
}

void td_draw_intervals(const td_drawing *d) {
    int rows = draw_intervals(d, &d->w->awake_shapes, 0);
    draw_intervals(d, &d->w->rest_shapes, rows);
}

/* ---- pairs ---- */

/* Half the width and height of a shape's tight bounds (without the margin of fat bounds), length.
 */
static thud_pos half_bounds(const td_shape_proxy *proxy) {
    double c = __builtin_fabs((double)proxy->c), s = __builtin_fabs((double)proxy->s);
    double x = (double)proxy->half_x, y = (double)proxy->half_y;
    return proxy->turns == 0.0f ? (thud_pos){x, y} : (thud_pos){c * x + s * y, s * x + c * y};
}

/* Whether the tight bounds of a contact's shapes overlap; the bounds of a terrain segment have no
 * lower end, since the ground is solid below it. */
static bool bounds_overlap(const td_drawing *d, const td_contact *contact) {
    const thud_world *w = d->w;
    const td_shape_proxy *a = td_shape_proxy_at(w, contact->shape_a),
                         *b = td_shape_proxy_at(w, contact->shape_b);
    thud_pos half = half_bounds(b);
    double x = (double)(b->center.x - a->center.x) / w->to_fixed;
    double y = (double)(b->center.y - a->center.y) / w->to_fixed;
    if (!td_kind_is_line(td_shape_at(w, contact->shape_a)->kind)) {
        thud_pos other = half_bounds(a);
        return __builtin_fabs(x) <= half.x + other.x && __builtin_fabs(y) <= half.y + other.y;
    }
    thud_terrain ground = td_terrain_view(w, contact->shape_a);
    if (ground.kind == THUD_TERRAIN_FLAT) {
        return y - half.y <= ground.slope * x + __builtin_fabs(ground.slope) * half.x;
    }
    const thud_pos *p = &ground.points[contact->child], *q = p + 1;
    return x + half.x >= p->x && x - half.x <= q->x && y - half.y <= td_max_double(p->y, q->y);
}

/* Draws all contacts. `stages`: contacts of which only the fat bounds overlap get a style of their
 * own. */
static void draw_pairs(const td_drawing *d, bool stages) {
    for (int i = 0; i < d->w->constraints.count; i++) {
        const td_constraint *contact = td_constraint_at(d->w, i);
        if (!td_is_contact(contact) || !contact->live || td_contact_is_ending(d->w, contact)) {
            continue;
        }
        td_drawing_pair(d, contact,
                        contact->open                           ? THUD_STYLE_PAIR_TOUCHING
                        : stages && !bounds_overlap(d, contact) ? THUD_STYLE_PAIR_CANDIDATE
                                                                : THUD_STYLE_PAIR);
    }
}

void td_draw_pairs(const td_drawing *d) {
    draw_pairs(d, false);
}

void td_draw_stages(const td_drawing *d) {
    draw_pairs(d, true);
}

/* ---- motions ---- */

/* Draws the two lines parallel to the motion (x, y) that touch a circle at both ends of the motion.
 */
static void join_circles(const td_drawing *d, const thud_geometry *start, double x, double y) {
    double part = start->hx / __builtin_sqrt(x * x + y * y);
    for (int side = -1; side <= 1; side += 2) {
        double ax = start->x - side * part * y, ay = start->y + side * part * x;
        td_drawing_line(d, (thud_vec2){(float)ax, (float)ay},
                        (thud_vec2){(float)(ax + x), (float)(ay + y)}, THUD_STYLE_MOTION);
    }
}

static double distance_squared(thud_pos p, thud_pos q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

/* The corner after p on the convex hull, counter-clockwise: no corner lies to the right of the line
 * from p to it, and of several on that line it is the furthest. `rounding`: cross products up to
 * this (length^2) count as 0. */
static int next_on_hull(const thud_pos *corners, int count, int p, double rounding) {
    int q = (p + 1) % count;
    for (int r = 0; r < count; r++) {
        double right = (corners[q].y - corners[p].y) * (corners[r].x - corners[p].x) -
                       (corners[q].x - corners[p].x) * (corners[r].y - corners[p].y);
        if (right > rounding ||
            (right >= -rounding &&
             distance_squared(corners[r], corners[p]) > distance_squared(corners[q], corners[p]))) {
            q = r;
        }
    }
    return q;
}

/* Draws those sides of the convex hull of both boxes that join a corner of one to a corner of the
 * other. The hull is found by gift wrapping (R. A. Jarvis, On the identification of the convex hull
 * of a finite set of points in the plane, 1973). */
static void join_boxes(const td_drawing *d, const thud_geometry *start, const thud_geometry *end) {
    enum { CORNERS = 4, BOTH = 8 };
    thud_pos corners[BOTH], middle = {start->x, start->y};
    int first = 0;
    for (int i = 0; i < BOTH; i++) {
        td_corner(i < CORNERS ? start : end, i % CORNERS, &corners[i].x, &corners[i].y);
        if (distance_squared(corners[i], middle) > distance_squared(corners[first], middle)) {
            first = i; /* the corner furthest from any point is on the hull */
        }
    }
    /* Chosen: far above the rounding of double precision, far below what is visible. */
    double rounding = 1e-9 * distance_squared(corners[first], middle);
    for (int turns = 0, p = first; turns < BOTH && (turns == 0 || p != first); turns++) {
        int q = next_on_hull(corners, BOTH, p, rounding);
        if (p / CORNERS != q / CORNERS) {
            td_drawing_line(d, (thud_vec2){(float)corners[p].x, (float)corners[p].y},
                            (thud_vec2){(float)corners[q].x, (float)corners[q].y},
                            THUD_STYLE_MOTION);
        }
        p = q;
    }
}

/* Draws a shape's outline in the style of motions. */
static void draw_outline(const td_drawing *d, const thud_geometry *p) {
    thud_vec2 at = {(float)p->x, (float)p->y};
    switch (p->kind) {
    case THUD_SHAPE_CIRCLE:
        if (d->draw->circle) {
            d->draw->circle(at, (float)p->hx, 1.0f, 0.0f, THUD_STYLE_MOTION, -1, d->draw->context);
        }
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        if (d->draw->box) {
            d->draw->box(at, (thud_vec2){(float)p->hx, (float)p->hy}, (float)p->c, (float)p->s,
                         THUD_STYLE_MOTION, -1, d->draw->context);
        }
        break;
    case THUD_SHAPE_TERRAIN: /* does not move */
        break;
    }
}

/* Draws the swept volume of a shape: the shape at both ends of its motion, and the sides of their
 * convex hull that join them. */
static void draw_swept(const td_drawing *d, const thud_geometry *start, const thud_geometry *end) {
    draw_outline(d, start);
    draw_outline(d, end);
    switch (start->kind) {
    case THUD_SHAPE_CIRCLE:
        join_circles(d, start, end->x - start->x, end->y - start->y);
        break;
    case THUD_SHAPE_AABB:
    case THUD_SHAPE_OBB:
        join_boxes(d, start, end);
        break;
    case THUD_SHAPE_TERRAIN:
        break;
    }
}

/* Whether the bounds of the straight motion from start to end overlap the view. */
static bool in_view(const td_drawing *d, const thud_geometry *start, const thud_geometry *end) {
    thud_vec2 lower = td_drawing_local(d, d->lower), upper = td_drawing_local(d, d->upper);
    double reach = td_reach(start);
    double left = start->x < end->x ? start->x : end->x, right = start->x + end->x - left;
    double low = start->y < end->y ? start->y : end->y, high = start->y + end->y - low;
    return right + reach >= (double)lower.x && left - reach <= (double)upper.x &&
           high + reach >= (double)lower.y && low - reach <= (double)upper.y;
}

/* Draws the motion of the last step of each body that moved further than a quarter of its smallest
 * size: half of reach[0], as finalize.c tests it. */
void td_draw_motions(const td_drawing *d) {
    const thud_world *w = d->w;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        const float *delta = td_row(&w->delta, slot);
        float fast = 0.5f * td_row(&w->reach, slot)[0];
        td_body_index index = td_body_of(w, slot);
        if (delta[0] * delta[0] + delta[1] * delta[1] <= fast * fast) {
            continue;
        }
        const td_pose *pose = td_pose_at(w, index);
        td_trajectory trajectory = {.place = pose->center,
                                    .angle = pose->angle,
                                    .since = 1.0,
                                    .motion = {(double)delta[0], (double)delta[1],
                                               (double)delta[2]}};
        for (int i = td_body_at(w, index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
            thud_geometry start = td_trajectory_shape(w, &trajectory, i, 0.0, d->origin);
            thud_geometry end = td_trajectory_shape(w, &trajectory, i, 1.0, d->origin);
            if ((end.x == start.x && end.y == start.y) || !in_view(d, &start, &end)) {
                continue;
            }
            draw_swept(d, &start, &end);
        }
    }
}
