/* api_world.c: exports that create, step and destroy worlds, and their settings, statistics, errors
 * and poses. api.h has the conventions. */
#include "api.h"
#include <thud/thud_reads.h>

#include <string.h>

/* Import of the module: the host's clock, seconds. */
extern double thud_clock(void);
/* Import of the module: called before (after = 0) and after each step of api_world_advance. */
extern void thud_stepped(const thud_world *world, int after);

/* The last message that thud logged, cut to its size; "" after JavaScript has read it. */
static char last_message[256];

static double read_clock(void *context) {
    (void)context;
    return thud_clock();
}

/* The thud_log_fn of all worlds. */
static void keep_message(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    size_t length = strlen(message), room = sizeof last_message - 1;
    if (length > room)
        length = room;
    memcpy(last_message, message, length); /* snprintf would add 8 kB to the module */
    last_message[length] = '\0';
}

int api_refuse(const char *message) {
    keep_message(THUD_ERROR_INVALID, message, NULL);
    return THUD_ERROR_INVALID;
}

/* The address of the message that says why the last call failed. JavaScript clears it by writing a
 * 0 byte there. */
char *api_last_message(void) {
    return last_message;
}

const thud_detection *api_detection(double number) {
    static const thud_detection *const all[] = {&thud_detection_overlap, &thud_detection_continuous,
                                                &thud_detection_bisect, &thud_detection_swept};
    int i = api_to_int(number);
    return i >= 0 && i < 4 ? all[i] : NULL;
}

/* The quality of an index into QUALITIES of web/package/src/types.ts; null, which the engine
 * refuses, for other numbers. */
static const thud_quality *api_quality(double number) {
    static const thud_quality *const all[] = {&thud_quality_draft, &thud_quality_default,
                                              &thud_quality_high, &thud_quality_exact};
    int i = api_to_int(number);
    return i >= 0 && i < 4 ? all[i] : NULL;
}

/* A quality with changes (see quality_options); valid until the next call. */
static const thud_quality *changed_quality(double number, const struct quality_options *changes) {
    static thud_quality quality;
    if (api_quality(number) == NULL)
        return NULL;
    quality = *api_quality(number);
    if (changes->substeps != 0.0)
        quality.substeps = api_to_int(changes->substeps);
    if (changes->contact_stiffness != 0.0)
        quality.contact_stiffness = (float)changes->contact_stiffness;
    if (changes->contact_damping != 0.0)
        quality.contact_damping = (float)changes->contact_damping;
    if (changes->detection >= 0.0)
        quality.detection = api_detection(changes->detection);
    if (changes->islands == 0.0) {
        quality.islands = NULL;
        quality.island_limit = 1; /* else bisect and swept bring an island solver */
    }
    if (changes->islands == 1.0 && quality.islands == NULL) {
        quality.islands = thud_quality_default.islands;
        quality.overlap_limit = thud_quality_default.overlap_limit;
        quality.island_limit = thud_quality_default.island_limit;
        quality.island_work = thud_quality_default.island_work;
        quality.island_slow_steps = thud_quality_default.island_slow_steps;
    }
    return &quality;
}

