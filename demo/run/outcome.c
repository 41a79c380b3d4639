/* outcome.c: prints the result of a run as text or as JSON. */
#include "choices.h"
#include "outcome.h"

#include <cjson/cJSON.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

double run_error_of(const run_outcome *o, const scene *s) {
    double length = fmax(o->penetration_max, o->worst.joint_gap_max);
    return o->passed > 0 || o->quarantined > 0 ? INFINITY : fmax(0, length) / s->length_scale;
}

static double energy_of(const run_outcome *o) {
    return o->measure.kinetic_energy + o->measure.potential_energy;
}

static double ms_per_step(const run_outcome *o, double seconds) {
    return 1000 * seconds / (double)o->steps;
}

void run_print_text(const run_outcome *o, const scene *s, const run_options *options) {
    printf("scene        %s (quality %s)\n", s->name, QUALITIES[options->quality]->name);
    printf("steps        %ld\n", o->steps);
    printf("bodies       %d (%d awake), %d shapes\n", o->stats.bodies, o->stats.awake_bodies,
           o->stats.shapes);
    printf("contacts     %d of %d pairs\n", o->stats.contacts, o->stats.pairs);
    printf("ms per step  %.4f (slowest %.4f)\n", ms_per_step(o, o->seconds),
           1000 * o->worst_seconds);
    for (int i = 0; i < THUD_STAGE_COUNT; i++)
        printf("  %-12s %.4f\n", thud_stage_name((thud_stage)i),
               ms_per_step(o, o->stage_seconds[i]));
    printf("penetration  %.6g at worst, at the end %.6g at worst and %.6g in the mean\n",
           o->penetration_max, o->measure.penetration_max, o->measure.penetration_mean);
    printf("worst step   penetration %.6g in the mean, residual %.6g, %d overlaps, energy %+.6g\n",
           o->worst.penetration_mean, o->worst.residual, o->worst.overlaps, o->worst.energy_change);
    if (s->joint_count > 0)
        printf("joints       %d, open by %.6g and %.6g rad at worst\n", s->joint_count,
               o->worst.joint_gap_max, o->worst.joint_angle_max);
    printf("energy       %.9g (kinetic %.9g, potential %.9g)\n", energy_of(o),
           o->measure.kinetic_energy, o->measure.potential_energy);
    printf("memory       %" PRIu64 " bytes\n", o->stats.bytes);
    if (o->quarantined > 0)
        printf("quarantined  %ld bodies became non-finite and were frozen\n", o->quarantined);
    if (o->passed > 0)
        printf("passed       %ld times a body went through what stands\n", o->passed);
    printf("hash         %016" PRIx64 "\n", o->hash);
}

bool run_print_json(const run_outcome *o, const scene *s, const run_options *options) {
    char hash[17];
    snprintf(hash, sizeof hash, "%016" PRIx64, o->hash);
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "scene", s->name);
    cJSON_AddStringToObject(json, "quality", QUALITIES[options->quality]->name);
    cJSON_AddNumberToObject(json, "steps", (double)o->steps);
    cJSON_AddNumberToObject(json, "bodies", o->stats.bodies);
    cJSON_AddNumberToObject(json, "awake", o->stats.awake_bodies);
    cJSON_AddNumberToObject(json, "contacts", o->stats.contacts);
    cJSON_AddNumberToObject(json, "ms_per_step", ms_per_step(o, o->seconds));
    cJSON_AddNumberToObject(json, "ms_max", 1000 * o->worst_seconds);
    cJSON *stages = cJSON_AddObjectToObject(json, "ms_by_stage");
    for (int i = 0; i < THUD_STAGE_COUNT; i++)
        cJSON_AddNumberToObject(stages, thud_stage_name((thud_stage)i),
                                ms_per_step(o, o->stage_seconds[i]));
    cJSON_AddNumberToObject(json, "penetration_max", o->penetration_max);
    cJSON_AddNumberToObject(json, "penetration_end", o->measure.penetration_max);
    cJSON *worst = cJSON_AddObjectToObject(json, "worst_step_error");
    cJSON_AddNumberToObject(worst, "penetration_max", o->worst.penetration_max);
    cJSON_AddNumberToObject(worst, "penetration_mean", o->worst.penetration_mean);
    cJSON_AddNumberToObject(worst, "residual", o->worst.residual);
    cJSON_AddNumberToObject(worst, "energy_change", o->worst.energy_change);
    cJSON_AddNumberToObject(worst, "overlaps", o->worst.overlaps);
    cJSON_AddNumberToObject(worst, "joint_gap_max", o->worst.joint_gap_max);
    cJSON_AddNumberToObject(worst, "joint_angle_max", o->worst.joint_angle_max);
    cJSON_AddNumberToObject(json, "energy", energy_of(o));
    cJSON_AddNumberToObject(json, "bytes", (double)o->stats.bytes);
    cJSON_AddNumberToObject(json, "quarantined", (double)o->quarantined);
    cJSON_AddNumberToObject(json, "passed", (double)o->passed);
    cJSON_AddStringToObject(json, "hash", hash);
    return run_print_and_free(json);
}

bool run_print_and_free(cJSON *json) {
    char *text = json ? cJSON_Print(json) : NULL;
    cJSON_Delete(json);
    if (!text) {
        fprintf(stderr, "thud-run: out of memory\n");
        return false;
    }
    puts(text);
    cJSON_free(text);
    return true;
}
