/* block.h: blocks, which hold eight constraints side by side as a structure of arrays: the unit of
 * the narrowphase and of the solver (Box2D v3's src/contact_solver.c has the same as wide
 * contacts).
 *
 * A constraint that acts (a touching contact, or a constraint of an enabled joint) holds one lane
 * of a block. Invariants:
 * - The lanes of a bin (kind of constraint, side a static or not, graph colour) refer to no moving
 *   body twice, so that eight lanes can be read, solved and written back at once.
 * - Slot 0 of the awake bodies is a dummy at rest with inverse mass 0. Static sides and empty lanes
 *   point to it, and write it back unchanged.
 *
 * In memory a block is a td_block, whose last member is its one or two td_points, then a
 * td_point_history for each point, a td_surface, and what its form adds (td_block_form): a
 * td_manifold_cache, or the rows of a joint. All of it consists of rows of eight 32-bit words, one
 * word a lane, so that lanes.c can copy a lane without knowing its meaning.
 *
 * Units: lengths, times and masses of the caller; angles in radians. f8 values are by lane. */
#ifndef TD_BLOCK_H
#define TD_BLOCK_H

#include "base/fixed.h"
#include "base/simd.h"
#include "base/indices.h"

#include <stdatomic.h>
#include <stddef.h>
#include <string.h>

/* A shape at its present pose: all of its geometry that the wide kernels of td_finalize, the
 * broadphase and the narrowphase read, in one cache line. */
typedef struct td_shape_proxy {
    td_position center;   /* of the shape, position quanta (base/fixed.h) */
    float c, s;           /* cosine and sine of the rotation; 1, 0 for kinds that do not turn */
    float half_x, half_y; /* half extents; of a circle both are its radius (td_kind_half_y) */
    float x, y;           /* offset of the centre from the body's centre of mass, world axes */
    float turns;          /* 0 where the bounds do not depend on the rotation; 1 where they do; 2
                             where the shape also has an angle in its body's frame */
    int32_t margin;       /* how far the fat bounds exceed the tight ones, bounds quanta */
    td_bounds fat;        /* bounds with that margin */
} td_shape_proxy;

/* A contact point of eight lanes; wide_solve.h has the equations. The solver spends most of its
 * time on loading and storing blocks. So the fields that it reads in each pass stand together, in
 * three cache lines. */
typedef struct td_point {
    f8 separation;       /* present separation of the shapes minus the skin (thud_world.skin);
                            negative: overlap. The relax pass writes it for the next solve pass.
                            TD_APART: no point here */
    f8 normal_mass;      /* effective mass along the normal; 0: no point here */
    f8 normal_impulse;   /* of one substep, >= 0 for contacts */
    f8 cross_a, cross_b; /* r x n: the lever arm r from the body's centre of mass to the point */
    f8 start_separation; /* separation at the start of the step */
} td_point;

/* The fields of a contact point that few passes need, apart from td_point so that it stays small.
 * Blocks of locks and rods have a td_brace_rows in their place. */
typedef struct td_point_history {
    f8 normal_velocity; /* at the start of the step, length/s; negative: closing. Where the manifold
                           cache has kept the manifold of an earlier step, it is valid in bouncy
                           blocks only */
    f8 total; /* sum of the normal impulses of all substeps; valid if td_solve_context.keep_totals
                 is set */
} td_point_history;

/* Data of locks and rods for bracing (joints/joint_brace.c), in the place of the two
 * td_point_history of contacts. Work is impulse times speed, an energy, mass length^2 / s^2. */
typedef struct td_brace_rows {
    f8 group; /* number of the lane's group of bodies that locks and rods connect */
    union {
        f8 work_without; /* work at the speeds without the impulses: p.u */
        f8 kept_share;   /* set after work_without and work_with: the share of the impulses that is
                            kept */
    };
    float torn; /* 1 where the group of a lane has a torn joint, else 0: bracing passes over
                   the block. Valid after the first bracing of a step */
    float unused[TD_LANES - 1];
    f8 work_with; /* work at the speeds with the impulses: p.u' */
} td_brace_rows;

static_assert(sizeof(td_brace_rows) == 2 * sizeof(td_point_history), "they share their place");

