/* changes.c: the first stage of a step: applies the change list. For each body on it, according to
 * td_body.changes: wakes the bodies that touch it, gives or takes its awake slot, adds and frees
 * shapes, and places shapes anew. All changes of one body are applied, or, when memory is short,
 * none: the body and those after it then stay on the list for the step that is tried again. */
#include "state/awake.h"
#include "state/body.h"
#include "constraint/joint_hooks.h"
#include "contact/contact.h"
#include "constraint/lanes.h"
#include "contact/internal_edges.h"
#include "state/shape.h"
#include "api/step.h"
#include "textures/texture_hooks.h"

#include <string.h>

/* Wakes every sleeping body that has an open contact or a joint with this one. A body that only
 * overlaps a sensor stays asleep, since sensors exert no force; their contact becomes TD_WAITING,
 * so that its overlap is tested again. False when memory is short. */
static bool wake_touching(thud_world *w, td_body_index body) {
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        const td_constraint *constraint = td_constraint_at(w, td_edge_constraint(e));
        if (constraint->kind == TD_PAIR_SENSOR) {
            if (constraint->state == TD_RESTING) {
                td_constraint_wait(w, td_edge_constraint(e));
            }
        } else if ((constraint->open || !td_is_contact(constraint)) &&
                   !td_wake(w, td_other_body(w, e))) {
            return false;
        }
    }
    return true;
}

/* Makes room for the end events of all contacts of the body. False when memory is short. */
static bool reserve_ends(thud_world *w, td_body_index body) {
    int count = 0;
    for (int e = td_body_at(w, body)->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        count++;
    }
    return count == 0 || td_contact_end_reserve(w, count);
}

/* Frees a shape's slot and its line of terrain, and subtracts it from the world's counts. */
static void free_shape(thud_world *w, int index) {
    td_shape *shape = td_shape_at(w, index);
    if (shape->terrain != TD_NONE) {
        td_terrain_record *record = td_terrain_record_at(w, shape->terrain);
        td_array_free(&w->memory, &record->points);
        if (w->texture_hooks) {
            w->texture_hooks->forget(w, shape->terrain);
        }
        record->shape = TD_NONE;
        td_slots_give(&w->terrains, shape->terrain);
    }
    w->thinnest_stale = true;
    w->sensors -= (shape->flags & TD_SHAPE_SENSOR) != 0;
    w->mobile_sensors -=
        (shape->flags & TD_SHAPE_SENSOR) && td_body_at(w, shape->body)->kind == THUD_BODY_DYNAMIC;
    shape->flags = 0;
    *td_marks_at(w, index) = 0;
    shape->generation++;
    td_slots_give(&w->shapes, index);
}

/* Frees a destroyed body with its constraints and shapes. */
static void remove_body(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    td_contacts_destroy(w, index, TD_NONE, true);
    if (body->awake.at > 0) {
        td_awake_remove(w, index);
    }
    for (int i = body->first_shape; i != TD_NONE;) {
        int next = td_shape_at(w, i)->next;
        free_shape(w, i);
        i = next;
    }
    body->changes = 0;
    body->flags = 0;
    body->generation++;
    td_slots_give(&w->bodies, index.at);
}

/* Frees the destroyed shapes of a body, recomputes its mass, settles its shapes (td_shape_settle),
 * and has its lanes compute their manifolds anew in place of reusing those of earlier steps
 * (td_lane_renew). */
static void update_shapes(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    for (int *link = &body->first_shape; *link != TD_NONE;) {
        int i = *link;
        if (td_shape_at(w, i)->flags & TD_SHAPE_LIVE) {
            link = &td_shape_at(w, i)->next;
            continue;
        }
        *link = td_shape_at(w, i)->next;
        td_contacts_destroy(w, index, i, false);
        free_shape(w, i);
        body->shape_count--;
    }
    td_body_weigh(w, index);
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_settle(w, i);
    }
    if (w->internal_edges && body->kind != THUD_BODY_STATIC) {
        w->internal_edges->join(w, index);
    }
    td_awake_refresh(w, index);
    for (int e = body->first_constraint; e != TD_NONE; e = td_next_edge(w, e)) {
        if (td_constraint_at(w, td_edge_constraint(e))->state == TD_TOUCHING) {
            td_lane_renew(w, td_edge_constraint(e));
        }
    }
}

/* After a body was enabled or disabled: its contacts and forces end, and its awake slot follows.
 * Its shapes stay in the broadphase: td_pair_allowed rules out those of a disabled body, and the
 * mark TD_MARK_FRESH makes all pairs of an enabled one new. */
static void apply_enabled(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    bool enabled = !(body->flags & TD_BODY_DISABLED);
    td_contacts_destroy(w, index, TD_NONE, false);
    if (w->joint_hooks) {
        w->joint_hooks->suspend(w, index);
    }
    if (!enabled && body->awake.at > 0) {
        td_awake_remove(w, index);
    } else if (enabled && body->awake.at < 0 && body->kind != THUD_BODY_STATIC) {
        td_awake_add(w, index);
    }
    memset(body->force, 0, sizeof body->force);
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        *td_marks_at(w, i) |= TD_MARK_FRESH;
    }
    td_proxy_set_forget(&w->awake_shapes);
    td_proxy_set_forget(&w->rest_shapes);
}

