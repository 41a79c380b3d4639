/* state.c: guarantees of what can be read from a world (poses, contacts, lists of moved bodies and
 * of sensor overlaps), and of terrain that is edited. */
#include "guarantee.h"
#include "yard.h"

#include <thud/thud_lists.h>
#include <thud/thud_textured.h>

/* thud_world_get_poses with alpha 0 and 1 gives the poses of the last two steps; a slot without a
 * body has the pose NaN. */
static void poses_are_those_of_two_steps(trial *t) {
    yard y;
    thud_pos before[YARD_BODIES];
    int count = 0;
    yard_make(&y, t, trial_def(t), 0);
    for (int k = 0; k < 20 && !trial_failed(t); k++) {
        for (int i = 0; i < YARD_BODIES; i++) {
            before[i] = trial_state(t, y.world, y.body[i]).position;
        }
        trial_run(t, y.world, 1);
        for (int i = 0; i < 2 * YARD_BODIES && !trial_failed(t); i++) {
            thud_body_id body = y.body[i / 2];
            const thud_pose *poses =
                thud_poses_of(y.world, (thud_pos){0, 0}, (double)(i % 2), &count);
            thud_pos at = i % 2 ? trial_state(t, y.world, body).position : before[i / 2];
            const thud_pose *p = &poses[body.index1 - 1];
            if (hypot((double)p->x / t->scale - at.x, (double)p->y / t->scale - at.y) > 1e-5) {
                trial_fault(t, "step %d: body %d is at %g, not %g", k, i / 2,
                            (double)p->x / t->scale, at.x);
            }
        }
    }
    DO(t, thud_body_destroy(y.world, y.body[3]));
    trial_run(t, y.world, 1);
    const thud_pose *poses = thud_poses_of(y.world, (thud_pos){0, 0}, 1, &count);
    if (!trial_failed(t) && poses[y.body[3].index1 - 1].x == poses[y.body[3].index1 - 1].x) {
        trial_fault(t, "a slot without a body has a pose");
    }
}

/* What hear_friction checks: the ground, and the friction of the body on it. */
typedef struct hearing {
    trial *t;
    thud_shape_id line;
    float body_friction;
    int heard;
} hearing;

static bool hear_friction(thud_world *world, const thud_contact *contact,
                          thud_contact_settings *surface, void *context) {
    hearing *h = context;
    float ground = -1;
    if (contact->shape_a.index1 != h->line.index1 && contact->shape_b.index1 != h->line.index1) {
        return true;
    }
    DO(h->t, thud_shape_get_friction_at(world, h->line, contact->point.x, &ground));
    double wanted = sqrt((double)ground * (double)h->body_friction);
    if (!(fabs((double)surface->friction - wanted) < 1e-6)) {
        trial_fault(h->t, "a contact at %g has friction %g, not %g", contact->point.x / h->t->scale,
                    (double)surface->friction, wanted);
    }
    h->heard++;
    return true;
}

/* On textured ground, whose friction grows from 0 at x = -10 to 1 at x = 10, each contact has the
 * friction of where it stands, also after a dig; it grows on as before there. */
static void contacts_have_the_friction_of_their_place(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_body_def ground = thud_default_body_def();
    thud_shape_def plain = thud_default_shape_def();
    thud_pos points[21];
    double values[21];
    thud_body_id body;
    hearing h = {.t = t, .body_friction = 0.5f};
    if (!world) {
        return;
    }
    for (int i = 0; i <= 20; i++) {
        points[i] = trial_place(t, i - 10, 0);
        values[i] = 0.05 * i;
    }
    DO(t, thud_body_create(world, &ground, &body));
    DO(t, thud_shape_create_terrain(
              world, body, &plain,
              &(thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 21},
              &h.line));
    DO(t, thud_shape_set_texture(world, h.line, &(thud_texture){.vertices = values, .count = 21}));
    plain.friction = h.body_friction;
    for (int k = 0; k < 3; k++) {
        trial_add(t, world,
                  (part){.kind = THUD_BODY_DYNAMIC,
                         .form = (form)k,
                         .x = 3 * k - 7,
                         .y = 0.6,
                         .hx = 0.3,
                         .hy = 0.3,
                         .vx = 4,
                         .vy = -9,
                         .shape = &plain});
    }
    trial_listen(t, world, hear_friction, NULL, &h);
    trial_run(t, world, trial_steps(t, 0.7));
    DO(t, thud_shape_dig(world, h.line, trial_place(t, 0.3, 0.4), 1.5 * t->scale));
    trial_run(t, world, trial_steps(t, 0.7));
    for (double x = -9.9; x < 9.9; x += 0.37) {
        float friction = -1;
        DO(t, thud_shape_get_friction_at(world, h.line, x * t->scale, &friction));
        if (!trial_failed(t) && !(fabs((double)friction - 0.05 * (x + 10)) < 1e-6)) {
            trial_fault(t, "the friction at %g is %g", x, (double)friction);
        }
    }
    if (!trial_failed(t) && h.heard < 20) {
        trial_fault(t, "%d contacts were seen", h.heard);
    }
}

