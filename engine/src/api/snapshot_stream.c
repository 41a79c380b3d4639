/* snapshot_stream.c: the values of a snapshot. serialize_all goes through all values once, in one
 * order; the direction of the stream decides whether it writes or reads them. The layout is that of
 * snapshot.h. */
#include "api/snapshot.h"

#include "constraint/joint_hooks.h"
#include "constraint/lanes.h"
#include "contact/sensors.h"
#include "solver/error.h"
#include "solver/restitution.h"
#include "state/sleep_hooks.h"
#include "state/body.h"
#include "state/kinds.h"

#include <string.h>

/* The fields of thud_world that are state, by offset and size. */
#define FIELD(name) \
    { offsetof(thud_world, name), sizeof((thud_world *)0)->name }
#define PROXY_SET_FIELDS(p)                                                                       \
    FIELD(p.moved_count), FIELD(p.woken), FIELD(p.listed), FIELD(p.loose), FIELD(p.valid),        \
        FIELD(p.origin_x), FIELD(p.origin_y), FIELD(p.end_x), FIELD(p.end_y), FIELD(p.reference), \
        FIELD(p.widest), FIELD(p.axis)

static const struct {
    size_t at, bytes;
} FIELDS[] = {
    /* Settings with a setter. The pointers among them are in head.plugged and head.detection. */
    FIELD(def.gravity),
    FIELD(def.time_step),
    FIELD(def.sleeping),
    FIELD(def.max_error),
    FIELD(quality.substeps),
    FIELD(quality.contact_stiffness),
    FIELD(quality.contact_damping),
    FIELD(quality.overlap_limit),
    FIELD(quality.island_limit),
    FIELD(quality.island_work),
    FIELD(quality.island_slow_steps),
    FIELD(substeps),
    FIELD(skin),
    FIELD(number), /* so that handles stay valid */
    FIELD(steps),
    FIELD(spare_time),
    FIELD(begun),
    FIELD(gathers),
    FIELD(paired),
    FIELD(narrowed),
    FIELD(rest_epoch),
    FIELD(touching),
    FIELD(bouncy),
    FIELD(surface_speeds),
    FIELD(sensors),
    FIELD(mobile_sensors),
    FIELD(breakable),
    FIELD(damped),
    FIELD(substep_gain_stale),
    FIELD(kinetic),
    FIELD(kinetic_stale),
    FIELD(idle_bodies),
    FIELD(thinnest),
    FIELD(thinnest_stale),
    FIELD(drowsy_bodies),
    FIELD(vast),
    PROXY_SET_FIELDS(awake_shapes),
    PROXY_SET_FIELDS(rest_shapes),
    FIELD(errors),
    FIELD(budget),
    FIELD(stats)};
enum { FIELD_COUNT = sizeof FIELDS / sizeof *FIELDS };

/* A body is stored as the bytes before td_body.detection, one byte for the detection's rank in
 * place of its address, and the bytes from user_data on. */
enum {
    BODY_FRONT = offsetof(td_body, detection),
    BODY_BACK = offsetof(td_body, user_data),
    BODY_BYTES = BODY_FRONT + 1 + sizeof(td_body) - BODY_BACK
};

/* The bytes of a terrain record before its array of points. The points are stored after these
 * bytes. */
enum { TERRAIN_BYTES = offsetof(td_terrain_record, points) };

enum {
    BIN_BYTES = sizeof(int32_t) + sizeof(td_bin),
    BIN_COUNT = TD_CONSTRAINT_KINDS * TD_BINS_A_KIND
};

/* Detections by rank. */
static const thud_detection *const DETECTIONS[TD_RANK_COUNT] = {&thud_detection_overlap,
                                                                &thud_detection_continuous,
                                                                &thud_detection_bisect,
                                                                &thud_detection_swept};

/* By shape kind: the function that plugs it into a world, and the pair kind that the world has
 * exactly if the shape kind is plugged in. */
#define KIND_ROW(kind, plug, own) [kind] = {plug, own},
static const struct {
    void (*plug)(thud_world *w);
    td_pair_kind own;
} KINDS[] = {TD_ALL_KINDS(KIND_ROW)};
_Static_assert(sizeof KINDS / sizeof *KINDS == THUD_SHAPE_KIND_COUNT, "every kind has its line");

/* ---- the head ---- */

/* No pointer is in the bytes, so that builds of 32 bits whose records have the sizes of a build of
 * 64 bits, as WebAssembly's have, read and write the same bytes. Records that contain pointers
 * enter the hash with their size in a build of 64 bits. */
