/* uses.c: see uses.h. */
#include "uses.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <thud/thud_forces.h>
#include <thud/thud_lists.h>
#include <thud/thud_queries.h>
#include <thud/thud_rules.h>

static const double TURNED = 1e-3;  /* rad */
static const double SLIDING = 0.05; /* length scales a second: what falls asleep is slower */
static const double RUBBING = 1e-3; /* of the normal impulse */
static const double UPRIGHT = 0.5;  /* of a contact normal along gravity: what lies on what */
enum { CONTACTS_MAX = 256 };        /* of a body that are looked at in a step */

/* What a body has done, by slot. */
typedef struct body_record {
    thud_body_id id;
    double angle; /* at first sight */
    bool turned, turned_box, bounced, slid, rubbed, slept;
} body_record;

/* A dynamic body in the present step, in the order of their heights. */
typedef struct stander {
    double height; /* against gravity */
    int slot;
} stander;

/* A contact in which one body lies on another. */
typedef struct support {
    int above, below; /* slots; below -1: it stands */
} support;

typedef struct counting {
    uses *out;
    const scene *scene;
    body_record *bodies;
    stander *standers;
    int *levels; /* bodies below, itself included, by slot */
    int slots;
    support *supports;
    int support_count, support_capacity;
    thud_manifold *contacts; /* of one body */
} counting;

static bool fail(const char *what) {
    fprintf(stderr, "thud-run: %s\n", what);
    return false;
}

/* Makes room for all slots. False if memory runs out. */
static bool make_room(counting *c, int slots) {
    if (slots <= c->slots)
        return true;
    size_t count = 2 * (size_t)slots;
    body_record *bodies = realloc(c->bodies, count * sizeof *bodies);
    c->bodies = bodies ? bodies : c->bodies;
    stander *standers = realloc(c->standers, count * sizeof *standers);
    c->standers = standers ? standers : c->standers;
    int *levels = realloc(c->levels, count * sizeof *levels);
    c->levels = levels ? levels : c->levels;
    if (!bodies || !standers || !levels)
        return false;
    memset(c->bodies + c->slots, 0, (count - (size_t)c->slots) * sizeof *bodies);
    c->slots = (int)count;
    return true;
}

static bool add_support(counting *c, int above, int below) {
    if (c->support_count == c->support_capacity) {
        int capacity = 2 * c->support_capacity + 256;
        support *grown = realloc(c->supports, (size_t)capacity * sizeof *grown);
        if (!grown)
            return false;
        c->supports = grown;
        c->support_capacity = capacity;
    }
    c->supports[c->support_count++] = (support){above, below};
    return true;
}

/* Adds to the totals what the body of a record did, and empties the record. */
static void settle(counting *c, body_record *record) {
    c->out->turned += record->turned;
    c->out->turned_boxes += record->turned_box;
    c->out->bounced += record->bounced;
    c->out->slid += record->slid;
    c->out->rubbed += record->rubbed;
    c->out->slept += record->slept;
    *record = (body_record){0};
}

static bool has_box(const thud_world *world, thud_body_id id) {
    thud_shape_id shapes[64];
    int count = 0;
    thud_body_get_shapes(world, id, shapes, 64, &count);
    for (int i = 0; i < count && i < 64; i++) {
        thud_shape_state shape;
        if (thud_shape_get_state(world, shapes[i], &shape) == THUD_OK &&
            shape.kind == THUD_SHAPE_OBB && !shape.sensor)
            return true;
    }
    return false;
}

/* The record of the body in a slot; a body that is new there settles the one before. */
static body_record *record_of(counting *c, thud_body_id id, double angle) {
    body_record *record = &c->bodies[id.index1 - 1];
    if (record->id.index1 != id.index1 || record->id.generation != id.generation) {
        settle(c, record);
        record->id = id;
        record->angle = angle;
    }
    return record;
}

/* The ratio of two masses, the larger over the smaller; 1 where one has none. */
static double ratio_of(double a, double b) {
    return a > 0 && b > 0 ? fmax(a / b, b / a) : 1;
}

/* The speed at which the surfaces of a contact pass each other. */
static double sliding_speed(const thud_world *world, const thud_manifold *m) {
    thud_vec2 a = {0, 0}, b = {0, 0};
    thud_body_get_velocity_at(world, m->body_a, m->point[0], &a);
    thud_body_get_velocity_at(world, m->body_b, m->point[0], &b);
    return fabs((double)(b.x - a.x) * m->normal.y - (double)(b.y - a.y) * m->normal.x);
}

/* Looks at a contact of a dynamic body. That of two dynamic bodies is seen from both, and counts
 * once. False if memory runs out. */
