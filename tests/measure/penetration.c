/* penetration.c: see penetration.h. Finds all overlapping pairs with a uniform hash grid. A shape
 * no larger than a cell is in the cell of its centre, so that all small shapes that it may overlap
 * are in this cell or the eight around it. The few larger shapes are tested against all. */
#include "penetration.h"

#include "depth.h"
#include "tied_pairs.h"

#include <math.h>
#include <stdlib.h>

typedef struct placed {
    depth_shape shape;
    double reach; /* radius of the bounding circle, m */
    const scene_shape *source;
    int body;
    bool dynamic;
    int64_t cell_x, cell_y;
    int next; /* next in the same bucket; -1 ends the list */
} placed;

struct penetration_meter {
    const scene *scene;
    placed *placed; /* circles and boxes, sorted by reach */
    int count, small_count;
    double cell;
    int *buckets; /* first of each list; -1: empty */
    size_t bucket_mask;
    depth_ground *grounds;
    const scene_shape **ground_sources;
    int *ground_bodies;
    int ground_count;
    tied_pairs tied;
    scene_point *ground_points;
};

/* m: half the length of the segment that represents an endless line */
#define FLAT_HALF_WIDTH 1e6

static bool is_ground(const scene_shape *shape) {
    return shape->kind == SCENE_TERRAIN_FLAT || shape->kind == SCENE_TERRAIN_UNIFORM ||
           shape->kind == SCENE_TERRAIN_IRREGULAR;
}

static int ground_vertices(const scene_shape *shape) {
    return shape->kind == SCENE_TERRAIN_FLAT ? 2 : shape->point_count;
}

/* Computes the vertices in world coordinates once, since terrain is static. */
static void place_ground(penetration_meter *meter, int index, const scene_shape *shape,
                         scene_point *points) {
    const scene_body *body = &meter->scene->bodies[index];
    int count = ground_vertices(shape);
    for (int i = 0; i < count; i++) {
        double flat_x = i == 0 ? -FLAT_HALF_WIDTH : FLAT_HALF_WIDTH;
        scene_point p = shape->kind == SCENE_TERRAIN_FLAT
                            ? (scene_point){flat_x, shape->slope * flat_x}
                            : meter->scene->points[shape->first_point + i];
        points[i] = (scene_point){body->x + p.x, body->y + p.y};
    }
    meter->ground_sources[meter->ground_count] = shape;
    meter->ground_bodies[meter->ground_count] = index;
    meter->grounds[meter->ground_count++] = (depth_ground){points, count};
}

static int by_reach(const void *left, const void *right) {
    const placed *a = left, *b = right;
    if (a->reach != b->reach)
        return a->reach < b->reach ? -1 : 1;
    return a->source < b->source ? -1 : a->source > b->source;
}

static void collect_shapes(penetration_meter *meter) {
    const scene *s = meter->scene;
    scene_point *points = meter->ground_points;
    for (int b = 0; b < s->body_count; b++) {
        const scene_body *body = &s->bodies[b];
        for (int i = 0; i < body->shape_count; i++) {
            const scene_shape *shape = &s->shapes[body->first_shape + i];
            if (shape->sensor)
                continue;
            if (is_ground(shape)) {
                place_ground(meter, b, shape, points);
                points += ground_vertices(shape);
                continue;
            }
            bool circle = shape->kind == SCENE_CIRCLE;
            meter->placed[meter->count++] = (placed){
                .shape = {.circle = circle, .hx = shape->hx, .hy = shape->hy},
                .reach = circle ? shape->hx : hypot(shape->hx, shape->hy),
                .source = shape,
                .body = b,
                .dynamic = body->kind == SCENE_DYNAMIC,
            };
        }
    }
}

penetration_meter *penetration_meter_create(const scene *s) {
    penetration_meter *meter = calloc(1, sizeof *meter);
    if (!meter)
        return NULL;
    meter->scene = s;
    size_t ground_count = 0, point_count = 0, buckets = 64;
    for (int i = 0; i < s->shape_count; i++)
        if (is_ground(&s->shapes[i])) {
            ground_count++;
            point_count += (size_t)ground_vertices(&s->shapes[i]);
        }
    while (buckets < 2 * (size_t)s->shape_count)
        buckets *= 2;
    meter->bucket_mask = buckets - 1;
    meter->placed = calloc((size_t)s->shape_count + 1, sizeof *meter->placed);
    meter->buckets = calloc(buckets, sizeof *meter->buckets);
    meter->grounds = calloc(ground_count + 1, sizeof *meter->grounds);
    meter->ground_sources = calloc(ground_count + 1, sizeof *meter->ground_sources);
    meter->ground_bodies = calloc(ground_count + 1, sizeof *meter->ground_bodies);
    meter->ground_points = calloc(point_count + 1, sizeof *meter->ground_points);
    if (!tied_pairs_init(&meter->tied, s) || !meter->ground_bodies || !meter->placed ||
        !meter->buckets || !meter->grounds || !meter->ground_sources || !meter->ground_points) {
        penetration_meter_destroy(meter);
        return NULL;
    }
    collect_shapes(meter);
    qsort(meter->placed, (size_t)meter->count, sizeof *meter->placed, by_reach);
    /* Cells of four times the median diameter: nearly all shapes are small, and a cell contains few
     * of them. Chosen. */
    meter->cell = meter->count > 0 ? 4 * 2 * meter->placed[meter->count / 2].reach : 1;
    while (meter->small_count < meter->count &&
           2 * meter->placed[meter->small_count].reach <= meter->cell)
        meter->small_count++;
    return meter;
}

