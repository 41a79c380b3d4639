/* long_run.c: an hour of standing still. */
#include "stack.h"

#include <math.h>

enum { BOXES = 10, SETTLING = 600 };

static void run(ledger *l) {
    int steps = l->quick ? 1800 : 60 * 60 * 60;
    scene s;
    stack_init(&s, BOXES, 1);
    figure *drift =
        ledger_add(l, bound_at_most(1, ON_THUD), "stack of ten: furthest that a box has moved, mm");
    figure *growth = ledger_add(l, bound_at_most(0, ON_THUD), "the same: memory grown by, bytes");
    figure *blocks =
        ledger_add(l, bound_at_most(0, ON_THUD), "the same: memory blocks asked for in steps");
    for (entrant e = 0; e < ENTRANTS; e++) {
        if (!ledger_has(l, e))
            continue;
        trial *t = trial_begin(l, e, &s, (trial_settings){0});
        if (!t)
            continue;
        bool ok = trial_steps(t, SETTLING);
        scene_point settled[BOXES + 1];
        const contender_body *now = trial_read(t);
        for (int i = 0; i <= BOXES; i++)
            settled[i] = (scene_point){now[i].x, now[i].y};
        uint64_t bytes = trial_bytes(t), allocations = 0;
        double furthest = 0;
        for (int i = 0; ok && i < steps; i++) {
            ok = trial_step(t);
            allocations += trial_allocations(t);
            if (i % 60 != 59)
                continue;
            now = trial_read(t);
            for (int b = 1; b <= BOXES; b++)
                furthest = fmax(furthest, hypot(now[b].x - settled[b].x, now[b].y - settled[b].y));
            if (i % 3600 == 3599)
                ledger_progress(l, entrant_name(e), (e + (double)i / steps) / ENTRANTS);
        }
        figure_tell(drift, e, ok ? 1000 * furthest : INFINITY);
        figure_tell(growth, e, (double)trial_bytes(t) - (double)bytes);
        if (e != ENTRANT_BOX2D)
            figure_tell(blocks, e, (double)allocations);
        trial_end(t);
    }
    scene_free(&s);
}

const extreme extreme_long_run = {
    .name = "long-run",
    .title = "Long runs",
    .about = "A stack of ten boxes of 1 m, awake for a simulated hour; figures from the tenth "
             "second on, when it has settled.",
    .run = run,
};
