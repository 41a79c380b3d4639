/* repeats.h: bytes without what they repeat of themselves: calls of a step mostly have the
 * arguments of the step before. Written are, in turn, how many bytes come as they are, these, and
 * how many are copied from which distance before: a code of the family LZ77 (J. Ziv, A. Lempel, "A
 * Universal Algorithm for Sequential Data Compression", 1977), by whole bytes, as that of LZ4. */
#ifndef TD_REPEATS_H
#define TD_REPEATS_H

#include "recording/stream.h"

/* Writes bytes without their repeats. The same bytes give the same everywhere. */
void td_repeats_write(td_writer *to, const uint8_t *bytes, size_t count);
/* Reads `count` bytes. False where they contradict themselves. */
bool td_repeats_read(td_reader *from, uint8_t *out, size_t count);

#endif