void penetration_meter_destroy(penetration_meter *meter) {
    if (!meter)
        return;
    free(meter->placed);
    free(meter->buckets);
    free(meter->grounds);
    free(meter->ground_sources);
    free(meter->ground_bodies);
    free(meter->ground_points);
    tied_pairs_free(&meter->tied);
    free(meter);
}

/* Moves a shape to its body's pose; false if that is not finite. */
static bool place(placed *p, const engine_body *body) {
    double c = body->cosine, s = body->sine;
    const scene_shape *source = p->source;
    p->shape.x = body->x + source->x * c - source->y * s;
    p->shape.y = body->y + source->x * s + source->y * c;
    double turn_c = 1, turn_s = 0;
    if (source->kind == SCENE_OBB) {
        turn_c = cos(source->angle);
        turn_s = sin(source->angle);
    }
    /* Rotations in single precision are unit vectors to seven digits only. */
    double length = hypot(c, s);
    p->shape.cosine = (c * turn_c - s * turn_s) / length;
    p->shape.sine = (s * turn_c + c * turn_s) / length;
    /* m: farther away, the number of a cell could overflow, and the shape counts as lost. */
    return length > 0 && fabs(p->shape.x) < 1e12 && fabs(p->shape.y) < 1e12;
}

static size_t bucket_of(const penetration_meter *meter, int64_t cell_x, int64_t cell_y) {
    uint64_t mixed =
        (uint64_t)cell_x * 0x9E3779B97F4A7C15u ^ (uint64_t)cell_y * 0xC2B2AE3D27D4EB4Fu;
    return (size_t)(mixed ^ mixed >> 29) & meter->bucket_mask;
}

/* Whether filters and joints let a placed shape collide with a shape of `body`. */
static bool may_collide(const penetration_meter *meter, const placed *p, const scene_shape *b,
                        int body) {
    const scene_shape *a = p->source;
    if (tied_pairs_have(&meter->tied, p->body, body))
        return false;
    if (a->group == b->group && a->group != 0)
        return a->group > 0;
    return (a->category & b->mask) != 0 && (b->category & a->mask) != 0;
}

/* Adds a pair's depth to the worst and the sum, if the pair overlaps. */
static void count_depth(penetration *seen, double depth) {
    if (depth <= 0)
        return;
    seen->worst = depth > seen->worst ? depth : seen->worst;
    seen->sum += depth;
    seen->pairs++;
}

static void test_pair(const penetration_meter *meter, const placed *a, const placed *b,
                      penetration *seen) {
    double reach = a->reach + b->reach;
    if ((!a->dynamic && !b->dynamic) || a->body == b->body ||
        !(fabs(a->shape.x - b->shape.x) <= reach && fabs(a->shape.y - b->shape.y) <= reach) ||
        !may_collide(meter, a, b->source, b->body))
        return;
    count_depth(seen, depth_of_pair(&a->shape, &b->shape));
}

static void test_cell(const penetration_meter *meter, int index, int64_t cell_x, int64_t cell_y,
                      penetration *seen) {
    const placed *p = meter->placed;
    for (int i = meter->buckets[bucket_of(meter, cell_x, cell_y)]; i >= 0; i = p[i].next)
        if (i < index && p[i].cell_x == cell_x && p[i].cell_y == cell_y)
            test_pair(meter, &p[index], &p[i], seen);
}

static void test_grounds(const penetration_meter *meter, const placed *p, penetration *seen) {
    for (int i = 0; p->dynamic && i < meter->ground_count; i++)
        if (may_collide(meter, p, meter->ground_sources[i], meter->ground_bodies[i]))
            count_depth(seen, depth_in_ground(&meter->grounds[i], &p->shape));
}

void penetration_sample(penetration_meter *meter, const engine_body *bodies, penetration *seen) {
    placed *p = meter->placed;
    int lost = 0;
    for (size_t i = 0; i <= meter->bucket_mask; i++)
        meter->buckets[i] = -1;
    /* Shapes are inserted one by one and tested against those inserted before: each pair once. */
    for (int i = 0; i < meter->count; i++) {
        if (!place(&p[i], &bodies[p[i].body])) {
            lost++;
            p[i].shape.x = p[i].shape.y = NAN; /* NaN: overlaps no shape */
            continue;
        }
        test_grounds(meter, &p[i], seen);
        if (i >= meter->small_count) {
            for (int j = 0; j < i; j++)
                test_pair(meter, &p[i], &p[j], seen);
            continue;
        }
        p[i].cell_x = (int64_t)floor(p[i].shape.x / meter->cell);
        p[i].cell_y = (int64_t)floor(p[i].shape.y / meter->cell);
        for (int64_t dy = -1; dy <= 1; dy++)
            for (int64_t dx = -1; dx <= 1; dx++)
                test_cell(meter, i, p[i].cell_x + dx, p[i].cell_y + dy, seen);
        int *bucket = &meter->buckets[bucket_of(meter, p[i].cell_x, p[i].cell_y)];
        p[i].next = *bucket;
        *bucket = i;
    }
    seen->lost = lost > seen->lost ? lost : seen->lost;
}

double penetration_mean(const penetration *seen) {
    return seen->pairs > 0 ? seen->sum / (double)seen->pairs : 0;
}
