/* packed.c: packs snapshots, alone or against a base (thud_packed.h). Packed bytes are, in the byte
 * order of the machine, packed_head | the head of the snapshot | its sections in the order of
 * td_packed_order. A section is packed in chunks of 1024 records, or 128 blocks (CHUNK_WORDS). A
 * chunk begins with a byte. CHUNK_SAME: the chunk is equal to the base's, and nothing follows.
 * CHUNK_COLUMNS: the columns of its records follow (packed_column.h). */
#include "sessions/packed.h"
#include "sessions/packed_column.h"
#include "state/handles.h"

#include "thud/thud_packed.h"

#include <string.h>

#define MAGIC "thudpack"

/* To be raised whenever the same snapshot is packed to different bytes: if the format changes, or a
 * prediction of packed_known.c. */
enum { PACKED_VERSION = 1 };

typedef struct packed_head {
    char magic[8];
    uint64_t checksum;       /* td_snapshot_checksum of all bytes after this field */
    uint64_t version;        /* PACKED_VERSION */
    uint64_t bytes;          /* size of all packed bytes, this head included */
    uint64_t snapshot_bytes; /* size of the snapshot that is packed */
    uint64_t base_bytes;     /* of the base; 0: none */
    uint64_t base_checksum;  /* its td_snapshot_head.checksum; 0: none */
} packed_head;

enum { SUMMED_FROM = offsetof(packed_head, checksum) + sizeof(uint64_t) };

/* First bytes of chunks. */
enum { CHUNK_SAME, CHUNK_COLUMNS };

/* Words of a column in a chunk. Every column passes over all records of the chunk, which therefore
 * have to fit in the cache. A multiple of TD_PACKED_GROUP squared, so that a chunk of blocks
 * (CHUNK_WORDS / lanes) also begins with a whole group. Chosen. */
enum { CHUNK_WORDS = 1024 };

/* More words than the longest record has, a block with the rows of a joint. */
enum { RECORD_WORDS_MAX = 1024 };
#define LONGEST_BLOCK                                                                            \
    (sizeof(td_block) + 2 * (sizeof(td_point) + sizeof(td_point_history)) + sizeof(td_surface) + \
     sizeof(td_lock_rows) + sizeof(td_drive_rows) + sizeof(td_gear_rows))
_Static_assert(LONGEST_BLOCK <= RECORD_WORDS_MAX * sizeof(uint32_t) &&
                   sizeof(td_joint) <= RECORD_WORDS_MAX * sizeof(uint32_t),
               "no record has more words");

/* One call that packs or unpacks; the code that goes through the columns is the same for both. */
typedef struct passage {
    td_packed_stream stream;
    td_packed_pair pair;
    bool packs;
} passage;

/* Finds the sections by the head. False where the head does not fit the bytes. */
static bool find_sections(thud_world *w, td_packed_image *i, size_t bytes) {
    td_snapshot_head own = td_snapshot_head_of(w);
    const td_snapshot_head *head = &i->head;
    if (memcmp(head->magic, own.magic, sizeof own.magic) != 0 || head->version != own.version ||
        head->layout != own.layout || head->bytes != bytes || head->textured > bytes ||
        !td_snapshot_counts_valid(head)) {
        return false;
    }
    td_snapshot_list_sections(w, head, i->sections);
    i->to_fixed = TD_FIXED_ONE / head->length_scale;
    uint64_t at = sizeof *head;
    for (int k = 0; k < TD_SECTION_COUNT; k++) {
        i->at[k] = at;
        at += i->sections[k].bytes;
    }
    return at == bytes;
}

/* Whether the bytes are a whole snapshot of this build. */
static bool open_image(thud_world *w, td_packed_image *i, thud_bytes bytes) {
    union {
        const void *given;
        uint8_t *same;
    } pointer = {bytes.data};
    i->bytes = pointer.same;
    if (bytes.count < sizeof i->head) {
        return false;
    }
    memcpy(&i->head, bytes.data, sizeof i->head);
    return find_sections(w, i, bytes.count) &&
           i->head.checksum == td_snapshot_checksum(i->bytes + TD_SNAPSHOT_SUMMED_FROM,
                                                    bytes.count - TD_SNAPSHOT_SUMMED_FROM);
}

