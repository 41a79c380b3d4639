/* jobs.h: thud-run --jobs: runs the jobs of a file over all cores, a result a line.
 *
 * A job is one run of a scene: what to run, how, and what happens at which step. The file holds one
 * JSON object a line (NDJSON); a list or a range in a field stands for one job for each of its
 * values. Each job runs on one thread, in a world of its own, so that its result does not depend on
 * the others nor on the number of threads. */
#ifndef THUD_RUN_JOBS_H
#define THUD_RUN_JOBS_H

#include "options.h"
#include "outcome.h"
#include "scene.h"

/* Largest numbers of jobs of a file and of inputs of a job. Chosen: a job of the longest list takes
 * some hundred bytes. */
enum { JOBS_MAX = 1000000, JOB_INPUTS_MAX = 1000 };

/* The command line. */
typedef struct jobs_options {
    const char *file;
    const char *out; /* null: standard output */
    int workers;     /* threads, each of which runs one job at a time */
    int part, parts; /* runs the jobs part - 1, part - 1 + parts, ... of the list */
    bool resume;     /* jobs whose results stand in `out` are not run again */
    bool times;      /* results have the times of their runs */
} jobs_options;

typedef enum job_input_kind { JOB_PUSH, JOB_DROP_CIRCLE, JOB_DROP_BOX, JOB_EXPLODE } job_input_kind;

/* What happens to the world after `step` steps. */
typedef struct job_input {
    job_input_kind kind;
    long step;
    int body;                        /* push: index in scene.bodies */
    double x, y;                     /* where, m; push: the impulse, kg m/s */
    double vx, vy;                   /* drop: velocity, m/s */
    double size;                     /* drop: diameter or side, m */
    double radius, falloff, impulse; /* explode: as in thud_explosion */
} job_input;

typedef struct job {
    char *id;     /* unique in the file */
    char *text;   /* the job as compact JSON, without its id: it names the same run everywhere */
    char *source; /* run_options.source */
    run_options options;
    int seed;     /* 0: the scene as it is; else every dynamic body starts at another velocity */
    double shake; /* m/s: the most that the seed changes each component of it; negative: a hundredth
                     of a length scale a second */
    job_input *inputs;
    int input_count;
    int line;    /* of the file, from 1 on */
    bool done;   /* its result stands in the output file already */
    bool failed; /* it does, and says that the job failed */
} job;

/* All zero: empty. */
typedef struct job_list {
    job *jobs;
    int count, capacity;
} job_list;

/* Parses the arguments behind the program's name. False after a message. */
bool jobs_options_parse(int count, char **arguments, jobs_options *out);

/* Reads and checks all jobs of a file, and loads each scene once to see that it can be. False after
 * a message that names the line; the list is to be freed in any case. */
bool jobs_read(const char *path, job_list *list);
void jobs_free(job_list *list);

/* The jobs of the list in the order of their ids. The caller frees it; null if memory runs out. */
job **jobs_by_id(const job_list *list);
/* Where in that order the job with the id stands, or null. */
job **jobs_find(job **sorted, int count, char *id);

/* The text of a file with a 0 behind it, and its length in bytes. Null after a message, or without
 * one where the file does not exist and `missing` is not null, which is then set. The caller frees
 * it. */
char *jobs_read_text(const char *path, size_t *length, bool *missing);

struct cJSON;
/* Reads the list of a job's inputs. False after writing what is wrong to `why`, which has
 * RUN_FAILURE_MAX characters. */
bool job_inputs_read(const struct cJSON *json, job *j, char *why);
/* Whether the bodies that the job's inputs name exist and can be pushed. False as above. */
bool job_inputs_fit(const job *j, const scene *s, char *why);

/* Runs a job. False after writing why to `failure`, which has RUN_FAILURE_MAX characters. */
bool job_run(const job *j, run_outcome *out, double *error, char *failure);

/* Marks the jobs as done whose results stand in the file, and cuts off an unfinished last line.
 * False after a message: the file cannot be read or holds something else. */
bool jobs_resume(const char *path, job_list *list);
/* The result as one line of JSON with its end, for the caller to free by cJSON_free; `failure` is
 * null for a job that succeeded. Null if memory runs out. */
char *job_result(const job *j, const run_outcome *o, double error, const char *failure, bool times);

/* Runs the jobs of the file. Returns the exit status: 0 all have a result without failure, 1 some
 * failed or could not be written, 2 the file is wrong and nothing was run. */
int jobs_run(const jobs_options *options);

#endif