/* For a body whose detection follows it from collision to collision: extends the fat bounds of its
 * shapes over its expected motion in this step. */
static void extend_bounds(thud_world *w, td_body_index index) {
    const td_body *body = td_body_at(w, index);
    if (body->awake.at < 0 || !body->detection->time_of_impact) {
        return;
    }
    const float *v = td_row(&w->velocity, body->awake);
    float h = (float)w->def.time_step;
    for (int i = body->first_shape; i != TD_NONE; i = td_shape_at(w, i)->next) {
        td_shape_expect(w, i, v[0] * h, v[1] * h);
    }
}

/* Applies all changes of a body. False when memory is short: then all of them are still pending. */
static bool apply_changes(thud_world *w, td_body_index index) {
    td_body *body = td_body_at(w, index);
    int changes = body->changes;
    int edits = TD_CHANGE_LEAVE | TD_CHANGE_SHAPES | TD_CHANGE_PLACE | TD_CHANGE_ENABLE;
    if (!reserve_ends(w, index) ||
        /* A body that has just been created covers no faces of its neighbours yet. */
        ((changes & edits) && !(changes & TD_CHANGE_ENTER) && w->internal_edges &&
         !w->internal_edges->lose(w, index)) ||
        ((changes & edits || body->kind == THUD_BODY_KINEMATIC) && !wake_touching(w, index)) ||
        (changes != TD_CHANGE_SLEEP && !(changes & TD_CHANGE_LEAVE) && !td_wake(w, index))) {
        return false;
    }
    body->changes = 0;
    bool rests = body->awake.at < 0;
    if ((changes & TD_CHANGE_ENTER) && !(changes & TD_CHANGE_LEAVE) &&
        body->kind != THUD_BODY_STATIC && !(body->flags & TD_BODY_DISABLED)) {
        td_awake_add(w, index);
        rests = false;
    }
    if (changes & (edits | TD_CHANGE_ENTER)) {
        td_proxy_set_forget(rests ? &w->rest_shapes : &w->awake_shapes);
        if (w->rest_shapes
                .woken) { /* the set of resting shapes may still contain the shapes of this body */
            td_proxy_set_forget(&w->rest_shapes);
        }
        w->rest_epoch += rests;
    }
    if (changes & TD_CHANGE_LEAVE) {
        remove_body(w, index);
        return true;
    }
    if (changes & TD_CHANGE_ENTER) {
        /* The world gets the body's detection here, and not when the body is created: that may
         * happen in a callback, in a step that has reserved memory for other detections only. */
        w->detections[body->detection->rank] = body->detection;
    }
    if (changes & TD_CHANGE_WAKE && w->ground) {
        w->ground->drop_removed(w, index);
    }
    if (changes & TD_CHANGE_SHAPES) {
        update_shapes(w, index);
    }
    if (changes & TD_CHANGE_PLACE && w->ground) {
        w->ground->restart(w, index);
        w->ground->renew(w, index);
    }
    if (changes & (TD_CHANGE_SHAPES | TD_CHANGE_PLACE) && w->joint_hooks) {
        w->joint_hooks->move_locks(w, index);
    }
    if (changes & TD_CHANGE_ENABLE) {
        apply_enabled(w, index);
    }
    if (changes & (edits | TD_CHANGE_ENTER)) {
        td_body_place_shapes(w, index);
        extend_bounds(w, index);
    }
    if (body->awake.at > 0) {
        *td_row(&w->idle, body->awake) = changes == TD_CHANGE_SLEEP ? TD_SLEEP_TIME : 0.0f;
        w->drowsy_bodies += changes == TD_CHANGE_SLEEP;
    }
    return true;
}

/* Removes freed shapes, which are recognised by their cleared marks, from the moved list. */
static void drop_freed_from_moved(thud_world *w) {
    int *moved = w->moved.data, count = 0;
    for (int i = 0; i < w->moved.count; i++) {
        if (*td_marks_at(w, moved[i]) & TD_MARK_MOVED) {
            moved[count++] = moved[i];
        }
    }
    w->moved.count = count;
}

/* Gives lanes to joints whose bodies have entered the world. False when memory is short. */
static bool engage_joints(thud_world *w) {
    return !w->joint_hooks || w->joint_hooks->engage(w);
}

/* The stage: applies deferred edits, then the change list body by body. False when memory is short:
 * the rest of the list stays for the step that is tried again. */
bool td_changes_apply(thud_world *w) {
    td_deferred_apply(w);
    w->preview.shape.count = 0;
    w->preview.stale = true;
    if (w->changed.count == 0) {
        return engage_joints(w);
    }
    w->paired = false;
    w->narrowed = 0;
    if (!td_contact_end_reserve(w, 0)) {
        return false;
    }
    int done = 0;
    td_body_index *changed = w->changed.data;
    while (done < w->changed.count && apply_changes(w, changed[done])) {
        done++;
    }
    bool whole = done == w->changed.count;
    for (int i = done; i < w->changed.count; i++) {
        changed[i - done] = changed[i];
    }
    w->changed.count -= done;
    drop_freed_from_moved(w);
    return whole && engage_joints(w);
}
