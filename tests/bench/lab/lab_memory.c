/* lab_memory.c: bytes per body and per contact, as the engines report them. It compares two worlds
 * with the same bodies: in one nothing touches, in the other the bodies stand in columns; the
 * difference is the memory of contacts. Buffers double when they are full, so that the result for
 * one size depends on where it lies between two doublings: the mean over sizes of one octave does
 * not. */
#include "lab/lab.h"

#include "engine.h"

#include <math.h>
#include <stdio.h>

enum { COLUMN = 10, SMALLEST = 8000, SIZE_COUNT = 8, STEPS = 10 };

/* Bound on thud's bytes divided by Box2D's. Chosen. */
static const double MOST_PART = 0.5;

typedef struct lab_memory_use {
    double per_body, per_contact; /* bytes */
} lab_memory_use;

/* Columns of bodies without gravity. They overlap by less than the slop of each engine, so that
 * nothing moves. */
static void fill(scene *s, bool boxes, bool touching, int count) {
    scene_init(s);
    s->gravity_y = 0;
    double rise = touching ? 0.998 : 2;
    for (int i = 0; i < count; i++) {
        double x = 2.0 * (i / COLUMN), y = rise * (i % COLUMN);
        if (boxes)
            scene_dynamic_box(s, x, y, 0.5, 0.5);
        else
            scene_dynamic_circle(s, x, y, 0.5);
    }
}

/* Measures the bytes of a world with `count` bodies after some steps; false if the engine failed.
 */
static bool bytes_of(const physics_engine *engine, bool boxes, bool touching, int count,
                     double *out) {
    scene s;
    fill(&s, boxes, touching, count);
    void *world = engine_create(engine, &s, (engine_settings){0});
    bool ok = world != NULL;
    for (int i = 0; ok && i < STEPS; i++)
        ok = engine->step(world);
    if (ok)
        *out = (double)engine->bytes(world);
    engine->destroy(world);
    scene_free(&s);
    return ok;
}

static bool measure(const physics_engine *engine, bool boxes, int sizes, lab_memory_use *out) {
    *out = (lab_memory_use){0, 0};
    for (int i = 0; i < sizes; i++) {
        int count = (int)(SMALLEST * pow(2, (double)i / sizes)) / COLUMN * COLUMN;
        int contacts = count / COLUMN * (COLUMN - 1);
        double apart, touching;
        if (!bytes_of(engine, boxes, false, count, &apart) ||
            !bytes_of(engine, boxes, true, count, &touching)) {
            fprintf(stderr, "thud-bench: %s could not be measured\n", engine->name);
            return false;
        }
        out->per_body += apart / count / sizes;
        out->per_contact += (touching - apart) / contacts / sizes;
    }
    return true;
}

bool lab_memory(bool quick, json *out) {
    printf("%-8s  %10s %10s %6s  %12s %12s %6s\n", "of", "thud B/body", "Box2D", "part",
           "thud B/cont.", "Box2D", "part");
    json_begin_array(out, "memory");
    bool ok = true;
    for (int boxes = 0; ok && boxes < 2; boxes++) {
        lab_memory_use own, its;
        ok = measure(&engine_thud, boxes, quick ? 1 : SIZE_COUNT, &own) &&
             measure(engine_find("box2d"), boxes, quick ? 1 : SIZE_COUNT, &its);
        if (!ok)
            break;
        double body = own.per_body / its.per_body, contact = own.per_contact / its.per_contact;
        printf("%-8s  %11.0f %10.0f %6.2f  %12.0f %12.0f %6.2f  at most %.2f, %s\n",
               boxes ? "boxes" : "circles", own.per_body, its.per_body, body, own.per_contact,
               its.per_contact, contact, MOST_PART,
               body <= MOST_PART && contact <= MOST_PART ? "holds" : "misses");
        fflush(stdout);
        json_begin_object(out, NULL);
        json_text(out, "of", boxes ? "boxes" : "circles");
        json_number(out, "bytes_per_body", own.per_body);
        json_number(out, "box2d_bytes_per_body", its.per_body);
        json_number(out, "bytes_per_contact", own.per_contact);
        json_number(out, "box2d_bytes_per_contact", its.per_contact);
        json_number(out, "at_most", MOST_PART);
        json_end(out);
    }
    json_end(out);
    return ok;
}