/* Sums over the lanes of a group of bodies that locks and rods connect, for bracing: energies, mass
 * length^2 / s^2. Each bracing computes the first three anew. */
typedef struct td_brace_group {
    double work_without, work_with; /* p.u and p.u', as in td_brace_rows */
    double exchanged; /* energy that the locks exchange: the sum of |p.u'| of single lanes */
    int lanes;        /* number of lanes */
    float opening;    /* the widest gap (opening_of, joint_brace.c) */
} td_brace_group;

/* The fields of friction and restitution that few passes read, apart from td_block. */
typedef struct td_surface {
    f8 speed;  /* surface speed (a belt's): target of b's sliding speed along t, length/s; read only
                  where td_solve_context.surface_speeds */
    f8 total;  /* sum of the tangent impulses of all substeps; valid if
                  td_solve_context.keep_tangents is set */
    f8 energy; /* in blocks with a lane that has restitution: twice the pair's kinetic energy before
                  it bounced in this step; < 0: it has not bounced */
} td_surface;

/* The poses for which a lane's manifold was computed. While both shapes stay near these poses,
 * relative to each other and in the world, the manifold is kept, and only its separations are
 * updated: contact/wide_manifold_cache.h. */
typedef struct td_manifold_cache {
    f8 dx, dy;         /* from a's centre of mass to b's, length; on terrain: b's position, as the
                          bits of an int in units of 256 position quanta */
    f8 ac, as, bc, bs; /* cosine and sine of both shapes' rotations */
    f8 separation[2];  /* separations of the points in those poses */
    f8 limit;          /* relative motion up to which the manifold is kept, length */
    f8 reach; /* greatest half extent: the lever arm by which a rotation counts as motion */
} td_manifold_cache;

/* The impulse that a joint has applied in this substep, in world axes: (x, y) and moment_b to body
 * b, -(x, y) and -moment_a to body a. A substep begins with the impulses of the substep before
 * (motion.h); a joint whose direction has turned since then removes that impulse, and applies it
 * along its present direction. */
typedef struct td_applied_impulse {
    f8 x, y, moment_a, moment_b;
} td_applied_impulse;

/* The anchors of a joint. They depend only on the joint and the bodies' centres of mass, and are
 * copied again when td_block.anchors_stale is set (joints/anchors.c). */
typedef struct td_anchor_rows {
    i8 body_a, body_b;     /* td_body_index, also of static bodies */
    f8 a_x, a_y, b_x, b_y; /* from the centre of mass to the anchor, in the body's frame */
    f8 axis_c, axis_s;     /* td_joint.axis_c and .axis_s: direction `along` in the frame of a */
    i8 turn;               /* td_joint.turn: the relative angle that is 0, 2^32 a full turn */
} td_anchor_rows;

/* The rows that a block of locks (a joint's locked directions) or rods has in addition. The joint's
 * frame is u = (nx, ny), v = (-ny, nx). Point 0 of the block is the row along u (`along`, or the
 * rod), point 1 that along v (`across`), and the tangent row is the rotation (`turn`). The points'
 * separations and `turn_gap` are the gaps that the solver closes. */
typedef struct td_lock_rows {
    td_applied_impulse applied;
    f8 frame_turns; /* 1: the frame turns with body a; 0: it is constant in the step */
    union {
        f8 start_turn_gap; /* of a lock: gap of `turn` at the start of the step, rad */
        f8 rest_length;    /* of a rod */
    };
    f8 turn_sign;      /* 1, or -1 where td_joint.swapped: the sides are the caller's b and a */
    f8 turn_gap;       /* gap of `turn` at present, rad */
    f8 closing_factor; /* maximum closing speed of gaps in this step, in multiples of
                          TD_JOINT_CLOSING_SPEED */
    i8 locked;         /* td_joint.locked: bits of the locked directions */
    td_anchor_rows anchor;
} td_lock_rows;

/* The rows that a block of drives has in addition. A drive is the limits, spring and motor of one
 * direction of a joint. The impulse of the limits is that of point 0, the impulse of the spring
 * that of point 1, the impulse of the motor the tangent's. cross_a and cross_b of point 0 are the
 * lever arms crossed with u, those of point 1 the same crossed with v, as for locks. The coordinate
 * is a length, or an angle of direction `turn`. */
