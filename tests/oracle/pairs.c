/* pairs.c: see pairs.h. The spans are sorted anew in each call, since the oracle need not be fast.
 */
#include "pairs.h"

#include <math.h>
#include <stdlib.h>

bool near_pairs_init(near_pairs *near, const model *m) {
    *near = (near_pairs){.spans = calloc((size_t)m->shape_count + 1, sizeof *near->spans)};
    return near->spans != NULL;
}

void near_pairs_free(near_pairs *near) {
    free(near->pairs);
    free(near->spans);
    *near = (near_pairs){0};
}

static bool add(near_pairs *near, const model *m, int a, int b) {
    if (near->count == near->capacity) {
        int capacity = near->capacity > 0 ? 2 * near->capacity : 256;
        near_pair *grown = realloc(near->pairs, (size_t)capacity * sizeof *grown);
        if (!grown)
            return false;
        near->pairs = grown;
        near->capacity = capacity;
    }
    bool swap = m->shapes[a].ground == m->shapes[b].ground ? a > b : m->shapes[b].ground;
    near->pairs[near->count++] = swap ? (near_pair){b, a} : (near_pair){a, b};
    return true;
}

/* The bounds of a shape with a margin; ground is unbounded in y. */
static near_span span_of(const model_shape *shape, int index, double margin) {
    const depth_shape *s = &shape->solid;
    if (shape->ground) {
        const depth_ground *line = &shape->line;
        return (near_span){line->points[0].x, line->points[line->count - 1].x, -HUGE_VAL, HUGE_VAL,
                           index};
    }
    double x = s->hx + margin, y = s->hx + margin;
    if (!s->circle) {
        x = fabs(s->hx * s->cosine) + fabs(s->hy * s->sine) + margin;
        y = fabs(s->hx * s->sine) + fabs(s->hy * s->cosine) + margin;
    }
    return (near_span){s->x - x, s->x + x, s->y - y, s->y + y, index};
}

static int by_low_end(const void *left, const void *right) {
    const near_span *a = left, *b = right;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    return a->shape - b->shape;
}

static int by_index(const void *left, const void *right) {
    const near_pair *a = left, *b = right;
    return a->a != b->a ? a->a - b->a : a->b - b->b;
}

bool near_pairs_find(near_pairs *near, const model *m, const double *margins) {
    int spans = 0;
    for (int i = 0; i < m->shape_count; i++)
        if (m->shapes[i].ground || !isnan(m->shapes[i].solid.x))
            near->spans[spans++] = span_of(&m->shapes[i], i, margins[i]);
    qsort(near->spans, (size_t)spans, sizeof *near->spans, by_low_end);
    near->count = 0;
    for (int i = 0; i < spans; i++) {
        const near_span *a = &near->spans[i];
        for (int j = i + 1; j < spans && near->spans[j].low <= a->high; j++) {
            const near_span *b = &near->spans[j];
            if (a->bottom <= b->top && b->bottom <= a->top &&
                model_may_collide(m, &m->shapes[a->shape], &m->shapes[b->shape]) &&
                !add(near, m, a->shape, b->shape))
                return false;
        }
    }
    if (near->count > 0)
        qsort(near->pairs, (size_t)near->count, sizeof *near->pairs, by_index);
    return true;
}
