/* pool.c: two players clear a table; who pots a ball goes on. Lengths are in balls. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_edits.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

enum { BALLS = 16, CUE = 0, POCKETS = 6, SHOTS = 200 };
enum { BALL = 2 }; /* category */

static const thud_vec2 pockets[POCKETS] = {{-22, -11}, {0, -11}, {22, -11},
                                           {-22, 11},  {0, 11},  {22, 11}};

typedef struct game {
    thud_world *world;
    thud_body_id ball[BALLS];
    int left, player, potted[2], fouls[2];
} game;

static void lay_table(game *g) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def cushion = thud_default_shape_def(), pocket = cushion;
    thud_body_shape table[4 + POCKETS] = {{thud_aabb_at(-23, 0, 1, 13), &cushion},
                                          {thud_aabb_at(23, 0, 1, 13), &cushion},
                                          {thud_aabb_at(0, -12, 22, 1), &cushion},
                                          {thud_aabb_at(0, 12, 22, 1), &cushion}};
    cushion.restitution = 0.8f;
    pocket.sensor = true;
    for (int i = 0; i < POCKETS; i++)
        table[4 + i] = (thud_body_shape){thud_circle_at(pockets[i].x, pockets[i].y, 0.5), &pocket};
    thud_body_create_with_shapes(g->world, &body_def, table, 4 + POCKETS, NULL, NULL);
}

static void add_ball(game *g, int i, double x, double y) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape ball = {thud_circle_at(0, 0, 0.5), &shape_def};
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){x, y};
    body_def.linear_damping = 0.7f;
    body_def.angular_damping = 2;
    body_def.detection = &thud_detection_swept; /* the break is fast */
    body_def.user_data = i;
    shape_def.friction = 0.05f;
    shape_def.restitution = 0.95f;
    shape_def.filter.category = BALL;
    thud_body_create_with_shapes(g->world, &body_def, &ball, 1, &g->ball[i], NULL);
}

/* Whether no other ball stands in the way of this one. */
static bool is_free(const game *g, thud_body_id ball, thud_pos from, double dx, double dy) {
    thud_query_filter others = thud_default_query_filter();
    bool hit = true;
    others.mask = BALL;
    others.ignore = ball;
    thud_world_cast_circle(g->world, from, 0.49, dx, dy, &others, &hit, NULL);
    return !hit;
}

/* Of all ways of potting a ball the straightest, or else at the nearest. */
static thud_vec2 aim(const game *g) {
    thud_pos cue, ball;
    thud_vec2 shot = {0, 0};
    double best = 0;
    thud_body_position(g->world, g->ball[CUE], &cue);
    for (int i = 1; i < BALLS; i++) {
        if (thud_body_position(g->world, g->ball[i], &ball) != THUD_OK)
            continue; /* it is potted */
        for (int j = 0; j < POCKETS; j++) {
            double px = pockets[j].x - ball.x, py = pockets[j].y - ball.y;
            double rest = sqrt(px * px + py * py);
            /* The cue ball must touch it on the side away from the pocket. */
            double x = ball.x - px / rest - cue.x, y = ball.y - py / rest - cue.y;
            double way = sqrt(x * x + y * y), straight = (x * px + y * py) / (way * rest);
            bool good = straight > 0.2 && is_free(g, g->ball[CUE], cue, x, y) &&
                        is_free(g, g->ball[i], ball, px, py);
            double worth = good ? straight / (way + rest) : 1e-6 / way;
            if (worth > best) {
                double speed = 15 + way + rest / fmax(straight, 0.2);
                shot = (thud_vec2){speed * x / way, speed * y / way};
                best = worth;
            }
        }
    }
    return shot;
}

/* Until all balls are at rest. False: it is the other's turn. */
static bool roll(game *g) {
    int left = g->left;
    do {
        thud_world_step(g->world);
        thud_events events = thud_world_events(g->world);
        for (int i = 0; i < events.sensor_begin_count; i++) {
            thud_pair pair; /* a is the pocket */
            thud_pair_get(g->world, events.sensor_begin[i].shape_a, events.sensor_begin[i].shape_b,
                          &pair);
            thud_body_destroy(g->world, pair.b.body);
            g->left -= pair.b.body_data != CUE;
        }
    } while (thud_world_stats(g->world).awake_bodies > 0);
    bool foul = !thud_body_is_valid(g->world, g->ball[CUE]);
    if (foul)
        add_ball(g, CUE, -11, 0);
    g->potted[g->player] += left - g->left;
    g->fouls[g->player] += foul;
    return !foul && g->left < left;
}

int main(void) {
    game g = {.left = BALLS - 1};
    thud_world_def world_def = thud_default_world_def();
    world_def.gravity = (thud_vec2){0, 0};
    if (thud_world_create(&world_def, &g.world) != THUD_OK)
        return 1;
    lay_table(&g);
    add_ball(&g, CUE, -11, 0.3);
    for (int i = 1, row = 0; row < 5; row++)
        for (int j = 0; j <= row; j++)
            add_ball(&g, i++, 11 + 0.88 * row, 1.01 * (j - 0.5 * row));
    int shots = 0;
    for (; g.left > 0 && shots < SHOTS; shots++) {
        thud_body_set_velocity(g.world, g.ball[CUE], aim(&g), 0);
        if (!roll(&g))
            g.player = !g.player;
    }
    printf("%d to %d balls in %d shots, %d and %d fouls\n", g.potted[0], g.potted[1], shots,
           g.fouls[0], g.fouls[1]);
    printf("hash %016llx\n", (unsigned long long)thud_world_hash(g.world));
    thud_world_destroy(g.world);
    return g.left > 0;
}