/* ---- sections ---- */

static void pass_column(passage *p, const td_packed_column *column) {
    if (p->packs) {
        td_packed_write(&p->stream, column);
    } else {
        td_packed_read(&p->stream, column);
    }
}

/* A chunk of a section: the records column.first to column.end - 1. */
typedef struct chunk {
    int section;
    td_packed_column column; /* the members that are the same for all of the chunk's columns */
    const uint8_t *base;     /* record 0 of the section in the base; null: there is no base */
    uint8_t *words;          /* record 0 */
    /* By word of a record: the bits in which any record of the chunk differs from the base's. Set
     * only when packing, and only if the base has all records of the chunk. */
    uint32_t changed[RECORD_WORDS_MAX];
} chunk;

/* Whether all records are in the base. */
static bool is_in_base(const chunk *c) {
    return c->base && c->column.end <= c->column.base_records;
}

/* Sets `changed`, in one pass over the records. */
static void find_changes(chunk *c) {
    size_t stride = c->column.stride, words = stride / sizeof(uint32_t);
    memset(c->changed, 0, words * sizeof *c->changed);
    for (size_t r = c->column.first; r < c->column.end; r++) {
        const uint8_t *now = c->words + r * stride, *was = c->base + r * stride;
        for (size_t i = 0; i < words; i++) {
            uint32_t a, b;
            memcpy(&a, now + i * sizeof a, sizeof a);
            memcpy(&b, was + i * sizeof b, sizeof b);
            c->changed[i] |= a ^ b;
        }
    }
}

/* Whether all words of the column at byte `at` of the records are equal to the base's. For packing.
 */
static bool is_same(const chunk *c, const td_packed_column *column, size_t at) {
    uint32_t changed = 0;
    if (!is_in_base(c)) {
        return false;
    }
    for (size_t r = column->first; column->width == 1 && r < column->end; r++) {
        changed |= c->words[r * column->stride + at] ^ c->base[r * column->stride + at];
    }
    for (int i = 0; column->width != 1 && i < column->lanes; i++) {
        changed |= c->changed[at / sizeof(uint32_t) + (size_t)i];
    }
    return changed == 0;
}

/* Packs or unpacks the columns of one pass (td_packed_pass_of). */
static void pass_columns(passage *p, const chunk *c, int pass) {
    td_packed_column column = c->column;
    size_t each = (size_t)column.width * (size_t)column.lanes;
    for (size_t at = 0; at < column.stride; at += each) {
        if (column.stride - at < each) {
            column.lanes = column.width = 1;
            each = 1;
        }
        td_packed_field field = {&p->pair, c->section, at};
        column.base = c->base ? c->base + at : NULL;
        column.words = c->words + at;
        column.context = &field;
        column.known = each > 1 && td_packed_follows(&field) ? td_packed_known : NULL;
        if (td_packed_pass_of(c->section, at) == pass) {
            column.same = p->packs && is_same(c, &column, at);
            pass_column(p, &column);
        }
    }
}

static void pass_chunk(passage *p, chunk *c) {
    bool in_base = is_in_base(c), blocks = c->column.lanes > 1;
    size_t stride = c->column.stride, at = c->column.first * stride;
    size_t bytes = (c->column.end - c->column.first) * stride;
    uint8_t how = CHUNK_COLUMNS;
    if (p->packs) {
        if (in_base && memcmp(c->words + at, c->base + at, bytes) == 0) {
            how = CHUNK_SAME;
        } else if (in_base) {
            find_changes(c);
        }
        td_packed_put(&p->stream, how);
    } else {
        how = td_packed_take(&p->stream);
        if (how > CHUNK_COLUMNS || (how == CHUNK_SAME && !in_base)) {
            p->stream.broken = true;
        } else if (in_base) {
            memcpy(c->words + at, c->base + at, bytes);
        }
    }
    c->column.copied = in_base;
    for (int pass = 0; how == CHUNK_COLUMNS && pass < (blocks ? TD_PACKED_PASSES : 1); pass++) {
        pass_columns(p, c, pass);
    }
}

