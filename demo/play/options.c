/* options.c: see options.h. */
#include "options.h"

#include "input.h"
#include "draw/picture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    FRAMES_MAX = 1000000,
    SIDE_MIN = 64,
    SIDE_MAX = 8192,
    STEP_RATE_MAX = 1000,    /* steps a second */
    TOP_SPEED_MAX = 1000000, /* length scales a second; THUD_SPEED_MAX */
};

void options_print_help(void) {
    printf(
        "usage: thud-play [SCENE|LEVEL.tmj|LEVEL.tmx|RECORDING] [OPTION...]\n"
        "\n"
        "Shows a built-in scene or a level of the Tiled editor, and lets you play with it. What\n"
        "of a level cannot be modelled is left out, and listed on standard error. Or plays a\n"
        "recording, as thud-run --record, the page and programs make them: step by step, back,\n"
        "slowly, and from any step on by hand. A level or recording may also be dropped on the\n"
        "window.\n"
        "\n"
        "  --replay FILE      play a recording\n"
        "  --calls            list the calls of each step of a recording\n"
        "  --list             print what there is to show\n"
        "  --size WxH         size of the window or picture (1280x800)\n"
        "  --quality Q        draft, default, high or exact\n"
        "  --detection D      overlap, continuous, bisect or swept (continuous)\n"
        "  --broadphase B     grid, sweep, sweep_y, sweep_widest, sweep_both or all (grid)\n"
        "  --rate N           steps a second, 1 to 1000 (60)\n"
        "  --top-speed N      clamps x and y of every velocity to N length scales a second, 1 to\n"
        "                     1000000; a text says whether bisection may miss something then\n"
        "  --workers N        threads that step the world, 1 to 64 (1)\n"
        "  --overlay LIST     contacts, normals, bounds, cells, islands, sleeping, timings, axes,\n"
        "                     pairs, motions, joints, forces, separated by commas; or all, or none\n"
        "                     (sleeping, joints, and what the scene is there to show)\n"
        "  --look L           of scene minkowski's pairs: sum, closest or bounds (sum)\n"
        "  --paused           do not start yet\n"
        "  --bare             no panel and no texts\n"
        "  --frames N         end after N frames\n"
        "  --screenshot FILE  needs no display: runs N steps of --frames (0), writes the\n"
        "                     picture to FILE.png or FILE.bmp, and ends\n"
        "  --help             this\n"
        "\n"
        "%s",
        INPUT_HELP);
}

/* Prints an error message; returns false. */
static bool complain(const char *what, const char *argument) {
    fprintf(stderr, "thud-play: %s '%s'; see thud-play --help\n", what, argument);
    return false;
}

/* Parses a whole number in [low, high] that is followed by the character `end`. *rest becomes the
 * text after it, if `rest` is not null. */
static bool parse_number(const char *text, long low, long high, char end, int *out,
                         const char **rest) {
    char *stop;
    if (*text < '0' || *text > '9')
        return false;
    long value = strtol(text, &stop, 10);
    if (*stop != end || value < low || value > high)
        return false;
    *out = (int)value;
    if (rest)
        *rest = stop + 1;
    return true;
}

static bool parse_frames(options *o, const char *text) {
    return parse_number(text, 0, FRAMES_MAX, '\0', &o->frames, NULL) ||
           complain("--frames needs a number from 0 to 1000000, not", text);
}

static bool parse_size(options *o, const char *text) {
    const char *height;
    return (parse_number(text, SIDE_MIN, SIDE_MAX, 'x', &o->width, &height) &&
            parse_number(height, SIDE_MIN, SIDE_MAX, '\0', &o->height, NULL)) ||
           complain("--size needs WIDTHxHEIGHT, each from 64 to 8192, not", text);
}

static bool parse_step_rate(options *o, const char *text) {
    return parse_number(text, 1, STEP_RATE_MAX, '\0', &o->step_rate, NULL) ||
           complain("--rate needs a number from 1 to 1000, not", text);
}

static bool parse_top_speed(options *o, const char *text) {
    return parse_number(text, 1, TOP_SPEED_MAX, '\0', &o->top_speed, NULL) ||
           complain("--top-speed needs a number from 1 to 1000000, not", text);
}

