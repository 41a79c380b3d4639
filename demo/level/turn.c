/* turn.c: sine and cosine with the same bits on every platform, which those of the C library do not
 * have. The series end where the next term is below 1e-15 at pi/4. */
#include "level.h"

#include <math.h>

double level_turn(double degrees, double *c, double *s) {
    double r = degrees - 360.0 * floor(degrees / 360.0 + 0.5);
    double q = floor(r / 90.0 + 0.5);
    double a = (r - 90.0 * q) * 0.017453292519943295;
    double z = a * a;
    double sine =
        a * (1.0 +
             z * (-1.0 / 6.0 +
                  z * (1.0 / 120.0 +
                       z * (-1.0 / 5040.0 +
                            z * (1.0 / 362880.0 +
                                 z * (-1.0 / 39916800.0 +
                                      z * (1.0 / 6227020800.0 + z * (-1.0 / 1307674368000.0))))))));
    double cosine =
        1.0 +
        z * (-1.0 / 2.0 +
             z * (1.0 / 24.0 + z * (-1.0 / 720.0 +
                                    z * (1.0 / 40320.0 + z * (-1.0 / 3628800.0 +
                                                              z * (1.0 / 479001600.0 +
                                                                   z * (-1.0 / 87178291200.0)))))));
    switch ((int)q) {
    case 0:
        *c = cosine;
        *s = sine;
        break;
    case 1:
        *c = -sine;
        *s = cosine;
        break;
    case -1:
        *c = sine;
        *s = -cosine;
        break;
    default: /* -2 and 2: half a turn */
        *c = -cosine;
        *s = -sine;
        break;
    }
    return r;
}
