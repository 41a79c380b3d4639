/* snapshot.c: taking and restoring snapshots. A restore first checks all bytes, then reserves all
 * memory, and only then writes to the world: from there on it cannot fail. The layout is that of
 * snapshot.h. */
#include "api/snapshot.h"

#include "state/handles.h"

#include <string.h>

thud_result thud_world_get_snapshot_size(const thud_world *w, size_t *out_bytes) {
    if (!w || !out_bytes) {
        return td_refuse(w, THUD_ERROR_NULL, "snapshot size: world or bytes is null");
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "snapshot size: not inside a callback");
    }
    *out_bytes = (size_t)td_snapshot_head_of(td_unconst(w)).bytes;
    return THUD_OK;
}

thud_result thud_world_snapshot(const thud_world *w, void *buffer, size_t capacity,
                                size_t *out_bytes) {
    if (!w || !buffer) {
        return td_refuse(w, THUD_ERROR_NULL, "snapshot: world or buffer is null");
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "snapshot: not inside a callback");
    }
    td_snapshot_head head = td_snapshot_head_of(td_unconst(w));
    if (head.bytes > capacity) {
        return td_refuse(w, THUD_ERROR_INVALID, "snapshot: the buffer is too small");
    }
    char *to = buffer;
    size_t size = (size_t)head.bytes;
    memcpy(to, &head, sizeof head);
    td_snapshot_write(td_unconst(w), &head, to + sizeof head);
    if (w->rule_hooks) {
        w->rule_hooks->write(w, to + sizeof head + td_snapshot_ruled_at(&head));
    }
    if (w->texture_hooks) {
        w->texture_hooks->write(w, to + sizeof head + td_snapshot_textured_at(&head));
    }
    head.checksum =
        td_snapshot_checksum(to + TD_SNAPSHOT_SUMMED_FROM, size - TD_SNAPSHOT_SUMMED_FROM);
    memcpy(to, &head, TD_SNAPSHOT_SUMMED_FROM);
    if (out_bytes) {
        *out_bytes = size;
    }
    return THUD_OK;
}

/* ---- restoring ---- */

bool td_snapshot_counts_valid(const td_snapshot_head *head) {
    bool valid = head->detection >= 0 && head->detection < TD_RANK_COUNT && head->bins >= 0;
    int64_t max = INT32_MAX / 16; /* elements that an array can hold: memory.c */
    for (int i = 0; i < 2; i++) {
        valid = valid && head->levels[i] >= 0 && head->levels[i] <= TD_LEVELS;
    }
    for (int i = 0; i < TD_SNAPSHOT_SLOTS; i++) {
        const td_snapshot_slots *s = &head->slots[i];
        valid = valid && s->count >= 0 && s->count <= max && s->live >= 0 && s->live <= s->count &&
                s->free_head >= TD_NONE && s->free_head < s->count;
    }
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        const td_snapshot_part *p = &head->parts[i];
        valid = valid && p->count >= 0 && p->count <= max && p->used >= 0 && p->used <= max;
    }
    for (int i = 0; i < TD_CONSTRAINT_KINDS; i++) {
        valid = valid && head->constraints[i] >= 0 && head->constraints[i] <= max;
    }
    return valid && head->ruled.rules >= 0 && head->ruled.rules <= TD_RULES_MAX &&
           head->ruled.impulses >= 0 && head->ruled.impulses <= max;
}

/* Whether the lengths of arrays in the snapshot are valid: an array with an element for each body,
 * shape or awake slot must have as many as there are of these, and no list may be longer than the
 * room that it will get. */
