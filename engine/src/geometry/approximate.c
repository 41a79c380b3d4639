/* approximate.c: a polygon approximated by circles and boxes; see thud_approximate.h.
 *
 * A greedy search adds one shape after the other. A shape covers area of the polygon that is not
 * covered yet (inside) and area outside of it; its score is inside - weight * outside. Each shape
 * is found by a pattern search (R. Hooke and T. Jeeves, "Direct search" solution of numerical and
 * statistical problems, 1961) from the points that are deepest in what is not covered yet: circles
 * by centre and radius, boxes by their four sides, at angles of the polygon's edges. The search
 * also tries sides through corners of the polygon, so that boxes which fit exactly are found
 * exactly.
 *
 * Three searches run side by side. With weight 1 each shape makes the wrong area (missed + extra)
 * as small as possible at once, which is best for few shapes; with a larger weight shapes stay
 * inside the polygon, which gives less wrong area with many shapes. A result replaces the one with
 * fewer shapes only if neither its wrong area nor its distance is larger.
 *
 * The polygon is moved to the origin and scaled by a power of two, so that its extent is 0.5 to 1,
 * and turned around if it is clockwise. */
#include "thud/thud_approximate.h"

#include "base/memory.h"
#include "geometry/cover.h"
#include "geometry/polygon.h"

enum {
    SEARCHES = 3,
    SEEDS = 3,      /* starting points of the search for a shape. Chosen */
    DIRECTIONS = 4, /* angles of boxes at each starting point. Chosen */
    ROUNDS_MAX = 4  /* passes over the sides at one step width. Chosen */
};

/* Weight of area outside, by search. Chosen: the largest keeps shapes within about a thousandth of
 * the polygon's extent, and the middle one is best for about four shapes. */
static const double OUTSIDE[SEARCHES] = {1.0, 6.0, 48.0};
/* Weight of area that is already covered by other shapes. Small: it only decides between shapes
 * that add equal areas. */
static const double AGAIN = 1.0 / 64.0;
/* Step widths of a search: at its start; at the end of the coarse search, after which shapes are
 * compared; and at the end of the fine search of the best one. */
static const double STEP_FIRST = 0.25, STEP_COMPARED = 1.0 / 32.0, STEP_LAST = 1.0 / 4096.0;
/* SMALLEST: the minimum half extent of a shape, in internal lengths. WORTH: the minimum score of a
 * shape, as a share of the polygon's area. Chosen. */
static const double SMALLEST = 1e-5, WORTH = 1e-6;

/* One of the searches: its shapes so far, and its errors. */
typedef struct search {
    double outside; /* weight */
    thud_geometry shapes[THUD_APPROXIMATE_SHAPES_MAX];
    td_convex sets[THUD_APPROXIMATE_SHAPES_MAX];
    int count;
    bool ended;
    td_cover_line *lines;
    double beyond, within; /* upper bounds of the distance of its shapes' points from the polygon,
                              and of the polygon's points from its shapes */
    thud_approximation errors;
} search;

/* The memory of a call. */
typedef struct work {
    search searches[SEARCHES];
    thud_pos points[THUD_POLYGON_POINTS_MAX];
    td_convex triangles[THUD_POLYGON_POINTS_MAX];
    td_cover_piece stack[TD_PIECE_STACK];
    double ys[THUD_POLYGON_POINTS_MAX + 4 * THUD_APPROXIMATE_SHAPES_MAX];
    td_interval intervals[THUD_POLYGON_POINTS_MAX + 3 * THUD_APPROXIMATE_SHAPES_MAX];
    td_cover_line lines[SEARCHES][THUD_POLYGON_POINTS_MAX + TD_COVER_LINES];
    int left[THUD_POLYGON_POINTS_MAX], corners[THUD_POLYGON_POINTS_MAX][3];
    int count, triangle_count, line_count;
    double area;
    thud_pos origin;
    double scale; /* internal lengths per length of the caller */
    thud_approximate_kind kinds;
} work;

/* ---- the search for one shape ---- */

