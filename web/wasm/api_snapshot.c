/* api_snapshot.c: a world's whole state as bytes, through one buffer for both ways. */
#include "api.h"

#include <thud/thud_snapshot.h>

#include <stdlib.h>

static char *buffer;
static size_t capacity;

/* Room for so many bytes; null when memory is short. */
char *api_snapshot_room(uint32_t bytes) {
    if (bytes > capacity) {
        free(buffer);
        buffer = malloc(bytes);
        capacity = buffer == NULL ? 0 : bytes;
    }
    return buffer;
}

/* Slots out: list of bytes, which stay until the next call. */
int api_world_snapshot(const thud_world *world) {
    size_t bytes = 0;
    thud_result result = thud_world_snapshot_size(world, &bytes);
    if (result != THUD_OK)
        return result;
    char *to = api_snapshot_room((uint32_t)bytes);
    if (to == NULL)
        return THUD_ERROR_MEMORY;
    api_slots.list.address = (double)(uintptr_t)to;
    api_slots.list.count = (double)bytes;
    return thud_world_snapshot(world, to, bytes, NULL);
}

/* From the first bytes of the room that api_snapshot_room gave. */
int api_world_restore(thud_world *world, uint32_t bytes) {
    return thud_world_restore(world, buffer, bytes);
}