static bool lengths_valid(thud_world *w, const td_snapshot_head *head) {
    const td_snapshot_part *parts = head->parts;
    td_part own[TD_SNAPSHOT_PARTS];
    td_snapshot_list_parts(w, head, own);
    int slots = parts[TD_SNAPSHOT_AWAKE + TD_AWAKE_body_of].count;
    bool valid = slots > 0 && slots <= head->slots[TD_SNAPSHOT_BODIES].live + 1 &&
                 parts[TD_SNAPSHOT_POSE].used == head->slots[TD_SNAPSHOT_BODIES].count &&
                 parts[TD_SNAPSHOT_MOVED].count <= head->slots[TD_SNAPSHOT_SHAPES].count &&
                 parts[TD_SNAPSHOT_CHANGED].count <= head->slots[TD_SNAPSHOT_BODIES].count;
    for (int i = TD_SNAPSHOT_PROXY; i <= TD_SNAPSHOT_MARKS; i++) {
        valid = valid && parts[i].used == head->slots[TD_SNAPSHOT_SHAPES].count;
    }
    for (int i = 0; i < TD_AWAKE_ARRAY_COUNT; i++) {
        valid = valid && parts[TD_SNAPSHOT_AWAKE + i].used >= (td_awake_is_state[i] ? slots : 0);
    }
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        valid = valid && parts[TD_SNAPSHOT_WAITING + kind].count <= head->constraints[kind];
    }
    for (int p = 0; p < 2; p++) {
        const td_snapshot_part *set =
            &parts[TD_SNAPSHOT_PROXY_SETS + p * TD_SNAPSHOT_PROXY_SET_PARTS];
        for (int i = TD_SNAPSHOT_IDS; i <= TD_SNAPSHOT_PLACES_MOVED; i++) {
            valid = valid && set[i].used >= set[TD_SNAPSHOT_IDS].count;
        }
    }
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        valid = valid && parts[i].count <= td_max_int(parts[i].used, own[i].room);
    }
    return valid;
}

/* Entry i of the table of snapshot.h, which may be unaligned. */
static int32_t table_at(const char *table, int i) {
    int32_t value;
    memcpy(&value, table + (size_t)i * sizeof value, sizeof value);
    return value;
}

/* Whether the table's points and live blocks add up to those of the head. */
static bool table_valid(const td_snapshot_head *head, const char *table) {
    uint64_t points = 0;
    bool valid = true;
    int at = 0;
    for (; at < head->slots[TD_SNAPSHOT_TERRAINS].count; at++) {
        valid = valid && table_at(table, at) >= 0;
        points += (uint64_t)table_at(table, at);
    }
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        const td_snapshot_slots *pool = &head->slots[TD_SNAPSHOT_BLOCK_POOLS + form];
        int live = 0;
        for (int end = at + pool->count; at < end; at++) {
            live += table_at(table, at) == TD_SNAPSHOT_LIVE;
        }
        valid = valid && live == pool->live;
    }
    return valid && points == head->points;
}

/* The bytes of the rules in a snapshot. */
static const char *ruled_in(const td_snapshot_head *head, const char *from) {
    return from + sizeof *head + td_snapshot_ruled_at(head);
}

/* The bytes of the textures in a snapshot. */
static const char *textured_in(const td_snapshot_head *head, const char *from) {
    return from + sizeof *head + td_snapshot_textured_at(head);
}

/* Whether the bytes of textures are valid. A world without texture hooks gets here only with a
 * snapshot that has none. The table begins with the points of each terrain. */
static bool textures_valid(const thud_world *w, const td_snapshot_head *head, const char *from) {
    return !w->texture_hooks ||
           w->texture_hooks->valid(textured_in(head, from), head->textured, from + sizeof *head,
                                   head->slots[TD_SNAPSHOT_TERRAINS].count);
}

/* Whether the bytes of rules are valid. A world without rule hooks gets here only with a snapshot
 * that has none. */
static bool rules_valid(const thud_world *w, const td_snapshot_head *head, const char *from) {
    return !w->rule_hooks || w->rule_hooks->valid(w, head->ruled, ruled_in(head, from));
}

/* The reason why the snapshot cannot be restored to this world, or null. Copies its head to *head.
 */
static const char *fault_of(thud_world *w, const char *from, size_t bytes, td_snapshot_head *head) {
    if (bytes < sizeof *head) {
        return "restore: too short for a snapshot";
    }
    memcpy(head, from, sizeof *head);
    td_snapshot_head own = td_snapshot_head_of(w);
    if (memcmp(head->magic, own.magic, sizeof own.magic) != 0) {
        return "restore: this is no snapshot of a thud world";
    }
    if (head->version != own.version || head->layout != own.layout) {
        return "restore: the snapshot is of another version or build of thud";
    }
    if (head->bytes != bytes) {
        return "restore: the snapshot is cut short, or has something after it";
    }
    if (head->checksum !=
        td_snapshot_checksum(from + TD_SNAPSHOT_SUMMED_FROM, bytes - TD_SNAPSHOT_SUMMED_FROM)) {
        return "restore: the snapshot is damaged";
    }
    if (head->length_scale != own.length_scale) {
        return "restore: the snapshot is of a world with another length scale";
    }
    if (memcmp(head->broadphase, own.broadphase, sizeof own.broadphase) != 0) {
        return "restore: the snapshot is of a world with another broadphase";
    }
    if (memcmp(&head->settings, &own.settings, sizeof own.settings) != 0) {
        return "restore: the snapshot is of a world whose def has other settings";
    }
    if (head->slots[TD_SNAPSHOT_JOINTS].live > 0 &&
        (head->plugged & ~own.plugged & TD_SNAPSHOT_ALL_JOINTS)) {
        return "restore: the snapshot has joints that this world never had";
    }
    if ((head->ruled.rules || head->ruled.impulses) && !w->rule_hooks) {
        return "restore: the snapshot has rules, and this world never had any";
    }
    if (head->textured && !w->texture_hooks) {
        return "restore: the snapshot has textures, and this world never had any";
    }
    if (!td_snapshot_counts_valid(head) || head->textured > bytes || !lengths_valid(w, head) ||
        td_snapshot_bytes_of(w, head) != bytes || !table_valid(head, from + sizeof *head) ||
        !rules_valid(w, head, from) || !textures_valid(w, head, from)) {
        return "restore: the snapshot contradicts itself";
    }
    return NULL;
}

