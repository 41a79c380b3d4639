/* trajectory.c: see trajectory.h. Pairs are tested in the order of the cost of the tests: circles
 * around both motions, boxes around both motions, separation along the present normal; only pairs
 * that pass all need a time of impact. */
#include "detection/trajectory.h"

#include "state/body.h"
#include "base/rotation.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "terrain/terrain.h"

const thud_detection *td_detection_of(const thud_world *w, td_body_index body_a,
                                      td_body_index body_b) {
    const td_body *a = td_body_at(w, body_a), *b = td_body_at(w, body_b);
    bool moves_a = a->kind == THUD_BODY_DYNAMIC, moves_b = b->kind == THUD_BODY_DYNAMIC;
    return !moves_b || (moves_a && a->detection->rank > b->detection->rank) ? a->detection
                                                                            : b->detection;
}

void td_trajectory_begin(thud_world *w, td_awake_slot slot, bool moved) {
    td_body_index index = td_body_of(w, slot);
    const td_pose *pose = td_pose_at(w, index);
    const float *delta = td_row(&w->delta, slot);
    td_trajectory f = *td_trajectory_at(w, slot);
    /* The slot had another body, which was quarantined; this body was moved into it. */
    if (!td_same_body(f.body, index)) {
        f = (td_trajectory){.body = index};
    }
    td_position place = pose->center;
    uint32_t angle = pose->angle;
    if (moved) {
        place.x = td_wrap_sub64(place.x, td_length_from(w, delta[0]));
        place.y = td_wrap_sub64(place.y, td_length_from(w, delta[1]));
        angle -= td_angle_between((double)delta[2]);
    }
    *td_trajectory_at(w, slot) =
        (td_trajectory){.place = place,
                        .angle = angle,
                        .body = index,
                        .extras = TD_NONE,
                        .escaped = TD_NONE,
                        .motion = {(double)delta[0] - 0.5 * f.acceleration[0],
                                   (double)delta[1] - 0.5 * f.acceleration[1], (double)delta[2]},
                        .before = {f.before[0], f.before[1], f.before[2]},
                        .acceleration = {f.acceleration[0], f.acceleration[1]},
                        .free = f.free,
                        .contact_count = f.contact_count};
}

td_trajectory td_trajectory_of(const thud_world *w, td_body_index body) {
    td_awake_slot slot = td_body_at(w, body)->awake;
    if (slot.at > 0) {
        return *td_trajectory_at(w, slot);
    }
    const td_pose *pose = td_pose_at(w, body);
    return (td_trajectory){.place = pose->center,
                           .angle = pose->angle,
                           .body = body,
                           .extras = TD_NONE};
}

/* The angle at `time`; 2^32 is a full turn. */
static uint32_t angle_at(const td_trajectory *f, double time) {
    double turn = f->motion[2] * (time - f->since);
    return f->angle + (uint32_t)(uint64_t)td_round64(turn * (1.0 / TD_RADIANS_A_QUANTUM));
}

/* The displacement along x or y (axis 0, 1) from `since` to `time`. */
static double path_along(const td_trajectory *f, int axis, double time) {
    double part = time - f->since;
    return (f->motion[axis] + 0.5 * f->acceleration[axis] * part) * part;
}

td_pose td_start_pose(const thud_world *w, td_awake_slot slot) {
    td_pose pose = *td_pose_at(w, td_body_of(w, slot));
    const float *delta = td_row(&w->delta, slot);
    pose.center.x = td_wrap_sub64(pose.center.x, td_length_from(w, delta[0]));
    pose.center.y = td_wrap_sub64(pose.center.y, td_length_from(w, delta[1]));
    pose.angle -= td_angle_between((double)delta[2]);
    return pose;
}

void td_leg_note(thud_world *w, const td_trajectory *trajectory, double end) {
    td_array *legs = &w->scratch.legs;
    if (w->scratch.sensed_room > 0 && end > trajectory->since &&
        td_array_reserve(&w->memory, legs, legs->count + 1)) {
        td_leg *leg = td_append(legs, sizeof *leg);
        leg->trajectory = *trajectory;
        leg->end = end;
    }
}

bool td_held_reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.held_at, w->body_of.count);
}

void td_held_count(thud_world *w, td_awake_slot slot, double time) {
    td_array *all = &w->scratch.held_at;
    if (w->stats.held_bodies == 0) {
        all->count = w->body_of.count;
        for (int i = 0; i < all->count; i++) {
            *TD_AT(double, all, i) = 1.0;
        }
    }
    /* The share of the step's motion that the body has kept after all its stops so far; 1: none. */
    double *at = TD_AT(double, all, slot.at);
    w->stats.held_bodies += *at == 1.0;
    w->stats.held_seconds += (1.0 - time) * *at * w->def.time_step;
    *at *= time;
}

