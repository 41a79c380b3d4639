/* stage.h: a built-in scene with its world at one of the qualities, for tests of what scenes
 * show. */
#ifndef THUD_TEST_STAGE_H
#define THUD_TEST_STAGE_H

#include "engine_support.h"

#include "act_thud.h"
#include "build_thud.h"
#include "scenes.h"

#include <thud/thud_snapshot.h>

/* A scene with its world and bodies. */
typedef struct stage {
    scene scene;
    thud_world *world;
    thud_body_id *bodies;
} stage;

/* Builds a scene's world; size 0: the scene's default size. */
static inline stage open_stage(const char *name, int size, const thud_quality *quality) {
    stage t;
    thud_world_def def = thud_default_world_def();
    def.quality = quality;
    assert_true(scenes_fill(scenes_find(name), size, &t.scene));
    t.bodies = malloc((size_t)t.scene.body_count * sizeof *t.bodies);
    OK(scene_build_thud(&t.scene, &def, &t.world, t.bodies, NULL));
    return t;
}

static inline void close_stage(stage *t) {
    thud_world_destroy(t->world);
    free(t->bodies);
    scene_free(&t->scene);
}

/* State of the body with this index in the scene's list. */
static inline thud_body_state body(const stage *t, int index) {
    return state_of(t->world, t->bodies[index]);
}

/* Runs the scene, and asserts that no body is lost: none is quarantined, and all end in the
 * camera's view or near it. */
static inline void run_whole(stage *t, int steps) {
    const scene *s = &t->scene;
    for (int i = 0; i < steps; i++) {
        OK(scene_step_thud(&s->fields, t->world));
        assert_int_equal(thud_events_of(t->world).quarantined_count, 0);
    }
    for (int i = 0; i < s->body_count; i++) {
        thud_body_state b = body(t, i);
        assert_true(fabs(b.position.x - s->camera_x) < 2 * fmax(s->camera_width, s->camera_height));
        assert_true(fabs(b.position.y - s->camera_y) < 2 * s->camera_height);
    }
}

/* Asserts that a world that is restored from the snapshot of another world of the same scene
 * continues with the same hashes. */
static inline void restored_goes_on(const char *name, int before, int after) {
    stage a = open_stage(name, 0, &thud_quality_default);
    stage b = open_stage(name, 0, &thud_quality_default);
    for (int i = 0; i < before; i++)
        OK(scene_step_thud(&a.scene.fields, a.world));
    size_t size;
    OK(thud_world_get_snapshot_size(a.world, &size));
    void *bytes = malloc(size);
    OK(thud_world_snapshot(a.world, bytes, size, NULL));
    OK(thud_world_restore(b.world, bytes, size));
    free(bytes);
    for (int i = 0; i < after; i++) {
        OK(scene_step_thud(&a.scene.fields, a.world));
        OK(scene_step_thud(&b.scene.fields, b.world));
    }
    assert_true(thud_hash_of(a.world) == thud_hash_of(b.world));
    close_stage(&a);
    close_stage(&b);
}

#endif
