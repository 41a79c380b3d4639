/* car.c: a race seen from above: three cars pass four gates in order, for three laps. On one
 * straight there is oil, on which wheels grip less. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

/* STEPS: the longest race, two minutes. GATE, CAR: categories. */
enum { CARS = 3, GATES = 4, LAPS = 3, STEPS = 60 * 120, GATE = 2, CAR = 4 };

/* The places of the sensors: the gates in the order of the race, then the oil. The user data of
 * each is its index. */
static const thud_pos places[GATES + 1] = {{24, -12}, {24, 12}, {-24, 12}, {-24, -12}, {17, 12}};

typedef struct game {
    thud_world *world;
    thud_shape_id oil;
    thud_body_id cars[CARS];
    unsigned passed[CARS]; /* number of gates passed */
} game;

static void set_up(game *g) {
    thud_geometry walls[] = {thud_aabb_at(0, 0, 17, 6), thud_aabb_at(-31, 0, 1, 20),
                             thud_aabb_at(31, 0, 1, 20), thud_aabb_at(0, -19, 30, 1),
                             thud_aabb_at(0, 19, 30, 1)};
    for (int i = 0; i < 5; i++)
        thud_body_make(g->world, walls[i], &(thud_body_options){.friction = 0.1f});
    for (int i = 0; i <= GATES; i++) {
        thud_body_options gate = {.sensor = true, .category = GATE, .user_data = i};
        thud_body_id body =
            thud_body_make(g->world, thud_circle_at(places[i].x, places[i].y, 5), &gate);
        thud_body_get_shapes(g->world, body, &g->oil, 1, NULL); /* oil is the last one */
    }
    for (int i = 0; i < CARS; i++) {
        thud_body_options car = {.kind = THUD_BODY_DYNAMIC, .category = CAR, .user_data = i};
        car.linear_damping = 0.3f;
        car.angular_damping = 1;
        car.friction = 0.1f;
        g->cars[i] = thud_body_make(g->world, thud_obb_at(-4 * i, 2 * i - 12, 1, 0.5, 0), &car);
    }
}

/* A wheel at distance `ahead` in front of the car's middle: it rolls freely in the direction of
 * `steer` (radians) and resists motion across it, by a force of at most 20, on oil 4. */
static void roll(const game *g, thud_body_id car, float ahead, double steer) {
    thud_pos at;
    double sine, cosine;
    bool oily = false;
    thud_sincos(steer, &sine, &cosine);
    thud_body_get_world_point(g->world, car, (thud_vec2){ahead, 0}, &at);
    thud_shape_contains_point(g->world, g->oil, at, &oily);
    thud_vec2 across = {-sine, cosine};
    thud_body_apply_grip(g->world, car, (thud_vec2){ahead, 0}, across, 0, oily ? 4 : 20);
}

/* Drives a car towards its next gate, more slowly near the gate and in bends; after the last gate
 * it stops. */
static void drive(const game *g, int i) {
    thud_vec2 to, middle = {0, 0}, ahead = {1, 0};
    thud_body_get_local_point(g->world, g->cars[i], places[g->passed[i] % GATES], &to);
    double steer = to.x < 0 ? copysign(0.5, to.y) : fmax(-0.5, fmin(0.5, to.y / to.x));
    double speed = g->passed[i] < LAPS * GATES ? 8 + 0.4 * fmax(to.x, 0) - 6 * fabs(steer) : 0;
    thud_body_apply_grip(g->world, g->cars[i], middle, ahead, speed, 16 + 2 * i);
    roll(g, g->cars[i], 0.9f, steer);
    roll(g, g->cars[i], -0.9f, 0);
}

int main(void) {
    game g = {.world = thud_world_make((thud_vec2){0, 0}, &thud_quality_default)};
    int steps = 0, home = 0;
    set_up(&g);
    for (; home < CARS && steps < STEPS; steps++) {
        for (int i = 0; i < CARS; i++)
            drive(&g, i);
        thud_world_step(g.world);
        for (thud_event_pair m = {0}; thud_world_next_event_pair(g.world, GATE, CAR, &m);) {
            unsigned car = m.b.body_data, *passed = &g.passed[car];
            if (m.a.body_data == *passed % GATES && ++*passed == LAPS * GATES)
                printf("place %d: car %d after %.2f s\n", ++home, car + 1, steps / 60.0);
        }
    }
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(g.world));
    thud_world_destroy(g.world);
    return home < CARS;
}