/* The broadphase of an index into BROADPHASES of web/package/src/types.ts. */
static const thud_broadphase *api_broadphase(double number) {
    static const thud_broadphase *const all[] = {
        &thud_broadphase_grid,    &thud_broadphase_sweep,        &thud_broadphase_all,
        &thud_broadphase_sweep_y, &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
    int i = api_to_int(number);
    return i >= 0 && i < (int)(sizeof all / sizeof *all) ? all[i] : NULL;
}

/* Slots out: world_options. */
void api_world_defaults(void) {
    thud_world_def def = thud_default_world_def();
    struct world_options *s = &api_slots.world_options;
    s->gravity[0] = def.gravity.x;
    s->gravity[1] = def.gravity.y;
    s->time_step = def.time_step;
    s->length_scale = def.length_scale;
    s->quality = 1.0; /* default */
    s->substeps = def.substeps;
    s->contact_stiffness = def.contact_stiffness;
    s->contact_damping = def.contact_damping;
    s->push_speed = def.push_speed;
    s->restitution_threshold = def.restitution_threshold;
    s->hit_speed = def.hit_speed;
    s->maximum_speed = def.maximum_speed;
    s->sleeping = def.sleeping;
    s->detection = -1.0; /* the quality's */
    s->contact_events = def.contact_events;
    s->timed = 0.0;
    s->broadphase = 0.0; /* grid */
    s->time_budget = def.time_budget;
    s->max_error = def.max_error;
    s->cell_size = def.cell_size;
    s->changes = (struct quality_options){.detection = -1.0, .islands = -1.0};
}

thud_world_def api_world_def(void) {
    const struct world_options *s = &api_slots.world_options;
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){(float)s->gravity[0], (float)s->gravity[1]};
    def.time_step = s->time_step;
    def.length_scale = (float)s->length_scale;
    def.quality = changed_quality(s->quality, &s->changes);
    def.substeps = api_to_int(s->substeps);
    def.contact_stiffness = (float)s->contact_stiffness;
    def.contact_damping = (float)s->contact_damping;
    def.push_speed = (float)s->push_speed;
    def.restitution_threshold = (float)s->restitution_threshold;
    def.hit_speed = (float)s->hit_speed;
    def.maximum_speed = (float)s->maximum_speed;
    def.sleeping = s->sleeping != 0.0;
    def.detection = api_detection(s->detection);
    def.contact_events = s->contact_events != 0.0;
    def.clock = s->timed != 0.0 || s->time_budget != 0.0 ? read_clock : NULL;
    def.broadphase = api_broadphase(s->broadphase);
    def.time_budget = s->time_budget;
    def.max_error = s->max_error;
    def.cell_size = (float)s->cell_size;
    def.log = keep_message;
#ifdef API_THREADS
    def.job_system = api_job_system();
#endif
    return def;
}

/* Creates a world. Slots in: world_options. Slots out: list, whose address is the world's. */
int api_world_create(void) {
    thud_world_def def = api_world_def();
    thud_world *world = NULL;
    thud_result result = thud_world_create(&def, &world);
    api_slots.list.address = (double)(uintptr_t)world;
    return result;
}

/* Destroys a world; THUD_ERROR_LOCKED inside a callback, where thud_world_destroy does nothing but
 * returns no result. So an advance by a negative time is tried first, which is always refused,
 * inside a callback as THUD_ERROR_LOCKED. */
int api_world_destroy(thud_world *world) {
    thud_result result = thud_world_advance(world, -1.0, 1, NULL, NULL);
    thud_world_destroy(world);
    return result == THUD_ERROR_LOCKED ? result : THUD_OK;
}

int api_world_step(thud_world *world) {
    return thud_world_step(world);
}

static void before_step(thud_world *world, void *context) {
    (void)context;
    thud_stepped(world, 0);
}

static void after_step(thud_world *world, void *context) {
    (void)context;
    thud_stepped(world, 1);
}

/* `calls`: a sum of 1 for calls of thud_stepped before each step, and 2 for calls after it. Slots
 * out: advance. */
int api_world_advance(thud_world *world, double elapsed, double max_steps, int calls) {
    int steps = 0;
    double alpha = 0.0;
    const thud_step_calls stepped = {calls & 1 ? before_step : NULL, calls & 2 ? after_step : NULL,
                                     NULL};
    thud_result result =
        thud_world_advance_with(world, elapsed, api_to_int(max_steps), &stepped, &steps, &alpha);
    api_slots.advance.steps = steps;
    api_slots.advance.alpha = alpha;
    return result;
}

int api_world_set_gravity(thud_world *world, double x, double y) {
    return thud_world_set_gravity(world, (thud_vec2){(float)x, (float)y});
}

int api_world_set_time_step(thud_world *world, double time_step) {
    return thud_world_set_time_step(world, time_step);
}

/* Sets a quality by its number, with changes. Numbers of 0, a detection of -1 and islands of -1
 * take the values of the quality. */
int api_world_set_quality(thud_world *world, double number, double substeps, double stiffness,
                          double damping, double detection, double islands) {
    const struct quality_options changes = {substeps, stiffness, damping, detection, islands};
    return thud_world_set_quality(world, changed_quality(number, &changes));
}

int api_world_set_max_error(thud_world *world, double max_error) {
    return thud_world_set_max_error(world, max_error);
}

