/* listeners.c: asks prologues and tells epilogues; see thud_listeners.h.
 *
 * A lane's settings are its pair's own until a prologue wants others, and then again from the next
 * step on: the marks of lanes say which. */
#include "thud/thud_listeners.h"

#include "constraint/lanes.h"
#include "contact/contact.h"
#include "detection/collide.h"
#include "listeners/listener_hooks.h"
#include "listeners/seen.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/surface.h"

#include <string.h>

/* The listeners of a world, and what they are asked and told at once. */
typedef struct td_listeners {
    thud_listeners told;
    td_array contacts; /* thud_contact */
    td_array answers;  /* thud_contact_answer */
} td_listeners;

static bool same(const thud_contact_settings *a, const thud_contact_settings *b) {
    return a->friction == b->friction && a->restitution == b->restitution &&
           a->surface_speed == b->surface_speed;
}

static bool valid(const thud_world *w, td_reason *why, const thud_contact_settings *s) {
    double fastest = (double)(THUD_SURFACE_SPEED_MAX * w->unit);
    return td_in(why, "prologue: friction", (double)s->friction, 0.0, (double)THUD_FRICTION_MAX) &&
           td_in(why, "prologue: restitution", (double)s->restitution, 0.0,
                 (double)THUD_BOUNCE_MAX) &&
           td_in(why, "prologue: surface_speed", (double)s->surface_speed, -fastest, fastest);
}

/* What is out of range is refused, and the pair keeps what it had. */
static void accept(const thud_world *w, const thud_contact_settings *wanted,
                   thud_contact_settings *settings) {
    if (same(wanted, settings)) {
        return;
    }
    td_reason why;
    if (valid(w, &why, wanted)) {
        *settings = *wanted;
    } else {
        td_refuse(w, THUD_ERROR_INVALID, why.text);
    }
}

/* Asks about one by itself. */
static bool ask_one(thud_world *w, const thud_contact *seen, thud_contact_settings *settings) {
    const thud_listeners *told = &w->listeners->told;
    thud_contact_answer wanted = {*settings, true};
    if (told->prologue) {
        wanted.collide = told->prologue(w, seen, &wanted.settings, told->context);
    } else {
        told->prologue_all(w, seen, &wanted, 1, told->context);
    }
    accept(w, &wanted.settings, settings);
    return wanted.collide;
}

/* ---- all that touch ---- */

/* One that is asked about or told of. */
typedef struct lane {
    td_block *block;
    int points, index;         /* points: that the block has */
    const td_seen_block *seen; /* the block */
    uint32_t tag, without;     /* of thud_contact_part */
    double from_fixed;
} lane;

TD_INLINE thud_body_id body_handle(const thud_world *w, td_body_index body, uint32_t tag) {
    return (thud_body_id){(uint32_t)body.at + 1, td_body_at(w, body)->generation + tag};
}

/* Of td_position a caller's unit is a power of two: products with its inverse are exact. What
 * listeners do without stays zero, and so do the impulses of who is asked: those that a lane has
 * are of a step before, whichever it was that added them up. */
TD_INLINE void view(const thud_world *w, const lane *l, bool solved, thud_contact *c) {
    const td_block *block = l->block;
    int k = l->index, a = block->shape_a[k], b = block->shape_b[k];
    const td_shape *shape_a = td_shape_at(w, a), *shape_b = td_shape_at(w, b);
    c->shape_a = (thud_shape_id){(uint32_t)a + 1, shape_a->generation + l->tag};
    c->shape_b = (thud_shape_id){(uint32_t)b + 1, shape_b->generation + l->tag};
    c->normal = (thud_vec2){block->nx[k], block->ny[k]};
    c->separation = l->seen->separation[k];
    c->point_count = l->seen->points[k];
    if (solved) {
        c->normal_impulse = l->seen->normal_impulse[k];
        c->tangent_impulse = l->seen->tangent_impulse[k];
    }
    if (!(l->without & THUD_CONTACT_BODIES)) {
        c->body_a = body_handle(w, shape_a->body, l->tag);
        c->body_b = body_handle(w, shape_b->body, l->tag);
    }
    if (!(l->without & THUD_CONTACT_POINT)) {
        const td_pose *pose = td_pose_at(w, shape_b->body);
        c->point.x = (double)(pose->center.x + l->seen->x[k / 4][k % 4]) * l->from_fixed;
        c->point.y = (double)(pose->center.y + l->seen->y[k / 4][k % 4]) * l->from_fixed;
    }
}

TD_INLINE thud_contact_settings own_of(const thud_world *w, const lane *l) {
    return l->block->mark[l->index].rule & TD_LANE_ALTERED
               ? td_surface_of_pair(w, l->block->shape_a[l->index], l->block->shape_b[l->index])
               : td_surface_get(l->block, l->points, l->index);
}

