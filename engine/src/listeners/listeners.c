/* listeners.c: runs the prologues and epilogues (pre-solve and post-solve callbacks) of
 * thud_listeners.h, for one contact at a time or for all in one call.
 *
 * A prologue's answer holds for one step. A lane whose settings are not its pair's own is marked
 * TD_LANE_ALTERED, and one that the prologue has vetoed TD_LANE_REFUSED (td_lane_marks.rule); the
 * next step starts from the pair's own settings again. */
#include "listeners/listeners.h"

#include "constraint/lanes.h"
#include "contact/contact.h"
#include "detection/collide.h"
#include "listeners/listener_hooks.h"
#include "listeners/seen.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/shape.h"
#include "state/surface.h"

#include <string.h>

static bool settings_equal(const thud_contact_settings *a, const thud_contact_settings *b) {
    return a->friction == b->friction && a->restitution == b->restitution &&
           a->surface_speed == b->surface_speed;
}

/* Whether the settings are in range; the reason is in *why where not. */
static bool settings_valid(const thud_world *w, td_reason *why, const thud_contact_settings *s) {
    double max_speed = (double)(THUD_SURFACE_SPEED_MAX * w->length_scale);
    return td_in(why, "prologue: friction", (double)s->friction, 0.0, (double)THUD_FRICTION_MAX) &&
           td_in(why, "prologue: restitution", (double)s->restitution, 0.0,
                 (double)THUD_PAIR_RESTITUTION_MAX) &&
           td_in(why, "prologue: surface_speed", (double)s->surface_speed, -max_speed, max_speed);
}

/* Copies the settings of an answer; refuses those out of range, and leaves *settings unchanged. */
static void accept(const thud_world *w, const thud_contact_settings *answer,
                   thud_contact_settings *settings) {
    if (settings_equal(answer, settings)) {
        return;
    }
    td_reason why;
    if (!settings_valid(w, &why, answer)) {
        td_refuse(w, THUD_ERROR_INVALID, why.text);
    } else if (answer->restitution > 0.0f && !w->restitution_hooks) {
        td_refuse(w, THUD_ERROR_INVALID, TD_NO_RESTITUTION("prologue: "));
    } else {
        *settings = *answer;
    }
}

/* td_listener_hooks.ask_one. */
static bool run_prologue_for_impact(thud_world *w, const thud_contact *seen,
                                    thud_contact_settings *settings) {
    const thud_listeners *calls = &w->listeners->calls;
    thud_contact_answer answer = {*settings, true};
    w->listeners->asked = (td_question){.contacts = seen, .count = 1, .impact = true};
    if (calls->prologue) {
        answer.collide = calls->prologue(w, seen, &answer.settings, calls->context);
    } else {
        calls->prologue_all(w, seen, &answer, 1, calls->context);
    }
    w->listeners->asked.count = 0;
    accept(w, &answer.settings, settings);
    return answer.collide;
}

/* ---- all contacts that touch ---- */

/* A lane whose contact a listener is called for. */
typedef struct lane {
    td_block *block;
    int points, index;         /* points of the block's kind; index of the lane */
    const td_seen_block *seen; /* what listeners see of the block's lanes */
    uint32_t tag, without;     /* td_tag(w, 0); bits of thud_contact_part not to fill in */
    double from_fixed;
} lane;

TD_INLINE thud_body_id body_handle(const thud_world *w, td_body_index body, uint32_t tag) {
    return (thud_body_id){(uint32_t)body.at + 1, td_body_at(w, body)->generation + tag};
}

/* Fills in the public view of a lane's contact. Fields that the listeners do not want
 * (thud_listeners.without) stay zero. Impulses stay zero before the solve: the lane then still has
 * those of an earlier step. `from_fixed` times a position is exact, since to_fixed is a power of
 * two. */
