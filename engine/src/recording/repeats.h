/* repeats.h: compresses bytes by their repeats: the calls of a step mostly have the arguments of
 * the step before. Written are, in turn, a number of literal bytes, these bytes, and the length and
 * distance of a copy of earlier bytes. This is a code of the family LZ77 (J. Ziv, A. Lempel, "A
 * Universal Algorithm for Sequential Data Compression", 1977), of whole bytes, like LZ4's. */
#ifndef TD_REPEATS_H
#define TD_REPEATS_H

#include "recording/stream.h"

/* Writes the compressed bytes. The same input gives the same output on every platform. */
void td_repeats_write(td_writer *to, const uint8_t *bytes, size_t count);
/* Decompresses to `count` bytes. False if the input is damaged. */
bool td_repeats_read(td_reader *from, uint8_t *out, size_t count);

#endif
