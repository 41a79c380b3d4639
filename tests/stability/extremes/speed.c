/* speed.c: the extreme "speed": bullets shot at thin walls. Each lane has a wall and a bullet, and
 * lanes do not collide with each other. The bullets' distances at the start are spread over the
 * motion of a step, and their angles go up to 89 degrees from the wall's normal. Walls do not
 * rotate and are so long that no bullet can get around an end: a bullet behind the wall at the end
 * has passed through it. Measured is the share that passes. */
#include "random.h"
#include "trial.h"

#include <math.h>

enum { LANES = 50, SPEED_COUNT = 5, DEFAULT_EXACT = ON_DEFAULT | ON_EXACT };

static const double SPEEDS[SPEED_COUNT] = {1e1, 1e2, 1e3, 1e4, 1e5};
static const double STEP = ENGINE_TIME_STEP, DEGREE = 0.017453292519943295;
static const double THICKNESS = 0.02;
static const double WALL_MASS = 4; /* kg, of a wall that moves; about a hundred times a bullet's
                                      mass */
static const double CLEAR =
    0.25;                       /* m: distance from the wall at the start, larger than any bullet */
static const double SLANT = 89; /* degrees: the largest angle from the wall's normal */
static const double GRAVITY = 10; /* m/s^2, in every second world */

typedef enum wall_kind { WALL_STATIC = 0, WALL_DYNAMIC, WALL_ONCOMING, WALL_KINDS } wall_kind;

typedef struct range {
    scene_shape_kind bullet;
    wall_kind wall;
    scene_detection detection; /* detection of bullets and walls */
} range;

/* Steps until the last bullet has arrived, and three more. */
static int steps_of(double speed) {
    return (int)ceil(CLEAR / cos(SLANT * DEGREE) / (speed * STEP)) + 4;
}

static void add_wall(scene *s, scene_random *random, const range *r, double speed, int lane) {
    double time = steps_of(speed) * STEP, half = 2 + time * speed + GRAVITY * time * time;
    scene_body_kind kind = r->wall == WALL_STATIC ? SCENE_STATIC : SCENE_DYNAMIC;
    scene_body *wall = scene_add_body(s, kind, 16.0 * (lane % 8), 16.0 * (lane / 8));
    wall->fixed_rotation = true;
    wall->detection = r->detection;
    bool upright = lane % 2;
    if (!upright)
        wall->angle = scene_random_range(random, -3, 3);
    if (upright)
        scene_add_aabb(s, THICKNESS / 2, half);
    else
        scene_add_obb(s, THICKNESS / 2, half);
    s->shapes[s->shape_count - 1].material.density = WALL_MASS / (2 * half * THICKNESS);
}

/* The wall's unit normal on the side of the bullet. */
static scene_point face_of(const scene_body *wall) {
    return (scene_point){-cos(wall->angle), -sin(wall->angle)};
}

static void add_bullet(scene *s, scene_random *random, const range *r, double speed) {
    scene_body *wall = &s->bodies[s->body_count - 1];
    scene_point n = face_of(wall), place = {wall->x, wall->y};
    double oncoming = r->wall == WALL_ONCOMING ? speed : 0;
    wall->vx = oncoming * n.x;
    wall->vy = oncoming * n.y;
    double aim = scene_random_range(random, -1, 1);
    double slant = scene_random_range(random, -SLANT, SLANT) * DEGREE;
    /* The direction back to the bullet's start, and the time and place at which its centre would be
     * in the wall's middle. */
    double bx = n.x * cos(slant) - n.y * sin(slant), by = n.x * sin(slant) + n.y * cos(slant);
    double time = CLEAR / (speed * cos(slant) + oncoming) + scene_random_range(random, 0, STEP);
    scene_point meeting = {place.x - aim * n.y + oncoming * time * n.x,
                           place.y + aim * n.x + oncoming * time * n.y};
    scene_body *b = scene_add_body(s, SCENE_DYNAMIC, meeting.x + speed * time * bx,
                                   meeting.y + speed * time * by);
    b->detection = r->detection;
    b->vx = -speed * bx;
    b->vy = -speed * by;
    if (r->bullet == SCENE_CIRCLE) {
        scene_add_circle(s, 0.1);
    } else if (r->bullet == SCENE_AABB) {
        scene_add_aabb(s, 0.15, 0.1);
    } else {
        b->angle = scene_random_range(random, -3, 3);
        b->angular_velocity = scene_random_range(random, -10, 10);
        scene_add_obb(s, 0.15, 0.1);
    }
}

