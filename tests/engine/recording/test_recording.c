/* test_recording.c: recordings (thud_recording.h) of small worlds play to the same hashes: with
 * listeners of every kind, filters, calls inside callbacks, queries, and calls that are not
 * recorded; differences are named; damage is refused; failing allocations do no harm. Random calls
 * of the whole API are recorded by tests/fuzz. */
#include "engine_support.h"

#include "hostile_memory.h"

#include <thud/thud_all.h>

/* Calls of files that do not include thud_recorded.h. */
static thud_result step_unseen(thud_world *world) {
    return thud_world_step(world);
}
static thud_result restore_unseen(thud_world *world, const void *from, size_t bytes) {
    return thud_world_restore(world, from, bytes);
}
static thud_result push_unseen(thud_world *world, thud_body_id body) {
    return thud_body_set_velocity(world, body, (thud_vec2){0.5f, 0}, 0);
}

#include <thud/thud_recorded.h>

/* A floor and balls that fall on it. */
enum { BALLS = 4, STEPS = 130 };

typedef struct game {
    thud_world *world;
    thud_body_id ball[BALLS];
    thud_body_id wall;
    int calls;    /* of callbacks */
    int replaced; /* bodies, by `hit` */
} game;

static game make_game(thud_world_def def) {
    game g = {.world = make_world(def)};
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC, .restitution = 0.3f};
    thud_body_make(g.world, thud_aabb_at(0, -1, 30, 1), NULL);
    g.wall = thud_body_make(g.world, thud_aabb_at(5, 2, 0.5, 2), NULL);
    for (int i = 0; i < BALLS; i++) {
        g.ball[i] = thud_body_make(g.world, thud_circle_at(i * 1.5, 2 + i, 0.5), &ball);
    }
    return g;
}

/* What a game calls in a step, by its number. */
static void play(game *g, int step) {
    thud_body_id ball = g->ball[step % BALLS];
    if (step % 3 == 0) {
        OK(thud_body_apply_center_impulse(g->world, ball, (thud_vec2){0.25f * (step % 7 - 3), 1}));
    }
    if (step % 40 == 10) {
        thud_body_options box = {.kind = THUD_BODY_DYNAMIC, .friction = 0.1f, .user_data = 77};
        assert_true(thud_body_make(g->world, thud_obb_at(-3, 4, 0.5, 0.25, 0.3), &box).index1);
    }
    assert_int_equal(thud_body_set_velocity(g->world, (thud_body_id){0, 0}, (thud_vec2){0, 0}, 0),
                     THUD_ERROR_STALE);
    OK(thud_world_step(g->world));
}

static thud_recorder *begin(thud_world *world, thud_recorder_options options) {
    thud_recorder *recorder = NULL;
    OK(thud_recorder_begin(world, &options, &recorder));
    return recorder;
}

static thud_bytes bytes_of(thud_recorder *recorder) {
    thud_bytes bytes;
    OK(thud_recorder_get_bytes(recorder, &bytes));
    return bytes;
}

static thud_player *open_player(thud_bytes bytes) {
    thud_player *player = NULL;
    OK(thud_player_create(bytes, NULL, &player));
    return player;
}

static thud_player_progress progress_of(const thud_player *player) {
    thud_player_progress progress;
    OK(thud_player_get_progress(player, &progress));
    return progress;
}

static thud_world *world_of(const thud_player *player) {
    thud_world *world = NULL;
    OK(thud_player_get_world((thud_player *)player, &world));
    return world;
}

/* Plays to the end, and expects the state of the world there. */
static void expect_same(thud_bytes bytes, const thud_world *world) {
    thud_player *player = open_player(bytes);
    for (bool stepped = true; stepped;) {
        OK(thud_player_step(player, &stepped));
    }
    thud_player_progress progress = progress_of(player);
    assert_int_equal(progress.steps, progress.end);
    assert_true(progress.hashes > 0);
    assert_int_equal(thud_hash_of(world_of(player)), thud_hash_of(world));
    thud_player_destroy(player);
}

/* ---- calls and steps ---- */

static void calls_are_played(void **state) {
    (void)state;
    for (int quality = 0; quality < QUALITIES; quality++) {
        game g = make_game(thud_default_world_def_of(qualities[quality]));
        thud_recorder *recorder = begin(g.world, (thud_recorder_options){.hash_steps = 1});
        for (int i = 0; i < STEPS; i++) {
            play(&g, i);
        }
        expect_same(bytes_of(recorder), g.world);
        thud_recorder_end(recorder);
        thud_world_destroy(g.world);
    }
}

/* The recording goes on after its bytes were taken. */
static void bytes_can_be_taken_often(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){.body_hashes = true});
    for (int i = 0; i < STEPS; i++) {
        play(&g, i);
        if (i % 50 == 7) {
            expect_same(bytes_of(recorder), g.world);
        }
    }
    thud_bytes first = bytes_of(recorder), again = bytes_of(recorder);
    assert_int_equal(first.count, again.count);
    expect_same(again, g.world);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

static void any_step_is_found(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    uint64_t hashes[STEPS + 1] = {thud_hash_of(g.world)};
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){.keyframe_steps = 25});
    for (int i = 0; i < STEPS; i++) {
        play(&g, i);
        hashes[i + 1] = thud_hash_of(g.world);
    }
    thud_player *player = open_player(bytes_of(recorder));
    for (int i = 0; i < 60; i++) {
        int step = i * 37 % (STEPS + 1);
        OK(thud_player_seek(player, step));
        assert_int_equal(progress_of(player).steps, step);
        assert_int_equal(thud_hash_of(world_of(player)), hashes[step]);
    }
    assert_int_equal(thud_player_seek(player, STEPS + 1), THUD_ERROR_INVALID);
    assert_int_equal(thud_player_seek(player, -1), THUD_ERROR_INVALID);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

