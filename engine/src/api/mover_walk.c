/* mover_walk.c: the slide part of collide and slide (mover.h): where a mover goes after a hit. On
 * the ground it follows the ground's tangent and climbs steps; in the air it slides along the
 * planes that it hits. */
#include "api/mover.h"

#include "base/base.h"

/* Hits after which a walk or a flight ends. thud_mover.h promises four. Chosen: going around a
 * convex corner takes two hits; with a maximum of one a mover would stop at each change of slope.
 */
enum { HITS_MAX = 4 };

/* Rounding may make a displacement along a plane point into the plane by up to this share of the
 * displacement's length, which does not count as a corner. Chosen: far above double precision's
 * 1e-16, and far below any slope. */
#define CORNER_ROUNDING 1e-9

/* The part of a vector at a right angle to `up`. */
static td_way across(const td_move *m, td_way way) {
    td_way up = td_up(m);
    return td_plus(way, up, -td_dot(way, up));
}

/* Stores the hit as the ground that the mover stands on. */
static void stand_on(td_move *m, const thud_mover_hit *hit) {
    m->mover.on_ground = true;
    m->mover.ground_normal = hit->normal;
    m->mover.ground_shape = hit->shape;
    m->mover.ground_body = hit->body;
    m->mover.ground_point = hit->point;
}

/* ---- on the ground ---- */

/* A displacement of this length along the ground's tangent, in the direction of `way`. */
static td_way along_ground(const td_move *m, td_way way, double length) {
    td_way normal = {(double)m->mover.ground_normal.x, (double)m->mover.ground_normal.y};
    td_way tangent = {normal.y, -normal.x};
    double side = td_dot(tangent, way) < 0.0 ? -1.0 : 1.0;
    return td_scaled(tangent, side * length / td_size(tangent));
}

/* Climbs a step by three casts: up by step_height, ahead by `ahead` (at least two skins, so that it
 * gets past the edge), and down again. False, and the mover as before, unless it then stands on
 * ground and has come forward. */
static bool climb(td_move *m, td_way ahead) {
    double length = td_size(ahead), min = 2.0 * m->mover.skin;
    if (!(length > 0.0)) {
        return false;
    }
    td_move before = *m;
    td_way up = td_up(m), left;
    thud_mover_hit hit = {0};
    double bottom = td_mover_bottom(m), height = m->mover.step_height + 2.0 * m->mover.skin;
    td_way from = {m->mover.shape.x, m->mover.shape.y};
    td_mover_go(m, td_scaled(up, height), &hit, &left);
    double raised = td_mover_bottom(m) - bottom;
    td_mover_go(m, td_scaled(ahead, length < min ? min / length : 1.0), &hit, &left);
    bool stands =
        td_mover_go(m, td_scaled(up, -raised), &hit, &left) && td_mover_stands_on(m, &hit, bottom);
    td_way moved = td_plus((td_way){m->mover.shape.x, m->mover.shape.y}, from, -1.0);
    if (stands && td_dot(moved, ahead) > 0.0) {
        stand_on(m, &hit);
        return true;
    }
    thud_result result = m->result;
    *m = before;
    m->result = result;
    return false;
}

void td_mover_walk(td_move *m, td_way way) {
    td_way left = along_ground(m, way, td_size(way));
    for (int i = 0; i < HITS_MAX && td_size(left) > 0.0; i++) {
        thud_mover_hit hit;
        if (!td_mover_go(m, left, &hit, &left)) {
            return;
        }
        td_mover_note(m, &hit);
        if (td_mover_stands_on(m, &hit, td_mover_bottom(m))) {
            stand_on(m, &hit);
            left = along_ground(m, way, td_size(left));
        } else {
            m->stopped = !climb(m, across(m, left));
            return;
        }
    }
}

bool td_mover_settle(td_move *m) {
    td_way up = td_up(m), left;
    thud_mover_hit hit, other;
    double fraction = 0.0, length = m->mover.snap_distance + m->mover.skin;
    if (!td_mover_meets(m, td_scaled(up, -length), &hit, &fraction) ||
        !td_mover_stands_on(m, &hit, td_mover_bottom(m))) {
        return false;
    }
    double rise = td_dot(td_mover_normal(&hit), up);
    double down = fraction * length - m->mover.skin / td_max_double(rise, TD_MIN_RISE);
    td_mover_go(m, td_scaled(up, -down), &other, &left);
    stand_on(m, &hit);
    return true;
}

/* ---- in the air ---- */

/* `way` without its part into the plane of this normal. */
static td_way clipped(td_way way, td_way normal) {
    double into = td_dot(way, normal);
    return into < 0.0 ? td_plus(way, normal, -into) : way;
}

/* The normal of the plane along which the mover slides after a hit: that of the hit; where sliding
 * would take the mover up a slope that is too steep to stand on, that of an upright wall. */
static td_way plane_of(const td_move *m, const thud_mover_hit *hit, td_way way) {
    td_way up = td_up(m), normal = td_mover_normal(hit), wall = across(m, normal);
    double rise = td_dot(normal, up), size = td_size(wall);
    double before = td_dot(way, up), after = td_dot(clipped(way, normal), up);
    bool climbs = rise > 0.0 && rise < m->walkable && after > before && after > 0.0;
    return climbs && size > 0.0 ? td_scaled(wall, 1.0 / size) : normal;
}

void td_mover_fly(td_move *m, td_way way) {
    td_way planes[HITS_MAX];
    for (int i = 0; i < HITS_MAX; i++) {
        thud_mover_hit hit;
        if (!td_mover_go(m, way, &hit, &way)) {
            return;
        }
        td_mover_note(m, &hit);
        if (td_dot(way, td_up(m)) <= 0.0 && td_mover_stands_on(m, &hit, td_mover_bottom(m))) {
            stand_on(m, &hit);
            td_mover_walk(m, across(m, way));
            return;
        }
        planes[i] = plane_of(m, &hit, way);
        way = clipped(way, planes[i]);
        m->left = clipped(m->left, planes[i]);
        for (int k = 0; k < i; k++) {
            if (td_dot(way, planes[k]) <
                -CORNER_ROUNDING * td_size(way)) { /* two planes form a corner: stop */
                way = m->left = (td_way){0.0, 0.0};
            }
        }
    }
}