static void fill(scene *s, scene_random *random, const range *r, double speed, double gravity) {
    scene_init(s);
    s->gravity_y = -gravity;
    s->material = (scene_material){.density = 1, .friction = 0.1, .restitution = 0.5};
    for (int lane = 0; lane < LANES; lane++) {
        add_wall(s, random, r, speed, lane);
        add_bullet(s, random, r, speed);
        for (int k = s->shape_count - 2; k < s->shape_count; k++) {
            s->shapes[k].mask = 0; /* collides with the other body of its lane only */
            s->shapes[k].group = lane + 1;
        }
    }
}

/* A body whose state is not finite counts as passed. */
static int count_passed(trial *t) {
    const engine_body *now = trial_read(t);
    const scene *s = trial_scene(t);
    int passed = 0;
    for (int i = 0; i + 1 < s->body_count; i += 2) {
        scene_point n = face_of(&s->bodies[i]);
        double side = (now[i + 1].x - now[i].x) * n.x + (now[i + 1].y - now[i].y) * n.y;
        passed += !(side > 0);
    }
    return passed;
}

/* Fires `shots` bullets at each speed; the share that passes, in %. Infinite if a world fails. */
static double fire(ledger *l, entrant e, const range *r, int shots) {
    scene_random random = {8};
    double passed = 0;
    for (int i = 0; i < SPEED_COUNT; i++) {
        for (int done = 0; done < shots; done += LANES) {
            scene s;
            fill(&s, &random, r, SPEEDS[i], done / LANES % 2 ? GRAVITY : 0);
            for (int b = 1; e == ENTRANT_BOX2D && b < s.body_count; b += 2)
                s.bodies[b].detection = SCENE_SWEPT;
            trial *t = trial_begin(l, e, &s, (engine_settings){.bullets = true});
            passed += t && trial_steps(t, steps_of(SPEEDS[i])) ? count_passed(t) : INFINITY;
            trial_end(t);
            scene_free(&s);
        }
    }
    return 100 * passed / (SPEED_COUNT * shots);
}

static void run(ledger *l) {
    static const struct {
        const char *name;
        scene_shape_kind kind;
    } BULLETS[] = {{"circles", SCENE_CIRCLE},
                   {"upright boxes", SCENE_AABB},
                   {"turning boxes", SCENE_OBB}};
    static const char *const WALLS[WALL_KINDS] = {"static", "dynamic", "oncoming"};
    static const struct {
        const char *name;
        scene_detection detection;
        unsigned by;                /* entrants that run it */
        unsigned binds[WALL_KINDS]; /* entrants that the bound applies to, by kind of wall */
        int bullets;                /* number of kinds of bullets, from the first on */
    } WAYS[] = {
        {"as the quality", SCENE_AS_WORLD, ON_ALL, {DEFAULT_EXACT, ON_EXACT, ON_EXACT}, 3},
        {"swept", SCENE_SWEPT, DEFAULT_EXACT, {DEFAULT_EXACT, DEFAULT_EXACT, DEFAULT_EXACT}, 3},
        {"overlap", SCENE_OVERLAP, ON_DEFAULT, {0}, 1},
    };
    int shots = l->quick ? 4 * LANES : 10000;
    for (int i = 0; i < 27; i++) {
        int way = i / 9, wall = i / 3 % 3, bullet = i % 3;
        unsigned binds = WAYS[way].binds[wall];
        range r = {BULLETS[bullet].kind, (wall_kind)wall, WAYS[way].detection};
        if (bullet >= WAYS[way].bullets)
            continue;
        figure *f = ledger_add(l, binds ? bound_at_most(0, binds) : bound_none(),
                               "%s at %s walls, detection %s: passed, %%", BULLETS[bullet].name,
                               WALLS[wall], WAYS[way].name);
        for (entrant e = 0; e < ENTRANTS; e++) {
            ledger_progress(l, f->what, i / 27.0);
            if (ledger_has(l, e) && (WAYS[way].by & 1u << e))
                figure_tell(f, e, fire(l, e, &r, shots));
        }
    }
}

const extreme extreme_speed = {
    .name = "speed",
    .title = "Speed",
    .about =
        "Bullets of 20 to 30 cm at walls of 2 cm, at 10, 100, ... 100,000 m/s and from head-on to "
        "a degree from grazing, 10,000 shots at each speed, half of them under gravity. Oncoming walls fly at the "
        "bullets as fast as those. Box2D's bullets are marked as such, and its speed limit is "
        "lifted. Figures: how many of all 50,000 are beyond the wall in the end.",
    .run = run,
};
