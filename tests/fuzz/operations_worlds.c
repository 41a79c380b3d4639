/* operations_worlds.c: operations that step a world, change its settings, and read its reports. */
#include "operations.h"
#include "oracles.h"

void play_step(fuzz_session *s) {
    TRY(s, thud_world_step(s->world));
    if (s->depth && s->result != THUD_ERROR_LOCKED) {
        fuzz_fail(s, "a step inside a callback: %s", thud_result_text(s->result));
    }
    if (s->result == THUD_OK) {
        oracle_step(s);
    } else if (!s->depth) {
        fuzz_fail(s, "a step: %s", thud_result_text(s->result));
    }
}

/* At most one step in a call, so that the events of each step are checked. */
void play_advance(fuzz_session *s) {
    double elapsed = next_number(&s->bytes, 0, 1.0 / 4096), alpha = 0;
    int most = next_chance(&s->bytes, 8) ? 0 : 1, steps = 0;
    TRY(s, thud_world_advance(s->world, elapsed, most, &steps, &alpha));
    if (s->result == THUD_OK) {
        note_bits(s, (uint64_t)steps);
        note_number(s, alpha);
        if (!(alpha >= 0 && alpha < 1) || steps < 0 || steps > most || s->depth) {
            fuzz_fail(s, "advance: %d steps, alpha %g", steps, alpha);
        }
        if (steps) {
            oracle_step(s);
        }
    }
}

static void count_step(thud_world *world, void *context) {
    (void)world;
    ++*(int *)context;
}

/* The same with a callback after each step. */
void play_advance_with(fuzz_session *s) {
    double elapsed = next_number(&s->bytes, 0, 1.0 / 4096);
    int steps = 0, calls = 0;
    const thud_step_calls count = {NULL, count_step, &calls};
    TRY(s, thud_world_advance_with(s->world, elapsed, 1, &count, &steps, NULL));
    if (s->result == THUD_OK) {
        note_bits(s, (uint64_t)steps);
        if (calls != steps) {
            fuzz_fail(s, "advance: %d steps, and %d calls", steps, calls);
        }
        if (steps) {
            oracle_step(s);
        }
    }
}

/* Replaces the session's log hook and sets it again before any message. */
void play_log(fuzz_session *s) {
    TRY(s, thud_world_set_log(s->world, thud_log_to_stderr, NULL));
    TRY(s, thud_world_set_log(s->world, s->def.log, s->def.log_context));
}

void play_settings(fuzz_session *s) {
    static const double steps[] = {1.0 / 60, 1.0 / 30, 1.0 / 120, 1.0 / 1000};
    switch (next_choice(&s->bytes, 4)) {
    case 0: {
        thud_vec2 gravity = pick_velocity(s);
        TRY(s, thud_world_set_gravity(s->world, gravity));
        break;
    }
    case 1: {
        unsigned byte = next_byte(&s->bytes);
        double step =
            s->bytes.hostile && byte >= FIRST_HOSTILE ? hostile_number(byte) : steps[byte % 4];
        TRY(s, thud_world_set_time_step(s->world, step));
        break;
    }
    case 2: {
        double error = next_number(&s->bytes, 0, 0.0001);
        TRY(s, thud_world_set_max_error(s->world, error));
        break;
    }
    default: {
        bool sleeping = next_choice(&s->bytes, 2) == 0;
        TRY(s, thud_world_set_sleeping(s->world, sleeping));
    }
    }
}

/* No listener, one of the two forms, or both forms, which is refused; and `without` parts, of which
 * only two bits are valid. */
void play_listeners(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    thud_listeners listeners = {.prologue = byte & 1 ? session_prologue : NULL,
                                .epilogue = byte & 4 ? session_epilogue : NULL,
                                .prologue_all = byte & 2 ? session_prologue_all : NULL,
                                .epilogue_all = byte & 8 ? session_epilogue_all : NULL,
                                .context = s,
                                .without = byte >> 4 & 7};
    bool none = byte & 128, wrong = !none && ((byte & 3) == 3 || (byte & 12) == 12 || byte & 64);
    TRY(s, thud_world_set_listeners(s->world, none ? NULL : &listeners));
    thud_result expected = s->depth ? THUD_ERROR_LOCKED : wrong ? THUD_ERROR_INVALID : THUD_OK;
    if (s->result != expected) {
        fuzz_fail(s, "listeners: %s", thud_result_text(s->result));
    }
    if (s->result == THUD_OK) {
        s->listeners = none ? (thud_listeners){.context = s} : listeners;
    }
}

/* The epilogue of a body or of categories, set or removed. No snapshot has those of bodies, so that
 * a session that goes on in other worlds sets none. The session keeps the categories of one. */
