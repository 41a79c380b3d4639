/* mover_meet.c: the casts of a mover: which hits stop it and how far it gets, resolving overlap,
 * one-way platforms, and which ground it can stand on. See mover.h. */
#include "api/mover.h"

#include "geometry/shape_instance.h"
#include "api/query.h"

enum {
    /* Maximum number of hits of a cast that are examined, nearest first. If the first 16 do not
     * stop the mover, shapes behind them do not either. Chosen; not tuned. */
    CAST_HITS_MAX = 16,
    /* Iterations that resolve overlap, one shape each. A mover in a corner needs two; what is left
     * after eight is reported as thud_mover_report.depth. Chosen; not tuned. */
    SEPARATIONS_MAX = 8
};

td_way td_mover_normal(const thud_mover_hit *hit) {
    td_way n = {(double)hit->normal.x, (double)hit->normal.y};
    return td_scaled(n, 1.0 / td_size(n));
}

void td_mover_note(td_move *m, const thud_mover_hit *hit) {
    thud_mover_report *report = &m->report;
    if (report->hit_count < THUD_MOVER_HITS) {
        report->hits[report->hit_count++] = *hit;
    }
}

/* Casts the mover's shape along `way`: at most CAST_HITS_MAX hits, nearest first. Returns their
 * number. */
static int cast_mover(td_move *m, td_way way, thud_ray_hit *found) {
    int count = 0;
    thud_geometry shape = m->mover.shape;
    thud_pos center = {shape.x, shape.y};
    shape.x = shape.y = 0.0;
    if (m->result == THUD_OK) {
        m->result =
            thud_world_cast_shape_all(m->world,
                                      &(thud_shape_cast){center, shape, way.x, way.y, &m->solid},
                                      found, CAST_HITS_MAX, &count);
    }
    return td_min_int(count, CAST_HITS_MAX);
}

/* Whether a hit stops the mover; if so, sets *hit. False for the mover's own body, and if the
 * callback `pass` lets the mover through. */
static bool stops(td_move *m, const thud_ray_hit *found, thud_mover_hit *hit) {
    thud_shape_state shape;
    if (!thud_shape_is_valid(m->world, found->shape)) { /* destroyed by `pass` */
        return false;
    }
    thud_shape_get_state(m->world, found->shape, &shape);
    *hit = (thud_mover_hit){.shape = found->shape,
                            .body = shape.body,
                            .point = found->point,
                            .normal = found->normal,
                            .depth = found->depth,
                            .category = shape.filter.category};
    bool own = shape.body.index1 == m->mover.body.index1 && m->mover.body.index1 != 0;
    return !own && !(m->mover.pass && m->mover.pass(&m->mover, hit, m->velocity, m->mover.context));
}

bool td_mover_meets(td_move *m, td_way way, thud_mover_hit *hit, double *fraction) {
    thud_ray_hit found[CAST_HITS_MAX];
    int count = cast_mover(m, way, found);
    for (int i = 0; i < count; i++) {
        /* A surface that the mover moves away from or along does not stop it. */
        td_way normal = {(double)found[i].normal.x, (double)found[i].normal.y};
        if (td_dot(way, normal) < 0.0 && stops(m, &found[i], hit)) {
            *fraction = found[i].fraction;
            return true;
        }
    }
    return false;
}

/* Adds a sensor to the report, once, unless it belongs to the mover's own body. */
static void report_sensor(td_move *m, thud_shape_id sensor) {
    thud_mover_report *report = &m->report;
    thud_shape_state shape;
    int i = 0;
    while (i < report->sensor_count && report->sensors[i].index1 != sensor.index1) {
        i++;
    }
    if (i == report->sensor_count && i < THUD_MOVER_SENSORS &&
        thud_shape_get_state(m->world, sensor, &shape) == THUD_OK &&
        !(shape.body.index1 == m->mover.body.index1 && m->mover.body.index1 != 0)) {
        report->sensors[report->sensor_count++] = sensor;
    }
}

void td_mover_sense(td_move *m, td_way way) {
    thud_ray_hit found[THUD_MOVER_SENSORS];
    int count = 0;
    thud_geometry shape = m->mover.shape;
    thud_pos center = {shape.x, shape.y};
    shape.x = shape.y = 0.0;
    if (m->mover.filter.sensors && m->result == THUD_OK) {
        thud_shape_cast cast = {center, shape, way.x, way.y, &m->mover.filter};
        m->result = td_query_cast_sensors(m->world, &cast, found, THUD_MOVER_SENSORS, &count);
    }
    for (int i = 0; i < td_min_int(count, THUD_MOVER_SENSORS); i++) {
        report_sensor(m, found[i].shape);
    }
}

