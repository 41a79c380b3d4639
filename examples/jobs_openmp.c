/* jobs_openmp.c: the threads of OpenMP as the job system of a world. The steps of a large pyramid
 * end with the same bits as on one thread. */
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_make.h>
#include <thud/thud_snapshot.h>

/* A thud_parallel_fn. OpenMP keeps its threads between two calls, and the calling thread is one of
 * them. If OpenMP gives fewer threads than asked for, the loop still calls the task as often. */
static void run_by_openmp(thud_task_fn *task, void *argument, int workers, void *context) {
    (void)context;
#pragma omp parallel for schedule(static, 1) num_threads(workers)
    for (int i = 0; i < workers; i++)
        task(argument);
}

static unsigned long long hash_with(thud_job_system jobs) {
    enum { ROWS = 30 };
    thud_world_def def = thud_default_world_def();
    def.job_system = jobs;
    thud_world *world;
    if (thud_world_create(&def, &world) != THUD_OK)
        return 0;
    thud_body_options box = {.kind = THUD_BODY_DYNAMIC};
    thud_body_make(world, thud_aabb_at(0, -1, 60, 1), NULL);
    for (int row = 0; row < ROWS; row++)
        for (int i = 0; i < ROWS - row; i++)
            thud_body_make(world, thud_obb_at(i - 0.5 * (ROWS - row), 0.5 + row, 0.45, 0.5, 0),
                           &box);
    for (int i = 0; i < 60; i++)
        thud_world_step(world);
    unsigned long long hash = thud_hash_of(world);
    thud_world_destroy(world);
    return hash;
}

int main(void) {
    unsigned long long alone = hash_with((thud_job_system){0});
    for (int workers = 2; workers <= 4; workers++)
        if (hash_with((thud_job_system){.run = run_by_openmp,
                                        .workers = workers,
                                        .stages = &thud_shared_stages_all}) != alone)
            return 1;
    puts("2 to 4 workers of OpenMP: the same bits as one");
}
