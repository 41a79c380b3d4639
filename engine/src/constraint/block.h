/* block.h: eight constraints side by side, the unit of narrowphase and solver.
 *
 * A constraint that acts, as a contact does that touches, holds one lane of a block for as long as
 * it acts. Blocks of one bin (kind, static or not, graph colour) never name a moving body twice, so
 * that eight lanes are solved at once. Slot 0 of the awake bodies is a dummy at rest: static sides
 * and empty lanes point to it, and have zero mass. */
#ifndef TD_BLOCK_H
#define TD_BLOCK_H

#include "base/fixed.h"
#include "base/simd.h"
#include "base/indices.h"

#include <stdatomic.h>
#include <stddef.h>
#include <string.h>

/* A shape as it stands in the world. It fills one cache line, and has all of the geometry that the
 * wide kernels of td_finalize, of the grids and of the narrowphase read of a shape. */
typedef struct td_shape_proxy {
    td_position center;
    float c, s;           /* rotation; 1, 0 where it cannot matter */
    float half_x, half_y; /* half extents, of a circle both its radius: td_kind_half_y */
    float x, y;           /* offset of the centre from the body's centre of mass, in the world */
    float turns;          /* 1 where the bounds depend on the rotation, else 0 */
    int32_t margin;       /* by which the fat bounds exceed the tight ones, bounds quanta */
    td_bounds fat;
} td_shape_proxy;

/* A contact point of eight lanes. A cross is r x n, where r is the arm from a body's centre of mass
 * to the point and n the normal. The solver is bound by the bytes that it moves, so that what it
 * reads of a point stands together, in three cache lines. */
typedef struct td_point {
    f8 separation;  /* now: the relax pass leaves it for the next solve pass */
    f8 normal_mass; /* 0: no point here */
    f8 normal_impulse;
    f8 cross_a, cross_b;
    f8 base; /* separation at the start of the step */
} td_point;

/* The part of a contact point that the passes of a substep mostly leave alone, kept apart so that
 * td_point stays small. Of what joints lock it has rings and powers: joints/joint_brace.c. */
typedef struct td_point_history {
    f8 approach; /* normal velocity at the start of the step; negative: closing */
    f8 total;    /* normal impulse of the step; kept only where td_solve_context asks */
} td_point_history;

/* The part of friction and restitution that most contacts do not need, kept apart for the same
 * reason. */
typedef struct td_surface {
    f8 speed;  /* at which b is driven along t; read only where td_solve_context.surface_speeds */
    f8 total;  /* tangent impulse of all substeps; kept only where keep_tangents */
    f8 energy; /* twice the pair's kinetic energy before it bounced in this step, < 0 where it has
                  not; set in bouncy blocks alone */
} td_surface;

/* The poses for which a lane's manifold was worked out. While both shapes stay near them, relative
 * to each other and in the world, the manifold is kept and only its separations follow: see
 * wide_manifold_cache.h. */
typedef struct td_manifold_cache {
    f8 dx, dy;         /* from a's centre of mass to b's; on terrain: bits of b's place */
    f8 ac, as, bc, bs; /* cosine and sine of both shapes */
    f8 base[2];        /* separations then */
    f8 limit;          /* motion up to which the manifold stays */
    f8 reach;          /* greatest half extent: what a turn moves */
} td_manifold_cache;

/* What a joint gave in this substep, in the world: substeps begin with what the one before gave
 * (motion.h), and a joint that has turned since takes it back, and gives it along where it is now.
 */
typedef struct td_applied_impulse {
    f8 x, y, moment_a, moment_b;
} td_applied_impulse;

/* Where a joint is fixed on its bodies. It follows from the joint and its bodies' centres of mass
 * alone, and is looked up anew where td_block.armed is set: joints/anchors.c. */
typedef struct td_anchor_rows {
    i8 body_a, body_b;     /* td_body_index, of a static side too */
    f8 a_x, a_y, b_x, b_y; /* from the centre of mass to the anchor, in the body's frame */
    f8 axis_c, axis_s;     /* td_joint.axis_c and .axis_s */
    i8 turn;               /* td_joint.turn */
} td_anchor_rows;

/* The rest of a joint's locked directions. Its points are `along` and `across`, off by their
 * separations, and its tangent is `turn`. */
typedef struct td_lock_rows {
    td_applied_impulse applied;
    f8 frame;      /* 1: the directions turn with a; 0: they stay in the step as they are */
    f8 turn_base;  /* angle by which it is off at the start of the step; of a rod its length */
    f8 turn_sign;  /* 1, or -1 where sides have changed places */
    f8 turn_apart; /* like separation, now */
    f8 haste;      /* gaps close at up to so many times TD_JOINT_CLOSING in this step */
    i8 locked;     /* td_joint.locked */
    td_anchor_rows anchor;
} td_lock_rows;