static void a_ring_keeps_the_last_steps(void **state) {
    (void)state;
    enum { RING = 40, LONG = 1000 };
    game g = make_game(thud_default_world_def());
    uint64_t hashes[LONG + 1];
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){.ring_steps = RING});
    size_t largest = 0;
    for (int i = 0; i < LONG; i++) {
        OK(thud_body_apply_center_impulse(g.world, g.ball[0], (thud_vec2){0, 0.125f}));
        OK(thud_world_step(g.world));
        hashes[i + 1] = thud_hash_of(g.world);
        size_t count = bytes_of(recorder).count;
        largest = i == 2 * RING ? count + count / 4 : largest;
        assert_true(i <= 2 * RING || count <= largest);
    }
    thud_bytes bytes = bytes_of(recorder);
    thud_player *player = open_player(bytes);
    thud_player_progress progress = progress_of(player);
    assert_int_equal(progress.end, LONG);
    assert_in_range(LONG - progress.first, RING, RING + RING / 4);
    OK(thud_player_seek(player, LONG - RING));
    assert_int_equal(thud_hash_of(world_of(player)), hashes[LONG - RING]);
    thud_player_destroy(player);
    expect_same(bytes, g.world);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* ---- sinks and chunks ---- */

typedef struct tape {
    char bytes[1 << 17];
    size_t count;
    int pieces;
    int allowed; /* pieces until it fails */
} tape;

static bool keep(const void *bytes, size_t count, void *context) {
    tape *t = context;
    assert_true(t->count + count <= sizeof t->bytes);
    memcpy(t->bytes + t->count, bytes, count);
    t->count += count;
    return t->pieces++ < t->allowed;
}

static void a_sink_gets_all(void **state) {
    (void)state;
    static tape t;
    t = (tape){.allowed = 1000};
    game g = make_game(thud_default_world_def());
    thud_recorder_options options = {.hash_steps = 10, .sink = keep, .context = &t};
    thud_recorder *recorder = begin(g.world, options);
    for (int i = 0; i < STEPS; i++) {
        play(&g, i);
    }
    thud_bytes bytes;
    assert_int_equal(thud_recorder_get_bytes(recorder, &bytes), THUD_ERROR_INVALID);
    assert_true(t.pieces > STEPS / 10);
    thud_recorder_end(recorder);
    expect_same((thud_bytes){t.bytes, t.count}, g.world);
    /* One that fails ends the recording, and nothing else. */
    t = (tape){.allowed = 3};
    recorder = begin(g.world, options);
    for (int i = 0; i < STEPS; i++) {
        play(&g, i);
    }
    assert_int_equal(t.pieces, 4);
    assert_int_equal(thud_recorder_add_chunk(recorder, "x", (thud_bytes){NULL, 0}),
                     THUD_ERROR_MEMORY);
    thud_recorder_end(recorder);
    t = (tape){.allowed = 0};
    assert_int_equal(thud_recorder_begin(g.world, &options, &recorder), THUD_ERROR_MEMORY);
    thud_world_destroy(g.world);
}

static void hear(const char *name, thud_bytes bytes, void *context) {
    int *heard = context;
    assert_string_equal(name, *heard == 0 ? "inputs" : "");
    assert_int_equal(bytes.count, *heard == 0 ? 3 : 0);
    assert_true(*heard > 0 || memcmp(bytes.data, "abc", 3) == 0);
    ++*heard;
}

static void chunks_are_kept(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){0});
    play(&g, 0);
    OK(thud_recorder_add_chunk(recorder, "inputs", (thud_bytes){"abc", 3}));
    play(&g, 1);
    OK(thud_recorder_add_chunk(recorder, "", (thud_bytes){NULL, 0}));
    int heard = 0;
    thud_player_options options = {.chunk = hear, .context = &heard};
    thud_player *player;
    OK(thud_player_create(bytes_of(recorder), &options, &player));
    OK(thud_player_step(player, NULL));
    assert_int_equal(heard, 0);
    OK(thud_player_step(player, NULL));
    assert_int_equal(heard, 1);
    OK(thud_player_step(player, NULL));
    assert_int_equal(heard, 2);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* ---- calls that are told ---- */

typedef struct told_calls {
    int count;
    char names[8][40];
    thud_result results[8];
    int value_counts[8];
    thud_call_value values[8][4]; /* the first ones */
    uint32_t returned[8];
} told_calls;

static void note_call(const thud_played_call *call, void *context) {
    told_calls *t = context;
    assert_true(t->count < 8);
    strcpy(t->names[t->count], call->name);
    t->results[t->count] = call->result;
    t->value_counts[t->count] = call->value_count;
    for (int i = 0; i < 4 && i < call->value_count; i++) {
        t->values[t->count][i] = call->values[i];
    }
    t->returned[t->count++] = call->returned;
}

