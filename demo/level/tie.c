/* tie.c: adds a map's joints to the scene, after the whole map is read. */
#include "reader.h"

#include <math.h>
#include <stdlib.h>

/* Radians per degree. */
static const double RADIANS = 0.017453292519943295;

void level_place_body(level_reader *r, uint32_t id, double rotation) {
    if (r->placed_count == r->placed_capacity) {
        int wanted = r->placed_capacity ? 2 * r->placed_capacity : 64;
        level_placed *grown = realloc(r->placed, (size_t)wanted * sizeof *grown);
        if (!grown) {
            r->s->failed = true;
            return;
        }
        r->placed = grown;
        r->placed_capacity = wanted;
    }
    r->placed[r->placed_count++] =
        (level_placed){.id = id, .index = r->s->body_count - 1, .rotation = rotation};
}

/* ---- objects by their ids ---- */

/* Compares by id; bodies of one object by the order in which they were made. */
static int compare_placed(const void *a, const void *b) {
    const level_placed *p = a, *q = b;
    if (p->id != q->id)
        return p->id < q->id ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

/* The first entry of an id in a sorted list; null if it has none. */
static const level_placed *find(const level_placed *sorted, int count, uint32_t id) {
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (sorted[middle].id < id)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && sorted[low].id == id ? &sorted[low] : NULL;
}

/* ---- joints of bodies ---- */

/* Reports a problem of a joint. */
static void complain(const level_reader *r, const level_joint *o, const char *what) {
    level_problem_add(r->report, LEVEL_SKIP, o->id, "a %s %s", level_joint_name(o->joint.kind),
                      what);
}

/* Reports that the object `id`, which property `which` of the joint refers to, is no `what`
 * ("body", "joint"). False, without a report, if it was found or id is 0. */
static bool is_missing(const level_reader *r, const level_joint *o, const level_placed *found,
                       char which, uint32_t id, const char *what) {
    if (found || id == 0)
        return false;
    level_problem_add(r->report, LEVEL_SKIP, o->id, "%c refers to object %u, which is no %s", which,
                      id, what);
    return true;
}

/* Whether the engine accepts a joint of these bodies. False after a report. */
static bool may_tie(const level_reader *r, const level_joint *o, const level_placed *a,
                    const level_placed *b) {
    bool a_moves = a && r->s->bodies[a->index].kind == SCENE_DYNAMIC;
    bool b_moves = r->s->bodies[b->index].kind == SCENE_DYNAMIC;
    bool of_b = o->joint.kind == SCENE_WHEEL || o->joint.kind == SCENE_TARGET;
    if (of_b && !b_moves)
        complain(r, o, "needs a b that is dynamic");
    else if (!a_moves && !b_moves)
        complain(r, o, "needs one dynamic body, a or b");
    else
        return true;
    return false;
}

/* Sets the frame of a side of a joint relative to its body; without a body, at the origin, with the
 * axis in the world. False if it is further from the body than the engine accepts. */
static bool set_frame(const level_reader *r, const level_joint *o, int side,
                      const level_placed *placed, scene_joint *joint) {
    double c, s, axis = 0.0 - level_turn(o->rotation, &c, &s) * RADIANS;
    joint->x[side] = joint->y[side] = 0;
    joint->angle[side] = axis;
    if (!placed)
        return true;
    const scene_body *body = &r->s->bodies[placed->index];
    scene_point place = level_joint_place(r, o, side);
    double dx = place.x - body->x, dy = place.y - body->y;
    level_turn(placed->rotation, &c, &s);
    joint->x[side] = c * dx - s * dy;
    joint->y[side] = s * dx + c * dy;
    joint->angle[side] = axis - body->angle;
    return level_joint_fits(r, joint->x[side]) && level_joint_fits(r, joint->y[side]);
}

/* Adds the static body without shapes, at the joint's place, that a joint to the world is tied to.
 * Returns its index. */
static int add_anchor(level_reader *r, const level_joint *o) {
    scene_body *anchor = scene_add_body(r->s, SCENE_STATIC, o->x[0] / r->pixels_per_unit,
                                        (r->map_height - o->y[0]) / r->pixels_per_unit);
    anchor->id = o->id;
    return r->s->body_count - 1;
}

/* Adds a joint between two bodies, or reports why not. */
static void tie(level_reader *r, level_joint *o) {
    const level_placed *a = find(r->placed, r->placed_count, o->a);
    const level_placed *b = find(r->placed, r->placed_count, o->b);
    bool missing = is_missing(r, o, a, 'a', o->a, "body");
    if (is_missing(r, o, b, 'b', o->b, "body") || missing || !may_tie(r, o, a, b))
        return;
    scene_point place = level_joint_place(r, o, 0);
    if (!a && !level_place_fits(r, place.x, place.y)) {
        complain(r, o, "is " LEVEL_TOO_FAR);
        return;
    }
    scene_joint joint = o->joint;
    bool near = set_frame(r, o, 0, a, &joint);
    if (!set_frame(r, o, 1, b, &joint) || !near) {
        complain(r, o, "is too far from its bodies");
        return;
    }
    joint.body[0] = a ? a->index : add_anchor(r, o);
    joint.body[1] = b->index;
    o->made = r->s->joint_count;
    *scene_tie(r->s, joint.kind, joint.body[0], joint.body[1], 0, 0, 0) = joint;
}

/* ---- gears, of joints ---- */

/* The index of the body that a joint moves relative to a static one, so that a gear can tie it to
 * another joint; -1 if the joint is none of that kind. */
static int moved_by(const level_reader *r, const level_joint *o) {
    const scene_joint *joint = &r->s->joints[o->made];
    bool valued = joint->kind == SCENE_HINGE || joint->kind == SCENE_WHEEL ||
                  joint->kind == SCENE_SLIDER || joint->kind == SCENE_DISTANCE;
    scene_body_kind a = r->s->bodies[joint->body[0]].kind, b = r->s->bodies[joint->body[1]].kind;
    if (valued && a == SCENE_STATIC)
        return joint->body[1];
    return valued && b == SCENE_STATIC ? joint->body[0] : -1;
}

/* Adds a gear between two joints, or reports why not. `sorted` has all joints that were added, by
 * id. */
static void mesh(level_reader *r, const level_joint *o, const level_placed *sorted, int count) {
    const level_placed *a = find(sorted, count, o->a), *b = find(sorted, count, o->b);
    bool missing = is_missing(r, o, a, 'a', o->a, "joint");
    if (is_missing(r, o, b, 'b', o->b, "joint") || missing)
        return;
    const level_joint *first = &r->joints[a->index], *second = &r->joints[b->index];
    int of_first = moved_by(r, first), of_second = moved_by(r, second);
    if (of_first < 0 || of_second < 0) {
        complain(r, o,
                 "needs two joints, each a hinge, a wheel, a slider or a distance between a body "
                 "that is static and one that is dynamic");
    } else if (of_first == of_second) {
        complain(r, o, "needs joints of two bodies");
    } else {
        scene_joint *gear = scene_tie_gear(r->s, first->made, second->made, o->joint.ratio);
        gear->collide_connected = o->joint.collide_connected;
        gear->break_force = o->joint.break_force;
        gear->break_torque = o->joint.break_torque;
    }
}

/* Adds all gears. */
static void mesh_all(level_reader *r) {
    level_placed *made = malloc((size_t)r->joint_count * sizeof *made);
    int count = 0;
    if (!made) {
        r->s->failed = true;
        return;
    }
    for (int i = 0; i < r->joint_count; i++)
        if (r->joints[i].made >= 0)
            made[count++] = (level_placed){.id = r->joints[i].id, .index = i};
    qsort(made, (size_t)count, sizeof *made, compare_placed);
    for (int i = 0; i < r->joint_count; i++)
        if (r->joints[i].joint.kind == SCENE_GEAR)
            mesh(r, &r->joints[i], made, count);
    free(made);
}

void level_tie_joints(level_reader *r) {
    if (r->joint_count == 0 || r->s->failed)
        return;
    if (r->placed_count > 0)
        qsort(r->placed, (size_t)r->placed_count, sizeof *r->placed, compare_placed);
    for (int i = 0; i < r->joint_count; i++) {
        r->joints[i].made = -1;
        if (r->joints[i].joint.kind != SCENE_GEAR)
            tie(r, &r->joints[i]);
    }
    mesh_all(r);
}
