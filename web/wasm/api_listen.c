/* api_listen.c: callbacks into JavaScript: listeners, called once a step for all contacts, and the
 * pair filter. JavaScript finds its functions by the address of the world (rules/callbacks.ts), so
 * that no context is needed. */
#include "api.h"

#include <stdlib.h>
#include <thud/thud_listeners.h>
#include <thud/thud_rules.h>

/* Imports of the module: the prologue, the epilogue, and the pair filter. The prologue may write to
 * the last four numbers of each row. */
extern void thud_asked(const thud_world *world, struct listened_row *rows, int count);
extern void thud_told(const thud_world *world, struct listened_row *rows, int count);
extern int thud_filtered(const thud_world *world, uint32_t index_a, uint32_t generation_a,
                         uint32_t index_b, uint32_t generation_b);

/* Rows of a call where there is no memory for all of them: listeners are then called several times.
 * Chosen: 16 rows take 2,560 bytes of stack. */
enum { PIECE = 16 };

/* The row of a contact, with zeros for the prologue's answers. */
static struct listened_row row_of(const thud_contact *c) {
    return (struct listened_row){
        .shape_a = {c->shape_a.index1, c->shape_a.generation},
        .shape_b = {c->shape_b.index1, c->shape_b.generation},
        .body_a = {c->body_a.index1, c->body_a.generation},
        .body_b = {c->body_b.index1, c->body_b.generation},
        .normal = {(double)c->normal.x, (double)c->normal.y},
        .point = {c->point.x, c->point.y},
        .separation = (double)c->separation,
        .normal_impulse = (double)c->normal_impulse,
        .tangent_impulse = (double)c->tangent_impulse,
        .point_count = c->point_count,
    };
}

/* Calls the prologue where `answers` is not null, and writes its decisions there; else the
 * epilogue. */
static void listen(const thud_world *world, const thud_contact *contacts,
                   thud_contact_answer *answers, int count) {
    struct listened_row few[PIECE], *rows = malloc((size_t)count * sizeof *rows);
    int room = rows ? count : PIECE;
    struct listened_row *all = rows ? rows : few;
    for (int first = 0; first < count; first += room) {
        int part = count - first < room ? count - first : room;
        for (int i = 0; i < part; i++) {
            all[i] = row_of(&contacts[first + i]);
            if (answers) {
                const thud_contact_settings *s = &answers[first + i].settings;
                all[i].collide = 1;
                all[i].friction = (double)s->friction;
                all[i].restitution = (double)s->restitution;
                all[i].surface_speed = (double)s->surface_speed;
            }
        }
        (answers ? thud_asked : thud_told)(world, all, part);
        for (int i = 0; i < part && answers; i++) {
            answers[first + i].collide = all[i].collide != 0;
            answers[first + i].settings =
                (thud_contact_settings){(float)all[i].friction, (float)all[i].restitution,
                                        (float)all[i].surface_speed};
        }
    }
    free(rows);
}

static void prologue(thud_world *world, const thud_contact *contacts, thud_contact_answer *answers,
                     int count, void *context) {
    (void)context;
    listen(world, contacts, answers, count);
}

static void epilogue(thud_world *world, const thud_contact *contacts, int count, void *context) {
    (void)context;
    listen(world, contacts, NULL, count);
}

/* `asks`: with a prologue; `tells`: with an epilogue; `without`: a sum of thud_contact_part. */
int api_world_set_listeners(thud_world *world, int asks, int tells, int without) {
    const thud_listeners listeners = {.prologue_all = asks ? prologue : NULL,
                                      .epilogue_all = tells ? epilogue : NULL,
                                      .without = (uint32_t)without};
    return thud_world_set_listeners(world, &listeners);
}

static bool filter(const thud_world *world, thud_shape_id a, thud_shape_id b, void *context) {
    (void)context;
    return thud_filtered(world, a.index1, a.generation, b.index1, b.generation) != 0;
}

int api_world_set_filter(thud_world *world, int filters) {
    return thud_world_set_filter(world, filters ? filter : NULL, NULL);
}
