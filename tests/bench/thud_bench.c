/* thud_bench.c: the program thud-bench, which compares thud with other engines. It runs the parts
 * that the command line names, one after the other, and prints each when it is done. */
#include "json.h"
#include "lab/lab.h"
#include "machine.h"
#include "options.h"
#include "report.h"

#include <string.h>

static bench_plan plan_of(const options *o, const chosen_scene *chosen) {
    bench_plan plan = bench_plan_for(chosen->info->name, chosen->size);
    if (o->quick)
        plan = bench_plan_quick(plan);
    if (o->steps > 0)
        plan.steps = o->steps;
    return plan;
}

static bool run_scene(const options *o, const chosen_scene *chosen, race_result *out) {
    const physics_engine *able[RACE_MAX_ENGINES];
    race_settings settings = {.engines = able, .repetitions = o->repetitions};
    scene s;
    if (!scenes_fill(chosen->info, chosen->size, &s)) {
        fprintf(stderr, "thud-bench: out of memory for scene %s\n", chosen->info->name);
        return false;
    }
    /* An engine that cannot build the scene, for example because it has no joints, is left out. */
    for (int i = 0; i < o->engine_count; i++)
        if (engine_can_build(o->engines[i], &s))
            able[settings.engine_count++] = o->engines[i];
    bool ok = race_run(&s, chosen->size, plan_of(o, chosen), &settings, out);
    out->scene = chosen->info->name;
    scene_free(&s);
    return ok;
}

static bool run_scenes(const options *o, json *out) {
    bool ok = true, sleepers = false;
    report_table_head(stdout);
    json_begin_array(out, "scenes");
    for (int i = 0; i < o->scene_count; i++) {
        race_result result;
        if (!run_scene(o, &o->scenes[i], &result)) {
            ok = false;
            continue;
        }
        report_table_row(stdout, &result);
        report_json(out, &result);
        sleepers = sleepers || strcmp(result.scene, "asleep") == 0;
    }
    json_end(out);
    if (sleepers)
        ok = lab_alone(o->quick, out) && ok;
    report_table_foot(stdout, o->repetitions);
    return ok;
}

static bool run_profile(const options *o, json *out) {
    bench_plan plans[OPTIONS_MAX_SCENES];
    for (int i = 0; i < o->scene_count; i++)
        plans[i] = plan_of(o, &o->scenes[i]);
    printf("\nProfile: where the time of a step goes\n\n");
    return lab_profile(plans, o->scene_count, out);
}

static bool run_all(const options *o, FILE *file) {
    json out = {.file = file};
    json_begin_object(&out, NULL);
    machine_describe(&out);
    json_bool(&out, "quick", o->quick);
    json_number(&out, "repetitions", o->repetitions);
    bool ok = true;
    if (o->parts & BENCH_SCENES)
        ok = run_scenes(o, &out);
    static const struct {
        bench_part part;
        const char *title;
        bool (*run)(bool quick, json *out);
    } LABS[] = {
        {BENCH_GROWTH, "Growth: time per body as there are more of them", lab_growth},
        {BENCH_GROWTH, "Memory: bytes per body and per contact", lab_memory},
        {BENCH_PAY, "Pay for what you use: the same scene with a feature and without it", lab_pay},
        {BENCH_WORKERS, "Workers: the same world with one thread and with two", lab_workers},
    };
    for (size_t i = 0; i < sizeof LABS / sizeof LABS[0]; i++) {
        if (!(o->parts & LABS[i].part))
            continue;
        printf("\n%s\n\n", LABS[i].title);
        ok = LABS[i].run(o->quick, &out) && ok;
    }
    if (o->parts & BENCH_PROFILE)
        ok = run_profile(o, &out) && ok;
    json_end(&out);
    return ok;
}

int main(int argc, char **argv) {
    static options o;
    switch (options_read(&o, argc, argv)) {
    case OPTIONS_HELP:
        options_print_help();
        return 0;
    case OPTIONS_LIST:
        options_print_list();
        return 0;
    case OPTIONS_WRONG:
        return 2;
    case OPTIONS_RUN:
        break;
    }
    FILE *file = NULL;
    if (o.json && !(file = fopen(o.json, "w"))) {
        fprintf(stderr, "thud-bench: cannot write: %s (see --help)\n", o.json);
        return 2;
    }
    bool ok = run_all(&o, file);
    if (file) {
        bool written = !ferror(file);
        if (fclose(file) != 0 || !written) {
            fprintf(stderr, "thud-bench: could not write: %s\n", o.json);
            ok = false;
        }
    }
    return ok ? 0 : 1;
}
