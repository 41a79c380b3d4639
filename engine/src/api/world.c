/* world.c: creating and destroying worlds, checks of their def, and settings that can change later.
 * The tables ARRAYS and SLOTS list every array of thud_world: those of them are initialised and
 * freed in loops. */
#include "thud/thud_joint.h"
#include "thud/thud_rules.h"
#include "state/world.h"

#include "state/awake.h"
#include "state/body.h"
#include "detection/arrival_rows.h"
#include "detection/collide.h"
#include "state/handles.h"
#include "state/shared_stages.h"
#include "constraint/chunks.h"
#include "solver/quality.h"
#include "api/step.h"
#include "listeners/listener_hooks.h"
#include "rules/rule_hooks.h"
#include "textures/texture_hooks.h"

#include <stdatomic.h>
#include <string.h>

thud_world_def td_world_def_of(const thud_quality *quality) {
    return (thud_world_def) {
        .gravity = {0.0f, -10.0f}, .time_step = 1.0 / 60.0, .length_scale = 1.0f,
        .quality = quality, .push_speed = 3.0f, .restitution_threshold = 1.0f, .hit_speed = 1.0f,
        .maximum_speed = 1e6f, .contact_events = true,
#if !defined(NDEBUG)
        .log = thud_log_to_stderr,
#endif
        .cookie = TD_COOKIE,
    };
}

/* The largest power of two that is not above x > 0 (x with its fraction bits cleared): multiplying
 * by it is exact. */
static double power_below(double x) {
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    bits &= (uint64_t)0x7ff << 52;
    memcpy(&x, &bits, sizeof x);
    return x;
}

/* Whether each numeric field of the def is in its range; if not, `why` says which is not. */
static bool numbers_in(const thud_world_def *d, td_reason *why) {
    float max = THUD_SPEED_MAX;
    return td_float_in(why, "world def: gravity.x", d->gravity.x, -FLT_MAX, FLT_MAX) &&
           td_float_in(why, "world def: gravity.y", d->gravity.y, -FLT_MAX, FLT_MAX) &&
           td_above_0(why, "world def: time_step", d->time_step, THUD_TIME_STEP_MAX) &&
           td_float_in(why, "world def: length_scale", d->length_scale, THUD_LENGTH_SCALE_MIN,
                       THUD_LENGTH_SCALE_MAX) &&
           td_in(why, "world def: substeps", d->substeps, 0.0, THUD_SUBSTEPS_MAX) &&
           (d->contact_stiffness == 0.0f ||
            td_float_in(why, "world def: contact_stiffness", d->contact_stiffness,
                        THUD_CONTACT_STIFFNESS_MIN, THUD_CONTACT_STIFFNESS_MAX)) &&
           td_float_in(why, "world def: contact_damping", d->contact_damping, 0.0f,
                       THUD_CONTACT_DAMPING_MAX) &&
           td_float_in(why, "world def: push_speed", d->push_speed, 0.0f, max) &&
           td_float_in(why, "world def: restitution_threshold", d->restitution_threshold, 0.0f,
                       max) &&
           td_float_in(why, "world def: hit_speed", d->hit_speed, 0.0f, max) &&
           td_above_0(why, "world def: maximum_speed", (double)d->maximum_speed, (double)max) &&
           td_float_in(why, "world def: cell_size", d->cell_size, 0.0f,
                       THUD_SIZE_MAX * (float)power_below((double)d->length_scale)) &&
           td_in(why, "world def: time_budget", d->time_budget, 0.0, THUD_TIME_BUDGET_MAX) &&
           td_in(why, "world def: job_system.workers", d->job_system.workers, 0.0,
                 THUD_WORKERS_MAX);
}