static double score_of(const work *w, const search *s, const thud_geometry *shape) {
    td_cover_gain gain = td_cover_gain_of(s->lines, w->line_count, shape);
    return gain.inside - s->outside * gain.outside - AGAIN * gain.again;
}

/* A shape and its score. */
typedef struct candidate {
    thud_geometry shape;
    double score;
} candidate;

/* Replaces *best by a changed shape if that is better by more than rounding. */
static bool keep_better(const work *w, const search *s, candidate *best, thud_geometry shape) {
    if (!(shape.hx >= SMALLEST && (td_kind_is_round(shape.kind) || shape.hy >= SMALLEST))) {
        return false;
    }
    double score = score_of(w, s, &shape);
    if (!(score > best->score + 1e-12)) {
        return false;
    }
    *best = (candidate){shape, score};
    return true;
}

/* Tries to move the circle, or to change its radius, by a step, and keeps each change that improves
 * the score. Returns whether one did. */
static bool improve_circle(const work *w, const search *s, candidate *best, double step) {
    bool better = false;
    for (int i = 0; i < 6; i++) {
        thud_geometry shape = best->shape;
        double by = i % 2 ? -step : step;
        shape.x += i / 2 == 1 ? by : 0.0;
        shape.y += i / 2 == 2 ? by : 0.0;
        shape.hx += i / 2 == 0 ? by : 0.0;
        better = keep_better(w, s, best, shape) || better;
    }
    return better;
}

/* The box after one of its sides, 0 to 3, has been moved to the coordinate `to` of its own frame;
 * the opposite side stays. */
static thud_geometry with_side(const thud_geometry *box, int side, double to) {
    thud_geometry moved = *box;
    double u = box->c * box->x + box->s * box->y, v = box->c * box->y - box->s * box->x;
    double *centre = side < 2 ? &u : &v, *half = side < 2 ? &moved.hx : &moved.hy;
    double far = side % 2 ? *centre - *half : *centre + *half;
    *half = side % 2 ? 0.5 * (to - far) : 0.5 * (far - to);
    *centre = 0.5 * (to + far);
    moved.x = box->c * u - box->s * v;
    moved.y = box->s * u + box->c * v;
    return moved;
}

/* The coordinates along (c, k) of the polygon's corners nearest to `at`, two on each side. */
static void corners_beside(const work *w, double c, double k, double at, double out[4]) {
    out[0] = out[1] = -1e300;
    out[2] = out[3] = 1e300;
    for (int i = 0; i < w->count; i++) {
        double corner = c * w->points[i].x + k * w->points[i].y;
        if (corner < at - 1e-9 && corner > out[0] + 1e-9) {
            out[1] = out[0];
            out[0] = corner;
        } else if (corner < out[0] - 1e-9 && corner > out[1]) {
            out[1] = corner;
        } else if (corner > at + 1e-9 && corner < out[2] - 1e-9) {
            out[3] = out[2];
            out[2] = corner;
        } else if (corner > out[2] + 1e-9 && corner < out[3]) {
            out[3] = corner;
        }
    }
}

/* Moves the sides of a box by a step, and to the next two corners of the polygon in both
 * directions. It tries two corners, since moving to the first may add no area: where the polygon is
 * a cross of two bars, only moving to the second does. */
static bool improve_box(const work *w, const search *s, candidate *best, double step) {
    bool better = false;
    for (int side = 0; side < 4; side++) {
        const thud_geometry box = best->shape;
        double c = side < 2 ? box.c : -box.s, k = side < 2 ? box.s : box.c;
        double half = side < 2 ? box.hx : box.hy;
        double at = c * box.x + k * box.y + (side % 2 ? half : -half);
        double to[6] = {at - step, at + step};
        corners_beside(w, c, k, at, to + 2);
        for (int i = 0; i < 6; i++) {
            if (td_abs(to[i]) < 4.0) {
                better = keep_better(w, s, best, with_side(&box, side, to[i])) || better;
            }
        }
    }
    return better;
}

