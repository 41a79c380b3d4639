/* long_run.c: the extreme "long-run": a stack that stands for an hour, and ten minutes in which
 * bodies are destroyed and created. Measured are the drift of the stack, the growth of memory, and
 * allocations. */
#include "extremes/stack.h"

#include <math.h>

enum { BOXES = 10, SECOND = 60, MINUTE = 60 * SECOND };

/* Memory in use, and allocations, since a step. */
typedef struct growth {
    uint64_t bytes, blocks;
} growth;

/* Records the world's memory at the start. */
static growth growth_begin(trial *t) {
    return (growth){trial_bytes(t), 0};
}

/* Adds the allocations of the last step. */
static void growth_step(growth *g, trial *t) {
    g->blocks += trial_allocations(t);
}

/* Writes the bytes gained since the start and the number of allocations to the figures. */
static void growth_tell(const growth *g, trial *t, entrant e, figure *bytes, figure *blocks) {
    figure_tell(bytes, e, (double)trial_bytes(t) - (double)g->bytes);
    if (e != ENTRANT_BOX2D)
        figure_tell(blocks, e, (double)g->blocks);
}

/* Runs a stack for an hour with one entrant; the first ten seconds, in which it settles, are not
 * counted. */
static void stand(ledger *l, entrant e, const scene *s, figure *drift, figure *bytes,
                  figure *blocks) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return;
    bool ok = trial_steps(t, 10 * SECOND);
    scene_point settled[BOXES + 1];
    const engine_body *now = trial_read(t);
    for (int i = 0; i <= BOXES; i++)
        settled[i] = (scene_point){now[i].x, now[i].y};
    growth g = growth_begin(t);
    double furthest = 0;
    int steps = l->quick ? 30 * SECOND : 60 * MINUTE;
    for (int i = 1; ok && i <= steps; i++) {
        ok = trial_step(t);
        growth_step(&g, t);
        if (i % SECOND != 0)
            continue;
        now = trial_read(t);
        for (int b = 1; b <= BOXES; b++)
            furthest = fmax(furthest, hypot(now[b].x - settled[b].x, now[b].y - settled[b].y));
        if (i % MINUTE == 0)
            ledger_progress(l, drift->what, 0.5 * (e + (double)i / steps) / ENTRANTS);
    }
    figure_tell(drift, e, ok ? 1000 * furthest : INFINITY);
    growth_tell(&g, t, e, bytes, blocks);
    trial_end(t);
}

enum { RAIN = 200 };

/* Circles above a trough, with gaps of half a radius. */
static void fill_rain(scene *s) {
    scene_init(s);
    scene_static_box(s, 0, -1, 10, 1);
    for (int side = -1; side <= 1; side += 2)
        scene_static_box(s, 9.0 * side, 10, 1, 10);
    for (int i = 0; i < RAIN; i++)
        scene_dynamic_circle(s, -7.5 + 0.625 * (i % 21), 12 + 0.625 * (i / 21), 0.25);
}

/* In each step one circle is destroyed and created again at its start, each in turn. The first
 * minute is not counted. */
static void rain(ledger *l, entrant e, const scene *s, figure *bytes, figure *blocks) {
    trial *t = trial_begin(l, e, s, (engine_settings){0});
    if (!t)
        return;
    int first = s->body_count - RAIN;
    int before = l->quick ? 10 * SECOND : MINUTE, steps = l->quick ? 20 * SECOND : 10 * MINUTE;
    growth g = {0};
    for (int i = 0; i < steps; i++) {
        if (i == before)
            g = growth_begin(t);
        if (!trial_renew(t, first + i % RAIN) || !trial_step(t))
            break;
        growth_step(&g, t);
        if (i % MINUTE == 0)
            ledger_progress(l, bytes->what, 0.5 + 0.5 * (e + (double)i / steps) / ENTRANTS);
    }
    growth_tell(&g, t, e, bytes, blocks);
    trial_end(t);
}

static void run(ledger *l) {
    scene stack, shower;
    stack_init(&stack, BOXES, 1);
    fill_rain(&shower);
    bound none = bound_at_most(0, ON_THUD);
    figure *drift = ledger_add(l, bound_at_most(1, ON_THUD),
                               "stack of ten, an hour: furthest that a box has moved, mm");
    figure *bytes = ledger_add(l, none, "stack of ten, an hour: memory grown by, bytes");
    figure *blocks = ledger_add(l, none, "stack of ten, an hour: blocks asked for in steps");
    figure *rain_bytes = ledger_add(l, none, "rain, ten minutes: memory grown by, bytes");
    figure *rain_blocks = ledger_add(l, none, "rain, ten minutes: blocks asked for in steps");
    for (entrant e = 0; e < ENTRANTS; e++) {
        if (!ledger_has(l, e))
            continue;
        stand(l, e, &stack, drift, bytes, blocks);
        rain(l, e, &shower, rain_bytes, rain_blocks);
    }
    scene_free(&stack);
    scene_free(&shower);
}

const extreme extreme_long_run = {
    .name = "long-run",
    .title = "Long runs",
    .about =
        "A stack of ten boxes of 1 m, awake for a simulated hour; figures from the tenth "
        "second on, when it has settled. And a rain of 200 circles into a trough, of which one "
        "is destroyed and made anew in every step; figures from the second minute on.",
    .run = run,
};
