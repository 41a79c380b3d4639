/* sensing.c: see sensing.h.
 *
 * The path of a body in the step is a chain of legs, each straight or a parabola: impacts.c and
 * continuous.c append a leg for each body whose path they change, where there are sensors. A body
 * without legs moved straight. Two shapes are tested in each interval in which both stay on one
 * leg, by time of impact (geometry/toi.c): forward in time for the begin of an overlap, and
 * backward in time for its end. */
#include "detection/sensing.h"

#include "base/rotation.h"
#include "contact/sensors.h"
#include "detection/trajectory.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/kinds.h"
#include "state/shape.h"

#include <string.h>

/* ---- paths ---- */

/* Index in scratch.legs of the first leg of an awake body, or TD_NONE. */
static int first_leg(const thud_world *w, td_awake_slot slot) {
    const td_array *first = &w->scratch.first_legs;
    return slot.at > 0 && slot.at < first->count ? td_int_at(first, slot.at) : TD_NONE;
}

/* The leg on which the body is from `time` on; null if its path has no legs, or if it has reached
 * the end of its last leg and stays there. */
static const td_leg *leg_at(const thud_world *w, td_awake_slot slot, double time) {
    int i = first_leg(w, slot);
    while (i != TD_NONE && TD_AT(td_leg, &w->scratch.legs, i)->end <= time) {
        i = TD_AT(td_leg, &w->scratch.legs, i)->next;
    }
    return i == TD_NONE ? NULL : TD_AT(td_leg, &w->scratch.legs, i);
}

/* The trajectory on which the body is at `time`: that of its leg; at rest after its last leg; or
 * straight through the step if it has no legs. */
static td_trajectory trajectory_at(const thud_world *w, td_body_index body, double time) {
    td_awake_slot slot = td_body_at(w, body)->awake;
    const td_leg *leg = leg_at(w, slot, time);
    const td_pose *pose = td_pose_at(w, body);
    td_trajectory trajectory = {.place = pose->center, .angle = pose->angle, .body = body};
    if (leg) {
        trajectory = leg->trajectory;
    } else if (slot.at > 0 && first_leg(w, slot) == TD_NONE) {
        const float *delta = td_row(&w->delta, slot);
        trajectory.place.x = td_wrap_sub64(trajectory.place.x, td_length_from(w, delta[0]));
        trajectory.place.y = td_wrap_sub64(trajectory.place.y, td_length_from(w, delta[1]));
        trajectory.angle -= td_angle_between((double)delta[2]);
        for (int k = 0; k < 3; k++) {
            trajectory.motion[k] = (double)delta[k];
        }
    }
    return trajectory;
}

/* The time at which the leg that the body is on at `time` ends. */
static double leg_end_at(const thud_world *w, td_body_index body, double time) {
    const td_leg *leg = leg_at(w, td_body_at(w, body)->awake, time);
    return leg ? leg->end : 1.0;
}

/* A shape and its motion between two times on one leg. The second time may be earlier than the
 * first; the motion is then that backward in time. */
typedef struct moving_shape {
    thud_geometry at;   /* at the first time */
    thud_motion motion; /* motion from the first time to the second */
} moving_shape;

/* A shape from time `from` to time `to`, relative to `origin`. */
static moving_shape moving_shape_of(const thud_world *w, int shape, double from, double to,
                                    td_position origin) {
    td_trajectory trajectory =
        trajectory_at(w, td_shape_at(w, shape)->body, td_min_double(from, to));
    thud_geometry at = td_trajectory_shape(w, &trajectory, shape, from, origin);
    thud_geometry end = td_trajectory_shape(w, &trajectory, shape, to, origin);
    bool turns = td_kind_turns(at.kind);
    return (moving_shape){at,
                          {end.x - at.x, end.y - at.y,
                           turns ? trajectory.motion[2] * (to - from) : 0.0}};
}

/* Two shapes. The first may be a terrain (line), which does not move. Places are relative to
 * `origin`. */
