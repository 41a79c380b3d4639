/* load.c: see load.h. */
#include "load.h"

#include "level.h"
#include "scenes.h"
#include "without.h"

#include <stdio.h>
#include <string.h>

/* Prints a level's problems, and how many more were only counted. */
static void print_report(const char *path, const level_report *report) {
    static const char *const WORDS[] = {"note", "unsupported", "error"};
    for (int i = 0; i < report->count; i++)
        fprintf(stderr, "%s: %s: %s\n", path, WORDS[report->problems[i].severity],
                report->problems[i].text);
    int more = report->notes + report->skipped + report->fatal - report->count;
    if (more > 0)
        fprintf(stderr, "%s: and %d more\n", path, more);
}

/* Loads a level into *s. False, and *s is empty, after messages on stderr. */
static bool load_level(const run_options *options, scene *s) {
    level_report report;
    bool loaded = level_read_file(options->source, options->skip_unsupported, s, &report);
    if (!options->failure)
        print_report(options->source, &report);
    if (!loaded && report.fatal == 0)
        fprintf(stderr,
                "thud-run: refused because of %d problems; --skip-unsupported leaves them "
                "out\n",
                report.skipped);
    level_report_free(&report);
    return loaded;
}

/* Loads it whole. False after a message. */
static bool load_whole(const run_options *options, scene *s) {
    const scene_info *info = scenes_find(options->source);
    bool is_path = strpbrk(options->source, "./") != NULL;
    if (!info && !is_path) {
        fprintf(stderr, "thud-run: no scene is called '%s'; --list shows them all\n",
                options->source);
        return false;
    }
    if (!info && options->size != 0) {
        fprintf(stderr, "thud-run: --size is for built-in scenes, not for levels\n");
        return false;
    }
    if (!info)
        return load_level(options, s);
    if (options->size != 0 && (options->size < info->min_size || options->size > info->max_size)) {
        fprintf(stderr, "thud-run: the size of %s is from %d to %d %s\n", info->name,
                info->min_size, info->max_size, info->size_means);
        return false;
    }
    if (!scenes_fill(info, options->size, s)) {
        fprintf(stderr, "thud-run: out of memory\n");
        return false;
    }
    return true;
}

/* The mass of a body. */
static double mass_of(const scene *s, const scene_body *body) {
    double mass = 0;
    for (int i = 0; i < body->shape_count; i++) {
        const scene_shape *shape = &s->shapes[body->first_shape + i];
        double area = shape->kind == SCENE_CIRCLE ? 3.141592653589793 * shape->hx * shape->hx
                                                  : 4 * shape->hx * shape->hy;
        mass += shape->sensor ? 0 : area * shape->material.density;
    }
    return mass;
}

/* Makes the heaviest dynamic body, and of equal ones the highest, so many times as heavy. */
static void make_heavier(scene *s, double factor) {
    const scene_body *heaviest = NULL;
    double most = 0, top = 0;
    for (int i = 0; i < s->body_count; i++) {
        const scene_body *body = &s->bodies[i];
        double mass = mass_of(s, body), height = -(body->x * s->gravity_x + body->y * s->gravity_y);
        if (body->kind != SCENE_DYNAMIC || mass < most || (mass == most && height <= top))
            continue;
        heaviest = body;
        most = mass;
        top = height;
    }
    for (int i = 0; heaviest && i < heaviest->shape_count; i++)
        s->shapes[heaviest->first_shape + i].material.density *= factor;
}

bool run_load(const run_options *options, scene *s) {
    if (!load_whole(options, s))
        return false;
    without_change_scene(s, options->without);
    if (options->heavier != 1)
        make_heavier(s, options->heavier);
    return true;
}
