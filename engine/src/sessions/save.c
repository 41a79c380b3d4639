/* save.c: a world in a file; see thud_snapshot.h. A head, then the snapshot, then the caller's own
 * bytes. A snapshot knows by itself whether it is whole; the head knows of the rest. */
#include "api/snapshot.h"
#include "state/handles.h"

#include <stdio.h>
#include <string.h>

static const char MAGIC[8] = {'t', 'h', 'u', 'd', 's', 'a', 'v', 'e'};

typedef struct save_head {
    char magic[8];
    uint64_t world_bytes, own_bytes;
    uint64_t checksum; /* of the caller's own */
} save_head;

static thud_result check(const thud_world *w, const char *path, const void *own, size_t bytes) {
    if (!w || !path || (!own && bytes > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "save or load: world, path or own is null");
    }
    return w->locked ? td_refuse(w, THUD_ERROR_LOCKED, "save or load: not inside a callback")
                     : THUD_OK;
}

/* ---- saving ---- */

static bool write_file(const char *path, const char *from, size_t bytes) {
    FILE *file = fopen(path, "wb");
    if (!file) {
        return false;
    }
    bool written = fwrite(from, 1, bytes, file) == bytes;
    return fclose(file) == 0 && written;
}

/* In place of what has that name. */
static bool rename_over(const char *from, const char *to) {
#if defined(_WIN32)
    remove(to); /* its rename does not replace */
#endif
    return rename(from, to) == 0;
}

thud_result thud_world_save(thud_world *w, const char *path, const void *own, size_t bytes) {
    thud_result result = check(w, path, own, bytes);
    if (result != THUD_OK) {
        return result;
    }
    size_t world_bytes = 0, name = strlen(path);
    thud_world_snapshot_size(w, &world_bytes);
    size_t size = sizeof(save_head) + world_bytes + bytes, all = size + name + 2;
    char *image = all > bytes ? td_memory_get(&w->memory, all) : NULL;
    if (!image) {
        return td_refuse(w, THUD_ERROR_MEMORY, "save: out of memory");
    }
    char *world = image + sizeof(save_head), *beside = world + world_bytes, *draft = image + size;
    thud_world_snapshot(w, world, world_bytes, NULL);
    if (bytes > 0) {
        memcpy(beside, own, bytes);
    }
    save_head head = {.world_bytes = world_bytes, .own_bytes = bytes};
    memcpy(head.magic, MAGIC, sizeof MAGIC);
    head.checksum = td_snapshot_checksum(beside, bytes);
    memcpy(image, &head, sizeof head);
    memcpy(draft, path, name);
    draft[name] = '~';
    bool saved = write_file(draft, image, size) && rename_over(draft, path);
    if (!saved) {
        remove(draft);
    }
    td_memory_put(&w->memory, image, all);
    return saved ? THUD_OK : td_refuse(w, THUD_ERROR_INVALID, "save: the file cannot be written");
}

/* ---- loading ---- */

/* How long the file is, from its beginning; false where it has no length. */
static bool length_of(FILE *file, uint64_t *bytes) {
    if (fseek(file, 0, SEEK_END) != 0) {
        return false;
    }
    long end = ftell(file);
    *bytes = (uint64_t)end;
    return end >= 0 && fseek(file, 0, SEEK_SET) == 0;
}

/* Why the file cannot be loaded, or null. */
static const char *fault_of(FILE *file, size_t bytes, save_head *head, size_t *rest) {
    uint64_t length;
    if (!length_of(file, &length) || fread(head, sizeof *head, 1, file) != 1 ||
        memcmp(head->magic, MAGIC, sizeof MAGIC) != 0) {
        return "load: this is no file of thud_world_save";
    }
    if (head->own_bytes != bytes) {
        return "load: the file was saved with another number of own bytes";
    }
    *rest = (size_t)(length - sizeof *head);
    if (head->world_bytes > length || length - sizeof *head - head->world_bytes != bytes ||
        *rest != length - sizeof *head) {
        return "load: the file is cut short, or has something after it";
    }
    return NULL;
}

static thud_result load(thud_world *w, FILE *file, void *own, size_t bytes) {
    save_head head;
    size_t rest;
    const char *fault = fault_of(file, bytes, &head, &rest);
    if (fault) {
        return td_refuse(w, THUD_ERROR_INVALID, fault);
    }
    char *image = td_memory_get(&w->memory, rest);
    if (!image) {
        return td_refuse(w, THUD_ERROR_MEMORY, "load: out of memory");
    }
    thud_result result;
    char *beside = image + head.world_bytes;
    if (fread(image, 1, rest, file) != rest ||
        td_snapshot_checksum(beside, bytes) != head.checksum) {
        result = td_refuse(w, THUD_ERROR_INVALID, "load: the file cannot be read, or is damaged");
    } else {
        result = thud_world_restore(w, image, (size_t)head.world_bytes);
    }
    if (result == THUD_OK && bytes > 0) {
        memcpy(own, beside, bytes);
    }
    td_memory_put(&w->memory, image, rest);
    return result;
}

thud_result thud_world_load(thud_world *w, const char *path, void *own, size_t bytes) {
    thud_result result = check(w, path, own, bytes);
    if (result != THUD_OK) {
        return result;
    }
    FILE *file = fopen(path, "rb");
    if (!file) {
        return td_refuse(w, THUD_ERROR_INVALID, "load: the file is not there, or cannot be read");
    }
    result = load(w, file, own, bytes);
    fclose(file);
    return result;
}
