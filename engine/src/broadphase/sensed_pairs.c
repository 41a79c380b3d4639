/* sensed_pairs.c: at the end of a step, makes the new contacts between sensors and other shapes,
 * where one of the two has left its fat bounds in the step. So sensors report the overlaps of the
 * poses at the end of the step (sensor_events.c tests them). All other new pairs are left to the
 * next broadphase, which finds the pairs made here a second time. So that it does not make their
 * contacts twice, their moved shapes get the mark TD_MARK_WOKEN here: for marked shapes the
 * broadphase searches the list of contacts. */
#include "api/step.h"
#include "broadphase/pairs.h"
#include "constraint/constraint.h"
#include "contact/contact.h"
#include "contact/sensors.h"
#include "state/shape.h"

/* Reserves, before bodies move, the memory of all functions below. False when memory is short.
 * found_shapes gets room for three times the number of shapes: once for the hits of a search, once
 * for the room that a search reserves before it tests a range of shapes (reserve_hits in
 * wide_scan.h), and once as a margin. */
bool td_sensed_reserve(thud_world *w) {
    int room = w->scratch.sensed_room = td_sensors_expect(w);
    int more[TD_CONSTRAINT_KINDS] = {[TD_PAIR_SENSOR] = room};
    int shapes = w->awake_shapes.ids.count + w->rest_shapes.ids.count;
    return td_array_reserve(&w->memory, &w->scratch.sensing, w->body_of.count) &&
           td_array_reserve(&w->memory, &w->scratch.found_shapes, 3 * shapes + 4 * TD_LANES) &&
           td_bounds_grid_reserve(&w->memory, &w->scratch.sensed, w->sensors) &&
           td_array_reserve(&w->memory, &w->scratch.pairs, 2 * room) &&
           td_constraints_reserve(w, more);
}

/* Whether the shape has left its fat bounds in this step. */
static bool moved(const thud_world *w, int shape) {
    return *td_marks_at(w, shape) & TD_MARK_MOVED;
}

/* Whether the shape has been in the world since the start of the step. */
static bool exists_since_start(const thud_world *w, int shape) {
    return (td_shape_at(w, shape)->flags & (TD_SHAPE_LIVE | TD_SHAPE_WAITS)) == TD_SHAPE_LIVE &&
           !(*td_marks_at(w, shape) & TD_MARK_FRESH);
}

/* Whether the shape is a sensor for which this step has reserved memory. */
static bool is_sensor(const thud_world *w, int shape) {
    return td_senses(w, shape) && exists_since_start(w, shape);
}

/* Lists the awake bodies that have a sensor. */
void td_sensed_list(thud_world *w) {
    td_array *list = &w->scratch.sensing;
    list->count = 0;
    for (td_awake_slot slot = {1}; slot.at < w->body_of.count; slot.at++) {
        int i = td_body_at(w, td_body_of(w, slot))->first_shape;
        while (i != TD_NONE && !is_sensor(w, i)) {
            i = td_shape_at(w, i)->next;
        }
        if (i != TD_NONE) {
            td_push_slot(list, slot);
        }
    }
}

/* Adds a pair that has no contact, and marks the shape, because the next broadphase finds the pair
 * as well. False where there is no room for another pair (td_sensed_reserve). */
static bool add(thud_world *w, int shape, int other, int child) {
    td_new_pair pair = {td_min_int(shape, other), td_max_int(shape, other), child};
    td_pair_of(w, &pair.a, &pair.b);
    if (td_pair_has_contact(w, &pair)) {
        return true;
    }
    *td_marks_at(w, shape) |= TD_MARK_WOKEN;
    return w->scratch.pairs.count < w->scratch.sensed_room &&
           td_pairs_add(w, pair.a, pair.b, child);
}

/* Whether one of the two is a sensor, `other` has been in the world since the start of the step,
 * and filters allow the pair. */
static bool may_pair(const thud_world *w, int shape, int other) {
    return (td_senses(w, shape) || td_senses(w, other)) && exists_since_start(w, other) &&
           td_pair_allowed(w, shape, other);
}

