/* record_callbacks.c: the callbacks of a world that is recorded. The recorder sets functions of its
 * own in place of the caller's. These call the caller's, and record the calls that are made within
 * them and their answers. A callback is recorded only if calls were recorded within it, or its
 * answer is not the usual one: yes with unchanged settings; no for a mover's pass callback. */
#include "listeners/listeners.h"
#include "recording/recorder.h"
#include "rules/rules.h"

#include <string.h>

/* ---- answers ---- */

static void write_float(td_writer *to, float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    td_write_number(to, bits, sizeof bits);
}

/* Writes the answer of a prologue about a contact. */
static void write_answer(td_writer *to, bool yes, const thud_contact_settings *own,
                         const thud_contact_settings *settings) {
    bool differs = memcmp(own, settings, sizeof *own) != 0;
    td_write_byte(to, (yes ? TD_ANSWER_YES : 0u) | (differs ? TD_ANSWER_SETTINGS : 0u));
    if (differs) {
        write_float(to, settings->friction);
        write_float(to, settings->restitution);
        write_float(to, settings->surface_speed);
    }
}

/* Writes the answer of a callback that returns yes or no, unless it is the usual one. */
static void write_yes(thud_recorder *r, td_record_callback callback, bool yes, bool usual) {
    td_writer *to = td_record_leave(r, callback, yes == usual);
    if (to) {
        td_write_byte(to, yes);
    }
}

/* ---- the world's ---- */

static bool on_prologue(thud_world *w, const thud_contact *contact, thud_contact_settings *settings,
                        void *context) {
    thud_recorder *r = context;
    thud_contact_settings own = *settings;
    td_record_callback callback = td_record_enter(r, w);
    bool yes = r->listeners.prologue(w, contact, settings, r->listeners.context);
    td_writer *to = td_record_leave(r, callback, yes && memcmp(&own, settings, sizeof own) == 0);
    if (to) {
        write_answer(to, yes, &own, settings);
    }
    return yes;
}

static void on_epilogue(thud_world *w, const thud_contact *contact, void *context) {
    thud_recorder *r = context;
    td_record_callback callback = td_record_enter(r, w);
    r->listeners.epilogue(w, contact, r->listeners.context);
    td_record_leave(r, callback, true);
}

/* Records the answers of prologue_all that differ from the default answers, each after its distance
 * in the list from the last one recorded. If memory for a copy of the default answers is short, the
 * recording fails. */
static void on_prologue_all(thud_world *w, const thud_contact *contacts,
                            thud_contact_answer *answers, int count, void *context) {
    thud_recorder *r = context;
    td_record_callback callback = td_record_enter(r, w);
    size_t bytes = (size_t)count * sizeof *answers;
    thud_contact_answer *own =
        callback.frame && count > 0 ? td_memory_get(&r->memory, bytes) : NULL;
    r->failed |= callback.frame && count > 0 && !own;
    if (own) {
        memcpy(own, answers, bytes);
    }
    r->listeners.prologue_all(w, contacts, answers, count, r->listeners.context);
    int changed = 0;
    for (int i = 0; own && i < count; i++) {
        changed += !answers[i].collide ||
                   memcmp(&own[i].settings, &answers[i].settings, sizeof own[i].settings) != 0;
    }
    td_writer *to = td_record_leave(r, callback, changed == 0);
    if (to) {
        td_write_count(to, (uint64_t)changed);
    }
    int last = 0;
    for (int i = 0; to && changed > 0 && i < count; i++) {
        if (!answers[i].collide ||
            memcmp(&own[i].settings, &answers[i].settings, sizeof own[i].settings) != 0) {
            td_write_count(to, (uint64_t)(i - last));
            write_answer(to, answers[i].collide, &own[i].settings, &answers[i].settings);
            last = i;
        }
    }
    td_memory_put(&r->memory, own, bytes);
}

static void on_epilogue_all(thud_world *w, const thud_contact *contacts, int count, void *context) {
    thud_recorder *r = context;
    td_record_callback callback = td_record_enter(r, w);
    r->listeners.epilogue_all(w, contacts, count, r->listeners.context);
    td_record_leave(r, callback, true);
}

bool td_record_filter(const thud_world *w, thud_shape_id a, thud_shape_id b, void *context) {
    thud_recorder *r = context;
    td_record_callback callback = td_record_enter(r, w);
    bool yes = r->filter(w, a, b, r->filter_context);
    write_yes(r, callback, yes, true);
    return yes;
}

/* ---- of single calls ---- */

void td_record_before(thud_world *w, void *context) {
    thud_recorder *r = context;
    const thud_step_calls *own = r->frame->steps;
    td_record_callback callback = td_record_enter(r, w);
    own->before(w, own->context);
    td_record_leave(r, callback, true);
}

