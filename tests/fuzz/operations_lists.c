/* operations_lists.c: lists of a world's bodies, shapes, pairs and overlaps. All handles in a list
 * are valid and in the order of their slots, and a list with less capacity is the beginning of the
 * full one. */
#include "operations.h"

enum { ROOM = 6 };

/* A capacity of a list, at most ROOM. */
static int pick_room(fuzz_session *s) {
    int capacity = next_count(&s->bytes, ROOM);
    return capacity > ROOM ? ROOM : capacity;
}

static void check_list(fuzz_session *s, const uint32_t *index1, int count, int capacity) {
    if (count < 0) {
        fuzz_fail(s, "%s: %d of them", s->calls[s->depth].text, count);
    }
    note_bits(s, (uint64_t)count);
    for (int i = 0; i < count && i < capacity; i++) {
        note_bits(s, index1[i]);
        if (i > 0 && index1[i] <= index1[i - 1]) {
            fuzz_fail(s, "%s: slot %u after %u", s->calls[s->depth].text, index1[i], index1[i - 1]);
        }
    }
}

static void check_bodies(fuzz_session *s, const thud_body_id *list, int count, int capacity) {
    uint32_t index1[ROOM];
    for (int i = 0; i < count && i < capacity; i++) {
        index1[i] = list[i].index1;
        if (!COUNTED(thud_body_is_valid(s->world, list[i]))) {
            fuzz_fail(s, "%s: body %u is gone", s->calls[s->depth].text, index1[i]);
        }
    }
    check_list(s, index1, count, capacity);
}

static void check_shapes(fuzz_session *s, const thud_shape_id *list, int count, int capacity) {
    uint32_t index1[ROOM];
    for (int i = 0; i < count && i < capacity; i++) {
        index1[i] = list[i].index1;
        if (!COUNTED(thud_shape_is_valid(s->world, list[i]))) {
            fuzz_fail(s, "%s: shape %u is gone", s->calls[s->depth].text, index1[i]);
        }
    }
    check_list(s, index1, count, capacity);
}

void play_lists(fuzz_session *s) {
    thud_body_id bodies[ROOM];
    thud_shape_id shapes[ROOM];
    int capacity = pick_room(s), all = -7, awake = -7, count = -7;
    TRY(s, thud_world_get_bodies(s->world, capacity ? bodies : NULL, capacity, &all));
    if (s->result == THUD_OK) {
        check_bodies(s, bodies, all, capacity);
    }
    TRY(s, thud_world_get_awake_bodies(s->world, bodies, capacity, &awake));
    if (s->result == THUD_OK) {
        check_bodies(s, bodies, awake, capacity);
    }
    if (awake > all) {
        fuzz_fail(s, "%d bodies are awake, and there are %d", awake, all);
    }
    TRY(s, thud_world_get_shapes(s->world, shapes, capacity, &count));
    if (s->result == THUD_OK) {
        check_shapes(s, shapes, count, capacity);
    }
}

void play_slots(fuzz_session *s) {
    int slot = next_count(&s->bytes, SESSION_BODIES), bodies = -7, shapes = -7;
    thud_body_id body = {0, 0};
    thud_shape_id shape = {0, 0};
    TRY(s, thud_world_get_slot_counts(s->world, &bodies, &shapes));
    TRY(s, thud_world_get_body_at(s->world, slot, &body));
    if ((s->result == THUD_OK) != (slot >= 0 && slot < bodies) ||
        (body.index1 && !COUNTED(thud_body_is_valid(s->world, body)))) {
        fuzz_fail(s, "slot %d of %d: body %u", slot, bodies, body.index1);
    }
    TRY(s, thud_world_get_shape_at(s->world, slot, &shape));
    if ((s->result == THUD_OK) != (slot >= 0 && slot < shapes) ||
        (shape.index1 && !COUNTED(thud_shape_is_valid(s->world, shape)))) {
        fuzz_fail(s, "slot %d of %d: shape %u", slot, shapes, shape.index1);
    }
    note_bits(s, (uint64_t)body.index1 << 32 | shape.index1);
}

