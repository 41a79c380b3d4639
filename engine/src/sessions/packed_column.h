/* packed_column.h: columns of records, as packed snapshots hold them (packed.c).
 *
 * A column has one word of each record of an array, or eight words side by side of each block. Each
 * word is predicted from words that the reader knows already (td_guess), and the differences, as
 * integers modulo 2^32, are written in groups of eight: zigzag coded, so that small differences of
 * either sign are small numbers, and with as many bits as the greatest of the group needs (frame of
 * reference: J. Goldstein, R. Ramakrishnan, U. Shaft, "Compressing Relations and Indexes", 1998).
 *
 * A group begins with a byte:
 *
 *     1 ... 32        bits of a number; eight numbers follow
 *     65 ... 96       64 more than the bits; a byte follows that has a bit for each number that is
 *                     not 0, and then these numbers
 *     128 ... 255     127 more than the number of groups that have only zeros; nothing follows
 *
 * Numbers are packed from the lowest bit of the first byte on. A column begins with a byte, its
 * td_guess; TD_GUESS_SAME says that all words are those of the base, and nothing follows. */
#ifndef TD_PACKED_COLUMN_H
#define TD_PACKED_COLUMN_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TD_PACKED_GROUP = 8 }; /* words of a group */

/* How a word is predicted. TD_GUESS_BASE and TD_GUESS_STEP predict a record that the base does not
 * have as TD_GUESS_PREVIOUS does. */
typedef enum td_guess {
    TD_GUESS_SAME,     /* the word of the base; no word differs from it */
    TD_GUESS_BASE,     /* the word of the base */
    TD_GUESS_PREVIOUS, /* the word before it; 0 before that of record 0 */
    TD_GUESS_LINE,     /* linear extrapolation of the two words before it */
    TD_GUESS_STEP,     /* the word of the base, plus the difference of the word before it from the
                          base's */
    TD_GUESS_KNOWN,    /* by td_packed_column.known */
    TD_GUESS_COUNT
} td_guess;

/* The packed bytes, which are written or read. */
typedef struct td_packed_stream {
    uint8_t *to;         /* written here; null: nothing is written, and only `at` advances */
    const uint8_t *from; /* read from here */
    size_t at, end;      /* offset of the next byte; of the end of what is read */
    bool broken;         /* the bytes that were read contradict themselves */
} td_packed_stream;

typedef struct td_packed_column td_packed_column;

/* Writes predictions of the `count` words of one group, from word `first` on. They may use only
 * words that are unpacked before this column. */
typedef void td_known_fn(const void *context, size_t first, int count,
                         uint32_t out[TD_PACKED_GROUP]);

/* A column. `first` times `lanes` is a multiple of TD_PACKED_GROUP. Words need no alignment. */
struct td_packed_column {
    const uint8_t
        *base;      /* the word of record 0 in the base; null: the base has none of the records */
    uint8_t *words; /* the word of record 0. Not written when packing */
    size_t stride;  /* bytes from record to record, in both */
    size_t first, end;   /* the column is of the records first to end - 1; the records before are
                            known already. */
    size_t base_records; /* number of records that the base has, from record 0 on */
    int width;           /* bytes of a word: 4, or 1 */
    int lanes;           /* words of a record side by side: 1, or TD_PACKED_GROUP */
    bool same;           /* no word differs from the base's. Read when packing */
    bool copied;         /* the caller has already copied the base's words here. Read when unpacking
                          */
    td_known_fn *known;  /* null: TD_GUESS_KNOWN is not possible */
    const void *context; /* of `known` */
};

void td_packed_put(td_packed_stream *t, uint8_t byte);
uint8_t td_packed_take(td_packed_stream *t); /* the next byte; past the end 0, and sets `broken` */

/* Packs the column, with the guess that takes the fewest bytes for a sample of its groups. */
void td_packed_write(td_packed_stream *t, const td_packed_column *column);
/* Reads the column, and writes its words. */
void td_packed_read(td_packed_stream *t, const td_packed_column *column);

#endif
