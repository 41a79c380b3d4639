/* terrain_reshape.c: see terrain_reshape.h. */
#include "terrain/terrain_reshape.h"

#include "terrain/terrain.h"
#include "base/trig.h"

/* Half a circle in pieces of 11.25 degrees: chords are within 0.5 % of the radius of the arc. */
enum { PIECES = 16 };

/* Vertices nearer to each other than this share of the radius become one. */
#define NEAREST (1.0 / 64.0)

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
    /* Every vertex and every sample, and a rim before each. */
    return 2 * (count + PIECES + 1);
}

/* By how much the tool would move ground of that height; a circle does so only downwards. */
static double shift_at(const td_tool *tool, double x, double ground) {
    double u = (x - tool->x) / tool->radius, inside = td_max_double(1.0 - u * u, 0.0);
    /* A mound's slope vanishes at its foot and on its top. */
    return tool->digs ? tool->y - tool->radius * __builtin_sqrt(inside) - ground
                      : tool->rise * inside * inside;
}

static bool moves(const td_tool *tool, double shift) {
    return tool->digs ? shift < 0.0 : shift != 0.0;
}

/* Places along the tool's lower half circle, from its left end to its right one. */
static double sample_x(const td_tool *tool, int i) {
    double s, c;
    td_sincos(TD_PI * i / PIECES, &s, &c);
    return tool->x - tool->radius * c;
}

static double ground_at(const thud_terrain *t, int right, double x) {
    thud_pos p = t->points[right - 1], q = t->points[right];
    return p.y + (q.y - p.y) * ((x - p.x) / (q.x - p.x));
}

/* A line that grows to the right. */
typedef struct pen {
    const thud_pos *before; /* the vertex that stays, or null */
    thud_pos *out;
    int count;
    double nearest;
    double stop; /* the end of the line */
} pen;

static bool too_near(const pen *p, thud_pos a, thud_pos b) {
    double dx = b.x - a.x, dy = b.y - a.y;
    return dx * dx + dy * dy < p->nearest * p->nearest || dx < 1e-6 * p->nearest;
}

static void draw_to(pen *p, double x, double y) {
    const thud_pos *last = p->count ? &p->out[p->count - 1] : p->before;
    if (last && too_near(p, *last, (thud_pos){x, y})) {
        if (x < p->stop || x <= last->x) {
            return;
        }
        p->count -= p->count > 1; /* the line keeps its end instead */
    }
    p->out[p->count++] = (thud_pos){x, y};
}

/* Walks along vertices and samples, and draws what moved, what is a vertex, and the rims between
 * moved ground and ground that stays. */
static void draw_irregular(pen *p, const thud_terrain *t, const td_tool *tool, int first, int end) {
    double before_x = 0.0, before_ground = 0.0, before_shift = 0.0;
    bool begun = false;
    for (int v = first, k = 0; v < end || k <= PIECES;) {
        double x = k <= PIECES ? sample_x(tool, k) : t->points[v].x;
        bool vertex = v < end && t->points[v].x <= x;
        bool edge = !vertex && (k == 0 || k == PIECES);
        x = vertex ? t->points[v].x : x;
        int right = td_min_int(v, t->count - 1);
        v += vertex;
        k += !vertex;
        if (x < t->points[0].x || x > p->stop) {
            continue;
        }
        double ground = vertex || right == 0 ? t->points[right].y : ground_at(t, right, x);
        double shift = shift_at(tool, x, ground);
        /* At its ends the tool leaves the ground as it is, if need be with a wall beside it. */
        shift = edge && moves(tool, shift) ? 0.0 : shift;
        bool moved = moves(tool, shift);
        if (begun && moved != moves(tool, before_shift)) {
            double f = before_shift / (before_shift - shift);
            draw_to(p, before_x + f * (x - before_x), before_ground + f * (ground - before_ground));
        }
        if (moved || vertex) {
            draw_to(p, x, moved ? ground + shift : ground);
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
            out[i] = (thud_pos){x, moves(tool, shift) ? y + shift : y};
        }
        return count;
    }
    int end = first + count;
    pen p = {first > 0 ? &t->points[first - 1] : NULL, out, 0, NEAREST * tool->radius,
             t->points[t->count - 1].x};
    draw_irregular(&p, t, tool, first, end);
    if (end < t->count && p.count && too_near(&p, out[p.count - 1], t->points[end])) {
        p.count--;
    }
    return p.count;
}
