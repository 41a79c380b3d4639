/* catalogue_queries.c: nanoseconds of each query of a world with 10,000 shapes, for each
 * broadphase, and of a move of a character mover. */
#include "catalogue/call_timer.h"
#include "catalogue/catalogue.h"
#include "catalogue/catalogue_choices.h"
#include "catalogue/crowd.h"
#include "lab/lab_world.h"
#include "random.h"

#include <thud/thud_mover.h>

#include <math.h>

enum { SHAPES = 10000, QUICK_SHAPES = 300, PLACES = 1024, MOVES = 2000, WALKS = 3 };

/* Random places in the world, and a path of 10 m from each in a random direction. */
typedef struct questions {
    thud_world *world;
    thud_pos from[PLACES];
    thud_pos way[PLACES];
} questions;

/* Random starts in a square of that half width, each with a random direction of length 10. */
static void make_questions(questions *q, double half) {
    scene_random random = {15};
    for (int i = 0; i < PLACES; i++) {
        double angle = scene_random_range(&random, 0, 6.28318530717959);
        q->from[i] = (thud_pos){scene_random_range(&random, -half, half),
                                scene_random_range(&random, -half, half)};
        q->way[i] = (thud_pos){10 * cos(angle), 10 * sin(angle)};
    }
}

#define FOR_EACH_QUESTION(inputs, count) \
    const questions *q = inputs;         \
    double answers = 0;                  \
    for (int n = 0, i = 0; n < count; n++, i = n & (PLACES - 1))

static double ray(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        bool hit = false;
        thud_ray_hit first;
        thud_world_cast_ray(q->world, &(thud_ray){q->from[i], q->way[i].x, q->way[i].y, NULL}, &hit,
                            &first);
        answers += hit;
    }
    return answers;
}

static double ray_all(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        int hits = 0;
        thud_world_cast_ray_all(q->world, &(thud_ray){q->from[i], q->way[i].x, q->way[i].y, NULL},
                                NULL, 0, &hits);
        answers += hits;
    }
    return answers;
}

static double circle_cast(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        bool hit = false;
        thud_ray_hit first;
        thud_world_cast_shape(q->world,
                              &(thud_shape_cast){q->from[i], thud_circle_at(0, 0, 0.25),
                                                 q->way[i].x, q->way[i].y, NULL},
                              &hit, &first);
        answers += hit;
    }
    return answers;
}

static double box_cast(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        bool hit = false;
        thud_ray_hit first;
        thud_world_cast_shape(q->world,
                              &(thud_shape_cast){q->from[i], thud_obb_at(0, 0, 0.25, 0.25, 0.5),
                                                 q->way[i].x, q->way[i].y, NULL},
                              &hit, &first);
        answers += hit;
    }
    return answers;
}

static double closest(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        bool found = false;
        thud_closest_hit hit;
        thud_world_closest(q->world, q->from[i], 2, NULL, &found, &hit);
        answers += found;
    }
    return answers;
}

static bool count_one(thud_shape_id shape, void *context) {
    (void)shape;
    ++*(double *)context;
    return true;
}

static double overlap_circle(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        thud_world_overlap_shape(q->world, q->from[i], thud_circle_at(0, 0, 2), NULL, count_one,
                                 &answers);
    }
    return answers;
}

static double overlap_aabb(const void *inputs, int count) {
    FOR_EACH_QUESTION(inputs, count) {
        thud_world_overlap_aabb(q->world, (thud_pos){q->from[i].x - 2, q->from[i].y - 2},
                                (thud_pos){q->from[i].x + 2, q->from[i].y + 2}, NULL, count_one,
                                &answers);
    }
    return answers;
}

static const struct {
    const char *name;
    call_fn *fn;
} CALLS[] = {
    {"ray", ray},
    {"ray, all hits", ray_all},
    {"circle cast", circle_cast},
    {"box cast", box_cast},
    {"closest", closest},
    {"overlap circle", overlap_circle},
    {"overlap AABB", overlap_aabb},
};

enum { CALL_COUNT = sizeof CALLS / sizeof CALLS[0] };

static bool open_worlds(const scene *s, lab_world labs[BROADPHASE_COUNT]) {
    for (int k = 0; k < BROADPHASE_COUNT; k++) {
        thud_world_def def = lab_settings();
        def.broadphase = broadphase_at(k);
        labs[k].scene = *s; /* the scene is shared with the other worlds */
        if (!lab_open(&labs[k], &def))
            return false;
        crowd_passes_through(labs[k].world);
        if (!lab_run(&labs[k], 2, NULL))
            return false;
    }
    return true;
}

