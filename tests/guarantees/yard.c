/* yard.c: see yard.h. */
#include "yard.h"

#include "driven.h"

#include <thud/thud_fields.h>
#include <thud/thud_joint.h>
#include <thud/thud_locks.h>
#include <thud/thud_rules.h>

/* Last: a yard's edits are recorded where a guarantee records its world. */
#include <thud/thud_recorded.h>

/* Categories of shapes, as bits of their filter: bodies have KINDS categories from FIRST_KIND on by
 * turns. */
enum { LINE = 7, FIRST_KIND = 2, KINDS = 3, PLATE_KIND = 16 };

thud_pos yard_origin(const yard *y) {
    double at = y->away * trial_unit(y->t);
    return (thud_pos){at, at};
}

/* A position of the world, from length scales within the yard. */
static thud_pos place(const yard *y, double x, double up) {
    thud_pos at = trial_place(y->t, x, up), origin = yard_origin(y);
    return (thud_pos){at.x + origin.x, at.y + origin.y};
}

/* Adds body i: its form and category depend on i, every fifth body bounces, every seventh is a
 * sensor. */
static void add_body(yard *y, int i, double x, double up) {
    trial *t = y->t;
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    float hx = (float)(draw(&y->random, 0.2, 0.45) * t->scale);
    float hy = (float)(draw(&y->random, 0.2, 0.45) * t->scale);
    def.kind = THUD_BODY_DYNAMIC;
    def.position = place(y, x, up);
    def.angle = i % 3 == 2 ? draw(&y->random, -1, 1) : 0.0;
    def.velocity = trial_speed(t, draw(&y->random, -3, 3), draw(&y->random, -3, 3));
    shape.restitution = i % 5 == 4 ? 0.7f : 0.0f;
    shape.sensor = i % 7 == 6;
    if (y->features & YARD_RULES) {
        shape.filter.category = (uint32_t)FIRST_KIND << i % KINDS;
    }
    DO(t, thud_body_create(y->world, &def, &y->body[i]));
    if (i % 3 == 0) {
        DO(t, thud_shape_create_circle(y->world, y->body[i], &shape, (thud_vec2){0, 0}, hx, NULL));
    } else if (i % 3 == 1) {
        DO(t, thud_shape_create_aabb(y->world, y->body[i], &shape, (thud_vec2){0, 0},
                                     (thud_vec2){hx, hy}, NULL));
    } else {
        DO(t, thud_shape_create_obb(y->world, y->body[i], &shape, (thud_vec2){hx * 0.2f, 0},
                                    (thud_vec2){hx, hy}, 0, NULL));
    }
}

static void add_box(yard *y, thud_body_id body, double x, double up, double hx, double hy,
                    uint32_t kind) {
    thud_shape_def shape = thud_default_shape_def();
    shape.filter.category = kind;
    DO(y->t, thud_shape_create_aabb(y->world, body, &shape, trial_speed(y->t, x, up),
                                    trial_speed(y->t, hx, hy), NULL));
}

static void add_floor(yard *y) {
    thud_body_def def = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_pos points[LINE];
    def.position = place(y, 0, 0);
    DO(y->t, thud_body_create(y->world, &def, &y->floor));
    for (int i = -3; i <= 3; i++) {
        add_box(y, y->floor, 2.0 * i, -1, 1, 1, 1);
    }
    add_box(y, y->floor, -7, 5, 2, 8, 1);
    add_box(y, y->floor, 7, 5, 2, 8, 1);
    add_box(y, y->floor, 0, 12, 7, 2, 1);
    for (int i = 0; i < LINE; i++) {
        points[i] = trial_place(y->t, i - 3.0, i % 2 ? 0.4 : 0.05);
    }
    DO(y->t, thud_body_create(y->world, &def, &y->ground));
    DO(y->t, thud_shape_create_terrain(
                 y->world, y->ground, &shape,
                 &(thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = LINE},
                 &y->line));
}