/* The rest of a joint's driven direction. Both its points have the crosses of its frame; the first
 * one's impulse is that of the limits, the second one's of the spring, the tangent's of the motor.
 */
typedef struct td_drive_rows {
    td_applied_impulse applied;
    f8 gap_u, gap_v;      /* where b's anchor is from a's, at the start of the step */
    f8 value_base;        /* of turn: the angle then */
    f8 turn_sign;         /* as above */
    f8 limit, limit_side; /* the nearer one; 1: it is the lower, -1: the upper, 0: none */
    f8 locked;            /* 1: both are the same */
    f8 target, frequency, damping, spring_most; /* spring_most: a force */
    f8 motor_speed, motor_most;                 /* motor_most: a force */
    f8 lower, upper;
    i8 limited, across; /* masks; across: it drives THUD_ACROSS */
    td_anchor_rows anchor;
} td_drive_rows;

/* The rest of a gear's one row, whose side b has the directions of its block: that of side a. */
typedef struct td_gear_rows {
    f8 a_x, a_y;
} td_gear_rows;

/* What a lane keeps beside its rows: as wide as an element of them, so that it is copied like one.
 */
typedef struct td_lane_marks {
    uint8_t internal_edges; /* td_shape.internal_edges of shape_a, where that is static */
    uint8_t loaded;         /* how often in succession it was found to carry too much, see
                               direct_islands.c; and the bit TD_DIRECT */
    uint16_t rule;          /* rules/rules.h: what a step is to look at; and the bits below */
} td_lane_marks;

/* In td_lane_marks.rule: a prologue wanted other settings; or it said no. Of a joint: it lost
 * against a static shape in the last solve; and in the one before: joints/joint_yield.c. */
enum {
    TD_LANE_ALTERED = 1 << 13,
    TD_LANE_REFUSED = 1 << 12,
    TD_LANE_LOST = 1 << 11,
    TD_LANE_WAS_LOST = 1 << 10
};

/* Behind its points, a block has one td_point_history for each of them, a td_surface, and, where
 * its form says so, a td_manifold_cache. */
typedef struct td_block {
    int32_t shape_a[TD_LANES], shape_b[TD_LANES];
    int32_t constraint[TD_LANES]; /* TD_NONE: empty lane */
    uint32_t
        feature[TD_LANES]; /* faces in touch; impulses carry over while they stay; 0: none yet */
    int32_t next, prev;    /* blocks of the same bin */
    int32_t used;          /* lanes 0 .. used - 1 are in use */
    uint32_t touching;     /* lanes with a point, by the last narrowphase */
    int32_t bouncy;        /* a lane has restitution */
    int32_t armed;         /* a lane's shape may be off its body's centre of mass; of joints: what
                              a lane keeps of its joint is to be looked up anew */
    int32_t shared;        /* a lane has a kinematic body, which other blocks may have as well */
    uint32_t apart; /* lanes that the motion of the step surely keeps apart: detection/gaps.h */
    td_lane_marks mark[TD_LANES];
    /* The solver's rows begin here. */
    uint32_t a[TD_LANES], b[TD_LANES]; /* awake slots, in bytes of their records of four floats; 0:
                                          that side is static */
    f8 nx, ny;                         /* from a to b */
    f8 inv_inertia_a, inv_inertia_b;
    /* Friction acts along t = (ny, -nx), once for all points, whose tangents are the same line. */
    f8 friction;
    f8 tangent_mass, tangent_impulse;
    f8 tangent_cross_a, tangent_cross_b; /* r x t, where r is the mean of the points' arms */
    f8 restitution;
    td_point point[]; /* one or two */
} td_block;

/* Whether a lane has one of these marks: two lanes at once, since most blocks have none. */
static inline bool td_any_lane_marked(const td_block *block, td_lane_marks marks) {
    const td_lane_marks each[2] = {marks, marks};
    uint64_t lanes[TD_LANES / 2], mask;
    memcpy(lanes, block->mark, sizeof lanes);
    memcpy(&mask, each, sizeof mask);
    return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) & mask;
}

enum { TD_DIRECT = 128 }; /* in td_lane_marks.loaded: impulses are the direct solver's */

enum { TD_AWAKE_BYTES = 4 * (int)sizeof(float) };