TD_INLINE void fill_contact(const thud_world *w, const lane *l, bool solved, thud_contact *c) {
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

/* The settings of the lane's pair, without the answer of the last step. */
TD_INLINE thud_contact_settings pair_settings(const thud_world *w, const lane *l) {
    return l->block->mark[l->index].rule & TD_LANE_ALTERED
               ? td_surface_of_pair(w, l->block->shape_a[l->index], l->block->shape_b[l->index])
               : td_surface_get(l->block, l->points, l->index);
}

/* Stores the normal velocity of the lane's points, which the restitution pass needs and which is
 * only kept in lanes that had restitution before. */
static void store_normal_velocity(const thud_world *w, const lane *l) {
    for (int k = 0; k < l->points; k++) {
        td_history_of(l->block, l->points)[k].normal_velocity[l->index] =
            -td_contact_closing_speed(w, l->block, &l->block->point[k], l->index);
    }
}

/* Applies an answer that differs from the pair's own settings, or follows one that did: sets the
 * lane's marks, settings and veto. The lane is passed by value: no pointer to the lane of the
 * calling loop exists, so that the compiler can keep that lane in registers. */
static void apply_answer(thud_world *w, lane one, const thud_contact_settings *own,
                         const thud_contact_settings *settings, bool yes) {
    const lane *l = &one;
    unsigned mark = l->block->mark[l->index].rule & ~(unsigned)(TD_LANE_ALTERED | TD_LANE_REFUSED);
    mark |= (settings_equal(settings, own) ? 0u : TD_LANE_ALTERED) | (yes ? 0u : TD_LANE_REFUSED);
    l->block->mark[l->index].rule = (uint16_t)mark;
    td_surface_set(w, l->block, l->points, l->index, settings);
    if (settings->restitution != own->restitution) {
        store_normal_velocity(w, l);
    }
    td_contact *contact = td_contact_at(w, l->block->constraint[l->index]);
    contact->vetoed = (uint8_t)((contact->vetoed & TD_HELD) | (yes ? 0 : TD_VETOED));
    if (!yes) {
        td_surface_mute(l->block, l->points, l->index);
    }
}

/* Applies an answer. Nothing is to be done in the common case, that the answer is the pair's own
 * settings in this step and was so in the last one. */
TD_INLINE void apply_if_changed(thud_world *w, const lane *l, const thud_contact_settings *own,
                                const thud_contact_settings *answer, bool yes) {
    bool was_yes = !(l->block->mark[l->index].rule & (TD_LANE_ALTERED | TD_LANE_REFUSED));
    if (!(was_yes && yes && memcmp(own, answer, sizeof *own) == 0)) {
        thud_contact_settings settings = *own;
        accept(w, answer, &settings);
        apply_answer(w, *l, own, &settings, yes);
    }
}

/* Whether the prologue has just decided the velocities of the contact with this number. */
static bool is_decided(const thud_world *w, int number) {
    const td_decisions *all = w->decisions;
    return all && all->list.count > 0 &&
           TD_AT(td_decision, &all->list, all->list.count - 1)->number == number;
}

/* Calls the epilogues for one contact: that of the world, where it is called for one at a time,
 * then those of objects. */
TD_INLINE void tell_one(thud_world *w, const thud_contact *seen) {
    const td_listeners *l = w->listeners;
    if (l->calls.epilogue) {
        l->calls.epilogue(w, seen, l->calls.context);
    }
    if (l->tells_objects) {
        l->object_hooks->tell(w, seen);
    }
}

/* Whether no epilogue is called for the lane's contact: the world has none for all contacts, and
 * neither object of the pair has one. */
TD_INLINE bool is_unheard(const thud_world *w, const lane *l) {
    const td_listeners *listeners = w->listeners;
    return !listeners->calls.epilogue &&
           !listeners->object_hooks->wants(w, l->block->shape_a[l->index],
                                           l->block->shape_b[l->index]);
}

/* What `visit` does with each contact. The order matters: from TELL on the step has been solved. */
typedef enum visit_purpose {
    ASK,            /* calls the prologue, and applies its answer */
    LIST_QUESTIONS, /* lists the contact and a default answer for prologue_all */
    TAKE_ANSWERS,   /* applies the answers of prologue_all */
    TELL,           /* calls the epilogues */
    LIST_SOLVED     /* lists the contact for epilogue_all */
} visit_purpose;

/* Does with one lane what `purpose` says. `number`: of this lane among the visited ones; `seen`:
 * memory for the contact as listeners see it. */
TD_INLINE void visit_lane(thud_world *w, const lane *l, int number, visit_purpose purpose,
                          thud_contact *seen) {
    td_listeners *listeners = w->listeners;
    const thud_listeners *calls = &listeners->calls;
    thud_contact_settings own = {0};
    if (purpose == TELL && is_unheard(w, l)) {
        return;
    }
    if (purpose <= TAKE_ANSWERS) {
        own = pair_settings(w, l);
    }
    if (purpose != TAKE_ANSWERS) {
        fill_contact(w, l, purpose > TAKE_ANSWERS, seen);
    }
    switch (purpose) {
    case ASK: {
        thud_contact_settings answer = own;
        listeners->asked = (td_question){.contacts = seen, .count = 1, .number = number};
        bool yes = calls->prologue(w, seen, &answer, calls->context) && !is_decided(w, number);
        apply_if_changed(w, l, &own, &answer, yes);
        break;
    }
    case LIST_QUESTIONS:
        *TD_AT(thud_contact, &listeners->contacts, number) = *seen;
        *TD_AT(thud_contact_answer, &listeners->answers, number) = (thud_contact_answer){own, true};
        break;
    case TAKE_ANSWERS: {
        const thud_contact_answer *answer = TD_AT(thud_contact_answer, &listeners->answers, number);
        apply_if_changed(w, l, &own, &answer->settings, answer->collide);
        break;
    }
    case TELL:
        tell_one(w, seen);
        break;
    case LIST_SOLVED:
        *TD_AT(thud_contact, &listeners->contacts, number) = *seen;
    }
}

/* Whether a one-way rule lets the lane's pair pass through each other. */
static bool is_passing(const thud_world *w, const td_block *block, int index) {
    return td_contact_at(w, block->constraint[index])->vetoed & TD_PASSING;
}

/* Visits the lanes of all touching contacts; returns how many. Callbacks may create bodies and
 * shapes, so that no pointer into their arrays is kept across calls. */
TD_INLINE int visit(thud_world *w, visit_purpose purpose) {
    td_see_fn *see = &TD_PICK_WIDE(w, td_see_block);
    /* Epilogues of objects get all fields, whatever `without` says. Of a decided contact they get
     * what the prologue was given, so that it too is then given all fields. */
    unsigned without = w->listeners->tells_objects ? 0 : w->listeners->calls.without;
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
                /* After the solve, a lane without points (vetoed, or let through by a rule) is left
                 * out: no epilogue is called for it. Before the solve, the prologue is asked again
                 * about a lane that it vetoed in the last step, but not about one that a rule lets
                 * through. */
                if (seen.points[l.index] || (purpose < TELL && !is_passing(w, l.block, l.index))) {
                    visit_lane(w, &l, number++, purpose, &contact);
                }
            }
        }
    }
    return number;
}

