/* reason.c: see reason.h. It formats numbers itself: the C library's output functions would take
 * more code than the whole engine of a small program. */
#include "base/reason.h"

#include <assert.h>
#include <float.h>

/* Copies a text. Returns the end of the copy. */
static char *put(char *to, const char *text) {
    while ((*to = *text++)) {
        to++;
    }
    return to;
}

/* Significant digits: seven show a float as it was written (0.1f as 0.1). Numbers that would need
 * more than DIGITS digits before the point, or more than DECIMALS behind it, are written
 * as 1.5e-12. */
enum { DIGITS = 7, DECIMALS = 9 };
#define SCALED_MIN 1e6 /* 10^(DIGITS - 1) */

/* Writes a number. Returns the end of the text. The number is scaled to n 10^power, where n has
 * DIGITS digits; then zeros at the end of n move into the power. */
static char *put_number(char *to, double x) {
    if (x < 0.0) {
        *to++ = '-';
        x = -x;
    }
    if (!(x <= DBL_MAX)) {
        return put(to, x > 0.0 ? "infinity" : "NaN");
    }
    int power = 0, exponent = 0, count = 0;
    for (; x >= 10.0 * SCALED_MIN; x /= 10.0) {
        power++;
    }
    for (; x > 0.0 && x < SCALED_MIN; x *= 10.0) {
        power--;
    }
    unsigned n = (unsigned)(x + 0.5);
    for (; n && n % 10 == 0; n /= 10) {
        power++;
    }
    char digit[16]; /* digits, the last one first */
    for (; n || !count; n /= 10) {
        digit[count++] = (char)('0' + n % 10);
    }
    if (power < -DECIMALS || count + power > DIGITS) {
        exponent = power + count - 1;
        power = 1 - count;
    }
    while (count <= -power) {
        digit[count++] = '0';
    }
    while (count--) {
        *to++ = digit[count];
        if (count && count == -power) {
            *to++ = '.';
        }
    }
    for (; power > 0; power--) {
        *to++ = '0';
    }
    return exponent ? put_number(put(to, "e"), exponent) : to;
}

/* Writes the whole text. Returns false, which the checks return. */
static bool refuse(td_reason *why, const char *name, double x, double low, const char *opened,
                   double high) {
    char *to = put(why->text, name);
    assert(to - why->text <= TD_NAME_MAX);
    to = put_number(put(to, " is "), x);
    to = put_number(put(to, opened), low);
    put(put_number(put(to, ", "), high), "]");
    return false;
}

bool td_in(td_reason *why, const char *name, double x, double low, double high) {
    return (x >= low && x <= high) || refuse(why, name, x, low, ", not in [", high);
}

bool td_float_in(td_reason *why, const char *name, float x, float low, float high) {
    return td_in(why, name, (double)x, (double)low, (double)high);
}

bool td_above_0(td_reason *why, const char *name, double x, double high) {
    return (x > 0.0 && x <= high) || refuse(why, name, x, 0.0, ", not in (", high);
}

bool td_all_finite(td_reason *why, const char *name, float x, float y, float z) {
    const float number[3] = {x, y, z};
    bool in = true;
    for (int i = 0; i < 3 && in; i++) {
        in = td_float_in(why, name, number[i], -FLT_MAX, FLT_MAX);
    }
    return in;
}
