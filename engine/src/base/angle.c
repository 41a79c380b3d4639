/* angle.c: the angle with a given cosine and sine. */
#include "base/trig.h"

#include "base/base.h"

/* atan2(s, c) without the C library, whose bits differ between platforms. The first guess replaces
 * the unit circle by the diamond |c| + |s| = 1, and is off by at most 0.08 rad. Each iteration adds
 * sin(target - angle), which leaves an error of error^3 / 6: four iterations reach rounding. */
double td_angle_of(double c, double s) {
    double quarters = 1.0 - c / (td_abs(c) + td_abs(s)); /* |angle| / (pi / 2), [0, 2] */
    double angle = (s < 0.0 ? -0.5 : 0.5) * TD_PI * quarters;
    for (int i = 0; i < 4; i++) {
        double sine, cosine;
        td_sincos(angle, &sine, &cosine);
        angle += s * cosine - c * sine;
    }
    return angle;
}

thud_result thud_angle_of(double sine, double cosine, double *out_angle) {
    if (!out_angle) {
        return THUD_ERROR_NULL;
    }
    if (!(td_abs(cosine * cosine + sine * sine - 1.0) < THUD_UNIT_ERROR)) {
        return THUD_ERROR_INVALID;
    }
    *out_angle = td_angle_of(cosine, sine);
    return THUD_OK;
}
