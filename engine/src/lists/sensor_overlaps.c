/* sensor_overlaps.c: thud_shape_get_sensor_overlaps: the shapes of a sensor's open contacts, in the
 * order of slots. Contacts are in no order; so the lowest `capacity` slots are kept in a binary
 * max-heap in the caller's array, which heapsort (J. W. J. Williams, Algorithm 232, 1964) then puts
 * in ascending order. */
#include "constraint/constraint.h"
#include "lists/lists.h"

#include "thud/thud_lists.h"

/* The other shape's slot, if this edge of the sensor's body is an open contact of the sensor and
 * the other body is enabled; else TD_NONE. */
static int overlapped_by(const thud_world *w, int edge, int sensor) {
    const td_constraint *contact = td_constraint_at(w, td_edge_constraint(edge));
    if (contact->kind != TD_PAIR_SENSOR || !contact->open ||
        (contact->shape_a != sensor && contact->shape_b != sensor)) {
        return TD_NONE;
    }
    int other = contact->shape_a == sensor ? contact->shape_b : contact->shape_a;
    bool present = td_shape_lives(w, other) &&
                   !(td_body_at(w, td_shape_at(w, other)->body)->flags & TD_BODY_DISABLED);
    return present ? other : TD_NONE;
}

/* Whether this edge is the first with this other shape. A terrain, sensor or other, has a contact
 * for each segment, of which only the first counts. */
static bool is_first(const thud_world *w, int first, int edge, int sensor, int other) {
    if (!td_kind_is_line(td_shape_at(w, other)->kind) &&
        !td_kind_is_line(td_shape_at(w, sensor)->kind)) {
        return true;
    }
    int e = first;
    while (e != edge && overlapped_by(w, e, sensor) != other) {
        e = td_next_edge(w, e);
    }
    return e == edge;
}

static void swap(thud_shape_id *a, thud_shape_id *b) {
    thud_shape_id t = *a;
    *a = *b;
    *b = t;
}

/* Moves element i down the heap until no child has a higher slot. */
static void sift_down(thud_shape_id *heap, int count, int i) {
    for (int below; (below = 2 * i + 1) < count; i = below) {
        below += below + 1 < count && heap[below + 1].index1 > heap[below].index1;
        if (heap[below].index1 <= heap[i].index1) {
            return;
        }
        swap(&heap[below], &heap[i]);
    }
}

/* Moves element i up the heap until its parent has a higher slot. */
static void sift_up(thud_shape_id *heap, int i) {
    for (int above; i > 0 && heap[above = (i - 1) / 2].index1 < heap[i].index1; i = above) {
        swap(&heap[above], &heap[i]);
    }
}

/* Adds a shape to the heap. If the heap is full, the shape replaces the one with the highest slot,
 * provided that its own slot is lower. `kept`: the number of shapes so far. */
static void keep(thud_shape_id *heap, int capacity, int kept, thud_shape_id shape) {
    if (kept < capacity) {
        heap[kept] = shape;
        sift_up(heap, kept);
    } else if (capacity > 0 && shape.index1 < heap[0].index1) {
        heap[0] = shape;
        sift_down(heap, capacity, 0);
    }
}

thud_result thud_shape_get_sensor_overlaps(const thud_world *w, thud_shape_id id,
                                           thud_shape_id *out, int capacity, int *out_count) {
    int sensor, n = 0;
    thud_result result = td_list_check(w, out, capacity, out_count);
    if (result == THUD_OK) {
        result = td_find_shape(w, id, &sensor);
    }
    if (result != THUD_OK) {
        return result;
    }
    if (!(td_shape_at(w, sensor)->flags & TD_SHAPE_SENSOR)) {
        return td_refuse(w, THUD_ERROR_INVALID, "sensor overlaps: the shape is no sensor");
    }
    const td_body *body = td_body_at(w, td_shape_at(w, sensor)->body);
    int first = body->flags & TD_BODY_DISABLED ? TD_NONE : body->first_constraint;
    for (int e = first; e != TD_NONE; e = td_next_edge(w, e)) {
        int other = overlapped_by(w, e, sensor);
        if (other != TD_NONE && is_first(w, first, e, sensor, other)) {
            keep(out, capacity, n, td_shape_handle(w, other));
            n++;
        }
    }
    for (int end = td_min_int(n, capacity) - 1; end > 0; end--) {
        swap(&out[0], &out[end]);
        sift_down(out, end, 0);
    }
    *out_count = n;
    return THUD_OK;
}