typedef struct td_drive_rows {
    td_applied_impulse applied;
    f8 gap_u, gap_v; /* from a's anchor to b's along u and v, at the start of the step */
    f8 start_value;  /* the coordinate at the start of the step */
    f8 turn_sign;    /* as in td_lock_rows */
    f8 limit;        /* the limit that is nearer at present: `lower` or `upper` */
    f8 limit_side;   /* 1: `limit` is the lower one, -1: the upper one, 0: no limits */
    f8 locked;       /* 1: both limits are equal, so that the row is an equality row; else 0 */
    f8 target, frequency, damping; /* of the spring; frequency in Hz, 0: none; damping ratio */
    f8 max_spring_force;           /* bound of the spring's force (or torque) */
    f8 motor_speed;                /* target speed of the motor */
    f8 max_motor_force;            /* bound of the motor's force (or torque); 0: no motor */
    f8 lower, upper;               /* limits of the coordinate */
    i8 limited, across; /* masks: there are limits; the direction is THUD_DIRECTION_ACROSS */
    td_anchor_rows anchor;
} td_drive_rows;

/* The rows that a block of gears has in addition. A gear has one constraint row. The linear part of
 * its Jacobian is (a_x, a_y) for side a, and the block's (nx, ny) for side b. */
typedef struct td_gear_rows {
    f8 a_x, a_y;
} td_gear_rows;

/* Flags and counters of a lane: 32 bits, so that they are copied like a row. */
typedef struct td_lane_marks {
    uint8_t internal_edges; /* td_internal_edges_of both shapes; 0: neither has internal edges */
    uint8_t loaded; /* in how many checks in succession the lane's load was above the threshold from
                       which its island is solved directly (direct/direct_islands.c), at most 2; and
                       the bit TD_DIRECT */
    uint16_t rule;  /* bits 0 to 9: number of the pair's rule in the table (rules/rules.h);
                       bits 14, 15: TD_RULE_IMPULSE, TD_RULE_ONE_WAY; and the bits below */
} td_lane_marks;

/* Bits of td_lane_marks.rule. */
enum {
    TD_LANE_ALTERED = 1 << 13, /* contact: the program's callback before the solver (prologue) has
                                  changed its settings */
    TD_LANE_REFUSED =
        1 << 12, /* contact: the program's callback before the solver (prologue) has vetoed it */
    /* Joint: it yielded, in the last step (LOST) or in the one before it (WAS_LOST): it had pressed
       a body into a static shape, and joint_yield.c corrected the motion. */
    TD_LANE_LOST = 1 << 11,
    TD_LANE_WAS_LOST = 1 << 10
};

/* The head of a block; the head of this file says what follows its points in memory. */
typedef struct td_block {
    int32_t shape_a[TD_LANES], shape_b[TD_LANES]; /* of joints TD_NONE */
    int32_t constraint[TD_LANES];                 /* TD_NONE: empty lane */
    uint32_t feature[TD_LANES]; /* code of the faces or corners that touch; while it stays the same,
                                   impulses are kept as the warm start. 0: none yet */
    /* One row that belongs to the block as a whole, not to lanes. */
    int32_t next, prev; /* indices of blocks of the same bin, or TD_NONE */
    int32_t used;       /* lanes 0 .. used - 1 are in use */
    uint32_t touching;  /* one bit for each lane: the last narrowphase found a contact point */
    int32_t bouncy;     /* 1: a lane may have restitution */
    union {
        int32_t has_offsets;   /* contacts, 1: a shape may be off its body's centre of mass, turned
                                  against its body, or have internal edges */
        int32_t anchors_stale; /* joints, 1: td_anchor_rows and settings must be copied from the
                                  joint again */
    };
    int32_t shared;      /* 1: a lane has a kinematic body. Other blocks of the run may have the
                            same body, so that only one worker may solve the run */
    union {              /* one bit for each lane */
        uint32_t apart;  /* contacts: its shapes provably stay apart during the motion of the step
                            (detection/gaps.h) */
        uint32_t solved; /* joints, where td_solve_context.passes_over: the lane's island was solved
                            before the soft solver runs (direct/joint_islands.c) */
    };
    td_lane_marks mark[TD_LANES];
    /* The rows that the solver reads begin here. */
    uint32_t a[TD_LANES], b[TD_LANES]; /* awake slot times TD_AWAKE_BYTES; 0: that side is static */
    f8 nx, ny;                         /* unit normal, from a to b; of joints direction u */
    f8 inv_inertia_a, inv_inertia_b;   /* 0: the side does not turn */
    /* One friction row for each contact, along the tangent t = (ny, -nx): the points of a contact
     * lie on one line along t, so that friction at each of them has the same line of action. */
    f8 friction;                         /* friction coefficient of the pair */
    f8 tangent_mass, tangent_impulse;    /* effective mass along t; impulse of one substep */
    f8 tangent_cross_a, tangent_cross_b; /* r x t, where r is the mean of the points' lever arms */
    f8 restitution;                      /* coefficient of restitution of the pair */
    td_point point[];                    /* one or two: td_form_points */
} td_block;