typedef struct shape_pair {
    int a, b;
    bool line; /* a is a terrain */
    td_position origin;
} shape_pair;

/* The pair of two shapes, in the order in which a terrain comes first. */
static shape_pair shape_pair_of(const thud_world *w, int a, int b) {
    bool second = td_kind_is_line(td_shape_at(w, b)->kind);
    shape_pair c = {.a = second ? b : a, .b = second ? a : b};
    c.line = td_kind_is_line(td_shape_at(w, c.a)->kind);
    c.origin = td_shape_proxy_at(w, c.a)->center;
    return c;
}

/* Whether the pair overlaps at some time between `from` and `to`, between which no leg ends. *time:
 * when it first does so, as a share in [0, 1] of the interval. */
static bool first_overlap(const thud_world *w, const shape_pair *c, double from, double to,
                          double *time) {
    bool hit = false;
    moving_shape b = moving_shape_of(w, c->b, from, to, c->origin);
    if (c->line) {
        w->ground->time_of_impact(w, c->a, &b.at, b.motion, &hit, time);
    } else {
        moving_shape a = moving_shape_of(w, c->a, from, to, c->origin);
        w->instances->time_of_impact(&a.at, a.motion, &b.at, b.motion, 0.0, &hit, time);
    }
    return hit;
}

/* Whether the pair overlaps within the step: *from is when first, *until when last. */
static bool overlap_on_path(const thud_world *w, int shape_a, int shape_b, double *from,
                            double *until) {
    shape_pair c = shape_pair_of(w, shape_a, shape_b);
    td_body_index body_a = td_shape_at(w, c.a)->body, body_b = td_shape_at(w, c.b)->body;
    bool overlaps = false;
    for (double now = 0.0, next; now < 1.0; now = next) {
        next = td_min_double(leg_end_at(w, body_a, now), leg_end_at(w, body_b, now));
        double part = 0.0, back = 0.0;
        if (first_overlap(w, &c, now, next, &part)) {
            double first = now + part * (next - now);
            bool ends = first_overlap(w, &c, next, now, &back);
            *from = overlaps ? *from : first;
            *until = ends ? next - back * (next - now) : first;
            overlaps = true;
        }
    }
    return overlaps;
}

/* Whether the detection of the pair tests its paths. Continuous detection does for sensors of
 * static bodies only. */
static bool is_detected(const thud_world *w, int a, int b) {
    const td_shape *shapes[2] = {td_shape_at(w, a), td_shape_at(w, b)};
    const thud_detection *detection = td_detection_of(w, shapes[0]->body, shapes[1]->body);
    bool static_sensor = false;
    for (int i = 0; i < 2; i++) {
        static_sensor |= (shapes[i]->flags & TD_SHAPE_SENSOR) &&
                         td_body_at(w, shapes[i]->body)->kind == THUD_BODY_STATIC;
    }
    return detection->time_of_impact || (detection->rank == TD_RANK_CONTINUOUS && static_sensor);
}

float td_sensing_time(const thud_world *w, int a, int b, bool begins) {
    double from = 1.0, until = 1.0;
    if (is_detected(w, a, b)) {
        overlap_on_path(w, a, b, &from, &until);
    }
    return (float)(begins ? from : until);
}

/* ---- pairs that overlapped within the step only ---- */

/* Whether an earlier step reported the begin of the overlap and none has reported its end: then
 * contact/sensor_events.c reports the end, and nothing is reported here. */
static bool was_open(const thud_world *w, int a, int b) {
    int e = td_body_at(w, td_shape_at(w, b)->body)->first_constraint;
    bool open = false;
    for (; e != TD_NONE && !open; e = td_next_edge(w, e)) {
        const td_constraint *c = td_constraint_at(w, td_edge_constraint(e));
        open = c->kind == TD_PAIR_SENSOR && c->open &&
               ((c->shape_a == a && c->shape_b == b) || (c->shape_a == b && c->shape_b == a));
    }
    return open;
}

