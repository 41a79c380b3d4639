/* pool.c: pool for two computer players. A player who pots a ball plays again. A length of 1 is the
 * diameter of a ball. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

/* CUE: the index of the cue ball. SHOTS: the longest game. BALL, POCKET: categories. */
enum { BALLS = 16, CUE = 0, POCKETS = 6, SHOTS = 200, BALL = 2, POCKET = 4 };

static const thud_pos pockets[POCKETS] = {{-22, -11}, {0, -11}, {22, -11},
                                          {-22, 11},  {0, 11},  {22, 11}};

typedef struct game {
    thud_world *world;
    thud_body_id ball[BALLS];
    int player, shots, potted[2], fouls[2];
} game;

static void add_ball(game *g, int i, double x, double y) {
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC, .category = BALL, .user_data = i};
    ball.detection = &thud_detection_swept; /* the break is fast */
    ball.friction = 0.05f;
    ball.restitution = 0.95f;
    ball.linear_damping = 0.7f;
    ball.angular_damping = 2;
    g->ball[i] = thud_body_make(g->world, thud_circle_at(x, y, 0.5), &ball);
}

static void set_up(game *g) {
    thud_body_options cushion = {.restitution = 0.8f}, hole = {.sensor = true, .category = POCKET};
    for (int side = -1; side < 2; side += 2) {
        thud_body_make(g->world, thud_aabb_at(23 * side, 0, 1, 13), &cushion);
        thud_body_make(g->world, thud_aabb_at(0, 12 * side, 22, 1), &cushion);
    }
    for (int i = 0; i < POCKETS; i++)
        thud_body_make(g->world, thud_circle_at(pockets[i].x, pockets[i].y, 0.5), &hole);
    add_ball(g, CUE, -11, 0.3);
    for (int i = 1, row = 0; row < 5; row++)
        for (int j = 0; j <= row; j++)
            add_ball(g, i++, 11 + 0.88 * row, 1.01 * (j - 0.5 * row));
}

/* Whether a ball can move by (dx, dy) without hitting another one. */
static bool is_free(const game *g, thud_body_id ball, double dx, double dy) {
    thud_query_filter others = {.category = ~0u, .mask = BALL, .ignore = ball};
    thud_pos from = thud_position_of(g->world, ball);
    bool hit = true;
    thud_world_cast_shape(g->world,
                          &(thud_shape_cast){from, thud_circle_at(0, 0, 0.49), dx, dy, &others},
                          &hit, NULL);
    return !hit;
}

/* The velocity of the cue ball for the best shot. Among all pairs of a ball and a pocket whose
 * paths are free, it is the one with the straightest and shortest path; if no path is free, the
 * shot goes at the nearest ball. */
static thud_vec2 aim(const game *g) {
    thud_pos cue = thud_position_of(g->world, g->ball[CUE]);
    thud_vec2 shot = {0, 0};
    double best = 0;
    for (int i = POCKETS; i < BALLS * POCKETS; i++) {
        thud_body_id ball = g->ball[i / POCKETS];
        thud_pos at = thud_position_of(g->world, ball), to = pockets[i % POCKETS];
        double px = to.x - at.x, py = to.y - at.y, rest = sqrt(px * px + py * py);
        /* The cue ball must touch the other ball on the side away from the pocket. */
        double x = at.x - px / rest - cue.x, y = at.y - py / rest - cue.y;
        double way = sqrt(x * x + y * y), straight = (x * px + y * py) / (way * rest);
        bool good = straight > 0.2 && is_free(g, g->ball[CUE], x, y) && is_free(g, ball, px, py);
        double worth = good ? straight / (way + rest) : 1e-6 / way;
        double speed = 15 + way + rest / fmax(straight, 0.2);
        if (worth > best &&
            thud_body_is_valid(g->world, ball)) { /* the ball is still on the table */
            shot = (thud_vec2){speed * x / way, speed * y / way};
            best = worth;
        }
    }
    return shot;
}

/* Plays a shot until all balls are at rest, and decides who plays next. */
static void play(game *g) {
    int before = g->potted[g->player];
    thud_body_set_velocity(g->world, g->ball[CUE], aim(g), 0);
    do {
        thud_world_step(g->world);
        for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, POCKET, BALL, &m);) {
            thud_body_destroy(g->world, m.b.body);
            int *count = m.b.body_data == CUE ? g->fouls : g->potted;
            count[g->player]++;
        }
    } while (thud_stats_of(g->world).awake_bodies > 0);
    bool foul = !thud_body_is_valid(g->world, g->ball[CUE]);
    if (foul)
        add_ball(g, CUE, -11, 0);
    if (foul || g->potted[g->player] == before)
        g->player = !g->player;
}

int main(void) {
    game g = {.world = thud_world_make((thud_vec2){0, 0}, &thud_quality_default)};
    set_up(&g);
    for (; g.potted[0] + g.potted[1] < BALLS - 1 && g.shots < SHOTS; g.shots++)
        play(&g);
    printf("%d to %d balls in %d shots, %d and %d fouls\n", g.potted[0], g.potted[1], g.shots,
           g.fouls[0], g.fouls[1]);
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(g.world));
    thud_world_destroy(g.world);
    return g.shots == SHOTS;
}
