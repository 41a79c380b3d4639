/* model.h: a scene as the oracle sees it: rigid bodies with masses, and solid shapes in place. */
#ifndef THUD_ORACLE_MODEL_H
#define THUD_ORACLE_MODEL_H

#include "depth.h"
#include "scene.h"
#include "tied_pairs.h"

/* Of a body's origin. */
typedef struct model_pose {
    double x, y, cosine, sine;
} model_pose;

typedef struct model_body {
    bool dynamic;
    double mass, inertia;                 /* about the centre of mass; 0 unless dynamic */
    double inverse_mass, inverse_inertia; /* 0 for what does not give way */
    double center_x, center_y;            /* of mass, in the body's frame */
} model_body;

/* Sensors are left out. */
typedef struct model_shape {
    const scene_shape *source;
    int body;
    bool ground;       /* terrain: `line`; else `solid` */
    depth_shape solid; /* in place since model_place; its centre is NaN where the body is lost */
    depth_ground line; /* stands still */
    double reach;      /* m, radius of the circle around the centre that holds the solid */
    double size;       /* m: diameter, or shorter side; infinite for what is not dynamic */
} model_shape;

typedef struct model {
    const scene *scene;
    model_body *bodies;
    model_shape *shapes;
    scene_point *points; /* of the lines */
    tied_pairs tied;
    int shape_count;
} model;

/* False, and nothing to free, if memory runs out. */
bool model_init(model *m, const scene *s);
void model_free(model *m);

/* Puts the shapes of a body where its origin is. */
void model_place(model *m, int body, model_pose pose);

/* Whether two shapes can ever push each other. */
bool model_may_collide(const model *m, const model_shape *a, const model_shape *b);

#endif
