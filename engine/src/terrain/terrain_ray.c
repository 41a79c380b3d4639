/* terrain_ray.c: a ray against a terrain, from above.
 *
 * The ray is followed from vertex to vertex, and its height above the line is computed at each. The
 * height at a vertex is computed once and used for the segments on both sides, so that rounding
 * lets no ray pass between them. */
#include "terrain/terrain.h"

/* A ray and the terrain that it is cast against. */
typedef struct ray {
    const thud_terrain *terrain;
    double ox, oy, dx, dy; /* start, and the vector to the end */
} ray;

/* A point of the ray: its fraction of the ray, and its height above the line there. */
typedef struct ray_sample {
    double fraction, height;
} ray_sample;

static ray_sample sample_over_vertex(const ray *r, int vertex) {
    double fraction = (td_terrain_x(r->terrain, vertex) - r->ox) / r->dx;
    return (ray_sample){fraction, r->oy + fraction * r->dy - r->terrain->points[vertex].y};
}

/* The sample at a fraction of the ray, its start or end; false where the line has no height
 * there. */
static bool sample_at(const ray *r, double fraction, ray_sample *out) {
    thud_terrain_sample sample;
    if (thud_terrain_sample_at(r->terrain, r->ox + fraction * r->dx, &sample) != THUD_OK) {
        return false;
    }
    *out = (ray_sample){fraction, r->oy + fraction * r->dy - sample.height};
    return true;
}

/* Whether the ray crosses the line from above between two samples, and at which fraction. */
static bool crosses_down(ray_sample a, ray_sample b, double *fraction) {
    if (!(a.height >= 0.0 && b.height <= 0.0 && a.height > b.height)) {
        return false;
    }
    double part = a.height / (a.height - b.height);
    *fraction = td_clamp(a.fraction + part * (b.fraction - a.fraction), 0.0, 1.0);
    return true;
}

/* Walks the segments `first` to `last` in the direction of the ray. False if the ray does not cross
 * the line, or starts below it. */
static bool walk_segments(const ray *r, int first, int last, double *fraction, int *segment) {
    bool rightward = r->dx > 0.0;
    int step = rightward ? 1 : -1, i = rightward ? first : last, end = rightward ? last : first;
    ray_sample a, b;
    if (sample_at(r, 0.0, &a)) {
        if (a.height < 0.0) {
            return false;
        }
        i = td_terrain_segment_at(r->terrain, r->ox);
    } else {
        a = sample_over_vertex(r, rightward ? 0 : r->terrain->count - 1);
    }
    for (; (end - i) * step >= 0; i += step) {
        int vertex = rightward ? i + 1 : i;
        double reach = (td_terrain_x(r->terrain, vertex) - (r->ox + r->dx)) * step;
        if (r->dx == 0.0 || reach >= 0.0) {
            *segment = i;
            return sample_at(r, 1.0, &b) && crosses_down(a, b, fraction);
        }
        b = sample_over_vertex(r, vertex);
        if (crosses_down(a, b, fraction)) {
            *segment = i;
            return true;
        }
        a = b;
    }
    return false;
}

bool thud_terrain_cast_ray(const thud_terrain *terrain, thud_segment way, double *out_fraction,
                           double *out_nx, double *out_ny) {
    if (td_terrain_readable(terrain) != THUD_OK || !td_finite(way.x + way.y + way.dx + way.dy)) {
        return false;
    }
    ray r = {terrain, way.x, way.y, way.dx, way.dy};
    double found = 0.0;
    int first, last, segment = 0;
    double end = way.x + way.dx;
    thud_terrain_segments(terrain, way.dx < 0.0 ? end : way.x, way.dx < 0.0 ? way.x : end, &first,
                          &last);
    if (first > last) {
        return false;
    }
    if (terrain->kind == THUD_TERRAIN_FLAT) {
        double from = way.y - terrain->slope * way.x, fall = terrain->slope * way.dx - way.dy;
        if (!crosses_down((ray_sample){0.0, from}, (ray_sample){1.0, from - fall}, &found)) {
            return false;
        }
    } else if (!walk_segments(&r, first, last, &found, &segment)) {
        return false;
    }
    td_segment s = td_terrain_segment(terrain, segment, 0.0, 1.0);
    if (out_fraction) {
        *out_fraction = found;
    }
    if (out_nx) {
        *out_nx = -s.ty;
    }
    if (out_ny) {
        *out_ny = s.tx;
    }
    return true;
}
