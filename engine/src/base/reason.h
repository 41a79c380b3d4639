/* reason.h: why a call is refused where one number is at fault: its name, the number, and the range
 * that it is not in, as text for the log. */
#ifndef TD_REASON_H
#define TD_REASON_H

#include <stdbool.h>

enum {
    TD_NAME_MAX = 64,   /* bytes of a name */
    TD_REASON_MAX = 128 /* bytes of a text: a name, three numbers of at most 14, and the words */
};

typedef struct td_reason {
    char text[TD_REASON_MAX];
} td_reason;

/* Whether low <= x <= high. If not, `why` says so: "NAME is X, not in [LOW, HIGH]". */
bool td_in(td_reason *why, const char *name, double x, double low, double high);
/* The same of floats: a call takes half the code. */
bool td_float_in(td_reason *why, const char *name, float x, float low, float high);
/* Whether 0 < x <= high. If not: "NAME is X, not in (0, HIGH]". */
bool td_above_0(td_reason *why, const char *name, double x, double high);
/* Whether all three are finite. If not, that of the first which is not, as above. */
bool td_all_finite(td_reason *why, const char *name, float x, float y, float z);

#endif
