/* joint_crowds.c: the extreme "joint-crowds": scenes with many joints, and joints far from the
 * origin. Measured are joint gaps, angles beyond limits, overlap, and bit differences. */
#include "extremes/tied.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int by_size(const void *left, const void *right) {
    const double *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

typedef struct crowd {
    const char *name;
    void (*fill)(scene *s, int size);
    int size, quick_size;
} crowd;

/* The 99th percentile of the gap over all joints and steps and the largest gap, in mm; the largest
 * angle beyond a limit, in degrees; the deepest overlap, in mm. */
static tied_outcome crowd_gaps(ledger *l, entrant e, const void *how) {
    const crowd *c = how;
    scene s;
    scene_init(&s);
    c->fill(&s, l->quick ? c->quick_size : c->size);
    int steps = l->quick ? 90 : 600;
    long seen = 0;
    joint_gaps gaps = {0};
    penetration deep = {0};
    tied_outcome o = {{INFINITY, INFINITY, INFINITY, INFINITY}};
    double *all = calloc((size_t)steps * (size_t)s.joint_count + 1, sizeof *all);
    trial *t = all ? trial_begin(l, e, &s, (engine_settings){0}) : NULL;
    for (int i = 0; t && i < steps && trial_step(t); i++) {
        const engine_body *now = trial_read(t);
        for (int k = 0; k < s.joint_count; k++)
            all[seen++] = joint_gap_of(&s, k, now).length;
        trial_joint_gaps(t, &gaps);
        trial_penetration(t, &deep);
    }
    if (seen > 0 && gaps.lost == 0) {
        qsort(all, (size_t)seen, sizeof *all, by_size);
        o = (tied_outcome){{1000 * all[seen * 99 / 100], 1000 * gaps.worst.length,
                            DEGREES * gaps.worst.beyond_angle, 1000 * deep.worst}};
    }
    trial_end(t);
    free(all);
    scene_free(&s);
    return o;
}

/* How much the middle column of a hanging grid is stretched, in % of its height, and the largest
 * gap in mm, both in the second half of the run. */
static tied_outcome grid_gaps(ledger *l, entrant e, const void *how) {
    int side = *(const int *)how, steps = l->quick ? 60 : 600;
    scene s;
    scene_init(&s);
    fill_joint_grid(&s, side);
    joint_gaps gaps = {0};
    double open = INFINITY;
    trial *t = trial_begin(l, e, &s, (engine_settings){0});
    if (t && trial_steps(t, steps / 2)) {
        for (int i = 0; i < steps / 2 && trial_step(t); i++)
            trial_joint_gaps(t, &gaps);
        /* Sums the gaps of the middle column, from its fixed end to its free end. */
        const engine_body *now = trial_read(t);
        open = 0;
        for (int i = 0; i < s.joint_count; i++) {
            const scene_joint *j = &s.joints[i];
            if (j->body[1] / side == side / 2 && j->body[0] == j->body[1] - 1)
                open += joint_gap_of(&s, i, now).length;
        }
    }
    trial_end(t);
    scene_free(&s);
    bool whole = gaps.lost == 0 && isfinite(open);
    return (tied_outcome){
        {whole ? 100 * open / (side - 1) : INFINITY, whole ? 1000 * gaps.worst.length : INFINITY}};
}

/* Bridges and cars have no angle limits. */
static void tell_crowds(ledger *l) {
    static const tied_row ROWS[] = {{"gap, 99th percentile, mm", 0, 0},
                                    {"worst gap, mm", 0, 0},
                                    {"past a limit, degrees", 0, 0},
                                    {"deepest overlap, mm", 0, 0}};
    static const crowd CROWDS[] = {
        {"50 ragdolls on stairs", fill_ragdolls, 50, 5},
        {"50 ragdolls in a pit", fill_ragdoll_heap, 50, 5},
        {"bridge of 10 planks", fill_boxed_bridge, 10, 10},
        {"bridge of 100 planks", fill_boxed_bridge, 100, 20},
        {"bridge of 1,000 planks", fill_boxed_bridge, 1000, 30},
        {"3 cars", fill_cars, 3, 1},
        {"33 cars", fill_cars, 33, 2},
        {"333 cars", fill_cars, 333, 3},
    };
    enum { CROWD_COUNT = sizeof CROWDS / sizeof CROWDS[0] };
    for (int i = 0; i < CROWD_COUNT; i++) {
        ledger_progress(l, CROWDS[i].name, 0.4 * i / CROWD_COUNT);
        tied_tell(l, ROWS, 4, CROWDS[i].name, crowd_gaps, &CROWDS[i]);
    }
}