/* Adds a joint; its kind depends on i, and some have a drive or a limit. */
static void tie(yard *y, int i, thud_body_id a, thud_body_id b) {
    static const thud_joint_kind kinds[] = {THUD_JOINT_DISTANCE, THUD_JOINT_HINGE,
                                            THUD_JOINT_WHEEL,    THUD_JOINT_SLIDER,
                                            THUD_JOINT_FILTER,   THUD_JOINT_WELD,
                                            THUD_JOINT_TARGET};
    thud_joint_def def = thud_default_joint_def(kinds[i % 7]);
    def.body_a = a;
    def.body_b = b;
    def.frame_a.position = trial_speed(y->t, 0.5, 0.3);
    def.frame_b.position = trial_speed(y->t, -0.4, 0.1);
    def.length = (float)(1.5 * y->t->scale);
    if (i % 2 && is_driven(def.kind, THUD_DIRECTION_TURN)) {
        def.drive[THUD_DIRECTION_TURN].limited = true;
        def.drive[THUD_DIRECTION_TURN].lower = -1;
        def.drive[THUD_DIRECTION_TURN].upper = 0.5f;
    }
    if (def.kind == THUD_JOINT_WHEEL || def.kind == THUD_JOINT_TARGET) {
        def.drive[THUD_DIRECTION_ALONG].frequency = 3;
        def.drive[THUD_DIRECTION_ACROSS].frequency = def.kind == THUD_JOINT_TARGET ? 3 : 0;
    }
    DO(y->t, thud_joint_create(y->world, &def, NULL));
}

/* Sets a rule between two categories: `what` 0 lets them ignore each other, 1 gives them a surface,
 * 2 makes the plate one-way for other categories. */
static void rule_between(yard *y, int what, uint32_t first, uint32_t second) {
    thud_rule rule = thud_default_rule();
    rule.kind = what == 0 ? THUD_RULE_IGNORE : THUD_RULE_COLLIDE;
    if (what == 2 && first != second) {
        rule.kind = THUD_RULE_ONE_WAY;
    }
    rule.friction = 1.5f;
    rule.restitution = 0.5f;
    rule.surface_speed = (float)(0.5 * y->t->scale);
    rule.event_impulse = (float)(0.01 * y->t->scale * y->t->scale * y->t->scale);
    DO(y->t, thud_world_set_rule(y->world, first, second, &rule));
}

static void set_rules(yard *y) {
    rule_between(y, 0, FIRST_KIND, FIRST_KIND << 1);
    rule_between(y, 1, FIRST_KIND << 1, FIRST_KIND << 2);
    rule_between(y, 2, PLATE_KIND, FIRST_KIND | FIRST_KIND << 1 | FIRST_KIND << 2);
}

void yard_make(yard *y, trial *t, thud_world_def def, double away) {
    yard_make_with(y, t, def, away, YARD_TIED);
}

void yard_make_loose(yard *y, trial *t, thud_world_def def, double away) {
    yard_make_with(y, t, def, away, 0);
}

void yard_make_with(yard *y, trial *t, thud_world_def def, double away, unsigned features) {
    *y = (yard){.t = t,
                .away = away,
                .features = features,
                .random = {t->random.state ^ 0x5deece66du}};
    y->world = trial_make(t, def);
    if (!y->world) {
        return;
    }
    add_floor(y);
    for (int i = 0; i < YARD_BODIES; i++) {
        add_body(y, i, i % 4 * 2.2 - 3.5, 1.6 + i / 4 * 1.8);
    }
    thud_body_def plate = thud_default_body_def();
    plate.kind = THUD_BODY_KINEMATIC;
    plate.position = place(y, 0, 4);
    DO(t, thud_body_create(y->world, &plate, &y->plate));
    add_box(y, y->plate, 0, 0, 1, 0.2, features & YARD_RULES ? PLATE_KIND : 1);
    for (int i = 0; i < YARD_JOINTS && features & YARD_TIED; i++) {
        tie(y, i, i == 2 ? y->plate : y->body[i], y->body[i + 4]);
    }
    if (features & YARD_RULES) {
        set_rules(y);
    }
}

/* Rounds a position to 1/64 length scale. The last bits of a position that is read back as a double
 * depend on how far away the yard is. */