/* The reason why the def is refused, or null. */
static const char *def_error(const thud_world_def *d, td_reason *why) {
    if (d->cookie != TD_COOKIE && d->cookie != TD_COOKIE_BASELINE) {
        return "world_create: the def does not start from thud_default_world_def()";
    }
    if (!numbers_in(d, why)) {
        return why->text;
    }
    if (!d->broadphase && !d->parts) {
        return "world def: broadphase is null, in a def of thud_default_small_world_def";
    }
    if (d->sleeping && !d->parts) {
        return "world def: sleeping, in a def of thud_default_small_world_def; thud_world_set_sleeping can set it";
    }
    if (!d->quality) {
        return "world def: quality is null";
    }
    const char *error = td_quality_error(d->quality, why);
    error = error ? error : td_check_max_error(d->max_error, d->quality, why);
    if (error) {
        return error;
    }
    if (d->time_budget > 0.0 && !d->clock) {
        return "world def: time_budget lacks a clock";
    }
    if (d->time_budget > 0.0 && !d->parts) {
        return "world def: time_budget, in a def of thud_default_small_world_def";
    }
    if (d->job_system.workers > 1 && !d->job_system.run) {
        return "world def: job_system.workers lacks a run";
    }
    if (!d->allocator.allocate != !d->allocator.release) {
        return "world def: the allocator lacks a function";
    }
    return NULL;
}

/* Whether this processor runs the AVX2 kernels; `baseline`: the def does not want them. */
static bool has_avx2(bool baseline) {
#if defined(TD_HAS_AVX2)
    return !baseline && __builtin_cpu_supports("avx2");
#else
    (void)baseline;
    return false;
#endif
}

/* The arrays of a world, with the type of their elements. */
#define ARRAY(name, element) TD_ARRAY_PLACE(thud_world, name, element)
#define BY_SLOT(name, element, is_state) ARRAY(name, element),
#define EVENTS(list)                                                                              \
    ARRAY(list.begin, thud_contact_event), ARRAY(list.end, thud_contact_event),                   \
        ARRAY(list.sensor_begin, thud_contact_event), ARRAY(list.sensor_end, thud_contact_event), \
        ARRAY(list.sensor_begin_time, float), ARRAY(list.sensor_end_time, float),                 \
        ARRAY(list.hit, thud_hit_event), ARRAY(list.quarantined, thud_body_id)

static const td_array_place ARRAYS[] = {
    TD_AWAKE_ARRAYS(BY_SLOT) ARRAY(pose, td_pose),
    ARRAY(proxy, td_shape_proxy),
    ARRAY(previous_fat, td_bounds),
    ARRAY(marks, uint8_t),
    ARRAY(moved, int),
    ARRAY(changed, td_body_index),
    ARRAY(deferred, td_deferred_edit),
    ARRAY(placed_bins, td_bins),
    ARRAY(poses, thud_pose),
    ARRAY(preview.shape, int),
    ARRAY(preview.proxy, td_shape_proxy),
    ARRAY(preview.number, int),
    ARRAY(scratch.found_shapes, int),
    ARRAY(scratch.near_rest, int),
    ARRAY(scratch.ahead, int),
    ARRAY(scratch.crowded, int),
    ARRAY(scratch.stamps, uint32_t),
    ARRAY(scratch.pairs, int[3]),
    ARRAY(scratch.bodies, td_body_index),
    ARRAY(scratch.constraints, int),
    ARRAY(scratch.blocks, td_block *),
    ARRAY(scratch.runs, td_run),
    ARRAY(scratch.separated, td_block *),
    ARRAY(scratch.chunks, td_chunk),
    ARRAY(scratch.chunk_order, int),
    ARRAY(scratch.phases, td_phase),
    ARRAY(scratch.bounds, int),
    ARRAY(scratch.begins, int),
    ARRAY(scratch.ends, int),
    ARRAY(scratch.parents, td_awake_slot),
    ARRAY(scratch.lane_bins, int),
    ARRAY(scratch.trajectories, td_trajectory),
    ARRAY(scratch.extra_candidates, td_toi_candidate),
    ARRAY(scratch.escaped, td_escaped_shape),
    ARRAY(scratch.arrivals, td_arrival),
    ARRAY(scratch.impacts, td_impact),
    ARRAY(scratch.test_list, td_block *),
    ARRAY(scratch.fast, td_awake_slot),
    ARRAY(scratch.odd, td_awake_slot),
    ARRAY(scratch.shares, td_share),
    ARRAY(scratch.order, int32_t),
    ARRAY(scratch.next_tied, td_awake_slot),
    ARRAY(scratch.before, float[4]),
    ARRAY(scratch.brace_groups, td_brace_group),
    ARRAY(scratch.legs, td_leg),
    ARRAY(scratch.first_legs, int),
    ARRAY(scratch.held_at, double),
    ARRAY(scratch.sensing, td_awake_slot),
    ARRAY(scratch.sensed.boxes, td_boxed),
    ARRAY(scratch.sensed.ends, int),
    EVENTS(events),
    EVENTS(published),
    ARRAY(broken, thud_joint_event),
    EVENTS(gathered.lists),
    ARRAY(gathered.broken, thud_joint_event),
    ARRAY(gathered.impulses, thud_impulse_event),
    ARRAY(force_records, td_force_record),
};
enum { ARRAY_COUNT = sizeof ARRAYS / sizeof *ARRAYS };

