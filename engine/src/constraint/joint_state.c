/* joint_state.c: what callers read of a joint; see thud_joint.h. */
#include "constraint/joint.h"
#include "state/handles.h"

static bool is_live(const thud_world *w, thud_joint_id id) {
    return id.index1 > 0 && id.index1 <= (uint32_t)w->joints.count &&
           td_joint_at(w, (int)(id.index1 - 1))->live &&
           td_tag(w, td_joint_at(w, (int)(id.index1 - 1))->generation) == id.generation;
}

thud_result td_find_joint(const thud_world *w, thud_joint_id id, bool edits, int *index) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (!is_live(w, id)) {
        return td_refuse(w, THUD_ERROR_STALE, "this joint is destroyed, or of another world");
    }
    if (edits && w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "joint: not inside a callback");
    }
    *index = (int)(id.index1 - 1);
    return THUD_OK;
}

bool thud_joint_is_valid(const thud_world *w, thud_joint_id id) {
    return w && is_live(w, id);
}

static double size_of(double x) {
    return x < 0.0 ? -x : x;
}

/* Adds what a part gave b's side in the last substep. */
static void add_impulse(const thud_world *w, const td_constraint *part, double impulse[3]) {
    if (part->state != TD_TOUCHING) {
        return;
    }
    td_lane at = td_lane_of(w, part);
    double first = (double)at.block->point[0].normal_impulse[at.lane];
    double x = (double)at.block->nx[at.lane], y = (double)at.block->ny[at.lane];
    double third = (double)at.block->tangent_impulse[at.lane];
    if (part->kind == TD_CONSTRAINT_ROD) {
        impulse[0] += x * first;
        impulse[1] += y * first;
        return;
    }
    double second = (double)at.block->point[1].normal_impulse[at.lane];
    if (part->kind == TD_CONSTRAINT_HOLD) {
        impulse[0] += x * first - y * second;
        impulse[1] += y * first + x * second;
        impulse[2] += (double)td_hold_rows_at(at.block)->turn_sign[at.lane] * third;
        return;
    }
    const td_drive_rows *rows = td_drive_rows_at(at.block);
    double along = (double)rows->limit_side[at.lane] * first + second + third;
    bool turns = part->kind == TD_CONSTRAINT_DRIVE_TURN;
    impulse[0] += turns ? 0.0 : x * along;
    impulse[1] += turns ? 0.0 : y * along;
    impulse[2] += turns ? (double)rows->turn_sign[at.lane] * along : 0.0;
}

thud_result thud_joint_get(const thud_world *w, thud_joint_id id, thud_joint_state *out) {
    TD_IN_OWN_MODE;
    int index = 0;
    thud_result result = td_find_joint(w, id, false, &index);
    if (result != THUD_OK || !out) {
        return result != THUD_OK ? result : td_refuse(w, THUD_ERROR_NULL, "joint get: out is null");
    }
    const td_joint *joint = td_joint_at(w, index);
    td_joint_place place = td_joint_place_of(w, joint);
    double x = (double)place.x, y = (double)place.y;
    double u = (double)place.axis_x, v = (double)place.axis_y;
    double value[] = {x * u + y * v, y * u - x * v, (double)place.turn};
    double length = __builtin_sqrt(x * x + y * y);
    unsigned locked = td_joint_locked(joint);
    double gap_u = locked >> THUD_ALONG & 1u ? value[0] : 0.0;
    double gap_v = locked >> THUD_ACROSS & 1u ? value[1] : 0.0;
    double gap = __builtin_sqrt(gap_u * gap_u + gap_v * gap_v), impulse[3] = {0.0, 0.0, 0.0};
    if (joint->kind == THUD_DISTANCE) {
        value[THUD_ALONG] = length;
        value[THUD_ACROSS] = 0.0;
        gap = locked ? size_of(length - (double)joint->length) : 0.0;
    }
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        if (joint->part[i] != TD_NONE) {
            add_impulse(w, td_constraint_at(w, joint->part[i]), impulse);
        }
    }
    double rate = (joint->swapped ? -1.0 : 1.0) * w->substeps / w->def.time_step;
    *out =
        (thud_joint_state){.kind = (thud_joint_kind)joint->kind,
                           .body_a = td_body_handle(w, joint->body[joint->swapped]),
                           .body_b = td_body_handle(w, joint->body[!joint->swapped]),
                           .enabled = !joint->disabled,
                           .value = {value[0], value[1], value[2]},
                           .gap = gap,
                           .angle_gap = locked >> THUD_TURN & 1u ? size_of(value[THUD_TURN]) : 0.0,
                           .force = {(float)(rate * impulse[0]), (float)(rate * impulse[1])},
                           .torque = (float)(rate * impulse[2]),
                           .user_data = joint->user_data};
    return THUD_OK;
}
