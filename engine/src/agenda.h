/* agenda.h: which of many things comes next: a binary heap of numbers with a time each, that may be
 * brought forward, put off or struck out. Equal times come in the order of the numbers. */
#ifndef TD_AGENDA_H
#define TD_AGENDA_H

#include "memory.h"

typedef struct td_agenda {
    td_array time; /* double, by number */
    td_array spot; /* int, by number: where it stands in the heap, or TD_NONE */
    td_array heap; /* int: numbers */
} td_agenda;

void td_agenda_init(td_agenda *agenda);
/* Room for the numbers below `count`. False when memory is short. */
bool td_agenda_reserve(td_memory *memory, td_agenda *agenda, int count);
void td_agenda_free(td_memory *memory, td_agenda *agenda);

/* Empty, for numbers below `count`, for which there is room. */
void td_agenda_clear(td_agenda *agenda, int count);
void td_agenda_set(td_agenda *agenda, int number, double time);
void td_agenda_strike(td_agenda *agenda, int number); /* fine if it is not there */
/* The number that comes first, taken out, or TD_NONE. */
int td_agenda_next(td_agenda *agenda, double *time);

#endif
