/* scene.h: a scene as plain data, independent of any engine.
 *
 * The built-in scenes (scenes.h) and the levels (../level) fill one. build_thud.h builds a thud
 * world from it, and the comparison with Box2D builds the same one there. All numbers are doubles:
 * each builder rounds them to float once, so that all builders start from equal bits.
 *
 * Units are metres, seconds, kilograms and radians; y points up, angles are counter-clockwise. The
 * order of bodies, and of the shapes of a body, is the order of creation. Positions of bodies are
 * multiples of 2^-16 (scene_grid), so that a shift by whole numbers up to 10^7 is exact in double
 * precision. */
#ifndef THUD_DEMO_SCENE_H
#define THUD_DEMO_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum scene_body_kind {
    SCENE_STATIC = 0,
    SCENE_KINEMATIC, /* moves and rotates at its set velocity */
    SCENE_DYNAMIC
} scene_body_kind;

typedef enum scene_shape_kind {
    SCENE_CIRCLE = 0,
    SCENE_AABB, /* never rotates: only on bodies with fixed_rotation (or static) and angle 0 */
    SCENE_OBB,
    SCENE_TERRAIN_FLAT,     /* infinite line through the body's origin: height = slope * x */
    SCENE_TERRAIN_UNIFORM,  /* points at equal distances `spacing`, from the first one's x on */
    SCENE_TERRAIN_IRREGULAR /* points with strictly increasing x */
} scene_shape_kind;

/* The collision detection of a body, see thud_detection.h; SCENE_AS_WORLD: the world's. */
typedef enum scene_detection {
    SCENE_AS_WORLD = 0,
    SCENE_OVERLAP,
    SCENE_CONTINUOUS,
    SCENE_BISECT,
    SCENE_SWEPT
} scene_detection;

/* Overlays that a viewer shows from the start; bits of scene.show. */
enum scene_show {
    SCENE_SHOW_CELLS = 1 << 0,
    SCENE_SHOW_AXES = 1 << 1,
    SCENE_SHOW_MOTIONS = 1 << 2
};

/* A point of terrain, relative to the body's origin. All terrain is one-sided: solid below. */
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
    double x, y;                  /* offset from the body's origin, in its frame */
    double hx, hy;                /* half extents; of a circle hx is the radius and hy is 0 */
    double angle;                 /* of an OBB, in the body's frame */
    double slope;                 /* flat terrain */
    double spacing;               /* uniform terrain */
    int first_point, point_count; /* uniform and irregular terrain: range in scene.points */
    /* Irregular terrain, 0: its friction is that of the material, all along; else the number, from
     * 1 on, of the row of the texture that it is read from (texture.h). thud alone knows textures.
     */
    int texture_row;
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
    int look;    /* the viewer's colour number, from 1 on; 0: a colour by its handle */
    uint32_t id; /* of the object in a level file; 0 in built-in scenes */
    int first_shape, shape_count; /* range in scene.shapes */
} scene_body;

/* As in thud_joint.h. */
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

/* The directions of a joint, indices of scene_joint.drive. */
enum { SCENE_ALONG, SCENE_ACROSS, SCENE_TURN, SCENE_DIRECTIONS };

/* Limits, spring and motor of a joint's direction, as thud_drive. */
typedef struct scene_drive {
    bool limited;
    double lower, upper;
    double frequency, damping, target, spring_force; /* defaults 0, 0.7, 0, 1e30 */
    double motor_speed, motor_force;
} scene_drive;

typedef struct scene_joint {
    scene_joint_kind kind;
    int body[2];                 /* indices in scene.bodies; of a gear: in scene.joints */
    double x[2], y[2], angle[2]; /* the joint's frame in each body, relative to the body's origin */
    scene_drive drive[SCENE_DIRECTIONS];
    double length;                    /* of a distance joint */
    double ratio;                     /* of a gear; default 1 */
    bool collide_connected;           /* default false; true for a gear */
    double break_force, break_torque; /* default 1e30: never breaks */
} scene_joint;

/* An explosion before a step, see thud_fields.h. */
typedef struct scene_blast {
    int step; /* the number of steps before it, from 0 on */
    double x, y, radius, falloff, impulse;
} scene_blast;

enum { SCENE_BLASTS_MAX = 4 };

typedef enum scene_rule_kind { SCENE_COLLIDE = 0, SCENE_IGNORE, SCENE_ONE_WAY } scene_rule_kind;

/* The collision rule of two kinds of shapes, see thud_rules.h. From its `step` on a rule replaces
 * the earlier ones of the list with the same `first` and `second`; rules that differ in these have
 * no pair of kinds in common. NaN: the value of the shapes. */
typedef struct scene_rule {
    int step;               /* the number of steps before it takes effect; 0: from the start */
    uint32_t first, second; /* kinds: bits as in scene_shape.category */
    scene_rule_kind kind;   /* one-way: solid from above, passed from below */
    double friction, restitution;
    double surface_speed; /* m/s, clockwise */
    double event_impulse; /* kg m/s in a step, beyond which a contact makes an impulse event;
                            default infinite */
} scene_rule;

enum { SCENE_RULES_MAX = 16 };

/* Fields that act on awake bodies before each step, and collision rules, see act_thud.h. All zero:
 * none. */
