/* car.c: a race seen from above, through the gates in turn; on one straight there is oil. */
#include <math.h>
#include <stdio.h>
#include <thud/thud.h>
#include <thud/thud_forces.h>
#include <thud/thud_lists.h>
#include <thud/thud_reads.h>

enum { CARS = 3, GATES = 4, LAPS = 3, OIL = GATES, STEPS = 60 * 120 };

/* In the order of the race, and the oil: sensors, which carry their number. */
static const thud_pos places[GATES + 1] = {{24, -12}, {24, 12}, {-24, 12}, {-24, -12}, {17, 12}};

typedef struct racer {
    thud_body_id body;
    float power, grip;
    unsigned gates;
    int place;
} racer;

static thud_shape_id lay_track(thud_world *world) {
    static const float blocks[][4] = {
        {0, 0, 17, 6}, {-31, 0, 1, 20}, {31, 0, 1, 20}, {0, -19, 30, 1}, {0, 19, 30, 1}};
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    thud_body_id track;
    thud_shape_id oil;
    thud_body_create(world, &body_def, &track);
    shape_def.friction = 0.1f;
    for (int i = 0; i < 5; i++)
        thud_shape_create_aabb(world, track, &shape_def, (thud_vec2){blocks[i][0], blocks[i][1]},
                               (thud_vec2){blocks[i][2], blocks[i][3]}, NULL);
    shape_def.sensor = true;
    for (int i = 0; i <= GATES; i++) {
        shape_def.user_data = i;
        thud_shape_create_circle(world, track, &shape_def, (thud_vec2){places[i].x, places[i].y},
                                 i == OIL ? 3 : 5, &oil);
    }
    return oil; /* the last */
}

static void add_car(thud_world *world, racer *car, int i) {
    thud_body_def body_def = thud_default_body_def();
    thud_shape_def shape_def = thud_default_shape_def();
    body_def.kind = THUD_DYNAMIC;
    body_def.position = (thud_pos){-4 * i, 2 * i - 12};
    body_def.linear_damping = 0.3f;
    body_def.angular_damping = 1;
    shape_def.friction = 0.1f;
    shape_def.user_data = i;
    thud_body_create(world, &body_def, &car->body);
    thud_shape_create_obb(world, car->body, &shape_def, (thud_vec2){0, 0}, (thud_vec2){1, 0.5f}, 0,
                          NULL);
    car->power = 16 + 2 * i;
}

/* Wheels at this place of the car roll freely along the way they are steered, and hold across it as
 * well as they grip. */
static void roll(thud_world *world, const racer *car, float ahead, double steer, float drive) {
    thud_pos at;
    thud_vec2 along, velocity;
    double sine, cosine;
    thud_sincos(steer, &sine, &cosine);
    thud_body_world_vector(world, car->body, (thud_vec2){cosine, sine}, &along);
    thud_body_world_point(world, car->body, (thud_vec2){ahead, 0}, &at);
    thud_body_velocity_at(world, car->body, at, &velocity);
    float slip = velocity.y * along.x - velocity.x * along.y;
    float hold = fmaxf(-car->grip, fminf(car->grip, -30 * slip));
    thud_vec2 force = {drive * along.x - hold * along.y, drive * along.y + hold * along.x};
    thud_body_apply_force_at(world, car->body, force, at);
}

/* Towards the next gate, slower near it and in turns. */
static void drive(thud_world *world, const racer *car) {
    thud_vec2 to, velocity;
    thud_body_local_point(world, car->body, places[car->gates % GATES], &to);
    thud_body_velocity(world, car->body, &velocity, NULL);
    thud_body_local_vector(world, car->body, velocity, &velocity);
    double steer = to.x < 0 ? copysign(0.5, to.y) : fmax(-0.5, fmin(0.5, to.y / to.x));
    double wanted = car->place ? 0 : 8 + 0.4 * fmax(to.x, 0) - 6 * fabs(steer);
    roll(world, car, 0.9f, steer, 0);
    roll(world, car, -0.9f, 0, car->power * (float)fmax(-1, fmin(1, wanted - velocity.x)));
}

static void look_for_oil(const thud_world *world, thud_shape_id oil, racer *cars) {
    thud_shape_id on_oil[CARS];
    int count = 0;
    for (int i = 0; i < CARS; i++)
        cars[i].grip = 20;
    thud_sensor_overlaps(world, oil, on_oil, CARS, &count);
    for (int i = 0; i < count; i++) {
        uint64_t car = 0;
        thud_shape_user_data(world, on_oil[i], &car);
        cars[car].grip = 4;
    }
}

int main(void) {
    thud_world *world;
    thud_world_def world_def = thud_default_world_def();
    racer cars[CARS] = {0};
    int steps = 0, home = 0;
    world_def.gravity = (thud_vec2){0, 0};
    if (thud_world_create(&world_def, &world) != THUD_OK)
        return 1;
    thud_shape_id oil = lay_track(world);
    for (int i = 0; i < CARS; i++)
        add_car(world, &cars[i], i);
    for (; home < CARS && steps < STEPS; steps++) {
        look_for_oil(world, oil, cars);
        for (int i = 0; i < CARS; i++)
            drive(world, &cars[i]);
        thud_world_step(world);
        thud_events events = thud_world_events(world);
        for (int i = 0; i < events.sensor_begin_count; i++) {
            thud_pair pair; /* a is the gate, b the car */
            thud_pair_get(world, events.sensor_begin[i].shape_a, events.sensor_begin[i].shape_b,
                          &pair);
            racer *car = &cars[pair.b.shape_data];
            if (pair.a.shape_data == car->gates % GATES && ++car->gates == LAPS * GATES) {
                car->place = ++home;
                printf("place %d: car %d after %.2f s\n", home, (int)pair.b.shape_data + 1,
                       steps / 60.0);
            }
        }
    }
    printf("hash %016llx\n", (unsigned long long)thud_world_hash(world));
    thud_world_destroy(world);
    return home < CARS;
}