/* Frees point arrays of slots that no terrain uses. */
static void free_spare_lines(thud_world *w) {
    for (int i = 0; i < td_slots_capacity(&w->terrains); i++) {
        td_terrain_record *record = td_terrain_record_at(w, i);
        if (i >= w->terrains.count || record->shape == TD_NONE) {
            td_array_free(&w->memory, &record->points);
        }
    }
}

/* Reserves memory for the world of the snapshot; the content of the world stays. False when memory
 * is short. */
static bool reserve(thud_world *w, const td_snapshot_head *head, const char *from) {
    const char *table = from + sizeof *head;
    td_slots *slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_list_slots(w, slots);
    for (int i = 0; i < TD_SNAPSHOT_SLOTS; i++) {
        if (!td_slots_reserve(&w->memory, slots[i], head->slots[i].count - slots[i]->live)) {
            return false;
        }
    }
    td_part parts[TD_SNAPSHOT_PARTS];
    td_snapshot_list_parts(w, head, parts);
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        int room = td_max_int(parts[i].room, head->parts[i].used);
        if (!td_array_reserve(&w->memory, parts[i].array, room)) {
            return false;
        }
    }
    for (int i = 0; i < head->slots[TD_SNAPSHOT_TERRAINS].count; i++) {
        td_terrain_record *record = td_terrain_record_at(w, i);
        record->points.stride = (int)sizeof(thud_pos);
        if (!td_array_reserve(&w->memory, &record->points, table_at(table, i))) {
            return false;
        }
    }
    return (!w->rule_hooks || w->rule_hooks->make_room(w, head->ruled)) &&
           (!w->texture_hooks ||
            w->texture_hooks->make_room(w, textured_in(head, from), head->textured));
}

/* Empties caches and lists that the steps so far have left for later ones. */
static void clear_scratch(thud_world *w) {
    w->scratch.sequenced = false;
    w->scratch.bin_end[0] = TD_COLOURS;
    w->scratch.bin_end[1] = 2 * TD_COLOURS;
    w->scratch.placed_end = TD_BINS_A_KIND + w->placed_bins.count;
    w->scratch.blocks.count = w->scratch.runs.count = w->scratch.impacts.count = 0;
    w->islands.island.count = w->islands.slots.count = w->islands.constraints.count = 0;
    w->islands.local.count = 0;
    w->preview.shape.count = 0;
    w->preview.stale = true;
}

thud_result thud_world_restore(thud_world *w, const void *buffer, size_t bytes) {
    td_snapshot_head head;
    if (!w || !buffer) {
        return td_refuse(w, THUD_ERROR_NULL, "restore: world or buffer is null");
    }
    if (w->locked || w->advancing) {
        return td_refuse(w, THUD_ERROR_LOCKED, "restore: not inside a callback");
    }
    const char *from = buffer, *fault = fault_of(w, from, bytes, &head);
    if (fault) {
        return td_refuse(w, THUD_ERROR_INVALID, fault);
    }
    bool room = reserve(w, &head, from);
    if (room) {
        td_snapshot_read(w, &head, from + sizeof head);
        if (w->rule_hooks) {
            w->rule_hooks->read(w, head.ruled, ruled_in(&head, from));
        }
        if (w->texture_hooks) {
            w->texture_hooks->read(w, textured_in(&head, from), head.textured);
        }
        clear_scratch(w);
    }
    free_spare_lines(w);
    return room ? THUD_OK : td_refuse(w, THUD_ERROR_MEMORY, "restore: out of memory");
}