static bool count_contact(counting *c, thud_world *world, const thud_manifold *m,
                          body_record *record, const thud_body_state *body, bool is_b) {
    double normal = m->normal_impulse[0] + m->normal_impulse[1];
    if (m->point_count == 0 || !(normal > 0))
        return true;
    if (fabs(m->tangent_impulse) > RUBBING * normal)
        record->rubbed = true;
    if (sliding_speed(world, m) >= SLIDING * c->scene->length_scale)
        record->slid = true;
    thud_body_state other;
    thud_body_id other_id = is_b ? m->body_a : m->body_b;
    if (thud_body_get_state(world, other_id, &other) != THUD_OK)
        return true;
    bool pair = other.kind == THUD_BODY_DYNAMIC;
    if (pair)
        c->out->mass_ratio = fmax(c->out->mass_ratio, ratio_of(body->mass, other.mass));
    if (body->awake && (is_b || !pair)) {
        c->out->contacts++;
        c->out->direct_contacts += m->direct;
    }
    /* How far the normal, from the other body to this one, points against gravity. */
    double g = hypot(c->scene->gravity_x, c->scene->gravity_y), sign = is_b ? 1 : -1;
    double up =
        g > 0 ? -sign * (m->normal.x * c->scene->gravity_x + m->normal.y * c->scene->gravity_y) / g
              : 0;
    if (up < UPRIGHT)
        return true;
    return add_support(c, (int)record->id.index1 - 1, pair ? (int)other_id.index1 - 1 : -1);
}

static bool count_contacts(counting *c, thud_world *world, body_record *record,
                           const thud_body_state *body) {
    int count = 0;
    if (thud_body_get_contacts(world, record->id, c->contacts, CONTACTS_MAX, &count) != THUD_OK)
        return true;
    for (int i = 0; i < count && i < CONTACTS_MAX; i++) {
        const thud_manifold *m = &c->contacts[i];
        bool is_b = m->body_b.index1 == record->id.index1;
        if (!count_contact(c, world, m, record, body, is_b))
            return false;
    }
    return true;
}

static int lower_first(const void *a, const void *b) {
    double x = ((const stander *)a)->height, y = ((const stander *)b)->height;
    return (x > y) - (x < y);
}

static int by_above(const void *a, const void *b) {
    return ((const support *)a)->above - ((const support *)b)->above;
}

/* The largest number of bodies on top of each other: from the lowest body to the highest, each has
 * one more than the highest of those below it that it lies on. */
static void count_stack(counting *c, int count) {
    support none;
    support *supports = c->supports ? c->supports : &none; /* qsort and bsearch take no null */
    qsort(c->standers, (size_t)count, sizeof *c->standers, lower_first);
    qsort(supports, (size_t)c->support_count, sizeof *supports, by_above);
    memset(c->levels, 0, (size_t)c->slots * sizeof *c->levels);
    for (int i = 0; i < count; i++) {
        support key = {c->standers[i].slot, 0};
        const support *found =
            bsearch(&key, supports, (size_t)c->support_count, sizeof *supports, by_above);
        while (found && found > supports && found[-1].above == key.above)
            found--;
        int level = 0;
        for (; found && found < supports + c->support_count && found->above == key.above; found++) {
            int below = found->below < 0 ? 0 : c->levels[found->below];
            /* What hangs on nothing that stands is no stack. */
            if (found->below < 0 || below > 0)
                level = below + 1 > level ? below + 1 : level;
        }
        c->levels[key.above] = level;
        c->out->stack = level > c->out->stack ? level : c->out->stack;
    }
}

/* Looks at a dynamic body after a step. False if memory runs out. */
static bool count_body(counting *c, thud_world *world, thud_body_id id, const thud_body_state *body,
                       double limit) {
    body_record *record = record_of(c, id, body->angle);
    double turn = remainder(body->angle - record->angle, 6.283185307179586);
    if (!record->turned && fabs(turn) > TURNED) {
        record->turned = true;
        record->turned_box = has_box(world, id);
    }
    record->slept |= !body->awake;
    double speed = hypot(body->velocity.x, body->velocity.y);
    if (isfinite(limit) && limit > 0)
        c->out->speed = fmax(c->out->speed, speed / limit);
    return count_contacts(c, world, record, body);
}

/* The restitution of a pair: the larger of both, unless a rule says otherwise. */
static double restitution_of(const thud_world *world, const thud_shape_state *a,
                             const thud_shape_state *b) {
    uint32_t first = a->filter.category & (~a->filter.category + 1);
    uint32_t second = b->filter.category & (~b->filter.category + 1);
    thud_rule rule;
    bool is_set = false;
    if (first != 0 && second != 0 &&
        thud_world_get_rule(world, first, second, &rule, &is_set, NULL) == THUD_OK && is_set &&
        !isnan(rule.restitution))
        return rule.restitution;
    return fmax(a->restitution, b->restitution);
}

static void count_bounces(counting *c, const thud_world *world) {
    thud_events events = thud_events_of(world);
    for (int i = 0; i < events.hit_count; i++) {
        thud_shape_state shapes[2];
        if (thud_shape_get_state(world, events.hit[i].shape_a, &shapes[0]) != THUD_OK ||
            thud_shape_get_state(world, events.hit[i].shape_b, &shapes[1]) != THUD_OK ||
            !(restitution_of(world, &shapes[0], &shapes[1]) > 0))
            continue;
        for (int side = 0; side < 2; side++) {
            thud_body_state body;
            if (thud_body_get_state(world, shapes[side].body, &body) == THUD_OK &&
                body.kind == THUD_BODY_DYNAMIC)
                record_of(c, shapes[side].body, body.angle)->bounced = true;
        }
    }
}

