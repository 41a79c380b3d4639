/* toi_queue.h: when candidates meet, in a queue by time. Numbers are those of td_toi_candidate. */
#ifndef TD_TOI_QUEUE_H
#define TD_TOI_QUEUE_H

#include "detection/trajectory.h"

/* Whether a contact is one of those that are looked at: neither a sensor's, nor on a line, which is
 * an extra candidate. */
bool td_toi_queue_accepts(const thud_world *w, int contact);

/* Puts down when a contact meets on the ways that the step began with. */
void td_toi_queue_set_first(thud_world *w, int number);
/* Puts down when a candidate meets from where its two bodies are now. */
void td_toi_queue_set(thud_world *w, int number);
/* The same for all candidates of a body that goes another way. */
void td_toi_queue_update_body(thud_world *w, const td_trajectory *trajectory);

#endif
