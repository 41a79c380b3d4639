/* catalogue_volumes.c: nanoseconds of fitting a bounding volume of each kind around shapes, motions
 * and points, and of tests with volumes. */
#include "catalogue/call_timer.h"
#include "catalogue/catalogue.h"
#include "random.h"
#include "catalogue/sample_pairs.h"

#include <thud/thud_volumes.h>

enum { KINDS = 3, POINTS = 100 };

static const struct {
    const char *name;
    thud_shape_kind kind;
} VOLUMES[KINDS] = {{"circle", THUD_SHAPE_CIRCLE},
                    {"AABB", THUD_SHAPE_AABB},
                    {"OBB", THUD_SHAPE_OBB}};

/* OBBs, the shapes for which fitting a volume takes longest. */
typedef struct contents {
    thud_shape_kind kind; /* kind of the volumes */
    sample_pairs pairs;
    thud_volume a[SAMPLE_PAIRS], b[SAMPLE_PAIRS]; /* volumes around the two shapes of a pair ... */
    thud_volume both[SAMPLE_PAIRS];               /* ... and around both */
    thud_pos points[SAMPLE_PAIRS][POINTS];        /* random points in a square */
} contents;

static void make_contents(thud_shape_kind kind, contents *c) {
    scene_random random = {17};
    c->kind = kind;
    sample_pairs_make(THUD_SHAPE_OBB, THUD_SHAPE_OBB, &c->pairs);
    for (int i = 0; i < SAMPLE_PAIRS; i++) {
        thud_volume_around_shape(kind, &c->pairs.a[i], &c->a[i]);
        thud_volume_around_shape(kind, &c->pairs.b[i], &c->b[i]);
        thud_volume_merge(kind, &c->a[i], &c->b[i], &c->both[i]);
        for (int k = 0; k < POINTS; k++)
            c->points[i][k] =
                (thud_pos){scene_random_range(&random, -1, 1), scene_random_range(&random, -1, 1)};
    }
}

#define FOR_EACH_CALL(inputs, count) \
    const contents *c = inputs;      \
    double answers = 0;              \
    for (int n = 0, i = 0; n < count; n++, i = n & (SAMPLE_PAIRS - 1))

static double around_shape(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_volume volume = {0};
        thud_volume_around_shape(c->kind, &c->pairs.a[i], &volume);
        answers += volume.hx;
    }
    return answers;
}

static double around_motion(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_volume volume = {0};
        thud_volume_around_motion(c->kind, &c->pairs.far_b[i], c->pairs.motion[i], &volume);
        answers += volume.hx;
    }
    return answers;
}

static double around_points(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_volume volume = {0};
        thud_volume_around_points(c->kind, c->points[i], POINTS, &volume);
        answers += volume.hx;
    }
    return answers;
}

static double merge(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_volume volume = {0};
        thud_volume_merge(c->kind, &c->a[i], &c->b[i], &volume);
        answers += volume.hx;
    }
    return answers;
}

static double overlap(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool met = false;
        thud_volumes_overlap(&c->a[i], &c->b[i], &met);
        answers += met;
    }
    return answers;
}

static double contains_point(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool inside = false;
        thud_volume_contains_point(&c->a[i], c->b[i].x, c->b[i].y, &inside);
        answers += inside;
    }
    return answers;
}

static double contains(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool inside = false;
        thud_volume_contains(&c->both[i], &c->a[i], &inside);
        answers += inside;
    }
    return answers;
}

static const struct {
    const char *name;
    call_fn *fn;
} CALLS[] = {
    {"volume_around_shape", around_shape},
    {"volume_around_motion", around_motion},
    {"volume_around_points", around_points},
    {"volume_merge", merge},
    {"volumes_overlap", overlap},
    {"volume_contains_point", contains_point},
    {"volume_contains", contains},
};

bool catalogue_volumes(bool quick, json *out) {
    static contents each[KINDS];
    printf("%-24s", "ns");
    for (int k = 0; k < KINDS; k++) {
        make_contents(VOLUMES[k].kind, &each[k]);
        printf(" %10s", VOLUMES[k].name);
    }
    printf("\n");
    json_begin_array(out, "volumes");
    for (size_t i = 0; i < sizeof CALLS / sizeof CALLS[0]; i++) {
        json_begin_object(out, NULL);
        json_text(out, "call", CALLS[i].name);
        json_begin_object(out, "ns");
        printf("%-24s", CALLS[i].name);
        for (int k = 0; k < KINDS; k++) {
            double ns = call_timer_ns(CALLS[i].fn, &each[k], quick);
            json_number(out, VOLUMES[k].name, ns);
            printf(" %10.1f", ns);
        }
        printf("\n");
        json_end(out);
        json_end(out);
    }
    json_end(out);
    return true;
}
