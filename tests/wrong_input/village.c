/* village.c: see village.h. */
#include "village.h"

#include <stdio.h>

/* The world's log: counts messages. */
static void listen(thud_result result, const char *message, void *context) {
    assert_int_not_equal(result, THUD_OK);
    assert_true(message && message[0]);
    ((village *)context)->told++;
}

static thud_shape_id add_line(thud_world *world, double x, double y, const thud_terrain *line) {
    thud_shape_def def = thud_default_shape_def();
    thud_shape_id shape;
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, x, y, 0), &def, line,
                                 &shape));
    return shape;
}

static void add_grounds(village *v) {
    const thud_pos hill[] = {{-20, 0}, {-5, 1}, {0, 4}, {6, 1}, {20, 0}};
    const thud_pos heights[] = {{0, 0}, {0, 1}, {0, 0}, {0, 1}, {0, 0}};
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = hill, .count = 5};
    v->hill = add_line(v->world, 200, 0, &line);
    line = (thud_terrain){
        .kind = THUD_TERRAIN_UNIFORM, .x0 = -8, .spacing = 4, .points = heights, .count = 5};
    v->dunes = add_line(v->world, 300, 0, &line);
    line = (thud_terrain){.kind = THUD_TERRAIN_FLAT, .slope = 0.1};
    v->plain = add_line(v->world, 0, -500, &line);
    add_ball(v->world, 203, 6, 0.5f);
    add_box(v->world, 300, 2, 0.5f, 0.5f);
    v->floor = add_floor(v->world, NULL);
}

/* Creates handles that are stale; their slots have new bodies. */
static void add_and_destroy(village *v) {
    v->gone = add_body(v->world, THUD_BODY_DYNAMIC, 0, 50, 0);
    v->gone_shape = add_shape(v->world, v->gone, 1, 0, false, NULL);
    run(v->world, 1);
    OK(thud_body_destroy(v->world, v->gone));
    run(v->world, 1);
}

void village_make(village *v, thud_world_def def) {
    *v = (village){.told = 0};
    def.log = listen;
    def.log_context = v;
    v->world = make_world(def);
    add_grounds(v);
    add_and_destroy(v);
    thud_shape_def bouncy = thud_default_shape_def(), sensor = thud_default_shape_def();
    bouncy.restitution = 1;
    sensor.sensor = true;
    v->ball = add_body(v->world, THUD_BODY_DYNAMIC, 0, 5, 0);
    v->ball_shape = add_shape(v->world, v->ball, 0.5f, 0, false, &bouncy);
    assert_int_equal(v->ball.index1, v->gone.index1);
    v->box = add_body(v->world, THUD_BODY_DYNAMIC, 3, 0.5, 0);
    v->box_shape = add_shape(v->world, v->box, 0.5f, 0.5f, false, NULL);
    for (int i = 1; i < 4; i++) {
        add_box(v->world, 3, 0.5 + i, 0.5f, 0.5f);
    }
    v->plank = add_body(v->world, THUD_BODY_DYNAMIC, 8, 0.25, 0);
    v->plank_shape = add_shape(v->world, v->plank, 2, 0.25f, true, NULL);
    add_shape(v->world, add_body(v->world, THUD_BODY_STATIC, 0, 1, 0), 1, 1, true, &sensor);
    v->lift = add_body(v->world, THUD_BODY_KINEMATIC, -6, 1, 0);
    add_shape(v->world, v->lift, 1, 0.25f, false, NULL);
    OK(thud_body_set_velocity(v->world, v->lift, (thud_vec2){0, 0.25f}, 0.5f));
    v->switched_off = add_box(v->world, 12, 0.5, 0.5f, 0.5f);
    OK(thud_body_set_enabled(v->world, v->switched_off, false));
    v->bare = add_body(v->world, THUD_BODY_DYNAMIC, 20, 300, 0);
    v->mover = thud_default_mover(
        (thud_geometry){.kind = THUD_SHAPE_CIRCLE, .x = -12, .y = 0.5, .c = 1, .hx = 0.4});
    run(v->world, 20);
}

/* The mover walks to and fro, so that it stays on the ground. */
void village_step(village *v) {
    OK(thud_world_step(v->world));
    float x = (thud_stats_of(v->world).steps / 32) & 1 ? 0.5f : -0.5f;
    OK(thud_mover_move(v->world, &v->mover, (thud_vec2){x, -2}, 1.0 / 60, NULL));
}

void village_free(village *v) {
    thud_world_destroy(v->world);
}

/* ---- as text ---- */

void village_body_text(const thud_world *world, thud_body_id body, char *out, size_t size) {
    thud_body_state s = state_of(world, body);
    int n =
        snprintf(out, size,
                 "body %u: kind %d at %a %a centre %a %a angle %a (%a %a) velocity %a %a %a "
                 "mass %a %a gravity %a awake %d enabled %d quarantined %d data %llu shapes %d\n",
                 body.index1, (int)s.kind, s.position.x, s.position.y, s.center.x, s.center.y,
                 s.angle, (double)s.cosine, (double)s.sine, (double)s.velocity.x,
                 (double)s.velocity.y, (double)s.angular_velocity, (double)s.mass,
                 (double)s.inertia, (double)s.gravity_scale, s.awake, s.enabled, s.quarantined,
                 (unsigned long long)s.user_data, s.shape_count);
    assert_in_range(n, 1, (int)size - 1);
}