static void pass_section(passage *p, int k) {
    const td_packed_image *base = &p->pair.base;
    const td_snapshot_section *section = &p->pair.now.sections[k];
    size_t stride = section->stride, bytes = (size_t)section->bytes;
    size_t base_bytes = base->bytes ? (size_t)base->sections[k].bytes : 0;
    if (bytes == 0) {
        return;
    }
    bool blocks = k >= TD_SECTION_BLOCKS && k < TD_SECTION_PARTS;
    size_t records = bytes / stride;
    chunk c;
    c.section = k;
    c.words = p->pair.now.bytes + p->pair.now.at[k];
    c.base = base_bytes ? base->bytes + base->at[k] : NULL;
    c.column = (td_packed_column){.stride = stride,
                                  .base_records = base_bytes / stride,
                                  .width = stride < sizeof(uint32_t) ? 1 : (int)sizeof(uint32_t),
                                  .lanes = blocks ? TD_PACKED_GROUP : 1};
    size_t length = CHUNK_WORDS / (size_t)c.column.lanes;
    for (size_t first = 0; first < records && !p->stream.broken; first = c.column.end) {
        c.column.first = first;
        c.column.end = records - first < length ? records : first + length;
        pass_chunk(p, &c);
    }
    size_t rest = bytes % stride;
    if (rest) {
        td_packed_column column = {
            .stride = 1, .end = rest, .width = 1, .lanes = 1, .words = c.words + bytes - rest};
        pass_column(p, &column);
    }
}

/* Packs or unpacks the snapshot's head, as a column of words. */
static void pass_head(passage *p) {
    td_packed_column column = {.stride = 4,
                               .end = sizeof(td_snapshot_head) / 4,
                               .width = 4,
                               .lanes = 1,
                               .base = p->pair.base.bytes,
                               .words = p->pair.now.bytes};
    column.base_records = p->pair.base.bytes ? column.end : 0;
    pass_column(p, &column);
}

static void pass_sections(passage *p) {
    int order[TD_SECTION_COUNT];
    td_packed_order(order);
    for (int k = 0; k < TD_SECTION_COUNT; k++) {
        pass_section(p, order[k]);
    }
}

/* ---- packing ---- */

/* Checks the arguments of thud_world_pack and thud_world_unpack. `bytes`: the snapshot, or the
 * packed bytes. */
static thud_result check(const thud_world *w, thud_bytes base, thud_bytes bytes, const void *buffer,
                         size_t capacity, const size_t *out_bytes) {
    if (!w || !bytes.data || !out_bytes || (!buffer && capacity > 0) ||
        (!base.data && base.count > 0)) {
        return td_refuse(w, THUD_ERROR_NULL, "pack or unpack: world, bytes or out_bytes is null");
    }
    return w->locked ? td_refuse(w, THUD_ERROR_LOCKED, "pack or unpack: not inside a callback")
                     : THUD_OK;
}

bool td_is_packed(const void *bytes, size_t count) {
    return count >= sizeof MAGIC - 1 && memcmp(bytes, MAGIC, sizeof MAGIC - 1) == 0;
}

