/* terrain_reshape.c: see terrain_reshape.h. The tool's curve is sampled at points of a half
 * circle. */
#include "terrain/terrain_reshape.h"

#include "terrain/terrain.h"
#include "base/trig.h"

/* Number of chords that approximate the half circle, 11.25 degrees each: their error is at most 1 -
 * cos(5.625 degrees), 0.5 % of the radius. With half as many it would be 1.9 %; twice as many would
 * double the vertices that an edit adds. */
enum { ARC_PIECES = 16 };

/* Vertices nearer to each other than this share of the radius are merged. Chosen; not tuned. */
#define SPACING_MIN (1.0 / 64.0)

void td_tool_vertices(const thud_terrain *t, const td_tool *tool, int *first, int *count) {
    int begin = td_terrain_vertices_left_of(t, tool->x - tool->radius);
    if (begin < t->count && td_terrain_x(t, begin) == tool->x - tool->radius) {
        begin++;
    }
    int end = td_terrain_vertices_left_of(t, tool->x + tool->radius);
    *first = begin;
    *count = end > begin ? end - begin : 0;
}

int td_tool_room(int count) {
    /* Each vertex and each of the ARC_PIECES + 1 samples, and a crossing before each. */
    return 2 * (count + ARC_PIECES + 1);
}

/* The change of height by the tool at x, where the ground has the height `ground`. For a circle
 * only negative changes are applied. */
static double shift_at(const td_tool *tool, double x, double ground) {
    double u = (x - tool->x) / tool->radius, inside = td_max_double(1.0 - u * u, 0.0);
    /* A mound's slope is zero at its foot and on its top. */
    return tool->digs ? tool->y - tool->radius * __builtin_sqrt(inside) - ground
                      : tool->rise * inside * inside;
}

/* Whether a change of the height by `shift` is applied: a circle only removes ground. */
static bool changes(const td_tool *tool, double shift) {
    return tool->digs ? shift < 0.0 : shift != 0.0;
}

/* The x of sample i, 0 to ARC_PIECES, of the tool's lower half circle, from left to right. */
static double sample_x(const td_tool *tool, int i) {
    double s, c;
    td_sincos(TD_PI * i / ARC_PIECES, &s, &c);
    return tool->x - tool->radius * c;
}

/* The height of the line at x, between the vertices right - 1 and right. */
static double ground_at(const thud_terrain *t, int right, double x) {
    thud_pos p = t->points[right - 1], q = t->points[right];
    return p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x));
}

/* The new vertices, written from left to right. */
typedef struct polyline {
    const thud_pos *before; /* the last vertex to the left of the tool, which is kept; null: there
                               is none */
    thud_pos *out;
    int count;
    double spacing_min; /* minimum distance between two vertices */
    double stop;        /* x of the last vertex of the line */
} polyline;

/* Whether b, to the right of a, is too close to it for a vertex of its own. Their x must also
 * differ, by at least a millionth of the minimum distance. */
static bool too_near(const polyline *p, thud_pos a, thud_pos b) {
    double dx = b.x - a.x, dy = b.y - a.y;
    return dx * dx + dy * dy < p->spacing_min * p->spacing_min || dx < 1e-6 * p->spacing_min;
}

/* Appends a vertex, or drops it where it is too near to the last one. */
static void append(polyline *p, double x, double y) {
    const thud_pos *last = p->count ? &p->out[p->count - 1] : p->before;
    if (last && too_near(p, *last, (thud_pos){x, y})) {
        if (x < p->stop || x <= last->x) {
            return;
        }
        p->count -= p->count > 1; /* the end of the line replaces the last vertex */
    }
    p->out[p->count++] = (thud_pos){x, y};
}

/* Walks vertices and samples of the tool's curve together, in the order of x, and appends: samples
 * where the ground changes, all old vertices, and the points where changed and unchanged ground
 * meet. */
static void reshape_irregular(polyline *p, const thud_terrain *t, const td_tool *tool, int first,
                              int end) {
    double before_x = 0.0, before_ground = 0.0, before_shift = 0.0;
    bool begun = false;
    for (int v = first, k = 0; v < end || k <= ARC_PIECES;) {
        double x = k <= ARC_PIECES ? sample_x(tool, k) : t->points[v].x;
        bool vertex = v < end && t->points[v].x <= x;
        bool edge = !vertex && (k == 0 || k == ARC_PIECES);
        x = vertex ? t->points[v].x : x;
        int right = td_min_int(v, t->count - 1);
        v += vertex;
        k += !vertex;
        if (x < t->points[0].x || x > p->stop) {
            continue;
        }
        double ground = vertex || right == 0 ? t->points[right].y : ground_at(t, right, x);
        double shift = shift_at(tool, x, ground);
        /* At the ends of the half circle the ground is unchanged, even if that makes a nearly
         * vertical wall. */
        shift = edge && changes(tool, shift) ? 0.0 : shift;
        bool changed = changes(tool, shift);
        if (begun && changed != changes(tool, before_shift)) {
            double f = before_shift / (before_shift - shift);
            append(p, before_x + f * (x - before_x), before_ground + f * (ground - before_ground));
        }
        if (changed || vertex) {
            append(p, x, changed ? ground + shift : ground);
        }
        before_x = x;
        before_ground = ground;
        before_shift = shift;
        begun = true;
    }
}

int td_tool_reshape(const thud_terrain *t, const td_tool *tool, int first, int count,
                    thud_pos *out) {
    if (t->kind == THUD_TERRAIN_UNIFORM) {
        for (int i = 0; i < count; i++) {
            double x = td_terrain_x(t, first + i), y = t->points[first + i].y;
            double shift = shift_at(tool, x, y);
            out[i] = (thud_pos){x, changes(tool, shift) ? y + shift : y};
        }
        return count;
    }
    int end = first + count;
    polyline p = {first > 0 ? &t->points[first - 1] : NULL, out, 0, SPACING_MIN * tool->radius,
                  t->points[t->count - 1].x};
    reshape_irregular(&p, t, tool, first, end);
    if (end < t->count && p.count && too_near(&p, out[p.count - 1], t->points[end])) {
        p.count--;
    }
    return p.count;
}
