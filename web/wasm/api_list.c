/* api_list.c: exports that list bodies and shapes of a world (thud_lists.h). A list is an array of
 * handles, two uint32_t each; api.h has the conventions. */
#include "api.h"

#include <thud/thud_lists.h>

static api_buffer bodies, shapes;

/* Gives a list `count` handles of any value. */
static thud_result make_room(api_buffer *list, int count) {
    api_buffer_clear(list);
    for (int i = 0; i < count; i++)
        api_buffer_push(list, &(thud_body_id){0}, sizeof(thud_body_id));
    return api_buffer_result(list);
}

/* Slots out: list. Returns `result`. */
static int told(thud_result result, const api_buffer *list, int count) {
    api_slots.list.address = (double)(uintptr_t)list->data;
    api_slots.list.count = count;
    return result;
}

/* The bodies that a function of thud_lists.h lists. Slots out: list. */
static int list_bodies(const thud_world *world,
                       thud_result (*find)(const thud_world *, thud_body_id *, int, int *)) {
    int count = 0;
    thud_result result = find(world, NULL, 0, &count);
    if (result == THUD_OK)
        result = make_room(&bodies, count);
    if (result == THUD_OK)
        result = find(world, (thud_body_id *)bodies.data, count, &count);
    return told(result, &bodies, count);
}

/* Slots out: list, here and in the next two. */
int api_world_bodies(const thud_world *world) {
    return list_bodies(world, thud_world_get_bodies);
}

int api_world_awake_bodies(const thud_world *world) {
    return list_bodies(world, thud_world_get_awake_bodies);
}

int api_world_shapes(const thud_world *world) {
    int count = 0;
    thud_result result = thud_world_get_shapes(world, NULL, 0, &count);
    if (result == THUD_OK)
        result = make_room(&shapes, count);
    if (result == THUD_OK)
        result = thud_world_get_shapes(world, (thud_shape_id *)shapes.data, count, &count);
    return told(result, &shapes, count);
}

/* `seen`: an array of `slots` elements, zeroed before its first use. Slots out: list. */
int api_world_moved_bodies(const thud_world *world, thud_body_seen *seen, int slots) {
    int count = 0;
    thud_result result = make_room(&bodies, slots);
    if (result == THUD_OK)
        result = thud_world_get_moved_bodies(world, seen, slots, (thud_body_id *)bodies.data, slots,
                                             &count);
    return told(result, &bodies, count);
}

/* The size of an element of `seen`, bytes. */
int api_body_seen_bytes(void) {
    return sizeof(thud_body_seen);
}

/* The number of body slots that have ever been used. */
int api_world_body_slots(const thud_world *world) {
    int slots = 0;
    thud_world_get_slot_counts(world, &slots, NULL);
    return slots;
}

/* Slots out: handle, zeros for an empty slot; also in the next. */
int api_world_body_at(const thud_world *world, double slot) {
    thud_body_id id = {0};
    thud_result result = thud_world_get_body_at(world, api_to_int(slot), &id);
    api_slots.handle = (struct handle){id.index1, id.generation};
    return result;
}

int api_world_shape_at(const thud_world *world, double slot) {
    thud_shape_id id = {0};
    thud_result result = thud_world_get_shape_at(world, api_to_int(slot), &id);
    api_slots.handle = (struct handle){id.index1, id.generation};
    return result;
}

/* Slots out: list. */
int api_shape_sensor_overlaps(const thud_world *world, uint32_t index1, uint32_t generation) {
    int count = 0;
    thud_shape_id sensor = api_shape(index1, generation);
    thud_result result = thud_shape_get_sensor_overlaps(world, sensor, NULL, 0, &count);
    if (result == THUD_OK)
        result = make_room(&shapes, count);
    if (result == THUD_OK)
        result = thud_shape_get_sensor_overlaps(world, sensor, (thud_shape_id *)shapes.data, count,
                                                &count);
    return told(result, &shapes, count);
}

static struct pair_side side_of(const thud_pair_side *side) {
    return (struct pair_side){.body = {side->body.index1, side->body.generation},
                              .body_data = (double)side->body_data,
                              .shape_data = (double)side->shape_data,
                              .sensor = side->sensor};
}

/* Slots out: pair. */
int api_world_pair(const thud_world *world, uint32_t index1_a, uint32_t generation_a,
                   uint32_t index1_b, uint32_t generation_b) {
    thud_pair pair;
    thud_result result = thud_world_get_pair(world, api_shape(index1_a, generation_a),
                                             api_shape(index1_b, generation_b), &pair);
    if (result == THUD_OK)
        api_slots.pair = (struct pair){side_of(&pair.a), side_of(&pair.b)};
    return result;
}