void play_object_epilogues(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    thud_object_epilogue_fn *epilogue = byte & 1 ? session_object_epilogue : NULL;
    if (byte & 2) {
        thud_body_id body = pick_body(s);
        epilogue = s->twin == TWIN_SNAPSHOT ? NULL : epilogue;
        TRY(s, thud_body_set_epilogue(s->world, body, epilogue, s));
        return;
    }
    uint32_t categories = s->told_categories ? s->told_categories : byte >> 4;
    TRY(s, thud_world_set_category_epilogue(s->world, categories, epilogue, s));
    thud_result expected = !categories ? THUD_ERROR_INVALID
                           : s->depth  ? THUD_ERROR_LOCKED
                                       : THUD_OK;
    if (s->result != expected) {
        fuzz_fail(s, "epilogue of categories: %s", thud_result_text(s->result));
    }
    if (s->result == THUD_OK) {
        s->told_categories = epilogue ? categories : 0;
    }
}

/* Velocities after the collision that a prologue is called about, or, outside of it, of a contact
 * that nobody is asked about, which is refused. */
void play_decide(fuzz_session *s) {
    static const thud_contact nobody;
    unsigned byte = next_byte(&s->bytes);
    thud_velocities a = {.velocity = pick_velocity(s)}, b = {.velocity = pick_velocity(s)};
    a.angular_velocity = next_float(&s->bytes, -8, 0.0625);
    b.angular_velocity = next_float(&s->bytes, -8, 0.0625);
    const thud_contact *contact = s->question ? s->question : &nobody;
    TRY(s, thud_contact_decide(s->world, contact, byte & 1 ? &a : NULL, byte & 2 ? &b : NULL));
    if (s->result == THUD_OK && (!s->question || !(byte & 3))) {
        fuzz_fail(s, "decided what nobody was asked about");
    }
}

void play_qualities(fuzz_session *s) {
    unsigned byte = next_byte(&s->bytes);
    thud_quality quality = *pick_quality(s, byte);
    if (byte & 64) {
        quality.substeps = next_count(&s->bytes, 8);
        quality.contact_stiffness = next_float(&s->bytes, 0.01, 0.002);
        quality.contact_damping = next_float(&s->bytes, 0, 0.4);
        quality.detection = pick_detection(s, next_byte(&s->bytes));
        quality.islands = next_choice(&s->bytes, 4) ? &thud_islands_direct : NULL;
        quality.overlap_limit = next_float(&s->bytes, 0, 0.001);
        quality.island_limit = next_count(&s->bytes, 100);
        quality.island_work = (int64_t)next_count(&s->bytes, 255) * 50;
        quality.island_slow_steps = next_count(&s->bytes, 8);
    }
    TRY(s, thud_world_set_quality(s->world, byte & 32 ? NULL : &quality));
}

void play_reading(fuzz_session *s) {
    if (!s->depth) {
        thud_measure m = COUNTED(thud_measure_of(s->world));
        s->calls[s->depth].text = "thud_measure_of";
        note_number(s, m.penetration_max);
        note_number(s, m.penetration_mean);
    }
    COUNTED(thud_stats_of(s->world));
    COUNTED(thud_step_error_of(s->world));
    COUNTED(thud_events_of(s->world));
    if (s->twin != TWIN_SHIFT) {
        note_bits(s, COUNTED(thud_hash_of(s->world)));
    }
}

void play_limit(fuzz_session *s) {
    double speed = -1;
    TRY(s, thud_world_get_bisection_limit(s->world, &speed));
    if (s->result == THUD_OK && !(speed >= 0)) {
        fuzz_fail(s, "the bisection limit is %g", speed);
    }
    thud_broadphase_counts counts;
    TRY(s, thud_world_get_broadphase_counts(s->world, &counts));
    if (s->result == THUD_OK &&
        (counts.found > counts.tested || counts.cells > counts.cell_shapes)) {
        fuzz_fail(s, "the broadphase found more than it tested, or counts empty cells");
    }
}

static void check_name(fuzz_session *s, const char *name) {
    if (!name) {
        fuzz_fail(s, "a name is null");
    }
}

void play_names(fuzz_session *s) {
    int number = next_count(&s->bytes, 12);
    if (COUNTED(thud_default_world_def()).quality != &thud_quality_default) {
        fuzz_fail(s, "the default world is of another quality");
    }
    check_name(s, COUNTED(thud_stage_name((thud_stage)number)));
    check_name(s, COUNTED(thud_result_text((thud_result)number)));
    check_name(s, COUNTED(thud_detection_name(pick_detection(s, (unsigned)number))));
    check_name(s, COUNTED(thud_broadphase_name(number & 1 ? s->def.broadphase : NULL)));
}

void play_poses(fuzz_session *s) {
    double alpha = next_number(&s->bytes, 0, 1.0 / 240);
    thud_pos origin = pick_place(s);
    int count = -1, told = s->told;
    const thud_pose *poses = COUNTED(thud_poses_of(s->world, origin, alpha, &count));
    if (poses ? count < 0 : count != 0 || s->told == told) {
        fuzz_fail(s, "thud_world_get_poses: %d, and %s", count, poses ? "poses" : "none");
    }
    s->calls[s->depth].text = "thud_world_get_poses";
    for (int i = 0; i < count; i++) {
        if (!isnan(poses[i].x)) {
            note_number(s, (double)(poses[i].c * poses[i].c + poses[i].s * poses[i].s));
        }
    }
}