/* Times one kind of query with each broadphase, and counts how many results it finds on average. */
static void ask(size_t call, questions each[BROADPHASE_COUNT], bool quick, json *out) {
    json_begin_object(out, NULL);
    json_text(out, "query", CALLS[call].name);
    double found = CALLS[call].fn(&each[0], PLACES) / PLACES;
    json_number(out, "found", found);
    printf("%-16s %8.2f", CALLS[call].name, found);
    for (int k = 0; k < BROADPHASE_COUNT; k++) {
        double ns = call_timer_ns(CALLS[call].fn, &each[k], quick);
        json_number(out, thud_broadphase_name(broadphase_at(k)), ns);
        printf(" %11.0f", ns);
    }
    printf("\n");
    fflush(stdout);
    json_end(out);
}

/* Times all queries in a crowd, with each broadphase. */
static bool ask_everything(bool quick, json *out) {
    static questions each[BROADPHASE_COUNT];
    crowd c = {quick ? QUICK_SHAPES : SHAPES, 1.5625, 0.25, 0.25, 1, 5};
    lab_world labs[BROADPHASE_COUNT] = {0};
    scene s;
    scene_init(&s);
    crowd_fill(&c, &s);
    bool ok = open_worlds(&s, labs);
    printf("%-16s %8s", "query, ns", "finds");
    for (int k = 0; k < BROADPHASE_COUNT; k++)
        printf(" %11s", thud_broadphase_name(broadphase_at(k)));
    printf("\n");
    json_begin_array(out, "queries");
    for (int k = 0; ok && k < BROADPHASE_COUNT; k++) {
        each[k].world = labs[k].world;
        make_questions(&each[k], 0.5 * sqrt(c.area * c.bodies));
    }
    for (size_t i = 0; ok && i < CALL_COUNT; i++)
        ask(i, each, quick, out);
    json_end(out);
    for (int k = 0; k < BROADPHASE_COUNT; k++)
        thud_world_destroy(labs[k].world);
    scene_free(&s);
    return ok;
}

/* ---- character movers ---- */

/* A floor of 10,000 tiles whose heights differ by at most 0.2 m. */
static void fill_tiles(scene *s) {
    scene_random random = {16};
    for (int i = 0; i < SHAPES; i++)
        scene_static_box(s, i, scene_random_range(&random, -0.6, -0.4), 0.5, 0.5);
}

/* Walks at 5 m/s under gravity. Lowers *ns to the nanoseconds of a move if they are fewer. */
static bool walk(thud_world *world, thud_mover mover, int moves, double *ns) {
    const double dt = 1.0 / 60;
    thud_vec2 velocity = {5, 0};
    double start = lab_now(NULL);
    for (int i = 0; i < moves; i++) {
        thud_mover_report report;
        velocity.y -= (float)(10 * dt);
        if (thud_mover_move(world, &mover, velocity, dt, &report) != THUD_OK)
            return false;
        velocity = (thud_vec2){5, report.velocity.y};
    }
    *ns = fmin(*ns, (lab_now(NULL) - start) / moves * 1e9);
    return mover.on_ground && mover.shape.x > 10 + 0.8 * 5 * dt * moves;
}

static bool time_movers(bool quick, json *out) {
    const struct {
        const char *name;
        thud_geometry shape;
    } MOVERS[] = {
        {"circle", {.kind = THUD_SHAPE_CIRCLE, .x = 10, .y = 1, .c = 1, .hx = 0.4}},
        {"AABB", {.kind = THUD_SHAPE_AABB, .x = 10, .y = 1, .c = 1, .hx = 0.4, .hy = 0.9}},
    };
    thud_world_def def = lab_settings();
    lab_world lab = {0};
    scene_init(&lab.scene);
    fill_tiles(&lab.scene);
    bool ok = lab_open(&lab, &def) && lab_run(&lab, 2, NULL);
    json_begin_array(out, "mover");
    for (size_t i = 0; ok && i < sizeof MOVERS / sizeof MOVERS[0]; i++) {
        double ns = INFINITY;
        for (int walks = 0; ok && walks < WALKS; walks++)
            ok = walk(lab.world, thud_default_mover(MOVERS[i].shape), quick ? 60 : MOVES, &ns);
        if (!ok) {
            fprintf(stderr, "thud-catalogue: the %s did not walk\n", MOVERS[i].name);
            break;
        }
        printf("%-6s mover, a move %12.0f\n", MOVERS[i].name, ns);
        json_begin_object(out, NULL);
        json_text(out, "mover", MOVERS[i].name);
        json_number(out, "ns", ns);
        json_end(out);
    }
    json_end(out);
    lab_close(&lab);
    return ok;
}

bool catalogue_queries(bool quick, json *out) {
    return ask_everything(quick, out) && time_movers(quick, out);
}
