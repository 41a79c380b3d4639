/* api_world.c: worlds: creation, stepping, settings, statistics, and poses. */
#include "api.h"

#include <string.h>

/* The import that times the stages: seconds, as thud_clock_fn wants them. */
extern double thud_clock(void);

static char last_message[256];

static double read_clock(void *context) {
    (void)context;
    return thud_clock();
}

static void keep_message(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    size_t length = strlen(message), room = sizeof last_message - 1;
    if (length > room)
        length = room;
    memcpy(last_message, message, length); /* snprintf would bring 8 kB with it */
    last_message[length] = '\0';
}

/* Why the last call failed, in the log's words; JavaScript clears it by writing a 0 byte. */
char *api_last_message(void) {
    return last_message;
}

const thud_detection *api_detection(double number) {
    static const thud_detection *const all[] = {&thud_detection_overlap, &thud_detection_continuous,
                                                &thud_detection_bisect, &thud_detection_swept};
    int i = api_to_int(number);
    return i >= 0 && i < 4 ? all[i] : NULL;
}

/* What is no number of a quality is null, which the engine refuses. */
static const thud_quality *api_quality(double number) {
    static const thud_quality *const all[] = {&thud_quality_draft, &thud_quality_default,
                                              &thud_quality_high, &thud_quality_exact};
    int i = api_to_int(number);
    return i >= 0 && i < 4 ? all[i] : NULL;
}

/* A quality with changes, each where it is not the number that takes the quality's own: substeps,
 * contact stiffness and damping (0), detection (-1), and islands (-1; 0: the soft solver does all,
 * 1: the direct one helps, at default's limits where the quality has none). Valid until the next
 * call. */
static const thud_quality *changed_quality(double number, const double *changes) {
    static thud_quality quality;
    if (api_quality(number) == NULL)
        return NULL;
    quality = *api_quality(number);
    if (changes[0] != 0.0)
        quality.substeps = api_to_int(changes[0]);
    if (changes[1] != 0.0)
        quality.contact_stiffness = (float)changes[1];
    if (changes[2] != 0.0)
        quality.contact_damping = (float)changes[2];
    if (changes[3] >= 0.0)
        quality.detection = api_detection(changes[3]);
    if (changes[4] == 0.0)
        quality.islands = NULL;
    if (changes[4] == 1.0 && quality.islands == NULL) {
        quality.islands = thud_quality_default.islands;
        quality.sag_limit = thud_quality_default.sag_limit;
        quality.island_limit = thud_quality_default.island_limit;
        quality.island_work = thud_quality_default.island_work;
        quality.island_patience = thud_quality_default.island_patience;
    }
    return &quality;
}

static const thud_broadphase *api_broadphase(double number) {
    static const thud_broadphase *const all[] = {&thud_broadphase_grid, &thud_broadphase_sweep,
                                                 &thud_broadphase_all};
    int i = api_to_int(number);
    return i >= 0 && i < 3 ? all[i] : NULL;
}

/* Slots: 0, 1 gravity  2 time step  3 length scale  4 quality  5 substeps  6 contact stiffness
 * 7 contact damping  8 push speed  9 restitution threshold  10 hit speed  11 maximum speed
 * 12 sleeping  13 detection  14 contact events  15 stages are timed  16 broadphase
 * 17 time budget  18 maximum error  19... changes of the quality, see changed_quality. */
void api_world_defaults(void) {
    thud_world_def def = thud_default_world_def();
    double *s = api_slots;
    s[0] = def.gravity.x;
    s[1] = def.gravity.y;
    s[2] = def.time_step;
    s[3] = def.length_scale;
    s[4] = 1.0; /* default */
    s[5] = def.substeps;
    s[6] = def.contact_stiffness;
    s[7] = def.contact_damping;
    s[8] = def.push_speed;
    s[9] = def.restitution_threshold;
    s[10] = def.hit_speed;
    s[11] = def.maximum_speed;
    s[12] = def.sleeping;
    s[13] = -1.0; /* the quality's */
    s[14] = def.contact_events;
    s[15] = 0.0;
    s[16] = 0.0; /* grid */
    s[17] = def.time_budget;
    s[18] = def.max_error;
    s[19] = s[20] = s[21] = 0.0; /* the quality's */
    s[22] = s[23] = -1.0;
}

thud_world_def api_world_def(void) {
    const double *s = api_slots;
    thud_world_def def = thud_default_world_def();
    def.gravity = (thud_vec2){(float)s[0], (float)s[1]};
    def.time_step = s[2];
    def.length_scale = (float)s[3];
    def.quality = changed_quality(s[4], s + 19);
    def.substeps = api_to_int(s[5]);
    def.contact_stiffness = (float)s[6];
    def.contact_damping = (float)s[7];
    def.push_speed = (float)s[8];
    def.restitution_threshold = (float)s[9];
    def.hit_speed = (float)s[10];
    def.maximum_speed = (float)s[11];
    def.sleeping = s[12] != 0.0;
    def.detection = api_detection(s[13]);
    def.contact_events = s[14] != 0.0;
    def.clock = s[15] != 0.0 || s[17] != 0.0 ? read_clock : NULL;
    def.broadphase = api_broadphase(s[16]);
    def.time_budget = s[17];
    def.max_error = s[18];
    def.log = keep_message;
    return def;
}

