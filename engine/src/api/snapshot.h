/* snapshot.h: the layout of a snapshot, in memory order of the machine:
 *
 *     td_snapshot_head   magic, checksum, version, settings, and every count and size
 *     table              int32: the number of points of each terrain slot; then for each block slot
 *                        its next free slot, or TD_SNAPSHOT_LIVE
 *     values             in the order of serialize_all in snapshot_stream.c
 *     rules              bytes of the world's rule hooks (td_ruled_bytes)
 *     textures           bytes of its texture hooks, last
 *
 * One function both writes and reads the values, so that the two orders cannot differ. A snapshot
 * has no addresses: kinds of shapes, detections and the island solver stand as bits and ranks.
 * Sizes are all in the head and the table, so that a restore can check and reserve everything
 * before it writes to the world. */
#ifndef TD_SNAPSHOT_H
#define TD_SNAPSHOT_H

#include "rules/rule_hooks.h"
#include "state/world.h"
#include "textures/texture_hooks.h"

#include "thud/thud_snapshot.h"

#define TD_SNAPSHOT_MAGIC "thudsnap"

enum { TD_SNAPSHOT_VERSION = 13 }; /* to be raised whenever the meaning of the bytes changes */

/* Indices of td_snapshot_head.slots: arrays with free lists. */
enum {
    TD_SNAPSHOT_BODIES,
    TD_SNAPSHOT_SHAPES,
    TD_SNAPSHOT_CONSTRAINTS, /* contacts and parts of joints */
    TD_SNAPSHOT_JOINTS,
    TD_SNAPSHOT_TERRAINS,
    TD_SNAPSHOT_BLOCK_POOLS, /* of blocks, by td_block_form */
    TD_SNAPSHOT_SLOTS = TD_SNAPSHOT_BLOCK_POOLS + TD_FORM_COUNT
};

/* Indices of the arrays of one proxy set (the sorted bounds of a broadphase), after its first in
 * parts. */
enum {
    TD_SNAPSHOT_LIST,
    TD_SNAPSHOT_IDS, /* from here to PLACES_MOVED: arrays in the order of td_proxy_set.ids, which
                        every broadphase fills */
    TD_SNAPSHOT_MIN_X,
    TD_SNAPSHOT_MIN_Y,
    TD_SNAPSHOT_MAX_X,
    TD_SNAPSHOT_MAX_Y,
    TD_SNAPSHOT_PLACES_MOVED,
    TD_SNAPSHOT_CELLS,
    TD_SNAPSHOT_STARTS,
    TD_SNAPSHOT_INDEX_OF,
    TD_SNAPSHOT_ANCHOR_X,
    TD_SNAPSHOT_ANCHOR_Y,
    TD_SNAPSHOT_KEYS,
    TD_SNAPSHOT_PROXY_SET_PARTS
};

/* Indices of td_snapshot_head.parts: arrays of thud_world. */
enum {
    TD_SNAPSHOT_POSE,
    TD_SNAPSHOT_PROXY,
    TD_SNAPSHOT_PREVIOUS_FAT,
    TD_SNAPSHOT_MARKS,
    TD_SNAPSHOT_AWAKE, /* arrays by awake slot, in the order of awake_arrays.h */
    TD_SNAPSHOT_MOVED = TD_SNAPSHOT_AWAKE + TD_AWAKE_ARRAY_COUNT,
    TD_SNAPSHOT_CHANGED,
    TD_SNAPSHOT_DEFERRED,
    TD_SNAPSHOT_WAITING, /* by kind of constraint */
    TD_SNAPSHOT_EVENTS = TD_SNAPSHOT_WAITING + TD_CONSTRAINT_KINDS,
    TD_SNAPSHOT_PUBLISHED = TD_SNAPSHOT_EVENTS + TD_EVENT_LIST_COUNT,
    TD_SNAPSHOT_BROKEN = TD_SNAPSHOT_PUBLISHED + TD_EVENT_LIST_COUNT,
    TD_SNAPSHOT_GATHERED,
    TD_SNAPSHOT_GATHERED_BROKEN = TD_SNAPSHOT_GATHERED + TD_EVENT_LIST_COUNT,
    TD_SNAPSHOT_GATHERED_IMPULSES,
    TD_SNAPSHOT_FORCE_RECORDS,
    TD_SNAPSHOT_PLACED_BINS,
    TD_SNAPSHOT_BEGINS, /* this list and that of TD_SNAPSHOT_ENDS are empty, except after a step
                           that ran out of memory */
    TD_SNAPSHOT_ENDS,
    TD_SNAPSHOT_PROXY_SETS,
    TD_SNAPSHOT_PARTS = TD_SNAPSHOT_PROXY_SETS + 2 * TD_SNAPSHOT_PROXY_SET_PARTS
};

