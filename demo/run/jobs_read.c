/* jobs_read.c: reads a file of jobs, multiplies out what lists and ranges stand for, and checks
 * each job. */
#define _POSIX_C_SOURCE 200809L
#include "jobs.h"

#include "load.h"

#include <cjson/cJSON.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where in the file the reader is, and what the checks of jobs share. */
typedef struct jobs_reader {
    const char *path;
    int line;
    job_list *list;
    scene scene; /* of the last job, so that a list of settings loads it once */
    bool loaded;
    run_options loaded_as;
    char *loaded_source;
} jobs_reader;

/* Prints where and what is wrong; returns false. */
static bool complain(const jobs_reader *r, const char *what, const char *which) {
    fprintf(stderr, "thud-run: %s:%d: %s%s\n", r->path, r->line, what, which);
    return false;
}

char *jobs_read_text(const char *path, size_t *length, bool *missing) {
    FILE *file = fopen(path, "rb");
    if (!file && errno == ENOENT && missing) {
        *missing = true;
        return NULL;
    }
    char *text = NULL;
    size_t room = 0, used = 0;
    bool whole = file != NULL;
    while (whole) {
        if (room - used < 2) {
            room = room ? 2 * room : 65536;
            char *grown = realloc(text, room);
            whole = grown != NULL;
            text = grown ? grown : text;
            continue;
        }
        size_t got = fread(text + used, 1, room - used - 1, file);
        if (got == 0)
            break;
        used += got;
    }
    whole = whole && !ferror(file);
    if (file)
        fclose(file);
    if (!whole) {
        fprintf(stderr, "thud-run: %s cannot be read\n", path);
        free(text);
        return NULL;
    }
    text[used] = '\0';
    *length = used;
    return text;
}

/* ---- what a field stands for ---- */

/* The number of values of a range {"from", "to", "step"} or {"from", "to", "count"}, its first
 * value and the distance of two. 0: it is none, or has more than JOBS_MAX. */
static int range_of(const cJSON *json, double *first, double *step) {
    const cJSON *from = cJSON_GetObjectItemCaseSensitive(json, "from"),
                *to = cJSON_GetObjectItemCaseSensitive(json, "to"),
                *by = cJSON_GetObjectItemCaseSensitive(json, "step"),
                *count = cJSON_GetObjectItemCaseSensitive(json, "count");
    if (cJSON_GetArraySize(json) != 3 || !cJSON_IsNumber(from) || !cJSON_IsNumber(to))
        return 0;
    *first = from->valuedouble;
    double way = to->valuedouble - *first, values = 0;
    if (cJSON_IsNumber(count)) {
        values = floor(count->valuedouble);
        *step = values > 1 ? way / (values - 1) : 0;
        values = values == count->valuedouble ? values : 0;
    } else if (cJSON_IsNumber(by) && by->valuedouble != 0) {
        *step = by->valuedouble;
        values =
            floor(way / *step + 1e-9) + 1; /* 0.1 to 0.3 by 0.1 has its end in spite of rounding */
    }
    return values >= 1 && values <= JOBS_MAX ? (int)values : 0;
}

/* Whether the field's value is a list of values. Inputs are a list already: of several such. */
static bool is_list(const cJSON *item) {
    return cJSON_IsArray(item) &&
           (strcmp(item->string, "inputs") != 0 || cJSON_IsArray(item->child));
}

/* The number of values that the field stands for; 0: it is wrong. */
static int values_of(const cJSON *item) {
    double first, step;
    return is_list(item)          ? cJSON_GetArraySize(item)
           : cJSON_IsObject(item) ? range_of(item, &first, &step)
                                  : 1;
}

/* A copy of the field's value with the index. */
static cJSON *value_at(const cJSON *item, int index) {
    double first, step;
    if (is_list(item))
        return cJSON_Duplicate(cJSON_GetArrayItem(item, index), 1);
    if (cJSON_IsObject(item) && range_of(item, &first, &step) > 0)
        return cJSON_CreateNumber(first + index * step);
    return cJSON_Duplicate(item, 1);
}

/* ---- a job ---- */

