/* oracles.c: checks of a session's world after each step, and at its end; see oracles.h. The note_
 * functions (calls.h) add a value to the digest in which both twins must agree. */
#include "oracles.h"

#include "calls.h"

/* ---- events ---- */

/* The index of a pair in the ledger; its count if the pair is not open. */
static int find_pair(const pair_ledger *l, const thud_contact_event *pair) {
    int i = 0;
    while (i < l->count && memcmp(&l->open[i], pair, sizeof *pair) != 0) {
        i++;
    }
    return i;
}

/* Removes the pair from the ledger; false if it is not open. */
static bool close_pair(pair_ledger *l, const thud_contact_event *pair) {
    int i = find_pair(l, pair);
    if (i == l->count) {
        return false;
    }
    l->open[i] = l->open[--l->count];
    return true;
}

static void note_pair(fuzz_session *s, const thud_contact_event *pair) {
    note_bits(s, (uint64_t)pair->shape_a.index1 << 32 | pair->shape_b.index1);
}

/* Shapes of a pair that begins are valid, unless callbacks have destroyed a shape in the step. */
static void check_handles(fuzz_session *s, const thud_contact_event *pair, const char *what) {
    if (!s->destroyed_inside && !(thud_shape_is_valid(s->world, pair->shape_a) &&
                                  thud_shape_is_valid(s->world, pair->shape_b))) {
        fuzz_fail(s, "a %s begins between shapes of which one is gone", what);
    }
}

/* Enters a step's events into the ledger. Ends of open pairs are entered first; the other ends must
 * be of pairs that begin in this step. */
static void enter_events(fuzz_session *s, pair_ledger *l, const char *what,
                         const thud_contact_event *begin, int begins, const thud_contact_event *end,
                         int ends) {
    static bool begins_in_step[SESSION_OPEN_PAIRS_MAX]; /* by end: its pair was not open before */
    if (begins < 0 || ends < 0 || begins + l->count > SESSION_OPEN_PAIRS_MAX ||
        ends > SESSION_OPEN_PAIRS_MAX) {
        fuzz_fail(s, "%d %ss begin and %d end, with %d open: more than %d shapes can make", begins,
                  what, ends, l->count, SESSION_WORLD_SHAPES_MAX);
    }
    for (int i = 0; i < ends; i++) {
        begins_in_step[i] = !close_pair(l, &end[i]);
        note_pair(s, &end[i]);
    }
    for (int i = 0; i < begins; i++) {
        if (find_pair(l, &begin[i]) < l->count) {
            fuzz_fail(s, "a %s of shapes %u and %u begins twice", what, begin[i].shape_a.index1,
                      begin[i].shape_b.index1);
        }
        check_handles(s, &begin[i], what);
        l->open[l->count++] = begin[i];
        note_pair(s, &begin[i]);
    }
    for (int i = 0; i < ends; i++) {
        if (begins_in_step[i] && !close_pair(l, &end[i])) {
            fuzz_fail(s, "a %s of shapes %u and %u ends and had not begun", what,
                      end[i].shape_a.index1, end[i].shape_b.index1);
        }
    }
}

/* Bodies are quarantined where their state became non-finite. */
static void note_hits_and_quarantined(fuzz_session *s, const thud_events *e) {
    for (int i = 0; i < e->hit_count; i++) {
        const thud_hit_event *hit = &e->hit[i];
        note_bits(s, (uint64_t)hit->shape_a.index1 << 32 | hit->shape_b.index1);
        note_place(s, hit->point);
        note_vector(s, hit->normal);
        note_number(s, (double)hit->speed);
    }
    for (int i = 0; i < e->quarantined_count; i++) {
        note_bits(s, e->quarantined[i].index1);
    }
}

static void check_events(fuzz_session *s) {
    thud_events e = thud_events_of(s->world);
    enter_events(s, &s->now.touches, "contact", e.begin, e.begin_count, e.end, e.end_count);
    enter_events(s, &s->now.sensed, "sensing", e.sensor_begin, e.sensor_begin_count, e.sensor_end,
                 e.sensor_end_count);
    for (int i = 0; i < e.sensor_begin_count; i++) {
        note_number(s, (double)e.sensor_begin_time[i]);
    }
    for (int i = 0; i < e.sensor_end_count; i++) {
        note_number(s, (double)e.sensor_end_time[i]);
    }
    note_hits_and_quarantined(s, &e);
}

