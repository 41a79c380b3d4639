/* snapshot.h: how a snapshot is laid out.
 *
 * A head that tells every size, then the values in the order of snapshot_pass.c, which writes and
 * reads them by the same lines. No addresses: what a world has by address goes as a number. */
#ifndef TD_SNAPSHOT_H
#define TD_SNAPSHOT_H

#include "state/world.h"

#include "thud/thud_snapshot.h"

#define TD_SNAPSHOT_MAGIC "thudsnap"

enum { TD_SNAPSHOT_VERSION = 2 }; /* rises when what the bytes mean changes */

/* in td_snapshot_head.slots */
enum {
    TD_SNAPSHOT_BODIES,
    TD_SNAPSHOT_SHAPES,
    TD_SNAPSHOT_CONTACTS,
    TD_SNAPSHOT_TERRAINS,
    TD_SNAPSHOT_POOLS,
    TD_SNAPSHOT_SLOTS = TD_SNAPSHOT_POOLS + TD_FORM_COUNT
};

/* in td_snapshot_head.parts */
enum {
    TD_SNAPSHOT_PLACES = 0, /* of bodies; then three rows by shape */
    TD_SNAPSHOT_VELOCITY = 4,
    TD_SNAPSHOT_BODY_OF = TD_SNAPSHOT_VELOCITY + 12,
    TD_SNAPSHOT_AWAKE_ROWS = 15,
    TD_SNAPSHOT_MOVED = TD_SNAPSHOT_VELOCITY + TD_SNAPSHOT_AWAKE_ROWS,
    TD_SNAPSHOT_WAITING = TD_SNAPSHOT_MOVED + 3, /* after `changed` and `deferred` */
    TD_SNAPSHOT_PROXY_SETS = TD_SNAPSHOT_WAITING + TD_PAIR_COUNT + 2 * 6,
    TD_SNAPSHOT_PROXY_SET_PARTS = 13, /* a list, then rows by place, of which six all have */
    TD_SNAPSHOT_PARTS = TD_SNAPSHOT_PROXY_SETS + 2 * TD_SNAPSHOT_PROXY_SET_PARTS
};

enum { TD_SNAPSHOT_SETTINGS = 10 };

/* What is plugged in, as bits: one for each kind of shape, by its number, and above them these. */
enum {
    TD_SNAPSHOT_ISLANDS = 1 << THUD_SHAPE_KIND_COUNT,
    TD_SNAPSHOT_DETECTIONS = 2 * TD_SNAPSHOT_ISLANDS /* shifted by the rank of the detection */
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
    double settings[TD_SNAPSHOT_SETTINGS]; /* of the def, that no setter changes */
    uint32_t plugged;
    int32_t detection; /* rank of the quality's */
    int32_t bins;      /* that are not empty */
    int32_t contacts[TD_PAIR_COUNT];
    int32_t levels[2]; /* of the two proxy sets: from the first that is not empty on */
    td_snapshot_slots slots[TD_SNAPSHOT_SLOTS];
    td_snapshot_part parts[TD_SNAPSHOT_PARTS];
    uint64_t points; /* of all terrains */
} td_snapshot_head;

/* ---- snapshot_parts.c: where a world has what ---- */

/* An array of the world, and how much of it is state. */
typedef struct td_part {
    td_array *array;
    int used; /* elements now */
    int room; /* elements that the stages take for granted, in a world as the head tells */
} td_part;

void td_snapshot_list_parts(thud_world *w, const td_snapshot_head *head,
                            td_part parts[TD_SNAPSHOT_PARTS]);
/* Bodies, shapes, contacts, terrains, then the pools. */
void td_snapshot_list_slots(thud_world *w, td_slots *slots[TD_SNAPSHOT_SLOTS]);

/* ---- snapshot_pass.c ---- */

/* The head of a snapshot of the world as it is, but for the checksum. */
td_snapshot_head td_snapshot_head_of(thud_world *w);
/* The bytes of the whole by the counts of a head; the world only knows how large elements are. */
uint64_t td_snapshot_bytes_of(thud_world *w, const td_snapshot_head *head);
uint64_t td_snapshot_checksum(const void *bytes, size_t count);

/* First after the head stands a table of int32: how many points each terrain has, then for each
 * block the next free one, or this. */
enum { TD_SNAPSHOT_LIVE = -2 };
int td_snapshot_table_of(const td_snapshot_head *head); /* how many entries it has */

/* All values after the head, which is that of the world. Changes nothing. */
void td_snapshot_write(thud_world *w, const td_snapshot_head *head, char *to);
/* ... into a world that has room for them, from bytes that are what the head tells. */
void td_snapshot_read(thud_world *w, const td_snapshot_head *head, const char *from);

#endif