static thud_pos coarse(const yard *y, thud_pos at) {
    thud_pos origin = yard_origin(y);
    double scale = y->t->scale;
    return place(y, round((at.x - origin.x) / scale * 64) / 64,
                 round((at.y - origin.y) / scale * 64) / 64);
}

static void edit_body(yard *y, int what, thud_body_id body) {
    double x = draw(&y->random, -3, 3), up = draw(&y->random, 1.5, 8);
    thud_vec2 speed = trial_speed(y->t, draw(&y->random, -4, 4), draw(&y->random, -4, 4));
    thud_body_state state = {.mass = 0};
    DO(y->t, thud_body_get_state(y->world, body, &state));
    switch (what) {
    case 0:
        DO(y->t, thud_body_set_transform(y->world, body, place(y, x, up), 0));
        break;
    case 1:
        DO(y->t, thud_body_set_velocity(y->world, body, speed, 2));
        break;
    case 2:
        speed.x *= state.mass;
        speed.y *= state.mass;
        DO(y->t, thud_body_apply_impulse(y->world, body, speed, coarse(y, state.center)));
        break;
    case 3:
        DO(y->t, thud_body_set_enabled(y->world, body, !state.enabled));
        break;
    default:
        DO(y->t, thud_body_set_awake(y->world, body, !state.awake));
    }
}

void yard_edit(yard *y) {
    int i = draw_below(&y->random, YARD_BODIES), what = draw_below(&y->random, 40);
    double x = draw(&y->random, -2.5, 2.5);
    if (what < 5) {
        edit_body(y, what, y->body[i]);
    } else if (what == 5) {
        DO(y->t, thud_body_destroy(y->world, y->body[i]));
        add_body(y, i, x, 6);
    } else if (what == 6) {
        DO(y->t, thud_shape_dig(y->world, y->line, place(y, x, 0.4), (float)(0.4 * y->t->scale)));
    } else if (what == 7) {
        DO(y->t, thud_shape_raise(y->world, y->line, place(y, x, 0).x, 0.6 * y->t->scale,
                                  0.2 * y->t->scale));
    } else if (what == 8 && y->features & YARD_TIED) {
        tie(y, i, y->body[i], y->body[(i + 5) % YARD_BODIES]);
    } else if (what > 8 && what < 12 && y->features & YARD_TIED) {
        int axes = draw_below(&y->random, 4);
        DO(y->t, thud_body_set_locks(y->world, y->body[i], axes & 1, axes >> 1));
    } else if (what < 14 && y->features & YARD_RULES) {
        int kind = draw_below(&y->random, KINDS), other = draw_below(&y->random, KINDS);
        rule_between(y, draw_below(&y->random, 3), (uint32_t)FIRST_KIND << kind,
                     (uint32_t)FIRST_KIND << other);
    } else if (what < 16 && y->features & YARD_FIELDS) {
        thud_explosion blast = thud_default_explosion();
        blast.center = place(y, x, 2);
        blast.radius = y->t->scale;
        blast.falloff = 2 * y->t->scale;
        blast.impulse = (float)(y->t->scale * y->t->scale);
        DO(y->t, thud_world_explode(y->world, &blast, NULL));
    }
}

/* Applies fields before a step: each body gets one of four kinds, by its index. */
static void act(yard *y) {
    thud_water water = thud_default_water();
    float scale = (float)y->t->scale;
    water.point = place(y, 0, 2);
    water.density = 2;
    water.flow = trial_speed(y->t, 1, 0);
    for (int i = 0; i < YARD_BODIES; i++) {
        thud_body_id body = y->body[i];
        switch (i % 4) {
        case 0:
            DO(y->t, thud_body_apply_wind(y->world, body, trial_speed(y->t, 6, 1), 0.5f, 1, 0.5f));
            break;
        case 1:
            DO(y->t, thud_body_apply_buoyancy(y->world, body, &water));
            break;
        case 2:
            DO(y->t, thud_body_apply_grip(y->world, body, trial_speed(y->t, 0.1, 0),
                                          (thud_vec2){0.6f, 0.8f}, 0, scale * scale * scale));
            break;
        default:
            DO(y->t, thud_body_apply_rolling_resistance(y->world, body, 0.25f));
        }
    }
}

