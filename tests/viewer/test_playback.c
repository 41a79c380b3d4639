/* test_playback.c: tests how the viewer shows recordings, by its keys and its pointer, on a screen
 * that nobody sees. */
#define _POSIX_C_SOURCE 200809L
#include "crash.h"
#include "input.h"
#include "draw/palette.h"
#include "panel/hud.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef _WIN32
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

#include <cmocka.h>
#include <thud/thud_recording.h>

/* Pushes a body by a call that is not recorded. */
static thud_result push_in_secret(thud_world *world, thud_body_id body) {
    return thud_body_set_velocity(world, body, (thud_vec2){-3, 0}, 0);
}

/* Last: the calls below are recorded. */
#include <thud/thud_recorded.h>

#define OK(call) assert_int_equal(call, THUD_OK)

enum { STEPS = 50, ASKED = 10, PUSHED = 20, DROPPED = 30, WIDTH = 1000, HEIGHT = 300 };

static const char FILE_NAME[] = "test_playback.rec";

/* What was recorded: the hash of the world after so many steps. */
static uint64_t hashes[STEPS + 1];

static void write_file(const char *path, const void *bytes, size_t count) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fclose(file), 0);
}

static bool find_all(thud_shape_id shape, void *context) {
    (void)shape;
    (void)context;
    return true;
}

/* Asks in four ways where the ball is, and what is below it. */
static void ask(thud_world *world) {
    thud_ray down = {.origin = {0, 9}, .dy = -20};
    thud_shape_cast along = {.center = {-3, 0.5}, .shape = thud_circle_at(0, 0, 0.4), .dx = 2};
    thud_ray_hit hit;
    thud_closest_hit closest;
    bool found;
    OK(thud_world_cast_ray(world, &down, &found, &hit));
    OK(thud_world_cast_shape(world, &along, &found, &hit));
    OK(thud_world_overlap_aabb(world, (thud_pos){-1, -1}, (thud_pos){1, 4}, NULL, find_all, NULL));
    OK(thud_world_closest(world, (thud_pos){1, 3}, 5, NULL, &found, &closest));
}

/* Records a ball that falls on ground, is asked for after ASKED steps, is pushed after PUSHED
 * steps, and is joined by a second one after DROPPED. `secret`: after 35 steps it also gets a push
 * that is not recorded. */
static void record(const char *path, bool secret) {
    thud_world *world = thud_world_make((thud_vec2){0, -10}, &thud_quality_default);
    thud_body_make(world, thud_aabb_at(0, -1, 40, 2), NULL);
    thud_body_options falls = {.kind = THUD_BODY_DYNAMIC};
    thud_body_id ball = thud_body_make(world, thud_circle_at(0, 3, 0.5), &falls);
    thud_recorder_options options = {.hash_steps = 1,
                                     .body_hashes = true,
                                     .keyframe_steps = 16,
                                     .queries = true};
    thud_recorder *recorder = NULL;
    OK(thud_recorder_begin(world, &options, &recorder));
    for (int i = 0; i < STEPS; i++) {
        hashes[i] = thud_hash_of(world);
        if (i == ASKED)
            ask(world);
        if (i == PUSHED)
            OK(thud_body_set_velocity(world, ball, (thud_vec2){2, 1.5f}, 0));
        if (i == DROPPED)
            assert_true(thud_body_make(world, thud_circle_at(4, 3, 0.5), &falls).index1 > 0);
        if (i == 35 && secret)
            OK(push_in_secret(world, ball));
        OK(thud_world_step(world));
    }
    hashes[STEPS] = thud_hash_of(world);
    thud_bytes bytes;
    OK(thud_recorder_get_bytes(recorder, &bytes));
    write_file(path, bytes.data, bytes.count);
    thud_recorder_end(recorder);
    thud_world_destroy(world);
}

/* ---- a viewer ---- */

typedef struct screen {
    viewer v;
    SDL_Surface *surface;
    SDL_Renderer *renderer;
} screen;