/* Turns the answers of decided contacts into vetoes, so that the solver leaves these contacts
 * alone: apply in decide.c sets their velocities. */
static void mark_decided(const thud_world *w) {
    const td_decisions *all = w->decisions;
    for (int i = 0; all && i < all->list.count; i++) {
        int number = TD_AT(td_decision, &all->list, i)->number;
        TD_AT(thud_contact_answer, &w->listeners->answers, number)->collide = false;
    }
}

/* td_listener_hooks.ask. */
static void run_prologue(thud_world *w) {
    td_listeners *l = w->listeners;
    if (l->calls.prologue) {
        visit(w, ASK);
    } else {
        int count = visit(w, LIST_QUESTIONS);
        l->asked = (td_question){.contacts = l->contacts.data, .count = count};
        l->calls.prologue_all(w, l->contacts.data, l->answers.data, count, l->calls.context);
        mark_decided(w);
        visit(w, TAKE_ANSWERS);
    }
    l->asked.count = 0;
    if (w->decisions) {
        w->decisions->apply(w);
    }
}

/* Calls the epilogues for a contact that has no lane, or lists it for epilogue_all. */
static void tell_or_list(thud_world *w, const thud_contact *seen, int *count) {
    td_listeners *l = w->listeners;
    if (l->calls.epilogue_all) {
        *TD_AT(thud_contact, &l->contacts, (*count)++) = *seen;
    } else {
        tell_one(w, seen);
    }
}

/* td_listener_hooks.tell: first the contacts that were solved, then those whose velocities were
 * decided, then the impacts that detection has resolved. */
