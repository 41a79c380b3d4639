/* draw_detection.c: what detection goes by, drawn: the grid's cells, the plane sweep's sorted
 * intervals, the pairs that they give, and the motions of fast shapes. */
#include "api/debug_draw.h"
#include "detection/trajectory.h"
#include "contact/contact.h"
#include "geometry/shape_instance.h"
#include "state/shape.h"

/* ---- cells ---- */

/* The cells that awake shapes lie in; of shapes side by side in one, once. Without a grid there is
 * no level with shapes. */
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
            /* Hashing may give two cells one number: their places tell them apart. */
            x = td_grid_index(x, grid->origin_x, level->inv_cell);
            y = td_grid_index(y, grid->origin_y, level->inv_cell);
            if (i > level->first && x == column && y == row) {
                continue;
            }
            column = x;
            row = y;
            int64_t size = level->cell + level->cell / 65536;
            x = grid->origin_x + x * size;
            y = grid->origin_y + y * size;
            td_drawing_bounds(d, x, y, x + size, y + size, THUD_DRAW_CELL);
        }
    }
}

/* ---- sorted intervals ---- */

enum {
    ROWS = 12, /* of bars above each other; where more overlap, they lie on top of each other */
    ROWS_A_VIEW = 90 /* of bars there would be from the lower edge to the upper one */
};

/* Where each row of bars is taken up to, so that bars side by side share a row. */
static int free_row(const double *taken, double least) {
    int best = 0;
    for (int i = 0; i < ROWS; i++) {
        if (taken[i] < least) {
            return i;
        }
        best = taken[i] < taken[best] ? i : best;
    }
    return best;
}

/* The sorted row of one proxy set, above `rows` rows of another; returns the rows in use. Only the
 * plane sweep has keys. */
static int draw_row(const td_drawing *d, const td_proxy_set *row, int rows) {
    const td_sweep_key *keys = row->keys.data;
    double taken[ROWS], furthest = -0x1p80;
    double left = (double)(d->lower.x >> TD_COARSE_SHIFT) - (double)row->reference;
    double right = (double)(d->upper.x >> TD_COARSE_SHIFT) - (double)row->reference;
    float height = (float)(d->draw->upper.y - d->draw->lower.y) / ROWS_A_VIEW;
    int used = 0;
    for (int i = 0; i < ROWS; i++) {
        taken[i] = -0x1p80;
    }
    for (int i = 0; i < row->keys.count; i++) {
        const td_shape_proxy *proxy = td_shape_proxy_at(d->w, keys[i].shape);
        double least = keys[i].least;
        double most = least + (double)td_wrap_sub(proxy->fat.max_x, proxy->fat.min_x);
        bool overlaps = furthest >= least || (i + 1 < row->keys.count && keys[i + 1].least <= most);
        furthest = td_max_double(furthest, most);
        if (most < left || least > right) {
            continue;
        }
        int at = free_row(taken, least);
        taken[at] = most;
        used = td_max_int(used, at + 1);
        int64_t quantum = 1 << TD_COARSE_SHIFT;
        td_position from = {(row->reference + (int64_t)least) * quantum, d->lower.y};
        td_position to = {(row->reference + (int64_t)most) * quantum, d->lower.y};
        thud_vec2 a = td_drawing_local(d, from), b = td_drawing_local(d, to);
        a.y = b.y = a.y + height * (float)(rows + at + 1);
        td_drawing_line(d, a, b, overlaps ? THUD_DRAW_INTERVAL_OVERLAPPING : THUD_DRAW_INTERVAL);
    }
    return rows + used;
}

void td_draw_intervals(const td_drawing *d) {
    int rows = draw_row(d, &d->w->awake_shapes, 0);
    draw_row(d, &d->w->rest_shapes, rows);
}

/* ---- pairs ---- */

/* The half size of a shape's true bounds. */
static thud_pos half_bounds(const td_shape_proxy *proxy) {
    double c = __builtin_fabs((double)proxy->c), s = __builtin_fabs((double)proxy->s);
    double x = (double)proxy->half_x, y = (double)proxy->half_y;
    return proxy->turns == 0.0f ? (thud_pos){x, y} : (thud_pos){c * x + s * y, s * x + c * y};
}

/* Whether a pair's true bounds overlap; those of a piece of terrain reach down without end. */
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

static void draw_pairs(const td_drawing *d, bool stages) {
    for (int i = 0; i < d->w->constraints.count; i++) {
        const td_constraint *contact = td_constraint_at(d->w, i);
        if (!td_is_contact(contact) || !contact->live || td_contact_is_ending(d->w, contact)) {
            continue;
        }
        td_drawing_pair(d, contact,
                        contact->open                           ? THUD_DRAW_PAIR_TOUCHING
                        : stages && !bounds_overlap(d, contact) ? THUD_DRAW_PAIR_CANDIDATE
                                                                : THUD_DRAW_PAIR);
    }
}

