/* trig.h: sine and cosine in double precision, with the same bits from every
 * compiler and processor, which the C library's functions do not promise. */
#ifndef TD_TRIG_H
#define TD_TRIG_H

/* |angle| <= THUD_ANGLE_MAX; the error stays below 1e-15. */
void td_sincos(double angle, double *s, double *c);

#endif
