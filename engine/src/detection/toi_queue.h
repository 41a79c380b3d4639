/* toi_queue.h: the queue (scratch.queue, by time) of time-of-impact candidates. Numbers are those
 * of td_toi_candidate; a candidate is in the queue if its shapes may meet before the step ends; its
 * time is that of the impact, or the time from which the pair has to be tested again. */
#ifndef TD_TOI_QUEUE_H
#define TD_TOI_QUEUE_H

#include "detection/trajectory.h"

/* Whether a contact is a candidate: not if it is a sensor's, or on a terrain, whose pairs are
 * extra candidates. */
bool td_toi_queue_accepts(const thud_world *w, int contact);

/* Finds when a pair meets, or when it is to be tested again since only a part of its path was
 * tested; false if the pair does not meet in this step. Impacts that are ghosts are skipped. False
 * also for pairs that the prologue refused, whose detection finds no times of impact, or neither of
 * whose bodies an impact can stop. */
bool td_toi_queue_meeting_time(thud_world *w, const td_toi_candidate *e, double *time);
/* Queues a contact for the trajectories at the start of the step. */
void td_toi_queue_set_first(thud_world *w, int number);
/* Queues a candidate for the present trajectories of its two bodies, or takes it out of the queue.
 */
void td_toi_queue_set(thud_world *w, int number);
/* td_toi_queue_set for all candidates of a body whose trajectory has changed. */
void td_toi_queue_update_body(thud_world *w, const td_trajectory *trajectory);

#endif
