/* jobs.c: runs the jobs of a file on several threads, see jobs.h. */
#define _POSIX_C_SOURCE 200809L

#include "jobs.h"

#include <cjson/cJSON.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/* What the threads share. Each takes the next job, runs it, and writes its result. */
typedef struct jobs_work {
    const jobs_options *options;
    job **jobs; /* those to run */
    int count;
    pthread_mutex_t mutex; /* of all that follows */
    int next, finished, failed;
    FILE *out;
    bool broken; /* a result could not be written: no more jobs are begun */
} jobs_work;

/* The next job to run. Null if there is none. */
static const job *take(jobs_work *w) {
    pthread_mutex_lock(&w->mutex);
    const job *j = w->next < w->count && !w->broken ? w->jobs[w->next++] : NULL;
    pthread_mutex_unlock(&w->mutex);
    return j;
}

/* Writes a result and hands it to the system at once, so that a run that is killed loses no job
 * that it has finished, and leaves at most its last line unfinished. `line` may be null. */
static void put(jobs_work *w, const char *line, bool failed) {
    pthread_mutex_lock(&w->mutex);
    w->finished++;
    w->failed += failed;
    if (!line || w->broken || fprintf(w->out, "%s\n", line) < 0 || fflush(w->out) != 0)
        w->broken = true;
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r%d of %d jobs, %d failed ", w->finished, w->count, w->failed);
    pthread_mutex_unlock(&w->mutex);
}

static void *work(void *argument) {
    jobs_work *w = argument;
    for (const job *j = take(w); j; j = take(w)) {
        run_outcome outcome = {0};
        double error = 0;
        char failure[RUN_FAILURE_MAX] = "";
        bool done = job_run(j, &outcome, &error, failure);
        char *line = job_result(j, &outcome, error, done ? NULL : failure, w->options->times);
        put(w, line, !done);
        cJSON_free(line);
    }
    return NULL;
}

/* Works on `workers` threads, this one included, or on as many as can be created. */
static void work_on_threads(jobs_work *w, int workers) {
    pthread_t threads[THUD_WORKERS_MAX];
    int started = 0;
    while (started < workers - 1 && started < w->count - 1 &&
           pthread_create(&threads[started], NULL, work, w) == 0)
        started++;
    work(w);
    for (int i = 0; i < started; i++)
        pthread_join(threads[i], NULL);
}

/* Lists the jobs of the part that are not done yet; returns how many of it are, and how many of
 * these have failed. */
static int choose(jobs_work *w, job_list *list, int *failed) {
    int done = 0;
    for (int i = w->options->part - 1; i < list->count; i += w->options->parts) {
        done += list->jobs[i].done;
        *failed += list->jobs[i].failed;
        if (!list->jobs[i].done)
            w->jobs[w->count++] = &list->jobs[i];
    }
    return done;
}

/* Opens the output behind what it has. Null after a message. */
static FILE *open_out(const jobs_options *options) {
    if (!options->out)
        return stdout;
    FILE *file = fopen(options->out, "ab");
    if (!file)
        fprintf(stderr, "thud-run: %s cannot be written\n", options->out);
    return file;
}

/* Runs what is left of the list. Returns the exit status. */
static int run_list(const jobs_options *options, job_list *list) {
    jobs_work w = {.options = options, .mutex = PTHREAD_MUTEX_INITIALIZER};
    w.jobs = malloc(((size_t)list->count + 1) * sizeof(job *));
    w.out = w.jobs ? open_out(options) : NULL;
    if (!w.out) {
        free(w.jobs);
        return 1;
    }
    int failed_before = 0, done = choose(&w, list, &failed_before);
    work_on_threads(&w, options->workers);
    bool closed = fflush(w.out) == 0 && (w.out == stdout || fclose(w.out) == 0);
    if (w.broken || !closed)
        fprintf(stderr, "thud-run: results cannot be written\n");
    fprintf(stderr, "%sthud-run: %d jobs run, %d of them failed; %d had results",
            isatty(STDERR_FILENO) ? "\r" : "", w.finished, w.failed, done);
    fprintf(stderr, failed_before > 0 ? ", %d of these a failure\n" : "\n", failed_before);
    free(w.jobs);
    return w.broken || !closed || w.failed + failed_before > 0 ? 1 : 0;
}

/* Whether the output may be written: it is empty, or is to be continued. False after a message. */
static bool check_out(const jobs_options *options, job_list *list) {
    if (!options->out)
        return true;
    if (options->resume)
        return jobs_resume(options->out, list);
    bool missing = false;
    size_t length = 0;
    char *text = jobs_read_text(options->out, &length, &missing);
    bool read = text || missing;
    free(text);
    if (read && length > 0)
        fprintf(stderr, "thud-run: %s has something in it; --resume continues it\n", options->out);
    return read && length == 0;
}

int jobs_run(const jobs_options *options) {
    job_list list = {0};
    int status = 2;
    if (jobs_read(options->file, &list) && check_out(options, &list))
        status = run_list(options, &list);
    jobs_free(&list);
    return status;
}