static const td_array_place SLOTS[] = {
    ARRAY(bodies, td_body),
    ARRAY(shapes, td_shape),
    ARRAY(joints, td_joint),
    ARRAY(constraints, td_contact),
    ARRAY(terrains, td_terrain_record),
};
enum { SLOTS_COUNT = sizeof SLOTS / sizeof *SLOTS };

/* Array i of SLOTS. */
static td_slots *slots_at(thud_world *w, int i) {
    return (td_slots *)((char *)w + SLOTS[i].at);
}

/* Initialises all arrays, empty, with the size of their elements. */
static void init_arrays(thud_world *w) {
    static_assert(sizeof *w <= UINT16_MAX, "offsets of arrays are 16 bits");
    td_arrays_init(w, ARRAYS, ARRAY_COUNT);
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        w->waiting[kind].stride = (int)sizeof(int);
    }
    for (int i = 0; i < SLOTS_COUNT; i++) {
        td_slots_init(slots_at(w, i), SLOTS[i].stride);
    }
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        td_slots_init(&w->pool[form], (int)td_form_bytes((td_block_form)form));
    }
}

/* Refuses to create a world, and passes the reason to the def's log, since there is no world yet.
 */
static thud_result refuse(const thud_world_def *def, thud_result result, const char *message) {
    if (def->log) {
        def->log(result, message, def->log_context);
    }
    return result;
}

thud_result thud_world_create(const thud_world_def *def, thud_world **out) {
    TD_IN_OWN_FLOAT_MODE;
    static const char no_memory[] = "world create: out of memory";
    static atomic_uint made;
    if (!def) {
        return THUD_ERROR_NULL;
    }
    if (!out) {
        return refuse(def, THUD_ERROR_NULL, "world create: out is null");
    }
    td_reason why;
    const char *error = def_error(def, &why);
    if (error) {
        return refuse(def, THUD_ERROR_INVALID, error);
    }
    td_memory memory = td_memory_make(def->allocator);
    thud_world *w = td_memory_get(&memory, sizeof *w);
    if (!w) {
        return refuse(def, THUD_ERROR_MEMORY, no_memory);
    }
    w->def = *def;
    w->memory = memory;
    w->sensor_hooks = def->parts ? def->parts->sensors : NULL;
    w->few_resting = def->parts ? def->parts->few_resting : NULL;
    w->error_hooks = def->parts ? def->parts->errors : NULL;
    w->sleep_hooks = def->parts ? def->parts->sleep : NULL;
    w->restitution_hooks = def->parts ? def->parts->restitution : NULL;
    w->number = atomic_fetch_add(&made, 1u) + 1u;
    w->wide = has_avx2(def->cookie == TD_COOKIE_BASELINE);
    if (!def->broadphase) {
        w->def.broadphase = def->parts->broadphase;
    }
    double unit = power_below((double)def->length_scale);
    w->length_scale = (float)unit;
    w->to_fixed = TD_FIXED_ONE / unit;
    w->to_coarse = TD_COARSE_ONE / unit;
    w->quantum = (float)(unit / TD_FIXED_ONE);
    w->thinnest_stale = true;
    init_arrays(w);
    td_event_queue_init(&w->scratch.queue);
    td_islands_init(&w->islands, w->wide);
    td_proxy_set_init(&w->awake_shapes);
    td_proxy_set_init(&w->rest_shapes);
    td_quality_begin(w);
    if (!td_awake_reserve(w, 0)) {
        thud_world_destroy(w);
        return refuse(def, THUD_ERROR_MEMORY, no_memory);
    }
    *out = w;
    return THUD_OK;
}

