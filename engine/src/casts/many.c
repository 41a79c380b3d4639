/* many.c: many casts in one call, divided among the workers of the job system in chunks. A worker
 * only reads the world, and writes to the hits of its chunks and to a candidate array of its own.
 * So the result does not depend on the number of workers. */
#include "casts/walk.h"

#include "state/handles.h"
#include "state/jobs.h"
#include "thud/thud_casts.h"

enum {
    /* Workers are used if there are at least this many casts. Chosen: with fewer the calling thread
     * finishes before another thread has woken up; thud_casts.h promises 64. */
    SHARED_CASTS_MIN = 64,
    /* Casts that a worker takes at once. Chosen; not tuned: four workers share the smallest batch
       evenly. */
    CHUNK = 16
};

typedef struct batch batch;

/* One call. */
struct batch {
    const thud_world *world;
    td_path (*path_of)(const batch *b, int i); /* the path of cast i */
    const void *casts;                         /* thud_ray or thud_shape_cast */
    thud_ray_hit *hits;
    int count;             /* of casts and hits */
    int *rooms, room_size; /* candidate arrays, one after the other; ints in each */
    td_job job;
};

/* A batch with the memory of one worker. */
typedef struct batch_worker {
    const batch *b;
    int *room; /* its candidate array */
} batch_worker;

static td_path ray_path(const batch *b, int i) {
    const thud_ray *ray = (const thud_ray *)b->casts + i;
    return (td_path){td_point_meets, ray->origin, td_place_from(b->world, ray->origin),
                     ray->dx,        ray->dy,     NULL,
                     ray->filter,    false};
}

static td_path shape_path(const batch *b, int i) {
    const thud_shape_cast *cast = (const thud_shape_cast *)b->casts + i;
    return (td_path){td_shape_meets, cast->center, td_place_from(b->world, cast->center),
                     cast->dx,       cast->dy,     &cast->shape,
                     cast->filter,   false};
}

/* Makes CHUNK casts. */
static void cast_chunk(void *work, int chunk) {
    const batch_worker *h = work;
    const batch *b = h->b;
    int end = td_min_int((chunk + 1) * CHUNK, b->count);
    for (int i = chunk * CHUNK; i < end; i++) {
        td_path way = b->path_of(b, i);
        td_nearest k = {&b->hits[i], 1, 0};
        td_walk walk = td_walk_begin(b->world, &way, h->room, b->room_size);
        td_walk_next(&walk, 2.0, &k);
        if (k.count == 0) {
            thud_pos end_of_way = {way.origin.x + way.dx, way.origin.y + way.dy};
            b->hits[i] = (thud_ray_hit){.point = end_of_way, .fraction = 1.0};
        }
    }
}

/* The task of one worker: takes chunk after chunk until none is left. */
static void cast_chunks(void *argument) {
    batch *b = argument;
    td_worker worker = td_worker_arrive(&b->job);
    batch_worker h = {b, b->rooms + (size_t)worker.index * (size_t)b->room_size};
    td_worker_walk(&worker, (b->count + CHUNK - 1) / CHUNK, cast_chunk, &h);
}

/* Makes all casts, which have been checked. */
static thud_result cast_all(thud_world *w, batch *b) {
    int workers = w->def.job_system.workers;
    bool shared = workers > 1 && b->count >= SHARED_CASTS_MIN && !w->locked;
    td_job_begin(&b->job, shared ? workers : 1);
    b->room_size = td_walk_room(w);
    if (!td_query_prepare(w) ||
        !td_array_reserve(&w->memory, &w->scratch.found_shapes, b->room_size * b->job.workers)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "casts: out of memory");
    }
    b->rooms = w->scratch.found_shapes.data;
    td_job_run(w, &b->job, cast_chunks, b);
    return THUD_OK;
}

/* ---- the API ---- */

/* Refuses a negative count, and null lists with a count. */
static thud_result check_lists(const batch *b) {
    if (b->count < 0) {
        return td_refuse(b->world, THUD_ERROR_INVALID, "casts: their count is negative");
    }
    return b->count == 0 || (b->casts && b->hits)
               ? THUD_OK
               : td_refuse(b->world, THUD_ERROR_NULL, "casts: there are none, or no room for hits");
}

thud_result thud_world_cast_rays(thud_world *w, const thud_ray *rays, int count,
                                 thud_ray_hit *out_hits) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    batch b = {w, ray_path, rays, out_hits, .count = count};
    thud_result result = check_lists(&b);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        td_path way = {.origin = rays[i].origin,
                       .dx = rays[i].dx,
                       .dy = rays[i].dy,
                       .filter = rays[i].filter};
        result = td_path_check(w, &way);
    }
    return result != THUD_OK ? result : cast_all(w, &b);
}

thud_result thud_world_cast_shapes(thud_world *w, const thud_shape_cast *casts, int count,
                                   thud_ray_hit *out_hits) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w) {
        return THUD_ERROR_NULL;
    }
    batch b = {w, shape_path, casts, out_hits, .count = count};
    thud_result result = check_lists(&b);
    for (int i = 0; i < count && result == THUD_OK; i++) {
        td_path way = {.origin = casts[i].center,
                       .dx = casts[i].dx,
                       .dy = casts[i].dy,
                       .filter = casts[i].filter};
        result = td_path_check(w, &way);
        if (result == THUD_OK && td_query_check(w, way.origin, &casts[i].shape) != THUD_OK) {
            result = td_refuse(w, THUD_ERROR_INVALID, "cast shapes: a shape is invalid");
        }
    }
    return result != THUD_OK ? result : cast_all(w, &b);
}