/* Fields of thud_world_def without a setter that change how a world steps: snapshot and world must
 * agree on them. All are doubles, without padding, so that memcmp compares them. */
typedef struct td_snapshot_settings {
    double substeps, contact_stiffness, contact_damping, push_speed, restitution_threshold;
    double hit_speed, maximum_speed, contact_events, time_budget;
    double detection; /* rank of the world's own; -1: the quality's */
} td_snapshot_settings;

/* Bits of td_snapshot_head.plugged, the optional parts that the world links: bit k for shape kind
 * k, and above them these. */
enum {
    TD_SNAPSHOT_ISLANDS = 1 << THUD_SHAPE_KIND_COUNT,
    TD_SNAPSHOT_DETECTIONS = 2 * TD_SNAPSHOT_ISLANDS, /* shifted by the rank of the detection */
    /* shifted by (constraint kind - TD_PAIR_COUNT): kinds of joint constraints */
    TD_SNAPSHOT_JOINT_KINDS = TD_SNAPSHOT_DETECTIONS << TD_RANK_COUNT,
    TD_SNAPSHOT_ALL_JOINTS =
        TD_SNAPSHOT_JOINT_KINDS * ((1 << (TD_CONSTRAINT_KINDS - TD_PAIR_COUNT)) - 1),
    /* no shape can be a sensor yet: thud_default_small_world_def */
    TD_SNAPSHOT_NO_SENSORS = TD_SNAPSHOT_ALL_JOINTS + TD_SNAPSHOT_JOINT_KINDS,
    /* no contact can bounce yet */
    TD_SNAPSHOT_NO_RESTITUTION = 2 * TD_SNAPSHOT_NO_SENSORS,
    /* no body can fall asleep yet */
    TD_SNAPSHOT_NO_SLEEP = 2 * TD_SNAPSHOT_NO_RESTITUTION,
    /* errors of steps are not collected yet */
    TD_SNAPSHOT_NO_ERRORS = 2 * TD_SNAPSHOT_NO_SLEEP
};

typedef struct td_snapshot_slots {
    int32_t count;     /* slots ever used */
    int32_t free_head; /* first slot of the free list, or TD_NONE */
    int32_t live;      /* slots in use */
} td_snapshot_slots;

typedef struct td_snapshot_part {
    int32_t count; /* td_array.count */
    int32_t used;  /* number of elements in the snapshot. It is more than `count` where the wide
                      kernels also read the padding behind the elements, or where the array's length
                      follows from that of another one */
} td_snapshot_part;

typedef struct td_snapshot_head {
    char magic[8];
    uint64_t checksum; /* td_snapshot_checksum of all bytes after this field */
    uint64_t bytes;    /* size of the whole snapshot */
    uint32_t version;
    uint32_t layout;     /* hash of sizes of records and byte order: builds must agree on it */
    char broadphase[16]; /* name, cut off */
    double length_scale; /* thud_world.length_scale, a power of two */
    td_snapshot_settings settings;
    uint32_t plugged;
    int32_t detection;                        /* rank of the quality's detection */
    int32_t bins;                             /* number of bins with lanes */
    int32_t constraints[TD_CONSTRAINT_KINDS]; /* constraints of each kind */
    int32_t levels[2]; /* grid levels stored of either proxy set: the last ones, from the first that
                          is not empty on */
    td_snapshot_slots slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_part parts[TD_SNAPSHOT_PARTS];
    uint64_t points;   /* points of all terrains together */
    td_ruled ruled;    /* counts of the rules, whose bytes come last but one */
    uint64_t textured; /* bytes of the textures, which come last */
} td_snapshot_head;

/* The checksum is over all bytes from this offset on. */
enum { TD_SNAPSHOT_SUMMED_FROM = offsetof(td_snapshot_head, checksum) + sizeof(uint64_t) };

/* Casts const away: writing and reading share functions, which take a world that they may write to;
 * when a snapshot is written, they only read it. */