static screen *open_screen(void) {
    screen *s = calloc(1, sizeof *s);
    assert_non_null(s);
    viewer_init(&s->v);
    assert_true(catalog_init(&s->v.catalog, "no levels"));
    s->surface = SDL_CreateRGBSurfaceWithFormat(0, WIDTH, HEIGHT, 32, SDL_PIXELFORMAT_ARGB8888);
    s->renderer = SDL_CreateSoftwareRenderer(s->surface);
    assert_true(s->renderer && canvas_init(&s->v.canvas, s->renderer, 1));
    viewer_layout(&s->v);
    return s;
}

static void close_screen(screen *s) {
    canvas_free(&s->v.canvas);
    viewer_free(&s->v);
    SDL_DestroyRenderer(s->renderer);
    SDL_FreeSurface(s->surface);
    free(s);
}

/* A frame of the viewer, and what is needed for a seek that it began, also by drawing buttons. */
static void frame(screen *s, double elapsed) {
    input_poll(&s->v, NULL);
    viewer_advance(&s->v, elapsed);
    viewer_draw(&s->v);
    while (s->v.session.played && s->v.session.played->target >= 0)
        viewer_advance(&s->v, 0);
}

static void press(screen *s, SDL_Keycode key, bool shift) {
    SDL_Event event = {.key = {.type = SDL_KEYDOWN}};
    event.key.keysym.sym = key;
    event.key.keysym.mod = shift ? KMOD_LSHIFT : KMOD_NONE;
    assert_int_equal(SDL_PushEvent(&event), 1);
    frame(s, 0);
}

static void drop(screen *s, const char *path) {
    SDL_Event event = {.drop = {.type = SDL_DROPFILE, .file = SDL_strdup(path)}};
    assert_int_equal(SDL_PushEvent(&event), 1);
    frame(s, 0);
}

static void point(screen *s, Uint32 type, int x, int y) {
    SDL_Event event = {.type = type};
    if (type == SDL_MOUSEMOTION) {
        event.motion.x = x;
        event.motion.y = y;
    } else {
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = x;
        event.button.y = y;
    }
    assert_int_equal(SDL_PushEvent(&event), 1);
    frame(s, 0);
}

/* Pixels of this colour. */
static int pixels_of(const screen *s, SDL_Color color) {
    int count = 0;
    for (int y = 0; y < HEIGHT; y++) {
        const Uint32 *row =
            (const Uint32 *)((const char *)s->surface->pixels + (size_t)y * s->surface->pitch);
        for (int x = 0; x < WIDTH; x++)
            count += (row[x] & 0xFFFFFF) == (Uint32)(color.r << 16 | color.g << 8 | color.b);
    }
    return count;
}

static void stands_at(screen *s, int step) {
    assert_int_equal(s->v.session.played->progress.steps, step);
    assert_true(thud_hash_of(s->v.session.world) == hashes[step]);
    /* The bodies for drawing are those of this step: the third one is there from DROPPED on. */
    assert_int_equal(s->v.session.body_count, step > DROPPED ? 3 : 2);
}

/* ---- tests ---- */

static void keys_go_to_every_step(void **state) {
    (void)state;
    record(FILE_NAME, false);
    screen *s = open_screen();
    assert_true(viewer_open_recording(&s->v, FILE_NAME));
    assert_string_equal(s->v.session.scene.title, "test_playback");
    stands_at(s, 0);
    press(s, SDLK_RIGHT, false);
    stands_at(s, 1);
    press(s, SDLK_n, false);
    stands_at(s, 2);
    press(s, SDLK_END, false);
    stands_at(s, STEPS);
    press(s, SDLK_LEFT, false);
    stands_at(s, STEPS - 1);
    for (int step = STEPS - 2; step >= 0; step--) {
        press(s, SDLK_LEFT, false);
        stands_at(s, step);
    }
    press(s, SDLK_LEFT, false);
    stands_at(s, 0);
    press(s, SDLK_RIGHT, true);
    stands_at(s, STEPS);
    press(s, SDLK_HOME, false);
    stands_at(s, 0);
    assert_true(s->v.session.paused);
    assert_string_equal(s->v.session.message, "");
    close_screen(s);
}

