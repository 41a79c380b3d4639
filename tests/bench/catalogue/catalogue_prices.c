/* catalogue_prices.c: what each detection pays for its accuracy. Balls bounce without loss in two
 * scenes whose motion is known in closed form, at several step rates. The error of a setting is the
 * mean distance of the balls from where they should be at the end; its price is the processor time
 * of the steps. So a detection that needs fewer steps for the same error shows. */
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"

#include <math.h>

enum { BALLS = 64, RATE_COUNT = 5, QUICK_RATES = 2, REPETITIONS = 5 };

static const double RATES[RATE_COUNT] = {60, 120, 240, 480, 960}; /* steps per second */
static const double SECONDS = 2;                                  /* the simulated time */
static const double RADIUS = 0.1, GRAVITY = 10;
static const double ROOM = 2; /* m: the shuttle's balls fly so far between two walls */

/* The speed of a ball of the shuttle, and the height from which one of the hop falls. */
static double speed_of(int ball) {
    return 3 + 0.11 * ball;
}
static double height_of(int ball) {
    return 1 + 0.031 * ball;
}

static void fill_shuttle(scene *s) {
    scene_static_box(s, -1, 0, 1, 1000);
    scene_static_box(s, ROOM + 2 * RADIUS + 1, 0, 1, 1000);
    for (int i = 0; i < BALLS; i++)
        scene_dynamic_circle(s, RADIUS, i, RADIUS)->vx = speed_of(i);
}

/* Where a ball of the shuttle has got to: x goes to and fro in the room. */
static thud_pos shuttle_at(int ball, double time) {
    double way = fmod(speed_of(ball) * time, 2 * ROOM);
    return (thud_pos){RADIUS + (way <= ROOM ? way : 2 * ROOM - way), ball};
}

static void fill_hop(scene *s) {
    s->gravity_y = -GRAVITY;
    scene_static_box(s, BALLS / 2, -1, 1000, 1);
    for (int i = 0; i < BALLS; i++)
        scene_dynamic_circle(s, i, RADIUS + height_of(i), RADIUS);
}

/* Where a ball of the hop has got to: each flight is a parabola from the floor to its height. */
static thud_pos hop_at(int ball, double time) {
    double height = height_of(ball), fall = sqrt(2 * height / GRAVITY);
    double since = fmod(time + fall, 2 * fall) - fall; /* from the top of the flight */
    return (thud_pos){ball, RADIUS + height - 0.5 * GRAVITY * since * since};
}

static const struct {
    const char *name;
    void (*fill)(scene *s);
    thud_pos (*at)(int ball, double time);
} SCENES[] = {{"shuttle", fill_shuttle, shuttle_at}, {"hop", fill_hop, hop_at}};

enum { SCENE_COUNT = sizeof SCENES / sizeof SCENES[0] };

typedef struct price {
    double seconds, error;
} price;

/* The mean distance of the balls, which are the last bodies, from where they should be. */
static bool measure_error(const way_world *w, int index, double time, double *error) {
    int first = w->count - BALLS;
    double sum = 0;
    for (int i = 0; i < BALLS; i++) {
        thud_body_state now;
        if (thud_body_get_state(w->world, w->bodies[first + i], &now) != THUD_OK)
            return false;
        thud_pos wanted = SCENES[index].at(i, time);
        sum += hypot(now.position.x - wanted.x, now.position.y - wanted.y);
    }
    *error = sum / BALLS;
    return true;
}

static bool run_once(int index, const thud_detection *detection, double rate, price *found) {
    scene s;
    scene_init(&s);
    s.gravity_y = 0;
    s.material = (scene_material){.density = 1, .friction = 0, .restitution = 1};
    SCENES[index].fill(&s);
    for (int i = 0; i < s.shape_count; i++)
        s.shapes[i].group = -1;
    /* Walls and ground are hit: only the balls let each other through. */
    for (int i = 0; i < s.shape_count - BALLS; i++)
        s.shapes[i].group = 0;
    way_world w = {0};
    bool ok = way_open(&w, &s, detection, 1 / rate);
    int steps = (int)(SECONDS * rate + 0.5);
    double start = processor_seconds();
    for (int i = 0; ok && i < steps; i++)
        ok = way_step(&w);
    found->seconds = processor_seconds() - start;
    ok = ok && measure_error(&w, index, SECONDS, &found->error);
    way_close(&w);
    scene_free(&s);
    return ok;
}

/* The least time of several repetitions; worlds are deterministic, so the error is the same. */
static bool run(int index, const thud_detection *detection, double rate, bool quick, price *best) {
    best->seconds = INFINITY;
    for (int i = 0; i < (quick ? 1 : REPETITIONS); i++) {
        price found;
        if (!run_once(index, detection, rate, &found))
            return false;
        best->seconds = fmin(best->seconds, found.seconds);
        best->error = found.error;
    }
    return true;
}

bool catalogue_prices(bool quick, json *out) {
    printf("%-10s %-10s %7s %12s %12s\n", "scene", "detection", "1/step", "us a second",
           "error mm");
    json_begin_array(out, "prices");
    for (int index = 0; index < SCENE_COUNT; index++)
        for (int way = 0; way < WAY_COUNT; way++)
            for (int i = 0; i < (quick ? QUICK_RATES : RATE_COUNT); i++) {
                price found;
                if (!run(index, way_at(way), RATES[i], quick, &found))
                    return false;
                const char *name = thud_detection_name(way_at(way));
                double us = found.seconds / SECONDS * 1e6;
                printf("%-10s %-10s %7g %12.1f %12.4f\n", SCENES[index].name, name, RATES[i], us,
                       found.error * 1e3);
                json_begin_object(out, NULL);
                json_text(out, "scene", SCENES[index].name);
                json_text(out, "detection", name);
                json_number(out, "rate", RATES[i]);
                json_number(out, "us", us); /* microseconds for a simulated second */
                json_number(out, "error", found.error);
                json_end(out);
            }
    json_end(out);
    return true;
}