/* Adds the pair if it may have a contact and the fat bounds overlap. False when there is no room
 * for it, as in the functions below. */
static bool try_pair(thud_world *w, int shape, int other) {
    bool may = td_pair_meets(w, shape, other) && may_pair(w, shape, other);
    return !may || add(w, shape, other, 0);
}

/* Adds the pairs of the shape with the segments of a line. */
static bool try_line(thud_world *w, int shape, int line) {
    return !may_pair(w, shape, line) || w->ground->each(w, line, shape, add);
}

/* Adds the pairs of a moved shape with the shapes of a set that did not move. The bounds of shapes
 * that moved in this step are out of date in the set. */
static bool pair_with_set(thud_world *w, const td_proxy_set *set, int shape) {
    td_array *found = &w->scratch.found_shapes;
    found->count = 0;
    bool done = w->def.broadphase->find[w->wide](set, &w->memory, td_fat_at(w, shape),
                                                 td_shape_proxy_at(w, shape)->center, found,
                                                 &w->broadphase.tested);
    for (int i = 0; i < found->count && done; i++) {
        int other = td_int_at(found, i);
        done = moved(w, other) || try_pair(w, shape, other);
    }
    return done;
}

/* Puts the sensors of awake bodies into the grid, and those of other bodies that have moved. */
static void fill_grid(thud_world *w) {
    td_bounds_grid *grid = &w->scratch.sensed;
    grid->boxes.count = 0;
    for (int i = 0; i < w->scratch.sensing.count; i++) {
        int shape = td_body_at(w, td_body_of(w, td_slot_in(&w->scratch.sensing, i)))->first_shape;
        for (; shape != TD_NONE; shape = td_shape_at(w, shape)->next) {
            if (is_sensor(w, shape)) {
                td_bounds_grid_add(grid, td_fat_at(w, shape), shape);
            }
        }
    }
    for (int i = 0; i < w->moved.count; i++) {
        int shape = td_int_at(&w->moved, i);
        const td_shape *s = td_shape_at(w, shape);
        if (is_sensor(w, shape) && !td_kind_is_line(s->kind) &&
            td_body_at(w, s->body)->awake.at <= 0) {
            td_bounds_grid_add(grid, td_fat_at(w, shape), shape);
        }
    }
    td_bounds_grid_build(grid);
}

/* Adds the pairs of a moved shape with awake sensors near it. If the shape is a sensor itself, it
 * leaves those that did not move to pair_with_set; of two sensors that moved, the one of lower
 * index adds the pair. */
static bool pair_with_sensors(thud_world *w, int shape) {
    td_array *found = &w->scratch.found_shapes;
    bool done = true, senses = td_senses(w, shape);
    found->count = 0;
    td_bounds_grid_find(&w->scratch.sensed, td_fat_at(w, shape), found);
    for (int i = 0; i < found->count && done; i++) {
        int other = td_int_at(found, i);
        done = (senses && (!moved(w, other) || other <= shape)) || try_pair(w, shape, other);
    }
    return done;
}

/* Adds all new sensor pairs of one moved shape that is no line. */
static bool add_pairs_of(thud_world *w, int shape) {
    bool done = pair_with_set(w, &w->rest_shapes, shape) &&
                (!td_senses(w, shape) || pair_with_set(w, &w->awake_shapes, shape)) &&
                pair_with_sensors(w, shape);
    for (int t = 0; t < w->terrains.count && done; t++) {
        int line = td_terrain_record_at(w, t)->shape;
        done = line == TD_NONE || try_line(w, shape, line);
    }
    return done;
}

/* Where there is no room for all pairs, makes none: which pairs came first would depend on the
 * broadphase. The next broadphase finds them all. */
bool td_sensed_pairs(thud_world *w) {
    bool done = true;
    w->scratch.pairs.count = 0;
    fill_grid(w);
    for (int i = 0; i < w->moved.count && done; i++) {
        int shape = td_int_at(&w->moved, i);
        done = !exists_since_start(w, shape) || td_kind_is_line(td_shape_at(w, shape)->kind) ||
               add_pairs_of(w, shape);
    }
    return done && td_pairs_sort(w) && td_pairs_create(w);
}