void yard_before_step(yard *y) {
    int period = trial_steps(y->t, 1.0);
    if (y->steps++ % period == 0) {
        double side = y->steps / period % 2 ? 1.0 : -1.0;
        DO(y->t, thud_body_set_velocity(y->world, y->plate, trial_speed(y->t, side, 0), 0));
    }
    yard_edit(y);
    if (y->features & YARD_FIELDS) {
        act(y);
    }
}

void yard_step(yard *y) {
    if (!trial_failed(y->t)) {
        yard_before_step(y);
        DO(y->t, thud_world_step(y->world));
    }
}

/* ---- digest of what the yard reports ---- */

void yard_mix(uint64_t *digest, const void *bytes, size_t count) {
    const unsigned char *at = bytes;
    for (size_t i = 0; i < count; i++) {
        *digest = (*digest ^ at[i]) * 0x100000001b3u;
    }
}

#define MIX(value) yard_mix(&digest, &(value), sizeof(value))

static uint64_t mix_pairs(uint64_t digest, const thud_contact_event *pairs, int count) {
    MIX(count);
    for (int i = 0; i < count; i++) {
        MIX(pairs[i].shape_a.index1);
        MIX(pairs[i].shape_b.index1);
    }
    return digest;
}

static uint64_t mix_events(uint64_t digest, const thud_world *world) {
    thud_events e = thud_events_of(world);
    digest = mix_pairs(digest, e.begin, e.begin_count);
    digest = mix_pairs(digest, e.end, e.end_count);
    digest = mix_pairs(digest, e.sensor_begin, e.sensor_begin_count);
    digest = mix_pairs(digest, e.sensor_end, e.sensor_end_count);
    for (int i = 0; i < e.sensor_begin_count; i++) {
        MIX(e.sensor_begin_time[i]);
    }
    for (int i = 0; i < e.sensor_end_count; i++) {
        MIX(e.sensor_end_time[i]);
    }
    for (int i = 0; i < e.hit_count; i++) {
        MIX(e.hit[i].shape_a.index1);
        MIX(e.hit[i].shape_b.index1);
        MIX(e.hit[i].normal);
        MIX(e.hit[i].speed);
    }
    return digest;
}

static uint64_t mix_impulses(uint64_t digest, const thud_world *world) {
    int count = 0;
    const thud_impulse_event *events = thud_impulse_events_of(world, &count);
    for (int i = 0; i < count; i++) {
        MIX(events[i].shape_a.index1);
        MIX(events[i].shape_b.index1);
        MIX(events[i].impulse);
    }
    return digest;
}

static uint64_t mix_report(uint64_t digest, const thud_world *world) {
    thud_step_error error = thud_step_error_of(world);
    thud_stats s = thud_stats_of(world);
    const int64_t counts[] = {s.bodies,      s.shapes,   s.awake_bodies,   s.pairs,
                              s.contacts,    s.substeps, s.direct_islands, s.factorings,
                              s.island_work, s.impacts,  s.held_bodies,    s.motion_pairs};
    MIX(error.penetration_max);
    MIX(error.penetration_mean);
    MIX(error.residual);
    MIX(error.overlaps);
    MIX(counts);
    return digest;
}

uint64_t yard_told(const yard *y) {
    uint64_t digest = 0xcbf29ce484222325u;
    int count = 0;
    const thud_pose *poses = thud_poses_of(y->world, yard_origin(y), 1.0, &count);
    for (int i = 0; i < count; i++) {
        if (poses[i].x == poses[i].x) { /* NaN: no body has the slot */
            MIX(poses[i]);
        }
    }
    for (int i = 0; i < YARD_BODIES; i++) {
        thud_body_state s = {.mass = 0};
        if (thud_body_get_state(y->world, y->body[i], &s) == THUD_OK) {
            MIX(s.velocity);
            MIX(s.angular_velocity);
            MIX(s.awake);
        }
    }
    digest = mix_impulses(mix_events(digest, y->world), y->world);
    return mix_report(digest, y->world);
}
