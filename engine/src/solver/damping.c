/* damping.c: see damping.h. */
#include "solver/damping.h"

#include "base/base.h"

/* Greater values of z are clamped to this one, so that squares of z stay finite. It leaves 1e-12 of
 * a velocity. */
#define Z_MAX 1e12

/* The exponential is Taylor's series for z / 4, squared twice: exact to the rounding of floats up
 * to z = 1, and falling as z rises above. To keep digits where z is small, q = (exp(z) - 1) / z is
 * found by doubling z: with d = (q - 1) / z, doubling turns q into q (1 + z q / 2) and d into d / 2
 * + q^2 / 4. Then exp(z) = 1 + z q, p = q / exp(z), and gain_share = (1 - p) / (z p) = 1 - d / q.
 */
td_damping td_damping_of(float z) {
    if (z == 0.0f) {
        return (td_damping){.lost = 0.0f, .gained = 1.0f, .gain_share = 0.5f};
    }
    double x = 0.25 * td_min_double((double)z, Z_MAX);
    double d = 0.5 + x * (1.0 / 6 + x * (1.0 / 24 + x * (1.0 / 120)));
    double q = 1.0 + x * d;
    for (int i = 0; i < 2; i++) {
        d = 0.5 * d + 0.25 * q * q;
        q += 0.5 * x * q * q;
        x += x;
    }
    double p = q / (1.0 + x * q);
    return (td_damping){(float)(x * p), (float)p, (float)(1.0 - d / q)};
}
