/* report.c: reading a world as a whole: events, poses, statistics, the error of the last step,
 * energy and penetration, and its hash. */
#include "constraint/joint_hooks.h"
#include "solver/error.h"
#include "state/body.h"
#include "state/handles.h"
#include "constraint/lanes.h"
#include "base/rotation.h"

thud_result thud_world_get_events(const thud_world *w, thud_events *out) {
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    const td_event_lists *e = w->gathers ? &w->gathered.lists : &w->published;
    *out = (thud_events){
        .begin = e->begin.data,
        .end = e->end.data,
        .sensor_begin = e->sensor_begin.data,
        .sensor_end = e->sensor_end.data,
        .sensor_begin_time = e->sensor_begin_time.data,
        .sensor_end_time = e->sensor_end_time.data,
        .hit = e->hit.data,
        .quarantined = e->quarantined.data,
        .begin_count = e->begin.count,
        .end_count = e->end.count,
        .sensor_begin_count = e->sensor_begin.count,
        .sensor_end_count = e->sensor_end.count,
        .hit_count = e->hit.count,
        .quarantined_count = e->quarantined.count,
    };
    return THUD_OK;
}

/* Interpolation goes back from the last step's pose by (1 - alpha) of the body's motion in it,
 * thud_world.delta. */
thud_result thud_world_get_poses(thud_world *w, thud_pos origin, double alpha,
                                 const thud_pose **out, int *out_count) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !out || !out_count) {
        return THUD_ERROR_NULL;
    }
    thud_result result = td_check_place(w, "poses: x or y of origin", origin.x, origin.y);
    result = result != THUD_OK ? result : td_check(w, "poses: alpha", alpha, 0.0, 1.0);
    if (result != THUD_OK) {
        return result;
    }
    if (!td_array_reserve(&w->memory, &w->poses, td_max_int(w->bodies.count, 1))) {
        return td_refuse(w, THUD_ERROR_MEMORY, "poses: out of memory");
    }
    thud_pose *poses = w->poses.data;
    td_position from = td_place_from(w, origin);
    float back = (float)(1.0 - alpha);
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        const td_body *body = td_body_at(w, i);
        const td_pose *pose = td_pose_at(w, i);
        if (!(body->flags & TD_BODY_LIVE)) {
            poses[i.at].x = poses[i.at].y = __builtin_nanf("");
            continue;
        }
        float x = (float)(pose->center.x - from.x) * w->quantum;
        float y = (float)(pose->center.y - from.y) * w->quantum;
        float c = pose->c, s = pose->s;
        if (body->awake.at > 0 && back > 0.0f) {
            const float *delta = td_row(&w->delta, body->awake);
            x -= back * delta[0];
            y -= back * delta[1];
            if (delta[2] != 0.0f) {
                td_angle_turn(pose->angle - td_angle_between((double)(back * delta[2])), &c, &s);
            }
        }
        poses[i.at] = (thud_pose){x - (c * body->center_x - s * body->center_y),
                                  y - (s * body->center_x + c * body->center_y), c, s};
    }
    *out = poses;
    *out_count = w->bodies.count;
    return THUD_OK;
}

const char *thud_stage_name(thud_stage stage) {
    static const char *const names[] = {"changes",    "broadphase", "narrowphase",
                                        "contacts",   "solve",      "finalize",
                                        "continuous", "events",     "sleep"};
    _Static_assert(sizeof names / sizeof names[0] == THUD_STAGE_COUNT, "a name for each stage");
    return (int)stage >= 0 && stage < THUD_STAGE_COUNT ? names[stage] : "unknown";
}

thud_result thud_world_get_stats(const thud_world *w, thud_stats *out) {
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    thud_stats stats = w->stats;
    stats.steps = w->steps;
    stats.bodies = w->bodies.live;
    stats.shapes = w->shapes.live;
    stats.awake_bodies = w->body_of.count - 1;
    stats.pairs = 0;
    for (int kind = 0; kind < TD_PAIR_COUNT; kind++) {
        stats.pairs += w->constraint_count[kind];
    }
    stats.contacts = w->touching;
    stats.bytes = w->memory.bytes;
    *out = stats;
    return THUD_OK;
}

