/* wrong_worlds.c: world defs and settings of worlds that must be refused. */
#include <thud/thud_reads.h>
#include "wrong_input.h"

/* A world's log: counts messages. */
static void tell(thud_result result, const char *message, void *context) {
    assert_int_not_equal(result, THUD_OK);
    assert_true(message && message[0]);
    (*(int *)context)++;
}

/* An allocator that always fails. */
static void *no_memory(size_t bytes, void *context) {
    (void)bytes;
    (void)context;
    return NULL;
}

/* A release function without an effect. */
static void forget(void *block, size_t bytes, void *context) {
    (void)block;
    (void)bytes;
    (void)context;
}

/* Calls thud_world_advance; its callers pass an invalid time or number of steps. */
static thud_result step_forever(wrong_pair *p, double elapsed, int max_steps) {
    return thud_world_advance(p->here.world, elapsed, max_steps, &wrong_out.count,
                              &wrong_out.number);
}

/* thud_world_get_poses returns no result code: a refusal is null with count 0. */
static thud_result poses(thud_world *world, thud_pos origin, double alpha) {
    int count = 7;
    const thud_pose *got = thud_poses_of(world, origin, alpha, &count);
    if (got || count) {
        return THUD_OK;
    }
    return world ? THUD_ERROR_INVALID : THUD_ERROR_NULL;
}

void wrong_worlds(void **state) {
    wrong_pair *p = *state;
    thud_world_def def = thud_default_world_def();
    def.log = tell;
    def.log_context = &p->here.told;
    const thud_world_def good = def;
    thud_quality quality;
#define BAD(field, value) \
    def = good;           \
    def.field = (value);  \
    REFUSED(INVALID, thud_world_create(&def, &wrong_out.world))
#define BAD_QUALITY(field, value)   \
    quality = thud_quality_default; \
    quality.field = (value);        \
    BAD(quality, &quality)
    EACH(x, not_finite) {
        float f = (float)x;
        BAD(gravity.x, f);
        BAD(gravity.y, f);
        BAD(time_step, x);
        BAD(length_scale, f);
        BAD(contact_stiffness, f);
        BAD(contact_damping, f);
        BAD(push_speed, f);
        BAD(restitution_threshold, f);
        BAD(hit_speed, f);
        BAD(maximum_speed, f);
        BAD_QUALITY(contact_stiffness, f);
        BAD_QUALITY(contact_damping, f);
    }
    BAD(allocator, ((thud_allocator){.allocate = no_memory}));
    BAD(allocator, ((thud_allocator){.release = forget}));
    def.allocator = (thud_allocator){no_memory, forget, NULL};
    REFUSED(MEMORY, thud_world_create(&def, &wrong_out.world));
    BAD(time_step, 0);
    BAD(time_step, -1);
    BAD(time_step, 1.0001);
    BAD(length_scale, 0);
    BAD(length_scale, -1);
    BAD(length_scale, 9e-7f);
    BAD(length_scale, 2e6f);
    BAD(substeps, -1);
    BAD(substeps, 65);
    BAD(contact_stiffness, -0.1f);
    BAD(contact_stiffness, 0.009f);
    BAD(contact_stiffness, 0.51f);
    BAD(contact_damping, -1e-3f);
    BAD(contact_damping, 101);
    BAD(push_speed, -1);
    BAD(push_speed, 3e38f);
    BAD(restitution_threshold, -1);
    BAD(restitution_threshold, 3e38f);
    BAD(hit_speed, -1);
    BAD(hit_speed, 3e38f);
    BAD(maximum_speed, 0);
    BAD(maximum_speed, -1);
    BAD(maximum_speed, 1.1e6f);
    BAD(time_budget, NAN);
    BAD(time_budget, INFINITY);
    BAD(time_budget, -1);
    BAD(time_budget, 1.1);
    BAD(time_budget, 0.001); /* without a clock */
    BAD(job_system.workers, -1);
    BAD(job_system.workers, THUD_WORKERS_MAX + 1);
    BAD(job_system.workers, 2); /* without a function that runs them */
    BAD_QUALITY(substeps, 0);
    BAD_QUALITY(substeps, 65);
    BAD_QUALITY(contact_stiffness, 0.6f);
    BAD_QUALITY(contact_damping, -1);
    BAD_QUALITY(detection, NULL);
    BAD_QUALITY(overlap_limit, NAN);
    BAD_QUALITY(overlap_limit, -1);
    BAD_QUALITY(island_limit, 0);
#undef BAD_QUALITY
#undef BAD
    REFUSED_UNTOLD(NULL, thud_world_create(NULL, &wrong_out.world));
    def = good;
    def.log = NULL;
    REFUSED_UNTOLD(NULL, thud_world_create(&def, NULL));
    REFUSED(NULL, thud_world_create(&good, NULL));
}