static void shape_text(const thud_world *world, thud_shape_id shape, char *out, size_t size) {
    thud_shape_state s;
    OK(thud_shape_get_state(world, shape, &s));
    int n = snprintf(out, size,
                     "shape %u: kind %d of %u at %a %a half %a %a angle %a density %a friction %a "
                     "bounce %a speed %a filter %x %x %d sensor %d data %llu\n",
                     shape.index1, (int)s.kind, s.body.index1, (double)s.offset.x,
                     (double)s.offset.y, (double)s.half_extents.x, (double)s.half_extents.y,
                     s.angle, (double)s.density, (double)s.friction, (double)s.restitution,
                     (double)s.surface_speed, s.filter.category, s.filter.mask, s.filter.group,
                     s.sensor, (unsigned long long)s.user_data);
    assert_in_range(n, 1, (int)size - 1);
}

typedef struct text {
    char *at;
    size_t left;
} text;

#define SAY(t, ...)                                            \
    do {                                                       \
        int said_ = snprintf((t)->at, (t)->left, __VA_ARGS__); \
        assert_in_range(said_, 1, (int)(t)->left - 1);         \
        (t)->at += said_;                                      \
        (t)->left -= (size_t)said_;                            \
    } while (0)

static void say_line(text *t, const village *v, const char *name, thud_shape_id shape) {
    thud_terrain line;
    OK(thud_shape_get_terrain(v->world, shape, &line));
    SAY(t, "%s: kind %d slope %a from %a by %a:", name, (int)line.kind, line.slope, line.x0,
        line.spacing);
    for (int i = 0; i < line.count; i++) {
        SAY(t, " %a %a", line.points[i].x, line.points[i].y);
    }
    SAY(t, "\n");
}

static void say_world(text *t, const village *v) {
    thud_stats s = thud_stats_of(v->world);
    thud_measure m = thud_measure_of(v->world);
    thud_events e = thud_events_of(v->world);
    double limit;
    OK(thud_world_get_bisection_limit(v->world, &limit));
    SAY(t,
        "world: hash %llx steps %llu bodies %d shapes %d awake %d pairs %d contacts %d colours %d "
        "blocks %d bytes %llu allocations %llu\n",
        (unsigned long long)thud_hash_of(v->world), (unsigned long long)s.steps, s.bodies, s.shapes,
        s.awake_bodies, s.pairs, s.contacts, s.colours, s.blocks, (unsigned long long)s.bytes,
        (unsigned long long)s.step_allocations);
    SAY(t, "detection: impacts %d held %d %a unbisectable %d motions %d %d %d %d limit %a\n",
        s.impacts, s.held_bodies, s.held_seconds, s.unbisectable, s.motion_pairs, s.motion_circles,
        s.motion_boxes, s.motion_exact, limit);
    SAY(t, "measure: depth %a %a energy %a %a\n", m.penetration_max, m.penetration_mean,
        m.kinetic_energy, m.potential_energy);
    SAY(t, "events: %d %d %d %d %d %d\n", e.begin_count, e.end_count, e.sensor_begin_count,
        e.sensor_end_count, e.hit_count, e.quarantined_count);
}

static void say_mover(text *t, const thud_mover *m) {
    SAY(t, "mover: at %a %a ground %d %u %u normal %a %a point %a %a place %a %a turn %a %a\n",
        m->shape.x, m->shape.y, m->on_ground, m->ground_shape.index1, m->ground_body.index1,
        (double)m->ground_normal.x, (double)m->ground_normal.y, m->ground_point.x,
        m->ground_point.y, m->ground_place.x, m->ground_place.y, (double)m->ground_cosine,
        (double)m->ground_sine);
}

enum { SHAPES = 512 };

typedef struct shape_list {
    thud_shape_id at[SHAPES];
    int count;
} shape_list;

static bool list_shape(thud_shape_id shape, void *context) {
    shape_list *list = context;
    assert_true(list->count < SHAPES);
    list->at[list->count++] = shape;
    return true;
}

char *village_text(const village *v) {
    enum { SIZE = 1 << 19 };
    text t = {malloc(SIZE), SIZE};
    char *start = t.at;
    shape_list list = {.count = 0};
    thud_query_filter all = thud_default_query_filter();
    all.sensors = true;
    say_world(&t, v);
    OK(thud_world_overlap_aabb(v->world, (thud_pos){-1e6, -1e6}, (thud_pos){1e6, 1e6}, &all,
                               list_shape, &list));
    for (int i = 0; i < list.count; i++) {
        thud_shape_state state;
        char line[1024];
        shape_text(v->world, list.at[i], line, sizeof line);
        SAY(&t, "%s", line);
        OK(thud_shape_get_state(v->world, list.at[i], &state));
        village_body_text(v->world, state.body, line, sizeof line);
        SAY(&t, "%s", line);
    }
    char line[1024];
    village_body_text(v->world, v->switched_off, line, sizeof line);
    SAY(&t, "%s", line);
    village_body_text(v->world, v->bare, line, sizeof line);
    SAY(&t, "%s", line);
    say_line(&t, v, "hill", v->hill);
    say_line(&t, v, "dunes", v->dunes);
    say_line(&t, v, "plain", v->plain);
    say_mover(&t, &v->mover);
    return start;
}