enum { POINTER_BYTES = 8, ARRAY_BYTES = 24 };
_Static_assert(sizeof(void *) != POINTER_BYTES || sizeof(td_array) == ARRAY_BYTES,
               "the size of an array's record in a build of 64 bits");

/* A hash of the sizes of all records and of the byte order (by the bytes of 0x01020304). */
static uint32_t layout_of_build(void) {
#define ELEMENT_BYTES(name, element, is_state) sizeof(element),
    const uint32_t sizes[] = {0x01020304,
                              TD_AWAKE_ARRAYS(ELEMENT_BYTES) sizeof(td_snapshot_head),
                              POINTER_BYTES,
                              sizeof(td_body),
                              sizeof(td_shape),
                              sizeof(td_contact),
                              TERRAIN_BYTES + ARRAY_BYTES,
                              sizeof(td_pose),
                              sizeof(td_shape_proxy),
                              sizeof(td_deferred_edit),
                              sizeof(td_level),
                              (uint32_t)td_form_bytes(TD_FORM_ONE),
                              (uint32_t)td_form_bytes(TD_FORM_TWO_CACHED),
                              sizeof(td_joint),
                              sizeof(td_kept_rule),
                              sizeof(td_force_record),
                              sizeof(thud_impulse_event),
                              sizeof(td_errors),
                              sizeof(td_budget),
                              sizeof(thud_stats),
                              sizeof(thud_hit_event),
                              BIN_COUNT,
                              TD_LEVELS};
    return (uint32_t)td_snapshot_checksum(sizes, sizeof sizes);
}

/* td_snapshot_head.plugged of the world. */
static uint32_t plugged_into(const thud_world *w) {
    uint32_t plugged = w->quality.islands ? TD_SNAPSHOT_ISLANDS : 0u;
    plugged |= w->sensor_hooks ? 0u : TD_SNAPSHOT_NO_SENSORS;
    plugged |= w->restitution_hooks ? 0u : TD_SNAPSHOT_NO_RESTITUTION;
    plugged |= w->error_hooks ? 0u : TD_SNAPSHOT_NO_ERRORS;
    plugged |= w->sleep_hooks ? 0u : TD_SNAPSHOT_NO_SLEEP;
    for (int kind = 0; kind < THUD_SHAPE_KIND_COUNT; kind++) {
        plugged |= w->kinds[KINDS[kind].own] ? 1u << kind : 0u;
    }
    for (int rank = 0; rank < TD_RANK_COUNT; rank++) {
        plugged |= w->detections[rank] ? (uint32_t)TD_SNAPSHOT_DETECTIONS << rank : 0u;
    }
    for (int kind = TD_PAIR_COUNT; kind < TD_CONSTRAINT_KINDS; kind++) {
        plugged |=
            w->kinds[kind] ? (uint32_t)TD_SNAPSHOT_JOINT_KINDS << (kind - TD_PAIR_COUNT) : 0u;
    }
    return plugged;
}

static td_snapshot_settings settings_of(const thud_world_def *d) {
    return (td_snapshot_settings){
        .substeps = (double)d->substeps,
        .contact_stiffness = (double)d->contact_stiffness,
        .contact_damping = (double)d->contact_damping,
        .push_speed = (double)d->push_speed,
        .restitution_threshold = (double)d->restitution_threshold,
        .hit_speed = (double)d->hit_speed,
        .maximum_speed = (double)d->maximum_speed,
        .contact_events = (double)d->contact_events,
        .time_budget = d->time_budget,
        .detection = d->detection ? (double)d->detection->rank : -1.0,
    };
}

/* The number of grid levels from the first one with shapes on. */
static int levels_of(const td_proxy_set *p) {
    int first = 0;
    while (first < TD_LEVELS && p->levels[first].count == 0) {
        first++;
    }
    return TD_LEVELS - first;
}

/* The points of all terrains. */
static uint64_t points_of(const thud_world *w) {
    uint64_t points = 0;
    for (int i = 0; i < w->terrains.count; i++) {
        const td_terrain_record *record = td_terrain_record_at(w, i);
        points += (uint64_t)record->points.count;
    }
    return points;
}