static void it_plays_pauses_at_its_end_and_begins_again(void **state) {
    (void)state;
    screen *s = open_screen();
    assert_true(viewer_open_recording(&s->v, FILE_NAME));
    s->v.session.speed = 0.5;
    for (int i = 0; i < 20; i++)
        frame(s, 1.0 / 60);
    assert_in_range(s->v.session.played->progress.steps, 9, 11);
    press(s, SDLK_SPACE, false);
    int64_t there = s->v.session.played->progress.steps;
    frame(s, 1);
    assert_int_equal(s->v.session.played->progress.steps, there);
    press(s, SDLK_SPACE, false);
    for (int i = 0; i < STEPS / 2; i++)
        frame(s, 4.0 / 60);
    stands_at(s, STEPS);
    assert_true(s->v.session.paused);
    press(s, SDLK_SPACE, false);
    frame(s, 2.5 / 60);
    assert_in_range(s->v.session.played->progress.steps, 1, 2);
    close_screen(s);
}

static void the_pointer_draws_the_line_of_steps(void **state) {
    (void)state;
    screen *s = open_screen();
    assert_true(viewer_open_recording(&s->v, FILE_NAME));
    frame(s, 0);
    int y = HEIGHT - (int)hud_footer(&s->v) + 18, x = 0;
    /* The line is where a press goes on: buttons left of it act, and the steps rise along it. */
    int64_t last = 0;
    for (x = 450; x < 700; x += 50) {
        point(s, SDL_MOUSEBUTTONDOWN, x, y);
        assert_true(s->v.scrubbing);
        assert_true(s->v.session.played->progress.steps >= last);
        last = s->v.session.played->progress.steps;
        stands_at(s, (int)last);
        point(s, SDL_MOUSEMOTION, x - 20, y - 200);
        assert_true(s->v.session.played->progress.steps <= last);
        point(s, SDL_MOUSEBUTTONUP, x, y);
        assert_false(s->v.scrubbing);
    }
    assert_in_range(last, 20, STEPS);
    close_screen(s);
}

static void calls_of_a_step_are_listed(void **state) {
    (void)state;
    screen *s = open_screen();
    assert_true(viewer_open_recording(&s->v, FILE_NAME));
    const playback *p = s->v.session.played;
    press(s, SDLK_i, false);
    assert_true(s->v.lists_calls);
    for (int step = STEPS; step > 0; step--) {
        viewer_go_to(&s->v, step);
        frame(s, 0);
        bool asked = step == ASKED + 1, changed = step == PUSHED + 1 || step == DROPPED + 1;
        assert_int_equal(p->call_count, asked ? 4 : changed);
        assert_int_equal(p->query_count, asked ? 4 : 0);
        assert_int_equal(pixels_of(s, COLOR_INTERVAL) > 0, asked);
        if (step == PUSHED + 1)
            assert_string_equal(p->calls[0], "thud_body_set_velocity(#2, 2, 1.5, 0)");
        if (step == DROPPED + 1)
            assert_non_null(strstr(p->calls[0], "thud_body_make("));
    }
    viewer_go_to(&s->v, ASKED + 1);
    frame(s, 0);
    assert_string_equal(p->calls[0], "thud_world_cast_ray(0, 9, 0, -20): 1 hit");
    assert_string_equal(p->calls[3], "thud_world_closest(1, 3, 5): 1 hit");
    /* The ball above, by rays and shapes that begin where they were told to. */
    const playback_query *q = p->queries;
    assert_true(q[0].ray && q[0].shape.y == 9 && q[0].dy == -20 && q[0].points);
    assert_true(q[0].hits[0].point.y > 2 && q[0].hits[0].point.y < 3.5);
    assert_true(!q[1].ray && q[1].shape.hx == 0.4 && q[1].shape.x == -3 && q[1].dx == 2);
    assert_true(!q[2].points && q[2].shape.y == 1.5 && q[2].shape.hy == 2.5);
    assert_int_equal(q[2].hit_count, 2);
    assert_true(q[3].ray && q[3].dx < 0);
    press(s, SDLK_i, false);
    assert_false(s->v.lists_calls);
    assert_int_equal(pixels_of(s, COLOR_INTERVAL), 0);
    close_screen(s);
}