void td_record_after(thud_world *w, void *context) {
    thud_recorder *r = context;
    const thud_step_calls *own = r->frame->steps;
    td_record_callback callback = td_record_enter(r, w);
    own->after(w, own->context);
    td_record_leave(r, callback, true);
}

bool td_record_pass(const thud_mover *mover, const thud_mover_hit *hit, thud_vec2 velocity,
                    void *context) {
    thud_recorder *r = context;
    const td_record_frame *frame = r->frame;
    td_record_callback callback = td_record_enter(r, r->world);
    bool yes = frame->pass(mover, hit, velocity, frame->pass_context);
    write_yes(r, callback, yes, false);
    return yes;
}

/* ---- epilogues of objects: all those of a contact count as one callback ---- */

/* Says that every pair has an epilogue. A player does not know which objects have one; so that it
 * counts the same callbacks, the recorder's is called for all contacts. */
static bool wants_any(const thud_world *w, int shape_a, int shape_b) {
    (void)w;
    (void)shape_a;
    (void)shape_b;
    return true;
}

static void tell_objects(thud_world *w, const thud_contact *seen) {
    thud_recorder *r = w->recorder;
    td_record_callback callback = td_record_enter(r, w);
    r->object_hooks->tell(w, seen);
    td_record_leave(r, callback, true);
}

static bool prune_objects(thud_world *w) {
    w->recorder->object_hooks->prune(w);
    return true;
}

static void end_objects(thud_world *w) {
    w->recorder->object_hooks->end(w);
}

static const td_object_hooks OBJECT_HOOKS = {.wants = wants_any,
                                             .tell = tell_objects,
                                             .prune = prune_objects,
                                             .end = end_objects};

/* ---- replacing the caller's callbacks ---- */

/* Replaces the caller's listeners by the recorder's, if the caller has set new ones. */
static void take_listeners(thud_recorder *r, td_listeners *l) {
    thud_listeners *own = &l->calls;
    bool taken = (!own->prologue || own->prologue == on_prologue) &&
                 (!own->epilogue || own->epilogue == on_epilogue) &&
                 (!own->prologue_all || own->prologue_all == on_prologue_all) &&
                 (!own->epilogue_all || own->epilogue_all == on_epilogue_all);
    if (!taken) {
        r->listeners = *own;
        own->prologue = own->prologue ? on_prologue : NULL;
        own->epilogue = own->epilogue ? on_epilogue : NULL;
        own->prologue_all = own->prologue_all ? on_prologue_all : NULL;
        own->epilogue_all = own->epilogue_all ? on_epilogue_all : NULL;
        own->context = r;
    }
    if (l->object_hooks && l->object_hooks != &OBJECT_HOOKS) {
        r->object_hooks = l->object_hooks;
        l->object_hooks = &OBJECT_HOOKS;
        td_listeners_update(r->world);
    }
}

void td_record_take_callbacks(thud_recorder *r) {
    thud_world *w = r->world;
    unsigned calls = 0;
    uint32_t without = 0;
    if (w->listeners) {
        take_listeners(r, w->listeners);
        const thud_listeners *own = &w->listeners->calls;
        calls = (own->prologue ? TD_CALLS_PROLOGUE : 0u) |
                (own->epilogue ? TD_CALLS_EPILOGUE : 0u) |
                (own->prologue_all ? TD_CALLS_PROLOGUE_ALL : 0u) |
                (own->epilogue_all ? TD_CALLS_EPILOGUE_ALL : 0u) |
                (w->listeners->object_hooks ? TD_CALLS_OBJECTS : 0u);
        without = own->without;
    }
    if (w->rules && w->rules->filter) {
        calls |= TD_CALLS_FILTER;
        if (w->rules->filter != td_record_filter) {
            r->filter = w->rules->filter;
            r->filter_context = w->rules->filter_context;
            w->rules->filter = td_record_filter;
            w->rules->filter_context = r;
        }
    }
    if (calls != r->calls || without != r->without) {
        r->calls = calls;
        r->without = without;
        td_record_flush_steps(r);
        td_write_byte(&r->records, TD_RECORD_LISTENERS);
        td_write_byte(&r->records, calls);
        td_write_count(&r->records, without);
    }
}

void td_record_return_callbacks(thud_recorder *r) {
    thud_world *w = r->world;
    if (w->listeners) {
        const thud_listeners *own = &w->listeners->calls;
        if (own->prologue == on_prologue || own->epilogue == on_epilogue ||
            own->prologue_all == on_prologue_all || own->epilogue_all == on_epilogue_all) {
            w->listeners->calls = r->listeners;
        }
        if (w->listeners->object_hooks == &OBJECT_HOOKS) {
            w->listeners->object_hooks = r->object_hooks;
        }
        td_listeners_update(w);
    }
    if (w->rules && w->rules->filter == td_record_filter) {
        w->rules->filter = r->filter;
        w->rules->filter_context = r->filter_context;
    }
}