/* ---- drawing ---- */

/* Fails if a drawn coordinate is not finite. */
static void see_number(void *context, double value) {
    fuzz_session *s = context;
    if (!isfinite(value)) {
        fuzz_fail(s, "drawn at %g", value);
    }
}

static void see_vector(void *context, thud_vec2 v) {
    see_number(context, (double)v.x);
    see_number(context, (double)v.y);
}

static void see_circle(thud_vec2 center, float radius, float c, float sine, thud_style style,
                       int island, void *context) {
    (void)style, (void)island;
    see_vector(context, center);
    see_number(context, (double)(radius + c + sine));
    session_ask(context);
}

static void see_box(thud_vec2 center, thud_vec2 half, float c, float sine, thud_style style,
                    int island, void *context) {
    (void)style, (void)island;
    see_vector(context, center);
    see_vector(context, half);
    see_number(context, (double)(c + sine));
}

static void see_line(thud_vec2 a, thud_vec2 b, thud_style style, void *context) {
    (void)style;
    see_vector(context, a);
    see_vector(context, b);
}

static void see_point(thud_vec2 p, thud_style style, void *context) {
    (void)style;
    see_vector(context, p);
}

void play_drawing(fuzz_session *s) {
    unsigned flags = next_byte(&s->bytes) | (unsigned)next_choice(&s->bytes, 32) << 8;
    thud_debug_draw draw = {.flags = flags,
                            .origin = pick_place(s),
                            .lower = pick_place(s),
                            .upper = pick_place(s),
                            .context = s,
                            .circle = flags & 1 ? see_circle : NULL,
                            .box = see_box,
                            .line = see_line,
                            .point = see_point};
    TRY(s, thud_world_draw(s->world, &draw));
}

/* ---- calls that are refused ---- */

void play_refused_worlds(fuzz_session *s) {
    thud_world_def def = s->def;
    unsigned byte = next_byte(&s->bytes);
    double wrong = hostile_number(byte / 8);
    float narrow = (float)fmax(fmin(wrong, (double)FLT_MAX), -(double)FLT_MAX);
    switch (byte % 8) {
    case 0:
        def.time_step = -fabs(wrong);
        break;
    case 1:
        def.length_scale = -fabsf(narrow);
        break;
    case 2:
        def.substeps = 65;
        break;
    case 3:
        def.gravity.x = NAN;
        break;
    case 4:
        def.quality = NULL;
        break;
    case 5:
        def.allocator.release = NULL;
        break;
    case 6:
        def.max_error = -1;
        break;
    default:
        def.job_system.workers = 65;
    }
    thud_world *made = NULL;
    TRY(s, thud_world_create(&def, &made));
    if (s->result == THUD_OK || made) {
        fuzz_fail(s, "a world def is taken that is wrong by %u", byte % 8);
    }
    if (s->depth) {
        int told = s->told;
        COUNTED(thud_world_destroy(s->world));
        if (s->told == told) {
            fuzz_fail(s, "a world is destroyed inside a callback, unheard");
        }
    }
}

/* Fails if a call with a null argument was not refused. */
static void wants_null(fuzz_session *s, thud_result result) {
    fuzz_calls_made++;
    if (result != THUD_ERROR_NULL) {
        fuzz_fail(s, "null is taken: %s", thud_result_text(result));
    }
}

void play_nulls(fuzz_session *s) {
    thud_body_id body = pick_body(s);
    thud_shape_id shape = pick_shape(s);
    thud_pos place = {0, 0};
    thud_vec2 vector = {0, 0};
    bool hit;
    wants_null(s, thud_world_create(NULL, NULL));
    wants_null(s, thud_world_step(NULL));
    wants_null(s, thud_world_advance(NULL, 0, 1, NULL, NULL));
    wants_null(s, thud_world_set_log(NULL, NULL, NULL));
    wants_null(s, thud_world_advance_with(NULL, 0, 1, NULL, NULL, NULL));
    wants_null(s, thud_world_set_gravity(NULL, vector));
    wants_null(s, thud_body_destroy(NULL, body));
    wants_null(s, thud_body_set_transform(NULL, body, place, 0));
    wants_null(s, thud_shape_destroy(NULL, shape));
    wants_null(s, thud_world_cast_ray(NULL, &(thud_ray){place, 1, 0, NULL}, &hit, NULL));
    wants_null(s, thud_world_get_snapshot_size(s->world, NULL));
    wants_null(s, thud_world_restore(s->world, NULL, 0));
    wants_null(s, thud_mover_move(s->world, NULL, vector, 0.1, NULL));
    COUNTED(thud_world_destroy(NULL));
    if (COUNTED(thud_body_is_valid(NULL, body)) || COUNTED(thud_shape_is_valid(NULL, shape)) ||
        COUNTED(thud_events_of(NULL)).begin_count || COUNTED(thud_stats_of(NULL)).bodies) {
        fuzz_fail(s, "there is something in no world");
    }
}