/* Sets a number or a word, by the rules of the command line's option of the same name. */
static bool set_option(const cJSON *item, run_options *options) {
    static const char *const numbers[] = {"steps",     "rate",     "heavier",
                                          "cell_size", "substeps", "size"};
    static const char *const words[] = {"quality", "detection", "broadphase", "without"};
    bool number = false, word = false;
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++)
        number |= strcmp(item->string, numbers[i]) == 0;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++)
        word |= strcmp(item->string, words[i]) == 0;
    char option[32], text[64];
    snprintf(option, sizeof option, "--%s", item->string);
    if (strcmp(item->string, "cell_size") == 0)
        snprintf(option, sizeof option, "--cell-size");
    snprintf(text, sizeof text, "%.17g", item->valuedouble);
    if (number && cJSON_IsNumber(item))
        return run_options_set(option, text, options);
    return word && cJSON_IsString(item) && run_options_set(option, item->valuestring, options);
}

/* Sets a field of the job. False if there is none of this name or its value is wrong. */
static bool set_field(const cJSON *item, job *j) {
    const char *name = item->string;
    if (strcmp(name, "scene") == 0) {
        j->source = cJSON_IsString(item) ? strdup(item->valuestring) : NULL;
        return j->source != NULL;
    }
    if (strcmp(name, "seed") == 0) {
        j->seed = item->valueint;
        return cJSON_IsNumber(item) && j->seed == item->valuedouble && j->seed >= 0;
    }
    if (strcmp(name, "shake") == 0) {
        j->shake = item->valuedouble;
        return cJSON_IsNumber(item) && j->shake >= 0 && j->shake <= THUD_SPEED_MAX;
    }
    if (strcmp(name, "sleeping") == 0) {
        j->options.no_sleeping = cJSON_IsFalse(item);
        return cJSON_IsBool(item);
    }
    if (strcmp(name, "skip_unsupported") == 0) {
        j->options.skip_unsupported = cJSON_IsTrue(item);
        return cJSON_IsBool(item);
    }
    return set_option(item, &j->options);
}

/* Loads the job's scene, unless the job before had the same. */
static bool load(jobs_reader *r, const job *j) {
    const run_options *was = &r->loaded_as, *is = &j->options;
    if (r->loaded && strcmp(r->loaded_source, j->source) == 0 && was->size == is->size &&
        was->skip_unsupported == is->skip_unsupported)
        return true;
    if (r->loaded)
        scene_free(&r->scene);
    free(r->loaded_source);
    r->loaded_source = strdup(j->source);
    r->loaded_as = *is;
    r->loaded = r->loaded_source && run_load(is, &r->scene);
    return r->loaded;
}

/* Checks a job whose lists are multiplied out. */
static bool check_job(jobs_reader *r, const cJSON *json, job *j) {
    char why[RUN_FAILURE_MAX];
    for (const cJSON *item = json->child; item; item = item->next)
        if (strcmp(item->string, "inputs") != 0 && !set_field(item, j))
            return complain(r, "no such field, or no value for it: ", item->string);
    if (!j->source)
        return complain(r, "a job names its scene", "");
    if (j->shake >= 0 && j->seed == 0)
        return complain(r, "shake needs a seed from 1 on", "");
    j->options.source = j->source;
    const cJSON *inputs = cJSON_GetObjectItemCaseSensitive(json, "inputs");
    if (inputs && !job_inputs_read(inputs, j, why))
        return complain(r, why, "");
    if (!load(r, j))
        return complain(r, "the scene cannot be loaded", "");
    return job_inputs_fit(j, &r->scene, why) || complain(r, why, "");
}

/* Appends a job with nothing but its line. Null if memory runs out. */
static job *append(job_list *list, int line) {
    if (list->count == list->capacity) {
        int capacity = list->capacity ? 2 * list->capacity : 64;
        job *grown = realloc(list->jobs, (size_t)capacity * sizeof *grown);
        if (!grown)
            return NULL;
        list->jobs = grown;
        list->capacity = capacity;
    }
    job *j = &list->jobs[list->count++];
    *j = (job){.line = line, .shake = -1};
    run_options_default(&j->options);
    return j;
}

/* The id of the job with the index among so many of its line. */
static char *id_of(const jobs_reader *r, const char *given, int index, int count) {
    size_t room = (given ? strlen(given) : 0) + 32;
    char *id = malloc(room);
    if (!id)
        return NULL;
    int used = given ? snprintf(id, room, "%s", given) : snprintf(id, room, "%d", r->line);
    if (count > 1)
        snprintf(id + used, room - (size_t)used, "/%d", index + 1);
    return id;
}

