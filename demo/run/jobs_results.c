/* jobs_results.c: writes results of jobs, and reads those that an interrupted run has left. */
#define _POSIX_C_SOURCE 200809L

#include "jobs.h"

#include <cjson/cJSON.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Adds what the run of a job counted. */
static void add_outcome(cJSON *json, const run_outcome *o, double error) {
    char hash[17];
    snprintf(hash, sizeof hash, "%016" PRIx64, o->hash);
    cJSON_AddStringToObject(json, "hash", hash);
    cJSON_AddItemToObject(json, "error",
                          isfinite(error) ? cJSON_CreateNumber(error) : cJSON_CreateNull());
    cJSON_AddNumberToObject(json, "penetration_max", o->penetration_max);
    cJSON_AddNumberToObject(json, "joint_gap_max", o->worst.joint_gap_max);
    cJSON_AddNumberToObject(json, "energy",
                            o->measure.kinetic_energy + o->measure.potential_energy);
    cJSON_AddNumberToObject(json, "steps", (double)o->steps);
    cJSON_AddNumberToObject(json, "bodies", o->stats.bodies);
    cJSON_AddNumberToObject(json, "awake", o->stats.awake_bodies);
    cJSON_AddNumberToObject(json, "contacts", o->stats.contacts);
    cJSON_AddNumberToObject(json, "passed", (double)o->passed);
    cJSON_AddNumberToObject(json, "quarantined", (double)o->quarantined);
}

char *job_result(const job *j, const run_outcome *o, double error, const char *failure,
                 bool times) {
    cJSON *json = cJSON_CreateObject();
    cJSON_AddStringToObject(json, "id", j->id);
    cJSON_AddRawToObject(json, "job", j->text);
    if (failure)
        cJSON_AddStringToObject(json, "failed", failure);
    else
        add_outcome(json, o, error);
    if (!failure && times) {
        cJSON *object = cJSON_AddObjectToObject(json, "times");
        cJSON_AddNumberToObject(object, "seconds", o->seconds);
        cJSON_AddNumberToObject(object, "ms_per_step", 1000 * o->seconds / (double)o->steps);
        cJSON_AddNumberToObject(object, "ms_max", 1000 * o->worst_seconds);
    }
    char *text = cJSON_PrintUnformatted(json);
    cJSON_Delete(json);
    return text;
}

/* Marks the job of a result as done. False if the line is no result of a job of the list. */
static bool mark(const char *line, job **sorted, int count) {
    cJSON *json = cJSON_ParseWithOpts(line, NULL, 1);
    char *id = cJSON_GetStringValue(cJSON_GetObjectItemCaseSensitive(json, "id"));
    char *text = cJSON_PrintUnformatted(cJSON_GetObjectItemCaseSensitive(json, "job"));
    bool whole = cJSON_IsString(cJSON_GetObjectItemCaseSensitive(json, "hash")) ||
                 cJSON_IsString(cJSON_GetObjectItemCaseSensitive(json, "failed"));
    job **found = id && text && whole ? jobs_find(sorted, count, id) : NULL;
    bool known = found && strcmp((*found)->text, text) == 0;
    if (known) {
        (*found)->done = true;
        (*found)->failed = cJSON_HasObjectItem(json, "failed");
    }
    cJSON_free(text);
    cJSON_Delete(json);
    return known;
}

/* Marks the jobs whose results are lines of the text, which is changed. *whole: bytes of the lines
 * that have an end. */
static bool mark_all(const char *path, char *text, size_t length, job **sorted, int count,
                     size_t *whole) {
    int line = 1;
    *whole = 0;
    for (char *end; (end = memchr(text + *whole, '\n', length - *whole)); line++) {
        *end = '\0';
        if (!mark(text + *whole, sorted, count)) {
            fprintf(stderr, "thud-run: %s:%d: no result of a job of the list; was it changed?\n",
                    path, line);
            return false;
        }
        *whole = (size_t)(end + 1 - text);
    }
    return true;
}

/* Shortens a file. False after a message. */
static bool cut(const char *path, size_t length) {
    if (truncate(path, (off_t)length) == 0)
        return true;
    fprintf(stderr, "thud-run: %s cannot be written\n", path);
    return false;
}

bool jobs_resume(const char *path, job_list *list) {
    bool missing = false;
    size_t length, whole = 0;
    char *text = jobs_read_text(path, &length, &missing);
    if (!text)
        return missing;
    job **sorted = jobs_by_id(list);
    if (!sorted)
        fprintf(stderr, "thud-run: out of memory\n");
    bool done = sorted && mark_all(path, text, length, sorted, list->count, &whole) &&
                (whole == length || cut(path, whole));
    free(sorted);
    free(text);
    return done;
}
