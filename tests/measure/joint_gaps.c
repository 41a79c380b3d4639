/* joint_gaps.c: see joint_gaps.h. */
#include "joint_gaps.h"

#include <math.h>

/* The pose of frame b relative to frame a: along and across its axis in m, and the angle in rad. */
typedef struct view {
    double along, across, turn;
} view;

/* The second anchor in the first anchor's frame: along and across its axis, and the relative angle.
 */
static view look(const scene_joint *j, const engine_body *a, const engine_body *b) {
    double ax = a->x + a->cosine * j->x[0] - a->sine * j->y[0];
    double ay = a->y + a->sine * j->x[0] + a->cosine * j->y[0];
    double bx = b->x + b->cosine * j->x[1] - b->sine * j->y[1];
    double by = b->y + b->sine * j->x[1] + b->cosine * j->y[1];
    double tilt = atan2(a->sine, a->cosine) + j->angle[0];
    double turn = atan2(b->sine, b->cosine) + j->angle[1] - tilt;
    double dx = bx - ax, dy = by - ay;
    return (view){dx * cos(tilt) + dy * sin(tilt), dy * cos(tilt) - dx * sin(tilt),
                  atan2(sin(turn), cos(turn))};
}

/* How far the value is beyond the drive's limits; 0 within them. */
static double past(const scene_drive *d, double value) {
    return d->limited ? fmax(0, fmax(d->lower - value, value - d->upper)) : 0;
}

static bool is_driven(const scene_drive *d) {
    return d->limited || d->frequency > 0 || d->motor_force > 0;
}

static joint_gap gap_of_distance(const scene_joint *j, view v) {
    double distance = hypot(v.along, v.across);
    const scene_drive *d = &j->drive[SCENE_ALONG];
    return is_driven(d) ? (joint_gap){.beyond = past(d, distance)}
                        : (joint_gap){.length = fabs(distance - j->length)};
}

static joint_gap gap_of_weld(const scene_joint *j, view v) {
    double along = is_driven(&j->drive[SCENE_ALONG]) ? 0 : v.along;
    double across = is_driven(&j->drive[SCENE_ACROSS]) ? 0 : v.across;
    return (joint_gap){.length = hypot(along, across),
                       .angle = is_driven(&j->drive[SCENE_TURN]) ? 0 : fabs(v.turn)};
}

/* A body is lost if its pose is not finite. Checked separately, because fmax ignores NaN. */
static bool is_lost(const engine_body *b) {
    return !isfinite(b->x) || !isfinite(b->y) || !isfinite(b->cosine) || !isfinite(b->sine);
}

joint_gap joint_gap_of(const scene *s, int joint, const engine_body *bodies) {
    const scene_joint *j = &s->joints[joint];
    if (j->kind == SCENE_GEAR || j->kind == SCENE_FILTER)
        return (joint_gap){0};
    const engine_body *a = &bodies[j->body[0]], *b = &bodies[j->body[1]];
    if (is_lost(a) || is_lost(b))
        return (joint_gap){NAN, NAN, NAN, NAN};
    view v = look(j, a, b);
    double beyond = past(&j->drive[SCENE_ALONG], v.along);
    double beyond_angle = past(&j->drive[SCENE_TURN], v.turn);
    switch (j->kind) {
    case SCENE_DISTANCE:
        return gap_of_distance(j, v);
    case SCENE_HINGE:
        return (joint_gap){.length = hypot(v.along, v.across), .beyond_angle = beyond_angle};
    case SCENE_SLIDER:
        return (joint_gap){.length = fabs(v.across), .angle = fabs(v.turn), .beyond = beyond};
    case SCENE_WELD:
        return gap_of_weld(j, v);
    case SCENE_WHEEL:
        return (
            joint_gap){.length = fabs(v.across), .beyond = beyond, .beyond_angle = beyond_angle};
    case SCENE_TARGET:
    case SCENE_FILTER:
    case SCENE_GEAR:
        break;
    }
    return (joint_gap){0};
}

void joint_gaps_sample(const scene *s, const engine_body *bodies, joint_gaps *seen) {
    int lost = 0;
    for (int i = 0; i < s->joint_count; i++) {
        joint_gap gap = joint_gap_of(s, i, bodies);
        if (isnan(gap.length)) {
            lost++;
            continue;
        }
        seen->worst.length = fmax(seen->worst.length, gap.length);
        seen->worst.angle = fmax(seen->worst.angle, gap.angle);
        seen->worst.beyond = fmax(seen->worst.beyond, gap.beyond);
        seen->worst.beyond_angle = fmax(seen->worst.beyond_angle, gap.beyond_angle);
        seen->sum += gap.length;
        seen->joints++;
    }
    seen->lost = lost > seen->lost ? lost : seen->lost;
}

double joint_gaps_mean(const joint_gaps *seen) {
    return seen->joints > 0 ? seen->sum / (double)seen->joints : 0;
}

double joint_gaps_sum(const scene *s, const engine_body *bodies) {
    joint_gaps now = {0};
    joint_gaps_sample(s, bodies, &now);
    return now.lost > 0 ? INFINITY : now.sum;
}