static void a_fork_goes_on_by_hand_and_back(void **state) {
    (void)state;
    screen *s = open_screen();
    session *shown = &s->v.session;
    assert_true(viewer_open_recording(&s->v, FILE_NAME));
    s->v.ui.x = 600;
    s->v.ui.y = 120;
    for (int step = 0; step <= 40; step += 20) {
        viewer_go_to(&s->v, step);
        frame(s, 0);
        int bodies = shown->body_count;
        press(s, SDLK_c, false);
        press(s, SDLK_x, false);
        assert_non_null(strstr(shown->message, "Fork"));
        stands_at(s, step);
        press(s, SDLK_h, false);
        assert_string_equal(shown->message, "");
        press(s, SDLK_c, false);
        assert_int_equal(shown->body_count, bodies + 1);
        press(s, SDLK_n, false);
        press(s, SDLK_RIGHT, false);
        assert_int_equal(shown->played->forked_steps, 2);
        assert_true(thud_hash_of(shown->world) != hashes[step + 2]);
        thud_pos at = thud_position_of(shown->world, shown->bodies[1].id);
        assert_true(grab_start(&s->v.grab, shown, at, 0.01));
        press(s, SDLK_h, false);
        assert_false(s->v.grab.held);
        stands_at(s, step);
        press(s, SDLK_RIGHT, false);
        stands_at(s, step + 1);
    }
    close_screen(s);
}

static void what_differs_is_told_and_marked(void **state) {
    (void)state;
    record("differs.rec", true);
    screen *s = open_screen();
    session *shown = &s->v.session;
    assert_true(viewer_open_recording(&s->v, "differs.rec"));
    viewer_go_to(&s->v, 40);
    frame(s, 0);
    assert_string_equal(shown->message, "The state differs after step 35, at step 36, first in the "
                                        "body of slot 1 (#2)");
    assert_int_equal(shown->played->progress.steps, 36);
    assert_true(shown->paused);
    press(s, SDLK_h, false);
    assert_false(shown->played->forked);
    press(s, SDLK_LEFT, false);
    assert_string_equal(shown->message, "");
    stands_at(s, 35);
    /* After the next keyframe all is as recorded. */
    viewer_go_to(&s->v, 49);
    frame(s, 0);
    stands_at(s, 49);
    close_screen(s);
    remove("differs.rec");
}

/* The text at the foot that tells of bisection is there where the recording's detection is that. */
static void the_detection_of_the_recording_is_shown(void **state) {
    (void)state;
    static const char path[] = "test_detection.rec";
    int without = 0; /* pixels of the text's colour elsewhere */
    for (int choice = 1; choice < DETECTION_CHOICES; choice++) {
        thud_world_def def = thud_default_world_def();
        def.detection = DETECTIONS[choice].detection;
        thud_world *world = NULL;
        OK(thud_world_create(&def, &world));
        thud_body_options falls = {.kind = THUD_BODY_DYNAMIC};
        thud_body_make(world, thud_circle_at(0, 3, 0.5), &falls);
        thud_recorder *recorder = NULL;
        OK(thud_recorder_begin(world, NULL, &recorder));
        OK(thud_world_step(world));
        thud_bytes bytes;
        OK(thud_recorder_get_bytes(recorder, &bytes));
        write_file(path, bytes.data, bytes.count);
        thud_recorder_end(recorder);
        thud_world_destroy(world);

        screen *s = open_screen();
        s->v.session.detection = DETECTION_CHOICES - choice;
        drop(s, path);
        press(s, SDLK_RIGHT, false);
        assert_int_equal(session_detection(&s->v.session), choice);
        bool bisects = DETECTIONS[choice].detection == &thud_detection_bisect;
        int pixels = pixels_of(s, COLOR_TIMINGS);
        without = choice == 1 ? pixels : without;
        assert_true((pixels > without) == bisects);
        drop(s, "tests/viewer/ball.tmj");
        assert_int_equal(session_detection(&s->v.session), DETECTION_CHOICES - choice);
        close_screen(s);
    }
    remove(path);
}