/* Whether an edit has ended the overlap before the step, so that its end is among the events of
 * this step already, at time 0. If a begin and an end of the same pair followed, the caller would
 * take them for a second overlap. */
static bool has_ended(const thud_world *w, int sensor, int other) {
    thud_contact_event pair = {td_shape_handle(w, sensor), td_shape_handle(w, other)};
    const td_array *ends = &w->events.sensor_end, *times = &w->events.sensor_end_time;
    bool ended = false;
    for (int i = 0; i < ends->count && *TD_AT(float, times, i) == 0.0f && !ended; i++) {
        ended = memcmp(TD_AT(thud_contact_event, ends, i), &pair, sizeof pair) == 0;
    }
    return ended;
}

/* Whether one of the shapes is a sensor. */
static bool has_sensor(const thud_world *w, int a, int b) {
    return (td_shape_at(w, a)->flags | td_shape_at(w, b)->flags) & TD_SHAPE_SENSOR;
}

void td_sensing_test_pair(thud_world *w, int a, int b) {
    double from, until;
    if (has_sensor(w, a, b) && td_pair_allowed(w, a, b) && !td_pair_is_silent(w, a, b) &&
        is_detected(w, a, b) && overlap_on_path(w, a, b, &from, &until) &&
        !td_sensor_overlaps(w, a, b) && !was_open(w, a, b)) {
        bool second = !(td_shape_at(w, a)->flags & TD_SHAPE_SENSOR);
        int sensor = second ? b : a, other = second ? a : b;
        if (!has_ended(w, sensor, other)) {
            td_sensor_passed(w, sensor, other, (float)from, (float)until);
        }
    }
}

/* Whether the body's path has one leg only: nothing stopped or turned it in this step. */
static bool is_straight(const thud_world *w, td_awake_slot slot) {
    return first_leg(w, slot) == TD_NONE;
}

bool td_sensing_is_fast(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot), *reach = td_row(&w->reach, slot);
    return !is_straight(w, slot) ||
           delta[0] * delta[0] + delta[1] * delta[1] > 0.25f * reach[0] * reach[0];
}

/* Half the width of the square about the end of the path that contains the whole path of the body,
 * by the places where its legs begin, how far a parabola leaves its chord, and its max_extent. A
 * length. */
static double path_reach(const thud_world *w, td_awake_slot slot) {
    const float *delta = td_row(&w->delta, slot);
    double extent = (double)td_row(&w->reach, slot)[1];
    if (is_straight(w, slot)) {
        return td_max_double(td_abs((double)delta[0]), td_abs((double)delta[1])) + extent;
    }
    td_body_index body = td_body_of(w, slot);
    td_position end = td_pose_at(w, body)->center;
    const td_trajectory straight = {.body = body};
    double far = 0.0, chord_error = 0.0;
    for (double now = 0.0, next; now < 1.0; now = next) {
        td_trajectory leg = trajectory_at(w, body, now);
        next = leg_end_at(w, body, now);
        far = td_max_double(far, td_abs((double)td_wrap_sub64(leg.place.x, end.x)));
        far = td_max_double(far, td_abs((double)td_wrap_sub64(leg.place.y, end.y)));
        chord_error =
            td_max_double(chord_error, td_trajectories_chord_error(&straight, &leg, next - now));
    }
    return far / w->to_fixed + chord_error + extent;
}

bool td_sensing_path_bounds(const thud_world *w, td_awake_slot slot, td_bounds *bounds) {
    double reach = path_reach(w, slot);
    /* Wider bounds might wrap around: 2^14 length scales are a sixteenth of the period. */
    if (!(reach < 0x1p14 * (double)w->length_scale)) {
        return false;
    }
    int32_t half = (int32_t)(reach * w->to_coarse) + 3;
    *bounds = td_bounds_about(td_pose_at(w, td_body_of(w, slot))->center, half, half);
    return true;
}

