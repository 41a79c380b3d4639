/* callbacks.c: guarantees of the prologue and the epilogue (pre-solve and post-solve callbacks):
 * which pairs they are called for, vetoes, surface settings, decided velocities, epilogues of
 * objects, and edits made inside of them. */
#include "guarantee.h"
#include "yard.h"

#include <thud/thud_snapshot.h>

enum { ASKED_MAX = 256 };

/* ---- which pairs callbacks are called for ---- */

/* The pairs that callbacks were called for in a step, with the number of prologues (asks) and
 * epilogues (tells) of each. */
typedef struct asked {
    trial *t;
    thud_shape_id a[ASKED_MAX], b[ASKED_MAX];
    int asks[ASKED_MAX], tells[ASKED_MAX];
    int count;
    int unasked; /* epilogues of pairs that had no prologue */
} asked;

/* The index of the pair of shapes, in either order; `count` if it is not listed. */
static int find_asked(const asked *s, thud_shape_id a, thud_shape_id b) {
    int i = 0;
    while (i < s->count && !(s->a[i].index1 == a.index1 && s->b[i].index1 == b.index1) &&
           !(s->a[i].index1 == b.index1 && s->b[i].index1 == a.index1)) {
        i++;
    }
    return i;
}

/* A prologue that counts its calls for each pair. */
static bool note_asked(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *wanted, void *context) {
    asked *s = context;
    int i = find_asked(s, contact->shape_a, contact->shape_b);
    (void)world;
    (void)wanted;
    if (i == s->count && i < ASKED_MAX) {
        s->a[i] = contact->shape_a;
        s->b[i] = contact->shape_b;
        s->asks[i] = s->tells[i] = 0;
        s->count++;
    }
    s->asks[i < ASKED_MAX ? i : 0]++;
    return true;
}

/* An epilogue that counts its calls for each pair, and those for pairs without a prologue. */
static void note_told(thud_world *world, const thud_contact *contact, void *context) {
    asked *s = context;
    int i = find_asked(s, contact->shape_a, contact->shape_b);
    (void)world;
    if (i == s->count) {
        s->unasked++;
    } else {
        s->tells[i]++;
    }
}

/* Reports a pair with more than one prologue in a step. Allowed are: one for each collision within
 * the step, where the detection resolves those; and pairs with a terrain line, of which each
 * segment is a contact of its own. */
static void expect_asked_once(trial *t, const asked *s, thud_shape_id line, int step) {
    bool often = t->set->value[DETECTION] >= BISECT;
    for (int i = 0; i < s->count; i++) {
        if (s->asks[i] > 1 && s->a[i].index1 != line.index1 &&
            !(often && s->asks[i] <= s->tells[i])) {
            trial_fault(t, "step %d: shapes %u and %u are asked about %d times, and told %d times",
                        step, s->a[i].index1, s->b[i].index1, s->asks[i], s->tells[i]);
        }
    }
    if (s->unasked) {
        trial_fault(t, "step %d: %d pairs were solved unasked", step, s->unasked);
    }
}

/* Every contact that a step solved had one prologue in it, and there is no epilogue of another
 * pair. */
static void prologue_asks_each_pair_once(trial *t) {
    asked s = {.t = t};
    thud_world_def def = trial_def(t);
    yard y;
    int in_all = 0;
    yard_make(&y, t, def, 0);
    trial_listen(t, y.world, note_asked, note_told, &s);
    for (int k = 0; k < trial_steps(t, 1.0) && !trial_failed(t); k++) {
        thud_manifold touching[16];
        int count = 0;
        s.count = s.unasked = 0;
        yard_step(&y);
        in_all += s.count;
        expect_asked_once(t, &s, y.line, k);
        for (int i = 0; i < YARD_BODIES && !trial_failed(t); i++) {
            if (!trial_state(t, y.world, y.body[i]).awake) {
                continue;
            }
            DO(t, thud_body_get_contacts(y.world, y.body[i], touching, 16, &count));
            for (int c = 0; c < count && c < 16; c++) {
                if (touching[c].point_count &&
                    find_asked(&s, touching[c].shape_a, touching[c].shape_b) == s.count) {
                    trial_fault(t, "step %d: a touching pair of body %d was not asked about", k, i);
                }
            }
        }
    }
    if (in_all == 0) {
        trial_fault(t, "nothing touched");
    }
}

/* ---- vetoes ---- */