/* A body that is made, moved in vain and in earnest; ground of three points; a restore. */
static void calls_are_told_with_their_arguments(void **state) {
    (void)state;
    thud_world *w = thud_world_make((thud_vec2){0, -10}, &thud_quality_draft);
    thud_body_def still = thud_default_body_def();
    thud_body_id ground;
    OK(thud_body_create(w, &still, &ground));
    thud_recorder *recorder = begin(w, (thud_recorder_options){0});
    thud_body_options fast = {.kind = THUD_BODY_DYNAMIC, .velocity = {3, 4}};
    thud_body_id ball = thud_body_make(w, thud_circle_at(1, 2, 0.5), &fast);
    OK(thud_body_set_velocity(w, ball, (thud_vec2){-7, 0.25f}, 2));
    assert_int_equal(thud_body_set_velocity(w, ball, (thud_vec2){NAN, 0}, 0), THUD_ERROR_INVALID);
    thud_pos points[] = {{0, 0}, {1, 0.5}, {3, 0}};
    thud_terrain hill = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 3};
    thud_shape_def def = thud_default_shape_def();
    OK(thud_shape_create_terrain(w, ground, &def, &hill, NULL));
    OK(thud_world_step(w));
    OK(thud_world_step(w));
    told_calls t = {0};
    thud_player_options options = {.call = note_call, .context = &t};
    thud_player *player;
    OK(thud_player_create(bytes_of(recorder), &options, &player));
    OK(thud_player_step(player, NULL));
    const char *names[] = {"thud_body_make", "thud_body_set_velocity", "thud_body_set_velocity",
                           "thud_shape_create_terrain", "thud_world_step"};
    assert_int_equal(t.count, 5);
    for (int i = 0; i < 5; i++) {
        assert_string_equal(t.names[i], names[i]);
        assert_int_equal(t.results[i], i == 2 ? THUD_ERROR_INVALID : THUD_OK);
        assert_int_equal(t.returned[i], i == 0 ? ball.index1 : i == 3 ? 2 : 0); /* 2: the hill */
    }
    assert_true(t.values[1][0].handle && t.values[1][0].number == ball.index1);
    assert_true(!t.values[1][1].handle && t.values[1][1].number == -7);
    assert_true(t.values[1][2].number == 0.25 && t.values[1][3].number == 2);
    assert_int_equal(t.value_counts[1], 4);
    assert_int_equal(t.value_counts[2], 0);
    assert_true(t.value_counts[3] >= 6);
    assert_int_equal(t.value_counts[4], 0);
    t.count = 0;
    OK(thud_player_step(player, NULL));
    assert_int_equal(t.count, 1);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(w);
}

/* ---- queries ---- */

typedef struct told_queries {
    int count;
    char names[16][40];
    int value_counts[16];
    thud_call_value values[16][4]; /* the first ones */
    int hit_counts[16];
    thud_ray_hit hits[16]; /* the last one of each */
} told_queries;

static void note_query(const thud_played_call *call, void *context) {
    told_queries *t = context;
    if (!call->query) {
        assert_int_equal(call->hit_count, 0);
        return;
    }
    assert_true(t->count < 16);
    assert_int_equal(call->result, THUD_OK);
    strcpy(t->names[t->count], call->name);
    t->value_counts[t->count] = call->value_count;
    for (int i = 0; i < 4; i++) {
        t->values[t->count][i] = call->values[i];
    }
    t->hit_counts[t->count] = call->hit_count;
    if (call->hit_count > 0) {
        t->hits[t->count] = call->hits[call->hit_count - 1];
    }
    t->count++;
}

/* As note_query, of the last query alone. */
static void note_last_query(const thud_played_call *call, void *context) {
    ((told_queries *)context)->count = 0;
    note_query(call, context);
}

static double go_on(const thud_ray_hit *out, void *context) {
    (void)out;
    (void)context;
    return THUD_CAST_ON;
}

static bool find_more(thud_shape_id shape, void *context) {
    (void)shape;
    (void)context;
    return true;
}

/* Makes every query that is recorded, each along or around the row of balls. */
static void ask_everything(thud_world *w, thud_ray_hit *first) {
    thud_ray ray = {.origin = {-9, 2}, .dx = 20}, up = {.origin = {-9, 2}, .dy = 5};
    thud_ray both[] = {ray, up};
    thud_shape_cast cast = {.center = {-9, 2}, .shape = thud_circle_at(0, 0, 0.25), .dx = 20};
    thud_ray_hit hits[8];
    thud_closest_hit closest;
    bool found;
    int count;
    OK(thud_world_cast_ray(w, &ray, &found, first));
    assert_true(found);
    OK(thud_world_cast_ray(w, &up, &found, hits));
    assert_false(found);
    OK(thud_world_cast_ray_all(w, &ray, hits, 1, &count));
    assert_int_equal(count, 2);
    OK(thud_world_cast_ray_each(w, &ray, go_on, NULL));
    OK(thud_world_cast_rays(w, both, 2, hits));
    OK(thud_world_cast_shape(w, &cast, &found, hits));
    OK(thud_world_cast_shape_all(w, &cast, NULL, 0, &count));
    OK(thud_world_cast_shape_each(w, &cast, go_on, NULL));
    OK(thud_world_cast_shapes(w, &cast, 1, hits));
    OK(thud_world_overlap_shape(w, (thud_pos){0, 2}, thud_circle_at(0, 0, 0.25), NULL, find_more,
                                NULL));
    OK(thud_world_overlap_aabb(w, (thud_pos){-1, 1}, (thud_pos){9, 2.25}, NULL, find_more, NULL));
    OK(thud_world_closest(w, (thud_pos){-1, 2}, 5, NULL, &found, &closest));
    assert_int_equal(thud_world_cast_ray(w, NULL, &found, hits), THUD_ERROR_NULL);
}

