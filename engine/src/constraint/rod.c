/* rod.c: see rod.h. */
#include "constraint/rod.h"

#include "constraint/joining.h"
#include "constraint/lanes.h"
#include "state/body.h"
#include "state/handles.h"
#include "state/kinds.h"

TD_DECLARE_WIDE(const td_solve_ops, td_solve_rod);

/* ---- lanes ---- */

static void fill(thud_world *w, td_block *block, int lane, int index) {
    (void)w, (void)index;
    block->shape_a[lane] = block->shape_b[lane] = TD_NONE;
}

/* Nothing of a rod is counted elsewhere, and all of its row is worked out anew in every step. */
static void let_be(thud_world *w, td_block *block, int lane, int index) {
    (void)w, (void)block, (void)lane, (void)index;
}

/* The arms of a rod about the centres of mass, and its line from a to b. */
typedef struct rod_line {
    float arm[2][2];
    float x, y, length;
} rod_line;

static void arm_of(const thud_world *w, td_body_index index, const float anchor[2], float arm[2]) {
    const td_body *body = td_body_at(w, index);
    const td_pose *pose = td_pose_at(w, index);
    float x = anchor[0] - body->center_x, y = anchor[1] - body->center_y;
    arm[0] = pose->c * x - pose->s * y;
    arm[1] = pose->s * x + pose->c * y;
}

static rod_line line_of(const thud_world *w, const td_constraint *constraint) {
    const td_joint *joint = td_slot_at(&w->joints, constraint->joint);
    td_position a = td_pose_at(w, constraint->body[0])->center;
    td_position b = td_pose_at(w, constraint->body[1])->center;
    rod_line line;
    for (int side = 0; side < 2; side++) {
        arm_of(w, constraint->body[side], joint->anchor[side], line.arm[side]);
    }
    float x = (float)((double)(b.x - a.x) / w->to_fixed) + line.arm[1][0] - line.arm[0][0];
    float y = (float)((double)(b.y - a.y) / w->to_fixed) + line.arm[1][1] - line.arm[0][1];
    line.length = __builtin_sqrtf(x * x + y * y);
    /* Where both ends meet any direction will do. */
    line.x = line.length > 0.0f ? x / line.length : 0.0f;
    line.y = line.length > 0.0f ? y / line.length : 1.0f;
    return line;
}

static float inverse_mass(const thud_world *w, uint32_t record) {
    return td_row(&w->velocity, td_slot_of_side(record))[3];
}

static void prepare_lane(const thud_world *w, td_block *block, int lane) {
    const td_constraint *constraint = td_constraint_at(w, block->constraint[lane]);
    const td_joint *joint = td_slot_at(&w->joints, constraint->joint);
    rod_line line = line_of(w, constraint);
    td_point *p = &block->point[0];
    float cross_a = line.arm[0][0] * line.y - line.arm[0][1] * line.x;
    float cross_b = line.arm[1][0] * line.y - line.arm[1][1] * line.x;
    float inertia_a = block->inv_inertia_a[lane], inertia_b = block->inv_inertia_b[lane];
    float k = inverse_mass(w, block->a[lane]) + inverse_mass(w, block->b[lane]) +
              inertia_a * cross_a * cross_a + inertia_b * cross_b * cross_b;
    block->nx[lane] = line.x;
    block->ny[lane] = line.y;
    p->cross_a[lane] = block->a[lane] ? cross_a : 0.0f;
    p->cross_b[lane] = cross_b;
    p->normal_mass[lane] = k > 0.0f ? 1.0f / k : 0.0f;
    p->base[lane] = p->separation[lane] = line.length - joint->length;
}

/* Rods never part. */
static void prepare(thud_world *w, td_block *const *blocks, int count,
                    const td_collide_context *context) {
    (void)context;
    for (int i = 0; i < count; i++) {
        for (int lane = 0; lane < blocks[i]->used; lane++) {
            prepare_lane(w, blocks[i], lane);
        }
        blocks[i]->touching = (1u << blocks[i]->used) - 1u;
    }
}

/* A rod overlaps nothing. It misses what it wants by the speed along it, either way. */
static void count(thud_world *w, const td_block *block) {
    const td_point *p = &block->point[0];
    for (int lane = 0; lane < block->used; lane++) {
        const float *a = td_row(&w->velocity, td_slot_of_side(block->a[lane]));
        const float *b = td_row(&w->velocity, td_slot_of_side(block->b[lane]));
        float speed = (b[0] - a[0]) * block->nx[lane] + (b[1] - a[1]) * block->ny[lane] +
                      b[2] * p->cross_b[lane] - a[2] * p->cross_a[lane];
        w->errors.residual = td_max_float(w->errors.residual, speed < 0.0f ? -speed : speed);
    }
}