/* A prologue that vetoes every contact and counts its calls. */
static bool refuse_all(thud_world *world, const thud_contact *contact,
                       thud_contact_settings *wanted, void *context) {
    (void)world;
    (void)contact;
    (void)wanted;
    ++*(int *)context;
    return false;
}

/* Adds 1,000,000 to the count of calls, which no scene reaches by prologues. */
static void count_epilogues(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    (void)contact;
    *(int *)context += 1000000;
}

/* A body whose contacts are all vetoed falls as in an empty world, without hit events and
 * epilogues. */
static void vetoed_pairs_do_nothing(trial *t) {
    int calls = 0;
    thud_world_def def = trial_def(t);
    thud_world *empty = trial_make(t, def);
    thud_world *world = trial_make(t, def);
    trial_listen(t, world, refuse_all, count_epilogues, &calls);
    if (!world || !empty) {
        return;
    }
    form kind = (form)trial_pick(t, FORMS);
    double reach = trial_pick(t, 2) ? 0.4 : 0.02, hits = 0;
    trial_wall(t, world, 0, 0, 4, reach);
    trial_drop(t, world, BALL, 0.1, -1, 0.4);
    thud_body_id body = trial_drop(t, world, kind, 0, 1, 0.3);
    thud_body_id alone = trial_drop(t, empty, kind, 0, 1, 0.3);
    thud_vec2 speed = trial_speed(t, 0, -4);
    DO(t, thud_body_set_velocity(world, body, speed, 0));
    DO(t, thud_body_set_velocity(empty, alone, speed, 0));
    for (int k = 0; k < trial_steps(t, 0.5) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        trial_run(t, empty, 1);
        hits += thud_events_of(world).hit_count;
    }
    double at = trial_state(t, world, body).position.y;
    double wanted = trial_state(t, empty, alone).position.y;
    /* An island that is solved directly integrates a step at once: its place differs by up to the
     * error of substeps. */
    double substep = t->step / thud_stats_of(empty).substeps;
    if (fabs(at - wanted) > 0.5 * 10 * 0.5 * substep || hits > 0 || calls >= 1000000 ||
        calls == 0) {
        trial_fault(t, "it fell to %g, not %g, with %g hits, %d calls", at, wanted, hits, calls);
    }
}

typedef struct one_way_platform {
    trial *t;
    thud_body_id body;
} one_way_platform;

/* A prologue that lets a body pass if it rises faster than 1 length scale per second; a body that
 * is pushed out of the platform is slower. */
static bool one_way(thud_world *world, const thud_contact *contact, thud_contact_settings *wanted,
                    void *context) {
    const one_way_platform *s = context;
    thud_body_state body;
    (void)wanted;
    if (contact->body_a.index1 != s->body.index1 ||
        thud_body_get_state(world, contact->body_b, &body) != THUD_OK) {
        return true;
    }
    return body.velocity.y <= (float)s->t->scale;
}

static void one_way_platforms_hold_from_above(trial *t) {
    one_way_platform platform = {.t = t};
    thud_world_def def = trial_def(t);
    double top = -9;
    thud_world *world = trial_make(t, def);
    trial_listen(t, world, one_way, NULL, &platform);
    if (!world) {
        return;
    }
    platform.body = trial_wall(t, world, 0, 2, 3, 0.2);
    thud_body_id body = trial_add(t, world,
                                  (part){.kind = THUD_BODY_DYNAMIC,
                                         .form = (form)trial_pick(t, FORMS),
                                         .y = 0.5,
                                         .hx = 0.3,
                                         .hy = 0.3,
                                         .vy = 9.5});
    for (int k = 0; k < trial_steps(t, 3) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        top = fmax(top, trial_state(t, world, body).position.y);
    }
    double y = trial_state(t, world, body).position.y;
    if (top < 4 || fabs(y - 2.5) > 0.02) {
        trial_fault(t, "it rose to %g and rests at %g", top, y);
    }
}

/* ---- settings ---- */

typedef struct surface {
    float friction, speed;
    int steps; /* number of steps in which the prologue sets them */
} surface;

/* A prologue that sets friction and surface speed while `steps` is positive. */
static bool set_surface(thud_world *world, const thud_contact *contact,
                        thud_contact_settings *wanted, void *context) {
    const surface *s = context;
    (void)world;
    (void)contact;
    if (s->steps > 0) {
        wanted->friction = s->friction;
        wanted->surface_speed = s->speed;
    }
    return true;
}