int api_world_set_sleeping(thud_world *world, int sleeping) {
    return thud_world_set_sleeping(world, sleeping != 0);
}

/* Slots out: stats. Returns the number of stages of a step. */
int api_world_stats(const thud_world *world) {
    thud_stats stats = thud_stats_of(world);
    struct stats *s = &api_slots.stats;
    s->steps = (double)stats.steps;
    s->bodies = stats.bodies;
    s->shapes = stats.shapes;
    s->awake_bodies = stats.awake_bodies;
    s->pairs = stats.pairs;
    s->contacts = stats.contacts;
    s->colours = stats.colours;
    s->blocks = stats.blocks;
    s->bytes = (double)stats.bytes;
    s->step_allocations = (double)stats.step_allocations;
    s->substeps = stats.substeps;
    s->step_seconds = stats.step_seconds;
    s->direct_islands = stats.direct_islands;
    s->direct_bodies = stats.direct_bodies;
    s->soft_islands = stats.soft_islands;
    s->impacts = stats.impacts;
    s->motion_pairs = stats.motion_pairs;
    s->motion_circles = stats.motion_circles;
    s->motion_boxes = stats.motion_boxes;
    s->motion_exact = stats.motion_exact;
    _Static_assert(sizeof s->stage_seconds == THUD_STAGE_COUNT * sizeof(double),
                   "slots.h has another number of stages");
    for (int i = 0; i < THUD_STAGE_COUNT; i++)
        s->stage_seconds[i] = stats.stage_seconds[i];
    s->held_bodies = stats.held_bodies;
    s->held_seconds = stats.held_seconds;
    s->unbisectable = stats.unbisectable;
    return THUD_STAGE_COUNT;
}

/* Slots out: broadphase_counts. */
int api_world_broadphase_counts(const thud_world *world) {
    thud_broadphase_counts counts;
    thud_result result = thud_world_get_broadphase_counts(world, &counts);
    if (result == THUD_OK)
        api_slots.broadphase_counts = (struct broadphase_counts){
            .moved = counts.moved,
            .tested = (double)counts.tested,
            .found = (double)counts.found,
            .sort_moves = (double)counts.sort_moves,
            .cells = counts.cells,
            .cell_shapes = counts.cell_shapes,
            .cell_shapes_max = counts.cell_shapes_max,
        };
    return result;
}

/* Writes the speed, length/s, to the first slot; infinite without shapes. */
int api_world_bisection_limit(thud_world *world) {
    return thud_world_get_bisection_limit(world, api_slots.all);
}

/* Slots out: step_error. */
void api_world_step_error(const thud_world *world) {
    thud_step_error error = thud_step_error_of(world);
    api_slots.step_error.penetration_max = error.penetration_max;
    api_slots.step_error.penetration_mean = error.penetration_mean;
    api_slots.step_error.residual = error.residual;
    api_slots.step_error.energy_change = error.energy_change;
    api_slots.step_error.overlaps = error.overlaps;
    api_slots.step_error.shortfall = error.shortfall;
    api_slots.step_error.joint_gap_max = error.joint_gap_max;
    api_slots.step_error.joint_gap_mean = error.joint_gap_mean;
    api_slots.step_error.joint_angle_max = error.joint_angle_max;
    api_slots.step_error.energy_decided = error.energy_decided;
}

/* Slots out: measure. */
void api_world_measure(const thud_world *world) {
    thud_measure measure = thud_measure_of(world);
    api_slots.measure.penetration_max = measure.penetration_max;
    api_slots.measure.penetration_mean = measure.penetration_mean;
    api_slots.measure.kinetic_energy = measure.kinetic_energy;
    api_slots.measure.potential_energy = measure.potential_energy;
}

/* Slots out: hash. */
void api_world_hash(const thud_world *world) {
    uint64_t hash = thud_hash_of(world);
    api_slots.hash.upper = (double)(uint32_t)(hash >> 32);
    api_slots.hash.lower = (double)(uint32_t)hash;
}

/* The array of thud_world_get_poses, or null where it is refused. Slots out: list, its count. */
const thud_pose *api_world_poses(thud_world *world, double x, double y, double alpha) {
    int count = 0;
    const thud_pose *poses = thud_poses_of(world, (thud_pos){x, y}, alpha, &count);
    api_slots.list.count = count;
    return poses;
}
