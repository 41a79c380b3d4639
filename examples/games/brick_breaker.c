/* brick_breaker.c: a paddle, a ball and a wall of bricks. Every fifth brick drops a gift, which
 * makes the paddle wider. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_edits.h>
#include <thud/thud_forces.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

enum { COLUMNS = 8, BRICKS = 40, LIVES = 5 };
enum { WALL = 1, FLOOR = 2, BRICK = 4, PADDLE = 8, BALL = 16, GIFT = 32 }; /* categories */

typedef struct game {
    thud_world *world;
    thud_body_id paddle, ball;
    thud_shape_id paddle_shape;
    float half_width;
    int bricks, lives, score, steps;
} game;

static thud_body_id add_box(game *g, thud_body_kind kind, uint32_t category, double x, double y,
                            float half_x, float half_y, thud_shape_id *shape) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_id body;
    thud_body_shape box = {thud_aabb_at(0, 0, half_x, half_y), &shape_def};
    body_def.kind = kind;
    body_def.position = (thud_pos){x, y};
    body_def.user_data = category;
    shape_def.filter.category = category;
    shape_def.filter.mask = category == GIFT ? PADDLE | FLOOR : ~0u;
    shape_def.sensor = category == FLOOR;
    shape_def.friction = 0;
    thud_body_create_with_shapes(g->world, &body_def, &box, 1, &body, shape);
    return body;
}

static void serve(game *g) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape ball = {thud_circle_at(0, 0, 0.3), &shape_def};
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){0, 6};
    body_def.velocity = (thud_vec2){3, -12};
    body_def.gravity_scale = 0;
    body_def.detection = &thud_detection_swept;
    body_def.user_data = BALL;
    shape_def.filter.category = BALL;
    shape_def.friction = 0;
    shape_def.restitution = 1;
    thud_body_create_with_shapes(g->world, &body_def, &ball, 1, &g->ball, NULL);
}

static void set_up(game *g) {
    add_box(g, THUD_STATIC, WALL, -11, 12, 1, 14, NULL);
    add_box(g, THUD_STATIC, WALL, 11, 12, 1, 14, NULL);
    add_box(g, THUD_STATIC, WALL, 0, 25, 10, 1, NULL);
    add_box(g, THUD_STATIC, FLOOR, 0, -3, 12, 1, NULL);
    for (int i = 0; i < BRICKS; i++)
        add_box(g, THUD_STATIC, BRICK, 2.4 * (i % COLUMNS) - 8.4, 16 + 1.2 * (i / COLUMNS), 1.1f,
                0.5f, NULL);
    g->paddle = add_box(g, THUD_KINEMATIC, PADDLE, 0, 1, g->half_width, 0.3f, &g->paddle_shape);
    serve(g);
}

/* Under the ball, a little beside its middle, no faster than a hand. */
static void move_paddle(game *g) {
    thud_pos ball, paddle;
    thud_body_position(g->world, g->ball, &ball);
    thud_body_position(g->world, g->paddle, &paddle);
    double way = ball.x + 0.4 * g->half_width * (g->steps / 95 % 5 - 2) - paddle.x;
    paddle.x += fmax(-0.25, fmin(0.25, way));
    thud_body_set_target(g->world, g->paddle, paddle, 0);
}

/* Where the ball hits the paddle says where it goes. */
static void send_back(game *g) {
    thud_pos ball, paddle;
    thud_body_position(g->world, g->ball, &ball);
    thud_body_position(g->world, g->paddle, &paddle);
    float side = (float)(ball.x - paddle.x) / (g->half_width + 0.3f);
    float x = 16 * fmaxf(-0.8f, fminf(0.8f, side));
    thud_body_set_velocity(g->world, g->ball, (thud_vec2){x, sqrtf(256 - x * x)}, 0);
}

static void meet(game *g, thud_shape_id shape_a, thud_shape_id shape_b) {
    thud_pair pair;
    thud_pos at;
    thud_pair_get(g->world, shape_a, shape_b, &pair);
    bool in_order = pair.a.body_data < pair.b.body_data;
    thud_pair_side low = in_order ? pair.a : pair.b, high = in_order ? pair.b : pair.a;
    switch (low.body_data) { /* 0: it has met something else before, and is gone */
    case FLOOR:
        thud_body_destroy(g->world, high.body);
        if (high.body_data == BALL && --g->lives > 0)
            serve(g);
        break;
    case BRICK:
        thud_body_position(g->world, low.body, &at);
        thud_body_destroy(g->world, low.body);
        g->score += 10;
        if (--g->bricks % 5 == 0)
            add_box(g, THUD_DYNAMIC, GIFT, at.x, at.y, 0.5f, 0.5f, NULL);
        break;
    case PADDLE:
        if (high.body_data == BALL) {
            send_back(g);
        } else {
            thud_body_destroy(g->world, high.body);
            g->score += 50;
            g->half_width += 0.25f;
            thud_shape_set_half_extents(g->world, g->paddle_shape,
                                        (thud_vec2){g->half_width, 0.3f});
        }
    }
}

int main(void) {
    game g = {.half_width = 1.5f, .bricks = BRICKS, .lives = LIVES};
    thud_world_def world_def = thud_default_world_def();
    world_def.restitution_threshold = world_def.hit_speed = 0; /* however slowly it comes */
    if (thud_world_create(&world_def, &g.world) != THUD_OK)
        return 1;
    set_up(&g);
    for (; g.bricks > 0 && g.lives > 0; g.steps++) {
        move_paddle(&g);
        thud_world_step(g.world);
        thud_events events = thud_world_events(g.world);
        for (int i = 0; i < events.hit_count; i++)
            meet(&g, events.hit[i].shape_a, events.hit[i].shape_b);
        for (int i = 0; i < events.sensor_begin_count; i++)
            meet(&g, events.sensor_begin[i].shape_a, events.sensor_begin[i].shape_b);
    }
    printf("%d bricks and %d lives left after %.1f s, score %d\n", g.bricks, g.lives,
           g.steps / 60.0, g.score);
    printf("hash %016llx\n", (unsigned long long)thud_world_hash(g.world));
    thud_world_destroy(g.world);
    return g.bricks > 0;
}