/* A surface that a prologue sets holds for one step: without friction a box slides on, then it is
 * braked again; a surface speed carries a box; an invalid friction is refused, and the pair keeps
 * its own. */
static void surfaces_are_what_a_prologue_sets(trial *t) {
    surface ice = {.friction = 0, .steps = 1};
    thud_world_def def = trial_def(t);
    thud_world *world = trial_make(t, def);
    trial_listen(t, world, set_surface, NULL, &ice);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 40, 1);
    thud_body_id box = trial_drop(t, world, UPRIGHT, 0, 0.3, 0.3);
    trial_run(t, world, 3);
    DO(t, thud_body_set_velocity(world, box, trial_speed(t, 3, 0), 0));
    trial_run(t, world, trial_steps(t, 0.3));
    double slid = (double)trial_state(t, world, box).velocity.x;
    ice.steps = 0;
    trial_run(t, world, trial_steps(t, 1.5));
    double stopped = (double)trial_state(t, world, box).velocity.x;
    ice = (surface){.friction = 1, .speed = (float)(2 * t->scale), .steps = 1};
    DO(t, thud_body_set_awake(world, box, true));
    trial_run(t, world, trial_steps(t, 1.0));
    double carried = (double)trial_state(t, world, box).velocity.x;
    if (fabs(slid - 3) > 1e-3 || fabs(stopped) > 1e-2 || fabs(carried - 2) > 0.02) {
        trial_fault(t, "on ice %g of 3, without %g, on a belt %g of 2", slid, stopped, carried);
    }
    ice = (surface){.friction = NAN, .steps = 1};
    t->heard = 0;
    trial_run(t, world, trial_steps(t, 1.5));
    if (t->heard == 0 || t->heard_result != THUD_ERROR_INVALID) {
        trial_fault(t, "friction of no number was not refused");
    }
    stopped = (double)trial_state(t, world, box).velocity.x;
    if (!(fabs(stopped) < 1e-2)) {
        trial_fault(t, "with refused settings it slides at %g", stopped);
    }
}

/* ---- velocities that a prologue decides ---- */

typedef struct portal {
    trial *t;
    thud_velocities after;
    int decided, told;
} portal;

/* A prologue that decides the velocities of what comes down on the wall, side a. */
static bool pass_on(thud_world *world, const thud_contact *contact, thud_contact_settings *wanted,
                    void *context) {
    portal *s = context;
    thud_body_state body;
    (void)wanted;
    DO(s->t, thud_body_get_state(world, contact->body_b, &body));
    if (body.velocity.y < 0) {
        DO(s->t, thud_contact_decide(world, contact, NULL, &s->after));
        REFUSED(s->t, thud_contact_decide(world, contact, &s->after, NULL), THUD_ERROR_INVALID);
        s->decided++;
    }
    return true;
}

/* An epilogue that counts the pairs that were given an impulse. */
static void note_passing(thud_world *world, const thud_contact *contact, void *context) {
    (void)world;
    ((portal *)context)->told += contact->normal_impulse > 0;
}

/* What meets a wall goes on through it with the velocities that the prologue decides, and nothing
 * else acts on it there; the epilogue is told, and the errors of the steps have the energy. */
static void decided_velocities_hold(trial *t) {
    portal s = {.t = t, .after = {trial_speed(t, 1.5, -3), 0}};
    thud_world *world = trial_make(t, trial_weightless(t));
    trial_listen(t, world, pass_on, note_passing, &s);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, 0, 4, 0.4);
    thud_body_id id = trial_drop(t, world, (form)trial_pick(t, FORMS), 0, 1.2, 0.3);
    DO(t, thud_body_set_velocity(world, id, trial_speed(t, 0, -4), 0));
    double decided = 0;
    for (int k = 0; k < trial_steps(t, 0.5) && !trial_failed(t); k++) {
        trial_run(t, world, 1);
        decided += thud_step_error_of(world).energy_decided;
    }
    thud_body_state body = trial_state(t, world, id);
    double wanted = 0.5 * (double)body.mass * (1.5 * 1.5 + 3 * 3 - 4 * 4) * t->scale * t->scale;
    if (s.decided == 0 || s.told == 0 || fabs((double)body.velocity.x - 1.5) > 1e-5 ||
        fabs((double)body.velocity.y + 3) > 1e-5 || body.position.y > 0 ||
        fabs(decided - wanted) > 1e-3 * -wanted) {
        trial_fault(t, "%d decided, %d told: it goes by (%g, %g), and got %g of %g", s.decided,
                    s.told, (double)body.velocity.x, (double)body.velocity.y, decided, wanted);
    }
}

