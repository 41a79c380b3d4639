/* options.c: see options.h. */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_STEPS = 1000000, MAX_REPETITIONS = 100 };

void options_print_help(void) {
    printf(
        "usage: thud-bench [option...]\n"
        "Runs scenes in thud and its rivals, a few steps each in turn, and compares the time\n"
        "per step, the overlap and the memory.\n\n"
        "what is measured (several in one run; without any, the scenes):\n"
        "  --scenes             every scene in every engine\n"
        "  --growth             time per body from 1,000 to 1,000,000 bodies, and bytes per body\n"
        "                       and per contact\n"
        "  --pay                what each feature costs: a scene with it and without it\n"
        "  --workers            what a second thread brings\n"
        "  --profile            the time of a step by stage, scene by scene\n"
        "  --all                all five\n\n"
        "how:\n"
        "  --scene NAME[:SIZE]  only this scene; may be given several times\n"
        "  --against ENGINE     only this rival; may be given several times. Here: box2d%s%s\n"
        "  --steps N            times N steps instead of the scene's own number\n"
        "  --repeat N           repetitions of every scene (default 3)\n"
        "  --quick              40 steps and 1 repetition: shows that it runs, compares little\n"
        "  --json FILE          also writes everything to FILE\n"
        "  --list               lists the scenes, and which steps of each are timed\n"
        "  --help               this text\n",
        engine_find("rapier") ? ", rapier" : "", engine_find("chipmunk") ? ", chipmunk" : "");
}

void options_print_list(void) {
    printf("%-15s %8s %8s %7s %9s  %s\n", "scene", "size", "warm-up", "steps", "at least", "");
    for (int i = 0; i < bench_plan_count(); i++) {
        bench_plan plan = bench_plan_at(i);
        int size = plan.size ? plan.size : bench_scene(plan.scene)->default_size;
        printf("%-15s %8d %8d %7d %9.1f  %s\n", plan.scene, size, plan.warm_up, plan.steps,
               plan.target, plan.why);
    }
    printf("\nOnly by name, the first five seconds of: rubble");
    for (int i = 0; i < scenes_count(); i++)
        if (!bench_plan_for(scenes_at(i)->name, 0).by_default)
            printf(", %s", scenes_at(i)->name);
    printf("\nSize counts what a scene is made of; warm-up and steps are steps of 1/60 s;\n"
           "at least: Box2D's time over thud's.\n");
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
    if (o->scene_count == OPTIONS_MAX_SCENES)
        return fail("too many scenes", text);
    o->scenes[o->scene_count++] = (chosen_scene){info, size};
    return true;
}

static void add_default_scenes(options *o) {
    for (int i = 0; i < bench_plan_count() && o->scene_count < OPTIONS_MAX_SCENES; i++) {
        bench_plan plan = bench_plan_at(i);
        const scene_info *info = bench_scene(plan.scene);
        if (plan.by_default)
            o->scenes[o->scene_count++] =
                (chosen_scene){info, plan.size ? plan.size : info->default_size};
    }
}

static bool add_rival(options *o, const char *name) {
    const physics_engine *rival = engine_find(name);
    if (rival == &engine_thud)
        rival = NULL;
    for (int k = 1; k < o->engine_count; k++)
        if (o->engines[k] == rival)
            return true;
    if (rival)
        o->engines[o->engine_count++] = rival;
    return rival ||
           fail(strcmp(name, "rapier") == 0 ? "this build has no such engine, for want of Rust"
                                            : "no such engine",
                name);
}

/* Reads an option that takes no value. */
static bool read_flag(options *o, const char *name) {
    static const struct {
        const char *name;
        unsigned part;
    } PARTS[] = {{"--scenes", BENCH_SCENES},   {"--growth", BENCH_GROWTH},   {"--pay", BENCH_PAY},
                 {"--workers", BENCH_WORKERS}, {"--profile", BENCH_PROFILE}, {"--all", BENCH_ALL}};
    for (size_t i = 0; i < sizeof PARTS / sizeof PARTS[0]; i++) {
        if (strcmp(name, PARTS[i].name) == 0) {
            o->parts |= PARTS[i].part;
            return true;
        }
    }
    if (strcmp(name, "--quick") != 0)
        return false;
    o->quick = true;
    return true;
}

static bool read_value(options *o, const char *name, const char *value) {
    bool known = strcmp(name, "--scene") == 0 || strcmp(name, "--against") == 0 ||
                 strcmp(name, "--json") == 0 || strcmp(name, "--steps") == 0 ||
                 strcmp(name, "--repeat") == 0;
    if (!known)
        return fail("unknown option", name);
    if (!value)
        return fail("a value is missing after", name);
    if (strcmp(name, "--scene") == 0)
        return add_scene(o, value);
    if (strcmp(name, "--against") == 0)
        return add_rival(o, value);
    if (strcmp(name, "--steps") == 0)
        return read_int(value, 1, MAX_STEPS, &o->steps) ||
               fail("--steps wants a number from 1 to 1000000, not", value);
    if (strcmp(name, "--repeat") == 0)
        return read_int(value, 1, MAX_REPETITIONS, &o->repetitions) ||
               fail("--repeat wants a number from 1 to 100, not", value);
    o->json = value;
    return true;
}

/* Refuses options that the chosen parts do not use: growth, pay and workers have scenes and steps
 * of their own. Growth needs Box2D in the build. */
static bool is_of_use(const options *o) {
    if (o->parts & BENCH_GROWTH && !engine_find("box2d"))
        return fail("--growth wants Box2D, which this build has not", NULL);
    if (o->parts == 0 || o->parts & (BENCH_SCENES | BENCH_PROFILE))
        return true;
    if (o->scene_count > 0)
        return fail("--scene goes with --scenes and --profile only", NULL);
    return o->steps == 0 || fail("--steps goes with --scenes and --profile only", NULL);
}

static void fill_in_defaults(options *o) {
    if (o->scene_count == 0)
        add_default_scenes(o);
    if (o->engine_count == 1)
        for (int i = 1; i < BUILT_ENGINE_COUNT; i++)
            if (!BUILT_ENGINES[i]->only_by_name)
                o->engines[o->engine_count++] = BUILT_ENGINES[i];
    if (o->parts == 0)
        o->parts = BENCH_SCENES;
    if (o->repetitions == 0)
        o->repetitions = o->quick ? 1 : 3;
}

options_outcome options_read(options *o, int argc, char **argv) {
    *o = (options){.engines = {&engine_thud}, .engine_count = 1};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0)
            return OPTIONS_HELP;
        if (strcmp(argv[i], "--list") == 0)
            return OPTIONS_LIST;
    }
    for (int i = 1; i < argc; i++) {
        if (read_flag(o, argv[i]))
            continue;
        if (!read_value(o, argv[i], i + 1 < argc ? argv[i + 1] : NULL))
            return OPTIONS_WRONG;
        i++;
    }
    if (!is_of_use(o))
        return OPTIONS_WRONG;
    fill_in_defaults(o);
    return OPTIONS_RUN;
}