/* Between an awake slot and td_block.a or .b; without a slot it is the dummy's. */
static inline uint32_t td_side_of_slot(td_awake_slot slot) {
    return (uint32_t)td_max_int(slot.at, 0) * TD_AWAKE_BYTES;
}

static inline td_awake_slot td_slot_of_side(uint32_t side) {
    return (td_awake_slot){(int32_t)(side / TD_AWAKE_BYTES)};
}

enum { TD_CHUNK_BLOCKS = 24 }; /* enough work for a worker to be worth taking */

static inline td_point_history *td_history_of(td_block *block, int points) {
    return (td_point_history *)&block->point[points];
}

static inline td_surface *td_surface_at(td_block *block, int points) {
    return (td_surface *)&td_history_of(block, points)[points];
}

static inline td_manifold_cache *td_manifold_cache_of(td_block *block, int points) {
    return (td_manifold_cache *)(td_surface_at(block, points) + 1);
}

static inline td_lock_rows *td_lock_rows_of(td_block *block) {
    return (td_lock_rows *)(td_surface_at(block, 2) + 1);
}

static inline const td_lock_rows *td_lock_rows_at(const td_block *block) {
    const td_surface *surface =
        (const td_surface *)((const td_point_history *)&block->point[2] + 2);
    return (const td_lock_rows *)(surface + 1);
}

static inline td_drive_rows *td_drive_rows_of(td_block *block) {
    return (td_drive_rows *)(td_surface_at(block, 2) + 1);
}

static inline const td_drive_rows *td_drive_rows_at(const td_block *block) {
    const td_surface *surface =
        (const td_surface *)((const td_point_history *)&block->point[2] + 2);
    return (const td_drive_rows *)(surface + 1);
}

static inline td_gear_rows *td_gear_rows_of(td_block *block) {
    return (td_gear_rows *)(td_surface_at(block, 1) + 1);
}

/* Blocks lie where their constraints began, and the passes over them are bound by memory: the
 * solver's rows of the one after the next are asked for early. */
TD_INLINE void td_fetch_early(td_block *const *blocks, int i, int count, int points) {
    if (i + 2 < count) {
        const td_block *block = blocks[i + 2];
        const char *at = (const char *)block->a, *end = (const char *)&block->point[points];
        for (; at < end; at += 64) {
            __builtin_prefetch(at, 1);
        }
    }
}

/* The forms of blocks: how many points they have, and what stands behind their surface. */
typedef enum td_block_form {
    TD_FORM_ONE,
    TD_FORM_ONE_CACHED,
    TD_FORM_TWO_CACHED,
    TD_FORM_LOCK,
    TD_FORM_DRIVE,
    TD_FORM_GEAR,
    TD_FORM_COUNT
} td_block_form;

static inline int td_form_points(td_block_form form) {
    return form == TD_FORM_ONE || form == TD_FORM_ONE_CACHED || form == TD_FORM_GEAR ? 1 : 2;
}

static inline size_t td_form_bytes(td_block_form form) {
    size_t points = (size_t)td_form_points(form);
    size_t behind = form == TD_FORM_ONE     ? 0
                    : form == TD_FORM_LOCK  ? sizeof(td_lock_rows)
                    : form == TD_FORM_DRIVE ? sizeof(td_drive_rows)
                    : form == TD_FORM_GEAR  ? sizeof(td_gear_rows)
                                            : sizeof(td_manifold_cache);
    return sizeof(td_block) + points * (sizeof(td_point) + sizeof(td_point_history)) +
           sizeof(td_surface) + behind;
}

/* ---- what the wide kernels are given ---- */

typedef struct td_collide_context {
    const td_shape_proxy *proxy; /* by shape */
    const float (*velocity)[4];  /* by awake slot: x, y, angular, inverse mass */
    td_block **parted;           /* gets the blocks that have a lane without a point */
    int *parted_count;
    int *armed;           /* set where a block is armed */
    float quantum;        /* length of a position quantum */
    float margin;         /* speculative */
    float skin;           /* at which contacts rest: what the solver takes for touching */
    float axis_tolerance; /* how much better b's face must be to be preferred */
} td_collide_context;

/* Passes of restitution: the first and others before all substeps, and the one after them. */
typedef enum td_bounce { TD_BOUNCE_FIRST, TD_BOUNCE_AGAIN, TD_BOUNCE_LAST } td_bounce;

/* Passes that keep joints that are torn from adding energy, by their warm start or by the end of a
 * substep: joints/joint_brace.c. */