/* Lanes that did not bounce before may not know how fast they close in. */
static void note_approach(const thud_world *w, const lane *l) {
    for (int k = 0; k < l->points; k++) {
        td_history_of(l->block, l->points)[k].approach[l->index] =
            -td_contact_closing(w, l->block, &l->block->point[k], l->index);
    }
}

/* Where this answer or the last one was not just yes. It has a lane of its own: that of the loop,
 * whose address nobody else is given, then stands in registers. */
static void heed(thud_world *w, lane one, const thud_contact_settings *own,
                 const thud_contact_settings *settings, bool yes) {
    const lane *l = &one;
    unsigned mark = l->block->mark[l->index].rule & ~(unsigned)(TD_LANE_ALTERED | TD_LANE_REFUSED);
    mark |= (same(settings, own) ? 0u : TD_LANE_ALTERED) | (yes ? 0u : TD_LANE_REFUSED);
    l->block->mark[l->index].rule = (uint16_t)mark;
    td_surface_set(w, l->block, l->points, l->index, settings);
    if (settings->restitution != own->restitution) {
        note_approach(w, l);
    }
    td_contact *contact = td_contact_at(w, l->block->constraint[l->index]);
    contact->vetoed = (uint8_t)((contact->vetoed & TD_HELD) | (yes ? 0 : TD_VETOED));
    if (!yes) {
        td_surface_mute(l->block, l->points, l->index);
    }
}

TD_INLINE void take_answer(thud_world *w, const lane *l, const thud_contact_settings *own,
                           const thud_contact_settings *wanted, bool yes) {
    bool was_yes = !(l->block->mark[l->index].rule & (TD_LANE_ALTERED | TD_LANE_REFUSED));
    if (!(was_yes && yes && memcmp(own, wanted, sizeof *own) == 0)) {
        thud_contact_settings settings = *own;
        accept(w, wanted, &settings);
        heed(w, *l, own, &settings, yes);
    }
}

/* What is done with each lane. */
typedef enum visit_purpose { ASK, LIST_QUESTIONS, TAKE_ANSWERS, TELL, LIST_SOLVED } visit_purpose;

TD_INLINE void visit_lane(thud_world *w, const lane *l, int number, visit_purpose purpose,
                          thud_contact *seen) {
    td_listeners *listeners = w->listeners;
    const thud_listeners *told = &listeners->told;
    thud_contact_settings own = {0};
    if (purpose <= TAKE_ANSWERS) {
        own = own_of(w, l);
    }
    if (purpose != TAKE_ANSWERS) {
        view(w, l, purpose > TAKE_ANSWERS, seen);
    }
    switch (purpose) {
    case ASK: {
        thud_contact_settings wanted = own;
        bool yes = told->prologue(w, seen, &wanted, told->context);
        take_answer(w, l, &own, &wanted, yes);
        break;
    }
    case LIST_QUESTIONS:
        *TD_AT(thud_contact, &listeners->contacts, number) = *seen;
        *TD_AT(thud_contact_answer, &listeners->answers, number) = (thud_contact_answer){own, true};
        break;
    case TAKE_ANSWERS: {
        const thud_contact_answer *answer = TD_AT(thud_contact_answer, &listeners->answers, number);
        take_answer(w, l, &own, &answer->settings, answer->collide);
        break;
    }
    case TELL:
        told->epilogue(w, seen, told->context);
        break;
    case LIST_SOLVED:
        *TD_AT(thud_contact, &listeners->contacts, number) = *seen;
    }
}

static bool is_passing(const thud_world *w, const td_block *block, int index) {
    return td_contact_at(w, block->constraint[index])->vetoed & TD_PASSING;
}

/* Visits the lanes to ask about, or, where they have been solved, to tell of; returns how many. A
 * callback may make bodies: arrays of them may move. */
TD_INLINE int visit(thud_world *w, visit_purpose purpose) {
    td_see_fn *see = &TD_PICK_WIDE(w, td_see_block);
    unsigned without = w->listeners->told.without;
    td_seeing how = {.solved = purpose >= TELL,
                     .places = purpose != TAKE_ANSWERS && !(without & THUD_CONTACT_POINT),
                     .skin = w->skin,
                     .to_fixed = w->to_fixed};
    td_seen_block seen;
    thud_contact contact = {0};
    lane l = {.seen = &seen,
              .tag = td_tag(w, 0),
              .without = without,
              .from_fixed = 1.0 / w->to_fixed};
    int number = 0;
    for (int r = 0; r < w->scratch.runs.count; r++) {
        td_run run = *TD_AT(td_run, &w->scratch.runs, r);
        l.points = td_form_points(w->kinds[run.kind]->form);
        for (int i = 0; i < run.count && run.kind < TD_PAIR_COUNT; i++) {
            l.block = *TD_AT(td_block *, &w->scratch.blocks, run.first + i);
            see(l.block, l.points, &how, &seen);
            for (l.index = 0; l.index < l.block->used; l.index++) {
                /* A rule that lets a pair through leaves it no points. */
                if (seen.points[l.index] || (purpose < TELL && !is_passing(w, l.block, l.index))) {
                    visit_lane(w, &l, number++, purpose, &contact);
                }
            }
        }
    }
    return number;
}

