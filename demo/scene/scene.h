/* scene.h: a scene as a plain description, known to no engine.
 *
 * The built-in scenes (scenes.h) and the levels (../level) fill one; build_thud.h turns it into a
 * thud world, and the comparison with Box2D builds the very same one there. Only doubles here:
 * whoever builds a world rounds to float once, so that every builder starts from equal bits.
 *
 * Units are metres, seconds, kilograms and radians, y up, angles counter-clockwise. The order of
 * bodies, and of the shapes of a body, is the order of creation. Bodies lie on a grid of 2^-16
 * (scene_grid), so that a shift by whole numbers up to 10^7 is exact in double precision. */
#ifndef THUD_DEMO_SCENE_H
#define THUD_DEMO_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum scene_body_kind {
    SCENE_STATIC = 0,
    SCENE_KINEMATIC, /* a motor: turns and travels at its set velocity for ever */
    SCENE_DYNAMIC
} scene_body_kind;

typedef enum scene_shape_kind {
    SCENE_CIRCLE = 0,
    SCENE_AABB, /* never rotates: only on bodies with fixed_rotation (or static) and angle 0 */
    SCENE_OBB,
    SCENE_TERRAIN_FLAT,     /* endless line through the body's origin: height = slope * x */
    SCENE_TERRAIN_UNIFORM,  /* points at equal distances `spacing`, from the first one's x on */
    SCENE_TERRAIN_IRREGULAR /* points with strictly increasing x */
} scene_shape_kind;

/* How a body's collisions are found, see thud_detection.h. */
typedef enum scene_detection {
    SCENE_AS_WORLD = 0,
    SCENE_OVERLAP,
    SCENE_CONTINUOUS,
    SCENE_BISECT,
    SCENE_SWEPT
} scene_detection;

/* What a viewer shows over the bodies from the start. */
enum scene_show {
    SCENE_SHOW_CELLS = 1 << 0,
    SCENE_SHOW_AXES = 1 << 1,
    SCENE_SHOW_MOTIONS = 1 << 2
};

/* All terrain is one-sided: solid below. Its points are relative to the body's origin. */
typedef struct scene_point {
    double x, y;
} scene_point;

typedef struct scene_material {
    double density;     /* kg/m^2; default 1 */
    double friction;    /* default 0.6 */
    double restitution; /* [0, 1]; default 0 */
} scene_material;

typedef struct scene_shape {
    scene_shape_kind kind;
    double x, y;                  /* offset in the body's frame */
    double hx, hy;                /* half extents; a circle's radius is hx, its hy is 0 */
    double angle;                 /* OBB: in the body's frame */
    double slope;                 /* flat terrain */
    double spacing;               /* uniform terrain */
    int first_point, point_count; /* uniform and irregular terrain: in scene.points */
    scene_material material;
    bool sensor;
    uint32_t category, mask; /* default 1, all */
    int32_t group;           /* default 0: none */
} scene_shape;

typedef struct scene_body {
    scene_body_kind kind;
    double x, y, angle;
    double vx, vy, angular_velocity;
    double gravity_scale; /* default 1 */
    double linear_damping, angular_damping;
    bool fixed_rotation;
    bool may_sleep; /* default true */
    scene_detection detection;
    int look;                     /* the viewer's colour of that number, from 1 on; 0: by chance */
    uint32_t id;                  /* of the object in a level file; 0 in built-in scenes */
    int first_shape, shape_count; /* in scene.shapes */
} scene_body;

/* As thud_joint.h has them. */
typedef enum scene_joint_kind {
    SCENE_DISTANCE = 0,
    SCENE_HINGE,
    SCENE_SLIDER,
    SCENE_WELD,
    SCENE_WHEEL,
    SCENE_TARGET,
    SCENE_FILTER,
    SCENE_GEAR
} scene_joint_kind;

enum { SCENE_ALONG, SCENE_ACROSS, SCENE_TURN, SCENE_DIRECTIONS };

typedef struct scene_drive {
    bool limited;
    double lower, upper;
    double frequency, damping, target, spring_force; /* defaults 0, 0.7, 0, 1e30 */
    double motor_speed, motor_force;
} scene_drive;

typedef struct scene_joint {
    scene_joint_kind kind;
    int body[2];                 /* indices of scene.bodies; of a gear: of scene.joints */
    double x[2], y[2], angle[2]; /* frames, from the bodies' origins and in their frames */
    scene_drive drive[SCENE_DIRECTIONS];
    double length;                    /* of a distance */
    double ratio;                     /* of a gear; default 1 */
    bool collide_connected;           /* default false; of a gear true */
    double break_force, break_torque; /* default 1e30: never */
} scene_joint;

/* An explosion as a step begins, see thud_fields.h. */
typedef struct scene_blast {
    int step; /* after so many others, from 0 on */
    double x, y, radius, falloff, impulse;
} scene_blast;

enum { SCENE_BLASTS_MAX = 4 };

typedef enum scene_meeting { SCENE_COLLIDE = 0, SCENE_IGNORE, SCENE_ONE_WAY } scene_meeting;

/* What two kinds of shapes are to each other, see thud_rules.h; of several for the same
 * bits, the last one whose step has come; two whose bits differ share no pair. Not-a-number: as the
 * shapes have it. */
