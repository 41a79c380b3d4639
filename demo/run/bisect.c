/* bisect.c: see bisect.h. */
#define _POSIX_C_SOURCE 200809L

#include "bisect.h"

#include <thud/thud_lists.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* Steps from one hash that is compared in the first pass to the next. Chosen: what is played again
 * is then at most as much, and a keyframe's distance. */
enum { COARSE_STEPS = 64 };

/* ---- this build ---- */

/* Steps that are played, with their hashes. */
typedef struct stretch {
    thud_player *player;
    int64_t next, to, every;
    bool over;
} stretch;

static thud_player_progress progress_of(const thud_player *player) {
    thud_player_progress p;
    thud_player_get_progress(player, &p);
    return p;
}

static uint64_t hash_now(thud_player *player) {
    thud_world *world = NULL;
    thud_player_get_world(player, &world);
    return thud_hash_of(world);
}

/* Goes to the last keyframe at or before a step. False after a message. */
static bool begin(stretch *s, thud_player *player, const long *steps) {
    int64_t keyframe = 0;
    int64_t end = progress_of(player).end;
    *s = (stretch){.player = player,
                   .next = steps[0],
                   .to = steps[1] < end ? steps[1] : end,
                   .every = steps[2]};
    if (thud_player_get_keyframe(player, steps[0], &keyframe) == THUD_OK &&
        thud_player_seek(player, keyframe) == THUD_OK)
        return true;
    fprintf(stderr, "thud-run: the recording has no step %ld\n", steps[0]);
    return false;
}

/* Plays to the next step whose hash is wanted. False if there is none. At the end of the recording
 * the calls after its last step are made, too. */
static bool next_hash(stretch *s, int64_t *step, uint64_t *hash) {
    thud_player_progress p = progress_of(s->player);
    thud_result result = THUD_OK;
    if (s->over || s->next > s->to)
        return false;
    while (result == THUD_OK && p.steps < s->next) {
        result = thud_player_step(s->player, NULL);
        p = progress_of(s->player);
    }
    if (result == THUD_OK && p.steps == p.end)
        result = thud_player_step(s->player, NULL);
    *step = p.steps;
    *hash = hash_now(s->player);
    s->over = result != THUD_OK;
    while (s->next <= p.steps)
        s->next += s->every;
    if (s->next > s->to && p.steps < s->to)
        s->next = s->to; /* the last one is always wanted */
    return true;
}

bool bisect_print_hashes(const run_options *options, thud_player *player) {
    stretch s;
    int64_t step;
    uint64_t hash;
    if (!begin(&s, player, options->hashes))
        return false;
    while (next_hash(&s, &step, &hash))
        printf("%" PRId64 " %016" PRIx64 "\n", step, hash);
    return true;
}

/* FNV-1a over the bytes of a number. */
static uint64_t mix(uint64_t hash, double number) {
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    for (int i = 0; i < 8; i++)
        hash = (hash ^ (bits >> 8 * i & 0xff)) * 0x100000001b3u;
    return hash;
}

/* The hash of what a body shows: its pose and its velocity. */
static uint64_t body_hash(const thud_world *world, thud_body_id id) {
    thud_body_state b;
    if (thud_body_get_state(world, id, &b) != THUD_OK)
        return 0;
    const double numbers[] = {b.position.x, b.position.y, b.cosine,          b.sine,
                              b.velocity.x, b.velocity.y, b.angular_velocity};
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        hash = mix(hash, numbers[i]);
    return hash;
}

/* The bodies of a world; null if memory runs out. */
static thud_body_id *list_bodies(const thud_world *world, int *count) {
    *count = 0;
    thud_world_get_bodies(world, NULL, 0, count);
    thud_body_id *ids = malloc((size_t)*count * sizeof *ids + 1);
    if (ids)
        thud_world_get_bodies(world, ids, *count, count);
    else
        fprintf(stderr, "thud-run: out of memory\n");
    return ids;
}

/* Plays to a step, from the last keyframe before it: one at the step would hide what differs. False
 * after a message. */
static bool go_to(thud_player *player, long step, int64_t *at, uint64_t *hash) {
    thud_player_progress p = progress_of(player);
    long before = step > p.first && step <= p.end ? step - 1 : step;
    stretch s;
    if (!begin(&s, player, (const long[]){before, before, 1}))
        return false;
    s.next = step;
    s.to = progress_of(player).end;
    if (next_hash(&s, at, hash))
        return true;
    fprintf(stderr, "thud-run: the recording has no step %ld\n", step);
    return false;
}

bool bisect_print_bodies(const run_options *options, thud_player *player) {
    thud_world *world = NULL;
    int64_t step;
    uint64_t hash;
    int count;
    if (!go_to(player, options->hash_at, &step, &hash))
        return false;
    thud_player_get_world(player, &world);
    thud_body_id *ids = list_bodies(world, &count);
    if (!ids)
        return false;
    printf("%" PRId64 " %016" PRIx64 "\n", step, hash);
    for (int i = 0; i < count; i++)
        printf("%" PRIu32 " %016" PRIx64 "\n", ids[i].index1 - 1, body_hash(world, ids[i]));
    free(ids);
    return true;
}