static const td_lane_ops lanes = {
    .fill = fill, .clear = let_be, .renew = let_be, .count = count, .take_rows = td_rod_take_rows};

#define ROD_OPS(solve_ops)                                                                     \
    {                                                                                          \
        .form = TD_FORM_ONE, .lanes = &lanes, .collide_world = prepare, .solve = &(solve_ops), \
        .solve_unarmed = &(solve_ops)                                                          \
    }

static const td_constraint_ops *ops_of(const thud_world *w) {
    static const td_constraint_ops base = ROD_OPS(td_solve_rod_base);
#if defined(TD_HAS_AVX2)
    static const td_constraint_ops avx2 = ROD_OPS(td_solve_rod_avx2);
    return w->wide ? &avx2 : &base;
#else
    (void)w;
    return &base;
#endif
}

/* ---- the engine's own door ---- */

static bool is_valid(const thud_world *w, const td_rod_def *d) {
    const float values[] = {d->anchor_a.x, d->anchor_a.y, d->anchor_b.x, d->anchor_b.y};
    float most = 1e6f * w->unit;
    bool valid = d->length > 0.0f && d->length <= most;
    for (int i = 0; i < 4; i++) {
        valid = valid && values[i] >= -most && values[i] <= most;
    }
    return valid;
}

static bool gives_way(const thud_world *w, td_body_index body) {
    return td_body_at(w, body)->kind == THUD_DYNAMIC;
}

/* The static one of both, if there is one, comes first. */
static int add(thud_world *w, const td_rod_def *def, td_body_index a, td_body_index b) {
    bool swapped = td_body_at(w, b)->kind == THUD_STATIC;
    thud_vec2 first = swapped ? def->anchor_b : def->anchor_a;
    thud_vec2 second = swapped ? def->anchor_a : def->anchor_b;
    int index = td_constraint_create(w, TD_CONSTRAINT_ROD, swapped ? b : a, swapped ? a : b);
    int joint = td_constraint_at(w, index)->joint = td_slots_take(&w->joints);
    *(td_joint *)td_slot_at(&w->joints, joint) =
        (td_joint){.anchor = {{first.x, first.y}, {second.x, second.y}}, .length = def->length};
    w->kinds[TD_CONSTRAINT_ROD] = ops_of(w);
    w->joining = &td_joining;
    td_body_mark(w, a, TD_CHANGE_WAKE);
    td_body_mark(w, b, TD_CHANGE_WAKE);
    return index;
}

thud_result td_rod_create(thud_world *w, const td_rod_def *def, int *rod) {
    td_body_index a, b;
    int more[TD_CONSTRAINT_KINDS] = {[TD_CONSTRAINT_ROD] = 1};
    if (!w || !def) {
        return td_refuse(w, THUD_ERROR_NULL, "rod create: world or def is null");
    }
    thud_result result = td_find_body(w, def->body_a, &a);
    result = result == THUD_OK ? td_find_body(w, def->body_b, &b) : result;
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "rod create: not inside a callback");
    }
    if (td_same_body(a, b) || (!gives_way(w, a) && !gives_way(w, b))) {
        return td_refuse(w, THUD_ERROR_INVALID,
                         "rod create: needs two bodies, one of them dynamic");
    }
    if (!is_valid(w, def)) {
        return td_refuse(w, THUD_ERROR_INVALID, "rod create: anchors or length are out of range");
    }
    if (!td_slots_reserve(&w->memory, &w->joints, 1) || !td_constraints_reserve(w, more)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "rod create: out of memory");
    }
    int index = add(w, def, a, b);
    if (rod) {
        *rod = index;
    }
    return THUD_OK;
}

static bool is_rod(const thud_world *w, int index) {
    return w && index >= 0 && index < w->constraints.count && td_constraint_at(w, index)->live &&
           td_constraint_at(w, index)->kind == TD_CONSTRAINT_ROD;
}

thud_result td_rod_destroy(thud_world *w, int rod) {
    if (!is_rod(w, rod)) {
        return td_refuse(w, w ? THUD_ERROR_STALE : THUD_ERROR_NULL, "rod destroy: there is none");
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "rod destroy: not inside a callback");
    }
    for (int side = 0; side < 2; side++) {
        td_body_mark(w, td_constraint_at(w, rod)->body[side], TD_CHANGE_WAKE);
    }
    td_constraint_destroy(w, rod);
    return THUD_OK;
}

double td_rod_stretch(const thud_world *w, int rod) {
    if (!is_rod(w, rod)) {
        return 0.0;
    }
    const td_constraint *constraint = td_constraint_at(w, rod);
    const td_joint *joint = td_slot_at(&w->joints, constraint->joint);
    return (double)line_of(w, constraint).length - (double)joint->length;
}
