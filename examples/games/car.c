/* car.c: a race seen from above, through the gates in turn; on one straight there is oil. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_casts.h>
#include <thud/thud_edits.h>
#include <thud/thud_forces.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

enum { CARS = 3, GATES = 4, LAPS = 3, STEPS = 60 * 120 };

/* Sensors carry their number: the gates in the order of the race, then the oil. */
static const thud_pos places[GATES + 1] = {{24, -12}, {24, 12}, {-24, 12}, {-24, -12}, {17, 12}};

typedef struct game {
    thud_world *world;
    thud_shape_id oil;
    thud_body_id cars[CARS];
    unsigned passed[CARS]; /* gates */
} game;

static void lay_track(game *g) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def wall = thud_default_shape_def();
    thud_body_shape walls[] = {{thud_aabb_at(0, 0, 17, 6), &wall},
                               {thud_aabb_at(-31, 0, 1, 20), &wall},
                               {thud_aabb_at(31, 0, 1, 20), &wall},
                               {thud_aabb_at(0, -19, 30, 1), &wall},
                               {thud_aabb_at(0, 19, 30, 1), &wall}};
    thud_body_id track;
    wall.friction = 0.1f;
    thud_body_create_with_shapes(g->world, &body_def, walls, 5, &track, NULL);
    for (int i = 0; i <= GATES; i++) {
        thud_shape_def sensor = thud_default_shape_def();
        sensor.sensor = true;
        sensor.user_data = i;
        thud_shape_create_circle(g->world, track, &sensor, (thud_vec2){places[i].x, places[i].y}, 5,
                                 &g->oil); /* the last */
    }
}

static void add_car(game *g, int i) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_shape box = {thud_obb_at(0, 0, 1, 0.5, 0), &shape_def};
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){-4 * i, 2 * i - 12};
    body_def.linear_damping = 0.3f;
    body_def.angular_damping = 1;
    body_def.user_data = i;
    shape_def.friction = 0.1f;
    thud_body_create_with_shapes(g->world, &body_def, &box, 1, &g->cars[i], NULL);
}

/* An axle so far ahead of the middle rolls freely the way it is steered, and holds across it as
 * well as it grips. */
static void roll(const game *g, thud_body_id car, float ahead, double steer, float drive) {
    thud_pos at;
    thud_vec2 along, velocity;
    double sine, cosine;
    bool oily = false;
    thud_sincos(steer, &sine, &cosine);
    thud_body_world_vector(g->world, car, (thud_vec2){cosine, sine}, &along);
    thud_body_world_point(g->world, car, (thud_vec2){ahead, 0}, &at);
    thud_body_velocity_at(g->world, car, at, &velocity);
    thud_shape_contains_point(g->world, g->oil, at, &oily);
    float slip = velocity.y * along.x - velocity.x * along.y, grip = oily ? 4 : 20;
    float hold = fmaxf(-grip, fminf(grip, -30 * slip));
    thud_vec2 force = {drive * along.x - hold * along.y, drive * along.y + hold * along.x};
    thud_body_apply_force_at(g->world, car, force, at);
}

/* Towards the next gate, slower near it and in turns; at rest after the last. */
static void drive(const game *g, int i) {
    thud_vec2 to, velocity;
    thud_body_local_point(g->world, g->cars[i], places[g->passed[i] % GATES], &to);
    thud_body_velocity(g->world, g->cars[i], &velocity, NULL);
    thud_body_local_vector(g->world, g->cars[i], velocity, &velocity);
    double steer = to.x < 0 ? copysign(0.5, to.y) : fmax(-0.5, fmin(0.5, to.y / to.x));
    double wanted = 8 + 0.4 * fmax(to.x, 0) - 6 * fabs(steer);
    if (g->passed[i] >= LAPS * GATES)
        wanted = 0;
    roll(g, g->cars[i], 0.9f, steer, 0);
    roll(g, g->cars[i], -0.9f, 0, (16 + 2 * i) * (float)fmax(-1, fmin(1, wanted - velocity.x)));
}

int main(void) {
    game g = {0};
    thud_world_def world_def = thud_default_world_def();
    int steps = 0, home = 0;
    world_def.gravity = (thud_vec2){0, 0};
    if (thud_world_create(&world_def, &g.world) != THUD_OK)
        return 1;
    lay_track(&g);
    for (int i = 0; i < CARS; i++)
        add_car(&g, i);
    for (; home < CARS && steps < STEPS; steps++) {
        for (int i = 0; i < CARS; i++)
            drive(&g, i);
        thud_world_step(g.world);
        thud_events events = thud_world_events(g.world);
        for (int i = 0; i < events.sensor_begin_count; i++) {
            thud_pair pair; /* a is the gate, b the car */
            thud_pair_get(g.world, events.sensor_begin[i].shape_a, events.sensor_begin[i].shape_b,
                          &pair);
            unsigned *passed = &g.passed[pair.b.body_data];
            if (pair.a.shape_data == *passed % GATES && ++*passed == LAPS * GATES)
                printf("place %d: car %d after %.2f s\n", ++home, (int)pair.b.body_data + 1,
                       steps / 60.0);
        }
    }
    printf("hash %016llx\n", (unsigned long long)thud_world_hash(g.world));
    thud_world_destroy(g.world);
    return home < CARS;
}
