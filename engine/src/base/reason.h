/* reason.h: checks of numbers in the arguments of API calls, and the text for the log that says why
 * a call is refused: "NAME is X, not in [LOW, HIGH]". */
#ifndef TD_REASON_H
#define TD_REASON_H

#include <stdbool.h>

enum {
    TD_NAME_MAX = 64, /* maximum number of characters of a name */
    TD_REASON_MAX =
        128 /* bytes of a text: a name, three numbers of at most 14, and the words between */
};

typedef struct td_reason {
    char text[TD_REASON_MAX];
} td_reason;

/* Whether low <= x <= high. If not (also for not-a-number), `why` gets the text above. */
bool td_in(td_reason *why, const char *name, double x, double low, double high);
/* td_in for floats. A call has no conversions to double, and so half the code. */
bool td_float_in(td_reason *why, const char *name, float x, float low, float high);
/* Whether 0 < x <= high. If not, `why` gets "NAME is X, not in (0, HIGH]". */
bool td_above_0(td_reason *why, const char *name, double x, double high);
/* Whether all three numbers are finite. If not, `why` gets the text for the first one that is not.
 */
bool td_all_finite(td_reason *why, const char *name, float x, float y, float z);

#endif