static void run_epilogue(thud_world *w) {
    td_listeners *l = w->listeners;
    int count = l->calls.epilogue_all ? visit(w, LIST_SOLVED) : visit(w, TELL);
    for (int i = 0; w->decisions && i < w->decisions->list.count; i++) {
        tell_or_list(w, &TD_AT(td_decision, &w->decisions->list, i)->seen, &count);
    }
    for (int i = 0; i < w->scratch.impacts.count; i++) {
        tell_or_list(w, &TD_AT(td_impact, &w->scratch.impacts, i)->seen, &count);
    }
    if (l->calls.epilogue_all) {
        l->calls.epilogue_all(w, l->contacts.data, count, l->calls.context);
        for (int i = 0; l->tells_objects && i < count; i++) {
            l->object_hooks->tell(w, TD_AT(thud_contact, &l->contacts, i));
        }
    }
}

/* td_listener_hooks.reserve. It also empties the lists of the step before. There are at most as
 * many impacts as the step's detection has reserved room for. */
static bool reserve(thud_world *w) {
    td_listeners *l = w->listeners;
    td_listeners_update(w);
    if (w->decisions) {
        w->decisions->list.count = 0;
    }
    int touching = w->touching, impacts = w->scratch.impacts.capacity;
    int max = l->calls.epilogue_all ? touching + impacts : l->calls.prologue_all ? touching : 0;
    return td_array_reserve(&w->memory, &l->contacts, max) &&
           td_array_reserve(&w->memory, &l->answers, l->calls.prologue_all ? touching : 0);
}

/* td_listener_hooks.end. */
static void end(thud_world *w) {
    td_array_free(&w->memory, &w->listeners->contacts);
    td_array_free(&w->memory, &w->listeners->answers);
    if (w->listeners->objects) {
        w->listeners->object_hooks->end(w);
    }
    if (w->decisions) {
        td_array_free(&w->memory, &w->decisions->list);
        td_memory_put(&w->memory, w->decisions, sizeof *w->decisions);
    }
    td_memory_put(&w->memory, w->listeners, sizeof *w->listeners);
}

static const td_listener_hooks HOOKS = {.reserve = reserve,
                                        .ask = run_prologue,
                                        .ask_one = run_prologue_for_impact,
                                        .tell = run_epilogue,
                                        .end = end};

/* ---- setting the listeners ---- */

void td_listeners_update(thud_world *w) {
    td_listeners *l = w->listeners;
    l->tells_objects = l->objects && l->object_hooks->prune(w);
    w->tells = l->calls.epilogue || l->calls.epilogue_all || l->tells_objects;
}

bool td_listeners_make(thud_world *w) {
    if (!w->listeners) {
        w->listeners = td_memory_get(&w->memory, sizeof *w->listeners);
        if (!w->listeners) {
            return false;
        }
        w->listeners->contacts.stride = (int)sizeof(thud_contact);
        w->listeners->answers.stride = (int)sizeof(thud_contact_answer);
        w->listener_hooks = &HOOKS;
        w->sweep_is_vetoed = td_sweep_is_vetoed;
    }
    return true;
}

/* Gives every lane that an answer had changed its pair's own settings back. */
static void reset_answers(thud_world *w) {
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
    TD_IN_OWN_FLOAT_MODE;
    const thud_listeners none = {0}, *calls = listeners ? listeners : &none;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "listeners: not inside a callback");
    }
    if ((calls->prologue && calls->prologue_all) || (calls->epilogue && calls->epilogue_all)) {
        return td_refuse(w, THUD_ERROR_INVALID, "listeners: a prologue or epilogue of both forms");
    }
    if (calls->without & ~(uint32_t)(THUD_CONTACT_BODIES | THUD_CONTACT_POINT)) {
        return td_refuse(w, THUD_ERROR_INVALID, "listeners: without is of thud_contact_part");
    }
    if (!td_listeners_make(w)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "listeners: out of memory");
    }
    bool had_prologue = w->asks;
    reset_answers(w);
    w->listeners->calls = *calls;
    w->asks = calls->prologue || calls->prologue_all;
    td_listeners_update(w);
    if (had_prologue || w->asks) {
        td_wake_all(w);
    }
    return THUD_OK;
}
