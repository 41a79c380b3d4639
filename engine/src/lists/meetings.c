/* meetings.c: who met whom in the last step, out of its events: contacts that began, hits, and what
 * sensors began to overlap, in this order. */
#include "lists/lists.h"

#include "thud/thud_events.h"
#include "thud/thud_lists.h"

/* The shapes of an event, counted through the three lists; false behind the last one. */
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

/* 0 for what is gone, which nobody met. */
static uint32_t category_of(const thud_world *w, thud_shape_id id) {
    return thud_shape_is_valid(w, id) ? td_shape_at(w, (int)(id.index1 - 1))->filter.category : 0;
}

static bool same(thud_shape_id a, thud_shape_id b) {
    return a.index1 == b.index1 && a.generation == b.generation;
}

static bool same_pair(const thud_contact_event *a, const thud_contact_event *b) {
    return (same(a->shape_a, b->shape_a) && same(a->shape_b, b->shape_b)) ||
           (same(a->shape_a, b->shape_b) && same(a->shape_b, b->shape_a));
}

static bool told_before(const thud_events *e, int at, const thud_contact_event *event) {
    thud_contact_event before;
    for (int i = 0; i < at && event_at(e, i, &before); i++) {
        if (same_pair(&before, event)) {
            return true;
        }
    }
    return false;
}

/* Whether a meeting of the kinds is told: in the order of the event, or turned round. */
static bool is_of(const thud_world *w, uint32_t first, uint32_t second, thud_contact_event *event) {
    uint32_t a = category_of(w, event->shape_a), b = category_of(w, event->shape_b);
    if ((a & first) && (b & second)) {
        return true;
    }
    *event = (thud_contact_event){event->shape_b, event->shape_a};
    return (b & first) && (a & second);
}

bool thud_world_next_meeting(const thud_world *w, uint32_t first, uint32_t second,
                             thud_met *meeting) {
    if (!w || !meeting) {
        td_refuse(w, THUD_ERROR_NULL, "next meeting: world or meeting is null");
        return false;
    }
    if (meeting->next < 0) {
        td_refuse(w, THUD_ERROR_INVALID, "next meeting: next is negative");
        return false;
    }
    thud_events e = thud_world_events(w);
    thud_contact_event event;
    int at = meeting->next;
    for (; event_at(&e, at, &event); at++) {
        if (is_of(w, first, second, &event) && !told_before(&e, at, &event)) {
            thud_pair pair;
            thud_pair_get(w, event.shape_a, event.shape_b, &pair);
            *meeting = (thud_met){event.shape_a, event.shape_b, pair.a, pair.b, at + 1};
            return true;
        }
    }
    *meeting = (thud_met){.next = at};
    return false;
}
