/* recording.c: what recorder and player have in common: see recording.h. */
#include "recording/recording.h"

#include "state/body.h"

#include <string.h>

/* ---- hashes of bodies ---- */

static uint64_t mixed(uint64_t hash, uint64_t bits) {
    hash = (hash ^ bits) * 0x100000001b3ull;
    return hash ^ hash >> 29;
}

uint16_t td_recording_body_hash(const thud_world *w, td_body_index i) {
    const td_body *body = td_body_at(w, i);
    if (!(body->flags & TD_BODY_LIVE)) {
        return 0;
    }
    const td_pose *pose = td_pose_at(w, i);
    const float *v = td_body_velocity(w, body);
    uint32_t speed[3];
    memcpy(speed, v, sizeof speed);
    uint64_t hash = mixed(0xcbf29ce484222325ull, (uint64_t)pose->center.x);
    hash = mixed(hash, (uint64_t)pose->center.y);
    hash = mixed(hash, (uint64_t)pose->angle);
    hash = mixed(hash, speed[0] | (uint64_t)speed[1] << 32);
    hash = mixed(hash, speed[2]);
    return (uint16_t)(hash >> 40);
}

/* ---- the def ---- */

static const thud_broadphase *const BROADPHASES[] = {
    &thud_broadphase_grid, &thud_broadphase_sweep,        &thud_broadphase_sweep_y,
    &thud_broadphase_all,  &thud_broadphase_sweep_widest, &thud_broadphase_sweep_both};
static const thud_detection *const DETECTIONS[] = {NULL, &thud_detection_overlap,
                                                   &thud_detection_continuous,
                                                   &thud_detection_bisect, &thud_detection_swept};
enum {
    BROADPHASE_COUNT = sizeof BROADPHASES / sizeof *BROADPHASES,
    DETECTION_COUNT = sizeof DETECTIONS / sizeof *DETECTIONS
};

/* The numbers of a def that are floats. */
static const size_t FLOATS[] = {
    offsetof(thud_world_def, length_scale),          offsetof(thud_world_def, contact_stiffness),
    offsetof(thud_world_def, contact_damping),       offsetof(thud_world_def, push_speed),
    offsetof(thud_world_def, restitution_threshold), offsetof(thud_world_def, hit_speed),
    offsetof(thud_world_def, maximum_speed),         offsetof(thud_world_def, cell_size)};
enum { FLOAT_COUNT = sizeof FLOATS / sizeof *FLOATS };

void td_recording_write_def(td_writer *to, const thud_world *w) {
    unsigned broadphase = 0, detection = 0;
    while (broadphase < BROADPHASE_COUNT && BROADPHASES[broadphase] != w->def.broadphase) {
        broadphase++;
    }
    while (detection < DETECTION_COUNT && DETECTIONS[detection] != w->def.detection) {
        detection++;
    }
    td_write_byte(to, broadphase);
    td_write_byte(to, detection);
    td_write_byte(to, w->def.contact_events);
    td_write_integer(to, w->def.substeps);
    for (int i = 0; i < FLOAT_COUNT; i++) {
        uint32_t bits;
        memcpy(&bits, (const char *)&w->def + FLOATS[i], sizeof bits);
        td_write_number(to, bits, sizeof bits);
    }
}

bool td_recording_read_def(td_reader *from, thud_world_def *def) {
    unsigned broadphase = td_read_byte(from), detection = td_read_byte(from);
    if (broadphase >= BROADPHASE_COUNT || detection >= DETECTION_COUNT) {
        return false;
    }
    def->broadphase = BROADPHASES[broadphase];
    def->detection = DETECTIONS[detection];
    def->contact_events = td_read_byte(from) != 0;
    def->substeps = (int)td_read_integer(from);
    for (int i = 0; i < FLOAT_COUNT; i++) {
        uint32_t bits = (uint32_t)td_read_number(from, sizeof bits);
        memcpy((char *)def + FLOATS[i], &bits, sizeof bits);
    }
    return !from->broken;
}
