/* predict.c: the free flight of bodies up to the first shape that they meet (thud_world_predict),
 * as casts of their shapes along chords of it. */
#include "casts/flight.h"
#include "casts/walk.h"

#include "base/rotation.h"
#include "base/trig.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"

/* A chord of the flight: the displacement of the centre of mass, and the rotation at its start. */
typedef struct chord {
    td_position from;    /* the centre of mass */
    double dx, dy;       /* length */
    double cosine, sine; /* of the body's angle */
} chord;

/* A body's shape on a chord, about the body's centre of mass. */
static thud_geometry placed(const td_shape *shape, const chord *c) {
    double arm_x = (double)shape->arm_x, arm_y = (double)shape->arm_y, s, cosine;
    td_sincos(td_angle_radians(shape->angle), &s, &cosine);
    return (thud_geometry){.kind = (thud_shape_kind)shape->kind,
                           .x = c->cosine * arm_x - c->sine * arm_y,
                           .y = c->sine * arm_x + c->cosine * arm_y,
                           .c = c->cosine * cosine - c->sine * s,
                           .s = c->sine * cosine + c->cosine * s,
                           .hx = (double)shape->half_x,
                           .hy = (double)shape->half_y};
}

/* A shape that touches another one at the start of a chord moves further into it if the cosine
 * between its displacement and the other's outward normal is below minus this. It is above the
 * error of normals, which are in single precision (6e-8): a shape that slides along a surface is
 * not stopped by it. */
#define FACING 1e-6

/* Finds the first shape that `shape` meets on the chord, and stores it in *first if it comes before
 * the hit that is there. A shape that overlaps at the start counts only if the motion leads further
 * into it. */
static void meet(const thud_world *w, int shape, const chord *c, const td_array *room,
                 thud_ray_hit *first) {
    const td_shape *own = td_shape_at(w, shape);
    thud_geometry moving = placed(own, c);
    thud_query_filter filter = {.category = own->filter.category,
                                .mask = own->filter.mask,
                                .group = own->filter.group,
                                .ignore = td_body_handle(w, own->body)};
    td_path way = {.meets = td_shape_meets,
                   .origin = td_place_to(w, c->from),
                   .from = c->from,
                   .dx = c->dx,
                   .dy = c->dy,
                   .shape = &moving,
                   .filter = &filter};
    td_walk walk = td_walk_begin(w, &way, room->data, td_walk_room(w));
    double length = __builtin_sqrt(c->dx * c->dx + c->dy * c->dy);
    thud_ray_hit hit = {.fraction = 2.0};
    td_nearest k = {&hit, 1, 0};
    for (td_walk_next(&walk, first->fraction, &k); k.count > 0;
         td_walk_next(&walk, first->fraction, &k)) {
        double along = (double)hit.normal.x * c->dx + (double)hit.normal.y * c->dy;
        if (hit.fraction < first->fraction && (hit.fraction > 0.0 || along < -FACING * length)) {
            *first = hit;
            return;
        }
    }
}

/* The number of chords for a flight of this time: one for each step or part of a step, up to a
 * maximum. A part below 0.001 step, which may be rounding, does not count. */
static int chords_of(const thud_world *w, double seconds) {
    double steps = seconds / w->def.time_step + 0.999;
    return steps < THUD_PREDICTION_CHORDS_MAX ? (int)steps : THUD_PREDICTION_CHORDS_MAX;
}

/* Whether both ends of the chord are in the world. A chord that is not is not cast: it meets
 * nothing. */
static bool ends_inside(const thud_world *w, const chord *c) {
    thud_pos at = td_place_to(w, c->from);
    return td_place_valid(w, at.x, at.y) && td_place_valid(w, at.x + c->dx, at.y + c->dy);
}

static thud_prediction predict(const thud_world *w, td_body_index index, double seconds,
                               const td_array *room) {
    td_flight f = td_flight_of(w, index);
    int chords = f.moves ? chords_of(w, seconds) : 0;
    const td_pose *pose = td_pose_at(w, index);
    double angle = td_angle_radians(pose->angle);
    td_flight_point from = td_flight_at(&f, 0.0);
    for (int i = 0; i < chords; i++) {
        td_flight_point to = td_flight_at(&f, seconds * (i + 1) / chords);
        chord c = {.from = {pose->center.x + td_round64(from.moved[0] * w->to_fixed),
                            pose->center.y + td_round64(from.moved[1] * w->to_fixed)},
                   .dx = to.moved[0] - from.moved[0],
                   .dy = to.moved[1] - from.moved[1]};
        td_sincos(td_angle_radians(td_angle_between(angle + from.moved[2])), &c.sine, &c.cosine);
        thud_ray_hit first = {.fraction = 2.0};
        for (int s = td_body_at(w, index)->first_shape; s != TD_NONE && ends_inside(w, &c);
             s = td_shape_at(w, s)->next) {
            if (!(td_shape_at(w, s)->flags & TD_SHAPE_HOLLOW) &&
                !td_kind_is_line(td_shape_at(w, s)->kind)) {
                meet(w, s, &c, room, &first);
            }
        }
        if (first.fraction <= 1.0) {
            double time = seconds * (i + first.fraction) / chords;
            td_flight_point at = td_flight_at(&f, time);
            at.moved[0] = from.moved[0] + first.fraction * c.dx;
            at.moved[1] = from.moved[1] + first.fraction * c.dy;
            at.moved[2] = from.moved[2];
            thud_prediction told = td_flight_tell(w, &f, &at, time);
            told.met = first.shape;
            return told;
        }
        from = to;
    }
    td_flight_point end = td_flight_at(&f, seconds);
    return td_flight_tell(w, &f, &end, seconds);
}

thud_result thud_world_predict(thud_world *w, const thud_body_id *bodies, int count, double seconds,
                               thud_prediction *out) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = td_flight_check(w, bodies, count, seconds, out);
    if (result != THUD_OK) {
        return result;
    }
    td_array *room = &w->scratch.found_shapes;
    if (!td_query_prepare(w) || !td_array_reserve(&w->memory, room, td_walk_room(w))) {
        return td_refuse(w, THUD_ERROR_MEMORY, "predict: out of memory");
    }
    for (int i = 0; i < count && result == THUD_OK; i++) {
        td_body_index index;
        result = td_find_body(w, bodies[i], &index);
        out[i] = predict(w, index, seconds, room);
    }
    return result;
}
