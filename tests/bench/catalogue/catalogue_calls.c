/* catalogue_calls.c: nanoseconds of a call of each function of thud_volumes.h, thud_geometry.h and
 * thud_minkowski.h, for each pair of kinds of shapes. */
#include "catalogue/call_timer.h"
#include "catalogue/catalogue.h"
#include "progress.h"
#include "catalogue/sample_pairs.h"

#include <thud/thud_volumes.h>

enum { PAIR_COUNT = 6 };

static const struct {
    const char *name;
    thud_shape_kind a, b;
} PAIRS[PAIR_COUNT] = {
    {"circle, circle", THUD_SHAPE_CIRCLE, THUD_SHAPE_CIRCLE},
    {"circle, AABB", THUD_SHAPE_CIRCLE, THUD_SHAPE_AABB},
    {"circle, OBB", THUD_SHAPE_CIRCLE, THUD_SHAPE_OBB},
    {"AABB, AABB", THUD_SHAPE_AABB, THUD_SHAPE_AABB},
    {"AABB, OBB", THUD_SHAPE_AABB, THUD_SHAPE_OBB},
    {"OBB, OBB", THUD_SHAPE_OBB, THUD_SHAPE_OBB},
};

static const thud_motion STILL = {0, 0, 0};

/* The body of a call_fn: the i-th call has the i-th pair, and every result is added to `answers`.
 */
#define FOR_EACH_CALL(inputs, count) \
    const sample_pairs *p = inputs;  \
    double answers = 0;              \
    for (int n = 0, i = 0; n < count; n++, i = n & (SAMPLE_PAIRS - 1))

static double volumes_overlap(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool overlap = false;
        thud_volumes_overlap(&p->a[i], &p->b[i], &overlap);
        answers += overlap;
    }
    return answers;
}

static double geometry_overlap(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        answers += thud_geometry_overlap(&p->a[i], &p->b[i]);
    }
    return answers;
}

static double geometry_closest(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_closest closest = {0};
        thud_geometry_closest(&p->a[i], &p->b[i], &closest);
        answers += closest.distance;
    }
    return answers;
}

static double geometry_contacts(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_contacts contacts = {0};
        thud_geometry_contacts(&p->a[i], &p->b[i], 0.02, &contacts);
        answers += contacts.count;
    }
    return answers;
}

static double geometry_approach(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_approach approach = {0};
        thud_geometry_approach(&p->a[i], STILL, &p->far_b[i], p->motion[i], &approach);
        answers += approach.time;
    }
    return answers;
}

static double time_of_impact(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool hit = false;
        double time = 0;
        thud_geometry_time_of_impact(&p->a[i], STILL, &p->far_b[i], p->motion[i], 0, &hit, &time);
        answers += time;
    }
    return answers;
}

static double time_of_collision(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool collided = false;
        double time = 0;
        thud_geometry_time_of_collision(&p->a[i], STILL, &p->far_b[i], p->motion[i], p->tolerance,
                                        &collided, &time);
        answers += time;
    }
    return answers;
}

static double minkowski_sum(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        thud_minkowski sum;
        thud_minkowski_sum(&p->a[i], &p->b[i], &sum);
        answers += sum.vertices[0].x;
    }
    return answers;
}

static double minkowski_contains(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool inside = false;
        thud_minkowski_contains(&p->sum[i], p->b[i].x, p->b[i].y, &inside);
        answers += inside;
    }
    return answers;
}

static double minkowski_distance(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        double distance = 0, nx, ny;
        thud_minkowski_distance(&p->sum[i], p->b[i].x, p->b[i].y, &distance, &nx, &ny);
        answers += distance;
    }
    return answers;
}

static double minkowski_cast(const void *inputs, int count) {
    FOR_EACH_CALL(inputs, count) {
        bool hit = false;
        double fraction = 0, nx, ny;
        thud_minkowski_cast(&p->sum[i],
                            (thud_segment){p->far_b[i].x, p->far_b[i].y, p->motion[i].dx,
                                           p->motion[i].dy},
                            &hit, &fraction, &nx, &ny);
        answers += fraction;
    }
    return answers;
}

static const struct {
    const char *name;
    call_fn *fn;
    bool circles_only;
} CALLS[] = {
    {"volumes_overlap", volumes_overlap, false},
    {"geometry_overlap", geometry_overlap, false},
    {"geometry_closest", geometry_closest, false},
    {"geometry_contacts", geometry_contacts, false},
    {"geometry_approach", geometry_approach, true},
    {"geometry_time_of_impact", time_of_impact, false},
    {"geometry_time_of_collision", time_of_collision, false},
    {"minkowski_sum", minkowski_sum, false},
    {"minkowski_contains", minkowski_contains, false},
    {"minkowski_distance", minkowski_distance, false},
    {"minkowski_cast", minkowski_cast, false},
};

static void print_pairs(const char *title) {
    printf("%-26s", title);
    for (int i = 0; i < PAIR_COUNT; i++)
        printf(" %14s", PAIRS[i].name);
    printf("\n");
}

static void time_function(size_t call, const sample_pairs samples[PAIR_COUNT], bool quick,
                          json *out) {
    json_begin_object(out, NULL);
    json_text(out, "call", CALLS[call].name);
    json_begin_object(out, "ns");
    printf("%-26s", CALLS[call].name);
    for (int i = 0; i < (CALLS[call].circles_only ? 1 : PAIR_COUNT); i++) {
        double ns = call_timer_ns(CALLS[call].fn, &samples[i], quick);
        json_number(out, PAIRS[i].name, ns);
        printf(" %14.1f", ns);
    }
    printf("\n");
    fflush(stdout);
    json_end(out);
    json_end(out);
}

static void time_tolerances(sample_pairs samples[PAIR_COUNT], bool quick, json *out) {
    printf("\n");
    print_pairs("bisection to");
    json_begin_array(out, "tolerances");
    for (int bits = 5; bits <= 40; bits = bits < 10 ? 10 : bits + 10) {
        json_begin_object(out, NULL);
        json_number(out, "bits", bits);
        json_begin_object(out, "ns");
        printf("2^-%-23d", bits);
        for (int i = 0; i < PAIR_COUNT; i++) {
            samples[i].tolerance = 1 / (double)(1LL << bits);
            double ns = call_timer_ns(time_of_collision, &samples[i], quick);
            json_number(out, PAIRS[i].name, ns);
            printf(" %14.1f", ns);
        }
        printf("\n");
        json_end(out);
        json_end(out);
    }
    json_end(out);
}

bool catalogue_calls(bool quick, json *out) {
    static sample_pairs samples[PAIR_COUNT];
    for (int i = 0; i < PAIR_COUNT; i++)
        sample_pairs_make(PAIRS[i].a, PAIRS[i].b, &samples[i]);
    print_pairs("ns");
    json_begin_array(out, "calls");
    for (size_t i = 0; i < sizeof CALLS / sizeof CALLS[0]; i++) {
        progress_show(CALLS[i].name, (double)i * sizeof CALLS[0] / sizeof CALLS);
        time_function(i, samples, quick, out);
    }
    json_end(out);
    progress_clear();
    time_tolerances(samples, quick, out);
    return true;
}