static void queries_are_told_with_what_they_found(void **state) {
    (void)state;
    static const struct {
        const char *name;
        double value; /* the first or the second one */
        int hits;
        double x; /* of the last hit; 0: it has no point */
    } wanted[] = {{"thud_world_cast_ray", -9, 1, -0.5},
                  {"thud_world_cast_ray", -9, 0, 0},
                  {"thud_world_cast_ray_all", -9, 1, -0.5},
                  {"thud_world_cast_ray_each", -9, 2, 0}, /* in no certain order */
                  {"thud_world_cast_rays", -9, 2, -9},
                  {"thud_world_cast_shape", -9, 1, -0.5},
                  {"thud_world_cast_shape_all", -9, 0, 0},
                  {"thud_world_cast_shape_each", -9, 2, 0},
                  {"thud_world_cast_shapes", -9, 1, -0.5},
                  {"thud_world_overlap_shape", 0, 1, 0},
                  {"thud_world_overlap_aabb", -1, 2, 0},
                  {"thud_world_closest", -1, 1, -0.5}};
    enum { QUERIES = sizeof wanted / sizeof *wanted };
    for (int asked = 0; asked < 2; asked++) {
        game g = make_game(thud_default_world_def());
        thud_recorder *recorder = begin(g.world, (thud_recorder_options){.queries = asked});
        thud_ray_hit first;
        ask_everything(g.world, &first);
        OK(thud_world_step(g.world));
        told_queries t = {0};
        thud_player_options options = {.call = note_query, .context = &t};
        thud_player *player;
        expect_same(bytes_of(recorder), g.world);
        OK(thud_player_create(bytes_of(recorder), &options, &player));
        OK(thud_player_step(player, NULL));
        assert_int_equal(t.count, asked ? QUERIES : 0);
        for (int i = 0; i < t.count; i++) {
            assert_string_equal(t.names[i], wanted[i].name);
            assert_true(t.values[i][0].number == wanted[i].value);
            assert_int_equal(t.hit_counts[i], wanted[i].hits);
            if (wanted[i].x != 0) {
                assert_true(fabs(t.hits[i].point.x - wanted[i].x) < 1e-6);
            }
        }
        if (asked) {
            thud_world *played = world_of(player);
            thud_body_id body;
            assert_true(t.values[0][1].number == 2 && t.values[0][2].number == 20);
            assert_true(t.hits[0].fraction == first.fraction && t.hits[0].normal.x == -1);
            OK(thud_shape_get_body(played, t.hits[0].shape, &body));
            assert_int_equal(body.index1, g.ball[0].index1);
            OK(thud_shape_get_body(played, t.hits[9].shape, &body));
            assert_int_equal(body.index1, g.ball[0].index1);
        }
        thud_player_destroy(player);
        thud_recorder_end(recorder);
        thud_world_destroy(g.world);
    }
}

static double tick(void *context) {
    return *(double *)context += 0.5;
}

/* Times of stages come from the clock of the options, and change no state. */
static void clock_of_the_player_times_its_steps(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){0});
    play(&g, 0);
    double now = 0;
    thud_player_options options = {.clock = tick, .clock_context = &now};
    thud_player *player;
    thud_world *world;
    OK(thud_player_create(bytes_of(recorder), &options, &player));
    OK(thud_player_step(player, NULL));
    OK(thud_player_get_world(player, &world));
    assert_true(thud_stats_of(world).step_seconds > 0);
    assert_true(thud_hash_of(world) == thud_hash_of(g.world));
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* The world keeps a pointer to the name, when the call that brought it is long over. */
static void names_of_qualities_are_kept(void **state) {
    (void)state;
    thud_quality own = thud_quality_draft;
    own.name = "my own";
    thud_world *w = thud_world_make((thud_vec2){0, -10}, &thud_quality_draft), *played;
    thud_recorder *recorder = begin(w, (thud_recorder_options){0});
    OK(thud_world_set_quality(w, &thud_quality_high));
    OK(thud_world_step(w));
    OK(thud_world_set_quality(w, &own));
    OK(thud_world_step(w));
    thud_player *player;
    thud_step_settings settings;
    OK(thud_player_create(bytes_of(recorder), NULL, &player));
    OK(thud_player_get_world(player, &played));
    OK(thud_player_step(player, NULL));
    OK(thud_world_get_step_settings(played, &settings));
    assert_ptr_equal(settings.quality.name, thud_quality_high.name);
    OK(thud_player_step(player, NULL));
    OK(thud_world_get_step_settings(played, &settings));
    assert_string_equal(settings.quality.name, "recorded");
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(w);
}

