/* main.c: the program thud-play: a viewer in a window, or a picture without a display. */
#define SDL_MAIN_HANDLED
#include "crash.h"
#include "input.h"
#include "options.h"
#include "draw/picture.h"
#include "viewer.h"

#include <SDL.h>
#include <stdio.h>
#include <stdlib.h>

/* s. Min time between frames, also where the display does not limit their rate. Chosen. */
static const double FRAME_SHORTEST = 1.0 / 250;

static int fail(const char *what) {
    fprintf(stderr, "thud-play: %s: %s\n", what, SDL_GetError());
    return EXIT_FAILURE;
}

static void print_list(const catalog *c) {
    for (int i = 0; i < c->count; i++) {
        const catalog_entry *entry = &c->entries[i];
        if (entry->info)
            printf("%-16s %s\n", entry->info->name, entry->info->about);
        else
            printf("%s\n", entry->path);
    }
}

/* The path of the recording that the command line names, or null. */
static const char *recording_of(const options *o) {
    return o->replay ? o->replay : o->show && playback_is_recording(o->show) ? o->show : NULL;
}

/* Opens the first scene, level or recording with the options of the command line. False after a
 * message. */
static bool open_first(viewer *v, const options *o) {
    const char *recording = recording_of(o);
    int entry = o->show && !recording ? catalog_find(&v->catalog, o->show) : 0;
    if (entry == -1) {
        fprintf(stderr,
                "thud-play: there is no scene '%s', and it is no .tmj file and no recording; "
                "see thud-play --list\n",
                o->show);
        return false;
    }
    v->bare = o->bare;
    v->lists_calls = o->calls;
    v->pair_look = o->pair_look;
    v->session.quality = o->quality;
    v->session.detection = o->detection;
    v->session.broadphase = o->broadphase;
    v->session.step_rate = o->step_rate;
    v->session.top_speed = o->top_speed;
    v->session.paused = o->paused;
    if (o->workers > 1 && thud_threads_create(o->workers, NULL, &v->session.threads) != THUD_OK)
        fprintf(stderr, "thud-play: threads cannot be created; running on one thread\n");
    viewer_layout(v);
    if (recording ? viewer_open_recording(v, recording) : viewer_open(v, entry)) {
        if (o->overlays_given)
            v->overlays = o->overlays, v->lent = 0;
        return true;
    }
    fprintf(stderr, "thud-play: %s\n", v->session.message);
    return false;
}

/* Runs the steps that the options ask for, and writes a picture. Returns the exit status. */
static int take_picture(viewer *v, const options *o) {
    SDL_Surface *surface =
        SDL_CreateRGBSurfaceWithFormat(0, o->width, o->height, 32, SDL_PIXELFORMAT_ARGB8888);
    SDL_Renderer *renderer = surface ? SDL_CreateSoftwareRenderer(surface) : NULL;
    int status = EXIT_FAILURE;
    if (!renderer || !canvas_init(&v->canvas, renderer, 1)) {
        fail("cannot draw");
    } else if (open_first(v, o)) {
        for (int i = 0; i < o->frames && !o->paused; i++)
            viewer_step_once(v);
        v->ui.x = v->ui.y = -1;
        viewer_draw(v);
        status = picture_save(surface, o->screenshot) ? EXIT_SUCCESS : fail(o->screenshot);
    }
    canvas_free(&v->canvas);
    SDL_DestroyRenderer(renderer);
    SDL_FreeSurface(surface);
    return status;
}

static double seconds_now(void) {
    return (double)SDL_GetPerformanceCounter() / (double)SDL_GetPerformanceFrequency();
}

/* The loop of events, steps and drawing, until the viewer quits or `frames` frames are drawn; < 0:
 * no limit. */
static void run(viewer *v, SDL_Window *window, int frames) {
    double last = seconds_now();
    for (int i = 0; (frames < 0 || i < frames) && !v->quit; i++) {
        double now = seconds_now();
        if (now - last < FRAME_SHORTEST) {
            SDL_Delay((Uint32)((FRAME_SHORTEST - (now - last)) * 1e3) + 1);
            now = seconds_now();
        }
        double elapsed = now - last;
        last = now;
        v->frame_seconds += 0.05 * (elapsed - v->frame_seconds);
        input_poll(v, window);
        viewer_advance(v, elapsed);
        viewer_draw(v);
    }
}

/* Opens the window and runs the viewer in it. Returns the exit status. */
static int play(viewer *v, const options *o) {
    int status = EXIT_FAILURE;
    SDL_Renderer *renderer = NULL;
    SDL_Window *window =
        SDL_CreateWindow("thud", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, o->width,
                         o->height, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
    if (window)
        renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
    int pixels = o->width;
    if (!renderer || SDL_GetRendererOutputSize(renderer, &pixels, NULL) != 0 ||
        !canvas_init(&v->canvas, renderer, (float)pixels / (float)o->width)) {
        fail("cannot open a window");
    } else if (open_first(v, o)) {
        v->frame_seconds = 1.0 / 60;
        crash_watch(&v->session);
        run(v, window, o->frames);
        crash_watch(NULL);
        status = EXIT_SUCCESS;
    }
    canvas_free(&v->canvas);
    SDL_DestroyRenderer(renderer);
    SDL_DestroyWindow(window);
    return status;
}

int main(int argc, char **argv) {
    options o;
    if (!options_parse(&o, argc, argv))
        return EXIT_FAILURE;
    if (o.help) {
        options_print_help();
        return EXIT_SUCCESS;
    }
    viewer *v = malloc(sizeof *v);
    if (v)
        viewer_init(v);
    if (!v || !catalog_init(&v->catalog, THUD_PLAY_LEVELS)) {
        fprintf(stderr, "thud-play: out of memory\n");
        free(v);
        return EXIT_FAILURE;
    }
    int status = EXIT_SUCCESS;
    if (o.list) {
        print_list(&v->catalog);
    } else {
        SDL_SetMainReady();
        if (o.screenshot)
            SDL_SetHint(SDL_HINT_VIDEODRIVER, "dummy");
        if (SDL_Init(SDL_INIT_VIDEO) != 0)
            status = fail("cannot start SDL");
        else
            status = o.screenshot ? take_picture(v, &o) : play(v, &o);
    }
    viewer_free(v);
    free(v);
    SDL_Quit();
    return status;
}
