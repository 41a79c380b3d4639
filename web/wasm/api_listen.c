/* api_listen.c: callbacks into JavaScript: listeners, called once a step for all contacts,
 * epilogues of bodies and categories, called for one contact, and the pair filter. JavaScript finds
 * its functions by the address of the world (rules/callbacks.ts), and that of an object by the
 * number of the body or the categories, which is the context. */
#include "api.h"

#include <stdlib.h>
#include <thud/thud_listeners.h>
#include <thud/thud_rules.h>

/* Imports of the module: the prologue, the epilogue, those of a body (by its index1) and of
 * categories, with the side that the object is on, and the pair filter. The prologue may write to
 * the last four numbers of each row. */
extern void thud_asked(const thud_world *world, struct listened_row *rows, int count);
extern void thud_told(const thud_world *world, struct listened_row *rows, int count);
extern void thud_told_body(const thud_world *world, struct listened_row *row, uint32_t index1,
                           int side);
extern void thud_told_category(const thud_world *world, struct listened_row *row,
                               uint32_t categories, int side);
extern int thud_filtered(const thud_world *world, uint32_t index_a, uint32_t generation_a,
                         uint32_t index_b, uint32_t generation_b);

/* Rows of a call where there is no memory for all of them: listeners are then called several times.
 * Chosen: 16 rows take 2,560 bytes of stack. */
enum { PIECE = 16 };

/* The contacts whose rows a prologue has, by which it names them: api_contact_decide. None outside
 * of prologues. */
static struct {
    const thud_world *world;
    const thud_contact *contacts;
    int count;
} asked;

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
        if (answers) {
            /* The prologue of one world may step another one. */
            __typeof__(asked) outer = asked;
            asked = (__typeof__(asked)){world, &contacts[first], part};
            thud_asked(world, all, part);
            asked = outer;
        } else {
            thud_told(world, all, part);
        }
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

static void tell_body(thud_world *world, const thud_contact *contact, int side, void *context) {
    struct listened_row row = row_of(contact);
    thud_told_body(world, &row, (uint32_t)(uintptr_t)context, side);
}

static void tell_category(thud_world *world, const thud_contact *contact, int side, void *context) {
    struct listened_row row = row_of(contact);
    thud_told_category(world, &row, (uint32_t)(uintptr_t)context, side);
}

int api_body_set_epilogue(thud_world *world, uint32_t index1, uint32_t generation, int tells) {
    return thud_body_set_epilogue(world, api_body(index1, generation), tells ? tell_body : NULL,
                                  (void *)(uintptr_t)index1);
}

int api_world_set_category_epilogue(thud_world *world, uint32_t categories, int tells) {
    return thud_world_set_category_epilogue(world, categories, tells ? tell_category : NULL,
                                            (void *)(uintptr_t)categories);
}

/* Decides the velocities after the collision of the contact in this row of the prologue that is
 * running. `sides`: 1 those of a, 2 those of b, 3 both. */
int api_contact_decide(thud_world *world, int row, int sides, double ax, double ay, double turn_a,
                       double bx, double by, double turn_b) {
    const thud_velocities a = {{(float)ax, (float)ay}, (float)turn_a};
    const thud_velocities b = {{(float)bx, (float)by}, (float)turn_b};
    if (world != asked.world || row < 0 || row >= asked.count)
        return api_refuse("decide: no prologue is asked about this row");
    return thud_contact_decide(world, &asked.contacts[row], sides & 1 ? &a : NULL,
                               sides & 2 ? &b : NULL);
}

static bool filter(const thud_world *world, thud_shape_id a, thud_shape_id b, void *context) {
    (void)context;
    return thud_filtered(world, a.index1, a.generation, b.index1, b.generation) != 0;
}

int api_world_set_filter(thud_world *world, int filters) {
    return thud_world_set_filter(world, filters ? filter : NULL, NULL);
}
