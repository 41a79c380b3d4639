/* scratch.h: arrays that are valid within one step or query; those of td_lanes_sequence, while
 * `sequenced` is set. Their memory is kept between steps. Of them only `begins` and `ends` are in
 * snapshots, for steps that ran out of memory. */
#ifndef TD_SCRATCH_H
#define TD_SCRATCH_H

#include "base/bounds_grid.h"
#include "base/event_queue.h"
#include "base/memory.h"

typedef struct td_scratch {
    td_array found_shapes;        /* int: shapes that a broadphase search has found */
    td_array near_rest;           /* int: resting shapes near the awake ones that moved */
    td_array ahead;               /* int: resting shapes that a fast body may hit */
    td_array crowded;             /* int: shapes of a crowd that may lack contacts: broadphase.c */
    td_array stamps;              /* uint32_t, by shape: partners have `stamp`: stamp_partners */
    uint32_t stamp;               /* number of the present search for partners */
    td_array pairs;               /* td_new_pair: broadphase/pairs.h */
    td_array bodies, constraints; /* int: of an island that wakes or falls asleep */
    td_array blocks;              /* td_block *: in the order of solving */
    td_array runs;                /* td_run: sequences of `blocks` of one bin */
    int points; /* number of points of all `blocks`, one or two a block: a measure of the work of
                   solving them */
    bool sequenced;     /* `blocks` and `runs` list all blocks of the awake bins */
    int bin_end[3];     /* from this colour (td_run.bin) on, no colour has lanes: [0] of two moving
                           bodies, [1] with a static one; [2], of sleeping lanes, is not read */
    int placed_end;     /* bins by place from here on have no lanes */
    td_array separated; /* td_block *: with a lane whose shapes no longer touch */
    td_array chunks;    /* td_chunk: pieces of `runs`, each for one worker */
    td_array chunk_order;      /* int: indices of `chunks`, by phase and worker; after these the
                                  beginnings of parts (td_phase) */
    td_array phases;           /* td_phase: constraint/chunks.h */
    td_array bounds;           /* int, by worker: the first of its awake slots */
    td_array begins, ends;     /* int: contacts that begin or end in this step */
    td_array parents;          /* td_awake_slot, by awake slot: union-find, see label.h */
    td_array lane_bins;        /* int: see td_lanes_place */
    td_array test_blocks;      /* td_block of the contacts' largest form: waiting pairs to test */
    td_array test_list;        /* td_block *: pointers to those of test_blocks */
    td_array fast;             /* td_awake_slot: dynamic bodies that moved further than half
                                  their min_extent */
    td_event_queue queue;      /* candidates in the order of their time of impact */
    td_array trajectories;     /* td_trajectory, by awake slot */
    td_array extra_candidates; /* td_toi_candidate: pairs that may collide and are not contacts
                                */
    td_array escaped;      /* td_escaped_shape: shapes that may leave their bounds of the step */
    td_array arrivals;     /* td_arrival: detection/arrival_rows.h */
    td_array impacts;      /* td_impact; before detection, td_pushes by block: gaps.c */
    td_array odd;          /* td_awake_slot: bodies that wide_finalize.c leaves to finalize.c:
                              without one centred shape, not finite, or too fast for it */
    td_array shares;       /* td_share: state/shared_stages.h */
    td_array next_tied;    /* td_awake_slot, by awake slot: constraint/tied_bodies.h */
    td_array before;       /* float[4], by awake slot: velocities, joints/joint_yield.c */
    td_array brace_groups; /* td_brace_group, by group of bodies: joints/joint_brace.c */
    td_array held_at;      /* double, by awake slot: see td_held_count */
    td_array legs;         /* td_leg, parts of paths in the order of time: sensing.c */
    td_array first_legs;   /* int, by awake slot: the first of its legs, or TD_NONE */
    td_array sensing;      /* td_awake_slot: awake bodies with sensors */
    td_bounds_grid
        sensed; /* grid of awake sensors. sensing_awake.c fills it with the paths of their bodies
                   (id: awake slot), later sensed_pairs.c with their fat bounds (id: shape) */
    int sensed_room; /* new sensor pairs for which this step has reserved memory; 0:
                        it began without sensors */
    td_array order;  /* any type: while a proxy set is sorted, or chunks are cut */
} td_scratch;

#endif
