/* snapshot.h: how a snapshot is laid out.
 *
 * A head that tells every size, then the values in the order of snapshot_stream.c, which writes and
 * reads them by the same lines. No addresses: what a world has by address goes as a number. */
#ifndef TD_SNAPSHOT_H
#define TD_SNAPSHOT_H

#include "rules/rule_hooks.h"
#include "state/world.h"

#include "thud/thud_snapshot.h"

#define TD_SNAPSHOT_MAGIC "thudsnap"

enum { TD_SNAPSHOT_VERSION = 9 }; /* rises when what the bytes mean changes */

/* in td_snapshot_head.slots */
enum {
    TD_SNAPSHOT_BODIES,
    TD_SNAPSHOT_SHAPES,
    TD_SNAPSHOT_CONTACTS,
    TD_SNAPSHOT_JOINTS,
    TD_SNAPSHOT_TERRAINS,
    TD_SNAPSHOT_POOLS,
    TD_SNAPSHOT_SLOTS = TD_SNAPSHOT_POOLS + TD_FORM_COUNT
};

/* of a proxy set */
enum {
    TD_SNAPSHOT_LIST,
    TD_SNAPSHOT_IDS, /* from here to `moved` rows by place, which all broadphases have */
    TD_SNAPSHOT_MIN_X,
    TD_SNAPSHOT_MIN_Y,
    TD_SNAPSHOT_MAX_X,
    TD_SNAPSHOT_MAX_Y,
    TD_SNAPSHOT_PLACES_MOVED,
    TD_SNAPSHOT_CELLS,
    TD_SNAPSHOT_STARTS,
    TD_SNAPSHOT_SPOT,
    TD_SNAPSHOT_ANCHOR_X,
    TD_SNAPSHOT_ANCHOR_Y,
    TD_SNAPSHOT_KEYS,
    TD_SNAPSHOT_PROXY_SET_PARTS
};

/* in td_snapshot_head.parts */
enum {
    TD_SNAPSHOT_POSE,
    TD_SNAPSHOT_PROXY,
    TD_SNAPSHOT_WAS,
    TD_SNAPSHOT_MARKS,
    TD_SNAPSHOT_AWAKE, /* thud_world.awake, by its numbers */
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
    TD_SNAPSHOT_PULLS,
    TD_SNAPSHOT_PROXY_SETS,
    TD_SNAPSHOT_PARTS = TD_SNAPSHOT_PROXY_SETS + 2 * TD_SNAPSHOT_PROXY_SET_PARTS
};

/* What the def says for good, and the steps to come follow. Doubles and nothing else, so that equal
 * settings are equal bytes. */
typedef struct td_snapshot_settings {
    double substeps, contact_stiffness, contact_damping, push_speed, restitution_threshold;
    double hit_speed, maximum_speed, contact_events, time_budget;
    double detection; /* rank of the world's own; -1: the quality's */
} td_snapshot_settings;

/* What is plugged in, as bits: one for each kind of shape, by its number, and above them these. */
enum {
    TD_SNAPSHOT_ISLANDS = 1 << THUD_SHAPE_KIND_COUNT,
    TD_SNAPSHOT_DETECTIONS = 2 * TD_SNAPSHOT_ISLANDS, /* shifted by the rank of the detection */
    /* Shifted by the kind of joint, of which pair kinds are none. */
    TD_SNAPSHOT_JOINT_KINDS = TD_SNAPSHOT_DETECTIONS << TD_RANK_COUNT,
    TD_SNAPSHOT_ALL_JOINTS =
        TD_SNAPSHOT_JOINT_KINDS * ((1 << (TD_CONSTRAINT_KINDS - TD_PAIR_COUNT)) - 1)
};

typedef struct td_snapshot_slots {
    int32_t count, free_head, live;
} td_snapshot_slots;

typedef struct td_snapshot_part {
    int32_t count; /* td_array.count */
    int32_t used;  /* elements that follow, which some arrays have beyond or without a count */
} td_snapshot_part;

typedef struct td_snapshot_head {
    char magic[8];
    uint64_t checksum; /* of all that follows */
    uint64_t bytes;    /* of the whole */
    uint32_t version;
    uint32_t layout; /* of the build: sizes of records, byte order */
    char broadphase[16];
    double unit;
    td_snapshot_settings settings;
    uint32_t plugged;
    int32_t detection; /* rank of the quality's */
    int32_t bins;      /* that are not empty */
    int32_t contacts[TD_CONSTRAINT_KINDS];
    int32_t levels[2]; /* of the two proxy sets: from the first that is not empty on */
    td_snapshot_slots slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_part parts[TD_SNAPSHOT_PARTS];
    uint64_t points; /* of all terrains */
    td_ruled ruled;  /* its bytes are the last: written and read by the world's own rules */
} td_snapshot_head;

/* ---- snapshot_parts.c: where a world has what ---- */

/* Of the arrays by awake slot: 1 where it is state. */
extern const uint8_t td_awake_kept[TD_AWAKE_ARRAY_COUNT];

/* An array of the world, and how much of it is state. */
typedef struct td_part {
    td_array *array;
    int used; /* elements now that are state */
    int room; /* elements that the stages take for granted, in a world as the head tells */
} td_part;

void td_snapshot_list_parts(thud_world *w, const td_snapshot_head *head,
                            td_part parts[TD_SNAPSHOT_PARTS]);
/* Bodies, shapes, contacts, terrains, then the pools. */
void td_snapshot_list_slots(thud_world *w, td_slots *slots[TD_SNAPSHOT_SLOTS]);
/* How many entries the table has that stands first after the head; see below. */
int td_snapshot_table_of(const td_snapshot_head *head);

/* ---- snapshot_stream.c ---- */

/* The head of a snapshot of the world as it is, but for the checksum. */
td_snapshot_head td_snapshot_head_of(thud_world *w);
/* The bytes of the whole by the counts of a head; the world only knows how large elements are. */
uint64_t td_snapshot_bytes_of(thud_world *w, const td_snapshot_head *head);
uint64_t td_snapshot_checksum(const void *bytes, size_t count);

/* First after the head stands a table of int32: how many points each terrain has, then for each
 * block the next free one, or this. */
enum { TD_SNAPSHOT_LIVE = -2 };

/* Where after the head the bytes of rules stand. */
static inline uint64_t td_snapshot_ruled_at(const td_snapshot_head *head) {
    return head->bytes - sizeof *head - td_ruled_bytes(head->ruled);
}

/* All values after the head, which is that of the world, up to its rules. Changes nothing. */
void td_snapshot_write(thud_world *w, const td_snapshot_head *head, char *to);
/* Takes the values into a world that has room for them, from bytes that are what the head tells. */
void td_snapshot_read(thud_world *w, const td_snapshot_head *head, const char *from);

#endif