void thud_world_destroy(thud_world *w) {
    if (!w) {
        return;
    }
    if (w->locked || w->advancing) {
        td_refuse(w, THUD_ERROR_LOCKED, "world destroy: not inside a callback");
        return;
    }
    if (w->rule_hooks) {
        w->rule_hooks->end(w);
    }
    if (w->listener_hooks) {
        w->listener_hooks->end(w);
    }
    if (w->texture_hooks) {
        w->texture_hooks->end(w);
    }
    for (int i = 0; i < w->terrains.count; i++) {
        td_array_free(&w->memory, &td_terrain_record_at(w, i)->points);
    }
    td_arrays_free(&w->memory, w, ARRAYS, ARRAY_COUNT);
    td_array_free(&w->memory, &w->scratch.test_blocks); /* its elements have the size of the largest
                                                           block: narrowphase.c */
    for (int i = 0; i < SLOTS_COUNT; i++) {
        td_slots_free(&w->memory, slots_at(w, i));
    }
    for (int form = 0; form < TD_FORM_COUNT; form++) {
        td_slots_free(&w->memory, &w->pool[form]);
    }
    for (int kind = 0; kind < TD_CONSTRAINT_KINDS; kind++) {
        td_array_free(&w->memory, &w->waiting[kind]);
    }
    td_islands_free(&w->memory, &w->islands);
    td_event_queue_free(&w->memory, &w->scratch.queue);
    td_proxy_set_free(&w->memory, &w->awake_shapes);
    td_proxy_set_free(&w->memory, &w->rest_shapes);
    td_memory memory = w->memory;
    td_memory_put(&memory, w, sizeof *w);
}

/* ---- settings ---- */

thud_result thud_world_set_log(thud_world *w, thud_log_fn *log, void *context) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    w->def.log = log;
    w->def.log_context = context;
    return THUD_OK;
}

thud_result thud_world_set_gravity(thud_world *w, thud_vec2 gravity) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    thud_result result = td_check_finite(w, "set gravity: gravity", gravity.x, gravity.y, 0.0f);
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "set gravity: not inside a callback");
    }
    w->def.gravity = gravity;
    td_wake_all(w);
    return THUD_OK;
}

thud_result thud_world_set_time_step(thud_world *w, double time_step) {
    if (!w) {
        return THUD_ERROR_NULL;
    }
    thud_result result =
        td_check_above_0(w, "set time step: time_step", time_step, THUD_TIME_STEP_MAX);
    if (result != THUD_OK) {
        return result;
    }
    if (w->locked) {
        return td_refuse(w, THUD_ERROR_LOCKED, "set time step: not inside a callback");
    }
    w->def.time_step = time_step;
    w->drowsy_bodies = w->body_of.count; /* with a longer time step bodies may fall asleep in an
                                            earlier step than drowsy_bodies counts on */
    w->substep_gain_stale = true;
    return THUD_OK;
}