static void tell_grids(ledger *l) {
    static const tied_row GRID[] = {{"stretch of its middle, %", 0, 0}, {"worst gap, mm", 0, 0}};
    const int small = l->quick ? 10 : 40, large = 100;
    ledger_progress(l, "grid", 0.4);
    tied_tell(l, GRID, 2, "grid of 40 x 40", grid_gaps, &small);
    ledger_progress(l, "larger grid", 0.5);
    /* In Chipmunk the grid breaks apart, and its bodies fly so far that memory runs out. */
    unsigned all = l->entrants;
    l->entrants &= ~(unsigned)ON_CHIPMUNK;
    if (!l->quick)
        tied_tell(l, GRID, 2, "grid of 100 x 100", grid_gaps, &large);
    l->entrants = all;
}

static void fill_swinging_chain(scene *s, int count) {
    fill_chain(s, &(chain_scene){count, 100, true});
}

static void fill_loaded_bridge(scene *s, int count) {
    fill_bridge(s, &(bridge_scene){count, count - 2, count / 3, 40});
}

typedef struct place {
    void (*fill)(scene *s, int size);
    int size;
} place;

static trial *run_at(ledger *l, entrant e, const scene *s, double x, double y) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (t) {
        trial_look_from(t, x, y);
        trial_steps(t, l->quick ? 60 : 600);
    }
    return t;
}

/* The number of bodies that differ in a bit of their pose 10^7 units away, and the largest gap
 * there at the end, in mm. */
static tied_outcome far_from_near(ledger *l, entrant e, const void *how) {
    static const double AWAY = 1e7;
    const place *p = how;
    scene near, far;
    scene_init(&near);
    scene_init(&far);
    p->fill(&near, p->size);
    p->fill(&far, p->size);
    scene_shift(&far, AWAY, -AWAY);
    trial *a = run_at(l, e, &near, 0, 0), *b = run_at(l, e, &far, AWAY, -AWAY);
    tied_outcome o = {{INFINITY, INFINITY}};
    if (a && b) {
        joint_gaps gaps = {0};
        trial_joint_gaps(b, &gaps);
        o = (tied_outcome){{0, gaps.lost > 0 ? INFINITY : 1000 * gaps.worst.length}};
        for (int i = 0; i < near.body_count; i++) {
            float at_a[4], at_b[4];
            trial_pose(a, i, at_a);
            trial_pose(b, i, at_b);
            o.value[0] += memcmp(at_a, at_b, sizeof at_a) != 0;
        }
    }
    trial_end(a);
    trial_end(b);
    scene_free(&near);
    scene_free(&far);
    return o;
}

static void tell_far_away(ledger *l) {
    static const place PLACES[] = {{fill_ragdolls, 10},
                                   {fill_swinging_chain, 30},
                                   {fill_loaded_bridge, 20}};
    static const char *const NAMES[] = {"10 ragdolls, 10^7 away", "swinging chain, 10^7 away",
                                        "bridge, 10^7 away"};
    for (int i = 0; i < 3; i++) {
        ledger_progress(l, NAMES[i], 0.8 + i / 15.0);
        figure *differ =
            ledger_add(l, bound_at_most(0, ON_THUD), "%s: bodies that differ in a bit", NAMES[i]);
        figure *gap = ledger_add(l, bound_none(), "%s: worst gap at the end, mm", NAMES[i]);
        for (entrant e = 0; e < ENTRANTS; e++) {
            if (!ledger_has(l, e))
                continue;
            tied_outcome o = far_from_near(l, e, &PLACES[i]);
            figure_tell(differ, e, o.value[0]);
            figure_tell(gap, e, o.value[1]);
        }
    }
}

static void run(ledger *l) {
    tell_crowds(l);
    tell_grids(l);
    tell_far_away(l);
}

const extreme extreme_joint_crowds = {
    .name = "joint-crowds",
    .title = "Many joints, and joints far away",
    .about =
        "Ragdolls of 11 bodies and 10 hinges with limits fall on stairs and into a pit, boxes lie on "
        "bridges, and cars drive over waves, for 10 s; a grid of hinged circles hangs from the middle of its upper row, measured in the last 5 of 10 s; "
        "and scenes with joints, run for 10 s at the origin and far from it.",
    .run = run,
    .also = ON_BOX2D | ON_CHIPMUNK,
};