/* Looks at all bodies; after a step also at what they met. False if memory runs out. */
static bool look(counting *c, thud_world *world) {
    int slots = 0, count = 0;
    double limit = INFINITY;
    thud_world_get_slot_counts(world, &slots, NULL);
    thud_world_get_bisection_limit(world, &limit);
    if (!make_room(c, slots))
        return false;
    c->support_count = 0;
    for (int i = 0; i < slots; i++) {
        thud_body_id id;
        thud_body_state body;
        if (thud_world_get_body_at(world, i, &id) != THUD_OK || id.index1 == 0 ||
            thud_body_get_state(world, id, &body) != THUD_OK || body.kind != THUD_BODY_DYNAMIC ||
            !body.enabled)
            continue;
        if (!count_body(c, world, id, &body, limit))
            return false;
        c->standers[count++] = (stander){-(body.position.x * c->scene->gravity_x +
                                           body.position.y * c->scene->gravity_y),
                                         i};
    }
    count_stack(c, count);
    return true;
}

/* A run_watch: before the first step. */
static bool on_built(thud_world *world, void *context) {
    counting *c = context;
    if (!look(c, world))
        return fail("out of memory");
    for (int i = 0; i < c->scene->joint_count; i++) {
        const scene_joint *joint = &c->scene->joints[i];
        thud_body_state sides[2];
        bool found = joint->kind != SCENE_GEAR;
        for (int side = 0; side < 2 && found; side++) {
            thud_body_id id;
            found = thud_world_get_body_at(world, joint->body[side], &id) == THUD_OK &&
                    thud_body_get_state(world, id, &sides[side]) == THUD_OK &&
                    sides[side].kind == THUD_BODY_DYNAMIC;
        }
        if (found)
            c->out->mass_ratio = fmax(c->out->mass_ratio, ratio_of(sides[0].mass, sides[1].mass));
    }
    return true;
}

static bool on_step(thud_world *world, const run_outcome *so_far, void *context) {
    counting *c = context;
    const thud_stats *stats = &so_far->stats;
    c->out->held += stats->held_bodies;
    c->out->held_steps += stats->held_bodies > 0;
    c->out->impacts += stats->impacts;
    c->out->direct_steps += stats->direct_islands > stats->soft_islands;
    count_bounces(c, world);
    return look(c, world) || fail("out of memory");
}

/* Counts what the scene has. */
static void list(const scene *s, uses *out) {
    static const thud_shape_kind KINDS[] = {
        [SCENE_CIRCLE] = THUD_SHAPE_CIRCLE,
        [SCENE_AABB] = THUD_SHAPE_AABB,
        [SCENE_OBB] = THUD_SHAPE_OBB,
        [SCENE_TERRAIN_FLAT] = THUD_SHAPE_TERRAIN,
        [SCENE_TERRAIN_UNIFORM] = THUD_SHAPE_TERRAIN,
        [SCENE_TERRAIN_IRREGULAR] = THUD_SHAPE_TERRAIN,
    };
    for (int i = 0; i < s->body_count; i++) {
        out->static_bodies += s->bodies[i].kind == SCENE_STATIC;
        out->kinematic_bodies += s->bodies[i].kind == SCENE_KINEMATIC;
        out->dynamic_bodies += s->bodies[i].kind == SCENE_DYNAMIC;
    }
    for (int i = 0; i < s->shape_count; i++) {
        out->shapes[KINDS[s->shapes[i].kind]]++;
        out->sensors += s->shapes[i].sensor;
    }
    for (int i = 0; i < s->joint_count; i++)
        out->joints[s->joints[i].kind]++;
    out->joint_count = s->joint_count;
    out->blasts = s->fields.blast_count;
    out->rules = s->fields.rule_count;
    out->water = s->fields.water_density > 0;
    out->wind = s->fields.air_density > 0;
    out->breaking = s->fields.breaks != 0;
}

bool uses_count(const run_options *options, const scene *s, run_outcome *outcome, uses *out) {
    *out = (uses){.mass_ratio = 1};
    list(s, out);
    counting c = {.out = out, .scene = s};
    run_watch watch = {.built = on_built, .stepped = on_step, .context = &c};
    c.contacts = malloc(CONTACTS_MAX * sizeof *c.contacts);
    bool done = c.contacts ? run_scene(options, s, &watch, outcome) : fail("out of memory");
    for (int i = 0; i < c.slots; i++)
        settle(&c, &c.bodies[i]);
    free(c.contacts);
    free(c.supports);
    free(c.levels);
    free(c.standers);
    free(c.bodies);
    return done;
}
