/* event_pairs.c: thud_world_next_event_pair, an iterator over the pairs of shapes of two categories
 * that met in the last step. It goes through begin, hit and sensor_begin events, in this order, by
 * one running number, and returns each pair once. */
#include "lists/lists.h"

#include "thud/thud_events.h"
#include "thud/thud_lists.h"

/* The shapes of event `at`, counted through the three lists. False after the last event. */
static bool event_at(const thud_events *e, int at, thud_contact_event *out) {
    if (at < e->begin_count) {
        *out = e->begin[at];
        return true;
    }
    at -= e->begin_count;
    if (at < e->hit_count) {
        *out = (thud_contact_event){e->hit[at].shape_a, e->hit[at].shape_b};
        return true;
    }
    at -= e->hit_count;
    if (at < e->sensor_begin_count) {
        *out = e->sensor_begin[at];
        return true;
    }
    return false;
}

/* The category of a shape; 0, which matches nothing, if it has been destroyed. */
static uint32_t category_of(const thud_world *w, thud_shape_id id) {
    return thud_shape_is_valid(w, id) ? td_shape_at(w, (int)(id.index1 - 1))->filter.category : 0;
}

/* Whether two handles are equal. */
static bool same(thud_shape_id a, thud_shape_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

/* Whether two events are of the same two shapes, in either order. */
static bool same_pair(const thud_contact_event *a, const thud_contact_event *b) {
    return (same(a->shape_a, b->shape_a) && same(a->shape_b, b->shape_b)) ||
           (same(a->shape_a, b->shape_b) && same(a->shape_b, b->shape_a));
}

/* Whether an event before number `at` is of the same pair. */
static bool is_repeated(const thud_events *e, int at, const thud_contact_event *event) {
    thud_contact_event before;
    for (int i = 0; i < at && event_at(e, i, &before); i++) {
        if (same_pair(&before, event)) {
            return true;
        }
    }
    return false;
}

/* Whether the event's shapes are of the categories `first` and `second`; swaps the event's shapes
 * where only the other order matches. */
static bool is_of(const thud_world *w, uint32_t first, uint32_t second, thud_contact_event *event) {
    uint32_t a = category_of(w, event->shape_a), b = category_of(w, event->shape_b);
    if ((a & first) && (b & second)) {
        return true;
    }
    *event = (thud_contact_event){event->shape_b, event->shape_a};
    return (b & first) && (a & second);
}

bool thud_world_next_event_pair(const thud_world *w, uint32_t first, uint32_t second,
                                thud_event_pair *pair) {
    if (!w || !pair) {
        td_refuse(w, THUD_ERROR_NULL, "next event pair: world or pair is null");
        return false;
    }
    if (pair->next < 0) {
        td_refuse(w, THUD_ERROR_INVALID, "next event pair: next is negative");
        return false;
    }
    thud_events e = thud_events_of(w);
    thud_contact_event event;
    int at = pair->next;
    for (; event_at(&e, at, &event); at++) {
        if (is_of(w, first, second, &event) && !is_repeated(&e, at, &event)) {
            thud_pair sides;
            thud_world_get_pair(w, event.shape_a, event.shape_b, &sides);
            *pair = (thud_event_pair){event.shape_a, event.shape_b, sides.a, sides.b, at + 1};
            return true;
        }
    }
    *pair = (thud_event_pair){.next = at};
    return false;
}