/* Improves a shape with step widths that halve from `from` to `to`. */
static void improve(const work *w, const search *s, candidate *best, double from, double to) {
    for (double step = from; step >= to; step *= 0.5) {
        for (int round = 0; round < ROUNDS_MAX; round++) {
            if (!(td_kind_is_round(best->shape.kind) ? improve_circle(w, s, best, step)
                                                     : improve_box(w, s, best, step))) {
                break;
            }
        }
    }
}

/* ---- starting points ---- */

/* The distance of a point from the segment from a to b. *along: the unit direction of the segment.
 */
static double from_segment(thud_pos p, thud_pos a, thud_pos b, thud_pos *along) {
    double x = b.x - a.x, y = b.y - a.y, length = __builtin_sqrt(x * x + y * y);
    *along = length > 0.0 ? (thud_pos){x / length, y / length} : (thud_pos){1.0, 0.0};
    double t = td_clamp((p.x - a.x) * along->x + (p.y - a.y) * along->y, 0.0, length);
    double dx = p.x - a.x - t * along->x, dy = p.y - a.y - t * along->y;
    return __builtin_sqrt(dx * dx + dy * dy);
}

/* The depth of a point in the area that is not covered yet: its distance from the polygon's outline
 * and from the shapes. *along: the direction of the nearest edge. */
static double depth_of(const work *w, const search *s, thud_pos p, thud_pos *along) {
    double depth = 1e300;
    for (int i = 0; i < w->count; i++) {
        thud_pos direction;
        double distance =
            from_segment(p, w->points[i], w->points[i + 1 < w->count ? i + 1 : 0], &direction);
        if (distance < depth) {
            depth = distance;
            *along = direction;
        }
    }
    for (int i = 0; i < s->count; i++) {
        const thud_geometry point = {.kind = THUD_SHAPE_CIRCLE, .x = p.x, .y = p.y, .c = 1.0};
        thud_closest closest;
        td_closest(&s->shapes[i], &point, &closest);
        depth = td_min_double(depth, closest.distance);
    }
    return depth;
}

/* A starting point of a search. */
typedef struct seed {
    thud_pos at, along; /* the direction of the nearest edge */
    double depth;
} seed;

/* Inserts a starting point into the list of the deepest ones. Of points that are nearer to each
 * other than their depth, only the deepest is kept. */
static int keep_seed(seed *seeds, int count, seed one) {
    for (int i = 0; i < count; i++) {
        double x = seeds[i].at.x - one.at.x, y = seeds[i].at.y - one.at.y;
        double apart = td_max_double(seeds[i].depth, one.depth);
        if (x * x + y * y < apart * apart) {
            seeds[i] = one.depth > seeds[i].depth ? one : seeds[i];
            return count;
        }
    }
    if (count < SEEDS) {
        seeds[count] = one;
        return count + 1;
    }
    int shallowest = 0;
    for (int i = 1; i < count; i++) {
        shallowest = seeds[i].depth < seeds[shallowest].depth ? i : shallowest;
    }
    seeds[shallowest] = one.depth > seeds[shallowest].depth ? one : seeds[shallowest];
    return count;
}

static int find_seeds(const work *w, const search *s, seed *seeds) {
    int count = 0;
    for (int i = 0; i < w->line_count; i++) {
        const td_cover_line *line = &s->lines[i];
        for (int k = 0; k < line->open_count; k++) {
            seed one = {
                .at = {0.5 * (line->open[k].from + line->open[k].to), 0.5 * (line->y0 + line->y1)}};
            one.depth = depth_of(w, s, one.at, &one.along);
            if (one.depth > SMALLEST) {
                count = keep_seed(seeds, count, one);
            }
        }
    }
    return count;
}

/* Adds a direction, unless there is one within about half a degree of it or of its perpendicular.
 */
static int add_direction(thud_pos *list, int count, thud_pos along) {
    for (int i = 0; i < count; i++) {
        double dot = list[i].x * along.x + list[i].y * along.y;
        double cross = list[i].x * along.y - list[i].y * along.x;
        if (td_abs(dot) < 0.01 || td_abs(cross) < 0.01) {
            return count;
        }
    }
    list[count] = along;
    return count + 1;
}

