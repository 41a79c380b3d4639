/* finish.c: motion becomes pose. Reads velocity and delta of every awake body; writes poses, shape
 * places, fat bounds, idle times, the moved list and the list of fast bodies. A body that is not
 * finite is frozen where it was and reported: its contacts end, nobody else hears of its values. */
#include "awake.h"
#include "body.h"
#include "contact.h"
#include "handles.h"
#include "rotation.h"
#include "step.h"

#include <string.h>

static bool row_finite(const float *row)
{
    return td_finite((double)row[0] + (double)row[1] + (double)row[2]);
}

static void quarantine(thud_world *w, int index)
{
    td_body *body = td_body_at(w, index);
    memset(td_row(&w->velocity, body->awake), 0, sizeof(float[4]));
    for (int e = body->first_contact; e != TD_NONE;) {
        int next = td_next_edge(w, e);
        if (td_contact_end_reserve(w, 1)) {
            td_contact_destroy(w, e / 2);
        }
        e = next;
    }
    td_awake_remove(w, index);
    body->flags |= TD_BODY_QUARANTINED;
    w->awake_grid.valid = w->rest_grid.valid = false;
    if (td_array_reserve(&w->memory, &w->events.quarantined, w->events.quarantined.count + 1)) {
        *(thud_body_id *)td_at(&w->events.quarantined, w->events.quarantined.count++) =
            td_body_handle(w, index);
    }
    td_refuse(w, THUD_ERROR_INVALID, "a body became non-finite and is quarantined");
}

static void move(thud_world *w, int index, const float *delta)
{
    td_pose *pose = td_pose_at(w, index);
    pose->center.x += td_length_from(w, delta[0]);
    pose->center.y += td_length_from(w, delta[1]);
    if (delta[2] != 0.0f) {
        pose->angle += (uint32_t)td_round64((double)delta[2] * (1.0 / TD_RADIANS_A_QUANTUM));
        td_angle_turn(pose->angle, &pose->c, &pose->s);
    }
}

/* Adds to the time at rest, or starts it over. Kinematic bodies never rest while they move. */
static void count_idle(thud_world *w, int slot, const float *velocity, float rim)
{
    float still = TD_SLEEP_SPEED * w->unit;
    float turn = velocity[2] < 0.0f ? -velocity[2] * rim : velocity[2] * rim;
    float *idle = td_row(&w->idle, slot);
    bool rests = velocity[0] * velocity[0] + velocity[1] * velocity[1] < still * still &&
                 turn < still;
    *idle = rests ? *idle + (float)w->def.time_step : 0.0f;
    w->idle_bodies += *idle >= TD_SLEEP_TIME;
    w->drowsy_bodies += *idle + (float)w->def.time_step >= TD_SLEEP_TIME;
}

bool td_finish_reserve(thud_world *w)
{
    return td_array_reserve(&w->memory, &w->scratch.fast, w->body_of.count);
}

void td_finish(thud_world *w)
{
    w->idle_bodies = w->drowsy_bodies = 0;
    w->scratch.fast.count = 0;
    for (int slot = w->body_of.count - 1; slot > 0; slot--) {
        int index = *(int *)td_at(&w->body_of, slot);
        const float *velocity = td_row(&w->velocity, slot), *delta = td_row(&w->delta, slot);
        const float *reach = td_row(&w->reach, slot);
        if (!row_finite(velocity) || !row_finite(delta)) {
            quarantine(w, index);
            continue;
        }
        move(w, index, delta);
        if (w->def.sleeping) {
            count_idle(w, slot, velocity, reach[1]);
        }
        if (w->def.continuous && delta[0] * delta[0] + delta[1] * delta[1] >
                                     0.25f * reach[0] * reach[0]) {
            td_push_int(&w->scratch.fast, index);
        } else {
            td_body_place_shapes(w, index);
        }
    }
}