/* Whether any lane of the block has one of these marks. It tests two lanes at a time, since most
 * blocks have none. */
static inline bool td_any_lane_marked(const td_block *block, td_lane_marks marks) {
    const td_lane_marks each[2] = {marks, marks};
    uint64_t lanes[TD_LANES / 2], mask;
    memcpy(lanes, block->mark, sizeof lanes);
    memcpy(&mask, each, sizeof mask);
    return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) & mask;
}

enum { TD_DIRECT = 128 }; /* in td_lane_marks.loaded: impulses are the direct solver's */

/* Bytes of a record of an array by awake slot (float[4]). */
enum { TD_AWAKE_BYTES = 4 * (int)sizeof(float) };

/* Conversion between awake slots and the values of td_block.a and .b. A body without a slot
 * (TD_NONE) counts as the dummy, slot 0. */
static inline uint32_t td_side_of_slot(td_awake_slot slot) {
    return (uint32_t)td_max_int(slot.at, 0) * TD_AWAKE_BYTES;
}

static inline td_awake_slot td_slot_of_side(uint32_t side) {
    return (td_awake_slot){(int32_t)(side / TD_AWAKE_BYTES)};
}

/* Minimum and maximum number of blocks in a chunk, the piece of a run that a worker claims: enough
 * work to outweigh the cost of claiming it, and small enough that another worker can take over a
 * part of a share that takes long. Chosen. Chunks begin at multiples of TD_CHUNK_UNIT blocks of
 * their run, since depths of as many blocks are rounded together (wide_tally.c): so a report does
 * not depend on how runs are divided. */
enum { TD_CHUNK_UNIT = 4, TD_CHUNK_BLOCKS_MIN = 8, TD_CHUNK_BLOCKS = 96 };

/* Blocks that are solved and then added to the error statistics before the next ones: 22 to 36 KB,
 * which are still in the cache then. Chosen; a multiple of TD_CHUNK_UNIT. */
enum { TD_TALLY_BLOCKS = 24 };

/* ---- the data after a block's points ---- */

static inline td_point_history *td_history_of(td_block *block, int points) {
    return (td_point_history *)&block->point[points];
}

static inline td_surface *td_surface_at(td_block *block, int points) {
    return (td_surface *)&td_history_of(block, points)[points];
}

