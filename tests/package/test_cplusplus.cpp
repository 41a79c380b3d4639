// test_cplusplus.cpp: includes every public header in C++, and builds, steps and queries a world,
// to test that functions are linked with C names.
#include <thud/thud.h>
#include <thud/thud_all.h>
#include <thud/thud_casts.h>
#include <thud/thud_detection.h>
#include <thud/thud_draw.h>
#include <thud/thud_edits.h>
#include <thud/thud_events.h>
#include <thud/thud_fields.h>
#include <thud/thud_forces.h>
#include <thud/thud_hooks.h>
#include <thud/thud_ids.h>
#include <thud/thud_joint.h>
#include <thud/thud_limits.h>
#include <thud/thud_listeners.h>
#include <thud/thud_lists.h>
#include <thud/thud_make.h>
#include <thud/thud_math.h>
#include <thud/thud_minkowski.h>
#include <thud/thud_mover.h>
#include <thud/thud_quality.h>
#include <thud/thud_queries.h>
#include <thud/thud_reads.h>
#include <thud/thud_rollback.h>
#include <thud/thud_rules.h>
#include <thud/thud_geometry.h>
#include <thud/thud_snapshot.h>
#include <thud/thud_terrain.h>
#include <thud/thud_threads.h>
#include <thud/thud_version.h>
#include <thud/thud_volumes.h>

#include <cstdio>

static int failures;

static void expect(bool holds, const char *what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %s\n", what);
        failures++;
    }
}
#define EXPECT(condition) expect((condition), #condition)

static void ball_falls_onto_floor(thud_world *world) {
    thud_body_def body = thud_default_body_def();
    thud_shape_def shape = thud_default_shape_def();
    thud_body_id floor, ball;
    body.position = thud_pos{0, -1};
    EXPECT(thud_body_create(world, &body, &floor) == THUD_OK);
    EXPECT(thud_shape_create_aabb(world, floor, &shape, thud_vec2{0, 0}, thud_vec2{10, 1},
                                  nullptr) == THUD_OK);
    body.kind = THUD_BODY_DYNAMIC;
    body.position = thud_pos{0, 2};
    EXPECT(thud_body_create(world, &body, &ball) == THUD_OK);
    EXPECT(thud_shape_create_circle(world, ball, &shape, thud_vec2{0, 0}, 0.5f, nullptr) ==
           THUD_OK);
    for (int i = 0; i < 120; i++) {
        EXPECT(thud_world_step(world) == THUD_OK);
    }
    thud_body_state state;
    EXPECT(thud_body_get_state(world, ball, &state) == THUD_OK);
    EXPECT(state.position.y > 0.49 && state.position.y < 0.51);
    EXPECT(thud_body_set_velocity(world, thud_body_id{0, 0}, thud_vec2{0, 0}, 0) ==
           THUD_ERROR_STALE);
    bool hit = false;
    thud_ray ray = {thud_pos{0, 5}, 0, -9, nullptr};
    EXPECT(thud_world_cast_ray(world, &ray, &hit, nullptr) == THUD_OK);
    EXPECT(hit);
    thud_body_options light = {};
    light.kind = THUD_BODY_DYNAMIC;
    light.density = 0.5f;
    EXPECT(thud_position_of(world, thud_body_make(world, thud_aabb_at(9, 9, 1, 1), &light)).x == 9);
    thud_event_pair met = {};
    EXPECT(!thud_world_next_event_pair(world, 2, 2, &met));
    int bodies = 0;
    EXPECT(thud_world_get_bodies(world, nullptr, 0, &bodies) == THUD_OK);
    EXPECT(bodies == 3);
}

static void geometry_answers(thud_world *world) {
    thud_geometry disc = {THUD_SHAPE_CIRCLE, 0, 3, 1, 0, 0.5, 0};
    thud_minkowski sum;
    EXPECT(thud_minkowski_sum(&disc, &disc, &sum) == THUD_OK);
    thud_volume around;
    EXPECT(thud_volume_around_shape(THUD_SHAPE_AABB, &disc, &around) == THUD_OK);
    thud_mover mover = thud_default_mover(disc);
    EXPECT(thud_mover_move(world, &mover, thud_vec2{1, -1}, 1.0 / 60, nullptr) == THUD_OK);
    thud_uv uv[2] = {{0, 0}, {1, 1}}, at;
    thud_terrain flat = {THUD_TERRAIN_FLAT, 0, 0, 0, nullptr, 0};
    thud_terrain_sample sample;
    EXPECT(thud_terrain_sample_at(&flat, 0.25, &sample) == THUD_OK);
    EXPECT(thud_terrain_texture_at(&sample, uv, 2, &at) == THUD_OK);
    thud_debug_draw nothing = {};
    EXPECT(thud_world_draw(world, &nothing) == THUD_OK);
}

int main() {
    thud_world_def def = thud_default_world_def();
    def.quality = &thud_quality_high;
    def.detection = &thud_detection_swept;
    def.broadphase = &thud_broadphase_sweep;
    thud_world *world = nullptr;
    EXPECT(thud_world_create(&def, &world) == THUD_OK);
    if (world) {
        ball_falls_onto_floor(world);
        geometry_answers(world);
    }
    thud_world_destroy(world);
    return failures;
}