thud_result thud_world_pack(const thud_world *w, thud_bytes base, thud_bytes snapshot, void *buffer,
                            size_t capacity, size_t *out_bytes) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = check(w, base, snapshot, buffer, capacity, out_bytes);
    if (result != THUD_OK) {
        return result;
    }
    passage p = {.packs = true, .stream = {.at = sizeof(packed_head)}};
    thud_world *world = td_unconst(w);
    if ((base.data && !open_image(world, &p.pair.base, base)) ||
        !open_image(world, &p.pair.now, snapshot)) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "pack: base or snapshot is no whole snapshot of this build of thud");
    }
    if (capacity < td_packed_max(snapshot.count)) { /* count before anything is written */
        pass_head(&p);
        pass_sections(&p);
        if (buffer && p.stream.at > capacity) {
            return td_refuse(w, THUD_ERROR_INVALID, "pack: the buffer is too small");
        }
        *out_bytes = p.stream.at;
    }
    if (buffer) {
        p.stream = (td_packed_stream){.to = buffer, .at = sizeof(packed_head)};
        pass_head(&p);
        pass_sections(&p);
        packed_head head = {.magic = MAGIC,
                            .version = PACKED_VERSION,
                            .bytes = p.stream.at,
                            .snapshot_bytes = snapshot.count,
                            .base_bytes = base.count,
                            .base_checksum = p.pair.base.head.checksum};
        memcpy(buffer, &head, sizeof head);
        head.checksum =
            td_snapshot_checksum((char *)buffer + SUMMED_FROM, p.stream.at - SUMMED_FROM);
        memcpy(buffer, &head, sizeof head);
        *out_bytes = p.stream.at;
    }
    return THUD_OK;
}

/* ---- unpacking ---- */

/* The reason why the bytes cannot be unpacked, or null. Copies their head to *head. */
static const char *fault_of(thud_world *w, passage *p, thud_bytes base, thud_bytes packed,
                            packed_head *head) {
    const char *from = packed.data;
    if (packed.count < sizeof *head) {
        return "unpack: too short for a packed snapshot";
    }
    memcpy(head, from, sizeof *head);
    if (memcmp(head->magic, MAGIC, sizeof head->magic) != 0) {
        return "unpack: this is no packed snapshot";
    }
    if (head->bytes != packed.count ||
        head->checksum != td_snapshot_checksum(from + SUMMED_FROM, packed.count - SUMMED_FROM)) {
        return "unpack: the packed snapshot is damaged or cut short";
    }
    if (head->version != PACKED_VERSION) {
        return "unpack: the packed snapshot is of another version of thud";
    }
    if (head->base_bytes != base.count || (base.data && !open_image(w, &p->pair.base, base)) ||
        head->base_checksum != p->pair.base.head.checksum) {
        return "unpack: this is not the base with which the snapshot was packed";
    }
    return NULL;
}

/* Unpacks into the buffer. False where the bytes contradict themselves. */
static bool unpack(thud_world *w, passage *p, uint8_t *buffer, size_t bytes) {
    p->pair.now.bytes = buffer;
    pass_head(p);
    memcpy(&p->pair.now.head, buffer, sizeof p->pair.now.head);
    if (p->stream.broken || !find_sections(w, &p->pair.now, bytes)) {
        return false;
    }
    pass_sections(p);
    return !p->stream.broken && p->stream.at == p->stream.end &&
           p->pair.now.head.checksum == td_snapshot_checksum(buffer + TD_SNAPSHOT_SUMMED_FROM,
                                                             bytes - TD_SNAPSHOT_SUMMED_FROM);
}

thud_result thud_world_unpack(const thud_world *w, thud_bytes base, thud_bytes packed, void *buffer,
                              size_t capacity, size_t *out_bytes) {
    TD_IN_OWN_FLOAT_MODE;
    thud_result result = check(w, base, packed, buffer, capacity, out_bytes);
    if (result != THUD_OK) {
        return result;
    }
    passage p = {.packs = false};
    packed_head head;
    thud_world *world = td_unconst(w);
    const char *fault = fault_of(world, &p, base, packed, &head);
    if (fault) {
        return td_refuse(w, THUD_ERROR_INVALID, fault);
    }
    if (buffer && capacity < head.snapshot_bytes) {
        return td_refuse(w, THUD_ERROR_INVALID, "unpack: the buffer is too small");
    }
    size_t bytes = (size_t)head.snapshot_bytes;
    bool is_size = bytes == head.snapshot_bytes && bytes >= sizeof(td_snapshot_head);
    p.stream = (td_packed_stream){.from = packed.data, .at = sizeof head, .end = packed.count};
    if (!is_size || (buffer && !unpack(world, &p, buffer, bytes))) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "unpack: the packed snapshot is of another version or build of thud, or "
                         "contradicts itself");
    }
    *out_bytes = bytes;
    return THUD_OK;
}