/* ---- epilogues of objects ---- */

typedef struct told_bodies {
    thud_body_id body;
    int by_world, by_body; /* calls that name the body, and calls of its own epilogue */
} told_bodies;

static bool is_told_body(const told_bodies *s, thud_body_id body) {
    return body.index1 == s->body.index1 && body.generation == s->body.generation;
}

static void note_body(thud_world *world, const thud_contact *contact, void *context) {
    told_bodies *s = context;
    (void)world;
    s->by_world += is_told_body(s, contact->body_a) + is_told_body(s, contact->body_b);
}

static void note_own(thud_world *world, const thud_contact *contact, int side, void *context) {
    told_bodies *s = context;
    (void)world;
    s->by_body += is_told_body(s, side ? contact->body_b : contact->body_a);
}

/* A body with an epilogue is told of each contact that the world is told of and that it has, and of
 * no other, until an edit destroys it. */
static void objects_are_told_of_their_contacts(trial *t) {
    told_bodies s = {0};
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    trial_listen(t, y.world, NULL, note_body, &s);
    s.body = y.body[trial_pick(t, YARD_BODIES)];
    DO(t, thud_body_set_epilogue(y.world, s.body, note_own, &s));
    for (int k = 0; k < trial_steps(t, 1.0) && !trial_failed(t); k++) {
        yard_step(&y);
        if (s.by_world != s.by_body) {
            trial_fault(t, "step %d: the world is told of %d contacts, the body of %d", k,
                        s.by_world, s.by_body);
        }
    }
}

/* ---- edits and refused calls inside callbacks ---- */

typedef struct intruder {
    trial *t;
    thud_body_id other;
    thud_pos to;
    int calls;
} intruder;

/* An epilogue whose first call makes calls that must be refused inside a step. */
static void intrude(thud_world *world, const thud_contact *contact, void *context) {
    intruder *s = context;
    trial *t = s->t;
    size_t size;
    (void)contact;
    if (s->calls++) {
        return;
    }
    REFUSED(t, thud_world_step(world), THUD_ERROR_LOCKED);
    REFUSED(t, thud_world_set_gravity(world, (thud_vec2){0, 0}), THUD_ERROR_LOCKED);
    REFUSED(t, thud_world_set_sleeping(world, false), THUD_ERROR_LOCKED);
    REFUSED(t, thud_world_set_quality(world, &thud_quality_draft), THUD_ERROR_LOCKED);
    REFUSED(t, thud_world_get_snapshot_size(world, &size), THUD_ERROR_LOCKED);
    thud_world_destroy(world);
    REFUSED(t, THUD_ERROR_LOCKED, THUD_ERROR_LOCKED);
    DO(t, thud_body_set_transform(world, s->other, s->to, 0));
}

/* Calls that an epilogue may not make are refused; its edits take effect with the next step. */
static void callbacks_edit_the_next_step(trial *t) {
    intruder s = {.t = t, .to = trial_place(t, 20, 3)};
    thud_world_def def = trial_weightless(t);
    thud_world *world = trial_make(t, def);
    trial_listen(t, world, NULL, intrude, &s);
    if (!world) {
        return;
    }
    trial_wall(t, world, 0, -1, 4, 1);
    trial_drop(t, world, BALL, 0, 0.29, 0.3);
    s.other = trial_drop(t, world, BALL, 10, 3, 0.3);
    for (int k = 0; k < 10 && s.calls == 0 && !trial_failed(t); k++) {
        trial_run(t, world, 1);
    }
    double before = trial_state(t, world, s.other).position.x;
    trial_run(t, world, 1);
    double after = trial_state(t, world, s.other).position.x;
    if (s.calls == 0 || fabs(before - 10) > 1e-3 || fabs(after - 20) > 1e-3) {
        trial_fault(t, "%d calls: at %g, and a step later at %g", s.calls, before, after);
    }
}

const guarantee guarantees_of_callbacks[] = {
    GUARANTEE(callbacks_edit_the_next_step),
    GUARANTEE(decided_velocities_hold),
    GUARANTEE(objects_are_told_of_their_contacts),
    GUARANTEE(one_way_platforms_hold_from_above),
    GUARANTEE(prologue_asks_each_pair_once),
    GUARANTEE(surfaces_are_what_a_prologue_sets),
    GUARANTEE(vetoed_pairs_do_nothing),
    {.name = NULL},
};