/* Digging wakes the body that stood there, and it falls; a body that rests elsewhere stays asleep.
 */
static void dug_ground_lets_down_who_stood_there(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_body_def ground = thud_default_body_def();
    thud_shape_def plain = thud_default_shape_def();
    thud_pos points[21];
    thud_body_id body;
    thud_shape_id line = {0, 0};
    if (!world) {
        return;
    }
    for (int i = 0; i <= 20; i++) {
        points[i] = trial_place(t, i - 10, 0);
    }
    DO(t, thud_body_create(world, &ground, &body));
    DO(t,
       thud_shape_create_terrain(
           world, body, &plain,
           &(thud_terrain){.kind = THUD_TERRAIN_IRREGULAR, .points = points, .count = 21}, &line));
    thud_body_id here = trial_drop(t, world, BALL, 0, 0.3, 0.3);
    thud_body_id there = trial_drop(t, world, UPRIGHT, 6, 0.3, 0.3);
    trial_run(t, world, trial_steps(t, 1.5));
    bool slept = !trial_state(t, world, here).awake && !trial_state(t, world, there).awake;
    DO(t, thud_shape_dig(world, line, trial_place(t, 0, 0.4), 1.5 * t->scale));
    trial_run(t, world, 2);
    bool sleeps = !trial_state(t, world, there).awake, woke = trial_state(t, world, here).awake;
    trial_run(t, world, trial_steps(t, 1));
    double y = trial_state(t, world, here).position.y;
    double other = trial_state(t, world, there).position.y;
    if (slept != settings_sleeping(t->set) || sleeps != slept || !woke || y > -0.4 || y < -1.3 ||
        fabs(other - 0.3) > 0.02) {
        trial_fault(t, "slept %d, there %d, woke %d; it fell to %g, the other is at %g", slept,
                    sleeps, woke, y, other);
    }
}

/* The contacts of a body after a step are those with the bodies beside it. */
static void contacts_of_a_body_are_its_neighbours(trial *t) {
    thud_world *world = trial_make(t, trial_def(t));
    thud_manifold m[8];
    int count = 0;
    if (!world) {
        return;
    }
    thud_body_id floor = trial_wall(t, world, 0, -1, 5, 1);
    thud_body_id below = trial_drop(t, world, TURNED, 0, 0.4, 0.4);
    thud_body_id above = trial_drop(t, world, UPRIGHT, 0, 1.2, 0.4);
    trial_drop(t, world, BALL, 2, 0.4, 0.4);
    trial_run(t, world, trial_steps(t, 0.4));
    DO(t, thud_body_get_contacts(world, below, m, 8, &count));
    double borne = 0;
    for (int i = 0; i < count && i < 8; i++) {
        bool on_floor = m[i].body_a.index1 == floor.index1;
        uint32_t other =
            m[i].body_a.index1 == below.index1 ? m[i].body_b.index1 : m[i].body_a.index1;
        double up =
            m[i].body_b.index1 == below.index1 ? (double)m[i].normal.y : -(double)m[i].normal.y;
        if ((other != floor.index1 && other != above.index1) || (up > 0) != on_floor) {
            trial_fault(t, "contact %d is with body %u, normal %g up", i, other, up);
        }
        borne += on_floor ? (double)(m[i].normal_impulse[0] + m[i].normal_impulse[1]) : 0;
    }
    double mass = (double)(trial_state(t, world, below).mass + trial_state(t, world, above).mass);
    double load = mass * 10 * t->scale * t->step;
    if (count != 2 || fabs(borne - load) > 0.1 * load) {
        trial_fault(t, "%d contacts; the floor bears %g of %g", count, borne, load);
    }
}