void wrong_settings(void **state) {
    wrong_pair *p = *state;
    thud_world *w = p->here.world;
    const double not_a_step[] = {NAN, INFINITY, -INFINITY, 0, -0.0, -1e-3, 1.0001, 1e300};
    const double not_elapsed[] = {NAN, INFINITY, -INFINITY, -1e-300, -1, 1.1e9, 1e300};
    const double not_alpha[] = {NAN, INFINITY, -INFINITY, -1e-9, 1.000001};
    EACH(x, not_finite) {
        float f = (float)x;
        REFUSED(INVALID, thud_world_set_gravity(w, (thud_vec2){f, 0}));
        REFUSED(INVALID, thud_world_set_gravity(w, (thud_vec2){0, f}));
    }
    EACH(x, not_a_step) {
        REFUSED(INVALID, thud_world_set_time_step(w, x));
    }
    EACH(x, not_elapsed) {
        REFUSED(INVALID, step_forever(p, x, 1));
    }
    REFUSED(INVALID, step_forever(p, 1, 0));
    REFUSED(INVALID, step_forever(p, 1, -1));
    thud_quality bad[] = {thud_quality_default, thud_quality_default, thud_quality_default,
                          thud_quality_default, thud_quality_default, thud_quality_default};
    bad[0].substeps = 0;
    bad[1].contact_stiffness = 0.6f;
    bad[2].contact_damping = NAN;
    bad[3].detection = NULL;
    bad[4].overlap_limit = NAN;
    bad[5].island_limit = -1;
    for (int i = 0; i < COUNT(bad); i++) {
        REFUSED(INVALID, thud_world_set_quality(w, &bad[i]));
    }
    REFUSED(NULL, thud_world_set_quality(w, NULL));
    REFUSED(NULL, thud_world_get_bisection_limit(w, NULL));
    REFUSED_UNTOLD(NULL, thud_world_get_bisection_limit(NULL, &wrong_out.number));
    thud_broadphase_counts counts;
    REFUSED_UNTOLD(NULL, thud_world_get_broadphase_counts(w, NULL));
    REFUSED_UNTOLD(NULL, thud_world_get_broadphase_counts(NULL, &counts));
    REFUSED_UNTOLD(NULL, thud_world_set_quality(NULL, &thud_quality_default));
    REFUSED_UNTOLD(NULL, thud_world_set_gravity(NULL, (thud_vec2){0, 0}));
    REFUSED_UNTOLD(NULL, thud_world_set_time_step(NULL, 0.01));
    REFUSED_UNTOLD(NULL, thud_world_set_sleeping(NULL, false));
    REFUSED_UNTOLD(NULL, thud_world_set_log(NULL, NULL, NULL));
    REFUSED_UNTOLD(NULL, thud_world_step(NULL));
    REFUSED_UNTOLD(NULL, thud_world_advance(NULL, 1, 1, &wrong_out.count, &wrong_out.number));
    REFUSED_UNTOLD(NULL, thud_world_advance_with(NULL, 1, 1, NULL, NULL, NULL));
    EACH(x, not_finite) {
        REFUSED(INVALID, poses(w, (thud_pos){x, 0}, 0.5));
        REFUSED(INVALID, poses(w, (thud_pos){0, x}, 0.5));
    }
    EACH(x, not_alpha) {
        REFUSED(INVALID, poses(w, (thud_pos){0, 0}, x));
    }
    REFUSED_UNTOLD(NULL, poses(NULL, (thud_pos){0, 0}, 0.5));
    /* Functions without a result code return zeros. */
    thud_world_destroy(NULL);
    assert_int_equal(thud_events_of(NULL).begin_count, 0);
    assert_int_equal(thud_stats_of(NULL).bodies, 0);
    assert_true(thud_measure_of(NULL).kinetic_energy == 0);
    assert_true(thud_step_error_of(NULL).residual == 0);
    (void)thud_hash_of(NULL);
    assert_true(thud_stage_name((thud_stage)-1)[0] && thud_stage_name(THUD_STAGE_COUNT)[0]);
    assert_true(thud_result_text((thud_result)-1)[0] && thud_result_text((thud_result)99)[0]);
    assert_string_equal(thud_broadphase_name(NULL), "");
    assert_string_equal(thud_detection_name(NULL), "");
}
