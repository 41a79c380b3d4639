/* shape.h: placing shapes, and terrain as the world keeps it. */
#ifndef TD_SHAPE_H
#define TD_SHAPE_H

#include "base/reason.h"
#include "state/world.h"

/* Whether a shape of such a body may have this radius or half extent. */
static inline bool td_shape_size_valid(const thud_world *w, int body_kind, float size) {
    float s = size / w->unit,
          most = body_kind == THUD_STATIC ? THUD_STATIC_SIZE_MAX : THUD_SIZE_MAX;
    return s >= THUD_SIZE_MIN && s <= most;
}

/* Why there can be no such def; null where there can. */
const char *td_shape_def_error(const thud_world *w, const thud_shape_def *def, td_reason *why);

/* Whether a shape may be so large on a body of that kind, and so far from its body's origin. */
bool td_size_in(const thud_world *w, td_reason *why, const char *name, int body_kind, float size);
bool td_offset_in(const thud_world *w, td_reason *why, const char *name, thud_vec2 offset);

/* Room for so many more; false where memory is short. */
bool td_shape_reserve(thud_world *w, int count);

/* Recomputes offsets from the centre of mass; after td_body_weigh. */
void td_shape_settle(thud_world *w, int shape);

/* Puts one shape where its body's pose says, and its bounds onto the moved list when they leave the
 * fat ones. Terrain keeps its place and has no bounds. */
void td_shape_place(thud_world *w, int shape);

/* The proxy that td_shape_settle and td_shape_place would give it, with tight bounds for fat ones;
 * nothing changes. */
td_shape_proxy td_shape_placed(const thud_world *w, int shape);

/* Makes the fat bounds reach as far as the shape is expected to move in the next step. */
void td_shape_expect(thud_world *w, int shape, float dx, float dy);

/* Bounds of a shape placed relative to `origin`, and `slack` more on each side. */
td_bounds td_placed_bounds(const thud_world *w, const thud_shape_instance *placed,
                           td_position origin, double slack);

TD_INLINE_SMALL float td_half_thickness(const td_shape *shape) {
    return (float)td_kind_half_thickness(shape->kind, (double)shape->half_x, (double)shape->half_y);
}

static inline float td_thickness(const td_shape *shape) {
    return 2.0f * td_half_thickness(shape);
}

/* The thinnest shape's thickness; infinite where there is none. Terrain is solid below. */
float td_thinnest(thud_world *w);

/* Puts a shape onto the moved list; its bounds of before go to `was`. */
void td_shape_mark_moved(thud_world *w, int shape);

/* A shape in its place, relative to `origin`; of a terrain, only where its origin stands. */
thud_shape_instance td_shape_instance(const thud_world *w, int shape, td_position origin);
/* The same where a proxy of it says. */
thud_shape_instance td_shape_instance_of(const thud_world *w, int shape,
                                         const td_shape_proxy *proxy, td_position origin);

/* What is asked of a line; plugged into a world with the first one, see kinds.h. Those below by
 * their names as well, for files that only a program with lines links. */
typedef struct td_ground_ops {
    bool (*overlap)(const thud_terrain *terrain, const thud_shape_instance *shape);
    thud_result (*time_of_impact)(const thud_terrain *terrain, const thud_shape_instance *shape,
                                  thud_motion motion, double target, bool *hit, double *time);
    thud_result (*sample_at)(const thud_terrain *terrain, double x, thud_terrain_sample *out);
    thud_terrain (*view)(const thud_world *w, int shape);
    bool (*below)(const thud_world *w, int terrain_shape, td_position near_place,
                  const td_bounds *bounds);
    void (*segments_of)(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                        td_position near_place, const td_bounds *bounds, int *first, int *last);
    bool (*reaches)(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                    td_position near_place, const td_bounds *bounds, int segment);
    bool (*add_pairs)(thud_world *w); /* broadphase/pairs.h */
} td_ground_ops;

/* A view of a terrain shape's line, relative to its body's origin. */
thud_terrain td_terrain_view(const thud_world *w, int shape);

/* Whether bounds near a place stand above the whole line; most of what falls does for long. */
bool td_terrain_below(const thud_world *w, int terrain_shape, td_position near_place,
                      const td_bounds *bounds);

/* The segments in the column of bounds that lie near a place. */
void td_terrain_segments_of(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                            td_position near_place, const td_bounds *bounds, int *first, int *last);
/* Whether the bounds reach down to one segment: the pair exists exactly while they do. */
bool td_terrain_reaches(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                        td_position near_place, const td_bounds *bounds, int segment);

#endif