void td_trajectory_advance(thud_world *w, td_trajectory *f, double time) {
    td_leg_note(w, f, time);
    f->place.x = td_wrap_add64(f->place.x, td_round64(path_along(f, 0, time) * w->to_fixed));
    f->place.y = td_wrap_add64(f->place.y, td_round64(path_along(f, 1, time) * w->to_fixed));
    f->angle = angle_at(f, time);
    f->motion[0] += f->acceleration[0] * (time - f->since);
    f->motion[1] += f->acceleration[1] * (time - f->since);
    f->since = time;
}

void td_trajectory_displacement(const thud_world *w, const td_trajectory *f, double time,
                                double displacement[3]) {
    td_awake_slot slot = td_body_at(w, f->body)->awake;
    const td_pose *pose = td_pose_at(w, f->body); /* the end of the solver's motion */
    const float *delta = td_row(&w->delta, slot);
    displacement[0] = (double)delta[0] +
                      (double)td_wrap_sub64(f->place.x, pose->center.x) / w->to_fixed +
                      path_along(f, 0, time);
    displacement[1] = (double)delta[1] +
                      (double)td_wrap_sub64(f->place.y, pose->center.y) / w->to_fixed +
                      path_along(f, 1, time);
    displacement[2] = (double)delta[2] + f->motion[2] * (time - f->since) +
                      (double)(int32_t)(f->angle - pose->angle) * TD_RADIANS_A_QUANTUM;
}

void td_trajectory_reduce_acceleration(const thud_world *w, td_trajectory *f, double x, double y) {
    float *velocity = td_row(&w->velocity, td_body_at(w, f->body)->awake);
    double gain_per_acceleration = (1.0 - f->since) / w->def.time_step;
    velocity[0] = (float)((double)velocity[0] - x * gain_per_acceleration);
    velocity[1] = (float)((double)velocity[1] - y * gain_per_acceleration);
    f->acceleration[0] -= x;
    f->acceleration[1] -= y;
}

thud_geometry td_trajectory_shape(const thud_world *w, const td_trajectory *f, int index,
                                  double time, td_position origin) {
    const td_shape *shape = td_shape_at(w, index);
    float c, s;
    td_angle_turn(angle_at(f, time), &c, &s);
    thud_geometry p = {.kind = (thud_shape_kind)shape->kind,
                       .x = (double)td_wrap_sub64(f->place.x, origin.x) / w->to_fixed +
                            path_along(f, 0, time) + (double)(c * shape->arm_x - s * shape->arm_y),
                       .y = (double)td_wrap_sub64(f->place.y, origin.y) / w->to_fixed +
                            path_along(f, 1, time) + (double)(s * shape->arm_x + c * shape->arm_y),
                       .c = 1.0,
                       .hx = (double)shape->half_x,
                       .hy = (double)shape->half_y};
    if (td_kind_turns(shape->kind)) {
        p.c = (double)(c * shape->angle_c - s * shape->angle_s);
        p.s = (double)(s * shape->angle_c + c * shape->angle_s);
    }
    return p;
}

td_toi_candidate *td_extra_candidate_at(const thud_world *w, int number) {
    return TD_AT(td_toi_candidate, &w->scratch.extra_candidates, number - w->constraints.count);
}

td_toi_candidate td_toi_candidate_at(const thud_world *w, int number) {
    if (number >= w->constraints.count) {
        return *td_extra_candidate_at(w, number);
    }
    const td_contact *c = td_contact_at(w, number);
    return (td_toi_candidate){.shape = {c->shape_a, c->shape_b},
                              .body = {c->body[0], c->body[1]},
                              .vetoed = c->vetoed & TD_VETOED};
}

/* ---- tests of rising cost ---- */

/* Whether circles of radii ra and rb, b at (x, y) from a, stay apart by more than the target while
 * b moves by (mx, my) relative to a. */
static bool circles_miss(const td_approach *p, double x, double y, double mx, double my, double ra,
                         double rb) {
    double reach = ra + rb + p->target + __builtin_sqrt(mx * mx + my * my);
    return x * x + y * y > reach * reach;
}

/* Whether two intervals stay apart while their centres, now at a distance x, move by `motion`
 * relative to each other; `reach` is the sum of both half lengths. */
