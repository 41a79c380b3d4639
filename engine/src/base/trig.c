/* trig.c: see trig.h. It uses + - * / alone, in a fixed order, which IEEE 754 rounds correctly. */
#include "base/trig.h"
#include "base/base.h"

/* pi / 2 as a sum of three doubles, to subtract quarter turns from an angle without losing digits
 * (the argument reduction of Cody and Waite, Software Manual for the Elementary Functions, 1980).
 * The first two have 33 bits, so that their products with a number of quarter turns below 2^20 are
 * exact, and only the last subtractions round. */
#define QUARTER_1 0x1.921fb544p+0
#define QUARTER_2 0x1.0b4611a6p-34
#define QUARTER_3 0x1.3198a2e037073p-69

/* Numbers of quarter turns below this are ints. */
#define QUARTERS_MAX 2147483647.0

void td_sincos(double angle, double *s, double *c) {
    double turns = angle * (2.0 / TD_PI);
    double nearest = turns < 0.0 ? turns - 0.5 : turns + 0.5;
    /* In C the conversion to int of NaN, or of a number outside of its range, is undefined. */
    int quarters = td_abs(nearest) < QUARTERS_MAX ? (int)nearest : 0;
    double n = (double)quarters;
    double x = ((angle - n * QUARTER_1) - n * QUARTER_2) - n * QUARTER_3;
    double z = x * x;
    /* Taylor series for |x| <= pi / 4, which end where the next term is below half a unit in the
     * last place of the sum. */
    double sine =
        x + x * z *
                (-1.0 / 6.0 +
                 z * (1.0 / 120.0 +
                      z * (-1.0 / 5040.0 +
                           z * (1.0 / 362880.0 +
                                z * (-1.0 / 39916800.0 +
                                     z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0)))))));
    double cosine =
        1.0 +
        z * (-0.5 +
             z * (1.0 / 24.0 +
                  z * (-1.0 / 720.0 +
                       z * (1.0 / 40320.0 +
                            z * (-1.0 / 3628800.0 +
                                 z * (1.0 / 479001600.0 + z * (-1.0 / 87178291200.0 +
                                                               z * (1.0 / 20922789888000.0))))))));
    double u = quarters & 1 ? cosine : sine, v = quarters & 1 ? sine : cosine;
    *s = quarters & 2 ? -u : u;
    *c = (quarters + 1) & 2 ? -v : v;
}

thud_result thud_sincos(double angle, double *out_sine, double *out_cosine) {
    if (!out_sine || !out_cosine) {
        return THUD_ERROR_NULL;
    }
    if (!(td_abs(angle) <= THUD_ANGLE_MAX)) {
        return THUD_ERROR_INVALID;
    }
    td_sincos(angle, out_sine, out_cosine);
    return THUD_OK;
}