static void keyframes_are_found(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){.keyframe_steps = 10});
    for (int i = 0; i < 25; i++) {
        play(&g, i);
    }
    thud_player *player;
    int64_t at = -1;
    OK(thud_player_create(bytes_of(recorder), NULL, &player));
    for (int64_t step = 0; step <= 25; step++) {
        OK(thud_player_get_keyframe(player, step, &at));
        assert_int_equal(at, step / 10 * 10);
    }
    assert_int_equal(thud_player_get_keyframe(player, 26, &at), THUD_ERROR_INVALID);
    assert_int_equal(thud_player_get_keyframe(player, -1, &at), THUD_ERROR_INVALID);
    assert_int_equal(thud_player_get_keyframe(player, 0, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_player_get_keyframe(NULL, 0, &at), THUD_ERROR_NULL);
    assert_int_equal(at, 20);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* ---- callbacks ---- */

/* Vetoes, changes and decides, by the number of the call. */
static bool answer(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                   void *context) {
    game *g = context;
    int call = g->calls++;
    if (call % 5 == 1) {
        settings->friction = 0.0f;
        settings->restitution = 0.9f;
    }
    if (call % 17 == 3) {
        thud_velocities up = {{0.5f, 3}, 0.25f};
        bool first = state_of(world, contact->body_a).kind == THUD_BODY_DYNAMIC;
        OK(thud_contact_decide(world, contact, first ? &up : NULL, first ? NULL : &up));
    }
    if (call % 23 == 7) {
        OK(thud_body_set_velocity(world, g->ball[call % BALLS], (thud_vec2){1, 2}, 0));
    }
    return call % 11 != 4;
}

static void answer_all(thud_world *world, const thud_contact *contacts,
                       thud_contact_answer *answers, int count, void *context) {
    for (int i = 0; i < count; i++) {
        answers[i].collide = answer(world, &contacts[i], &answers[i].settings, context);
    }
}

/* Creates a ball now and then, which the next step takes up. */
static void look(thud_world *world, const thud_contact *contact, void *context) {
    (void)contact;
    game *g = context;
    if (g->calls++ % 31 == 9) {
        thud_body_options ball = {.kind = THUD_BODY_DYNAMIC};
        assert_true(
            thud_body_make(world, thud_circle_at(-5 + g->calls % 5, 6, 0.25), &ball).index1);
    }
}

static void look_at_object(thud_world *world, const thud_contact *contact, int side,
                           void *context) {
    (void)contact;
    game *g = context;
    if (side == 0 || g->calls++ % 7 == 3) {
        OK(thud_body_apply_center_impulse(world, g->ball[g->calls % BALLS], (thud_vec2){0.5f, 0}));
    }
}

/* Balls do not meet the wall; those that are made later do. */
static bool let_meet(const thud_world *world, thud_shape_id a, thud_shape_id b, void *context) {
    game *g = context;
    thud_body_id of_a, of_b;
    OK(thud_shape_get_body(world, a, &of_a));
    OK(thud_shape_get_body(world, b, &of_b));
    g->calls++;
    return of_a.index1 != g->wall.index1 && of_b.index1 != g->wall.index1;
}

static void callbacks_are_not_needed(void **state) {
    (void)state;
    enum { PROLOGUES, ALL, OBJECTS, FILTER, LATE, WAYS };
    for (int way = 0; way < WAYS; way++) {
        game g = make_game(thud_default_world_def());
        thud_listeners one = {.prologue = answer, .epilogue = look, .context = &g};
        thud_listeners all = {.prologue_all = answer_all, .epilogue = look, .context = &g};
        thud_recorder *recorder = NULL;
        if (way == LATE) {
            recorder = begin(g.world, (thud_recorder_options){.hash_steps = 1});
            play(&g, 1);
        }
        if (way == PROLOGUES || way == LATE) {
            OK(thud_world_set_listeners(g.world, &one));
        } else if (way == ALL) {
            OK(thud_world_set_listeners(g.world, &all));
        } else if (way == OBJECTS) {
            OK(thud_body_set_epilogue(g.world, g.ball[1], look_at_object, &g));
            OK(thud_world_set_category_epilogue(g.world, 1, look_at_object, &g));
        }
        if (way == FILTER || way == LATE) {
            OK(thud_world_set_filter(g.world, let_meet, &g));
            OK(thud_body_apply_center_impulse(g.world, g.ball[0], (thud_vec2){6, 0}));
        }
        recorder =
            way == LATE
                ? recorder
                : begin(g.world, (thud_recorder_options){.hash_steps = 1, .keyframe_steps = 50});
        for (int i = 0; i < STEPS; i++) {
            play(&g, i);
            if (way == LATE && i == STEPS / 2) {
                OK(thud_world_set_filter(g.world, NULL, NULL));
                OK(thud_body_set_epilogue(g.world, g.ball[1], look_at_object, &g));
            }
        }
        assert_true(g.calls > 10);
        thud_bytes bytes = bytes_of(recorder);
        expect_same(bytes, g.world);
        thud_player *player = open_player(bytes);
        OK(thud_player_seek(player, 70));
        OK(thud_player_seek(player, progress_of(player).end));
        assert_int_equal(thud_hash_of(world_of(player)), thud_hash_of(g.world));
        thud_player_destroy(player);
        thud_recorder_end(recorder);
        /* The caller's callbacks are back. */
        int calls = g.calls;
        OK(thud_body_set_transform(g.world, g.ball[1], (thud_pos){-8, 0.4}, 0));
        OK(thud_body_set_transform(g.world, g.ball[2], (thud_pos){5, 1}, 0));
        run(g.world, 3);
        assert_true(g.calls > calls || way == LATE);
        thud_world_destroy(g.world);
    }
}

/* Replaces two bodies, and sets the velocity of a third one: inside a query, so that it takes
 * effect after what is set when the query is over. */
static bool hit(thud_shape_id shape, void *context) {
    game *g = context;
    thud_body_id body;
    bool found;
    thud_ray_hit first;
    OK(thud_shape_get_body(g->world, shape, &body));
    OK(thud_world_cast_ray(g->world, &(thud_ray){.dx = 9}, &found, &first));
    OK(thud_body_set_velocity(g->world, g->ball[0], (thud_vec2){1, 5}, 0));
    if (state_of(g->world, body).kind == THUD_BODY_DYNAMIC && g->replaced < 2) {
        thud_body_options ball = {.kind = THUD_BODY_DYNAMIC};
        g->replaced++;
        OK(thud_body_destroy(g->world, body));
        assert_true(thud_body_make(g->world, thud_circle_at(-9, 3, 0.5), &ball).index1);
    }
    return true;
}

static void push_each(thud_world *world, void *context) {
    game *g = context;
    bool found;
    thud_ray_hit first;
    OK(thud_world_cast_ray(world, &(thud_ray){.origin = {-9, 0.5}, .dx = 20}, &found, &first));
    OK(thud_body_apply_center_force(world, g->ball[0], (thud_vec2){(float)(g->calls++ % 5), 12}));
}

static bool pass_some(const thud_mover *mover, const thud_mover_hit *what, thud_vec2 velocity,
                      void *context) {
    (void)mover;
    (void)what;
    (void)velocity;
    game *g = context;
    return g->calls++ % 3 != 0;
}

/* Calls inside a query, steps by time with callbacks, and a mover that passes through things and
 * pushes others. */
static void other_callbacks_are_recorded(void **state) {
    (void)state;
    for (int queries = 0; queries < 2; queries++) {
        game g = make_game(thud_default_world_def());
        thud_mover mover = thud_default_mover(thud_circle_at(-2, 0.6, 0.5));
        mover.push_force = 50;
        mover.pass = pass_some;
        mover.context = &g;
        thud_step_calls calls = {.before = push_each, .after = push_each, .context = &g};
        thud_recorder_options options = {.hash_steps = 1, .queries = queries};
        thud_recorder *recorder = begin(g.world, options);
        for (int i = 0; i < STEPS; i++) {
            OK(thud_mover_move(g.world, &mover, (thud_vec2){2, -1}, 1.0 / 60, NULL));
            assert_ptr_equal(mover.context, &g);
            OK(thud_world_advance_with(g.world, 0.03, 5, &calls, NULL, NULL));
            if (i == 20) {
                OK(thud_world_overlap_aabb(g.world, (thud_pos){2, -1}, (thud_pos){9, 9}, NULL, hit,
                                           &g));
                assert_int_equal(g.replaced, 2);
                OK(thud_body_set_velocity(g.world, g.ball[0], (thud_vec2){0, 0}, 0));
            }
            if (i % 30 == 0) {
                OK(thud_world_advance(g.world, 0.04, 3, NULL, NULL));
            }
        }
        expect_same(bytes_of(recorder), g.world);
        thud_recorder_end(recorder);
        thud_world_destroy(g.world);
    }
}

/* ---- what is not recorded ---- */

static void unseen_steps_and_restores_are_noticed(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    static char snapshot[1 << 17], present[1 << 17];
    size_t bytes = 0, now = 0;
    OK(thud_world_snapshot(g.world, snapshot, sizeof snapshot, &bytes));
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){.hash_steps = 1});
    for (int i = 0; i < STEPS; i++) {
        play(&g, i);
        if (i == 20) {
            OK(step_unseen(g.world));
        } else if (i == 60) {
            OK(restore_unseen(g.world, snapshot, bytes));
        } else if (i == 70) {
            OK(thud_world_restore(g.world, snapshot, bytes));
        } else if (i == 80) { /* of the same step, which only a recorded call tells */
            OK(thud_world_snapshot(g.world, present, sizeof present, &now));
            OK(thud_body_set_velocity(g.world, g.ball[0], (thud_vec2){9, 9}, 0));
            OK(thud_world_restore(g.world, present, now));
        }
    }
    OK(step_unseen(g.world));
    expect_same(bytes_of(recorder), g.world);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

