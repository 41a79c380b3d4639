/* pool.h: a thread pool as a thud_world_def.job_system, for programs that have no job system of
 * their own. */
#ifndef THUD_DEMO_POOL_H
#define THUD_DEMO_POOL_H

#include <thud/thud.h>

typedef struct pool pool;

/* Creates a pool of `workers` in 2 .. THUD_WORKERS_MAX, which include the calling thread. Returns
 * null if that number is out of range, or if threads or memory run out. The pool must outlive the
 * worlds that use it. Several worlds may use it, but not at the same time. */
pool *pool_create(int workers);
void pool_destroy(pool *p); /* `p` may be null */

thud_job_system pool_job_system(pool *p); /* for a null `p`: a job system without workers, so that a
                                             world steps on the calling thread alone */

#endif