/* ---- lists ---- */

enum { SLOTS = 64 };

/* A slot's body and pose when the list of moved bodies last contained it. */
typedef struct place {
    thud_body_id body;
    thud_pos position;
    double angle;
} place;

static bool same_place(place a, place b) {
    return a.body.index1 == b.body.index1 && a.body.generation == b.body.generation &&
           a.position.x == b.position.x && a.position.y == b.position.y && a.angle == b.angle;
}

/* The list of moved bodies contains those whose position or angle has changed, and no other. */
static void moved_bodies_are_those_elsewhere(trial *t) {
    static thud_body_seen seen[SLOTS];
    place last[SLOTS];
    thud_body_id all[SLOTS], moved[SLOTS];
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    memset(seen, 0, sizeof seen);
    memset(last, 0, sizeof last);
    for (int k = 0; k < 60 && !trial_failed(t); k++) {
        int count = 0, told = 0, next = 0;
        yard_step(&y);
        DO(t, thud_world_get_bodies(y.world, all, SLOTS, &count));
        DO(t, thud_world_get_moved_bodies(y.world, seen, SLOTS, moved, SLOTS, &told));
        for (int i = 0; i < count && !trial_failed(t); i++) {
            thud_body_state now = trial_state(t, y.world, all[i]);
            place here = {all[i], now.position, now.angle};
            bool is_told = next < told && moved[next].index1 == all[i].index1;
            if (same_place(here, last[all[i].index1 - 1]) == is_told) {
                trial_fault(t, "step %d: body %d is%s told", k, i, is_told ? "" : " not");
            }
            last[all[i].index1 - 1] = here;
            next += is_told;
        }
        if (next != told) {
            trial_fault(t, "step %d: %d bodies are told, of which %d live", k, told, next);
        }
    }
}

/* The overlaps that a sensor lists are the pairs that its events have begun and not ended. Each
 * event toggles a pair, also where a step reports both for it (thud_events.h). */
static void sensors_list_what_they_told(trial *t) {
    bool open[SLOTS][SLOTS] = {{false}};
    thud_shape_id all[SLOTS], list[SLOTS];
    yard y;
    yard_make(&y, t, trial_def(t), 0);
    for (int k = 0; k < 60 && !trial_failed(t); k++) {
        int count = 0, sensed = 0;
        yard_step(&y);
        thud_events e = thud_events_of(y.world);
        for (int i = 0; i < e.sensor_end_count + e.sensor_begin_count; i++) {
            bool ends = i < e.sensor_end_count;
            const thud_contact_event *at =
                ends ? &e.sensor_end[i] : &e.sensor_begin[i - e.sensor_end_count];
            open[at->shape_a.index1 - 1][at->shape_b.index1 - 1] ^= true;
        }
        DO(t, thud_world_get_shapes(y.world, all, SLOTS, &count));
        for (int i = 0; i < count && !trial_failed(t); i++) {
            const bool *told = open[all[i].index1 - 1];
            thud_shape_state state;
            DO(t, thud_shape_get_state(y.world, all[i], &state));
            if (!state.sensor) {
                continue;
            }
            DO(t, thud_shape_get_sensor_overlaps(y.world, all[i], list, SLOTS, &sensed));
            int expected = 0, found = 0;
            for (int n = 0; n < SLOTS; n++) {
                expected += told[n];
                found += n < sensed && told[list[n].index1 - 1];
            }
            if (sensed != expected || found != expected) {
                trial_fault(t, "step %d: %d are sensed, %d of %d that were told", k, sensed, found,
                            expected);
            }
        }
    }
}

const guarantee guarantees_of_state[] = {
    GUARANTEE(contacts_of_a_body_are_its_neighbours),
    GUARANTEE(contacts_have_the_friction_of_their_place),
    GUARANTEE(dug_ground_lets_down_who_stood_there),
    GUARANTEE(moved_bodies_are_those_elsewhere),
    GUARANTEE(poses_are_those_of_two_steps),
    GUARANTEE(sensors_list_what_they_told),
    {.name = NULL},
};