/* ---- bodies and statistics ---- */

/* Names the call whose values are noted next: the text of a finding says which call gave a value
 * that is not finite. */
static void name_call(fuzz_session *s, const char *call) {
    s->calls[0].text = call;
}

/* Slack of a clamped speed, for rounding to float. Chosen. */
#define SPEED_SLACK 1.00001f

/* After a step x and y of a velocity are within the world's maximum_speed, and the angular velocity
 * is within THUD_ANGULAR_SPEED_MAX. A collision that detection resolves within the step
 * (thud_stats.impacts) may leave more, since velocities are clamped before it. */
static void check_speed(const fuzz_session *s, thud_body_id body, const thud_body_state *state) {
    double max = (double)SPEED_SLACK * (double)s->def.maximum_speed * s->unit;
    bool within = fabs((double)state->velocity.x) <= max &&
                  fabs((double)state->velocity.y) <= max &&
                  fabsf(state->angular_velocity) <= SPEED_SLACK * THUD_ANGULAR_SPEED_MAX;
    if (!within && state->kind == THUD_BODY_DYNAMIC && state->awake &&
        thud_stats_of(s->world).impacts == 0) {
        fuzz_fail(s, "a step leaves body %u the velocity %g, %g of at most %g, and the spin %g",
                  body.index1, (double)state->velocity.x, (double)state->velocity.y, max,
                  (double)state->angular_velocity);
    }
}

/* Reads and notes a joint, unless its handle is stale. */
static void check_joint(fuzz_session *s, thud_joint_id joint) {
    thud_joint_state state;
    if (thud_joint_get_state(s->world, joint, &state) != THUD_OK) {
        return;
    }
    name_call(s, "thud_joint_get_state");
    note_number(s, state.gap);
    note_number(s, state.angle_gap);
    for (int i = 0; i < THUD_DIRECTION_COUNT; i++) {
        note_number(s, state.value[i]);
    }
}

/* Reads, notes and checks a body, unless its handle is stale. */
static void check_body(fuzz_session *s, thud_body_id body) {
    thud_body_state state;
    if (thud_body_get_state(s->world, body, &state) != THUD_OK) {
        return;
    }
    name_call(s, "thud_body_get_state");
    note_place(s, state.position);
    note_place(s, state.center);
    note_number(s, state.angle);
    note_number(s, (double)state.cosine);
    note_number(s, (double)state.sine);
    note_vector(s, state.velocity);
    note_number(s, (double)state.angular_velocity);
    note_number(s, (double)state.mass);
    note_number(s, (double)state.inertia);
    note_bits(s, (uint64_t)(state.awake + 2 * state.enabled + 4 * state.quarantined));
    check_speed(s, body, &state);
    if (state.mass < 0 || state.inertia < 0 || state.shape_count < 0 ||
        (state.awake && !state.enabled)) {
        fuzz_fail(s, "body %u: mass %g, inertia %g, %d shapes, awake %d, enabled %d", body.index1,
                  (double)state.mass, (double)state.inertia, state.shape_count, state.awake,
                  state.enabled);
    }
}

/* Reads and notes the poses halfway between the last two steps. */
static void check_poses(fuzz_session *s) {
    int count = -1;
    const thud_pose *poses =
        thud_poses_of(s->world, (thud_pos){s->shift_x, s->shift_y}, 0.5, &count);
    name_call(s, "thud_poses_of");
    if (!poses && count != 0) {
        fuzz_fail(s, "no poses, and %d of them", count);
    }
    for (int i = 0; i < count; i++) {
        if (isnan(poses[i].x) && isnan(poses[i].y)) {
            continue; /* no body has this slot */
        }
        note_number(s, (double)poses[i].x);
        note_number(s, (double)poses[i].y);
        note_number(s, (double)poses[i].c);
        note_number(s, (double)poses[i].s);
    }
}

/* Most pairs of two shapes: a shape makes a pair with each segment of a terrain line that it
 * overlaps. The lines of a session begin with 16 segments, and edits (thud_shape_dig) add vertices;
 * 64 is chosen, not derived. */
