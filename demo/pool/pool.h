/* pool.h: threads for thud_world_def.job_system, for programs that have no job system of their own.
 */
#ifndef THUD_DEMO_POOL_H
#define THUD_DEMO_POOL_H

#include <thud/thud.h>

typedef struct pool pool;

/* `workers` in 2 .. THUD_WORKERS_MAX, the calling thread among them. Null when threads or memory
 * run out. Must outlive the worlds that use it; worlds may take turns, but not run at once. */
pool *pool_create(int workers);
void pool_destroy(pool *p); /* null is fine */

thud_job_system pool_job_system(pool *p); /* of null: the calling thread alone */

#endif
