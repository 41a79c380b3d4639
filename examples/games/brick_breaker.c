/* brick_breaker.c: brick breaker with a computer player. Every fifth brick drops a gift, which
 * makes the paddle wider. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

enum { COLUMNS = 8, BRICKS = 40, LIVES = 5 };
enum { WALL = 1, FLOOR = 2, BRICK = 4, PADDLE = 8, BALL = 16, GIFT = 32 }; /* categories */

typedef struct game {
    thud_world *world;
    thud_body_id paddle, ball;
    float half_width;
    int bricks, lives, score, steps;
} game;

/* A box of a category. The floor is a sensor, and a gift collides with paddle and floor only. */
static thud_body_id add_box(game *g, thud_body_kind kind, uint32_t category, double x, double y,
                            double half_x, double half_y) {
    thud_body_options box = {.kind = kind, .category = category, .frictionless = true};
    box.sensor = category == FLOOR;
    box.mask = category == GIFT ? PADDLE | FLOOR : ~0u;
    return thud_body_make(g->world, thud_aabb_at(x, y, half_x, half_y), &box);
}

/* Adds a new ball. */
static void serve(game *g) {
    thud_body_options ball = {.kind = THUD_BODY_DYNAMIC,
                              .velocity = {3, -12},
                              .weightless = true,
                              .detection = &thud_detection_swept,
                              .category = BALL,
                              .restitution = 1,
                              .frictionless = true};
    g->ball = thud_body_make(g->world, thud_circle_at(0, 6, 0.3), &ball);
}

static void set_up(game *g) {
    add_box(g, THUD_BODY_STATIC, WALL, -11, 12, 1, 14);
    add_box(g, THUD_BODY_STATIC, WALL, 11, 12, 1, 14);
    add_box(g, THUD_BODY_STATIC, WALL, 0, 25, 10, 1);
    add_box(g, THUD_BODY_STATIC, FLOOR, 0, -3, 12, 1);
    for (int i = 0; i < BRICKS; i++)
        add_box(g, THUD_BODY_STATIC, BRICK, 2.4 * (i % COLUMNS) - 8.4, 16 + 1.2 * (i / COLUMNS),
                1.1, 0.5);
    g->paddle = add_box(g, THUD_BODY_KINEMATIC, PADDLE, 0, 1, g->half_width, 0.3);
    serve(g);
}

/* Moves the paddle towards the ball, by at most 0.25 in a step. The paddle aims beside the ball by
 * an offset that changes every 95 steps, so that the ball does not fly the same way each time. */
static void move_paddle(game *g) {
    thud_pos at = thud_position_of(g->world, g->paddle);
    double way = thud_position_of(g->world, g->ball).x - at.x;
    way += 0.4 * g->half_width * (g->steps / 95 % 5 - 2);
    at.x += fmax(-0.25, fmin(0.25, way));
    thud_body_set_target(g->world, g->paddle, at, 0);
}

/* Sends the ball back from the paddle at speed 16, the more to the side the further it is from the
 * paddle's middle. */
static void send_back(game *g) {
    double x = thud_position_of(g->world, g->ball).x - thud_position_of(g->world, g->paddle).x;
    float side = (float)x / (g->half_width + 0.3f), across = 16 * fmaxf(-0.8f, fminf(0.8f, side));
    thud_vec2 velocity = {across, sqrtf(256 - across * across)};
    thud_body_set_velocity(g->world, g->ball, velocity, 0);
}

/* Runs a step, and applies the rules to the shapes that met. */
static void play(game *g) {
    thud_world_step(g->world);
    for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, PADDLE, BALL, &m);)
        send_back(g);
    for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, BRICK, BALL, &m);) {
        thud_pos at = thud_position_of(g->world, m.a.body);
        thud_body_destroy(g->world, m.a.body);
        g->score += 10;
        if (--g->bricks % 5 == 0)
            add_box(g, THUD_BODY_DYNAMIC, GIFT, at.x, at.y, 0.5, 0.5);
    }
    for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, PADDLE, GIFT, &m);) {
        g->score += 50;
        g->half_width += 0.25f;
        thud_shape_set_half_extents(g->world, m.shape_a, (thud_vec2){g->half_width, 0.3f});
        thud_body_destroy(g->world, m.b.body);
    }
    for (thud_event_pair m = {0}; thud_world_next_event_pair(g->world, FLOOR, BALL | GIFT, &m);)
        thud_body_destroy(g->world, m.b.body);
    if (!thud_body_is_valid(g->world, g->ball) && --g->lives > 0)
        serve(g);
}

int main(void) {
    game g = {.half_width = 1.5f, .bricks = BRICKS, .lives = LIVES};
    thud_world_def def = thud_default_world_def();
    def.restitution_threshold = 0; /* the ball bounces at any speed */
    if (thud_world_create(&def, &g.world) != THUD_OK)
        return 1;
    set_up(&g);
    for (; g.bricks > 0 && g.lives > 0; g.steps++) {
        move_paddle(&g);
        play(&g);
    }
    printf("%d bricks and %d lives left after %.1f s, score %d\n", g.bricks, g.lives,
           g.steps / 60.0, g.score);
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(g.world));
    thud_world_destroy(g.world);
    return g.bricks > 0;
}