void td_draw_pairs(const td_drawing *d) {
    draw_pairs(d, false);
}

void td_draw_stages(const td_drawing *d) {
    draw_pairs(d, true);
}

/* ---- motions ---- */

/* The two tangents along the motion (x, y). */
static void join_circles(const td_drawing *d, const thud_shape_instance *start, double x,
                         double y) {
    double part = start->hx / __builtin_sqrt(x * x + y * y);
    for (int side = -1; side <= 1; side += 2) {
        double ax = start->x - side * part * y, ay = start->y + side * part * x;
        td_drawing_line(d, (thud_vec2){(float)ax, (float)ay},
                        (thud_vec2){(float)(ax + x), (float)(ay + y)}, THUD_DRAW_MOTION);
    }
}

static double distance_squared(thud_pos p, thud_pos q) {
    return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

/* The corner after p around the hull, counter-clockwise: none lies to the right of the way there,
 * and of those straight ahead it is the last. */
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

/* The sides of the convex hull of both that lead from one to the other, by gift wrapping. */
static void join_boxes(const td_drawing *d, const thud_shape_instance *start,
                       const thud_shape_instance *end) {
    enum { CORNERS = 4, BOTH = 8 };
    thud_pos corners[BOTH], middle = {start->x, start->y};
    int first = 0;
    for (int i = 0; i < BOTH; i++) {
        td_corner(i < CORNERS ? start : end, i % CORNERS, &corners[i].x, &corners[i].y);
        if (distance_squared(corners[i], middle) > distance_squared(corners[first], middle)) {
            first = i; /* what is farthest from any point is on the hull */
        }
    }
    double rounding = 1e-9 * distance_squared(corners[first], middle);
    for (int turns = 0, p = first; turns < BOTH && (turns == 0 || p != first); turns++) {
        int q = next_on_hull(corners, BOTH, p, rounding);
        if (p / CORNERS != q / CORNERS) {
            td_drawing_line(d, (thud_vec2){(float)corners[p].x, (float)corners[p].y},
                            (thud_vec2){(float)corners[q].x, (float)corners[q].y},
                            THUD_DRAW_MOTION);
        }
        p = q;
    }
}

static void draw_outline(const td_drawing *d, const thud_shape_instance *p) {
    thud_vec2 at = {(float)p->x, (float)p->y};
    switch (p->kind) {
    case THUD_CIRCLE:
        if (d->draw->circle) {
            d->draw->circle(at, (float)p->hx, 1.0f, 0.0f, THUD_DRAW_MOTION, -1, d->draw->context);
        }
        break;
    case THUD_AABB:
    case THUD_OBB:
        if (d->draw->box) {
            d->draw->box(at, (thud_vec2){(float)p->hx, (float)p->hy}, (float)p->c, (float)p->s,
                         THUD_DRAW_MOTION, -1, d->draw->context);
        }
        break;
    case THUD_TERRAIN: /* a line stands */
        break;
    }
}

/* A shape at both ends of its way, and the lines on which its outline goes. */
static void draw_way(const td_drawing *d, const thud_shape_instance *start,
                     const thud_shape_instance *end) {
    draw_outline(d, start);
    draw_outline(d, end);
    switch (start->kind) {
    case THUD_CIRCLE:
        join_circles(d, start, end->x - start->x, end->y - start->y);
        break;
    case THUD_AABB:
    case THUD_OBB:
        join_boxes(d, start, end);
        break;
    case THUD_TERRAIN:
        break;
    }
}

/* False: the straight way from start to end is out of sight. */
static bool in_view(const td_drawing *d, const thud_shape_instance *start,
                    const thud_shape_instance *end) {
    thud_vec2 lower = td_drawing_local(d, d->lower), upper = td_drawing_local(d, d->upper);
    double reach = td_reach(start);
    double left = start->x < end->x ? start->x : end->x, right = start->x + end->x - left;
    double low = start->y < end->y ? start->y : end->y, high = start->y + end->y - low;
    return right + reach >= (double)lower.x && left - reach <= (double)upper.x &&
           high + reach >= (double)lower.y && low - reach <= (double)upper.y;
}

void td_draw_motions(const td_drawing *d) {
    const thud_world *w = d->w;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        const float *delta = td_row(&w->delta, slot);
        float fast = 0.5f * td_row(&w->reach, slot)[0]; /* as in finalize.c */
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
            thud_shape_instance start = td_trajectory_shape(w, &trajectory, i, 0.0, d->origin);
            thud_shape_instance end = td_trajectory_shape(w, &trajectory, i, 1.0, d->origin);
            if ((end.x == start.x && end.y == start.y) || !in_view(d, &start, &end)) {
                continue;
            }
            draw_way(d, &start, &end);
        }
    }
}
