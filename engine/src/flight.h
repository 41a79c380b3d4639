/* flight.h: bodies on their way through a step, and the pairs that may meet on it. */
#ifndef TD_FLIGHT_H
#define TD_FLIGHT_H

#include "detection.h"
#include "world.h"

/* The way of an awake body from `since` to the end of the step: at constant speed, or falling. */
typedef struct td_flight {
    td_place place;   /* of the centre of mass, at `since` */
    uint32_t angle;
    int32_t body;
    int32_t extras;   /* edge of its first extra encounter: extra * 2 + side, or TD_NONE */
    int32_t impacts;
    double since;     /* in [0, 1] of the step */
    double motion[3]; /* in a whole step at the speed of `since`: x, y, angle */
    double fall[2];   /* by how much gravity changes that in a step; 0 where something bears it */
    bool free;        /* nothing but gravity acted on it: it moves as its velocity says */
    bool borne;       /* contacts pushed it in the step before */
    bool changed;     /* its way is no more the one that finish.c took */
    bool held;        /* stays where it is for the rest of the step */
    int32_t strays;   /* first of its shapes in scratch.strays, or TD_NONE */
} td_flight;

/* A shape that may leave the bounds that it had at the start of the step. */
typedef struct td_stray {
    td_bounds ahead; /* of the rest of its way */
    int32_t shape, next; /* of the same body */
    bool chose;      /* its body's own detection looks for what it meets */
} td_stray;

/* Two shapes that may meet; a terrain comes first. Numbers below w->contacts.count are contacts',
 * the others extra ones': of terrain, and of bodies that strayed from where they were expected. */
typedef struct td_encounter {
    int32_t shape[2], body[2];
    int32_t next[2]; /* extra: edges of the same bodies */
    bool vetoed;
} td_encounter;

/* The flight of an awake body, by its slot. */
static inline td_flight *td_flight_at(const thud_world *w, int slot)
{
    return td_at(&w->scratch.flights, slot);
}

/* What finds out when the two meet. */
const thud_detection *td_detection_of(const thud_world *w, int body_a, int body_b);

/* The flight of any body; those at rest stay where they are. */
td_flight td_flight_of(const thud_world *w, int body);
/* Brings it to `time`, which is no earlier than `since`. */
void td_flight_advance(const thud_world *w, td_flight *flight, double time);
/* From `since` on something bears this part of the fall; the velocity at the end lacks it as well. */
void td_flight_bear(const thud_world *w, td_flight *flight, double x, double y);
/* One of the body's shapes at `time`, relative to `origin`. */
thud_placed td_flight_shape(const thud_world *w, const td_flight *flight, int shape, double time,
                            td_place origin);

/* How far a parabola may be from its chord, of one body as the other sees it. */
double td_flights_bend(const td_flight *a, const td_flight *b, double rest);

td_encounter *td_extra_at(const thud_world *w, int number);
td_encounter td_encounter_at(const thud_world *w, int number);

/* How the two fly from `now` until a later time; false where they surely do not meet. */
bool td_encounter_approach(thud_world *w, const td_encounter *e, double now, double until,
                           td_approach *approach);

/* Their ways alone: places at `now`, and motions from then on. */
void td_encounter_ways(const thud_world *w, const td_encounter *e, double now, double until,
                       td_approach *approach);
/* One of them may be hidden from the other: see seams.h. */
bool td_encounter_has_seams(const thud_world *w, const td_encounter *e);

/* Where two shapes are nearest to each other, relative to `origin`. */
typedef struct td_features {
    td_place origin;
    thud_contacts contacts;
} td_features;

void td_encounter_features(thud_world *w, const td_encounter *e, double time,
                           td_features *features);

#endif
