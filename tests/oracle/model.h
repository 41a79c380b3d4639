/* model.h: a scene in the oracle's terms: rigid bodies with masses, and shapes at their places. */
#ifndef THUD_ORACLE_MODEL_H
#define THUD_ORACLE_MODEL_H

#include "depth.h"
#include "scene.h"
#include "tied_pairs.h"

/* The pose of a body's origin. */
typedef struct model_pose {
    double x, y, cosine, sine;
} model_pose;

typedef struct model_body {
    bool dynamic;
    double mass, inertia;                 /* kg, and kg m^2 about the centre of mass; 0 unless
                                             dynamic */
    double inverse_mass, inverse_inertia; /* 0 for bodies that impulses do not move */
    double center_x, center_y;            /* centre of mass in the body's frame */
} model_body;

/* Sensors are not in the list. */
typedef struct model_shape {
    const scene_shape *source;
    int body;
    bool ground;       /* terrain, with `line`; otherwise `solid` */
    depth_shape solid; /* placed by model_place; its centre is NaN if the body is lost */
    depth_ground line; /* static */
    double reach;      /* m, radius of the bounding circle of `solid` about its centre */
    double size;       /* m: diameter of a circle, shorter side of a box; infinite unless dynamic */
} model_shape;

typedef struct model {
    const scene *scene;
    model_body *bodies;
    model_shape *shapes;
    scene_point *points; /* vertices of the lines */
    tied_pairs tied;
    int shape_count;
} model;

/* False, with nothing to free, if memory runs out. */
bool model_init(model *m, const scene *s);
void model_free(model *m);

/* Places the shapes of a body at its pose. */
void model_place(model *m, int body, model_pose pose);

/* Whether two shapes can collide, by bodies, filters and joints. */
bool model_may_collide(const model *m, const model_shape *a, const model_shape *b);

#endif