static void a_wrong_file_changes_nothing(void **state) {
    (void)state;
    screen *s = open_screen();
    session *shown = &s->v.session;
    char bytes[4000];
    FILE *file = fopen(FILE_NAME, "rb");
    size_t count = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    write_file("short.rec", bytes, count / 2);
    write_file("foreign.rec", "no recording", 12);
    const struct {
        const char *path, *words;
    } cases[] = {{"short.rec", "damaged"},
                 {"foreign.rec", "neither a recording nor a level"},
                 {"missing.rec", "neither a recording nor a level"}};
    for (int played = 0; played < 2; played++) {
        assert_true(played ? viewer_open_recording(&s->v, FILE_NAME) : viewer_open(&s->v, 0));
        press(s, SDLK_n, false);
        const thud_world *world = shown->world;
        uint64_t hash = thud_hash_of(world);
        for (int i = 0; i < 3; i++) {
            drop(s, cases[i].path);
            assert_non_null(strstr(shown->message, cases[i].words));
            assert_ptr_equal(shown->world, world);
            assert_true(thud_hash_of(world) == hash && shown->paused);
        }
        press(s, SDLK_n, false);
        assert_true(thud_hash_of(world) != hash);
    }
    close_screen(s);
    remove("short.rec");
    remove("foreign.rec");
}

static void a_recording_is_dropped_and_a_scene_follows(void **state) {
    (void)state;
    screen *s = open_screen();
    assert_true(viewer_open(&s->v, 0));
    s->v.session.paused = true;
    drop(s, FILE_NAME);
    assert_non_null(s->v.session.played);
    assert_false(s->v.session.paused);
    drop(s, FILE_NAME);
    press(s, SDLK_e, false);
    assert_non_null(strstr(s->v.session.message, "detection"));
    press(s, SDLK_r, false);
    stands_at(s, 0);
    press(s, SDLK_PAGEDOWN, false);
    assert_null(s->v.session.played);
    assert_int_equal(s->v.selected, 0);
    close_screen(s);
    remove(FILE_NAME);
}

/* Opens a scene and does in it what a user can do, for so many steps. */
static void play_scene(screen *s, const char *name, int steps) {
    viewer *v = &s->v;
    assert_true(viewer_open(v, catalog_find(&v->catalog, name)));
    v->ui.x = 600;
    v->ui.y = 120;
    for (int i = 0; i < steps; i++) {
        const SDL_Keycode keys[] = {SDLK_c, SDLK_b, SDLK_x, SDLK_g, SDLK_m, SDLK_q, SDLK_DELETE};
        if (i % 20 == 10)
            press(s, keys[i / 20 % 7], i % 40 == 10);
        if (i % 50 == 30) {
            thud_pos at = thud_position_of(v->session.world, v->session.bodies[1].id);
            grab_start(&v->grab, &v->session, at, 0.1);
        }
        grab_move(&v->grab, &v->session, (thud_pos){0.1 * i, 8});
        if (i % 50 == 45)
            grab_end(&v->grab, &v->session);
        viewer_step_once(v);
    }
    grab_end(&v->grab, &v->session);
    press(s, SDLK_t, false);
}

/* Whatever users do, and scenes do by themselves, and levels with a character. */
static void the_last_seconds_are_saved(void **state) {
    (void)state;
    enum { RATE = 4, KEPT = LAST_SECONDS * RATE };
    const char *const names[] = {"digging", "crates", "meetings", "boats", "ragdolls"};
    screen *s = open_screen();
    session *shown = &s->v.session;
    for (int i = 0; i < 5; i++) {
        char path[80];
        snprintf(path, sizeof path, "%s-1.rec", names[i]);
        remove(path);
        int steps = i == 0 ? KEPT + 60 : 100;
        shown->step_rate = i == 0 ? RATE : 0;
        shown->paused = true;
        play_scene(s, names[i], steps);
        assert_non_null(strstr(shown->message, path));
        uint64_t hash = thud_hash_of(shown->world);
        double height = shown->scene.camera_height;
        assert_true(viewer_open_recording(&s->v, path));
        const playback *p = shown->played;
        assert_true(shown->scene.camera_height == height);
        assert_int_equal(p->progress.end, steps);
        assert_true(p->progress.first == 0 ? steps < KEPT
                                           : p->progress.first >= steps - KEPT - KEPT / 2 &&
                                                 p->progress.first <= steps - KEPT);
        while (playback_goes_on(p))
            viewer_step_once(&s->v);
        assert_string_equal(shown->message, "");
        assert_true(thud_hash_of(shown->world) == hash);
        press(s, SDLK_t, false);
        assert_non_null(strstr(shown->message, "this is a recording"));
        remove(path);
    }
    close_screen(s);
}

