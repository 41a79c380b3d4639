/* rollback.c: sumo between two peers who hear of each other late. Each plays on at once, as if the
 * other still did what it did last; where that proves wrong it goes back to the snapshot of that
 * frame and plays from there again. What both are sure of is compared to the last bit. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_edits.h>
#include <thud/thud_forces.h>
#include <thud/thud_reads.h>
#include <thud/thud_snapshot.h>

enum { LATEST = 12, RING = 16, WINS = 3, FRAMES = 60 * 120 };

typedef struct score {
    int wins[2];
} score;

typedef struct frame {
    char before[8192]; /* the world's snapshot as the frame begins, some 5 kB ... */
    size_t bytes;
    score score;   /* ... and the game's own state */
    int input[2];  /* 0 to 8: where to push, as on a number pad */
    uint64_t hash; /* of the world as it ends */
} frame;

typedef struct peer {
    thud_world *world;
    thud_body_id wrestler[2];
    score score;
    frame frames[RING];
    int heard, again; /* the last frame of the other that it knows; how many it played again */
} peer;

static void line_up(peer *p) {
    for (int i = 0; i < 2; i++) {
        thud_body_set_transform(p->world, p->wrestler[i], (thud_pos){4 * i - 2, 0.1 * i}, 0);
        thud_body_set_velocity(p->world, p->wrestler[i], (thud_vec2){0, 0}, 0);
    }
}

static bool start(peer *p) {
    thud_world_def world_def = thud_default_world_def();
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape disc = {thud_circle_at(0, 0, 0.5), &shape_def};
    world_def.gravity = (thud_vec2){0, 0};
    body_def.kind = THUD_DYNAMIC;
    body_def.linear_damping = 1;
    shape_def.restitution = 0.8f;
    if (thud_world_create(&world_def, &p->world) != THUD_OK)
        return false;
    for (int i = 0; i < 2; i++)
        thud_body_create_with_shapes(p->world, &body_def, &disc, 1, &p->wrestler[i], NULL);
    line_up(p);
    return true;
}

static double from_middle(thud_pos at) {
    return sqrt(at.x * at.x + at.y * at.y);
}

/* At the other, in turns with a swerve; near the edge back to the middle. */
static int think(const peer *p, int me, int now) {
    thud_pos at, other;
    thud_body_position(p->world, p->wrestler[me], &at);
    thud_body_position(p->world, p->wrestler[!me], &other);
    double x = other.x - at.x, y = other.y - at.y, swerve = now / 25 % 2 == me;
    thud_pos to = {x - swerve * y, y + swerve * x};
    if (from_middle(at) > 4)
        to = (thud_pos){-at.x, -at.y};
    return (to.x > 0.3) - (to.x < -0.3) + 3 * ((to.y > 0.3) - (to.y < -0.3)) + 4;
}

static void play(peer *p, int me, int now) {
    frame *f = &p->frames[now % RING];
    thud_world_snapshot(p->world, f->before, sizeof f->before, &f->bytes);
    f->score = p->score;
    if (now > p->heard)
        f->input[!me] = p->frames[(now - 1) % RING].input[!me];
    for (int i = 0; i < 2; i++) {
        thud_vec2 push = {0.2f * (f->input[i] % 3 - 1), 0.2f * (f->input[i] / 3 - 1)};
        thud_body_apply_center_impulse(p->world, p->wrestler[i], push);
    }
    thud_world_step(p->world);
    for (int i = 0; i < 2; i++) {
        thud_pos at;
        thud_body_position(p->world, p->wrestler[i], &at);
        if (from_middle(at) > 5) {
            p->score.wins[!i]++;
            line_up(p);
        }
    }
    f->hash = thud_world_hash(p->world);
}

/* Takes in the other's inputs up to the frame that the network has brought by now. */
static void hear(peer *p, const peer *other, int me, int now) {
    int late = 2 + (int)((uint32_t)(2 * now + me) * 2654435761u >> 16) % (LATEST - 2), back = now;
    for (; p->heard < now - late; p->heard++) {
        int next = p->heard + 1, input = other->frames[next % RING].input[!me];
        if (p->frames[next % RING].input[!me] != input && next < back)
            back = next;
        p->frames[next % RING].input[!me] = input;
    }
    if (back < now) {
        thud_world_restore(p->world, p->frames[back % RING].before, p->frames[back % RING].bytes);
        p->score = p->frames[back % RING].score;
        p->again += now - back;
        for (; back < now; back++)
            play(p, me, back);
    }
}

int main(void) {
    static peer peers[2];
    const frame *sure[2];
    int now = 0, unlike = 0;
    uint64_t hash = 0;
    if (!start(&peers[0]) || !start(&peers[1]))
        return 1;
    do {
        now++;
        for (int me = 0; me < 2; me++) {
            hear(&peers[me], &peers[!me], me, now);
            peers[me].frames[now % RING].input[me] = think(&peers[me], me, now);
            play(&peers[me], me, now);
            sure[me] = &peers[me].frames[(now + RING - LATEST) % RING];
        }
        unlike += sure[0]->hash != sure[1]->hash;
        hash = hash * 31 + sure[0]->hash;
    } while (sure[0]->score.wins[0] < WINS && sure[0]->score.wins[1] < WINS && now < FRAMES);
    printf("%d to %d rounds in %d frames\n", sure[0]->score.wins[0], sure[0]->score.wins[1], now);
    printf("%d and %d frames played again\n", peers[0].again, peers[1].again);
    printf("%d unlike, hash %016llx\n", unlike, (unsigned long long)hash);
    thud_world_destroy(peers[0].world);
    thud_world_destroy(peers[1].world);
    return unlike > 0 || now == FRAMES;
}