static void ask(thud_world *w) {
    td_listeners *l = w->listeners;
    if (l->told.prologue) {
        visit(w, ASK);
    } else {
        int count = visit(w, LIST_QUESTIONS);
        l->told.prologue_all(w, l->contacts.data, l->answers.data, count, l->told.context);
        visit(w, TAKE_ANSWERS);
    }
}

static void tell(thud_world *w) {
    td_listeners *l = w->listeners;
    bool each = l->told.epilogue != NULL;
    int count = each ? visit(w, TELL) : visit(w, LIST_SOLVED);
    for (int i = 0; i < w->scratch.impacts.count; i++) {
        const thud_contact *seen = &TD_AT(td_impact, &w->scratch.impacts, i)->seen;
        if (each) {
            l->told.epilogue(w, seen, l->told.context);
        } else {
            *TD_AT(thud_contact, &l->contacts, count++) = *seen;
        }
    }
    if (!each) {
        l->told.epilogue_all(w, l->contacts.data, count, l->told.context);
    }
}

/* Impacts of the step are listed where its detection has reserved room for them. */
static bool reserve(thud_world *w) {
    td_listeners *l = w->listeners;
    int touching = w->touching, impacts = w->scratch.impacts.capacity;
    int most = l->told.epilogue_all ? touching + impacts : l->told.prologue_all ? touching : 0;
    return td_array_reserve(&w->memory, &l->contacts, most) &&
           td_array_reserve(&w->memory, &l->answers, l->told.prologue_all ? touching : 0);
}

static void end(thud_world *w) {
    td_array_free(&w->memory, &w->listeners->contacts);
    td_array_free(&w->memory, &w->listeners->answers);
    td_memory_put(&w->memory, w->listeners, sizeof *w->listeners);
}

static const td_listener_hooks LISTENING = {
    .reserve = reserve, .ask = ask, .ask_one = ask_one, .tell = tell, .end = end};

/* ---- who listens ---- */

/* What the last prologue wanted holds no longer. */
static void restore(thud_world *w) {
    for (int i = 0; i < w->constraints.count; i++) {
        td_constraint *contact = td_constraint_at(w, i);
        if (contact->live && td_is_contact(contact) && contact->state == TD_TOUCHING) {
            td_lane at = td_lane_of(w, contact);
            uint16_t *mark = &at.block->mark[at.lane].rule;
            if (*mark & (TD_LANE_ALTERED | TD_LANE_REFUSED)) {
                td_contact_settle(w, at.block, at.lane, i);
                *mark &= (uint16_t) ~(TD_LANE_ALTERED | TD_LANE_REFUSED);
                contact->vetoed &= TD_HELD | TD_PASSING;
            }
        }
    }
}

thud_result thud_world_set_listeners(thud_world *w, const thud_listeners *listeners) {
    TD_IN_OWN_MODE;
    const thud_listeners none = {0}, *told = listeners ? listeners : &none;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "listeners: not inside a callback");
    }
    if ((told->prologue && told->prologue_all) || (told->epilogue && told->epilogue_all)) {
        return td_refuse(w, THUD_ERROR_INVALID, "listeners: a prologue or epilogue of both forms");
    }
    if (told->without & ~(uint32_t)(THUD_CONTACT_BODIES | THUD_CONTACT_POINT)) {
        return td_refuse(w, THUD_ERROR_INVALID, "listeners: without is of thud_contact_part");
    }
    if (!w->listeners) {
        w->listeners = td_memory_get(&w->memory, sizeof *w->listeners);
        if (!w->listeners) {
            return td_refuse(w, THUD_ERROR_MEMORY, "listeners: out of memory");
        }
        w->listeners->contacts.stride = (int)sizeof(thud_contact);
        w->listeners->answers.stride = (int)sizeof(thud_contact_answer);
        w->listener_hooks = &LISTENING;
    }
    bool asked = w->asks;
    restore(w);
    w->listeners->told = *told;
    w->asks = told->prologue || told->prologue_all;
    w->tells = told->epilogue || told->epilogue_all;
    if (asked || w->asks) {
        td_wake_all(w);
    }
    return THUD_OK;
}
