/* helper.c: what the Python package needs beside the engine, in C so that no step waits for
 * Python's lock: the message of a refused call, memory that views outlive, and steps of many
 * worlds. */
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "helper.h"

enum { MESSAGE_BYTES = 512, ALIGNMENT = 64 };

/* Stands before each block of a world; padded, so that the block is aligned as the engine wants. */
typedef union kept_block {
    union kept_block *next;
    char padding[ALIGNMENT];
} kept_block;

/* Belongs to one world, and lives as long as the world and all views of its memory. It counts both
 * itself: what Python frees together, it frees in any order. */
struct thud_py_context {
    char message[MESSAGE_BYTES]; /* of the last call that was refused; empty: none, or it is told */
    char told[MESSAGE_BYTES];    /* the message that was told last */
    thud_world *world;           /* null: not created */
    atomic_int users;            /* the world, and views that Python has of its memory */
    /* The present period, 0 or 1, and for each the views that were made in it, and the blocks that
     * the world released in it while there were views. A view shows no block that was released
     * before the view was made: so the blocks of the period before are freed, and the next period
     * begins, when that period's views are gone. */
    int period;
    atomic_int views[2];
    kept_block *kept[2];
};

static void free_kept(thud_py_context *context, int period) {
    while (context->kept[period]) {
        kept_block *block = context->kept[period];
        context->kept[period] = block->next;
        free(block);
    }
}

static void *allocate(size_t bytes, void *context) {
    (void)context;
    size_t rounded = (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    if (rounded < bytes || rounded + sizeof(kept_block) < rounded)
        return NULL;
    kept_block *block = aligned_alloc(ALIGNMENT, sizeof(kept_block) + rounded);
    return block ? block + 1 : NULL;
}

/* A view may outlive what it shows: then it has old values, but never memory of others. */
static void release(void *memory, size_t bytes, void *user) {
    (void)bytes;
    if (!memory)
        return;
    thud_py_context *context = user;
    kept_block *block = (kept_block *)memory - 1;
    int now = context->period, before = 1 - now;
    block->next = context->kept[now];
    context->kept[now] = block;
    if (atomic_load(&context->views[before]) == 0) {
        free_kept(context, before);
        context->period = before;
        if (atomic_load(&context->views[now]) == 0)
            free_kept(context, now);
    }
}

/* With THUD_OK the engine warns of a call that succeeded: no reason of an error. */
static void keep_message(thud_result result, const char *message, void *user) {
    thud_py_context *context = user;
    if (result != THUD_OK)
        snprintf(context->message, sizeof context->message, "%s", message);
}

thud_py_context *thud_py_context_create(void) {
    thud_py_context *context = calloc(1, sizeof *context);
    if (context)
        atomic_init(&context->users, 1);
    return context;
}

int thud_py_context_hold(thud_py_context *context) {
    atomic_fetch_add(&context->users, 1);
    atomic_fetch_add(&context->views[context->period], 1);
    return context->period;
}

/* Ends one of the users. */
static void leave(thud_py_context *context) {
    if (atomic_fetch_sub(&context->users, 1) == 1) {
        free_kept(context, 0);
        free_kept(context, 1);
        free(context);
    }
}

void thud_py_context_let_go(thud_py_context *context, int period) {
    atomic_fetch_sub(&context->views[period], 1);
    leave(context);
}

thud_result thud_py_context_create_world(thud_py_context *context, thud_world_def *def) {
    def->allocator = (thud_allocator){allocate, release, context};
    def->log = keep_message;
    def->log_context = context;
    return thud_world_create(def, &context->world);
}

thud_world *thud_py_context_world(const thud_py_context *context) {
    return context->world;
}

bool thud_py_context_end_world(thud_py_context *context) {
    context->message[0] = '\0';
    thud_world_destroy(context->world);
    if (context->message[0])
        return false;
    context->world = NULL;
    return true;
}

void thud_py_context_destroy(thud_py_context *context) {
    thud_world_destroy(context->world);
    leave(context);
}

const char *thud_py_context_message(thud_py_context *context) {
    memcpy(context->told, context->message, sizeof context->told);
    context->message[0] = '\0';
    return context->told;
}

/* A world whose step fails is not stepped further; the others are. */
void thud_py_step_all(thud_world **worlds, int count, int steps, thud_result *out_results) {
    for (int i = 0; i < count; i++) {
        out_results[i] = THUD_OK;
        for (int step = 0; step < steps && out_results[i] == THUD_OK; step++)
            out_results[i] = thud_world_step(worlds[i]);
    }
}