static inline td_brace_rows *td_brace_rows_of(td_block *block) {
    return (td_brace_rows *)td_history_of(block, 2);
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

/* Prefetches the solver's rows of block i + 2. Blocks of a run are not in order in memory, and the
 * passes are bound by memory. */
TD_INLINE void td_fetch_early(td_block *const *blocks, int i, int count, int points) {
    if (i + 2 < count) {
        const td_block *block = blocks[i + 2];
        const char *at = (const char *)block->a, *end = (const char *)&block->point[points];
        for (; at < end; at += 64) {
            __builtin_prefetch(at, 1);
        }
    }
}

/* The forms of blocks: the number of points, and what follows td_surface in memory. */
typedef enum td_block_form {
    TD_FORM_ONE,        /* one point */
    TD_FORM_ONE_CACHED, /* one point, td_manifold_cache */
    TD_FORM_TWO_CACHED, /* two points, td_manifold_cache */
    TD_FORM_LOCK,       /* two points, td_lock_rows */
    TD_FORM_DRIVE,      /* two points, td_drive_rows */
    TD_FORM_GEAR,       /* one point, td_gear_rows */
    TD_FORM_COUNT
} td_block_form;

static inline int td_form_points(td_block_form form) {
    return form == TD_FORM_ONE || form == TD_FORM_ONE_CACHED || form == TD_FORM_GEAR ? 1 : 2;
}

/* Bytes of a block of the form. */
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

/* ---- arguments of the wide kernels ---- */

/* Arguments of the narrowphase. */
typedef struct td_collide_context {
    const td_shape_proxy *proxy; /* by shape */
    const float (*velocity)[4];  /* by awake slot: x, y, turn, inverse mass */
    td_block **separated; /* out: the blocks that have a lane without a point; has room for the
                             number of blocks plus one */
    int *separated_count; /* in and out: number of elements of `separated` */
    int *has_offsets;     /* out: set to 1 where a block has offsets */
    float quantum;        /* length of a position quantum */
    float margin;         /* separation below which a pair touches (speculative margin), length */
    float skin;           /* distance at which contacts rest, length */
    float axis_tolerance; /* length by which the separation along a face normal of b must be larger
                             than along those of a for b's face to be the reference face */
} td_collide_context;

/* Passes of restitution (solver/wide_bounce.c): the first one and further ones before all substeps,
 * and one after them. */
typedef enum td_bounce { TD_BOUNCE_FIRST, TD_BOUNCE_AGAIN, TD_BOUNCE_LAST } td_bounce;

/* Passes of bracing (joints/joint_brace.c), which scales down the impulses of torn joints so that
 * they add no energy, after the warm start and after the relax pass of a substep. The stages of a
 * bracing run in this order: */
typedef enum td_brace {
    TD_BRACE_WARM_START,   /* apply the warm start along the present directions; not in the first
                              substep */
    TD_BRACE_WORK_WITH,    /* compute impulse times speed, at the speeds with the impulses */
    TD_BRACE_REMOVE,       /* where energy may have been added: remove the impulses */
    TD_BRACE_WORK_WITHOUT, /* compute impulse times speed, at the speeds without them */
    TD_BRACE_APPLY_SHARE   /* apply the share of the impulses that adds no energy */
} td_brace;

/* Maximum speed at which the gap of a joint closes, length scales/s, or rad/s for rotations: in the
 * direct solver, and in the soft solver in groups that are braced. Chosen: the default of
 * push_speed for contacts. */
#define TD_JOINT_CLOSING_SPEED 3.0f
/* In groups of the soft solver that are not braced, gaps close at up to this many times
 * TD_JOINT_CLOSING_SPEED. The impulse of a soft joint grows with its gap, so that this also bounds
 * the load that it can carry. Chosen. */
#define TD_JOINT_CLOSING_FACTOR 30.0f

/* Softness of a joint in the soft solver, h omega in the equations of solve.c: the phase of its
 * spring in a substep, rad, with a damping ratio of 1. Swinging bodies lose less energy with
 * stiffer joints. Measured: at about 2.2 and above, hanging chains and lattices never come to
 * rest. */
#define TD_JOINT_PHASE 2.0f
/* The share of a gap that closes in a substep: h bias_rate = h omega / (2 + h omega), one half. */
#define TD_JOINT_GAP_SHARE (TD_JOINT_PHASE / (2.0f + TD_JOINT_PHASE))

/* Maximum phase q = h omega of a joint's spring in a substep, rad: a faster spring acts like one
 * with this phase. Derived: with damping ratio d and a = q (q + 2 d), a soft row has mass_scale = a
 * / (1 + a) and h bias_rate = q / (q + 2 d) (solve.c). Rows that share bodies, each solved twice in
 * a substep, add no energy while q^2 < (1 + 2 a) / (1 + a), which is above 1 for every d. */
#define TD_SPRING_PHASE 1.0f

/* Maximum number of bounce passes before the substeps. A pass propagates an impact along a row of
 * bodies by at least two contacts: neighbouring contacts share a body, so they have different graph
 * colours (lanes.h), which a pass solves one after the other. The 64 passes reach through a row of
 * 128 bodies. Chosen. */
enum { TD_BOUNCE_PASSES = 64 };

/* Arguments of the solver's passes: constants of the step, then the state of the present pass. */
typedef struct td_solve_context {
    float (*velocity)[4]; /* by awake slot: x, y, turn, inverse mass */
    float (*delta)[4];    /* by awake slot: motion since the start of the step: x, y, angle. The
                             fourth value is 1 if a contact of the body has restitution and closes
                             or parts faster than resting ones (td_end_flights_fn) */
    const float (*substep_gain)[4]; /* by awake slot: velocity gained by forces in a substep */
    float inv_h;                    /* 1 / h: substeps per second */
    float substeps;                 /* number of substeps of the step */
    float push_speed;               /* maximum speed at which overlap is corrected, length/s */
    float joint_closing_speed;      /* TD_JOINT_CLOSING_SPEED, length/s */
    float bounce_speed;  /* <= 0, length/s: a pair bounces if its normal velocity, which is negative
                            where it closes, is below this */
    float elastic_speed; /* bounce_speed for pairs with a restitution of 1 or more */
    /* A pair bounces in this step if it meets within this time, s: a step and a substep, since the
     * last relax pass would otherwise stop a pair that meets in the substep after the step. */
    float bounce_time;
    float fall; /* gravity times time_step^2, length: a pair bounces in this step only if its
                   separation would be below this at the end */
    /* Softness of contacts between moving bodies [0], and with a static body [1]: solver/solve.c.
     */
    float bias_rate[2]; /* 1/s */
    float mass_scale[2], impulse_scale[2];
    bool keep_totals;    /* td_point_history.total is summed up, since a later stage reads it */
    bool keep_tangents;  /* td_surface.total is summed up, since a later stage reads it */
    bool surface_speeds; /* a lane has a surface speed */
    bool passes_over;    /* td_block.solved is valid: td_islands.passes_over */
    bool last;           /* this is the last substep, whose relax pass fills `tally` */
    bool again;          /* this is the second relax pass of its substep */
    bool first;          /* this is the first substep, which sets totals (td_point_history.total)
                            instead of adding to them */
    bool bounces;        /* a lane has restitution: bounce passes have set the totals of blocks that
                            are bouncy */
    td_bounce bounce;    /* the present bounce pass */
    atomic_bool *bounced;   /* a flag that the present bounce pass sets if a pair bounces */
    td_brace brace;         /* the present pass of bracing */
    atomic_bool *torn;      /* set by the warm start if a joint's gap is so large that the bias of
                               one substep exceeds TD_JOINT_CLOSING_SPEED */
    struct td_tally *tally; /* error statistics of this worker */
} td_solve_context;

/* The narrowphase of a kind: computes normals, lever arms, effective masses and separations of the
 * blocks for the present poses, and sets td_block.touching. */
typedef void td_collide_fn(td_block *const *blocks, int count, const td_collide_context *context);
/* A pass of the solver over blocks of one run. */
typedef void td_solve_fn(td_block *const *blocks, int count, const td_solve_context *context);

/* The result of a quick test of eight waiting pairs, one bit for each pair. bounds_apart: the fat
 * bounds no longer overlap, and the contact ends. near: the shapes may touch, and need the exact
 * test. A pair with neither bit keeps waiting. */
typedef struct td_sifted {
    unsigned bounds_apart, near;
} td_sifted;

typedef td_sifted td_sift_fn(const int32_t *shape_a, const int32_t *shape_b,
                             const td_collide_context *context);

/* The passes of the solver over blocks of a kind: [0] both sides move, [1] side a is static.
 * `brace` is null except for locks and rods. */
typedef struct td_solve_ops {
    td_solve_fn *warm_start[2], *solve[2], *relax[2], *brace[2];
} td_solve_ops;

#endif
