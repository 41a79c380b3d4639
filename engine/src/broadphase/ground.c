/* ground.c: the table td_ground (td_ground_ops in shape.h): what the stages of a step need to know
 * of terrain shapes, here called lines. A world gets the table with its first line, so that a
 * program without terrain does not link it. Shapes are given relative to the line's origin, in the
 * caller's unit, unless said otherwise. */
#include "broadphase/pairs.h"
#include "constraint/constraint.h"
#include "constraint/lanes.h"
#include "contact/contact.h"
#include "state/shape.h"

/* Whether the shape overlaps the solid below the line. */
static bool overlap(const thud_world *w, int line, const thud_geometry *shape) {
    thud_terrain terrain = td_terrain_view(w, line);
    return thud_terrain_overlap(&terrain, shape);
}

/* The time, in [0, 1] of the motion, at which the shape meets the line: see
 * thud_terrain_time_of_impact. */
static void time_of_impact(const thud_world *w, int line, const thud_geometry *shape,
                           thud_motion motion, bool *hit, double *time) {
    thud_terrain terrain = td_terrain_view(w, line);
    thud_terrain_time_of_impact(&terrain, shape, motion, 0.0, hit, time);
}

/* Contact geometry for a shape on the ground: both closest points are the point of the line above
 * or below the shape's centre, and the normal is that of the line there. */
static thud_closest closest_below(const thud_world *w, int line, const thud_geometry *shape) {
    thud_terrain terrain = td_terrain_view(w, line);
    thud_terrain_sample ground = {.height = shape->y, .ny = 1.0};
    thud_terrain_sample_at(&terrain, shape->x, &ground);
    return (thud_closest){.nx = ground.nx,
                          .ny = ground.ny,
                          .ax = shape->x,
                          .ay = ground.height,
                          .bx = shape->x,
                          .by = ground.height};
}

/* Whether the bounds of a sweep reach down to a segment of the line; true for a sweep that has no
 * bounds. */
static bool near_sweep(const thud_world *w, int line, const td_swept *swept) {
    int first, last;
    if (swept->far) {
        return true;
    }
    if (td_terrain_below(w, line, swept->start, &swept->bounds)) {
        return false;
    }
    thud_terrain terrain = td_terrain_view(w, line);
    td_terrain_segments_of(w, line, &terrain, swept->start, &swept->bounds, &first, &last);
    while (first <= last &&
           !td_terrain_reaches(w, line, &terrain, swept->start, &swept->bounds, first)) {
        first++;
    }
    return first <= last;
}

/* Moves a swept shape against the line. A shape that overlaps the line at the start (hit->inside)
 * is replaced by its core, which does not rotate. */
static void sweep(const thud_world *w, int line, const td_swept *swept, td_swept_hit *hit) {
    if (!near_sweep(w, line, swept)) {
        return;
    }
    thud_terrain terrain = td_terrain_view(w, line);
    const td_position *origin = &td_shape_proxy_at(w, line)->center;
    double x = (double)(swept->start.x - origin->x) / w->to_fixed;
    double y = (double)(swept->start.y - origin->y) / w->to_fixed;
    thud_geometry placed = swept->placed;
    thud_motion motion = swept->motion;
    placed.x += x, placed.y += y;
    hit->inside = thud_terrain_overlap(&terrain, &placed);
    if (hit->inside) {
        placed = swept->core;
        placed.x += x, placed.y += y;
        motion.turn = 0.0;
    }
    thud_terrain_time_of_impact(&terrain, &placed, motion, 0.0, &hit->hit, &hit->time);
}

/* Whether the fat bounds of a shape of the world reach down to a segment. */
static bool reaches_segment(const thud_world *w, int line, int shape, int segment) {
    thud_terrain terrain = td_terrain_view(w, line);
    const td_shape_proxy *proxy = td_shape_proxy_at(w, shape);
    return td_terrain_reaches(w, line, &terrain, proxy->center, &proxy->fat, segment);
}

/* Visits each segment that the fat bounds of a shape of the world reach down to, until `visit`
 * returns false; returns what it returned last. */
static bool each_segment(thud_world *w, int line, int shape,
                         bool (*visit)(thud_world *w, int shape, int line, int segment)) {
    thud_terrain terrain = td_terrain_view(w, line);
    td_position at = td_shape_proxy_at(w, shape)->center;
    const td_bounds *fat = td_fat_at(w, shape);
    int first, last;
    td_terrain_segments_of(w, line, &terrain, at, fat, &first, &last);
    bool done = true;
    for (int i = first; i <= last && done; i++) {
        done = !td_terrain_reaches(w, line, &terrain, at, fat, i) || visit(w, shape, line, i);
    }
    return done;
}

/* Destroys the contacts of a body's terrain lines, and marks the lines as new, so that all their
 * pairs are searched again. */
static void restart_terrain_pairs(thud_world *w, td_body_index index) {
    for (int i = td_body_at(w, index)->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        if (td_kind_is_line(td_shape_at(w, i)->kind)) {
            td_contacts_destroy(w, index, i, false);
            *td_marks_at(w, i) |= TD_MARK_FRESH;
        }
    }
}

/* Makes the next narrowphase compute a teleported body's manifolds with terrain anew. Their cache
 * stores the body's place modulo 256 length scales (contact/wide_terrain.c), and would not notice a
 * teleport by a multiple of 256 length scales. */
static void renew_terrain_contacts(thud_world *w, td_body_index index) {
    for (int e = td_body_at(w, index)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->state == TD_TOUCHING && td_is_contact(constraint) &&
            td_pair_is_on_line((td_pair_kind)constraint->kind)) {
            td_lane_renew(w, td_edge_constraint(e));
        }
    }
}

/* Destroys the body's contacts with terrain segments that an edit has removed (child TD_NONE). */
static void destroy_contacts_of_removed_segments(thud_world *w, td_body_index index) {
    for (int e = td_body_at(w, index)->first_constraint; e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (td_constraint_at(w, td_edge_constraint(e))->child == TD_NONE) {
            td_contact_destroy(w, td_edge_constraint(e));
        }
        e = next;
    }
}

const td_ground_ops td_ground = {overlap,
                                 time_of_impact,
                                 closest_below,
                                 near_sweep,
                                 sweep,
                                 reaches_segment,
                                 each_segment,
                                 td_pairs_add_ground,
                                 restart_terrain_pairs,
                                 renew_terrain_contacts,
                                 destroy_contacts_of_removed_segments};
