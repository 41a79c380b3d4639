/* play_callbacks.c: the callbacks of a world that is played: they count themselves, make the calls
 * that were recorded within them, and give the recorded answers (recording.h). */
#include "listeners/listeners.h"
#include "recording/play_call.h"
#include "rules/rules.h"
#include "thud/thud_all.h"

#include <string.h>

void td_play_next_callback(td_play *p, td_play_frame *frame) {
    td_reader *from = &p->from;
    frame->next = 0;
    if (!from->broken && from->at < from->end && from->bytes[from->at] == TD_RECORD_CALLBACK) {
        from->at++;
        frame->next = frame->callbacks + td_read_count(from);
    }
}

/* Counts a callback. If it has a record, plays the calls that were made within it, and returns
 * true: the recorded answer follows, after which the caller must call `leave`. */
static bool enter(td_play *p) {
    td_play_frame *frame = p->frame;
    if (!frame || ++frame->callbacks != frame->next || !td_play_goes_on(p)) {
        return false;
    }
    for (unsigned record = td_read_byte(&p->from); record != TD_RECORD_ANSWER;
         record = td_read_byte(&p->from)) {
        p->record(p, record);
        if (!td_play_goes_on(p)) {
            return false;
        }
    }
    return !p->from.broken;
}

static void leave(td_play *p) {
    td_play_next_callback(p, p->frame);
}

/* Plays a callback that returns nothing. */
static void play(td_play *p) {
    if (enter(p)) {
        leave(p);
    }
}

/* Plays a callback that returns yes or no. Without a record it returns `usual`. */
static bool ask(td_play *p, bool usual) {
    bool yes = usual;
    if (enter(p)) {
        yes = td_read_byte(&p->from) != 0;
        leave(p);
    }
    return yes;
}

static float read_float(td_reader *from) {
    uint32_t bits = (uint32_t)td_read_number(from, sizeof(float));
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Reads the answer of a prologue about a contact. */
static bool read_answer(td_reader *from, thud_contact_settings *settings) {
    unsigned answer = td_read_byte(from);
    if (answer & TD_ANSWER_SETTINGS) {
        settings->friction = read_float(from);
        settings->restitution = read_float(from);
        settings->surface_speed = read_float(from);
    }
    return answer & TD_ANSWER_YES;
}

/* ---- the callbacks ---- */

static bool play_prologue(thud_world *w, const thud_contact *contact,
                          thud_contact_settings *settings, void *context) {
    (void)w;
    (void)contact;
    td_play *p = context;
    bool yes = true;
    if (enter(p)) {
        yes = read_answer(&p->from, settings);
        leave(p);
    }
    return yes;
}

static void play_epilogue(thud_world *w, const thud_contact *contact, void *context) {
    (void)w;
    (void)contact;
    play(context);
}

static void play_prologue_all(thud_world *w, const thud_contact *contacts,
                              thud_contact_answer *answers, int count, void *context) {
    (void)w;
    (void)contacts;
    td_play *p = context;
    if (!enter(p)) {
        return;
    }
    uint64_t at = 0;
    for (uint64_t changed = td_read_count(&p->from); changed > 0 && !p->from.broken; changed--) {
        at += td_read_count(&p->from);
        thud_contact_settings settings = {0};
        bool there = at < (uint64_t)count;
        bool yes = read_answer(&p->from, there ? &answers[at].settings : &settings);
        if (there) {
            answers[at].collide = yes;
        }
        p->differs |= !there;
    }
    leave(p);
}

static void play_epilogue_all(thud_world *w, const thud_contact *contacts, int count,
                              void *context) {
    (void)w;
    (void)contacts;
    (void)count;
    play(context);
}

static bool play_filter(const thud_world *w, thud_shape_id a, thud_shape_id b, void *context) {
    (void)w;
    (void)a;
    (void)b;
    return ask(context, true);
}

static void play_step_call(thud_world *w, void *context) {
    (void)w;
    play(context);
}

bool td_play_pass(const thud_mover *mover, const thud_mover_hit *hit, thud_vec2 velocity,
                  void *context) {
    (void)mover;
    (void)hit;
    (void)velocity;
    return ask(context, false);
}

/* ---- epilogues of objects: called for all contacts ---- */

static bool wants(const thud_world *w, int shape_a, int shape_b) {
    (void)w;
    (void)shape_a;
    (void)shape_b;
    return true;
}

/* thud_world.listeners.objects points to the player here, not to a list of objects. */
static void tell(thud_world *w, const thud_contact *seen) {
    (void)seen;
    play((td_play *)(void *)w->listeners->objects);
}

static bool prune(thud_world *w) {
    (void)w;
    return true;
}

static void end(thud_world *w) {
    w->listeners->objects = NULL;
}

static const td_object_hooks OBJECT_HOOKS = {.wants = wants,
                                             .tell = tell,
                                             .prune = prune,
                                             .end = end};

/* ---- setting them ---- */

static thud_listeners listeners_of(td_play *p, unsigned calls, uint32_t without) {
    return (
        thud_listeners){.prologue = calls & TD_CALLS_PROLOGUE ? play_prologue : NULL,
                        .epilogue = calls & TD_CALLS_EPILOGUE ? play_epilogue : NULL,
                        .prologue_all = calls & TD_CALLS_PROLOGUE_ALL ? play_prologue_all : NULL,
                        .epilogue_all = calls & TD_CALLS_EPILOGUE_ALL ? play_epilogue_all : NULL,
                        .context = p,
                        .without = without};
}

bool td_play_set_callbacks(td_play *p, unsigned calls, uint32_t without) {
    thud_world *w = p->world;
    if (!td_listeners_make(w)) {
        return false;
    }
    td_listeners *l = w->listeners;
    bool objects = calls & TD_CALLS_OBJECTS;
    l->calls = listeners_of(p, calls, without);
    l->object_hooks = objects ? &OBJECT_HOOKS : NULL;
    l->objects = objects ? (struct td_objects *)(void *)p : NULL;
    w->asks = l->calls.prologue || l->calls.prologue_all;
    td_listeners_update(w);
    w->rules->filter = calls & TD_CALLS_FILTER ? play_filter : NULL;
    w->rules->filter_context = p;
    return true;
}

/* ---- calls that pass callbacks ---- */

#define ARGUMENT(type, i) (*(type const *)d->args[i])

thud_result td_play_world_advance_with(td_play *p, thud_world *w, const td_decoded *d) {
    thud_step_calls calls = {.before = d->calls & TD_CALLS_BEFORE ? play_step_call : NULL,
                             .after = d->calls & TD_CALLS_AFTER ? play_step_call : NULL,
                             .context = p};
    return thud_world_advance_with(w, ARGUMENT(double, 0), ARGUMENT(int, 1),
                                   d->calls ? &calls : NULL, NULL, NULL);
}

thud_result td_play_world_set_filter(td_play *p, thud_world *w, const td_decoded *d) {
    return thud_world_set_filter(w, d->calls ? play_filter : NULL, p);
}

thud_result td_play_world_set_listeners(td_play *p, thud_world *w, const td_decoded *d) {
    thud_listeners listeners = listeners_of(p, d->calls, d->without);
    return thud_world_set_listeners(w, &listeners);
}

thud_result td_play_mover_move(td_play *p, thud_world *w, const td_decoded *d) {
    const thud_mover *given = ARGUMENT(thud_mover *, 0);
    if (!given) {
        return THUD_ERROR_NULL;
    }
    thud_mover mover = *given;
    mover.context = p;
    return thud_mover_move(w, &mover, ARGUMENT(thud_vec2, 1), ARGUMENT(double, 2), NULL);
}
