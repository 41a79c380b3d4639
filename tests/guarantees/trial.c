/* trial.c: see trial.h. */
#include "trial.h"

#include "some_threads.h"

#include <thud/thud_snapshot.h>

#include <stdarg.h>
#include <stdio.h>

/* The seed depends on the settings too, so that each case has a scene of its own. */
void trial_begin(trial *t, const settings *set, uint64_t seed) {
    for (int d = 0; d < DIMENSIONS; d++) {
        seed = seed * VALUES_MAX + (uint64_t)set->value[d];
    }
    *t = (trial){.set = set,
                 .random = {(seed + 1) * 0x9e3779b97f4a7c15u | 1},
                 .scale = settings_scale(set),
                 .step = settings_step(set)};
}

void trial_end(trial *t) {
    for (int i = 0; i < t->worlds; i++) {
        thud_world_destroy(t->world[i]);
    }
    t->worlds = 0;
}

void trial_fault(trial *t, const char *format, ...) {
    if (!trial_failed(t)) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(t->fault, sizeof t->fault, format, arguments);
        va_end(arguments);
    }
}

void trial_expect(trial *t, thud_result got, thud_result wanted, const char *call) {
    if (got != wanted) {
        trial_fault(t, "%s: result %d, not %d", call, (int)got, (int)wanted);
    }
}

void trial_refused(trial *t, thud_result got, thud_result wanted, const char *call) {
    trial_expect(t, got, wanted, call);
    if (t->heard == 0 || t->heard_result != wanted) {
        trial_fault(t, "%s: the log did not hear of it", call);
    }
    t->heard = 0;
}

/* ---- worlds ---- */

/* The world's log: counts messages and keeps the last result. */
static void listen(thud_result result, const char *message, void *context) {
    trial *t = context;
    (void)message;
    t->heard++;
    t->heard_result = result;
}

static long shared_runs;

/* The pool's job system, with a count of its calls. */
static void run_shared(thud_task_fn *task, void *argument, int workers, void *context) {
    thud_job_system jobs = thud_job_system_of(context);
    shared_runs++;
    jobs.run(task, argument, workers, jobs.context);
}

long trial_shared_runs(void) {
    return shared_runs;
}

thud_job_system trial_jobs(int workers) {
    static thud_threads *threads;
    if (workers < 2) {
        return (thud_job_system){.workers = 1};
    }
    if (!threads) {
        threads = some_threads(2);
    }
    return (thud_job_system){.run = run_shared,
                             .context = threads,
                             .workers = 2,
                             .stages = &thud_shared_stages_all,
                             .share_from = 1};
}

thud_world_def trial_def(trial *t) {
    thud_world_def def = thud_default_world_def_of(settings_quality(t->set));
    def.detection = settings_detection(t->set);
    def.broadphase = settings_broadphase(t->set);
    def.sleeping = settings_sleeping(t->set);
    def.length_scale = (float)t->scale;
    def.gravity = trial_speed(t, 0, -10);
    def.time_step = t->step;
    def.job_system = trial_jobs(settings_workers(t->set));
    def.log = listen;
    def.log_context = t;
    return def;
}

thud_world_def trial_weightless(trial *t) {
    thud_world_def def = trial_def(t);
    def.gravity = (thud_vec2){0, 0};
    return def;
}

thud_world *trial_make(trial *t, thud_world_def def) {
    thud_world *world = NULL;
    DO(t, thud_world_create(&def, &world));
    if (world) {
        t->world[t->worlds++] = world;
    }
    return world;
}

void trial_listen(trial *t, thud_world *world, thud_prologue_fn *prologue,
                  thud_epilogue_fn *epilogue, void *context) {
    thud_listeners listeners = {.prologue = prologue, .epilogue = epilogue, .context = context};
    if (world) {
        DO(t, thud_world_set_listeners(world, &listeners));
    }
}

void trial_run(trial *t, thud_world *world, int steps) {
    for (int i = 0; i < steps && !trial_failed(t); i++) {
        DO(t, thud_world_step(world));
    }
}

