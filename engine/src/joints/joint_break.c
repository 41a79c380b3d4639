/* joint_break.c: joints that break, or report, beyond a force or torque. Events are collected at
 * the end of a step, and the joints are destroyed after that, so that the joints of the events
 * still exist. */
#include "constraint/joint_hooks.h"
#include "joints/joint.h"
#include "state/handles.h"

static float length_of(thud_vec2 v) {
    double x = (double)v.x, y = (double)v.y;
    return (float)__builtin_sqrt(x * x + y * y);
}

/* Adds the event of a joint whose force or torque in the last substep exceeds its maximum. */
static void add_event_if_overloaded(thud_world *w, int index) {
    const td_joint *joint = td_joint_at(w, index);
    if (!joint->live || !td_joint_breaks(joint) || !td_joint_acts(w, joint)) {
        return;
    }
    td_joint_load load = td_joint_load_of(w, joint);
    float force = length_of(load.force), torque = td_joint_abs(load.torque);
    if (force > joint->break_force || torque > joint->break_torque) {
        /* Snapshots copy the whole struct with the padding bytes between its members, which must
         * therefore have a defined value. */
        thud_joint_event *event = td_at(&w->broken, w->broken.count++);
        __builtin_memset(event, 0, sizeof *event);
        event->joint = td_joint_handle(w, index);
        event->body_a = td_body_handle(w, joint->body[joint->swapped]);
        event->body_b = td_body_handle(w, joint->body[!joint->swapped]);
        event->user_data = joint->user_data;
        event->force = force;
        event->torque = torque;
        event->broken = !joint->only_reports;
    }
}

void td_joints_break_up(thud_world *w) {
    w->broken.count = 0;
    for (int i = 0; i < w->joints.count && w->breakable > 0; i++) {
        add_event_if_overloaded(w, i);
    }
    for (int i = 0; i < w->broken.count; i++) {
        const thud_joint_event *event = td_at(&w->broken, i);
        if (event->broken) {
            td_joint_end(w, (int)(event->joint.index1 - 1));
        }
    }
}

thud_result thud_world_get_joint_events(const thud_world *w, const thud_joint_event **out,
                                        int *out_count) {
    if (!w || !out || !out_count) {
        return THUD_ERROR_NULL;
    }
    const td_array *events = w->gathers ? &w->gathered.broken : &w->broken;
    *out = events->count ? td_at(events, 0) : NULL;
    *out_count = events->count;
    return THUD_OK;
}

thud_result thud_joint_set_breaking(thud_world *w, thud_joint_id id, float force, float torque,
                                    bool only_reports) {
    int index = 0;
    thud_result result = td_find_joint(w, id, true, &index);
    if (result != THUD_OK) {
        return result;
    }
    td_reason why;
    if (!td_joint_break_valid(&why, "joint set breaking: force", force) ||
        !td_joint_break_valid(&why, "joint set breaking: torque", torque)) {
        return td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
    td_joint *joint = td_joint_at(w, index);
    w->breakable -= td_joint_breaks(joint);
    joint->break_force = force;
    joint->break_torque = torque;
    joint->only_reports = only_reports;
    w->breakable += td_joint_breaks(joint);
    return THUD_OK;
}