static bool intervals_miss(double x, double motion, double reach) {
    double end = x + motion;
    return (x > reach && end > reach) || (x < -reach && end < -reach);
}

/* Half the width and height of a box that contains the shape, at any angle if it `turns`. */
static void half_extents(const thud_geometry *p, bool turns, double *x, double *y) {
    if (td_kind_is_round(p->kind)) {
        *x = *y = p->hx;
    } else if (turns) {
        *x = *y = __builtin_sqrt(p->hx * p->hx + p->hy * p->hy);
    } else {
        *x = td_projected_extent(p, 1.0, 0.0);
        *y = td_projected_extent(p, 0.0, 1.0);
    }
}

/* Whether circles or boxes around both motions show that the pair does not meet. */
static bool motions_miss(thud_world *w, const td_approach *p) {
    double x = p->b.x - p->a.x, y = p->b.y - p->a.y;
    double mx = p->motion_b.dx - p->motion_a.dx, my = p->motion_b.dy - p->motion_a.dy;
    double ax, ay, bx, by;
    w->stats.motion_pairs++;
    if (circles_miss(p, x, y, mx, my, td_reach(&p->a), td_reach(&p->b))) {
        return true;
    }
    w->stats.motion_circles++;
    half_extents(&p->a, p->motion_a.turn != 0.0, &ax, &ay);
    half_extents(&p->b, p->motion_b.turn != 0.0, &bx, &by);
    if (intervals_miss(x, mx, ax + bx + p->target) || intervals_miss(y, my, ay + by + p->target)) {
        return true;
    }
    w->stats.motion_boxes++;
    return false;
}

/* ---- approaches ---- */

/* Whether the motion stays above the highest point of the terrain. */
static bool stays_above_line(const thud_world *w, int terrain_shape, const td_approach *p) {
    const td_terrain_record *record =
        td_terrain_record_at(w, td_shape_at(w, terrain_shape)->terrain);
    double end = p->a.y + p->motion_a.dy;
    return (end < p->a.y ? end : p->a.y) - td_reach(&p->a) - p->target > record->highest;
}

/* The motion of a shape of the body between two placements, `duration` (share of the step) apart.
 */
static thud_motion motion_between(const td_trajectory *f, const thud_geometry *from,
                                  const thud_geometry *to, double duration) {
    return (thud_motion){to->x - from->x, to->y - from->y,
                         td_kind_turns(from->kind) ? f->motion[2] * duration : 0.0};
}

/* The distance of the arc of a shape that is off its body's centre of mass from its chord: r phi^2
 * / 8, the sagitta, for the arm r (bounded by |x| + |y|) and the turn phi. */
static double arc_error(const thud_world *w, const td_trajectory *f, int index, double duration) {
    const td_shape *shape = td_shape_at(w, index);
    double turn = f->motion[2] * duration;
    double arm = td_abs((double)shape->arm_x) + td_abs((double)shape->arm_y);
    return 0.125 * arm * turn * turn;
}

double td_trajectories_chord_error(const td_trajectory *a, const td_trajectory *b,
                                   double duration) {
    double x = b->acceleration[0] - a->acceleration[0], y = b->acceleration[1] - a->acceleration[1];
    return 0.125 * __builtin_sqrt(x * x + y * y) * duration * duration;
}

void td_toi_candidate_motions(const thud_world *w, const td_toi_candidate *e, double now,
                              double until, td_approach *p) {
    td_trajectory a = td_trajectory_of(w, e->body[0]), b = td_trajectory_of(w, e->body[1]);
    td_position origin = a.place;
    *p = (td_approach){.on_ground = td_kind_is_line(td_shape_at(w, e->shape[0])->kind)};
    if (p->on_ground) {
        origin = td_shape_proxy_at(w, e->shape[0])->center;
        p->ground = td_terrain_view(w, e->shape[0]);
        p->a = td_trajectory_shape(w, &b, e->shape[1], now, origin);
        thud_geometry end = td_trajectory_shape(w, &b, e->shape[1], until, origin);
        p->motion_a = motion_between(&b, &p->a, &end, until - now);
        return;
    }
    p->a = td_trajectory_shape(w, &a, e->shape[0], now, origin);
    p->b = td_trajectory_shape(w, &b, e->shape[1], now, origin);
    thud_geometry end_a = td_trajectory_shape(w, &a, e->shape[0], until, origin);
    thud_geometry end_b = td_trajectory_shape(w, &b, e->shape[1], until, origin);
    p->motion_a = motion_between(&a, &p->a, &end_a, until - now);
    p->motion_b = motion_between(&b, &p->b, &end_b, until - now);
}

