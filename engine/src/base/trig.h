/* trig.h: sine and cosine in double precision, and the angle that has them, with the same bits on
 * every compiler and processor, which the C library's functions do not promise. */
#ifndef TD_TRIG_H
#define TD_TRIG_H

/* Sine and cosine of an angle in radians, |angle| <= THUD_ANGLE_MAX, with an error below 1e-15.
 * Not finite where the angle is not. */
void td_sincos(double angle, double *s, double *c);

/* The angle in (-pi, pi] with this cosine and sine, rad; (angle.c). */
double td_angle_of(double c, double s);

#endif