/* Tests a pair with a shape of the set of resting shapes. If the narrowphase has woken the shape's
 * body since the set was built, the pair is left to sensing_awake.c. */
static void test_resting(thud_world *w, int shape, int other) {
    if (other != TD_NONE && td_body_at(w, td_shape_at(w, other)->body)->awake.at <= 0) {
        td_sensing_test_pair(w, shape, other);
    }
}

/* Tests a fast body against all shapes at rest near its path, and all terrains. In the order of
 * shapes, so that the result does not depend on the broadphase. */
static void test_all_resting(thud_world *w, td_awake_slot slot) {
    td_body_index index = td_body_of(w, slot);
    const td_array *found = &w->rest_shapes.ids;
    td_bounds bounds;
    if (td_sensing_path_bounds(w, slot, &bounds)) {
        td_array *hits = &w->scratch.ahead;
        hits->count = 0;
        if (!w->def.broadphase->find[w->wide](&w->rest_shapes, &w->memory, &bounds,
                                              td_pose_at(w, index)->center, hits, NULL)) {
            return;
        }
        td_sort_ints(hits);
        found = hits;
    }
    for (int a = td_body_at(w, index)->first_shape; a != TD_NONE; a = td_shape_at(w, a)->next) {
        for (int i = 0; i < found->count; i++) {
            test_resting(w, a, td_int_at(found, i));
        }
        for (int t = 0; t < w->terrains.count; t++) {
            int line = td_terrain_record_at(w, t)->shape;
            if (line != TD_NONE) {
                td_sensing_test_pair(w, a, line);
            }
        }
    }
}

/* Links the legs of each body, which were appended in the order of time. If continuous.c held a
 * body, and impacts.c then moved it along the path that was left, both made legs for the same
 * times; those of impacts.c count. */
static void link_legs(thud_world *w) {
    td_array *first = &w->scratch.first_legs;
    first->count = w->body_of.count;
    for (int slot = 0; slot < first->count; slot++) {
        td_int_set(first, slot, TD_NONE);
    }
    for (int i = w->scratch.legs.count - 1; i >= 0; i--) {
        td_leg *leg = TD_AT(td_leg, &w->scratch.legs, i);
        int slot = td_body_at(w, leg->trajectory.body)->awake.at, next = td_int_at(first, slot);
        if (next == TD_NONE ||
            TD_AT(td_leg, &w->scratch.legs, next)->trajectory.since > leg->trajectory.since) {
            leg->next = next;
            td_int_set(first, slot, i);
        }
    }
}

/* scratch.ahead gets room for the hits of a query among the resting shapes. */
bool td_sensing_reserve(thud_world *w) {
    return td_array_reserve(&w->memory, &w->scratch.first_legs, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.legs, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.ahead, td_query_room(w->rest_shapes.ids.count));
}

void td_sensing_note_held(thud_world *w) {
    for (td_awake_slot slot = {1}; slot.at < w->scratch.held_at.count; slot.at++) {
        double end = *TD_AT(double, &w->scratch.held_at, slot.at);
        if (end < 1.0 && end > 0.0) {
            td_pose start = td_start_pose(w, slot);
            const float *delta = td_row(&w->delta, slot);
            td_trajectory trajectory = {.place = start.center,
                                        .angle = start.angle,
                                        .body = td_body_of(w, slot)};
            for (int k = 0; k < 3; k++) {
                trajectory.motion[k] = (double)delta[k] / end;
            }
            td_leg_note(w, &trajectory, end);
        }
    }
}

void td_sensing_find_passed(thud_world *w) {
    void (*sense_awake)(thud_world *) = td_sensing_of(w)->sense_awake;
    link_legs(w);
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        if (td_sensing_is_fast(w, slot)) {
            test_all_resting(w, slot);
        }
    }
    if (sense_awake) {
        sense_awake(w);
    }
}