typedef struct scene_rule {
    int step;               /* from which on; 0: from the beginning */
    uint32_t first, second; /* bits as in scene_shape.category */
    scene_meeting meeting;  /* one-way: from below */
    double friction, restitution;
    double surface_speed; /* m/s, clockwise */
    double most_impulse;  /* kg m/s in a step; default infinite */
} scene_rule;

enum { SCENE_RULES_MAX = 16 };

/* What acts on everything that is awake before each step, see act_thud.h. Zero: nothing does. */
typedef struct scene_fields {
    double water_density; /* kg/m^2; 0: no water */
    double water_level;
    double water_drag;  /* 1/s, of motion and of spin */
    double air_density; /* kg/m^2; 0: no wind */
    double wind;        /* m/s, to the right; gusts make a fifth of it, or nearly twice as much */
    double wind_origin; /* x at which gusts are on time; farther on in the wind they are later */
    double air_drag, air_lift;
    scene_blast blasts[SCENE_BLASTS_MAX];
    int blast_count;
    scene_rule rules[SCENE_RULES_MAX]; /* steps ascend */
    int rule_count;
    uint32_t breaks, pieces; /* kinds: what a rule's most_impulse breaks, and into what; 0: none */
} scene_fields;

typedef struct scene {
    const char *name;  /* the registry's, or the level's file name without folder and suffix */
    const char *title; /* for a menu */
    const char *about; /* one sentence: what to look at */
    double gravity_x, gravity_y; /* default 0, -10 */
    double length_scale;         /* of a typical body; default 1 */
    double camera_x, camera_y;   /* what to look at first ... */
    double camera_height;        /* ... and how many metres of it from top to bottom, */
    double camera_width;         /* and at least from left to right; default 0 */
    double spawn_x, spawn_y;     /* where a viewer drops new bodies */
    bool character;              /* played with one, which starts there */
    unsigned show;               /* scene_show */
    scene_fields fields;
    bool textured; /* the ground is drawn with a texture, see texture.h */
    int kinds;     /* so many, from 1 << 1 on, whose rules a viewer lets a user set */
    int sum_pairs; /* so many times two bodies, from the first on, are shown
with their Minkowski sum; each has one shape, no terrain */
    scene_body *bodies;
    scene_shape *shapes;
    scene_point *points;
    scene_joint *joints;
    int body_count, shape_count, point_count, joint_count;
    int body_capacity, shape_capacity, point_capacity, joint_capacity;
    scene_material material; /* given to every shape that is added from now on */
    bool failed;             /* memory ran out while filling: the scene is incomplete */
    scene_body spare_body;   /* what the helpers hand out once memory has run out */
    scene_shape spare_shape;
    scene_joint spare_joint;
    scene_rule spare_rule;
    char *owned_text; /* storage behind name, title and about of a level; else null */
} scene;

/* An empty scene with the defaults above. Every scene_init needs its scene_free. */
void scene_init(scene *s);
void scene_free(scene *s);

/* The nearest multiple of 2^-16: floor(x * 65536 + 0.5) / 65536. */
double scene_grid(double x);

/* Adds a body; the shapes that follow are its own. The pointer, like those below, is never null
 * and valid until the next call that adds something: set through it what is not default. */
scene_body *scene_add_body(scene *s, scene_body_kind kind, double x, double y);
scene_shape *scene_add_circle(scene *s, double radius);
scene_shape *scene_add_aabb(scene *s, double hx, double hy); /* fixes its body's rotation */
scene_shape *scene_add_obb(scene *s, double hx, double hy);
scene_shape *scene_add_flat(scene *s, double slope);
/* Heights at x0, x0 + spacing, ... */
scene_shape *scene_add_uniform(scene *s, double x0, double spacing, const double *heights,
                               int count);
scene_shape *scene_add_irregular(scene *s, const scene_point *points, int count);

/* A body with one shape, which is what most scenes are made of. Static boxes are AABBs, dynamic
 * ones OBBs. */
scene_body *scene_static_box(scene *s, double x, double y, double hx, double hy);
scene_body *scene_dynamic_box(scene *s, double x, double y, double hx, double hy);
scene_body *scene_dynamic_circle(scene *s, double x, double y, double radius);

/* Ties two bodies, by their indices, at a place in the world, where both frames are, with their x
 * axes along `angle`. The bodies stand at angle 0 (shapes may be at any); for others set the frames
 * through the pointer. */
scene_joint *scene_tie(scene *s, scene_joint_kind kind, int a, int b, double x, double y,
                       double angle);
/* From a place of body a to one of body b, in the world, locked at what is between them. */
scene_joint *scene_tie_distance(scene *s, int a, int b, double ax, double ay, double bx, double by);
/* Of two joints, by their indices. */
scene_joint *scene_tie_gear(scene *s, int first, int second, double ratio);

/* An explosion that walls and crates give cover from; a scene has at most SCENE_BLASTS_MAX. */
void scene_add_blast(scene *s, scene_blast blast);
/* From the beginning on, with what is not default set through the pointer; a scene has at most
 * SCENE_RULES_MAX. */
scene_rule *scene_add_rule(scene *s, uint32_t first, uint32_t second, scene_meeting meeting);
/* Whether there is anything but bodies and joints, which other engines have no like of. */
bool scene_has_fields(const scene *s);

/* Moves everything, and the camera, by (dx, dy): exact for whole numbers up to 10^7. */
void scene_shift(scene *s, double dx, double dy);

#endif
