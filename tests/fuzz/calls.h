/* calls.h: macros for a call of the public API in a session. They count the call, make it in the
 * caller's floating-point mode and with allocations that may fail, and check what every refused
 * call promises: it calls the log hook, and changes neither the world nor its outputs. */
#ifndef FUZZ_CALLS_H
#define FUZZ_CALLS_H

#include "session.h"

#include <string.h>

/* A call that takes a world, which logs refusals. If it runs out of memory it is made once more.
 * The result is in s->result. */
#define TRY(s, call)          \
    do {                      \
        call_begin(s, #call); \
        s->result = (call);   \
    } while (call_again(s))

/* A call without a world. If it is refused, `out` must be unchanged. */
#define PURE(s, out, call)                        \
    do {                                          \
        memset(&(out), CALL_FILL, sizeof(out));   \
        s->result = (call);                       \
        call_pure(s, #call, &(out), sizeof(out)); \
    } while (0)

/* A call that returns no thud_result. */
#define COUNTED(call) (fuzz_calls_made++, (call))

/* Byte with which outputs are filled before a call. */
enum { CALL_FILL = 0xa5 };

void call_begin(fuzz_session *s, const char *text);
bool call_again(fuzz_session *s);
void call_pure(fuzz_session *s, const char *text, const void *out, size_t bytes);
/* Expects that these bytes of a refused call's outputs still have the value CALL_FILL. */
void call_untouched(fuzz_session *s, const void *out, size_t bytes);

/* ---- the digest, in which twins must agree ---- */

void note_bits(fuzz_session *s, uint64_t bits);
void note_number(fuzz_session *s, double value);  /* a value that is not finite ends the process
                                                     with a finding */
void note_place(fuzz_session *s, thud_pos place); /* the same; left out of the digest of shifted
                                                     twins */
void note_vector(fuzz_session *s, thud_vec2 value);

#endif
