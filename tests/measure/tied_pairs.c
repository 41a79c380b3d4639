/* tied_pairs.c: see tied_pairs.h. */
#include "tied_pairs.h"

#include <stdlib.h>

static uint64_t key_of(int a, int b) {
    return a < b ? (uint64_t)a << 32 | (uint32_t)b : (uint64_t)b << 32 | (uint32_t)a;
}

static int by_key(const void *left, const void *right) {
    const uint64_t *a = left, *b = right;
    return *a < *b ? -1 : *a > *b;
}

bool tied_pairs_init(tied_pairs *t, const scene *s) {
    *t = (tied_pairs){.keys = malloc((size_t)s->joint_count * sizeof *t->keys + 1)};
    if (!t->keys)
        return false;
    for (int i = 0; i < s->joint_count; i++) {
        const scene_joint *j = &s->joints[i];
        if (!j->collide_connected && j->kind != SCENE_GEAR)
            t->keys[t->count++] = key_of(j->body[0], j->body[1]);
    }
    qsort(t->keys, t->count, sizeof *t->keys, by_key);
    return true;
}

void tied_pairs_free(tied_pairs *t) {
    free(t->keys);
    *t = (tied_pairs){0};
}

bool tied_pairs_have(const tied_pairs *t, int a, int b) {
    uint64_t key = key_of(a, b);
    return t->count > 0 && bsearch(&key, t->keys, t->count, sizeof key, by_key) != NULL;
}