/* A second call does not list the same bodies again. */
void play_moved(fuzz_session *s) {
    thud_body_id bodies[ROOM];
    int capacity = pick_room(s), slots = next_count(&s->bytes, SESSION_BODIES);
    int count = -7, left = -7;
    slots = slots > SESSION_BODIES ? SESSION_BODIES : slots;
    TRY(s, thud_world_get_moved_bodies(s->world, s->seen, slots, bodies, capacity, &count));
    if (s->result != THUD_OK) {
        return;
    }
    check_bodies(s, bodies, count, capacity);
    TRY(s, thud_world_get_moved_bodies(s->world, s->seen, slots, NULL, 0, &left));
    if (left != (count > capacity ? count - capacity : 0)) {
        fuzz_fail(s, "%d bodies moved, %d were told, %d are left", count, capacity, left);
    }
}

void play_sensed(fuzz_session *s) {
    thud_shape_id sensor = pick_shape(s), shapes[ROOM];
    int capacity = pick_room(s), count = -7;
    TRY(s, thud_shape_get_sensor_overlaps(s->world, sensor, shapes, capacity, &count));
    if (s->result == THUD_OK) {
        check_shapes(s, shapes, count, capacity);
    }
}

static void check_side(fuzz_session *s, thud_shape_id shape, const thud_pair_side *side) {
    bool there = COUNTED(thud_shape_is_valid(s->world, shape));
    if (there != COUNTED(thud_body_is_valid(s->world, side->body)) ||
        (!there && (side->body_data || side->shape_data || side->sensor))) {
        fuzz_fail(s, "shape %u is of body %u", shape.index1, side->body.index1);
    }
    note_bits(s, side->body.index1 + side->body_data + side->shape_data);
}

/* The sides of two shapes of the session, or of the pair that ended last. */
void play_sides(fuzz_session *s) {
    thud_shape_id a = pick_shape(s), b = pick_shape(s);
    thud_events e = COUNTED(thud_events_of(s->world));
    if (e.end_count && next_choice(&s->bytes, 2)) {
        a = e.end[e.end_count - 1].shape_a;
        b = e.end[e.end_count - 1].shape_b;
    }
    thud_pair pair;
    memset(&pair, CALL_FILL, sizeof pair);
    TRY(s, thud_world_get_pair(s->world, a, b, &pair));
    if (s->result != THUD_OK) {
        fuzz_fail(s, "a pair is refused: %s", thud_result_text(s->result));
    }
    check_side(s, a, &pair.a);
    check_side(s, b, &pair.b);
}

/* Lists pairs of two categories: each pair occurs once, is of the categories that were asked for,
 * and its shapes are valid; some shapes are destroyed during the loop. */
void play_meetings(fuzz_session *s) {
    enum { MET = 32 };
    uint32_t first = next_byte(&s->bytes), second = next_byte(&s->bytes), told[MET][2];
    bool destroys = next_choice(&s->bytes, 8) == 0;
    thud_event_pair m = {0};
    int count = 0;
    while (count < MET && COUNTED(thud_world_next_event_pair(s->world, first, second, &m))) {
        thud_shape_state a, b;
        if (COUNTED(thud_shape_get_state(s->world, m.shape_a, &a)) != THUD_OK ||
            COUNTED(thud_shape_get_state(s->world, m.shape_b, &b)) != THUD_OK ||
            !(a.filter.category & first) || !(b.filter.category & second) ||
            a.body.index1 != m.a.body.index1 || b.body.index1 != m.b.body.index1) {
            fuzz_fail(s, "shapes %u and %u did not meet", m.shape_a.index1, m.shape_b.index1);
        }
        for (int i = 0; i < count; i++) {
            if ((told[i][0] == m.shape_a.index1 && told[i][1] == m.shape_b.index1) ||
                (told[i][1] == m.shape_a.index1 && told[i][0] == m.shape_b.index1)) {
                fuzz_fail(s, "shapes %u and %u met twice", told[i][0], told[i][1]);
            }
        }
        told[count][0] = m.shape_a.index1;
        told[count++][1] = m.shape_b.index1;
        note_bits(s, (uint64_t)m.shape_a.index1 << 32 | m.shape_b.index1);
        if (destroys) {
            s->gone_shapes[s->gone++ % SESSION_GONE] = m.shape_b;
            s->destroyed_inside += s->depth > 0;
            TRY(s, thud_shape_destroy(s->world, m.shape_b));
        }
    }
    m.next = -1;
    if (COUNTED(thud_world_next_event_pair(s->world, first, second, &m))) {
        fuzz_fail(s, "a meeting before the first one");
    }
}