/* A world from the slots of api_world_defaults; its address goes to slot 0. */
int api_world_create(void) {
    thud_world_def def = api_world_def();
    thud_world *world = NULL;
    thud_result result = thud_world_create(&def, &world);
    api_slots[0] = (double)(uintptr_t)world;
    return result;
}

void api_world_destroy(thud_world *world) {
    thud_world_destroy(world);
}

int api_world_step(thud_world *world) {
    return thud_world_step(world);
}

/* Slots out: 0 steps run  1 alpha. */
int api_world_advance(thud_world *world, double elapsed, double max_steps) {
    int steps = 0;
    double alpha = 0.0;
    thud_result result = thud_world_advance(world, elapsed, api_to_int(max_steps), &steps, &alpha);
    api_slots[0] = steps;
    api_slots[1] = alpha;
    return result;
}

int api_world_set_gravity(thud_world *world, double x, double y) {
    return thud_world_set_gravity(world, (thud_vec2){(float)x, (float)y});
}

int api_world_set_time_step(thud_world *world, double time_step) {
    return thud_world_set_time_step(world, time_step);
}

/* Numbers of 0, a detection of -1 and islands of -1 take the quality's own. */
int api_world_set_quality(thud_world *world, double number, double substeps, double stiffness,
                          double damping, double detection, double islands) {
    const double changes[] = {substeps, stiffness, damping, detection, islands};
    return thud_world_set_quality(world, changed_quality(number, changes));
}

int api_world_set_max_error(thud_world *world, double max_error) {
    return thud_world_set_max_error(world, max_error);
}

int api_world_set_sleeping(thud_world *world, int sleeping) {
    return thud_world_set_sleeping(world, sleeping != 0);
}

/* Slots out: 0 steps  1 bodies  2 shapes  3 awake bodies  4 pairs  5 contacts  6 colours
 * 7 blocks  8 bytes  9 allocations of the last step  10 its substeps  11 its seconds  12 islands
 * solved directly  13 their bodies  14 of them, back with the soft solver  15 impacts  16 pairs of
 * motions  17 of them, whose circles met  18 boxes met  19 times were worked out  20... seconds of
 * its stages  29 bodies held back  30 the seconds that they lost  31 too fast to be bisected. */
int api_world_stats(const thud_world *world) {
    thud_stats stats = thud_world_stats(world);
    double *s = api_slots;
    s[0] = (double)stats.steps;
    s[1] = stats.bodies;
    s[2] = stats.shapes;
    s[3] = stats.awake_bodies;
    s[4] = stats.pairs;
    s[5] = stats.contacts;
    s[6] = stats.colours;
    s[7] = stats.blocks;
    s[8] = (double)stats.bytes;
    s[9] = (double)stats.step_allocations;
    s[10] = stats.substeps;
    s[11] = stats.step_seconds;
    s[12] = stats.direct_islands;
    s[13] = stats.direct_bodies;
    s[14] = stats.soft_islands;
    s[15] = stats.impacts;
    s[16] = stats.motion_pairs;
    s[17] = stats.motion_circles;
    s[18] = stats.motion_boxes;
    s[19] = stats.motion_exact;
    _Static_assert(20 + THUD_STAGE_COUNT <= 29, "no room for the seconds of another stage");
    for (int i = 0; i < THUD_STAGE_COUNT; i++)
        s[20 + i] = stats.stage_seconds[i];
    s[29] = stats.held_bodies;
    s[30] = stats.held_seconds;
    s[31] = stats.unbisectable;
    return THUD_STAGE_COUNT;
}

/* Slots out: 0 the speed, infinite without shapes. */
int api_world_bisection_limit(thud_world *world) {
    return thud_world_bisection_limit(world, api_slots);
}

/* Slots out: 0 largest penetration  1 mean penetration  2 residual  3 energy change  4 overlaps. */
void api_world_error(const thud_world *world) {
    thud_step_error error = thud_world_error(world);
    api_slots[0] = error.penetration_max;
    api_slots[1] = error.penetration_mean;
    api_slots[2] = error.residual;
    api_slots[3] = error.energy_change;
    api_slots[4] = error.overlaps;
}

/* Slots out: 0 largest penetration  1 mean penetration  2 kinetic  3 potential energy. */
void api_world_measure(const thud_world *world) {
    thud_measure measure = thud_world_measure(world);
    api_slots[0] = measure.penetration_max;
    api_slots[1] = measure.penetration_mean;
    api_slots[2] = measure.kinetic_energy;
    api_slots[3] = measure.potential_energy;
}

/* Slots out: 0 upper  1 lower half of the hash. */
void api_world_hash(const thud_world *world) {
    uint64_t hash = thud_world_hash(world);
    api_slots[0] = (double)(uint32_t)(hash >> 32);
    api_slots[1] = (double)(uint32_t)hash;
}

/* The world's own array of poses; slot 0 is their count. */
const thud_pose *api_world_poses(thud_world *world, double x, double y, double alpha) {
    int count = 0;
    const thud_pose *poses = thud_world_poses(world, (thud_pos){x, y}, alpha, &count);
    api_slots[0] = count;
    return poses;
}