int trial_steps(const trial *t, double seconds) {
    return (int)ceil(seconds / t->step - 1e-9);
}

trial_bytes trial_snapshot(trial *t, const thud_world *world) {
    trial_bytes s = {NULL, 0};
    DO(t, thud_world_get_snapshot_size(world, &s.size));
    s.bytes = malloc(s.size);
    DO(t, thud_world_snapshot(world, s.bytes, s.size, NULL));
    return s;
}

/* ---- bodies ---- */

double trial_unit(const trial *t) {
    return exp2(floor(log2(t->scale)));
}

thud_pos trial_place(const trial *t, double x, double y) {
    double fine = trial_unit(t) * 0x1p-20;
    return (thud_pos){round(x * t->scale / fine) * fine, round(y * t->scale / fine) * fine};
}

thud_vec2 trial_speed(const trial *t, double x, double y) {
    return (thud_vec2){(float)(x * t->scale), (float)(y * t->scale)};
}

thud_body_id trial_add(trial *t, thud_world *world, part p) {
    thud_body_def def = thud_default_body_def();
    thud_shape_def plain = thud_default_shape_def();
    const thud_shape_def *shape = p.shape ? p.shape : &plain;
    thud_body_id body = {0, 0};
    thud_vec2 half = {(float)(p.hx * t->scale), (float)(p.hy * t->scale)}, zero = {0, 0};
    def.kind = p.kind;
    def.position = trial_place(t, p.x, p.y);
    def.angle = p.angle;
    def.velocity = trial_speed(t, p.vx, p.vy);
    def.angular_velocity = (float)p.spin;
    def.detection = p.detection;
    DO(t, thud_body_create(world, &def, &body));
    if (p.form == BALL) {
        DO(t, thud_shape_create_circle(world, body, shape, zero, half.x, NULL));
    } else if (p.form == UPRIGHT) {
        DO(t, thud_shape_create_aabb(world, body, shape, zero, half, NULL));
    } else {
        DO(t, thud_shape_create_obb(world, body, shape, zero, half, 0, NULL));
    }
    return body;
}

thud_body_id trial_drop(trial *t, thud_world *world, form kind, double x, double y, double hx) {
    return trial_add(
        t, world,
        (part){.kind = THUD_BODY_DYNAMIC, .form = kind, .x = x, .y = y, .hx = hx, .hy = hx});
}

thud_body_id trial_wall(trial *t, thud_world *world, double x, double y, double hx, double hy) {
    return trial_add(t, world, (part){.form = UPRIGHT, .x = x, .y = y, .hx = hx, .hy = hy});
}

thud_shape_id trial_shape(trial *t, thud_world *world, thud_body_id body) {
    thud_shape_id shape = {0, 0};
    DO(t, thud_body_get_shapes(world, body, &shape, 1, NULL));
    return shape;
}

thud_body_state trial_state(trial *t, const thud_world *world, thud_body_id body) {
    thud_body_state s = {.kind = THUD_BODY_STATIC};
    DO(t, thud_body_get_state(world, body, &s));
    s.position.x /= t->scale;
    s.position.y /= t->scale;
    s.velocity.x /= (float)t->scale;
    s.velocity.y /= (float)t->scale;
    return s;
}

thud_geometry trial_placed(trial *t, const thud_world *world, thud_body_id body) {
    thud_body_state b = trial_state(t, world, body);
    thud_shape_id id = {0, 0};
    thud_shape_state s = {.kind = THUD_SHAPE_CIRCLE};
    DO(t, thud_body_get_shapes(world, body, &id, 1, NULL));
    DO(t, thud_shape_get_state(world, id, &s));
    return (thud_geometry){.kind = s.kind,
                           .x = b.position.x,
                           .y = b.position.y,
                           .c = s.kind == THUD_SHAPE_OBB ? (double)b.cosine : 1.0,
                           .s = s.kind == THUD_SHAPE_OBB ? (double)b.sine : 0.0,
                           .hx = (double)s.half_extents.x / t->scale,
                           .hy = (double)s.half_extents.y / t->scale};
}