static bool parse_workers(options *o, const char *text) {
    return parse_number(text, 1, THUD_WORKERS_MAX, '\0', &o->workers, NULL) ||
           complain("--workers needs a number from 1 to 64, not", text);
}

static bool parse_quality(options *o, const char *text) {
    o->quality = quality_find(text);
    return o->quality >= 0 || complain("--quality needs draft, default, high or exact, not", text);
}

static bool parse_detection(options *o, const char *text) {
    o->detection = detection_find(text);
    return o->detection >= 0 ||
           complain("--detection needs overlap, continuous, bisect or swept, not", text);
}

static bool parse_broadphase(options *o, const char *text) {
    o->broadphase = broadphase_find(text);
    return o->broadphase >= 0 ||
           complain("--broadphase needs grid, sweep, sweep_y, sweep_widest, sweep_both or all, not",
                    text);
}

static bool parse_overlays(options *o, const char *text) {
    o->overlays_given = true;
    return overlays_parse(text, &o->overlays) || complain("there is no such overlay in", text);
}

static bool parse_look(options *o, const char *text) {
    int look = pair_look_find(text);
    o->pair_look = look < 0 ? PAIR_SUM : (pair_look)look;
    return look >= 0 || complain("--look needs sum, closest or bounds, not", text);
}

static bool parse_replay(options *o, const char *text) {
    o->replay = text;
    return true;
}

static bool parse_screenshot(options *o, const char *text) {
    o->screenshot = text;
    return picture_has_format(text) ||
           complain("--screenshot writes .png and .bmp files only, not", text);
}

/* Parses an option with a value, which may be null. False after a message. *known: `name` is such
 * an option. */
static bool parse_valued(options *o, const char *name, const char *value, bool *known) {
    static const struct {
        const char *name;
        bool (*parse)(options *o, const char *text);
    } table[] = {
        {"--frames", parse_frames},         {"--size", parse_size},
        {"--quality", parse_quality},       {"--detection", parse_detection},
        {"--broadphase", parse_broadphase}, {"--overlay", parse_overlays},
        {"--screenshot", parse_screenshot}, {"--look", parse_look},
        {"--rate", parse_step_rate},        {"--top-speed", parse_top_speed},
        {"--workers", parse_workers},       {"--replay", parse_replay},
    };
    *known = true;
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (strcmp(name, table[i].name) == 0)
            return value ? table[i].parse(o, value) : complain("a value has to follow", name);
    *known = false;
    return true;
}

/* Parses an option without a value. False after a message. */
static bool parse_switch(options *o, const char *name) {
    const struct {
        const char *name;
        bool *value;
    } table[] = {{"--calls", &o->calls},
                 {"--list", &o->list},
                 {"--paused", &o->paused},
                 {"--bare", &o->bare}};
    for (size_t i = 0; i < sizeof table / sizeof table[0]; i++)
        if (strcmp(name, table[i].name) == 0) {
            *table[i].value = true;
            return true;
        }
    return complain("there is no option", name);
}

bool options_parse(options *o, int argc, char **argv) {
    *o = (options){.frames = -1,
                   .width = 1280,
                   .height = 800,
                   .overlays = OVERLAYS_DEFAULT,
                   .quality = QUALITY_DEFAULT,
                   .detection = DETECTION_DEFAULT,
                   .broadphase = BROADPHASE_DEFAULT};
    for (int i = 1; i < argc; i++)
        o->help = o->help || strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0;
    for (int i = 1; i < argc && !o->help; i++) {
        bool known;
        if (!parse_valued(o, argv[i], i + 1 < argc ? argv[i + 1] : NULL, &known))
            return false;
        if (known) {
            i++;
        } else if (argv[i][0] == '-') {
            if (!parse_switch(o, argv[i]))
                return false;
        } else if (o->show) {
            return complain("only one scene or level can be shown, so not also", argv[i]);
        } else {
            o->show = argv[i];
        }
    }
    if (o->show && o->replay)
        return complain("--replay plays a recording, and so does not show", o->show);
    return true;
}
