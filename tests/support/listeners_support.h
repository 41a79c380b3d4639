/* listeners_support.h: listeners of every form (for single contacts or for all at once) that answer
 * by a fixed rule and hash all that they are given, and a scene with many contacts. */
#ifndef LISTENERS_SUPPORT_H
#define LISTENERS_SUPPORT_H

#include "engine_support.h"

#include <thud/thud_terrain.h>

/* Bodies of the scene; forms of listeners; contacts kept of a step. */
enum { BODIES = 70, FORMS = 4, HEARD_MOST = 512 };

/* A listener's context: what it counted, and a digest of all that it was given. */
typedef struct ear {
    bool plain; /* the prologue accepts every contact as it is */
    uint64_t digest;
    int calls, asked, vetoed, changed, told;
    thud_contact heard[HEARD_MOST]; /* by the epilogue since the test last set heard_count to 0 */
    int heard_count;
} ear;

/* Adds bytes to the digest (FNV-1a's step). */
static inline void mix(ear *e, const void *values, size_t bytes) {
    const unsigned char *at = values;
    for (size_t i = 0; i < bytes; i++) {
        e->digest = (e->digest ^ at[i]) * 0x100000001b3u;
    }
}

/* Adds a contact to the digest, and asserts that its handles are valid. */
static inline void mix_contact(const thud_world *world, ear *e, const thud_contact *c) {
    const double numbers[] = {(double)c->normal.x,
                              (double)c->normal.y,
                              c->point.x,
                              c->point.y,
                              (double)c->separation,
                              (double)c->normal_impulse,
                              (double)c->tangent_impulse};
    const uint32_t counts[] = {c->shape_a.index1, c->shape_b.index1, c->body_a.index1,
                               c->body_b.index1, (uint32_t)c->point_count};
    mix(e, numbers, sizeof numbers);
    mix(e, counts, sizeof counts);
    assert_true(thud_shape_is_valid(world, c->shape_a) && thud_shape_is_valid(world, c->shape_b));
    assert_true(thud_body_is_valid(world, c->body_a) && thud_body_is_valid(world, c->body_b));
}

/* ---- the answer of a prologue, by the pair and the step: veto, no friction, bounce, moving
 * surface, invalid settings, or none ---- */

/* Whether the contact collides; may change its settings. It asserts that a contact arrives with its
 * shapes' settings and without impulses. */
static inline bool opinion(thud_world *world, const thud_contact *contact, thud_contact_settings *s,
                           ear *e) {
    int steps = (int)thud_stats_of(world).steps;
    int which = (int)(contact->shape_a.index1 * 7 + contact->shape_b.index1) + steps / 6;
    mix_contact(world, e, contact);
    mix(e, s, sizeof *s);
    assert_true(s->friction == 0.5f && s->restitution == 0 && s->surface_speed == 0);
    assert_true(contact->normal_impulse == 0 && contact->tangent_impulse == 0);
    e->asked++;
    if (e->plain) {
        return true;
    }
    switch (which % 9) {
    case 1:
        e->vetoed++;
        return false;
    case 2:
        s->friction = 0;
        break;
    case 3:
        s->restitution = 0.9f;
        break;
    case 4:
        s->surface_speed = 3;
        break;
    case 5:
        s->friction = NAN;
        s->restitution = 0.9f;
        break;
    case 6: /* vetoed, with settings changed, which must have no effect */
        s->restitution = 0.5f;
        e->vetoed++;
        return false;
    default:
        return true;
    }
    e->changed++;
    return true;
}

/* What an epilogue does with a contact. */
static inline void take_note(thud_world *world, const thud_contact *contact, ear *e) {
    mix_contact(world, e, contact);
    e->told++;
    if (e->heard_count < HEARD_MOST) {
        e->heard[e->heard_count++] = *contact;
    }
    /* a deferred edit, which is applied as the next step begins */
    if (!e->plain && e->told % 41 == 0) {
        thud_vec2 up = {0, 0.3f};
        (void)thud_body_apply_impulse(world, contact->body_b, up, contact->point);
    }
}

/* The four forms: `ask` and `ask_all` are prologues, `tell` and `tell_all` epilogues. */
static inline bool ask(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *settings, void *context) {
    ((ear *)context)->calls++;
    return opinion(world, contact, settings, context);
}

static inline void tell(thud_world *world, const thud_contact *contact, void *context) {
    ((ear *)context)->calls++;
    take_note(world, contact, context);
}

static inline void ask_all(thud_world *world, const thud_contact *contacts,
                           thud_contact_answer *answers, int count, void *context) {
    ((ear *)context)->calls++;
    for (int i = 0; i < count; i++) {
        assert_true(answers[i].collide);
        answers[i].collide = opinion(world, &contacts[i], &answers[i].settings, context);
    }
}

static inline void tell_all(thud_world *world, const thud_contact *contacts, int count,
                            void *context) {
    ((ear *)context)->calls++;
    for (int i = 0; i < count; i++) {
        take_note(world, &contacts[i], context);
    }
}

/* Bit 0 of `form`: the prologue takes all contacts at once; bit 1: the epilogue does. */
static inline thud_listeners of_form(int form, ear *e) {
    return (thud_listeners){.prologue = form & 1 ? NULL : ask,
                            .epilogue = form & 2 ? NULL : tell,
                            .prologue_all = form & 1 ? ask_all : NULL,
                            .epilogue_all = form & 2 ? tell_all : NULL,
                            .context = e};
}

/* ---- a mixed scene: every kind of shape and body, some moving far in a step ---- */

static inline thud_world *make_scene(thud_world_def def, thud_body_id bodies[BODIES]) {
    thud_world *world = make_world(def);
    thud_shape_def plain = thud_default_shape_def();
    plain.friction = 0.5f;
    add_floor(world, &plain);
    thud_pos points[21];
    for (int i = 0; i <= 20; i++) {
        points[i] = (thud_pos){i - 10, 0.4 + 0.3 * (i % 3)};
    }
    thud_terrain line = {.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 21};
    OK(thud_shape_create_terrain(world, add_body(world, THUD_BODY_STATIC, 0, 0, 0), &plain, &line,
                                 NULL));
    uint64_t seed = 11;
    for (int i = 0; i < BODIES; i++) {
        thud_body_def body = thud_default_body_def();
        body.kind = i % 20 == 7 ? THUD_BODY_KINEMATIC : THUD_BODY_DYNAMIC;
        body.position = (thud_pos){i % 10 * 1.3 - 6, 1.5 + i / 10 * 1.2};
        body.angle = i % 3 == 2 ? 0 : random_in(&seed, -1, 1);
        body.velocity.x = (float)(i % 20 == 7 ? 1 : random_in(&seed, -3, 3));
        body.velocity.y = i % 17 == 3 ? -150.0f : 0.0f;
        OK(thud_body_create(world, &body, &bodies[i]));
        float hx = (float)random_in(&seed, 0.2, 0.6), hy = (float)random_in(&seed, 0.2, 0.6);
        add_shape(world, bodies[i], hx, i % 3 ? hy : 0, i % 3 == 2, &plain);
    }
    return world;
}

#endif