static void a_difference_is_named(void **state) {
    (void)state;
    game g = make_game(weightless());
    thud_recorder *recorder =
        begin(g.world, (thud_recorder_options){.hash_steps = 4, .body_hashes = true});
    for (int i = 0; i < 30; i++) {
        OK(thud_world_step(g.world));
        if (i == 16) {
            OK(push_unseen(g.world, g.ball[2]));
        }
    }
    thud_player *player = open_player(bytes_of(recorder));
    thud_result result = THUD_OK;
    for (bool stepped = true; stepped && result == THUD_OK;) {
        result = thud_player_step(player, &stepped);
    }
    thud_player_progress progress = progress_of(player);
    assert_int_equal(result, THUD_ERROR_INVALID);
    assert_true(progress.differs);
    assert_int_equal(progress.differs_after, 16);
    assert_int_equal(progress.differs_at, 20);
    assert_int_equal(progress.body.index1, g.ball[2].index1);
    assert_int_equal(thud_player_step(player, NULL), THUD_ERROR_INVALID);
    OK(thud_player_seek(player, 8));
    assert_false(progress_of(player).differs);
    assert_int_equal(thud_player_seek(player, 28), THUD_ERROR_INVALID);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    /* A call that gives another result. */
    recorder = begin(g.world, (thud_recorder_options){0});
    play(&g, 10);
    thud_bytes bytes = bytes_of(recorder);
    player = open_player(bytes);
    assert_true(thud_body_make(world_of(player), thud_circle_at(0, 50, 1), NULL).index1);
    assert_int_equal(thud_player_step(player, NULL), THUD_ERROR_INVALID);
    assert_true(progress_of(player).differs);
    thud_player_destroy(player);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* ---- refusals ---- */

static int told;

static void count_told(thud_result result, const char *message, void *context) {
    (void)result;
    (void)context;
    assert_true(strlen(message) > 10);
    told++;
}

static thud_recorder *shared;

static bool call_inside(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *settings, void *context) {
    (void)contact;
    (void)settings;
    thud_recorder *recorder = NULL;
    thud_bytes bytes;
    ++*(int *)context;
    assert_int_equal(thud_recorder_begin(world, NULL, &recorder), THUD_ERROR_LOCKED);
    assert_int_equal(thud_recorder_get_bytes(shared, &bytes), THUD_ERROR_LOCKED);
    assert_int_equal(thud_recorder_add_chunk(shared, "x", (thud_bytes){"x", 1}), THUD_ERROR_LOCKED);
    thud_recorder_end(shared);
    return true;
}

static double stand_still(void *context) {
    (void)context;
    return 0;
}

static void wrong_calls_are_refused(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = NULL, *other = NULL;
    OK(thud_world_set_log(g.world, count_told, NULL));
    assert_int_equal(thud_recorder_begin(NULL, NULL, &recorder), THUD_ERROR_NULL);
    assert_int_equal(thud_recorder_begin(g.world, NULL, NULL), THUD_ERROR_NULL);
    thud_recorder_options wrong[] = {{.hash_steps = -1},
                                     {.keyframe_steps = THUD_RECORDING_STEPS_MAX + 1},
                                     {.ring_steps = -5},
                                     {.ring_steps = 5, .sink = keep}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        told = 0;
        assert_int_equal(thud_recorder_begin(g.world, &wrong[i], &recorder), THUD_ERROR_INVALID);
        assert_int_equal(told, 1);
    }
    OK(thud_recorder_begin(g.world, NULL, &recorder));
    assert_int_equal(thud_recorder_begin(g.world, NULL, &other), THUD_ERROR_INVALID);
    assert_int_equal(thud_recorder_get_bytes(NULL, &(thud_bytes){NULL, 0}), THUD_ERROR_NULL);
    assert_int_equal(thud_recorder_get_bytes(recorder, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_recorder_add_chunk(recorder, NULL, (thud_bytes){"", 0}), THUD_ERROR_NULL);
    assert_int_equal(thud_recorder_add_chunk(recorder, "a", (thud_bytes){NULL, 1}),
                     THUD_ERROR_NULL);
    int asked = 0;
    shared = recorder;
    set_listeners(g.world, call_inside, NULL, &asked);
    run(g.world, 60);
    assert_true(asked > 0);
    thud_recorder_end(NULL);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
    thud_world_def def = thud_default_world_def();
    def.time_budget = 1e-3;
    def.clock = stand_still;
    g = make_game(def);
    assert_int_equal(thud_recorder_begin(g.world, NULL, &recorder), THUD_ERROR_INVALID);
    thud_world_destroy(g.world);
    assert_int_equal(thud_player_create((thud_bytes){NULL, 0}, NULL, &(thud_player *){NULL}),
                     THUD_ERROR_NULL);
    assert_int_equal(thud_player_step(NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_player_seek(NULL, 0), THUD_ERROR_NULL);
    assert_int_equal(thud_player_get_world(NULL, NULL), THUD_ERROR_NULL);
    assert_int_equal(thud_player_get_progress(NULL, NULL), THUD_ERROR_NULL);
    thud_player_destroy(NULL);
}

/* The recording goes with the world. */
static void a_world_may_be_destroyed_first(void **state) {
    (void)state;
    static char copy[1 << 16];
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder = begin(g.world, (thud_recorder_options){0});
    play(&g, 0);
    thud_bytes bytes = bytes_of(recorder);
    assert_true(bytes.count <= sizeof copy);
    memcpy(copy, bytes.data, bytes.count);
    thud_world_destroy(g.world);
    bytes = bytes_of(recorder);
    assert_memory_equal(bytes.data, copy, bytes.count);
    OK(thud_recorder_add_chunk(recorder, "late", (thud_bytes){"x", 1}));
    thud_recorder_end(recorder);
}

static void damage_is_refused(void **state) {
    (void)state;
    game g = make_game(thud_default_world_def());
    thud_recorder *recorder =
        begin(g.world, (thud_recorder_options){.hash_steps = 5, .keyframe_steps = 10});
    for (int i = 0; i < 20; i++) {
        play(&g, i);
    }
    thud_bytes bytes = bytes_of(recorder);
    char *copy = malloc(bytes.count + 1);
    thud_player *player = NULL;
    thud_player_options options = {.log = count_told};
    for (size_t i = 0; i <= bytes.count; i++) {
        size_t count = i < bytes.count ? i : bytes.count + 1; /* cut short, and with a byte more */
        memcpy(copy, bytes.data, bytes.count);
        told = 0;
        assert_int_equal(thud_player_create((thud_bytes){copy, count}, &options, &player),
                         THUD_ERROR_INVALID);
        assert_int_equal(told, 1);
        if (i < bytes.count) {
            copy[i] ^= (char)(1 << i % 8);
            assert_int_equal(thud_player_create((thud_bytes){copy, bytes.count}, &options, &player),
                             THUD_ERROR_INVALID);
        }
    }
    free(copy);
    thud_recorder_end(recorder);
    thud_world_destroy(g.world);
}

/* ---- crashes ---- */

typedef struct crash {
    thud_recorder *recorder;
    thud_bytes bytes;
    int after; /* callbacks */
} crash;

/* A prologue that makes calls, and takes what there is of the recording as if it crashed. */
static bool crash_in_prologue(thud_world *world, const thud_contact *contact,
                              thud_contact_settings *settings, void *context) {
    (void)contact;
    (void)settings;
    crash *c = context;
    thud_body_id body;
    OK(thud_shape_get_body(world, contact->shape_b, &body));
    OK(thud_body_apply_center_impulse(world, body, (thud_vec2){0.125f, 0}));
    if (c->after-- == 0) {
        OK(thud_recorder_salvage(c->recorder, &c->bytes));
    }
    return true;
}

/* A recording that is taken in the midst of a step has this step as its last one. */
static void a_crash_leaves_what_led_to_it(void **state) {
    (void)state;
    for (int way = 0; way < 4; way++) {
        bool inside = way > 0, advances = way == 2, rings = way == 3;
        game g = make_game(thud_default_world_def());
        crash c = {.recorder = begin(g.world, (thud_recorder_options){.hash_steps = 1,
                                                                      .ring_steps = rings ? 8 : 0}),
                   .after = inside ? 40 : -1};
        thud_listeners l = {.prologue = crash_in_prologue, .context = &c};
        if (inside) {
            OK(thud_world_set_listeners(g.world, &l));
        }
        uint64_t last = 0, steps = 0; /* before the crash */
        while (!c.bytes.data && steps < 200) {
            last = thud_hash_of(g.world);
            steps = thud_stats_of(g.world).steps;
            if (!inside && steps == 50) {
                OK(thud_recorder_salvage(c.recorder, &c.bytes));
            } else if (advances) {
                OK(thud_world_advance(g.world, 1.0 / 60, 1, NULL, NULL));
            } else {
                OK(thud_world_step(g.world));
            }
        }
        assert_non_null(c.bytes.data);
        thud_player *player = open_player(c.bytes);
        assert_int_equal(progress_of(player).end, steps + inside);
        OK(thud_player_seek(player, (int64_t)steps));
        assert_int_equal(thud_hash_of(world_of(player)), last);
        bool stepped;
        OK(thud_player_step(player, &stepped));
        assert_int_equal(stepped, inside);
        OK(thud_player_step(player, &stepped));
        assert_false(stepped || progress_of(player).differs);
        thud_player_destroy(player);
        thud_bytes again;
        assert_int_equal(thud_recorder_get_bytes(c.recorder, &again), THUD_ERROR_MEMORY);
        thud_recorder_end(c.recorder);
        OK(thud_world_step(g.world));
        thud_world_destroy(g.world);
    }
    thud_bytes bytes;
    assert_int_equal(thud_recorder_salvage(NULL, &bytes), THUD_ERROR_NULL);
}

/* ---- memory ---- */

static void failing_memory_does_no_harm(void **state) {
    (void)state;
    thud_world_def def = thud_default_world_def();
    def.allocator = hostile_memory();
    uint64_t straight = 0;
    int lost = 0;
    for (int allowed = -1; allowed < 60; allowed++) {
        game g = make_game(def);
        run(g.world, 40);
        memory_allowed = allowed;
        thud_recorder_options options = {.hash_steps = 1, .keyframe_steps = 5, .queries = true};
        thud_recorder *recorder = NULL;
        thud_result result = thud_recorder_begin(g.world, &options, &recorder);
        assert_true(result == THUD_OK || (result == THUD_ERROR_MEMORY && allowed >= 0));
        for (int i = 0; i < 20; i++) {
            bool found;
            thud_ray_hit first;
            result = thud_world_cast_ray(g.world, &(thud_ray){.dx = 9}, &found, &first);
            assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
            result = thud_body_set_velocity(g.world, g.ball[i % BALLS], (thud_vec2){1, 2}, 0);
            result = result == THUD_OK ? thud_world_step(g.world) : result;
            if (result == THUD_ERROR_MEMORY) {
                OK(thud_world_step(g.world));
            }
        }
        memory_allowed = -1;
        straight = allowed < 0 ? thud_hash_of(g.world) : straight;
        assert_int_equal(thud_hash_of(g.world), straight);
        thud_bytes bytes;
        if (recorder) {
            result = thud_recorder_get_bytes(recorder, &bytes);
            lost += result == THUD_ERROR_MEMORY;
            if (result == THUD_OK) {
                expect_same(bytes, g.world);
            }
        }
        if (recorder && result == THUD_OK) {
            memory_allowed = allowed;
            thud_player *player = NULL;
            told_queries t = {.count = 0};
            thud_player_options own = {.allocator = def.allocator,
                                       .call = note_last_query,
                                       .context = &t};
            result = thud_player_create(bytes, &own, &player);
            for (bool stepped = true; result == THUD_OK && stepped;) {
                result = thud_player_step(player, &stepped);
            }
            memory_allowed = -1;
            assert_true(result == THUD_OK || result == THUD_ERROR_MEMORY);
            thud_player_destroy(player);
        }
        thud_recorder_end(recorder);
        thud_world_destroy(g.world);
        assert_int_equal(memory_held, 0);
    }
    assert_true(lost > 0 && memory_refused > 30);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(calls_are_played),
        cmocka_unit_test(bytes_can_be_taken_often),
        cmocka_unit_test(any_step_is_found),
        cmocka_unit_test(a_ring_keeps_the_last_steps),
        cmocka_unit_test(a_sink_gets_all),
        cmocka_unit_test(chunks_are_kept),
        cmocka_unit_test(calls_are_told_with_their_arguments),
        cmocka_unit_test(queries_are_told_with_what_they_found),
        cmocka_unit_test(clock_of_the_player_times_its_steps),
        cmocka_unit_test(names_of_qualities_are_kept),
        cmocka_unit_test(keyframes_are_found),
        cmocka_unit_test(callbacks_are_not_needed),
        cmocka_unit_test(other_callbacks_are_recorded),
        cmocka_unit_test(unseen_steps_and_restores_are_noticed),
        cmocka_unit_test(a_difference_is_named),
        cmocka_unit_test(wrong_calls_are_refused),
        cmocka_unit_test(a_world_may_be_destroyed_first),
        cmocka_unit_test(damage_is_refused),
        cmocka_unit_test(a_crash_leaves_what_led_to_it),
        cmocka_unit_test(failing_memory_does_no_harm),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