bool td_mover_go(td_move *m, td_way way, thud_mover_hit *hit, td_way *left) {
    double length = td_size(way), fraction = 1.0;
    if (!(length > 0.0)) {
        return false;
    }
    /* The cast goes one skin further than the way, so that the mover also keeps its skin before a
     * surface that lies just behind the end of the way. With cosine = -way . n / |way|, n the hit's
     * normal, it stops at the distance skin / cosine before the hit, where its gap along n is the
     * skin. */
    double reach = 1.0 + m->mover.skin / length;
    bool met = td_mover_meets(m, td_scaled(way, reach), hit, &fraction);
    double going = 1.0;
    if (met) {
        double cosine = -td_dot(way, td_mover_normal(hit)) / length;
        going = fraction * reach - m->mover.skin / (length * cosine);
        met = going < 1.0;
        going = td_clamp(going, 0.0, 1.0);
    }
    td_mover_sense(m, td_scaled(way, going));
    if (m->result == THUD_OK) {
        m->mover.shape.x += way.x * going;
        m->mover.shape.y += way.y * going;
    }
    *left = td_scaled(way, 1.0 - going);
    return met;
}

/* The deepest overlap of the mover with a static or kinematic shape. False without one. */
static bool deepest_overlap(td_move *m, thud_mover_hit *hit) {
    thud_ray_hit found[CAST_HITS_MAX];
    int count = cast_mover(m, (td_way){0.0, 0.0}, found);
    hit->depth = 0.0;
    for (int i = 0; i < count; i++) {
        thud_mover_hit here;
        thud_body_state body;
        if (found[i].depth > hit->depth && stops(m, &found[i], &here) &&
            thud_body_get_state(m->world, here.body, &body) == THUD_OK &&
            body.kind != THUD_BODY_DYNAMIC) {
            *hit = here;
        }
    }
    return hit->depth > 0.0;
}

void td_mover_separate(td_move *m) {
    thud_mover_hit hit;
    for (int i = 0; deepest_overlap(m, &hit); i++) {
        if (i == SEPARATIONS_MAX) {
            m->report.depth = hit.depth;
            break;
        }
        td_way out = td_scaled(td_mover_normal(&hit), hit.depth + m->mover.skin);
        m->mover.shape.x += out.x;
        m->mover.shape.y += out.y;
        td_mover_note(m, &hit);
    }
}

/* Deepest overlap with a one-way platform, in skins, at which the platform still carries the mover:
 * it has risen under the mover's feet. Deeper overlap means that the mover is on its way through.
 * Chosen; not tuned. */
#define UNDERFOOT_SKINS 8.0
/* Smallest component along `up` of the normal of a platform's upper side. Chosen: cos(45.6
 * degrees). */
#define UPPER_SIDE_RISE 0.7f

bool thud_mover_passes_one_way(const thud_mover *mover, const thud_mover_hit *hit,
                               thud_vec2 velocity, void *context) {
    const thud_one_way *one_way = context;
    thud_vec2 up = mover->up;
    return (hit->category & one_way->categories) &&
           (one_way->drop || hit->depth > UNDERFOOT_SKINS * mover->skin ||
            hit->normal.x * up.x + hit->normal.y * up.y < UPPER_SIDE_RISE ||
            velocity.x * up.x + velocity.y * up.y > 0.0f);
}

/* ---- ground ---- */

double td_mover_bottom(const td_move *m) {
    const thud_geometry *s = &m->mover.shape;
    td_way up = td_up(m);
    double half = td_half_along(s, up.x, up.y);
    return td_dot((td_way){s->x, s->y}, up) - half;
}

bool td_mover_stands_on(td_move *m, const thud_mover_hit *hit, double bottom) {
    td_way up = td_up(m), normal = td_mover_normal(hit);
    double rise = td_dot(normal, up);
    if (rise >= m->walkable) {
        return true;
    }
    td_way point = {hit->point.x, hit->point.y};
    if (rise < TD_MIN_RISE || td_dot(point, up) - bottom > m->mover.step_height + m->mover.skin) {
        return false;
    }
    /* A ray straight down onto the surface, one skin inward from the corner, finds its normal. */
    double skin = m->mover.skin;
    td_way ahead = td_plus(td_scaled(up, rise), normal, -1.0);
    double size = td_size(ahead);
    td_way from = td_plus(td_plus(point, up, skin), ahead, size > 0.0 ? skin / size : 0.0);
    bool found;
    thud_ray_hit below;
    return thud_world_cast_ray(m->world,
                               &(thud_ray){(thud_pos){from.x, from.y}, -2.0 * skin * up.x,
                                           -2.0 * skin * up.y, &m->solid},
                               &found, &below) == THUD_OK &&
           found && below.shape.index1 == hit->shape.index1 &&
           (double)below.normal.x * up.x + (double)below.normal.y * up.y >= m->walkable;
}
