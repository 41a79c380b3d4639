/* recorded_queries.c: the functions of thud_recorded.h for queries: each makes its call, and
 * records it with what it found, if queries are recorded. */
#include "recording/recorder.h"

#include "thud/thud_all.h"

/* What a query with a callback has found so far, and the caller's own callback. */
typedef struct query_found {
    union {
        thud_overlap_fn *overlap;
        thud_cast_fn *cast;
    } fn;
    void *context;
    int count;
    thud_ray_hit hits[THUD_RECORDED_FOUND_MAX];
} query_found;

static void add_hit(query_found *f, thud_ray_hit hit) {
    if (f->count < THUD_RECORDED_FOUND_MAX) {
        f->hits[f->count++] = hit;
    }
}

/* A thud_overlap_fn. */
static bool find_overlap(thud_shape_id shape, void *context) {
    query_found *f = context;
    add_hit(f, (thud_ray_hit){.shape = shape});
    return f->fn.overlap(shape, f->context);
}

/* A thud_cast_fn. */
static double find_hit(const thud_ray_hit *hit, void *context) {
    query_found *f = context;
    add_hit(f, *hit);
    return f->fn.cast(hit, f->context);
}

/* ---- the first hit ---- */

THUD_API thud_result thud_recorded_world_cast_ray(thud_world *world, const thud_ray *ray,
                                                  bool *out_hit, thud_ray_hit *out) {
    thud_result result = thud_world_cast_ray(world, ray, out_hit, out);
    if (result == THUD_OK) {
        const void *const args[] = {&ray, &out_hit, &out};
        td_record_query(world, TD_CALL_WORLD_CAST_RAY, args, out, *out_hit);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_cast_shape(thud_world *world, const thud_shape_cast *cast,
                                                    bool *out_hit, thud_ray_hit *out) {
    thud_result result = thud_world_cast_shape(world, cast, out_hit, out);
    if (result == THUD_OK) {
        const void *const args[] = {&cast, &out_hit, &out};
        td_record_query(world, TD_CALL_WORLD_CAST_SHAPE, args, out, *out_hit);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_closest(thud_world *world, thud_pos point,
                                                 double max_distance,
                                                 const thud_query_filter *filter, bool *out_found,
                                                 thud_closest_hit *out) {
    thud_result result = thud_world_closest(world, point, max_distance, filter, out_found, out);
    if (result == THUD_OK) {
        const void *const args[] = {&point, &max_distance, &filter, &out_found, &out};
        thud_ray_hit hit = {.shape = {0, 0}};
        if (*out_found) {
            hit = (thud_ray_hit){.shape = out->shape, .point = out->point, .normal = out->normal};
        }
        td_record_query(world, TD_CALL_WORLD_CLOSEST, args, &hit, *out_found);
    }
    return result;
}

/* ---- all hits ---- */

THUD_API thud_result thud_recorded_world_cast_ray_all(thud_world *world, const thud_ray *ray,
                                                      thud_ray_hit *out, int capacity,
                                                      int *out_count) {
    thud_result result = thud_world_cast_ray_all(world, ray, out, capacity, out_count);
    if (result == THUD_OK) {
        const void *const args[] = {&ray, &out, &capacity, &out_count};
        td_record_query(world, TD_CALL_WORLD_CAST_RAY_ALL, args, out,
                        td_min_int(*out_count, capacity));
    }
    return result;
}

THUD_API thud_result thud_recorded_world_cast_shape_all(thud_world *world,
                                                        const thud_shape_cast *cast,
                                                        thud_ray_hit *out, int capacity,
                                                        int *out_count) {
    thud_result result = thud_world_cast_shape_all(world, cast, out, capacity, out_count);
    if (result == THUD_OK) {
        const void *const args[] = {&cast, &out, &capacity, &out_count};
        td_record_query(world, TD_CALL_WORLD_CAST_SHAPE_ALL, args, out,
                        td_min_int(*out_count, capacity));
    }
    return result;
}

/* ---- many at once ---- */

THUD_API thud_result thud_recorded_world_cast_rays(thud_world *world, const thud_ray *rays,
                                                   int count, thud_ray_hit *out_hits) {
    thud_result result = thud_world_cast_rays(world, rays, count, out_hits);
    if (result == THUD_OK) {
        const void *const args[] = {&rays, &count, &out_hits};
        td_record_query(world, TD_CALL_WORLD_CAST_RAYS, args, out_hits, count);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_cast_shapes(thud_world *world,
                                                     const thud_shape_cast *casts, int count,
                                                     thud_ray_hit *out_hits) {
    thud_result result = thud_world_cast_shapes(world, casts, count, out_hits);
    if (result == THUD_OK) {
        const void *const args[] = {&casts, &count, &out_hits};
        td_record_query(world, TD_CALL_WORLD_CAST_SHAPES, args, out_hits, count);
    }
    return result;
}

/* ---- with a callback ---- */

THUD_API thud_result thud_recorded_world_cast_ray_each(thud_world *world, const thud_ray *ray,
                                                       thud_cast_fn *fn, void *context) {
    if (!fn || !td_records_queries(world)) {
        return thud_world_cast_ray_each(world, ray, fn, context);
    }
    query_found f = {.fn.cast = fn, .context = context};
    thud_result result = thud_world_cast_ray_each(world, ray, find_hit, &f);
    if (result == THUD_OK) {
        const void *const args[] = {&ray, &fn, &context};
        td_record_query(world, TD_CALL_WORLD_CAST_RAY_EACH, args, f.hits, f.count);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_cast_shape_each(thud_world *world,
                                                         const thud_shape_cast *cast,
                                                         thud_cast_fn *fn, void *context) {
    if (!fn || !td_records_queries(world)) {
        return thud_world_cast_shape_each(world, cast, fn, context);
    }
    query_found f = {.fn.cast = fn, .context = context};
    thud_result result = thud_world_cast_shape_each(world, cast, find_hit, &f);
    if (result == THUD_OK) {
        const void *const args[] = {&cast, &fn, &context};
        td_record_query(world, TD_CALL_WORLD_CAST_SHAPE_EACH, args, f.hits, f.count);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_overlap_shape(thud_world *world, thud_pos center,
                                                       thud_geometry shape,
                                                       const thud_query_filter *filter,
                                                       thud_overlap_fn *fn, void *context) {
    if (!fn || !td_records_queries(world)) {
        return thud_world_overlap_shape(world, center, shape, filter, fn, context);
    }
    query_found f = {.fn.overlap = fn, .context = context};
    thud_result result = thud_world_overlap_shape(world, center, shape, filter, find_overlap, &f);
    if (result == THUD_OK) {
        const void *const args[] = {&center, &shape, &filter, &fn, &context};
        td_record_query(world, TD_CALL_WORLD_OVERLAP_SHAPE, args, f.hits, f.count);
    }
    return result;
}

THUD_API thud_result thud_recorded_world_overlap_aabb(thud_world *world, thud_pos lower,
                                                      thud_pos upper,
                                                      const thud_query_filter *filter,
                                                      thud_overlap_fn *fn, void *context) {
    if (!fn || !td_records_queries(world)) {
        return thud_world_overlap_aabb(world, lower, upper, filter, fn, context);
    }
    query_found f = {.fn.overlap = fn, .context = context};
    thud_result result = thud_world_overlap_aabb(world, lower, upper, filter, find_overlap, &f);
    if (result == THUD_OK) {
        const void *const args[] = {&lower, &upper, &filter, &fn, &context};
        td_record_query(world, TD_CALL_WORLD_OVERLAP_AABB, args, f.hits, f.count);
    }
    return result;
}
