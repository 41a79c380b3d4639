/* calls.h: a call of the public API within a session: counted, in the caller's floating-point mode,
 * with memory that may fail, and held to what is promised of every call that is refused. */
#ifndef FUZZ_CALLS_H
#define FUZZ_CALLS_H

#include "session.h"

#include <string.h>

/* Of a world that hears of refusals. Refused memory, it is made again. The result is s->result. */
#define TRY(s, call)          \
    do {                      \
        call_begin(s, #call); \
        s->result = (call);   \
    } while (call_again(s))

/* Without a world; refused, it leaves `out` as it was. */
#define PURE(s, out, call)                        \
    do {                                          \
        memset(&(out), CALL_FILL, sizeof(out));   \
        s->result = (call);                       \
        call_pure(s, #call, &(out), sizeof(out)); \
    } while (0)

/* What has no result. */
#define COUNTED(call) (fuzz_calls_made++, (call))

enum { CALL_FILL = 0xa5 };

void call_begin(fuzz_session *s, const char *text);
bool call_again(fuzz_session *s);
void call_pure(fuzz_session *s, const char *text, const void *out, size_t bytes);
/* Bytes that were filled before a call that was refused. */
void call_untouched(fuzz_session *s, const void *out, size_t bytes);

/* ---- what twins must agree on ---- */

void note_bits(fuzz_session *s, uint64_t bits);
void note_number(fuzz_session *s, double value);  /* finite, or that is a finding */
void note_place(fuzz_session *s, thud_pos place); /* likewise; but for shifted twins */
void note_vector(fuzz_session *s, thud_vec2 value);

#endif