/* The directions of the longest edges, the longest first; of edges of exactly equal length only the
 * first is used; `count` elements are already in the list. */
static int edge_directions(const work *w, thud_pos *list, int count) {
    double below = 1e300;
    for (int i = 0; i < w->count && count < DIRECTIONS; i++) {
        double longest = 0.0;
        thud_pos along = {1.0, 0.0};
        for (int k = 0; k < w->count; k++) {
            thud_pos p = w->points[k], q = w->points[k + 1 < w->count ? k + 1 : 0];
            double x = q.x - p.x, y = q.y - p.y, length = __builtin_sqrt(x * x + y * y);
            if (length > longest && length < below) {
                longest = length;
                along = (thud_pos){x / length, y / length};
            }
        }
        if (longest == 0.0) {
            break;
        }
        below = longest;
        count = add_direction(list, count, along);
    }
    return count;
}

/* Tries a shape at a starting point, and stores it in *best if it is better. */
static void try_shape(const work *w, const search *s, thud_geometry shape, candidate *best) {
    candidate one = {shape, score_of(w, s, &shape)};
    improve(w, s, &one, STEP_FIRST, STEP_COMPARED);
    *best = one.score > best->score + 1e-9 ? one : *best;
}

/* The box about a point along a unit vector, rotated by multiples of 90 degrees so that its angle
 * is above -45 and at most 45 degrees: an axis-aligned box gets exactly (1, 0). */
static thud_geometry box_along(thud_pos at, thud_pos along, double half) {
    while (!(along.x > 0.0 && along.y > -along.x && along.y <= along.x)) {
        along = (thud_pos){along.y, 0.0 - along.x};
    }
    return (thud_geometry){THUD_SHAPE_OBB, at.x, at.y, along.x, along.y + 0.0, half, half};
}

/* The box around the polygon. */
static thud_geometry box_around(const work *w) {
    double x = 0.0, y = 0.0;
    for (int i = 0; i < w->count; i++) {
        x = td_max_double(x, td_abs(w->points[i].x));
        y = td_max_double(y, td_abs(w->points[i].y));
    }
    return (thud_geometry){THUD_SHAPE_OBB, 0.0, 0.0, 1.0, 0.0, x, y};
}

/* The circle through the corners of that box. */
static thud_geometry circle_around(const work *w) {
    thud_geometry box = box_around(w);
    double radius = __builtin_sqrt(box.hx * box.hx + box.hy * box.hy);
    return (thud_geometry){THUD_SHAPE_CIRCLE, 0.0, 0.0, 1.0, 0.0, radius, 0.0};
}

/* Finds the next shape of a search. False if none has the minimum score. The first shape always
 * exists: for a polygon that is too jagged it is one around it. */
static bool find_shape(const work *w, const search *s, thud_geometry *out) {
    seed seeds[SEEDS];
    int count = find_seeds(w, s, seeds);
    candidate best = {.score = 0.0};
    for (int i = 0; i < count; i++) {
        thud_pos at = seeds[i].at, directions[DIRECTIONS];
        double depth = td_max_double(seeds[i].depth, SMALLEST);
        if (w->kinds != THUD_APPROXIMATE_CIRCLES) {
            int all = edge_directions(w, directions, add_direction(directions, 0, seeds[i].along));
            for (int k = 0; k < all; k++) {
                try_shape(w, s, box_along(at, directions[k], 0.7 * depth), &best);
            }
        }
        if (w->kinds != THUD_APPROXIMATE_BOXES) {
            try_shape(w, s, (thud_geometry){THUD_SHAPE_CIRCLE, at.x, at.y, 1.0, 0.0, depth, 0.0},
                      &best);
        }
    }
    if (best.score <= WORTH * w->area) {
        *out = w->kinds == THUD_APPROXIMATE_CIRCLES ? circle_around(w) : box_around(w);
        return s->count == 0;
    }
    improve(w, s, &best, STEP_COMPARED, STEP_LAST);
    *out = best.shape;
    return true;
}

