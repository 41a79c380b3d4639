/* thud_bench.c: thud-bench, the side-by-side benchmark: reads the command line, runs the scenes
 * one after the other, prints each as soon as it is done. */
#include "lab.h"
#include "report.h"
#include "scenes.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MAX_SCENES = 64, MAX_STEPS = 1000000, MAX_REPETITIONS = 100 };

typedef struct chosen_scene {
    const scene_info *info;
    int size;
} chosen_scene;

typedef struct options {
    chosen_scene scenes[MAX_SCENES];
    int scene_count;
    const char *json;
    int steps; /* 0: the plan's */
    int repetitions;
    bool quick;
    bool (*lab)(bool quick, FILE *json); /* instead of the race */
} options;

static void print_help(void) {
    printf("usage: thud-bench [options]\n"
           "Runs scenes in thud and in Box2D v3.2, a few steps each in turn, and compares the time "
           "per step,\nthe overlap and the memory.\n\n"
           "  --scene NAME[:SIZE]  only this scene; may be given several times\n"
           "  --json FILE          also writes the results to FILE\n"
           "  --steps N            times N steps instead of the scene's own number\n"
           "  --repeat N           repetitions of every scene (default 3)\n"
           "  --growth             instead: time and memory per body from 1,000 to 256,000 bodies\n"
           "  --pay                instead: what each feature costs, the scene with it and without\n"
           "  --profile            instead: the time of a step by stage\n"
           "  --quick              40 steps and 1 repetition: shows that it runs, compares little\n"
           "  --list               lists the scenes, and which steps of each are timed\n"
           "  --help               this text\n");
}

static void print_list(void) {
    printf("%-15s %8s %8s %7s  %s\n", "scene", "size", "warm-up", "steps", "");
    for (int i = 0; i < bench_plan_count(); i++) {
        bench_plan plan = bench_plan_at(i);
        int size = plan.size ? plan.size : bench_scene(plan.scene)->default_size;
        printf("%-15s %8d %8d %7d  %s\n", plan.scene, size, plan.warm_up, plan.steps, plan.why);
    }
    printf("\nOnly by name, the first five seconds of: rubble");
    for (int i = 0; i < scenes_count(); i++)
        if (!bench_plan_for(scenes_at(i)->name, 0).by_default)
            printf(", %s", scenes_at(i)->name);
    printf("\n");
    printf("\nSize counts what a scene is made of; warm-up and steps are steps of 1/60 s.\n");
}

static bool fail(const char *what, const char *value) {
    fprintf(stderr, "thud-bench: %s%s%s (see --help)\n", what, value ? ": " : "",
            value ? value : "");
    return false;
}

static bool read_int(const char *text, int low, int high, int *out) {
    char *end;
    long value = strtol(text, &end, 10);
    if (end == text || *end || value < low || value > high)
        return false;
    *out = (int)value;
    return true;
}

static bool add_scene(options *o, const char *text) {
    char name[64];
    size_t length = strcspn(text, ":");
    if (length >= sizeof name)
        return fail("no such scene", text);
    memcpy(name, text, length);
    name[length] = '\0';
    const scene_info *info = bench_scene(name);
    if (!info)
        return fail("no such scene, --list shows all", name);
    int size = info->default_size;
    if (text[length] && !read_int(text + length + 1, info->min_size, info->max_size, &size))
        return fail("no size that this scene can have", text);
    if (o->scene_count == MAX_SCENES)
        return fail("too many scenes", text);
    o->scenes[o->scene_count++] = (chosen_scene){info, size};
    return true;
}

static void add_default_scenes(options *o) {
    for (int i = 0; i < bench_plan_count() && o->scene_count < MAX_SCENES; i++) {
        bench_plan plan = bench_plan_at(i);
        const scene_info *info = bench_scene(plan.scene);
        if (plan.by_default)
            o->scenes[o->scene_count++] =
                (chosen_scene){info, plan.size ? plan.size : info->default_size};
    }
}

