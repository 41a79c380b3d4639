/* car.c: a race seen from above: three cars pass four gates in order, for three laps. On one
 * straight there is oil, on which wheels grip less. Lengths are in metres, masses in kilograms: a
 * car is 2 m long and weighs 2 kg. */
#include <math.h>
#include <stdio.h>
#include <thud/thud_all.h>

enum { CARS = 3, GATES = 4, LAPS = 3 };
/* The default time step is 1/60 s; a race that is not over after two minutes is given up. */
enum { STEPS_PER_SECOND = 60, STEPS_MAX = 120 * STEPS_PER_SECOND };
/* Category bits of shapes, by which main asks for the cars that reach gates. */
enum { GATE = 2, CAR = 4 };

/* The centres of the sensors: the gates in the order of the race, then the oil. The user data of
 * each is its index. */
static const thud_pos sensors[GATES + 1] = {{24, -12}, {24, 12}, {-24, 12}, {-24, -12}, {17, 12}};

typedef struct game {
    thud_world *world;
    thud_shape_id oil;
    thud_body_id cars[CARS];
    unsigned passed[CARS]; /* gates passed in order, over all laps */
} game;

/* Makes the track (the island in the middle, then the four outer walls, by centre and half
 * extents), the sensors, and the cars, each a little behind the one before it. */
static void set_up(game *g) {
    thud_geometry walls[] = {thud_aabb_at(0, 0, 17, 6), thud_aabb_at(-31, 0, 1, 20),
                             thud_aabb_at(31, 0, 1, 20), thud_aabb_at(0, -19, 30, 1),
                             thud_aabb_at(0, 19, 30, 1)};
    for (int i = 0; i < 5; i++)
        thud_body_make(g->world, walls[i], &(thud_body_options){.friction = 0.1f});
    for (int i = 0; i <= GATES; i++) {
        thud_body_options sensor = {.sensor = true, .category = GATE, .user_data = i};
        thud_body_id body =
            thud_body_make(g->world, thud_circle_at(sensors[i].x, sensors[i].y, 5), &sensor);
        thud_body_get_shapes(g->world, body, &g->oil, 1, NULL); /* the last one, the oil, stays */
    }
    for (int i = 0; i < CARS; i++) {
        thud_body_options car = {.kind = THUD_BODY_DYNAMIC, .category = CAR, .user_data = i};
        car.linear_damping = 0.3f;
        car.angular_damping = 1;
        car.friction = 0.1f; /* cars slide along walls and each other */
        g->cars[i] = thud_body_make(g->world, thud_obb_at(-4 * i, 2 * i - 12, 1, 0.5, 0), &car);
    }
}

/* Applies the sideways grip of a wheel at distance `ahead` in front of the car's middle. The wheel
 * rolls freely along its own direction, at the angle `steer` to the left of the car's (radians),
 * and resists motion across that by a force of at most 20 N, on oil 4 N. */
static void grip_sideways(const game *g, thud_body_id car, float ahead, double steer) {
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
 * it stops. Speeds are in m/s. The motor gives at most 16 N in the first car, and 2 N more in each
 * that starts further back. All these numbers are chosen. */
static void drive(const game *g, int i) {
    thud_vec2 gate, middle = {0, 0}, forward = {1, 0}; /* in the car's frame */
    thud_body_get_local_point(g->world, g->cars[i], sensors[g->passed[i] % GATES], &gate);
    double steer = gate.x < 0 ? copysign(0.5, gate.y) : fmax(-0.5, fmin(0.5, gate.y / gate.x));
    double speed = g->passed[i] < LAPS * GATES ? 8 + 0.4 * fmax(gate.x, 0) - 6 * fabs(steer) : 0;
    thud_body_apply_grip(g->world, g->cars[i], middle, forward, speed, 16 + 2 * i);
    grip_sideways(g, g->cars[i], 0.9f, steer);
    grip_sideways(g, g->cars[i], -0.9f, 0);
}

int main(void) {
    game g = {.world = thud_world_make((thud_vec2){0, 0}, &thud_quality_default)};
    int home = 0; /* cars that have finished */
    set_up(&g);
    for (int step = 1; home < CARS && step <= STEPS_MAX; step++) {
        for (int i = 0; i < CARS; i++)
            drive(&g, i);
        thud_world_step(g.world);
        for (thud_event_pair pair = {0}; thud_world_next_event_pair(g.world, GATE, CAR, &pair);) {
            unsigned car = pair.b.body_data, *passed = &g.passed[car];
            if (pair.a.body_data == *passed % GATES && ++*passed == LAPS * GATES)
                printf("place %d: car %d after %.2f s\n", ++home, car + 1,
                       step / (double)STEPS_PER_SECOND);
        }
    }
    /* The same on every machine, since the engine is deterministic. */
    printf("hash %016llx\n", (unsigned long long)thud_hash_of(g.world));
    thud_world_destroy(g.world);
    return home < CARS;
}