/* ---- errors ---- */

/* Measures the errors of a search's shapes. */
static void measure(work *w, search *s) {
    td_cover_areas areas =
        td_cover_measure(w->points, w->count, s->shapes, s->count, w->ys, w->intervals);
    double sum = 0.0;
    for (int i = 0; i < s->count; i++) {
        double area, moment;
        td_kind_area(s->shapes[i].kind, s->shapes[i].hx, s->shapes[i].hy, &area, &moment);
        sum += area;
    }
    s->errors = (thud_approximation){.count = s->count,
                                     .missed = areas.missed / w->area,
                                     .extra = areas.extra / w->area,
                                     .overlap = td_max_double(sum - areas.covered, 0.0) / w->area};
}

/* Bounds the distance. A further shape moves no point of the polygon further away from the shapes,
 * and of the shapes' points only those of the last shape are new. */
static void measure_distance(work *w, search *s) {
    double within = 0.0;
    for (int i = 0; i < w->triangle_count; i++) {
        double known = td_max_double(within, s->beyond);
        within = td_max_double(within, td_cover_distance(&w->triangles[i], s->sets, s->count, NULL,
                                                         0, known, w->stack));
    }
    s->within = td_min_double(s->within, within);
    s->errors.distance = td_max_double(s->within, s->beyond);
}

/* Adds the next shape of a search, if there is one. */
static void advance(work *w, search *s) {
    s->ended = s->ended || !find_shape(w, s, &s->shapes[s->count]);
    if (s->ended) {
        return;
    }
    s->sets[s->count] = td_convex_of_shape(&s->shapes[s->count]);
    td_cover_add(s->lines, w->line_count, &s->shapes[s->count]);
    s->beyond = td_max_double(s->beyond,
                              td_cover_distance(&s->sets[s->count], w->triangles, w->triangle_count,
                                                w->points, w->count, s->beyond, w->stack));
    s->count++;
    measure(w, s);
    measure_distance(w, s);
}

/* ---- the call ---- */

/* Bytes of the lists of one search's lines. */
static size_t bytes_of_lists(int points, int shapes) {
    size_t lines = (size_t)(points + TD_COVER_LINES), each = (size_t)(points + 2 * shapes + 4);
    return lines * each * sizeof(td_interval);
}

/* Gives each line its memory: points + shapes + 2 intervals for `open`, more than the points / 2 +
 * shapes that can occur, and shapes + 2 for `taken`. */
static void give_room(work *w, td_interval *lists, int points, int shapes) {
    int open = points + shapes + 2, taken = shapes + 2;
    for (int i = 0; i < SEARCHES; i++) {
        w->searches[i].lines = w->lines[i];
        for (int k = 0; k < points + TD_COVER_LINES; k++) {
            w->lines[i][k].open = lists;
            w->lines[i][k].taken = lists + open;
            lists += open + taken;
        }
    }
}

/* Sets up the polygon, and the searches. */
static void prepare(work *w, const thud_pos *points, int count) {
    thud_pos low = points[0], high = low;
    for (int i = 1; i < count; i++) {
        low = (thud_pos){td_min_double(low.x, points[i].x), td_min_double(low.y, points[i].y)};
        high = (thud_pos){td_max_double(high.x, points[i].x), td_max_double(high.y, points[i].y)};
    }
    double extent = td_max_double(high.x - low.x, high.y - low.y);
    w->origin = (thud_pos){0.5 * low.x + 0.5 * high.x, 0.5 * low.y + 0.5 * high.y};
    w->scale = 1.0;
    for (; extent * w->scale > 1.0; w->scale *= 0.5) {
    }
    for (; extent * w->scale <= 0.5; w->scale *= 2.0) {
    }
    bool clockwise = td_polygon_area(points, count) < 0.0;
    for (int i = 0; i < count; i++) {
        const thud_pos *p = &points[clockwise ? count - 1 - i : i];
        w->points[i] = (thud_pos){(p->x - w->origin.x) * w->scale, (p->y - w->origin.y) * w->scale};
    }
    w->count = count;
    w->area = td_polygon_area(w->points, count);
    w->triangle_count = td_polygon_triangles(w->points, count, w->left, w->corners);
    for (int i = 0; i < w->triangle_count; i++) {
        const int *at = w->corners[i];
        w->triangles[i] =
            td_convex_of_triangle(w->points[at[0]], w->points[at[1]], w->points[at[2]]);
    }
    for (int i = 0; i < SEARCHES; i++) {
        search *s = &w->searches[i];
        s->outside = OUTSIDE[i];
        s->within = 1e300;
        w->line_count = td_cover_lines(w->points, count, w->ys, s->lines);
    }
}

