/* thud_network.c: the program thud-network, which measures what the delay of a network costs, and
 * writes it as JSON to stdout. People call ./run network, which makes docs/network.md of it. */
#include "json.h"
#include "machine.h"
#include "measure.h"
#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { REPETITIONS_MAX = 100, RUNS_MAX = 64, NAMES_MAX = 16 };

/* Simulated steps of a run, and of one with --quick: a minute, and five seconds. */
enum { STEPS = 3600, STEPS_QUICK = 300 };

/* The networks, from none at all to one on which nobody would want to play. A datagram that is held
 * up takes as long as three frames more. */
static const measure_line LINES[] = {
    {.name = "steady"},
    {"ordinary", .jitter = 10, .loss = 0.01, .duplicates = 0.01, .held = 0.01, .held_for = 50},
    {"bad", .jitter = 30, .loss = 0.05, .duplicates = 0.02, .held = 0.05, .held_for = 50},
    {"worst", .jitter = 60, .loss = 0.1, .duplicates = 0.05, .held = 0.1, .held_for = 50},
};
enum { LINE_COUNT = sizeof LINES / sizeof *LINES };
static const int DELAYS[] = {0, 30, 60, 120, 250};
enum { DELAY_COUNT = sizeof DELAYS / sizeof *DELAYS };
/* All lines and delays are played by so many; one of them by fewer, too. */
enum { PLAYERS = 4, FEWER_LINE = 1, FEWER_DELAY = 120 };

typedef struct named_plan {
    char name[64];
    measure_plan plan;
} named_plan;

typedef struct options {
    bool help, list, quick;
    int repetitions;
    const char *only[NAMES_MAX];
    int only_count;
} options;

static const char USAGE[] =
    "usage: thud-network [OPTION...]\n"
    "\n"
    "Plays a game over simulated networks, and writes what their delay costs as JSON to stdout.\n"
    "\n"
    "  --run NAME     only this run; may be given several times\n"
    "  --repeat N     timed repetitions, 1 to 100 (default 5, with --quick 1)\n"
    "  --quick        five seconds of each run, which show that it works\n"
    "  --list         names the runs\n"
    "  --help         this\n";

static bool refuse(const char *what, const char *which) {
    fprintf(stderr, "thud-network: %s%s%s (--help shows the options)\n", what, which ? " " : "",
            which ? which : "");
    return false;
}

static int list_plans(named_plan *out, const options *o) {
    int count = 0;
    for (int line = 0; line < LINE_COUNT; line++) {
        for (int delay = 0; delay < DELAY_COUNT; delay++) {
            bool fewer = line == FEWER_LINE && DELAYS[delay] == FEWER_DELAY;
            for (int players = fewer ? 2 : PLAYERS; players <= PLAYERS; players++) {
                named_plan *n = &out[count++];
                n->plan = (measure_plan){.line = &LINES[line],
                                         .delay = DELAYS[delay],
                                         .players = players,
                                         .steps = o->quick ? STEPS_QUICK : STEPS,
                                         .repetitions = o->repetitions};
                snprintf(n->name, sizeof n->name, "%s, %d ms, %d players", LINES[line].name,
                         DELAYS[delay], players);
            }
        }
    }
    return count;
}

static bool read_options(options *o, int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : NULL;
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            o->help = true;
        } else if (strcmp(argv[i], "--list") == 0) {
            o->list = true;
        } else if (strcmp(argv[i], "--quick") == 0) {
            o->quick = true;
        } else if (strcmp(argv[i], "--run") != 0 && strcmp(argv[i], "--repeat") != 0) {
            return refuse("unknown option", argv[i]);
        } else if (!value) {
            return refuse("a value is missing after", argv[i]);
        } else if (strcmp(argv[i++], "--run") == 0) {
            if (o->only_count == NAMES_MAX) {
                return refuse("too many runs are named", NULL);
            }
            o->only[o->only_count++] = value;
        } else {
            char *end;
            long n = strtol(value, &end, 10);
            if (end == value || *end || n < 1 || n > REPETITIONS_MAX) {
                return refuse("--repeat wants a number from 1 to 100, not", value);
            }
            o->repetitions = (int)n;
        }
    }
    o->repetitions = o->repetitions ? o->repetitions : o->quick ? 1 : 5;
    return true;
}

