/* impulses.c: events of contacts whose normal impulse, summed over the step, exceeds event_impulse
 * of their rule; see thud_world_get_impulse_events in thud_rules.h. */
#include "detection/collide.h"
#include "constraint/lanes.h"
#include "contact/contact.h"
#include "rules/rules.h"

/* Reserves memory for an event of each touching lane and of each impact; the step's detection has a
 * maximum number of impacts. False when memory is short. */
bool td_rules_reserve(thud_world *w) {
    return !w->adds_impulses || td_array_reserve(&w->memory, &w->rules->impulses,
                                                 w->touching + w->scratch.impacts.capacity);
}

/* Adds the event of a contact; memory has been reserved. */
static void add_event(thud_world *w, const thud_contact *seen) {
    TD_PUSH(thud_impulse_event, &w->rules->impulses) =
        (thud_impulse_event){seen->shape_a, seen->shape_b, seen->point, seen->normal,
                             seen->normal_impulse};
}

/* Adds the events of a block's lanes. Compares with the lowest threshold of all rules first, since
 * few lanes exceed it. */
static void add_events_of_block(thud_world *w, td_block *block, int points) {
    const td_point_history *history = td_history_of(block, points);
    for (int lane = 0; lane < block->used; lane++) {
        float impulse = history[0].total[lane] + (points == 2 ? history[1].total[lane] : 0.0f);
        if (impulse > w->rules->min_bound) {
            const td_rule *rule = td_rule_of_lane(w, block, lane, TD_RULE_IMPULSE);
            if (rule && impulse > rule->rule.event_impulse) {
                thud_contact seen = td_contact_view(w, block, lane);
                add_event(w, &seen);
            }
        }
    }
}

/* Adds the events of the step: those of solved lanes, then those of impacts within the step. */
void td_rules_tell(thud_world *w) {
    for (int r = 0; r < w->scratch.runs.count && w->adds_impulses; r++) {
        const td_run *run = TD_AT(td_run, &w->scratch.runs, r);
        int points = td_form_points(w->kinds[run->kind]->form);
        for (int i = 0; i < run->count && run->kind < TD_PAIR_COUNT; i++) {
            add_events_of_block(w, *TD_AT(td_block *, &w->scratch.blocks, run->first + i), points);
        }
    }
    for (int i = 0; i < w->scratch.impacts.count && w->adds_impulses; i++) {
        const thud_contact *seen = &TD_AT(td_impact, &w->scratch.impacts, i)->seen;
        const td_rule *rule =
            td_rule_of_pair(w, (int)seen->shape_a.index1 - 1, (int)seen->shape_b.index1 - 1);
        if (rule && seen->normal_impulse > rule->rule.event_impulse) {
            add_event(w, seen);
        }
    }
}

thud_result thud_world_get_impulse_events(const thud_world *w, const thud_impulse_event **out,
                                          int *out_count) {
    if (!w || !out || !out_count) {
        return THUD_ERROR_NULL;
    }
    const td_array *events = !w->rules    ? NULL
                             : w->gathers ? &w->gathered.impulses
                                          : &w->rules->impulses;
    *out = events ? events->data : NULL;
    *out_count = events ? events->count : 0;
    return THUD_OK;
}
