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

/* A shape on its way from `start`, which `placed` is relative to. */
typedef struct td_swept {
    td_position start;
    thud_shape_instance placed;
    thud_shape_instance core; /* goes alone, and does not turn, where `placed` overlaps already */
    thud_motion motion;
    td_bounds bounds; /* of the whole way, about `start`; where it is too long for them: */
    bool far;         /* it is looked at whatever they say */
} td_swept;

/* What a swept shape meets. */
typedef struct td_swept_hit {
    bool inside; /* the core met it */
    bool hit;
    double time; /* part of the motion; 1 where it met nothing */
} td_swept_hit;

/* What is asked of a line, with its shape in `line` and other shapes relative to its origin;
 * plugged into a world with the first line, see kinds.h, so that no other program links what
 * answers. */
typedef struct td_ground_ops {
    bool (*overlap)(const thud_world *w, int line, const thud_shape_instance *shape);
    void (*time_of_impact)(const thud_world *w, int line, const thud_shape_instance *shape,
                           thud_motion motion, bool *hit, double *time);
    /* Where a shape at the ground stands, by the point of the line below its middle. */
    thud_closest (*below)(const thud_world *w, int line, const thud_shape_instance *shape);
    /* Whether the bounds of the sweep come down to any segment at all; most falling bodies' do not.
     */
    bool (*near_sweep)(const thud_world *w, int line, const td_swept *swept);
    void (*sweep)(const thud_world *w, int line, const td_swept *swept, td_swept_hit *hit);
    /* Whether the fat bounds of a shape reach down to one segment. */
    bool (*reaches)(const thud_world *w, int line, int shape, int segment);
    /* Visits each segment that they reach down to, until one says false, which it then returns. */
    bool (*each)(thud_world *w, int line, int shape,
                 bool (*visit)(thud_world *w, int shape, int line, int segment));
    bool (*add_pairs)(thud_world *w); /* broadphase/pairs.h */
} td_ground_ops;

/* The table, of ground.c. */
extern const td_ground_ops td_ground;

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