typedef enum td_brace {
    TD_BRACE_GIVE,   /* give the warm start along the directions as they are now, */
    TD_BRACE_AFTER,  /* measure their power; and where they may have added energy */
    TD_BRACE_TAKE,   /* take back what was given, */
    TD_BRACE_BEFORE, /* measure the power at the velocities without them, */
    TD_BRACE_KEEP    /* and give the share of them that adds no energy */
} td_brace;

/* Walks over blocks that bracing takes, and tasks of one worker between them. */
enum { TD_BRACE_STAGES = TD_BRACE_KEEP + 1, TD_BRACE_TASKS = 2 };

/* Length scales, or radians, a second, at which a gap of a joint closes, or so many times that
 * where it is solved softly and adds no energy by it: with less it would bear no more than so much,
 * since what it is open by is what it pulls with. Both chosen. */
#define TD_JOINT_CLOSING 3.0f
#define TD_JOINT_HASTE 30.0f

/* How soft a joint is: its angle in a substep, with a damping ratio of 1, as solve.c has them for
 * contacts; and the part of a gap that closes in a substep. What swings loses less energy the
 * stiffer joints are; from some 2.2 on chains and lattices that hang never come to rest, and shake
 * the harder. */
#define TD_JOINT_ANGLE 2.0f
#define TD_JOINT_PULL (TD_JOINT_ANGLE / (2.0f + TD_JOINT_ANGLE))

/* A spring goes on by at most this phase in a substep, rad: faster ones act as one that does. With
 * a = q (q + 2 d) of phase q and damping d a row keeps a / (1 + a) of what it corrects, and moves
 * by q / (q + 2 d) of how far it is off; of many rows that share bodies, each solved twice in a
 * substep, none adds energy while q^2 < (1 + 2 a) / (1 + a), which is above 1 for every damping. */
#define TD_SPRING_PHASE 1.0f

enum { TD_BOUNCE_PASSES = 64 }; /* before all substeps; each takes a row two links on at least */

typedef struct td_solve_context {
    float (*velocity)[4];   /* by awake slot */
    float (*delta)[4];      /* by awake slot: motion since the start of the step: x, y, angle */
    const float (*push)[4]; /* by awake slot: velocity that gravity and forces give in a substep */
    float inv_h;            /* substeps per second */
    float substeps;         /* in a step */
    float time_step;        /* s */
    float push_speed;
    float joint_closing; /* TD_JOINT_CLOSING, lengths/s */
    float bounce_speed;  /* normal velocity, <= 0: pairs that close in more slowly do not bounce */
    float elastic_speed; /* the same for pairs of restitution 1 */
    float fall;          /* a length: gravity times the square of time_step */
    float bias_rate[2];  /* soft contact against a moving [0] and a static body [1] */
    float mass_scale[2], impulse_scale[2];
    bool keep_totals;     /* somebody will read td_point_history.total */
    bool keep_tangents;   /* somebody will read td_surface.total */
    bool surface_speeds;  /* a lane has a surface speed */
    bool last;            /* this is the last substep, whose relax pass tallies */
    bool again;           /* this relax pass comes on top of another one of its substep */
    bool first;           /* this is the first substep, where totals start anew */
    bool bounces;         /* some lane may bounce: totals of bouncy blocks began anew then */
    td_bounce bounce;     /* which pass */
    atomic_bool *bounced; /* set by it where a pair bounces */
    td_brace brace;       /* which pass */
    atomic_bool *adds;    /* set where what torn joints gave may have added energy: of this bracing
                             and those after it in the step */
    atomic_bool *torn;    /* set by the warm start where a joint is open by more than
                             TD_JOINT_CLOSING takes out of it in a substep */
    struct td_tally *tally; /* the last relax pass notes approaches there */
} td_solve_context;

/* Fills normal, crosses, masses, base and separation of the blocks from the present poses, and
 * sets td_block.touching. */
typedef void td_collide_fn(td_block *const *blocks, int count, const td_collide_context *context);
typedef void td_solve_fn(td_block *const *blocks, int count, const td_solve_context *context);

/* Sifts eight pairs of shapes: bits of those whose fat bounds overlap no more, and of those that
 * may touch. What is in neither is surely apart, but not for good. */
typedef struct td_sifted {
    unsigned parted, near;
} td_sifted;

typedef td_sifted td_sift_fn(const int32_t *shape_a, const int32_t *shape_b,
                             const td_collide_context *context);

/* The passes over blocks of one number of points: [0] both sides move, [1] side a is static.
 * `brace` is null but for what joints lock. */
typedef struct td_solve_ops {
    td_solve_fn *warm_start[2], *solve[2], *relax[2], *bounce, *brace[2];
} td_solve_ops;

#endif
