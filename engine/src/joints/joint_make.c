/* joint_make.c: creates joints (thud_joint.h), and the constraints that they consist of. */
#include "joints/gear.h"
#include "constraint/joint_hooks.h"
#include "direct/joint_islands.h"
#include "state/handles.h"

/* Whether a joint needs a part, by the directions that it locks and drives. */
static bool has_part(const td_joint *joint, int part) {
    unsigned driven = joint->driven;
    /* A joint that locks and drives nothing, such as a filter, still has the part for locked
     * directions, so that it is in its bodies' lists of constraints. */
    return part == TD_JOINT_LOCK ? joint->locked || !driven : driven >> part & 1u;
}

bool td_joint_reserve(thud_world *w, int kind) {
    int counts[TD_CONSTRAINT_KINDS] = {0};
    td_joint joint = {.kind = (uint8_t)kind};
    for (int i = 0; i < TD_JOINT_PARTS; i++) {
        counts[td_joint_part_kind(&joint, i)]++;
    }
    return td_constraints_reserve(w, counts);
}

static const td_joint_hooks joint_hooks = {.engage = td_joints_engage,
                                           .suspend = td_joints_suspend,
                                           .move_locks = td_joints_move_locks,
                                           .exclude_contact = td_joints_exclude_contact,
                                           .remove_part = td_joints_remove_part,
                                           .tie = td_joints_tie,
                                           .hold_back = td_joints_hold_back,
                                           .brace = td_joints_brace,
                                           .share_caps = td_joints_share_caps,
                                           .clear_yielded = td_joints_clear_yielded,
                                           .yield = td_joints_yield,
                                           .break_up = td_joints_break_up,
                                           .measure = td_joints_measure,
                                           .draw = td_joints_draw,
                                           .solve = td_island_solve_joints,
                                           .solve_tree = td_lock_tree_step,
                                           .solve_trees = td_lock_trees_step,
                                           .write_tree = td_lock_tree_write,
                                           .islands = &td_islands_of_joints};

/* Prepares a world for its first joint: sets the operations of the joints' constraint kinds, the
 * hooks, and the direct solver for joints. */
static void install_hooks(thud_world *w) {
    w->kinds[TD_CONSTRAINT_ROD] = td_rod_ops(w);
    w->kinds[TD_CONSTRAINT_LOCK] = td_lock_ops(w);
    for (int kind = TD_CONSTRAINT_DRIVE_LINE; kind <= TD_CONSTRAINT_DRIVE_TURN; kind++) {
        w->kinds[kind] = td_drive_ops(w, kind);
    }
    w->kinds[TD_CONSTRAINT_GEAR] = td_gear_ops(w);
    w->joint_hooks = &joint_hooks;
    if (w->quality.islands) {
        w->quality.islands = joint_hooks.islands;
    }
}

thud_result thud_world_use_joints(thud_world *w) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "use joints: not inside a callback");
    }
    install_hooks(w);
    return THUD_OK;
}

void td_joint_update_parts(thud_world *w, int index) {
    td_joint *joint = td_joint_at(w, index);
    td_joint_sort_directions(joint);
    for (int part = TD_JOINT_PARTS - 1; part >= 0; part--) {
        if (has_part(joint, part) && joint->part[part] == TD_NONE) {
            int kind = td_joint_part_kind(joint, part);
            int made = td_constraint_create(w, kind, joint->body[0], joint->body[1]);
            td_constraint_at(w, made)->joint = index;
            joint->part[part] = made;
        }
    }
    for (int part = 0; part < TD_JOINT_PARTS; part++) {
        if (!has_part(joint, part) && joint->part[part] != TD_NONE) {
            td_constraint_destroy(w, joint->part[part]);
        }
    }
    install_hooks(w);
    td_joint_wake(w, joint);
}

/* The dynamic body of one of a gear's joints, which becomes a side of the gear. */
static thud_result find_dynamic_body(const thud_world *w, thud_joint_id id, td_body_index *body) {
    int index = 0;
    thud_result result = td_find_joint(w, id, false, &index);
    if (result != THUD_OK) {
        return result;
    }
    const td_joint *joint = td_joint_at(w, index);
    if ((!td_gear_by_angle(joint) && joint->kind != THUD_JOINT_SLIDER &&
         joint->kind != THUD_JOINT_DISTANCE) ||
        td_body_at(w, joint->body[0])->kind != THUD_BODY_STATIC) {
        return td_refuse(
            w, THUD_ERROR_INVALID,
            "joint create: a gear is of hinges, wheels, sliders or distances with a static body");
    }
    *body = joint->body[1];
    return THUD_OK;
}

/* Finds the bodies of a joint's def. */
static thud_result find_sides(const thud_world *w, const thud_joint_def *def, td_body_index *a,
                              td_body_index *b) {
    if (def->kind == THUD_JOINT_GEAR) {
        thud_result result = find_dynamic_body(w, def->gear[0], a);
        return result == THUD_OK ? find_dynamic_body(w, def->gear[1], b) : result;
    }
    thud_result result = td_find_body(w, def->body_a, a);
    return result == THUD_OK ? td_find_body(w, def->body_b, b) : result;
}

/* Sets the two joints of a gear, and `rest` by their present coordinates. */
static void set_members(const thud_world *w, td_joint *gear, const thud_joint_def *def) {
    gear->gear = (td_gear){.ratio = def->ratio};
    for (int i = 0; i < 2; i++) {
        int member = (int)(def->gear[i].index1 - 1);
        gear->gear.joint[i] = member;
        gear->gear.generation[i] = td_joint_at(w, member)->generation;
    }
    td_gear_set_rest(w, gear);
}

thud_result thud_joint_create(thud_world *w, const thud_joint_def *def, thud_joint_id *out) {
    TD_IN_OWN_FLOAT_MODE;
    td_body_index a, b;
    if (!w || !def) {
        return td_refuse(w, THUD_ERROR_NULL, "joint create: world or def is null");
    }
    thud_result result = find_sides(w, def, &a, &b);
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "joint create: not inside a callback");
    }
    td_reason why;
    const char *error = td_joint_def_error(w, def, a, b, &why);
    if (error) {
        return td_refuse(w, THUD_ERROR_INVALID, error);
    }
    if (!td_slots_reserve(&w->memory, &w->joints, 1) || !td_joint_reserve(w, (int)def->kind)) {
        return td_refuse(w, THUD_ERROR_MEMORY, "joint create: out of memory");
    }
    int index = td_slots_take(&w->joints);
    td_joint *joint = td_joint_at(w, index);
    uint32_t generation = joint->generation;
    *joint = td_joint_of_def(w, def, a, b);
    joint->generation = generation;
    w->breakable += td_joint_breaks(joint);
    if (!joint->collides) {
        td_body_at(w, a)->passes |= td_passing_bit(b);
        td_body_at(w, b)->passes |= td_passing_bit(a);
    }
    if (joint->kind == THUD_JOINT_GEAR) {
        set_members(w, joint, def);
    }
    td_joint_update_parts(w, index);
    if (out) {
        *out = td_joint_handle(w, index);
    }
    for (int i = 0; i < TD_JOINT_DIRECTIONS; i++) {
        const thud_drive *drive = &def->drive[i];
        td_joint_warn_of_drive(w, drive);
        /* thud_joint_set_drive does not report this: a program may call it to turn limits off and
         * on again, with the same values of lower and upper. */
        if (!drive->limited && (drive->lower != 0.0f || drive->upper != 0.0f)) {
            td_refuse(w, THUD_OK, "joint create: lower and upper without `limited` limit nothing");
        }
    }
    return THUD_OK;
}