bool td_toi_candidate_has_internal_edges(const thud_world *w, const td_toi_candidate *e) {
    return td_shape_at(w, e->shape[0])->internal_edges |
           td_shape_at(w, e->shape[1])->internal_edges;
}

/* Whether the pair stays apart along the present normal (c->nx, c->ny): the distance, less the
 * relative motion along the normal and the arcs of the furthest corners, is above the target. */
static bool normal_separates(const td_approach *p, const thud_closest *c) {
    double x = p->motion_b.dx - p->motion_a.dx, y = p->motion_b.dy - p->motion_a.dy;
    double turn =
        td_abs(p->motion_a.turn) * td_reach(&p->a) + td_abs(p->motion_b.turn) * td_reach(&p->b);
    return c->distance + td_min_double(c->nx * x + c->ny * y, 0.0) - turn > p->target;
}

/* The distance of both shapes, and their closest points. If they overlap and the normal belongs to
 * an internal edge (a ghost), the overlap along an allowed normal is returned. */
static double allowed_distance(thud_world *w, const td_toi_candidate *e, const td_approach *p,
                               thud_closest *closest) {
    td_internal_edge_contact contact;
    thud_closest c;
    td_closest(&p->a, &p->b, &c);
    *closest = c;
    if (c.distance < 0.0 && td_toi_candidate_has_internal_edges(w, e)) {
        td_internal_edge_pair pair = {w, {e->shape[0], e->shape[1]}, {p->a, p->b}};
        if (w->internal_edges->is_ghost(&pair, c.nx, c.ny) &&
            w->internal_edges->contact(&pair, &contact)) {
            double last = contact.separation[contact.count - 1];
            return td_min_double(contact.separation[0], last);
        }
    }
    return c.distance;
}

bool td_toi_candidate_is_far(thud_world *w, const td_toi_candidate *e) {
    if (td_body_at(w, e->body[0])->kind == THUD_BODY_STATIC) { /* its max_extent is not set */
        return false;
    }
    td_trajectory a = td_trajectory_of(w, e->body[0]), b = td_trajectory_of(w, e->body[1]);
    double x = (double)td_wrap_sub64(b.place.x, a.place.x) / w->to_fixed;
    double y = (double)td_wrap_sub64(b.place.y, a.place.y) / w->to_fixed;
    double mx = path_along(&b, 0, 1.0) - path_along(&a, 0, 1.0);
    double my = path_along(&b, 1, 1.0) - path_along(&a, 1, 1.0);
    double reach =
        (double)(td_body_at(w, e->body[0])->max_extent + td_body_at(w, e->body[1])->max_extent) +
        2.0 * (double)(TD_IMPACT_DISTANCE * w->length_scale) +
        td_trajectories_chord_error(&a, &b, 1.0);
    double gap = __builtin_sqrt(x * x + y * y) - reach;
    bool far = gap > 0.0 && gap * gap > mx * mx + my * my;
    w->stats.motion_pairs += far;
    return far;
}

bool td_toi_candidate_approach(thud_world *w, const td_toi_candidate *e, double now, double until,
                               td_approach *p) {
    td_trajectory a = td_trajectory_of(w, e->body[0]), b = td_trajectory_of(w, e->body[1]);
    double target = (double)(TD_IMPACT_DISTANCE * w->length_scale) +
                    arc_error(w, &b, e->shape[1], until - now) +
                    td_trajectories_chord_error(&a, &b, until - now);
    td_toi_candidate_motions(w, e, now, until, p);
    p->target = target;
    if (p->on_ground) {
        w->stats.motion_pairs++;
        if (stays_above_line(w, e->shape[0], p)) {
            return false;
        }
        w->stats.motion_circles++;
        w->stats.motion_boxes++;
        /* Contacts are searched only within twice the target. If there is none, p->distance is set
         * to a greater value: callers only use it to see that it is above the target. */
        thud_contacts near;
        thud_terrain_contacts(&p->ground, &p->a, 2.0 * target, &near);
        p->path_error = target - (double)(TD_IMPACT_DISTANCE * w->length_scale);
        p->distance = near.count ? near.point[0].distance : 4.0 * target;
        p->target = 0.5 * p->distance < target ? 0.5 * p->distance : target;
        return true;
    }
    p->target += arc_error(w, &a, e->shape[0], until - now);
    p->path_error = p->target - (double)(TD_IMPACT_DISTANCE * w->length_scale);
    if (motions_miss(w, p)) {
        return false;
    }
    thud_closest closest;
    p->distance = allowed_distance(w, e, p, &closest);
    if (normal_separates(p, &closest)) {
        return false;
    }
    /* Shapes that are nearer than the target meet at half their distance. */
    p->target = 0.5 * p->distance < p->target ? 0.5 * p->distance : p->target;
    return true;
}