td_snapshot_head td_snapshot_head_of(thud_world *w) {
    td_snapshot_head head = {.magic = TD_SNAPSHOT_MAGIC,
                             .version = TD_SNAPSHOT_VERSION,
                             .layout = layout_of_build(),
                             .length_scale = (double)w->length_scale,
                             .settings = settings_of(&w->def),
                             .plugged = plugged_into(w),
                             .detection = w->quality.detection->rank,
                             .levels = {levels_of(&w->awake_shapes), levels_of(&w->rest_shapes)},
                             .points = points_of(w)};
    strncpy(head.broadphase, w->def.broadphase->name, sizeof head.broadphase - 1);
    memcpy(head.constraints, w->constraint_count, sizeof head.constraints);
    const td_bin *bins = w->bins[0].of;
    for (int i = 0; i < BIN_COUNT; i++) {
        head.bins += bins[i].lanes > 0;
    }
    td_slots *slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_list_slots(w, slots);
    for (int i = 0; i < TD_SNAPSHOT_SLOTS; i++) {
        head.slots[i] = (td_snapshot_slots){slots[i]->count, slots[i]->free_head, slots[i]->live};
    }
    td_part parts[TD_SNAPSHOT_PARTS];
    td_snapshot_list_parts(w, &head, parts);
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        head.parts[i] = (td_snapshot_part){parts[i].array->count, parts[i].used};
    }
    if (w->rule_hooks) {
        head.ruled = w->rule_hooks->ruled(w);
    }
    if (w->texture_hooks) {
        head.textured = w->texture_hooks->bytes(w);
    }
    head.bytes = td_snapshot_bytes_of(w, &head);
    return head;
}

void td_snapshot_list_sections(thud_world *w, const td_snapshot_head *head,
                               td_snapshot_section sections[TD_SECTION_COUNT]) {
    const td_snapshot_slots *slots = head->slots;
    td_part parts[TD_SNAPSHOT_PARTS];
    td_snapshot_list_parts(w, head, parts);
    uint64_t fields = 0;
    for (int i = 0; i < FIELD_COUNT; i++) {
        fields += FIELDS[i].bytes;
    }
    const struct {
        uint64_t count;
        size_t stride;
    } records[TD_SECTION_BLOCKS] = {
        [TD_SECTION_TABLE] = {(uint64_t)td_snapshot_table_count(head), sizeof(int32_t)},
        [TD_SECTION_FIELDS] = {fields, 1},
        [TD_SECTION_BINS] = {(uint64_t)head->bins, BIN_BYTES},
        [TD_SECTION_LEVELS] = {(uint64_t)(head->levels[0] + head->levels[1]), sizeof(td_level)},
        [TD_SECTION_BODIES] = {(uint64_t)slots[TD_SNAPSHOT_BODIES].count, BODY_BYTES},
        [TD_SECTION_SHAPES] = {(uint64_t)slots[TD_SNAPSHOT_SHAPES].count, sizeof(td_shape)},
        [TD_SECTION_CONSTRAINTS] = {(uint64_t)slots[TD_SNAPSHOT_CONSTRAINTS].count,
                                    sizeof(td_contact)},
        [TD_SECTION_JOINTS] = {(uint64_t)slots[TD_SNAPSHOT_JOINTS].count, sizeof(td_joint)},
        [TD_SECTION_TERRAINS] = {(uint64_t)slots[TD_SNAPSHOT_TERRAINS].count * TERRAIN_BYTES +
                                     head->points * sizeof(thud_pos),
                                 1},
    };
    for (int i = 0; i < TD_SECTION_BLOCKS; i++) {
        size_t stride = records[i].stride;
        sections[i] = (td_snapshot_section){records[i].count * stride,
                                            stride == 1 ? sizeof(uint32_t) : stride};
    }
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        size_t stride = td_form_bytes((td_block_form)form);
        uint64_t live = (uint64_t)slots[TD_SNAPSHOT_BLOCK_POOLS + form].live;
        sections[TD_SECTION_BLOCKS + form] = (td_snapshot_section){live * stride, stride};
    }
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        size_t stride = (size_t)parts[i].array->stride;
        sections[TD_SECTION_PARTS + i] =
            (td_snapshot_section){(uint64_t)head->parts[i].used * stride, stride};
    }
    sections[TD_SECTION_RULED] =
        (td_snapshot_section){td_ruled_bytes(head->ruled), sizeof(uint32_t)};
    sections[TD_SECTION_TEXTURED] = (td_snapshot_section){head->textured, sizeof(uint32_t)};
}

size_t td_snapshot_field_at(size_t member) {
    size_t at = 0;
    for (int i = 0; FIELDS[i].at != member; i++) {
        at += FIELDS[i].bytes;
    }
    return at;
}

