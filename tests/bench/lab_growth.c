/* lab_growth.c: time and memory per body as the population grows; Box2D beside it. */
#include "lab.h"

#include "contender.h"
#include "lab_world.h"

#include <stdlib.h>

enum { STEPS = 60, WARM_UP = 60 };

typedef struct growth {
    double seconds; /* the median step */
    uint64_t bytes;
    int pairs;
} growth;

static bool measure_thud(const scene_info *info, int size, int steps, growth *out) {
    lab_world lab;
    double *seconds = calloc((size_t)steps, sizeof *seconds);
    thud_world_def def = lab_settings();
    bool ok = seconds && lab_open_scene(&lab, info, size, &def) && lab_run(&lab, steps, NULL) &&
              lab_run(&lab, steps, seconds);
    if (ok) {
        thud_stats stats = thud_world_stats(lab.world);
        *out = (growth){lab_median(seconds, steps), stats.bytes, stats.pairs};
    }
    lab_close(&lab);
    free(seconds);
    return ok;
}

static bool measure_box2d(const scene_info *info, int size, int steps, growth *out) {
    scene s;
    if (!scenes_fill(info, size, &s))
        return false;
    double *seconds = calloc((size_t)steps, sizeof *seconds);
    void *world = contender_box2d.create(&s, (contender_settings){0});
    bool ok = seconds && world;
    for (int i = 0; ok && i < 2 * steps; i++) {
        double start = lab_now(NULL);
        ok = contender_box2d.step(world);
        if (i >= steps)
            seconds[i - steps] = lab_now(NULL) - start;
    }
    if (ok)
        *out = (growth){lab_median(seconds, steps), contender_box2d.bytes(world), 0};
    contender_box2d.destroy(world);
    free(seconds);
    scene_free(&s);
    return ok;
}

static bool grow(const scene_info *info, bool quick, FILE *json, const char **between) {
    static const int SIZES[] = {1000, 4000, 16000, 64000, 256000};
    int sizes = quick ? 2 : 5, steps = quick ? 5 : STEPS;
    double least = 1e300, most = 0;
    for (int i = 0; i < sizes; i++) {
        growth own, rival;
        fprintf(stderr, "\r%s %d ...", info->name, SIZES[i]);
        if (!measure_thud(info, SIZES[i], steps, &own) ||
            !measure_box2d(info, SIZES[i], steps, &rival))
            return false;
        double each = own.seconds / SIZES[i], its = rival.seconds / SIZES[i];
        least = each < least ? each : least;
        most = each > most ? each : most;
        fprintf(stderr, "\r%24s\r", "");
        printf("%-8s %8d  %9.3f %7.1f  %9.3f %7.1f  %8.0f %8.0f  %8.2f\n", info->name, SIZES[i],
               own.seconds * 1e3, each * 1e9, rival.seconds * 1e3, its * 1e9,
               (double)own.bytes / SIZES[i], (double)rival.bytes / SIZES[i],
               (double)own.pairs / SIZES[i]);
        fflush(stdout);
        if (json)
            fprintf(json,
                    "%s  {\"scene\": \"%s\", \"bodies\": %d, \"ns_per_body\": %.4g, "
                    "\"box2d_ns_per_body\": %.4g, \"bytes_per_body\": %.5g, "
                    "\"box2d_bytes_per_body\": %.5g, \"pairs_per_body\": %.4g}",
                    *between, info->name, SIZES[i], each * 1e9, its * 1e9,
                    (double)own.bytes / SIZES[i], (double)rival.bytes / SIZES[i],
                    (double)own.pairs / SIZES[i]);
        *between = ",\n";
    }
    printf("%-8s dearest over cheapest body: %.2f\n", info->name, most / least);
    return true;
}

bool lab_growth(bool quick, FILE *json) {
    printf("%-8s %8s  %9s %7s  %9s %7s  %8s %8s  %8s\n", "scene", "bodies", "thud ms", "ns/body",
           "Box2D ms", "ns/body", "B/body", "its", "pairs/b.");
    const char *between = "";
    if (json)
        fprintf(json, "[\n");
    bool ok = grow(scenes_find("gas"), quick, json, &between) &&
              grow(&bench_rubble, quick, json, &between);
    if (json)
        fprintf(json, "\n]\n");
    return ok;
}
