/* mover_walk.c: how a mover goes on where it meets something: along the ground, up a step, down to
 * the ground again; and in the air along whatever it touches. */
#include "api/mover.h"

#include "base/base.h"

enum { TURNS = 4 };

/* A way along a plane may point into it by so much of its length. */
#define ROUNDING 1e-9

static td_way across(const td_move *m, td_way way) {
    td_way up = td_up(m);
    return td_plus(way, up, -td_dot(way, up));
}

static void stand_on(td_move *m, const thud_mover_hit *hit) {
    m->mover.on_ground = true;
    m->mover.ground_normal = hit->normal;
    m->mover.ground_shape = hit->shape;
    m->mover.ground_body = hit->body;
    m->mover.ground_point = hit->point;
}

/* ---- on the ground ---- */

/* The way across, laid along the ground with its length kept. */
static td_way along_ground(const td_move *m, td_way way, double length) {
    td_way normal = {(double)m->mover.ground_normal.x, (double)m->mover.ground_normal.y};
    td_way tangent = {normal.y, -normal.x};
    double side = td_dot(tangent, way) < 0.0 ? -1.0 : 1.0;
    return td_scaled(tangent, side * length / td_size(tangent));
}

/* Up, ahead and down again, if there is ground to stand on no higher than a step. */
static bool climb(td_move *m, td_way ahead) {
    double length = td_size(ahead), least = 2.0 * m->mover.skin;
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
    td_mover_go(m, td_scaled(ahead, length < least ? least / length : 1.0), &hit, &left);
    bool stands =
        td_mover_go(m, td_scaled(up, -raised), &hit, &left) && td_mover_stands_on(m, &hit, bottom);
    td_way gone = td_plus((td_way){m->mover.shape.x, m->mover.shape.y}, from, -1.0);
    if (stands && td_dot(gone, ahead) > 0.0) {
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
    for (int i = 0; i < TURNS && td_size(left) > 0.0; i++) {
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
    double down = fraction * length - m->mover.skin / td_max_double(rise, TD_LEAST_RISE);
    td_mover_go(m, td_scaled(up, -down), &other, &left);
    stand_on(m, &hit);
    return true;
}

/* ---- in the air ---- */

/* Without its part into the plane. */
static td_way clipped(td_way way, td_way normal) {
    double into = td_dot(way, normal);
    return into < 0.0 ? td_plus(way, normal, -into) : way;
}

/* Slopes too steep to stand on are slid down, but are upright walls to what would go up them. */
static td_way plane_of(const td_move *m, const thud_mover_hit *hit, td_way way) {
    td_way up = td_up(m), normal = td_mover_normal(hit), wall = across(m, normal);
    double rise = td_dot(normal, up), size = td_size(wall);
    double before = td_dot(way, up), after = td_dot(clipped(way, normal), up);
    bool climbs = rise > 0.0 && rise < m->walkable && after > before && after > 0.0;
    return climbs && size > 0.0 ? td_scaled(wall, 1.0 / size) : normal;
}

void td_mover_fly(td_move *m, td_way way) {
    td_way planes[TURNS];
    for (int i = 0; i < TURNS; i++) {
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
            if (td_dot(way, planes[k]) < -ROUNDING * td_size(way)) { /* in a corner */
                way = m->left = (td_way){0.0, 0.0};
            }
        }
    }
}
