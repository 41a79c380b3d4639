/* lab_profile.c: the time of each stage of a step, measured by the engine
 * (thud_stats.stage_seconds). */
#include "lab/lab.h"

#include "lab/lab_world.h"
#include "progress.h"

static bool profile(const bench_plan *plan, json *out) {
    thud_world_def def = lab_settings();
    def.sleeping = plan->sleeping;
    def.clock = lab_now;
    lab_world lab;
    double stage[THUD_STAGE_COUNT] = {0}, total = 0;
    bool ok = lab_open_scene(&lab, bench_scene(plan->scene), plan->size, &def) &&
              lab_run(&lab, plan->warm_up, NULL);
    thud_stats stats = {0};
    for (int i = 0; ok && i < plan->steps; i++) {
        progress_show(plan->scene, (double)i / plan->steps);
        ok = lab_run(&lab, 1, NULL);
        stats = thud_stats_of(lab.world);
        total += stats.step_seconds;
        for (int k = 0; k < THUD_STAGE_COUNT; k++)
            stage[k] += stats.stage_seconds[k];
    }
    progress_clear();
    lab_close(&lab);
    if (!ok)
        return false;
    double ms = total / plan->steps * 1e3;
    printf("%-14s %7d %8.3f", plan->scene, stats.bodies, ms);
    json_begin_object(out, NULL);
    json_text(out, "scene", plan->scene);
    json_number(out, "bodies", stats.bodies);
    json_number(out, "ms", ms);
    json_begin_object(out, "percent");
    for (int k = 0; k < THUD_STAGE_COUNT; k++) {
        printf(" %11.1f", 100 * stage[k] / total);
        json_number(out, thud_stage_name((thud_stage)k), 100 * stage[k] / total);
    }
    json_end(out);
    json_end(out);
    printf("\n");
    fflush(stdout);
    return true;
}

bool lab_profile(const bench_plan *plans, int count, json *out) {
    printf("%-14s %7s %8s", "% of a step", "bodies", "mean ms");
    for (int k = 0; k < THUD_STAGE_COUNT; k++)
        printf(" %11s", thud_stage_name((thud_stage)k));
    printf("\n");
    json_begin_array(out, "profile");
    bool ok = true;
    for (int i = 0; ok && i < count; i++)
        ok = profile(&plans[i], out);
    json_end(out);
    return ok;
}
