/* packed.h: the parts of a packed snapshot (packed.c), and the prediction of some of its words from
 * others (packed_known.c). */
#ifndef TD_PACKED_H
#define TD_PACKED_H

#include "api/snapshot.h"

/* A snapshot, and where its sections are. */
typedef struct td_packed_image {
    uint8_t *bytes; /* null: no snapshot. Only read when packing */
    td_snapshot_head head;
    td_snapshot_section sections[TD_SECTION_COUNT];
    uint64_t at[TD_SECTION_COUNT]; /* offset of each section, bytes */
    double to_fixed;               /* position quanta in a length: thud_world.to_fixed */
} td_packed_image;

/* The snapshot that is packed or unpacked, and its base. */
typedef struct td_packed_pair {
    td_packed_image base, now;
} td_packed_pair;

/* A column: the words at byte `at` of the records of a section. */
typedef struct td_packed_field {
    const td_packed_pair *pair;
    int section; /* TD_SECTION_TABLE and so on */
    size_t at;
} td_packed_field;

/* The greatest size that a snapshot of `bytes` bytes has when packed, bytes: promised by
 * thud_world_pack. */
static inline size_t td_packed_max(size_t bytes) {
    return bytes + bytes / 8 + 2048;
}

/* Whether the bytes begin as a packed snapshot does. */
bool td_is_packed(const void *bytes, size_t count);

/* Whether td_packed_known can predict the column from columns that are read before it. */
bool td_packed_follows(const td_packed_field *field);
/* Predicts words of the column from the columns that were read before it; a td_known_fn. `field`: a
 * td_packed_field. */
void td_packed_known(const void *field, size_t first, int count, uint32_t *out);

/* The sections in the order in which they are packed. A section comes after those from which it is
 * predicted. */
void td_packed_order(int order[TD_SECTION_COUNT]);
/* The rows of blocks are packed in several passes, so that a row comes after those from which it is
 * predicted. Returns
 * the pass, 0 to TD_PACKED_PASSES - 1, of the row at byte `at` of a block of this section. */
enum { TD_PACKED_PASSES = 6 };
int td_packed_pass_of(int section, size_t at);

#endif
