/* terrain_ray.c: a ray against a ground line, from above.
 *
 * The ray is followed from vertex to vertex. Its height over a vertex is worked out once and serves
 * the segments on both sides, so that no ray slips through between them. */
#include "terrain/terrain.h"

typedef struct ray {
    const thud_terrain *terrain;
    double ox, oy, dx, dy;
} ray;

/* Where the ray is over a place, and how far above the line. */
typedef struct stop {
    double fraction, height;
} stop;

static stop stop_over_vertex(const ray *r, int vertex) {
    double fraction = (td_terrain_x(r->terrain, vertex) - r->ox) / r->dx;
    return (stop){fraction, r->oy + fraction * r->dy - r->terrain->points[vertex].y};
}

/* The ray's own start or end; false where there is no line. */
static bool stop_at(const ray *r, double fraction, stop *out) {
    thud_terrain_sample sample;
    if (thud_terrain_sample_at(r->terrain, r->ox + fraction * r->dx, &sample) != THUD_OK) {
        return false;
    }
    *out = (stop){fraction, r->oy + fraction * r->dy - sample.height};
    return true;
}

/* Does the ray come down through the line between two stops? */
static bool comes_down(stop a, stop b, double *fraction) {
    if (!(a.height >= 0.0 && b.height <= 0.0 && a.height > b.height)) {
        return false;
    }
    double part = a.height / (a.height - b.height);
    *fraction = td_clamp(a.fraction + part * (b.fraction - a.fraction), 0.0, 1.0);
    return true;
}

static bool follow(const ray *r, int first, int last, double *fraction, int *segment) {
    bool rightward = r->dx > 0.0;
    int step = rightward ? 1 : -1, i = rightward ? first : last, behind = rightward ? last : first;
    stop a, b;
    if (stop_at(r, 0.0, &a)) {
        if (a.height < 0.0) {
            return false;
        }
        i = td_terrain_segment_at(r->terrain, r->ox);
    } else {
        a = stop_over_vertex(r, rightward ? 0 : r->terrain->count - 1);
    }
    for (; (behind - i) * step >= 0; i += step) {
        int vertex = rightward ? i + 1 : i;
        double reach = (td_terrain_x(r->terrain, vertex) - (r->ox + r->dx)) * step;
        if (r->dx == 0.0 || reach >= 0.0) {
            *segment = i;
            return stop_at(r, 1.0, &b) && comes_down(a, b, fraction);
        }
        b = stop_over_vertex(r, vertex);
        if (comes_down(a, b, fraction)) {
            *segment = i;
            return true;
        }
        a = b;
    }
    return false;
}

bool thud_terrain_cast_ray(const thud_terrain *terrain, double ox, double oy, double dx, double dy,
                           double *fraction, double *nx, double *ny) {
    if (td_terrain_readable(terrain) != THUD_OK || !td_finite(ox + oy + dx + dy)) {
        return false;
    }
    ray r = {terrain, ox, oy, dx, dy};
    double found = 0.0;
    int first, last, segment = 0;
    thud_terrain_segments(terrain, dx < 0.0 ? ox + dx : ox, dx < 0.0 ? ox : ox + dx, &first, &last);
    if (first > last) {
        return false;
    }
    if (terrain->kind == THUD_TERRAIN_FLAT) {
        double from = oy - terrain->slope * ox, fall = terrain->slope * dx - dy;
        if (!comes_down((stop){0.0, from}, (stop){1.0, from - fall}, &found)) {
            return false;
        }
    } else if (!follow(&r, first, last, &found, &segment)) {
        return false;
    }
    td_segment s = td_terrain_segment(terrain, segment, 0.0, 1.0);
    if (fraction) {
        *fraction = found;
    }
    if (nx) {
        *nx = -s.ty;
    }
    if (ny) {
        *ny = s.tx;
    }
    return true;
}