typedef struct scene_fields {
    double water_density; /* kg/m^2; 0: no water */
    double water_level;
    double water_drag;  /* 1/s, linear and angular */
    double air_density; /* kg/m^2; 0: no wind */
    double wind;        /* m/s, to the right; gusts change it to between 0.2 and 1.8 times this */
    double wind_origin; /* x at which gusts have no delay; downwind of it they arrive later */
    double air_drag, air_lift;
    scene_blast blasts[SCENE_BLASTS_MAX];
    int blast_count;
    scene_rule rules[SCENE_RULES_MAX]; /* ordered by step */
    int rule_count;
    uint32_t breaks, pieces; /* kinds: boxes of `breaks` break into boxes of `pieces`; 0: none */
} scene_fields;

typedef struct scene {
    const char *name; /* the built-in scene's, or the level's file name without folder and suffix */
    const char *title;           /* for a menu */
    const char *about;           /* one sentence: what to look at */
    double gravity_x, gravity_y; /* default 0, -10 */
    double length_scale;         /* size of a typical body, m; default 1 */
    double camera_x, camera_y;   /* centre of the first view, m */
    double camera_height;        /* height of the first view, m */
    double camera_width;         /* its min width, m; default 0 */
    double spawn_x, spawn_y;     /* where a viewer adds new bodies, m */
    bool character;              /* played with a character, which starts at (spawn_x, spawn_y) */
    unsigned show;               /* bits of scene_show */
    scene_fields fields;
    bool textured; /* the ground is drawn with a texture, see texture.h */
    int kinds;     /* number of kinds, from 1 << 1 on, whose rules a viewer lets a user set */
    /* Number of pairs of bodies, from the first body on, that are shown with their Minkowski sum;
     * each body has one shape, no terrain. */
    int sum_pairs;
    scene_body *bodies;
    scene_shape *shapes;
    scene_point *points;
    scene_joint *joints;
    int body_count, shape_count, point_count, joint_count;
    int body_capacity, shape_capacity, point_capacity, joint_capacity;
    scene_material material; /* of every shape that is added from now on */
    bool failed;             /* memory ran out while filling: the scene is incomplete */
    scene_body spare_body;   /* returned by functions that add something once memory has run out */
    scene_shape spare_shape;
    scene_joint spare_joint;
    scene_rule spare_rule;
    char *owned_text; /* memory of name, title and about of a level; else null */
} scene;

/* Makes *s an empty scene with the defaults above. A scene that was initialised has to be freed. */
void scene_init(scene *s);
void scene_free(scene *s);

/* The nearest multiple of 2^-16: floor(x * 65536 + 0.5) / 65536. */
double scene_grid(double x);

/* Adds a body; shapes that are added next belong to it. The pointer, like those below, is never
 * null and valid until the next call that adds something. The caller sets through it what is not
 * default. */
scene_body *scene_add_body(scene *s, scene_body_kind kind, double x, double y);
scene_shape *scene_add_circle(scene *s, double radius);
scene_shape *scene_add_aabb(scene *s, double hx, double hy); /* fixes its body's rotation */
scene_shape *scene_add_obb(scene *s, double hx, double hy);
scene_shape *scene_add_flat(scene *s, double slope);
/* Uniform terrain with heights at x0, x0 + spacing, ... */
scene_shape *scene_add_uniform(scene *s, double x0, double spacing, const double *heights,
                               int count);
scene_shape *scene_add_irregular(scene *s, const scene_point *points, int count);

/* A body with one shape. A static box is an AABB, a dynamic one an OBB. */
scene_body *scene_static_box(scene *s, double x, double y, double hx, double hy);
scene_body *scene_dynamic_box(scene *s, double x, double y, double hx, double hy);
scene_body *scene_dynamic_circle(scene *s, double x, double y, double radius);

/* Adds a joint of the bodies with the indices `a` and `b`. Its frames are both at (x, y) in the
 * world, with their x axes along `angle`. The bodies' angles have to be 0 (those of shapes may be
 * any); for others the caller sets the frames through the pointer. */
scene_joint *scene_tie(scene *s, scene_joint_kind kind, int a, int b, double x, double y,
                       double angle);
/* A distance joint from a place on body a to one on body b, both in the world. Its length is the
 * distance between them. */
scene_joint *scene_tie_distance(scene *s, int a, int b, double ax, double ay, double bx, double by);
/* A gear of the joints with the indices `first` and `second`. */
scene_joint *scene_tie_gear(scene *s, int first, int second, double ratio);

/* Adds an explosion; walls and crates shield bodies from it. Beyond SCENE_BLASTS_MAX s->failed is
 * set. */
void scene_add_blast(scene *s, scene_blast blast);
/* Adds a rule from the first step on; the caller sets through the pointer what is not default.
 * Beyond SCENE_RULES_MAX s->failed is set. */
scene_rule *scene_add_rule(scene *s, uint32_t first, uint32_t second, scene_rule_kind meeting);
/* Whether the scene has water, wind, explosions or rules, which are not built in other engines. */
bool scene_has_fields(const scene *s);

/* The chunk of a recording (thud_recording.h) that says how it is to be shown, and most characters
 * of its text. */
#define SCENE_SHOWN "thud-page"
enum { SCENE_SHOWN_MAX = 320 };
/* Writes that text for the scene, JSON as web/src/worker/playback.ts reads it: the first view, and
 * the length scale. Returns its length. */
size_t scene_shown(const scene *s, char *out);

/* Moves everything, including the camera, by (dx, dy): exact for whole numbers up to 10^7. */
void scene_shift(scene *s, double dx, double dy);

#endif