uint64_t td_snapshot_bytes_of(thud_world *w, const td_snapshot_head *head) {
    td_snapshot_section sections[TD_SECTION_COUNT];
    td_snapshot_list_sections(w, head, sections);
    uint64_t bytes = sizeof *head;
    for (int i = 0; i < TD_SECTION_COUNT; i++) {
        bytes += sections[i].bytes;
    }
    return bytes;
}

/* ---- the values ---- */

/* A position in the bytes of a snapshot, to be written or read. */
typedef struct stream {
    char *to; /* where the next bytes are written; null: the stream reads */
    const char *from;
} stream;

/* Writes `bytes` bytes of memory to the stream, or reads them from it. */
static void serialize(stream *t, void *memory, size_t bytes) {
    if (bytes && t->to) {
        memcpy(t->to, memory, bytes);
        t->to += bytes;
    } else if (bytes) {
        memcpy(memory, t->from, bytes);
        t->from += bytes;
    }
}

/* Writes or reads the table of snapshot.h. Reading also sets the counts of points and block->used.
 * A free block holds its next free slot in its first four bytes. */
static void serialize_table(stream *t, thud_world *w) {
    for (int i = 0; i < w->terrains.count; i++) {
        int32_t *count = &td_terrain_record_at(w, i)->points.count;
        serialize(t, count, sizeof *count);
    }
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        for (int i = 0; i < w->pool[form].count; i++) {
            td_block *block = td_slot_at(&w->pool[form], i);
            int32_t link = block->used ? TD_SNAPSHOT_LIVE : *(int32_t *)block;
            serialize(t, &link, sizeof link);
            if (!t->to) {
                block->used = link == TD_SNAPSHOT_LIVE; /* serialize_blocks reads the rest of it */
                *(int32_t *)block = link;
            }
        }
    }
}

/* Writes or reads the bins that have lanes, each after its index. */
static void serialize_bins(stream *t, thud_world *w, int count) {
    td_bin *bins = w->bins[0].of;
    if (!t->to) {
        memset(bins, 0, sizeof w->bins);
        td_array *placed = &w->placed_bins; /* the snapshot's bins by place are among its parts */
        if (placed->count) {
            memset(placed->data, 0, (size_t)placed->count * sizeof(td_bins));
        }
    }
    for (int32_t i = 0; t->to && i < BIN_COUNT; i++) {
        if (bins[i].lanes) {
            serialize(t, &i, sizeof i);
            serialize(t, &bins[i], sizeof bins[i]);
        }
    }
    for (int k = 0; !t->to && k < count; k++) {
        int32_t i = 0;
        serialize(t, &i, sizeof i);
        serialize(t, &bins[i], sizeof bins[i]);
    }
}

/* Writes or reads the last `count` grid levels; the levels before them are empty. */
static void serialize_levels(stream *t, td_proxy_set *p, int count) {
    if (!t->to) {
        memset(p->levels, 0, sizeof p->levels);
    }
    serialize(t, &p->levels[TD_LEVELS - count], (size_t)count * sizeof(td_level));
}

static void serialize_body(stream *t, td_body *body) {
    uint8_t rank = t->to ? (uint8_t)body->detection->rank : 0;
    serialize(t, body, BODY_FRONT);
    serialize(t, &rank, sizeof rank);
    serialize(t, &body->user_data, sizeof *body - BODY_BACK);
    if (!t->to) {
        body->detection = DETECTIONS[rank];
    }
}

/* Writes or reads all slots, free ones as well. Slots are contiguous within TD_CHUNK of them. */
static void serialize_slots(stream *t, td_slots *slots) {
    for (int i = 0; i < slots->count; i += TD_CHUNK) {
        int count = td_min_int(TD_CHUNK, slots->count - i);
        serialize(t, td_slot_at(slots, i), (size_t)count * (size_t)slots->stride);
    }
}

static void serialize_terrains(stream *t, td_slots *terrains) {
    for (int i = 0; i < terrains->count; i++) {
        td_terrain_record *record = td_slot_at(terrains, i);
        serialize(t, record, TERRAIN_BYTES);
        serialize(t, record->points.data, (size_t)record->points.count * sizeof(thud_pos));
    }
}

/* Writes or reads the blocks that are in use. */
static void serialize_blocks(stream *t, td_slots *pool) {
    for (int i = 0; i < pool->count; i++) {
        td_block *block = td_slot_at(pool, i);
        if (block->used) {
            serialize(t, block, (size_t)pool->stride);
        }
    }
}

/* Plugs into the world the shape kinds, detections and the island solver that the head names.
 * Removes all other shape kinds and detections. */