/* Whether the shapes of a search are better than the result with fewer shapes: their wrong area
 * (missed + extra) is smaller, and their distance is not larger. */
static bool is_better(const search *s, const thud_approximation *than) {
    return s->errors.missed + s->errors.extra < than->missed + than->extra &&
           s->errors.distance <= than->distance;
}

/* Runs all searches, and copies the shapes of the better one. `good`: adds no more shapes once the
 * distance is at most this. */
static void run(work *w, int shapes_max, double good, thud_geometry *out,
                thud_approximation *found) {
    *found = (thud_approximation){.missed = 1e300, .distance = 1e300};
    bool ended = false;
    for (int k = 1; k <= shapes_max && !ended && found->distance > good; k++) {
        ended = true;
        for (int i = 0; i < SEARCHES; i++) {
            search *s = &w->searches[i];
            advance(w, s);
            ended = ended && s->ended;
            if (!s->ended && is_better(s, found)) {
                *found = s->errors;
                for (int n = 0; n < s->count; n++) {
                    out[n] = s->shapes[n];
                }
            }
        }
    }
}

/* Transforms the result back to the caller's origin and unit. The distance is rounded up. */
static void give_back(const work *w, thud_geometry *shapes, thud_approximation *found) {
    double size = 1.0 / w->scale;
    for (int i = 0; i < found->count; i++) {
        shapes[i].x = w->origin.x + shapes[i].x * size;
        shapes[i].y = w->origin.y + shapes[i].y * size;
        shapes[i].hx *= size;
        shapes[i].hy *= size;
    }
    double rounding = 1e-13 * size + 1e-15 * (td_abs(w->origin.x) + td_abs(w->origin.y));
    found->distance = found->distance * size + rounding;
}

thud_result thud_approximate(const thud_pos *points, int count,
                             const thud_approximate_options *options, thud_geometry *out_shapes,
                             thud_approximation *out) {
    if (!points || !options || !out_shapes || !out) {
        return THUD_ERROR_NULL;
    }
    if (options->shapes_max < 1 || options->shapes_max > THUD_APPROXIMATE_SHAPES_MAX ||
        options->kinds < THUD_APPROXIMATE_BOTH || options->kinds > THUD_APPROXIMATE_BOXES ||
        !td_target_valid(options->distance) || thud_polygon_check(points, count, NULL) != THUD_OK) {
        return THUD_ERROR_INVALID;
    }
    size_t lists = bytes_of_lists(count, options->shapes_max);
    td_memory memory = td_memory_make(options->allocator);
    work *w = td_memory_get(&memory, sizeof *w);
    td_interval *room = td_memory_get(&memory, SEARCHES * lists);
    bool enough = w && room;
    if (enough) {
        w->kinds = options->kinds;
        give_room(w, room, count, options->shapes_max);
        prepare(w, points, count);
        run(w, options->shapes_max, options->distance * w->scale, out_shapes, out);
        give_back(w, out_shapes, out);
    }
    td_memory_put(&memory, room, SEARCHES * lists);
    td_memory_put(&memory, w, sizeof *w);
    return enough ? THUD_OK : THUD_ERROR_MEMORY;
}