/* Adds the job with the index of those that a line stands for: the last field varies fastest. */
static bool add_job(jobs_reader *r, const cJSON *line, const char *id, int index, int count) {
    job *j = append(r->list, r->line);
    cJSON *json = cJSON_CreateObject();
    int left = count, place = index;
    bool whole = j && json;
    for (const cJSON *item = line->child; item; item = item->next) {
        if (strcmp(item->string, "id") == 0)
            continue;
        left /= values_of(item);
        whole = cJSON_AddItemToObject(json, item->string, value_at(item, place / left)) && whole;
        place %= left;
    }
    bool added = whole && (j->text = cJSON_PrintUnformatted(json)) != NULL &&
                 (j->id = id_of(r, id, index, count)) != NULL;
    if (!added)
        complain(r, "out of memory", "");
    added = added && check_job(r, json, j);
    cJSON_Delete(json);
    return added;
}

/* The number of jobs that a line stands for. 0 after a message. */
static int count_jobs(const jobs_reader *r, const cJSON *json) {
    double count = 1;
    for (const cJSON *item = json->child; item; item = item->next) {
        if (cJSON_GetObjectItemCaseSensitive(json, item->string) != item)
            return complain(r, "a field stands there twice: ", item->string);
        int values = values_of(item);
        if (values == 0)
            return complain(r, "an empty list, or no range {from, to, step} or {from, to, count}: ",
                            item->string);
        count *= values;
    }
    if (count + r->list->count > JOBS_MAX)
        return complain(r, "more jobs than a file may have", "");
    return (int)count;
}

static bool read_line(jobs_reader *r, const char *text) {
    if (text[strspn(text, " \t\r")] == '\0')
        return true;
    cJSON *json = cJSON_ParseWithOpts(text, NULL, 1);
    const cJSON *id = cJSON_GetObjectItemCaseSensitive(json, "id");
    const char *name = cJSON_GetStringValue(id);
    int count = 0;
    if (!cJSON_IsObject(json))
        complain(r, "not a JSON object", "");
    else if (id && (!name || !*name))
        complain(r, "an id is a text that is not empty", "");
    else
        count = count_jobs(r, json);
    bool added = count > 0;
    for (int i = 0; i < count && added; i++)
        added = add_job(r, json, name, i, count);
    cJSON_Delete(json);
    return added;
}

static int by_id(const void *a, const void *b) {
    return strcmp((*(job *const *)a)->id, (*(job *const *)b)->id);
}

job **jobs_by_id(const job_list *list) {
    job **sorted = malloc(((size_t)list->count + 1) * sizeof *sorted);
    for (int i = 0; sorted && i < list->count; i++)
        sorted[i] = &list->jobs[i];
    if (sorted)
        qsort(sorted, (size_t)list->count, sizeof *sorted, by_id);
    return sorted;
}

job **jobs_find(job **sorted, int count, char *id) {
    job key = {.id = id}, *wanted = &key;
    return bsearch(&wanted, sorted, (size_t)count, sizeof *sorted, by_id);
}

/* Whether no two jobs have the same id. */
static bool check_ids(jobs_reader *r) {
    int count = r->list->count;
    job **sorted = jobs_by_id(r->list);
    if (!sorted)
        return complain(r, "out of memory", "");
    bool unique = true;
    for (int i = 1; i < count && unique; i++) {
        unique = strcmp(sorted[i - 1]->id, sorted[i]->id) != 0;
        r->line = sorted[i - 1]->line > sorted[i]->line ? sorted[i - 1]->line : sorted[i]->line;
        if (!unique)
            complain(r, "another job has the id ", sorted[i]->id);
    }
    free(sorted);
    return unique;
}

bool jobs_read(const char *path, job_list *list) {
    jobs_reader r = {.path = path, .list = list};
    size_t length;
    char *text = jobs_read_text(path, &length, NULL);
    bool done = text != NULL;
    for (char *line = text; done && line < text + length;) {
        char *end = memchr(line, '\n', (size_t)(text + length - line));
        end = end ? end : text + length;
        *end = '\0';
        r.line++;
        done = strlen(line) == (size_t)(end - line) ? read_line(&r, line)
                                                    : complain(&r, "not a JSON object", "");
        line = end + 1;
    }
    if (done && list->count == 0)
        fprintf(stderr, "thud-run: %s has no jobs\n", path);
    done = done && list->count > 0 && check_ids(&r);
    if (r.loaded)
        scene_free(&r.scene);
    free(r.loaded_source);
    free(text);
    return done;
}

void jobs_free(job_list *list) {
    for (int i = 0; i < list->count; i++) {
        job *j = &list->jobs[i];
        cJSON_free(j->text);
        free(j->id);
        free(j->source);
        free(j->inputs);
    }
    free(list->jobs);
    *list = (job_list){0};
}