static void a_body_that_is_stopped_is_worth_a_recording(void **state) {
    (void)state;
    screen *s = open_screen();
    session *shown = &s->v.session;
    assert_true(viewer_open(&s->v, catalog_find(&s->v.catalog, "tall_stack")));
    press(s, SDLK_n, false);
    assert_string_equal(shown->message, "");
    for (int i = 0; i < 2; i++)
        OK(thud_body_apply_center_force(shown->world, shown->bodies[9].id, (thud_vec2){3e38f, 0}));
    press(s, SDLK_n, false);
    assert_non_null(strstr(shown->message, "T saves a recording"));
    remove("tall_stack-1.rec");
    press(s, SDLK_t, false);
    uint64_t hash = thud_hash_of(shown->world);
    assert_true(viewer_open_recording(&s->v, "tall_stack-1.rec"));
    press(s, SDLK_END, false);
    assert_true(thud_hash_of(shown->world) == hash);
    close_screen(s);
    remove("tall_stack-1.rec");
}

#ifndef _WIN32
/* A prologue that crashes. */
static bool crash(thud_world *world, const thud_contact *contact, thud_contact_settings *settings,
                  void *context) {
    (void)world;
    (void)contact;
    (void)settings;
    (void)context;
    raise(SIGSEGV);
    return true;
}

/* Opens the first scene, makes STEPS steps of it, and crashes within one, or after them. */
static void run_and_crash(bool within) {
    screen *s = open_screen();
    session *shown = &s->v.session;
    crash_watch(shown);
    if (!viewer_open(&s->v, 0) || !freopen("crash.txt", "w", stderr))
        exit(1);
    for (int i = 0; i < STEPS; i++)
        session_step(shown);
    if (within) {
        (void)!thud_world_set_listeners(shown->world, &(thud_listeners){.prologue = crash});
        session_step(shown);
    }
    raise(SIGABRT);
    exit(1);
}

static void a_crash_saves_what_led_to_it(void **state) {
    (void)state;
    for (int within = 0; within < 2; within++) {
        remove("pyramid-1.rec");
        pid_t child = fork();
        if (child == 0)
            run_and_crash(within);
        int status = 0;
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), within ? SIGSEGV : SIGABRT);
        screen *s = open_screen();
        assert_true(viewer_open_recording(&s->v, "pyramid-1.rec"));
        playback *p = s->v.session.played;
        assert_int_equal(p->progress.end, STEPS + within);
        viewer_go_to(&s->v, p->progress.end);
        frame(s, 0);
        assert_int_equal(p->progress.steps, p->progress.end);
        assert_false(p->stopped || p->progress.differs);
        close_screen(s);
    }
    remove("pyramid-1.rec");
    remove("crash.txt");
}
#endif

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_go_to_every_step),
        cmocka_unit_test(it_plays_pauses_at_its_end_and_begins_again),
        cmocka_unit_test(the_pointer_draws_the_line_of_steps),
        cmocka_unit_test(calls_of_a_step_are_listed),
        cmocka_unit_test(a_fork_goes_on_by_hand_and_back),
        cmocka_unit_test(what_differs_is_told_and_marked),
        cmocka_unit_test(the_detection_of_the_recording_is_shown),
        cmocka_unit_test(a_wrong_file_changes_nothing),
        cmocka_unit_test(a_recording_is_dropped_and_a_scene_follows),
        cmocka_unit_test(the_last_seconds_are_saved),
        cmocka_unit_test(a_body_that_is_stopped_is_worth_a_recording),
#ifndef _WIN32
        cmocka_unit_test(a_crash_saves_what_led_to_it),
#endif
    };
    SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
    if (SDL_Init(SDL_INIT_VIDEO) != 0)
        return 1;
    int failed = cmocka_run_group_tests(tests, NULL, NULL);
    SDL_Quit();
    return failed;
}
