/* lab_profile.c: the time of a step by stage, from the engine's own clock. */
#include "lab.h"

#include "lab_world.h"

#include <stdlib.h>

static bool profile(const bench_plan *plan, bool quick, FILE *json, const char *between) {
    bench_plan cut = quick ? bench_plan_quick(*plan) : *plan;
    thud_world_def def = lab_settings();
    def.sleeping = plan->sleeping;
    def.clock = lab_now;
    lab_world lab;
    double stage[THUD_STAGE_COUNT] = {0}, total = 0;
    bool ok = lab_open_scene(&lab, bench_scene(plan->scene), plan->size, &def) &&
              lab_run(&lab, cut.warm_up, NULL);
    for (int i = 0; ok && i < cut.steps; i++) {
        ok = lab_run(&lab, 1, NULL);
        thud_stats stats = thud_world_stats(lab.world);
        total += stats.step_seconds;
        for (int k = 0; k < THUD_STAGE_COUNT; k++)
            stage[k] += stats.stage_seconds[k];
    }
    if (ok) {
        printf("%-14s %7d %8.3f ", plan->scene, thud_world_stats(lab.world).bodies,
               total / cut.steps * 1e3);
        if (json)
            fprintf(json, "%s  {\"scene\": \"%s\", \"bodies\": %d, \"ms\": %.5g", between,
                    plan->scene, thud_world_stats(lab.world).bodies, total / cut.steps * 1e3);
        for (int k = 0; k < THUD_STAGE_COUNT; k++) {
            printf(" %11.1f", 100 * stage[k] / total);
            if (json)
                fprintf(json, ", \"%s\": %.4g", thud_stage_name((thud_stage)k),
                        100 * stage[k] / total);
        }
        printf("\n");
        fflush(stdout);
        if (json)
            fprintf(json, "}");
    }
    lab_close(&lab);
    return ok;
}

bool lab_profile(bool quick, FILE *json) {
    printf("%-14s %7s %8s ", "scene", "bodies", "ms");
    for (int k = 0; k < THUD_STAGE_COUNT; k++)
        printf(" %9s %%", thud_stage_name((thud_stage)k));
    printf("\n");
    if (json)
        fprintf(json, "[\n");
    bool ok = true;
    for (int i = 0; ok && i < bench_plan_count(); i++) {
        bench_plan plan = bench_plan_at(i);
        ok = profile(&plan, quick, json, i ? ",\n" : "");
    }
    if (json)
        fprintf(json, "\n]\n");
    return ok;
}
