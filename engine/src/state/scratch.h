/* scratch.h: lists that a step makes for itself, and keeps only for the room that they have. */
#ifndef TD_SCRATCH_H
#define TD_SCRATCH_H

#include "base/event_queue.h"
#include "base/memory.h"

typedef struct td_scratch {
    td_array hits;    /* int: what a grid reports */
    td_array ahead;   /* int: shapes at rest that a fast body may hit */
    td_array crowded; /* int: shapes in a crowd of which pairs are missing */
    td_array stamps;  /* uint32_t, by shape: the last one that it was found to touch */
    uint32_t stamp;
    td_array pairs;               /* td_new_pair */
    td_array bodies, constraints; /* int: an island that wakes or falls asleep */
    td_array blocks;              /* td_block *: in solver order */
    td_array runs;                /* td_run */
    bool sequenced;               /* `blocks` and `runs` list all blocks of the awake bins */
    td_array parted;              /* td_block *: have a lane that touches no more */
    td_array chunks;              /* td_chunk: what workers take of the blocks */
    td_array counters;            /* atomic_int: of phases, see jobs.h */
    td_array begins, ends;        /* int: contacts */
    td_array parents;             /* td_awake_slot, by awake slot: see label.h */
    td_array lane_bins;           /* int: see td_lanes_place */
    td_array test_blocks;         /* td_block of the largest form: waiting pairs under test */
    td_array test_list;           /* td_block *: to those of test_blocks */
    td_array fast;                /* td_awake_slot: dynamic bodies that moved further than half
                                     their core */
    td_event_queue queue;         /* of the time-of-impact candidates that are going to meet */
    td_array trajectories;        /* td_trajectory, by awake slot */
    td_array candidates;          /* td_toi_candidate: the extra ones */
    td_array strays;              /* td_stray */
    td_array impacts;             /* td_impact; before, td_pushes by block: gaps.c */
    td_array odd;                 /* td_awake_slot: what wide_finalize.c leaves to finalize.c */
    td_array next_tied;           /* td_awake_slot, by awake slot: constraint/tied_bodies.h */
    td_array before;              /* float[4], by awake slot: velocities, joints/joint_yield.c */
    td_array powers;              /* double[3], by ring: joints/joint_brace.c */
    td_array held_at;             /* double, by awake slot: see td_held_count */
    td_array legs;                /* td_leg, in the order of time: detection/sensing.c */
    td_array first_legs;          /* int, by awake slot: the first of its legs, or TD_NONE */
    td_array sensing;             /* td_awake_slot: bodies with sensors */
    int sensed_room;              /* pairs of sensors that may still come or be passed in this
                                     step; 0 where it began without sensors */
    td_array order;               /* while a proxy set is put into its order */
} td_scratch;

#endif
