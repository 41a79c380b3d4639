/* record_frames.c: begins and ends the frames of calls and callbacks, and writes their records; see
 * recorder.h. */
#include "recording/recorder.h"

void td_record_flush_steps(thud_recorder *r) {
    if (r->waiting > 0) {
        td_write_byte(&r->records, TD_RECORD_STEPS);
        td_write_count(&r->records, r->waiting);
        r->waiting = 0;
    }
}

static void open_callback(thud_recorder *r, td_record_frame *frame);

void td_record_place(thud_recorder *r, td_record_frame *frame) {
    if (frame->outer) {
        open_callback(r, frame->outer);
    } else {
        td_record_flush_steps(r);
    }
    frame->start = r->records.count;
    if (frame->locked) {
        td_write_byte(&r->records, TD_RECORD_LOCKED);
    }
}

/* Writes the begin of the record of the callback under way, and before it that of its call, unless
 * they are written already. */
static void open_callback(thud_recorder *r, td_record_frame *frame) {
    td_writer *to = &r->records;
    if (!frame->opened) {
        td_record_place(r, frame);
        td_write_byte(to, TD_RECORD_OPEN);
        td_write_count(to, (uint64_t)frame->call);
        td_codec_write(r->world, to, &td_recorded_calls[frame->call], frame->args);
        frame->opened = true;
    }
    if (!frame->answering) {
        td_write_byte(to, TD_RECORD_CALLBACK);
        td_write_count(to, frame->callbacks - frame->written);
        frame->written = frame->callbacks;
        frame->answering = true;
    }
}

td_record_callback td_record_enter(thud_recorder *r, const thud_world *w) {
    td_record_callback callback = {r->failed ? NULL : r->frame, r->locked};
    if (callback.frame) {
        callback.frame->callbacks++;
        callback.frame->answering = false;
    }
    r->locked = w->locked;
    return callback;
}

td_writer *td_record_leave(thud_recorder *r, td_record_callback callback, bool usual) {
    td_record_frame *frame = callback.frame;
    r->locked = callback.locked;
    if (!frame || (usual && !frame->answering) || r->failed) {
        return NULL;
    }
    open_callback(r, frame);
    td_write_byte(&r->records, TD_RECORD_ANSWER);
    frame->answering = false;
    return &r->records;
}