static bool read_lab(options *o, const char *name) {
    static const struct {
        const char *name;
        bool (*lab)(bool quick, FILE *json);
    } LABS[] = {{"--growth", lab_growth}, {"--pay", lab_pay}, {"--profile", lab_profile}};
    for (size_t i = 0; i < sizeof LABS / sizeof LABS[0]; i++) {
        if (strcmp(name, LABS[i].name) == 0) {
            o->lab = LABS[i].lab;
            return true;
        }
    }
    return false;
}

static bool read_option(options *o, const char *name, const char *value, bool *takes_value) {
    *takes_value = false;
    if (strcmp(name, "--quick") == 0) {
        o->quick = true;
        return true;
    }
    if (read_lab(o, name))
        return true;
    *takes_value = true;
    bool known = strcmp(name, "--scene") == 0 || strcmp(name, "--json") == 0 ||
                 strcmp(name, "--steps") == 0 || strcmp(name, "--repeat") == 0;
    if (!known)
        return fail("unknown option", name);
    if (!value)
        return fail("a value is missing after", name);
    if (strcmp(name, "--scene") == 0)
        return add_scene(o, value);
    if (strcmp(name, "--steps") == 0)
        return read_int(value, 1, MAX_STEPS, &o->steps) ||
               fail("--steps wants a number from 1 to 1000000, not", value);
    if (strcmp(name, "--repeat") == 0)
        return read_int(value, 1, MAX_REPETITIONS, &o->repetitions) ||
               fail("--repeat wants a number from 1 to 100, not", value);
    o->json = value;
    return true;
}

static bool read_options(options *o, int argc, char **argv) {
    *o = (options){0};
    for (int i = 1; i < argc; i++) {
        bool takes_value;
        if (!read_option(o, argv[i], i + 1 < argc ? argv[i + 1] : NULL, &takes_value))
            return false;
        i += takes_value;
    }
    if (o->scene_count == 0)
        add_default_scenes(o);
    if (o->repetitions == 0)
        o->repetitions = o->quick ? 1 : 3;
    return true;
}

/* On a terminal only: one line that is overwritten until the scene's row takes its place. */
static void show_progress(const char *name, double fraction, void *context) {
    (void)context;
    fprintf(stderr, "\r%-15s %3.0f %%", name, 100 * fraction);
    if (fraction >= 1)
        fprintf(stderr, "\r%21s\r", "");
    fflush(stderr);
}

static bool run_scene(const options *o, const chosen_scene *chosen, race_result *out) {
    static const contender *const contenders[] = {&contender_thud, &contender_box2d};
    race_settings settings = {
        .contenders = contenders,
        .contender_count = sizeof contenders / sizeof contenders[0],
        .repetitions = o->repetitions,
        .progress = isatty(STDERR_FILENO) ? show_progress : NULL,
    };
    bench_plan plan = bench_plan_for(chosen->info->name, chosen->size);
    if (o->quick)
        plan = bench_plan_quick(plan);
    if (o->steps > 0)
        plan.steps = o->steps;
    scene s;
    if (!scenes_fill(chosen->info, chosen->size, &s))
        return fail("out of memory for scene", chosen->info->name);
    bool ok = race_run(&s, chosen->size, plan, &settings, out);
    out->scene = chosen->info->name;
    scene_free(&s);
    return ok;
}

static bool run_all(const options *o, FILE *json) {
    static race_result results[MAX_SCENES];
    int count = 0;
    bool ok = true;
    report_table_head(stdout);
    for (int i = 0; i < o->scene_count; i++) {
        if (!run_scene(o, &o->scenes[i], &results[count])) {
            ok = false;
            continue;
        }
        report_table_row(stdout, &results[count++]);
    }
    report_table_foot(stdout, o->repetitions);
    if (json && !report_json(json, results, count))
        ok = fail("could not write", o->json);
    return ok;
}

int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0)
            return print_help(), 0;
        if (strcmp(argv[i], "--list") == 0)
            return print_list(), 0;
    }
    options o;
    if (!read_options(&o, argc, argv))
        return 2;
    FILE *json = NULL;
    if (o.json && !(json = fopen(o.json, "w"))) {
        fail("cannot write", o.json);
        return 2;
    }
    bool ok = o.lab ? o.lab(o.quick, json) : run_all(&o, json);
    if (json && fclose(json) != 0)
        ok = fail("could not write", o.json);
    return ok ? 0 : 1;
}