/* ---- the other build ---- */

typedef struct other {
    pid_t process;
    FILE *lines; /* what it prints; null: it could not be started */
} other;

/* Runs the other build with an option and its value. */
static other ask(const run_options *options, const char *option, const char *value) {
    int ends[2];
    other o = {.process = -1};
    if (pipe(ends) != 0)
        return o;
    o.process = fork();
    if (o.process == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        execlp(options->bisect, options->bisect, "--replay", options->replay, option, value,
               (char *)NULL);
        fprintf(stderr, "thud-run: %s cannot be run\n", options->bisect);
        _exit(127);
    }
    close(ends[1]);
    o.lines = o.process > 0 ? fdopen(ends[0], "r") : NULL;
    if (!o.lines)
        close(ends[0]);
    return o;
}

/* Reads a line of two numbers. False at the end, or where there is another line. */
static bool read_line(other *o, int64_t *number, uint64_t *hash) {
    return o->lines && fscanf(o->lines, "%" SCNd64 " %16" SCNx64, number, hash) == 2;
}

/* Waits until it has ended; what it would still print is not read. */
static void dismiss(other *o) {
    if (o->lines)
        fclose(o->lines);
    if (o->process > 0)
        waitpid(o->process, NULL, 0);
}

/* ---- comparing ---- */

typedef enum verdict { SAME, DIFFERENT, NO_ANSWER } verdict;

/* What a comparison of steps found. */
typedef struct found {
    int64_t same;  /* the last step that is the same; -1: none is */
    int64_t other; /* the first that is not */
} found;

/* Compares hashes from a step on. */
static verdict compare(const run_options *options, thud_player *player, int64_t from, int64_t to,
                       int every, found *out) {
    char value[80];
    stretch s;
    int64_t mine, its;
    uint64_t my_hash, its_hash;
    verdict result = SAME;
    *out = (found){.same = -1};
    snprintf(value, sizeof value, "%" PRId64 ",%" PRId64 ",%d", from, to, every);
    if (!begin(&s, player, (const long[]){(long)from, (long)to, every}))
        return NO_ANSWER;
    other o = ask(options, "--hashes", value);
    while (result == SAME && next_hash(&s, &mine, &my_hash)) {
        if (!read_line(&o, &its, &its_hash)) {
            result = NO_ANSWER;
        } else if (mine != its || my_hash != its_hash) {
            out->other = mine < its ? mine : its;
            result = DIFFERENT;
        } else {
            out->same = mine;
        }
    }
    dismiss(&o);
    return result;
}

/* Finds the first body that differs after a step. False if none does, or there is no answer. */
static bool find_body(const run_options *options, thud_player *player, int64_t step,
                      int64_t *slot) {
    char value[40];
    int64_t at, its;
    uint64_t hash, its_hash;
    int count = 0;
    thud_world *world = NULL;
    if (!go_to(player, (long)step, &at, &hash))
        return false;
    thud_player_get_world(player, &world);
    thud_body_id *ids = list_bodies(world, &count);
    snprintf(value, sizeof value, "%" PRId64, step);
    other o = ask(options, "--hash-at", value);
    bool answers = ids && read_line(&o, &its, &its_hash), differs = false;
    for (int i = 0; i < count && answers && !differs; i++) {
        *slot = (int64_t)ids[i].index1 - 1;
        answers = read_line(&o, &its, &its_hash);
        differs = answers && (its != *slot || its_hash != body_hash(world, ids[i]));
    }
    dismiss(&o);
    free(ids);
    return differs;
}

/* Prints where the builds differ. */
static void tell(const run_options *options, thud_player *player, const found *f) {
    int64_t slot = -1;
    bool body = f->other == f->same + 1 && find_body(options, player, f->other, &slot);
    if (options->json) {
        printf("{\"same\": false, \"after\": %" PRId64 ", \"at\": %" PRId64, f->same, f->other);
        if (body)
            printf(", \"body\": %" PRId64, slot);
        printf("}\n");
        return;
    }
    printf("the builds differ after step %" PRId64 ", at step %" PRId64, f->same, f->other);
    if (body)
        printf(", first in the body of slot %" PRId64, slot);
    else if (f->other == f->same + 1)
        printf(", where poses and velocities are still the same");
    printf("\n");
}

bool bisect_builds(const run_options *options, thud_player *player) {
    thud_player_progress p = progress_of(player);
    found coarse, fine;
    verdict result = compare(options, player, p.first, p.end, COARSE_STEPS, &coarse);
    if (result == DIFFERENT && coarse.same >= 0 &&
        compare(options, player, coarse.same, coarse.other, 1, &fine) == DIFFERENT)
        coarse = fine;
    if (result == NO_ANSWER)
        fprintf(stderr, "thud-run: %s does not answer as thud-run --hashes does\n",
                options->bisect);
    else if (result == DIFFERENT)
        tell(options, player, &coarse);
    else if (options->json)
        printf("{\"same\": true, \"at\": %" PRId64 "}\n", coarse.same);
    else
        printf("the builds have the same hashes up to step %" PRId64 "%s\n", coarse.same,
               coarse.same < p.end ? ", where both differ from the recording" : "");
    return result == SAME;
}