static void write_spread(json *out, const char *key, const measure_spread *s) {
    json_begin_object(out, key);
    json_number(out, "mean", s->mean);
    json_number(out, "p99", s->p99);
    json_number(out, "max", s->max);
    json_end(out);
}

static void write_run(json *out, const named_plan *n, const measure_result *r) {
    const measure_line *line = n->plan.line;
    json_begin_object(out, NULL);
    json_text(out, "name", n->name);
    json_text(out, "line", line->name);
    json_number(out, "delay", n->plan.delay);
    json_number(out, "players", n->plan.players);
    json_number(out, "steps", n->plan.steps);
    json_number(out, "jitter", line->jitter);
    json_number(out, "loss", line->loss);
    json_number(out, "duplicates", line->duplicates);
    json_number(out, "held", line->held);
    json_number(out, "held_for", line->held_for);
    json_number(out, "lost", (double)r->wire.lost / (double)r->wire.sent);
    json_number(out, "overtaken", (double)r->wire.overtaken / (double)r->wire.delivered);
    json_number(out, "replayed", r->replayed);
    json_number(out, "replayed_max", r->replayed_max);
    json_number(out, "waits", r->waits);
    json_number(out, "ms_step", r->ms_step);
    json_number(out, "ms_median", r->ms_median);
    json_number(out, "ms_p99", r->ms_p99);
    json_number(out, "bytes", r->bytes);
    json_number(out, "bytes_in_all", r->bytes_in_all);
    json_number(out, "bytes_states", r->bytes_states);
    json_begin_array(out, "ways");
    for (int way = 0; way < WAY_COUNT; way++) {
        json_begin_object(out, NULL);
        json_text(out, "way", MEASURE_WAYS[way]);
        write_spread(out, "place", &r->of[way].place);
        write_spread(out, "angle", &r->of[way].angle);
        write_spread(out, "place_jump", &r->of[way].place_jump);
        write_spread(out, "angle_jump", &r->of[way].angle_jump);
        json_end(out);
    }
    json_end(out);
    json_end(out);
}

static bool is_wanted(const options *o, const char *name) {
    for (int i = 0; i < o->only_count; i++) {
        if (strcmp(o->only[i], name) == 0) {
            return true;
        }
    }
    return o->only_count == 0;
}

static bool knows_all(const options *o, const named_plan *plans, int count) {
    for (int i = 0; i < o->only_count; i++) {
        bool is_known = false;
        for (int k = 0; k < count; k++) {
            is_known |= strcmp(plans[k].name, o->only[i]) == 0;
        }
        if (!is_known) {
            return refuse("there is no run", o->only[i]);
        }
    }
    return true;
}

static bool run_plans(const options *o, const named_plan *plans, int count) {
    json out = {.file = stdout};
    json_begin_object(&out, NULL);
    machine_describe(&out);
    json_bool(&out, "quick", o->quick);
    json_begin_array(&out, "runs");
    for (int i = 0; i < count; i++) {
        measure_result result;
        if (!is_wanted(o, plans[i].name)) {
            continue;
        }
        progress_show(plans[i].name, (double)i / count);
        if (!measure_run(&plans[i].plan, &result)) {
            progress_clear();
            return refuse("memory is short, or players did not agree in", plans[i].name);
        }
        write_run(&out, &plans[i], &result);
        fflush(stdout);
    }
    progress_clear();
    json_end(&out);
    json_end(&out);
    return (fflush(stdout) == 0 && !ferror(stdout)) || refuse("cannot write to stdout", NULL);
}

int main(int argc, char **argv) {
    options o = {0};
    if (!read_options(&o, argc, argv)) {
        return 2;
    }
    if (o.help) {
        fputs(USAGE, stdout);
        return 0;
    }
    named_plan plans[RUNS_MAX];
    int count = list_plans(plans, &o);
    for (int i = 0; o.list && i < count; i++) {
        puts(plans[i].name);
    }
    if (o.list) {
        return 0;
    }
    return knows_all(&o, plans, count) && run_plans(&o, plans, count) ? 0 : 1;
}
