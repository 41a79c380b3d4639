/* save.c: saves a world to a file and loads it (thud_snapshot.h). The file is, in the byte order of
 * the machine, save_head | the world's snapshot, packed, world_bytes | the caller's own bytes,
 * own_bytes. A packed snapshot has a checksum of its own (packed.c); save_head has that of the
 * caller's bytes. A file whose snapshot is not packed is loaded as well.
 *
 * A save writes PATH~ first and renames it, so that a save that fails leaves the old file whole
 * (but for Windows, where the old file has to be removed before: rename_over). */
#include "sessions/packed.h"
#include "state/handles.h"

#include "thud/thud_packed.h"

#include <stdio.h>
#include <string.h>

static const char MAGIC[8] = {'t', 'h', 'u', 'd', 's', 'a', 'v', 'e'};

/* The head of the file. */
typedef struct save_head {
    char magic[8];
    uint64_t world_bytes, own_bytes;
    uint64_t checksum; /* of the caller's own bytes */
} save_head;

/* Refuses null arguments, and calls inside a callback. */
static thud_result check(const thud_world *w, const char *path, const void *own, size_t bytes) {
    if (!w || !path || (!own && bytes > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "save or load: world, path or own is null");
    }
    return w->locked ? td_refuse(w, THUD_ERROR_LOCKED, "save or load: not inside a callback")
                     : THUD_OK;
}

/* ---- saving ---- */

/* Writes a file. False where it could not be written as a whole. */
static bool write_file(const char *path, const char *from, size_t bytes) {
    FILE *file = fopen(path, "wb");
    if (!file) {
        return false;
    }
    bool written = fwrite(from, 1, bytes, file) == bytes;
    return fclose(file) == 0 && written;
}

/* Renames a file, replacing one that has the new name. */
static bool rename_over(const char *from, const char *to) {
#if defined(_WIN32)
    remove(to); /* rename does not replace a file there */
#endif
    return rename(from, to) == 0;
}

thud_result thud_world_save(thud_world *w, const char *path, const void *own, size_t bytes) {
    thud_result result = check(w, path, own, bytes);
    if (result != THUD_OK) {
        return result;
    }
    size_t world_bytes = 0, path_length = strlen(path);
    thud_world_get_snapshot_size(w, &world_bytes);
    /* One piece of memory for the snapshot, the name of the temporary file, and the file's bytes.
     */
    size_t packed = td_packed_max(world_bytes), name = path_length + 2;
    size_t total = world_bytes + name + sizeof(save_head) + packed + bytes;
    char *snapshot = total > bytes ? td_memory_get(&w->memory, total) : NULL;
    if (!snapshot) {
        return td_refuse(w, THUD_ERROR_MEMORY, "save: out of memory");
    }
    char *draft = snapshot + world_bytes, *image = draft + name, *world = image + sizeof(save_head);
    thud_world_snapshot(w, snapshot, world_bytes, NULL);
    thud_world_pack(w, (thud_bytes){NULL, 0}, (thud_bytes){snapshot, world_bytes}, world, packed,
                    &packed);
    char *own_copy = world + packed;
    size_t size = sizeof(save_head) + packed + bytes;
    if (bytes > 0) {
        memcpy(own_copy, own, bytes);
    }
    save_head head = {.world_bytes = packed, .own_bytes = bytes};
    memcpy(head.magic, MAGIC, sizeof MAGIC);
    head.checksum = td_snapshot_checksum(own_copy, bytes);
    memcpy(image, &head, sizeof head);
    memcpy(draft, path, path_length);
    draft[path_length] = '~';
    bool saved = write_file(draft, image, size) && rename_over(draft, path);
    if (!saved) {
        remove(draft);
    }
    td_memory_put(&w->memory, snapshot, total);
    return saved ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, "save: the file cannot be written");
}

/* ---- loading ---- */

/* The length of the file, which is left at its start; false for one that has no length, as a pipe.
 */
static bool file_length(FILE *file, uint64_t *bytes) {
    if (fseek(file, 0, SEEK_END) != 0) {
        return false;
    }
    long end = ftell(file);
    *bytes = (uint64_t)end;
    return end >= 0 && fseek(file, 0, SEEK_SET) == 0;
}

/* Reads the head, and sets *body_bytes to the number of bytes after it. Returns the reason why the
 * file cannot be loaded; null: it can. */
static const char *header_error(FILE *file, size_t bytes, save_head *head, size_t *body_bytes) {
    uint64_t length;
    if (!file_length(file, &length) || fread(head, sizeof *head, 1, file) != 1 ||
        memcmp(head->magic, MAGIC, sizeof MAGIC) != 0) {
        return "load: this is no file of thud_world_save";
    }
    if (head->own_bytes != bytes) {
        return "load: the file was saved with another number of own bytes";
    }
    *body_bytes = (size_t)(length - sizeof *head);
    if (head->world_bytes > length || length - sizeof *head - head->world_bytes != bytes ||
        *body_bytes != length - sizeof *head) {
        return "load: the file is cut short, or has something after it";
    }
    return NULL;
}

/* Restores the world from a snapshot, which may be packed. */
static thud_result restore(thud_world *w, const char *from, size_t bytes) {
    thud_bytes none = {NULL, 0}, packed = {from, bytes};
    size_t size;
    if (!td_is_packed(from, bytes)) {
        return thud_world_restore(w, from, bytes);
    }
    thud_result result = thud_world_unpack(w, none, packed, NULL, 0, &size);
    if (result != THUD_OK) {
        return result;
    }
    char *snapshot = td_memory_get(&w->memory, size);
    if (!snapshot) {
        return td_refuse(w, THUD_ERROR_MEMORY, "load: out of memory");
    }
    result = thud_world_unpack(w, none, packed, snapshot, size, &size);
    if (result == THUD_OK) {
        result = thud_world_restore(w, snapshot, size);
    }
    td_memory_put(&w->memory, snapshot, size);
    return result;
}

/* Loads the world and the caller's bytes from an open file. */
static thud_result load(thud_world *w, FILE *file, void *own, size_t bytes) {
    save_head head;
    size_t body_bytes;
    const char *fault = header_error(file, bytes, &head, &body_bytes);
    if (fault) {
        return td_refuse(w, THUD_ERROR_INVALID, fault);
    }
    char *image = td_memory_get(&w->memory, body_bytes);
    if (!image) {
        return td_refuse(w, THUD_ERROR_MEMORY, "load: out of memory");
    }
    thud_result result;
    char *own_copy = image + head.world_bytes;
    if (fread(image, 1, body_bytes, file) != body_bytes ||
        td_snapshot_checksum(own_copy, bytes) != head.checksum) {
        result = td_refuse(w, THUD_ERROR_INVALID, "load: the file cannot be read, or is damaged");
    } else {
        result = restore(w, image, (size_t)head.world_bytes);
    }
    if (result == THUD_OK && bytes > 0) {
        memcpy(own, own_copy, bytes);
    }
    td_memory_put(&w->memory, image, body_bytes);
    return result;
}

thud_result thud_world_load(thud_world *w, const char *path, void *out_own, size_t bytes) {
    thud_result result = check(w, path, out_own, bytes);
    if (result != THUD_OK) {
        return result;
    }
    FILE *file = fopen(path, "rb");
    if (!file) {
        return td_refuse(w, THUD_ERROR_INVALID, "load: the file is not there, or cannot be read");
    }
    result = load(w, file, out_own, bytes);
    fclose(file);
    return result;
}
