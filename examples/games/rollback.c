/* rollback.c: sumo between two peers whose messages arrive late. Each peer runs a step at once, and
 * predicts that the input of the other has not changed. If the prediction was wrong, it restores
 * the state before that step and runs the steps since then again (thud_rollback.h). The hashes of
 * steps whose inputs both know are compared. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

/* LATEST: the largest delay of an input, steps. WINS: rounds that decide the match. STEPS: the
 * longest match, two minutes. */
enum { LATEST = 12, WINS = 3, STEPS = 60 * 120 };

/* The game as one peer has it. */
typedef struct peer {
    thud_world *world;
    thud_rollback *rollback;
    thud_body_id wrestler[2];
    int wins[2];
} peer;

/* Begins a round: puts two new wrestlers at their places. */
static void line_up(peer *p) {
    thud_body_options disc = {.kind = THUD_BODY_DYNAMIC, .linear_damping = 1, .restitution = 0.8f};
    for (int i = 0; i < 2; i++) {
        thud_body_destroy(p->world, p->wrestler[i]);
        p->wrestler[i] = thud_body_make(p->world, thud_circle_at(4 * i - 2, 0.1 * i, 0.5), &disc);
    }
}

static double from_middle(thud_pos at) {
    return sqrt(at.x * at.x + at.y * at.y);
}

/* A step of the game. An input of 0 to 8 is a direction, in rows of three as on a number pad; 4:
 * none.
 */
static thud_result play(thud_world *world, const uint64_t *inputs, void *state) {
    peer *p = state;
    for (int i = 0; i < 2; i++) {
        thud_vec2 push = {0.2f * ((int)inputs[i] % 3 - 1), 0.2f * ((int)inputs[i] / 3 - 1)};
        thud_body_apply_center_impulse(world, p->wrestler[i], push);
    }
    thud_result result = thud_world_step(world);
    for (int i = 0; i < 2; i++) {
        if (from_middle(thud_position_of(world, p->wrestler[i])) > 5) {
            p->wins[!i]++;
            line_up(p);
        }
    }
    return result;
}

/* Creates a peer's world and rollback. The struct itself is the state that is restored with the
 * world.
 */
static bool start(peer *p) {
    thud_rollback_options options = {
        .step = play, .idle = 4, .depth = LATEST, .state = p, .state_bytes = sizeof *p};
    p->world = thud_world_make((thud_vec2){0, 0}, &thud_quality_default);
    line_up(p);
    return thud_rollback_create(p->world, &options, &p->rollback) == THUD_OK;
}

/* The input of the computer player `me`: towards the other wrestler, every other 25 steps with a
 * deviation to the side; near the edge back to the middle. */
static int think(const peer *p, int me, int now) {
    thud_pos at = thud_position_of(p->world, p->wrestler[me]);
    thud_pos other = thud_position_of(p->world, p->wrestler[!me]);
    double x = other.x - at.x, y = other.y - at.y, swerve = now / 25 % 2 == me;
    thud_pos to = {x - swerve * y, y + swerve * x};
    if (from_middle(at) > 4)
        to = (thud_pos){-at.x, -at.y};
    return (to.x > 0.3) - (to.x < -0.3) + 3 * ((to.y > 0.3) - (to.y < -0.3)) + 4;
}

int main(void) {
    static peer peers[2];
    static int inputs[2][STEPS];
    peer sure = {0};
    uint64_t hash[2];
    int now = 0, unlike = 0;
    if (!start(&peers[0]) || !start(&peers[1]))
        return 1;
    for (; sure.wins[0] < WINS && sure.wins[1] < WINS && now < STEPS; now++) {
        for (int me = 0; me < 2; me++) {
            inputs[me][now] = think(&peers[me], me, now);
            thud_rollback_input(peers[me].rollback, me, now, inputs[me][now]);
            /* Each message has all inputs of the last LATEST steps, so that none is missed if one
             * message overtakes another. */
            int late = 2 + (int)((uint32_t)(2 * now + me) * 2654435761u >> 16) % (LATEST - 2);
            for (int then = now < LATEST ? 0 : now - LATEST; then <= now - late; then++)
                thud_rollback_input(peers[me].rollback, !me, then, inputs[!me][then]);
            thud_rollback_advance(peers[me].rollback, NULL);
            int known = now < LATEST ? 0 : now - LATEST + 1;
            thud_rollback_get_state(peers[me].rollback, known, &hash[me], &sure);
        }
        unlike += hash[0] != hash[1];
    }
    printf("%d to %d rounds in %d steps\n", sure.wins[0], sure.wins[1], now);
    for (int me = 0; me < 2; me++) {
        printf("%d steps played again\n", (int)thud_progress_of(peers[me].rollback).replayed);
        thud_rollback_destroy(peers[me].rollback);
        thud_world_destroy(peers[me].world);
    }
    printf("%d unlike, hash %016llx\n", unlike, (unsigned long long)hash[0]);
    return unlike > 0 || now == STEPS;
}