enum { PAIRS_OF_TWO_SHAPES_MAX = 64 };

/* Notes the statistics of the step, and checks that they are possible together (thud_stats says
 * what each counts). */
static void check_statistics(fuzz_session *s) {
    thud_stats t = thud_stats_of(s->world);
    bool possible = t.bodies >= 0 && t.shapes >= 0 && t.awake_bodies >= 0 &&
                    t.awake_bodies <= t.bodies && t.contacts >= 0 && t.contacts <= t.pairs &&
                    t.pairs <= t.shapes * t.shapes * PAIRS_OF_TWO_SHAPES_MAX &&
                    t.direct_bodies <= t.bodies && t.held_bodies <= t.bodies &&
                    t.unbisectable <= t.bodies && t.substeps >= 1 &&
                    t.substeps <= THUD_SUBSTEPS_MAX && t.colours <= t.blocks;
    if (!possible) {
        fuzz_fail(s,
                  "%d bodies, %d awake, %d direct, %d held, %d unbisectable, %d shapes, %d pairs, "
                  "%d contacts, %d substeps, %d colours, %d blocks",
                  t.bodies, t.awake_bodies, t.direct_bodies, t.held_bodies, t.unbisectable,
                  t.shapes, t.pairs, t.contacts, t.substeps, t.colours, t.blocks);
    }
    const int counts[] = {t.bodies,         t.shapes,        t.awake_bodies, t.pairs,
                          t.contacts,       t.colours,       t.blocks,       t.substeps,
                          t.direct_islands, t.direct_bodies, t.soft_islands, t.factorings,
                          t.impacts,        t.held_bodies,   t.unbisectable, t.motion_pairs};
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        note_bits(s, (uint64_t)counts[i]);
    }
    note_bits(s, t.steps);
    note_bits(s, (uint64_t)t.island_work);
}

/* Notes the errors of the step, the measures of the world and its hash. */
static void check_errors_and_measures(fuzz_session *s) {
    thud_step_error e = thud_step_error_of(s->world);
    name_call(s, "thud_step_error_of");
    note_number(s, e.penetration_max);
    note_number(s, e.penetration_mean);
    note_number(s, e.residual);
    note_number(s, e.energy_change);
    note_number(s, e.energy_decided);
    note_bits(s, (uint64_t)e.overlaps);
    thud_measure m = thud_measure_of(s->world);
    name_call(s, "thud_measure_of");
    note_number(s, m.penetration_max);
    note_number(s, m.penetration_mean);
    note_number(s, m.kinetic_energy);
    /* It depends on the distance from the origin; note_place leaves it out for a shifted twin. */
    note_place(s, (thud_pos){m.potential_energy, 0});
    if (s->twin != TWIN_SHIFT) {
        note_bits(s, thud_hash_of(s->world));
    }
}

void oracle_step(fuzz_session *s) {
    check_events(s);
    for (int i = 0; i < SESSION_BODIES; i++) {
        check_body(s, s->now.bodies[i]);
    }
    for (int i = 0; i < SESSION_JOINTS; i++) {
        check_joint(s, s->now.joints[i]);
    }
    check_poses(s);
    check_statistics(s);
    check_errors_and_measures(s);
    s->destroyed_inside = 0;
}

void oracle_end(fuzz_session *s) {
    for (int i = 0; i < SESSION_BODIES; i++) {
        if (thud_body_is_valid(s->world, s->now.bodies[i])) {
            TRY(s, thud_body_destroy(s->world, s->now.bodies[i]));
        }
    }
    TRY(s, thud_world_step(s->world));
    if (s->result != THUD_OK) {
        fuzz_fail(s, "the last step: %s", thud_result_text(s->result));
    }
    oracle_step(s);
    thud_stats stats = thud_stats_of(s->world);
    if (s->now.touches.count || s->now.sensed.count || stats.bodies || stats.pairs) {
        fuzz_fail(s, "%d contacts and %d sensings have not ended, %d bodies and %d pairs are left",
                  s->now.touches.count, s->now.sensed.count, stats.bodies, stats.pairs);
    }
}
