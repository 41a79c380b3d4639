/* recorded_by_hand.c: the functions of thud_recorded.h that do more than their call: those that
 * pass callbacks, and those that replace or end what is recorded. */
#include "recording/recorder.h"

#include "thud/thud_all.h"

THUD_API thud_result thud_recorded_world_advance_with(thud_world *world, double elapsed,
                                                      int max_steps, const thud_step_calls *calls,
                                                      int *out_steps, double *out_alpha) {
    const void *const args[] = {&elapsed, &max_steps, &calls, &out_steps, &out_alpha};
    td_record_frame frame;
    td_record_open(&frame, world, TD_CALL_WORLD_ADVANCE_WITH, args);
    thud_step_calls own = {.context = frame.recorder};
    const thud_step_calls *passed = calls;
    if (frame.recorder && calls) {
        frame.steps = calls;
        own.before = calls->before ? td_record_before : NULL;
        own.after = calls->after ? td_record_after : NULL;
        passed = &own;
    }
    return td_record_close(&frame, thud_world_advance_with(world, elapsed, max_steps, passed,
                                                           out_steps, out_alpha));
}

THUD_API thud_result thud_recorded_world_set_filter(thud_world *world, thud_filter_fn *filter,
                                                    void *context) {
    const void *const args[] = {&filter, &context};
    td_record_frame frame;
    td_record_open(&frame, world, TD_CALL_WORLD_SET_FILTER, args);
    thud_recorder *r = frame.recorder;
    if (!r || !filter) {
        return td_record_close(&frame, thud_world_set_filter(world, filter, context));
    }
    thud_filter_fn *old = r->filter;
    void *old_context = r->filter_context;
    r->filter = filter;
    r->filter_context = context;
    thud_result result = thud_world_set_filter(world, td_record_filter, r);
    if (result != THUD_OK) {
        r->filter = old;
        r->filter_context = old_context;
    }
    return td_record_close(&frame, result);
}

THUD_API thud_result thud_recorded_mover_move(thud_world *world, thud_mover *mover,
                                              thud_vec2 velocity, double dt,
                                              thud_mover_report *out_report) {
    thud_mover before = mover ? *mover : (thud_mover){0};
    const thud_mover *given = mover ? &before : NULL;
    const void *const args[] = {&given, &velocity, &dt, &out_report};
    td_record_frame frame;
    td_record_open(&frame, world, TD_CALL_MOVER_MOVE, args);
    bool passes = frame.recorder && mover && mover->pass;
    if (passes) {
        frame.pass = mover->pass;
        frame.pass_context = mover->context;
        mover->pass = td_record_pass;
        mover->context = frame.recorder;
    }
    thud_result result = thud_mover_move(world, mover, velocity, dt, out_report);
    if (passes) {
        mover->pass = before.pass;
        mover->context = before.context;
    }
    return td_record_close(&frame, result);
}

THUD_API thud_result thud_recorded_world_restore(thud_world *world, const void *buffer,
                                                 size_t bytes) {
    thud_result result = thud_world_restore(world, buffer, bytes);
    if (result == THUD_OK) {
        td_record_restored(world);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_load(thud_world *world, const char *path, void *out_own,
                                              size_t bytes) {
    thud_result result = thud_world_load(world, path, out_own, bytes);
    if (result == THUD_OK) {
        td_record_restored(world);
    }
    return result;
}

THUD_API void thud_recorded_world_destroy(thud_world *world) {
    td_record_leave_world(world);
    thud_world_destroy(world);
}