static void plug_in(thud_world *w, const td_snapshot_head *head) {
    memset(w->kinds, 0,
           TD_PAIR_COUNT * sizeof *w->kinds); /* the kinds of joints stay: snapshot.c has checked
                                                 that the world has those of the snapshot */
    w->instances = NULL;
    w->edit_apply = td_edit_apply; /* for edits that wait in the snapshot */
    w->internal_edges = NULL;
    w->ground = NULL;
    for (int kind = 0; kind < THUD_SHAPE_KIND_COUNT; kind++) {
        if (head->plugged >> kind & 1) {
            KINDS[kind].plug(w);
        }
    }
    for (int rank = 0; rank < TD_RANK_COUNT; rank++) {
        w->detections[rank] =
            head->plugged & (uint32_t)TD_SNAPSHOT_DETECTIONS << rank ? DETECTIONS[rank] : NULL;
    }
    w->quality.detection = DETECTIONS[head->detection];
    w->quality.islands = head->plugged & TD_SNAPSHOT_ISLANDS ? td_direct_solver_of(w) : NULL;
}

/* Takes over the head's counts. Slots beyond them are cleared, as if they had never been used: the
 * generations of their handles begin anew, and awake slots that wide kernels process as padding
 * have no velocity. */
static void take_counts(thud_world *w, const td_snapshot_head *head) {
    td_slots *slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_list_slots(w, slots);
    for (int i = 0; i < TD_SNAPSHOT_SLOTS; i++) {
        const td_snapshot_slots *to = &head->slots[i];
        for (int k = to->count; k < slots[i]->count && i <= TD_SNAPSHOT_JOINTS; k++) {
            memset(td_slot_at(slots[i], k), 0, (size_t)slots[i]->stride);
        }
        slots[i]->count = to->count;
        slots[i]->free_head = to->free_head;
        slots[i]->live = to->live;
    }
    for (td_awake_slot slot = {head->parts[TD_SNAPSHOT_AWAKE + TD_AWAKE_velocity].used};
         slot.at < w->body_of.count; slot.at++) {
        memset(td_row(&w->velocity, slot), 0, sizeof(float[4]));
    }
    memcpy(w->constraint_count, head->constraints, sizeof head->constraints);
}

/* Writes or reads table and values, in the order of snapshot.h. */
static void serialize_all(stream *t, thud_world *w, const td_snapshot_head *head) {
    td_part parts[TD_SNAPSHOT_PARTS];
    td_snapshot_list_parts(w, head, parts);
    serialize_table(t, w);
    for (int i = 0; i < FIELD_COUNT; i++) {
        serialize(t, (char *)w + FIELDS[i].at, FIELDS[i].bytes);
    }
    serialize_bins(t, w, head->bins);
    serialize_levels(t, &w->awake_shapes, head->levels[0]);
    serialize_levels(t, &w->rest_shapes, head->levels[1]);
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        serialize_body(t, td_body_at(w, i));
    }
    serialize_slots(t, &w->shapes);
    serialize_slots(t, &w->constraints);
    serialize_slots(t, &w->joints);
    serialize_terrains(t, &w->terrains);
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        serialize_blocks(t, &w->pool[form]);
    }
    for (int i = 0; i < TD_SNAPSHOT_PARTS; i++) {
        td_array *array = parts[i].array;
        serialize(t, array->data, (size_t)head->parts[i].used * (size_t)array->stride);
        if (!t->to) {
            array->count = head->parts[i].count;
        }
    }
}

void td_snapshot_write(thud_world *w, const td_snapshot_head *head, char *to) {
    stream t = {.to = to};
    serialize_all(&t, w, head);
    assert((uint64_t)(t.to - to) == td_snapshot_ruled_at(head));
}

void td_snapshot_read(thud_world *w, const td_snapshot_head *head, const char *from) {
    stream t = {.from = from};
    plug_in(w, head);
    take_counts(w, head);
    serialize_all(&t, w, head);
    assert((uint64_t)(t.from - from) == td_snapshot_ruled_at(head));
    unsigned none = w->def.parts ? 0u : head->plugged;
    w->sensor_hooks = none & TD_SNAPSHOT_NO_SENSORS && w->sensors == 0 ? NULL : &td_sensor_stages;
    w->error_hooks = none & TD_SNAPSHOT_NO_ERRORS ? NULL : &td_error_report;
    w->sleep_hooks = none & TD_SNAPSHOT_NO_SLEEP && !w->def.sleeping ? NULL : &td_sleep_stages;
    w->restitution_hooks =
        none & TD_SNAPSHOT_NO_RESTITUTION && w->bouncy == 0 ? NULL : &td_restitution;
}