static inline thud_world *td_unconst(const thud_world *w) {
    union {
        const thud_world *given;
        thud_world *same;
    } pointer = {w};
    return pointer.same;
}

/* ---- snapshot_parts.c ---- */

/* By array of awake_arrays.h: true where it is state, false where each step computes it anew. */
extern const bool td_awake_is_state[TD_AWAKE_ARRAY_COUNT];

/* An array of the world, and how much of it goes into a snapshot. */
typedef struct td_part {
    td_array *array;
    int used; /* elements of the present world that are state */
    int room; /* elements that a world with the head's counts must have room for, because stages of
                 the step write that many without reserving; 0: no more than `used` */
} td_part;

/* Lists the arrays in the order of TD_SNAPSHOT_POSE and so on: how much of each the present world
 * `w` uses, and how much room it needs for the counts of `head`. */
void td_snapshot_list_parts(thud_world *w, const td_snapshot_head *head,
                            td_part parts[TD_SNAPSHOT_PARTS]);
/* Lists the world's pools of records in the order of TD_SNAPSHOT_BODIES and so on. */
void td_snapshot_list_slots(thud_world *w, td_slots *slots[TD_SNAPSHOT_SLOTS]);
/* The number of entries of the table after the head: one a terrain slot and one a block slot. */
int td_snapshot_table_count(const td_snapshot_head *head);

/* Indices of the sections of a snapshot: what follows its head, in this order. */
enum {
    TD_SECTION_TABLE,
    TD_SECTION_FIELDS,
    TD_SECTION_BINS,
    TD_SECTION_LEVELS,
    TD_SECTION_BODIES,
    TD_SECTION_SHAPES,
    TD_SECTION_CONSTRAINTS,
    TD_SECTION_JOINTS,
    TD_SECTION_TERRAINS,                                  /* records, each before its points */
    TD_SECTION_BLOCKS,                                    /* by td_block_form */
    TD_SECTION_PARTS = TD_SECTION_BLOCKS + TD_FORM_COUNT, /* as td_snapshot_head.parts */
    TD_SECTION_RULED = TD_SECTION_PARTS + TD_SNAPSHOT_PARTS,
    TD_SECTION_TEXTURED,
    TD_SECTION_COUNT
};

typedef struct td_snapshot_section {
    uint64_t bytes;
    size_t stride; /* bytes of a record; 4 where the section has no records of one size */
} td_snapshot_section;

/* ---- snapshot_stream.c ---- */

/* The head of a snapshot of the present world, without its checksum. */
td_snapshot_head td_snapshot_head_of(thud_world *w);
/* Lists the sections of a snapshot with a head's counts. The world is read for the sizes of
 * elements only. */
void td_snapshot_list_sections(thud_world *w, const td_snapshot_head *head,
                               td_snapshot_section sections[TD_SECTION_COUNT]);
/* The offset in TD_SECTION_FIELDS of the field at byte `member` of thud_world. The field must be in
 * FIELDS (snapshot_stream.c). */
size_t td_snapshot_field_at(size_t member);
/* The size of a snapshot with this head, bytes. */
uint64_t td_snapshot_bytes_of(thud_world *w, const td_snapshot_head *head);
/* snapshot_checksum.c: a hash of the bytes, against damage, not against forgery. */
uint64_t td_snapshot_checksum(const void *bytes, size_t count);

/* The table's entry of a block that is in use. */
enum { TD_SNAPSHOT_LIVE = -2 };

/* The offset of the rules' bytes from the end of the head. */
static inline uint64_t td_snapshot_ruled_at(const td_snapshot_head *head) {
    return head->bytes - sizeof *head - head->textured - td_ruled_bytes(head->ruled);
}

/* The offset of the textures' bytes from the end of the head. */
static inline uint64_t td_snapshot_textured_at(const td_snapshot_head *head) {
    return head->bytes - sizeof *head - head->textured;
}

/* Writes table and values to the bytes after the head, which td_snapshot_head_of gave for this
 * world. Does not change the world. */
void td_snapshot_write(thud_world *w, const td_snapshot_head *head, char *to);
/* Reads table and values into a world that has room for them; snapshot.c has checked head and
 * bytes. */
void td_snapshot_read(thud_world *w, const td_snapshot_head *head, const char *from);

/* ---- snapshot.c ---- */

/* Whether all counts of the head are in their ranges, each for itself. */
bool td_snapshot_counts_valid(const td_snapshot_head *head);

#endif