thud_result thud_world_get_step_error(const thud_world *w, thud_step_error *out) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    if (!w->error_hooks) {
        return td_refuse(
            w, THUD_ERROR_INVALID,
            "step error, in a world of thud_default_small_world_def before thud_world_use_step_error");
    }
    td_errors step = td_errors_of_step(w), *e = &step;
    td_joint_gaps gaps = {0};
    if (w->joint_hooks) {
        w->joint_hooks->measure(w, &gaps);
    }
    *out = (thud_step_error){
        .penetration_max = (double)e->deepest,
        .penetration_mean = e->points ? e->depth / w->to_fixed / (double)e->points : 0.0,
        .residual = (double)e->residual,
        .energy_change = e->energy_change,
        .energy_decided = e->energy_decided,
        .overlaps = (int)e->overlaps,
        .shortfall = __builtin_sqrt((double)e->shortfall_squared),
        .joint_gap_max = gaps.worst,
        .joint_gap_mean = gaps.mean,
        .joint_angle_max = gaps.angle,
    };
    return THUD_OK;
}

/* Maximum and mean penetration over the points of touching contacts, length. Lanes store
 * separations minus the skin, which is added here. Where detection moved bodies after the solver
 * they are computed anew from the poses (td_errors_separation). */
static void measure_penetration(const thud_world *w, thud_measure *m) {
    int points = 0;
    double sum = 0.0;
    bool moved = td_errors_points_stale(w);
    for (int i = 0; i < w->constraints.count; i++) {
        const td_constraint *contact = td_constraint_at(w, i);
        if (!td_is_contact(contact) || !contact->live || contact->state != TD_TOUCHING) {
            continue;
        }
        td_lane at = td_lane_of(w, contact);
        for (int k = 0; k < td_form_points(w->kinds[contact->kind]->form); k++) {
            const td_point *p = &at.block->point[k];
            if (p->normal_mass[at.lane] == 0.0f) {
                continue;
            }
            float separation =
                (moved ? td_errors_separation(w, contact, k) : p->separation[at.lane]) + w->skin;
            double depth = separation < 0.0f ? -(double)separation : 0.0;
            m->penetration_max = depth > m->penetration_max ? depth : m->penetration_max;
            sum += depth;
            points++;
        }
    }
    m->penetration_mean = points ? sum / points : 0.0;
}

thud_result thud_world_get_measure(const thud_world *w, thud_measure *out) {
    TD_IN_OWN_FLOAT_MODE;
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    thud_measure m = {0};
    measure_penetration(w, &m);
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        const td_body *body = td_body_at(w, i);
        if (!(body->flags & TD_BODY_LIVE) || body->kind != THUD_BODY_DYNAMIC) {
            continue;
        }
        const float *v = td_body_velocity(w, body);
        double x = (double)v[0], y = (double)v[1], turn = (double)v[2];
        double mass = (double)body->mass * (double)body->gravity_scale;
        thud_pos center = td_place_to(w, td_pose_at(w, i)->center);
        double energy =
            0.5 * (double)body->mass * (x * x + y * y) + 0.5 * (double)body->inertia * turn * turn;
        m.kinetic_energy +=
            td_finite(energy) ? energy : 0.0; /* not finite if a body's velocity is not; the next
                                                 step quarantines that body */
        m.potential_energy -=
            mass * ((double)w->def.gravity.x * center.x + (double)w->def.gravity.y * center.y);
    }
    *out = m;
    return THUD_OK;
}

/* FNV-1a (Fowler, Noll, Vo), by words of 64 bits in place of bytes. */
static uint64_t mix(uint64_t hash, uint64_t word) {
    return (hash ^ word) * 0x100000001b3ull;
}

static uint64_t bits_of(float x) {
    uint32_t bits;
    __builtin_memcpy(&bits, &x, sizeof bits);
    return bits;
}

thud_result thud_world_get_hash(const thud_world *w, uint64_t *out) {
    if (!w || !out) {
        return THUD_ERROR_NULL;
    }
    uint64_t hash = 0xcbf29ce484222325ull;
    for (td_body_index i = {0}; i.at < w->bodies.count; i.at++) {
        if (!td_body_lives(w, i)) {
            continue;
        }
        const td_pose *pose = td_pose_at(w, i);
        const float *v = td_body_velocity(w, td_body_at(w, i));
        hash = mix(hash, (uint64_t)pose->center.x);
        hash = mix(hash, (uint64_t)pose->center.y);
        hash = mix(hash, pose->angle);
        hash = mix(hash, bits_of(v[0]) | bits_of(v[1]) << 32);
        hash = mix(hash, bits_of(v[2]));
        hash ^= hash >> 29; /* a product carries information from low bits to high ones only: this
                               carries it from high bits to low ones */
    }
    *out = hash;
    return THUD_OK;
}