/* Replaces the contact points of a ghost by those along an allowed normal, or by none. */
static void move_ghost_contacts(thud_world *w, const td_toi_candidate *e, const thud_geometry *a,
                                const thud_geometry *b, thud_contacts *contacts) {
    td_internal_edge_pair pair = {w, {e->shape[0], e->shape[1]}, {*a, *b}};
    td_internal_edge_contact open = {.count = 0};
    if (!w->internal_edges->is_ghost(&pair, contacts->point[0].nx, contacts->point[0].ny)) {
        return;
    }
    contacts->count = w->internal_edges->contact(&pair, &open) ? open.count : 0;
    for (int k = 0; k < contacts->count; k++) {
        double x = 0.5 * open.separation[k] * open.nx, y = 0.5 * open.separation[k] * open.ny;
        contacts->point[k] =
            (thud_closest){open.separation[k], open.nx,       open.ny,      open.x[k] - x,
                           open.y[k] - y,      open.x[k] + x, open.y[k] + y};
    }
}

/* Tolerance of normals (sine of an angle) and of places (share of the extent): smaller differences
 * from the ground's count as none. Chosen, above the rounding of single precision (6e-8), and equal
 * to FACE_SINE_MAX of internal_edges.c. */
#define NORMAL_TOLERANCE 1e-5

bool td_is_at_sealed_end(const thud_world *w, int line, const thud_terrain *ground,
                         const thud_geometry *shape, const thud_closest *met, double *x,
                         double *out) {
    unsigned sealed = td_shape_at(w, line)->internal_edges;
    for (int side = 0; side < 2; side++) {
        td_segment s = td_terrain_segment(ground, side ? ground->count - 2 : 0, 0.0, 0.0);
        *x = side ? s.q.x : s.p.x;
        *out = side ? 1.0 : -1.0;
        if ((sealed >> (side ? TD_FACE_RIGHT : TD_FACE_LEFT) & 1) &&
            (met->ax - *x) * *out > -NORMAL_TOLERANCE * td_reach(shape) &&
            (met->nx * s.tx + met->ny * s.ty) * *out > NORMAL_TOLERANCE) {
            return true;
        }
    }
    return false;
}

/* Removes the contact points of a shape at sealed ends of a line, which are ghosts. */
static void drop_sealed_ends(const thud_world *w, int line, const thud_terrain *ground,
                             const thud_geometry *shape, thud_contacts *contacts) {
    int kept_count = 0;
    double x, out;
    for (int k = 0; k < contacts->count; k++) {
        if (!td_is_at_sealed_end(w, line, ground, shape, &contacts->point[k], &x, &out)) {
            contacts->point[kept_count++] = contacts->point[k];
        }
    }
    contacts->count = kept_count;
}

void td_toi_candidate_features(thud_world *w, const td_toi_candidate *e, double time,
                               td_features *out) {
    td_trajectory a = td_trajectory_of(w, e->body[0]), b = td_trajectory_of(w, e->body[1]);
    double margin = (double)(TD_SPECULATIVE * w->length_scale);
    out->contacts.count = 0; /* stays so where shapes are too far apart for the geometry */
    if (td_kind_is_line(td_shape_at(w, e->shape[0])->kind)) {
        out->origin = td_shape_proxy_at(w, e->shape[0])->center;
        thud_terrain ground = td_terrain_view(w, e->shape[0]);
        thud_geometry shape = td_trajectory_shape(w, &b, e->shape[1], time, out->origin);
        thud_terrain_contacts(&ground, &shape, margin, &out->contacts);
        if (td_toi_candidate_has_internal_edges(w, e)) {
            drop_sealed_ends(w, e->shape[0], &ground, &shape, &out->contacts);
        }
        return;
    }
    out->origin = a.place;
    thud_geometry at_a = td_trajectory_shape(w, &a, e->shape[0], time, a.place);
    thud_geometry at_b = td_trajectory_shape(w, &b, e->shape[1], time, a.place);
    thud_geometry_contacts(&at_a, &at_b, margin, &out->contacts);
    if (out->contacts.count && td_toi_candidate_has_internal_edges(w, e)) {
        move_ghost_contacts(w, e, &at_a, &at_b, &out->contacts);
    }
}
