/* shape.h: what other stages need of shapes: checks of defs and sizes, placing (proxies and fat
 * bounds), and terrain lines. */
#ifndef TD_SHAPE_H
#define TD_SHAPE_H

#include "base/reason.h"
#include "state/world.h"

/* Whether a shape of a body of that kind may have this radius or half extent (caller's unit). */
static inline bool td_shape_size_valid(const thud_world *w, int body_kind, float size) {
    float s = size / w->length_scale,
          max = body_kind == THUD_BODY_STATIC ? THUD_STATIC_SIZE_MAX : THUD_SIZE_MAX;
    return s >= THUD_SIZE_MIN && s <= max;
}

/* The reason why the def is refused, in `why` or a literal; null where it is valid. */
const char *td_shape_def_error(const thud_world *w, const thud_shape_def *def, td_reason *why);

/* Whether a radius or half extent is in range for a body of that kind, and whether an offset from
 * the body's origin is; the reason is in *why where not. */
bool td_size_in(const thud_world *w, td_reason *why, const char *name, int body_kind, float size);
bool td_offset_in(const thud_world *w, td_reason *why, const char *name, thud_vec2 offset);

/* Makes room for `count` more shapes. False when memory is short. */
bool td_shape_reserve(thud_world *w, int count);

/* Computes what follows from the body's centre of mass and the shape's size: the shape's arm, and
 * its proxy's extents and margin. To be called after td_body_weigh. */
void td_shape_settle(thud_world *w, int shape);

/* Computes a shape's place from its body's pose. Where its tight bounds have left the fat ones, it
 * gets new fat bounds, and goes onto the moved list. Terrain has no bounds, and always goes there.
 */
void td_shape_place(thud_world *w, int shape);

/* The proxy that td_shape_settle and td_shape_place would give the shape, but with tight bounds as
 * `fat`. Changes nothing. */
td_shape_proxy td_shape_placed(const thud_world *w, int shape);

/* Extends the fat bounds over the motion (dx, dy), caller's unit, that is expected in the next
 * step. */
void td_shape_expect(thud_world *w, int shape, float dx, float dy);

/* Bounds of a shape that is placed relative to `origin`, extended by `slack` (caller's unit) on
 * each side. */
td_bounds td_placed_bounds(const thud_world *w, const thud_geometry *placed, td_position origin,
                           double slack);

/* td_thickness is the least width of the shape over all directions, length; td_half_thickness is
 * half of it. */
TD_INLINE_SMALL float td_half_thickness(const td_shape *shape) {
    return (float)td_kind_half_thickness(shape->kind, (double)shape->half_x, (double)shape->half_y);
}

static inline float td_thickness(const td_shape *shape) {
    return 2.0f * td_half_thickness(shape);
}

/* The least thickness of all shapes but terrain, which is solid below; infinite where there is
 * none. */
float td_thinnest(thud_world *w);

/* Puts a shape onto the list `moved`, unless its mark (TD_MARK_MOVED) says that it is on one, and
 * stores its present fat bounds as those of the last broadphase. */
void td_shape_mark_moved_in(thud_world *w, td_array *moved, int shape);
/* The same for the world's moved list; also makes the awake proxy set out of date. */
void td_shape_mark_moved(thud_world *w, int shape);

/* A shape in its place, relative to `origin`; of a terrain only the place of its origin is set. */
thud_geometry td_shape_instance(const thud_world *w, int shape, td_position origin);
/* td_shape_instance with the place of another proxy of the shape, such as that of a preview
 * (preview.h). */
thud_geometry td_shape_instance_of(const thud_world *w, int shape, const td_shape_proxy *proxy,
                                   td_position origin);

/* A shape that moves within a step, for sweeps of continuous collision detection. */
typedef struct td_swept {
    td_position start; /* origin of `placed` and `core` */
    thud_geometry placed;
    thud_geometry core; /* the part that is swept, without rotation, where `placed` overlaps
                                 at the start */
    double shrink; /* length by which the half extents of `placed` are smaller than the shape's */
    thud_motion motion;
    td_bounds bounds; /* of the whole motion */
    bool far;         /* the motion is too long for bounds: ignore them */
} td_swept;

/* sweep_veto.c: whether rules or the prologue refuse the contact of a swept shape with a static
 * one, so that the shape passes through it. A world has it in sweep_is_vetoed. */
bool td_sweep_is_vetoed(thud_world *w, const td_swept *swept, int shape, int other, double time);

/* The result of a sweep. */
typedef struct td_swept_hit {
    bool inside; /* `placed` overlapped at the start: the rest is of the core */
    bool hit;
    double time; /* time of impact, as a share of the motion in [0, 1]; 1 without a hit */
} td_swept_hit;

/* Operations on terrain lines, which a world gets with its first line (kinds.h), so that a program
 * without terrain does not link them. `line` is the index of the line's shape; shape instances are
 * relative to its origin. The functions are described in broadphase/ground.c. */
typedef struct td_ground_ops {
    bool (*overlap)(const thud_world *w, int line, const thud_geometry *shape);
    void (*time_of_impact)(const thud_world *w, int line, const thud_geometry *shape,
                           thud_motion motion, bool *hit, double *time);
    /* The point of the line above or below the shape's centre, in the form of a pair of closest
     * points. */
    thud_closest (*below)(const thud_world *w, int line, const thud_geometry *shape);
    /* Whether the bounds of the sweep reach down to any segment; those of most falling bodies do
     * not. */
    bool (*near_sweep)(const thud_world *w, int line, const td_swept *swept);
    void (*sweep)(const thud_world *w, int line, const td_swept *swept, td_swept_hit *hit);
    /* Whether the fat bounds of a shape of the world reach down to one segment. */
    bool (*reaches)(const thud_world *w, int line, int shape, int segment);
    /* Calls `visit` for each segment that the fat bounds of the shape reach down to. Stops at the
     * first that returns false, and returns false itself. */
    bool (*each)(thud_world *w, int line, int shape,
                 bool (*visit)(thud_world *w, int shape, int line, int segment));
    bool (*add_pairs)(thud_world *w); /* broadphase/pairs.h */
    /* Called for a body that is terrain or touches it. An edit has moved the body: `restart` ends
     * the contacts of its own lines, `renew` has its manifolds with lines computed anew. An edit of
     * a line has removed segments: `drop_removed` ends the body's contacts with these. */
    void (*restart)(thud_world *w, td_body_index body);
    void (*renew)(thud_world *w, td_body_index body);
    void (*drop_removed)(thud_world *w, td_body_index body);
} td_ground_ops;

/* broadphase/ground.c */
extern const td_ground_ops td_ground;

/* A view of a terrain shape's line, relative to its body's origin. */
thud_terrain td_terrain_view(const thud_world *w, int shape);

/* Whether the whole line is below the bounds, which lie near near_place: a quick test, true for
 * most falling bodies. */
bool td_terrain_below(const thud_world *w, int terrain_shape, td_position near_place,
                      const td_bounds *bounds);

/* The segments, first .. last, of which x overlaps that of the bounds. */
void td_terrain_segments_of(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                            td_position near_place, const td_bounds *bounds, int *first, int *last);
/* Whether the bounds reach down to a segment: overlap it in x, and are not above both its ends. A
 * contact with the segment exists exactly while they do. */
bool td_terrain_reaches(const thud_world *w, int terrain_shape, const thud_terrain *terrain,
                        td_position near_place, const td_bounds *bounds, int segment);

#endif
