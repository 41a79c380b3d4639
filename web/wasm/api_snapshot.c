/* api_snapshot.c: exports for snapshots, the whole state of a world as bytes. Saving and restoring
 * use the same buffer. */
#include "api.h"

#include <thud/thud_snapshot.h>

#include <stdlib.h>

static char *buffer;
static size_t capacity;

/* The buffer with room for at least `bytes` bytes; its contents are lost where it grows. Null where
 * memory is short. */
char *api_snapshot_room(uint32_t bytes) {
    if (bytes > capacity) {
        free(buffer);
        buffer = malloc(bytes);
        capacity = buffer == NULL ? 0 : bytes;
    }
    return buffer;
}

/* Takes a snapshot. Slots out: list of bytes, valid until the next call of this file. */
int api_world_snapshot(const thud_world *world) {
    size_t bytes = 0;
    thud_result result = thud_world_get_snapshot_size(world, &bytes);
    if (result != THUD_OK)
        return result;
    char *to = api_snapshot_room((uint32_t)bytes);
    if (to == NULL)
        return THUD_ERROR_MEMORY;
    api_slots.list.address = (double)(uintptr_t)to;
    api_slots.list.count = (double)bytes;
    return thud_world_snapshot(world, to, bytes, NULL);
}

/* Restores the world from the first `bytes` bytes of the buffer. */
int api_world_restore(thud_world *world, uint32_t bytes) {
    return thud_world_restore(world, buffer, bytes);
}
